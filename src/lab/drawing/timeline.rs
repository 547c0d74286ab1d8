//! A scene over time: the error of every method above in decades, the kept energy below in parts of the right one; one method is picked out.
//! A moment lies at parts of the axes, 0 … 1, so that paper and screen draw the same.

use super::{legend::legend_of_curves, legend::legend_of_tolerance, looks::look_of, looks::shade, places::DiagramPlaces};
use crate::draw::chart::{CurveLook, Decades, LEAST_ERROR, TOLERANCE_DASH, dashed, marker, round_numbers, stroke};
use crate::draw::layout::{Area, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::curve::{CoursePoint, Measured, MethodCurve, OverTime};
use crate::number::{power, short, step};
use crate::{lab::TOLERANCE, view::lanes::LaneAxes, view::theme, view::widgets, words::tr};

/// The error's share of the height, where there is an energy, too.
const UPPER: f32 = 0.55;
/// Between the plots: the values of the time above, the name of the energy below.
const BETWEEN: f32 = 68.0;
/// About how many values of an axis have numbers.
const NAMED: usize = 7;

/// Markers of each curve, about; those of neighbours in the legend lie apart.
const MARKERS: usize = 4;

/// The part of a scene's curves that were followed over time.
pub fn followed(measured: &Measured, over_time: &OverTime) -> Measured {
    let is_followed = |curve: &&MethodCurve| course_of(over_time, curve).is_some();
    Measured { curves: measured.curves.iter().filter(is_followed).cloned().collect(), over_time: None, ..measured.clone() }
}

fn course_of<'o>(over_time: &'o OverTime, curve: &MethodCurve) -> Option<&'o MethodCurve<CoursePoint>> {
    over_time.courses.iter().find(|course| course.name == curve.name && course.origin == curve.origin)
}

/// In the places of the scene's other diagram; `measured` has the curves that were [`followed`], `picked` is one of them.
pub fn draw(canvas: &Canvas, plot: &DiagramPlaces, (measured, over_time): (&Measured, &OverTime), picked: Option<usize>) {
    widgets::panel(canvas, plot.panel);
    legend_of_curves(canvas, plot, measured, picked);
    legend_of_tolerance(canvas, plot, measured, tr("a tenth of a pixel, 1/300 m"));
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
        let Some(course) = course_of(over_time, curve) else { continue };
        let look = CurveLook { width: 2, ..look_of(&curve.name, curve.origin, index) };
        let colour = shade(Colour::hex(look.colour), picked.is_none_or(|picked| picked == index));
        let apart = course.points.len().div_ceil(MARKERS).max(1);
        let first = (index * apart / measured.curves.len().max(1)).max(1);
        let curve = |line: Vec<Vec2>| {
            stroke(canvas, &line, &look, colour);
            line.iter().skip(first).step_by(apart).for_each(|at| marker(canvas, *at, look.marker, colour));
        };
        curve(course.points.iter().map(|moment| upper.area.part(axes.error_at(moment))).collect());
        if let Some(lower) = &lower {
            let place = |moment: &CoursePoint| axes.energy_at(moment).map(|at| lower.area.part(at));
            curve(course.points.iter().filter_map(place).collect());
        }
    }
    let foot = lower.map_or(upper.area, |lower| lower.area);
    let words = tr!("time, s (step {step})", step = step(over_time.step));
    canvas.text(
        &words,
        Vec2::new(foot.centre().x, foot.max().y + 14.0 + canvas.frame().text_height(DETAILS).max(20.0)),
        Style::new(TEXT, theme::text()).middle().centred(),
    );
}

/// The range of energies on the axis, in parts of the exact one. A method beyond it has gained or lost all there is.
const ENERGIES: (f64, f64) = (0.0, 2.0);
/// The least that the axis of the energy spans, in parts of 1: a steady energy looks steady.
const LEAST_SPAN: f64 = 0.01;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timeline {
    pub end: f64,
    pub error: Decades,
    /// Range of the energies, where any is known.
    pub energy: Option<(f64, f64)>,
}

impl Timeline {
    /// Around all points and the tolerance.
    pub fn of(over_time: &OverTime) -> Self {
        let moments = || over_time.courses.iter().flat_map(|course| &course.points);
        let errors = moments().map(|moment| moment.error).filter(|error| error.is_finite()).map(shown);
        let end = moments().map(|moment| moment.time).fold(0.0, f64::max);
        let energies = moments().filter_map(|moment| moment.energy).filter(|energy| energy.is_finite());
        let span = |(least, most): (f64, f64), energy: f64| {
            let seen = energy.clamp(ENERGIES.0, ENERGIES.1);
            (least.min(seen), most.max(seen))
        };
        let energy = over_time.has_energy().then(|| energies.fold((1.0 - LEAST_SPAN, 1.0 + LEAST_SPAN), span));
        Self { end: if end > 0.0 { end } else { 1.0 }, error: Decades::around(errors.chain([TOLERANCE])), energy }
    }

    /// Parts of the axes to the right and upwards, 0 … 1; a run that blew up lies at the upper edge.
    pub fn error_at(&self, moment: &CoursePoint) -> (f64, f64) {
        let up = if moment.error.is_finite() { self.error.part(shown(moment.error)) } else { 1.0 };
        (moment.time / self.end, up)
    }

    /// The same of an energy, where it is known; clamped at the edges.
    pub fn energy_at(&self, moment: &CoursePoint) -> Option<(f64, f64)> {
        let (least, most) = self.energy?;
        let energy = moment.energy?;
        let part = ((energy - least) / (most - least)).clamp(0.0, 1.0);
        Some((moment.time / self.end, if part.is_nan() { 1.0 } else { part }))
    }
}

/// An energy as a label: the largest stands for all beyond it.
pub fn energy_name(energy: f64) -> String {
    if energy >= ENERGIES.1 { format!("≥ {}", short(ENERGIES.1)) } else { short(energy) }
}

/// An error clamped to the axis: rounding at the lower edge, blown-up runs at the upper one.
fn shown(error: f64) -> f64 {
    error.clamp(LEAST_ERROR, 1e4)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::chart::CurveOrigin;

    #[test]
    fn moments_lie_between_the_axes_whatever_they_are() {
        let moment = |time, error, energy| CoursePoint { time, error, energy };
        let moments = vec![
            moment(1.0, 0.0, Some(1.0)),
            moment(2.0, 0.1, Some(1.5)),
            moment(3.0, f64::INFINITY, Some(1e300)),
            moment(4.0, f64::NAN, Some(f64::NAN)),
        ];
        let over_time = OverTime {
            step: 0.1,
            courses: vec![MethodCurve { name: "a".into(), origin: CurveOrigin::Lab, version: String::new(), points: moments }],
        };
        let axes = Timeline::of(&over_time);
        assert_eq!((axes.end, axes.energy), (4.0, Some((0.99, 2.0))));
        let at: Vec<_> = over_time.courses[0].points.iter().map(|m| (axes.error_at(m), axes.energy_at(m).unwrap())).collect();
        assert_eq!(at[0].0, (0.25, 0.0));
        assert_eq!((at[2].0.1, at[3].0.1, at[2].1.1, at[3].1.1), (1.0, 1.0, 1.0, 1.0));
        assert!((at[1].1.1 - 0.51 / 1.01).abs() < 1e-12);
    }
}
