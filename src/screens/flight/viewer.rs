//! The viewer's part of a watched flight.

use crate::game::Unflown;
use crate::screens::flight::ahead::Ahead;

#[derive(Debug)]
pub(super) struct Viewer {
    pub title: String,
    /// The inputs that the history lacks.
    pub unflown: Option<Unflown>,
    /// Ticks to fly of them in a frame.
    pub ahead: Ahead,
    /// Whether the pointer holds the time line.
    pub dragged: bool,
}
