//! The measuring instruments of a lesson, without a window: they read a flight tick by tick and change nothing in it.

pub mod chart;
pub mod curve;
pub mod fit;
pub mod ledger;
pub mod quantity;
pub mod reading;
pub mod track;
pub mod vary;
