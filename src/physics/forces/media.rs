//! What acts on a body without touching it: gravity, its engine, air, streams and liquids.
//!
//! Air Resistance is that of [`crate::physics::forces::air`]. In a liquid of density ρ and viscosity η a body of which the fraction f is inside feels
//!
//! - **Buoyancy** ρ·g·V·f (Archimedes), V its box, 1 m deep;
//! - **Viscous Drag** of three parts: the quadratic drag of the air's formula with the liquid's density, times f; Stokes' 3π·η·d·u, times
//!   f, with the mean of width and height as diameter d; and, up and down, the waves that a body makes which the surface cuts.
//!
//! **Waves.** A floating body is a spring of stiffness K = ρ·g·b, b its width in the liquid, and quadratic drag alone lets it bob with an
//! amplitude that falls as 1/t only. What really stills it is that it radiates waves: a damping in proportion to its velocity (J. N. Newman,
//! *Marine Hydrodynamics*, MIT Press 1977; DNV-RP-C205, *Environmental conditions and environmental loads*). Its strength depends on
//! the hull and the period of its motion; one damping ratio for all, ζ = [`WAVES`], is a choice. Here −2·ζ·C_d·√(K·m)·φ·u_y, so that a
//! box of C_d = 1 that floats bobs with the damping ratio ζ, and one of C_d = 0 bobs for ever with ω = √(K/m). The factor
//! φ = 2r/(1 + r)·(1 − (1 − e)⁸), r the displaced mass over the body's and e the part of its height above the surface, is 1 for what
//! floats at its waterline, falls to 0 in proportion to the depth of what only just gets wet, and fades over the last tenths of what goes
//! under (waves are made near the surface): no force jumps with the depth.
//!
//! Air acts on the part outside. Where buoyancy and the constant forces balance to rounding, what has no velocity has no acceleration, and
//! the buoyancy listed is what makes the resultant exactly zero.

use crate::physics::data::aabb::Aabb;
use crate::physics::data::body::{Body, Pose};
use crate::physics::data::def::{FieldDef, FluidDef, StreamDef};
use crate::physics::data::plan::{Part, called};
use crate::physics::forces::air::Drag;
use crate::physics::forces::bath::{Regime, STOKES, Stiffness, WAVES, dry};
use crate::physics::forces::displaced::Displaced;
use crate::physics::forces::kind::{ForceKind, Source};
use crate::physics::forces::manager::{Force, ForceManager};
use crate::physics::forces::zone_list::ZoneList;
use crate::physics::forces::zones::{Stream, fall};
use glam::DVec2;
use std::cell::Cell;

/// What a step may be off by where nothing but a rough answer is needed, as a part of its way.
const ROUGH: f64 = 1e-3;
/// The media of a world.
#[derive(Clone, Debug)]
pub(crate) struct Media {
    /// N/kg downwards.
    pub gravity: f64,
    /// kg/m³.
    pub air_density: f64,
    /// Whether the plan has drag of the air.
    pub airy: bool,
    /// Air streams, and behind them fields.
    pub streams: Vec<Stream>,
    pub fluids: Vec<FluidDef>,
    /// Whether what is asked for may be rough.
    roughly: Cell<bool>,
    ended_early: Cell<u64>,
}

/// The law by which one body moves during one interval, contacts left out.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Law {
    /// All that is constant: gravity, drive, wind, m/s².
    pub constant: DVec2,
    /// Drag of the air.
    pub air: Drag,
    /// Whether it may meet some liquid, and those near it: all that touch this box, m.
    pub wet: bool,
    pub liquids: ZoneList,
    pub near: Aabb,
    /// What it displaces of them around where it was when that was last asked for.
    pub displaced: Displaced,
    /// How long the first step of its motion may be, s, as far as that is known from what went before.
    pub first: f64,
}

impl Law {
    /// Whether some liquid is so near that it may be met.
    pub fn is_near_liquid(&self) -> bool {
        self.wet
    }

    /// Whether nothing acts that depends on place or velocity.
    pub fn is_constant(&self) -> bool {
        self.air.is_none() && !self.is_near_liquid()
    }
}

impl Media {
    /// Of zones that stay where they are.
    pub fn new(gravity: f64, air_density: f64, (streams, fields): (&[StreamDef], &[FieldDef]), fluids: Vec<FluidDef>) -> Self {
        let streams: Vec<Stream> =
            (0..).zip(streams).map(Stream::of_stream).chain((0..).zip(fields).map(Stream::of_field)).collect();
        Self { gravity, air_density, airy: true, streams, fluids, roughly: Cell::new(false), ended_early: Cell::new(0) }
    }

    /// Says whether motions through liquids need nothing but a rough answer from now on.
    pub fn ask_roughly(&self, roughly: bool) {
        self.roughly.set(roughly);
    }

    /// Whether nothing but a rough answer is needed.
    pub fn is_rough(&self) -> bool {
        self.roughly.get()
    }

    /// What a step may be off by besides, as a part of its way.
    pub fn roughness(&self) -> f64 {
        if self.roughly.get() { ROUGH } else { 0.0 }
    }

    /// Counts a flow that did not get to its end by its own steps.
    pub fn end_early(&self) {
        self.ended_early.set(self.ended_early.get() + u64::from(!self.roughly.get()));
    }

    /// How many flows did not, since this was asked last.
    pub fn take_ended_early(&self) -> u64 {
        self.ended_early.take()
    }

    /// Gravity of the world on a body, N/kg downwards.
    pub fn gravity_on(&self, body: &Body) -> f64 {
        if body.weightless { 0.0 } else { self.gravity }
    }

    /// The drag of the air on a body.
    pub fn air(&self, body: &Body) -> Drag {
        if !(self.airy && body.feels_air) {
            return Drag::default();
        }
        called(Part::Air);
        Drag::of(body, self.air_density)
    }

    /// All that is constant of what acts on a body under a `force` (N) that is not its weight, m/s².
    pub fn constant(&self, body: &Body, force: DVec2) -> DVec2 {
        let push = force / body.mass;
        DVec2::new(0.0 + push.x, fall(self.gravity_on(body), push.y))
    }

    /// The law of a body for the next `t` seconds, under a `force` (N) that is not its weight. It depends on nothing but the body itself: what
    /// else is near must change no bit of its motion.
    pub fn law(&self, body: &Body, force: DVec2, t: f64) -> Law {
        let mut law = Law::default();
        self.renew(&mut law, body, force, t);
        law
    }

    /// The same in place of an earlier one.
    pub fn renew(&self, law: &mut Law, body: &Body, force: DVec2, t: f64) {
        (law.constant, law.air) = (self.constant(body, force), self.air(body));
        if self.fluids.is_empty() {
            return;
        }
        called(Part::Liquids);
        // Half its size besides: what others push may meet a liquid earlier.
        let (around, way) = (body.half * 1.5, (body.velocity.abs() + law.constant.abs() * t) * t);
        law.near = Aabb::around(body.position, around + way);
        law.liquids = self.liquids_at(&law.near);
        law.wet = !law.liquids.is_empty();
        if law.wet {
            self.follow(law, body, body.position);
        }
    }

    /// Lets a law be that of the body at `x`; also where that is further than buoyancy was thought to drive it.
    pub fn follow(&self, law: &mut Law, body: &Body, x: DVec2) {
        if !law.near.contains(&Aabb::around(x, body.half), 0.0) {
            law.near = Aabb::around(x, law.near.size() * 0.5);
            law.liquids = self.liquids_at(&law.near);
        }
        law.displaced.renew(self, body, x, (&law.liquids, &law.near));
    }

    /// The streams and fields that a box touches within `slop` metres.
    pub fn streams_at(&self, near: &Aabb, slop: f64) -> ZoneList {
        if self.streams.is_empty() {
            return ZoneList::default();
        }
        called(Part::Streams);
        ZoneList::touching(self.streams.iter().map(|stream| &stream.zone), near, slop)
    }

    fn liquids_at(&self, near: &Aabb) -> ZoneList {
        ZoneList::touching(self.fluids.iter().map(|fluid| &fluid.zone), near, 0.0)
    }

    /// Whether a box touches a liquid.
    pub fn wets(&self, near: &Aabb) -> bool {
        if self.fluids.is_empty() {
            return false;
        }
        called(Part::Liquids);
        self.fluids.iter().any(|fluid| near.touches(&fluid.zone, 0.0))
    }

    /// Acceleration of a body at `x` with velocity `v` under `law`, m/s².
    pub fn acceleration(&self, body: &Body, law: &Law, x: DVec2, v: DVec2) -> DVec2 {
        if !law.is_near_liquid() {
            return law.constant - v * law.air.rate(v);
        }
        Regime::new(self, body, law, x).acceleration(x, v)
    }

    /// The same of a body under a `force` (N) that is not its weight, as it is.
    pub fn acceleration_under(&self, body: &Body, force: DVec2) -> DVec2 {
        if self.fluids.is_empty() {
            return self.constant(body, force) - body.velocity * self.air(body).rate(body.velocity);
        }
        self.acceleration(body, &self.law(body, force, 0.0), body.position, body.velocity)
    }

    /// The linearisation of [`Media::acceleration`].
    pub fn stiffness(&self, body: &Body, law: &Law, x: DVec2, v: DVec2) -> Stiffness {
        if !law.is_near_liquid() {
            return Stiffness { drag: law.air.stiffness(v), lift: 0.0 };
        }
        Regime::new(self, body, law, x).bath(x).answer(v)
    }

    /// How fast the body's own motion changes its acceleration within `t` seconds, 1/s: what an explicit step has to resolve.
    pub fn rate(&self, body: &Body, law: &Law, (x, v): Pose, t: f64) -> f64 {
        let of =
            |drag: &Drag, linear: f64, stiffness: f64| linear + drag.rate(v) + drag.rate(law.constant).sqrt() + stiffness.sqrt();
        if !law.is_near_liquid() {
            return of(&law.air, 0.0, 0.0);
        }
        let regime = Regime::new(self, body, law, x);
        if regime.holds_around(x, (v.abs() + law.constant.abs() * t) * t) {
            let bath = regime.bath(x);
            return of(&bath.drag, bath.linear + bath.waves, bath.stiffness);
        }
        // It may come to be wholly inside all that are near.
        let sum = |sum: (f64, f64), fluid: &FluidDef| (sum.0 + fluid.density, sum.1 + fluid.viscosity);
        let (density, viscosity) = law.liquids.iter().map(|index| &self.fluids[index as usize]).fold((0.0, 0.0), sum);
        let stiffness = density * self.gravity.abs() * 2.0 * body.half.x / body.mass;
        let linear = STOKES * viscosity * (body.half.x + body.half.y) / body.mass + 2.0 * WAVES * body.drag * stiffness.sqrt();
        of(&law.air.plus(&Drag::of(body, density)), linear, stiffness)
    }

    /// The weight of a body, N.
    pub fn weight(&self, body: &Body) -> DVec2 {
        DVec2::new(0.0, body.mass * self.gravity_on(body))
    }

    /// Appends the forces of liquids and air on a body as it moves now, under a `push` (N), to those in `out`.
    pub fn list(&self, body: &Body, law: &Law, push: DVec2, out: &mut ForceManager) {
        let (x, v, mass) = (body.position, body.velocity, body.mass);
        let mut add = |kind, source, vector| out.list(Force { kind, source, vector, point: x });
        let mut wet = 0.0;
        for i in law.liquids.iter() {
            let alone =
                Law { air: Drag::default(), liquids: ZoneList::of(std::iter::once(i)), displaced: Displaced::default(), ..*law };
            let part = Regime::new(self, body, &alone, x).bath(x);
            if part.fraction == 0.0 {
                continue;
            }
            wet += part.fraction;
            let drag = part.drag.rate(v) + part.linear;
            let drag = -v * DVec2::new(drag, drag + part.waves) * mass;
            add(ForceKind::ViscousDrag, Source::Fluid(i), drag);
            add(ForceKind::Buoyancy, Source::Fluid(i), DVec2::new(0.0, -mass * part.lift));
        }
        if !law.air.is_none() {
            add(ForceKind::AirResistance, Source::Air, -v * (law.air.rate(v) * dry(body, x, wet) * mass));
        }
        if wet > 0.0 && v.y == 0.0 {
            // With v_y = 0 no drag acts up or down, so that the last buoyancy is the last of the vertical forces.
            let regime = Regime::new(self, body, law, x);
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
        Law {
            constant: DVec2::new(0.0, media.gravity),
            air: media.air(body),
            wet: true,
            liquids: ZoneList::of(0..media.fluids.len() as u32),
            near: Aabb::around(DVec2::ZERO, DVec2::splat(1e30)),
            displaced: Displaced::default(),
            first: 0.0,
        }
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
