//! What bounces to and fro between a wall and another body without loss, hit by hit: both fall alike, so that between two hits their gap changes evenly.

/// Of the other body and of the one in between, which begins at the wall: kg, m and m/s. The wall moves with `wall`; both fall with `pull` (m/s²).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wedge {
    pub wall: f64,
    pub masses: [f64; 2],
    pub gap: f64,
    pub speeds: [f64; 2],
    pub pull: f64,
}

impl Wedge {
    /// How many hits come within a time, s, if the gap stays as it is.
    pub fn hits(&self, time: f64) -> f64 {
        (self.speeds[1] - self.speeds[0]) * time / self.gap.max(f64::MIN_POSITIVE)
    }

    /// The highest that the other body gets within a time, m: its energy is never more than that of both.
    pub fn highest(&self, time: f64) -> f64 {
        let [far, middle] = self.speeds.map(|speed| (speed - self.wall) * (speed - self.wall));
        let most = far + middle * self.masses[1] / self.masses[0] + 2.0 * self.pull.abs() * self.gap;
        self.gap + (self.wall.abs() + most.sqrt()) * time
    }

    /// By how much each has moved after `time` seconds, and how fast it moves.
    pub fn at(&self, time: f64) -> [[f64; 2]; 2] {
        let ([mut y, mut x], [mut w, mut u]) = ([self.gap, 0.0], self.speeds.map(|speed| speed - self.wall));
        let (a, sum, mut left) = (self.pull, self.masses[0] + self.masses[1], time);
        // Bodies at the ends of the domain, 10⁻³ and 10⁵ kg, hit each other and a wall 31 416 times.
        for _ in 0..u16::MAX {
            let to_other = if u > w { (y - x).max(0.0) / (u - w) } else { f64::INFINITY };
            let root = (u * u - 2.0 * a * x.max(0.0)).sqrt();
            let to_wall = if u > 0.0 { (u + root) / -a } else { 2.0 * x.max(f64::MIN_POSITIVE) / (root - u) };
            let to_wall = if to_wall >= 0.0 { to_wall } else { f64::INFINITY };
            let t = to_other.min(to_wall).min(left);
            (x, y) = (x + (u + 0.5 * a * t) * t, y + (w + 0.5 * a * t) * t);
            (u, w, left) = (u + a * t, w + a * t, left - t);
            if left <= 0.0 {
                break;
            } else if to_other <= to_wall {
                let part = 2.0 * (u - w) / sum;
                (u, w, x) = (u - self.masses[0] * part, w + self.masses[1] * part, y);
            } else {
                (x, u) = (0.0, -u);
            }
        }
        [[y - self.gap + self.wall * time, w + self.wall], [x + self.wall * time, u + self.wall]]
    }
}
