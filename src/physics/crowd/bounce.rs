//! Restitution: the last stage of a crowd step.
//!
//! The step is solved as if every impact were plastic; that gives each contact the impulse of its compression. Poisson's law returns the
//! part e of it. In a group of bodies that merged in the air each contact returns the same part, the smallest restitution of its impacts:
//! the plastic velocities are the projection of the free ones on what the contacts allow, in the metric of the masses, so
//! |v⁺|² = |v_p|² + e²|v_p − v|² ≤ |v|² (Moreau 1988), and the momentum stays. What hits something that does not give way leaves with e·s, where s
//! is the closing speed at the contact by the energy of its own fall. A bounce that would end within the step is none.

use crate::physics::crowd::bodies::Bodies;
use crate::physics::crowd::dense::Dense;
use crate::physics::crowd::impulses::Edge;
use crate::physics::crowd::restitution::Fall;
use crate::physics::crowd::{ACROSS, ALONG};
use crate::physics::data::plan::{Part, called};
use glam::DVec2;

/// Energy gained that is no more than rounding, as a part of the kinetic energy. Smaller: rounding slows what it should not.
const ROUNDING: f64 = 1e-12;

/// Lets an edge along that axis return its part.
fn part(bodies: &mut Bodies, edge: &mut Edge, axis: usize) {
    let impulse = edge.restitution * edge.impulse;
    for (i, impulse) in [(edge.a as usize, -impulse), (edge.b as usize, impulse)] {
        if i < bodies.len() {
            bodies[i].end[axis] += impulse / bodies[i].mass;
        }
    }
    edge.impulse += impulse;
}

impl Dense {
    /// Returns to every impact its part of the impulse.
    pub(crate) fn bounce(&mut self, bodies: &mut Bodies) {
        self.bounced = false;
        if !bodies.bounces {
            return;
        }
        called(Part::Bounces);
        for i in 0..bodies.len() {
            self.plastic[i] = bodies[i].end;
        }
        let Self { anchors, report, bounced, .. } = self;
        for (edges, axis) in [(&mut anchors.edges, ALONG), (&mut report.sides, ACROSS)] {
            for edge in edges.iter_mut().filter(|edge| edge.restitution > 0.0) {
                part(bodies, edge, axis);
                *bounced = true;
            }
        }
        for i in 0..bodies.len() {
            if anchors.bounce[i] > 0.0 {
                let fall = Fall::of(&bodies[i], bodies[i].to.y - bodies[i].from.y, bodies[i].end.y);
                bodies[i].end.y = fall.rebound(anchors.bounce[i], anchors.bounces);
                *bounced |= bodies[i].end.y != fall.end;
            }
        }
    }

    /// The last word on energy. Impacts on both axes and of different restitution may return more than their island had: then all return the
    /// part of it that leaves none over, which keeps the momentum. What is merged and parted in a wild way may end higher even without
    /// bounces: then what was touched is slowed down by one factor. That is counted, and keeps the momentum where nothing immovable is.
    pub(crate) fn restrain(&mut self, bodies: &mut Bodies, doubt: bool) {
        let stirred = self.bounced || self.walls.any;
        if self.contacts.carried || !(stirred || doubt || !self.anchors.edges.is_empty()) {
            return;
        }
        let touched = |bodies: &Bodies, i: usize| stirred || bodies[i].end != bodies[i].free;
        let mut sum = Balance::default();
        for i in 0..bodies.len() {
            if touched(bodies, i) {
                let end = bodies[i].end;
                let plastic = if self.bounced { self.plastic[i] } else { end };
                sum.add(bodies, i, plastic, end - plastic);
            }
        }
        if sum.gained(1.0) <= ROUNDING * sum.all {
            return;
        }
        let part = sum.part();
        for i in (0..bodies.len()).filter(|_| self.bounced) {
            bodies[i].end = self.plastic[i] + (bodies[i].end - self.plastic[i]) * part;
        }
        for side in self.report.sides.iter_mut().filter(|side| side.restitution > 0.0) {
            side.impulse *= (1.0 + side.restitution * part) / (1.0 + side.restitution);
        }
        let (gained, left) = (sum.gained(part), sum.left(part));
        if gained <= ROUNDING * sum.all {
            return;
        }
        self.guards.energy_taken_out += 1;
        // In the frame of all that was touched, where nothing immovable is: that keeps their momentum.
        let n = bodies.len();
        let afloat = self.contacts.all().all(|contact| (contact.first as usize) < n && (contact.second as usize) < n);
        let of_touched = || (0..n).filter(|i| touched(bodies, *i));
        let mass: f64 = of_touched().map(|i| bodies[i].mass).sum();
        let momentum: DVec2 = of_touched().map(|i| bodies[i].mass * bodies[i].end).sum();
        let frame = if afloat { momentum / mass } else { DVec2::ZERO };
        let left = left - 0.5 * mass * frame.length_squared();
        let slower = if left > gained { (1.0 - gained / left).sqrt() } else { 0.0 };
        for i in 0..bodies.len() {
            if touched(bodies, i) {
                bodies[i].end = frame + (bodies[i].end - frame) * slower;
            }
        }
    }
}

/// The energy of an island as a polynomial of the part of the bounces that it keeps, J.
#[derive(Default)]
struct Balance {
    /// What it had at the start, with the work of what pulls at it.
    had: f64,
    /// Of the plastic velocities, their product with the bounces, and of the bounces.
    plastic: f64,
    mixed: f64,
    bounces: f64,
    /// Kinetic, before and after: the scale of rounding.
    all: f64,
}

impl Balance {
    fn add(&mut self, bodies: &Bodies, i: usize, plastic: DVec2, bounce: DVec2) {
        let body = &bodies[i];
        let (mass, before, work) = (body.mass, body.before.length_squared(), body.pull.dot(body.to - body.from));
        let had = 0.5 * before + work;
        // The work of liquids and streams is known of its flight alone.
        self.had += mass * body.guided.map_or(had, |flown| flown.max(had));
        self.plastic += 0.5 * mass * plastic.length_squared();
        self.mixed += mass * plastic.dot(bounce);
        self.bounces += 0.5 * mass * bounce.length_squared();
        self.all += mass * (before + 0.5 * (plastic + bounce).length_squared());
    }

    fn left(&self, part: f64) -> f64 {
        self.plastic + (self.mixed + self.bounces * part) * part
    }

    fn gained(&self, part: f64) -> f64 {
        self.left(part) - self.had
    }

    /// The largest part with which nothing is gained, at most 1.
    fn part(&self) -> f64 {
        let over = self.gained(0.0);
        let root = (self.mixed * self.mixed - 4.0 * self.bounces * over).max(0.0).sqrt();
        let below = self.mixed + root;
        if over >= 0.0 || below <= 0.0 { 0.0 } else { (-2.0 * over / below).min(1.0) }
    }
}
