//! The state of all bodies in separate arrays, and their numbering.
//!
//! Inside, y grows along gravity ("down") and the movable bodies are numbered bottom-up, so that every pass along gravity is one
//! linear loop; the immovable surfaces follow after the last movable body and never move. [`Bodies::slot`] and [`Bodies::id`]
//! translate between this numbering and that of the outside.

use glam::DVec2;
use std::cmp::Ordering;

/// After so many moves a body, insertion gives up and all is sorted anew. Either way the order is the same.
const MOST_MOVES: usize = 8;

/// What seldom enters a formula, kept together.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Traits {
    pub restitution: f64,
    pub static_friction: f64,
    pub kinetic_friction: f64,
}

/// All arrays have one entry a movable body, those marked so one more a surface.
#[derive(Clone, Debug, Default)]
pub(super) struct Bodies {
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
    pub traits: Vec<Traits>,
    /// Velocities at the end of the step if nothing were touched (surfaces too).
    pub free_vx: Vec<f64>,
    pub free_vy: Vec<f64>,
    /// Velocities as the solver leaves them (surfaces too).
    pub ux: Vec<f64>,
    pub uy: Vec<f64>,
    /// Mean velocities along gravity over the step of what touched something, m/s.
    pub mean_vy: Vec<f64>,
    /// Positions at the end of the step, first predicted, then final (surfaces too).
    pub px: Vec<f64>,
    pub py: Vec<f64>,
    /// Where the centre may go before neighbours have to be sought anew.
    pub allowed_left: Vec<f64>,
    pub allowed_right: Vec<f64>,
    pub allowed_top: Vec<f64>,
    pub allowed_bottom: Vec<f64>,
    /// How far the allowed ranges have moved since they were made, m.
    pub shift: (f64, f64),
    /// Where some would be at the end of the step, and how fast, if they touched nothing: set from outside, by their numbers there.
    pub guided: Vec<(u32, DVec2, DVec2)>,
    /// Number outside → number inside.
    pub slot: Vec<u32>,
    /// Number inside → number outside.
    pub id: Vec<u32>,
    order: Vec<u32>,
    spare: Vec<f64>,
    spare_traits: Vec<Traits>,
    spare_ids: Vec<u32>,
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
            traits: vec![Traits::default(); count + surfaces],
            free_vx: all(),
            free_vy: all(),
            ux: all(),
            uy: all(),
            mean_vy: movable(),
            px: all(),
            py: all(),
            allowed_left: vec![f64::INFINITY; count],
            allowed_right: movable(),
            allowed_top: movable(),
            allowed_bottom: movable(),
            shift: (0.0, 0.0),
            guided: Vec::new(),
            slot: (0..count as u32).collect(),
            id: (0..count as u32).collect(),
            order: (0..count as u32).collect(),
            spare: movable(),
            spare_traits: vec![Traits::default(); count],
            spare_ids: vec![0; count],
        }
    }

    /// The number of movable bodies; everything from here on is immovable.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether the predicted centre lies within the body's allowed box.
    #[inline(always)]
    pub fn is_allowed(&self, i: usize) -> bool {
        let (x, y) = (self.px[i] - self.shift.0, self.py[i] - self.shift.1);
        (x >= self.allowed_left[i]) & (x <= self.allowed_right[i]) & (y >= self.allowed_top[i]) & (y <= self.allowed_bottom[i])
    }

    /// Numbers the bodies bottom-up, equal heights by their number outside. Only what holds at the start of a step is carried
    /// along. By insertion where little has changed since the last time.
    pub fn renumber(&mut self) {
        let n = self.count;
        let (y, id) = (&self.y, &self.id);
        let below = |a: u32, b: u32| {
            let (a, b) = (a as usize, b as usize);
            y[a] > y[b] || (y[a] == y[b] && id[a] < id[b])
        };
        let mut sorted = true;
        for (i, slot) in self.order.iter_mut().enumerate() {
            *slot = i as u32;
        }
        let mut moves = 0;
        for i in 1..n {
            let moved = self.order[i];
            let mut at = i;
            while at > 0 && below(moved, self.order[at - 1]) {
                self.order[at] = self.order[at - 1];
                at -= 1;
            }
            self.order[at] = moved;
            sorted &= at == i;
            moves += i - at;
            if moves > MOST_MOVES * n {
                self.order.sort_unstable_by(|&a, &b| {
                    let (a, b) = (a as usize, b as usize);
                    y[b].partial_cmp(&y[a]).unwrap_or(Ordering::Equal).then(id[a].cmp(&id[b]))
                });
                break;
            }
        }
        if sorted {
            return;
        }
        let order = &self.order;
        for values in [
            &mut self.x,
            &mut self.y,
            &mut self.hx,
            &mut self.hy,
            &mut self.vx,
            &mut self.vy,
            &mut self.ax,
            &mut self.ay,
            &mut self.mass,
            &mut self.drag_wide,
            &mut self.drag_tall,
            &mut self.drag_round,
            &mut self.free_vx,
            &mut self.free_vy,
            &mut self.px,
            &mut self.py,
        ] {
            self.spare.copy_from_slice(&values[..n]);
            for (value, &from) in values.iter_mut().zip(order) {
                *value = self.spare[from as usize];
            }
        }
        self.spare_traits.copy_from_slice(&self.traits[..n]);
        self.spare_ids.copy_from_slice(&self.id);
        for (i, &from) in order.iter().enumerate() {
            self.traits[i] = self.spare_traits[from as usize];
            self.id[i] = self.spare_ids[from as usize];
            self.slot[self.id[i] as usize] = i as u32;
        }
    }

    /// The velocities that the solver left become those of the next step, the predicted positions the current ones.
    pub fn commit(&mut self) {
        std::mem::swap(&mut self.x, &mut self.px);
        std::mem::swap(&mut self.y, &mut self.py);
        std::mem::swap(&mut self.vx, &mut self.ux);
        std::mem::swap(&mut self.vy, &mut self.uy);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_body_comes_first_and_keeps_its_outer_number() {
        let mut bodies = Bodies::new(3, 1);
        bodies.y.copy_from_slice(&[1.0, 5.0, 3.0, 9.0]);
        bodies.mass.copy_from_slice(&[10.0, 50.0, 30.0]);
        bodies.renumber();
        assert_eq!(bodies.y, [5.0, 3.0, 1.0, 9.0]);
        assert_eq!(bodies.mass, [50.0, 30.0, 10.0]);
        assert_eq!(bodies.id, [1, 2, 0]);
        assert_eq!(bodies.slot, [2, 0, 1]);
    }
}
