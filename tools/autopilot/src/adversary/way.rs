//! Ways for the ship through a level's free space: how far each place is from a goal, on a grid of the places where the ship's centre can be.

use resultant::level::{Level, SHIP_HALF};
use resultant::physics::{Aabb, DVec2};
use std::collections::VecDeque;

/// The grid's cells, m: fine enough for gaps that the ship fits through with half a metre to spare.
const CELL: f64 = 0.5;
/// Distance of ways from deadly things, m.
const OFF_RED: f64 = 0.3;
/// So far along its way the ship looks, cells.
const AHEAD: usize = 8;

/// Where the ship can be.
#[derive(Clone, Debug)]
pub struct Space {
    wide: usize,
    high: usize,
    free: Vec<bool>,
}

/// How far each place is from a goal, in cells; `None` where no way leads there.
pub struct Way<'a> {
    space: &'a Space,
    far: Vec<Option<u32>>,
}

impl Space {
    pub fn of(level: &Level) -> Self {
        let (wide, high) = ((level.size.x / CELL) as usize, (level.size.y / CELL) as usize);
        let edge = level.bounds();
        let sources = level.streams.iter().map(|stream| stream.source);
        let solids: Vec<Aabb> = level.world.iter().map(|solid| solid.bounds).chain(sources).collect();
        let is_free = |index: usize| {
            let ship = Aabb::around(place(index % wide, index / wide), SHIP_HALF);
            let kept_off = Aabb::new(ship.min - OFF_RED, ship.max + OFF_RED);
            edge.contains(&ship, 0.01)
                && !solids.iter().any(|solid| ship.overlaps(solid, 0.01))
                && !level.obstacles.iter().any(|deadly| kept_off.overlaps(deadly, 0.0))
        };
        Self { wide, high, free: (0..wide * high).map(is_free).collect() }
    }

    /// A free place.
    pub fn any(&self, chosen: usize) -> Option<DVec2> {
        let free = self.free.iter().filter(|free| **free).count();
        let index = self.free.iter().enumerate().filter(|(_, free)| **free).nth(chosen % free.max(1))?.0;
        Some(place(index % self.wide, index / self.wide))
    }

    /// The ways to wherever the ship's box touches `goal`.
    pub fn to(&self, goal: &Aabb) -> Way<'_> {
        let mut far = vec![None; self.free.len()];
        let near = |index: &usize| Aabb::around(place(index % self.wide, index / self.wide), SHIP_HALF).touches(goal, CELL);
        let mut next: VecDeque<usize> = (0..self.free.len()).filter(|index| self.free[*index]).filter(near).collect();
        next.iter().for_each(|index| far[*index] = Some(0));
        while let Some(index) = next.pop_front() {
            for other in self.beside(index) {
                if self.free[other] && far[other].is_none() {
                    far[other] = far[index].map(|far| far + 1);
                    next.push_back(other);
                }
            }
        }
        Way { space: self, far }
    }

    /// The cells above, below and to the sides of one.
    fn beside(&self, index: usize) -> impl Iterator<Item = usize> + use<> {
        let (wide, high, x, y) = (self.wide, self.high, index % self.wide, index / self.wide);
        let sides = [
            (x > 0, index.wrapping_sub(1)),
            (x + 1 < wide, index + 1),
            (y > 0, index.wrapping_sub(wide)),
            (y + 1 < high, index + wide),
        ];
        sides.into_iter().filter(|(there, _)| *there).map(|(_, index)| index)
    }

    /// The free cell nearest to a place, within three cells.
    fn cell(&self, at: DVec2) -> Option<usize> {
        let (x, y) = ((at.x / CELL) as usize, (at.y / CELL) as usize);
        let around = (y.saturating_sub(3)..(y + 4).min(self.high))
            .flat_map(|y| (x.saturating_sub(3)..(x + 4).min(self.wide)).map(move |x| (x, y)));
        let free = around.filter(|(x, y)| self.free[y * self.wide + x]);
        let nearest = free.min_by(|a, b| place(a.0, a.1).distance(at).total_cmp(&place(b.0, b.1).distance(at)));
        nearest.map(|(x, y)| y * self.wide + x)
    }
}

impl Way<'_> {
    /// How far it is from a place, m; `None` where no way leads to the goal.
    pub fn far(&self, from: DVec2) -> Option<f64> {
        self.far[self.space.cell(from)?].map(|cells| f64::from(cells) * CELL)
    }

    /// The place to fly to next; `None` where no way leads on.
    pub fn next(&self, from: DVec2) -> Option<DVec2> {
        let mut index = self.space.cell(from)?;
        for _ in 0..AHEAD {
            let far = self.far[index]?;
            let Some(nearer) = self.space.beside(index).find(|other| self.far[*other].is_some_and(|other| other < far)) else {
                break;
            };
            index = nearer;
        }
        Some(place(index % self.space.wide, index / self.space.wide))
    }
}

/// The middle of a cell, m.
fn place(x: usize, y: usize) -> DVec2 {
    DVec2::new(x as f64 + 0.5, y as f64 + 0.5) * CELL
}
