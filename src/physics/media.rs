//! What acts on a body without touching it: gravity, its engine, air, streams and liquids.
//!
//! Air Resistance is ½·ρ·C_d·A·|u|·u with the depth of every body 1 m: A = height when it moves more across than up or down, width
//! otherwise. In a liquid the submerged fraction f of the box displaces ρ·g·V (Archimedes) and feels the same quadratic drag with the
//! liquid's density, plus Stokes' 3π·η·d·u with d the mean of width and height as a representative diameter; air acts on the rest.

use super::tuning::{STIFF_REACH, WET};
use super::{Aabb, Body, FluidDef, Force, ForceKind, Source, StreamDef};
use glam::DVec2;

/// m. From here on a liquid counts for the steps of a motion towards it.
const NEAR: f64 = 1.0;
/// Stokes' law: 3π per diameter.
const STOKES: f64 = 3.0 * std::f64::consts::PI;

/// The media of a world.
#[derive(Clone, Debug)]
pub(super) struct Media {
    /// N/kg downwards.
    pub gravity: f64,
    /// kg/m³.
    pub air_density: f64,
    pub streams: Vec<StreamDef>,
    pub fluids: Vec<FluidDef>,
}

/// The law by which one body moves during one interval, contacts left out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Law {
    /// All that is constant: gravity, drive, wind, m/s².
    pub constant: DVec2,
    /// Drag of the air, ½·ρ·C_d·A/m, 1/m.
    pub air: f64,
    /// Exposed area, m²: what the liquids act on.
    pub area: f64,
    /// Whether it may come to a liquid soon.
    pub near_liquid: bool,
    /// Whether a liquid acts on it: one that it touches. Until then it flies as if there were none, and meeting the surface is an event.
    pub wet: bool,
    /// Scale of all forces of the media, 1 but for things in contact that are so light that they follow the media within a tick.
    pub soft: f64,
}

impl Default for Law {
    fn default() -> Self {
        Self { constant: DVec2::ZERO, air: 0.0, area: 0.0, near_liquid: false, wet: false, soft: 1.0 }
    }
}

/// The fraction of a body's box that lies inside a zone, 0 … 1.
pub(super) fn submerged(position: DVec2, half: DVec2, zone: &Aabb) -> f64 {
    let inside = (position + half).min(zone.max) - (position - half).max(zone.min);
    let inside = inside.max(DVec2::ZERO);
    (inside.x * inside.y) / (4.0 * half.x * half.y)
}

/// Whether something moves more across than up or down: the side that then meets the air is its height. On the border between the two
/// (and at rest) it is `force` that decides: drag alone leaves the direction as it is.
pub(super) fn moves_across(v: DVec2, force: DVec2) -> bool {
    let turns = |v: f64, force: f64| if v == 0.0 { force.abs() } else { force * v.signum() };
    if v.x.abs() == v.y.abs() { turns(v.x, force.x) > turns(v.y, force.y) } else { v.x.abs() > v.y.abs() }
}

impl Law {
    /// Whether nothing acts that depends on place or velocity.
    pub fn is_constant(&self) -> bool {
        self.air == 0.0 && !self.wet
    }
}

impl Media {
    /// The law of a body that gets no further than `searched` in a tick; without the streams that it feels.
    pub fn law(&self, body: &Body, drive: DVec2, searched: &Aabb) -> Law {
        let area = 2.0 * if body.velocity.x.abs() > body.velocity.y.abs() { body.half.y } else { body.half.x };
        let air = if body.feels_air { 0.5 * self.air_density * body.drag * area / body.mass } else { 0.0 };
        let wet = self.fluids.iter().any(|fluid| searched.touches(&fluid.zone, 0.0));
        Law { constant: DVec2::new(0.0, self.gravity) + drive / body.mass, air, area, near_liquid: wet, wet, soft: 1.0 }
    }

    /// How the acceleration of a body answers to its own motion: −∂a/∂v (1/s) and −∂a/∂x (1/s²) along each axis.
    pub fn stiffness(&self, body: &Body, law: &Law, x: DVec2, v: DVec2) -> (DVec2, DVec2) {
        (DVec2::splat(self.rate(body, law, v)), DVec2::new(0.0, self.floats(body, x)))
    }

    /// Acceleration of a body at `x` with velocity `v` under `law`, m/s².
    pub fn acceleration(&self, body: &Body, law: &Law, x: DVec2, v: DVec2) -> DVec2 {
        let mut a = law.constant;
        let mut dry = 1.0;
        if law.wet {
            for fluid in &self.fluids {
                let f = submerged(x, body.half, &fluid.zone);
                if f > 0.0 {
                    dry -= f;
                    a += (self.buoyancy(body, fluid, f) + viscous_drag(body, fluid, law.area, f, v)) * (law.soft / body.mass);
                }
            }
            dry = f64::max(dry, 0.0);
        }
        if law.air > 0.0 {
            a -= v * (law.air * law.soft * dry * v.length());
        }
        a
    }

    /// How fast the body's own motion changes its acceleration at velocity `v`, 1/s: what a Runge–Kutta step has to resolve.
    pub fn rate(&self, body: &Body, law: &Law, v: DVec2) -> f64 {
        let (mut quadratic, mut linear, mut stiffness) = (law.air, 0.0, 0.0);
        if law.wet {
            for fluid in &self.fluids {
                if submerged(body.position, body.half + NEAR, &fluid.zone) > 0.0 {
                    quadratic += 0.5 * fluid.density * body.drag * law.area / body.mass;
                    linear += STOKES * fluid.viscosity * (body.half.x + body.half.y) / body.mass;
                    stiffness += fluid.density * self.gravity.abs() * 2.0 * body.half.x.max(body.half.y) / body.mass;
                }
            }
        }
        linear + quadratic * v.length() + (quadratic * law.constant.length()).sqrt() + stiffness.sqrt()
    }

    /// Whether a liquid acts on a body now: it touches it. What is so light that it would bob there many times within a `tick` (s) is
    /// within the liquid's reach already when it is near.
    pub fn is_met(&self, body: &Body, fluid: &FluidDef, tick: f64) -> bool {
        let stiffness = fluid.density * self.gravity.abs() * 2.0 * body.half.x / body.mass;
        let reach = if stiffness.sqrt() * tick > STIFF_REACH { NEAR } else { WET };
        body.bounds().touches(&fluid.zone, reach)
    }

    /// Whether the surface of a liquid cuts a body.
    pub fn cuts(&self, body: &Body) -> bool {
        self.fluids.iter().map(|fluid| submerged(body.position, body.half, &fluid.zone)).any(|f| f > 0.0 && f < 1.0)
    }

    /// By how much a body at `x` that floats on a surface is drawn back to it, 1/s²: the change of its buoyancy with its depth.
    pub fn floats(&self, body: &Body, x: DVec2) -> f64 {
        let (top, bottom) = (x - body.half, x + body.half);
        let stiffness = self.fluids.iter().map(|FluidDef { zone, density, .. }| {
            let width = (bottom.x.min(zone.max.x) - top.x.max(zone.min.x)).max(0.0);
            let cut = top.y < zone.min.y && bottom.y > zone.min.y && bottom.y < zone.max.y;
            if cut { density * self.gravity * width } else { 0.0 }
        });
        stiffness.sum::<f64>() / body.mass
    }

    fn buoyancy(&self, body: &Body, fluid: &FluidDef, f: f64) -> DVec2 {
        DVec2::new(0.0, -fluid.density * self.gravity * 4.0 * body.half.x * body.half.y * f)
    }

    /// Lists the named forces on a body as it moves now, the engine's drive (N) included.
    pub fn list(&self, body: &Body, drive: DVec2, in_stream: impl Fn(usize) -> bool, out: &mut Vec<Force>) {
        let law = &self.law(body, drive, &body.bounds());
        let mut add = |kind, source, vector: DVec2| {
            if vector != DVec2::ZERO {
                out.push(Force { kind, source, vector, point: body.position });
            }
        };
        add(ForceKind::Weight, Source::Gravity, DVec2::new(0.0, body.mass * self.gravity));
        add(ForceKind::Drive, Source::Engine, drive);
        for (i, stream) in self.streams.iter().enumerate() {
            if in_stream(i) {
                add(ForceKind::Wind, Source::Stream(i as u32), stream.force);
            }
        }
        let mut dry = 1.0;
        if law.wet {
            for (i, fluid) in self.fluids.iter().enumerate() {
                let f = submerged(body.position, body.half, &fluid.zone);
                if f > 0.0 {
                    dry -= f;
                    add(ForceKind::Buoyancy, Source::Fluid(i as u32), self.buoyancy(body, fluid, f));
                    add(ForceKind::ViscousDrag, Source::Fluid(i as u32), viscous_drag(body, fluid, law.area, f, body.velocity));
                }
            }
            dry = f64::max(dry, 0.0);
        }
        if law.air > 0.0 {
            let v = body.velocity;
            let k = 0.5 * self.air_density * body.drag * law.area;
            add(ForceKind::AirResistance, Source::Air, -v * (k * dry * v.length()));
        }
    }
}

fn viscous_drag(body: &Body, fluid: &FluidDef, area: f64, f: f64, v: DVec2) -> DVec2 {
    let quadratic = 0.5 * fluid.density * body.drag * area * v.length();
    let viscous = STOKES * fluid.viscosity * (body.half.x + body.half.y);
    -v * (f * (quadratic + viscous))
}
