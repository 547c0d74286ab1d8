//! Where a row's thing lies in the author's picture, in pixels, and what its cells hold when it lies elsewhere. Read leniently: what has
//! no place that can be read is not drawn, and its problem is the loader's to tell.

use super::kinds::Kind;
use super::{Document, RowId, SetCell};
use crate::level::types::{SHIP_HEIGHT, SHIP_PIXELS};
use crate::physics::DVec2;

/// Width of a letter in heights of it, about.
const LETTER: f64 = 0.5;

/// A rectangle in the author's picture, pixels, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// Its top left corner.
    pub min: DVec2,
    /// Its width and height.
    pub size: DVec2,
}

impl Place {
    /// Its bottom right corner.
    pub fn max(&self) -> DVec2 {
        self.min + self.size
    }

    /// Its middle.
    pub fn centre(&self) -> DVec2 {
        self.min + self.size * 0.5
    }

    /// The rectangle between two opposite corners.
    pub fn between(a: DVec2, b: DVec2) -> Self {
        Self { min: a.min(b), size: (a - b).abs() }
    }

    /// Whether a point lies in it or on its edge.
    pub fn contains(&self, point: DVec2) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max()).all()
    }

    /// Whether two share a point.
    pub fn meets(&self, other: &Self) -> bool {
        self.min.cmple(other.max()).all() && other.min.cmple(self.max()).all()
    }
}

/// How far down a number is written: a thousandth of a pixel.
const FINEST: f64 = 1000.0;

/// A number as a person writes it.
pub fn number(value: f64) -> String {
    let rounded = (value * FINEST).round() / FINEST;
    (if rounded == 0.0 { 0.0 } else { rounded }).to_string()
}

fn parsed(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| value.is_finite() && value.abs() < 1e12)
}

impl Document {
    /// Pixels a metre.
    pub fn metre(&self) -> f64 {
        let metre = self.setting("metre").and_then(parsed).filter(|metre| *metre > 1e-3);
        metre.unwrap_or(SHIP_PIXELS / SHIP_HEIGHT)
    }

    /// The level's size in pixels: that of its background, or what its settings say.
    pub fn size(&self) -> DVec2 {
        let given = |name: &str, usual: f64| self.setting(name).and_then(parsed).filter(|side| *side >= 1.0).unwrap_or(usual);
        self.background.unwrap_or_else(|| DVec2::new(given("width", 1280.0), given("height", 720.0)))
    }

    /// The number in a cell, where there is one.
    pub fn number(&self, row: RowId, column: &str) -> Option<f64> {
        self.cell(row, column).and_then(parsed)
    }

    /// Where the row's thing lies.
    pub(super) fn measure(&self, row: RowId) -> Option<Place> {
        let kind = self.kind(row)?;
        let at = DVec2::new(self.number(row, "x")?, self.number(row, "y")?);
        let size = match kind {
            Kind::Setting => return None,
            Kind::Ship => DVec2::splat(SHIP_HEIGHT * self.metre()),
            Kind::Object | Kind::Key | Kind::Picture => self.picture_size(self.cell(row, "image")?).unwrap_or(DVec2::splat(20.0)),
            Kind::Text => {
                let height = self.number(row, "size")?.abs();
                DVec2::new(LETTER * height * self.cell(row, "text").map_or(0, |text| text.chars().count()) as f64, height)
            }
            _ => DVec2::new(self.number(row, "width")?, self.number(row, "height")?),
        };
        if size.cmple(DVec2::ZERO).any() {
            return None;
        }
        Some(Place { min: if kind.by_centre() { at - size * 0.5 } else { at }, size })
    }

    /// Whether the row's thing can be given another size.
    pub fn is_sizable(&self, row: RowId) -> bool {
        match self.kind(row) {
            None | Some(Kind::Ship | Kind::Setting) => false,
            Some(Kind::Object | Kind::Key | Kind::Picture) => self.cell(row, "image").is_some_and(|image| shape(image).is_some()),
            Some(_) => true,
        }
    }

    /// What the row's cells hold when its thing lies there; its size only where that differs.
    pub fn placed(&self, row: RowId, to: Place) -> Vec<SetCell> {
        let (Some(kind), Some(from)) = (self.kind(row), self.place(row)) else { return Vec::new() };
        let mut cells = Vec::new();
        let mut set = |column: &'static str, value: f64| cells.push(SetCell { row, column, text: number(value) });
        let resized = (to.size - from.size).abs().max_element() > 0.5 / FINEST;
        let corner = |place: &Place| if kind.by_centre() { place.centre() } else { place.min };
        let (old, new) = (corner(&from), corner(&to));
        if new.x != old.x {
            set("x", new.x);
        }
        if new.y != old.y {
            set("y", new.y);
        }
        if resized && self.is_sizable(row) {
            match kind {
                Kind::Text => set("size", to.size.y.max(1.0)),
                Kind::Object | Kind::Key | Kind::Picture => {
                    let round = self.cell(row, "image").and_then(shape).is_some_and(|(round, _)| round);
                    let text = shape_text(round, to.size);
                    cells.push(SetCell { row, column: "image", text });
                }
                _ => {
                    set("width", to.size.x);
                    set("height", to.size.y);
                }
            }
        }
        cells
    }

    /// What the row's cells hold when its thing, and its way if it has one, lies so many pixels further.
    pub fn shifted(&self, row: RowId, by: DVec2) -> Vec<SetCell> {
        let Some(place) = self.place(row) else { return Vec::new() };
        let mut cells = self.placed(row, Place { min: place.min + by, ..place });
        if self.kind(row) == Some(Kind::Mover) {
            let way: Vec<DVec2> = self.way_points(row).into_iter().map(|point| point + by).collect();
            if !way.is_empty() {
                cells.push(SetCell { row, column: "way_points", text: way_text(&way) });
            }
        }
        cells
    }

    /// The way points of a mover, pixels; none where they cannot be read.
    pub fn way_points(&self, row: RowId) -> Vec<DVec2> {
        let text = self.cell(row, "way_points").unwrap_or_default();
        let points = text.split(';').map(str::trim).filter(|point| !point.is_empty());
        let point = |text: &str| {
            let mut numbers = text.split_whitespace().map(parsed);
            let point = DVec2::new(numbers.next()??, numbers.next()??);
            numbers.next().is_none().then_some(point)
        };
        points.map(point).collect::<Option<_>>().unwrap_or_default()
    }
}

/// Way points as the file holds them.
pub fn way_text(points: &[DVec2]) -> String {
    points.iter().map(|point| format!("{} {}", number(point.x), number(point.y))).collect::<Vec<_>>().join("; ")
}

/// Whether a plain shape is round, and its size.
pub(super) fn shape(image: &str) -> Option<(bool, DVec2)> {
    let lower = image.to_ascii_lowercase();
    let (round, size) =
        lower.strip_prefix("box:").map(|size| (false, size)).or_else(|| Some((true, lower.strip_prefix("ball:")?)))?;
    let (width, height) = size.split_once('x')?;
    Some((round, DVec2::new(parsed(width.trim())?, parsed(height.trim())?)))
}

/// A plain shape as a cell holds it.
pub(super) fn shape_text(round: bool, size: DVec2) -> String {
    format!("{}:{}x{}", if round { "ball" } else { "box" }, number(size.x), number(size.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_people_write_them() {
        for (value, text) in [(50.0, "50"), (-0.0001, "0"), (12.5, "12.5"), (0.1 + 0.2, "0.3"), (-7.25, "-7.25")] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn plain_shapes_have_a_size() {
        assert_eq!(shape("Box:40X20"), Some((false, DVec2::new(40.0, 20.0))));
        assert_eq!(shape("ball: 5 x 6"), Some((true, DVec2::new(5.0, 6.0))));
        assert_eq!(shape("assets/ball.png"), None);
        assert_eq!(shape_text(true, DVec2::new(5.5, 6.0)), "ball:5.5x6");
    }
}
