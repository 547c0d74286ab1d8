//! Light on the edges of the rock: the lit stretches and their brightness. Plain geometry in metres, y down.

use super::silhouette::RockEdge;
use crate::physics::{Aabb, DVec2};

/// Length of the pieces of a lit edge, m: between their ends the light changes evenly.
const PIECE: f64 = 0.5;
/// Weaker light is left out, of 1.
const FAINTEST: f32 = 0.01;
/// Rays begin this far off the edge, m: a box on the edge does not shade it.
const OFF: f64 = 0.02;

/// A stretch of an edge with light on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lit {
    /// m.
    pub from: DVec2,
    /// m.
    pub to: DVec2,
    /// The unit vector into the rock.
    pub inward: DVec2,
    /// The greatest depth of the light in the rock, m.
    pub depth: f64,
    /// The light at both ends, 0 … 1.
    pub strength: [f32; 2],
}

/// The light of a glowing box (a point, where it has no size) on the edges that face it, up to `reach` (m) away, past `opaque`
/// boxes.
pub fn cast(edges: &[RockEdge], source: &Aabb, reach: f64, opaque: &[Aabb]) -> Vec<Lit> {
    let lit_space = Aabb::new(source.min - reach, source.max + reach);
    let shading: Vec<&Aabb> = opaque.iter().filter(|solid| solid.touches(&lit_space, 0.0)).collect();
    let mut lit = Vec::new();
    for edge in edges.iter().filter(|edge| edge.bounds().touches(&lit_space, 0.0)) {
        let along = edge.along();
        // Only the part within reach is cut into pieces: an edge may be as long as the level.
        let near = |corner: DVec2| (corner - edge.from).dot(along);
        let (a, b) = (near(lit_space.min), near(lit_space.max));
        let (from, to) = (a.min(b).clamp(0.0, edge.length()), a.max(b).clamp(0.0, edge.length()));
        let pieces = ((to - from) / PIECE).ceil().max(1.0);
        let at = |i: f64| edge.from + along * (from + (to - from) * i / pieces);
        let mut before = (at(0.0), strength(at(0.0), edge.inward, source, reach, &shading));
        for i in 1..=pieces as usize {
            let after = (at(i as f64), strength(at(i as f64), edge.inward, source, reach, &shading));
            if before.1.max(after.1) > FAINTEST {
                let strength = [before.1, after.1];
                lit.push(Lit { from: before.0, to: after.0, inward: edge.inward, depth: edge.depth, strength });
            }
            before = after;
        }
    }
    lit
}

/// The light at a point of an edge: it falls off to nothing at the reach, and with the angle of incidence.
fn strength(at: DVec2, inward: DVec2, source: &Aabb, reach: f64, opaque: &[&Aabb]) -> f32 {
    let at = at - inward * OFF;
    let nearest = at.clamp(source.min, source.max);
    let distance = (nearest - at).length();
    if distance >= reach {
        return 0.0;
    }
    // The ray comes from half the height of the box over the edge: a lamp on a floor also lights the floor beside it.
    let from = if inward.x == 0.0 { DVec2::new(nearest.x, source.centre().y) } else { DVec2::new(source.centre().x, nearest.y) };
    let facing = (-inward).dot((from - at).normalize_or_zero());
    if facing <= 0.0 || opaque.iter().any(|solid| crosses(at, from, solid)) {
        return 0.0;
    }
    let fall = 1.0 - distance / reach;
    (fall * fall * facing.sqrt()) as f32
}

/// Whether the straight path between two points leads through a box.
fn crosses(from: DVec2, to: DVec2, solid: &Aabb) -> bool {
    let way = to - from;
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for (start, step, low, high) in [(from.x, way.x, solid.min.x, solid.max.x), (from.y, way.y, solid.min.y, solid.max.y)] {
        if step == 0.0 {
            if start <= low || start >= high {
                return false;
            }
        } else {
            let (a, b) = ((low - start) / step, (high - start) / step);
            enters = enters.max(a.min(b));
            leaves = leaves.min(a.max(b));
        }
    }
    // A box does not hide a light that touches it or is inside of it.
    leaves - enters > 1e-9 && enters < 1.0 - 1e-6
}
