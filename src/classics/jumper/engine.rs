//! An engine of cuboids, z up: moving cuboids fall, land on platforms, stop at walls and bounce off each other elastically.
//!
//! Cuboids collide only when they overlap: touching is not colliding. So a cuboid on a platform sinks in a little by every step's
//! fall, hits the top and is put back.

use glam::DVec3;

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
    /// A dynamic cuboid with a static one.
    Static { object: usize, obstacle: usize, face: CuboidFace },
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
}
