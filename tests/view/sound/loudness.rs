//! How loud the game is as a whole, and that nothing is ever too loud for a device.

use super::hearing::{FULL, Heard, Listener, RATE};
use crate::support::shipped::{fixture, record};
use resultant::game::Game;
use resultant::sound::{Ambience, Cue, Ear, Mixer, Sound, Speaker, Volumes, desk, tune};
use std::f64::consts::PI;

/// Levels with winds, knocks, a mill, a thick liquid, a landing.
const FLIGHTS: [&str; 4] = ["1", "2", "3", "15"];

/// A flight of that level with those volumes, from its first tick to a second after its last.
fn flight(name: &str, volumes: Volumes) -> Heard {
    let mut game = Game::new(fixture(name)).unwrap();
    let (desk, feed) = desk();
    desk.set_volumes(volumes);
    let (mut speaker, mut ear, mut mixer) = (Speaker::at(desk), Ear::default(), Mixer::new(RATE, feed));
    speaker.desk.set_tune(Some(tune(name)));
    let (mut samples, mut tick) = (Vec::new(), [0.0; 2 * RATE as usize / 120]);
    let mut hear = |game: &Game, speaker: &mut Speaker| {
        speaker.surround(Ambience::of(game, f64::from(game.ship().burning).abs()));
        speaker.end_frame();
        mixer.render(&mut tick);
        samples.extend_from_slice(tick.as_chunks().0);
    };
    for controls in record(name, "careful").inputs {
        game.step(controls);
        ear.listen(&game, |sound| speaker.play(sound));
        hear(&game, &mut speaker);
    }
    (0..120).for_each(|_| hear(&game, &mut speaker));
    Heard(samples)
}

fn decibels(amplitude: f64) -> f64 {
    20.0 * amplitude.log10()
}

/// The largest value of the curve that a device makes of the samples, in quarters of a sample: by the sum of sines that each one stands for.
fn true_peak(heard: &Heard) -> f64 {
    const REACH: usize = 16;
    // A Hann window ends the sum.
    let weight = |x: f64| {
        let hann = 0.5 + 0.5 * (PI * x / REACH as f64).cos();
        if x == 0.0 { 1.0 } else { (PI * x).sin() / (PI * x) * hann }
    };
    let parts =
        [0.25, 0.5, 0.75].map(|part| (0..2 * REACH).map(|k| weight(k as f64 - (REACH as f64 - 1.0) - part)).collect::<Vec<_>>());
    let mut most = heard.peak();
    for near in heard.0.windows(2 * REACH) {
        // Far below the ceiling nothing between two samples comes up to it.
        if near[REACH - 1..=REACH].iter().flatten().all(|sample| sample.abs() < 0.5) {
            continue;
        }
        for (side, part) in (0..2).flat_map(|side| parts.iter().map(move |part| (side, part))) {
            let between: f64 = near.iter().zip(part).map(|(sample, weight)| f64::from(sample[side]) * weight).sum();
            most = most.max(between.abs());
        }
    }
    most
}

#[test]
fn flights_are_as_loud_as_other_games() {
    let mut power = 0.0;
    for name in FLIGHTS {
        let heard = flight(name, Volumes::default());
        let (rms, peak) = (decibels(heard.rms()), decibels(true_peak(&heard)));
        assert!((-22.0..-17.0).contains(&rms), "level {name}: {rms:.1} dBFS");
        assert!(peak <= -1.0, "level {name}: {peak:.2} dBFS");
        power += heard.rms().powi(2) / FLIGHTS.len() as f64;
    }
    let rms = decibels(power.sqrt());
    assert!((-20.5..-18.0).contains(&rms), "{rms:.1} dBFS");
}

#[test]
fn volumes_lead_from_silence_by_even_steps_to_the_ceiling() {
    let loud = |percent: f32| {
        let volume = percent / 100.0;
        flight("1", Volumes { master: volume, ..Volumes::default() }).rms()
    };
    assert_eq!(loud(0.0), 0.0);
    let mut last = loud(10.0);
    for percent in [20.0, 40.0, 60.0, 80.0, 100.0] {
        let now = loud(percent);
        assert!(now > 1.25 * last, "{percent} %: {now} after {last}");
        last = now;
    }
}

#[test]
fn everything_at_once_at_full_volume_never_clips() {
    let mut listener = Listener::new();
    listener.desk.set_volumes(FULL);
    listener.desk.set_tune(Some(1));
    let all = Ambience { engine: 1.0, wind: 1.0, liquid: 0.0, motion: 1.0 };
    let mut most = 0.0_f64;
    for round in 0..60 {
        let place = [-1.0, 0.0, 1.0][round % 3];
        for cue in Cue::ALL {
            listener.desk.play(Sound { cue, loudness: 1.0, place });
        }
        let heard = listener.hear(0.1, all);
        most = most.max(true_peak(&heard));
        assert!(heard.rms() > 0.1, "it is not turned down further than it must be");
    }
    assert!(decibels(most) <= -1.0, "{:.2} dBFS", decibels(most));
}

/// With the volumes that the game begins with, the engine is turned down for a crash only while it is heard.
#[test]
fn the_engine_is_not_heard_to_pump() {
    let engine = Ambience { engine: 1.0, ..Ambience::default() };
    let mut listener = Listener::new();
    listener.desk.set_volumes(Volumes { music: 0.0, ..Volumes::default() });
    listener.hear(1.0, engine);
    let before = listener.hear(4.0, engine);
    let loudness = |heard: &Heard, at: f64| heard.part(at, at + 0.4).rms();
    let steady: Vec<f64> = (0..9).map(|i| loudness(&before, 0.4 * f64::from(i))).collect();
    let (least, most) = steady.iter().fold((f64::MAX, 0.0_f64), |(least, most), rms| (least.min(*rms), most.max(*rms)));
    assert!(most < 1.26 * least, "alone it is even within 2 dB: {least} … {most}");
    listener.desk.play(Sound::new(Cue::Crash, 1.0));
    let after = listener.hear(2.0, engine);
    assert!(loudness(&after, 0.0) > most, "the crash is louder");
    // Once the crash has faded the engine is as loud as before: it neither swells nor sags.
    let back = loudness(&after, 1.2);
    assert!((0.8 * least..1.25 * most).contains(&back), "{back} after {least} … {most}");
}
