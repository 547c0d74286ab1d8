//! The Lab's charts, on the screen and on paper.

pub mod diagram;
pub mod paper;
pub mod picture;
pub mod plane;
pub mod plot;
pub mod timeline;
