//! The round scale of the arrows changes at once where one is too long; where all are too short, after a while: a passage through zero is none.

use crate::physics::{BodyId, DVec2, World};
use crate::view::facts::round_up;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vector {
    Velocity,
    Acceleration,
}

impl Vector {
    pub const ALL: [Self; 2] = [Self::Velocity, Self::Acceleration];

    /// y downwards.
    pub fn of(self, world: &World, body: BodyId) -> DVec2 {
        let body = world.body(body);
        match self {
            Self::Velocity => body.velocity,
            Self::Acceleration => body.acceleration,
        }
    }
}

/// The value of a metre at first, m/s and m/s².
const USUAL: f64 = 2.0;
/// The scale is never finer than for this speed.
const NOTHING: f64 = 1e-6;
/// The scale changes where the longest arrow is shorter than this part of the limit for this time, s.
const TOO_SHORT: f64 = 0.15;
const PATIENCE: f64 = 0.6;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// The value of a metre of the level.
    a_metre: [f64; 2],
    /// s since the longest arrow became too short.
    short_for: [f64; 2],
}

impl Default for Scales {
    fn default() -> Self {
        Self { a_metre: [USUAL; 2], short_for: [0.0; 2] }
    }
}

impl Scales {
    /// One frame of `frame_time` s, in which no arrow of those bodies should be longer than `most` metres, drawn `length` times as long as usual.
    pub fn update(&mut self, frame_time: f64, world: &World, bodies: &[BodyId], (most, length): (f64, f64)) {
        for (i, vector) in Vector::ALL.into_iter().enumerate() {
            let largest = bodies.iter().map(|body| vector.of(world, *body).length()).fold(0.0, f64::max);
            let drawn = largest / self.a_metre(vector, length) / most;
            self.short_for[i] = if largest > NOTHING && drawn < TOO_SHORT { self.short_for[i] + frame_time } else { 0.0 };
            if drawn > 1.0 || self.short_for[i] > PATIENCE {
                self.a_metre[i] = round_up(length * largest / most);
                self.short_for[i] = 0.0;
            }
        }
    }

    /// The value of a metre, in the vector's unit, for arrows `length` times as long as usual.
    pub fn a_metre(&self, vector: Vector, length: f64) -> f64 {
        round_up(self.a_metre[vector as usize] / length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, WorldDef};

    fn moving(velocity: f64) -> World {
        let body = BodyDef { position: DVec2::splat(50.0), velocity: DVec2::new(velocity, 0.0), ..BodyDef::default() };
        World::new(WorldDef { bodies: vec![body], ..WorldDef::default() }).expect("a body")
    }

    /// The drawn length of a velocity, m, after `frames` of 1/60 s.
    fn drawn(scales: &mut Scales, velocity: f64, frames: u32, length: f64) -> f64 {
        for _ in 0..frames {
            scales.update(1.0 / 60.0, &moving(velocity), &[BodyId(0)], (8.0, length));
        }
        velocity / scales.a_metre(Vector::Velocity, length)
    }

    #[test]
    fn arrows_are_never_too_long_and_not_for_long_too_short() {
        let mut scales = Scales::default();
        assert_eq!(drawn(&mut scales, 4.0, 1, 1.0), 2.0);
        for velocity in [1e-5, 0.013, 0.7, 16.0, 17.0, 400.0, 1e5] {
            for length in [0.25, 1.0, 2.0_f64.sqrt(), 16.0] {
                assert!(drawn(&mut scales, velocity, 1, length) <= 8.0 * (1.0 + 1e-12));
                let after = drawn(&mut scales, velocity, 60, length);
                assert!((0.15 * 8.0..=8.0 * (1.0 + 1e-12)).contains(&after), "{velocity} m/s, {length} times: {after} m");
            }
        }
    }

    #[test]
    fn passing_through_rest_changes_no_scale() {
        let mut scales = Scales::default();
        for velocity in [6.0, 0.5, 0.1, 0.0, 0.1, 0.5, 6.0] {
            drawn(&mut scales, velocity, 5, 1.0);
        }
        assert_eq!(scales.a_metre(Vector::Velocity, 1.0), 2.0);
        drawn(&mut scales, 0.0, 600, 1.0);
        assert_eq!(scales.a_metre(Vector::Velocity, 1.0), 2.0, "what rests has no arrow that could be longer");
    }
}
