//! What bounces to and fro between two others without loss, in closed form. Where the gaps of three things in a row, each measured by √mass, are the
//! coordinates, their motion is a straight path between the sides of a wedge, and each hit folds it (Galperin 2003).

/// A row of three, the first maybe a wall; m and s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wedge {
    /// The inverse masses, 1/kg, and the velocity of all together, m/s.
    inverse: [f64; 3],
    together: f64,
    angle: f64,
    place: [f64; 2],
    speed: [f64; 2],
}

impl Wedge {
    /// From the gaps of three things, and their speeds along the row.
    pub fn new(inverse: [f64; 3], gaps: [f64; 2], speeds: [f64; 3]) -> Self {
        let [u, v, w] = inverse;
        let mut wedge = Self { inverse, together: 0.0, angle: 0.0, place: [0.0; 2], speed: [0.0; 2] };
        let ([along, across], [_, two]) = (wedge.sizes(), wedge.parts());
        // Of the first two together: what the second has of their mass, and of their gap.
        let of_first = v / (u + v);
        let both = of_first * speeds[0] + (1.0 - of_first) * speeds[1];
        wedge.together = both + two * (speeds[2] - both);
        wedge.angle = libm::atan2((u * v + u * w + v * w).sqrt(), v);
        wedge.place = [along * (gaps[1] + of_first * gaps[0]), across * gaps[0]];
        wedge.speed = [along * (speeds[2] - both), across * (speeds[1] - speeds[0])];
        wedge
    }

    /// √ of the reduced masses of the third against the first two, and of these two, √kg.
    fn sizes(&self) -> [f64; 2] {
        let [u, v, w] = self.inverse;
        [1.0 / (w + u * v / (u + v)).sqrt(), 1.0 / (u + v).sqrt()]
    }

    /// The part of the second in the mass of the first two, and of the third in that of all.
    fn parts(&self) -> [f64; 2] {
        let [u, v, w] = self.inverse;
        let both = u * v / (u + v);
        [u / (u + v), both / (w + both)]
    }

    /// How many hits are still to come.
    pub fn hits(&self) -> f64 {
        (self.turn(self.speed) / self.angle).abs()
    }

    /// The angle from its place to another one, −π to π: no path in a wedge turns by more.
    fn turn(&self, [x, y]: [f64; 2]) -> f64 {
        let [from_x, from_y] = self.place;
        libm::atan2(from_x * y - from_y * x, from_x * x + from_y * y)
    }

    /// By how much each of the three has moved along the row after `time` seconds, and how fast it moves.
    pub fn at(&self, time: f64) -> [[f64; 2]; 3] {
        let there = [0, 1].map(|k| self.place[k] + self.speed[k] * time);
        let begun = libm::atan2(self.place[1], self.place[0]);
        let folds = ((begun + self.turn(there)) / self.angle).floor();
        let odd = folds.rem_euclid(2.0);
        let fold = |of: [f64; 2]| {
            let turned = begun + self.turn(of) - (folds + odd) * self.angle;
            let size = (of[0] * of[0] + of[1] * of[1]).sqrt();
            [size * libm::cos(turned), (1.0 - 2.0 * odd) * size * libm::sin(turned)]
        };
        let ([along, across], [one, two]) = (self.sizes(), self.parts());
        // The two relative coordinates, and from them the three.
        let row = |of: [f64; 2], together: f64| {
            let (apart, gap) = (of[0] / along, of[1] / across);
            let both = together - two * apart;
            [both - one * gap, both + (1.0 - one) * gap, both + apart]
        };
        let (before, now, speeds) =
            (row(self.place, 0.0), row(fold(there), self.together * time), row(fold(self.speed), self.together));
        [0, 1, 2].map(|k| [now[k] - before[k], speeds[k]])
    }
}
