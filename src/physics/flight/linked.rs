//! Linked bodies fly together: the modified midpoint rule (Gragg 1965), extrapolated to order 16 at most (Bulirsch and Stoer 1966), over all of a
//! group. No step crosses an instant at which a law bends (a rope becomes taut or slack, a magnet is at its nearest) or a link breaks.

use crate::physics::data::tuning::{BALANCED, LINKED_ROUNDING, LINKED_TOLERANCE, LONGEST_SHORT, MOST_BENDS, SHORTEST_LINKED};
use crate::physics::data::{Aabb, Body, Cubic, LinkLaw, Pose, parabola};
use crate::physics::forces::{Law, Link, Media};
use glam::DVec2;

/// Rows of the extrapolation: 2, 4, 6 … midpoint steps.
const ROWS: usize = 8;

/// Error allowed where media brake, in parts of the longest way of a step. Larger: a tow is off by 1e-8 m in seconds; smaller: more steps at turns.
const ROUGH: f64 = 2e-11;

/// Place, velocity and the impulse of the links since the step's begin; or their rates.
type LinkedState = [DVec2; 3];

#[derive(Clone, Debug, Default)]
pub(crate) struct Linked {
    pub id: u32,
    /// Contacts hold it: it stays, and the others fly around it.
    pub held: bool,
    /// With it its whole group rests, which moves no more.
    pub rests: bool,
    /// The force, N, and the speed, m/s, that count as none where it hangs.
    pub least: (f64, f64),
    pub law: Law,
    pub pose: Pose,
    /// The mean force of its links over the tick, N.
    pub mean: DVec2,
    pub places: Aabb,
    mass: f64,
    /// The force of its links in the pose `at`, N.
    force: DVec2,
    at: Pose,
    /// Where it is beyond the bend that is sought.
    pub(super) beyond: Pose,
    /// The rates at the begin of the step, the last midpoint but one, its end, and the last row of the extrapolation.
    rates: LinkedState,
    before: LinkedState,
    end: LinkedState,
    row: [LinkedState; ROWS],
}

impl Linked {
    pub fn new(body: &Body, id: u32, held: bool, law: Law) -> Self {
        let (pose, places) = ((body.position, body.velocity), Aabb::around(body.position, DVec2::ZERO));
        Self { id, held, law, pose, places, mass: body.mass, at: pose, beyond: pose, ..Self::default() }
    }

    /// Takes the result of a row with twice `number` + 2 midpoint steps. Returns its error in parts of that allowed, larger by `rough`, m.
    fn extrapolate(&mut self, number: usize, h: f64, rough: f64) -> f64 {
        let mut best = self.end;
        for k in 1..=number {
            let before = std::mem::replace(&mut self.row[k - 1], best);
            let ratio = (number + 1) as f64 / (number + 1 - k) as f64;
            best = std::array::from_fn(|i| best[i] + (best[i] - before[i]) / (ratio * ratio - 1.0));
        }
        let last = self.row[number.saturating_sub(1)];
        (self.row[number], self.end) = (best, best);
        let error = (best[0] - last[0]).abs().max((best[1] - last[1]).abs() * h).max_element();
        let error = error / (LINKED_TOLERANCE + rough + 8.0 * f64::EPSILON * self.pose.0.abs().max_element());
        if number == 0 { f64::INFINITY } else { error }
    }

    /// The course of a body in free motion is a cubic: it lies within its control points.
    fn accept(&mut self, h: f64, t: f64) {
        let ((x, v), [to, w, impulse]) = (self.pose, self.end);
        for place in [x + v * (h / 3.0), to - w * (h / 3.0), to] {
            self.places = self.places.union(&Aabb::around(place, DVec2::ZERO));
        }
        (self.pose, self.at) = ((to, w), (to, w));
        self.mean += impulse / t;
    }

    pub(super) fn end(&self) -> Pose {
        (self.end[0], self.end[1])
    }

    /// Its pose `t` seconds after the begin of a step that leads to `end` after `h` seconds, about.
    pub(super) fn on_cubic(&self, end: Pose, h: f64, t: f64) -> Pose {
        let [x, v, ..] = Cubic::hermite(self.pose.0, self.pose.1, end.0, end.1, h).from(t).c;
        (x, v)
    }

    fn rates_in(&self, media: &Media, bodies: &[Body]) -> LinkedState {
        if self.held {
            return [DVec2::ZERO, DVec2::ZERO, self.force];
        }
        let (x, v) = self.at;
        [v, media.acceleration(&bodies[self.id as usize], &self.law, x, v) + self.force / self.mass, self.force]
    }

    /// Whether it stands, and its forces balance, as far as roundings of its place decide.
    fn balances(&mut self, stiffness: f64) -> bool {
        let ([_, pull, links], mass) = (self.rates, self.mass);
        let (links, little) = (links.length(), little(stiffness, self.pose.0));
        let most = if links <= little { little } else { little.min(0.5 * BALANCED * links + rounding(stiffness, self.pose.0)) };
        self.least = (most, if stiffness > 0.0 { little / (stiffness * mass).sqrt() } else { 0.0 });
        self.held || (pull * mass).length() <= most && self.pose.1.length() <= self.least.1
    }
}

/// The force of a link of that stiffness (N/m) that the rounding of a place makes, N.
fn rounding(stiffness: f64, place: DVec2) -> f64 {
    stiffness * 8.0 * f64::EPSILON * place.abs().max_element()
}

/// The force of a link at rest that counts as none, N.
pub(crate) fn little(stiffness: f64, place: DVec2) -> f64 {
    rounding(stiffness, place) + stiffness * LINKED_ROUNDING
}

#[derive(Clone, Debug)]
pub(crate) struct Pull {
    pub link: u32,
    /// The numbers of its ends among the members; a place has none.
    ends: [Option<usize>; 2],
    /// Its law as the step begins, and the side of that law's border.
    pub(super) law: LinkLaw,
    pub(super) above: bool,
    /// m/s.
    pub(super) growth: f64,
    pub broken: bool,
}

impl Pull {
    pub(super) fn law_after(&self, offset: f64) -> LinkLaw {
        self.law.length().map_or(self.law, |length| self.law.of_length(length + self.growth * offset))
    }
}

pub(crate) struct LinkedBodies<'a> {
    pub media: &'a Media,
    pub bodies: &'a [Body],
    pub links: &'a [Link],
    pub members: &'a mut [Linked],
    pub pulls: &'a mut Vec<Pull>,
    /// Length of the tick, and the time since its begin, s.
    pub tick: f64,
    pub now: f64,
}

impl LinkedBodies<'_> {
    /// Flies all members to the end of the tick. `pulls` has the links that have broken then.
    pub fn fly(&mut self) {
        self.gather();
        if self.rests() {
            for member in &mut *self.members {
                (member.rests, member.pose.1, member.mean) = (true, DVec2::ZERO, member.force);
            }
            return;
        }
        self.members.iter_mut().for_each(|member| member.at = member.pose);
        self.begin_step();
        let shortest = (self.tick / SHORTEST_LINKED).min(LONGEST_SHORT);
        let (mut h, mut bends) = (self.tick, 0);
        while self.now < self.tick {
            let left = self.tick - self.now;
            h = if h > 0.999 * left { left } else { h };
            let (error, rows) = self.step(h);
            if (error > 1.0 || error.is_nan()) && h > shortest {
                h *= if error.is_finite() { 0.5 } else { 0.1 };
                continue;
            }
            let mut taken = h;
            if bends < MOST_BENDS / self.members.len()
                && let Some(bend) = self.bend(h)
            {
                (taken, bends) = (bend, bends + 1);
            }
            if !self.members.iter().all(|member| member.end.iter().all(|part| part.is_finite())) {
                return self.end_early();
            }
            self.accept(taken);
            h *= if rows <= 5 { 2.0 } else { 1.0 };
        }
    }

    fn gather(&mut self) {
        let Self { links, members, pulls, tick, .. } = self;
        let find = |body: u32| members.binary_search_by_key(&body, |member| member.id).ok();
        pulls.clear();
        for (link, of) in (0..).zip(links.iter()).filter(|(_, link)| link.acts()) {
            let ends = [find(of.def.body.0), of.def.other().and_then(|other| find(other.0))];
            if ends[0].is_some() {
                pulls.push(Pull { link, ends, law: of.law, above: false, growth: of.growth(*tick), broken: false });
            }
        }
    }

    /// Whether the members hardly move, and would stay if they stood.
    fn rests(&mut self) -> bool {
        self.members.iter_mut().for_each(|member| member.at = (member.pose.0, DVec2::ZERO));
        self.begin_step();
        for at in 0..self.members.len() {
            let of = |pull: &&Pull| pull.ends.contains(&Some(at)) && self.force(pull, 0.0) != DVec2::ZERO;
            let stiffness = self.pulls.iter().filter(of).map(|pull| pull.law.rates()[0]).sum();
            if !self.members[at].balances(stiffness) {
                return false;
            }
        }
        self.pulls.iter().all(|pull| pull.growth == 0.0)
    }

    /// The media alone move what is left of a tick that no step resolves.
    fn end_early(&mut self) {
        let left = self.tick - self.now;
        self.media.end_early();
        for member in self.members.iter_mut().filter(|member| !member.held) {
            member.pose = parabola(member.pose, member.law.constant, left);
            member.places = member.places.union(&Aabb::around(member.pose.0, DVec2::ZERO));
        }
    }

    pub(super) fn accept(&mut self, h: f64) {
        self.members.iter_mut().for_each(|member| member.accept(h, self.tick));
        self.now = if h == self.tick - self.now { self.tick } else { self.now + h };
        self.begin_step();
    }

    /// Sides of borders, breaks and rates where the members are.
    fn begin_step(&mut self) {
        for k in 0..self.pulls.len() {
            let law = self.links[self.pulls[k].link as usize].law;
            self.pulls[k].law = law.length().map_or(law, |length| law.of_length(length + self.pulls[k].growth * self.now));
            let (border, over) = self.border(&self.pulls[k], 0.0, |member| member.at);
            (self.pulls[k].above, self.pulls[k].broken) = (border > 0.0, self.pulls[k].broken || over > 0.0);
        }
        self.pull(0.0);
        let Self { media, bodies, members, .. } = self;
        members.iter_mut().for_each(|member| member.rates = member.rates_in(media, bodies));
    }

    /// One step of `h` seconds. Returns its error as a part of the error allowed, and the rows that it took.
    pub(super) fn step(&mut self, h: f64) -> (f64, usize) {
        let brakes = self.members.iter().any(|member| !member.law.is_constant());
        let (mut rough, mut error) = (0.0, f64::INFINITY);
        for row in 0..ROWS {
            self.midpoints(h, 2 * (row + 1));
            if row == 0 && brakes {
                rough = ROUGH * self.members.iter().map(|member| (member.end[0] - member.pose.0).length()).fold(0.0, f64::max);
            }
            // An error that is no number is too large.
            let worse = |most: f64, error: f64| if error <= most { most } else { error };
            let before = error;
            error = self.members.iter_mut().map(|member| member.extrapolate(row, h, rough)).fold(0.0, worse);
            if error <= 1.0 {
                return (error, row + 1);
            }
            // Rows that come nearer no faster than this do not get there: the step is too long, or there is a corner in it.
            let last = (row + 1..ROWS).fold(error, |last, _| last * (error / before));
            if row >= 2 && (last > 1.0 || last.is_nan()) {
                return (error, row + 1);
            }
        }
        (error, ROWS)
    }

    /// The modified midpoint rule: the result of `count` steps becomes the members' ends.
    fn midpoints(&mut self, h: f64, count: usize) {
        let part = h / count as f64;
        for member in &mut *self.members {
            member.before = [member.pose.0, member.pose.1, DVec2::ZERO];
            member.end = along(&member.before, &member.rates, part);
        }
        for step in 1..=count {
            self.members.iter_mut().for_each(|member| member.at = member.end());
            self.pull(part * step as f64);
            for member in &mut *self.members {
                let rates = member.rates_in(self.media, self.bodies);
                if step < count {
                    member.before = std::mem::replace(&mut member.end, along(&member.before, &rates, 2.0 * part));
                } else {
                    let smooth = along(&member.before, &rates, part);
                    member.end = std::array::from_fn(|i| (smooth[i] + member.end[i]) * 0.5);
                }
            }
        }
    }

    /// The forces of the links where the members are, `offset` seconds after the begin of the step.
    fn pull(&mut self, offset: f64) {
        self.members.iter_mut().for_each(|member| member.force = DVec2::ZERO);
        for k in 0..self.pulls.len() {
            let (force, ends) = (self.force(&self.pulls[k], offset), self.pulls[k].ends);
            for (end, sign) in ends.into_iter().zip([1.0, -1.0]).filter_map(|(end, sign)| Some((end?, sign))) {
                self.members[end].force += force * sign;
            }
        }
    }

    /// The force of a link where the members are, N.
    fn force(&self, pull: &Pull, offset: f64) -> DVec2 {
        if pull.broken {
            return DVec2::ZERO;
        }
        let (apart, parting) = self.apart(pull, |member| member.at);
        pull.law_after(offset).force(pull.above, apart, parting)
    }

    pub(super) fn apart(&self, pull: &Pull, pose: impl Fn(&Linked) -> Pose) -> Pose {
        let def = &self.links[pull.link as usize].def;
        let end = |id: u32| pull.ends[usize::from(id != def.body.0)];
        def.apart(|id| end(id).map_or_else(Pose::default, |end| pose(&self.members[end])))
    }

    /// The side of a law's border in those poses, and how much of the force that breaks the link is exceeded, N.
    pub(super) fn border(&self, pull: &Pull, offset: f64, pose: impl Fn(&Linked) -> Pose) -> (f64, f64) {
        let (law, (apart, parting)) = (pull.law_after(offset), self.apart(pull, pose));
        let border = law.border(apart, parting);
        let breaks = self.links[pull.link as usize].def.breaks.filter(|_| !pull.broken);
        (border, breaks.map_or(-1.0, |breaks| law.force(border > 0.0, apart, parting).length() - breaks))
    }
}

fn along(from: &LinkedState, rates: &LinkedState, time: f64) -> LinkedState {
    std::array::from_fn(|i| from[i] + rates[i] * time)
}
