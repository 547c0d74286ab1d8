//! The tower: walls at both sides and rows of platforms that are generated ahead of the climb. The same seed builds the same tower.

use super::engine::{Cuboid, Static, StaticKind};
use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;

/// Between the walls, m.
pub const WIDTH: f64 = 15.0;
/// Walls across, platforms in height, m.
pub const THICKNESS: f64 = 0.1;
/// How far platforms and walls reach along y, m: as far as everything in the scene.
pub const DEPTH: f64 = 1.0;
/// From one row of platforms to the next, m.
const ROW_HEIGHT: f64 = 1.0;
/// The share of rows that are left out …
const LEFT_OUT: f64 = 0.2;
/// … and the most of them that follow each other.
const MAX_LEFT_OUT: u32 = 2;
/// Platforms are this wide, m.
const PLATFORM_WIDTHS: (f64, f64) = (1.0, 6.0);
/// Before a platform there is a gap with this probability …
const GAP_SHARE: f64 = 0.8;
/// … of at most this width, m.
const MAX_GAP: f64 = 8.0;
/// The walls' height, m. At the fastest climb, 8 m/s, it takes days to get there.
const WALL_HEIGHT: f64 = 1e7;
/// The generator's stream: any number, but another one builds other towers from the same seeds.
const STREAM: u64 = 0;

/// Walls and platforms, from a little below the view to a little above it.
#[derive(Clone, Debug)]
pub struct Tower {
    random: Pcg32,
    rows: u32,
    left_out: u32,
    statics: Vec<Static>,
}

impl Tower {
    /// The two walls, and no platform yet.
    pub fn new(seed: u64) -> Self {
        let wall = |x| slab(StaticKind::Wall, DVec3::new(x, 0.0, 0.0), DVec3::new(THICKNESS, DEPTH, WALL_HEIGHT));
        Self { random: Pcg32::new(seed, STREAM), rows: 0, left_out: 0, statics: vec![wall(-THICKNESS), wall(WIDTH)] }
    }

    /// The two walls, then the platforms from below to above.
    pub fn statics(&self) -> &[Static] {
        &self.statics
    }

    /// Generates all rows up to `height` m.
    pub fn grow_to(&mut self, height: f64) {
        while f64::from(self.rows + 1) * ROW_HEIGHT <= height {
            self.rows += 1;
            self.add_row(f64::from(self.rows) * ROW_HEIGHT);
        }
    }

    /// Drops the platforms below `height` m: no player comes back to them.
    pub fn drop_below(&mut self, height: f64) {
        self.statics.retain(|it| it.kind == StaticKind::Wall || it.cuboid.end().z >= height);
    }

    fn add_row(&mut self, height: f64) {
        if self.left_out < MAX_LEFT_OUT && self.fraction() < LEFT_OUT {
            self.left_out += 1;
            return;
        }
        self.left_out = 0;
        let (narrowest, widest) = PLATFORM_WIDTHS;
        let mut from = 0.0;
        while from + narrowest <= WIDTH {
            let gap = if self.fraction() < GAP_SHARE { MAX_GAP * self.fraction() } else { 0.0 };
            let width = narrowest + (widest - narrowest) * self.fraction();
            let mut start = from + gap;
            if start + narrowest > WIDTH {
                // Nothing fits behind the gap: the row ends here, unless that would leave a wider one up to the wall.
                if WIDTH - from <= MAX_GAP {
                    break;
                }
                start = WIDTH - narrowest;
            }
            let end = (start + width).min(WIDTH);
            let dimensions = DVec3::new(end - start, DEPTH, THICKNESS);
            self.statics.push(slab(StaticKind::Platform, DVec3::new(start, 0.0, height), dimensions));
            from = end;
        }
    }

    /// Evenly from [0, 1): the generator's bits directly, because distributions in libraries may change.
    fn fraction(&mut self) -> f64 {
        f64::from(self.random.next_u32()) / 4_294_967_296.0
    }
}

fn slab(kind: StaticKind, location: DVec3, dimensions: DVec3) -> Static {
    Static { cuboid: Cuboid { location, dimensions }, kind }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(seed: u64, height: u32) -> Vec<Vec<Cuboid>> {
        let mut tower = Tower::new(seed);
        tower.grow_to(f64::from(height));
        let platforms: Vec<Cuboid> = tower.statics()[2..].iter().map(|it| it.cuboid).collect();
        (1..=height).map(|z| platforms.iter().copied().filter(|it| it.location.z == f64::from(z)).collect()).collect()
    }

    #[test]
    fn rows_gaps_and_widths_are_within_their_bounds() {
        let (mut left_out, mut platforms, mut adjacent) = (0, 0, 0);
        for seed in 0..20 {
            let rows = rows(seed, 500);
            assert!(!rows.windows(3).any(|three| three.iter().all(Vec::is_empty)), "three rows left out, seed {seed}");
            left_out += rows.iter().filter(|row| row.is_empty()).count();
            for row in rows.iter().filter(|row| !row.is_empty()) {
                let mut from = 0.0;
                for platform in row {
                    let gap = platform.location.x - from;
                    assert!((0.0..=8.0).contains(&gap), "a gap of {gap}, seed {seed}");
                    assert!((0.999_999..=6.0).contains(&platform.dimensions.x), "{platform:?}, seed {seed}");
                    from = platform.end().x;
                    adjacent += usize::from(gap == 0.0);
                    platforms += 1;
                }
                assert!((-1e-12..=8.0).contains(&(15.0 - from)), "a gap of {} at the wall, seed {seed}", 15.0 - from);
            }
        }
        // 0.2 of the rows, less what the third in a row would have been: about 0.194.
        assert!((1850..2030).contains(&left_out), "{left_out} of 10 000 rows left out");
        let share = adjacent as f64 / platforms as f64;
        assert!((0.15..0.35).contains(&share), "{share} of the platforms without a gap before them");
    }

    #[test]
    fn a_seed_builds_the_same_tower_however_it_is_asked_for() {
        let mut tower = Tower::new(7);
        for tenths in 0..300 {
            tower.grow_to(f64::from(tenths) / 10.0);
        }
        tower.grow_to(30.0);
        let mut again = Tower::new(7);
        again.grow_to(30.0);
        assert_eq!(tower.statics(), again.statics());
        assert_ne!(rows(7, 30), rows(8, 30));
        again.drop_below(12.5);
        assert!(again.statics()[2..].iter().all(|it| it.cuboid.location.z >= 13.0));
        assert_eq!(again.statics()[..2], tower.statics()[..2]);
    }
}
