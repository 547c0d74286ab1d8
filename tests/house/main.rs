//! Rules that the sources keep.

mod catalogues;
mod no_clocks;
mod sources;
mod words;
