//! The broad phase: the bodies and surfaces that each body may meet.
//!
//! Each body owns a *fat box* (Box2D's fat AABBs); the list of bodies and surfaces whose boxes overlap it holds while the body stays inside.
//! Both are found in a hashed grid, each in all cells that its box covers; boxes that cover many cells are tested one by one.

use crate::physics::data::{Aabb, Body, NONE};
use crate::physics::store::motions::{MARGIN, Motions};
use glam::DVec2;

/// Skin of a fat box as a part of the mean half extent. Larger: more pairs to test; smaller: more new boxes.
const SKIN: f64 = 0.2;
/// Steps ahead for which a fat box is made. More: more pairs to test; fewer: more new boxes.
const HORIZON: f64 = 4.0;
/// Cells are this many times wider than the mean body.
const CELL: f64 = 2.0;
const MOST_CELLS: i64 = 64;
/// Up to this many bodies and surfaces all are tested one by one.
const FEW: usize = 32;
/// Pairs for which a body has room from the start.
const ROOM: usize = 16;

#[derive(Clone, Copy, Debug)]
struct Entry {
    item: u32,
    next: u32,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct BroadPhase {
    /// The fat box of each body, and behind them the boxes of surfaces.
    boxes: Vec<Aabb>,
    /// The items that overlap the fat box of each body; surfaces count on from the number of bodies.
    near: Vec<Vec<u32>>,
    pub revision: u64,
    per_metre: f64,
    skin: f64,
    heads: Vec<u32>,
    entries: Vec<Entry>,
    unused: Vec<u32>,
    large: Vec<u32>,
    found: Vec<u32>,
    search: u32,
}

impl BroadPhase {
    pub fn new(bodies: &[Body], motions: &Motions) -> Self {
        let n = bodies.len();
        let mean = bodies.iter().map(|body| body.half.min_element()).sum::<f64>() / n.max(1) as f64;
        let mut boxes = vec![Aabb::NOWHERE; n];
        boxes.extend(motions.surfaces.iter().map(|of| Aabb::around(of.from, of.half + MARGIN)));
        let all = boxes.len();
        let mut broad_phase = Self {
            boxes,
            near: (0..n).map(|_| Vec::with_capacity(ROOM)).collect(),
            per_metre: 1.0 / (CELL * 2.0 * mean).max(1e-6),
            skin: SKIN * mean,
            heads: vec![NONE; (4 * all).next_power_of_two().max(64)],
            entries: Vec::with_capacity(8 * all),
            found: vec![0; all],
            ..Self::default()
        };
        (n..all).for_each(|surface| broad_phase.enter(surface));
        broad_phase
    }

    pub fn near(&self, i: usize) -> &[u32] {
        &self.near[i]
    }

    /// Gives those of the bodies new boxes that sweep more than theirs.
    pub fn update(&mut self, bodies: &[Body], motions: &Motions, of: &[u32], dt: f64) {
        for i in of.iter().map(|i| *i as usize) {
            if !self.boxes[i].contains(&motions.swept[i], 0.0) {
                let (velocity, ahead) = (bodies[i].velocity, HORIZON * dt);
                let gained = DVec2::new(0.0, 0.5 * ahead * (motions.bodies[i].free.1.y - velocity.y) / dt);
                self.renew(i, motions.swept[i], ahead * (velocity + gained));
            }
        }
    }

    fn renew(&mut self, i: usize, Aabb { min, max }: Aabb, ahead: DVec2) {
        self.revision += 1;
        self.leave(i);
        let mine = Aabb::new(min - self.skin + ahead.min(DVec2::ZERO), max + self.skin + ahead.max(DVec2::ZERO));
        self.boxes[i] = mine;
        let mut near = std::mem::take(&mut self.near[i]);
        self.find(&mine, i, &mut near);
        for &j in &near {
            if let Some(list) = self.near.get_mut(j as usize) {
                list.push(i as u32);
            }
        }
        self.near[i] = near;
        self.enter(i);
    }

    fn leave(&mut self, i: usize) {
        let mut near = std::mem::take(&mut self.near[i]);
        for j in near.drain(..) {
            if let Some(list) = self.near.get_mut(j as usize) {
                list.retain(|other| *other as usize != i);
            }
        }
        self.near[i] = near;
        let Some(cells) = self.cells(&self.boxes[i]) else {
            return self.large.retain(|other| *other as usize != i);
        };
        for head in cells.all(self.heads.len()) {
            let mut at = self.heads[head];
            let mut before = NONE;
            while let Some(&Entry { item, next }) = self.entries.get(at as usize) {
                if item as usize == i {
                    match self.entries.get_mut(before as usize) {
                        Some(entry) => entry.next = next,
                        None => self.heads[head] = next,
                    }
                    self.unused.push(at);
                    break;
                }
                (before, at) = (at, next);
            }
        }
    }

    fn enter(&mut self, i: usize) {
        let Some(cells) = self.cells(&self.boxes[i]) else {
            return self.large.push(i as u32);
        };
        for head in cells.all(self.heads.len()) {
            let entry = Entry { item: i as u32, next: self.heads[head] };
            let at = self.unused.pop().unwrap_or(self.entries.len() as u32);
            match self.entries.get_mut(at as usize) {
                Some(unused) => *unused = entry,
                None => self.entries.push(entry),
            }
            self.heads[head] = at;
        }
    }

    fn find(&mut self, mine: &Aabb, i: usize, into: &mut Vec<u32>) {
        self.search = self.search.wrapping_add(1);
        self.found[i] = self.search;
        let cells = self.cells(mine);
        let Self { boxes, found, search, heads, entries, large, .. } = self;
        let mut test = |j: u32| {
            if std::mem::replace(&mut found[j as usize], *search) != *search && mine.meets(&boxes[j as usize]) {
                into.push(j);
            }
        };
        let Some(cells) = cells else {
            return (0..boxes.len() as u32).for_each(test);
        };
        large.iter().for_each(|j| test(*j));
        for head in cells.all(heads.len()) {
            let mut at = heads[head];
            while let Some(entry) = entries.get(at as usize) {
                test(entry.item);
                at = entry.next;
            }
        }
    }

    fn cells(&self, of: &Aabb) -> Option<Cells> {
        Cells::of(of, self.per_metre).filter(|_| self.boxes.len() > FEW)
    }
}

#[derive(Clone, Copy)]
struct Cells {
    columns: (i64, i64),
    rows: (i64, i64),
}

impl Cells {
    fn of(bounds: &Aabb, per_metre: f64) -> Option<Self> {
        let cell = |edge: f64| (edge * per_metre).floor() as i64;
        let [left, right] = [bounds.min.x, bounds.max.x].map(cell);
        let [top, bottom] = [bounds.min.y, bounds.max.y].map(cell);
        let count = (right.saturating_sub(left).saturating_add(1)).saturating_mul(bottom.saturating_sub(top).saturating_add(1));
        (right >= left && count <= MOST_CELLS).then_some(Self { columns: (left, right), rows: (top, bottom) })
    }

    /// Their places among the lists, whose number is a power of two. Two cells may share one.
    fn all(&self, lists: usize) -> impl Iterator<Item = usize> + use<> {
        let (Self { columns, rows }, mask) = (*self, lists - 1);
        (rows.0..=rows.1).flat_map(move |row| {
            let row = row.wrapping_mul(0x9E37_79B9_7F4A_7C15_u64 as i64);
            (columns.0..=columns.1).map(move |column| (row ^ column.wrapping_mul(0x2545_F491_4F6C_DD1D)) as usize >> 7 & mask)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::data::material::Material;
    use crate::physics::data::surface::{Surface, SurfaceDef};
    use crate::physics::forces::media::Media;
    use crate::random::Random;

    /// The lists are those that testing all against all gives, giants and fast ones included, however often boxes change.
    #[test]
    fn finds_what_brute_force_finds() {
        let (n, surfaces) = (300, 40);
        let mut generator = Random(1);
        let mut random = || generator.unit();
        let mut place = |k: usize| {
            let size = if k.is_multiple_of(50) { 6.0 } else { 0.4 };
            (DVec2::new(20.0 * random(), 20.0 * random()), DVec2::new(size * (0.2 + random()), size * (0.2 + random())))
        };
        let body = |(position, half)| Body { position, half, ..Body::default() };
        let mut bodies: Vec<Body> = (0..n).map(|i| body(place(i))).collect();
        let fixed = |(centre, half)| SurfaceDef::fixed(Aabb::around(centre, half), Material::WOOD);
        let fixed: Vec<Surface> = (n..n + surfaces).map(|k| Surface::new(fixed(place(k)))).collect();
        let media = Media::new(0.0, 0.0, (&[], &[]), Vec::new());
        let mut motions = Motions::new(&bodies, &fixed, &media);
        let mut broad_phase = BroadPhase::new(&bodies, &motions);
        let all: Vec<u32> = (0..n as u32).collect();
        for _ in 0..20 {
            for (i, body) in bodies.iter_mut().enumerate() {
                body.velocity.x = if i % 40 == 7 { 3000.0 } else { 4.0 * generator.unit() - 2.0 };
                body.position.x += 0.1 * body.velocity.x.min(2.0);
            }
            motions.fly(&bodies, &all, 0.01);
            broad_phase.update(&bodies, &motions, &all, 0.01);
            for i in 0..n {
                let mut found = broad_phase.near(i).to_vec();
                found.sort_unstable();
                let mine = broad_phase.boxes[i];
                assert!(mine.contains(&motions.swept[i], 0.0));
                let others = (0..n).filter(|&j| j != i && mine.meets(&broad_phase.boxes[j])).map(|j| j as u32);
                let fixed = (0..surfaces).filter(|&j| mine.meets(&broad_phase.boxes[n + j])).map(|j| (n + j) as u32);
                assert_eq!(found, others.chain(fixed).collect::<Vec<_>>());
            }
        }
    }
}
