//! Light on the edges of the rock: the lit stretches and their brightness. Plain geometry in metres, y down.
//!
//! The ink of a level: its rock and its paper share one tint, by which a player knows the level again.

use super::silhouette::RockEdge;
use crate::draw::Colour;
use crate::level::Landscape;
use crate::number::hash;
use crate::physics::{Aabb, DVec2};
use crate::view::sky::WorldPalette;
use crate::view::theme;

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

/// The inks, pale and calm: none is near a colour with a meaning (objectives, hazards, forces are all far more vivid).
const INKS: [Colour; 8] = [
    Colour::hex(0x8FA8CC),
    Colour::hex(0x86B8B4),
    Colour::hex(0xA9A0CF),
    Colour::hex(0xB9AE94),
    Colour::hex(0x9DB48E),
    Colour::hex(0xC09FA6),
    Colour::hex(0x8DB3C9),
    Colour::hex(0xA8AAB4),
];

/// The height of a strip of rock in a far view, m.
const STRIP: f64 = 2.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tint {
    /// The rock at its edge, and deep inside.
    pub lit: Colour,
    pub deep: Colour,
    /// The world whose face the rock has.
    pub world: Option<Landscape>,
    /// The rock's edge in the light.
    pub edge: Colour,
    /// The light of the level's world on edges that face it, and the unit vector towards it, y down.
    pub rim: Option<(Colour, DVec2)>,
    /// Hatching and dimension lines.
    pub ink: Colour,
    /// Line of the paper every metre.
    pub fine: Colour,
    /// Line of the paper every ten metres.
    pub heavy: Colour,
    /// The height of a level whose worlds lie in storeys, m.
    pub storeys: Option<f64>,
}

impl Tint {
    /// Of a level's world; without one by its name: numbered levels take the inks in turn, others a hash of the name.
    pub fn of(landscape: Option<Landscape>, name: &str) -> Self {
        match landscape {
            Some(world) if !theme::is_plain() => Self::from_world(world),
            _ => Self::from_name(name),
        }
    }

    fn from_world(world: Landscape) -> Self {
        let WorldPalette { ink, rock: [lit, deep], rim, light, .. } = WorldPalette::of(world);
        Self {
            lit,
            deep,
            world: Some(world),
            edge: ink.mixed(Colour::WHITE, 0.12),
            rim: Some((rim, light)),
            ink,
            fine: ink.faded(0.05),
            heavy: ink.faded(0.05),
            storeys: None,
        }
    }

    /// The tint at a height, m from the level's top.
    pub fn at(&self, y: f64) -> Self {
        let Some(height) = self.storeys else { return *self };
        let (above, below, t) = WorldPalette::storeys(y / height);
        let mixed = |of: fn(&WorldPalette) -> Colour| of(&above).mixed(of(&below), t);
        let ink = mixed(|world| world.ink);
        let rim = self.rim.map(|(_, towards)| (mixed(|world| world.rim), towards));
        Self {
            lit: mixed(|world| world.rock[0]),
            deep: mixed(|world| world.rock[1]),
            edge: ink.mixed(Colour::WHITE, 0.12),
            rim,
            ink,
            ..*self
        }
    }

    /// A box of rock in strips of about one tint.
    pub fn strips(&self, bounds: &Aabb) -> impl Iterator<Item = Aabb> + use<> {
        let count = if self.storeys.is_some() { (bounds.size().y / STRIP).ceil().max(1.0) } else { 1.0 };
        let (min, step) = (bounds.min, DVec2::new(0.0, bounds.size().y / count));
        let size = DVec2::new(bounds.size().x, step.y);
        (0..count as u32).map(move |i| Aabb::new(min + step * f64::from(i), min + step * f64::from(i) + size))
    }

    fn from_name(name: &str) -> Self {
        let number: usize = name.parse().unwrap_or_else(|_| hash(name) as usize);
        Self::from_ink(INKS[number.wrapping_sub(1) % INKS.len()])
    }

    fn from_ink(ink: Colour) -> Self {
        Self {
            lit: theme::ground().mixed(ink, if theme::is_plain() { 0.17 } else { 0.24 }),
            deep: theme::ground().mixed(ink, if theme::is_plain() { 0.17 } else { 0.09 }),
            world: None,
            edge: ink.mixed(Colour::WHITE, 0.12),
            rim: None,
            ink,
            fine: theme::ground().mixed(ink, 0.065),
            heavy: theme::ground().mixed(ink, 0.14),
            storeys: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbered_levels_take_turns_and_a_name_keeps_its_tint() {
        let first: Vec<Tint> = (1..=INKS.len()).map(|i| Tint::of(None, &i.to_string())).collect();
        for (i, tint) in first.iter().enumerate() {
            assert!(!first[..i].contains(tint), "level {} looks like one before it", i + 1);
        }
        assert_eq!(Tint::of(None, "9"), Tint::of(None, "1"));
        assert_eq!(Tint::of(None, "my-level"), Tint::of(None, "my-level"));
        assert_eq!(Tint::of(None, "0").deep.a, 1.0);
    }

    #[test]
    fn words_on_rock_and_its_edge_against_the_air_are_easy_to_see() {
        // Contrast after WCAG 2: (brighter + 0.05) / (darker + 0.05) of relative luminances; words want 4.5, shapes 3.
        let luminance = |c: Colour| {
            let linear = |v: f32| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
            0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b)
        };
        let contrast = |a: Colour, b: Colour| {
            let (a, b) = (luminance(a), luminance(b));
            (a.max(b) + 0.05) / (a.min(b) + 0.05)
        };
        let plain = INKS.map(|ink| (Tint::from_ink(ink), theme::ground()));
        let worlds = Landscape::ALL.iter().flat_map(|world| {
            WorldPalette::of(*world).sky.iter().map(|(_, sky)| (Tint::from_world(*world), *sky)).collect::<Vec<_>>()
        });
        for (tint, sky) in plain.into_iter().chain(worlds) {
            assert!(contrast(theme::text(), tint.lit) > 4.6);
            assert!(contrast(tint.edge, sky) > 2.4 && contrast(tint.edge, tint.lit) > 3.0, "{:?}", tint.world);
        }
    }
}
