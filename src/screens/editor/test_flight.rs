//! Test flights: from the start, from the pointer, and on from where one was stopped. What was flown last stays over the picture.

use super::{Editor, arrange::PictureLayer, ask::Ask, picture::edge, tools::EditorTool};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{Game, Outcome, SHIP, level_hash};
use crate::level::document::{Document, Place, SetCell, Table, number};
use crate::physics::{Aabb, DVec2};
use crate::{draw::layout::DETAILS, draw::layout::Vec2, screens::flight::Flight, screens::flight::open::FlownTrail};
use crate::{level::Level, number::clock, ui::input::Input, words::tr};
use crate::{screens::screen::Destination, screens::screen::Request, view::mechanisms::movers, view::theme};
use std::sync::Arc;

/// A body that has moved less than this is not shown where it has moved to, m.
const MOVED: f64 = 0.05;
/// The radius of an impact's ring, canvas units, and how much larger it is for each m/s.
const RING: f32 = 3.0;
const RING_PER_SPEED: f32 = 0.5;

/// The flight before, as it was left.
#[derive(Debug)]
pub(super) struct TestFlight {
    level: Arc<Level>,
    game: Box<Game>,
    trail: FlownTrail,
}

/// A level, and the problems of what is left out of it.
type Flyable = (Arc<Level>, Vec<String>);

impl Editor {
    /// Flies the level as it is in memory, or as much of it as loads; the ship starts at that place, pixels, where there is one.
    pub(super) fn fly(&mut self, from: Option<DVec2>) -> Option<Request> {
        let ship = self.document.rows(Table::Player).next();
        let (Some(at), Some(ship)) = (from, ship) else { return self.flyable(None).map(|flyable| try_out(flyable, None)) };
        let mut document = self.document.clone();
        let cell = |column, value: f64| SetCell { row: ship, column, text: number(value.round()) };
        if let Err(refusal) = document.set(&[cell("x", at.x), cell("y", at.y)], None) {
            self.say(refusal);
            return None;
        }
        self.flyable(Some(&document)).map(|flyable| try_out(flyable, None))
    }

    /// The level of a document, or of the editor's own; where it cannot be flown, the editor says why.
    fn flyable(&mut self, document: Option<&Document>) -> Option<Flyable> {
        if document.is_none() && self.checked.0 != Some(self.document.version()) {
            self.check();
        }
        let checked = match document {
            None => self.level.clone(),
            Some(document) => self.folder.check(document).ok().map(|loaded| Arc::new(loaded.level)),
        };
        if let Some(level) = checked {
            return Some((level, Vec::new()));
        }
        match self.folder.unfinished(document.unwrap_or(&self.document)) {
            Ok(loaded) => {
                let refused = self.problems.iter().filter(|(_, refused)| *refused);
                Some((Arc::new(loaded.level), refused.map(|(problem, _)| problem.to_string()).collect()))
            }
            Err(problems) => {
                let first = problems.first().map(ToString::to_string).unwrap_or_default();
                self.say(tr!("It cannot be flown until this is mended: {first}", first));
                None
            }
        }
    }

    /// With the pointer in the picture from there, else from the next click.
    pub(super) fn fly_here(&mut self) -> Option<Request> {
        if self.panes.middle.contains(self.pointer) {
            return self.fly(Some(self.view.pixels(self.pointer)));
        }
        self.tool = EditorTool::Fly;
        self.say(tr("Click where the ship is to start."));
        None
    }

    pub(super) fn launch(&mut self, input: &Input) -> Option<Request> {
        let clicked = self.tool == EditorTool::Fly && input.click && self.panes.middle.contains(input.pointer);
        let request = clicked.then(|| self.fly_here()).flatten();
        request.inspect(|_| self.tool = EditorTool::Select)
    }

    /// The flight that was stopped goes on in the level as it is now.
    pub(super) fn go_on(&mut self) -> Option<Request> {
        let (level, problems) = self.flyable(None)?;
        let carried = self.flown.as_ref().and_then(|flown| flown.game.carried_into(&flown.level, &level));
        if carried.is_none() {
            self.say(tr("No flight goes on: it has ended, or the ship has no room there."));
        }
        carried.map(|game| try_out((level, problems), Some(Box::new(game))))
    }

    /// Takes over what was flown, and asks what a completed flight is to prove.
    pub(super) fn take_flight(&mut self, flight: &Flight) {
        let (game, level) = (flight.game(), flight.attempt().level.clone());
        self.say(match flight.end_words() {
            words if words.is_empty() => tr!("Stopped after {time}: F7 goes on from there.", time = clock(game.time())),
            words => words,
        });
        let as_it_is = self.level.as_ref().is_some_and(|own| level_hash(own) == level_hash(&level));
        if let Some(replay) = flight.proof().filter(|_| as_it_is) {
            self.ask = Some(Ask::Prove(Box::new(replay), flight.end_words()));
        }
        let mut trail = self.flown.take().map(|flown| flown.trail).unwrap_or_default();
        trail.go_on_with(flight.trail());
        self.flown = Some(TestFlight { level, game: Box::new(game.clone()), trail });
    }

    pub(super) fn draw_flown(&self, canvas: &Canvas) {
        let Some(TestFlight { level, game, trail }) = self.flown.as_ref().filter(|_| self.arranged.shows(PictureLayer::Flight))
        else {
            return;
        };
        let point = |at: DVec2| self.view.point(at * level.metre);
        let area = |bounds: Aabb| self.view.rect(&Place::between(bounds.min * level.metre, bounds.max * level.metre));
        let path: Vec<Vec2> = trail.path().chain([game.world().body(SHIP).position]).map(point).collect();
        for pair in path.windows(2) {
            canvas.line(pair[0], pair[1], 2.0, theme::accent().faded(0.7));
        }
        let here = |bounds: Aabb, colour: Colour| edge(canvas, area(bounds), 1.5, colour.faded(0.8));
        for (body, start) in game.world().bodies()[1..].iter().zip(&level.objects) {
            if body.position.distance(start.position) > MOVED {
                here(body.bounds(), theme::quiet());
            }
        }
        movers(game).for_each(|bounds| here(bounds, theme::quiet()));
        here(game.world().body(SHIP).bounds(), theme::accent());
        for bump in trail.impacts() {
            let (at, colour) = (point(bump.at), if bump.damages { theme::bad() } else { theme::text() });
            canvas.ring(at, RING + RING_PER_SPEED * bump.speed as f32, 1.5, colour);
            if bump.damages {
                let words = tr!("{speed} m/s", speed = format_args!("{:.1}", bump.speed));
                canvas.text(&words, at + Vec2::new(12.0, -8.0), Style::new(DETAILS, colour).mono());
            }
        }
    }

    /// Of the ship in the test flight before, m.
    pub fn flown_path(&self) -> Vec<DVec2> {
        self.flown.iter().flat_map(|flown| flown.trail.path()).collect()
    }

    pub(super) fn is_stopped(&self) -> bool {
        self.flown.as_ref().is_some_and(|flown| flown.game.outcome() == Outcome::Running)
    }
}

fn try_out((level, problems): Flyable, on: Option<Box<Game>>) -> Request {
    Request::Push(Destination::TryOut { level, problems, in_memory: true, on })
}
