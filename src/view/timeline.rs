//! Draws a scene over time: the error of every method above, the energy that it has kept below. The same picture as `resultant chart`
//! makes, with one method picked out.

use super::diagram::{dashed, legend_of_curves, shade, stroke};
use super::layout::{Area, DETAILS, TEXT, Vec2};
use super::plot::Plot;
use super::{theme, widgets};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::TOLERANCE;
use crate::lab::axes::{number, power};
use crate::lab::course::{CoursePoint, OverTime};
use crate::lab::look::{Look, TOLERANCE_DASH};
use crate::lab::measured::Measured;
use crate::lab::timeline::{Timeline, energy_name, round_numbers};

/// Of the height, what the error takes where there is an energy, too.
const UPPER: f32 = 0.55;
/// From one plot to the next: the values of the time above, the name of the energy below.
const BETWEEN: f32 = 68.0;
/// Named values of an axis, about.
const NAMED: usize = 7;

/// One of the two plots.
struct Stage<'a> {
    area: Area,
    name: &'a str,
    /// Values with their parts of the way up.
    named: Vec<(f64, String)>,
}

impl Stage<'_> {
    fn at(&self, (right, up): (f64, f64)) -> Vec2 {
        let size = self.area.size;
        Vec2::new(self.area.min.x + size.x * right as f32, self.area.max().y - size.y * up as f32)
    }

    fn level(&self, up: f64) -> [Vec2; 2] {
        [self.at((0.0, up)), self.at((1.0, up))]
    }

    fn axes(&self, canvas: &Canvas, seconds: f64) {
        let quiet = Style::new(DETAILS, theme::quiet()).middle();
        canvas.rounded(self.area, 0.0, theme::ground());
        for (part, name) in &self.named {
            let [from, to] = self.level(*part);
            canvas.hairline(from, to, theme::panel_edge());
            canvas.text(name, from - Vec2::new(10.0, 0.0), quiet.right());
        }
        for time in round_numbers(0.0, seconds, NAMED) {
            let foot = self.at((time / seconds, 0.0));
            canvas.hairline(foot, Vec2::new(foot.x, self.area.min.y), theme::panel_edge());
            canvas.text(&number(time), foot + Vec2::new(0.0, 14.0), quiet.centred());
        }
        canvas.text(self.name, self.area.min - Vec2::new(0.0, 18.0), Style::new(TEXT, theme::text()).middle());
    }
}

/// Draws it in the places of the scene's other diagram; `picked` is one of its curves.
pub fn draw(canvas: &Canvas, plot: &Plot, (measured, over_time): (&Measured, &OverTime), picked: Option<usize>) {
    widgets::panel(canvas, plot.panel);
    legend_of_curves(canvas, plot, measured, picked);
    let axes = Timeline::of(over_time);
    let whole = plot.area;
    let height = if axes.energy.is_some() { (whole.size.y - BETWEEN + 8.0) * UPPER } else { whole.size.y };
    let decades = axes.error;
    let errors = decades.named(NAMED as i32).map(|exponent| (decades.part(10f64.powi(exponent)), power(exponent)));
    let upper =
        Stage { area: Area { min: whole.min, size: Vec2::new(whole.size.x, height) }, name: "error, m", named: errors.collect() };
    upper.axes(canvas, axes.end);
    let [from, to] = upper.level(decades.part(TOLERANCE));
    dashed(canvas, &[from, to], TOLERANCE_DASH, 2.0, theme::good());
    let lower = axes.energy.map(|(least, most)| {
        let named = round_numbers(least, most, NAMED - 2).into_iter();
        let top = upper.area.max().y + BETWEEN;
        let lower = Stage {
            area: Area::new(whole.min.x, top, whole.size.x, whole.max().y + 8.0 - top),
            name: "energy, parts of the right one",
            named: named.map(|energy| ((energy - least) / (most - least), energy_name(energy))).collect(),
        };
        lower.axes(canvas, axes.end);
        lower
    });
    for (index, curve) in measured.curves.iter().enumerate() {
        let Some(course) = over_time.courses.iter().find(|course| course.name == curve.name && course.origin == curve.origin)
        else {
            continue;
        };
        let look = Look { width: 2, ..Look::of(index, curve.origin) };
        let colour = shade(Colour::hex(look.colour), picked.is_none_or(|picked| picked == index));
        let line: Vec<Vec2> = course.points.iter().map(|moment| upper.at(axes.error_at(moment))).collect();
        stroke(canvas, &line, &look, colour);
        if let Some(lower) = &lower {
            let place = |moment: &CoursePoint| axes.energy_at(moment).map(|at| lower.at(at));
            stroke(canvas, &course.points.iter().filter_map(place).collect::<Vec<_>>(), &look, colour);
        }
    }
    let foot = lower.map_or(upper.area, |lower| lower.area);
    let words = format!("time, s (step {})", crate::lab::axes::step(over_time.step));
    canvas.text(&words, Vec2::new(foot.centre().x, foot.max().y + 34.0), Style::new(TEXT, theme::text()).middle().centred());
}
