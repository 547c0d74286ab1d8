//! Restitution, the last stage of a crowd step (Poisson's law; `docs/physics.md`, The crowd step, 6), and the bound on energy.

use crate::physics::crowd::{ACROSS, ALONG, Edge, ROUNDING, bodies::Bodies, dense::Dense};
use crate::physics::data::plan::{Part, called};
use glam::DVec2;

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
    pub(crate) fn bounce(&mut self, bodies: &mut Bodies) {
        self.bounced = false;
        if !bodies.bounces {
            return;
        }
        called(Part::Bounces);
        (0..bodies.len()).for_each(|i| self.plastic[i] = bodies[i].end);
        let Self { anchors, report, bounced, .. } = self;
        for (edges, axis) in [(&mut anchors.edges, ALONG), (&mut report.sides, ACROSS)] {
            for edge in edges.iter_mut().filter(|edge| edge.restitution > 0.0) {
                part(bodies, edge, axis);
                *bounced = true;
            }
        }
        for i in (0..bodies.len()).filter(|i| anchors.bounce[*i] > 0.0) {
            let (way, end) = (bodies[i].to.y - bodies[i].from.y, bodies[i].end.y);
            bodies[i].end.y = anchors.bounces.rebound(&bodies[i], way, end, anchors.bounce[i]);
            *bounced |= bodies[i].end.y != end;
        }
    }

    /// An island that has gained energy keeps the part of its bounces that leaves none over (momentum stays). If the plastic motion alone has too
    /// much, one factor slows the touched bodies: that is counted, and keeps the momentum where nothing immovable is.
    pub(crate) fn restrain(&mut self, bodies: &mut Bodies, doubt: bool) {
        let stirred = self.bounced || self.walls.any;
        if self.contacts.carried || !(stirred || doubt || !self.anchors.edges.is_empty()) {
            return;
        }
        let touched = |bodies: &Bodies, i: usize| stirred || bodies[i].end != bodies[i].free;
        let mut sum = Balance::default();
        for i in (0..bodies.len()).filter(|i| touched(bodies, *i)) {
            let end = bodies[i].end;
            let plastic = if self.bounced { self.plastic[i] } else { end };
            sum.add(bodies, i, [plastic, end - plastic], self.dt);
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
    /// At the start, with the work of all pulls.
    had: f64,
    /// Of the plastic velocities, their product with the bounces, and of the bounces.
    plastic: f64,
    mixed: f64,
    bounces: f64,
    /// Kinetic, before and after: the scale of rounding.
    all: f64,
}

impl Balance {
    fn add(&mut self, bodies: &Bodies, i: usize, [plastic, bounce]: [DVec2; 2], dt: f64) {
        let body = &bodies[i];
        let (mass, before, work) = (body.mass, body.before.length_squared(), body.pull.dot(body.to - body.from));
        // What liquids and streams do, at their mean force on its flight.
        let driven = body.guided.map_or(0.0, |gained| (gained / dt - body.pull).dot(body.to - body.from).max(0.0));
        self.had += mass * (0.5 * before + work + driven);
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

    fn part(&self) -> f64 {
        let over = self.gained(0.0);
        let root = (self.mixed * self.mixed - 4.0 * self.bounces * over).max(0.0).sqrt();
        let below = self.mixed + root;
        if over >= 0.0 || below <= 0.0 { 0.0 } else { (-2.0 * over / below).min(1.0) }
    }
}
