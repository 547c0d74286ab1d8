//! The broad phase: which pairs may meet soon.
//!
//! Every body owns an allowed box, its path of two ticks with a skin of [`SKIN`] around it. Only pairs whose allowed boxes overlap are
//! looked at more closely, and the list holds until a body is about to leave its box. It is always complete and always in the same
//! order, so that it changes no bit of any motion.

use super::tuning::{SKIN, SLOP};
use super::{Aabb, World};
use glam::DVec2;

/// Two things that may meet: a body, and a body of higher index or a surface (counted on from the number of bodies).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Pair {
    pub a: u32,
    pub b: u32,
}

/// The list of pairs and the boxes for which it holds.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    /// Those with something that is awake; the others cannot meet.
    pub live: Vec<Pair>,
    pairs: Vec<Pair>,
    allowed: Vec<Aabb>,
    by_left_edge: Vec<u32>,
    near: Vec<bool>,
    at_border: Vec<bool>,
    fresh: bool,
}

impl Candidates {
    /// Whether a body is in any pair.
    pub fn has_neighbours(&self, body: usize) -> bool {
        self.near[body]
    }

    /// Whether a body may meet something or cross the border of a zone.
    pub fn is_near(&self, body: usize) -> bool {
        self.near[body] || self.at_border[body]
    }

    /// Something was added or moved by hand: the list has to be made anew.
    pub fn spoil(&mut self) {
        self.fresh = false;
    }
}

impl World {
    /// Makes sure that the list holds for the next `dt` seconds.
    pub(super) fn refresh_candidates(&mut self, dt: f64) {
        // Where there is nothing to meet and no border the list stays empty.
        let empty = !self.plan.contacts && !self.plan.streams;
        let holds = self.candidates.fresh
            && (empty
                || self.awake.iter().all(|&index| {
                    let i = index as usize;
                    let (body, law, allowed) = (&self.bodies[i], &self.laws[i], &self.candidates.allowed[i]);
                    let reach = body.velocity.abs() * dt + law.constant.abs() * (dt * dt);
                    let bounds = body.bounds();
                    allowed.contains(&Aabb::new(bounds.min - reach, bounds.max + reach), 0.0)
                }));
        if !holds {
            self.rebuild_candidates(dt);
        }
    }

    fn rebuild_candidates(&mut self, dt: f64) {
        let n = self.bodies.len();
        let list = &mut self.candidates;
        list.allowed.clear();
        list.allowed.extend(self.bodies.iter().zip(&self.laws).map(|(body, law)| {
            let reach = 2.0 * (body.velocity.abs() * dt + law.constant.abs() * (dt * dt)) + DVec2::splat(SKIN);
            let bounds = body.bounds();
            Aabb::new(bounds.min - reach, bounds.max + reach)
        }));
        list.pairs.clear();
        // Bodies against bodies: sweep along x.
        if list.by_left_edge.len() != n {
            list.by_left_edge.clear();
            list.by_left_edge.extend(0..n as u32);
        }
        let allowed = &list.allowed;
        list.by_left_edge
            .sort_unstable_by(|&i, &j| allowed[i as usize].min.x.total_cmp(&allowed[j as usize].min.x).then(i.cmp(&j)));
        let sweep: &[u32] = if self.plan.pairs { &list.by_left_edge } else { &[] };
        for (at, &i) in sweep.iter().enumerate() {
            for &j in &sweep[at + 1..] {
                if allowed[j as usize].min.x > allowed[i as usize].max.x {
                    break;
                }
                if allowed[i as usize].touches(&allowed[j as usize], 0.0) {
                    list.pairs.push(Pair { a: i.min(j), b: i.max(j) });
                }
            }
        }
        for (i, allowed) in allowed.iter().enumerate() {
            for (s, surface) in self.surfaces.iter().enumerate() {
                if allowed.touches(&surface.bounds, 0.0) {
                    list.pairs.push(Pair { a: i as u32, b: (n + s) as u32 });
                }
            }
        }
        list.pairs.sort_unstable();
        list.near.clear();
        list.near.resize(n, false);
        for pair in &list.pairs {
            list.near[pair.a as usize] = true;
            if let Some(near) = list.near.get_mut(pair.b as usize) {
                *near = true;
            }
        }
        list.at_border.clear();
        list.at_border.extend(list.allowed.iter().map(|allowed| {
            self.media.streams.iter().any(|stream| allowed.touches(&stream.zone, SLOP) && !stream.zone.contains(allowed, 0.0))
        }));
        list.fresh = true;
        self.list_live_pairs();
    }

    /// Lists the pairs of which not both rest.
    pub(super) fn list_live_pairs(&mut self) {
        let mut live = std::mem::take(&mut self.candidates.live);
        live.clear();
        live.extend(self.candidates.pairs.iter().filter(|pair| {
            let awake = |item: u32| !self.immovable(item) && !self.rests(item);
            awake(pair.a) || awake(pair.b)
        }));
        self.candidates.live = live;
    }
}
