pub(crate) mod bodies;
pub(crate) mod driver;
pub(crate) mod grid;
pub(crate) mod islands;
pub(crate) mod neighbours;
