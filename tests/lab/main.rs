//! The laboratory: methods, stress tests and the experiments.

mod lessons;
mod methods;
mod stability;
#[path = "../support/mod.rs"]
mod support;
