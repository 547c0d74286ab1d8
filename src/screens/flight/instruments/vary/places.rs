//! Places: of the parts of the panel, which stands at the top right, a line below the other; and of what has a place at the start that
//! can vary, which the pointer leads elsewhere in the level itself.

use super::{Varied, Vary, VaryFrom};
use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, Vec2};
use crate::physics::{Aabb, BodyId, DVec2};
use crate::{draw::Canvas, level::Level, level::Parameter, ui::input::Input, view::camera::Viewport, view::theme};

/// Widths in heights of the text: of a line's name, slider, number and reset.
const COLUMNS: [f32; 4] = [7.2, 6.0, 7.2, 6.6];
const GAP: f32 = GRID;
const INSIDE: f32 = 1.5 * GRID;
/// Besides the lines: a heading, two rows of buttons, a message.
const ROWS: f32 = 4.0;
/// The room of a line above its text where the canvas is high enough.
const LEADING: f32 = 8.0;
const APART: f32 = 2.0;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Layout {
    pub panel: Area,
    pub buttons: [Area; 4],
    pub field: Area,
    top: f32,
    line: f32,
    columns: [(f32, f32); 4],
}

impl Layout {
    /// On a canvas, with that many lines; closer where they would not fit.
    pub fn new(frame: &Frame, lines: usize) -> Self {
        let text = frame.text_height(DETAILS);
        let rows = lines as f32 + ROWS;
        let room = frame.size.y - 2.0 * GRID - 2.0 * INSIDE - 3.25 * GAP;
        let line = (text * LINE + LEADING).min(room / rows).max(text + 2.0 * APART).floor();
        let width = COLUMNS.iter().sum::<f32>() * text + 3.0 * GAP + 2.0 * INSIDE;
        let min = Vec2::new(frame.size.x - 2.0 * GRID - width, 2.0 * GRID);
        let mut left = min.x + INSIDE;
        let columns = COLUMNS.map(|column| {
            let (begins, ends) = (left, left + column * text);
            left = ends + GAP;
            (begins, ends)
        });
        let row = |index: f32| min.y + INSIDE + index * line;
        let half = (width - 2.0 * INSIDE - GAP) / 2.0;
        let button = |index: usize, y: f32| {
            let x = min.x + INSIDE + index as f32 * (half + GAP);
            inner(Area::new(x, y, half, line))
        };
        let top = row(2.0) + 1.5 * GAP;
        let foot = top + lines as f32 * line + GAP;
        let field = Area::new(min.x + INSIDE, foot + line + 0.75 * GAP, width - 2.0 * INSIDE, line);
        Self {
            panel: Area { min, size: Vec2::new(width, field.max().y + INSIDE - min.y) },
            buttons: [button(0, row(1.0) + 0.5 * GAP), button(1, row(1.0) + 0.5 * GAP), button(0, foot), button(1, foot)],
            field: inner(field),
            top,
            line,
            columns,
        }
    }

    pub fn heading(&self) -> Area {
        Area::new(self.columns[0].0, self.panel.min.y + INSIDE, self.panel.size.x - 2.0 * INSIDE, self.line)
    }

    /// At the right end of the heading: to the other lines.
    pub fn page(&self) -> Area {
        let (left, right) = (self.columns[2].0, self.columns[3].1);
        inner(Area::new(left, self.heading().min.y, right - left, self.line))
    }

    /// All of a line, across the panel.
    pub fn row(&self, line: usize) -> Area {
        Area::new(self.panel.min.x, self.top + line as f32 * self.line, self.panel.size.x, self.line)
    }

    /// Name, slider, number and reset of a line.
    pub fn cells(&self, line: usize) -> [Area; 4] {
        let row = self.row(line);
        let cell = |(begins, ends): (f32, f32)| Area::new(begins, row.min.y, ends - begins, row.size.y);
        let [name, slider, number, reset] = self.columns.map(cell);
        [name, slider, inner(number), inner(reset)]
    }
}

fn inner(cell: Area) -> Area {
    Area::new(cell.min.x, cell.min.y + APART, cell.size.x, cell.size.y - 2.0 * APART)
}

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
