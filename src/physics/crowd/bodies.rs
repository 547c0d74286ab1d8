//! The bodies of one island in separate arrays, bottom-up, and after the last body the surfaces that they may meet. Here y grows along gravity.
//!
//! A step of the crowd gathers them from the world's state, works on them alone, and leaves in them where they end: islands do not know of
//! each other, and neighbours in a pile are neighbours in memory.

use crate::physics::data::axis::Axis;
use crate::physics::data::body::Body;
use crate::physics::data::material::Coefficients;
use crate::physics::data::surface::{Sides, Surface};
use crate::physics::forces::air::Drag;
use crate::physics::store::edges::Edges;
use crate::physics::store::islands::Island;
use crate::physics::store::motions::{MARGIN, Motions, SurfaceMotion};
use glam::DVec2;

/// Where the bodies of an island are gathered from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Source<'a> {
    pub bodies: &'a [Body],
    pub surfaces: &'a [Surface],
    pub motions: &'a Motions,
    /// The sign of gravity.
    pub down: f64,
    /// Whether anything bounces.
    pub bounces: bool,
}

/// An island in its own numbers: bodies bottom-up from 0, then its surfaces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Group<'a> {
    pub members: &'a [u32],
    pub island: Island<'a>,
    /// The own number of each body and surface of the world that is in the island.
    pub local: &'a [u32],
}

impl<'a> Group<'a> {
    /// What a member may touch, each a member before it or a surface.
    #[inline(always)]
    pub fn near(&self, member: u32) -> impl Iterator<Item = usize> + use<'a> {
        let local = self.local;
        self.island.near(self.island.members[member as usize]).iter().map(|j| local[*j as usize] as usize)
    }
}

/// Arrays begin with an entry for each body, those marked so go on with one for each surface. Beyond, they hold what other islands left.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bodies {
    /// The numbers of bodies and surfaces in the world.
    pub ids: Vec<u32>,
    pub surfaces: Vec<u32>,
    /// Centres, m (surfaces too).
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    /// Half extents, m (surfaces too).
    pub hx: Vec<f64>,
    pub hy: Vec<f64>,
    /// Velocities at the start of the step, m/s; of a surface its mean velocity.
    pub vx: Vec<f64>,
    pub vy: Vec<f64>,
    /// Accelerations by gravity and by what is set from outside, m/s².
    pub ax: Vec<f64>,
    pub ay: Vec<f64>,
    /// kg.
    pub mass: Vec<f64>,
    /// Drag of the air; empty if nothing meets it.
    drags: Vec<Drag>,
    /// Surfaces too.
    pub traits: Vec<Coefficients>,
    /// Velocities at the end of the step if nothing were touched (surfaces too).
    pub free_vx: Vec<f64>,
    pub free_vy: Vec<f64>,
    /// Velocities as the solver leaves them (surfaces too).
    pub ux: Vec<f64>,
    pub uy: Vec<f64>,
    /// Mean velocities over the step, m/s: the way divided by the step (surfaces too).
    pub mean_vx: Vec<f64>,
    pub mean_vy: Vec<f64>,
    /// Where free flight ends, m.
    pub free_x: Vec<f64>,
    pub free_y: Vec<f64>,
    /// The box in which contacts of this step are looked for: left, right, top, bottom, m.
    pub swept: Vec<Edges>,
    /// Whether anything bounces, and whether all bodies have the same friction.
    pub bounces: bool,
    pub alike: bool,
    /// The speed of a belt's upper side, m/s (surfaces too; 0 of bodies).
    pub belt: Vec<f64>,
    /// Of surfaces, from the first one on: from which sides each is solid, and its velocity in the step before, m/s.
    sides: Vec<Sides>,
    was: Vec<DVec2>,
    /// Positions at the end of the step, first predicted, then final (surfaces too).
    pub px: Vec<f64>,
    pub py: Vec<f64>,
    /// Of bodies whose flight no constant force describes: ½v² where it ends, J/kg.
    pub guided: Vec<Option<f64>>,
    /// Whether the air slows any.
    pub airy: bool,
}

impl Bodies {
    /// Room for `n` bodies; `all` with surfaces.
    pub fn new(n: usize, all: usize) -> Self {
        let array = || vec![0.0; all];
        Self {
            x: array(),
            y: array(),
            hx: array(),
            hy: array(),
            vx: array(),
            vy: array(),
            ax: array(),
            ay: array(),
            free_vx: array(),
            free_vy: array(),
            ux: array(),
            uy: array(),
            mean_vx: array(),
            mean_vy: array(),
            free_x: array(),
            free_y: array(),
            px: array(),
            py: array(),
            belt: array(),
            traits: vec![Coefficients::default(); all],
            swept: vec![[0.0; 4]; n],
            guided: vec![None; n],
            sides: vec![Sides::ALL; all - n],
            was: vec![DVec2::ZERO; all - n],
            ..Self::default()
        }
    }

    /// Gathers an island and the surfaces near it.
    pub fn gather(&mut self, from: Source<'_>, island: Island<'_>) {
        let n = island.members.len();
        self.ids.clear();
        self.ids.extend_from_slice(island.members);
        self.surfaces.clear();
        self.surfaces.extend(island.surfaces(from.motions.len()));
        self.surfaces.sort_unstable();
        self.surfaces.dedup();
        self.bounces = from.bounces;
        self.mass.resize(n, 0.0);
        self.set_bodies(from, n);
        self.belt[..n].fill(0.0);
        for k in 0..self.surfaces.len() {
            let s = self.surfaces[k] as usize;
            self.set_surface(n + k, &from.surfaces[s], &from.motions.surfaces[s], from.down);
        }
        self.drags.clear();
        self.airy = from.motions.airy;
        if self.airy {
            self.drags.extend(self.ids.iter().map(|i| from.motions.drags[*i as usize]));
        }
        if !from.bounces {
            self.traits[..n + self.surfaces.len()].iter_mut().for_each(|traits| traits.restitution = 0.0);
        }
        let friction = |traits: &Coefficients| (traits.static_friction, traits.kinetic_friction);
        self.alike = self.traits[..n].iter().all(|traits| friction(traits) == friction(&self.traits[0]));
    }

    /// Sets what is known of each body.
    fn set_bodies(&mut self, from: Source<'_>, n: usize) {
        let down = from.down;
        let Self { ids, x, y, hx, hy, vx, vy, ax, ay, mass, traits, free_vx, free_vy, free_x, free_y, px, py, .. } = self;
        // Slices stay in place while the loop writes, where vectors would be looked up each time.
        let ids = &ids[..n];
        let [x, y, hx, hy, vx, vy, ax, ay] = [x, y, hx, hy, vx, vy, ax, ay].map(|array| &mut array[..n]);
        let [free_vx, free_vy, free_x, free_y, px, py] = [free_vx, free_vy, free_x, free_y, px, py].map(|array| &mut array[..n]);
        let (mass, traits) = (&mut mass[..n], &mut traits[..n]);
        let (swept, guided) = (&mut self.swept[..n], &mut self.guided[..n]);
        for k in 0..n {
            let i = ids[k] as usize;
            let (body, motion) = (&from.bodies[i], &from.motions.bodies[i]);
            (x[k], y[k]) = (body.position.x, body.position.y * down);
            (hx[k], hy[k]) = body.half.into();
            (vx[k], vy[k]) = (body.velocity.x, body.velocity.y * down);
            (ax[k], ay[k]) = (motion.pull.x, motion.pull.y * down);
            mass[k] = body.mass;
            traits[k] = body.coefficients();
            let (place, velocity) = motion.free;
            (free_vx[k], free_vy[k]) = (velocity.x, velocity.y * down);
            (free_x[k], free_y[k]) = (place.x, place.y * down);
            (px[k], py[k]) = (free_x[k], free_y[k]);
            swept[k] = turned(from.motions.swept[i], down);
            guided[k] = motion.guided.then_some(0.5 * velocity.length_squared());
        }
    }

    fn set_surface(&mut self, j: usize, surface: &Surface, motion: &SurfaceMotion, down: f64) {
        let k = j - self.ids.len();
        let SurfaceMotion { from, to, half, mean, end, was, belt, .. } = *motion;
        (self.x[j], self.y[j]) = (from.x, from.y * down);
        (self.px[j], self.py[j]) = (to.x, to.y * down);
        (self.hx[j], self.hy[j]) = half.into();
        (self.vx[j], self.vy[j]) = (mean.x, mean.y * down);
        (self.mean_vx[j], self.mean_vy[j]) = (self.vx[j], self.vy[j]);
        // What rides on it moves so when the step ends.
        (self.ux[j], self.uy[j]) = (end.x, end.y * down);
        (self.free_vx[j], self.free_vy[j]) = (self.ux[j], self.uy[j]);
        self.was[k] = DVec2::new(was.x, was.y * down);
        self.belt[j] = belt * down;
        self.traits[j] = surface.material.coefficients();
        let Sides { top, bottom, .. } = surface.def.sides;
        self.sides[k] = if down < 0.0 { Sides { top: bottom, bottom: top, ..surface.def.sides } } else { surface.def.sides };
    }

    /// The pose of body `k` at the end of the step in the world.
    pub fn end(&self, k: usize, down: f64) -> (DVec2, DVec2) {
        (DVec2::new(self.px[k], self.py[k] * down), DVec2::new(self.ux[k], self.uy[k] * down))
    }

    /// What body `k` sweeps, as the world has it.
    pub fn swept(&self, k: usize, down: f64) -> Edges {
        turned(self.swept[k], down)
    }

    /// Whether nothing but the air slows the flight of a body, and it does.
    pub fn meets_air(&self, i: usize) -> bool {
        self.airy && !self.drags[i].is_none() && self.guided[i].is_none()
    }

    /// The drag of the air on a body; only asked where it meets air.
    pub fn drag_of(&self, i: usize) -> Drag {
        self.drags[i]
    }

    /// From which sides a surface is solid.
    pub fn sides(&self, j: usize) -> &Sides {
        &self.sides[j - self.ids.len()]
    }

    /// The number of bodies; surfaces count on from here.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// The coefficients of a body i with a body or surface j.
    #[inline(always)]
    pub fn coefficients(&self, i: usize, j: usize) -> Coefficients {
        self.traits[i].with(self.traits[j], j >= self.len())
    }

    /// Positions, half extents, velocities before and free velocities along an axis.
    pub fn along(&self, axis: Axis) -> [&[f64]; 4] {
        match axis {
            Axis::Across => [&self.x, &self.hx, &self.vx, &self.free_vx],
            Axis::Gravity => [&self.y, &self.hy, &self.vy, &self.free_vy],
        }
    }

    /// The velocity of the skin of a surface along the face that lies towards larger or smaller coordinates along `axis` (0: across,
    /// 1: along gravity), besides its own, m/s; 0 of a body.
    pub fn skin(&self, j: usize, axis: usize, larger: bool) -> f64 {
        if (axis == 0) == larger { self.belt[j] } else { -self.belt[j] }
    }

    /// Whether body i had the velocity across that the skin of `j` has, or, of a surface, had in the step before: it rides on it.
    #[inline(always)]
    pub fn rides_across(&self, i: usize, j: usize, skin: f64) -> bool {
        self.vx[i] == self.vx[j] + skin || (j >= self.len() && self.vx[i] == self.was[j - self.len()].x + skin)
    }

    /// The same along gravity.
    #[inline(always)]
    pub fn rides_along(&self, i: usize, j: usize, skin: f64) -> bool {
        self.vy[i] == self.vy[j] + skin || (j >= self.len() && self.vy[i] == self.was[j - self.len()].y + skin)
    }

    /// How fast something moved across when the step began, m/s: of a surface, when the one before ended.
    pub fn began_across(&self, j: usize) -> f64 {
        if j < self.len() { self.vx[j] } else { self.was[j - self.len()].x }
    }

    /// Whether a surface moves in this step.
    pub fn moves(&self, j: usize) -> bool {
        self.vx[j] != 0.0 || self.vy[j] != 0.0
    }

    /// Whether a surface moves, moved in the step before, or runs a belt.
    pub fn carries(&self, j: usize) -> bool {
        self.moves(j) || self.was[j - self.len()] != DVec2::ZERO || self.belt[j] != 0.0
    }

    /// Whether the predicted box of a body lies within what was swept when contacts were sought.
    #[inline(always)]
    pub fn is_swept(&self, i: usize) -> bool {
        let (s, x, y, hx, hy) = (&self.swept[i], self.px[i], self.py[i], self.hx[i], self.hy[i]);
        (x - hx >= s[0]) & (x + hx <= s[1]) & (y - hy >= s[2]) & (y + hy <= s[3])
    }

    /// Widens what a body sweeps to where it is predicted now.
    pub fn widen(&mut self, i: usize) {
        let (x, y, hx, hy) = (self.px[i], self.py[i], self.hx[i] + MARGIN, self.hy[i] + MARGIN);
        let s = &mut self.swept[i];
        *s = [s[0].min(x - hx), s[1].max(x + hx), s[2].min(y - hy), s[3].max(y + hy)];
    }

    /// Predicts a body to be where free flight leads it.
    pub fn fall_freely(&mut self, i: usize) {
        (self.px[i], self.py[i]) = (self.free_x[i], self.free_y[i]);
    }
}

/// A box in a world whose gravity points the other way, if `down` is −1.
fn turned([left, right, top, bottom]: Edges, down: f64) -> Edges {
    if down < 0.0 { [left, right, -bottom, -top] } else { [left, right, top, bottom] }
}
