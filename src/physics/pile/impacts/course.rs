//! The way of one body along one axis through a step: a parabola, until it is hit.

/// The motion of one body along one axis: at the step's start as if it had never been hit, and its acceleration.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Course {
    pub at: f64,
    pub velocity: f64,
    pub pull: f64,
    /// Whether it goes straight because air or a liquid brakes it so much; how fast it is in the end, m/s, and how fast it gets there, 1/s, or 0.
    pub braked: bool,
    pub end: f64,
    pub fade: f64,
}

/// How far from a parabola by its velocities at both ends a way may end and be taken for one, as a part of those velocities times the step. Larger:
/// what a medium stops within microseconds would go out and come back; smaller: drag makes impacts slower than they are.
const BENT: f64 = 0.125;

impl Course {
    /// Of something that begins at `at` with `velocity`, and is at `end.0` with `end.1` after `dt` seconds if nothing hits it: by its velocities at
    /// both ends. What is braked so much that this leads elsewhere goes straight to where it ends.
    pub(super) fn to(end: (f64, f64), (at, velocity): (f64, f64), dt: f64) -> Self {
        let way = end.0 - at;
        let off = (way - 0.5 * (velocity + end.1) * dt).abs();
        if off <= BENT * (velocity.abs() + end.1.abs()) * dt {
            Self::by((velocity, end.1), at, dt)
        } else {
            let fade = (velocity - end.1) / (way - end.1 * dt);
            let fade = if fade > 0.0 && fade.is_finite() { fade } else { 0.0 };
            Self { braked: true, end: end.1, fade, ..Self::straight(at, way / dt) }
        }
    }

    /// Of something that nothing pulls at.
    pub(super) fn straight(at: f64, velocity: f64) -> Self {
        Self { at, velocity, ..Self::default() }
    }

    /// Of something that begins at `at` and speeds up evenly.
    pub(super) fn by((velocity, end): (f64, f64), at: f64, dt: f64) -> Self {
        Self { at, velocity, pull: (end - velocity) * (1.0 / dt), ..Self::default() }
    }

    pub(super) fn place(&self, t: f64) -> f64 {
        self.at + (self.velocity + 0.5 * self.pull * t) * t
    }

    pub(super) fn speed(&self, t: f64) -> f64 {
        self.velocity + self.pull * t
    }

    /// How fast it would be at the end of a step of `dt` seconds.
    pub(super) fn ends(&self, dt: f64) -> f64 {
        if self.fade > 0.0 { self.end } else { self.speed(dt) }
    }
}

/// The acceleration by drag after a hit, m/s²: it was `drag` at a velocity `before`, grows with the square, acts against the motion,
/// and does not turn it round in the time `left`.
pub(super) fn slowed(drag: f64, before: f64, after: f64, left: f64) -> f64 {
    let part = if before == 0.0 { 0.0 } else { after / before };
    let most = if left > 0.0 { after.abs() / left } else { 0.0 };
    -(drag * part * part).abs().min(most).copysign(after)
}

/// How fast two part on average in the time `left`, m/s, that part with `leaves` at first, and by e^(−fade·t) less until they would close with
/// `closing`; less than 0: they are pressed together.
pub(super) fn parting(leaves: f64, closing: f64, fade: f64, left: f64) -> f64 {
    let faded = fade * left;
    let mean = if faded > 0.0 { -libm::expm1(-faded) / faded } else { 1.0 };
    (leaves + closing) * mean - closing
}

/// When a gap closes, s from now, and how fast it closes then, m/s: `closing` now, growing by `pull` a second.
pub(super) fn time_of_impact(gap: f64, closing: f64, pull: f64) -> Option<(f64, f64)> {
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
    use super::{Course, parting, time_of_impact};

    #[test]
    fn a_course_ends_where_the_body_does() {
        let fall = Course::to((1.0, 3.0), (0.0, 1.0), 0.5);
        assert_eq!((fall.velocity, fall.pull), (1.0, 4.0));
        // Stopped within microseconds from 10⁶ m/s.
        for (end, velocity) in [((0.1, 0.0), 1e6), ((-0.1, 0.0), -1e6)] {
            let course = Course::to(end, (0.0, velocity), 0.5);
            assert!((course.place(0.5) - end.0).abs() < 1e-15, "{course:?}");
            assert!(course.place(0.25).abs() <= end.0.abs(), "{course:?}");
        }
    }

    /// Terminal velocity u and time constant τ: the way is u·t + (v − u)·τ·(1 − e^(−t/τ)).
    #[test]
    fn what_a_medium_brakes_fades_to_its_terminal_velocity() {
        let (u, tau, dt): (f64, f64, f64) = (-5.0, 1e-3, 0.01);
        let rest = libm::exp(-dt / tau);
        let end = |v: f64| (u * dt + (v - u) * tau * (1.0 - rest), u + (v - u) * rest);
        let course = Course::to(end(0.7), (0.0, 0.7), dt);
        assert!((course.end - u).abs() < 1e-3 && (course.fade * tau - 1.0).abs() < 1e-3, "{course:?}");
        // Off a wall with the terminal velocity: back at it after 1.594 τ.
        assert!(parting(5.0, 5.0, 1.0 / tau, 1.59 * tau) > 0.0);
        assert!(parting(5.0, 5.0, 1.0 / tau, 1.60 * tau) < 0.0);
        // Where nothing presses, it goes back as far as it would have gone on.
        assert!((parting(5.0, 0.0, 1.0 / tau, dt) * dt - 5.0 * tau * (1.0 - rest)).abs() < 1e-15);
        assert_eq!(parting(5.0, 0.0, 0.0, dt), 5.0);
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
