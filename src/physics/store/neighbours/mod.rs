//! Who may meet whom: the broad phase.
//!
//! Each body owns an *allowed box*: the box that it sweeps in the next few steps, and a skin. While all predicted boxes stay
//! inside, the pairs of overlapping allowed boxes are all that can touch. Bodies that leave theirs get a new one, and their pairs
//! are added; when many have left, all is sought anew. The search is a uniform grid of centres filled by a counting sort (cells
//! in rows, so that what one row has to offer is one contiguous range); the boxes that are much larger than the rest, and those
//! that were made since, are tested one by one. Surfaces never move: each is tested when they are few, else looked up in a grid
//! of their own. Without surfaces the boxes move along with the mean motion, so that a shower is sought seldom.

pub(crate) mod search;

use crate::physics::store::bodies::{Bodies, MARGIN, NOWHERE};
use crate::physics::store::grid::{Edges, Grid, overlap};

/// After this part of the bodies has left its box, all is sought anew.
const LEFT: f64 = 1.0 / 8.0;
/// The fewest and the most steps ahead for which the allowed boxes are made; in between as many as keep the pairs few.
const HORIZON: (f64, f64) = (8.0, 64.0);
/// Where more of few bodies than these leave their boxes at once, all pairs are listed anew.
const ONE_BY_ONE: usize = 8;
/// Up to this many surfaces are tested one by one.
const FEW_SURFACES: usize = 8;

/// A neighbour that was added after the last search.
#[derive(Clone, Copy, Debug)]
pub(crate) struct More {
    pub with: u32,
    pub next: u32,
}

/// Bodies that are asked together whether they sweep what is beyond.
const BLOCK: usize = 32;

/// No neighbour follows.
const NONE: u32 = u32::MAX;

/// The pairs that may meet, and what it takes to find them again.
#[derive(Clone, Debug, Default)]
pub(crate) struct Neighbours {
    /// Neighbours of body i: `with[start[i]..start[i + 1]]`, each a lower number or a surface.
    pub start: Vec<u32>,
    pub with: Vec<u32>,
    /// Neighbours added since: the first of body i is `more[first[i]]`, each knows the next.
    pub first: Vec<u32>,
    pub more: Vec<More>,
    /// The same for moving surfaces, found anew in every step; and whom those that move now may meet.
    moving: Vec<More>,
    first_moving: Vec<u32>,
    carried: Vec<u32>,
    /// The surfaces that move, by their numbers among all surfaces.
    movers: Vec<u32>,
    left: usize,
    /// Counts changes of the pairs, from 1 on, and how often all of them were listed anew.
    pub revision: u64,
    pub listings: u64,
    /// Mean velocity (m/s) and mean fall (m/s²) when all was sought, and how long ago that was, s.
    drift: (f64, f64),
    age: f64,
    fall: f64,
    horizon: f64,
    /// How many steps ago all was sought, how often that was, and whether only for the step then at hand.
    updates: u32,
    searches: u32,
    hurries: bool,
    skin: f64,
    /// Half the width and half the height of the largest boxes that are not large, m.
    reach: (f64, f64),
    edges: Vec<Edges>,
    sizes: Vec<f64>,
    cell_of: Vec<u32>,
    large: Vec<u32>,
    is_large: Vec<bool>,
    grid: Grid,
    surfaces: Grid,
    surface_edges: Vec<Edges>,
    near: Vec<u32>,
    /// Whose swept boxes reach beyond where their neighbours were sought.
    beyond: Vec<u32>,
}

impl Neighbours {
    /// For the bodies' surfaces, which never change.
    pub fn new(bodies: &Bodies) -> Self {
        let n = bodies.len();
        let mut new = Self {
            horizon: HORIZON.0,
            start: vec![0; n + 1],
            first: vec![NONE; n],
            first_moving: vec![NONE; n],
            is_large: vec![false; n],
            ..Self::default()
        };
        for j in n..bodies.x.len() {
            // The very box in which contacts of a step are looked for: who is near must not depend on how far ahead others were sought.
            let (x, y, hx, hy) = (bodies.x[j], bodies.y[j], bodies.hx[j] + MARGIN, bodies.hy[j] + MARGIN);
            new.surface_edges.push([x - hx, x + hx, y - hy, y + hy]);
        }
        if new.surface_edges.len() > FEW_SURFACES {
            new.grid_surfaces();
        }
        new
    }

    /// The neighbours of body i, each a lower number or a surface: those of the last search, in ascending order, and in `later` what was
    /// added since.
    #[inline(always)]
    pub fn of(&self, i: usize, later: &mut Vec<u32>) -> &[u32] {
        later.clear();
        if self.first[i] != NONE || !self.moving.is_empty() {
            self.add_later(i, later);
        }
        &self.with[self.start[i] as usize..self.start[i + 1] as usize]
    }

    fn add_later(&self, i: usize, later: &mut Vec<u32>) {
        let mut at = self.first[i];
        while let Some(more) = self.more.get(at as usize) {
            at = more.next;
            later.push(more.with);
        }
        let mut at = if self.moving.is_empty() { NONE } else { self.first_moving[i] };
        while let Some(more) = self.moving.get(at as usize) {
            at = more.next;
            later.push(more.with);
        }
    }

    /// Whether nobody has any neighbour.
    pub fn is_empty(&self) -> bool {
        self.with.is_empty() && self.more.is_empty() && self.moving.is_empty()
    }

    /// Whether the pairs are those of a revision. Those of moving surfaces are new in every step.
    pub fn is_as_in(&self, revision: u64) -> bool {
        self.revision == revision && self.moving.is_empty()
    }

    /// Whether what is listed besides what was added is that of a listing, and no surface may be among it that moves.
    pub fn are_listed_as_in(&self, listing: u64) -> bool {
        self.listings == listing && self.movers.is_empty()
    }

    /// A surface moves from now on: it is no longer among those that stand.
    pub fn set_moving(&mut self, surface: usize) {
        self.surface_edges[surface] = NOWHERE;
        // All is sought anew, so that nobody has it among the neighbours that last.
        self.edges.clear();
    }

    /// Finds who may touch surfaces that move, by the boxes that all sweep in this step.
    pub fn find_moving(&mut self, bodies: &Bodies, surfaces: &[u32]) {
        self.moving.clear();
        self.carried.clear();
        self.movers.clear();
        self.movers.extend_from_slice(surfaces);
        if surfaces.is_empty() {
            return;
        }
        let n = bodies.len();
        self.first_moving.fill(NONE);
        for &j in surfaces {
            let mine = bodies.swept[n + j as usize];
            let carries = bodies.carries(n + j as usize);
            for i in 0..n {
                if overlap(&mine, &bodies.swept[i]) {
                    if carries {
                        self.carried.push(i as u32);
                    }
                    self.moving.push(More { with: n as u32 + j, next: self.first_moving[i] });
                    self.first_moving[i] = self.moving.len() as u32 - 1;
                }
            }
        }
    }

    /// Whom surfaces may meet that move, some more than once.
    pub fn carried(&self) -> &[u32] {
        &self.carried
    }

    /// Whether the boxes in which neighbours were sought stay where they are.
    pub fn stand(&self) -> bool {
        !self.surface_edges.is_empty()
    }

    /// Lets bodies into all of what they sweep, without numbering anything anew.
    pub fn follow(&mut self, bodies: &mut Bodies, slots: &[u32]) {
        let all_anew = slots.len() > ONE_BY_ONE && self.is_few(bodies.len());
        for &i in slots {
            let i = i as usize;
            let (s, (dx, dy), hx, hy) = (bodies.swept[i], bodies.shift, bodies.hx[i], bodies.hy[i]);
            bodies.allowed_left[i] = bodies.allowed_left[i].min(s[0] + hx - dx);
            bodies.allowed_right[i] = bodies.allowed_right[i].max(s[1] - hx - dx);
            bodies.allowed_top[i] = bodies.allowed_top[i].min(s[2] + hy - dy);
            bodies.allowed_bottom[i] = bodies.allowed_bottom[i].max(s[3] - hy - dy);
            let (left, right) = (bodies.allowed_left[i] - hx, bodies.allowed_right[i] + hx);
            self.left += 1;
            let mine = [left, right, bodies.allowed_top[i] - hy, bodies.allowed_bottom[i] + hy];
            if all_anew {
                self.edges[i] = mine;
            } else {
                self.add(bodies, i, mine);
            }
        }
        if all_anew {
            self.revision += 1;
            self.pair_up(bodies.len());
        }
    }

    /// Makes sure that all pairs that these bodies can touch on what they sweep now are known. Returns false where all have to be sought anew.
    pub fn update(&mut self, bodies: &mut Bodies, slots: &[u32], dt: f64) -> bool {
        let n = bodies.len();
        self.updates += 1;
        let mut beyond = std::mem::take(&mut self.beyond);
        beyond.clear();
        for block in slots.chunks(BLOCK) {
            // Without a branch for each: hardly anybody is.
            if !block.iter().fold(true, |all, i| all & bodies.sweeps_where_neighbours_are(*i as usize)) {
                beyond.extend(block.iter().filter(|i| !bodies.sweeps_where_neighbours_are(**i as usize)));
            }
        }
        // What leaves its box again and again is found one by one: only the pairs that it leaves behind make all slower.
        self.left += beyond.iter().filter(|i| !self.is_large[**i as usize]).count();
        let few = self.left <= (n as f64 * LEFT) as usize && self.more.len() <= n && self.edges.len() == n;
        if few {
            for &i in &beyond {
                let mine = self.allow(bodies, i as usize, dt);
                self.add(bodies, i as usize, mine);
            }
        }
        self.beyond = beyond;
        few
    }

    /// Moves the allowed boxes along for a step of `dt` seconds.
    pub fn drift(&mut self, bodies: &mut Bodies, dt: f64) {
        if self.surface_edges.is_empty() {
            self.age += dt;
            bodies.shift = self.drifted(self.age);
        }
    }

    fn drifted(&self, age: f64) -> (f64, f64) {
        (self.drift.0 * age, (self.drift.1 + 0.5 * self.fall * age) * age)
    }

    /// Gives a body that has left its box a new one, and adds the pairs that this lets meet.
    fn add(&mut self, bodies: &Bodies, i: usize, mine: Edges) {
        let before = std::mem::replace(&mut self.edges[i], mine);
        self.revision += 1;
        self.find_near_body(&mine, i);
        if !self.is_large[i] {
            self.is_large[i] = true;
            self.large.push(i as u32);
        }
        let bodies_near = self.near.len();
        self.near_surfaces(&mine, bodies.len());
        for k in 0..self.near.len() {
            let j = self.near[k];
            let other = self.edges.get(j as usize).unwrap_or_else(|| &self.surface_edges[j as usize - bodies.len()]);
            // Pairs of boxes that overlap are known.
            if overlap(&before, other) {
                continue;
            }
            let (upper, lower) = if k >= bodies_near || (j as usize) < i { (i, j) } else { (j as usize, i as u32) };
            if !self.knows(upper, lower) {
                self.more.push(More { with: lower, next: self.first[upper] });
                self.first[upper] = self.more.len() as u32 - 1;
            }
        }
    }

    /// Collects the bodies besides i whose boxes overlap `mine`.
    fn find_near_body(&mut self, mine: &Edges, i: usize) {
        self.near.clear();
        if self.is_few(self.edges.len()) {
            self.near_among(mine, self.edges.len());
            self.near.retain(|j| *j as usize != i);
            return;
        }
        self.near_in_grid(mine, |j, is_large| !is_large[j] && j != i);
        for &j in &self.large {
            if j as usize != i && overlap(mine, &self.edges[j as usize]) {
                self.near.push(j);
            }
        }
    }

    /// Who may be where body i sweeps, if neighbours were sought there: bodies and surfaces.
    pub fn near_swept(&mut self, bodies: &Bodies, i: usize) -> &[u32] {
        self.find_near_body(&bodies.swept[i], i);
        &self.near
    }

    fn knows(&self, i: usize, other: u32) -> bool {
        if self.with[self.start[i] as usize..self.start[i + 1] as usize].contains(&other) {
            return true;
        }
        let mut at = self.first[i];
        while at != NONE {
            let more = &self.more[at as usize];
            if more.with == other {
                return true;
            }
            at = more.next;
        }
        false
    }
}
