//! When the window computes its next frame, and whether it draws it. A frame that shows what the one before has shown costs a copy of that.

use crate::ui::input::Input;

/// The longest time that one frame brings, s, after a sleep or a system clock that was set. A slower frame would lose ticks in any case.
pub const LONGEST: f64 = 0.25;
/// From one frame to the next where nothing is flown, s.
pub const EASY: f64 = 1.0 / 30.0;
/// The same where another window has the keyboard and nothing is drawn. With it too long: of two presses of a key in a frame one is lost.
pub const AWAY: f64 = 0.1;
/// A player who has done nothing for so long is taken to have left, s.
pub const LEFT: f64 = 10.0;
/// The same where a screen rests and the player has left, s: whatever is pressed ends it at once.
pub const DOZE: f64 = 0.5;
/// So long after the last input, and after the screen has changed, every frame is drawn, s: highlights, scrolling and fades end within it.
pub const LINGER: f64 = 1.0;
/// A resting screen is drawn this often all the same, s: cursors blink, files change, windows cover it; and this often where the player left.
pub const BEATS: [f64; 2] = [0.5, 4.0];
/// A menu that nobody touches comes to rest after this, s.
pub const REST: f64 = 60.0;
/// A new screen fades in over this, s.
const FADE: f64 = 0.16;

/// The time that a frame brings, s, from the one that was measured, whatever that is.
pub fn passed(measured: f64) -> f64 {
    if measured.is_nan() { 0.0 } else { measured.clamp(0.0, LONGEST) }
}

/// How much of a screen its curtain still hides, 0 … 1, after it has been there so long, s.
pub fn veil(shown_for: f64) -> f64 {
    (1.0 - shown_for / FADE).clamp(0.0, 1.0)
}

/// How a screen moves by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    Full,
    /// A little: a frame every `EASY` seconds will do.
    Easy,
    Still,
}

/// What becomes of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Picture {
    #[default]
    Drawn,
    /// It is drawn, and kept to be shown again.
    Kept,
    Again,
}

/// Watches the frames go by.
#[derive(Clone, Debug, Default)]
pub struct Pace {
    last: Input,
    /// Without any input, s.
    idle: f64,
    /// Since a frame was drawn, s.
    undrawn: f64,
    pub picture: Picture,
}

impl Pace {
    /// The least time from the last frame to this one, s; none for what was pressed, clicked, turned, typed or dropped.
    pub fn interval(&self, motion: Motion, input: &Input) -> f64 {
        match (motion, input.away) {
            _ if input.has_news() => 0.0,
            (Motion::Full, false) => 0.0,
            (Motion::Still, _) if self.picture != Picture::Drawn && self.idle >= LEFT => DOZE,
            (Motion::Still, true) if self.picture != Picture::Drawn => AWAY,
            _ => EASY,
        }
    }

    /// Takes note of the input of a frame; how long there has been none, s.
    pub fn note(&mut self, input: &Input) -> f64 {
        let now = Input { frame_time: 0.0, waited: 0.0, idle: 0.0, answer: Default::default(), ..input.clone() };
        let rests = now == self.last && !now.has_news() && !now.holding && !now.dragging && now.held.is_empty();
        self.idle = if rests { self.idle + input.frame_time } else { 0.0 };
        self.last = now;
        self.idle
    }

    /// What becomes of the frame of a screen that has been there so long, s.
    pub fn decide(&mut self, motion: Motion, frame_time: f64, shown_for: f64) -> Picture {
        self.undrawn += frame_time;
        let beat = BEATS[usize::from(self.idle >= LEFT)];
        self.picture = if motion != Motion::Still || self.idle.min(shown_for) < LINGER {
            Picture::Drawn
        } else if self.undrawn >= beat || self.picture == Picture::Drawn {
            Picture::Kept
        } else {
            Picture::Again
        };
        if self.picture != Picture::Again {
            self.undrawn = 0.0;
        }
        self.picture
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::Vec2;
    use crate::screens::Key;

    #[test]
    fn whatever_is_measured_no_frame_brings_less_than_nothing_or_more_than_a_quarter_of_a_second() {
        for (measured, brings) in [
            (0.016, 0.016),
            (0.0, 0.0),
            (-1e-9, 0.0),
            (-3600.0, 0.0),
            (1e9, LONGEST),
            (f64::NAN, 0.0),
            (f64::INFINITY, LONGEST),
            (f64::NEG_INFINITY, 0.0),
        ] {
            assert_eq!(passed(measured), brings, "{measured}");
        }
    }

    #[test]
    fn a_screen_is_never_hidden_by_more_than_its_curtain() {
        assert_eq!([-5.0, 0.0, 0.08, 0.16, 1e9].map(veil), [1.0, 1.0, 0.5, 0.0, 0.0]);
    }

    fn input() -> Input {
        Input { frame_time: EASY, ..Input::default() }
    }

    /// How many of `frames` frames without input are drawn, on a screen that opened long ago.
    fn drawn(pace: &mut Pace, motion: Motion, frames: usize) -> usize {
        let mut frame = || {
            pace.note(&input());
            pace.decide(motion, EASY, 100.0)
        };
        (0..frames).filter(|_| frame() != Picture::Again).count()
    }

    #[test]
    fn what_moves_is_always_drawn_and_what_rests_now_and_then() {
        for motion in [Motion::Full, Motion::Easy] {
            assert_eq!(drawn(&mut Pace::default(), motion, 300), 300, "{motion:?}");
        }
        let mut pace = Pace::default();
        let lingers = drawn(&mut pace, Motion::Still, 31);
        assert_eq!(lingers, 31, "what the last input has set going comes to its end");
        let beats = drawn(&mut pace, Motion::Still, 300);
        assert!((15..=21).contains(&beats), "{beats} in ten seconds");
        let beats = drawn(&mut pace, Motion::Still, 300);
        assert!((2..=3).contains(&beats), "{beats} in ten seconds when the player has left");
        // The first frame of a rest is kept, and only what is kept is shown again.
        let mut pace = Pace::default();
        let mut before = Picture::Drawn;
        for _ in 0..200 {
            pace.note(&input());
            let now = pace.decide(Motion::Still, EASY, 100.0);
            assert!(now != Picture::Again || before != Picture::Drawn);
            before = now;
        }
    }

    #[test]
    fn every_input_and_every_new_screen_is_drawn_at_once() {
        let key = || [Key::Tab].into_iter().collect();
        let does = [
            Input { pointer: Vec2::new(1.0, 0.0), ..input() },
            Input { click: true, ..input() },
            Input { wheel: 1.0, ..input() },
            Input { typed: "a".into(), ..input() },
            Input { pressed: key(), ..input() },
            Input { held: key(), ..input() },
            Input { away: true, ..input() },
            Input { dropped: vec!["level".into()], ..input() },
            Input { frame: crate::draw::layout::Frame::of_window(Vec2::new(900.0, 500.0)), ..input() },
        ];
        for done in does {
            let mut pace = Pace::default();
            drawn(&mut pace, Motion::Still, 100);
            assert_eq!(pace.note(&done), 0.0, "{done:?}");
            assert_eq!(pace.decide(Motion::Still, EASY, 100.0), Picture::Drawn, "{done:?}");
            drawn(&mut pace, Motion::Still, 100);
            assert_eq!(pace.decide(Motion::Still, EASY, 0.0), Picture::Drawn, "a screen that has just opened");
        }
    }

    #[test]
    fn flights_wait_for_nothing_menus_for_their_frame_and_a_press_for_none() {
        let (mut pace, away) = (Pace::default(), Input { away: true, ..input() });
        let press = Input { pressed: [Key::Enter].into_iter().collect(), ..input() };
        assert_eq!(pace.interval(Motion::Full, &input()), 0.0);
        for motion in [Motion::Easy, Motion::Still] {
            assert_eq!(pace.interval(motion, &input()), EASY);
            assert_eq!(pace.interval(motion, &press), 0.0);
        }
        assert_eq!(pace.interval(Motion::Full, &away), EASY, "nobody steers");
        assert_eq!(pace.interval(Motion::Still, &away), EASY);
        drawn(&mut pace, Motion::Still, 100);
        assert_eq!(pace.interval(Motion::Still, &away), AWAY);
        assert_eq!(pace.interval(Motion::Still, &input()), EASY);
        drawn(&mut pace, Motion::Still, 600);
        assert_eq!(pace.interval(Motion::Still, &input()), DOZE);
        assert_eq!(pace.interval(Motion::Still, &press), 0.0);
    }
}
