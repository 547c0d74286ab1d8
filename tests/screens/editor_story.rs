//! An author's whole way, by mouse alone but for the level's name and the flight itself.

use crate::editor::{drag, draw};
use crate::sitting::Sitting;
use resultant::game::Medal;
use resultant::level::document::{Kind, LinkForm, Table};
use resultant::pack;
use resultant::screens::{Input, Key};
use std::sync::Arc;

/// Up for a moment, and down onto the pad.
fn fly(sitting: &mut Sitting) {
    sitting.hold(&[Key::Space], 20);
    sitting.hold_until(&[], |sitting| !["test flight", "flight"].contains(&sitting.at()));
}

#[test]
fn a_level_is_drawn_proven_shared_and_flown_elsewhere() {
    let mut sitting = Sitting::new();
    sitting.choose("Editor").click("New").write("yard").press(Key::Enter).rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "yard"));
    // Three goals: one of the ship, and two of keys, of which one lies there and one hangs on a rope.
    draw(&mut sitting, Kind::Pad, (100.0, 700.0), (200.0, 720.0));
    draw(&mut sitting, Kind::KeyPad, (500.0, 700.0), (600.0, 720.0));
    draw(&mut sitting, Kind::Key, (530.0, 640.0), (570.0, 680.0));
    draw(&mut sitting, Kind::KeyPad, (780.0, 290.0), (820.0, 330.0));
    draw(&mut sitting, Kind::Key, (780.0, 280.0), (820.0, 320.0));
    for (form, from, to) in [
        (LinkForm::Rope, (800.0, 300.0), (800.0, 100.0)),
        // A spring between the ship and what lies there is weak enough to fly with.
        (LinkForm::Spring, (550.0, 660.0), (800.0, 310.0)),
    ] {
        sitting.click(form.name());
        drag(&mut sitting, from, to);
    }
    // A lift with its switch.
    draw(&mut sitting, Kind::Mover, (1000.0, 600.0), (1120.0, 620.0));
    draw(&mut sitting, Kind::Switch, (300.0, 640.0), (360.0, 680.0));
    let wire = sitting.editor().handles().last().unwrap().1;
    drag(&mut sitting, (wire.x, wire.y), (1060.0, 610.0));
    assert_eq!(sitting.editor().document().wires().len(), 1);
    let rows = |table| sitting.editor().document().rows(table).count();
    assert_eq!((rows(Table::Objectives), rows(Table::Links), rows(Table::Movers)), (5, 2, 1));
    sitting.wait(0.3);
    assert!(sitting.editor().problems().iter().all(|(_, refused)| !refused), "{:?}", sitting.editor().problems());

    sitting.click("Fly");
    fly(&mut sitting);
    assert_eq!(sitting.at(), "editor");
    assert!(sitting.shows("Completed in"), "{:?}", sitting.texts());
    sitting.click("Gold").rest();
    assert!(sitting.shows("flights/gold.replay.csv") && !sitting.editor().is_unsaved());
    sitting.click("Back").rest();
    assert!(sitting.shows("proven: Gold"));
    sitting.click("Share").click("yard").rest();
    let file = sitting.folder.path().join("exports/yard.zip");

    // Dropped on another game's window.
    let mut other = Sitting::new();
    other.give(Input { dropped: vec![file], ..Input::default() }).rest();
    assert!(other.shows("Installed: yard"));
    other.press(Key::Escape).choose("yard").rest();
    assert_eq!((other.at(), other.flown()), ("flight", "yard"));
    let level = Arc::new(other.game().level().clone());
    let (proven, problems) = pack::proven(&other.folder.path().join("levels/yard"), &level);
    assert!(proven.len() == 1 && proven[0].starts_with("gold") && problems.is_empty(), "{proven:?} {problems:?}");
    fly(&mut other);
    assert_eq!(other.at(), "scoring");
    assert!(other.app.session.journal.medals("yard").medal >= Some(Medal::Silver), "{:?}", other.texts());
}
