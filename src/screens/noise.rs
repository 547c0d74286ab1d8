//! What the classics let be heard: told by their screens, which know no loudspeaker.

/// Something that was heard in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Noise {
    /// Somebody jumped.
    Jump,
    /// Somebody landed, this hard: 0 … 1.
    Landing(f64),
    /// Two ran into each other.
    Bump,
    /// Two blocks collided, however often.
    Collision,
}
