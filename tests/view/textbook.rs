//! Through every experiment, in three languages and in the smallest window and the usual one, the picture of each body names all of its
//! forces, and no words cover others or leave the window.

use crate::support::shipped::{experiment, experiments};
use resultant::draw::layout::{Area, Frame, TEXT, Vec2, words_width};
use resultant::game::{Controls, Game};
use resultant::physics::BodyId;
use resultant::view::facts::{ArrowKind, facts};
use resultant::view::textbook::{BodyPicture, NamedArrow, acting};
use resultant::words::{Language, speak};

/// Ticks between two looks, and of a run.
const EVERY: u64 = 13;
const WATCHED: u64 = 1300;
/// The part of the canvas that a sheet leaves, and rows of buttons and signs at its top and foot, canvas units.
const SHEET: f32 = 568.0;
const ROWS: f32 = 56.0;

fn game(name: &str) -> Game {
    Game::new(experiment(name)).unwrap()
}

fn check(picture: &BodyPicture, forces: usize, (room, frame): (Area, &Frame), what: &str) {
    let (laid, text) = (&picture.layout, frame.text_height(TEXT));
    assert_eq!((laid.tags.len(), laid.arrows.len()), (forces, forces), "{what}: {laid:#?}");
    let inside = |area: &Area| area.min.cmpge(room.min).all() && area.max().cmple(room.max()).all();
    for (i, tag) in laid.tags.iter().enumerate() {
        assert!(inside(&tag.area), "{what}: {:?} leaves {room:?}", tag);
        assert!(tag.lines.iter().all(|words| !words.is_empty() && words_width(words, text) <= tag.area.size.x), "{what}: {tag:?}");
        for other in &laid.tags[i + 1..] {
            assert!(tag.area.gap(&other.area) >= 0.0, "{what}: {tag:?} covers {other:?}");
        }
    }
    assert!(laid.arrows.iter().all(|arrow| inside(&arrow.area().inset(4.0))), "{what}: {laid:#?}");
    for words in picture.heads.iter().chain(&picture.feet) {
        assert!(words_width(words, text) <= 0.5 * room.size.x - 20.0, "{what}: {words:?}");
    }
}

#[test]
fn no_words_overlap_in_any_experiment_at_any_instant() {
    let windows = [Vec2::new(900.0, 500.0), Vec2::new(1280.0, 720.0)].map(Frame::of_window);
    for name in experiments() {
        let mut game = game(&name);
        let bodies: Vec<BodyId> = (game.lead().0..game.world().bodies().len() as u32).map(BodyId).collect();
        let mut pictures: Vec<BodyPicture> = (0..4 * bodies.len()).map(|_| BodyPicture::default()).collect();
        for look in 0..WATCHED / EVERY {
            let language = [Language::English, Language::German, Language::French][look as usize % 3];
            speak(language);
            for (i, id) in bodies.iter().enumerate() {
                let (forces, resultant) = NamedArrow::of(&facts(&acting(&game, *id), *id));
                let sides = forces.iter().filter(|force| !force.shown.is_impact()).count();
                let count = forces.len() + sides + usize::from(resultant.is_some());
                for (w, frame) in windows.iter().enumerate() {
                    for (s, width) in [0.0, SHEET].into_iter().enumerate() {
                        let room = Area::new(0.0, ROWS, frame.size.x - width, frame.size.y - 2.0 * ROWS);
                        let picture = &mut pictures[4 * i + 2 * w + s];
                        picture.arrange(&game, *id, room, frame);
                        let what = format!("{name}, body {}, tick {}, {language:?}, {room:?}", id.0, game.ticks());
                        check(picture, count, (room, frame), &what);
                    }
                }
            }
            (0..EVERY).for_each(|_| game.step(Controls::default()));
        }
    }
    speak(Language::English);
}

#[test]
fn a_push_has_its_owner_and_what_balances_is_zero_in_words() {
    let picture = |game: &Game, body: u32| {
        let (mut picture, frame) = (BodyPicture::default(), Frame::default());
        picture.arrange(game, BodyId(body), frame.area(), &frame);
        picture
    };
    let mut row = game("pushed-row");
    (0..480).for_each(|_| row.step(Controls::default()));
    let second = picture(&row, 2);
    let names: Vec<&str> = second.layout.tags[..4].iter().map(|tag| tag.lines[0].as_str()).collect();
    assert!(names.contains(&"Push by Box 1") && names.contains(&"Push by Box 3"), "{names:?}");
    assert!(second.feet[1].starts_with("F = 10.0 kg · 2.00 m/s² = 20.0 N"), "{:?}", second.feet);
    assert_eq!(second.layout.arrows.last().unwrap().shown, ArrowKind::Resultant);
    // Before the first tick the rope pulls as from it on; while time stands still nothing is placed again.
    let circle = game("circular-motion");
    let mut tied = picture(&circle, 1);
    assert_eq!(tied.layout.arrows.len(), 3, "the rope, in the polygon too, and the resultant: {:?}", tied.layout);
    assert!(tied.feet[1].starts_with("F = 2.00 kg · 11.9 m/s² = 23.9 N"), "{:?}", tied.feet);
    tied.layout.tags.clear();
    tied.arrange(&circle, BodyId(1), Frame::default().area(), &Frame::default());
    assert!(tied.layout.tags.is_empty());
    let mut fall = game("terminal-velocity");
    assert!(picture(&fall, 1).feet[1].starts_with("F = "));
    (0..1200).for_each(|_| fall.step(Controls::default()));
    let balanced = picture(&fall, 1);
    assert_eq!(balanced.feet[1], "Balance: the resultant is zero.");
    assert!(balanced.layout.arrows.iter().all(|arrow| arrow.shown != ArrowKind::Resultant));
}
