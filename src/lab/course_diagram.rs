//! A scene over time as SVG: the error of every method above, and the energy that it has kept below where that is known.

use super::axes::{number, power, step};
use super::course::{Course, Moment};
use super::curve::{Curve, Measured};
use super::diagram::{Area, Drawn, GRID, GROUND, HEAVY_GRID, LEGEND, LINE, QUIET, SIZE, rgb, sample, stroke};
use super::look::{GOOD, Look, TEXT, TOLERANCE_DASH};
use super::timeline::{Timeline, energy_name, round_numbers};
use plotters::prelude::*;
use std::error::Error;

/// Named values of the time, and of an energy.
const NAMED: usize = 6;

/// Draws it; nothing where the scene was not followed.
///
/// # Errors
/// What the plotting library reports.
pub fn svg(measured: &Measured) -> Result<Option<String>, Box<dyn Error>> {
    let Some(over_time) = &measured.over_time else { return Ok(None) };
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        root.fill(&rgb(GROUND))?;
        let heading = ("sans-serif", 24).into_font().color(&rgb(TEXT));
        let title = format!("{}: over time, step {}", measured.title, step(over_time.step));
        root.draw_text(&title, &heading, (24, 18)).map_err(|error| error.to_string())?;
        draw(measured, &over_time.courses, &Timeline::of(over_time), &root).map_err(|error| error.to_string())?;
        root.present()?;
    }
    Ok(Some(text))
}

/// Where a moment lies, if anything is known of it.
type Place<'a> = &'a dyn Fn(&Moment) -> Option<(f64, f64)>;

fn draw<'a>(measured: &Measured, courses: &[Course], axes: &Timeline, root: &Area<'a>) -> Drawn<'a> {
    let (left, _) = root.split_horizontally(LEGEND - 16);
    let (_, plots) = left.split_vertically(52);
    let height = (SIZE.1 - 52) as i32;
    let (upper, lower) = plots.split_vertically(if axes.energy.is_some() { height * 11 / 20 } else { height });
    let decades = axes.error;
    let errors: Vec<(f64, String)> =
        decades.named(8).map(|exponent| (decades.part(10f64.powi(exponent)), power(exponent))).collect();
    let tolerance = Some(decades.part(super::TOLERANCE));
    let plot = Plot { measured, courses, end: axes.end };
    plot.draw(&upper, &Upright { name: "error, m", named: errors, line: tolerance }, &|moment| Some(axes.error_at(moment)))?;
    if let Some((least, most)) = axes.energy {
        let part = |energy: f64| (energy - least) / (most - least);
        let energies = round_numbers(least, most, NAMED).into_iter().map(|energy| (part(energy), energy_name(energy))).collect();
        let upright = Upright { name: "energy, parts of the right one", named: energies, line: None };
        plot.draw(&lower, &upright, &|moment| axes.energy_at(moment))?;
    }
    let style = ("sans-serif", 17).into_font().color(&rgb(TEXT));
    for (line, course) in courses.iter().enumerate() {
        let y = 64 + line as i32 * LINE;
        sample(root, &look(measured, course), y)?;
        root.draw_text(&course.name, &style, (LEGEND + 46, y - 8))?;
    }
    Ok(())
}

/// As the same method looks in the scene's other diagram.
fn look(measured: &Measured, course: &Course) -> Look {
    let same = |curve: &Curve| curve.name == course.name && curve.origin == course.origin;
    let index = measured.curves.iter().position(same).unwrap_or(0);
    let look = Look::of(index, course.origin);
    Look { width: look.width.min(2), ..look }
}

/// What stands along an upright axis: its name, values with their parts of the way up, and a dotted line at one.
struct Upright {
    name: &'static str,
    named: Vec<(f64, String)>,
    line: Option<f64>,
}

/// What both plots share.
struct Plot<'a> {
    measured: &'a Measured,
    courses: &'a [Course],
    end: f64,
}

impl Plot<'_> {
    fn draw<'b>(&self, area: &Area<'b>, upright: &Upright, place: Place<'_>) -> Drawn<'b> {
        let mut chart = ChartBuilder::on(area)
            .margin_top(10)
            .margin_left(16)
            .margin_right(16)
            .margin_bottom(8)
            .x_label_area_size(44)
            .y_label_area_size(80)
            .build_cartesian_2d(0.0..self.end, 0.0..1.0)?;
        // The library names its own values; the upright ones are parts of the way.
        chart
            .configure_mesh()
            .disable_y_mesh()
            .y_labels(0)
            .x_labels(NAMED + 2)
            .x_label_formatter(&|value| number(*value))
            .x_desc("time, s")
            .y_desc(upright.name)
            .axis_style(rgb(HEAVY_GRID))
            .bold_line_style(rgb(HEAVY_GRID))
            .light_line_style(rgb(GRID))
            .label_style(("sans-serif", 15).into_font().color(&rgb(QUIET)))
            .axis_desc_style(("sans-serif", 16).into_font().color(&rgb(TEXT)))
            .draw()?;
        let words = ("sans-serif", 15).into_font().color(&rgb(QUIET));
        for (part, name) in &upright.named {
            chart.draw_series(LineSeries::new([(0.0, *part), (self.end, *part)], rgb(HEAVY_GRID)))?;
            let (x, y) = chart.backend_coord(&(0.0, *part));
            let (left, top) = area.get_base_pixel();
            let width = area.estimate_text_size(name, &words)?.0 as i32;
            area.draw_text(name, &words, (x - left - width - 8, y - top - 7))?;
        }
        if let Some(line) = upright.line {
            let (on, off) = TOLERANCE_DASH;
            chart.draw_series(DashedLineSeries::new([(0.0, line), (self.end, line)], on, off, rgb(GOOD).stroke_width(2)))?;
        }
        for course in self.courses {
            let look = look(self.measured, course);
            let line: Vec<(f64, f64)> = course.moments.iter().filter_map(place).map(|(right, up)| (right * self.end, up)).collect();
            match look.dash {
                None => drop(chart.draw_series(LineSeries::new(line, stroke(&look)))?),
                Some((on, off)) => drop(chart.draw_series(DashedLineSeries::new(line, on, off, stroke(&look)))?),
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::course::OverTime;
    use crate::lab::curve::Origin;

    #[test]
    fn what_blew_up_is_drawn_without_bad_numbers() {
        let moment = |time, error, energy| Moment { time, error, energy: Some(energy) };
        let moments = vec![moment(1.0, 0.0, 1.0), moment(2.0, f64::NAN, f64::INFINITY), moment(3.0, 1e300, f64::NAN)];
        let course = Course { name: "wild".into(), origin: Origin::Lab, moments };
        let over_time = Some(OverTime { step: 1.0 / 60.0, courses: vec![course] });
        let mut measured = Measured { over_time, ..Measured::of_curves(Vec::new()) };
        let drawn = svg(&measured).unwrap().unwrap();
        for word in ["A title: over time, step 1/60 s", "error, m", "energy", "wild", "time, s"] {
            assert!(drawn.contains(word), "{word}");
        }
        assert!(!drawn.contains("NaN") && !drawn.contains("inf"));
        measured.over_time = None;
        assert!(svg(&measured).unwrap().is_none());
    }
}
