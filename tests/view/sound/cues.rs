//! Sounds that are played once.

use super::hearing::{ALONE, Heard, Listener, RATE};
use resultant::sound::{Ambience, Cue, Sound, Stuff, Volumes};

fn heard(cue: Cue) -> Heard {
    Listener::new().hear_cue(cue, 1.0)
}

/// How long each cue lasts (s), and at which pitch it begins, where it has one (Hz).
const EXPECTED: [(Cue, f64, Option<f64>); Cue::COUNT] = [
    (Cue::Knock(Stuff::Asphalt), 0.27, Some(88.0)),
    (Cue::Knock(Stuff::Steel), 1.5, Some(410.0)),
    (Cue::Knock(Stuff::Ice), 0.2, Some(1480.0)),
    (Cue::Knock(Stuff::Rubber), 0.4, Some(74.0)),
    (Cue::Knock(Stuff::Wood), 0.25, Some(236.0)),
    (Cue::Knock(Stuff::Glass), 2.0, Some(2093.0)),
    (Cue::Crash, 1.1, None),
    (Cue::Met, 1.45, Some(880.0)),
    (Cue::Lost, 1.45, Some(659.26)),
    (Cue::Success, 2.6, None),
    (Cue::Death, 1.6, None),
    (Cue::Splash, 0.8, None),
    (Cue::Bubble, 0.15, None),
    (Cue::Press, 0.28, Some(659.26)),
    (Cue::Move, 0.1, Some(880.0)),
    (Cue::Click, 0.045, None),
    (Cue::Jump, 0.35, None),
];

/// A crack is a step where a sound begins or ends: a sample far from its neighbour while all around is quiet.
#[test]
fn every_cue_is_heard_at_its_pitch_for_as_long_as_it_should_without_a_crack() {
    for (cue, length, pitch) in EXPECTED {
        let heard = heard(cue);
        assert!((0.02..0.5).contains(&heard.loudest()), "{cue:?}: {}", heard.loudest());
        // Up to 0.85 the limiter leaves samples as they are.
        assert!((0.06..0.75).contains(&heard.peak()), "{cue:?}: {}", heard.peak());
        assert!((0.6 * length..1.6 * length).contains(&heard.length()), "{cue:?}: {} s", heard.length());
        assert_eq!(heard.part(4.0, 5.0).peak(), 0.0, "{cue:?}");
        if let Some(pitch) = pitch {
            let found = heard.part(0.0, length.min(0.5)).pitch(pitch / 1.3, pitch * 1.3);
            assert!((found / pitch - 1.0).abs() < 0.03, "{cue:?}: {found} Hz");
        }
        let first = heard.0.iter().position(|sample| sample != &[0.0; 2]).expect("it is heard");
        let begins = Heard(heard.0[first..first + 5].to_vec());
        assert!(begins.peak() < 0.25 * heard.peak(), "{cue:?} begins at {} of {}", begins.peak(), heard.peak());
        let last = heard.0.iter().rposition(|sample| sample[0].abs() > 1e-6).expect("it is heard");
        let ends = Heard(heard.0[last - 48..].to_vec());
        assert!(ends.step() < 0.002 * heard.peak(), "{cue:?} ends by a step of {}", ends.step());
    }
}

#[test]
fn success_is_a_scale_that_rises() {
    let heard = heard(Cue::Success);
    for (i, pitch) in [523.25, 587.33, 659.26, 783.99, 880.0, 1046.5].into_iter().enumerate() {
        let begins = 0.085 * i as f64;
        let (before, after) = (heard.part((begins - 0.08).max(0.0), begins), heard.part(begins, begins + 0.08));
        assert!(after.at(pitch) > 0.05 && (i == 0 || after.at(pitch) > 2.0 * before.at(pitch)), "note {i}");
    }
}

#[test]
fn what_is_hit_harder_is_louder_and_brighter() {
    for stuff in Stuff::ALL {
        let [soft, hard] = [0.25, 1.0].map(|loudness| Listener::new().hear_cue(Cue::Knock(stuff), loudness));
        assert!(hard.loudest() > 2.5 * soft.loudest(), "{stuff:?}");
        let even = if stuff == Stuff::Rubber { 1.0 } else { 1.04 };
        assert!(hard.brightness() > even * soft.brightness(), "{stuff:?}: {} {}", hard.brightness(), soft.brightness());
    }
}

#[test]
fn materials_are_told_apart_by_brightness_or_by_length() {
    let heard = Stuff::ALL.map(|stuff| (stuff, heard(Cue::Knock(stuff))));
    for (i, (one, a)) in heard.iter().enumerate() {
        for (other, b) in &heard[..i] {
            let ratio = |x: f64, y: f64| (x / y).max(y / x);
            let (bright, long) = (ratio(a.brightness(), b.brightness()), ratio(a.length(), b.length()));
            assert!(bright > 1.3 || long > 1.5, "{one:?} and {other:?}: {bright} {long}");
        }
    }
}

#[test]
fn sounds_come_from_where_they_are() {
    for (place, least) in [(-1.0, 0.99), (-0.5, 0.5), (0.0, -0.01), (0.5, -0.99), (1.0, -1.01)] {
        let mut listener = Listener::new();
        listener.desk.play(Sound { cue: Cue::Met, loudness: 1.0, place });
        let heard = listener.hear(1.0, Ambience::default());
        let side = |side: usize| heard.0.iter().map(|sample| f64::from(sample[side]).powi(2)).sum::<f64>();
        let (left, right) = (side(0), side(1));
        let balance = (left - right) / (left + right);
        assert!(balance >= least && balance < least + 0.52, "{place}: {balance}");
    }
}

#[test]
fn volumes_are_apart_and_silence_is_silence() {
    let peak = |volumes| {
        let mut listener = Listener::new();
        listener.desk.set_volumes(volumes);
        listener.hear(0.5, Ambience::default());
        listener.hear_cue(Cue::Crash, 1.0).peak()
    };
    let full = peak(ALONE);
    assert_eq!(peak(Volumes { music: 0.0, ..ALONE }), full);
    assert!(peak(Volumes { effects: 0.0, ..ALONE }) < 1e-6);
    assert!(peak(Volumes { master: 0.0, ..ALONE }) < 1e-6);
    let half = peak(Volumes { effects: 0.5, ..ALONE });
    assert!((0.2..0.3).contains(&(half / full)), "{half} of {full}");
}

#[test]
fn the_same_desk_gives_the_same_samples_in_blocks_of_any_size() {
    let play = |block: usize| {
        let mut listener = Listener::new();
        listener.desk.set_tune(Some(4));
        listener.desk.play(Sound::new(Cue::Splash, 0.7));
        listener.desk.set_ambience(Ambience { engine: 0.7, wind: 0.4, liquid: 0.6, motion: 0.5 });
        let mut samples = vec![0.0; 2 * RATE as usize];
        samples.chunks_mut(2 * block).for_each(|block| listener.mixer.render(block));
        samples
    };
    let whole = play(RATE as usize);
    assert!(whole == play(480) && whole == play(37));
}
