//! The picture of a body's forces as in a textbook: the body alone, its forces side by side by direction, with name and value at each tip; beside it
//! their polygon with the resultant. Impulses have a scale of their own and are no part of it. [`lay_out`] is plain arithmetic.

use super::facts::{ArrowKind, BodyFacts, NO_PART, Value, facts};
use super::scale::{self, Arrow, ScaleStep};
use super::{theme, widgets};
use crate::draw::layout::{self, Area, BUTTON_TEXT, Frame, GRID, LINE, PADDING, TEXT, Vec2, words_width};
use crate::draw::{Canvas, Style};
use crate::game::{Controls, Game};
use crate::physics::{BodyId, DVec2};
use crate::{number::scalar, words::tr};
use std::{borrow::Cow, f64::consts::TAU};

/// Side of a square of the paper, and the longer half of the body, canvas units.
const SQUARE: f32 = 32.0;
const BODY: f32 = 26.0;
/// A part with less than this many heights of the text in its width has two lines below it.
const NARROW: f32 = 16.0;
/// Between arrows side by side, and the least length of one, canvas units.
const APART: f32 = 16.0;
const LEAST: f32 = 14.0;
/// From a tip or a side to its tag, and from a tag to other arrows, canvas units.
const BESIDE: f32 = 6.0;
const CLEAR: f32 = 3.0;
/// Step of the search for a free place, and a tag farther than this from its arrow is tied to it, canvas units.
const STEP: f32 = 12.0;
const TIED: f32 = 24.0;
/// Cosine of the angle within which two arrows have one direction.
const ONE_WAY: f32 = 0.995;
/// Longer arrows must fit for this long before they are drawn longer, s of the game.
const PATIENCE: f64 = 1.0;

/// A force or an impulse, y down.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedArrow {
    pub shown: ArrowKind,
    pub vector: DVec2,
    /// With its owner.
    pub name: String,
    /// Its size with the unit.
    pub value: String,
}

impl NamedArrow {
    /// Those of a body that count, and its resultant; none where that is zero.
    pub fn of(facts: &BodyFacts) -> (Vec<Self>, Option<Self>) {
        let vectors = facts.rows.iter().filter_map(|row| match row.value {
            Value::Vector(vector) => Some((row, row.shown?, vector)),
            Value::Scalar(_) => None,
        });
        let all: Vec<_> = vectors.collect();
        let largest = |impact: bool| {
            let sizes = all.iter().filter(|(_, shown, _)| *shown != ArrowKind::Resultant && shown.is_impact() == impact);
            sizes.map(|(.., vector)| vector.length()).fold(0.0, f64::max)
        };
        let counts = |(_, shown, vector): &&(_, ArrowKind, DVec2)| {
            let size = vector.length();
            size > 0.0 && size >= NO_PART * largest(shown.is_impact())
        };
        let named = all.iter().filter(counts).map(|(row, shown, vector)| Self {
            shown: *shown,
            vector: *vector,
            name: row.label(),
            value: scalar(vector.length(), row.unit),
        });
        let (resultant, forces): (Vec<Self>, Vec<Self>) = named.partition(|named| named.shown == ArrowKind::Resultant);
        (forces, resultant.into_iter().next())
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Tag {
    pub lines: Vec<String>,
    /// The lines of its name; the others are its value.
    pub names: usize,
    pub area: Area,
    pub shown: ArrowKind,
    /// The point of its arrow that it belongs to.
    pub at: Vec2,
}

/// Arrows and tags of the body, then of the polygon.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PictureLayout {
    pub arrows: Vec<Arrow>,
    pub tags: Vec<Tag>,
}

/// The parts of the room for the body and for the polygon: beside each other, or below where it is higher than wide.
pub fn parts(room: Area) -> [Area; 2] {
    let along = if room.size.x >= room.size.y { Vec2::X } else { Vec2::Y };
    let half = |by: f32| (room.size - along * GRID) * (Vec2::ONE - along * 0.5) + along * by;
    let size = half(0.0);
    [Area { min: room.min, size }, Area { min: room.min + along * (size + GRID), size }]
}

/// What a canvas unit must be worth at least, N and N·s, for all arrows to have room in these parts.
pub fn needed(forces: &[NamedArrow], parts: &[Area; 2], line: f32) -> [f64; 2] {
    let reach = (parts[0].size * 0.5 - Vec2::new(PADDING, 2.0 * line + PADDING)).max(Vec2::splat(LEAST)).as_dvec2();
    let longest = |impact: bool| {
        let sizes = forces.iter().filter(|force| force.shown.is_impact() == impact);
        sizes.map(|force| (force.vector.abs() / reach).max_element()).fold(0.0, f64::max)
    };
    let corners = corners(&in_order(forces));
    let (low, high) = corners.iter().fold((DVec2::ZERO, DVec2::ZERO), |(low, high), at| (low.min(*at), high.max(*at)));
    let room = (parts[1].size - 4.0 * Vec2::splat(line)).max(Vec2::splat(LEAST)).as_dvec2();
    [longest(false).max(((high - low) / room).max_element()), longest(true)]
}

/// The forces, anticlockwise from the right: their polygon does not cross itself.
fn in_order(forces: &[NamedArrow]) -> Vec<&NamedArrow> {
    let mut order: Vec<&NamedArrow> = forces.iter().filter(|force| !force.shown.is_impact()).collect();
    // A hair's breadth below the right counts as the right.
    let angle = |force: &NamedArrow| ((-force.vector.y).atan2(force.vector.x) + 1e-6).rem_euclid(TAU);
    order.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    order
}

/// The corners of their polygon from its first tail on, N.
fn corners(order: &[&NamedArrow]) -> Vec<DVec2> {
    let mut at = DVec2::ZERO;
    let tips = order.iter().map(|force| {
        at += force.vector;
        at
    });
    [DVec2::ZERO].into_iter().chain(tips).collect()
}

/// Places all in these parts; `worth` is that of a canvas unit, N and N·s; `line` the height of a line of words, and `width` how wide words are.
pub fn lay_out(
    (forces, resultant): (&[NamedArrow], Option<&NamedArrow>),
    parts: &[Area; 2],
    worth: [f64; 2],
    (line, width): (f32, &dyn Fn(&str) -> f32),
) -> PictureLayout {
    let mut laid = PictureLayout::default();
    let arrow = |row, shown, from, to, to_scale| Arrow { body: BodyId(0), row, shown, from, to, to_scale };
    let along = |force: &NamedArrow| force.vector.normalize_or_zero().as_vec2();
    for (row, force) in forces.iter().enumerate() {
        let way = along(force);
        let alike: Vec<usize> = (0..forces.len()).filter(|i| along(&forces[*i]).dot(way) > ONE_WAY).collect();
        let rank = alike.iter().take_while(|i| **i < row).count() as f32 - (alike.len() - 1) as f32 * 0.5;
        let from = parts[0].centre() + way.perp() * rank * APART;
        let length = (force.vector.length() / worth[usize::from(force.shown.is_impact())]) as f32;
        laid.arrows.push(arrow(row, force.shown, from, from + way * length.max(LEAST), length >= LEAST));
    }
    let order = in_order(forces);
    let corners = corners(&order);
    let (low, high) = corners.iter().fold((DVec2::ZERO, DVec2::ZERO), |(low, high), at| (low.min(*at), high.max(*at)));
    let place = |at: DVec2| parts[1].centre() + ((at - (low + high) * 0.5) / worth[0]).as_vec2();
    let first = laid.arrows.len();
    let sides = order.iter().zip(corners.windows(2)).map(|(force, ends)| (*force, place(ends[0]), place(ends[1])));
    let sum = resultant.map(|sum| (sum, place(corners[0]), place(corners[0] + sum.vector)));
    for (side, from, to) in sides.chain(sum) {
        let length = from.distance(to);
        let to = from + along(side) * length.max(LEAST);
        let aside = aside(&laid.arrows[first..], from, to);
        laid.arrows.push(arrow(forces.len(), side.shown, from + aside, to + aside, length >= LEAST));
    }
    let body = Area::around(parts[0].centre(), Vec2::splat(2.0 * BODY));
    let named: Vec<&NamedArrow> = forces.iter().chain(order.iter().copied()).chain(resultant).collect();
    for (i, named) in named.into_iter().enumerate() {
        let Arrow { from, to, shown, .. } = laid.arrows[i];
        let (part, lines) = match named.shown {
            _ if i < first => (0, vec![named.name.clone(), named.value.clone()]),
            ArrowKind::Resultant => (1, vec![format!("{} {}", named.name, named.value)]),
            _ => (1, vec![named.name.clone()]),
        };
        let way = (to - from).normalize_or_zero();
        let out = from.midpoint(to) - parts[1].centre();
        let (at, way) = match i < first {
            true => (to, way),
            false => (from.midpoint(to), if way.perp().dot(out) < 0.0 { -way.perp() } else { way.perp() }),
        };
        let taken: Vec<Area> = laid.tags.iter().map(|tag| tag.area).chain([body]).collect();
        let placed = |share: &f32| {
            let cut = |words: &String| layout::lines(words, share * parts[part].size.x, width);
            let named = cut(&lines[0]);
            let (names, lines) = (named.len(), named.into_iter().chain(lines[1..].iter().cloned()).collect::<Vec<String>>());
            let size = Vec2::new(lines.iter().map(|words| width(words)).fold(0.0, f32::max) + GRID, lines.len() as f32 * line);
            Some(Tag { lines, names, area: free_place(at, way, size, (&parts[part], &taken, &laid.arrows))?, shown, at })
        };
        // A name without room stands in several lines.
        if let Some(tag) = [1.0, 0.6, 0.4].iter().find_map(placed) {
            laid.tags.push(tag);
        }
    }
    laid
}

/// The least shift to a side at which a line lies on none of these arrows.
fn aside(arrows: &[Arrow], from: Vec2, to: Vec2) -> Vec2 {
    let (way, length) = ((to - from).normalize_or_zero(), from.distance(to));
    let lies_on = |other: &Arrow, by: f32| {
        let ends = [other.from, other.to].map(|end| end - from);
        let far = ends.map(|end| end.dot(way.perp()) - by).map(f32::abs);
        let stretch = ends.map(|end| end.dot(way));
        far[0].max(far[1]) < APART - 1.0 && stretch[0].min(stretch[1]) < length - 1.0 && stretch[0].max(stretch[1]) > 1.0
    };
    let shifts = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0].map(|step| step * APART);
    way.perp() * shifts.iter().find(|by: &&f32| !arrows.iter().any(|other| lies_on(other, **by))).copied().unwrap_or_default()
}

/// A place for words of that size beyond a point, beside it, or as near to it as there is one: on no other words, and if that can be on no arrow.
fn free_place(at: Vec2, way: Vec2, size: Vec2, (room, taken, arrows): (&Area, &[Area], &[Arrow])) -> Option<Area> {
    let beyond = |way: Vec2| Area::around(at + way * ((size * 0.5 * way.abs()).element_sum() + BESIDE), size);
    let near = [way, way.perp(), -way.perp(), (way + way.perp()).normalize_or_zero(), (way - way.perp()).normalize_or_zero()];
    let cells = ((room.size - size) / STEP).floor().max(Vec2::ZERO);
    let grid = (0..=cells.x as usize).flat_map(|x| (0..=cells.y as usize).map(move |y| STEP * Vec2::new(x as f32, y as f32)));
    let mut places: Vec<Area> = grid.map(|from| Area { min: room.min + from, size }).collect();
    let far = |area: &Area| at.distance(at.clamp(area.min, area.max())) + 0.1 * at.distance(area.centre());
    places.sort_by(|a, b| far(a).total_cmp(&far(b)));
    let places: Vec<Area> = near.map(beyond).into_iter().chain(places).collect();
    let inside = |area: &&Area| area.min.cmpge(room.min).all() && area.max().cmple(room.max()).all() && area.covers_none(taken);
    let crossed = |area: &Area| {
        let wide = area.inset(-CLEAR);
        arrows.iter().any(|arrow| wide.stretch(arrow.from, (arrow.to - arrow.from).normalize_or_zero(), arrow.length()).is_some())
    };
    let free = || places.iter().filter(inside);
    free().find(|area| !crossed(area)).or_else(|| free().next()).copied()
}

/// The game whose forces are shown: at its start those of the first tick, since ropes and floors carry nothing before it.
pub fn acting(game: &Game, id: BodyId) -> Cow<'_, Game> {
    if game.ticks() > 0 {
        return Cow::Borrowed(game);
    }
    let mut first = game.clone();
    // Asks the tick for what contacts carry.
    let _ = first.world().forces(id);
    first.step(Controls::default());
    Cow::Owned(first)
}

/// Forces and their resultant, what a canvas unit is worth, and the height of a line.
type LayoutInputs = (Vec<NamedArrow>, Option<NamedArrow>, [f64; 2], f32);

#[derive(Default)]
pub struct BodyPicture {
    of: Option<BodyId>,
    /// N and N·s a square.
    squares: [ScaleStep; 2],
    pub layout: PictureLayout,
    /// Of what that is the layout.
    laid: Option<LayoutInputs>,
    parts: [Area; 2],
    /// Half the size of the drawn body, and whether it is round.
    body: (Vec2, bool),
    /// Above the parts, and below them.
    pub heads: [String; 2],
    pub feet: [String; 2],
}

impl BodyPicture {
    /// Lays the picture of a body out in that part of the canvas.
    pub fn arrange(&mut self, game: &Game, id: BodyId, room: Area, frame: &Frame) {
        if self.of != Some(id) {
            *self = Self { of: Some(id), ..Self::default() };
        }
        let game = &*acting(game, id);
        let (facts, body) = (facts(game, id), game.world().body(id));
        let (forces, resultant) = NamedArrow::of(&facts);
        let text = frame.text_height(TEXT);
        let (line, head) = (text * LINE, frame.text_height(BUTTON_TEXT) * LINE);
        let whole = parts(room.inset(PADDING));
        let foot = if whole[0].size.x < NARROW * text { 2.0 * line } else { line };
        let parts = whole.map(|part| Area { min: part.min + Vec2::Y * head, size: part.size - Vec2::Y * (head + foot) });
        let needed = needed(&forces, &parts, line);
        let patience = (PATIENCE * game.tick_rate()) as u64;
        let mut a_square = [0.0; 2];
        for ((found, step), needed) in a_square.iter_mut().zip(&mut self.squares).zip(needed) {
            *found = step.update(needed * f64::from(SQUARE), game.ticks(), patience);
        }
        let worth = a_square.map(|square| square / f64::from(SQUARE));
        let impulses = forces.iter().any(|force| force.shown.is_impact());
        let has_forces = forces.iter().any(|force| !force.shown.is_impact());
        let asked = (forces, resultant, worth, line);
        if self.laid.as_ref() != Some(&asked) || parts != self.parts {
            self.layout = lay_out((&asked.0[..], asked.1.as_ref()), &parts, worth, (line, &|words| words_width(words, text)));
        }
        self.parts = parts;
        let half = body.half.as_vec2();
        let round = game.level().objects.get(id.index().wrapping_sub(1)).is_some_and(|object| object.circular);
        self.body = (half / half.max_element().max(f32::MIN_POSITIVE) * BODY, round);
        let mass = scalar(body.mass, "kg");
        self.heads = [format!("{} · {mass}", facts.title), tr("Forces tip to tail").to_owned()];
        let scales = [(has_forces, "N"), (impulses, "N·s")].into_iter().zip(a_square).filter(|((there, _), _)| *there);
        let scales: Vec<String> = scales.map(|((_, unit), square)| scalar(square, unit)).collect();
        let scale = if scales.is_empty() { String::new() } else { tr!("1 square = {size}", size = scales.join(", ")) };
        let sum = match &asked.1 {
            Some(sum) => {
                let acceleration = scalar(sum.vector.length() / body.mass, "m/s²");
                format!("F = {mass} · {acceleration} = {}", sum.value)
            }
            None if has_forces => tr("Balance: the resultant is zero.").to_owned(),
            None => tr("No force: the resultant is zero.").to_owned(),
        };
        self.feet = [scale, sum];
        self.laid = Some(asked);
    }

    pub fn draw(&self, canvas: &Canvas) {
        canvas.rectangle(canvas.frame().area(), theme::ground());
        for (part, (head, foot)) in self.parts.iter().zip(self.heads.iter().zip(&self.feet)) {
            draw_paper(canvas, part);
            let above = Vec2::new(part.centre().x, part.min.y - 0.5 * canvas.line_height(BUTTON_TEXT));
            widgets::fitted(canvas, head, above, part.size.x, &[BUTTON_TEXT, TEXT], theme::accent());
            let style = Style::new(TEXT, theme::text()).centred().middle();
            for (i, words) in widgets::lines(canvas, foot, part.size.x, style).iter().enumerate() {
                canvas.text(words, Vec2::new(part.centre().x, part.max().y + (0.6 + i as f32) * canvas.line_height(TEXT)), style);
            }
        }
        let (half, round) = self.body;
        let middle = self.parts[0].centre();
        let area = Area::around(middle, 2.0 * half);
        canvas.rounded(area, if round { half.x } else { 3.0 }, theme::solid());
        canvas.rounded_edge(area, if round { half.x } else { 3.0 }, 1.5, theme::solid_top());
        scale::draw(&self.layout.arrows, |_| false, canvas);
        canvas.disc(middle, 3.5, theme::text());
        for tag in &self.layout.tags {
            let near = tag.at.clamp(tag.area.min, tag.area.max());
            if near.distance(tag.at) > TIED {
                canvas.line(near, tag.at, 1.0, theme::quiet());
            }
        }
        for tag in &self.layout.tags {
            canvas.rounded(tag.area, 3.0, theme::ground());
            for (i, words) in tag.lines.iter().enumerate() {
                let colour = if i < tag.names { scale::colour(tag.shown) } else { theme::text() };
                let at = Vec2::new(tag.area.centre().x, tag.area.min.y + (i as f32 + 0.5) * canvas.line_height(TEXT));
                canvas.text(words, at, Style::new(TEXT, colour).centred().middle());
            }
        }
    }
}

fn draw_paper(canvas: &Canvas, part: &Area) {
    let (low, high, middle) = (part.min, part.max(), part.centre());
    for axis in [Vec2::X, Vec2::Y] {
        let (half, across) = ((part.size * 0.5).dot(axis), Vec2::ONE - axis);
        let count = (half / SQUARE).floor() as i32;
        for i in -count..=count {
            let at = axis * (middle + i as f32 * SQUARE);
            canvas.hairline(at + across * low, at + across * high, theme::grid_fine());
        }
    }
    canvas.rectangle_edge(*part, 1.0, theme::grid_heavy());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ForceKind;

    const PARTS: [Area; 2] = [Area::new(0.0, 0.0, 600.0, 500.0), Area::new(608.0, 0.0, 600.0, 500.0)];

    fn force(kind: ForceKind, x: f64, y: f64) -> NamedArrow {
        NamedArrow {
            shown: ArrowKind::Force(kind),
            vector: DVec2::new(x, y),
            name: format!("{kind:?} by it"),
            value: "9 N".to_owned(),
        }
    }

    fn laid(forces: &[NamedArrow]) -> PictureLayout {
        let sum: DVec2 = forces.iter().map(|force| force.vector).sum();
        let sum = NamedArrow { shown: ArrowKind::Resultant, vector: sum, ..force(ForceKind::Push, 0.0, 0.0) };
        let sum = Some(&sum).filter(|sum| sum.vector.length() > 0.1);
        let worth = needed(forces, &PARTS, 24.0);
        lay_out((forces, sum), &PARTS, worth, (24.0, &|words| 9.0 * words.chars().count() as f32))
    }

    #[test]
    fn forces_of_one_direction_stand_side_by_side_and_point_where_they_act() {
        let forces = [
            force(ForceKind::Weight, 0.0, 98.1),
            force(ForceKind::Reaction, 0.0, -98.1),
            force(ForceKind::Push, 100.0, 0.0),
            force(ForceKind::Wind, 40.0, 0.0),
            force(ForceKind::Push, -80.0, 0.0),
        ];
        let laid = laid(&forces);
        for (arrow, force) in laid.arrows.iter().zip(&forces) {
            let way = (arrow.to - arrow.from).as_dvec2();
            assert!(way.perp_dot(force.vector).abs() < 1e-2 * force.vector.length() && way.dot(force.vector) > 0.0);
        }
        assert!((laid.arrows[2].from.y - laid.arrows[3].from.y).abs() >= APART - 0.1);
        // Tip to tail, and the resultant from the first tail to the last tip.
        let [.., third, fourth, last, sum] = &laid.arrows[..] else { panic!("{laid:?}") };
        assert!(third.to.distance(fourth.from) < 1.0 && fourth.to.distance(last.from) < 1.0, "{laid:?}");
        let (first, way) = (&laid.arrows[5], (sum.to - sum.from).normalize());
        assert!((sum.from - first.from).dot(way).abs() < 0.1 && (sum.to - last.to).dot(way).abs() < 0.1, "{laid:?}");
        assert_eq!((laid.arrows.len(), laid.tags.len()), (11, 11));
    }

    #[test]
    fn two_that_cancel_are_drawn_beside_each_other_and_a_small_one_can_be_seen() {
        let laid = laid(&[
            force(ForceKind::Weight, 0.0, 98.1),
            force(ForceKind::AirResistance, 0.0, -98.1),
            force(ForceKind::Wind, 0.2, 0.0),
        ]);
        let [.., wind, up, down, _] = &laid.arrows[..] else { panic!("{laid:?}") };
        assert!((up.from.x - down.from.x).abs() >= APART - 0.1 && wind.length() >= LEAST - 0.1, "{laid:?}");
        for (i, tag) in laid.tags.iter().enumerate() {
            assert!(laid.tags[i + 1..].iter().all(|other| tag.area.gap(&other.area) >= 0.0), "{laid:?}");
        }
    }
}
