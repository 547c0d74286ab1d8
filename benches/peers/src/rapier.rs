//! Rapier, in f32 and in f64: the same code on two crates.

/// Rapier's default of iterations, and its default stiffness of contacts between what moves, Hz; at what does not move it is twice that.
const ITERATIONS: u32 = 4;
const HERTZ: f64 = 30.0;

macro_rules! rapier {
    ($module:ident, $krate:ident, $real:ty, $name:literal, $version:literal) => {
        /// One precision of it.
        pub mod $module {
            use crate::engine::{Box, Engine, Lift, Liquid, NO_LIMIT, STIFFER, Spec, V, settings, version};
            use $krate::prelude::*;

            /// Its world, and the handles of its bodies.
            pub struct Rapier {
                world: PhysicsWorld,
                handles: Vec<RigidBodyHandle>,
                lift: Option<(RigidBodyHandle, Lift)>,
                water: Option<Water>,
                time: f64,
            }

            /// The water of a scene, and what is in it.
            struct Water {
                liquid: Liquid,
                bodies: Vec<Box>,
                gravity: f64,
            }

            fn vector((x, y): V) -> Vector {
                Vector::new(x as $real, y as $real)
            }

            impl Engine for Rapier {
                const NAME: &'static str = $name;
                const QUADRATIC: bool = false;

                fn version() -> String {
                    version($version)
                }

                fn settings(stiff: bool) -> String {
                    settings(super::ITERATIONS, "iterations", super::HERTZ, stiff)
                }

                fn new(spec: &Spec) -> Option<Self> {
                    let mut world = PhysicsWorld::new();
                    world.gravity = vector((0.0, spec.gravity));
                    if spec.stiff {
                        let parameters = &mut world.integration_parameters;
                        parameters.num_solver_iterations *= STIFFER as usize;
                        parameters.contact_softness.natural_frequency *= STIFFER as $real;
                        parameters.static_contact_softness.natural_frequency *= STIFFER as $real;
                        parameters.normalized_max_linear_velocity = NO_LIMIT as $real;
                    }
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
                    let lift = spec.lift.clone().map(|lift| {
                        let rigid = RigidBodyBuilder::kinematic_velocity_based().translation(vector(lift.place.0));
                        (world.insert(rigid, solid(lift.place.1, 0.0)).0, lift)
                    });
                    let water =
                        spec.liquid.clone().map(|liquid| Water { liquid, bodies: spec.bodies.clone(), gravity: spec.gravity });
                    Some(Self { world, handles, lift, water, time: 0.0 })
                }

                fn step(&mut self, dt: f64) {
                    let now = self.time;
                    self.time += dt;
                    if let Some((handle, lift)) = &self.lift {
                        let way = lift.at(self.time).1 - lift.at(now).1;
                        self.world.bodies[*handle].set_linvel(vector((0.0, way / dt)), true);
                    }
                    if let Some(water) = &self.water {
                        for (handle, body) in self.handles.iter().zip(&water.bodies) {
                            let rigid = &mut self.world.bodies[*handle];
                            let (at, v) = (rigid.translation(), rigid.linvel());
                            let (at, v) = ((f64::from(at.x), f64::from(at.y)), (f64::from(v.x), f64::from(v.y)));
                            rigid.reset_forces(false);
                            rigid.add_force(vector(water.liquid.force_on(body, at, v, water.gravity)), true);
                        }
                    }
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

rapier!(single, rapier2d, f32, "Rapier f32", "rapier2d");
rapier!(double, rapier2d_f64, f64, "Rapier f64", "rapier2d-f64");
