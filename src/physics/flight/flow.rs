//! The motion of one body through media, without contacts: as exact as it can be had at each cost.
//!
//! Nothing that depends on velocity or place: the parabola, exact at any step. Air alone: [`crate::physics::flight::air`]. Near a liquid:
//! [`crate::physics::flight::liquid`].

use crate::physics::data::body::{Body, Pose};
use crate::physics::flight::air::fly_through;
use crate::physics::flight::liquid::swim;
use crate::physics::flight::steps::Course;
use crate::physics::forces::law::Law;
use crate::physics::forces::media::Media;

/// Where `body` is after `t` seconds under `law`.
pub(crate) fn flow(media: &Media, body: &Body, law: &Law, t: f64) -> Pose {
    flow_through(media, body, law, t).end
}

/// The same with its time, its next step and its last acceleration.
pub(crate) fn flow_through(media: &Media, body: &Body, law: &Law, t: f64) -> Course {
    flow_while(media, body, law, t, |_, _| true)
}

/// The same up to the last step through a liquid for which `goes_on` holds at its time and end, or to the end of the first step.
pub(crate) fn flow_while(media: &Media, body: &Body, law: &Law, t: f64, goes_on: impl FnMut(f64, Pose) -> bool) -> Course {
    if law.is_near_liquid() {
        return swim(media, body, law, t, goes_on);
    }
    let end = fly_through((body.position, body.velocity), law.constant, &law.air, t);
    Course { end, time: t, next: f64::INFINITY, pull: None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::data::aabb::Aabb;
    use crate::physics::data::body::BodyDef;
    use crate::physics::data::def::{FluidDef, WorldDef};
    use crate::physics::forces::displaced::Displaced;
    use glam::DVec2;
    use proptest::prelude::*;
    use proptest::test_runner::FileFailurePersistence;

    fn media(gravity: f64, air_density: f64, fluids: Vec<FluidDef>) -> Media {
        Media::new(gravity, air_density, (&[], &[]), fluids)
    }

    /// A body and its law for one tick, refused or not at the door.
    fn at_the_door(media: &Media, def: &BodyDef, drive: DVec2) -> Option<(Body, Law)> {
        let world = WorldDef {
            gravity: media.gravity,
            air_density: media.air_density,
            fluids: media.fluids.clone(),
            bodies: vec![def.clone()],
            ..WorldDef::default()
        };
        world.check().ok()?;
        let body = Body::new(def);
        let constant = DVec2::new(0.0, media.gravity) + drive / body.mass;
        let displaced = Displaced::within(media, Aabb::around(DVec2::ZERO, DVec2::splat(1e30)));
        let law = Law { constant, air: media.air(&body), displaced, ..Law::default() };
        Some((body, law))
    }

    /// Evenly over the powers of ten.
    fn decades(low: f64, high: f64) -> impl Strategy<Value = f64> {
        (low..high).prop_map(|power| 10f64.powf(power))
    }

    fn signed(low: f64, high: f64) -> impl Strategy<Value = f64> {
        (decades(low, high), -1i8..=1).prop_map(|(size, sign)| size * f64::from(sign))
    }

    prop_compose! {
        /// Anything that is accepted, at up to 10⁶ m/s.
        fn things()(
            mass in decades(-9.0, 12.0), hx in decades(-6.0, 9.0), hy in decades(-6.0, 9.0), drag in prop_oneof![Just(0.0), decades(-6.0, 12.0)],
            round in any::<bool>(), vx in signed(-9.0, 6.0), vy in signed(-9.0, 6.0),
        ) -> BodyDef {
            BodyDef { mass, half: DVec2::new(hx, hy), drag, round, velocity: DVec2::new(vx, vy), ..BodyDef::default() }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            cases: 1000,
            failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions"))),
            ..ProptestConfig::default()
        })]

        /// Drag never reverses a motion, and takes energy only: what is gained, the constant force has done.
        #[test]
        fn drag_of_the_air_only_slows(
            def in things(), air in decades(-6.0, 12.0), gravity in prop_oneof![Just(0.0), signed(-3.0, 6.0)], fx in signed(-3.0, 9.0), t in decades(-6.0, 0.0),
        ) {
            let media = media(gravity, air, Vec::new());
            let drive = if gravity == 0.0 { DVec2::ZERO } else { DVec2::new(fx, 0.0) };
            let Some((body, law)) = at_the_door(&media, &def, drive) else { return Ok(()) };
            let (x, v) = flow(&media, &body, &law, t);
            prop_assert!(x.is_finite() && v.is_finite(), "{x} {v}");
            for axis in 0..2 {
                if law.constant[axis] * def.velocity[axis] >= 0.0 {
                    prop_assert!(v[axis] * def.velocity[axis] >= 0.0, "{v}, from {}", def.velocity);
                }
                if law.constant[axis] == 0.0 {
                    prop_assert!(v[axis].abs() <= def.velocity[axis].abs(), "{v}, from {}", def.velocity);
                }
            }
            let (before, after, work) = (def.velocity.length_squared(), v.length_squared(), 2.0 * law.constant.dot(x));
            prop_assert!(after - before - work <= 1e-8 * (before + work.abs()), "v² {after}, from {before}, work {work}");
        }

        /// In a pool as well, at its surface or under it.
        #[test]
        fn a_liquid_only_slows(
            def in things(), depth in -2.0..3.0f64, density in decades(-3.0, 12.0), viscosity in prop_oneof![Just(0.0), decades(-6.0, 12.0)],
            gravity in prop_oneof![Just(0.0), decades(-3.0, 6.0)], t in decades(-6.0, 0.0),
        ) {
            let zone = Aabb::new(DVec2::new(-1e12, 0.0), DVec2::new(1e12, 1e12));
            let media = media(gravity, 1.2, vec![FluidDef { zone, density, viscosity }]);
            let def = BodyDef { position: DVec2::new(0.0, depth * def.half.y), ..def };
            let Some((body, law)) = at_the_door(&media, &def, DVec2::ZERO) else { return Ok(()) };
            let (x, v) = flow(&media, &body, &law, t);
            prop_assert!(x.is_finite() && v.is_finite(), "{x} {v}");
            prop_assert!(v.x * def.velocity.x >= 0.0 && v.x.abs() <= def.velocity.x.abs() * (1.0 + 1e-9), "{v}, from {}", def.velocity);
            // Twice the potential energy per mass: of the weight, and of the displaced liquid.
            let height = 2.0 * body.half.y;
            let lift = density * gravity * 2.0 * body.half.x / body.mass;
            let potential = |y: f64| {
                let wet = (y + body.half.y).clamp(0.0, height);
                let sunk = (y - body.half.y).max(0.0);
                [-2.0 * gravity * y, lift * (wet * wet + 2.0 * height * sunk)]
            };
            let (from, to) = (potential(def.position.y), potential(x.y));
            let (before, after) = (def.velocity.length_squared(), v.length_squared());
            let scale = before + from[0].abs() + from[1].abs() + to[0].abs() + to[1].abs();
            let gained = after - before + (to[0] - from[0]) + (to[1] - from[1]);
            // And what the rounding of its depth is worth, wherever its energy lets it go.
            let rounding = f64::EPSILON * (def.position.y.abs() + x.y.abs() + height) * (scale * lift).sqrt();
            prop_assert!(gained <= 1e-6 * scale + 64.0 * rounding, "gained {gained} of {scale}: v {v}, from {}", def.velocity);
        }
    }
}
