//! Items: the bodies of an island and the surfaces near them, each on a path of its own; and that path as the search for impacts needs it.

use crate::physics::data::{Aabb, Body, BodyDef, Cubic, Pose, Quintic, STRAY, Sides, Surface, on_axis, parabola};
use crate::physics::{exact::train::Train, flight::liquid::flow, flight::liquid::flow_while, forces::Law, forces::Media};
use glam::DVec2;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Travel {
    #[default]
    Still,
    Parabola,
    Flow,
    /// Over one surface, through media.
    Slide,
    /// In contact, through media: on its `course`.
    Coupled,
    Train,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Slide {
    pub axis: usize,
    /// On which side of the surface the body is: 1 or −1.
    pub away: f64,
    /// μ_k with the sign of the slide: the part of the normal force that acts against it.
    pub friction: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EventKind {
    /// Nothing before the end of the tick.
    Nothing,
    /// It meets another item along an axis; `ascending` if that has the larger coordinate.
    Hit { other: u32, axis: usize, ascending: bool },
    /// Its slide over another item ends.
    Stop { other: u32 },
    /// Its contact with another item ends, because they no longer face each other.
    Edge { other: u32 },
    /// Its contact with another item begins: both are flush, and face each other from now on. Or one comes near the train of the other.
    Begin { other: u32 },
    /// It crosses the border of a stream.
    Border,
    /// Its path is foreseen up to here.
    Renew,
}

impl EventKind {
    pub fn other(self) -> Option<u32> {
        match self {
            Self::Hit { other, .. } | Self::Stop { other } | Self::Edge { other } | Self::Begin { other } => Some(other),
            Self::Nothing | Self::Border | Self::Renew => None,
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Next {
    /// s, from the tick's start.
    pub at: f64,
    pub kind: EventKind,
    /// The number of the path of the other item on which it was foreseen.
    pub foreseen_on: u32,
}

impl Next {
    pub const NEVER: Self = Self { at: f64::INFINITY, kind: EventKind::Nothing, foreseen_on: 0 };

    pub fn or_earlier(&mut self, at: f64, kind: EventKind) {
        if at < self.at {
            *self = Self { at, kind, foreseen_on: 0 };
        }
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Item {
    /// The body's or the surface's number in the world, and which of the two it is.
    pub id: u32,
    pub surface: bool,
    /// As it was at `since`; of a surface only place, half and velocity count.
    pub body: Body,
    /// The force of its engine, N.
    pub drive: DVec2,
    /// Whether links act on it, and their force at `since`, N.
    pub linked: bool,
    pub link: DVec2,
    /// s, from the tick's start.
    pub since: f64,
    /// Its motion is foreseen up to here, s from the tick's start.
    pub until: f64,
    pub law: Law,
    pub motion: Travel,
    /// Acceleration with all contacts at `since`, m/s².
    pub solved: DVec2,
    /// Of its parabola, m/s²: where media act on what is in contact, the mean one.
    pub mean: DVec2,
    pub slide: Option<Slide>,
    pub course: Quintic,
    /// The end of its flow, slide or course, with `since` and `until` as they were then.
    pub end: Option<(f64, f64, Pose)>,
    pub searched: Aabb,
    pub train: Option<Train>,
    /// How often it was hit since a time, s from the tick's start.
    pub hits: (u32, f64),
    /// How often in this tick it was taken to stay where it parted by a rounding.
    pub clung: u32,
    /// Borders of streams that it crossed back in this tick, soon after another event, and its velocity at the last border, m/s.
    pub crossed: (u32, DVec2),
    /// Whether contacts and accelerations are those of the tick's start, and later those of its end.
    pub known: bool,
    pub disturbed: bool,
    /// Of a surface: from which sides it is solid, and the speed of its belt.
    pub sides: Sides,
    pub belt: f64,
    /// Of a surface: when what it would squeeze stops it, s from the tick's start; infinite where nothing does.
    pub stops_at: f64,
}

impl Item {
    #[inline(always)]
    pub fn body(id: u32, body: &Body, drive: DVec2, searched: Aabb, known: bool) -> Self {
        let (body, a) = (body.clone(), body.acceleration);
        Self { id, body, drive, solved: a, mean: a, searched, known, stops_at: f64::INFINITY, ..Self::default() }
    }

    /// A surface; [`crate::physics::exact::Scene::set_on_path`] sets its motion.
    pub fn surface(id: u32, surface: &Surface) -> Self {
        let (bounds, material) = (&surface.bounds, surface.material);
        let (position, half) = (bounds.centre(), bounds.size() * 0.5);
        let stand_in = Body::new(&BodyDef { position, half, material, ..BodyDef::default() });
        let (sides, belt) = (surface.def.sides, surface.belt);
        Self { surface: true, sides, belt, ..Self::body(id, &stand_in, DVec2::ZERO, *bounds, true) }
    }

    pub fn is_still(&self) -> bool {
        self.motion == Travel::Still
    }

    /// Where it is at a time (s from the tick's start, not before `since`).
    pub fn pose(&self, media: &Media, at: f64) -> Pose {
        let (t, start) = (at - self.since, (self.body.position, self.body.velocity));
        let end = || self.end.filter(|end| (end.0, end.1) == (self.since, at));
        match self.motion {
            _ if t == 0.0 => start,
            Travel::Still => start,
            Travel::Parabola => parabola(start, self.mean, t),
            Travel::Coupled => self.course.pose(at),
            Travel::Flow | Travel::Slide if end().is_some() => end().map_or(start, |(.., end)| end),
            Travel::Flow => flow(media, &self.body, &self.law, t),
            Travel::Slide => self.slide_on(media, t),
            Travel::Train => self.train.map_or(start, |train| train.pose(start, t, at)),
        }
    }

    fn slide_on(&self, media: &Media, t: f64) -> Pose {
        let mut pose = (self.body.position, self.body.velocity);
        let Some(slide) = self.slide else { return parabola(pose, self.mean, t) };
        let reach = media.rate(&self.body, &self.law, pose, t) * t;
        // Rate × time of 0.02 a step leaves 1e-9 m after some metres. A path that is foreseen at once takes 25 steps.
        let steps = (reach / 0.02).ceil().clamp(1.0, 64.0);
        let mut regime = self.law.is_near_liquid().then(|| self.law.regime(media, &self.body, pose.0));
        let mut pull = |x: DVec2, v: DVec2| {
            let free = match &mut regime {
                Some(regime) => regime.follow(x).acceleration(x, v),
                None => media.acceleration(&self.body, &self.law, x, v),
            };
            let normal = (-slide.away * free[slide.axis]).max(0.0);
            on_axis(slide.axis, 0.0, free[1 - slide.axis] - slide.friction * normal)
        };
        for _ in 0..steps as u32 {
            pose = rk4(pose, t / steps, &mut pull);
        }
        // Across the face it moves evenly: far from the origin the steps would lead it away by their roundings.
        pose.0[slide.axis] = self.body.position[slide.axis] + self.body.velocity[slide.axis] * t;
        pose
    }

    /// Foresees the path, from `since` to `until`, or to where one cubic follows it.
    pub(crate) fn foresee(&mut self, media: &Media) -> Cubic {
        let (x, v, t) = (self.body.position, self.body.velocity, self.until - self.since);
        self.end = None;
        match self.motion {
            Travel::Still | Travel::Train => Cubic::parabola(x, DVec2::ZERO, DVec2::ZERO),
            Travel::Flow if t > 0.0 => self.foresee_flow(media),
            Travel::Slide | Travel::Coupled if t > 0.0 => {
                let end = self.pose(media, self.until);
                self.end = Some((self.since, self.until, end));
                Cubic::hermite(x, v, end.0, end.1, t)
            }
            Travel::Parabola | Travel::Flow | Travel::Slide | Travel::Coupled => Cubic::parabola(x, v, self.mean),
        }
    }

    /// A cubic that is exact at its start, at its end, and within [`STRAY`] at the end of each step of a flow through liquids.
    fn foresee_flow(&mut self, media: &Media) -> Cubic {
        let (x, v) = (self.body.position, self.body.velocity);
        let a = media.acceleration(&self.body, &self.law, x, v);
        let to = |t: f64, end: DVec2| Cubic { c: [x, v, a * 0.5, (end - x - (v + a * (0.5 * t)) * t) / (t * t * t)] };
        loop {
            let (mut passed, mut count, mut fits) = ([(0.0, DVec2::ZERO); 16], 0, true);
            let course = flow_while(media, &self.body, &self.law, self.until - self.since, |t, (place, speed)| {
                let way = to(t, place);
                // A cubic is beside a quartic with the same start and end place by 27/256 of the time and the difference of their last speeds.
                let beside = (way.from(t).c[1] - speed).abs().max_element() * t * (27.0 / 256.0);
                let strays = |(at, place): &(f64, DVec2)| way.from(*at).c[0].distance(*place) > STRAY;
                let follows = beside <= STRAY && !passed[..count].iter().any(strays);
                fits &= follows || count > 0;
                if follows {
                    passed[count] = (t, place);
                    count += 1;
                }
                follows && count < passed.len()
            });
            self.until = self.since + course.time;
            self.law.first = course.next;
            if fits || course.time <= 1e-9 {
                self.end = Some((self.since, self.until, course.end));
                return to(course.time, course.end.0);
            }
            self.until = self.since + 0.5 * course.time;
        }
    }
}

/// The path of an item from `since` to `until`, s from the tick's start: a cubic and the box that it sweeps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Track {
    pub since: f64,
    pub until: f64,
    pub motion: Travel,
    pub half: DVec2,
    pub way: Cubic,
    /// m.
    pub swept: Aabb,
    /// Bounds of the rounding of its places, m.
    pub rounding: DVec2,
}

impl Track {
    pub fn new(item: &Item, way: Cubic) -> Self {
        let Item { since, until, motion, .. } = *item;
        let (half, t) = (item.body.half, until - since);
        let free = || if way.stands() { Aabb::around(way.c[0], half) } else { way.swept(half, t) };
        let swept = item.train.as_ref().map_or_else(free, |train| train.way);
        // Places on a path are off by less than 64 roundings of the largest coordinate and 1e-6 m.
        let rounding = swept.min.abs().max(swept.max.abs()) * (64.0 * f64::EPSILON) + 1e-6;
        Self { since, until, motion, half, way, swept, rounding }
    }

    pub fn lane(&self, covers: &Aabb) -> Aabb {
        Aabb::new(covers.min - self.rounding, covers.max + self.rounding)
    }

    pub fn is_still(&self) -> bool {
        self.motion == Travel::Still
    }

    /// Whether its cubic is its motion.
    pub fn is_exact(&self) -> bool {
        matches!(self.motion, Travel::Still | Travel::Parabola)
    }

    pub fn way_from(&self, at: f64) -> Cubic {
        self.way.from(at - self.since)
    }

    pub fn bounds_at(&self, at: f64) -> Aabb {
        Aabb::around(self.way_from(at).c[0], self.half + self.rounding)
    }
}

fn rk4((x, v): Pose, h: f64, mut acceleration: impl FnMut(DVec2, DVec2) -> DVec2) -> Pose {
    let half = 0.5 * h;
    let a1 = acceleration(x, v);
    let v2 = v + a1 * half;
    let a2 = acceleration(x + v * half, v2);
    let v3 = v + a2 * half;
    let a3 = acceleration(x + v2 * half, v3);
    let v4 = v + a3 * h;
    let a4 = acceleration(x + v3 * h, v4);
    let sixth = h / 6.0;
    (x + (v + 2.0 * (v2 + v3) + v4) * sixth, v + (a1 + 2.0 * (a2 + a3) + a4) * sixth)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What moves on a parabola or a cubic stays in its lane.
    #[test]
    fn a_way_lies_within_what_it_sweeps() {
        let (half, t) = (DVec2::new(0.5, 0.25), 0.7);
        let way = Cubic { c: [DVec2::ZERO, DVec2::new(3.0, -4.0), DVec2::new(-5.0, 6.0), DVec2::new(1.0, 0.5)] };
        let lane = way.swept(half, t);
        for part in 0..=20 {
            let place = way.from(t * f64::from(part) / 20.0).c[0];
            assert!(lane.contains(&Aabb::around(place, half), 1e-15));
        }
    }
}
