//! The Lab's charts, on the screen and on paper.

pub mod diagram;
pub mod picture;
pub mod plane;
pub mod timeline;
