//! Random scenes: laws that hold whatever is drawn.

mod islands;
mod moving;
mod plan;
mod random;
