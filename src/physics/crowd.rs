//! Worlds of many bodies: the same world, advanced by the general method of [`super::pile`] instead of interval by interval.
//!
//! The plan chooses it by the number of bodies alone ([`CROWD`]). Up to there every impact, slide and zone edge is an event of its own and
//! exact; above, a tick is one step for all: contacts along gravity are still exact at any mass ratio and positions never overlap, and
//! what flies through air and zones does so as exactly as alone ([`super::passage`]).
//!
//! What a crowd does not do: impacts within one tick have no order, and slides do not end within it; upright walls and ceilings rub
//! nothing; what touches something is in a zone or out of it as its velocity says, and a crossing moves it by the mean force of the tick;
//! the crowd sleeps as a whole or not at all.

use super::air::Drag;
use super::candidates::Pair;
use super::media::Law;
use super::pile::{Axis, ContactForce, Other, Pile, PileBody, PileDef, PileSurface};
use super::{Body, DefError, World};
use glam::DVec2;

/// Up to this many bodies the exact method is used. A heap of 100 costs it 200 ns a body and tick and the general method 30, and the exact
/// one grows faster than linearly; a level that a person flies through seldom has more than a dozen.
pub(super) const CROWD: usize = 64;

/// Forces on one body for which there is room from the start. Fewer: what is hit from all sides for the first time allocates.
const FORCES: usize = 32;

/// Forces whose sum is smaller than this part of the largest balance each other if the solver says so. Below 1e-14 rounding would be
/// listed as a resultant of something at rest.
const ROUNDING: f64 = 1e-11;

/// The part of a world that only crowds have.
#[derive(Clone, Debug)]
pub(super) struct Crowd {
    pile: Pile,
    contacts: Vec<ContactForce>,
    /// What touched something in the last tick.
    touched: Vec<bool>,
}

impl World {
    /// Hands the bodies over to the general method if there are many.
    ///
    /// # Errors
    /// What the general method refuses.
    pub(super) fn gather_crowd(&mut self) -> Result<(), DefError> {
        self.crowd = None;
        if !self.plan.crowd {
            return Ok(());
        }
        let area = |body: &Body, side: f64| if body.feels_air { body.drag * side } else { 0.0 };
        let body = |body: &Body| PileBody {
            position: body.position,
            half: body.half,
            velocity: body.velocity,
            mass: body.mass,
            restitution: body.restitution,
            static_friction: body.material.static_friction,
            kinetic_friction: body.material.kinetic_friction,
            drag_area: if body.round {
                DVec2::ZERO
            } else {
                DVec2::new(area(body, 2.0 * body.half.x), area(body, 2.0 * body.half.y))
            },
            drag_round: if body.round { area(body, body.half.x + body.half.y) } else { 0.0 },
        };
        let surfaces = self.surfaces.iter().map(|surface| PileSurface {
            bounds: surface.bounds,
            static_friction: surface.material.static_friction,
            kinetic_friction: surface.material.kinetic_friction,
        });
        let pile = Pile::new(PileDef {
            bodies: self.bodies.iter().map(body).collect(),
            surfaces: surfaces.collect(),
            gravity: self.media.gravity,
            air_density: self.media.air_density,
            rest_speed: self.rest_speed,
            sleep: true,
        })
        .map_err(|error| DefError(error.0))?;
        self.forces.iter_mut().for_each(|forces| forces.renew().reserve(FORCES));
        self.crowd = Some(Box::new(Crowd { pile, contacts: Vec::new(), touched: Vec::new() }));
        Ok(())
    }

    /// One tick of a crowd.
    pub(super) fn step_crowd(&mut self, crowd: &mut Crowd, dt: f64) {
        for (i, body) in self.bodies.iter().enumerate() {
            crowd.pile.set_force(i, self.outer_force(body, &self.laws[i], dt));
        }
        if self.plan.media() {
            self.guide_crowd(crowd, dt);
        }
        crowd.pile.step(dt);
        self.show_crowd(crowd);
        for (i, body) in self.bodies.iter_mut().enumerate() {
            (body.position, body.velocity) = (crowd.pile.position(i), crowd.pile.velocity(i));
        }
        self.report_crowd(crowd);
        if crowd.pile.is_asleep() && self.bodies.iter().zip(&self.previous).all(|(body, previous)| body.position == *previous) {
            self.awake.clear();
        }
    }

    /// Tells bodies where they would get to if no constant force says it: near zones, and where they are held.
    fn guide_crowd(&mut self, crowd: &mut Crowd, dt: f64) {
        let Crowd { pile, contacts, touched } = crowd;
        touched.clear();
        touched.resize(self.bodies.len(), false);
        let mut touch = |item: usize| {
            if let Some(touched) = touched.get_mut(item) {
                *touched = true;
            }
        };
        for contact in &*contacts {
            touch(contact.a);
            touch(self.item(contact.b) as usize);
        }
        if !pile.has_stepped() {
            for contact in &self.contacts {
                touch(contact.lo as usize);
                touch(contact.hi as usize);
            }
        }
        for (i, touched) in touched.iter().enumerate() {
            if let Some((position, velocity)) = self.passage(i, dt, *touched) {
                pile.guide(i, position, velocity);
            }
        }
    }

    /// What acts on a body besides weight, air and contacts, N: drive, wind and liquids, as they are at the tick's start.
    fn outer_force(&self, body: &Body, law: &Law, dt: f64) -> DVec2 {
        let mut law = Law { air: Drag::default(), ..*law };
        if law.is_near_liquid() {
            // A force held for a whole tick must not turn a motion round.
            law.soft = (1.0 / (self.media.rate(body, &law, body.velocity) * dt)).min(1.0);
        }
        let weight = DVec2::new(0.0, self.media.gravity);
        (self.media.acceleration(body, &law, body.position, body.velocity) - weight) * body.mass
    }

    /// Lists the forces of the last step.
    fn show_crowd(&mut self, crowd: &mut Crowd) {
        for i in 0..self.bodies.len() {
            self.list_media_forces(i);
        }
        crowd.contacts.clear();
        crowd.pile.contact_forces(&mut crowd.contacts);
        for contact in &crowd.contacts {
            let (normal, friction) = match contact.axis {
                Axis::Gravity => (DVec2::new(0.0, contact.normal), DVec2::new(contact.friction, 0.0)),
                Axis::Across => (DVec2::new(contact.normal, 0.0), DVec2::new(0.0, contact.friction)),
            };
            let (a, b) = (contact.a as u32, self.item(contact.b));
            self.list_contact_forces(a, b, normal, friction);
            self.list_contact_forces(b, a, -normal, -friction);
        }
        for (i, body) in self.bodies.iter_mut().enumerate() {
            let solved = crowd.pile.acceleration(i);
            let forces = &mut self.forces[i];
            let sum = forces.close(None);
            // Along an axis on which nothing changed the sum may be one rounding off zero.
            let scale = forces.forces().iter().fold(DVec2::ZERO, |scale, force| scale.max(force.vector.abs()));
            let settle = |sum: f64, solved: f64, scale: f64| if solved == 0.0 && sum.abs() <= ROUNDING * scale { 0.0 } else { sum };
            let resultant = DVec2::new(settle(sum.x, solved.x, scale.x), settle(sum.y, solved.y, scale.y));
            forces.close(Some(resultant));
            body.acceleration = resultant / body.mass;
        }
    }

    fn item(&self, other: Other) -> u32 {
        match other {
            Other::Body(body) => body as u32,
            Other::Surface(surface) => (self.bodies.len() + surface) as u32,
        }
    }

    fn report_crowd(&mut self, crowd: &Crowd) {
        for impact in crowd.pile.impacts() {
            let axis = match impact.axis {
                Axis::Gravity => 1,
                Axis::Across => 0,
            };
            let pair = Pair { a: impact.a as u32, b: self.item(impact.b) };
            let ascending = self.place(pair.b)[axis] > self.place(pair.a)[axis];
            self.report(&self.contact_along(pair, axis, ascending, true), impact.speed);
        }
    }
}
