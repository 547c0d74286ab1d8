//! The state's hash: every bit that decides about the future, and that can change. A new field is written here or left out on purpose.

use crate::physics::data::{Body, Contact, LinkDef, LinkEnd, Surface};
use crate::physics::forces::{Force, ForceKind, ForceManager, Source, link::Link};
use crate::physics::{DVec2, state::State, world::World};

impl World {
    /// Feeds every bit that decides about the future to `write`. Left out: sleep and known contacts, which change no bit
    /// (`tests/engine/scenes/plan.rs`); all that never changes; and streams and belts that are as at the start.
    pub fn hash_state(&self, write: &mut impl FnMut(u64)) {
        let State { bodies, forces, links, surfaces, media, rest_speed: _, contacts, known: _, ticks: _ } = &self.state;
        bodies.iter().for_each(|body| hash_body(body, write));
        forces.iter().for_each(|forces| hash_vector(forces.total(ForceKind::Drive), write));
        forces.iter().for_each(|forces| hash_forces(forces, write));
        links.all.iter().for_each(|link| hash_link(link, write));
        surfaces.iter().for_each(|surface| hash_surface(surface, write));
        (0..).zip(&media.streams).filter(|(_, stream)| !stream.blows).for_each(|(s, _)| write(s));
        // Bodies with the velocity of a surface as the last step ended ride on it.
        let ends = self.space.moving.iter().map(|surface| self.space.motions.surfaces[*surface as usize].end);
        ends.for_each(|velocity| hash_vector(velocity, write));
        contacts.iter().for_each(|contact| hash_contact(contact, write));
    }
}

/// The sign of a zero is left out: `min` and `max` of +0 and −0 give either, each platform its own.
fn hash_number(number: f64, write: &mut impl FnMut(u64)) {
    write((number + 0.0).to_bits());
}

fn hash_vector(vector: DVec2, write: &mut impl FnMut(u64)) {
    vector.to_array().into_iter().for_each(|value| hash_number(value, write));
}

fn hash_forces(forces: &ForceManager, write: &mut impl FnMut(u64)) {
    let is_drive = |force: &Force| (force.source, force.kind) == (Source::Engine, ForceKind::Drive);
    for force in forces.forces().iter().filter(|force| !force.source.is_zone() && !is_drive(force)) {
        write(force.kind as u64);
        write(force.source.number());
        hash_vector(force.vector, write);
    }
}

fn hash_link(link: &Link, write: &mut impl FnMut(u64)) {
    let Link { def, law, on, winds, begun, broken, fastest: _ } = link;
    let LinkDef { body, to, law: _, as_found, hook, breaks, rate } = def;
    write(u64::from(*on) | u64::from(*winds) << 1 | u64::from(*begun) << 2 | u64::from(*broken) << 3);
    write(u64::from(*as_found) << 1 | u64::from(*hook));
    write(breaks.map_or(0, f64::to_bits));
    hash_number(*rate, write);
    write(u64::from(body.0) << 32 | law.kind() as u64);
    match to {
        LinkEnd::Body(other) => write(u64::from(other.0)),
        LinkEnd::Place(place) => hash_vector(*place, write),
    }
    law.numbers().into_iter().for_each(|number| hash_number(number, write));
}

fn hash_body(body: &Body, write: &mut impl FnMut(u64)) {
    let Body { position, velocity, acceleration, half, mass, drag, round, restitution, material, feels_air, weightless } = body;
    [position, velocity, acceleration, half].into_iter().for_each(|vector| hash_vector(*vector, write));
    let friction = [material.static_friction, material.kinetic_friction];
    [*mass, *drag, *restitution].into_iter().chain(friction).for_each(|value| hash_number(value, write));
    write(u64::from(*round) | u64::from(*feels_air) << 1 | u64::from(*weightless) << 2);
}

fn hash_surface(surface: &Surface, write: &mut impl FnMut(u64)) {
    let Surface { bounds, velocity, material, present, def, clock, belt, runs, wanted, moved } = surface;
    [bounds.min, bounds.max, *velocity].into_iter().for_each(|vector| hash_vector(vector, write));
    [material.static_friction, material.kinetic_friction, *clock].into_iter().for_each(|value| hash_number(value, write));
    if *belt != def.belt {
        hash_number(*belt, write);
    }
    write(u64::from(*runs) | u64::from(*present) << 1 | u64::from(*wanted) << 2 | u64::from(*moved) << 3);
}

/// Left out: all that an event or a step finds out for itself.
fn hash_contact(contact: &Contact, write: &mut impl FnMut(u64)) {
    let Contact { lo, hi, axis, slides, normal, friction, .. } = *contact;
    write(u64::from(lo) << 32 | u64::from(hi));
    write(axis as u64);
    [slides, normal, friction].into_iter().for_each(|value| hash_number(value, write));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Aabb, BodyDef, BodyId, Material, Path, Plan, SurfaceDef, WorldDef};

    /// A lift with two crates on it, one driven, after a while.
    fn world() -> World {
        let path = Path::shuttle(DVec2::new(0.0, -3.0), 2.0, 0.5, 0.1);
        let lift = SurfaceDef { path, ..SurfaceDef::fixed(Aabb::new(DVec2::ZERO, DVec2::new(9.0, 1.0)), Material::WOOD) };
        let crate_at = |x: f64| BodyDef { position: DVec2::new(x, -0.5), ..BodyDef::default() };
        let def = WorldDef { bodies: vec![crate_at(2.0), crate_at(5.0)], surfaces: vec![lift], ..WorldDef::default() };
        let plan = Plan { dense: true, ..Plan::of(&def) };
        let mut world = World::with_plan(def, plan).unwrap();
        world.set_drive(BodyId(0), DVec2::new(30.0, 0.0));
        for _ in 0..60 {
            world.step(1.0 / 120.0);
            // Asks the next step for contacts.
            world.forces(BodyId(0));
        }
        world
    }

    fn words(world: &World) -> Vec<u64> {
        let mut words = Vec::new();
        world.hash_state(&mut |word| words.push(word));
        words
    }

    #[test]
    fn every_field_of_the_state_is_in_its_hash() {
        type Change = (&'static str, fn(&mut State));
        let changes: [Change; 32] = [
            ("position", |state| state.bodies[1].position.y = 0.3),
            ("velocity", |state| state.bodies[1].velocity.x = 0.3),
            ("acceleration", |state| state.bodies[1].acceleration.x = 0.3),
            ("size", |state| state.bodies[1].half.y = 0.3),
            ("mass", |state| state.bodies[1].mass = 0.3),
            ("drag", |state| state.bodies[1].drag = 0.3),
            ("round", |state| state.bodies[1].round ^= true),
            ("restitution", |state| state.bodies[1].restitution = 0.3),
            ("static friction", |state| state.bodies[1].material.static_friction = 0.33),
            ("kinetic friction", |state| state.bodies[1].material.kinetic_friction = 0.33),
            ("weightless", |state| state.bodies[1].weightless ^= true),
            ("feels air", |state| state.bodies[1].feels_air ^= true),
            ("drive", |state| _ = state.forces[1].add(Source::Engine, ForceKind::Drive, DVec2::new(0.0, 0.3))),
            ("push", |state| _ = state.forces[1].add(Source::Body(BodyId(0)), ForceKind::Push, DVec2::new(0.0, 0.3))),
            ("place of a surface", |state| state.surfaces[0].bounds.min.y = -0.3),
            ("other end of a surface", |state| state.surfaces[0].bounds.max.x = 9.5),
            ("velocity of a surface", |state| state.surfaces[0].velocity.y = 0.3),
            ("static friction of a surface", |state| state.surfaces[0].material.static_friction = 0.33),
            ("kinetic friction of a surface", |state| state.surfaces[0].material.kinetic_friction = 0.33),
            ("clock", |state| state.surfaces[0].clock = 0.3),
            ("runs", |state| state.surfaces[0].runs ^= true),
            ("present", |state| state.surfaces[0].present ^= true),
            ("wanted", |state| state.surfaces[0].wanted ^= true),
            ("belt", |state| state.surfaces[0].belt = 0.3),
            ("number of bodies", |state| state.bodies.truncate(1)),
            ("lower end of a contact", |state| state.contacts[0].lo ^= 1),
            ("upper end of a contact", |state| state.contacts[0].hi ^= 1),
            ("axis of a contact", |state| state.contacts[0].axis ^= 1),
            ("slide of a contact", |state| state.contacts[0].slides -= 0.5),
            ("force of a contact", |state| state.contacts[0].normal += 0.5),
            ("friction of a contact", |state| state.contacts[0].friction += 0.5),
            ("number of contacts", |state| state.contacts.truncate(1)),
        ];
        let before = words(&world());
        assert_eq!(before, words(&world()));
        for (name, change) in changes {
            let mut world = world();
            change(&mut world.state);
            assert_ne!(words(&world), before, "{name}");
        }
    }
}
