//! The bodies of one island, bottom-up, and after the last body the surfaces that they may meet. Here y grows along gravity.
//!
//! A step gathers them from the world's state, works on them alone, and leaves their ends in them: neighbours in a pile are neighbours in memory.

use crate::physics::data::{Aabb, Body, Coefficients, Sides, Surface};
use crate::physics::store::{Island, MARGIN, Motions, SurfaceMotion};
use crate::physics::{crowd::ACROSS, forces::air::Drag};
use glam::DVec2;
use std::ops::{Index, IndexMut};

#[derive(Clone, Copy, Debug)]
pub(crate) struct Origin<'a> {
    pub bodies: &'a [Body],
    pub surfaces: &'a [Surface],
    pub motions: &'a Motions,
    pub frame: Frame,
    pub bounces: bool,
}

/// An island in its own numbers: bodies bottom-up from 0, then its surfaces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Group<'a> {
    pub island: Island<'a>,
    /// The own number of each body and surface of the world that is in the island.
    pub local: &'a [u32],
}

impl<'a> Group<'a> {
    #[inline(always)]
    pub fn near(&self, i: usize) -> impl Iterator<Item = usize> + use<'a> {
        let local = self.local;
        self.island.near(self.island.members[i]).iter().map(|j| local[*j as usize] as usize)
    }
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Member {
    /// Its centre at the start, and at the end: first predicted, then final, m.
    pub from: DVec2,
    pub to: DVec2,
    pub half: DVec2,
    /// Its velocity at the start, of a surface its mean velocity, m/s.
    pub before: DVec2,
    /// The same; but of a surface its velocity when the step before ended.
    pub was: DVec2,
    /// Its velocity at the end if it touched nothing, and as the solver leaves it, m/s.
    pub free: DVec2,
    pub end: DVec2,
    /// Its mean velocity over the step, m/s: the way divided by the step.
    pub mean: DVec2,
    pub flown: DVec2,
    /// Acceleration by gravity and by what is set from outside, m/s².
    pub pull: DVec2,
    /// kg; infinite of a surface.
    pub mass: f64,
    pub traits: Coefficients,
    /// The speed of a belt's upper side, m/s; 0 of a body.
    pub belt: f64,
    pub swept: Aabb,
    /// Of a body whose flight no constant force describes: how its velocity changes on it, m/s.
    pub guided: Option<DVec2>,
    pub drag: Drag,
    pub sides: Sides,
    /// Whether it is a body that the step takes for ground.
    pub settled: bool,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Bodies {
    pub things: Vec<Member>,
    /// The numbers of bodies, and of surfaces behind all bodies, in the world.
    pub ids: Vec<u32>,
    count: usize,
    /// Whether anything bounces, and whether all bodies have the same friction.
    pub bounces: bool,
    pub alike: bool,
    pub airy: bool,
    /// The number of bodies of the whole island, and the largest coordinate that settled ones sweep, m.
    pub whole: usize,
    pub settled_largest: f64,
}

impl Index<usize> for Bodies {
    type Output = Member;

    #[inline(always)]
    fn index(&self, i: usize) -> &Member {
        &self.things[i]
    }
}

impl IndexMut<usize> for Bodies {
    #[inline(always)]
    fn index_mut(&mut self, i: usize) -> &mut Member {
        &mut self.things[i]
    }
}

impl Bodies {
    pub fn new(all: usize) -> Self {
        Self { things: Vec::with_capacity(all), ids: Vec::with_capacity(8 * all), ..Self::default() }
    }

    pub fn clear(&mut self) {
        self.ids.clear();
        self.things.clear();
        self.count = 0;
    }

    /// Gathers a part of an island, settled members near it behind the bodies, with the surfaces. `whole`: see the last two fields.
    pub fn gather(&mut self, from: Origin<'_>, island: Island<'_>, whole: (usize, f64), is_settled: impl Fn(u32) -> bool) {
        let (n, all) = (island.members.len(), from.motions.len());
        self.ids.clear();
        self.ids.extend_from_slice(island.members);
        for i in island.members {
            for j in island.near(*i) {
                if *j as usize >= all || is_settled(*j) {
                    self.ids.push(*j);
                }
            }
        }
        self.ids[n..].sort_unstable();
        self.ids.dedup();
        (self.count, self.bounces, self.airy) = (n, from.bounces, from.motions.airy);
        (self.whole, self.settled_largest) = whole;
        self.things.clear();
        self.things.extend(self.ids[..n].iter().map(|i| Member::body(from, *i as usize)));
        self.things.extend(self.ids[n..].iter().map(|i| match (*i as usize).checked_sub(all) {
            Some(surface) => Member::surface(from, surface),
            None => Member { mass: f64::INFINITY, settled: true, ..Member::body(from, *i as usize) },
        }));
        if !from.bounces {
            self.things.iter_mut().for_each(|thing| thing.traits.restitution = 0.0);
        }
        self.alike = self.all().iter().all(|body| body.traits.rubs_like(&self.things[0].traits));
    }

    pub fn swept(&self, k: usize, frame: Frame) -> Aabb {
        frame.turn_box(self[k].swept)
    }

    /// The number of bodies; surfaces count on from here.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether it is a body of the world, settled or not.
    #[inline(always)]
    pub fn is_body(&self, k: usize) -> bool {
        k < self.count || self.things[k].settled
    }

    /// Whether a surface holds less than the bodies, if these are alike.
    pub fn is_slippery(&self, j: usize) -> bool {
        let first = self[0].traits;
        !self.is_body(j) && self[j].traits.static_friction < first.static_friction.max(first.kinetic_friction)
    }

    pub fn all(&self) -> &[Member] {
        &self.things[..self.count]
    }

    /// Whether nothing but the air slows the flight of a body, and it does.
    pub fn meets_air(&self, i: usize) -> bool {
        self.airy && !self[i].drag.is_none() && self[i].guided.is_none()
    }

    #[inline(always)]
    pub fn coefficients(&self, i: usize, j: usize) -> Coefficients {
        self[i].traits.with(self[j].traits, !self.is_body(j))
    }

    /// The velocity of a belt, besides that of its surface, on the side towards larger or smaller coordinates, m/s; 0 of a body.
    pub fn belt_velocity(&self, j: usize, axis: usize, larger: bool) -> f64 {
        if (axis == ACROSS) == larger { self[j].belt } else { -self[j].belt }
    }

    /// Whether body i had the velocity along an axis that the belt of `j` has, or, of a surface, had in the step before: it rides on it.
    #[inline(always)]
    pub fn rides(&self, i: usize, j: usize, axis: usize, belt_velocity: f64) -> bool {
        let (mine, its) = (self[i].before[axis], &self[j]);
        mine == its.before[axis] + belt_velocity || mine == its.was[axis] + belt_velocity
    }

    pub fn moves(&self, j: usize) -> bool {
        self[j].before != DVec2::ZERO
    }

    pub fn carries(&self, j: usize) -> bool {
        self.moves(j) || self[j].was != DVec2::ZERO || self[j].belt != 0.0
    }

    /// Whether the predicted box of a body lies within what was swept when contacts were sought.
    #[inline(always)]
    pub fn is_swept(&self, i: usize) -> bool {
        let Member { to, half, swept, .. } = &self[i];
        swept.contains(&Aabb::around(*to, *half), 0.0)
    }

    pub fn widen(&mut self, i: usize) {
        let s = &mut self[i];
        s.swept = s.swept.union(&Aabb::around(s.to, s.half + MARGIN));
    }

    pub fn fall_freely(&mut self) {
        self.things.iter_mut().filter(|thing| thing.mass.is_finite() || thing.settled).for_each(|body| body.to = body.flown);
    }
}

impl Member {
    #[inline(always)]
    fn body(source: Origin<'_>, i: usize) -> Self {
        let Origin { bodies, motions, frame, .. } = source;
        let (body, motion) = (&bodies[i], &motions.bodies[i]);
        let (before, flown) = (frame.turn(body.velocity), frame.turn(motion.free.0));
        Self {
            from: frame.turn(body.position),
            to: flown,
            half: frame.turn(body.half).abs(),
            before,
            was: before,
            free: frame.turn(motion.free.1),
            flown,
            pull: frame.turn(motion.pull),
            mass: body.mass,
            traits: body.coefficients(),
            swept: frame.turn_box(motions.swept[i]),
            guided: motion.guided.then(|| frame.turn(motion.free.1) - before),
            drag: frame.turn_drag(motions.drags[i]),
            ..Self::default()
        }
    }

    fn surface(source: Origin<'_>, s: usize) -> Self {
        let Origin { surfaces, motions, frame, .. } = source;
        let SurfaceMotion { from, to, half, mean, end, was, belt, .. } = motions.surfaces[s];
        let (mean, end) = (frame.turn(mean), frame.turn(end));
        Self {
            from: frame.turn(from),
            to: frame.turn(to),
            half: frame.turn(half).abs(),
            before: mean,
            was: frame.turn(was),
            free: end,
            end,
            mean,
            mass: f64::INFINITY,
            traits: surfaces[s].material.coefficients(),
            belt: belt * frame.hand(),
            sides: frame.turn_sides(surfaces[s].def.sides),
            ..Self::default()
        }
    }
}

/// How an island is turned so that what pulls at it points to larger y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    /// Whether it is pulled along x, so that the axes change places.
    pub swapped: bool,
    /// −1 if it is pulled to smaller coordinates, else 1.
    pub down: f64,
}

impl Frame {
    /// The larger component of the pull points down.
    pub fn of(pull: DVec2) -> Self {
        let swapped = pull.x.abs() > pull.y.abs();
        Self { swapped, down: if pull[usize::from(!swapped)] < 0.0 { -1.0 } else { 1.0 } }
    }

    pub fn axis(self, axis: usize) -> usize {
        if self.swapped { 1 - axis } else { axis }
    }

    /// Into the frame, and out of it again.
    pub fn turn(self, of: DVec2) -> DVec2 {
        if self.swapped { DVec2::new(of.y, of.x) * self.down } else { DVec2::new(of.x, of.y * self.down) }
    }

    /// −1 where what turns clockwise turns the other way in it.
    fn hand(self) -> f64 {
        if self.swapped { -1.0 } else { self.down }
    }

    fn turn_box(self, of: Aabb) -> Aabb {
        let (a, b) = (self.turn(of.min), self.turn(of.max));
        Aabb::new(a.min(b), a.max(b))
    }

    fn turn_drag(self, of: Drag) -> Drag {
        if self.swapped { Drag { tall: of.wide, wide: of.tall, ..of } } else { of }
    }

    fn turn_sides(self, of: Sides) -> Sides {
        let Sides { left, right, top, bottom } = of;
        match (self.swapped, self.down < 0.0) {
            (false, false) => of,
            (false, true) => Sides { top: bottom, bottom: top, ..of },
            (true, false) => Sides { left: top, right: bottom, top: left, bottom: right },
            (true, true) => Sides { left: bottom, right: top, top: right, bottom: left },
        }
    }
}
