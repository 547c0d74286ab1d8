pub(crate) mod bodies;
pub(crate) mod grid;
pub(crate) mod islands;
pub(crate) mod members;
pub(crate) mod neighbours;
pub(crate) mod sleep;
