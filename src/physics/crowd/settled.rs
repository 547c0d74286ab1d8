//! The members of an island that a crowd step takes for ground: they rested, the same pulls at them, and nothing that moves is near. If one is
//! pushed after all, or what it stands on moves, the step is solved again with it: the answer is that of all members, bit for bit.

use crate::physics::crowd::{ACROSS, bodies::Bodies, bodies::Origin, contacts::TOUCH, dense::Dense};
use crate::physics::{data::Body, store::Island, store::Motions};
use glam::DVec2;

/// In a smaller island all are looked at, or none: to find out takes as long.
const FEW: usize = 24;
/// A step is solved at most this often with a part of the members, then with all.
const MOST: u32 = 6;

/// What a member is to a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
enum MemberRest {
    #[default]
    Moves,
    /// Something may act on it, and on what touches it.
    Woken,
    /// It is looked at, and expected to rest: others rely on that.
    Relied,
    Settled,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Settled {
    rests: Vec<MemberRest>,
    /// The step in which a body was found to rest last, and its acceleration without contacts then, m/s².
    found: Vec<(u64, DVec2)>,
    active: Vec<u32>,
    /// Counts steps, two for one of another length.
    pub step: u64,
    /// Whether any surface carries what is on it in this step.
    pub carried: bool,
    solutions: u32,
    any: bool,
    /// The largest coordinate that the island sweeps, m.
    largest: f64,
    /// All members are looked at, by all stages of the step: for tests.
    pub off: bool,
}

impl Settled {
    pub fn new(n: usize) -> Self {
        let (rests, found) = (vec![MemberRest::Moves; n], vec![(0, DVec2::ZERO); n]);
        Self { rests, found, active: Vec::with_capacity(n), step: 2, ..Self::default() }
    }

    /// What has been found of a body holds no longer.
    pub fn forget(&mut self, body: usize) {
        self.found[body].0 = 0;
    }

    /// The largest coordinate that settled members sweep, m, or less.
    pub fn largest(&self) -> f64 {
        if self.any { self.largest } else { 0.0 }
    }

    pub fn is_settled(&self, item: u32) -> bool {
        self.any && self.rests.get(item as usize) == Some(&MemberRest::Settled)
    }

    /// Chooses the members of an island that are looked at.
    pub fn begin(&mut self, from: Origin<'_>, island: Island<'_>, looks_at_all: bool) {
        self.any = false;
        self.solutions = 1;
        let members = island.members;
        if self.off || looks_at_all {
            return;
        }
        let Self { rests, found, step, .. } = self;
        let (mut known, mut alike, first) = (0, true, from.bodies[members[0] as usize].coefficients());
        for at in members.iter().map(|i| *i as usize) {
            let (body, motion) = (&from.bodies[at], &from.motions.bodies[at]);
            let settled = found[at].0 + 1 == *step && found[at].1 == motion.pull && !motion.guided && body.velocity == DVec2::ZERO;
            if !settled && members.len() < FEW {
                return;
            }
            rests[at] = if settled { MemberRest::Settled } else { MemberRest::Moves };
            known += usize::from(settled);
            alike &= first.rubs_like(&body.coefficients());
        }
        // Too few of them: to look at the others takes as long.
        if !alike || 4 * known < members.len() {
            return;
        }
        // Rest on what carries is another in each step.
        let carried = |j: &u32| (*j as usize).checked_sub(self.rests.len()).is_some_and(|s| from.motions.surfaces[s].carries());
        let mut settled = members.iter().filter(|i| self.rests[**i as usize] == MemberRest::Settled);
        if self.carried && settled.any(|i| island.near(*i).iter().any(carried)) {
            return;
        }
        if known == members.len() {
            self.active.clear();
            self.any = true;
            return;
        }
        self.largest = members.iter().map(|i| from.motions.swept[*i as usize].largest()).fold(0.0, f64::max);
        for &i in members {
            if self.rests[i as usize] != MemberRest::Moves {
                continue;
            }
            for &j in island.near(i) {
                if self.rests.get(j as usize).is_some_and(|rest| *rest > MemberRest::Woken) {
                    self.rests[j as usize] = beside(from, i as usize, j as usize).min(self.rests[j as usize]);
                }
            }
        }
        self.choose(from, island);
    }

    /// Spreads over who touches whom, bottom-up, what is known of those that move.
    fn choose(&mut self, from: Origin<'_>, island: Island<'_>) {
        self.active.clear();
        for &i in island.members {
            let at = i as usize;
            let mut rest = self.rests[at];
            if rest > MemberRest::Woken {
                for j in island.near(i).iter().map(|j| *j as usize) {
                    rest = match self.rests.get(j) {
                        Some(MemberRest::Moves) => rest.min(beside(from, j, at)),
                        Some(MemberRest::Woken) if touch(from.bodies, at, j) => MemberRest::Woken,
                        Some(MemberRest::Woken) => rest.min(MemberRest::Relied),
                        Some(MemberRest::Relied | MemberRest::Settled) | None => rest,
                    };
                }
                self.rests[at] = rest;
            }
            if rest != MemberRest::Settled {
                self.active.push(i);
            }
        }
        self.any = self.solutions <= MOST && self.active.len() < island.members.len();
    }

    /// Looks at all. Returns whether that is new.
    pub fn give_up(&mut self) -> bool {
        std::mem::replace(&mut self.any, false)
    }

    /// What is looked at of an island.
    pub fn part_of<'a>(&'a self, island: Island<'a>) -> Island<'a> {
        if self.any { Island { members: &self.active, ..island } } else { island }
    }

    /// Looks also at those settled that were pushed, and at what rests on those that moved. Returns whether there are any.
    pub fn wake(&mut self, from: Origin<'_>, island: Island<'_>, bodies: &Bodies, dense: &Dense) -> bool {
        if !self.any {
            return false;
        }
        let n = bodies.len();
        let mut stirred = false;
        for k in dense.pushed().map(|k| k as usize).filter(|k| *k >= n && bodies.is_body(*k)) {
            (self.rests[bodies.ids[k] as usize], stirred) = (MemberRest::Woken, true);
        }
        for k in 0..n {
            let rest = &mut self.rests[bodies.ids[k] as usize];
            let moved = || bodies[k].to != bodies[k].from || bodies[k].end != DVec2::ZERO || dense.friction.is_awake[k];
            if *rest == MemberRest::Relied && moved() {
                (*rest, stirred) = (MemberRest::Woken, true);
            }
        }
        if stirred {
            let before = self.active.len();
            self.solutions += 1;
            self.choose(from, island);
            stirred = self.active.len() > before;
        }
        stirred
    }

    pub fn note(&mut self, motions: &Motions, island: Island<'_>, bodies: &Bodies, dense: &Dense) {
        let Self { found, step, rests, any, .. } = self;
        // A body that stands on such a surface may slide when others move.
        let slippery = (bodies.len()..bodies.things.len()).any(|j| bodies.is_slippery(j));
        for k in 0..bodies.len() {
            let (id, of, anchors) = (bodies.ids[k] as usize, &bodies[k], &dense.anchors);
            let hangs = anchors.any_hung && anchors.hung[k].is_some();
            let still = of.before == DVec2::ZERO && of.end == DVec2::ZERO && of.to == of.from && of.free[ACROSS] == 0.0;
            let settled = still && !slippery && anchors.rests[k] && !hangs && !dense.friction.is_awake[k];
            found[id] = (if settled { *step } else { 0 }, motions.bodies[id].pull);
        }
        for i in island.members.iter().map(|i| *i as usize).filter(|i| *any && rests[*i] == MemberRest::Settled) {
            found[i].0 = *step;
        }
    }
}

/// What one that rests is because of a mover near it: woken if it comes within touch.
fn beside(from: Origin<'_>, mover: usize, other: usize) -> MemberRest {
    let (a, b, end) = (&from.bodies[mover], &from.bodies[other], from.motions.bodies[mover].free.0);
    let reach = a.half + b.half + 2.0 * TOUCH;
    let (start, end) = (a.position - b.position, end - b.position);
    let comes = start.min(end).cmple(reach).all() && start.max(end).cmpge(-reach).all();
    if comes { MemberRest::Woken } else { MemberRest::Relied }
}

fn touch(bodies: &[Body], i: usize, j: usize) -> bool {
    let (a, b) = (&bodies[i], &bodies[j]);
    (a.position - b.position).abs().cmple(a.half + b.half + 2.0 * TOUCH).all()
}

#[cfg(test)]
mod tests {
    use crate::physics::{Aabb, BodyDef, BodyId, Plan, SurfaceDef, World, WorldDef};
    use crate::random::Random;
    use glam::DVec2;

    /// Boxes that rain into a pit of their own material: sizes, masses and restitutions of each at random where they are `mixed`.
    fn pit(random: &mut Random, count: usize, mixed: bool) -> World {
        let half = |random: &mut Random| 0.15 + 0.15 * random.unit();
        let body = |k: usize, random: &mut Random| BodyDef {
            position: DVec2::new((k % 12) as f64 * 0.8 + 0.2 * random.unit(), -0.9 * (k / 12) as f64 - 0.2 * random.unit()),
            velocity: DVec2::new(4.0 * random.unit() - 2.0, 0.0),
            half: if mixed { DVec2::new(half(random), half(random)) } else { DVec2::splat(0.25) },
            mass: if mixed { 0.5 * libm::pow(100.0, random.unit()) } else { 2.0 },
            restitution: if mixed { 0.8 * random.unit() } else { 0.0 },
            ..BodyDef::default()
        };
        let wall = |x0: f64, y0: f64, x1: f64, y1: f64| {
            SurfaceDef::fixed(Aabb::new(DVec2::new(x0, y0), DVec2::new(x1, y1)), BodyDef::default().material)
        };
        let bodies = (0..count).map(|k| body(k, random)).collect();
        let surfaces = vec![wall(-2.0, 0.8, 12.0, 2.0), wall(-2.0, -40.0, -1.0, 2.0), wall(10.0, -40.0, 12.0, 2.0)];
        let def = WorldDef { bodies, surfaces, rest_speed: if mixed { 0.1 } else { 0.0 }, ..WorldDef::default() };
        let plan = Plan { dense: true, direct: false, ..Plan::of(&def) };
        World::with_plan(def, plan).unwrap()
    }

    #[test]
    fn members_taken_for_ground_change_no_bit() {
        let mut random = Random(7);
        let mut taken = 0;
        for round in 0..12 {
            let mut world = pit(&mut random, 40 + 10 * round, round % 3 > 0);
            let mut whole = world.clone();
            whole.space.crowd.settled.off = true;
            for tick in 0..500 {
                // Something that rests is driven now and then.
                if tick % 60 == 0 && tick > 200 {
                    let (body, force) =
                        (BodyId((tick % 40) as u32), DVec2::new(60.0 * (random.unit() - 0.5), -40.0 * random.unit()));
                    [&mut world, &mut whole].into_iter().for_each(|of| of.set_drive(body, force));
                }
                [&mut world, &mut whole].into_iter().for_each(|of| of.step(1.0 / 60.0));
                let pose = |of: &World, i: usize| (of.bodies()[i].position.to_array(), of.bodies()[i].velocity.to_array());
                for i in 0..world.bodies().len() {
                    assert_eq!(pose(&world, i), pose(&whole, i), "round {round}, tick {tick}, body {i}");
                }
                taken += usize::from(world.space.crowd.bodies.len() < world.space.crowd.bodies.whole);
            }
        }
        assert!(taken > 500, "{taken}");
    }

    #[test]
    fn a_slide_in_closed_form_changes_no_bit() {
        let mut random = Random(11);
        let mut slid = 0;
        for round in 0..400 {
            // Down or up, and some leave the floor.
            let (side, floor) = ([1.0, -1.0][round % 2], 6.0 + 100.0 * random.unit());
            let body = BodyDef {
                position: DVec2::new(10.0 * random.unit() - 5.0, -0.25 * side),
                velocity: DVec2::new(20.0 * random.unit() - 10.0, 0.0),
                half: DVec2::new(0.1 + random.unit(), 0.25),
                mass: libm::pow(100.0, random.unit()),
                restitution: random.unit(),
                ..BodyDef::default()
            };
            let (min, max) = (DVec2::new(-floor, side.min(0.0)), DVec2::new(floor, side.max(0.0)));
            let floor = SurfaceDef::fixed(Aabb::new(min, max), body.material);
            let def = WorldDef {
                bodies: vec![body],
                surfaces: vec![floor],
                gravity: side * (1.0 + 20.0 * random.unit()),
                ..WorldDef::default()
            };
            let plan = Plan { dense: true, direct: false, ..Plan::of(&def) };
            let mut world = World::with_plan(def, plan).unwrap();
            let mut whole = world.clone();
            whole.space.crowd.settled.off = true;
            let drive = DVec2::new(40.0 * (random.unit() - 0.5), 4.0 * (random.unit() - 0.5));
            for _ in 0..120 {
                for of in [&mut world, &mut whole] {
                    of.set_drive(BodyId(0), drive);
                    of.step(1.0 / 60.0);
                }
                let pose = |of: &World| (of.bodies()[0].position.to_array(), of.bodies()[0].velocity.to_array());
                assert_eq!(pose(&world), pose(&whole), "round {round}");
                slid += usize::from(world.bodies()[0].velocity.x != 0.0);
            }
        }
        assert!(slid > 4000, "{slid}");
    }
}
