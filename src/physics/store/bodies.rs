//! All bodies in separate arrays, and after the last body all surfaces. Inside, y grows along gravity.

use crate::physics::data::axis::Axis;
use crate::physics::data::body::Body;
use crate::physics::data::material::Coefficients;
use crate::physics::data::surface::{Sides, Surface};
use glam::DVec2;

/// How much further than predicted a body may get before its contacts are sought anew: m, and across so many times its way besides.
/// Larger: more contacts to look at; smaller: more islands are solved again because a hit threw a body further.
pub(crate) const MARGIN: f64 = 1e-2;
const WAYS_ACROSS: f64 = 1.0;
const WAYS_ALONG: f64 = 0.0;

/// A box that overlaps none.
pub(crate) const NOWHERE: [f64; 4] = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];

/// All arrays have one entry a movable body, those marked so one more a surface.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bodies {
    count: usize,
    /// Centres, m (surfaces too).
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    /// Half extents, m (surfaces too).
    pub hx: Vec<f64>,
    pub hy: Vec<f64>,
    /// Velocities at the start of the step, m/s (surfaces too).
    pub vx: Vec<f64>,
    pub vy: Vec<f64>,
    /// Accelerations by gravity and by what is set from outside, m/s².
    pub ax: Vec<f64>,
    pub ay: Vec<f64>,
    /// kg.
    pub mass: Vec<f64>,
    /// ½ρ·C_d·side/m with the width, the height and, of round things alone, the diameter as side, 1/m.
    pub drag_wide: Vec<f64>,
    pub drag_tall: Vec<f64>,
    pub drag_round: Vec<f64>,
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
    /// Where free flight ends, kept while a step is solved, m.
    pub free_x: Vec<f64>,
    pub free_y: Vec<f64>,
    /// The box in which contacts of this step are looked for: left, right, top, bottom, m (surfaces too; an absent one has none).
    pub swept: Vec<[f64; 4]>,
    /// Whether anything bounces, and whether all bodies have the same friction.
    pub lively: bool,
    pub alike: bool,
    /// Of surfaces: the speed of a belt's upper side, m/s; from which sides it is solid; whether it is there. 0, all, yes for bodies.
    pub belt: Vec<f64>,
    pub sides: Vec<Sides>,
    /// Of surfaces: the velocity in the step before, m/s.
    pub was_vx: Vec<f64>,
    pub was_vy: Vec<f64>,
    pub present: Vec<bool>,
    /// Whether some have come or gone, or been put elsewhere.
    pub changed_surfaces: bool,
    /// Positions at the end of the step, first predicted, then final (surfaces too).
    pub px: Vec<f64>,
    pub py: Vec<f64>,
    /// Where some would be at the end of the step, and how fast, if they touched nothing: set from outside, by their numbers there.
    pub guided: Vec<(u32, DVec2, DVec2)>,
    /// Who of them that is in the present step, by the numbers outside.
    pub is_guided: Vec<bool>,
    /// Whether the air slows any.
    pub airy: bool,
}

impl Bodies {
    /// Room for `count` movable bodies and `surfaces` surfaces.
    pub fn new(count: usize, surfaces: usize) -> Self {
        let (movable, all) = (|| vec![0.0; count], || vec![0.0; count + surfaces]);
        Self {
            count,
            x: all(),
            y: all(),
            hx: all(),
            hy: all(),
            vx: all(),
            vy: all(),
            ax: movable(),
            ay: movable(),
            mass: movable(),
            drag_wide: movable(),
            drag_tall: movable(),
            drag_round: movable(),
            traits: vec![Coefficients::default(); count + surfaces],
            free_vx: all(),
            free_vy: all(),
            ux: all(),
            uy: all(),
            mean_vx: all(),
            mean_vy: all(),
            free_x: movable(),
            free_y: movable(),
            lively: false,
            alike: false,
            swept: vec![[0.0; 4]; count + surfaces],
            belt: all(),
            was_vx: all(),
            was_vy: all(),
            sides: vec![Sides::ALL; count + surfaces],
            present: vec![true; count + surfaces],
            changed_surfaces: true,
            px: all(),
            py: all(),
            guided: Vec::new(),
            is_guided: vec![false; count],
            airy: false,
        }
    }

    /// Takes over a body as it is, in air of a density (kg/m³); `down` is the sign of gravity.
    pub fn set_body(&mut self, i: usize, body: &Body, (down, air_density): (f64, f64)) {
        (self.x[i], self.y[i]) = (body.position.x, body.position.y * down);
        (self.px[i], self.py[i]) = (self.x[i], self.y[i]);
        (self.hx[i], self.hy[i]) = (body.half.x, body.half.y);
        (self.vx[i], self.vy[i]) = (body.velocity.x, body.velocity.y * down);
        self.mass[i] = body.mass;
        self.traits[i] = Coefficients {
            restitution: body.restitution,
            static_friction: body.material.static_friction,
            kinetic_friction: body.material.kinetic_friction,
        };
        let sides = if body.feels_air { body.half * 2.0 * body.drag } else { DVec2::ZERO };
        let [wide, tall] = sides.to_array().map(|side| 0.5 * air_density * side / body.mass);
        if body.round {
            let diameter = if body.feels_air { body.drag * (body.half.x + body.half.y) } else { 0.0 };
            self.drag_round[i] = 0.5 * air_density * diameter / body.mass;
        } else {
            (self.drag_wide[i], self.drag_tall[i]) = (wide, tall);
        }
    }

    /// Takes over a surface as it is.
    pub fn set_surface(&mut self, surface: usize, of: &Surface, down: f64) {
        let (j, centre, half) = (self.count + surface, of.bounds.centre(), of.bounds.size() * 0.5);
        (self.x[j], self.y[j]) = (centre.x, centre.y * down);
        (self.px[j], self.py[j]) = (self.x[j], self.y[j]);
        (self.hx[j], self.hy[j]) = (half.x, half.y);
        self.traits[j] = Coefficients {
            restitution: of.material.restitution,
            static_friction: of.material.static_friction,
            kinetic_friction: of.material.kinetic_friction,
        };
        self.belt[j] = of.belt * down;
        self.present[j] = of.present;
        let Sides { top, bottom, .. } = of.def.sides;
        self.sides[j] = if down < 0.0 { Sides { top: bottom, bottom: top, ..of.def.sides } } else { of.def.sides };
    }

    /// Notes which kinds of bodies there are.
    pub fn note_kinds(&mut self) {
        let n = self.count;
        let drags = [&self.drag_wide, &self.drag_tall, &self.drag_round];
        self.airy = drags.into_iter().flatten().any(|drag| *drag > 0.0);
        let friction = |traits: &Coefficients| (traits.static_friction, traits.kinetic_friction);
        self.alike = self.traits[..n].iter().all(|traits| friction(traits) == friction(&self.traits[0]));
        self.lively = self.traits.iter().any(|traits| traits.restitution > 0.0);
    }

    /// Takes every restitution out.
    pub fn make_plastic(&mut self) {
        self.traits.iter_mut().for_each(|traits| traits.restitution = 0.0);
        self.lively = false;
    }

    /// The number of movable bodies; everything from here on is immovable.
    pub fn len(&self) -> usize {
        self.count
    }

    /// The coefficients of a body i with a body or surface j.
    #[inline(always)]
    pub fn coefficients(&self, i: usize, j: usize) -> Coefficients {
        self.traits[i].with(self.traits[j], j >= self.count)
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
        self.vx[i] == self.vx[j] + skin || (j >= self.count && self.vx[i] == self.was_vx[j] + skin)
    }

    /// The same along gravity.
    #[inline(always)]
    pub fn rides_along(&self, i: usize, j: usize, skin: f64) -> bool {
        self.vy[i] == self.vy[j] + skin || (j >= self.count && self.vy[i] == self.was_vy[j] + skin)
    }

    /// How fast something moved across when the step began, m/s: of a surface, when the one before ended.
    pub fn began_across(&self, j: usize) -> f64 {
        if j < self.count { self.vx[j] } else { self.was_vx[j] }
    }

    /// Whether a surface moves in this step.
    pub fn moves(&self, j: usize) -> bool {
        self.vx[j] != 0.0 || self.vy[j] != 0.0
    }

    /// Whether a surface moves, moved in the step before, or runs a belt.
    pub fn carries(&self, j: usize) -> bool {
        let moved = self.was_vx[j] != 0.0 || self.was_vy[j] != 0.0;
        self.moves(j) || moved || self.belt[j] != 0.0
    }

    /// Whether the predicted box of a body lies within what was swept when contacts were sought.
    #[inline(always)]
    pub fn is_swept(&self, i: usize) -> bool {
        let (s, x, y, hx, hy) = (&self.swept[i], self.px[i], self.py[i], self.hx[i], self.hy[i]);
        (x - hx >= s[0]) & (x + hx <= s[1]) & (y - hy >= s[2]) & (y + hy <= s[3])
    }

    /// Lets a body rest where it is.
    pub fn stay(&mut self, i: usize) {
        (self.px[i], self.py[i]) = (self.x[i], self.y[i]);
        (self.ux[i], self.uy[i]) = (0.0, 0.0);
    }

    /// Widens what a body sweeps to where it is predicted now.
    pub fn widen(&mut self, i: usize) {
        let (x, y, hx, hy) = (self.px[i], self.py[i], self.hx[i] + MARGIN, self.hy[i] + MARGIN);
        let s = &mut self.swept[i];
        *s = [s[0].min(x - hx), s[1].max(x + hx), s[2].min(y - hy), s[3].max(y + hy)];
    }

    /// How much further than its way, which is so wide and so high, contacts of a body are looked for, m.
    #[inline(always)]
    pub fn margins(wide: f64, high: f64) -> (f64, f64) {
        (MARGIN + WAYS_ACROSS * wide, MARGIN + WAYS_ALONG * high)
    }

    /// Sets the boxes that these bodies sweep from where they are to where they are predicted, and a margin.
    pub fn sweep(&mut self, slots: &[u32]) {
        if slots.len() == self.count {
            return self.sweep_range(0, self.count);
        }
        for &i in slots {
            self.sweep_range(i as usize, i as usize + 1);
        }
    }

    /// The same for those of a range.
    #[inline(always)]
    pub fn sweep_range(&mut self, from: usize, to: usize) {
        let (x, px, hx) = (&self.x[from..to], &self.px[from..to], &self.hx[from..to]);
        let (y, py, hy) = (&self.y[from..to], &self.py[from..to], &self.hy[from..to]);
        for (i, swept) in self.swept[from..to].iter_mut().enumerate() {
            let (left, right) = if x[i] < px[i] { (x[i], px[i]) } else { (px[i], x[i]) };
            let (top, bottom) = if y[i] < py[i] { (y[i], py[i]) } else { (py[i], y[i]) };
            let (wide, high) = Self::margins(right - left, bottom - top);
            let (wide, high) = (hx[i] + wide, hy[i] + high);
            *swept = [left - wide, right + wide, top - high, bottom + high];
        }
    }

    /// The same for surfaces that move; for all, if others have come or gone. Returns whether they have.
    pub fn sweep_surfaces(&mut self, moving: &[u32]) -> bool {
        let (n, all) = (self.count, self.x.len());
        let others = std::mem::replace(&mut self.changed_surfaces, false);
        if others {
            (n..all).for_each(|j| self.sweep_surface(j));
        } else {
            moving.iter().for_each(|j| self.sweep_surface(n + *j as usize));
        }
        others
    }

    fn sweep_surface(&mut self, j: usize) {
        if self.present[j] {
            self.sweep_range(j, j + 1);
        } else {
            self.swept[j] = NOWHERE;
        }
    }

    /// Keeps where free flight has led these bodies.
    pub fn keep_free_flight(&mut self, slots: &[u32]) {
        let n = self.count;
        if slots.len() == n {
            self.free_x.copy_from_slice(&self.px[..n]);
            self.free_y.copy_from_slice(&self.py[..n]);
            return;
        }
        for &i in slots {
            (self.free_x[i as usize], self.free_y[i as usize]) = (self.px[i as usize], self.py[i as usize]);
        }
    }

    /// Predicts a body to be where free flight leads it.
    pub fn fall_freely(&mut self, i: usize) {
        (self.px[i], self.py[i]) = (self.free_x[i], self.free_y[i]);
    }

    /// The velocities that the solver left become those of the next step, the predicted positions the current ones.
    pub fn commit(&mut self) {
        std::mem::swap(&mut self.x, &mut self.px);
        std::mem::swap(&mut self.y, &mut self.py);
        std::mem::swap(&mut self.vx, &mut self.ux);
        std::mem::swap(&mut self.vy, &mut self.uy);
    }
}
