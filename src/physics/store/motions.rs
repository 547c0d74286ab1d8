//! How bodies and surfaces move in the present step: where free flight leads them, where they end, and what they sweep. The bodies themselves
//! are those of the world's state.

use crate::physics::data::{Aabb, Body, Part, Pose, Surface, called, parabola};
use crate::physics::flight::air::fly_through;
use crate::physics::forces::air::Drag;
use crate::physics::forces::media::Media;
use crate::physics::forces::weight::fall;
use crate::physics::store::edges::{Edges, NOWHERE, contains, edges};
use glam::DVec2;

/// How much further than predicted a body may get before its contacts are sought again, m; across, its own way besides. Larger: more contacts
/// to look at; smaller: more islands are solved again because a hit threw a body further.
pub(crate) const MARGIN: f64 = 1e-2;

/// The method that advances a body in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Method {
    /// Free flight, or rest.
    #[default]
    Flight,
    /// Flight together with the bodies that links join to it.
    Linked,
    /// From event to event.
    Events,
    /// The crowd step.
    Crowd,
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Motion {
    /// Acceleration by gravity and constant forces, m/s².
    pub pull: DVec2,
    /// The end of the step if the body touches nothing, and the end that the islands found.
    pub free: Pose,
    pub end: Pose,
    /// What an island found at the end of the step, m/s²; `known` if that holds, and the contacts with it.
    pub acceleration: DVec2,
    pub known: bool,
    pub method: Method,
    /// A body that names its island, unless it flies or rests by itself: the smallest, in a crowd the lowest.
    pub leader: u32,
    /// How often its island grew in this step, and whether that island is solved again.
    pub growths: u8,
    pub again: bool,
    /// Whether no constant force describes its flight.
    pub guided: bool,
    /// Whether a crowd step listed what its contacts gave.
    pub listed: bool,
    /// How often its island was solved so far: what an earlier solution listed holds no longer.
    pub solved: u32,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfaceMotion {
    /// Its centre at the start and at the end of the step, m, and half its size.
    pub from: DVec2,
    pub to: DVec2,
    pub half: DVec2,
    /// Velocities, m/s: the mean over the step, at its end, and at the end of the step before.
    pub mean: DVec2,
    pub end: DVec2,
    pub was: DVec2,
    /// The speed of its belt, m/s.
    pub belt: f64,
    pub present: bool,
}

impl SurfaceMotion {
    fn of(surface: &Surface) -> Self {
        let (from, half) = (surface.bounds.centre(), surface.bounds.size() * 0.5);
        let (mean, end, was) = (DVec2::ZERO, DVec2::ZERO, DVec2::ZERO);
        Self { from, to: from, half, mean, end, was, belt: surface.belt, present: surface.present }
    }

    /// Lets it stand for the step.
    pub fn stand(&mut self) {
        (self.to, self.mean, self.end) = (self.from, DVec2::ZERO, DVec2::ZERO);
    }

    /// Whether it moves in this step.
    pub fn moves(&self) -> bool {
        self.mean != DVec2::ZERO
    }

    /// Whether it moves, moved in the step before, or runs a belt.
    pub fn carries(&self) -> bool {
        self.moves() || self.was != DVec2::ZERO || self.belt != 0.0
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Motions {
    pub bodies: Vec<Motion>,
    pub surfaces: Vec<SurfaceMotion>,
    /// The pose of each body at the start of the last step.
    pub before: Vec<Pose>,
    /// What each body, and after them each surface, sweeps in this step: an absent surface nothing.
    pub swept: Vec<Edges>,
    /// Drag of the air on each body, and whether any feels it.
    pub drags: Vec<Drag>,
    pub airy: bool,
    /// The ends of flights that no constant force describes, in the next step.
    pub guided: Vec<(u32, Pose)>,
}

impl Motions {
    pub fn new(bodies: &[Body], surfaces: &[Surface], media: &Media) -> Self {
        let drags: Vec<Drag> = bodies.iter().map(|body| media.air(body)).collect();
        let rests = |body: &Body| {
            let pose = (body.position, body.velocity);
            Motion { free: pose, end: pose, ..Motion::default() }
        };
        let mut motions = Self {
            bodies: bodies.iter().map(rests).collect(),
            surfaces: surfaces.iter().map(SurfaceMotion::of).collect(),
            before: bodies.iter().map(|body| (body.position, body.velocity)).collect(),
            swept: vec![NOWHERE; bodies.len() + surfaces.len()],
            airy: drags.iter().any(|drag| !drag.is_none()),
            drags,
            guided: Vec::new(),
        };
        (0..surfaces.len()).for_each(|surface| motions.sweep_surface(surface));
        motions
    }

    /// The number of bodies; surfaces count on from here.
    pub fn len(&self) -> usize {
        self.bodies.len()
    }

    /// Sets the constant force (N) on a body besides weight and drag. Returns whether that changes its acceleration.
    pub fn set_force(&mut self, i: usize, (body, media): (&Body, &Media), force: DVec2) -> bool {
        let pull = DVec2::new(force.x / body.mass, fall(media.gravity_on(body), force.y / body.mass));
        std::mem::replace(&mut self.bodies[i].pull, pull) != pull
    }

    /// Lets these bodies fly freely for `dt` seconds, and finds what they sweep.
    pub fn fly(&mut self, bodies: &[Body], of: &[u32], dt: f64) {
        let Self { bodies: motions, swept, drags, .. } = self;
        for i in of.iter().map(|i| *i as usize) {
            let (body, motion) = (&bodies[i], &mut motions[i]);
            let pose = (body.position, body.velocity);
            motion.free = if self.airy {
                called(Part::Air);
                fly_through(pose, motion.pull, &drags[i], dt)
            } else {
                parabola(pose, motion.pull, dt)
            };
            motion.end = motion.free;
            swept[i] = way(body.position, motion.free.0, body.half);
            (motion.method, motion.known, motion.growths, motion.again, motion.guided) = (Method::Flight, true, 0, false, false);
        }
        for (i, pose) in self.guided.drain(..) {
            let (body, motion) = (&bodies[i as usize], &mut motions[i as usize]);
            (motion.free, motion.end, motion.guided) = (pose, pose, true);
            swept[i as usize] = way(body.position, pose.0, body.half);
        }
    }

    pub fn sweep_surface(&mut self, surface: usize) {
        let of = &self.surfaces[surface];
        self.swept[self.bodies.len() + surface] = if of.present { way(of.from, of.to, of.half) } else { NOWHERE };
    }

    /// Whether a body ends the step within what it was expected to sweep.
    pub fn is_swept(&self, i: usize, half: DVec2) -> bool {
        contains(&self.swept[i], &edges(self.bodies[i].end.0, half))
    }

    /// The body that names the island in which a body was advanced; none if it flew or rested by itself.
    pub fn island_of(&self, i: u32) -> Option<u32> {
        let motion = &self.bodies[i as usize];
        (motion.method != Method::Flight).then_some(motion.leader)
    }

    /// What a body sweeps.
    pub fn area(&self, i: u32) -> Aabb {
        let [left, right, top, bottom] = self.swept[i as usize];
        Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
    }

    /// Widens what a body sweeps by `reach` (m) to all sides.
    pub fn widen(&mut self, i: usize, reach: DVec2) {
        let [left, right, top, bottom] = self.swept[i];
        self.swept[i] = [left - reach.x, right + reach.x, top - reach.y, bottom + reach.y];
    }

    pub fn fall_freely(&mut self, i: usize) {
        self.bodies[i].end = self.bodies[i].free;
    }
}

/// The box from one place of a body to another, and a margin.
fn way(from: DVec2, to: DVec2, half: DVec2) -> Edges {
    let (min, max) = (from.min(to), from.max(to));
    let (wide, high) = (half.x + (MARGIN + (max.x - min.x)), half.y + MARGIN);
    [min.x - wide, max.x + wide, min.y - high, max.y + high]
}
