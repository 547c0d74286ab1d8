//! Sounds: which event is heard as what, and how loudly. The waves are computed at the start (`waves`); where the build has no
//! sound (on Linux without the feature `audio`) the [`Speaker`] is silent and the game is whole without it.

#[cfg(any(feature = "audio", windows, target_os = "macos"))]
mod loud;
#[cfg(not(any(feature = "audio", windows, target_os = "macos")))]
mod silent;
#[cfg(any(feature = "audio", windows, target_os = "macos", test))]
mod waves;

#[cfg(any(feature = "audio", windows, target_os = "macos"))]
pub use loud::Speaker;
#[cfg(not(any(feature = "audio", windows, target_os = "macos")))]
pub use silent::Speaker;

use crate::game::{DAMAGING_SPEED, GameEvent};

/// A sound that is played once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cue {
    /// Two things hit each other.
    Knock,
    /// The ship hit something so hard that it costs points.
    Crash,
    /// An objective is met.
    Chime,
    /// The level is complete.
    Fanfare,
    /// The ship is lost.
    Fall,
    /// A collision of the blocks that count π.
    Click,
}

impl Cue {
    /// All of them; a cue's number is its place here.
    pub const ALL: [Self; 6] = [Self::Knock, Self::Crash, Self::Chime, Self::Fanfare, Self::Fall, Self::Click];
}

/// What an event sounds like, and how loud it is (0 … 1); `None` for what is not heard.
pub fn heard(event: &GameEvent) -> Option<(Cue, f32)> {
    match event {
        GameEvent::Impact { speed, .. } => Some((Cue::Knock, (speed / DAMAGING_SPEED).min(1.0) as f32)),
        GameEvent::Crushed { .. } => Some((Cue::Knock, 1.0)),
        GameEvent::DamagingHit { .. } => Some((Cue::Crash, 1.0)),
        GameEvent::ObjectiveMet(_) => Some((Cue::Chime, 1.0)),
        GameEvent::Completed => Some((Cue::Fanfare, 1.0)),
        GameEvent::Died => Some((Cue::Fall, 1.0)),
        GameEvent::ObjectiveLost(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::DVec2;

    #[test]
    fn harder_knocks_are_louder_and_none_is_too_loud() {
        let knock = |speed| heard(&GameEvent::Impact { point: DVec2::ZERO, speed, normal: DVec2::NEG_Y });
        assert_eq!(knock(5.0), Some((Cue::Knock, 0.5)));
        assert_eq!(knock(1e9), Some((Cue::Knock, 1.0)));
    }

    #[test]
    fn a_cue_is_found_at_its_number() {
        for (number, cue) in Cue::ALL.into_iter().enumerate() {
            assert_eq!(cue as usize, number);
        }
    }
}
