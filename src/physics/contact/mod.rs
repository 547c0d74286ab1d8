pub(crate) mod axis;
pub(crate) mod network;
pub(crate) mod reactions;
pub(crate) mod resting;
