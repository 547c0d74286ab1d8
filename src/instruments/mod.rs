//! What a lesson measures with, without a window: it reads a flight tick by tick and changes nothing in it.

pub mod chart;
pub mod curve;
pub mod export;
pub mod look;
pub mod quantity;
pub mod series;
pub mod track;
pub mod unit;
pub mod walk;
