//! The centre of mass of several bodies: without forces from outside it goes on in a straight line, whatever the parts do.

use crate::physics::{Body, DVec2};

/// Σ m·r / Σ m over bodies, m.
pub fn centre_of_mass(bodies: &[Body]) -> DVec2 {
    let (moment, mass) =
        bodies.iter().fold((DVec2::ZERO, 0.0), |(moment, mass), body| (moment + body.mass * body.position, mass + body.mass));
    moment / mass
}

/// Σ m·v / Σ m over bodies, m/s.
pub fn velocity_of_centre(bodies: &[Body]) -> DVec2 {
    let (momentum, mass) =
        bodies.iter().fold((DVec2::ZERO, 0.0), |(momentum, mass), body| (momentum + body.mass * body.velocity, mass + body.mass));
    momentum / mass
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, World, WorldDef};

    #[test]
    fn it_lies_nearer_to_the_heavier() {
        let mut world = World::new(WorldDef::default()).expect("an empty world");
        for (mass, x, speed) in [(1.0, 10.0, 8.0), (3.0, 14.0, -4.0)] {
            let (position, velocity) = (DVec2::new(x, 50.0), DVec2::new(speed, 0.0));
            world.add_body(BodyDef { mass, position, velocity, ..BodyDef::default() }).expect("a body");
        }
        assert_eq!(centre_of_mass(world.bodies()), DVec2::new(13.0, 50.0));
        assert_eq!(velocity_of_centre(world.bodies()), DVec2::new(-1.0, 0.0));
    }
}
