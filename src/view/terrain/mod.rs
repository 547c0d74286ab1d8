//! The solid world: one silhouette with a drafted edge, made once a level, in metres and without a window ([`silhouette`],
//! [`drafting`], [`light`]); [`Terrain`] draws the part in view.

pub mod drafting;
pub mod light;
mod rock;
pub mod silhouette;
mod sweep;

mod paint;

pub use light::Tint;
pub use paint::{Lamp, Terrain, material_edge};

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

/// The solid world of a level with the rock round it, which is its edge, and with the sources of its streams, which are drawn over
/// it: rock has no edge against them. Movers, doors, fragile and one-way blocks are left out. The far side of the outer rock has no
/// edge.
pub fn mass(level: &Level) -> Silhouette {
    let (size, all) = (level.size, level.bounds());
    let inside = |bounds: &Aabb| Aabb::new(bounds.min.max(all.min), bounds.max.min(all.max));
    let solids = level.world.iter().filter(|solid| solid.is_rock()).map(|solid| (inside(&solid.bounds), kind(solid.material.name)));
    let sources = level.streams.iter().map(|stream| (inside(&stream.source), ROCK));
    let (low, high) = (DVec2::splat(-RIM), size + RIM);
    let rim = [
        Aabb::new(low, DVec2::new(high.x, 0.0)),
        Aabb::new(DVec2::new(low.x, size.y), high),
        Aabb::new(DVec2::new(low.x, 0.0), DVec2::new(0.0, size.y)),
        Aabb::new(DVec2::new(size.x, 0.0), DVec2::new(high.x, size.y)),
    ];
    let boxes: Vec<(Aabb, usize)> = rim.into_iter().map(|bounds| (bounds, ROCK)).chain(solids).chain(sources).collect();
    let mut mass = Silhouette::new(&boxes);
    mass.keep_edges(&all);
    mass
}

/// The parts of a box inside the mass, without overlap.
pub fn parts(mass: &Silhouette, within: &Aabb) -> impl Iterator<Item = Aabb> {
    let pieces = mass.pieces().map(|(piece, _)| piece).filter(move |piece| piece.overlaps(within, 0.0));
    pieces.map(move |piece| Aabb::new(piece.min.max(within.min), piece.max.min(within.max)))
}
