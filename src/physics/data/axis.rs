//! The two axes of boxes that do not turn.

/// The direction of a contact's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    /// Left and right.
    Across,
    /// Up and down.
    Gravity,
}
