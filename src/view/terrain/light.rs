//! Light on the edges of the rock and in the air along it: meshes of vertex colours, finer where the light bends, made piece by piece as they come
//! into view; metres, y down. A level's ink: its rock and its paper share one tint, by which a player knows the level again.

use super::ROCK;
use super::silhouette::{RockEdge, Silhouette};
use crate::draw::{Colour, Quad, layout::Vec2};
use crate::physics::{Aabb, DVec2};
use crate::view::{art::rock::FACE_METRES, camera::Viewport, particles::stretch, sky::WorldPalette, theme};
use crate::{level::Landscape, number::hash};
use std::{cell::RefCell, collections::BTreeMap};

/// Length of the pieces of a lit edge, m: between their ends the light changes evenly.
const PIECE: f64 = 0.5;
/// Weaker light is left out, of 1.
const FAINTEST: f32 = 0.01;
/// Rays begin this far off the edge, m: a box on the edge does not shade it.
const OFF: f64 = 0.02;

/// A stretch of an edge with light on it; lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lit {
    pub from: DVec2,
    pub to: DVec2,
    /// The unit vector into the rock.
    pub inward: DVec2,
    /// The greatest depth of the light in the rock.
    pub depth: f64,
    /// The light at both ends, 0 … 1.
    pub strength: [f32; 2],
}

/// The light of a glowing box (a point, where it has no size) on the edges that face it, up to `reach` (m) away, past `opaque` boxes.
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
    let Some((enters, leaves, _)) = stretch(solid, from, to - from) else { return false };
    // A box does not hide a light that touches it or is inside of it.
    leaves.min(1.0) - enters.max(0.0) > 1e-9 && enters < 1.0 - 1e-6
}

/// The inks, pale and calm: none is near a colour with a meaning (objectives, hazards, forces are all far more vivid).
const INKS: [u32; 8] = [0x8FA8CC, 0x86B8B4, 0xA9A0CF, 0xB9AE94, 0x9DB48E, 0xC09FA6, 0x8DB3C9, 0xA8AAB4];

/// The height of a strip of rock in a far view, m.
const STRIP: f64 = 2.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tint {
    /// The rock at its edge, and deep inside.
    pub lit: Colour,
    pub deep: Colour,
    /// The world whose face the rock has.
    pub world: Option<Landscape>,
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
            _ => {
                let number: usize = name.parse().unwrap_or_else(|_| hash(name) as usize);
                Self::from_ink(Colour::hex(INKS[number.wrapping_sub(1) % INKS.len()]))
            }
        }
    }

    fn from_world(world: Landscape) -> Self {
        let WorldPalette { ink, rock: [lit, deep], rim, light, .. } = WorldPalette::of(world);
        let (faint, rim) = (ink.faded(0.05), Some((rim, light)));
        Self { lit, deep, world: Some(world), rim, fine: faint, heavy: faint, ..Self::from_ink(ink) }
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

/// Width and height of a piece of the mesh, m: a whole part of [`FACE_METRES`].
const MESH: f64 = 8.0;
/// The largest cell, and the smallest at a usual scale and in a far view, m.
const LARGEST: f64 = 2.0;
const SMALLEST: [f64; 2] = [0.25, 1.0];
/// Views of fewer canvas units a metre are far, and very far: these show each rock in one tone.
const FAR: f64 = 13.0;
const VERY_FAR: f64 = 8.0;
/// A cell is cut where its middle is off the mean of its corners by more than this, of 1.
const UNEVEN: f32 = 0.02;
/// Depth of the first light, and from there to the deep tone, m; the power of its fall.
const LIT_FROM: f64 = 0.35;
const FALL: f64 = 4.65;
const POWER: f32 = 2.6;
/// The share of the lit tone that stays in the deep.
const LEAST: f32 = 0.05;
/// The share of the rim's colour on an edge that faces the light, and the depth in which it falls to 1/e, m.
const RIM: f64 = 0.30;
const RIM_DEPTH: f64 = 0.4;
/// Opacity of the shade on an edge, and its width in the air, m.
const SHADE: f64 = 0.58;
const SHADE_WIDTH: f64 = 1.7;

/// A box with the colours of its corners, in order round from the top left.
type RockCell = (Aabb, [Colour; 4]);
/// By scale and place: the cells of the rock, and those of the air.
type Pieces = BTreeMap<(usize, i64, i64), [Vec<RockCell>; 2]>;

/// The mesh of one level, as far as it has been in view.
#[derive(Default)]
pub struct RockMesh(RefCell<Pieces>);

impl RockMesh {
    /// The cells in view, of the rock or of the `air`, each with its places in the rock's face.
    pub fn show(&self, air: bool, mass: &Silhouette, open: &[Aabb], tint: &Tint, view: &Viewport) -> Vec<(Quad, [Vec2; 4])> {
        let (visible, far) = (view.visible(), usize::from(view.scale < FAR));
        let mut pieces = self.0.borrow_mut();
        let mut shown = Vec::new();
        let range = |low: f64, high: f64| (low / MESH).floor() as i64..(high / MESH).ceil() as i64;
        for i in range(visible.min.x, visible.max.x) {
            for j in range(visible.min.y, visible.max.y) {
                let cells = pieces.entry((far, i, j)).or_insert_with(|| {
                    let min = DVec2::new(i as f64, j as f64) * MESH;
                    make(&Aabb::new(min, min + MESH), mass, open, tint, SMALLEST[far])
                });
                let corner = (DVec2::new(i as f64, j as f64) * MESH / FACE_METRES).floor() * FACE_METRES;
                for (bounds, colours) in cells[usize::from(air)].iter().filter(|(bounds, _)| bounds.overlaps(&visible, 0.0)) {
                    let part = Aabb::new((bounds.min - corner) / FACE_METRES, (bounds.max - corner) / FACE_METRES);
                    let places = corners(&part).map(|place| place.as_vec2());
                    shown.push((Quad { corners: view.rect(bounds).corners(), colours: *colours }, places));
                }
            }
        }
        shown
    }

    pub fn is_plain(view: &Viewport) -> bool {
        view.scale < VERY_FAR
    }
}

fn make(piece: &Aabb, mass: &Silhouette, open: &[Aabb], tint: &Tint, smallest: f64) -> [Vec<RockCell>; 2] {
    let near = Aabb::new(piece.min - LIT_FROM - FALL, piece.max + LIT_FROM + FALL);
    let edges: Vec<&RockEdge> = mass.edges.iter().filter(|edge| edge.bounds().touches(&near, 0.0)).collect();
    let away = |edge: &RockEdge, at: DVec2| at.distance(at.clamp(edge.from.min(edge.to), edge.from.max(edge.to)));
    let rock = |at: DVec2| {
        let (mut nearest, mut rim) = (f64::MAX, 0.0_f64);
        for edge in &edges {
            let distance = away(edge, at);
            nearest = nearest.min(distance);
            if let Some((_, towards)) = tint.rim {
                rim = rim.max(-edge.inward.dot(towards) * RIM * (-distance / RIM_DEPTH).exp());
            }
        }
        let fall = 1.0 - ((nearest - LIT_FROM) / FALL).clamp(0.0, 1.0) as f32;
        let tint = tint.at(at.y);
        let tone = tint.deep.mixed(tint.lit, LEAST + (1.0 - LEAST) * fall.powf(POWER));
        tint.rim.map_or(tone, |(colour, _)| tone.mixed(colour, rim as f32))
    };
    let shade = |at: DVec2| {
        let nearest = edges.iter().map(|edge| away(edge, at)).fold(SHADE_WIDTH, f64::min);
        Colour::new(0.0, 0.0, 0.0, (SHADE * (1.0 - nearest / SHADE_WIDTH).powi(2)) as f32)
    };
    let within = |bounds: &Aabb| Aabb::new(bounds.min.max(piece.min), bounds.max.min(piece.max));
    let mut cells = [Vec::new(), Vec::new()];
    for (bounds, _) in mass.pieces().filter(|(bounds, kind)| *kind == ROCK && bounds.overlaps(piece, 0.0)) {
        cut(&within(&bounds), &rock, smallest, &mut cells[0]);
    }
    if tint.rim.is_some() {
        for bounds in open.iter().filter(|bounds| bounds.overlaps(piece, 0.0)) {
            cut(&within(bounds), &shade, smallest.max(0.5), &mut cells[1]);
        }
        cells[1].retain(|(_, colours)| colours.iter().any(|colour| colour.a > 0.0));
    }
    cells
}

fn corners(bounds: &Aabb) -> [DVec2; 4] {
    let (a, b) = (bounds.min, bounds.max);
    [a, DVec2::new(b.x, a.y), b, DVec2::new(a.x, b.y)]
}

/// Cuts a box in halves until the colours run evenly in each part.
fn cut(bounds: &Aabb, light: &impl Fn(DVec2) -> Colour, smallest: f64, cells: &mut Vec<RockCell>) {
    let places = corners(bounds);
    let colours = places.map(light);
    let off = |i: usize, j: usize| {
        let (middle, [a, b]) = (light((places[i] + places[j]) * 0.5), [colours[i], colours[j]]);
        let off = |middle: f32, a: f32, b: f32| (middle - (a + b) * 0.5).abs();
        off(middle.r, a.r, b.r).max(off(middle.g, a.g, b.g)).max(off(middle.b, a.b, b.b)).max(off(middle.a, a.a, b.a))
    };
    let size = bounds.size();
    let inside = off(0, 2).max(off(1, 3));
    let (across, down) = (off(0, 1).max(off(3, 2)), off(0, 3).max(off(1, 2)));
    let wants = |off: f32, size: f64| size > LARGEST || size > smallest * 1.5 && off.max(inside * 0.5) > UNEVEN;
    let (by_x, by_y) = (wants(across, size.x), wants(down, size.y));
    let middle = bounds.centre();
    if by_x && (!by_y || across * size.x as f32 >= down * size.y as f32) {
        cut(&Aabb::new(bounds.min, DVec2::new(middle.x, bounds.max.y)), light, smallest, cells);
        cut(&Aabb::new(DVec2::new(middle.x, bounds.min.y), bounds.max), light, smallest, cells);
    } else if by_y {
        cut(&Aabb::new(bounds.min, DVec2::new(bounds.max.x, middle.y)), light, smallest, cells);
        cut(&Aabb::new(DVec2::new(bounds.min.x, middle.y), bounds.max), light, smallest, cells);
    } else {
        cells.push((*bounds, colours));
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
        let plain = INKS.map(|ink| (Tint::from_ink(Colour::hex(ink)), theme::ground()));
        let worlds = Landscape::ALL.iter().flat_map(|world| {
            WorldPalette::of(*world).sky.iter().map(|(_, sky)| (Tint::from_world(*world), *sky)).collect::<Vec<_>>()
        });
        for (tint, sky) in plain.into_iter().chain(worlds) {
            assert!(contrast(theme::text(), tint.lit) > 4.6);
            assert!(contrast(tint.edge, sky) > 2.4 && contrast(tint.edge, tint.lit) > 3.0, "{:?}", tint.world);
        }
    }
}
