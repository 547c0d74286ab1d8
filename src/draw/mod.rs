//! A frame as a list of [`Shape`]s: a [`Canvas`] records it without a window; `pen` draws it on the screen, [`svg`] writes a file. Sizes and places
//! are in [`layout`]; the widths of words, from the typefaces themselves, in [`text`].

pub mod canvas;
pub mod chart;
#[cfg(feature = "window")]
mod glyphs;
pub mod layout;
#[cfg(feature = "window")]
pub mod pen;
pub mod raster;
pub mod shape;
pub mod svg;
pub mod text;

pub use canvas::Canvas;
pub use shape::{Align, Colour, Contour, Image, Painting, Quad, Quads, Shape, Style};
pub use text::Typeface;
