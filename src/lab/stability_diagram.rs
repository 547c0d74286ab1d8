//! The regions of stability as SVG and as CSV: the left half of the plane of z = h·λ down to its real axis, the edge of each method's
//! region, and its limits on the rays of a swing and of drag alone.

use super::curve::CurveOrigin;
use super::diagram::{Area, Drawn, GRID, GROUND, HEAVY_GRID, LEGEND, LINE, QUIET, SIZE, polygons, rgb, sample, stroke};
use super::look::{Look, TEXT};
use super::rows::{shortest, table};
use super::stability::{Complex, IMAGINARY, REAL, Region, SHIPPED, SHIPPED_LIMITS, examples, limit};
use plotters::prelude::*;
use std::error::Error;

/// From the canvas' top to the plot, and the height of the plot, pixels: as many for 1 as to the right.
const TOP: u32 = 84;
const HEIGHT: u32 = 336;
/// What the values along the axes take up, pixels.
const LABELS: u32 = 48;
/// From the legend's left edge to the columns of the limits, pixels.
const COLUMNS: [i32; 2] = [222, 268];
/// What the diagram says below itself.
const WORDS: [&str; 4] = [
    "h: the step; λ: the rate at which a motion e^(λt) fades (to the left) and swings (upwards). Inside its edge a method's errors",
    "fade, outside they grow from step to step. Below the real axis all is the same again. What really happens, e^z, fades in all",
    "of the left half, and so does the shipped engine, which takes the exact flow of both rays. Marks: how far each method goes on",
    "the two rays. A fall near its terminal velocity v_t has z = −2·g·h/v_t.",
];

/// The name of the picture.
pub const SVG: &str = "stability.svg";
/// Heading.
pub const TITLE: &str = "Where methods are stable: the plane of z = h·λ";

/// How the region of that index looks.
pub fn look(index: usize) -> Look {
    Look::of(index, CurveOrigin::Lab)
}

/// How the shipped engine looks.
pub fn shipped_look() -> Look {
    Look::of(0, CurveOrigin::Shipped)
}

/// The edges, point by point, and the limits on the two rays: two files.
pub fn csv(regions: &[Region]) -> [(&'static str, String); 2] {
    let points = regions.iter().flat_map(|region| {
        region.edge.iter().enumerate().flat_map(move |(piece, line)| {
            line.iter().map(move |(re, im)| vec![region.name.to_owned(), piece.to_string(), shortest(*re), shortest(*im)])
        })
    });
    let limits = regions.iter().map(|region| vec![region.name.to_owned(), shortest(region.drag), shortest(region.swing)]);
    [
        ("stability.csv", table(&["method", "piece", "re", "im"], points)),
        ("stability-limits.csv", table(&["method", "drag_alone", "swing"], limits)),
    ]
}

/// Draws them.
///
/// # Errors
/// What the plotting library reports.
pub fn svg(regions: &[Region]) -> Result<String, Box<dyn Error>> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        root.fill(&rgb(GROUND))?;
        draw(regions, &root).map_err(|error| error.to_string())?;
        root.present()?;
    }
    Ok(text)
}

fn draw<'a>(regions: &[Region], root: &Area<'a>) -> Drawn<'a> {
    root.draw_text(TITLE, &("sans-serif", 24).into_font().color(&rgb(TEXT)), (24, 18))?;
    let words = ("sans-serif", 16).into_font().color(&rgb(TEXT));
    let quiet = ("sans-serif", 15).into_font().color(&rgb(QUIET));
    root.draw_text("imaginary part: ω·h, what swings", &words, (24, 56))?;
    let (left, _) = root.split_horizontally(LEGEND - 16);
    let mut chart = ChartBuilder::on(&left)
        .margin_top(TOP)
        .margin_bottom(SIZE.1 - TOP - HEIGHT - LABELS)
        .margin_left(16)
        .margin_right(16)
        .x_label_area_size(LABELS)
        .y_label_area_size(LABELS)
        .build_cartesian_2d(REAL.0..REAL.1, IMAGINARY.0..IMAGINARY.1)?;
    chart
        .configure_mesh()
        .x_desc("real part: −h/τ, what fades")
        .x_labels(8)
        .y_labels(8)
        .max_light_lines(1)
        .axis_style(rgb(HEAVY_GRID))
        .bold_line_style(rgb(HEAVY_GRID))
        .light_line_style(rgb(GRID))
        .label_style(quiet.clone())
        .axis_desc_style(words)
        .draw()?;
    let rays: [&[Complex]; 2] = [&[(REAL.0, 0.0), (0.0, 0.0)], &[(0.0, 0.0), (0.0, IMAGINARY.1)]];
    for ray in rays {
        chart.draw_series(LineSeries::new(ray.iter().copied(), stroke(&shipped_look())))?;
    }
    for (index, region) in regions.iter().enumerate() {
        let look = look(index);
        for line in region.edge.iter().map(|line| line.iter().copied()) {
            match look.dash {
                None => drop(chart.draw_series(LineSeries::new(line, stroke(&look)))?),
                Some((on, off)) => drop(chart.draw_series(DashedLineSeries::new(line, on, off, stroke(&look)))?),
            }
        }
        for at in region.marks() {
            for piece in polygons((0, 0), look.marker, look.colour) {
                chart.draw_series(std::iter::once(EmptyElement::at(at) + piece))?;
            }
        }
    }
    for (name, at) in examples() {
        let (x, y) = chart.backend_coord(&at);
        root.draw(&Circle::new((x, y), 5, rgb(TEXT).stroke_width(2)))?;
        let wide = root.estimate_text_size(name, &quiet)?.0 as i32;
        root.draw_text(name, &quiet, (if at.0 < 0.0 { x - wide } else { x + 10 }, y - 20))?;
    }
    for (line, words) in WORDS.iter().enumerate() {
        root.draw_text(words, &quiet, (24, (TOP + HEIGHT + LABELS) as i32 + 22 + 20 * line as i32))?;
    }
    legend(regions, root)
}

fn legend<'a>(regions: &[Region], root: &Area<'a>) -> Drawn<'a> {
    let style = ("sans-serif", 17).into_font().color(&rgb(TEXT));
    let quiet = ("sans-serif", 15).into_font().color(&rgb(QUIET));
    let mut y = 64;
    for (x, words) in COLUMNS.into_iter().zip(["h/τ", "ω·h"]) {
        root.draw_text(words, &quiet, (LEGEND + x, y - 8))?;
    }
    root.draw_text("stable up to", &quiet, (LEGEND + 46, y - 8))?;
    let looks = regions.iter().enumerate().map(|(index, region)| (look(index), region.name, [region.drag, region.swing]));
    for (look, name, limits) in looks.chain([(shipped_look(), SHIPPED, SHIPPED_LIMITS)]) {
        y += LINE;
        sample(root, &look, y)?;
        for piece in polygons((LEGEND + 18, y), look.marker, look.colour) {
            root.draw(&piece)?;
        }
        root.draw_text(name, &style, (LEGEND + 46, y - 8))?;
        for (x, value) in COLUMNS.into_iter().zip(limits) {
            root.draw_text(&limit(value), &style, (LEGEND + x, y - 8))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::stability::regions;

    #[test]
    fn the_picture_names_every_method_and_the_files_hold_every_edge() {
        let regions = regions();
        let drawn = svg(&regions).unwrap();
        assert!(!drawn.contains("NaN") && !drawn.contains("inf"));
        let [(_, edges), (_, limits)] = csv(&regions);
        for region in &regions {
            assert!(drawn.contains(region.name) && limits.contains(&format!("\n{},", quoted(region.name))), "{}", region.name);
            let points = edges.lines().filter(|line| line.starts_with(&format!("{},", quoted(region.name)))).count();
            assert_eq!(points, region.edge.iter().map(Vec::len).sum::<usize>());
            assert!(points > 50, "{}", region.name);
        }
    }

    fn quoted(name: &str) -> String {
        if name.contains(',') { format!("\"{name}\"") } else { name.to_owned() }
    }
}
