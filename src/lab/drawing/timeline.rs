//! A scene over time: the error of every method above, the kept energy below. The picture of `resultant chart`, with one method
//! picked out.

use super::diagram::{DiagramPlaces, legend_of_curves, shade};
use super::look_of;
use crate::draw::chart::look::{CurveLook, TOLERANCE_DASH, dashed, stroke};
use crate::draw::chart::round_numbers;
use crate::draw::layout::{Area, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::TOLERANCE;
use crate::lab::curve::{CoursePoint, Measured, OverTime};
use crate::lab::timeline::{Timeline, energy_name};
use crate::number::{power, short, step};
use crate::view::lanes::LaneAxes;
use crate::view::{theme, widgets};
use crate::words::tr;

/// The error's share of the height, where there is an energy, too.
const UPPER: f32 = 0.55;
/// Between the plots: the values of the time above, the name of the energy below.
const BETWEEN: f32 = 68.0;
/// About how many values of an axis have numbers.
const NAMED: usize = 7;

/// In the places of the scene's other diagram; `picked` is one of its curves.
pub fn draw(canvas: &Canvas, plot: &DiagramPlaces, (measured, over_time): (&Measured, &OverTime), picked: Option<usize>) {
    widgets::panel(canvas, plot.panel);
    legend_of_curves(canvas, plot, measured, picked);
    let axes = Timeline::of(over_time);
    let whole = plot.area;
    let height = if axes.energy.is_some() { (whole.size.y - BETWEEN + 8.0) * UPPER } else { whole.size.y };
    let decades = axes.error;
    let errors = decades.named(NAMED as i32).map(|exponent| (decades.part(10f64.powi(exponent)), power(exponent)));
    let errors: Vec<_> = errors.collect();
    let times: Vec<_> = round_numbers(0.0, axes.end, NAMED).into_iter().map(|time| (time / axes.end, short(time))).collect();
    let area = Area { min: whole.min, size: Vec2::new(whole.size.x, height) };
    let upper = LaneAxes { area, name: "error, m", named: &errors };
    upper.draw(canvas, &times);
    let [from, to] = upper.level(decades.part(TOLERANCE));
    dashed(canvas, &[from, to], TOLERANCE_DASH, 2.0, theme::good());
    let (least, most) = axes.energy.unwrap_or_default();
    let energies = round_numbers(least, most, NAMED - 2).into_iter();
    let energies: Vec<_> = energies.map(|energy| ((energy - least) / (most - least), energy_name(energy))).collect();
    let lower = axes.energy.map(|_| {
        let top = upper.area.max().y + BETWEEN;
        let area = Area::new(whole.min.x, top, whole.size.x, whole.max().y + 8.0 - top);
        let lower = LaneAxes { area, name: "energy, parts of the right one", named: &energies };
        lower.draw(canvas, &times);
        lower
    });
    for (index, curve) in measured.curves.iter().enumerate() {
        let Some(course) = over_time.courses.iter().find(|course| course.name == curve.name && course.origin == curve.origin)
        else {
            continue;
        };
        let look = CurveLook { width: 2, ..look_of(&curve.name, curve.origin, index) };
        let colour = shade(Colour::hex(look.colour), picked.is_none_or(|picked| picked == index));
        let line: Vec<Vec2> = course.points.iter().map(|moment| upper.area.part(axes.error_at(moment))).collect();
        stroke(canvas, &line, &look, colour);
        if let Some(lower) = &lower {
            let place = |moment: &CoursePoint| axes.energy_at(moment).map(|at| lower.area.part(at));
            stroke(canvas, &course.points.iter().filter_map(place).collect::<Vec<_>>(), &look, colour);
        }
    }
    let foot = lower.map_or(upper.area, |lower| lower.area);
    let words = tr!("time, s (step {step})", step = step(over_time.step));
    canvas.text(&words, Vec2::new(foot.centre().x, foot.max().y + 34.0), Style::new(TEXT, theme::text()).middle().centred());
}
