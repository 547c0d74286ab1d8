//! The music: quiet, of each level its own, and none where it is switched off.

use super::hearing::{ALONE, Heard, Listener};
use resultant::sound::{Ambience, Arrangement, Volumes, WORLDS};

fn heard(tune: u32, seconds: f64) -> Heard {
    let mut listener = Listener::new();
    listener.desk.set_tune(Some(tune));
    listener.hear(seconds, Ambience::default())
}

#[test]
fn music_is_quiet_but_there_all_the_time() {
    for tune in 0..6 {
        let heard = heard(tune, 40.0);
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
