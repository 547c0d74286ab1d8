//! The methods that games use, as plain as in textbooks: pure functions of a state and a step, to be measured beside the engine, which uses none.

pub mod bounce;
pub mod chain;
pub mod impact;
pub mod motion;
pub mod rules;

use motion::{
    ADAPTIVE, MotionStep, adaptive, exact_decay, explicit_euler, heun, implicit_euler, implicit_midpoint, linearised_drag,
    midpoint, rk4, semi_implicit_euler, strang, trapezoid, velocity_verlet, yoshida,
};

/// Every method that steps a motion through drag, by the name that charts and tables show.
pub const METHODS: [(&str, MotionStep); 14] = [
    ("explicit Euler", explicit_euler),
    ("semi-implicit Euler", semi_implicit_euler),
    ("velocity Verlet", velocity_verlet),
    ("midpoint", midpoint),
    ("Heun", heun),
    ("RK4", rk4),
    ("Yoshida 4", yoshida),
    ("implicit Euler", implicit_euler),
    ("implicit midpoint", implicit_midpoint),
    ("trapezoid", trapezoid),
    (ADAPTIVE, adaptive),
    ("linearised drag", linearised_drag),
    ("exact drag (Lie)", exact_decay),
    ("Strang", strang),
];

/// The methods that differ where there is no drag.
pub static INTEGRATORS: &[(&str, MotionStep)] = METHODS.split_at(11).0;
