//! The reasons for which playing ends.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Why {
    /// The game has ended, or there is no library.
    Over,
    /// There is no device now.
    NoDevice,
    /// The device vanished.
    Lost,
}
