//! The sounds of real flights.

use super::hearing::{Listener, RATE};
use crate::support::Memory;
use crate::support::shipped::{fixture, record};
use resultant::game::{Controls, Game};
use resultant::level;
use resultant::sound::{Ambience, Cue, Ear, Sound, Speaker, Stuff, desk, tune};
use std::sync::Arc;

/// The ship at rest in a room of 20 m × 20 m, unless the files say otherwise.
fn game(files: &[(&'static str, &'static str)]) -> Game {
    let room = [
        ("constants.csv", "name,value\nwidth,600\nheight,600\n"),
        ("player.csv", "x,y,mass,fuel,thrust\n300,300,100,500,3000\n"),
        ("objectives.csv", "PLAYER,0,0,1,1\n"),
    ];
    let room = room.iter().filter(|(name, _)| files.iter().all(|(other, _)| other != name));
    let files = room.chain(files).map(|(name, text)| (*name, (*text).to_owned())).collect();
    let loaded = level::read("test", &Memory(files)).unwrap_or_else(|problems| panic!("{problems:?}"));
    Game::new(Arc::new(loaded.level)).unwrap()
}

/// A ship at rest in air 6 m above a floor of that material.
fn above(floor: &'static str) -> Game {
    game(&[("world.csv", floor)])
}

/// The sounds of `ticks` ticks, with no key pressed.
fn listen(game: &mut Game, ticks: usize) -> Vec<Sound> {
    let (mut ear, mut heard) = (Ear::default(), Vec::new());
    for _ in 0..ticks {
        game.step(Controls::default());
        ear.listen(game, |sound| heard.push(sound));
    }
    heard
}

#[test]
fn the_recorded_flight_is_heard_from_its_engine_to_its_success() {
    let mut game = Game::new(fixture("1")).unwrap();
    let (desk, feed) = desk();
    let (mut speaker, mut ear) = (Speaker::at(desk), Ear::default());
    let mut mixer = resultant::sound::Mixer::new(RATE, feed);
    let (mut cues, mut power, mut count) = (Vec::new(), 0.0, 0);
    let mut tick = [0.0; 2 * RATE as usize / 120];
    for controls in record("1", "careful").inputs {
        game.step(controls);
        ear.listen(&game, |sound| {
            cues.push(sound.cue);
            speaker.play(sound);
        });
        speaker.surround(Ambience::of(&game, f64::from(game.ship().burning).abs()));
        speaker.end_frame();
        mixer.render(&mut tick);
        assert!(tick.iter().all(|sample| sample.abs() < 1.0));
        power += tick.iter().map(|sample| f64::from(*sample).powi(2)).sum::<f64>();
        count += tick.len();
    }
    assert!(cues.contains(&Cue::Met) && cues.ends_with(&[Cue::Success]), "{cues:?}");
    assert!((power / f64::from(count as u32)).sqrt() > 0.01);
}

#[test]
fn a_fall_is_heard_as_what_it_falls_on_and_how_fast() {
    for (floor, stuff) in [("0,500,600,30,Steel\n", Stuff::Steel), ("0,500,600,30,Ice\n", Stuff::Ice)] {
        let mut game = above(floor);
        let heard = listen(&mut game, 240);
        let hardest = heard.iter().filter(|sound| sound.cue == Cue::Knock(stuff)).map(|sound| sound.loudness).fold(0.0, f32::max);
        // It falls for 5.8 m: 13 m/s, which is damaging; the point of the impact is a ship's half away.
        assert!(hardest > 0.85, "{heard:?}");
        assert!(heard.iter().any(|sound| sound.cue == Cue::Crash), "{heard:?}");
        assert!(heard.iter().all(|sound| !matches!(sound.cue, Cue::Knock(other) if other != stuff)), "{heard:?}");
    }
}

#[test]
fn death_is_heard_once() {
    let mut game = game(&[("obstacles.csv", "x,y,width,height\n0,500,600,30\n")]);
    let heard = listen(&mut game, 400);
    assert_eq!(heard.iter().filter(|sound| sound.cue == Cue::Death).count(), 1, "{heard:?}");
    assert_eq!(Ambience::of(&game, 1.0).engine, 0.0, "a lost ship burns no more");
}

#[test]
fn speed_is_wind_in_air_and_motion_in_a_liquid() {
    let mut game = above("0,590,600,10,Ice\n");
    assert_eq!(Ambience::of(&game, 0.0), Ambience::default());
    let mut last = 0.0;
    for _ in 0..60 {
        game.step(Controls::default());
        let wind = Ambience::of(&game, 0.0).wind;
        assert!(wind > last);
        last = wind;
    }
    let burning = Ambience::of(&game, 1.0).engine;
    assert!((0.9..=1.0).contains(&burning), "its thrust is twice its weight: {burning}");
}

#[test]
fn a_dive_splashes_once_and_is_heard_under_water() {
    let mut game = game(&[
        ("constants.csv", "name,value\nwidth,600\nheight,1200\n"),
        ("player.csv", "x,y,mass,fuel,thrust\n300,300,4000,500,3000\n"),
        ("fluids.csv", "x,y,width,height,density,viscosity\n0,500,600,700,1000,0.001\n"),
    ]);
    let heard = listen(&mut game, 300);
    assert_eq!(heard.iter().filter(|sound| sound.cue == Cue::Splash).count(), 1, "{heard:?}");
    let around = Ambience::of(&game, 0.0);
    assert!(around.liquid == 1.0 && around.wind == 0.0 && around.motion > 0.0, "{around:?}");
}

#[test]
fn many_collisions_in_a_frame_are_one_click_as_loud_as_the_loudest() {
    let (desk, feed) = desk();
    let mut speaker = Speaker::at(desk);
    for loudness in [0.25, 1.0, 0.5] {
        speaker.play(Sound::new(Cue::Click, loudness));
    }
    speaker.end_frame();
    assert_eq!(feed.next().map(|sound| (sound.cue, sound.loudness)), Some((Cue::Click, 1.0)));
    assert_eq!(feed.next(), None);
    speaker.end_frame();
    assert_eq!(feed.next(), None, "it is played once");
}

#[test]
fn what_surrounds_the_ship_must_be_said_in_every_frame() {
    let (desk, feed) = desk();
    let mut speaker = Speaker::at(desk);
    speaker.surround(Ambience { engine: 1.0, ..Ambience::default() });
    speaker.end_frame();
    assert_eq!(feed.ambience().engine, 1.0);
    speaker.end_frame();
    assert_eq!(feed.ambience(), Ambience::default());
}

#[test]
fn levels_by_number_have_that_tune_and_others_have_one_by_their_name() {
    assert_eq!((tune("3"), tune("12")), (3, 12));
    assert_eq!(tune("The cave"), tune("The cave"));
    assert_ne!(tune("The cave"), tune("The hill"));
    let mut listener = Listener::new();
    listener.desk.set_tune(Some(tune("The cave")));
    assert!(listener.hear(4.0, Ambience::default()).rms() > 0.005);
}
