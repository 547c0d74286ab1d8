//! A work–precision diagram as SVG: work to the right, error upwards, both logarithmic; a curve a method and a point a step. Methods
//! are told apart by colour, dash and marker. A cross on the upper edge is a run that blew up; a point on the lower edge has no error
//! but rounding, or none.

use super::curve::{Curve, Measured, Origin, Point};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;

// Sizes of type are given as the plotting library wants them: it writes 1/1.24 of them.

/// Pixels.
const SIZE: (u32, u32) = (1040, 600);
/// Pixels. Where the legend begins.
const LEGEND: i32 = 740;
/// Pixels between the legend's lines.
const LINE: i32 = 26;
/// Errors below this are drawn on the lower edge: rounding of numbers about 1.
const LEAST_ERROR: f64 = 1e-16;
/// Pixels.
const MARKER: i32 = 5;

// The game's notebook at night.
const GROUND: RGBColor = RGBColor(0x10, 0x14, 0x1B);
const GRID: RGBColor = RGBColor(0x1A, 0x21, 0x30);
const HEAVY_GRID: RGBColor = RGBColor(0x2C, 0x36, 0x48);
const TEXT: RGBColor = RGBColor(0xE6, 0xEB, 0xF2);
const QUIET: RGBColor = RGBColor(0x93, 0xA0, 0xB4);
const SHIPPED: RGBColor = RGBColor(0xFF, 0x9F, 0x1C);
const GOOD: RGBColor = RGBColor(0x4C, 0xC3, 0x8A);
/// Told apart by all common kinds of colour vision (M. Okabe, K. Ito, "Color Universal Design", 2008), lightened for a dark ground.
const COLOURS: [RGBColor; 8] = [
    RGBColor(0x56, 0xB4, 0xE9),
    RGBColor(0xB7, 0x9C, 0xED),
    RGBColor(0xF0, 0xE4, 0x42),
    RGBColor(0xD5, 0x5E, 0x00),
    RGBColor(0x1F, 0xB8, 0x8F),
    RGBColor(0xCC, 0x79, 0xA7),
    RGBColor(0xDC, 0xE6, 0xF5),
    RGBColor(0xA3, 0xA8, 0x47),
];
/// Pixels drawn and left out.
const DASHES: [Option<(u32, u32)>; 4] = [None, Some((8, 4)), Some((3, 3)), Some((14, 5))];

/// Draws it.
///
/// # Errors
/// What the plotting library reports.
pub fn svg(measured: &Measured) -> Result<String, Box<dyn Error>> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        root.fill(&GROUND)?;
        draw(measured, &root).map_err(|error| error.to_string())?;
        root.present()?;
    }
    Ok(text)
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn<'a> = Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw<'a>(measured: &Measured, root: &Area<'a>) -> Drawn<'a> {
    let heading = ("sans-serif", 24).into_font().color(&TEXT);
    root.draw_text(&measured.title, &heading, (24, 18))?;
    let (left, _) = root.split_horizontally(LEGEND - 16);
    let (xs, ys) = ranges(measured);
    let top = ys.end;
    let mut chart = ChartBuilder::on(&left)
        .margin_top(56)
        .margin_left(16)
        .margin_right(16)
        .margin_bottom(12)
        .x_label_area_size(56)
        .y_label_area_size(80)
        .build_cartesian_2d(xs.clone().log_scale(), ys.clone().log_scale())?;
    chart
        .configure_mesh()
        .x_desc(&measured.work)
        .y_desc(&measured.error)
        .x_label_formatter(&|value| power(*value))
        .y_label_formatter(&|value| power(*value))
        .x_labels(10)
        .y_labels(12)
        .axis_style(HEAVY_GRID)
        .bold_line_style(HEAVY_GRID)
        .light_line_style(GRID)
        .max_light_lines(4)
        .label_style(("sans-serif", 16).into_font().color(&QUIET))
        .axis_desc_style(("sans-serif", 17).into_font().color(&TEXT))
        .draw()?;
    let tolerance = [(xs.start, measured.tolerance), (xs.end, measured.tolerance)];
    chart.draw_series(DashedLineSeries::new(tolerance, 2, 4, GOOD.stroke_width(2)))?;
    for (index, curve) in measured.curves.iter().enumerate() {
        let look = Look::of(index, curve);
        let place = |point: &Point| (point.work, point.error.clamp(LEAST_ERROR, top));
        let line: Vec<_> = curve.points.iter().filter(|point| !point.blew_up()).map(place).collect();
        match look.dash {
            _ if line.len() < 2 => {}
            None => drop(chart.draw_series(LineSeries::new(line, look.stroke()))?),
            Some((on, off)) => drop(chart.draw_series(DashedLineSeries::new(line, on, off, look.stroke()))?),
        }
        for point in &curve.points {
            let marker = if point.blew_up() { Marker::Cross } else { look.marker };
            let at = if point.blew_up() { (point.work, top) } else { place(point) };
            chart.draw_series(std::iter::once(EmptyElement::at(at) + marker.polygon((0, 0), look.colour)))?;
        }
    }
    if let Some((_, point)) = measured.shipped() {
        let at = (point.work, point.error.clamp(LEAST_ERROR, top));
        let ring = Circle::new((0, 0), 11, SHIPPED.stroke_width(2));
        chart.draw_series(std::iter::once(EmptyElement::at(at) + ring))?;
    }
    legend(measured, root)
}

fn legend<'a>(measured: &Measured, root: &Area<'a>) -> Drawn<'a> {
    let style = ("sans-serif", 17).into_font().color(&TEXT);
    let quiet = ("sans-serif", 16).into_font().color(&QUIET);
    let mut y = 64;
    for (index, curve) in measured.curves.iter().enumerate() {
        let look = Look::of(index, curve);
        let (from, to) = ((LEGEND, y), (LEGEND + 36, y));
        match look.dash {
            None => root.draw(&PathElement::new(vec![from, to], look.stroke()))?,
            Some((on, off)) => {
                let mut x = from.0;
                while x < to.0 {
                    let end = (x + on as i32).min(to.0);
                    root.draw(&PathElement::new(vec![(x, y), (end, y)], look.stroke()))?;
                    x = end + off as i32;
                }
            }
        }
        root.draw(&look.marker.polygon((LEGEND + 18, y), look.colour))?;
        root.draw_text(&curve.name, &style, (LEGEND + 46, y - 8))?;
        y += LINE;
    }
    y += LINE / 2;
    for x in (LEGEND..LEGEND + 36).step_by(6) {
        root.draw(&PathElement::new(vec![(x, y), (x + 2, y)], GOOD.stroke_width(2)))?;
    }
    let tolerance = if measured.tolerance == super::TOLERANCE {
        "a tenth of a pixel, 1/300 m".to_owned()
    } else {
        format!("tolerance: {}", number(measured.tolerance))
    };
    root.draw_text(&tolerance, &quiet, (LEGEND + 46, y - 8))?;
    y += LINE;
    if measured.shipped().is_some() {
        root.draw(&Circle::new((LEGEND + 18, y), 10, SHIPPED.stroke_width(2)))?;
        root.draw_text("as shipped", &quiet, (LEGEND + 46, y - 8))?;
        y += LINE;
    }
    if measured.curves.iter().flat_map(|curve| &curve.points).any(Point::blew_up) {
        root.draw(&Marker::Cross.polygon((LEGEND + 18, y), QUIET))?;
        root.draw_text("on the upper edge: blew up", &quiet, (LEGEND + 46, y - 8))?;
        y += LINE;
    }
    if measured.curves.iter().flat_map(|curve| &curve.points).any(|point| point.error < LEAST_ERROR) {
        root.draw_text("on the lower edge: no error", &quiet, (LEGEND, y))?;
        y += LINE;
    }
    root.draw_text("lower left is better", &quiet, (LEGEND, y))?;
    Ok(())
}

/// How a curve looks. Other engines are white, ours has the accent's colour.
struct Look {
    colour: RGBColor,
    dash: Option<(u32, u32)>,
    marker: Marker,
    width: u32,
}

impl Look {
    fn of(index: usize, curve: &Curve) -> Self {
        let shape = Marker::ALL[index % Marker::ALL.len()];
        match curve.origin {
            Origin::Shipped => Self { colour: SHIPPED, dash: None, marker: Marker::Star, width: 3 },
            Origin::Lab => {
                Self { colour: COLOURS[index % COLOURS.len()], dash: DASHES[index % DASHES.len()], marker: shape, width: 2 }
            }
            Origin::Peer => Self { colour: TEXT, dash: DASHES[2], marker: shape, width: 1 },
        }
    }

    fn stroke(&self) -> ShapeStyle {
        self.colour.stroke_width(self.width)
    }
}

/// The shape of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Marker {
    Square,
    Up,
    Diamond,
    Down,
    Bar,
    Hexagon,
    Pole,
    Star,
    Cross,
}

impl Marker {
    /// Those that curves take in turn.
    const ALL: [Self; 7] = [Self::Square, Self::Up, Self::Diamond, Self::Down, Self::Hexagon, Self::Bar, Self::Pole];

    /// Drawn around a pixel.
    fn polygon(self, (x, y): (i32, i32), colour: RGBColor) -> Polygon<(i32, i32)> {
        let r = MARKER;
        let corners: Vec<(i32, i32)> = match self {
            Self::Square => vec![(-r + 1, -r + 1), (r - 1, -r + 1), (r - 1, r - 1), (-r + 1, r - 1)],
            Self::Up => vec![(0, -r - 1), (r + 1, r - 1), (-r - 1, r - 1)],
            Self::Down => vec![(0, r + 1), (r + 1, -r + 1), (-r - 1, -r + 1)],
            Self::Diamond => vec![(0, -r - 1), (r + 1, 0), (0, r + 1), (-r - 1, 0)],
            Self::Bar => vec![(-r - 1, -2), (r + 1, -2), (r + 1, 2), (-r - 1, 2)],
            Self::Pole => vec![(-2, -r - 1), (2, -r - 1), (2, r + 1), (-2, r + 1)],
            Self::Hexagon => vec![(-3, -5), (3, -5), (6, 0), (3, 5), (-3, 5), (-6, 0)],
            Self::Star => vec![(0, -8), (2, -2), (8, -2), (3, 2), (5, 8), (0, 4), (-5, 8), (-3, 2), (-8, -2), (-2, -2)],
            Self::Cross => {
                vec![(-6, -4), (-4, -6), (0, -2), (4, -6), (6, -4), (2, 0), (6, 4), (4, 6), (0, 2), (-4, 6), (-6, 4), (-2, 0)]
            }
        };
        Polygon::new(corners.into_iter().map(|(dx, dy)| (x + dx, y + dy)).collect::<Vec<_>>(), colour.filled())
    }
}

/// Whole decades around everything that is shown.
fn ranges(measured: &Measured) -> (std::ops::Range<f64>, std::ops::Range<f64>) {
    let points = || measured.curves.iter().flat_map(|curve| &curve.points);
    let work = points().map(|point| point.work).filter(|work| *work > 0.0);
    let errors = points().filter(|point| !point.blew_up()).map(|point| point.error.max(LEAST_ERROR)).chain([measured.tolerance]);
    (decades(work), decades(errors))
}

fn decades(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (least, most) = values.fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), value| (least.min(value), most.max(value)));
    if least > most {
        return 1.0..10.0;
    }
    let (from, to) = (least.log10().floor() as i32, most.log10().ceil() as i32);
    10f64.powi(from)..10f64.powi(to.max(from + 1))
}

/// A power of ten, as 10⁻³.
fn power(value: f64) -> String {
    let exponent = value.log10();
    if (exponent - exponent.round()).abs() > 1e-6 {
        return number(value);
    }
    let exponent = exponent.round() as i32;
    let digit = |c: char| match c {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => c.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(c),
    };
    format!("10{}", exponent.to_string().chars().map(digit).collect::<String>())
}

/// A number to three digits.
pub(super) fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "∞".to_owned();
    }
    if (1e-3..1e5).contains(&value.abs()) {
        let digits = (2 - value.abs().log10().floor() as i32).clamp(0, 6) as usize;
        let text = format!("{value:.digits$}");
        let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text };
        return text.replace('-', "−");
    }
    format!("{value:.1e}").replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases =
            [(1.0 / 300.0, "0.00333"), (1e-9, "1.0e−9"), (1234.5, "1234"), (0.5, "0.5"), (36.04, "36"), (0.0, "0"), (1e6, "1.0e6")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
        assert_eq!((power(1e-12), power(100.0), power(1.0)), ("10⁻¹²".to_owned(), "10²".to_owned(), "10⁰".to_owned()));
    }

    #[test]
    fn a_diagram_has_its_words_as_text_and_no_bad_numbers() {
        let point = |step, work, error| Point { step, work, error };
        let curve = |name: &str, origin, points| Curve { name: name.to_owned(), origin, points };
        let measured = Measured {
            name: "n".into(),
            title: "A title".into(),
            error: "error, m".into(),
            work: "work, ns".into(),
            tolerance: 1e-3,
            shipped_step: 0.01,
            alike: true,
            curves: vec![
                curve("wild", Origin::Lab, vec![point(0.1, 10.0, f64::NAN), point(0.01, 100.0, 1e-2)]),
                curve("ours", Origin::Shipped, vec![point(0.01, 50.0, 0.0)]),
            ],
        };
        let svg = svg(&measured).unwrap();
        for word in ["A title", "error, m", "work, ns", "wild", "ours", "as shipped", "blew up", "tolerance"] {
            assert!(svg.contains(word), "{word}");
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}
