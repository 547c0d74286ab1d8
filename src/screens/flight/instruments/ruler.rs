//! A ruler laid in the level by mouse, from point to point; each end can be moved later. An end on a body goes with it: in the middle of its
//! lower edge, from which heights and depths count. Between two bodies the ruler goes from centre to centre.

use super::super::Input;
use crate::draw::layout::Vec2;
use crate::physics::{BodyId, DVec2, World};

/// The range in which a click takes an end, or an end snaps to a body, canvas units.
const NEAR: f64 = 14.0;
/// A shorter drag is a click for the flight, canvas units.
const STARTS: f32 = 5.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// m.
    Place(DVec2),
    Body(BodyId),
}

/// y upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RulerReading {
    /// From end to end, m.
    pub length: f64,
    /// Its parts to the right and upwards, m.
    pub parts: DVec2,
    /// From the right, anticlockwise, degrees from −180 to 180.
    pub angle: f64,
}

#[derive(Clone, Debug, Default)]
pub struct Ruler {
    ends: Option<[End; 2]>,
    hold: Option<Hold>,
}

#[derive(Clone, Copy, Debug)]
struct Hold {
    end: usize,
    from: Vec2,
    moved: bool,
    before: Option<[End; 2]>,
}

/// The owner of a frame's click.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Click {
    /// The ruler leaves it.
    Others,
    Rulers,
    /// The ruler took it and moved nothing, so others may have it now.
    GivenBack,
}

impl Ruler {
    /// One frame, at `metre` canvas units a metre; `free` where nothing covers the level under the pointer.
    pub fn update(&mut self, input: &Input, world: &World, metre: f64, free: bool) -> Click {
        let near = NEAR / metre;
        if let Some(mut hold) = self.hold {
            if !input.holding {
                self.hold = None;
                if hold.moved {
                    return Click::Others;
                }
                self.ends = hold.before;
                return Click::GivenBack;
            }
            hold.moved |= (input.pointer - hold.from).length() > STARTS;
            self.hold = Some(hold);
            if let (true, Some(place), Some(ends)) = (hold.moved, input.place, &mut self.ends) {
                ends[hold.end] = end_at(place, world, near);
            }
            return Click::Others;
        }
        let Some(place) = input.place.filter(|_| input.click && free) else { return Click::Others };
        let before = self.ends;
        let taken = before.and_then(|ends| {
            let points = points(ends, world, |body| world.body(body).position);
            (0..2).find(|end| points[*end].distance(place) <= near)
        });
        if taken.is_none() {
            self.ends = Some([end_at(place, world, near); 2]);
        }
        self.hold = Some(Hold { end: taken.unwrap_or(1), from: input.pointer, moved: false, before });
        Click::Rulers
    }

    /// `None` before the player lays it.
    pub fn ends(&self) -> Option<[End; 2]> {
        self.ends.filter(|ends| ends[0] != ends[1])
    }

    pub fn reading(&self, world: &World) -> Option<RulerReading> {
        let [from, to] = points(self.ends()?, world, |body| world.body(body).position);
        Some(RulerReading::of(from, to))
    }
}

impl End {
    pub const fn is_body(&self) -> bool {
        matches!(self, Self::Body(_))
    }
}

/// Where the ends are, m, with the bodies' centres.
pub fn points(ends: [End; 2], world: &World, centre: impl Fn(BodyId) -> DVec2) -> [DVec2; 2] {
    let between_bodies = ends.iter().all(End::is_body);
    ends.map(|end| match end {
        End::Place(place) => place,
        End::Body(body) if between_bodies => centre(body),
        End::Body(body) => centre(body) + DVec2::new(0.0, world.body(body).half.y),
    })
}

impl RulerReading {
    fn of(from: DVec2, to: DVec2) -> Self {
        let parts = DVec2::new(to.x - from.x, from.y - to.y);
        Self { length: parts.length(), parts, angle: parts.y.atan2(parts.x).to_degrees() }
    }
}

/// An end at a place: on the body whose line from its centre down to its lower edge is nearest, and near.
fn end_at(place: DVec2, world: &World, near: f64) -> End {
    let bodies = (0..).map(BodyId).zip(world.bodies()).map(|(id, body)| {
        let down = (place.y - body.position.y).clamp(0.0, body.half.y);
        (id, (body.position + DVec2::new(0.0, down)).distance(place))
    });
    let nearest = bodies.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, distance)| *distance <= near);
    nearest.map_or(End::Place(place), |(id, _)| End::Body(id))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_reads_upwards_and_anticlockwise() {
        let reading = RulerReading::of(DVec2::new(10.0, 20.0), DVec2::new(13.0, 16.0));
        assert_eq!((reading.length, reading.parts), (5.0, DVec2::new(3.0, 4.0)));
        assert!((reading.angle - 53.130_102_354_155_98).abs() < 1e-12);
        assert!((RulerReading::of(DVec2::ZERO, DVec2::new(0.0, 2.0)).angle + 90.0).abs() < 1e-12);
    }
}
