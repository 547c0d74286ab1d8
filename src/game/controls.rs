//! The keys of one tick.

/// The keys that the player holds down during one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Controls {
    /// Thrust along the nose.
    pub thrust: bool,
    /// Thrust against it.
    pub reverse: bool,
    /// Rotate anticlockwise.
    pub left: bool,
    /// Rotate clockwise.
    pub right: bool,
}
