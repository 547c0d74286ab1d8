//! Free-body arrows: the forces on each body from its centre, and the impacts that it has just felt, to scale, each kind with a colour, a
//! dash and a head of its own.

use super::boxes::covers_none;
use super::camera::Viewport;
use super::canvas::{Canvas, Style};
pub use super::facts::Shown;
use super::facts::{by_name, impacts};
use super::focus::Focus;
use super::layout::{Area, DETAILS, Vec2};
use super::theme::{self, faded};
use crate::game::{DAMAGING_SPEED, Game, SHIP};
use crate::level::Player;
use crate::physics::{BodyId, DVec2, ForceKind};
use macroquad::color::Color;

/// About how many squares of the graph paper the ship's weight or thrust, whichever is larger, is long.
const LONGEST: f64 = 6.0;
/// N/kg. What the weight of a body is taken for where there is no gravity.
const STANDARD: f64 = 9.81;
/// Arrows shorter than this are a dot and have no label, canvas units.
const SHORTEST: f32 = 5.0;
/// Width of a force's arrow and of the resultant's, canvas units.
const WIDTH: f32 = 2.6;
const RESULTANT_WIDTH: f32 = 6.0;
/// Length of a head, canvas units; half its breadth is the same times [`HEAD_SPREAD`].
const HEAD: f32 = 11.0;
const HEAD_SPREAD: f32 = 0.45;

/// What is at an arrow's tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Head {
    Filled,
    Open,
    Double,
    Diamond,
    Bar,
    Disc,
}

/// An arrow on the canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow {
    /// The body's centre.
    pub from: Vec2,
    /// The tip.
    pub to: Vec2,
    /// What it stands for.
    pub shown: Shown,
}

impl Arrow {
    /// Its name.
    pub fn name(&self) -> &'static str {
        self.shown.name()
    }

    fn length(&self) -> f32 {
        (self.to - self.from).length()
    }

    /// The box around it.
    pub fn area(&self) -> Area {
        let min = self.from.min(self.to) - 4.0;
        Area { min, size: self.from.max(self.to) + 4.0 - min }
    }
}

/// How long arrows are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Newtons a metre of the level, for forces.
    pub newtons: f64,
    /// Newton-seconds a metre of the level, for impacts.
    pub newton_seconds: f64,
}

impl Scale {
    /// Round numbers that suit the level's ship, or whoever is followed: its weight is about as long as what stops it at damaging speed.
    /// Longer or shorter as is asked for.
    pub fn of(game: &Game, focus: &Focus) -> Self {
        let (level, length) = (game.level(), focus.length() * LONGEST);
        let Player { mass, thrust, .. } = level.player;
        let (mass, largest) = match focus.followed() {
            None | Some(SHIP) => (mass, (mass * level.gravity.abs()).max(thrust)),
            Some(id) => {
                let mass = game.world().body(id).mass;
                (mass, mass * if level.gravity == 0.0 { STANDARD } else { level.gravity.abs() })
            }
        };
        Self { newtons: round_up(largest / length), newton_seconds: round_up(mass * DAMAGING_SPEED / length) }
    }
}

/// The colour of what a line or an arrow stands for.
pub const fn colour(shown: Shown) -> Color {
    match shown {
        Shown::Resultant => theme::RESULTANT,
        Shown::Force(kind) => theme::force(kind),
        Shown::Impact => theme::IMPACT,
    }
}

/// The next number from …, 0.1, 0.2, 0.5, 1, 2, 5, 10, …
fn round_up(value: f64) -> f64 {
    let mut decade = 1e-9;
    while decade * 10.0 < value {
        decade *= 10.0;
    }
    [1.0, 2.0, 5.0].into_iter().map(|step| step * decade).find(|step| *step >= value).unwrap_or(10.0 * decade)
}

/// The arrows of a body whose centre is drawn at `centre` (m): the resultant first, then the forces and the impacts that are told, the
/// longest first, so that a shorter one over a longer can be seen.
pub fn arrows(game: &Game, (id, centre): (BodyId, DVec2), scale: &Scale, view: &Viewport) -> Vec<Arrow> {
    let Scale { newtons, newton_seconds } = *scale;
    let forces = game.world().forces(id);
    let arrow = |(shown, reach): (Shown, DVec2)| Arrow { from: view.point(centre), to: view.point(centre + reach), shown };
    let named = by_name(&forces).into_iter().map(|(kind, vector)| (Shown::Force(kind), vector / newtons));
    let felt = impacts(game, id).each.into_iter().map(|(impulse, _)| (Shown::Impact, impulse / newton_seconds));
    let mut reaches: Vec<(Shown, DVec2)> = named.chain(felt).collect();
    reaches.sort_by(|a, b| b.1.length_squared().total_cmp(&a.1.length_squared()));
    let resultant = (Shown::Resultant, forces.resultant() / newtons);
    std::iter::once(resultant).chain(reaches).map(arrow).filter(|arrow| arrow.length() > 0.0).collect()
}

/// Draws arrows, without their labels.
pub fn draw(arrows: &[Arrow], canvas: &Canvas) {
    arrows.iter().for_each(|arrow| draw_arrow(canvas, arrow, 1.0));
}

fn draw_arrow(canvas: &Canvas, arrow: &Arrow, alpha: f32) {
    let resultant = arrow.shown == Shown::Resultant;
    let (width, head_scale) = if resultant { (RESULTANT_WIDTH, 1.6) } else { (WIDTH, 1.0) };
    let ((head, dash), colour) = (style(arrow.shown), faded(colour(arrow.shown), alpha));
    let along = (arrow.to - arrow.from).normalize_or_zero();
    let tip_length = (HEAD * head_scale).min(arrow.length());
    let neck = arrow.to - along * tip_length * 0.8;
    canvas.line(arrow.from, neck, width + 2.0, faded(theme::ground(), 0.55 * alpha));
    if dash.is_empty() {
        canvas.line(arrow.from, neck, width, colour);
    } else {
        dashed(canvas, arrow.from, neck, dash, width, colour);
    }
    draw_head(canvas, head, arrow.to, along, tip_length, width, colour);
}

/// Draws a single arrow from its tail to its tip, for show; `alpha` (0 … 1) is how much of it is seen.
pub fn draw_one(canvas: &Canvas, (from, to): (Vec2, Vec2), shown: Shown, alpha: f32) {
    draw_arrow(canvas, &Arrow { from, to, shown }, alpha);
}

/// How a kind of force is told without its colour: no two of the same head and dash. Dashes are lengths drawn and left out in turn.
fn style(shown: Shown) -> (Head, &'static [f32]) {
    let kind = match shown {
        Shown::Resultant => return (Head::Filled, &[]),
        Shown::Impact => return (Head::Double, &[2.5, 3.0]),
        Shown::Force(kind) => kind,
    };
    match kind {
        ForceKind::Weight => (Head::Filled, &[]),
        ForceKind::Drive => (Head::Double, &[]),
        ForceKind::Reaction => (Head::Open, &[]),
        ForceKind::Friction => (Head::Filled, &[5.0, 4.0]),
        ForceKind::AirResistance => (Head::Open, &[10.0, 5.0]),
        ForceKind::Wind => (Head::Diamond, &[10.0, 5.0]),
        ForceKind::Buoyancy => (Head::Disc, &[]),
        ForceKind::ViscousDrag => (Head::Disc, &[9.0, 4.0, 2.5, 4.0]),
        ForceKind::Push => (Head::Bar, &[]),
    }
}

fn dashed(canvas: &Canvas, from: Vec2, to: Vec2, pattern: &[f32], width: f32, colour: Color) {
    let along = (to - from).normalize_or_zero();
    // What is outside of the window is passed over: an arrow may be a million dashes long.
    let seen = canvas.frame().area().inset(-width);
    let Some((start, length)) = stretch_inside(seen, from, along, (to - from).length()) else { return };
    let period: f32 = pattern.iter().sum();
    let mut at = (start / period).floor() * period;
    for (i, step) in pattern.iter().cycle().enumerate() {
        // Beyond what f32 can count in dashes there are none.
        if at >= length || at + step <= at {
            break;
        }
        let end = (at + step).min(length);
        if i % 2 == 0 {
            canvas.line(from + along * at, from + along * end, width, colour);
        }
        at = end;
    }
}

/// From where to where, seen from its start, a line is inside an area; `None` where it passes it by.
fn stretch_inside(area: Area, from: Vec2, along: Vec2, length: f32) -> Option<(f32, f32)> {
    let (mut enters, mut leaves) = (0.0_f32, length);
    for axis in 0..2 {
        let (low, high) = (area.min[axis] - from[axis], area.max()[axis] - from[axis]);
        if along[axis] == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
            continue;
        }
        let (a, b) = (low / along[axis], high / along[axis]);
        (enters, leaves) = (enters.max(a.min(b)), leaves.min(a.max(b)));
    }
    (enters < leaves).then_some((enters, leaves))
}

fn draw_head(canvas: &Canvas, head: Head, tip: Vec2, along: Vec2, length: f32, width: f32, colour: Color) {
    let side = along.perp() * length * HEAD_SPREAD;
    let triangle = |tip: Vec2| {
        let base = tip - along * length;
        canvas.convex(&[tip, base + side, base - side], colour);
    };
    match head {
        Head::Filled => triangle(tip),
        Head::Double => {
            triangle(tip);
            triangle(tip - along * length * 0.75);
        }
        Head::Open => {
            let base = tip - along * length;
            canvas.line(base, tip, width, colour);
            canvas.line(base + side, tip, width, colour);
            canvas.line(base - side, tip, width, colour);
        }
        Head::Diamond => {
            let middle = tip - along * length * 0.5;
            canvas.convex(&[tip, middle + side, tip - along * length, middle - side], colour);
        }
        Head::Bar => {
            canvas.line(tip - along * length, tip, width, colour);
            canvas.line(tip + side * 1.3, tip - side * 1.3, width * 1.4, colour);
        }
        Head::Disc => {
            canvas.line(tip - along * length, tip - along * length * 0.5, width, colour);
            canvas.disc(tip - along * length * 0.4, length * 0.4, colour);
        }
    }
}

/// A label and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Label {
    /// The index of its arrow.
    pub arrow: usize,
    /// Where it stands.
    pub area: Area,
}

/// Where the arrows' labels stand: beyond the tip, or next to it where that is taken; none over another or over `taken`, all inside
/// the window. `width` gives a label's width. An arrow whose label finds no room has none: its box names it.
pub fn place_labels(arrows: &[Arrow], height: f32, width: impl Fn(&str) -> f32, window: Area, taken: &[Area]) -> Vec<Label> {
    let mut fixed = taken.to_vec();
    let mut labels = Vec::new();
    for (index, arrow) in arrows.iter().enumerate().filter(|(_, arrow)| arrow.length() >= SHORTEST) {
        let size = Vec2::new(width(arrow.name()), height);
        let along = (arrow.to - arrow.from).normalize_or_zero();
        // From the tip to the label's middle so that the label just clears the tip in that direction.
        let beyond = |way: Vec2, gap: f32| arrow.to + way * ((size * 0.5 * way.abs()).element_sum() + gap);
        let places = [
            beyond(along, 4.0),
            beyond(along.perp(), 8.0) - along * 6.0,
            beyond(-along.perp(), 8.0) - along * 6.0,
            beyond(along, 4.0 + height),
            beyond(along.perp(), 8.0) - along * (6.0 + height),
            beyond(-along.perp(), 8.0) - along * (6.0 + height),
            beyond(along, 4.0 + 2.0 * height),
            // For a tip outside of the window or behind a box: beside the shaft.
            beyond(along.perp(), 8.0) - along * (arrow.length() * 0.4),
            beyond(-along.perp(), 8.0) - along * (arrow.length() * 0.4),
            beyond(along.perp(), 8.0) - along * (arrow.length() * 0.65),
            beyond(-along.perp(), 8.0) - along * (arrow.length() * 0.65),
        ];
        let fits = |middle: &Vec2| {
            let area = Area::around(*middle, size);
            area.min.cmpge(window.min).all() && area.max().cmple(window.max()).all() && covers_none(&area, &fixed)
        };
        if let Some(middle) = places.iter().find(|middle| fits(middle)) {
            let area = Area::around(*middle, size);
            fixed.push(area);
            labels.push(Label { arrow: index, area });
        }
    }
    labels
}

/// Draws the labels, on a dark ground so that they can be read over anything.
pub fn draw_labels(arrows: &[Arrow], labels: &[Label], canvas: &Canvas) {
    for label in labels {
        let arrow = &arrows[label.arrow];
        canvas.rounded(label.area.inset(-1.0), 3.0, faded(theme::ground(), 0.85));
        canvas.text(arrow.name(), label.area.centre(), Style::new(DETAILS, colour(arrow.shown)).centred().middle());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_a_round_number() {
        let near = |value: f64, wanted: f64| (round_up(value) / wanted - 1.0).abs() < 1e-9;
        for (value, wanted) in
            [(0.3, 0.5), (0.99, 1.0), (1.1, 2.0), (375.0, 500.0), (499.0, 500.0), (501.0, 1000.0), (750.0, 1000.0)]
        {
            assert!(near(value, wanted), "{value}: {}", round_up(value));
        }
    }

    #[test]
    fn dashes_are_drawn_inside_the_window_only() {
        let window = Area::new(0.0, 0.0, 1000.0, 500.0);
        let stretch = |x: f32, y: f32, along: Vec2, length: f32| stretch_inside(window, Vec2::new(x, y), along, length);
        assert_eq!(stretch(100.0, 100.0, Vec2::X, 50.0), Some((0.0, 50.0)));
        assert_eq!(stretch(100.0, 100.0, Vec2::X, 1e9), Some((0.0, 900.0)));
        assert_eq!(stretch(100.0, 900.0, -Vec2::Y, 1e9), Some((400.0, 900.0)));
        assert_eq!(stretch(-100.0, 100.0, -Vec2::X, 1e9), None);
        assert_eq!(stretch(100.0, 900.0, Vec2::X, 1e9), None);
    }

    #[test]
    fn no_two_kinds_share_head_and_dash() {
        let all: Vec<Shown> = ForceKind::ALL.into_iter().map(Shown::Force).chain([Shown::Impact]).collect();
        for (i, a) in all.iter().enumerate() {
            for b in &all[i + 1..] {
                assert_ne!(style(*a), style(*b), "{a:?} and {b:?}");
            }
        }
    }

    #[test]
    fn labels_keep_apart_and_inside() {
        let window = Area::new(0.0, 0.0, 1280.0, 720.0);
        let arrow = |x: f32, y: f32, shown| Arrow { from: Vec2::new(600.0, 300.0), to: Vec2::new(600.0 + x, 300.0 + y), shown };
        let force = Shown::Force;
        let arrows = [
            arrow(0.0, 90.0, Shown::Resultant),
            arrow(0.0, 90.0, force(ForceKind::Weight)),
            arrow(0.0, 88.0, force(ForceKind::Push)),
            arrow(2.0, -90.0, force(ForceKind::Reaction)),
            arrow(-2.0, -90.0, force(ForceKind::Buoyancy)),
            arrow(0.0, 1.0, force(ForceKind::Wind)),
        ];
        let labels = place_labels(&arrows, 18.0, |name| name.len() as f32 * 7.0, window, &[]);
        assert_eq!(labels.iter().map(|label| label.arrow).collect::<Vec<_>>(), [0, 1, 2, 3, 4], "an arrow too short has none");
        for (i, label) in labels.iter().enumerate() {
            let others: Vec<Area> = labels[i + 1..].iter().map(|other| other.area).collect();
            assert!(covers_none(&label.area, &others));
            assert!(label.area.min.cmpge(Vec2::ZERO).all() && label.area.max().cmple(window.size).all());
        }
    }
}
