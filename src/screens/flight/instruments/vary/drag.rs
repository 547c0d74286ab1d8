//! Places by hand: what has a place at the start that can vary is led elsewhere by the pointer, in the level itself.

use super::{Varied, Vary, VaryFrom};
use crate::draw::Canvas;
use crate::draw::layout::Vec2;
use crate::level::{Level, Parameter};
use crate::physics::{Aabb, BodyId, DVec2};
use crate::ui::input::Input;
use crate::view::camera::Viewport;
use crate::view::theme;

/// The pointer takes what is this near, and a shorter drag is a click for the flight, canvas units.
const NEAR: f64 = 14.0;
const STARTS: f32 = 5.0;
/// Places are led to tenths of a metre.
const PARTS: f64 = 10.0;
/// Of a dashed outline, canvas units.
const DASH: [f32; 2] = [6.0, 5.0];
/// Half the sign in its corner, and the heads of its arrows, canvas units.
const SIGN: f32 = 9.0;
const HEAD: f32 = 3.0;

#[derive(Clone, Debug)]
pub(super) struct DragHold {
    /// Its numbers to the right and upwards, as they were.
    numbers: [Option<(Parameter, f64)>; 2],
    /// Where the pointer took it: on the canvas, and m.
    from: Vec2,
    at: DVec2,
    moved: bool,
}

impl Vary {
    /// Whether places are led by hand: those of the start.
    fn leads(&self) -> bool {
        self.of_level.is_some() && self.from == VaryFrom::Start && !self.lines.is_empty()
    }

    pub fn holds_view(&self) -> bool {
        self.hold.as_ref().is_some_and(|hold| hold.moved)
    }

    /// One frame of the pointer in a level; `free` where nothing covers it. A thing that is led is the one that is followed, and shown.
    pub(in super::super) fn lead(&mut self, rest: &mut Input, (varied, level): (&Varied, &Level), free: bool) {
        if !self.leads() {
            return self.hold = None;
        }
        // The passes that show have none.
        let Some(at) = rest.place else { return };
        let pointed = thing_at(level, at, NEAR / level.metre).filter(|_| free && !rest.dragging);
        let Some(mut hold) = self.hold.take() else {
            self.over = pointed;
            if let Some(thing) = pointed.filter(|_| rest.click && rest.holding) {
                let numbers = Parameter::places(level)[thing].1.map(|number| number.and_then(|of| Some((of, of.of(level)?))));
                self.hold = Some(DragHold { numbers, from: rest.pointer, at, moved: false });
                rest.click = false;
            }
            return;
        };
        let begins = !hold.moved && rest.pointer.distance(hold.from) > STARTS;
        hold.moved |= begins;
        if !rest.holding {
            // What was not led anywhere was a click.
            rest.click |= !hold.moved;
            return;
        }
        if hold.moved {
            let by = [at.x - hold.at.x, hold.at.y - at.y];
            for ((parameter, was), by) in hold.numbers.iter().zip(by).filter_map(|(number, by)| Some(((*number)?, by))) {
                self.of_level = Some(!parameter.is_of_a_body());
                let body = parameter.body().map(|body| BodyId(body as u32));
                if begins && body.is_some_and(|body| body.index() != self.body) {
                    (rest.click, rest.pointed) = (true, body);
                }
                if let Some(line) = self.line(parameter, varied) {
                    self.ask(line, ((was + by) * PARTS).round() / PARTS, varied, !begins);
                }
            }
        }
        self.hold = Some(hold);
    }

    /// An outline around each thing that can be led, as it is at the start, with arrows for the ways that it can go.
    pub(in super::super) fn draw_places(&self, level: &Level, (view, canvas): (&Viewport, &Canvas)) {
        if !self.leads() {
            return;
        }
        for (thing, (bounds, numbers)) in Parameter::places(level).into_iter().enumerate() {
            let area = view.exact(&bounds).inset(-2.0);
            let lit = self.over == Some(thing);
            let colour = if lit { theme::accent() } else { theme::quiet() };
            let corners =
                [area.min, Vec2::new(area.max().x, area.min.y), area.max(), Vec2::new(area.min.x, area.max().y), area.min];
            canvas.dashed(&corners, &DASH, if lit { 2.5 } else { 1.5 }, colour);
            canvas.disc(corners[1], SIGN + 2.0, theme::ground());
            for (_, way) in numbers.iter().zip([Vec2::X, Vec2::Y]).filter(|(number, _)| number.is_some()) {
                for way in [way, -way] {
                    let tip = corners[1] + way * SIGN;
                    canvas.line(corners[1], tip, 1.5, colour);
                    canvas.triangle([tip, tip - (way - way.perp()) * HEAD, tip - (way + way.perp()) * HEAD], colour);
                }
            }
        }
    }
}

/// The nearest thing that can be led and has this point in it, or this near beside it, m.
fn thing_at(level: &Level, at: DVec2, near: f64) -> Option<usize> {
    let places = Parameter::places(level).into_iter().enumerate();
    let under = places.filter(|(_, (bounds, _))| bounds.contains(&Aabb::around(at, DVec2::ZERO), near));
    let nearest = under.min_by(|(_, a), (_, b)| a.0.centre().distance(at).total_cmp(&b.0.centre().distance(at)));
    nearest.map(|(thing, _)| thing)
}
