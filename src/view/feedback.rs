//! Feedback on events: the screen's shake and red edges after a damaging hit, the flash of a death, floating words for lost points
//! and praise, the ring of a met objective.

use super::{camera::Viewport, theme};
use crate::draw::layout::{Area, BUTTON_TEXT, LINE, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::physics::DVec2;

/// Duration of the shake after a damaging hit, s.
const SHAKE_TIME: f64 = 0.2;
/// Amplitude, canvas units.
const SHAKE_REACH: f64 = 6.0;
/// Duration of the red edges, s.
const FLASH_TIME: f64 = 0.35;
/// Duration of the flash, s.
const DEATH_FLASH: f64 = 0.14;
/// Duration (s) and speed (m/s) of floating words.
const FLOAT_TIME: f64 = 1.4;
const FLOAT_SPEED: f64 = 1.3;
/// Words nearer than that, canvas units, stand above each other.
const FLOAT_WIDTH: f32 = 320.0;
/// The least distance of floating words from the top of the screen, and their distance beside the hit under a roof, canvas units.
const TOP: f32 = 112.0;
const FLOAT_ASIDE: f32 = 80.0;
/// Duration (s) and radius (m) of a spreading ring.
const RING_TIME: f64 = 0.7;
const RING_REACH: f64 = 4.0;
/// Duration of a light's run along a wire, s, and its length as a part of the wire.
const RUN_TIME: f64 = 0.55;
const RUN_LENGTH: f64 = 0.3;

#[derive(Default)]
pub struct Feedback {
    hit: Option<f64>,
    death: Option<f64>,
    floats: Vec<(Float, f64)>,
    rings: Vec<((DVec2, Colour), f64)>,
    /// The corners of a wire, m.
    runs: Vec<([DVec2; 3], f64)>,
}

/// Words that float up from a point (m).
struct Float {
    point: DVec2,
    words: String,
    colour: Colour,
}

/// Effects that last for a time, s.
fn age<T>(effects: &mut Vec<(T, f64)>, frame_time: f64, lasts: f64) {
    effects.iter_mut().for_each(|(_, age)| *age += frame_time);
    effects.retain(|(_, age)| *age < lasts);
}

impl Feedback {
    /// A damaging hit at a point (m).
    pub fn hit(&mut self, point: DVec2) {
        self.hit = Some(0.0);
        self.float(point, "−500".into(), theme::bad());
    }

    pub fn death(&mut self) {
        self.hit = Some(0.0);
        self.death = Some(0.0);
    }

    /// `point` in m.
    pub fn float(&mut self, point: DVec2, words: String, colour: Colour) {
        self.floats.push((Float { point, words, colour }, 0.0));
    }

    /// `centre` in m.
    pub fn ring(&mut self, centre: DVec2, colour: Colour) {
        self.rings.push(((centre, colour), 0.0));
    }

    /// Light runs along the wire from a switch to the thing that it works, m.
    pub fn run(&mut self, from: DVec2, to: DVec2) {
        self.runs.push(([from, DVec2::new(to.x, from.y), to], 0.0));
    }

    pub fn advance(&mut self, frame_time: f64) {
        self.hit = self.hit.map(|age| age + frame_time).filter(|age| *age < SHAKE_TIME.max(FLASH_TIME));
        self.death = self.death.map(|age| age + frame_time).filter(|age| *age < DEATH_FLASH);
        age(&mut self.floats, frame_time, FLOAT_TIME);
        age(&mut self.rings, frame_time, RING_TIME);
        age(&mut self.runs, frame_time, RUN_TIME);
    }

    /// The shake of the screen, canvas units: at most 6 along each axis, none after 200 ms.
    pub fn shake(&self) -> DVec2 {
        self.hit.map_or(DVec2::ZERO, |age| {
            DVec2::new((age * 95.0).cos(), (age * 127.0).cos()) * (SHAKE_REACH * (1.0 - age / SHAKE_TIME).max(0.0))
        })
    }

    /// The rings and the floating words, in the level.
    pub fn draw_in_level(&self, view: &Viewport, canvas: &Canvas) {
        for ((centre, colour), age) in &self.rings {
            let t = age / RING_TIME;
            let spread = 1.0 - (1.0 - t).powi(3);
            canvas.ring(view.point(*centre), view.length(0.5 + RING_REACH * spread), 4.0, colour.faded(1.0 - t as f32));
        }
        for (wire, age) in &self.runs {
            draw_run(wire, age / RUN_TIME, view, canvas);
        }
        let line = canvas.frame().text_height(BUTTON_TEXT) * LINE;
        let mut newer: Option<Vec2> = None;
        for (Float { point, words, colour }, age) in self.floats.iter().rev() {
            let t = (age / FLOAT_TIME) as f32;
            let at = view.point(*point - DVec2::new(0.0, 1.2 + FLOAT_SPEED * age));
            // After a hit at the edge of the screen the words stay on it; under a roof they float beside the ship.
            let beside = if at.y < TOP { FLOAT_ASIDE * (canvas.size().x / 2.0 - at.x).signum() } else { 0.0 };
            let low = Vec2::new(48.0, TOP);
            let mut at = (at + Vec2::new(beside, 0.0)).clamp(low, (canvas.size() - low).max(low));
            if let Some(newer) = newer.filter(|newer| (newer.x - at.x).abs() < FLOAT_WIDTH) {
                at.y = at.y.min(newer.y - line);
            }
            newer = Some(at);
            canvas.text(words, at, Style::new(BUTTON_TEXT, colour.faded((2.0 - 2.0 * t).min(1.0))).mono().centred().middle());
        }
    }

    pub fn draw_flash(&self, canvas: &Canvas) {
        const BANDS: usize = 12;
        if let Some(age) = self.death {
            canvas.rectangle(canvas.frame().area(), theme::text().faded(0.7 * (1.0 - age / DEATH_FLASH) as f32));
        }
        let Some(age) = self.hit else { return };
        let left = (1.0 - age / FLASH_TIME).max(0.0) as f32;
        let (size, step) = (canvas.size(), 7.0);
        for band in 0..BANDS {
            let (inset, fall) = (band as f32 * step, 1.0 - band as f32 / BANDS as f32);
            let colour = theme::bad().faded(0.6 * left * fall * fall);
            let (w, h) = (size.x - 2.0 * inset, size.y - 2.0 * inset - 2.0 * step);
            canvas.rectangle(Area::new(inset, inset, w, step), colour);
            canvas.rectangle(Area::new(inset, size.y - inset - step, w, step), colour);
            canvas.rectangle(Area::new(inset, inset + step, step, h), colour);
            canvas.rectangle(Area::new(size.x - inset - step, inset + step, step, h), colour);
        }
    }
}

/// The wire, which fades, and the light on it at a part (0 … 1) of its run.
fn draw_run(wire: &[DVec2; 3], part: f64, view: &Viewport, canvas: &Canvas) {
    let lengths = [wire[0].distance(wire[1]), wire[1].distance(wire[2])];
    let all = lengths[0] + lengths[1];
    let at = |along: f64| match along.clamp(0.0, all) {
        along if along < lengths[0] => wire[0].lerp(wire[1], along / lengths[0]),
        along if lengths[1] > 0.0 => wire[1].lerp(wire[2], (along - lengths[0]) / lengths[1]),
        _ => wire[1],
    };
    let line = |from: f64, to: f64, width: f32, colour: Colour| {
        // The corner belongs to a stretch around it.
        let corner = (from < lengths[0] && lengths[0] < to).then_some(wire[1]);
        let points: Vec<Vec2> = [Some(at(from)), corner, Some(at(to))].into_iter().flatten().map(|at| view.point(at)).collect();
        points.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], width, colour));
    };
    let head = part * (1.0 + RUN_LENGTH) * all;
    line(0.0, all, 2.0, theme::good().faded(0.35 * (1.0 - part) as f32));
    line(head - RUN_LENGTH * all, head, 5.0, theme::good());
    if head < all {
        canvas.disc(view.point(at(head)), 6.0, theme::text());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hit_shakes_by_at_most_six_units_for_200_ms() {
        let mut feedback = Feedback::default();
        assert_eq!(feedback.shake(), DVec2::ZERO);
        feedback.hit(DVec2::ZERO);
        let mut felt: f64 = 0.0;
        for _ in 0..20 {
            let reach = feedback.shake().abs().max_element();
            assert!(reach <= 6.0);
            felt = felt.max(reach);
            feedback.advance(0.01);
        }
        assert!(felt > 3.0);
        feedback.advance(0.001);
        assert_eq!(feedback.shake().abs().max_element(), 0.0);
    }

    #[test]
    fn what_is_shown_ends() {
        let mut feedback = Feedback::default();
        feedback.hit(DVec2::ZERO);
        feedback.ring(DVec2::ZERO, theme::good());
        feedback.run(DVec2::ZERO, DVec2::ONE);
        for _ in 0..30 {
            feedback.advance(0.1);
        }
        assert!(feedback.hit.is_none() && feedback.floats.is_empty() && feedback.rings.is_empty());
        assert!(feedback.runs.is_empty());
    }
}
