//! What a goal or a switch sets going in the picture.

use crate::support::Memory;
use resultant::draw::layout::{Frame, Vec2};
use resultant::draw::{Canvas, Contour, Shape};
use resultant::game::{Controls, Game, GameEvent};
use resultant::level;
use resultant::physics::DVec2;
use resultant::view::{GameView, Overlays, theme};
use std::sync::Arc;

/// The ship falls on a plate, which opens a door.
#[test]
fn light_runs_along_the_wire_from_a_plate_to_its_door_and_goes_out() {
    let files = [
        ("constants.csv", "width,1280\nheight,720\n"),
        ("player.csv", "400,500,100,500,3000\n"),
        ("objectives.csv", "PLAYER,1200,330,40,40,0.4\n"),
        ("world.csv", "200,600,800,20\n"),
        ("switches.csv", "x,y,width,height,works,weight\n350,585,100,15,gate,300\n"),
        ("doors.csv", "x,y,width,height,name\n900,300,20,200,gate\n"),
    ];
    let level = level::read("wire", &Memory(files.map(|(file, text)| (file, text.to_owned())).into())).unwrap().level;
    let mut game = Game::new(Arc::new(level)).unwrap();
    let (frame, mut view) = (Frame::of_window(Vec2::new(1280.0, 720.0)), GameView::new(&game, &|_| None));
    while !game.events().iter().any(|event| matches!(event, GameEvent::Switched(0, true))) {
        game.step(Controls::default());
        assert!(game.ticks() < 600);
    }
    view.after_tick(&game);
    // The distance of the nearest green thing from the door, m.
    let lit = |view: &GameView| -> f64 {
        let canvas = Canvas::new(frame);
        view.draw(&game, 1.0, Overlays::default(), "", &canvas);
        let viewport = view.viewport(&game, 1.0, &frame);
        let light = |shape: &Shape| match shape {
            Shape::Fill { outline: Contour::Line(_, to, _), colour } if *colour == theme::good() => Some(viewport.metres(*to)),
            _ => None,
        };
        let door = DVec2::new(910.0, 400.0) / game.level().metre;
        canvas.shapes().iter().filter_map(light).map(|at| at.distance(door)).fold(f64::INFINITY, f64::min)
    };
    let mut apart = Vec::new();
    for _ in 0..60 {
        view.update(&game, 1.0, 1.0 / 60.0, Overlays::default(), &frame);
        apart.push(lit(&view));
    }
    let at_the_door = |apart: &f64| *apart < 3.0;
    assert!(!at_the_door(&apart[0]) && apart.iter().any(at_the_door) && !apart.last().is_some_and(at_the_door), "{apart:?}");
}
