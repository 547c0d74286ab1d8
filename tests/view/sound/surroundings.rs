//! Lasting sounds: engine, wind, liquid; and the music: quiet, of each level its own, and none where it is switched off.

use super::hearing::{ALONE, Heard, Listener};
use resultant::sound::{Ambience, Arrangement, Cue, Volumes, WORLDS};

const NOTHING: Ambience = Ambience { engine: 0.0, wind: 0.0, liquid: 0.0, motion: 0.0 };

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
    let mut samples = vec![0.0; 2 * 48_000];
    listener.mixer.render(&mut samples);
    let after = Heard(samples.as_chunks().0.to_vec());
    assert!(after.part(0.0, 0.2).rms() > 0.8 * before, "a slow frame is none");
    assert_eq!(after.part(0.8, 1.0).peak(), 0.0);
}

fn played(tune: u32, seconds: f64) -> Heard {
    let mut listener = Listener::new();
    listener.desk.set_tune(Some(tune));
    listener.hear(seconds, Ambience::default())
}

#[test]
fn music_is_quiet_but_there_all_the_time() {
    for tune in 0..6 {
        let heard = played(tune, 40.0);
        assert!((0.02..0.12).contains(&heard.rms()) && heard.peak() < 0.6, "tune {tune}: {} {}", heard.rms(), heard.peak());
        for from in [2.0, 10.0, 20.0, 30.0] {
            assert!(heard.part(from, from + 8.0).rms() > 0.008, "tune {tune} from {from} s on");
        }
        assert!(heard.step() < 0.08, "tune {tune}: {}", heard.step());
    }
}

#[test]
fn a_tune_fades_before_the_next_begins_and_before_silence() {
    for next in [Some(2), None] {
        let mut listener = Listener::new();
        listener.desk.set_tune(Some(1));
        let steady = listener.hear(8.0, Ambience::default());
        listener.desk.set_tune(next);
        let change = listener.hear(4.0, Ambience::default());
        assert!(change.part(1.2, 1.4).rms() < 0.05 * steady.rms());
        let fading = change.part(0.0, 1.4).step();
        assert!(fading <= steady.step(), "{fading}");
        assert_eq!(change.part(3.0, 4.0).peak() > 0.0, next.is_some());
    }
}

#[test]
fn music_that_is_switched_off_is_none_and_comes_back() {
    let mut listener = Listener::new();
    listener.desk.set_tune(Some(1));
    listener.hear(3.0, Ambience::default());
    listener.desk.set_volumes(Volumes { music: 0.0, ..ALONE });
    listener.hear(3.0, Ambience::default());
    assert_eq!(listener.hear(2.0, Ambience::default()).peak(), 0.0);
    listener.desk.set_volumes(ALONE);
    assert!(listener.hear(6.0, Ambience::default()).rms() > 0.008);
}

#[test]
fn each_world_has_an_ensemble_and_layers_come_in_with_speed_and_goals() {
    let heard = |how: Arrangement| {
        let mut listener = Listener::new();
        listener.desk.set_tune(Some(1));
        listener.desk.set_arrangement(how);
        listener.hear(16.0, Ambience::default())
    };
    let mut others: Vec<f64> = Vec::new();
    for world in 0..WORLDS {
        let alone = Arrangement { world, ..Arrangement::default() };
        let (calm, fast) = (heard(alone), heard(Arrangement { pace: 1.0, ..alone }));
        let goals = heard(Arrangement { goals: 1.0, ..alone });
        assert!((0.008..0.14).contains(&calm.rms()) && calm.peak() < 0.7, "world {world}: {} {}", calm.rms(), calm.peak());
        for louder in [&fast, &goals] {
            assert!(louder.rms() > 1.02 * calm.rms() && louder.peak() < 0.9, "world {world}: {} {}", calm.rms(), louder.rms());
        }
        assert!(others.iter().all(|other| (other - calm.rms()).abs() > 1e-5), "world {world} sounds like another");
        others.push(calm.rms());
    }
}
