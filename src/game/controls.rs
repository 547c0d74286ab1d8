/// The keys of one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Controls {
    pub thrust: bool,
    /// Thrust against the nose.
    pub reverse: bool,
    /// Anticlockwise.
    pub left: bool,
    /// Clockwise.
    pub right: bool,
}
