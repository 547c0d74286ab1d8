pub(crate) mod bodies;
pub(crate) mod broad_phase;
pub(crate) mod grid;
pub(crate) mod islands;
pub(crate) mod members;
pub(crate) mod sleep;
