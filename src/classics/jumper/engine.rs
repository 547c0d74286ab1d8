//! An engine of cuboids, z up: moving cuboids fall, land on platforms, stop at walls and bounce off each other elastically.
//!
//! Cuboids collide only when they overlap: touching is not colliding. So a cuboid on a platform sinks in a little by every step's
//! fall, hits the top and is put back.
//!
//! The tower: walls at both sides and rows of platforms that are generated ahead of the climb. The same seed builds the same tower.

use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;

/// A box: its corner with the smallest coordinates, and its extent, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    pub location: DVec3,
    /// Extent along each axis, above 0.
    pub dimensions: DVec3,
}

impl Cuboid {
    /// The corner with the largest coordinates.
    pub fn end(&self) -> DVec3 {
        self.location + self.dimensions
    }

    pub fn centre(&self) -> DVec3 {
        self.location + 0.5 * self.dimensions
    }

    /// Whether the two share more than faces, edges or corners.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.location.cmplt(other.end()).all() && other.location.cmplt(self.end()).all()
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dynamic {
    pub cuboid: Cuboid,
    /// m/s.
    pub velocity: DVec3,
    /// kg, above 0.
    pub mass: f64,
    /// The location before the last step's move.
    pub previous: DVec3,
    /// Whether it stood on the ground or on a platform at the end of the last step.
    pub on_ground: bool,
}

impl Dynamic {
    pub fn new(cuboid: Cuboid, velocity: DVec3, mass: f64) -> Self {
        Self { cuboid, velocity, mass, previous: cuboid.location, on_ground: false }
    }
}

/// The effect of a static cuboid on moving ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StaticKind {
    /// Carries bodies from above; lets all others pass.
    Platform,
    /// Stops motion along x; lets all other motion pass.
    Wall,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Static {
    pub cuboid: Cuboid,
    pub kind: StaticKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CuboidFace {
    Bottom,
    Top,
    MinX,
    MaxX,
    MinY,
    MaxY,
    /// None: the two overlapped already before the step.
    Internal,
}

/// A collision in a step, by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CuboidHit {
    Static {
        object: usize,
        obstacle: usize,
        face: CuboidFace,
    },
    /// Two dynamic cuboids, the first with the smaller index.
    Pair(usize, usize),
}

/// Moves everything by `dt` s under `gravity` m/s², then answers the collisions in order of index; `hits` is cleared and filled.
pub fn step(dynamics: &mut [Dynamic], statics: &[Static], gravity: f64, dt: f64, hits: &mut Vec<CuboidHit>) {
    hits.clear();
    for (object, dynamic) in dynamics.iter_mut().enumerate() {
        advance(dynamic, gravity, dt);
        for (obstacle, other) in statics.iter().enumerate() {
            if dynamic.cuboid.overlaps(&other.cuboid) {
                let face = face_hit(&Cuboid { location: dynamic.previous, ..dynamic.cuboid }, &other.cuboid);
                answer(dynamic, other, face);
                hits.push(CuboidHit::Static { object, obstacle, face });
            }
        }
    }
    for second in 1..dynamics.len() {
        let (before, from_second) = dynamics.split_at_mut(second);
        for (first, other) in before.iter_mut().enumerate() {
            if other.cuboid.overlaps(&from_second[0].cuboid) {
                bounce(other, &mut from_second[0]);
                hits.push(CuboidHit::Pair(first, second));
            }
        }
    }
}

fn advance(dynamic: &mut Dynamic, gravity: f64, dt: f64) {
    dynamic.velocity.z -= gravity * dt;
    dynamic.previous = dynamic.cuboid.location;
    dynamic.cuboid.location += dynamic.velocity * dt;
    dynamic.on_ground = dynamic.cuboid.location.z <= 0.0;
    if dynamic.on_ground {
        dynamic.cuboid.location.z = 0.0;
        dynamic.velocity.z = 0.0;
    }
}

/// The face of `obstacle` in front of which `before`, the moving cuboid before its step, was. In front of two, past an edge, it is
/// the first in the order of [`CuboidFace`].
pub fn face_hit(before: &Cuboid, obstacle: &Cuboid) -> CuboidFace {
    // Beside each other, touching included: two that overlap after the step only touched before it.
    let under = before.end().cmple(obstacle.location);
    let over = before.location.cmpge(obstacle.end());
    match () {
        () if under.z => CuboidFace::Bottom,
        () if over.z => CuboidFace::Top,
        () if under.x => CuboidFace::MinX,
        () if over.x => CuboidFace::MaxX,
        () if under.y => CuboidFace::MinY,
        () if over.y => CuboidFace::MaxY,
        () => CuboidFace::Internal,
    }
}

fn answer(dynamic: &mut Dynamic, other: &Static, face: CuboidFace) {
    let location = &mut dynamic.cuboid.location;
    match (other.kind, face) {
        (StaticKind::Platform, CuboidFace::Top) => {
            location.z = other.cuboid.end().z;
            dynamic.velocity.z = 0.0;
            dynamic.on_ground = true;
        }
        (StaticKind::Wall, CuboidFace::MinX) => {
            location.x = start_that_ends_at(other.cuboid.location.x, dynamic.cuboid.dimensions.x);
            dynamic.velocity.x = 0.0;
        }
        (StaticKind::Wall, CuboidFace::MaxX) => {
            location.x = other.cuboid.end().x;
            dynamic.velocity.x = 0.0;
        }
        (StaticKind::Platform | StaticKind::Wall, _) => {}
    }
}

/// The start of a stretch that ends at `edge`, touching. Were its end rounded beyond the edge, the next step would count an overlap
/// from before and let the cuboid through the wall.
fn start_that_ends_at(edge: f64, extent: f64) -> f64 {
    let start = edge - extent;
    if start + extent > edge { start.next_down() } else { start }
}

/// The elastic collision along the line between the centres, whether they approach or not.
fn bounce(a: &mut Dynamic, b: &mut Dynamic) {
    let normal = a.cuboid.centre() - b.cuboid.centre();
    let squared = normal.length_squared();
    if squared == 0.0 {
        return; // Centre on centre there is no such line.
    }
    let exchanged = normal * (2.0 / (a.mass + b.mass) * (a.velocity - b.velocity).dot(normal) / squared);
    a.velocity -= b.mass * exchanged;
    b.velocity += a.mass * exchanged;
}

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
    pub statics: Vec<Static>,
}

impl Tower {
    /// The two walls, and no platform yet.
    pub fn new(seed: u64) -> Self {
        let wall = |x| slab(StaticKind::Wall, DVec3::new(x, 0.0, 0.0), DVec3::new(THICKNESS, DEPTH, WALL_HEIGHT));
        Self { random: Pcg32::new(seed, STREAM), rows: 0, left_out: 0, statics: vec![wall(-THICKNESS), wall(WIDTH)] }
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

    #[test]
    fn a_stretch_put_against_an_edge_never_ends_behind_it() {
        let mut different = 0;
        for i in 1..2000 {
            for extent in [0.1, 0.3, 1.0 / 3.0, 14.7] {
                let edge = f64::from(i) * 0.013;
                let start = start_that_ends_at(edge, extent);
                assert!(start + extent <= edge && edge - (start + extent) < 1e-14, "{edge} {extent}");
                different += usize::from((edge - extent) + extent > edge);
            }
        }
        assert!(different > 0, "no case in which rounding would have mattered");
    }

    fn rows(seed: u64, height: u32) -> Vec<Vec<Cuboid>> {
        let mut tower = Tower::new(seed);
        tower.grow_to(f64::from(height));
        let platforms: Vec<Cuboid> = tower.statics[2..].iter().map(|it| it.cuboid).collect();
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
        assert_eq!(tower.statics, again.statics);
        assert_ne!(rows(7, 30), rows(8, 30));
        again.drop_below(12.5);
        assert!(again.statics[2..].iter().all(|it| it.cuboid.location.z >= 13.0));
        assert_eq!(again.statics[..2], tower.statics[..2]);
    }
}
