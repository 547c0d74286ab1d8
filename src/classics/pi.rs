//! π from collisions: a wall at the left, a light block at rest, a heavy one of 100^N times its mass that moves towards it; no
//! friction, nothing lost. They collide as often as the first N+1 digits of π say (G. Galperin, "Playing pool with π", Regular and
//! Chaotic Dynamics 8, 2003): ⌈π/atan(√(m₁/m₂))⌉ − 1 times. The formula is a check in the tests; here the collisions are counted.
//!
//! [`count`] and [`Blocks`] jump from collision to collision, [`step_through`] moves in steps, as games do, and shows where that fails.
//!
//! Blocks and wall take turns, so their collisions come in rounds: block against block, light block against wall. With the heavy
//! block's velocity u₂ and the closing speed h = u₁ − u₂ before a round, the pair formula reads
//! v₂' = u₂ + d·h with d = 2m₁/(m₁+m₂), and the closing speed is turned round: v₁' = v₂' − h. The wall turns v₁' into −v₁'. So a round is
//!
//! > u₂ ← u₂ + d·h, then h ← −v₁' − u₂ = h − 2u₂.
//!
//! No difference of nearly equal numbers and no coefficient near 1 is left, over which the pair formula itself stumbles in `f64` from N = 8 on, where
//! m₁ + m₂ rounds to m₂. It is an area-preserving map: what the rounding of a round does is not amplified by later ones. The angle that the rounds
//! add up to (π after the last collision) has to be right to a few tenths of 10^−N; after the 1.6·10⁹ rounds of N = 9 it is so to 10^−13.

/// The largest N: one more digit would need ten times as many collisions, and more exact numbers than `f64`.
pub const MAX_N: u32 = 9;
/// The light block's distance from the wall at the start, m.
pub const LIGHT_START: f64 = 1.0;
/// Where the heavy block would touch the light one if that stood at the wall, at the start, m: block widths play no part.
pub const HEAVY_START: f64 = 2.0;
/// The heavy block's velocity at the start, m/s. The light block is at rest.
pub const HEAVY_VELOCITY: f64 = -1.0;
/// How long [`step_through`] goes on, s. For every N up to [`MAX_N`] the true last collision comes before 8 s.
pub const STEPPED_DURATION: f64 = 20.0;
/// More steps than this are refused instead of computed for minutes: 10⁹ take about 3 s, and so the least step is 20 ns.
const MAX_STEPS: f64 = 1e9;

/// Velocities after an elastic collision along a line of masses m₁, m₂ (kg) with velocities u₁, u₂ (m/s).
pub fn elastic(m1: f64, u1: f64, m2: f64, u2: f64) -> (f64, f64) {
    let total = m1 + m2;
    (((m1 - m2) * u1 + 2.0 * m2 * u2) / total, ((m2 - m1) * u2 + 2.0 * m1 * u1) / total)
}

/// The heavy block's mass in light ones: 100^N, exact for N ≤ [`MAX_N`].
pub fn mass_ratio(n: u32) -> f64 {
    100_u64.pow(n) as f64
}

/// How often the blocks and the wall collide, for N ≤ [`MAX_N`].
pub fn count(n: u32) -> u64 {
    // Rounds as above, with w = 2u₂ instead of u₂, so that one is w ← w + k·h, h ← h − w with k = 2d.
    let k = 4.0 / (1.0 + mass_ratio(n));
    let (mut w, mut h) = (2.0 * HEAVY_VELOCITY, -HEAVY_VELOCITY);
    let mut rounds = 0;
    // Every step of a round waits for the one before it. Two rounds multiplied out (w₂ = w + k·h + k·h₁, h₂ = h − w₁ − w₂) wait no
    // longer than one. Both take place where h₂ > 0: then h₁ = h₂ + w₂ > 0 or, with w₁ < w₂ ≤ 0, h₁ = h − w₁ > 0.
    let [w_h, h_w, h_h] = [k * (2.0 - k), 2.0 - k, k * (3.0 - k)];
    loop {
        let w_after = w + (w_h * h - k * w);
        let h_after = h - (h_w * w + h_h * h);
        if h_after <= 0.0 {
            break;
        }
        (w, h) = (w_after, h_after);
        rounds += 2;
    }
    while h > 0.0 {
        w += k * h;
        h -= w;
        rounds += 1;
    }
    // In the last round the light block may not have come back to the wall: v₁' = −(h + u₂) ≥ 0.
    let wall_left_out = h + 0.5 * w <= 0.0;
    2 * rounds - u64::from(wall_left_out)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Collision {
    Blocks,
    Wall,
}

/// The blocks with positions and times, moved from collision to collision. Positions count from the wall, less the light block's
/// width for the heavy one: the blocks touch where they are equal.
#[derive(Clone, Debug, PartialEq)]
pub struct Blocks {
    d: f64,
    pub time: f64,
    /// The rounding error of `time` from the sum of delays (W. Kahan, 1965): in the thick of N = 7 a delay is a few times its last bit.
    time_lost: f64,
    light: f64,
    heavy: f64,
    /// Since the last collision, m/s.
    light_velocity: f64,
    heavy_velocity: f64,
    closing: f64,
    pub collisions: u64,
}

impl Blocks {
    /// The blocks at the start, for N ≤ [`MAX_N`].
    pub fn new(n: u32) -> Self {
        Self {
            d: 2.0 / (1.0 + mass_ratio(n)),
            time: 0.0,
            time_lost: 0.0,
            light: LIGHT_START,
            heavy: HEAVY_START,
            light_velocity: 0.0,
            heavy_velocity: HEAVY_VELOCITY,
            closing: -HEAVY_VELOCITY,
            collisions: 0,
        }
    }

    /// Positions of the light and the heavy block at `time` (s), between the last collision and the next, m.
    pub fn positions(&self, time: f64) -> (f64, f64) {
        let elapsed = time - self.time;
        (self.light + self.light_velocity * elapsed, self.heavy + self.heavy_velocity * elapsed)
    }

    /// The coming collision and how long after the last one it is, s; `None` after the very last.
    fn coming(&self) -> Option<(Collision, f64)> {
        if self.collisions.is_multiple_of(2) {
            (self.closing > 0.0).then(|| (Collision::Blocks, (self.heavy - self.light) / self.closing))
        } else {
            (self.light_velocity < 0.0).then(|| (Collision::Wall, self.light / -self.light_velocity))
        }
    }

    /// s; `None` after the very last.
    pub fn next_time(&self) -> Option<f64> {
        self.coming().map(|(_, delay)| self.time + (delay + self.time_lost))
    }

    /// Jumps to the coming collision and returns its kind; `None`, and nothing changes, after the very last.
    pub fn collide(&mut self) -> Option<Collision> {
        let (collision, delay) = self.coming()?;
        let delay_and_lost = delay + self.time_lost;
        let time = self.time + delay_and_lost;
        self.time_lost = delay_and_lost - (time - self.time);
        self.time = time;
        match collision {
            Collision::Blocks => {
                self.light += self.light_velocity * delay;
                self.heavy = self.light;
                self.heavy_velocity += self.d * self.closing;
                self.light_velocity = self.heavy_velocity - self.closing;
                self.closing -= 2.0 * self.heavy_velocity;
            }
            Collision::Wall => {
                self.light = 0.0;
                self.heavy += self.heavy_velocity * delay;
                self.light_velocity = -self.light_velocity;
            }
        }
        self.collisions += 1;
        Some(collision)
    }

    /// Makes the collisions up to `time` (s), `at_most` of them; returns their number. The same collisions come out however
    /// the time is cut into calls.
    pub fn advance(&mut self, time: f64, at_most: u64) -> u64 {
        let before = self.collisions;
        while self.collisions - before < at_most && self.next_time().is_some_and(|next| next <= time) {
            self.collide();
        }
        self.collisions - before
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stepped {
    /// Overlaps resolved, which should be collisions.
    pub collisions: u64,
    /// Moves made: the cost.
    pub steps: u64,
}

/// Moves the blocks in steps of `dt` s, each cut into `substeps`, and resolves the overlaps that it finds after each: the light block
/// is put back before the wall, or before the heavy block, and the velocities change as in a collision. It goes on until the blocks
/// part for good or [`STEPPED_DURATION`] is over.
///
/// It fails where the blocks turn round in less time than its two collisions a step allow: the heavy block is then carried on
/// through the wall, and what overlaps there is not always a collision.
/// Errors: a sentence, when `dt` is not above 0 and finite, `substeps` is 0, or the steps would be too many to wait for.
pub fn step_through(n: u32, dt: f64, substeps: u32) -> Result<Stepped, String> {
    if !(dt > 0.0 && dt.is_finite()) {
        return Err(format!("dt: found {dt}, expected a finite number of seconds above 0"));
    }
    if substeps == 0 {
        return Err("substeps: found 0, expected 1 or more".to_owned());
    }
    let h = dt / f64::from(substeps);
    let most = (STEPPED_DURATION / h).ceil();
    if most > MAX_STEPS {
        let found = format!("{dt:e} s in {substeps} {}", if substeps == 1 { "step" } else { "substeps" });
        return Err(format!("dt: found {found}, which makes {most:.0e} steps, expected at most {MAX_STEPS:e}"));
    }
    let heavy_mass = mass_ratio(n);
    let (mut light, mut heavy) = (LIGHT_START, HEAVY_START);
    let (mut u1, mut u2) = (0.0, HEAVY_VELOCITY);
    let mut done = Stepped { collisions: 0, steps: 0 };
    let parted = |light: f64, heavy: f64, u1: f64, u2: f64| light >= 0.0 && u1 >= 0.0 && heavy >= light && u2 >= u1;
    while done.steps < most as u64 && !parted(light, heavy, u1, u2) {
        light += u1 * h;
        heavy += u2 * h;
        if light < 0.0 {
            light = 0.0;
            u1 = -u1;
            done.collisions += 1;
        }
        if light > heavy {
            light = heavy;
            (u1, u2) = elastic(1.0, u1, heavy_mass, u2);
            done.collisions += 1;
        }
        done.steps += 1;
    }
    Ok(done)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pair_formula_gives_the_test_values() {
        for ((m1, u1), (m2, u2), (v1, v2)) in [
            ((1.0, 2.0), (1.0, -3.0), (-3.0, 2.0)),
            ((2.0, 4.0), (1.0, -3.0), (-2.0 / 3.0, 19.0 / 3.0)),
            ((2.0, 0.0), (1.0, -3.0), (-2.0, 1.0)),
            ((1.0, 2.0), (1.0, 3.0), (3.0, 2.0)),
            ((1.0, 2.0), (1.0, 2.0), (2.0, 2.0)),
            ((100.0, 5.0), (1.0, -3.0), (4.841584158415841, 12.841584158415841)),
            ((2.0, 0.0), (1.0, 0.0), (0.0, 0.0)),
        ] {
            let (w1, w2) = elastic(m1, u1, m2, u2);
            assert!((w1 - v1).abs() <= 1e-15 * v1.abs() && (w2 - v2).abs() <= 1e-15 * v2.abs(), "{w1} {w2}, not {v1} {v2}");
        }
    }

    #[test]
    fn a_round_is_the_pair_formula_and_the_wall() {
        for n in 0..=4 {
            let mut blocks = Blocks::new(n);
            for _ in 0..(1_u64 << n) {
                let (u1, u2) = (blocks.light_velocity, blocks.heavy_velocity);
                let (v1, v2) = elastic(1.0, u1, mass_ratio(n), u2);
                blocks.collide();
                let (w1, w2) = (blocks.light_velocity, blocks.heavy_velocity);
                assert!((w1 - v1).abs() < 1e-12 * (1.0 + v1.abs()) && (w2 - v2).abs() < 1e-12, "{n}: {w1} {w2}, not {v1} {v2}");
                blocks.collide();
                assert_eq!((blocks.light_velocity, blocks.heavy_velocity), (-w1, w2));
            }
        }
    }
}
