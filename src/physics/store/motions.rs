//! Motions of bodies and surfaces in the present step: free flights, ends, and swept boxes.

use crate::physics::data::{Aabb, Body, Part, Pose, Surface, called, parabola};
use crate::physics::flight::air::fly_through;
use crate::physics::forces::{Drag, Media, media::fall};
use glam::DVec2;

/// m. How much further than predicted a body may get before its contacts are sought again. Larger: more contacts; smaller: more islands grow.
pub(crate) const MARGIN: f64 = 1e-2;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Method {
    /// Free flight, or rest.
    #[default]
    Flight,
    /// Flight together with the bodies that links join to it.
    Linked,
    Events,
    Crowd,
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Guide {
    /// Its end, if the body touches nothing, and all places of its centre on the way, m, if these may lie beyond.
    pub end: Pose,
    pub places: Option<Aabb>,
    /// The acceleration there, m/s², if that came out of the flight.
    pub pull: Option<DVec2>,
    /// Whether the body stands still although nothing holds it: it may fall asleep.
    pub floats: bool,
    /// Whether the end is a rough one: the body touches something, so that an island finds its end.
    pub roughly: bool,
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BodyMotion {
    /// Acceleration by gravity and constant forces, m/s².
    pub pull: DVec2,
    /// The end of the step if the body touches nothing, and the end that the islands found.
    pub free: Pose,
    pub end: Pose,
    /// The acceleration that an island found at the end of the step, m/s²; whether that and the contacts hold.
    pub acceleration: DVec2,
    pub known: bool,
    pub method: Method,
    /// A body that names its island, unless it flies or rests by itself: the smallest, in a crowd the lowest.
    pub leader: u32,
    /// How often its island grew in this step, after how many events, and whether that island is solved again.
    pub growths: u8,
    pub spent: u32,
    pub again: bool,
    /// Whether no constant force describes its flight, and whether `acceleration` is that at its end.
    pub guided: bool,
    pub pulled: bool,
    /// Of such a flight: [`Guide::floats`], [`Guide::roughly`].
    pub floats: bool,
    pub roughly: bool,
    /// Whether a crowd step listed what its contacts gave.
    pub listed: bool,
    /// How often its island was solved so far: what an earlier solution listed holds no longer.
    pub solved: u32,
}

impl BodyMotion {
    /// Sets the acceleration at the end of a flight, m/s², if that came out of it.
    pub fn pull_at_end(&mut self, pull: Option<DVec2>) {
        (self.pulled, self.acceleration) = (pull.is_some(), pull.unwrap_or_default());
    }
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
    pub belt: f64,
    pub present: bool,
}

impl SurfaceMotion {
    fn of(surface: &Surface) -> Self {
        let (from, half) = (surface.bounds.centre(), surface.bounds.size() * 0.5);
        let (mean, end, was) = (DVec2::ZERO, DVec2::ZERO, DVec2::ZERO);
        Self { from, to: from, half, mean, end, was, belt: surface.belt, present: surface.present }
    }

    pub fn stand(&mut self) {
        (self.to, self.mean, self.end) = (self.from, DVec2::ZERO, DVec2::ZERO);
    }

    pub fn moves(&self) -> bool {
        self.mean != DVec2::ZERO
    }

    pub fn carries(&self) -> bool {
        self.moves() || self.was != DVec2::ZERO || self.belt != 0.0
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Motions {
    pub bodies: Vec<BodyMotion>,
    pub surfaces: Vec<SurfaceMotion>,
    pub before: Vec<Pose>,
    /// What each body, and after them each surface, sweeps in this step: an absent surface nothing.
    pub swept: Vec<Aabb>,
    pub drags: Vec<Drag>,
    pub airy: bool,
    /// Flights of the next step that no constant force describes.
    pub guided: Vec<(u32, Guide)>,
}

impl Motions {
    pub fn new(bodies: &[Body], surfaces: &[Surface], media: &Media) -> Self {
        let drags: Vec<Drag> = bodies.iter().map(|body| media.air(body)).collect();
        let pose = |body: &Body| (body.position, body.velocity);
        let rests = |pose: Pose| BodyMotion { free: pose, end: pose, ..BodyMotion::default() };
        let mut motions = Self {
            bodies: bodies.iter().map(pose).map(rests).collect(),
            surfaces: surfaces.iter().map(SurfaceMotion::of).collect(),
            before: bodies.iter().map(pose).collect(),
            swept: vec![Aabb::NOWHERE; bodies.len() + surfaces.len()],
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
            (motion.method, motion.known) = (Method::Flight, true);
            (motion.growths, motion.spent, motion.again) = (0, 0, false);
            (motion.guided, motion.pulled, motion.floats, motion.roughly) = (false, false, false, false);
        }
        for (i, guide) in self.guided.drain(..) {
            let (body, motion) = (&bodies[i as usize], &mut motions[i as usize]);
            (motion.free, motion.end, motion.guided) = (guide.end, guide.end, true);
            (motion.floats, motion.roughly) = (guide.floats, guide.roughly);
            motion.pull_at_end(guide.pull);
            let places = guide.places.map(|of| Aabb::new(of.min - body.half, of.max + body.half));
            let way = way(body.position, guide.end.0, body.half);
            swept[i as usize] = places.map_or(way, |places| way.union(&places));
        }
    }

    pub fn sweep_surface(&mut self, surface: usize) {
        let of = &self.surfaces[surface];
        self.swept[self.bodies.len() + surface] = if of.present { way(of.from, of.to, of.half) } else { Aabb::NOWHERE };
    }

    pub fn is_swept(&self, i: usize, half: DVec2) -> bool {
        self.swept[i].contains(&Aabb::around(self.bodies[i].end.0, half), 0.0)
    }

    /// The body that names the island in which a body was advanced; none if it flew or rested by itself.
    pub fn island_of(&self, i: u32) -> Option<u32> {
        let motion = &self.bodies[i as usize];
        (motion.method != Method::Flight).then_some(motion.leader)
    }

    pub fn widen(&mut self, i: usize, reach: DVec2) {
        let Aabb { min, max } = self.swept[i];
        self.swept[i] = Aabb::new(min - reach, max + reach);
    }

    pub fn fall_freely(&mut self, i: usize) {
        self.bodies[i].end = self.bodies[i].free;
    }
}

fn way(from: DVec2, to: DVec2, half: DVec2) -> Aabb {
    let (min, max) = (from.min(to), from.max(to));
    let reach = half + DVec2::new(MARGIN + (max.x - min.x), MARGIN);
    Aabb::new(min - reach, max + reach)
}
