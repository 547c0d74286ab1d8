//! The Lab's charts, on the screen and on paper.

pub mod diagram;
mod legend;
pub mod looks;
pub mod overview;
pub mod picture;
pub mod places;
pub mod plane;
pub mod timeline;
