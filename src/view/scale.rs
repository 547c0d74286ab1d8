//! Free-body arrows: colour, dash and head of each kind of force. Their scale is a round number of newtons a square, for which the longest one fits:
//! it shrinks at once when an arrow no longer fits or the view is zoomed, and grows back after a delay, for an unsteady one could not be compared.

pub use super::facts::ArrowKind;
use super::{facts::round_up, focus::Focus, theme};
use crate::draw::layout::{Area, DETAILS, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{DAMAGING_SPEED, Game, SHIP};
use crate::physics::{BodyId, ForceKind};
use crate::words::tr;

/// Width of a force's arrow and of the resultant's, canvas units.
const WIDTH: f32 = 2.6;
const RESULTANT_WIDTH: f32 = 6.0;
/// Length of a head, canvas units; half its breadth is the same times [`HEAD_SPREAD`].
const HEAD: f32 = 11.0;
/// Half the breadth of a head as a part of its length.
pub const HEAD_SPREAD: f32 = 0.45;
/// Scale of the resultant's head, and distance of the second head of two behind the first as a part of its length.
const RESULTANT_HEAD: f32 = 1.6;
const SECOND_HEAD: f32 = 0.75;
/// The mark of an arrow that is not to scale: half the length of its two strokes, and between them, canvas units.
const BREAK: f32 = 4.5;
const BREAK_GAP: f32 = 3.5;
/// Opacity of an arrow while others are lit.
const DIMMED: f32 = 0.35;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Head {
    Filled,
    Open,
    Double,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow {
    pub body: BodyId,
    /// The line of the body's box that states it.
    pub row: usize,
    pub shown: ArrowKind,
    /// The body's centre, if there is room.
    pub from: Vec2,
    pub to: Vec2,
    /// Whether its length is by the scale; otherwise it bears a mark.
    pub to_scale: bool,
}

impl Arrow {
    pub fn name(&self) -> &'static str {
        self.shown.name()
    }

    pub fn length(&self) -> f32 {
        (self.to - self.from).length()
    }

    pub fn area(&self) -> Area {
        let min = self.from.min(self.to) - 4.0;
        Area { min, size: self.from.max(self.to) + 4.0 - min }
    }

    pub fn distance(&self, point: Vec2) -> f32 {
        let way = self.to - self.from;
        point.distance(self.from + way * ((point - self.from).dot(way) / way.length_squared().max(1.0)).clamp(0.0, 1.0))
    }
}

/// The length of an arrow's whole head along it, and of one of its triangles, canvas units.
pub const fn head_length(shown: ArrowKind) -> Vec2 {
    let one = if matches!(shown, ArrowKind::Resultant) { HEAD * RESULTANT_HEAD } else { HEAD };
    let heads = if matches!(style(shown).0, Head::Double) { 1.0 + SECOND_HEAD } else { 1.0 };
    Vec2::new(one * heads, one)
}

pub const fn colour(shown: ArrowKind) -> Colour {
    match shown {
        ArrowKind::Resultant => theme::RESULTANT,
        ArrowKind::Force(kind) => theme::force(kind),
        ArrowKind::Impact => theme::IMPACT,
    }
}

/// The opacity of an arrow: full where none is lit.
pub fn seen(lit: bool, any: bool) -> f32 {
    if lit || !any { 1.0 } else { DIMMED }
}

/// Draws arrows, without their labels; `lit` picks arrows out.
pub fn draw(arrows: &[Arrow], lit: impl Fn(&Arrow) -> bool, canvas: &Canvas) {
    let any = arrows.iter().any(&lit);
    for arrow in arrows {
        let lit = lit(arrow);
        if lit {
            canvas.line(arrow.from, arrow.to, 3.5 * WIDTH, colour(arrow.shown).faded(0.35));
        }
        draw_arrow(canvas, arrow, seen(lit, any));
        if !arrow.to_scale {
            draw_break(canvas, arrow, seen(lit, any));
        }
    }
}

/// Two strokes across the shaft of an arrow that is not to scale.
fn draw_break(canvas: &Canvas, arrow: &Arrow, alpha: f32) {
    let along = (arrow.to - arrow.from).normalize_or_zero();
    let shaft = (arrow.length() - head_length(arrow.shown).x).max(0.0);
    let middle = arrow.from + along * (shaft - BREAK).max(shaft * 0.5);
    let stroke = (along.perp() + along * 0.6) * BREAK;
    let half = if arrow.shown == ArrowKind::Resultant { 1.5 } else { 1.0 };
    canvas.line(middle - along * BREAK_GAP * 0.5, middle + along * BREAK_GAP * 0.5, RESULTANT_WIDTH + 2.0, theme::ground());
    for side in [-0.5, 0.5] {
        let at = middle + along * (BREAK_GAP * side);
        canvas.line(at - stroke * half, at + stroke * half, 1.6, colour(arrow.shown).faded(alpha));
    }
}

fn draw_arrow(canvas: &Canvas, arrow: &Arrow, alpha: f32) {
    let width = if arrow.shown == ArrowKind::Resultant { RESULTANT_WIDTH } else { WIDTH };
    let ((head, dash), colour) = (style(arrow.shown), colour(arrow.shown).faded(alpha));
    let along = (arrow.to - arrow.from).normalize_or_zero();
    let tip_length = head_length(arrow.shown).y.min(arrow.length());
    let neck = arrow.to - along * tip_length * 0.8;
    canvas.line(arrow.from, neck, width + 2.0, theme::ground().faded(0.55 * alpha));
    canvas.dashed(&[arrow.from, neck], dash, width, colour);
    draw_head(canvas, head, arrow.to, along, tip_length, width, colour);
}

/// A single arrow from tail to tip; `alpha` (0 … 1) is its opacity.
pub fn draw_one(canvas: &Canvas, (from, to): (Vec2, Vec2), shown: ArrowKind, alpha: f32) {
    draw_arrow(canvas, &Arrow { body: SHIP, row: 0, shown, from, to, to_scale: true }, alpha);
}

/// Tells kinds of force apart without colour: no two share head and dash. Dashes are lengths drawn and left out in turn.
const fn style(shown: ArrowKind) -> (Head, &'static [f32]) {
    let kind = match shown {
        ArrowKind::Resultant => return (Head::Filled, &[]),
        ArrowKind::Impact => return (Head::Double, &[2.5, 3.0]),
        ArrowKind::Force(kind) => kind,
    };
    match kind {
        ForceKind::Weight => (Head::Filled, &[]),
        ForceKind::Drive => (Head::Double, &[]),
        ForceKind::Reaction => (Head::Open, &[]),
        ForceKind::Friction => (Head::Filled, &[5.0, 4.0]),
        ForceKind::AirResistance => (Head::Open, &[10.0, 5.0]),
        ForceKind::Wind => (Head::Double, &[10.0, 5.0]),
        ForceKind::Buoyancy => (Head::Double, &[5.0, 4.0]),
        ForceKind::ViscousDrag => (Head::Open, &[9.0, 4.0, 2.5, 4.0]),
        ForceKind::Push => (Head::Filled, &[10.0, 5.0]),
        ForceKind::Spring => (Head::Filled, &[9.0, 4.0, 2.5, 4.0]),
        ForceKind::Tension => (Head::Open, &[5.0, 4.0]),
        ForceKind::Magnetic => (Head::Double, &[9.0, 4.0, 2.5, 4.0]),
    }
}

fn draw_head(canvas: &Canvas, head: Head, tip: Vec2, along: Vec2, length: f32, width: f32, colour: Colour) {
    let side = along.perp() * length * HEAD_SPREAD;
    let triangle = |tip: Vec2| {
        let base = tip - along * length;
        canvas.convex(&[tip, base + side, base - side], colour);
    };
    match head {
        Head::Filled => triangle(tip),
        Head::Double => {
            triangle(tip);
            triangle(tip - along * length * SECOND_HEAD);
        }
        Head::Open => {
            let base = tip - along * length;
            canvas.line(base, tip, width, colour);
            canvas.line(base + side, tip, width, colour);
            canvas.line(base - side, tip, width, colour);
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Label {
    pub arrow: usize,
    pub area: Area,
}

/// The labels, on a dark ground so that they can be read over anything; `lit` as for the arrows.
pub fn draw_labels(arrows: &[Arrow], labels: &[Label], lit: impl Fn(&Arrow) -> bool, canvas: &Canvas) {
    let any = arrows.iter().any(&lit);
    for label in labels {
        let arrow = &arrows[label.arrow];
        let seen = seen(lit(arrow), any);
        canvas.rounded(label.area, 3.0, theme::ground().faded(0.85 * seen));
        canvas.text(tr(arrow.name()), label.area.centre(), Style::new(DETAILS, colour(arrow.shown).faded(seen)).centred().middle());
    }
}

/// The length of a body's usual force, canvas units: its weight, half of the ship's thrust, or the force that stops a damaging speed.
const USUAL: f64 = 225.0;
/// The least of that length where other bodies feel far more than the ship, canvas units: their arrows are cut then.
const USUAL_LEAST: f64 = 60.0;
/// An arrow with less room in the window, as in its corner, is cut instead of shortening all of them, canvas units.
const LEAST_ROOM: f32 = 120.0;
/// N/kg: gravity of the usual weight where a level has none.
const STANDARD: f64 = 9.81;
/// A zoom by this factor changes the scale at once.
const ZOOMED: f64 = 1.25;
/// Longer arrows must fit for this long before they are drawn longer, s of the game.
const PATIENCE: f64 = 2.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArrowScale {
    /// Newtons a metre of the level, for forces.
    pub newtons: f64,
    /// Newton-seconds a metre of the level, for impacts.
    pub newton_seconds: f64,
}

/// A force or an impulse (N, N·s) and the room of its arrow, canvas units.
pub type Reach = (f64, f32);

#[derive(Clone, Debug, Default)]
pub struct Steady {
    newtons: ScaleStep,
    newton_seconds: ScaleStep,
    /// The focus, and the canvas units a metre, at which the scale began.
    asked: Option<(Focus, f64)>,
}

impl Steady {
    /// The scale of this frame, at `metre` canvas units a metre, for the shown bodies and their forces and impulses.
    pub fn update(
        &mut self,
        game: &Game,
        (focus, shown): (&Focus, &[BodyId]),
        metre: f64,
        [forces, impulses]: [&[Reach]; 2],
    ) -> ArrowScale {
        // A new focus or zoom takes effect at once.
        if !self.asked.is_some_and(|(asked, at): (Focus, f64)| asked == *focus && (at / ZOOMED..=at * ZOOMED).contains(&metre)) {
            *self = Self { asked: Some((*focus, metre)), ..Self::default() };
        }
        let patience = (PATIENCE * game.tick_rate()) as u64;
        let wanted = |usual: f64, reaches: &[Reach]| {
            let needed = reaches.iter().map(|(size, room)| size / f64::from(room.max(LEAST_ROOM))).fold(0.0, f64::max);
            let most = if focus.followed.is_some() { f64::INFINITY } else { usual / USUAL_LEAST };
            (usual / USUAL).max(needed.min(most)) * metre / focus.length()
        };
        let [force, impulse] = usual(game, focus, shown);
        ArrowScale {
            newtons: self.newtons.update(wanted(force, forces), game.ticks(), patience),
            newton_seconds: self.newton_seconds.update(wanted(impulse, impulses), game.ticks(), patience),
        }
    }
}

/// The usual force and impulse, N and N·s: of the followed bodies, else of a ship in view, else of all; of a weightless body the present force.
fn usual(game: &Game, focus: &Focus, shown: &[BodyId]) -> [f64; 2] {
    let level = game.level();
    let gravity = if level.gravity == 0.0 { STANDARD } else { level.gravity.abs() };
    let one = |id: &BodyId| {
        let body = game.world().body(*id);
        let mass = body.mass;
        let largest = || game.world().forces(*id).forces().iter().map(|force| force.vector.length()).fold(0.0, f64::max);
        let force = match *id {
            SHIP => (mass * level.gravity.abs()).max(0.5 * level.player.thrust),
            _ if body.weightless && largest() > 0.0 => largest(),
            _ => mass * gravity,
        };
        [force, mass * DAMAGING_SPEED]
    };
    let picked: Vec<BodyId> = focus.followed.into_iter().chain(focus.compared).filter(|id| shown.contains(id)).collect();
    let whose = if !picked.is_empty() {
        &picked
    } else if shown.contains(&SHIP) {
        &[SHIP][..]
    } else {
        shown
    };
    let [force, impulse] = whose.iter().map(one).fold([0.0_f64; 2], |most, one| [most[0].max(one[0]), most[1].max(one[1])]);
    // No body is shown: any scale will do.
    if whose.is_empty() { [1.0; 2] } else { [force, impulse] }
}

#[derive(Clone, Debug, Default)]
pub(super) struct ScaleStep {
    now: Option<f64>,
    /// The tick since which a smaller value would do, and the largest wish since.
    loose: Option<(u64, f64)>,
}

impl ScaleStep {
    pub(super) fn update(&mut self, wanted: f64, tick: u64, patience: u64) -> f64 {
        let fitting = round_up(wanted);
        let now = match self.now {
            Some(now) if fitting < now => {
                let (since, largest) = self.loose.filter(|(since, _)| *since <= tick).unwrap_or((tick, fitting));
                let largest = largest.max(fitting);
                let over = tick - since >= patience;
                self.loose = (!over).then_some((since, largest));
                if over { largest } else { now }
            }
            _ => {
                self.loose = None;
                fitting
            }
        };
        self.now = Some(now);
        now
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_kinds_share_head_and_dash() {
        let all: Vec<ArrowKind> = ForceKind::ALL.into_iter().map(ArrowKind::Force).chain([ArrowKind::Impact]).collect();
        for (i, a) in all.iter().enumerate() {
            for b in &all[i + 1..] {
                assert_ne!(style(*a), style(*b), "{a:?} and {b:?}");
            }
        }
    }

    #[test]
    fn a_point_is_as_far_from_an_arrow_as_from_its_nearest_point() {
        let (from, to) = (Vec2::new(10.0, 10.0), Vec2::new(110.0, 10.0));
        let arrow = Arrow { body: SHIP, row: 0, shown: ArrowKind::Resultant, from, to, to_scale: true };
        for (x, y, far) in [(50.0, 10.0, 0.0), (50.0, 17.0, 7.0), (113.0, 14.0, 5.0), (7.0, 6.0, 5.0)] {
            assert_eq!(arrow.distance(Vec2::new(x, y)), far);
        }
    }

    #[test]
    fn arrows_grow_shorter_at_once_and_longer_after_a_while() {
        let mut step = ScaleStep::default();
        assert_eq!(step.update(90.0, 0, 10), 100.0);
        assert_eq!(step.update(101.0, 1, 10), 200.0, "what no longer fits is drawn shorter at once");
        for tick in 2..12 {
            // The maximum of the wishes counts, not the last one.
            assert_eq!(step.update(if tick == 5 { 45.0 } else { 3.0 }, tick, 10), 200.0, "tick {tick}");
        }
        assert_eq!(step.update(3.0, 12, 10), 50.0);
        assert_eq!(step.update(3.0, 13, 10), 50.0);
        // A jump back in time restarts the delay.
        assert_eq!(step.update(3.0, 4, 10), 50.0);
        assert_eq!(step.update(3.0, 13, 10), 50.0);
        assert_eq!(step.update(3.0, 14, 10), 5.0);
    }
}
