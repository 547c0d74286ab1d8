//! The law by which a body moves that touches nothing: constant forces, drag and buoyancy.

use crate::physics::data::{Aabb, Body, FluidDef, Part, Pose, WAVES, called};
use crate::physics::forces::liquid::{Regime, Stiffness, dry, sure};
use crate::physics::forces::{air::Drag, displaced::Displaced, displaced::STOKES, kind::ForceKind, kind::Source, media::Media};
use crate::physics::forces::{manager::Force, manager::ForceManager, media::fall};
use glam::DVec2;

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Law {
    /// The constant acceleration: gravity, drive, wind, fields, m/s².
    pub constant: DVec2,
    pub air: Drag,
    pub displaced: Displaced,
    /// The longest first step of its motion, s, by the steps before; 0 where none is known.
    pub first: f64,
    pub rough: bool,
}

impl Law {
    pub fn is_near_liquid(&self) -> bool {
        !self.displaced.liquids.is_empty()
    }

    pub fn is_constant(&self) -> bool {
        self.air.is_none() && !self.is_near_liquid()
    }

    #[inline(always)]
    pub fn regime<'a>(&'a self, media: &'a Media, body: &'a Body, x: DVec2) -> Regime<'a> {
        let mut regime = self.around(media, body);
        regime.follow(x);
        regime
    }

    /// Its regime where its forms hold.
    #[inline(always)]
    pub fn around<'a>(&'a self, media: &'a Media, body: &'a Body) -> Regime<'a> {
        let air = if self.air.is_none() { 0.0 } else { media.air_density };
        Regime::new(media, body, self.constant, air, &self.displaced)
    }
}

impl Media {
    /// The constant acceleration of a body by its weight and a `force` (N), m/s².
    pub fn constant(&self, body: &Body, force: DVec2) -> DVec2 {
        let push = force / body.mass;
        DVec2::new(0.0 + push.x, fall(self.gravity_on(body), push.y))
    }

    /// The law of a body for the next `t` seconds, under its weight and a `force` (N). It depends on the body alone.
    pub fn law(&self, body: &Body, force: DVec2, t: f64) -> Law {
        let mut law = Law::default();
        self.renew(&mut law, body, force, t);
        law
    }

    pub fn renew(&self, law: &mut Law, body: &Body, force: DVec2, t: f64) {
        (law.constant, law.air) = (self.constant(body, force), self.air(body));
        if self.fluids.is_empty() {
            return;
        }
        called(Part::Liquids);
        // Half its size besides: a body that others push may meet a liquid earlier.
        let (around, way) = (body.half * 1.5, (body.velocity.abs() + law.constant.abs() * t) * t);
        law.displaced.look(self, body, Aabb::around(body.position, around + way), body.position);
    }

    /// Acceleration of a body at `x` with velocity `v` under `law`, m/s².
    pub fn acceleration(&self, body: &Body, law: &Law, x: DVec2, v: DVec2) -> DVec2 {
        if law.is_near_liquid() { law.regime(self, body, x).acceleration(x, v) } else { law.constant - v * law.air.rate(v) }
    }

    /// Acceleration of a body in its present pose, under its weight and a `force` (N), m/s².
    pub fn acceleration_under(&self, body: &Body, force: DVec2) -> DVec2 {
        if self.fluids.is_empty() {
            return self.constant(body, force) - body.velocity * self.air(body).rate(body.velocity);
        }
        self.acceleration(body, &self.law(body, force, 0.0), body.position, body.velocity)
    }

    pub fn stiffness(&self, body: &Body, law: &Law, x: DVec2, v: DVec2) -> Stiffness {
        let near = law.is_near_liquid();
        if near { law.regime(self, body, x).bath(x).answer(v) } else { Stiffness { drag: law.air.stiffness(v), lift: 0.0 } }
    }

    /// Rate of bobbing, and of drag after an acceleration `a`, 1/s.
    pub fn bending(&self, body: &Body, law: &Law, x: DVec2, a: DVec2) -> f64 {
        if !law.is_near_liquid() {
            return law.air.rate(a).sqrt();
        }
        let bath = law.regime(self, body, x).bath(x);
        bath.stiffness.sqrt() + bath.drag.rate(a).sqrt()
    }

    /// Rate at which the body's motion changes its acceleration within `t` seconds, 1/s: an explicit step has to resolve it.
    pub fn rate(&self, body: &Body, law: &Law, (x, v): Pose, t: f64) -> f64 {
        let of = |drag: &Drag, linear: f64, lift: f64| linear + drag.rate(v) + drag.rate(law.constant).sqrt() + lift.sqrt();
        if !law.is_near_liquid() {
            return of(&law.air, 0.0, 0.0);
        }
        let (regime, way) = (law.regime(self, body, x), (v.abs() + law.constant.abs() * t) * t);
        if regime.displaced.holds_along([x - way, x + way]) {
            let bath = regime.bath(x);
            return of(&bath.drag, bath.linear + bath.waves, bath.stiffness);
        }
        // As if the body were wholly inside all liquids nearby.
        let sum = |sum: (f64, f64), fluid: &FluidDef| (sum.0 + fluid.density, sum.1 + fluid.viscosity);
        let (density, viscosity) = law.displaced.liquids.iter().map(|index| &self.fluids[index as usize]).fold((0.0, 0.0), sum);
        let stiffness = density * self.gravity.abs() * 2.0 * body.half.x / body.mass;
        let linear = STOKES * viscosity * (body.half.x + body.half.y) / body.mass + 2.0 * WAVES * body.drag * stiffness.sqrt();
        of(&law.air.plus(&Drag::of(body, density)), linear, stiffness)
    }

    /// Appends the forces of liquids and air on a body as it moves now, under a `push` (N).
    pub fn list(&self, body: &Body, law: &Law, push: DVec2, out: &mut ForceManager) {
        let (x, v, mass) = (body.position, body.velocity, body.mass);
        let mut add = |kind, source, vector| out.list(Force { kind, source, vector, point: x });
        let mut wet = 0.0;
        for i in law.displaced.liquids.iter() {
            let alone = Law { air: Drag::default(), displaced: law.displaced.alone(i), ..*law };
            let part = alone.regime(self, body, x).bath(x);
            if part.fraction == 0.0 {
                continue;
            }
            wet += part.fraction;
            let drag = part.drag.rate(v) + part.linear;
            add(ForceKind::ViscousDrag, Source::Fluid(i), -v * DVec2::new(drag, drag + part.waves) * mass);
            add(ForceKind::Buoyancy, Source::Fluid(i), DVec2::new(0.0, -mass * part.lift));
        }
        if !law.air.is_none() {
            let dry = dry(wet, sure(body, x));
            add(ForceKind::AirResistance, Source::Air, -v * (law.air.rate(v) * dry * mass));
        }
        if wet > 0.0 && v.y == 0.0 {
            // With v_y = 0 the last buoyancy is the last of the vertical forces.
            let regime = law.regime(self, body, x);
            let bath = regime.bath(x);
            if regime.balances(&bath, x, bath.acceleration(self.constant(body, push), v).y) {
                out.balance(ForceKind::Buoyancy);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::data::body::BodyDef;
    use crate::physics::data::def::WorldDef;

    fn pool(density: f64, viscosity: f64) -> Media {
        let zone = Aabb::new(DVec2::new(-10.0, 0.0), DVec2::new(10.0, 20.0));
        let def = WorldDef { fluids: vec![FluidDef { zone, density, viscosity }], ..WorldDef::default() };
        Media::new(15.0, 1.2, (&[], &[]), def.fluids)
    }

    fn law(media: &Media, body: &Body) -> Law {
        media.law(body, DVec2::ZERO, 1e10)
    }

    #[test]
    fn the_linearisation_is_that_of_the_acceleration() {
        let media = pool(900.0, 3.0);
        for round in [false, true] {
            for depth in [-1.0, 0.2, 3.0] {
                let position = DVec2::new(0.0, depth);
                let body = Body::new(&BodyDef { position, mass: 200.0, half: DVec2::new(0.4, 0.7), round, ..BodyDef::default() });
                let (law, v) = (law(&media, &body), DVec2::new(3.0, -2.0));
                let at = |x: DVec2, v: DVec2| media.acceleration(&body, &law, position + x, v);
                let found = media.stiffness(&body, &law, position, v);
                let step = 1e-6;
                let (across, down) = (DVec2::new(step, 0.0), DVec2::new(0.0, step));
                let drag = DVec2::new(
                    (at(DVec2::ZERO, v - across) - at(DVec2::ZERO, v + across)).x,
                    (at(DVec2::ZERO, v - down) - at(DVec2::ZERO, v + down)).y,
                );
                assert!((found.drag - drag / (2.0 * step)).length() < 1e-6, "{depth} m: {found:?}, not {drag}");
                // At rest nothing but buoyancy changes with the depth.
                let lift = (at(-down, DVec2::ZERO) - at(down, DVec2::ZERO)).y / (2.0 * step);
                assert!((found.lift - lift).abs() < 1e-6, "{depth} m: {found:?}, not {lift}");
            }
        }
    }

    /// Getting wet, going under: a step of a nanometre changes no force by more than that.
    #[test]
    fn no_force_jumps_with_the_depth() {
        let media = pool(1000.0, 1.0);
        for mass in [0.05, 30.0, 300.0, 900.0] {
            let body = Body::new(&BodyDef { mass, ..BodyDef::default() });
            let law = law(&media, &body);
            for v in [DVec2::new(2.0, 3.0), DVec2::new(0.0, -5.0)] {
                for depth in [-0.5, 0.5, 19.5, 20.5] {
                    let at = |y: f64| media.acceleration(&body, &law, DVec2::new(0.0, y), v) * body.mass;
                    let jump = (at(depth + 1e-9) - at(depth - 1e-9)).length();
                    assert!(jump < 1e-2, "{mass} kg at {depth} m, {v}: {jump} N");
                }
            }
        }
    }
}
