//! The drafting on the rock: hatching along its edge, dimension lines, crosses where the heavy lines of the paper would meet. Plain
//! geometry in metres, y down.

use super::silhouette::{Corner, RockEdge, Silhouette};
use crate::physics::{Aabb, DVec2};
use std::collections::BTreeSet;

/// Between two strokes, along an edge, m.
const STEP: f64 = 0.6;
/// The least length of a stroke, and the most that it is longer, m.
const SHORTEST: f64 = 0.5;
const LONGER: f64 = 0.9;
/// Shorter strokes are left out, m: they would be dots.
const LEAST: f64 = 0.2;
/// The most strokes of a level: in a very large one they stand further apart.
const MOST_STROKES: f64 = 40_000.0;
/// Spacing of grains along an edge and their greatest depth, m; the most grains of a level.
const GRAIN_STEP: f64 = 0.3;
const GRAIN_DEPTH: f64 = 0.42;
const MOST_GRAINS: f64 = 80_000.0;
/// The least and the greatest length with a dimension line, m: a shorter one has no room for its number, a longer one leaves the
/// window.
const MEASURED: (f64, f64) = (3.0, 36.0);
/// Depth of a dimension line in the rock, and the rock that it needs above and below it, m.
const DEEP: f64 = 1.5;
const ROOM: f64 = 0.6;
/// Size of the cells with at most one dimension line, m; further ones would be noise.
const CELL: DVec2 = DVec2::new(14.0, 9.0);
/// The most dimension lines of a level.
const MOST_DIMENSIONS: usize = 400;
/// Spacing of crosses, m: the heavy lines of the paper. A level with more than the most crosses has none.
const CROSSES: f64 = 10.0;
const MOST_CROSSES: f64 = 10_000.0;
/// The least rock round a cross, m.
const CROSS_ROOM: f64 = 1.5;

/// A stroke of the hatching: opaque at its beginning on the edge, transparent at its end in the rock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HatchStroke {
    /// m.
    pub from: DVec2,
    /// m.
    pub to: DVec2,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grain {
    /// m.
    pub at: DVec2,
    /// 0 … 1.
    pub size: f64,
}

/// A dimension line in the rock, parallel to the measured edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimension {
    /// Its ends, m, the left or upper one first.
    pub from: DVec2,
    /// m.
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

/// The hatching along all edges of a kind: strokes at 45°, on lines that run through the whole level. No stroke leaves its kind,
/// and strokes from opposite sides do not meet.
pub fn hatching(mass: &Silhouette, kind: usize) -> Vec<HatchStroke> {
    let edges = || mass.edges().iter().filter(move |edge| edge.kind == kind);
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
            let room = mass.reach(kind, (from, way), 2.0 * wanted);
            let length = wanted.min(room / 2.0);
            if length >= LEAST {
                strokes.push(HatchStroke { from, to: from + way * length });
            }
        }
    }
    strokes
}

/// The grain of stone along all edges of a kind, inside that kind and thinner with depth.
pub fn grains(mass: &Silhouette, kind: usize) -> Vec<Grain> {
    let edges = || mass.edges().iter().filter(move |edge| edge.kind == kind && edge.depth > GRAIN_DEPTH);
    let step = GRAIN_STEP.max(edges().map(RockEdge::length).sum::<f64>() / MOST_GRAINS);
    let mut grains = Vec::new();
    for edge in edges() {
        for i in 0..(edge.length() / step) as i64 {
            let place = (edge.from + edge.to).element_sum() * 16.0;
            let random = |salt: i64| chance(i * 3 + salt, edge.inward + DVec2::X * place);
            let (along, deep) = ((i as f64 + random(0)) * step, 0.12 + (GRAIN_DEPTH - 0.12) * random(1) * random(1));
            grains.push(Grain { at: edge.from + edge.along() * along + edge.inward * deep, size: random(2) });
        }
    }
    // No grain lies in blocks of other kinds behind the edge.
    grains.retain(|grain| mass.holds(&Aabb::around(grain.at, DVec2::splat(0.05)), kind));
    grains
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
    for edge in mass.edges().iter().filter(|edge| edge.kind == kind).filter(whole) {
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

/// The crosses of the paper's heavy lines inside the rock of a level of that size (m), clear of `taken`.
pub fn crosses(mass: &Silhouette, kind: usize, size: DVec2, taken: &[Aabb]) -> Vec<DVec2> {
    let count = (size / CROSSES).floor();
    if (count.x + 1.0) * (count.y + 1.0) > MOST_CROSSES {
        return Vec::new();
    }
    let mut found = Vec::new();
    for row in 0..=count.y as i64 {
        for column in 0..=count.x as i64 {
            let at = DVec2::new(column as f64, row as f64) * CROSSES;
            let room = Aabb::around(at, DVec2::splat(CROSS_ROOM));
            if mass.holds(&room, kind) && taken.iter().all(|other| !other.touches(&room, 0.0)) {
                found.push(at);
            }
        }
    }
    found
}
