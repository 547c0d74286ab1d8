//! Winds that solids shade.

use super::types::AirStream;
use crate::physics::Aabb;

/// The zone of a stream that ends, in all of its width, at the first solid before it; `None` where no zone is left.
pub(super) fn shaded(stream: &AirStream, solids: impl Iterator<Item = Aabb>) -> Option<Aabb> {
    let (mut zone, source) = (stream.zone, &stream.source);
    for solid in solids.filter(|solid| solid.overlaps(&stream.zone, 0.0)) {
        // It blows away from its source, along one axis.
        for axis in 0..2 {
            if stream.zone.min[axis] == source.max[axis] {
                zone.max[axis] = zone.max[axis].min(solid.min[axis]);
            } else if stream.zone.max[axis] == source.min[axis] {
                zone.min[axis] = zone.min[axis].max(solid.max[axis]);
            }
        }
    }
    zone.min.cmplt(zone.max).all().then_some(zone)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::DVec2;

    fn area(x: f64, y: f64, width: f64, height: f64) -> Aabb {
        Aabb::new(DVec2::new(x, y), DVec2::new(x + width, y + height))
    }

    #[test]
    fn the_first_solid_in_the_way_ends_it() {
        let source = area(10.0, 10.0, 2.0, 2.0);
        let solids = [area(11.5, 2.0, 5.0, 1.0), area(0.0, 4.0, 10.5, 1.0), area(12.0, 6.0, 3.0, 3.0), area(16.0, 11.0, 1.0, 9.0)];
        for (zone, ends) in [
            (area(10.0, 0.0, 2.0, 10.0), area(10.0, 5.0, 2.0, 5.0)),
            (area(12.0, 10.0, 9.0, 2.0), area(12.0, 10.0, 4.0, 2.0)),
            (area(10.0, 12.0, 2.0, 5.0), area(10.0, 12.0, 2.0, 5.0)),
        ] {
            let stream = AirStream { source, zone, force: DVec2::X, name: None };
            assert_eq!(shaded(&stream, solids.into_iter()), Some(ends));
        }
        let stream = AirStream { source, zone: area(10.0, 0.0, 2.0, 10.0), force: DVec2::X, name: None };
        assert_eq!(shaded(&stream, [area(9.0, 8.0, 4.0, 2.0)].into_iter()), None);
    }
}
