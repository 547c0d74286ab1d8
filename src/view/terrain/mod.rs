//! The solid world: one silhouette with a drafted edge, made once a level, in metres and without a window ([`silhouette`],
//! [`drafting`], [`light`]); [`Terrain`] draws the part in view.

pub mod drafting;
pub mod light;
pub mod silhouette;
mod sweep;

mod paint;

pub use light::Tint;
pub use paint::{Terrain, material_edge};

use crate::level::Level;
use crate::physics::{Aabb, DVec2, Material};
use silhouette::Silhouette;

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
    let boxes: Vec<(Aabb, usize)> = rim.into_iter().map(|bounds| (bounds, ROCK)).chain(solids).chain(sources).collect();
    let mut mass = Silhouette::new(&boxes);
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
