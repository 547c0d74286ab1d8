//! Rules that the sources keep.

mod catalogues;
mod sources;
mod words;
