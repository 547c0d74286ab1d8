//! Seeking all pairs anew: a uniform grid of centres filled by a counting sort (cells in rows, so that what one row has to offer is one
//! contiguous range); the boxes that are much larger than the rest are tested one by one. Surfaces are tested one by one when they are few,
//! else looked up in a grid of their own.

use crate::physics::store::bodies::Bodies;
use crate::physics::store::grid::{Edges, overlap};
use crate::physics::store::neighbours::{FEW_SURFACES, HORIZON, NONE, Neighbours};

/// Skin as a part of the mean half extent. Larger: more pairs to look at; smaller: more searches.
const SKIN: f64 = 0.2;
/// A box is large if it is this many times wider or higher than all but [`FEW`] of the boxes; those are tested against all.
const LARGE: f64 = 2.0;
const FEW: f64 = 1.0 / 64.0;
/// Fewer pairs a body than the first: look further ahead; more than the second: less far.
const PAIRS: (f64, f64) = (0.25, 4.0);
/// Up to so many bodies are tested one by one, without a grid.
const FEW_BODIES: usize = 96;
/// Where all of few bodies are sought anew step by step, one looks ahead only every so many times: what is fast leaves every box.
const OFTEN: u32 = 8;
/// The most cells of the surfaces' grid.
const MOST_CELLS: f64 = 65_536.0;

impl Neighbours {
    pub(crate) fn grid_surfaces(&mut self) {
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

    /// Renumbers the bodies, gives each a new allowed box, and finds all pairs that these let meet.
    pub fn search(&mut self, bodies: &mut Bodies, dt: f64) {
        self.revision += 1;
        bodies.renumber();
        let n = bodies.len();
        bodies.sweep_range(0, n);
        self.skin = SKIN * bodies.hx[..n].iter().zip(&bodies.hy[..n]).map(|(x, y)| x.min(*y)).sum::<f64>() / n.max(1) as f64;
        if self.surface_edges.is_empty() {
            let mean = |v: &[f64]| v[..n].iter().sum::<f64>() / n.max(1) as f64;
            self.drift = (mean(&bodies.vx), mean(&bodies.vy));
            self.fall = (mean(&bodies.free_vy) - self.drift.1) / dt;
            self.age = dt;
            bodies.shift = self.drifted(dt);
        }
        self.hurries = self.is_few(n) && self.updates <= 1 && !self.searches.is_multiple_of(OFTEN);
        (self.updates, self.searches) = (0, self.searches + 1);
        self.edges.clear();
        for i in 0..n {
            let edges = self.allow(bodies, i, dt);
            self.edges.push(edges);
        }
        if self.is_few(n) {
            self.large.clear();
            self.is_large.fill(false);
        } else {
            self.fill_grid(bodies);
        }
        self.left = 0;
        self.pair_up(n);
        let pairs = self.with.len() as f64 / n.max(1) as f64;
        if self.hurries {
            return;
        }
        if pairs < PAIRS.0 {
            self.horizon = (self.horizon * 2.0).min(HORIZON.1);
        } else if pairs > PAIRS.1 {
            self.horizon = (self.horizon * 0.5).max(HORIZON.0);
        }
    }

    /// Lists all pairs whose boxes overlap.
    pub(crate) fn pair_up(&mut self, n: usize) {
        self.listings += 1;
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
    }

    /// Gives a body a new allowed range of its centre, in which it sweeps now and in the next steps; returns its allowed box.
    pub(crate) fn allow(&self, bodies: &mut Bodies, i: usize, dt: f64) -> Edges {
        let ahead = if self.hurries { dt } else { self.horizon * dt };
        let (now, then) = (self.drifted((self.age - dt).max(0.0)), bodies.shift);
        let (x, px, y, py) = (bodies.x[i] - now.0, bodies.px[i] - then.0, bodies.y[i] - now.1, bodies.py[i] - then.1);
        let falling = self.drift.1 + self.fall * (self.age - dt).max(0.0);
        let (ax, ay) = (bodies.ax[i], (bodies.free_vy[i] - bodies.vy[i]) / dt);
        let far_x = x + ahead * (bodies.vx[i] - self.drift.0 + 0.5 * ahead * ax);
        let far_y = y + ahead * (bodies.vy[i] - falling + 0.5 * ahead * (ay - self.fall));
        // The longest ways of one step until then, of the body and of the boxes.
        let (way_x, way_y) = ((bodies.vx[i] + ahead * ax) * dt, (bodies.vy[i] + ahead * ay) * dt);
        let (wide, high) = Bodies::margins(
            (bodies.px[i] - bodies.x[i]).abs().max(way_x.abs()),
            (bodies.py[i] - bodies.y[i]).abs().max(way_y.abs()),
        );
        let (drift_x, drift_y) = (self.drift.0 * dt, (falling + self.fall * ahead) * dt);
        let (wide, high) = (wide + self.skin, high + self.skin);
        let (s, (dx, dy), hx, hy) = (bodies.swept[i], bodies.shift, bodies.hx[i], bodies.hy[i]);
        let left = (x.min(px).min(far_x) - wide - drift_x.max(0.0)).min(s[0] + hx - dx);
        let right = (x.max(px).max(far_x) + wide - drift_x.min(0.0)).max(s[1] - hx - dx);
        let top = (y.min(py).min(far_y) - high - drift_y.max(0.0)).min(s[2] + hy - dy);
        let bottom = (y.max(py).max(far_y) + high - drift_y.min(0.0)).max(s[3] - hy - dy);
        (bodies.allowed_left[i], bodies.allowed_right[i]) = (left, right);
        (bodies.allowed_top[i], bodies.allowed_bottom[i]) = (top, bottom);
        [left - hx, right + hx, top - hy, bottom + hy]
    }

    pub(crate) fn fill_grid(&mut self, bodies: &Bodies) {
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
    pub(crate) fn near_bodies(&mut self, i: usize) {
        let mine = self.edges[i];
        if self.is_large[i] || self.is_few(self.edges.len()) {
            return self.near_among(&mine, i);
        }
        for &j in &self.large {
            if (j as usize) < i && overlap(&mine, &self.edges[j as usize]) {
                self.near.push(j);
            }
        }
        self.near_in_grid(&mine, |j, _| j < i);
    }

    /// Whether all are tested one by one.
    pub(crate) fn is_few(&self, bodies: usize) -> bool {
        bodies <= FEW_BODIES
    }

    /// Collects those of so many bodies whose boxes overlap `mine`, without a branch for each.
    pub(crate) fn near_among(&mut self, mine: &Edges, count: usize) {
        let Self { edges, near, .. } = self;
        let mut found = near.len();
        near.resize(found + count, 0);
        for (j, other) in edges[..count].iter().enumerate() {
            near[found] = j as u32;
            found += usize::from(overlap(mine, other));
        }
        near.truncate(found);
    }

    /// Collects the bodies of the grid whose boxes overlap `mine`.
    #[inline(always)]
    pub(crate) fn near_in_grid(&mut self, mine: &Edges, take: impl Fn(usize, &[bool]) -> bool) {
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

    /// Collects the surfaces that overlap `mine`: one by one where that is less than the cells that it is in.
    pub(crate) fn near_surfaces(&mut self, mine: &Edges, n: usize) {
        let grid = &self.surfaces;
        let count = self.surface_edges.len();
        let few = count <= FEW_SURFACES || {
            let (wide, high) = (grid.column(mine[1]) - grid.column(mine[0]), grid.row(mine[3]) - grid.row(mine[2]));
            (wide + 1) * (high + 1) > count
        };
        if few {
            for (j, other) in self.surface_edges.iter().enumerate() {
                if overlap(mine, other) {
                    self.near.push((n + j) as u32);
                }
            }
            return;
        }
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
    use crate::random::Random;

    /// The grid finds exactly the pairs that testing all against all finds, giants and fast ones included.
    #[test]
    fn finds_what_brute_force_finds() {
        let (n, surfaces) = (300, 40);
        let mut bodies = Bodies::new(n, surfaces);
        let mut generator = Random(1);
        let mut random = || generator.unit();
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
