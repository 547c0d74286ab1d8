//! The introduction of a level: its name, the whole of its rooms, its goals one after the other.

use super::Flight;
use crate::draw::layout::{Area, HEADING, PADDING, TEXT, TITLE, Vec2};
use crate::draw::{Canvas, Style};
use crate::game::{Outcome, goals};
use crate::ui::input::Input;
use crate::view::{camera::Viewport, emitters::objective_colour, theme};
use crate::words::tr;

/// How long it stays, s, and how long it takes to come and to go.
const LASTS: f64 = 2.0;
const FADES: f64 = 0.2;
/// From one goal's ring to the next, and how long each spreads, s; by how much, canvas units.
const NEXT: f64 = 0.3;
const SPREADS: f64 = 0.7;
const REACH: f32 = 36.0;
/// The height of the dark at the foot, behind the words, and the strips that it fades in.
const FOOT: f32 = 200.0;
const STRIPS: usize = 20;
const FROM_EDGE: f32 = 64.0;

impl Flight {
    /// A frame of it: any key ends it, and does what it always does.
    pub(super) fn introduce(&mut self, input: &Input) {
        let Some(age) = &mut self.open.introduced else { return };
        *age += input.frame_time;
        if *age > LASTS || !input.pressed.is_empty() || input.click {
            self.open.introduced = None;
        }
    }

    /// Whether the whole level is in view: it is introduced, or has not begun and asks for that.
    pub(super) fn shows_all(&self) -> bool {
        let begins = self.run.game.is_idle() && self.run.game.outcome() == Outcome::Running;
        let overview = self.run.game.level().overview && begins && !self.is_watched();
        self.open.introduced.is_some() || self.seen.observer.shows_map() || overview
    }

    /// Rings spread from the goals, in their order.
    pub(super) fn draw_goals_in_order(&self, view: &Viewport, canvas: &Canvas) {
        let Some(age) = self.open.introduced else { return };
        let level = self.run.game.level();
        let mut order: Vec<usize> = (0..level.objectives.len()).collect();
        order.sort_by_key(|index| level.objectives[*index].order);
        for (turn, index) in order.into_iter().enumerate() {
            let part = ((age - FADES - turn as f64 * NEXT) / SPREADS) as f32;
            if (0.0..1.0).contains(&part) {
                let (area, colour) = (view.rect(&level.objectives[index].bounds), objective_colour(&self.run.game, index));
                for ring in 0..3 {
                    let spread = area.inset(-REACH * part * (1.0 + 0.3 * ring as f32));
                    canvas.rounded_edge(spread, 8.0, 2.5, colour.faded((1.0 - part) * 0.9f32.powi(ring)));
                }
            }
        }
    }

    /// Its name and its world at the left, what it offers at the right.
    pub(super) fn draw_introduction(&self, canvas: &Canvas) {
        let Some(age) = self.open.introduced else { return };
        let (level, size) = (self.run.game.level(), canvas.size());
        let strong = (age / FADES).min((LASTS - age) / FADES).clamp(0.0, 1.0) as f32;
        canvas.end_layer();
        let strip = FOOT / STRIPS as f32;
        for i in 0..STRIPS {
            let area = Area::new(0.0, size.y - FOOT + i as f32 * strip, size.x, strip);
            canvas.rectangle(area, theme::ground().faded(strong * 0.92 * (i as f32 / STRIPS as f32)));
        }
        let name = if level.title == level.name { tr!("Level {level}", level = level.name) } else { tr(&level.title).to_owned() };
        let at = Vec2::new(FROM_EDGE, size.y - FROM_EDGE);
        let title = Style::new(TITLE, theme::text().faded(strong)).middle();
        let large = canvas.width(&name, title) < 0.6 * size.x;
        canvas.text(&name, at, if large { title } else { Style { size: HEADING, ..title } });
        let quiet = Style::new(TEXT, theme::quiet().faded(strong)).middle();
        if let Some(world) = level.landscape {
            canvas.text(tr(world.title()), at - Vec2::new(0.0, canvas.line_height(TITLE) * 0.6), quiet);
        }
        let right = Vec2::new(size.x - FROM_EDGE, at.y);
        canvas.text(tr("any key starts the flight"), right, quiet.right());
        // Who has not been there is not hurried.
        let offers = if self.open.done { goals(&level.awards, &self.run.game.result()) } else { Vec::new() };
        for (i, offer) in offers.iter().rev().enumerate() {
            let above = right - Vec2::new(0.0, (i + 1) as f32 * (canvas.line_height(TEXT) + PADDING / 4.0));
            canvas.text(&offer.asks, above, quiet.right());
        }
    }
}
