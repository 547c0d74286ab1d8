//! Light in rock and shade in the air along it: meshes of vertex colours, finer where the light bends, made piece by piece as they
//! come into view. Plain geometry in metres, y down.

use super::silhouette::{RockEdge, Silhouette};
use super::{ROCK, Tint};
use crate::draw::layout::Vec2;
use crate::draw::{Colour, Quad};
use crate::physics::{Aabb, DVec2};
use crate::view::art::rock::FACE_METRES;
use crate::view::camera::Viewport;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Width and height of a piece of the mesh, m: a whole part of [`FACE_METRES`].
const PIECE: f64 = 8.0;
/// The largest cell, and the smallest at a usual scale and in a far view, m.
const LARGEST: f64 = 2.0;
const SMALLEST: [f64; 2] = [0.25, 1.0];
/// Views of fewer canvas units a metre are far, and very far: these show each rock in one tone.
const FAR: f64 = 13.0;
const VERY_FAR: f64 = 8.0;
/// A cell is cut where its middle is off the mean of its corners by more than this, of 1.
const OFF: f32 = 0.02;
/// Depth of the first light, and from there to the deep tone, m; the power of its fall.
const LIT: f64 = 0.35;
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
pub struct RockMesh {
    pieces: RefCell<Pieces>,
}

impl RockMesh {
    /// The cells in view, of the rock or of the `air`, each with its places in the rock's face.
    pub fn show(&self, air: bool, mass: &Silhouette, open: &[Aabb], tint: &Tint, view: &Viewport) -> Vec<(Quad, [Vec2; 4])> {
        let (visible, far) = (view.visible(), usize::from(view.scale < FAR));
        let mut pieces = self.pieces.borrow_mut();
        let mut shown = Vec::new();
        let range = |low: f64, high: f64| (low / PIECE).floor() as i64..(high / PIECE).ceil() as i64;
        for i in range(visible.min.x, visible.max.x) {
            for j in range(visible.min.y, visible.max.y) {
                let cells = pieces.entry((far, i, j)).or_insert_with(|| {
                    let min = DVec2::new(i as f64, j as f64) * PIECE;
                    make(&Aabb::new(min, min + PIECE), mass, open, tint, SMALLEST[far])
                });
                let corner = (DVec2::new(i as f64, j as f64) * PIECE / FACE_METRES).floor() * FACE_METRES;
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

/// The cells of a piece: of the rock, and of the air.
fn make(piece: &Aabb, mass: &Silhouette, open: &[Aabb], tint: &Tint, smallest: f64) -> [Vec<RockCell>; 2] {
    let near = Aabb::new(piece.min - LIT - FALL, piece.max + LIT + FALL);
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
        let fall = 1.0 - ((nearest - LIT) / FALL).clamp(0.0, 1.0) as f32;
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
    let wants = |off: f32, size: f64| size > LARGEST || size > smallest * 1.5 && off.max(inside * 0.5) > OFF;
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
