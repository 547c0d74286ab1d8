//! Whether a body is in an air stream.

use super::flow::Pose;
use super::tuning::SLOP;
use super::{Aabb, Body};

/// Whether a body in a pose feels a stream that blows in a zone: touching suffices, but what leaves it has left it. So what a tick finds does
/// not depend on how the time of a crossing was rounded.
pub(super) fn feels(zone: &Aabb, body: &Body, (position, velocity): Pose) -> bool {
    let apart = position - zone.centre();
    let gap = apart.abs() - body.half - zone.size() * 0.5;
    (0..2).all(|axis| gap[axis] < -SLOP || (gap[axis] <= SLOP && velocity[axis] * apart[axis].signum() <= 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, DVec2};

    #[test]
    fn touching_counts_and_leaving_does_not() {
        let zone = Aabb::new(DVec2::ZERO, DVec2::ONE);
        let body = Body::new(&BodyDef::default());
        let feels = |x: f64, v: f64| feels(&zone, &body, (DVec2::new(x, 0.5), DVec2::new(v, 0.0)));
        assert!(feels(1.4, 3.0) && feels(1.5, 0.0) && feels(1.5, -2.0));
        assert!(!feels(1.5, 2.0) && !feels(1.6, -2.0));
    }
}
