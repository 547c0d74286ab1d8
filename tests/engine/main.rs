//! The engine by itself: forces, contacts, impacts and motion against exact answers and laws, by hand and in random scenes.

mod allocations;
mod attacks;
mod crowds;
mod dense_laws;
mod dense_surfaces;
mod differential;
mod exact;
mod forces;
mod golden;
mod instants;
mod links;
mod liquids;
mod media_in_a_tick;
mod piles;
mod scenes;
mod state;
#[path = "../support/mod.rs"]
mod support;
mod surfaces;
mod ties;
mod worst_tick;
