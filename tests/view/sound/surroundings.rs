//! Lasting sounds: engine, wind, liquid.

use super::hearing::{Heard, Listener};
use resultant::sound::{Ambience, Cue};

const NOTHING: Ambience = Ambience { engine: 0.0, wind: 0.0, liquid: 0.0, motion: 0.0 };

/// The sound after a while.
fn heard(ambience: Ambience) -> Heard {
    let mut listener = Listener::new();
    listener.hear(1.0, ambience);
    listener.hear(3.0, ambience)
}

fn engine(engine: f32) -> Ambience {
    Ambience { engine, ..NOTHING }
}

fn wind(wind: f32) -> Ambience {
    Ambience { wind, ..NOTHING }
}

#[test]
fn the_engine_roars_with_its_thrust() {
    let [idle, half, full] = [0.25, 0.5, 1.0].map(|strength| heard(engine(strength)));
    assert!((0.03..0.3).contains(&full.rms()) && full.peak() < 0.7, "{} {}", full.rms(), full.peak());
    assert!(full.rms() > 1.5 * half.rms() && half.rms() > 1.5 * idle.rms());
    assert!(full.brightness() > half.brightness() && half.brightness() > idle.brightness());
}

#[test]
fn the_engine_answers_at_once_and_without_a_crack() {
    let mut listener = Listener::new();
    let steady = listener.hear(1.0, engine(1.0));
    assert!(steady.part(0.05, 0.15).rms() > 0.5 * steady.part(0.5, 1.0).rms(), "within a twentieth of a second");
    let end = listener.hear(1.0, NOTHING);
    assert!(end.part(0.15, 0.25).rms() < 0.05 * steady.rms() && end.part(0.5, 1.0).peak() == 0.0);
    assert!(end.step() < 1.5 * steady.step() && steady.part(0.0, 0.05).step() < 1.5 * steady.part(0.5, 1.0).step());
}

#[test]
fn the_wind_grows_and_rises_with_speed() {
    let [breeze, wind, storm] = [0.2, 0.5, 1.0].map(|speed| heard(wind(speed)));
    assert!((0.02..0.3).contains(&storm.rms()) && storm.peak() < 0.75, "{} {}", storm.rms(), storm.peak());
    assert!(storm.rms() > 1.5 * wind.rms() && wind.rms() > 1.5 * breeze.rms());
    assert!(storm.brightness() > 1.2 * wind.brightness() && wind.brightness() > 1.2 * breeze.brightness());
}

#[test]
fn a_liquid_bubbles_the_more_the_faster_one_moves() {
    let [still, fast] = [0.0, 1.0].map(|motion| heard(Ambience { liquid: 1.0, motion, ..NOTHING }));
    assert!(still.rms() > 0.002 && fast.rms() > 2.0 * still.rms() && fast.peak() < 0.6, "{} {}", still.rms(), fast.rms());
}

#[test]
fn a_liquid_muffles_everything_but_music() {
    let knock = |liquid| {
        let mut listener = Listener::new();
        let around = Ambience { liquid, ..NOTHING };
        listener.hear(1.0, around);
        listener.desk.play(resultant::sound::Sound::new(Cue::Met, 1.0));
        listener.hear(0.6, around).at(1760.0)
    };
    let (dry, wet) = (knock(0.0), knock(1.0));
    assert!(dry > 0.01 && wet < 0.2 * dry, "{dry} {wet}");
}

#[test]
fn a_game_that_is_held_up_falls_silent() {
    let mut listener = Listener::new();
    let before = listener.hear(1.0, engine(1.0)).rms();
    // No frame comes any more.
    let mut samples = vec![0.0; 2 * 48_000];
    listener.mixer.render(&mut samples);
    let after = Heard(samples.as_chunks().0.to_vec());
    assert!(after.part(0.0, 0.2).rms() > 0.8 * before, "a slow frame is none");
    assert_eq!(after.part(0.8, 1.0).peak(), 0.0);
}
