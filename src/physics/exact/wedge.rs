//! What bounces to and fro between a wall and another body without loss, hit by hit: both fall alike, so that between two hits their gap changes evenly.

/// Of the other body and of the one in between, kg, m and m/s away from the wall, which moves with `wall` m/s; both fall with `pull` m/s².
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wedge {
    pub wall: f64,
    pub masses: [f64; 2],
    pub ways: [f64; 2],
    pub speeds: [f64; 2],
    pub pull: f64,
}

impl Wedge {
    /// How many hits come within a time, s, if the gap stays as it is.
    pub fn hits(&self, time: f64) -> f64 {
        (self.speeds[1] - self.speeds[0]) * time / (self.ways[0] - self.ways[1]).max(f64::MIN_POSITIVE)
    }

    /// The highest that the other body gets within a time, m: its energy is never more than that of both.
    pub fn highest(&self, time: f64) -> f64 {
        let [far, middle] = self.speeds.map(|speed| (speed - self.wall) * (speed - self.wall));
        let lifted = 2.0 * self.pull.abs() * (self.ways[0] + self.ways[1] * self.masses[1] / self.masses[0]);
        self.ways[0] + (self.wall.abs() + (far + middle * self.masses[1] / self.masses[0] + lifted).sqrt()) * time
    }

    /// By how much each has moved after `time` seconds, and how fast it moves.
    pub fn at(&self, time: f64) -> [[f64; 2]; 2] {
        let ([mut y, mut x], [mut w, mut u]) = (self.ways, self.speeds.map(|speed| speed - self.wall));
        let (a, sum, mut left) = (self.pull, self.masses[0] + self.masses[1], time);
        // Bodies at the ends of the domain, 10⁻³ and 10⁵ kg, hit each other and a wall 31 416 times.
        for _ in 0..u16::MAX {
            let to_other = if u > w { (y - x).max(0.0) / (u - w) } else { f64::INFINITY };
            let root = (u * u - 2.0 * a * x).max(0.0).sqrt();
            let to_wall = match u > 0.0 {
                true if a < 0.0 => (u + root) / -a,
                false if u < 0.0 || a < 0.0 => 2.0 * x / (root - u),
                _ => f64::INFINITY,
            };
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
        let moved = self.wall * time;
        [[y - self.ways[0] + moved, w + self.wall], [x - self.ways[1] + moved, u + self.wall]]
    }
}
