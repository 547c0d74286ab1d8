//! The number of times the ship has pushed objects, for a mark of few pushes.

use super::ship::SHIP;
use crate::physics::{ForceManager, Impulse, Obstacle, Source};

/// Touches of the ship and one object less than this apart are one push, s. Shorter, and an object that bounces along before the
/// ship counts again and again; longer, and two deliberate nudges count as one.
pub const APART: f64 = 0.5;

/// A push begins when the ship touches an object that it has not touched for [`APART`], whichever of the two moves.
#[derive(Clone, Debug)]
pub struct PushCount {
    count: u32,
    /// By object, the tick after the last touch; 0 for never.
    touched: Vec<u64>,
}

impl PushCount {
    pub fn new(objects: usize) -> Self {
        Self { count: 0, touched: vec![0; objects] }
    }

    pub const fn count(&self) -> u32 {
        self.count
    }

    /// Takes the forces on the ship at a tick's end, and the impacts of that tick. `apart` is [`APART`] in ticks.
    pub fn note(&mut self, tick: u64, apart: f64, forces: &ForceManager, impulses: &[Impulse]) {
        let pressing = forces.forces().iter().filter_map(|force| if let Source::Body(by) = force.source { Some(by) } else { None });
        let hitting = impulses.iter().filter_map(|impulse| match impulse.on(SHIP) {
            Some((_, Obstacle::Body(by))) => Some(by),
            Some((_, Obstacle::Surface(_))) | None => None,
        });
        for body in pressing.chain(hitting) {
            let Some(last) = self.touched.get_mut(body.index().wrapping_sub(1)) else { continue };
            self.count += u32::from(*last == 0 || (tick + 1 - *last) as f64 >= apart);
            *last = tick + 1;
        }
    }

    /// Feeds every bit of the state to `write`; before the first push there is none.
    pub fn hash_state(&self, write: &mut impl FnMut(u64)) {
        if self.count > 0 {
            write(u64::from(self.count));
            self.touched.iter().for_each(|&tick| write(tick));
        }
    }
}
