//! Light on the edges of the rock: the lit stretches and their brightness. Plain geometry in metres, y down.
//!
//! The ink of a level: its rock and its paper share one tint, by which a player knows the level again.
//!
//! Rounded outer corners of rock, in the drawing alone: what collides is the box.

use super::ROCK;
use super::silhouette::{Corner, RockEdge};
use crate::draw::layout::Vec2;
use crate::draw::{Colour, Quads};
use crate::level::{Landscape, Level};
use crate::number::hash;
use crate::physics::{Aabb, DVec2};
use crate::view::camera::Viewport;
use crate::view::sky::WorldPalette;
use crate::view::theme;
use std::f64::consts::FRAC_PI_2;

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

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tint {
    pub rock: Colour,
    /// The rock on a map of the level, without edges.
    pub map: Colour,
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
}

impl Tint {
    /// Of a level's world; without one by its name: numbered levels take the inks in turn, others a hash of the name.
    pub fn of(landscape: Option<Landscape>, name: &str) -> Self {
        match landscape.map(WorldPalette::of) {
            Some(palette) if !theme::is_plain() => Self::from_world(&palette),
            _ => Self::from_name(name),
        }
    }

    fn from_world(palette: &WorldPalette) -> Self {
        let WorldPalette { sky, ink, rock, rim, light, .. } = *palette;
        Self {
            rock,
            map: sky[1].mixed(ink, 0.69),
            edge: ink.mixed(Colour::WHITE, 0.12),
            rim: Some((rim, light)),
            ink,
            fine: ink.faded(0.05),
            heavy: ink.faded(0.11),
        }
    }

    fn from_name(name: &str) -> Self {
        let number: usize = name.parse().unwrap_or_else(|_| hash(name) as usize);
        Self::from_ink(INKS[number.wrapping_sub(1) % INKS.len()])
    }

    fn from_ink(ink: Colour) -> Self {
        Self {
            rock: theme::ground().mixed(ink, 0.17),
            map: theme::ground().mixed(ink, 0.64),
            edge: ink.mixed(Colour::WHITE, 0.12),
            rim: None,
            ink,
            fine: theme::ground().mixed(ink, 0.065),
            heavy: theme::ground().mixed(ink, 0.14),
        }
    }
}

/// m.
const RADIUS: f64 = 0.25;
const STEPS: u32 = 5;

/// An outer corner of rock before open sky.
#[derive(Clone, Copy, Debug)]
pub struct RockCorner {
    /// m.
    at: DVec2,
    /// The unit vector along the edge that ends here; the next one runs along `inward`.
    along: DVec2,
    inward: DVec2,
}

/// The corners with room for the radius on both edges. A corner in a liquid, a stream or a mechanism keeps its box's shape.
pub fn corners(edges: &[RockEdge], level: &Level) -> Vec<RockCorner> {
    let taken: Vec<Aabb> = (level.fluids.iter().map(|fluid| fluid.zone))
        .chain(level.streams.iter().flat_map(|stream| [stream.zone, stream.source]))
        .chain(level.doors.iter().map(|door| door.bounds))
        .chain(level.movers.iter().map(|mover| mover.solid.bounds))
        .chain(level.world.iter().filter(|solid| !solid.is_rock()).map(|solid| solid.bounds))
        .chain(level.switches.iter().map(|switch| switch.bounds))
        .chain(level.objectives.iter().map(|objective| objective.bounds))
        .chain(level.obstacles.iter().copied())
        .collect();
    let long = |edge: &RockEdge| edge.kind == ROCK && edge.length() >= 2.0 * RADIUS && edge.depth >= RADIUS;
    let rounded = edges.iter().filter(|edge| edge.corners[1] == Corner::Outer && long(edge)).filter(|edge| {
        let goes_on = |next: &&RockEdge| next.from == edge.to && next.inward == -edge.along() && long(next);
        edges.iter().any(|next| goes_on(&next))
            && taken.iter().all(|other| !Aabb::around(edge.to, DVec2::ZERO).touches(other, RADIUS))
    });
    rounded.map(|edge| RockCorner { at: edge.to, along: edge.along(), inward: edge.inward }).collect()
}

/// Covers the tip of each corner in view with the colour of the sky behind it and draws the edge round it.
pub fn draw(
    corners: &[RockCorner],
    view: &Viewport,
    quads: &mut Quads,
    sky: impl Fn(Vec2) -> Colour,
    edge: impl Fn(DVec2) -> Colour,
) {
    let visible = view.visible();
    for RockCorner { at, along, inward } in
        corners.iter().filter(|corner| visible.contains(&Aabb::around(corner.at, DVec2::ZERO), 0.0))
    {
        let centre = *at + (*inward - *along) * RADIUS;
        let out = |step: u32| {
            let (sin, cos) = (f64::from(step) / f64::from(STEPS) * FRAC_PI_2).sin_cos();
            *along * sin - *inward * cos
        };
        let tip = view.point(*at);
        let behind = sky(tip);
        for step in 0..STEPS {
            let [a, b] = [step, step + 1].map(|step| view.point(centre + out(step) * RADIUS));
            quads.triangle([tip, a, b], behind);
            let colour = edge(-(out(step) + out(step + 1)) * 0.5);
            let inner = [step, step + 1].map(|step| view.point(centre + out(step) * RADIUS) - out(step).as_vec2() * 2.5);
            quads.quad([a, b, inner[1], inner[0]], [colour; 4]);
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
        assert_eq!(Tint::of(None, "0").rock.a, 1.0);
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
        let worlds = Landscape::ALL.map(WorldPalette::of);
        let worlds = worlds.iter().flat_map(|palette| palette.sky.map(|sky| (Tint::from_world(palette), sky)));
        for (tint, sky) in plain.into_iter().chain(worlds) {
            assert!(contrast(theme::text(), tint.rock) > 7.0);
            assert!(contrast(tint.map, sky) > 3.0, "a card");
            assert!(contrast(tint.edge, sky) > 4.5 && contrast(tint.edge, tint.rock) > 3.0);
        }
    }
}
