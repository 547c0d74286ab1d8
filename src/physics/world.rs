use crate::physics::data::{Aabb, Body, BodyDef, BodyId, Contact, Impulse, Material, Obstacle, Plan, Surface};
use crate::physics::data::{SurfaceDef, WorldDef, domain::DefError, on_axis, tuning::EDGE_THICKNESS};
use crate::physics::forces::{Force, ForceKind, ForceManager, Links, Media, Source};
use crate::physics::state::{Event, Guards, Methods, Records, State};
use crate::physics::{scratch::Scratch, space::Space};
use glam::DVec2;
use std::cell::Cell;

/// Bodies, surfaces, zones, and the state of their motion. Two worlds that began alike and were stepped alike are alike to the bit.
#[derive(Clone, Debug)]
pub struct World {
    pub(crate) state: State,
    pub(crate) records: Records,
    pub(crate) space: Box<Space>,
    pub(crate) scratch: Box<Scratch>,
    pub(crate) plan: Plan,
    /// Surfaces that have paths, and those that come back once no body is in their way.
    pub(crate) on_paths: Vec<u32>,
    pub(crate) awaited: Vec<u32>,
    /// Whether somebody has asked for forces since the last tick.
    pub(crate) asked: Cell<bool>,
}

impl World {
    /// Checks the definition and builds the world.
    ///
    /// # Errors
    /// A number that is not finite or out of its range.
    pub fn new(def: WorldDef) -> Result<Self, DefError> {
        let plan = Plan::of(&def);
        Self::with_plan(def, plan)
    }

    /// As [`World::new`], by another plan: a part that no body needs changes no bit, a missing one leaves its effect out.
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn with_plan(mut def: WorldDef, plan: Plan) -> Result<Self, DefError> {
        def.check()?;
        def.surfaces.extend(def.bounds.iter().flat_map(|bounds| edges(bounds, def.edge)));
        if !plan.streams {
            def.streams.clear();
            def.fields.clear();
        }
        if !plan.liquids {
            def.fluids.clear();
        }
        if !plan.links {
            def.links.clear();
        }
        let mut media = Media::new(def.gravity, def.air_density, (&def.streams, &def.fields), def.fluids);
        media.airy = plan.air;
        let n = def.bodies.len();
        let state = State {
            bodies: def.bodies.iter().map(Body::new).collect(),
            forces: std::iter::repeat_with(ForceManager::default).take(n).collect(),
            links: Links::default(),
            surfaces: def.surfaces.into_iter().map(Surface::new).collect(),
            media,
            rest_speed: def.rest_speed,
            contacts: Vec::new(),
            known: vec![false; n],
            ticks: 0,
        };
        let on_paths = (0..).zip(&state.surfaces).filter(|(_, surface)| !surface.def.path.is_still()).map(|(s, _)| s).collect();
        let awaited = Vec::with_capacity(state.surfaces.len());
        let (records, space, scratch) = (Records::default(), Box::new(Space::new(&state)), Box::default());
        let mut world = Self { space, scratch, state, records, plan, on_paths, awaited, asked: Cell::new(true) };
        if world.plan.streams {
            world.state.forces.fill_with(ForceManager::with_room);
            world.feel_zones();
        }
        def.links.into_iter().try_for_each(|link| world.link(link).map(drop))?;
        world.begin();
        Ok(world)
    }

    /// Goes on by another plan, as [`World::with_plan`] would have begun.
    pub const fn set_plan(&mut self, plan: Plan) {
        self.state.media.airy = plan.air;
        self.plan = plan;
    }

    /// Adds a body while the world runs (the menu's balls).
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn add_body(&mut self, def: BodyDef) -> Result<BodyId, DefError> {
        def.check()?;
        let State { bodies, forces, contacts, known, media, .. } = &mut self.state;
        let n = bodies.len() as u32;
        bodies.push(Body::new(&def));
        forces.push(ForceManager::default());
        known.push(false);
        // Contacts count surfaces on from the number of bodies.
        for contact in contacts {
            contact.lo += u32::from(contact.lo >= n);
            contact.hi += u32::from(contact.hi >= n);
        }
        self.plan.air |= media.air_density > 0.0 && def.feels_air && def.drag > 0.0;
        media.airy = self.plan.air;
        self.plan.bounces |= def.restitution.max(def.material.restitution) > 0.0;
        let before = std::mem::replace(&mut *self.space, Space::new(&self.state));
        self.space.keep_previous(&before);
        Ok(BodyId(n))
    }

    /// All bodies, by [`BodyId::index`].
    pub fn bodies(&self) -> &[Body] {
        &self.state.bodies
    }

    /// One body.
    pub fn body(&self, id: BodyId) -> &Body {
        &self.state.bodies[id.index()]
    }

    /// Where a body's centre was one tick ago, m: the view interpolates from here.
    pub fn previous_position(&self, id: BodyId) -> DVec2 {
        self.scratch.begun.get(id.index()).map_or_else(|| self.space.previous(id.index()).0, |pose| pose.0)
    }

    /// The surfaces: those of the definition, then the four edges (left, right, top, bottom) where there are any.
    pub fn surfaces(&self) -> &[Surface] {
        &self.state.surfaces
    }

    /// The events of the last tick.
    pub fn events(&self) -> &[Event] {
        &self.records.events
    }

    /// The impulses of the last tick, in the order of their times.
    pub fn impulses(&self) -> &[Impulse] {
        &self.records.impulses
    }

    /// The corners of the path of a body's centre during the last tick, from where it was to where it is.
    pub fn path(&self, id: BodyId) -> impl Iterator<Item = DVec2> + '_ {
        let corners = self.records.corners.iter().filter(move |(body, ..)| *body == id.0).map(|(.., at)| *at);
        std::iter::once(self.previous_position(id)).chain(corners).chain(std::iter::once(self.body(id).position))
    }

    /// The parts of the model that run.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// How often each guard of the engine has acted so far.
    pub fn guards(&self) -> &Guards {
        &self.records.guards
    }

    /// Events of the last tick, each counted as often as bodies were looked at for it. One step of a crowd is none.
    pub fn followed(&self) -> u64 {
        self.records.followed
    }

    /// How many bodies each method took through the last tick; all 0 as long as the tick does not tell.
    pub fn methods(&self) -> &Methods {
        &self.records.methods
    }

    /// The forces on a body as it is now, each with its source; what its contacts carry is what the last tick ended with.
    pub fn forces(&self, id: BodyId) -> ForceManager {
        self.asked.set(true);
        let mut forces = ForceManager::default();
        self.list_forces(id, &mut forces);
        forces
    }

    /// The same into a list that is there already. Does not ask the next tick for forces.
    pub(crate) fn list_forces(&self, id: BodyId, forces: &mut ForceManager) {
        let (state, body) = (&self.state, self.body(id));
        forces.clear();
        let (vector, point) = (state.media.weight(body), body.position);
        forces.list(Force { kind: ForceKind::Weight, source: Source::Gravity, vector, point });
        let pushes = &state.forces[id.index()];
        pushes.forces().iter().for_each(|force| forces.list(Force { point, ..*force }));
        let law = state.media.law(body, pushes.push(), 0.0);
        state.media.list(body, &law, pushes.push(), forces);
        self.list_links(id, forces);
        for contact in state.contacts.iter().filter(|contact| contact.has(id.0)) {
            self.list_contact(contact, id, forces);
        }
        forces.close(body.acceleration, state.links.all.iter().any(|link| link.acts_on(id.0)));
    }

    /// Lists the forces of a contact on a body, N: a Reaction of a surface, or along gravity; a Push side by side.
    fn list_contact(&self, contact: &Contact, id: BodyId, forces: &mut ForceManager) {
        let sign = if contact.hi == id.0 { 1.0 } else { -1.0 };
        let normal = on_axis(contact.axis, sign * contact.normal, 0.0);
        let friction = on_axis(contact.axis, 0.0, sign * contact.friction);
        let (source, kind) = match self.state.obstacle(contact.other(id.0)) {
            Obstacle::Surface(surface) => (Source::Surface(surface), ForceKind::Reaction),
            Obstacle::Body(other) if contact.axis == 1 => (Source::Body(other), ForceKind::Reaction),
            Obstacle::Body(other) => (Source::Body(other), ForceKind::Push),
        };
        let point = self.state.bounds_of(contact.lo).shared_middle(&self.state.bounds_of(contact.hi));
        for (kind, vector) in [(kind, normal), (ForceKind::Friction, friction)] {
            forces.list(Force { kind, source, vector: vector + DVec2::ZERO, point });
        }
    }
}

/// The four solid edges around a level: left, right, top, bottom.
pub(crate) fn edges(bounds: &Aabb, material: Material) -> [SurfaceDef; 4] {
    let (min, max) = (bounds.min, bounds.max);
    let t = EDGE_THICKNESS;
    let edge = |x0, y0, x1, y1| SurfaceDef::fixed(Aabb::new(DVec2::new(x0, y0), DVec2::new(x1, y1)), material);
    [
        edge(min.x - t, min.y - t, min.x, max.y + t),
        edge(max.x, min.y - t, max.x + t, max.y + t),
        edge(min.x, min.y - t, max.x, min.y),
        edge(min.x, max.y, max.x, max.y + t),
    ]
}
