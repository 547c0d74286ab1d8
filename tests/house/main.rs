//! Rules that the sources keep.

mod no_clocks;
mod sources;
mod words;
