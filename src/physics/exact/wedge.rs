//! What bounces to and fro between a wall and another body without loss, in closed form. In the distances from the wall, less widths and measured by
//! √mass, the motion of both is a straight path in a wedge, which each hit folds (Galperin 2003).

/// Of the other body and of the one in between, √kg, √kg·m and √kg·m/s; the wall moves with `wall` m/s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wedge {
    wall: f64,
    sizes: [f64; 2],
    place: [f64; 2],
    speed: [f64; 2],
}

impl Wedge {
    /// From masses, distances, and speeds away from the wall.
    pub fn new(wall: f64, masses: [f64; 2], ways: [f64; 2], speeds: [f64; 2]) -> Self {
        let sizes = masses.map(f64::sqrt);
        Self { wall, sizes, place: [0, 1].map(|k| sizes[k] * ways[k]), speed: [0, 1].map(|k| sizes[k] * (speeds[k] - wall)) }
    }

    fn angle(&self) -> f64 {
        libm::atan2(self.sizes[1], self.sizes[0])
    }

    /// How many hits are still to come.
    pub fn hits(&self) -> f64 {
        (self.turn(self.speed) / self.angle()).abs()
    }

    /// The angle from its place to another one, −π to π: no path in a wedge turns by more.
    fn turn(&self, [x, y]: [f64; 2]) -> f64 {
        let [from_x, from_y] = self.place;
        libm::atan2(from_x * y - from_y * x, from_x * x + from_y * y)
    }

    /// By how much each has moved after `time` seconds, and how fast it moves.
    pub fn at(&self, time: f64) -> [[f64; 2]; 2] {
        let there = [0, 1].map(|k| self.place[k] + self.speed[k] * time);
        let begun = libm::atan2(self.place[1], self.place[0]);
        let folds = ((begun + self.turn(there)) / self.angle()).floor();
        let odd = folds.rem_euclid(2.0);
        let fold = |of: [f64; 2]| {
            let (turned, size) = (begun + self.turn(of) - (folds + odd) * self.angle(), (of[0] * of[0] + of[1] * of[1]).sqrt());
            [size * libm::cos(turned), (1.0 - 2.0 * odd) * size * libm::sin(turned)]
        };
        let (now, speed) = (fold(there), fold(self.speed));
        [0, 1].map(|k| [(now[k] - self.place[k]) / self.sizes[k] + self.wall * time, speed[k] / self.sizes[k] + self.wall])
    }
}
