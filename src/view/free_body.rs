//! Places of free-body arrows: from the middle of their body and to scale wherever that hides nothing. A head that would cover another one, the ship,
//! a hazard, a goal or the display moves aside, along its line, or at last off its scale, which is marked. A tiny force is as long as its head needs.

use super::facts::{ArrowKind, BodyFacts, FactRow, NO_PART, Value, reads_as_nothing};
use super::scale::{Arrow, ArrowScale, HEAD_SPREAD, Label, Reach, head_length};
use crate::draw::layout::{Area, Vec2};
use crate::game::SHIP;
use crate::physics::{BodyId, DVec2};
use std::{collections::HashMap, sync::LazyLock};

/// From the window's edge to an arrow's ends, canvas units.
const EDGE: f32 = 6.0;
/// Between two heads, and between a head and a place that it may not cover, canvas units.
const APART: f32 = 1.0;
/// The usual place must be free by this margin for an arrow to return to it, canvas units: less makes it flutter.
const RETURNS: f32 = 6.0;
/// The least visible shaft, canvas units; the ship's heads stand that far outside of it.
const SHAFT: f32 = 9.0;
/// An arrow at least this long by the scale is not drawn longer, canvas units: its head shrinks with it.
const SHORTEST: f32 = 13.0;
const BEYOND: f32 = 3.0;
/// A step's shift aside and along the line, and its lengthening, canvas units; its shortening as a share.
const ASIDE: f32 = 9.0;
const SLIDE: f32 = 14.0;
const LENGTHEN: f32 = 14.0;
const SHORTEN: f32 = 0.15;
/// The most steps of lengthening.
const LENGTHENED: f32 = 10.0;
/// An arrow within this of its length by the scale is to scale, canvas units.
const TO_SCALE: f32 = 0.5;

/// Canvas units: longer than any window, and still exact enough for arithmetic.
const LONGEST: f64 = 1e6;

#[derive(Clone, Debug)]
pub struct ArrowSubject {
    pub facts: BodyFacts,
    pub object: Area,
}

/// The places that arrows keep off.
#[derive(Clone, Copy, Debug)]
pub struct Ground<'a> {
    pub window: Area,
    /// No head may cover these: the ship, hazards, goals.
    pub never: &'a [Area],
    /// Neither head nor shaft may cross these: the head-up display.
    pub panels: &'a [Area],
}

impl Ground<'_> {
    /// The start of a body's arrows: its middle, or the nearest point in the window.
    pub fn start(&self, object: &Area) -> Vec2 {
        let inner = self.window.inset(EDGE + 1.0);
        object.centre().clamp(inner.min, inner.max())
    }

    /// The distance from a point along a line to the window's edge or a panel.
    fn room(&self, from: Vec2, along: Vec2) -> f32 {
        let farthest = self.window.size.length();
        let inner = self.window.inset(EDGE).stretch(from, along, farthest).map_or(0.0, |(_, leaves)| leaves);
        // A panel that begins behind the start does not shorten the line.
        let meets = |panel: &Area| panel.stretch(from, along, farthest).map(|(enters, _)| enters).filter(|enters| *enters > 0.0);
        self.panels.iter().filter_map(meets).map(|enters| enters - EDGE).fold(inner, f32::min)
    }

    fn crosses_panel(&self, from: Vec2, along: Vec2, length: f32) -> bool {
        self.panels.iter().any(|panel| panel.stretch(from, along, length).is_some_and(|(enters, _)| enters > 0.0))
    }
}

/// The force or impact of a line with an arrow, and its vector. A line whose value is written as zero beside the others has none.
pub fn arrow_of(row: &FactRow, beside: &[FactRow]) -> Option<(ArrowKind, DVec2)> {
    match (row.shown, row.value) {
        (Some(ArrowKind::Resultant), Value::Vector(vector)) => {
            let forces = beside.iter().filter_map(FactRow::exerted).filter(|(shown, _)| !shown.is_impact());
            let largest = forces.map(|(_, force)| force.length()).fold(0.0, f64::max);
            Some((ArrowKind::Resultant, vector)).filter(|_| vector.length() >= NO_PART * largest)
        }
        _ => row.exerted(),
    }
    .filter(|_| !reads_as_nothing(row, beside))
}

/// The sizes of the forces and of the impulses of some bodies, with the room of their arrows.
pub fn reaches(subjects: &[ArrowSubject], ground: &Ground) -> [Vec<Reach>; 2] {
    let mut found = [Vec::new(), Vec::new()];
    for subject in subjects {
        let from = ground.start(&subject.object);
        for (shown, vector) in subject.facts.rows.iter().filter_map(|row| arrow_of(row, &subject.facts.rows)) {
            found[usize::from(shown.is_impact())].push((vector.length(), ground.room(from, vector.normalize_or_zero().as_vec2())));
        }
    }
    found
}

/// The arrows, from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct ArrowLayout {
    pub arrows: Vec<Arrow>,
    pub left_out: usize,
    /// The index in [`MOVES`] of each arrow: by its body, its kind, and its place among those of the same kind.
    moved: HashMap<(BodyId, ArrowKind, usize), usize>,
}

impl ArrowLayout {
    /// `metre` is canvas units a metre of the level.
    pub fn arrange(&mut self, subjects: &[ArrowSubject], scale: &ArrowScale, metre: f64, ground: &Ground) {
        let before = std::mem::take(&mut self.moved);
        self.arrows.clear();
        self.left_out = 0;
        let mut heads: Vec<Area> = Vec::new();
        for subject in subjects {
            let mut rows: Vec<(usize, ArrowKind, DVec2)> = told_rows(&subject.facts, scale);
            // The longest first, so that a shorter one over a longer can be seen; the resultant below all.
            let arrow = |row: &(usize, ArrowKind, DVec2)| row.1 != ArrowKind::Resultant;
            rows.sort_by(|a, b| arrow(a).cmp(&arrow(b)).then(b.2.length_squared().total_cmp(&a.2.length_squared())));
            for (i, &(row, shown, metres)) in rows.iter().enumerate() {
                let key = (subject.facts.body, shown, rows[..i].iter().filter(|other| other.1 == shown).count());
                let drawn = (metres.normalize_or_zero().as_vec2(), (metres.length() * metre).min(LONGEST) as f32);
                let wish = ArrowWish::new(subject, shown, drawn, ground);
                let near: Vec<_> = ground.never.iter().chain(&heads).copied().filter(|area| area.gap(&wish.reach) < 0.0).collect();
                match wish.place(before.get(&key).copied(), &near, ground) {
                    Some((index, from, to, to_scale)) => {
                        self.moved.insert(key, index);
                        heads.push(head_area(from, to, shown));
                        self.arrows.push(Arrow { body: subject.facts.body, row, shown, from, to, to_scale });
                    }
                    None => self.left_out += 1,
                }
            }
        }
    }
}

/// The lines of a body that have arrows, with these in metres of the level.
fn told_rows(facts: &BodyFacts, scale: &ArrowScale) -> Vec<(usize, ArrowKind, DVec2)> {
    let one = |shown: ArrowKind| if shown.is_impact() { scale.newton_seconds } else { scale.newtons };
    let rows = facts.rows.iter().enumerate().filter_map(|(row, fact)| Some((row, arrow_of(fact, &facts.rows)?)));
    rows.map(|(row, (shown, vector))| (row, shown, vector / one(shown))).collect()
}

pub fn head_area(from: Vec2, to: Vec2, shown: ArrowKind) -> Area {
    let along = (to - from).normalize_or_zero();
    let length = head_length(shown);
    let (foot, side) = (to - along * length.x, along.perp() * length.y * HEAD_SPREAD * 1.3);
    let corners = [to + side, to - side, foot + side, foot - side];
    let (min, max) = corners.iter().fold((to, to), |(min, max), corner| (min.min(*corner), max.max(*corner)));
    Area { min: min - 1.0, size: max - min + 2.0 }
}

/// An arrow's shift from its usual place, in steps.
#[derive(Clone, Copy, Debug)]
struct Move {
    aside: i8,
    slide: i8,
    stretch: i8,
}

/// The most steps of an arrow along its line, against its direction and with it.
const SLIDES: [i8; 2] = [13, 8];
/// The cost of a step: along the line, so that equal arrows begin side by side, and to another length, last of all.
const SLIDE_COST: f32 = 6.0;
const STRETCH_COST: f32 = 1.2;
const OFF_SCALE: f32 = 100.0;
/// An arrow that begins outside of its body, against its direction, stands this far aside, in steps: it would lie over the others.
const OUTSIDE_ASIDE: i8 = 2;

/// All moves, the least first; at most two sorts at once.
static MOVES: LazyLock<Vec<Move>> = LazyLock::new(|| {
    let mut moves = Vec::new();
    for aside in -6..=6_i8 {
        for slide in -SLIDES[0]..=SLIDES[1] {
            for stretch in -4..=LENGTHENED as i8 {
                if aside == 0 || slide == 0 || stretch == 0 {
                    moves.push(Move { aside, slide, stretch });
                }
            }
        }
    }
    let cost = |by: &Move| {
        let off_scale = if by.stretch == 0 { 0.0 } else { OFF_SCALE };
        let [aside, slide, stretch] = [by.aside, by.slide, by.stretch].map(|steps| f32::from(steps.abs()));
        aside + SLIDE_COST * slide + STRETCH_COST * stretch + off_scale
    };
    moves.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    moves
});

struct ArrowWish {
    shown: ArrowKind,
    from: Vec2,
    along: Vec2,
    /// From its usual start to its body's edge against its direction.
    back: f32,
    /// Length by the scale, least visible length, and length where nothing is in the way.
    length: f32,
    least: f32,
    base: f32,
    reach: Area,
}

impl ArrowWish {
    fn new(subject: &ArrowSubject, shown: ArrowKind, (along, length): (Vec2, f32), ground: &Ground) -> Self {
        let from = ground.start(&subject.object);
        let exit = || subject.object.stretch(from, along, f32::MAX).map_or(0.0, |(_, leaves)| leaves);
        let back = subject.object.stretch(from, -along, f32::MAX).map_or(0.0, |(_, leaves)| leaves);
        let outside = if subject.facts.body == SHIP { exit() + BEYOND } else { 0.0 };
        let head = head_length(shown);
        let least = outside.max(SHAFT) + head.x;
        // A single head shrinks with its arrow; the ship would hide it.
        let by_scale = if outside > 0.0 || head.x > head.y { outside + head.x } else { SHORTEST };
        let least = if length >= by_scale.max(SHORTEST) { least.min(length) } else { least };
        let (room, slides) = (ground.room(from, along), f32::from(SLIDES[0]) * SLIDE);
        let base = if length > room + slides { room } else { length }.max(least);
        let far = Vec2::splat(slides + LENGTHENED * LENGTHEN + head_length(shown).x);
        let (min, max) = (from.min(from + along * base) - far, from.max(from + along * base) + far);
        Self { shown, from, along, back, length, least, base, reach: Area { min, size: max - min } }
    }

    /// The first free place, off the scale at last: its index, the arrow's ends, and whether it is to scale.
    fn place(&self, before: Option<usize>, near: &[Area], ground: &Ground) -> Option<(usize, Vec2, Vec2, bool)> {
        let usual_clearance = if before.is_some_and(|index| index > 0) { RETURNS } else { APART };
        let tried = |index: usize, apart: f32| self.tried(index, apart, near, ground);
        let at_body = |index: &usize| MOVES.get(*index).is_some_and(|by| by.stretch == 0 && !self.begins_outside(*by));
        tried(0, usual_clearance)
            .or_else(|| tried(before.filter(at_body)?, APART))
            .or_else(|| (0..MOVES.len()).filter(at_body).find_map(|index| tried(index, APART)))
            .or_else(|| tried(before?, APART))
            .or_else(|| (0..MOVES.len()).find_map(|index| tried(index, APART)))
    }

    /// Whether a moved arrow begins outside of its body, against its direction.
    fn begins_outside(&self, by: Move) -> bool {
        f32::from(by.slide) * SLIDE < -self.back
    }

    fn tried(&self, index: usize, apart: f32, near: &[Area], ground: &Ground) -> Option<(usize, Vec2, Vec2, bool)> {
        let by = *MOVES.get(index)?;
        let Move { aside, slide, stretch } = by;
        let stretch = f32::from(stretch);
        let length = if stretch > 0.0 { self.base + stretch * LENGTHEN } else { self.base * (1.0 + stretch * SHORTEN) };
        if length < self.least || self.begins_outside(by) && aside.abs() < OUTSIDE_ASIDE {
            return None;
        }
        let from = self.from + self.along.perp() * (f32::from(aside) * ASIDE) + self.along * (f32::from(slide) * SLIDE);
        let to = from + self.along * length;
        let inner = ground.window.inset(EDGE - 1.0);
        let head = head_area(from, to, self.shown);
        let free = inner.contains(from)
            && head.min.cmpge(inner.min).all()
            && head.max().cmple(inner.max()).all()
            && near.iter().chain(ground.panels).all(|other| head.gap(other) >= apart)
            && !ground.crosses_panel(from, self.along, length);
        free.then_some((index, from, to, (length - self.length).abs() <= TO_SCALE))
    }
}

/// Places of the arrows' labels, beyond the tip or next to it, clear of each other and of `taken`. One without room is left out: its box names it.
pub fn place_labels(arrows: &[Arrow], height: f32, width: impl Fn(&str) -> f32, window: Area, taken: &[Area]) -> Vec<Label> {
    let mut fixed = taken.to_vec();
    let mut labels = Vec::new();
    for (index, arrow) in arrows.iter().enumerate() {
        let size = Vec2::new(width(arrow.name()), height);
        let along = (arrow.to - arrow.from).normalize_or_zero();
        // From the tip to the label's middle so that the label just clears the tip in that direction.
        let beyond = |way: Vec2, gap: f32| arrow.to + way * ((size * 0.5 * way.abs()).element_sum() + gap);
        let beside = |back: f32| [along.perp(), -along.perp()].map(|side| beyond(side, 9.0) - along * back);
        let length = arrow.length();
        let places = [beyond(along, 4.0)]
            .into_iter()
            .chain(beside(6.0))
            .chain([beyond(along, 4.0 + height)])
            .chain(beside(6.0 + height))
            .chain([beyond(along, 4.0 + 2.0 * height)])
            // For a tip at the window's edge or before a box: beside the shaft.
            .chain(beside(length * 0.4))
            .chain(beside(length * 0.65));
        let reach = Area::around(arrow.to, 2.0 * (size + 3.0 * height) + 1.3 * length);
        let near: Vec<Area> = fixed.iter().copied().filter(|other| other.gap(&reach) < 0.0).collect();
        let inside = |area: &Area| area.min.cmpge(window.min).all() && area.max().cmple(window.max()).all();
        let mut areas = places.map(|middle| Area::around(middle, size));
        if let Some(area) = areas.find(|area| inside(area) && area.covers_none(&near)) {
            fixed.push(area);
            labels.push(Label { arrow: index, area });
        }
    }
    labels
}
