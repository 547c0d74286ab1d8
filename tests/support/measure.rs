//! Measures of worlds: bits, overlap, energy, momentum.

use resultant::physics::{Aabb, BodyId, DVec2, Event, ForceKind, World};

/// All bits of a world's state.
pub fn bits(world: &World) -> Vec<u64> {
    let mut bits = Vec::new();
    world.hash_state(&mut |word| bits.push(word));
    bits
}

/// All bits of a body's motion, of the forces on it by kind and vector, and of its impacts.
pub fn bits_of_body(world: &World, id: BodyId) -> Vec<u64> {
    let (body, forces) = (world.body(id), world.forces(id));
    let motion = [body.position, body.velocity, body.acceleration, forces.resultant()];
    let listed = forces.forces().iter().flat_map(|force| [force.vector, force.point, DVec2::splat(force.kind as u8 as f64)]);
    let passed_on = world.impulses().iter().filter_map(|impulse| Some((impulse.on(id)?.0, impulse.point, impulse.at)));
    let impacts = passed_on.flat_map(|(vector, point, at)| [vector, point, DVec2::splat(at)]);
    motion.into_iter().chain(listed).chain(impacts).flat_map(|v| [v.x.to_bits(), v.y.to_bits()]).collect()
}

/// The sum of a body's forces by their kinds, N.
pub fn named_forces(world: &World, id: BodyId) -> DVec2 {
    ForceKind::ALL.iter().map(|&kind| world.forces(id).total(kind)).sum()
}

/// The deepest overlap of any two boxes, or of one of them and a solid, m.
pub fn deepest(mut boxes: Vec<Aabb>, solids: &[Aabb]) -> f64 {
    boxes.sort_by(|a, b| a.min.x.total_cmp(&b.min.x));
    let depth = |a: &Aabb, b: &Aabb| -a.gap(b).max_element();
    let mut worst = 0.0f64;
    for (i, a) in boxes.iter().enumerate() {
        worst = boxes[i + 1..].iter().take_while(|b| b.min.x < a.max.x).map(|b| depth(a, b)).fold(worst, f64::max);
        worst = solids.iter().map(|b| depth(a, b)).fold(worst, f64::max);
    }
    worst
}

/// The deepest overlap of any two bodies, or of a body and a surface, m.
pub fn worst_overlap(world: &World) -> f64 {
    let solids: Vec<Aabb> = world.surfaces().iter().map(|surface| surface.bounds).collect();
    deepest(world.bodies().iter().map(|body| body.bounds()).collect(), &solids)
}

/// Kinetic and potential energy, counted from the height `floor` (m), J.
pub fn energy(world: &World, gravity: f64, floor: f64) -> f64 {
    world.bodies().iter().map(|b| b.mass * (0.5 * b.velocity.length_squared() + gravity * (floor - b.position.y))).sum()
}

/// kg·m/s.
pub fn momentum(world: &World) -> DVec2 {
    world.bodies().iter().map(|b| b.velocity * b.mass).sum()
}

/// The sum of the magnitudes of all momenta, kg·m/s.
pub fn momentum_scale(world: &World) -> f64 {
    world.bodies().iter().map(|b| b.mass * b.velocity.length()).sum()
}

/// The Reactions on a body from below, N; the Reactions of bodies that it carries point downwards.
pub fn from_below(world: &World, id: BodyId) -> f64 {
    let forces = world.forces(id);
    let up = forces.forces().iter().filter(|force| force.kind == ForceKind::Reaction && force.vector.y < 0.0);
    up.map(|force| force.vector.y).sum()
}

/// The squeezes of the last tick: the body, the surface that squeezes it, and the force, N.
pub fn crushed(world: &World) -> Vec<(u32, u32, f64)> {
    let crush = |event: &Event| match *event {
        Event::Crushed { body, by, force } => Some((body.0, by, force)),
        Event::Impact { .. } | Event::Snapped { .. } | Event::Hooked { .. } => None,
    };
    world.events().iter().filter_map(crush).collect()
}

/// Each body rests exactly, and nothing acts on it in sum.
#[track_caller]
pub fn assert_all_at_rest(world: &World) {
    for (i, body) in (0..).zip(world.bodies()) {
        assert_eq!((body.velocity, body.acceleration), (DVec2::ZERO, DVec2::ZERO), "body {i}");
        assert_eq!(world.forces(BodyId(i)).resultant(), DVec2::ZERO, "body {i}");
    }
}

/// Advances a world by some seconds, and holds it against [`World::validate`] after every tick.
pub fn run(world: &mut World, seconds: f64, tick: f64) {
    for n in 0..(seconds / tick).round() as usize {
        world.step(tick);
        world.validate().unwrap_or_else(|fault| panic!("tick {n}: {fault}"));
    }
}
