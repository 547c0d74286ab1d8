//! The measuring instruments of a lesson, without a window: they read a flight tick by tick and change nothing in it.

pub mod centre;
pub mod chart;
pub mod companion;
pub mod curve;
pub mod energy;
pub mod export;
pub mod fit;
pub mod ledger;
pub mod look;
pub mod numerals;
pub mod quantity;
pub mod reading;
pub mod series;
pub mod track;
pub mod trail;
pub mod unit;
pub mod vary;
