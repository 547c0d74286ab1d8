pub(crate) mod broad_phase;
pub(crate) mod edges;
pub(crate) mod islands;
pub(crate) mod motions;
pub(crate) mod sleep;
