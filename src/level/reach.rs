//! Objects that no body can ever touch: an exact flood fill of the free space, for a warning to authors.
//!
//! The centre of a box among solid rectangles moves like a point among those rectangles grown by the box's half size. The edges
//! of the grown rectangles cut the level into a grid that is exact, whatever the sizes: its cells are the open intervals between
//! two edges and, between them, the edges themselves (a box may slide through a gap of exactly its size).
//!
//! A body that is touched can be pushed, and may then touch others where the ship does not fit. A doubtful body counts as reached: objects
//! are no obstacles to each other, and no body is too heavy to push.

use crate::physics::{Aabb, DVec2};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The largest grid that is searched, cells: 4 million take about 50 ms.
const MOST_CELLS: usize = 4_000_000;
/// The most sizes of objects that are searched.
const MOST_SIZES: usize = 16;
/// The most cells that all searches of a level look at together.
pub(super) const MOST_WORK: u64 = 20_000_000;

/// The cost of a level's searches so far, in cells looked at.
#[derive(Debug, Default)]
pub(super) struct SearchWork(Cell<u64>);

impl SearchWork {
    /// Whether the budget allows `cells` more cells; takes them from it then.
    pub fn spend(&self, cells: usize) -> bool {
        let spent = self.0.get().saturating_add(cells as u64);
        let allowed = spent <= MOST_WORK;
        if allowed {
            self.0.set(spent);
        }
        allowed
    }

    /// Counts looks that have a bound of their own.
    pub fn count(&self, looks: usize) {
        self.0.set(self.0.get().saturating_add(looks as u64));
    }

    #[cfg(test)]
    pub fn spent(&self) -> u64 {
        self.0.get()
    }
}

pub(super) struct FreeSpace {
    level: Aabb,
    solids: Vec<Aabb>,
    /// How far boxes may overlap solids, m: rounding must not close a gap.
    slack: f64,
    pub work: Rc<SearchWork>,
    grids: RefCell<Vec<(DVec2, Option<Rc<Grid>>)>>,
}

/// Where the centre of a box of one size can be.
struct Grid {
    half: DVec2,
    /// The edges, ascending, without repeats. Cell 2i + 1 is edge i, cell 2i the open interval before it.
    x: Vec<f64>,
    y: Vec<f64>,
    /// The connected part of the free space that each cell belongs to, from 1; 0 where it is blocked. Row by row.
    parts: Vec<u32>,
    counts: RefCell<BTreeMap<u32, Rc<Counts>>>,
}

/// A connected part of the free space of one size: the index of its grid, and the part's number.
type FreePart = (usize, u32);

/// Centre and half size.
pub(super) type CentredBox = (DVec2, DVec2);

impl FreeSpace {
    pub fn new(level: Aabb, solids: Vec<Aabb>, slack: f64, work: Rc<SearchWork>) -> Self {
        Self { level, solids, slack, work, grids: RefCell::default() }
    }

    pub fn with(&self, more: impl IntoIterator<Item = Aabb>) -> Self {
        let solids = self.solids.iter().copied().chain(more).collect();
        Self::new(self.level, solids, self.slack, self.work.clone())
    }

    /// The indices of the bodies that neither the ship reaches nor a body that it pushes or that is `moved` otherwise; none where the level is
    /// too large to say.
    pub fn unreached(&self, ship: CentredBox, bodies: &[CentredBox], moved: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut halves = vec![ship.1];
        for (_, half) in bodies {
            if halves.len() <= MOST_SIZES && !halves.contains(half) {
                halves.push(*half);
            }
        }
        if bodies.is_empty() || halves.len() > MOST_SIZES {
            return Vec::new();
        }
        let Some(grids) = halves.into_iter().map(|half| self.grid(half)).collect::<Option<Vec<Rc<Grid>>>>() else {
            return Vec::new();
        };
        let part_of = |(centre, half): &CentredBox| -> Option<FreePart> {
            let grid = grids.iter().position(|grid| grid.half == *half)?;
            Some((grid, grids[grid].part_at(*centre))).filter(|(_, part)| *part != 0)
        };
        let mut waiting: BTreeMap<FreePart, Vec<usize>> = BTreeMap::new();
        for (i, body) in bodies.iter().enumerate() {
            // A body in a blocked cell has been refused: it gets no warning.
            if let Some(part) = part_of(body) {
                waiting.entry(part).or_default().push(i);
            }
        }
        let others = bodies.iter().enumerate().filter(|(i, _)| moved(*i)).filter_map(|(_, body)| part_of(body));
        let mut reached: Vec<FreePart> = part_of(&ship).into_iter().chain(others).collect();
        reached.iter().for_each(|part| drop(waiting.remove(part)));
        while let Some((grid, part)) = reached.pop() {
            let Some(from) = self.counts(&grids[grid], part) else { return Vec::new() };
            let mut touched = Vec::new();
            for (grid, part) in waiting.keys() {
                let to = &grids[*grid];
                if !self.work.spend(to.parts.len()) {
                    return Vec::new();
                }
                if from.touches((to, *part), self.slack) {
                    touched.push((*grid, *part));
                }
            }
            for part in touched {
                waiting.remove(&part);
                reached.push(part);
            }
        }
        let mut unreached: Vec<usize> = waiting.into_values().flatten().collect();
        unreached.sort_unstable();
        unreached
    }

    /// Whether a body gets to a place from which it touches a box; true where the level is too large to say, or where the body starts in a
    /// solid.
    pub fn gets_to(&self, (centre, half): CentredBox, target: &Aabb) -> bool {
        let Some(grid) = self.grid(half) else { return true };
        let part = grid.part_at(centre);
        if part == 0 || !self.work.spend(1) {
            return true;
        }
        let Some(counts) = self.counts(&grid, part) else { return true };
        let reach = half + self.slack;
        counts.any_in(&Aabb::new(target.min - reach, target.max + reach))
    }

    /// `None` where the level is too large to search.
    fn grid(&self, half: DVec2) -> Option<Rc<Grid>> {
        if let Some((_, known)) = self.grids.borrow().iter().find(|(known, _)| *known == half) {
            return known.clone();
        }
        let edges = 2 * self.solids.len() + 2;
        let cells = (2 * edges + 1) * (2 * edges + 1);
        let room = self.grids.borrow().len() < MOST_SIZES && cells <= MOST_CELLS;
        let grid = (room && self.work.spend(cells)).then(|| Rc::new(self.build(half)));
        self.grids.borrow_mut().push((half, grid.clone()));
        grid
    }

    fn counts(&self, grid: &Rc<Grid>, part: u32) -> Option<Rc<Counts>> {
        if let Some(known) = grid.counts.borrow().get(&part) {
            return Some(known.clone());
        }
        if !self.work.spend(grid.parts.len()) {
            return None;
        }
        let counts = Rc::new(Counts::new(grid, part));
        grid.counts.borrow_mut().insert(part, counts.clone());
        Some(counts)
    }

    fn build(&self, half: DVec2) -> Grid {
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
        let (x, y) = (edges(|v| v.x), edges(|v| v.y));
        let (columns, rows) = (2 * x.len() + 1, 2 * y.len() + 1);
        let index = |edges: &[f64], value: f64| edges.partition_point(|edge| *edge < value);
        // How many solids begin less how many end at each cell: a solid of any size costs four cells.
        let mut begun = vec![0i32; (columns + 1) * (rows + 1)];
        for solid in &grown {
            // All cells strictly between two edges: the edges themselves stay free.
            let (left, right) = (2 * index(&x, solid.min.x) + 2, 2 * index(&x, solid.max.x) + 1);
            let (top, bottom) = (2 * index(&y, solid.min.y) + 2, 2 * index(&y, solid.max.y) + 1);
            for (row, column, by) in [(top, left, 1), (top, right, -1), (bottom, left, -1), (bottom, right, 1)] {
                begun[row * (columns + 1) + column] += by;
            }
        }
        let (left, right) = (2 * index(&x, inside.min.x) + 1, 2 * index(&x, inside.max.x) + 1);
        let (top, bottom) = (2 * index(&y, inside.min.y) + 1, 2 * index(&y, inside.max.y) + 1);
        let mut blocked = vec![false; columns * rows];
        let mut above = vec![0i32; columns];
        for row in 0..rows {
            let mut before = 0;
            for column in 0..columns {
                before += begun[row * (columns + 1) + column];
                above[column] += before;
                let outside = !(left..=right).contains(&column) || !(top..=bottom).contains(&row);
                blocked[row * columns + column] = above[column] > 0 || outside;
            }
        }
        Grid { half, x, y, parts: label(&blocked, columns), counts: RefCell::default() }
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

    fn interval(edges: &[f64], cell: usize) -> (f64, f64) {
        let before = |i: usize| i.checked_sub(1).map_or(f64::NEG_INFINITY, |i| edges[i]);
        match cell % 2 {
            1 => (edges[cell / 2], edges[cell / 2]),
            _ => (before(cell / 2), edges.get(cell / 2).copied().unwrap_or(f64::INFINITY)),
        }
    }

    /// Where the centres in a cell are; infinite at the outermost, which are blocked.
    fn area(&self, cell: usize) -> Aabb {
        let columns = 2 * self.x.len() + 1;
        let (x, y) = (Self::interval(&self.x, cell % columns), Self::interval(&self.y, cell / columns));
        Aabb { min: DVec2::new(x.0, y.0), max: DVec2::new(x.1, y.1) }
    }

    /// The part that a point belongs to; 0 where it is blocked.
    fn part_at(&self, point: DVec2) -> u32 {
        self.parts[Self::cell(&self.y, point.y) * (2 * self.x.len() + 1) + Self::cell(&self.x, point.x)]
    }
}

/// How many cells of a part of a grid lie above and to the left of each corner: four look-ups count the cells in any rectangle. Row by row,
/// one row and one column more than the grid.
struct Counts {
    count: Vec<u32>,
    half: DVec2,
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Counts {
    fn new(grid: &Grid, part: u32) -> Self {
        let columns = 2 * grid.x.len() + 1;
        let at = |row: usize, column: usize| row * (columns + 1) + column;
        let rows = grid.parts.len() / columns;
        let mut count = vec![0u32; (columns + 1) * (rows + 1)];
        for i in 0..grid.parts.len() {
            let (row, column) = (i / columns, i % columns);
            let others = count[at(row, column + 1)] + count[at(row + 1, column)] - count[at(row, column)];
            count[at(row + 1, column + 1)] = others + u32::from(grid.parts[i] == part);
        }
        Self { count, half: grid.half, x: grid.x.clone(), y: grid.y.clone() }
    }

    /// Whether one of the cells has a point in a rectangle, its edges included.
    fn any_in(&self, area: &Aabb) -> bool {
        let columns = 2 * self.x.len() + 1;
        let at = |row: usize, column: usize| self.count[row * (columns + 1) + column];
        let (left, right) = (Grid::cell(&self.x, area.min.x), Grid::cell(&self.x, area.max.x) + 1);
        let (top, bottom) = (Grid::cell(&self.y, area.min.y), Grid::cell(&self.y, area.max.y) + 1);
        at(bottom, right) + at(top, left) > at(top, right) + at(bottom, left)
    }

    /// Whether the box in one of these cells can touch another grid's box in that part.
    fn touches(&self, (other, part): (&Grid, u32), slack: f64) -> bool {
        let reach = self.half + other.half + slack;
        (0..other.parts.len()).filter(|i| other.parts[*i] == part).any(|i| {
            let area = other.area(i);
            self.any_in(&Aabb { min: area.min - reach, max: area.max + reach })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space(solids: &[[f64; 4]]) -> FreeSpace {
        let aabb = |[x, y, w, h]: [f64; 4]| Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h));
        let solids = solids.iter().copied().map(aabb).collect();
        FreeSpace::new(aabb([0.0, 0.0, 100.0, 100.0]), solids, 1e-6, Rc::default())
    }

    fn body(x: f64, y: f64, half: f64) -> (DVec2, DVec2) {
        (DVec2::new(x, y), DVec2::splat(half))
    }

    #[test]
    fn what_a_search_costs_depends_on_the_grid_and_not_on_how_much_of_it_solids_cover() {
        // 480 solids, each as large as the level but for a hair, and 2000 targets.
        let solids: Vec<[f64; 4]> = (0..480).map(|i| [0.01 * f64::from(i), 0.0, 40.0, 95.0 + 0.01 * f64::from(i)]).collect();
        let space = space(&solids);
        let targets = (0..2000).map(|i| Aabb::new(DVec2::new(50.0, 1.0), DVec2::new(51.0, 1.0 + 0.01 * f64::from(i))));
        assert!(targets.into_iter().all(|target| space.gets_to(body(80.0, 50.0, 1.0), &target)));
        let cells = (2 * (2 * 480 + 2) + 1_u64).pow(2);
        assert!(space.work.spent() <= 2 * cells, "{} of {cells} cells", space.work.spent());
        // Nothing is searched beyond what all may cost.
        let mut spent = 0;
        for i in 0..40 {
            space
                .with([Aabb::new(DVec2::ZERO, DVec2::splat(f64::from(i + 1)))])
                .gets_to(body(80.0, 50.0, 1.0), &Aabb::around(DVec2::ONE, DVec2::ONE));
            spent = space.work.spent();
        }
        assert!(spent <= MOST_WORK && spent + 4 * cells > MOST_WORK, "{spent}");
    }

    /// A wall at x = 50 … 52 with a gap of `gap` at the floor.
    fn wall(gap: f64) -> [f64; 4] {
        [50.0, 0.0, 2.0, 100.0 - gap]
    }

    #[test]
    fn a_closed_wall_separates_and_a_gap_of_exactly_the_ships_size_does_not() {
        let ship = body(10.0, 50.0, 1.0);
        let objects = [body(20.0, 20.0, 0.5), body(80.0, 20.0, 0.5)];
        assert_eq!(space(&[wall(0.0)]).unreached(ship, &objects, |_| false), [1]);
        assert!(space(&[wall(2.0)]).unreached(ship, &objects, |_| false).is_empty());
        assert!(space(&[]).unreached(ship, &objects, |_| false).is_empty());
    }

    #[test]
    fn what_can_come_out_or_be_touched_through_a_gap_is_reached() {
        let ship = body(10.0, 50.0, 1.0);
        // Too narrow for the ship, wide enough for the object.
        assert!(space(&[wall(1.5)]).unreached(ship, &[body(80.0, 20.0, 0.5)], |_| false).is_empty());
        // Too narrow for both, and the wall is thick.
        assert_eq!(space(&[wall(1.5)]).unreached(ship, &[body(80.0, 20.0, 0.8)], |_| false), [0]);
        // A smaller object can be pushed through and reaches the large one.
        let objects = [body(80.0, 20.0, 0.8), body(20.0, 20.0, 0.7)];
        assert!(space(&[wall(1.5)]).unreached(ship, &objects, |_| false).is_empty());
    }
}
