//! Curves above one linear axis, as SVG: a lane for each kind of number, one above the other, and a legend. What lies upwards in a lane is
//! told in parts of the way, so that it may be linear or not.

use super::diagram::{Area, Drawn, GRID, GROUND, HEAVY_GRID, LEGEND, LINE, QUIET, SIZE, polygons, rgb, sample, stroke};
use super::linear::Linear;
use super::look::{GOOD, Look, TEXT, TOLERANCE_DASH};
use plotters::prelude::*;

/// Named values to the right, about.
const NAMED: usize = 8;
/// Pixels. Where the lanes begin below the title.
const TOP: i32 = 52;
/// Pixels drawn and left out of a line that stands at a value.
const MARK_DASH: (u32, u32) = (2, 5);

/// All that is drawn.
pub struct Sheet {
    /// The heading.
    pub title: String,
    /// What a reader should know, below the legend; a line each.
    pub notes: Vec<String>,
    /// To the right.
    pub across: Linear,
    /// What that is, with its unit.
    pub across_name: String,
    /// From the top.
    pub lanes: Vec<Lane>,
    /// For the legend.
    pub legend: Vec<(String, Look)>,
}

/// One of the lanes.
pub struct Lane {
    /// What lies upwards, with its unit.
    pub name: String,
    /// How high it is beside the others.
    pub height: u32,
    /// Values with their parts of the way up.
    pub named: Vec<(f64, String)>,
    /// A dotted line at a part of the way up.
    pub line: Option<f64>,
    /// Values to the right at which a line stands.
    pub marks: Vec<f64>,
    /// The curves.
    pub ways: Vec<Way>,
}

/// An unbroken piece of a curve.
pub struct Way {
    /// How it looks.
    pub look: Look,
    /// Values to the right, and parts of the way up.
    pub points: Vec<(f64, f64)>,
    /// The one of them that bears the curve's marker, if any does.
    pub marker: Option<usize>,
}

/// Draws it.
///
/// # Errors
/// What the plotting library reports, in words.
pub fn svg(sheet: &Sheet) -> Result<String, String> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        draw(sheet, &root).and_then(|()| root.present()).map_err(|error| error.to_string())?;
    }
    Ok(text)
}

fn draw<'a>(sheet: &Sheet, root: &Area<'a>) -> Drawn<'a> {
    root.fill(&rgb(GROUND))?;
    root.draw_text(&sheet.title, &("sans-serif", 24).into_font().color(&rgb(TEXT)), (24, 18))?;
    let (left, _) = root.split_horizontally(LEGEND - 16);
    let (_, mut rest) = left.split_vertically(TOP);
    let mut height = SIZE.1 as i32 - TOP;
    let mut weight: u32 = sheet.lanes.iter().map(|lane| lane.height).sum();
    for lane in &sheet.lanes {
        let own = height * lane.height as i32 / weight.max(1) as i32;
        let (upper, lower) = rest.split_vertically(own);
        draw_lane(sheet, lane, &upper)?;
        (rest, height, weight) = (lower, height - own, weight - lane.height);
    }
    let words = ("sans-serif", 17).into_font().color(&rgb(TEXT));
    let mut y = 64;
    for (name, look) in &sheet.legend {
        sample(root, look, y)?;
        root.draw_text(name, &words, (LEGEND + 46, y - 8))?;
        y += LINE;
    }
    let quiet = ("sans-serif", 15).into_font().color(&rgb(QUIET));
    for note in &sheet.notes {
        root.draw_text(note, &quiet, (LEGEND, y))?;
        y += LINE - 6;
    }
    Ok(())
}

fn draw_lane<'a>(sheet: &Sheet, lane: &Lane, area: &Area<'a>) -> Drawn<'a> {
    let Linear { from, to } = sheet.across;
    let mut chart = ChartBuilder::on(area)
        .margin_top(10)
        .margin_left(16)
        .margin_right(16)
        .margin_bottom(8)
        .x_label_area_size(44)
        .y_label_area_size(80)
        .build_cartesian_2d(from..to, 0.0..1.0)?;
    // The library names values of its own; those named here are the round ones of the axes.
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(0)
        .y_labels(0)
        .x_desc(&sheet.across_name)
        .y_desc(&lane.name)
        .axis_style(rgb(HEAVY_GRID))
        .axis_desc_style(("sans-serif", 16).into_font().color(&rgb(TEXT)))
        .draw()?;
    let words = ("sans-serif", 15).into_font().color(&rgb(QUIET));
    let (base_x, base_y) = area.get_base_pixel();
    for (part, name) in &lane.named {
        chart.draw_series(LineSeries::new([(from, *part), (to, *part)], rgb(GRID)))?;
        let (x, y) = chart.backend_coord(&(from, *part));
        let width = area.estimate_text_size(name, &words)?.0 as i32;
        area.draw_text(name, &words, (x - base_x - width - 8, y - base_y - 7))?;
    }
    for (value, name) in sheet.across.named(NAMED) {
        chart.draw_series(LineSeries::new([(value, 0.0), (value, 1.0)], rgb(GRID)))?;
        let (x, y) = chart.backend_coord(&(value, 0.0));
        let width = area.estimate_text_size(&name, &words)?.0 as i32;
        area.draw_text(&name, &words, (x - base_x - width / 2, y - base_y + 6))?;
    }
    if let Some(line) = lane.line {
        let (on, off) = TOLERANCE_DASH;
        chart.draw_series(DashedLineSeries::new([(from, line), (to, line)], on, off, rgb(GOOD).stroke_width(2)))?;
    }
    for mark in &lane.marks {
        let (on, off) = MARK_DASH;
        chart.draw_series(DashedLineSeries::new([(*mark, 0.0), (*mark, 1.0)], on, off, rgb(QUIET).stroke_width(1)))?;
    }
    for way in &lane.ways {
        let line = way.points.iter().copied();
        match way.look.dash {
            None => drop(chart.draw_series(LineSeries::new(line, stroke(&way.look)))?),
            Some((on, off)) => drop(chart.draw_series(DashedLineSeries::new(line, on, off, stroke(&way.look)))?),
        }
        if let Some(at) = way.marker.and_then(|marker| way.points.get(marker)) {
            for piece in polygons((0, 0), way.look.marker, way.look.colour) {
                chart.draw_series(std::iter::once(EmptyElement::at(*at) + piece))?;
            }
        }
    }
    Ok(())
}
