//! Rapier, in f32 and in f64: the same code on two crates.

macro_rules! rapier {
    ($module:ident, $krate:ident, $real:ty, $name:literal) => {
        /// One precision of it.
        pub mod $module {
            use crate::engine::{Engine, Spec, V};
            use $krate::prelude::*;

            /// Its world, and the handles of its bodies.
            pub struct Rapier {
                world: PhysicsWorld,
                handles: Vec<RigidBodyHandle>,
            }

            fn vector((x, y): V) -> Vector {
                Vector::new(x as $real, y as $real)
            }

            impl Engine for Rapier {
                const NAME: &'static str = $name;
                const QUADRATIC: bool = false;

                fn new(spec: &Spec) -> Option<Self> {
                    let mut world = PhysicsWorld::new();
                    world.gravity = vector((0.0, spec.gravity));
                    let solid = |half: V, restitution: f64| {
                        ColliderBuilder::cuboid(half.0 as $real, half.1 as $real)
                            .friction(spec.friction as $real)
                            .restitution(restitution as $real)
                            .restitution_combine_rule(CoefficientCombineRule::Max)
                    };
                    for &(centre, half) in &spec.statics {
                        world.insert_collider(solid(half, 0.0).translation(vector(centre)), None);
                    }
                    let handles = spec.bodies.iter().map(|body| {
                        let rigid = RigidBodyBuilder::dynamic()
                            .translation(vector(body.position))
                            .linvel(vector(body.velocity))
                            .lock_rotations()
                            .can_sleep(spec.sleep)
                            .linear_damping((spec.gravity / spec.terminal) as $real)
                            .ccd_enabled(spec.swept);
                        let (handle, _) = world.insert(rigid, solid(body.half, body.restitution).mass(body.mass as $real));
                        world.bodies[handle].add_force(vector((body.force, 0.0)), true);
                        handle
                    });
                    let handles = handles.collect();
                    Some(Self { world, handles })
                }

                fn step(&mut self, dt: f64) {
                    self.world.integration_parameters.dt = dt as $real;
                    self.world.step();
                }

                fn position(&mut self, body: usize) -> V {
                    let at = self.world.bodies[self.handles[body]].translation();
                    (f64::from(at.x), f64::from(at.y))
                }

                fn velocity(&mut self, body: usize) -> V {
                    let v = self.world.bodies[self.handles[body]].linvel();
                    (f64::from(v.x), f64::from(v.y))
                }
            }
        }
    };
}

rapier!(single, rapier2d, f32, "Rapier f32");
rapier!(double, rapier2d_f64, f64, "Rapier f64");
