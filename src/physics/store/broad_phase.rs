//! The broad phase: the bodies and surfaces that each body may meet.
//!
//! Each body owns a *fat box*: what it sweeps in this step, wider by a skin and by its way of the next steps (Box2D's fat AABBs). While it
//! stays inside, the list of bodies and surfaces whose boxes overlap the fat one holds; a body that leaves gets a new box and list. Both are
//! found in a grid whose cells are hashed, each in all cells that its box covers; those that cover many are tested one by one.

use crate::physics::data::body::Body;
use crate::physics::store::edges::{Edges, NOWHERE, contains, edges, overlap};
use crate::physics::store::motions::{MARGIN, Motions};
use glam::DVec2;

/// Skin of a fat box as a part of the mean half extent. Larger: more pairs to test; smaller: more new boxes.
const SKIN: f64 = 0.2;
/// Steps ahead for which a fat box is made. More: more pairs to test; fewer: more new boxes.
const HORIZON: f64 = 4.0;
/// Cells are this many times wider than the mean body.
const CELL: f64 = 2.0;
/// A box that covers more cells is tested one by one.
const MOST_CELLS: i64 = 64;
/// Up to this many bodies and surfaces all are tested one by one.
const FEW: usize = 32;
/// Pairs for which a body has room from the start.
const ROOM: usize = 16;

/// No entry follows.
const NONE: u32 = u32::MAX;

/// A body or surface in a cell, and the next one there.
#[derive(Clone, Copy, Debug)]
struct Entry {
    item: u32,
    next: u32,
}

/// The pairs that may meet, and what finds them.
#[derive(Clone, Debug, Default)]
pub(crate) struct BroadPhase {
    /// The fat box of each body, and after them where contacts with each surface are looked for while it stands.
    boxes: Vec<Edges>,
    /// Bodies and surfaces that overlap the fat box of each body; surfaces count on from the number of bodies.
    near: Vec<Vec<u32>>,
    /// Counts changes of the lists.
    pub revision: u64,
    per_metre: f64,
    skin: f64,
    heads: Vec<u32>,
    entries: Vec<Entry>,
    unused: Vec<u32>,
    /// Bodies and surfaces that are in no cell.
    large: Vec<u32>,
    /// When a body or surface was found last, by the number of the search.
    found: Vec<u32>,
    search: u32,
}

impl BroadPhase {
    pub fn new(bodies: &[Body], motions: &Motions) -> Self {
        let n = bodies.len();
        let mean = bodies.iter().map(|body| body.half.min_element()).sum::<f64>() / n.max(1) as f64;
        let mut boxes = vec![NOWHERE; n];
        boxes.extend(motions.surfaces.iter().map(|of| edges(of.from, of.half + MARGIN)));
        let all = boxes.len();
        let mut broad_phase = Self {
            boxes,
            near: vec![Vec::with_capacity(ROOM); n],
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

    /// Bodies and surfaces that a body may meet while it sweeps no more than its fat box.
    pub fn near(&self, i: usize) -> &[u32] {
        &self.near[i]
    }

    /// Makes sure that the lists of these bodies hold for what they sweep.
    pub fn update(&mut self, bodies: &[Body], motions: &Motions, of: &[u32], dt: f64) {
        for i in of.iter().map(|i| *i as usize) {
            if !contains(&self.boxes[i], &motions.swept[i]) {
                // Where free flight leads it in the next steps.
                let (velocity, ahead) = (bodies[i].velocity, HORIZON * dt);
                let gained = DVec2::new(0.0, 0.5 * ahead * (motions.bodies[i].free.1.y - velocity.y) / dt);
                self.renew(i, &motions.swept[i], ahead * (velocity + gained));
            }
        }
    }

    /// Gives a body a new fat box, wider by its way ahead (m), and finds what overlaps it.
    fn renew(&mut self, i: usize, swept: &Edges, DVec2 { x, y }: DVec2) {
        self.revision += 1;
        self.leave(i);
        let ([left, right, top, bottom], skin) = (*swept, self.skin);
        let mine = [left - skin + x.min(0.0), right + skin + x.max(0.0), top - skin + y.min(0.0), bottom + skin + y.max(0.0)];
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

    /// Takes a body out of its cells and of the lists of others.
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
            self.heads[head] = match self.unused.pop() {
                Some(at) => {
                    self.entries[at as usize] = entry;
                    at
                }
                None => {
                    self.entries.push(entry);
                    self.entries.len() as u32 - 1
                }
            };
        }
    }

    /// Lists the bodies and surfaces besides i whose boxes overlap `mine`.
    fn find(&mut self, mine: &Edges, i: usize, into: &mut Vec<u32>) {
        self.search = self.search.wrapping_add(1);
        self.found[i] = self.search;
        let Self { boxes, found, search, heads, entries, large, .. } = self;
        let mut test = |j: u32| {
            if std::mem::replace(&mut found[j as usize], *search) != *search && overlap(mine, &boxes[j as usize]) {
                into.push(j);
            }
        };
        let cells = Cells::of(mine, self.per_metre).filter(|_| boxes.len() > FEW);
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

    /// The cells of a box; none if it is large, or none yet.
    fn cells(&self, of: &Edges) -> Option<Cells> {
        Cells::of(of, self.per_metre).filter(|_| self.boxes.len() > FEW)
    }
}

/// A range of columns and rows.
#[derive(Clone, Copy)]
struct Cells {
    columns: (i64, i64),
    rows: (i64, i64),
}

impl Cells {
    /// None if there are too many, or none.
    fn of(edges: &Edges, per_metre: f64) -> Option<Self> {
        let [left, right, top, bottom] = edges.map(|edge| (edge * per_metre).floor() as i64);
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
    use crate::physics::data::aabb::Aabb;
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
                assert!(contains(&mine, &motions.swept[i]));
                let others = (0..n).filter(|&j| j != i && overlap(&mine, &broad_phase.boxes[j])).map(|j| j as u32);
                let fixed = (0..surfaces).filter(|&j| overlap(&mine, &broad_phase.boxes[n + j])).map(|j| (n + j) as u32);
                assert_eq!(found, others.chain(fixed).collect::<Vec<_>>());
            }
        }
    }
}
