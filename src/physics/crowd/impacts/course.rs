//! The motion of one body along one axis through a step: a parabola, until something hits it.

/// A parabola, given at the step's start as if nothing had hit the body.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Course {
    /// m.
    pub at: f64,
    /// m/s.
    pub velocity: f64,
    /// m/s².
    pub pull: f64,
}

/// A motion may end this far from the parabola by its velocities at both ends, as a part of those velocities times the step. Larger: a body that a
/// medium stops within microseconds goes out and comes back; smaller: drag ends bounces.
const BENT: f64 = 0.125;

impl Course {
    /// From `at` with `velocity` to `end` (m, m/s) after `dt` seconds. None: a medium brakes so much that this is no parabola; `slack` is rounding, m.
    pub fn to(end: (f64, f64), (at, velocity): (f64, f64), dt: f64, slack: f64) -> Option<Self> {
        let off = (end.0 - at - 0.5 * (velocity + end.1) * dt).abs();
        let near = off <= BENT * (velocity.abs() + end.1.abs()) * dt + slack;
        near.then(|| Self { at, velocity, pull: (end.1 - velocity) * (1.0 / dt) })
    }

    /// A constant velocity.
    pub fn straight(at: f64, velocity: f64) -> Self {
        Self { at, velocity, pull: 0.0 }
    }

    /// The parabola that passes `place` with `speed` at `time`.
    pub fn through(place: f64, speed: f64, time: f64, pull: f64) -> Self {
        let velocity = speed - pull * time;
        Self { at: place - (velocity + 0.5 * pull * time) * time, velocity, pull }
    }

    /// Where the body is at `t`, m.
    pub fn place(&self, t: f64) -> f64 {
        self.at + (self.velocity + 0.5 * self.pull * t) * t
    }

    /// How fast it is at `t`, m/s.
    pub fn speed(&self, t: f64) -> f64 {
        self.velocity + self.pull * t
    }

    /// Whether nothing moves along this axis.
    pub fn is_still(&self) -> bool {
        self.velocity == 0.0 && self.pull == 0.0
    }
}

/// The acceleration by drag after a hit, m/s²: it was `drag` at a velocity `before`, grows with the square, acts against the motion,
/// and does not reverse it in the time `left`.
pub(crate) fn slowed(drag: f64, before: f64, after: f64, left: f64) -> f64 {
    let part = if before == 0.0 { 0.0 } else { after / before };
    let most = if left > 0.0 { after.abs() / left } else { 0.0 };
    -(drag * part * part).abs().min(most).copysign(after)
}

/// When a gap closes, s from now, and how fast it closes then, m/s: `closing` now, growing by `pull` a second.
pub(crate) fn time_of_impact(gap: f64, closing: f64, pull: f64) -> Option<(f64, f64)> {
    if pull == 0.0 {
        return (closing > 0.0).then(|| (gap / closing, closing));
    }
    let square = closing * closing + 2.0 * pull * gap;
    if square <= 0.0 {
        return None;
    }
    let speed = square.sqrt();
    if closing > 0.0 {
        return Some((2.0 * gap / (closing + speed), speed));
    }
    (pull > 0.0).then(|| ((speed - closing) / pull, speed))
}

#[cfg(test)]
mod tests {
    use crate::physics::crowd::impacts::course::{Course, time_of_impact};

    #[test]
    fn a_course_ends_where_the_body_does() {
        let fall = Course::to((1.0, 3.0), (0.0, 1.0), 0.5, 0.0).unwrap();
        assert_eq!((fall.velocity, fall.pull, fall.place(0.5)), (1.0, 4.0, 1.0));
        // Stopped within microseconds from 10⁶ m/s.
        assert!(Course::to((0.1, 0.0), (0.0, 1e6), 0.5, 0.0).is_none());
        let hit = Course::through(1.0, -2.0, 0.25, 8.0);
        assert_eq!((hit.place(0.25), hit.speed(0.25)), (1.0, -2.0));
    }

    #[test]
    fn gaps_close_when_the_parabola_says_so() {
        assert_eq!(time_of_impact(1.0, 1.0, 0.0), Some((1.0, 1.0)));
        assert_eq!(time_of_impact(0.0, 3.0, 10.0), Some((0.0, 3.0)));
        assert_eq!(time_of_impact(0.0, -3.0, 10.0), Some((0.6, 3.0)));
        assert_eq!(time_of_impact(1.25, 0.0, 10.0), Some((0.5, 5.0)));
        assert_eq!(time_of_impact(1.0, 1.0, -10.0), None);
        assert_eq!(time_of_impact(1.0, -1.0, 0.0), None);
    }
}
