//! The readings in the level: trails, arrows, the ruler.

use super::ruler::{End, RulerReading, points};
use super::{Tool, dock, figures::in_focus, measure::Measures, vectors::Vector};
use crate::draw::layout::{Area, DETAILS, GRID, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::number::{QuantityScale, fixed, scalar};
use crate::physics::{BodyId, DVec2, ForceKind};
use crate::view::{camera::Viewport, facts::round_up, game_view::drawn_centre, hud::HudLayout, theme};
use crate::{game::Game, game::SHIP, instruments::track::DOTS_A_SECOND, instruments::track::LASTS, words::tr};

const DOT: f32 = 3.0;
const WHOLE: f32 = 5.0;
/// Width of the arrows, length of their heads, half the heads' breadth, canvas units.
const ARROW: f32 = 4.0;
const HEAD: Vec2 = Vec2::new(14.0, 6.5);
/// Shorter arrows are not drawn, canvas units.
const SHORTEST: f32 = 3.0;
/// Canvas units.
const MARGIN: f32 = 12.0;
/// Arrows are shortened to the next round scale this often before the window's edge cuts them off.
const SHORTENED: usize = 6;
/// Half the length of the ruler's marks at its ends, and at its metres, canvas units.
const END_MARK: f32 = 9.0;
const METRE_MARK: f32 = 4.0;
/// Marks nearer than this are left out, canvas units.
const MARKS_APART: f32 = 6.0;
/// With a unit, y upwards.
pub fn pair(vector: DVec2, unit: &str) -> String {
    let scale = QuantityScale::of(vector.abs().max_element(), unit);
    format!("({}, {}) {}", scale.number(vector.x), scale.number(-vector.y), scale.unit())
}

/// Words on a dark ground, their left end at a point, within the window.
pub fn label(lines: &[String], at: Vec2, colour: Colour, canvas: &Canvas) {
    let style = Style::new(DETAILS, colour).mono();
    let (line, size) = (canvas.line_height(DETAILS), label_size(lines, canvas));
    let most = (canvas.size() - size - MARGIN).max(Vec2::splat(MARGIN));
    let min = (at - Vec2::new(0.0, size.y / 2.0)).clamp(Vec2::splat(MARGIN), most);
    canvas.rounded(Area { min, size }, 4.0, theme::ground().faded(0.85));
    for (i, words) in lines.iter().enumerate() {
        canvas.text(words, min + Vec2::new(0.5 * GRID, 0.25 * GRID + i as f32 * line), style);
    }
}

fn label_size(lines: &[String], canvas: &Canvas) -> Vec2 {
    let style = Style::new(DETAILS, theme::text()).mono();
    let width = lines.iter().map(|words| canvas.width(words, style)).fold(0.0, f32::max);
    Vec2::new(width, canvas.line_height(DETAILS) * lines.len() as f32) + Vec2::new(GRID, 0.5 * GRID)
}

impl Measures {
    pub(super) fn draw_in_level(&self, scene: (&Game, f64), (view, canvas): (&Viewport, &Canvas)) {
        if self.uses(Tool::Trails) {
            self.draw_trails(scene.0, view, canvas);
        }
        if self.uses(Tool::Vectors) {
            self.draw_vectors(scene, view, canvas);
        }
        if self.uses(Tool::Figures) && scene.0.level().gravity != 0.0 {
            self.draw_zero(scene.0, view, canvas);
        }
        if self.uses(Tool::Ruler) {
            self.draw_ruler(scene, view, canvas);
        }
    }

    fn draw_zero(&self, game: &Game, view: &Viewport, canvas: &Canvas) {
        let (y, frame) = (view.point(self.figures.zero(game.level())).y, canvas.frame().area());
        if (frame.min.y..=frame.max().y).contains(&y) {
            let colour = theme::force(ForceKind::Weight);
            canvas.dashed(&[Vec2::new(frame.min.x, y), Vec2::new(frame.max().x, y)], &[10.0, 6.0], 1.5, colour);
            label(&["E_pot = 0".to_owned()], Vec2::new(frame.max().x - 10.0 * GRID, y - 1.2 * GRID), colour, canvas);
        }
    }

    fn draw_trails(&self, game: &Game, view: &Viewport, canvas: &Canvas) {
        let (tick, rate) = (game.ticks(), game.tick_rate());
        let (now, lasts) = (tick as f64 / rate, (LASTS * DOTS_A_SECOND) as f64);
        let seen = canvas.frame().area().inset(-WHOLE);
        for (i, id) in self.trail.who.iter().enumerate() {
            let colour = if *id == SHIP { theme::text() } else { theme::player_objective() };
            // A body at rest has one dot, not fifty on each other.
            let mut before = Some(view.point(game.world().body(*id).position));
            let dots: Vec<_> = self.trail.dots(tick, rate).collect();
            for dots in dots.into_iter().rev() {
                let at = view.point(dots.places[i]);
                if before.is_some_and(|before| before.distance(at) < 1.0) {
                    continue;
                }
                before = Some(at);
                if !seen.contains(at) {
                    continue;
                }
                let age = (now * DOTS_A_SECOND as f64 - dots.number as f64) / lasts;
                let alpha = 1.0 - 0.85 * age as f32;
                let radius = if dots.number % DOTS_A_SECOND == 0 { WHOLE } else { DOT };
                canvas.disc(at, radius + 1.0, theme::ground().faded(0.6 * alpha));
                canvas.disc(at, radius, colour.faded(alpha));
            }
        }
    }

    /// The value of a metre in arrows from the bodies in focus, such that all tips are in the window if possible.
    pub(super) fn fitting(&self, vector: Vector, (game, alpha): (&Game, f64), view: &Viewport, canvas: &Canvas) -> f64 {
        let window = canvas.frame().area().inset(MARGIN);
        let bodies = in_focus(&self.focus, game);
        let mut a_metre = self.scales.a_metre(vector, self.focus.length());
        for _ in 0..SHORTENED {
            let inside = |id: &BodyId| {
                let centre = drawn_centre(game, *id, alpha);
                let [from, to] = [centre, centre + vector.of(game.world(), *id) / a_metre].map(|place| view.point(place));
                !window.contains(from) || window.contains(to)
            };
            if bodies.iter().all(inside) {
                break;
            }
            a_metre = round_up(a_metre * 1.5);
        }
        a_metre
    }

    fn draw_vectors(&self, (game, alpha): (&Game, f64), view: &Viewport, canvas: &Canvas) {
        let window = canvas.frame().area().inset(MARGIN);
        let mut labels = Vec::new();
        for vector in Vector::ALL {
            let a_metre = self.fitting(vector, (game, alpha), view, canvas);
            for id in in_focus(&self.focus, game) {
                let (centre, value) = (drawn_centre(game, id, alpha), vector.of(game.world(), id));
                let from = view.point(centre);
                let to = view.point(centre + value / a_metre);
                if !window.contains(from) || (to - from).length() < SHORTEST {
                    continue;
                }
                let to = to.clamp(window.min, window.max());
                draw_arrow(canvas, (from, to), colour(vector));
                labels.push((from, to, format!("{} {}", vector.sign(), scalar(value.length(), vector.unit())), colour(vector)));
            }
        }
        let mut taken: Vec<Area> =
            self.areas().chain(dock::rail(&self.frame)).chain(HudLayout::shown(canvas.frame(), game)).collect();
        for (from, to, words, colour) in labels {
            let style = Style::new(DETAILS, colour).mono();
            let size = Vec2::new(canvas.width(&words, style) + GRID, canvas.line_height(DETAILS));
            let along = (to - from).normalize_or_zero();
            let beyond = |towards: Vec2, gap: f32| to + towards * ((size * 0.5 * towards.abs()).element_sum() + gap);
            let places = [
                beyond(along, 4.0),
                beyond(along.perp(), 8.0),
                beyond(-along.perp(), 8.0),
                beyond(along, 4.0 + size.y),
                beyond(along.perp(), 8.0) - along * size.y,
                beyond(-along.perp(), 8.0) - along * size.y,
            ];
            let fits = |area: &Area| {
                let apart = |other: &Area| (other.min - area.max()).max(area.min - other.max()).max_element() >= 0.0;
                area.min.cmpge(window.min).all() && area.max().cmple(window.max()).all() && taken.iter().all(apart)
            };
            let areas = places.map(|middle| Area::around(middle, size));
            let area = areas.into_iter().find(fits).unwrap_or(areas[0]);
            label(&[words], Vec2::new(area.min.x, area.centre().y), colour, canvas);
            taken.push(area);
        }
    }

    fn draw_ruler(&self, (game, alpha): (&Game, f64), view: &Viewport, canvas: &Canvas) {
        let (Some(ends), Some(reading)) = (self.ruler.ends(), self.ruler.reading(game.world())) else { return };
        let places = points(ends, game.world(), |body| drawn_centre(game, body, alpha));
        let [from, to] = places.map(|place| view.point(place));
        let along = (to - from).normalize_or_zero();
        let (across, colour) = (along.perp(), theme::accent());
        canvas.line(from, to, 5.0, theme::ground().faded(0.7));
        canvas.line(from, to, 2.0, colour);
        let step = if view.length(1.0) >= MARKS_APART { 1.0 } else { round_up(f64::from(MARKS_APART / view.length(1.0))) };
        // A ruler longer than the window gets no more marks than the window has room for.
        let marks = (reading.length / step).floor().min(f64::from(canvas.size().length() / MARKS_APART)) as usize;
        for i in 1..=marks {
            let at = from + along * view.length(step * i as f64);
            let half = across * METRE_MARK * if i % 10 == 0 { 2.0 } else { 1.0 };
            canvas.line(at - half, at + half, 1.5, colour);
        }
        for (end, at) in ends.into_iter().zip([from, to]) {
            match end {
                End::Place(_) => canvas.line(at - across * END_MARK, at + across * END_MARK, 3.0, colour),
                End::Body(_) => canvas.ring(at, END_MARK, 3.0, colour),
            }
        }
        // Beside the middle of its visible part, on the side that has more room above.
        let area = canvas.frame().area().inset(MARGIN);
        let middle = (from.clamp(area.min, area.max()) + to.clamp(area.min, area.max())) / 2.0;
        let side = if across.y > 0.0 { -across } else { across };
        let lines = reading_lines(&reading, ends.iter().filter(|end| end.is_body()).count());
        let half = 0.5 * label_size(&lines, canvas);
        let beside = middle + side * ((half * side.abs()).element_sum() + GRID);
        label(&lines, beside - Vec2::new(half.x, 0.0), colour, canvas);
    }
}

impl Vector {
    /// In formulas.
    pub const fn sign(self) -> &'static str {
        match self {
            Self::Velocity => "v",
            Self::Acceleration => "a",
        }
    }

    pub const fn unit(self) -> &'static str {
        match self {
            Self::Velocity => "m/s",
            Self::Acceleration => "m/s²",
        }
    }
}

pub(super) const fn colour(vector: Vector) -> Colour {
    match vector {
        Vector::Velocity => theme::VELOCITY,
        Vector::Acceleration => theme::ACCELERATION,
    }
}

/// `bodies` are the ends on bodies, whose point a line names.
fn reading_lines(reading: &RulerReading, bodies: usize) -> Vec<String> {
    let RulerReading { length, parts, angle } = *reading;
    let angle = format!("{}°", fixed(angle, 1));
    let mut lines = vec![
        format!("{}  {angle}", scalar(length, "m")),
        format!("Δx {}", scalar(parts.x, "m")),
        format!("Δy {}", scalar(parts.y, "m")),
    ];
    lines.extend([None, Some(tr("lower edge")), Some(tr("centre to centre"))][bodies.min(2)].map(str::to_owned));
    lines
}

fn draw_arrow(canvas: &Canvas, (from, to): (Vec2, Vec2), colour: Colour) {
    let along = (to - from).normalize_or_zero();
    let head = HEAD * ((to - from).length() / HEAD.x).min(1.0);
    let neck = to - along * head.x;
    canvas.line(from, neck, ARROW + 2.0, theme::ground().faded(0.6));
    canvas.line(from, neck, ARROW, colour);
    canvas.convex(&[to, neck + along.perp() * head.y, neck - along.perp() * head.y], colour);
}
