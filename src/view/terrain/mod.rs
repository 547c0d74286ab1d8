//! The solid world: one silhouette with a drafted edge, made once a level, in metres and without a window ([`silhouette`],
//! [`light`], and here the drafting on the rock: hatching along its edge, and dimension lines); [`Terrain`] draws the part in view.

pub mod light;
pub mod silhouette;
mod sweep;

mod paint;

pub use light::Tint;
pub use paint::{Terrain, material_edge};

use crate::level::Level;
use crate::physics::{Aabb, DVec2, Material};
use silhouette::{Corner, RockEdge, Silhouette};
use std::collections::BTreeSet;

/// The index of a material in [`Material::ALL`], which is the kind of its silhouettes.
pub fn kind(name: &str) -> usize {
    Material::ALL.iter().position(|material| material.name == name).unwrap_or(ROCK)
}

/// The kind of plain rock: Asphalt, also round every level.
pub const ROCK: usize = 0;
/// Thickness of the rock round a level, m.
const RIM: f64 = 32.0;

/// The solid world of a level with the rock round it, which is its edge, and with the sources of its streams, which are drawn over it: rock has no
/// edge against them. Movers, doors, fragile and one-way blocks are left out. The far side of the outer rock has no edge.
pub fn mass(level: &Level) -> Silhouette {
    let all = level.bounds();
    let inside = |bounds: &Aabb| Aabb::new(bounds.min.max(all.min), bounds.max.min(all.max));
    let solids = level.world.iter().filter(|solid| solid.is_rock()).map(|solid| (inside(&solid.bounds), kind(solid.material.name)));
    let sources = level.streams.iter().map(|stream| (inside(&stream.source), ROCK));
    let rim = frame(&Aabb::new(all.min - RIM, all.max + RIM), &all);
    let mut mass = Silhouette::new(&rim.into_iter().map(|bounds| (bounds, ROCK)).chain(solids).chain(sources).collect::<Vec<_>>());
    mass.edges.retain(|edge| edge.bounds().touches(&all, 0.0));
    mass
}

/// A box but for one inside it: above, below, left and right of that.
fn frame(outer: &Aabb, inner: &Aabb) -> [Aabb; 4] {
    let (a, b, c, d) = (outer.min, inner.min, inner.max, outer.max);
    let piece = |left, top, right, bottom| Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom));
    [piece(a.x, a.y, d.x, b.y), piece(a.x, c.y, d.x, d.y), piece(a.x, b.y, b.x, c.y), piece(c.x, b.y, d.x, c.y)]
}

/// The parts of a box inside the mass, without overlap.
pub fn parts(mass: &Silhouette, within: &Aabb) -> impl Iterator<Item = Aabb> {
    let pieces = mass.pieces().map(|(piece, _)| piece).filter(move |piece| piece.overlaps(within, 0.0));
    pieces.map(move |piece| Aabb::new(piece.min.max(within.min), piece.max.min(within.max)))
}

/// Between two strokes, along an edge, m.
const STEP: f64 = 0.9;
/// The least length of a stroke, and the most that it is longer, m.
const SHORTEST: f64 = 0.5;
const LONGER: f64 = 0.9;
/// Shorter strokes are left out, m: they would be dots.
const LEAST: f64 = 0.2;
/// The most strokes of a level: in a very large one they stand further apart.
const MOST_STROKES: f64 = 40_000.0;
/// The least and the greatest length with a dimension line, m: a shorter one has no room for its number, a longer one leaves the window.
const MEASURED: (f64, f64) = (3.0, 36.0);
/// Depth of a dimension line in the rock, and the rock that it needs above and below it, m.
const DEEP: f64 = 1.5;
const ROOM: f64 = 0.6;
/// Size of the cells with at most one dimension line, m; further ones would be noise.
const CELL: DVec2 = DVec2::new(14.0, 9.0);
/// The most dimension lines of a level.
const MOST_DIMENSIONS: usize = 400;

/// A dimension line in the rock, parallel to the measured edge; lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimension {
    /// The left or upper end.
    pub from: DVec2,
    pub to: DVec2,
    /// From the line to the measured edge, at right angles, m.
    pub to_edge: DVec2,
}

impl Dimension {
    /// m.
    pub fn length(&self) -> f64 {
        (self.to - self.from).length()
    }

    /// The box of the line and its number, m.
    pub fn bounds(&self) -> Aabb {
        let ends = Aabb::new(self.from.min(self.to), self.from.max(self.to));
        let edge = self.to_edge.abs().normalize_or_zero() * ROOM;
        Aabb::new(ends.min - edge, ends.max + edge)
    }
}

/// Strokes at 45° from all edges of a kind into the rock, m, on lines through the whole level. None leaves its kind or meets one from the other side.
pub fn hatching(mass: &Silhouette, kind: usize) -> Vec<(DVec2, DVec2)> {
    let edges = || mass.edges.iter().filter(move |edge| edge.kind == kind);
    let step = STEP.max(edges().map(RockEdge::length).sum::<f64>() / MOST_STROKES);
    let mut strokes = Vec::new();
    for edge in edges() {
        // Up to the right, or down to the left where that leads inwards.
        let up = DVec2::new(std::f64::consts::FRAC_1_SQRT_2, -std::f64::consts::FRAC_1_SQRT_2);
        let way = if up.dot(edge.inward) > 0.0 { up } else { -up };
        let (low, high) = (edge.from.element_sum().min(edge.to.element_sum()), edge.from.element_sum().max(edge.to.element_sum()));
        for line in (low / step).ceil() as i64..=(high / step).floor() as i64 {
            let along = (line as f64 * step - edge.from.element_sum()).abs();
            let from = edge.from + edge.along() * along.min(edge.length());
            let wanted = SHORTEST + LONGER * chance(line, edge.inward);
            let length = wanted.min(mass.reach(kind, (from, way), 2.0 * wanted) / 2.0);
            if length >= LEAST {
                strokes.push((from, from + way * length));
            }
        }
    }
    strokes
}

/// A hash from 0 to 1 of a line of the hatching on a side, the same on every run.
pub fn chance(line: i64, side: DVec2) -> f64 {
    let side = (side.x * 3.0 + side.y) as i64;
    let mut bits = line.wrapping_mul(4).wrapping_add(side.wrapping_mul(7919)) as u64;
    bits = (bits ^ (bits >> 31)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    bits = (bits ^ (bits >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    ((bits >> 40) as f64) / f64::from(1 << 24)
}

/// Dimension lines beneath edges of rock; none covers another or a box of `taken`.
pub fn dimensions(mass: &Silhouette, kind: usize, taken: &[Aabb]) -> Vec<Dimension> {
    let mut cells = BTreeSet::new();
    let mut found: Vec<Dimension> = Vec::new();
    // Whole sides only: a part that ends at another kind is no length that a builder would ask for.
    let whole = |edge: &&RockEdge| edge.corners.iter().all(|corner| *corner != Corner::Straight);
    for edge in mass.edges.iter().filter(|edge| edge.kind == kind).filter(whole) {
        if !(MEASURED.0..=MEASURED.1).contains(&edge.length()) || edge.depth < DEEP + ROOM || found.len() >= MOST_DIMENSIONS {
            continue;
        }
        let (from, to) = (edge.from.min(edge.to), edge.from.max(edge.to));
        let line = Dimension { from: from + edge.inward * DEEP, to: to + edge.inward * DEEP, to_edge: -edge.inward * DEEP };
        let bounds = line.bounds();
        let cell = ((from + to) * 0.5 / CELL).floor();
        let apart = |other: &Aabb| !other.touches(&bounds, 0.2);
        let fits = mass.holds(&bounds, kind)
            && taken.iter().all(apart)
            && found.iter().all(|other| apart(&other.bounds()))
            && cells.insert((cell.x as i64, cell.y as i64));
        if fits {
            found.push(line);
        }
    }
    found
}
