//! Who may meet whom: the broad phase.
//!
//! Each body owns an *allowed box*: the box that it sweeps in the next few steps, and a skin. While all predicted boxes stay
//! inside, the pairs of overlapping allowed boxes are all that can touch. Bodies that leave theirs get a new one, and their pairs
//! are added; when many have left, all is sought anew. The search is a uniform grid of centres filled by a counting sort (cells
//! in rows, so that what one row has to offer is one contiguous range); the boxes that are much larger than the rest, and those
//! that were made since, are tested one by one. Surfaces never move: each is tested when they are few, else looked up in a grid
//! of their own. Without surfaces the boxes move along with the mean motion, so that a shower is sought seldom.

use super::bodies::{Bodies, MARGIN, NOWHERE};
use super::grid::{Edges, Grid, overlap};

/// Skin as a part of the mean half extent. Larger: more pairs to look at; smaller: more searches.
const SKIN: f64 = 0.3;
/// A box is large if it is this many times wider or higher than all but [`FEW`] of the boxes; those are tested against all.
const LARGE: f64 = 2.0;
const FEW: f64 = 1.0 / 64.0;
/// After this part of the bodies has left its box, all is sought anew.
const LEFT: f64 = 1.0 / 24.0;
/// The fewest and the most steps ahead for which the allowed boxes are made; in between as many as keep the pairs few.
const HORIZON: (f64, f64) = (4.0, 64.0);
/// Fewer pairs a body than the first: look further ahead; more than the second: less far.
const PAIRS: (f64, f64) = (0.25, 4.0);
/// Up to this many surfaces are tested one by one.
const FEW_SURFACES: usize = 8;
/// The most cells of the surfaces' grid.
const MOST_CELLS: f64 = 65_536.0;

/// A neighbour that was added after the last search.
#[derive(Clone, Copy, Debug)]
pub(super) struct More {
    pub with: u32,
    pub next: u32,
}

/// No neighbour follows.
const NONE: u32 = u32::MAX;

/// The pairs that may meet, and what it takes to find them again.
#[derive(Clone, Debug, Default)]
pub(super) struct Neighbours {
    /// Neighbours of body i: `with[start[i]..start[i + 1]]`, each a lower number or a surface.
    pub start: Vec<u32>,
    pub with: Vec<u32>,
    /// Neighbours added since: the first of body i is `more[first[i]]`, each knows the next.
    pub first: Vec<u32>,
    pub more: Vec<More>,
    /// The same for moving surfaces, found anew in every step.
    moving: Vec<More>,
    first_moving: Vec<u32>,
    left: usize,
    /// Counts changes of the pairs, from 1 on.
    pub revision: u64,
    /// Mean velocity (m/s) and mean fall (m/s²) when all was sought, and how long ago that was, s.
    drift: (f64, f64),
    age: f64,
    fall: f64,
    horizon: f64,
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

    fn grid_surfaces(&mut self) {
        let all = self.surface_edges.iter().fold([f64::MAX, f64::MIN, f64::MAX, f64::MIN], |a, e| {
            [a[0].min(e[0]), a[1].max(e[1]), a[2].min(e[2]), a[3].max(e[3])]
        });
        let mean = self.surface_edges.iter().map(|e| (e[1] - e[0]).min(e[3] - e[2])).sum::<f64>() / self.surface_edges.len() as f64;
        self.surfaces.lay(all, 2.0 * mean, MOST_CELLS);
        let grid = &mut self.surfaces;
        for pass in 0..2 {
            for (j, e) in self.surface_edges.iter().enumerate().rev() {
                for row in grid.row(e[2])..=grid.row(e[3]) {
                    for column in grid.column(e[0])..=grid.column(e[1]) {
                        let cell = row * grid.columns + column;
                        if pass == 0 {
                            grid.start[cell] += 1;
                        } else {
                            grid.start[cell] -= 1;
                            grid.items[grid.start[cell] as usize] = j as u32;
                        }
                    }
                }
            }
            if pass == 0 {
                grid.sum_up();
            }
        }
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

    /// Whether all has to be sought anew.
    pub fn is_stale(&self, bodies: &Bodies) -> bool {
        self.edges.len() != bodies.len()
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
        if surfaces.is_empty() {
            return;
        }
        let n = bodies.len();
        self.first_moving.fill(NONE);
        for &j in surfaces {
            let mine = bodies.swept[n + j as usize];
            for i in 0..n {
                if overlap(&mine, &bodies.swept[i]) {
                    self.moving.push(More { with: n as u32 + j, next: self.first_moving[i] });
                    self.first_moving[i] = self.moving.len() as u32 - 1;
                }
            }
        }
    }

    /// Lets bodies into all of what they sweep, without numbering anything anew.
    pub fn follow(&mut self, bodies: &mut Bodies, slots: &[u32]) {
        for &i in slots {
            let i = i as usize;
            let (s, (dx, dy), hx, hy) = (bodies.swept[i], bodies.shift, bodies.hx[i], bodies.hy[i]);
            bodies.allowed_left[i] = bodies.allowed_left[i].min(s[0] + hx - dx);
            bodies.allowed_right[i] = bodies.allowed_right[i].max(s[1] - hx - dx);
            bodies.allowed_top[i] = bodies.allowed_top[i].min(s[2] + hy - dy);
            bodies.allowed_bottom[i] = bodies.allowed_bottom[i].max(s[3] - hy - dy);
            let (left, right) = (bodies.allowed_left[i] - hx, bodies.allowed_right[i] + hx);
            self.left += 1;
            self.add(bodies, i, [left, right, bodies.allowed_top[i] - hy, bodies.allowed_bottom[i] + hy]);
        }
    }

    /// Makes sure that all pairs that can touch on the predicted ways are known. Returns whether the bodies were renumbered.
    pub fn update(&mut self, bodies: &mut Bodies, dt: f64) -> bool {
        let n = bodies.len();
        let most = (n as f64 * LEFT) as usize;
        if self.edges.len() == n {
            for i in 0..n {
                if bodies.is_allowed(i) {
                    continue;
                }
                self.left += 1;
                if self.left > most {
                    break;
                }
                let mine = self.allow(bodies, i, dt);
                self.add(bodies, i, mine);
            }
        }
        let all = self.left > most || self.edges.len() != n;
        if all {
            self.search(bodies, dt);
        }
        all
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
        self.edges[i] = mine;
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
        self.near_in_grid(mine, |j, is_large| !is_large[j] && j != i);
        for &j in &self.large {
            if j as usize != i && overlap(mine, &self.edges[j as usize]) {
                self.near.push(j);
            }
        }
    }

    /// Who may be where body i sweeps, bodies and surfaces. Lets the body into all of that.
    pub fn reach(&mut self, bodies: &mut Bodies, i: usize) -> &[u32] {
        if bodies.is_allowed(i) {
            let (s, (dx, dy)) = (bodies.swept[i], bodies.shift);
            let mine = [s[0] - dx, s[1] - dx, s[2] - dy, s[3] - dy];
            self.find_near_body(&mine, i);
            self.near_surfaces(&mine, bodies.len());
        } else {
            self.follow(bodies, &[i as u32]);
        }
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

    /// Renumbers the bodies, gives each a new allowed box, and finds all pairs that these let meet.
    pub fn search(&mut self, bodies: &mut Bodies, dt: f64) {
        self.revision += 1;
        bodies.renumber();
        let n = bodies.len();
        self.skin = SKIN * bodies.hx[..n].iter().zip(&bodies.hy[..n]).map(|(x, y)| x.min(*y)).sum::<f64>() / n.max(1) as f64;
        if self.surface_edges.is_empty() {
            let mean = |v: &[f64]| v[..n].iter().sum::<f64>() / n.max(1) as f64;
            self.drift = (mean(&bodies.vx), mean(&bodies.vy));
            self.fall = (mean(&bodies.free_vy) - self.drift.1) / dt;
            self.age = dt;
            bodies.shift = self.drifted(dt);
        }
        self.edges.clear();
        for i in 0..n {
            let edges = self.allow(bodies, i, dt);
            self.edges.push(edges);
        }
        self.fill_grid(bodies);
        self.left = 0;
        self.more.clear();
        self.first.fill(NONE);
        self.with.clear();
        for i in 0..n {
            self.start[i] = self.with.len() as u32;
            self.near.clear();
            self.near_bodies(i);
            let mine = self.edges[i];
            self.near_surfaces(&mine, n);
            self.near.sort_unstable();
            self.with.extend_from_slice(&self.near);
        }
        self.start[n] = self.with.len() as u32;
        let pairs = self.with.len() as f64 / n.max(1) as f64;
        if pairs < PAIRS.0 {
            self.horizon = (self.horizon * 2.0).min(HORIZON.1);
        } else if pairs > PAIRS.1 {
            self.horizon = (self.horizon * 0.5).max(HORIZON.0);
        }
    }

    /// Gives a body a new allowed range of its centre; returns its allowed box.
    fn allow(&self, bodies: &mut Bodies, i: usize, dt: f64) -> Edges {
        let ahead = self.horizon * dt;
        let (now, then) = (self.drifted((self.age - dt).max(0.0)), bodies.shift);
        let (x, px, y, py) = (bodies.x[i] - now.0, bodies.px[i] - then.0, bodies.y[i] - now.1, bodies.py[i] - then.1);
        let falling = self.drift.1 + self.fall * (self.age - dt).max(0.0);
        let far_x = x + ahead * (bodies.vx[i] - self.drift.0 + 0.5 * ahead * bodies.ax[i]);
        let far_y = y + ahead * (bodies.vy[i] - falling + 0.5 * ahead * ((bodies.free_vy[i] - bodies.vy[i]) / dt - self.fall));
        let (left, right) = (x.min(px).min(far_x) - self.skin, x.max(px).max(far_x) + self.skin);
        let (top, bottom) = (y.min(py).min(far_y) - self.skin, y.max(py).max(far_y) + self.skin);
        (bodies.allowed_left[i], bodies.allowed_right[i]) = (left, right);
        (bodies.allowed_top[i], bodies.allowed_bottom[i]) = (top, bottom);
        let (hx, hy) = (bodies.hx[i], bodies.hy[i]);
        [left - hx, right + hx, top - hy, bottom + hy]
    }

    fn fill_grid(&mut self, bodies: &Bodies) {
        let n = bodies.len();
        let size = |e: &Edges| (e[1] - e[0]).max(e[3] - e[2]);
        self.sizes.clear();
        self.sizes.extend(self.edges.iter().map(size));
        let nearly_all = n - 1 - (n as f64 * FEW) as usize;
        let large = LARGE * *self.sizes.select_nth_unstable_by(nearly_all, f64::total_cmp).1;
        self.large.clear();
        let mut area = [f64::MAX, f64::MIN, f64::MAX, f64::MIN];
        self.reach = (0.0, 0.0);
        let mut sum = 0.0;
        for (i, e) in self.edges.iter().enumerate() {
            self.is_large[i] = size(e) > large;
            if self.is_large[i] {
                self.large.push(i as u32);
            } else {
                self.reach = (self.reach.0.max(0.5 * (e[1] - e[0])), self.reach.1.max(0.5 * (e[3] - e[2])));
                sum += (e[1] - e[0]).min(e[3] - e[2]);
                let (x, y) = (0.5 * (e[0] + e[1]), 0.5 * (e[2] + e[3]));
                area = [area[0].min(x), area[1].max(x), area[2].min(y), area[3].max(y)];
            }
        }
        if self.large.len() == n {
            area = [0.0; 4];
        }
        let cell = sum / (n - self.large.len()).max(1) as f64;
        self.grid.lay(area, cell, (4 * n + 64) as f64);
        self.cell_of.clear();
        for (i, e) in self.edges.iter().enumerate() {
            let cell = self.grid.row(0.5 * (e[2] + e[3])) * self.grid.columns + self.grid.column(0.5 * (e[0] + e[1]));
            self.cell_of.push(cell as u32);
            self.grid.start[cell] += u32::from(!self.is_large[i]);
        }
        self.grid.sum_up();
        for i in (0..n).rev() {
            if !self.is_large[i] {
                let cell = self.cell_of[i] as usize;
                self.grid.start[cell] -= 1;
                self.grid.items[self.grid.start[cell] as usize] = i as u32;
            }
        }
    }

    /// Collects the lower bodies near body i.
    fn near_bodies(&mut self, i: usize) {
        let mine = self.edges[i];
        if self.is_large[i] {
            let near = self.edges[..i].iter().enumerate().filter(|(_, other)| overlap(&mine, other)).map(|(j, _)| j as u32);
            self.near.extend(near);
            return;
        }
        for &j in &self.large {
            if (j as usize) < i && overlap(&mine, &self.edges[j as usize]) {
                self.near.push(j);
            }
        }
        self.near_in_grid(&mine, |j, _| j < i);
    }

    /// Collects the bodies of the grid whose boxes overlap `mine`.
    #[inline(always)]
    fn near_in_grid(&mut self, mine: &Edges, take: impl Fn(usize, &[bool]) -> bool) {
        let Self { grid, edges, near, is_large, reach, .. } = self;
        let (from, to) = (grid.column(mine[0] - reach.0), grid.column(mine[1] + reach.0));
        for row in grid.row(mine[2] - reach.1)..=grid.row(mine[3] + reach.1) {
            let at = row * grid.columns;
            for &j in &grid.items[grid.start[at + from] as usize..grid.start[at + to + 1] as usize] {
                if take(j as usize, is_large) && overlap(mine, &edges[j as usize]) {
                    near.push(j);
                }
            }
        }
    }

    /// Collects the surfaces that overlap `mine`.
    fn near_surfaces(&mut self, mine: &Edges, n: usize) {
        if self.surface_edges.len() <= FEW_SURFACES {
            for (j, other) in self.surface_edges.iter().enumerate() {
                if overlap(mine, other) {
                    self.near.push((n + j) as u32);
                }
            }
            return;
        }
        let grid = &self.surfaces;
        let known = self.near.len();
        for row in grid.row(mine[2])..=grid.row(mine[3]) {
            for column in grid.column(mine[0])..=grid.column(mine[1]) {
                let cell = row * grid.columns + column;
                for &j in &grid.items[grid.start[cell] as usize..grid.start[cell + 1] as usize] {
                    let j = n as u32 + j;
                    if overlap(mine, &self.surface_edges[j as usize - n]) && !self.near[known..].contains(&j) {
                        self.near.push(j);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The grid finds exactly the pairs that testing all against all finds, giants and fast ones included.
    #[test]
    fn finds_what_brute_force_finds() {
        let (n, surfaces) = (300, 40);
        let mut bodies = Bodies::new(n, surfaces);
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 33) as f64 / (1u64 << 31) as f64
        };
        for i in 0..n + surfaces {
            (bodies.x[i], bodies.y[i]) = (20.0 * random(), 20.0 * random());
            let size = if i % 50 == 0 { 6.0 } else { 0.4 };
            (bodies.hx[i], bodies.hy[i]) = (size * (0.2 + random()), size * (0.2 + random()));
            if i < n {
                bodies.vx[i] = if i % 40 == 7 { 3000.0 } else { random() };
                (bodies.px[i], bodies.py[i]) = (bodies.x[i], bodies.y[i]);
            }
        }
        let mut neighbours = Neighbours::new(&bodies);
        neighbours.search(&mut bodies, 0.01);
        let surface_edges = neighbours.surface_edges.clone();
        for i in 0..n {
            let mut found = neighbours.with[neighbours.start[i] as usize..neighbours.start[i + 1] as usize].to_vec();
            found.sort_unstable();
            let mine = neighbours.edges[i];
            let lower = (0..i).filter(|&j| overlap(&mine, &neighbours.edges[j])).map(|j| j as u32);
            let fixed = (0..surfaces).filter(|&j| overlap(&mine, &surface_edges[j])).map(|j| (n + j) as u32);
            assert_eq!(found, lower.chain(fixed).collect::<Vec<_>>());
        }
    }
}
