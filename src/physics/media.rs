//! What acts on a body without touching it: gravity, its engine, air, streams and liquids.
//!
//! Air Resistance is that of [`super::air`]. In a liquid of density ρ and viscosity η a body of which the fraction f is inside feels
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

use super::air::Drag;
use super::tuning::SLOP;
use super::zone_tree::{ZoneList, ZoneTree};
use super::zones::{Stream, fall};
use super::{Aabb, Body, FieldDef, FluidDef, Force, ForceKind, Source, StreamDef};
use glam::DVec2;
use std::cell::Cell;

/// Stokes' law: 3π per diameter.
const STOKES: f64 = 3.0 * std::f64::consts::PI;
/// Damping ratio of what floats at its waterline, per unit of C_d. Smaller: 300 kg on water are not at rest after a minute; larger: a
/// splash calms down within one bob.
const WAVES: f64 = 0.15;
/// Relative: what rounding leaves of a balance of forces. Smaller: what floats never comes to rest; larger: it rests beside its waterline.
const BALANCE: f64 = 4e-14;

/// What the work of a law is counted in, as in `events`: about a nanosecond. A bath, and each liquid of it.
const WORK_OF_A_BATH: u64 = 10;
const WORK_OF_A_LIQUID: u64 = 10;

/// The media of a world.
#[derive(Clone, Debug)]
pub(super) struct Media {
    /// N/kg downwards.
    pub gravity: f64,
    /// kg/m³.
    pub air_density: f64,
    /// Air streams, and behind them fields.
    pub streams: Vec<Stream>,
    pub fluids: Vec<FluidDef>,
    /// Where these are.
    blowing: ZoneTree,
    wet: ZoneTree,
    /// What it has taken so far to evaluate laws, in units of work; and what it may have taken in all before motions through liquids are told
    /// by one step each.
    work: Cell<u64>,
    limit: Cell<u64>,
}

/// The law by which one body moves during one interval, contacts left out.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Law {
    /// All that is constant: gravity, drive, wind, m/s².
    pub constant: DVec2,
    /// Drag of the air.
    pub air: Drag,
    /// The liquids that it may meet. It flies as if there were no others.
    pub liquids: ZoneList,
}

impl Law {
    /// Whether some liquid is so near that it may be met.
    pub fn is_near_liquid(&self) -> bool {
        !self.liquids.is_empty()
    }

    /// Whether nothing acts that depends on place or velocity.
    pub fn is_constant(&self) -> bool {
        self.air.is_none() && !self.is_near_liquid()
    }
}

/// How the acceleration by the media answers to small changes of a state: what an implicit step needs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Stiffness {
    /// −∂a/∂v along either axis, 1/s, ≥ 0.
    pub drag: DVec2,
    /// −∂a_y/∂y by buoyancy, 1/s², ≥ 0.
    pub lift: f64,
}

/// What a liquid, or all media together, do to a body at a place, per mass.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bath {
    /// The fraction of the body that is inside.
    pub fraction: f64,
    pub drag: Drag,
    /// Stokes' drag, 1/s.
    pub linear: f64,
    /// Damping by waves, up and down, 1/s.
    pub waves: f64,
    /// Buoyancy upwards, m/s².
    pub lift: f64,
    /// K/m, 1/s².
    pub stiffness: f64,
    /// Whether the bath is the same a little to each side, and everywhere around.
    pub same_across: bool,
    pub same_around: bool,
}

impl Bath {
    /// Acceleration at velocity `v` if no medium did more than this and `constant` did the rest, m/s².
    pub fn acceleration(&self, constant: DVec2, v: DVec2) -> DVec2 {
        let drag = self.drag.rate(v) + self.linear;
        DVec2::new(constant.x - v.x * drag, (constant.y - self.lift) - v.y * (drag + self.waves))
    }

    /// Its linearisation at velocity `v`.
    pub fn answer(&self, v: DVec2) -> Stiffness {
        Stiffness { drag: self.drag.stiffness(v) + self.linear + DVec2::new(0.0, self.waves), lift: self.stiffness }
    }

    /// m/s²: what is left of a balance along the vertical at `y` if it is nothing but rounding.
    pub fn rounding(&self, constant: DVec2, body: &Body, y: f64) -> f64 {
        BALANCE * (constant.y.abs() + self.lift.abs() + self.stiffness * (y.abs() + body.half.y))
    }
}

impl Media {
    /// Of zones that stay where they are.
    pub fn new(gravity: f64, air_density: f64, (streams, fields): (&[StreamDef], &[FieldDef]), fluids: Vec<FluidDef>) -> Self {
        let streams: Vec<Stream> =
            (0..).zip(streams).map(Stream::of_stream).chain((0..).zip(fields).map(Stream::of_field)).collect();
        let blowing = ZoneTree::of(streams.iter().map(|stream| stream.zone));
        let wet = ZoneTree::of(fluids.iter().map(|fluid| fluid.zone));
        Self { gravity, air_density, streams, fluids, blowing, wet, work: Cell::new(0), limit: Cell::new(u64::MAX) }
    }

    /// Counts what it takes to evaluate a law.
    pub fn spend(&self, work: u64) {
        self.work.set(self.work.get() + work);
    }

    /// What has been counted, from the beginning.
    pub fn spent(&self) -> u64 {
        self.work.get()
    }

    /// Says how much motions through liquids may take from now on.
    pub fn allow(&self, work: u64) {
        self.limit.set(self.work.get().saturating_add(work));
    }

    /// Whether they have taken that.
    pub fn is_spent(&self) -> bool {
        self.work.get() > self.limit.get()
    }

    /// Gravity of the world on a body, N/kg downwards.
    fn gravity_on(&self, body: &Body) -> f64 {
        if body.weightless { 0.0 } else { self.gravity }
    }

    /// The drag of the air on a body.
    pub fn air(&self, body: &Body) -> Drag {
        if body.feels_air { Drag::of(body, self.air_density) } else { Drag::default() }
    }

    /// The law of a body for the next `t` seconds, under a `force` (N) that is not its weight. It depends on nothing but the body itself: what
    /// else is near must change no bit of its motion.
    pub fn law(&self, body: &Body, force: DVec2, t: f64) -> Law {
        let push = force / body.mass;
        let constant = DVec2::new(0.0 + push.x, fall(self.gravity_on(body), push.y));
        // Half its size besides: what others push may meet a liquid earlier.
        let reach = body.half * 1.5 + (body.velocity.abs() + constant.abs() * t) * t;
        let near = Aabb::around(body.position, reach);
        Law { constant, air: self.air(body), liquids: self.wet.near(&near, 0.0) }
    }

    /// Appends the streams that a box touches, in ascending order.
    pub fn streams_near(&self, near: &Aabb, into: &mut Vec<u32>) {
        let from = into.len();
        self.blowing.touching(near, SLOP, |stream| into.push(stream));
        into[from..].sort_unstable();
    }

    /// The streams that a box touches, and maybe some near it, in ascending order.
    pub fn streams_at(&self, near: &Aabb) -> impl Iterator<Item = &Stream> {
        self.blowing.near(near, 2.0 * SLOP).iter().map(|stream| &self.streams[stream as usize])
    }

    /// Whether a box touches a liquid.
    pub fn wets(&self, near: &Aabb) -> bool {
        self.wet.any(near)
    }

    /// The liquids of a law, with their indices.
    pub fn liquids<'a>(&'a self, law: &'a Law) -> impl Iterator<Item = (u32, &'a FluidDef)> {
        law.liquids.iter().map(|index| (index, &self.fluids[index as usize]))
    }

    /// What one liquid does to a body at `x`; none where it does not reach.
    #[inline]
    fn part(&self, body: &Body, fluid: &FluidDef, x: DVec2) -> Option<Bath> {
        let (zone, half) = (&fluid.zone, body.half);
        let (top_left, bottom_right) = (x - half, x + half);
        let inside = bottom_right.min(zone.max) - top_left.max(zone.min);
        if inside.x <= 0.0 || inside.y <= 0.0 {
            return None;
        }
        let (width, height) = (2.0 * half.x, 2.0 * half.y);
        let fraction = (inside.x * inside.y) / (width * height);
        let (displaced, per_mass) = (fluid.density * (inside.x * inside.y), 1.0 / body.mass);
        let contained = top_left.cmpge(zone.min) & bottom_right.cmple(zone.max);
        let mut bath = Bath {
            fraction,
            drag: Drag::of(body, fluid.density).scaled(fraction),
            linear: STOKES * fluid.viscosity * (half.x + half.y) * fraction * per_mass,
            lift: displaced * self.gravity * per_mass,
            same_across: contained.x,
            same_around: contained.all(),
            ..Bath::default()
        };
        // The surface is the side that buoyancy points to.
        let down = self.gravity >= 0.0;
        let emerged = if down { zone.min.y - top_left.y } else { bottom_right.y - zone.max.y };
        if emerged > 0.0 {
            let stiffness = fluid.density * self.gravity.abs() * inside.x * per_mass;
            let sunk = if down { bottom_right.y <= zone.max.y } else { top_left.y >= zone.min.y };
            bath.stiffness = if sunk { stiffness } else { 0.0 };
            let ratio = displaced * per_mass;
            let under = (1.0 - emerged / height).max(0.0);
            let fourth = (under * under) * (under * under);
            let fades = 1.0 - fourth * fourth;
            bath.waves = 2.0 * WAVES * body.drag * stiffness.sqrt() * (2.0 * ratio / (1.0 + ratio)) * fades;
        }
        Some(bath)
    }

    /// What all media do to a body at `x`.
    pub fn bath(&self, body: &Body, law: &Law, x: DVec2) -> Bath {
        self.spend(WORK_OF_A_BATH + WORK_OF_A_LIQUID * u64::from(law.liquids.len()));
        let mut all = Bath { same_across: true, same_around: true, ..Bath::default() };
        for (_, fluid) in self.liquids(law) {
            let Some(part) = self.part(body, fluid, x) else { continue };
            all.fraction += part.fraction;
            all.drag = all.drag.plus(&part.drag);
            all.linear += part.linear;
            all.waves += part.waves;
            all.lift += part.lift;
            all.stiffness += part.stiffness;
            all.same_across &= part.same_across;
            all.same_around &= part.same_around;
        }
        if !law.air.is_none() {
            all.drag = all.drag.plus(&law.air.scaled((1.0 - all.fraction).max(0.0)));
        }
        all
    }

    /// Acceleration of a body at `x` with velocity `v` under `law`, m/s².
    pub fn acceleration(&self, body: &Body, law: &Law, x: DVec2, v: DVec2) -> DVec2 {
        if !law.is_near_liquid() {
            return law.constant - v * law.air.rate(v);
        }
        let bath = self.bath(body, law, x);
        let mut a = bath.acceleration(law.constant, v);
        if balances(&bath, law, body, x, v, a) {
            a.y = 0.0;
        }
        a
    }

    /// The linearisation of [`Media::acceleration`].
    pub fn stiffness(&self, body: &Body, law: &Law, x: DVec2, v: DVec2) -> Stiffness {
        if !law.is_near_liquid() {
            return Stiffness { drag: law.air.stiffness(v), lift: 0.0 };
        }
        self.bath(body, law, x).answer(v)
    }

    /// How fast the body's own motion changes its acceleration at velocity `v`, 1/s: what an explicit step has to resolve.
    pub fn rate(&self, body: &Body, law: &Law, v: DVec2) -> f64 {
        let (mut drag, mut linear, mut stiffness) = (law.air, 0.0, 0.0);
        for (_, fluid) in self.liquids(law) {
            drag = drag.plus(&Drag::of(body, fluid.density));
            linear += STOKES * fluid.viscosity * (body.half.x + body.half.y) / body.mass;
            stiffness += fluid.density * self.gravity.abs() * 2.0 * body.half.x / body.mass;
        }
        linear + drag.rate(v) + drag.rate(law.constant).sqrt() + (1.0 + 2.0 * WAVES * body.drag) * stiffness.sqrt()
    }

    /// Lists the named forces on a body as it moves now, the engine's drive (N) included.
    pub fn list(&self, body: &Body, law: &Law, drive: DVec2, in_stream: impl Fn(usize) -> bool, out: &mut Vec<Force>) {
        let (x, v, mass) = (body.position, body.velocity, body.mass);
        let (mut sum, mut last) = (DVec2::ZERO, None);
        let mut add = |kind, source, vector: DVec2| {
            if vector != DVec2::ZERO {
                if kind == ForceKind::Buoyancy {
                    last = Some((out.len(), sum));
                }
                sum += vector;
                out.push(Force { kind, source, vector, point: x });
            }
        };
        add(ForceKind::Weight, Source::Gravity, DVec2::new(0.0, mass * self.gravity_on(body)));
        add(ForceKind::Drive, Source::Engine, drive);
        for (i, stream) in self.streams.iter().enumerate() {
            if in_stream(i) {
                add(stream.kind, stream.source, stream.on(body));
            }
        }
        let mut dry = 1.0;
        for (i, fluid) in self.liquids(law) {
            let Some(part) = self.part(body, fluid, x) else { continue };
            dry -= part.fraction;
            let drag = part.drag.rate(v) + part.linear;
            let drag = -v * DVec2::new(drag, drag + part.waves) * mass;
            add(ForceKind::ViscousDrag, Source::Fluid(i), drag);
            add(ForceKind::Buoyancy, Source::Fluid(i), DVec2::new(0.0, -mass * part.lift));
        }
        if !law.air.is_none() {
            add(ForceKind::AirResistance, Source::Air, -v * (law.air.rate(v) * f64::max(dry, 0.0) * mass));
        }
        if let Some((index, before)) = last
            && v.y == 0.0
        {
            // With v_y = 0 no drag acts up or down, so that the last buoyancy is the last of the vertical forces.
            let bath = self.bath(body, law, x);
            if balances(&bath, law, body, x, v, bath.acceleration(law.constant, v)) {
                out[index].vector.y = -before.y;
            }
        }
    }
}

/// Whether the vertical forces on what has no vertical velocity balance but for rounding.
fn balances(bath: &Bath, law: &Law, body: &Body, x: DVec2, v: DVec2, a: DVec2) -> bool {
    v.y == 0.0 && bath.fraction > 0.0 && a.y.abs() <= bath.rounding(law.constant, body, x.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, WorldDef};

    fn pool(density: f64, viscosity: f64) -> Media {
        let zone = Aabb::new(DVec2::new(-10.0, 0.0), DVec2::new(10.0, 20.0));
        let def = WorldDef { fluids: vec![FluidDef { zone, density, viscosity }], ..WorldDef::default() };
        Media::new(15.0, 1.2, (&[], &[]), def.fluids)
    }

    fn law(media: &Media, body: &Body) -> Law {
        Law { constant: DVec2::new(0.0, media.gravity), air: media.air(body), liquids: ZoneList::of(0..media.fluids.len() as u32) }
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
