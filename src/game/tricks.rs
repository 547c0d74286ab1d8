//! What marks for tricks ask for: burns, stars, and objectives met together.

use super::event::GameEvent;
use super::impacts::{SHIP_BOX, has_passed};
use super::ship::{SHIP, object_body};
use crate::level::{Level, Star, StarTouch};
use crate::physics::{BodyId, DVec2, World};

/// The engine is off for at least this time between two burns, s: shorter, and a key let go by mistake costs a burn; longer, and quick
/// taps pass for one.
const APART: f64 = 0.1;
/// A pause this much shorter counts, ticks: few tick rates have whole ticks in [`APART`].
const ROUNDING: f64 = 1e-9;

#[derive(Clone, Debug)]
pub struct Tricks {
    burns: u32,
    /// The tick after the last burning one; 0 before the first.
    burnt: u64,
    touched: Vec<bool>,
    /// By objective, the tick in which it was met last.
    met: Vec<u64>,
}

impl Tricks {
    pub fn new(level: &Level) -> Self {
        Self { burns: 0, burnt: 0, touched: vec![false; level.stars.len()], met: vec![0; level.objectives.len()] }
    }

    pub const fn burns(&self) -> u32 {
        self.burns
    }

    /// By index in `Level::stars`.
    pub fn touched(&self) -> &[bool] {
        &self.touched
    }

    /// The shortest time within which `count` objectives were met, s.
    pub fn together(&self, count: u32, tick_rate: f64) -> f64 {
        let mut met = self.met.clone();
        met.sort_unstable();
        let span = met.windows(count.max(1) as usize).map(|met| met[met.len() - 1] - met[0]).min();
        span.map_or(f64::INFINITY, |ticks| ticks as f64 / tick_rate)
    }

    /// Looks at the end of a tick, of that number, whose other events are there.
    pub fn note(&mut self, level: &Level, world: &World, (tick, rate): (u64, f64), burning: bool, events: &mut Vec<GameEvent>) {
        if burning {
            let off = (tick - self.burnt) as f64;
            self.burns += u32::from(self.burnt == 0 || off >= APART * rate - ROUNDING);
            self.burnt = tick + 1;
        }
        for event in events.iter() {
            if let GameEvent::ObjectiveMet(index) = *event {
                self.met[index] = tick;
            }
        }
        for (index, star) in level.stars.iter().enumerate() {
            if !self.touched[index] && is_touched(star, level, world) {
                self.touched[index] = true;
                events.push(GameEvent::StarTouched(index));
            }
        }
    }
}

/// Whether one of the bodies that count touched a star at any moment of the last tick.
fn is_touched(star: &Star, level: &Level, world: &World) -> bool {
    let passes = |body: BodyId, corners: &[DVec2]| has_passed(world, body, corners, &star.bounds);
    if star.by == StarTouch::Ship {
        return passes(SHIP, &SHIP_BOX);
    }
    level.objects.iter().enumerate().filter(|(_, object)| star.by == StarTouch::Object || object.key.is_some()).any(
        |(index, object)| {
            let half = object.size * 0.5;
            passes(object_body(index), &SHIP_BOX.map(|corner| corner.signum() * half))
        },
    )
}
