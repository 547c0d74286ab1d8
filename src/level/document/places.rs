//! Rectangles in the author's picture, in pixels, and the texts of numbers, way points and plain shapes.

use crate::physics::DVec2;

/// Pixels of the author's picture, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    pub min: DVec2,
    pub size: DVec2,
}

impl Place {
    pub fn max(&self) -> DVec2 {
        self.min + self.size
    }

    pub fn centre(&self) -> DVec2 {
        self.min + self.size * 0.5
    }

    pub fn between(a: DVec2, b: DVec2) -> Self {
        Self { min: a.min(b), size: (a - b).abs() }
    }

    /// Edges count.
    pub fn contains(&self, point: DVec2) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max()).all()
    }

    pub fn meets(&self, other: &Self) -> bool {
        self.min.cmple(other.max()).all() && other.min.cmple(self.max()).all()
    }
}

/// Steps of a written number in a pixel.
pub(super) const FINEST: f64 = 1000.0;

/// A number with at most three decimals.
pub fn number(value: f64) -> String {
    let rounded = (value * FINEST).round() / FINEST;
    (if rounded == 0.0 { 0.0 } else { rounded }).to_string()
}

pub(super) fn parsed(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| value.is_finite() && value.abs() < 1e12)
}

/// `600 300; 600 100`.
pub fn way_text(points: &[DVec2]) -> String {
    points.iter().map(|point| format!("{} {}", number(point.x), number(point.y))).collect::<Vec<_>>().join("; ")
}

pub(super) fn points(text: &str) -> Option<Vec<DVec2>> {
    let points = text.split(';').map(str::trim).filter(|point| !point.is_empty());
    points.map(point).collect()
}

/// `600 300`.
pub(super) fn point(text: &str) -> Option<DVec2> {
    match text.split_whitespace().collect::<Vec<_>>()[..] {
        [x, y] => Some(DVec2::new(parsed(x)?, parsed(y)?)),
        _ => None,
    }
}

/// Whether a plain shape is round, and its size.
pub(super) fn shape(image: &str) -> Option<(bool, DVec2)> {
    let lower = image.to_ascii_lowercase();
    let (round, size) =
        lower.strip_prefix("box:").map(|size| (false, size)).or_else(|| Some((true, lower.strip_prefix("ball:")?)))?;
    let (width, height) = size.split_once('x')?;
    Some((round, DVec2::new(parsed(width.trim())?, parsed(height.trim())?)))
}

/// `ball:40x40`.
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
