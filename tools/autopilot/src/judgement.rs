//! How a person misjudges: other errors at each step.

use rand::RngExt;
use rand_pcg::Pcg32;
use resultant::physics::DVec2;

/// The errors of a pilot who sees like a person.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// By how much places are misjudged, m, and speeds, a share of themselves: most by less, none by more than three times that.
    pub places: f64,
    pub speeds: f64,
    pub random: Pcg32,
    /// The present errors: of places, m, and a factor of speeds.
    pub off: DVec2,
    pub speed: f64,
}

impl Judgement {
    pub fn new(places: f64, speeds: f64, random: Pcg32) -> Self {
        Self { places, speeds, random, off: DVec2::ZERO, speed: 1.0 }
    }

    pub fn misjudge(&mut self) {
        let mut one = || (0..4).map(|_| self.random.random_range(-1.0..1.0)).sum::<f64>() * 0.866;
        let (x, y, speed) = (one(), one(), one());
        (self.off, self.speed) = (DVec2::new(x, y) * self.places, 1.0 + self.speeds * speed);
    }
}
