//! Which stretches of the solid world's edges lie open: only those get an edge line, so that adjoining rectangles look whole.

use crate::physics::{Aabb, DVec2};

/// Rectangles whose edges are this close count as adjoining, m: far below a pixel.
const TOUCH: f64 = 1e-6;

/// Which side of its rectangle an edge is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The upper one: it catches the light.
    Top,
    /// The lower one.
    Bottom,
    /// The left one.
    Left,
    /// The right one.
    Right,
}

/// An open stretch of the edge of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// The index of the rectangle.
    pub solid: usize,
    /// The side that it belongs to.
    pub side: Side,
    /// Its left or upper end, m.
    pub from: DVec2,
    /// Its right or lower end, m.
    pub to: DVec2,
}

/// The stretches of all edges that neither touch another of the rectangles nor lie on the edge of a level of that size (m).
pub fn open_edges(solids: &[Aabb], level: DVec2) -> Vec<Edge> {
    let mut edges = Vec::new();
    for (solid, bounds) in solids.iter().enumerate() {
        for side in [Side::Top, Side::Bottom, Side::Left, Side::Right] {
            let at = match side {
                Side::Top => bounds.min.y,
                Side::Bottom => bounds.max.y,
                Side::Left => bounds.min.x,
                Side::Right => bounds.max.x,
            };
            let level_edge = match side {
                Side::Top | Side::Left => at <= TOUCH,
                Side::Bottom => at >= level.y - TOUCH,
                Side::Right => at >= level.x - TOUCH,
            };
            if level_edge {
                continue;
            }
            let covers = |other: &Aabb| match side {
                Side::Top => other.min.y < at - TOUCH && other.max.y >= at - TOUCH,
                Side::Bottom => other.min.y <= at + TOUCH && other.max.y > at + TOUCH,
                Side::Left => other.min.x < at - TOUCH && other.max.x >= at - TOUCH,
                Side::Right => other.min.x <= at + TOUCH && other.max.x > at + TOUCH,
            };
            let lies = matches!(side, Side::Top | Side::Bottom);
            let span = |b: &Aabb| if lies { (b.min.x, b.max.x) } else { (b.min.y, b.max.y) };
            let point = |along: f64| if lies { DVec2::new(along, at) } else { DVec2::new(at, along) };
            let covered = solids.iter().enumerate().filter(|(i, o)| *i != solid && covers(o)).map(|(_, o)| span(o)).collect();
            edges.extend(open(span(bounds), covered).into_iter().map(|(a, b)| Edge { solid, side, from: point(a), to: point(b) }));
        }
    }
    edges
}

/// What is left of a span when others are taken out of it.
fn open(span: (f64, f64), mut covered: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    covered.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut left = Vec::new();
    let mut from = span.0;
    for (start, end) in covered {
        if start > from + TOUCH {
            left.push((from, start.min(span.1)));
        }
        from = from.max(end);
        if from >= span.1 {
            return left;
        }
    }
    if span.1 > from + TOUCH {
        left.push((from, span.1));
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solid(x: f64, y: f64, width: f64, height: f64) -> Aabb {
        Aabb::new(DVec2::new(x, y), DVec2::new(x + width, y + height))
    }

    #[test]
    fn a_box_in_the_open_has_four_edges() {
        assert_eq!(open_edges(&[solid(2.0, 2.0, 3.0, 1.0)], DVec2::splat(10.0)).len(), 4);
    }

    #[test]
    fn what_adjoins_and_what_lies_on_the_level_edge_has_none() {
        // A floor of two parts with a post on the first.
        let solids = [solid(0.0, 9.0, 5.0, 1.0), solid(5.0, 9.0, 5.0, 1.0), solid(1.0, 7.0, 1.0, 2.0)];
        let edges = open_edges(&solids, DVec2::splat(10.0));
        let top: Vec<_> = edges.iter().filter(|e| e.side == Side::Top).map(|e| (e.solid, e.from.x, e.to.x)).collect();
        assert_eq!(top, [(0, 0.0, 1.0), (0, 2.0, 5.0), (1, 5.0, 10.0), (2, 1.0, 2.0)]);
        assert!(!edges.iter().any(|e| e.solid < 2 && e.side != Side::Top));
        assert!(!edges.iter().any(|e| e.solid == 2 && e.side == Side::Bottom));
    }

    #[test]
    fn an_edge_inside_a_larger_solid_is_not_open() {
        let edges = open_edges(&[solid(1.0, 1.0, 8.0, 8.0), solid(3.0, 3.0, 2.0, 2.0)], DVec2::splat(10.0));
        assert!(edges.iter().all(|e| e.solid == 0), "{edges:?}");
    }
}
