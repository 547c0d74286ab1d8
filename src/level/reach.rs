//! Which objects nobody can ever touch: an exact flood fill of the free space, for a warning to authors.
//!
//! The centre of a box among solid rectangles moves like a point among those rectangles grown by the box's half size. The edges
//! of the grown rectangles cut the level into a grid that is exact, whatever the sizes: its cells are the open intervals between
//! two edges and, between them, the edges themselves (a box may slide through a gap of exactly its size).
//!
//! Who can be touched can be pushed, and may then touch others where the ship does not fit. Whatever might be reachable counts as
//! reachable: objects are no obstacles to each other, and nothing is too heavy to push.

use crate::physics::{Aabb, DVec2};
use std::collections::BTreeMap;

/// Grids with more cells than this are not searched: a warning is not worth a long load. 4 million cells take about 50 ms.
const MOST_CELLS: usize = 4_000_000;
/// No more sizes of objects than this are searched.
const MOST_SIZES: usize = 16;

/// A level's free space.
pub(super) struct Space {
    pub level: Aabb,
    pub solids: Vec<Aabb>,
    /// How far boxes may overlap solids, m: rounding must not close a gap.
    pub slack: f64,
}

/// Where the centre of a box of one size can be.
struct Grid {
    half: DVec2,
    /// The edges, ascending, without repeats. Cell 2i + 1 is edge i, cell 2i the open interval before it.
    x: Vec<f64>,
    y: Vec<f64>,
    /// The connected part of the free space that each cell belongs to, from 1; 0 where it is blocked. Row by row.
    parts: Vec<u32>,
}

/// A connected part of the free space of one size: the index of its grid, and the part's number.
type Part = (usize, u32);

impl Space {
    /// The indices of those `(centre, half)` bodies that nothing reaches that starts with the ship; none where the level is too
    /// large to say.
    pub fn unreached(&self, ship: (DVec2, DVec2), bodies: &[(DVec2, DVec2)]) -> Vec<usize> {
        let mut halves = vec![ship.1];
        for (_, half) in bodies {
            if !halves.contains(half) {
                halves.push(*half);
            }
        }
        let edges = 2 * self.solids.len() + 2;
        let cells = (2 * edges + 1) * (2 * edges + 1);
        if bodies.is_empty() || halves.len() > MOST_SIZES || cells.saturating_mul(halves.len()) > MOST_CELLS {
            return Vec::new();
        }
        let grids: Vec<Grid> = halves.into_iter().map(|half| self.grid(half)).collect();
        let part_of = |(centre, half): &(DVec2, DVec2)| -> Option<Part> {
            let grid = grids.iter().position(|grid| grid.half == *half)?;
            Some((grid, grids[grid].part_at(*centre))).filter(|(_, part)| *part != 0)
        };
        let mut waiting: BTreeMap<Part, Vec<usize>> = BTreeMap::new();
        for (i, body) in bodies.iter().enumerate() {
            // A body without a place of its own has been refused; it is never warned about.
            if let Some(part) = part_of(body) {
                waiting.entry(part).or_default().push(i);
            }
        }
        let mut reached: Vec<Part> = part_of(&ship).into_iter().collect();
        while let Some(by) = reached.pop() {
            let toucher = Toucher::new(&grids[by.0], by.1);
            let touched: Vec<Part> =
                waiting.keys().copied().filter(|part| toucher.touches(&grids[part.0], part.1, self.slack)).collect();
            for part in touched {
                waiting.remove(&part);
                reached.push(part);
            }
        }
        let mut unreached: Vec<usize> = waiting.into_values().flatten().collect();
        unreached.sort_unstable();
        unreached
    }

    /// Whether a `(centre, half)` body can get somewhere from where it touches a box; also where the level is too large to say, or where the
    /// body starts in something.
    pub fn gets_to(&self, (centre, half): (DVec2, DVec2), target: &Aabb) -> bool {
        let edges = 2 * self.solids.len() + 2;
        if (2 * edges + 1) * (2 * edges + 1) > MOST_CELLS {
            return true;
        }
        let grid = self.grid(half);
        let part = grid.part_at(centre);
        let reach = half + self.slack;
        let along = |edges: &[f64], low: f64, high: f64| Grid::cell(edges, low)..=Grid::cell(edges, high);
        let mut near = along(&grid.y, target.min.y - reach.y, target.max.y + reach.y)
            .flat_map(|row| along(&grid.x, target.min.x - reach.x, target.max.x + reach.x).map(move |column| (row, column)));
        part == 0 || near.any(|(row, column)| grid.parts[row * grid.columns() + column] == part)
    }

    fn grid(&self, half: DVec2) -> Grid {
        let grown: Vec<Aabb> = self
            .solids
            .iter()
            .map(|solid| Aabb::new(solid.min - half + self.slack, solid.max + half - self.slack))
            .filter(|grown| grown.min.cmplt(grown.max).all())
            .collect();
        let inside = Aabb::new(self.level.min + half - self.slack, self.level.max - half + self.slack);
        let edges = |axis: fn(DVec2) -> f64| {
            let mut edges: Vec<f64> = grown.iter().chain([&inside]).flat_map(|b| [axis(b.min), axis(b.max)]).collect();
            edges.sort_unstable_by(f64::total_cmp);
            edges.dedup();
            edges
        };
        let mut grid = Grid { half, x: edges(|v| v.x), y: edges(|v| v.y), parts: Vec::new() };
        let (columns, rows) = (2 * grid.x.len() + 1, 2 * grid.y.len() + 1);
        let mut blocked = vec![false; columns * rows];
        let index = |edges: &[f64], value: f64| edges.partition_point(|edge| *edge < value);
        for solid in &grown {
            // All cells strictly between two edges: the edges themselves stay free.
            let (left, right) = (2 * index(&grid.x, solid.min.x) + 2, 2 * index(&grid.x, solid.max.x));
            let (top, bottom) = (2 * index(&grid.y, solid.min.y) + 2, 2 * index(&grid.y, solid.max.y));
            for row in top..=bottom {
                blocked[row * columns + left..=row * columns + right].fill(true);
            }
        }
        let (left, right) = (2 * index(&grid.x, inside.min.x) + 1, 2 * index(&grid.x, inside.max.x) + 1);
        let (top, bottom) = (2 * index(&grid.y, inside.min.y) + 1, 2 * index(&grid.y, inside.max.y) + 1);
        for (i, cell) in blocked.iter_mut().enumerate() {
            *cell |= !(left..=right).contains(&(i % columns)) || !(top..=bottom).contains(&(i / columns));
        }
        grid.parts = label(&blocked, columns);
        grid
    }
}

/// Numbers the connected parts of the cells that are not blocked, from 1.
fn label(blocked: &[bool], columns: usize) -> Vec<u32> {
    let mut parts = vec![0; blocked.len()];
    let mut last = 0;
    let mut open = Vec::new();
    for start in 0..blocked.len() {
        if blocked[start] || parts[start] != 0 {
            continue;
        }
        last += 1;
        parts[start] = last;
        open.push(start);
        while let Some(cell) = open.pop() {
            // The outermost cells lie outside the level and are blocked: no neighbour leaves the grid.
            for next in [cell - 1, cell + 1, cell - columns, cell + columns] {
                if !blocked[next] && parts[next] == 0 {
                    parts[next] = last;
                    open.push(next);
                }
            }
        }
    }
    parts
}

impl Grid {
    /// The cell along one axis that holds `value`.
    fn cell(edges: &[f64], value: f64) -> usize {
        let before = edges.partition_point(|edge| *edge < value);
        2 * before + usize::from(edges.get(before) == Some(&value))
    }

    /// The interval that a cell covers along one axis.
    fn interval(edges: &[f64], cell: usize) -> (f64, f64) {
        let before = |i: usize| i.checked_sub(1).map_or(f64::NEG_INFINITY, |i| edges[i]);
        match cell % 2 {
            1 => (edges[cell / 2], edges[cell / 2]),
            _ => (before(cell / 2), edges.get(cell / 2).copied().unwrap_or(f64::INFINITY)),
        }
    }

    fn columns(&self) -> usize {
        2 * self.x.len() + 1
    }

    /// The part that a point belongs to; 0 where it is blocked.
    fn part_at(&self, point: DVec2) -> u32 {
        self.parts[Self::cell(&self.y, point.y) * self.columns() + Self::cell(&self.x, point.x)]
    }
}

/// A part of a grid, asked what its box can touch.
struct Toucher<'a> {
    grid: &'a Grid,
    /// How many cells of the part lie above and to the left of each corner of the grid, so that the cells of the part in any
    /// rectangle are counted by four look-ups. Row by row, one longer each way than the grid.
    count: Vec<u32>,
}

impl<'a> Toucher<'a> {
    fn new(grid: &'a Grid, part: u32) -> Self {
        let columns = grid.columns();
        let at = |row: usize, column: usize| row * (columns + 1) + column;
        let rows = grid.parts.len() / columns;
        let mut count = vec![0u32; (columns + 1) * (rows + 1)];
        for (i, cell) in grid.parts.iter().enumerate() {
            let (row, column) = (i / columns, i % columns);
            let others = count[at(row, column + 1)] + count[at(row + 1, column)] - count[at(row, column)];
            count[at(row + 1, column + 1)] = others + u32::from(*cell == part);
        }
        Self { grid, count }
    }

    /// Whether the box somewhere in its part can touch another grid's box somewhere in that part.
    fn touches(&self, other: &Grid, part: u32, slack: f64) -> bool {
        let reach = self.grid.half + other.half + slack;
        let at = |row: usize, column: usize| self.count[row * (self.grid.columns() + 1) + column];
        (0..other.parts.len()).filter(|i| other.parts[*i] == part).any(|i| {
            let x = Grid::interval(&other.x, i % other.columns());
            let y = Grid::interval(&other.y, i / other.columns());
            let (left, right) = (Grid::cell(&self.grid.x, x.0 - reach.x), Grid::cell(&self.grid.x, x.1 + reach.x) + 1);
            let (top, bottom) = (Grid::cell(&self.grid.y, y.0 - reach.y), Grid::cell(&self.grid.y, y.1 + reach.y) + 1);
            at(bottom, right) + at(top, left) > at(top, right) + at(bottom, left)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space(solids: &[[f64; 4]]) -> Space {
        let aabb = |[x, y, w, h]: [f64; 4]| Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h));
        Space { level: aabb([0.0, 0.0, 100.0, 100.0]), solids: solids.iter().copied().map(aabb).collect(), slack: 1e-6 }
    }

    fn body(x: f64, y: f64, half: f64) -> (DVec2, DVec2) {
        (DVec2::new(x, y), DVec2::splat(half))
    }

    /// A wall at x = 50 … 52 with a gap of `gap` at the floor.
    fn wall(gap: f64) -> [f64; 4] {
        [50.0, 0.0, 2.0, 100.0 - gap]
    }

    #[test]
    fn a_closed_wall_separates_and_a_gap_of_exactly_the_ships_size_does_not() {
        let ship = body(10.0, 50.0, 1.0);
        let objects = [body(20.0, 20.0, 0.5), body(80.0, 20.0, 0.5)];
        assert_eq!(space(&[wall(0.0)]).unreached(ship, &objects), [1]);
        assert!(space(&[wall(2.0)]).unreached(ship, &objects).is_empty());
        assert!(space(&[]).unreached(ship, &objects).is_empty());
    }

    #[test]
    fn what_can_come_out_or_be_touched_through_a_gap_is_reached() {
        let ship = body(10.0, 50.0, 1.0);
        // Too narrow for the ship, wide enough for the object.
        assert!(space(&[wall(1.5)]).unreached(ship, &[body(80.0, 20.0, 0.5)]).is_empty());
        // Too narrow for both, and the wall is thick.
        assert_eq!(space(&[wall(1.5)]).unreached(ship, &[body(80.0, 20.0, 0.8)]), [0]);
        // A smaller object can be pushed through and reaches the large one.
        let objects = [body(80.0, 20.0, 0.8), body(20.0, 20.0, 0.7)];
        assert!(space(&[wall(1.5)]).unreached(ship, &objects).is_empty());
    }

    #[test]
    fn a_chamber_made_of_many_blocks_is_closed_where_they_only_touch() {
        let chamber = [[40.0, 40.0, 20.0, 1.0], [40.0, 59.0, 20.0, 1.0], [40.0, 41.0, 1.0, 18.0], [59.0, 41.0, 1.0, 18.0]];
        let objects = [body(50.0, 50.0, 0.5), body(50.0, 39.5, 0.5)];
        assert_eq!(space(&chamber).unreached(body(10.0, 10.0, 1.0), &objects), [0]);
        assert_eq!(space(&chamber).unreached(body(50.0, 55.0, 1.0), &objects), [1]);
    }
}
