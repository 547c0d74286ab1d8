//! What a lesson measures with, without a window: it reads a flight tick by tick and changes nothing in it.

pub mod centre;
pub mod companion;
pub mod energy;
pub mod ledger;
pub mod stop_clock;
pub mod trail;
pub mod vary;
pub mod walk;
