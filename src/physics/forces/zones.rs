//! Zones that push what touches them: whether a body is in one, what it feels there, and when it crosses the border.

use crate::physics::data::aabb::Aabb;
use crate::physics::data::body::{Body, Pose};
use crate::physics::data::def::{FieldDef, StreamDef};
use crate::physics::data::impact_time::{Cubic, earliest};
use crate::physics::data::tuning::SLOP;
use crate::physics::forces::kind::{ForceKind, Source};
use crate::physics::forces::manager::ForceManager;
use crate::physics::forces::media::Media;
use crate::physics::forces::zone_list::ZoneList;
use glam::DVec2;

/// A zone that pushes whatever touches it: an air stream, or a field of gravity.
#[derive(Clone, Debug)]
pub(crate) struct Stream {
    pub zone: Aabb,
    /// N, on all alike.
    force: DVec2,
    /// N/kg.
    strength: DVec2,
    /// Whether it does so now.
    pub blows: bool,
    pub kind: ForceKind,
    pub source: Source,
}

impl Stream {
    pub fn of_stream((index, def): (u32, &StreamDef)) -> Self {
        let (zone, force) = (def.zone, def.force);
        Self { zone, force, strength: DVec2::ZERO, blows: true, kind: ForceKind::Wind, source: Source::Stream(index) }
    }

    pub fn of_field((index, def): (u32, &FieldDef)) -> Self {
        let (zone, strength) = (def.zone, def.strength);
        Self { zone, force: DVec2::ZERO, strength, blows: true, kind: ForceKind::Weight, source: Source::Field(index) }
    }

    /// The force on a body that touches it, N.
    pub fn on(&self, body: &Body) -> DVec2 {
        match (self.blows, self.kind) {
            (false, _) => DVec2::ZERO,
            (true, ForceKind::Weight) if body.weightless => DVec2::ZERO,
            (true, ForceKind::Weight) => self.strength * body.mass,
            (true, _) => self.force,
        }
    }
}

/// Relative: what rounding leaves of weight and a force that holds it, which is no force.
const HELD: f64 = 4.0 * f64::EPSILON;

/// The acceleration along y by gravity and by a force per mass, m/s²: exactly none where they balance but for rounding.
pub(crate) fn fall(gravity: f64, force: f64) -> f64 {
    let sum = gravity + force;
    if sum.abs() <= HELD * gravity.abs() { 0.0 } else { sum }
}

/// m. What is so near to a stream is counted to what touches it.
pub(crate) const BESIDE: f64 = 2.0 * SLOP;
/// m. So far from a border it is clear on which side something is.
const CLEAR: f64 = 2.0 * SLOP;
/// m. So far from a border whatever a way sweeps may be off by its rounding.
const FAR: f64 = 1e-6;

/// Whether a body in a pose feels a stream that blows in a zone: touching suffices, but what leaves it has left it. So what a tick finds does
/// not depend on how the time of a crossing was rounded.
pub(crate) fn feels(zone: &Aabb, body: &Body, (position, velocity): Pose) -> bool {
    let apart = position - zone.centre();
    let gap = apart.abs() - body.half - zone.size() * 0.5;
    (0..2).all(|axis| gap[axis] < -SLOP || (gap[axis] <= SLOP && velocity[axis] * apart[axis].signum() <= 0.0))
}

/// The streams around a body: those that touch a box in which it is likely to stay for some ticks, and maybe some near it. Zones never move, so
/// this holds until it leaves the box; and no answer depends on how large that is.
#[derive(Clone, Debug)]
pub(crate) struct Around {
    within: Aabb,
    streams: ZoneList,
}

impl Around {
    /// What lies around a body of which nothing is known.
    pub fn unknown() -> Self {
        Self { within: Aabb::new(DVec2::INFINITY, DVec2::NEG_INFINITY), streams: ZoneList::default() }
    }

    /// What touches a box.
    pub fn of(media: &Media, within: Aabb) -> Self {
        Self { within, streams: media.streams_at(&within, BESIDE) }
    }

    /// Whether this says what a box touches.
    pub fn knows(&self, near: &Aabb) -> bool {
        self.within.contains(near, 0.0)
    }

    /// What [`Media::streams_at`] finds.
    pub fn streams_at(&self, media: &Media, near: &Aabb) -> ZoneList {
        if !self.knows(near) {
            return media.streams_at(near, BESIDE);
        }
        let touches = |stream: &u32| near.touches(&media.streams[*stream as usize].zone, BESIDE);
        ZoneList::of(self.streams.iter().filter(touches))
    }

    /// The streams, in ascending order.
    pub fn streams<'a>(&self, media: &'a Media) -> impl Iterator<Item = &'a Stream> {
        self.streams.iter().map(|stream| &media.streams[stream as usize])
    }

    /// Whether a body that ends the tick in a pose crosses the border of one of them.
    pub fn crosses(&self, media: &Media, body: &Body, end: Pose, dt: f64) -> bool {
        let start = (body.position, body.velocity);
        let way = Cubic::hermite(start.0, start.1, end.0, end.1, dt);
        let swept = way.swept(body.half, dt);
        self.streams(media).any(|Stream { zone, .. }| {
            let inside = feels(zone, body, start);
            !stays(&swept, body.half, zone, inside) && border(&way, body.half, zone, inside, dt).is_some()
        })
    }

    /// The force of all streams and fields that a body feels besides a `push`, N.
    pub fn force_on(&self, media: &Media, body: &Body, push: DVec2) -> DVec2 {
        if self.knows(&body.bounds()) {
            return force_of(self.streams(media), body, push);
        }
        let near = media.streams_at(&body.bounds(), BESIDE);
        force_of(near.iter().map(|stream| &media.streams[stream as usize]), body, push)
    }
}

/// Lets the streams and fields that a body feels enter its force manager, and the others leave it.
pub(crate) fn feel(media: &Media, around: Option<&Around>, body: &Body, forces: &mut ForceManager) {
    let pose = (body.position, body.velocity);
    let near = around.map_or_else(|| media.streams_at(&body.bounds(), BESIDE), |around| around.streams_at(media, &body.bounds()));
    forces.leave_zones(|source| near.iter().any(|stream| media.streams[stream as usize].source == source));
    for stream in near.iter().map(|stream| &media.streams[stream as usize]) {
        let push = if feels(&stream.zone, body, pose) { stream.on(body) } else { DVec2::ZERO };
        forces.add(stream.source, stream.kind, push);
    }
}

fn force_of<'a>(streams: impl Iterator<Item = &'a Stream>, body: &Body, push: DVec2) -> DVec2 {
    let pose = (body.position, body.velocity);
    streams.filter(|stream| feels(&stream.zone, body, pose)).fold(push, |force, stream| force + stream.on(body))
}

/// Whether what sweeps no more than that on its way is sure to stay on its side of the border of a zone: `inside`, or out of it.
pub(crate) fn stays(swept: &Aabb, half: DVec2, zone: &Aabb, inside: bool) -> bool {
    if inside {
        let reaches = |axis: usize| {
            swept.min[axis] + 2.0 * half[axis] > zone.min[axis] + FAR && swept.max[axis] - 2.0 * half[axis] < zone.max[axis] - FAR
        };
        reaches(0) && reaches(1)
    } else {
        !swept.touches(zone, FAR)
    }
}

/// When a body on a way enters a zone or, from `inside`, leaves it. What begins at the border itself has crossed it once it is clear of it.
pub(crate) fn border(way: &Cubic, half: DVec2, zone: &Aabb, inside: bool, end: f64) -> Option<f64> {
    let reach = half + zone.size() * 0.5;
    let motion = Cubic::parabola(zone.centre(), DVec2::ZERO, DVec2::ZERO).relative(way);
    let mut first: Option<f64> = None;
    for axis in 0..2 {
        let (path, other, level) = (motion.axis(axis).until(end), motion.axis(1 - axis), reach[axis]);
        // Of the side at which it begins, if it begins at the border.
        let begin = motion.c[0][axis];
        let clear = |side: f64| if (side * begin - level).abs() <= SLOP { CLEAR } else { 0.0 };
        let (above, below) = (clear(1.0), clear(-1.0));
        let t = if inside {
            earliest(path.rises_through(level + above, 0.0), path.falls_through(-level - below, 0.0))
        } else {
            earliest(path.falls_through(level - above, 0.0), path.rises_through(below - level, 0.0))
                .filter(|&t| other.at(t).abs() <= reach[1 - axis])
        };
        first = earliest(first, t.filter(|&t| t < end));
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::DVec2;
    use crate::physics::data::body::BodyDef;

    #[test]
    fn touching_counts_and_leaving_does_not() {
        let zone = Aabb::new(DVec2::ZERO, DVec2::ONE);
        let body = Body::new(&BodyDef::default());
        let feels = |x: f64, v: f64| feels(&zone, &body, (DVec2::new(x, 0.5), DVec2::new(v, 0.0)));
        assert!(feels(1.4, 3.0) && feels(1.5, 0.0) && feels(1.5, -2.0));
        assert!(!feels(1.5, 2.0) && !feels(1.6, -2.0));
    }

    /// Regression: a body at rest beside a fan, with its edge on the border, drove away and kept the wind for a tick.
    #[test]
    fn what_begins_at_a_border_crosses_it() {
        let (zone, half) = (Aabb::new(DVec2::ZERO, DVec2::ONE), DVec2::splat(0.5));
        let way = |a: f64| Cubic::parabola(DVec2::new(1.5, 0.5), DVec2::ZERO, DVec2::new(a, 0.0));
        assert!(border(&way(3.0), half, &zone, true, 0.01).is_some_and(|t| t < 1e-4));
        assert!(border(&way(-3.0), half, &zone, false, 0.01).is_some_and(|t| t < 1e-4));
        assert_eq!(border(&way(-3.0), half, &zone, true, 0.01), None);
        assert_eq!(border(&way(3.0), half, &zone, false, 0.01), None);
    }
}
