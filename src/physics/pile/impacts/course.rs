//! The way of one body along one axis through a step: a parabola, until it is hit.

/// The motion of one body along one axis: at the step's start as if it had never been hit, and its acceleration.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Course {
    pub at: f64,
    pub velocity: f64,
    pub pull: f64,
}

impl Course {
    pub(super) fn place(&self, t: f64) -> f64 {
        self.at + (self.velocity + 0.5 * self.pull * t) * t
    }

    pub(super) fn speed(&self, t: f64) -> f64 {
        self.velocity + self.pull * t
    }
}

/// The acceleration by drag after a hit, m/s²: it was `drag` at a velocity `before`, grows with the square, acts against the motion,
/// and does not turn it round in the time `left`.
pub(super) fn slowed(drag: f64, before: f64, after: f64, left: f64) -> f64 {
    let part = if before == 0.0 { 0.0 } else { after / before };
    let most = if left > 0.0 { after.abs() / left } else { 0.0 };
    -(drag * part * part).abs().min(most).copysign(after)
}

/// When a gap closes, s from now, and how fast it closes then, m/s: `closing` now, growing by `pull` a second.
pub(super) fn time_of_impact(gap: f64, closing: f64, pull: f64) -> Option<(f64, f64)> {
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
    use super::time_of_impact;

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
