//! Where a box can get among solids, exactly: its centre moves like a point among the solids grown by its half size. Their edges cut the level into
//! a grid, whose cells are the open intervals between two edges and the edges themselves (a box may slide through a gap of exactly its size).
//! A doubtful place counts as reached.

use crate::physics::{Aabb, DVec2};
use std::cell::{Cell, RefCell};
use std::{collections::BTreeMap, ops::RangeInclusive, rc::Rc};

/// How far things may overlap at the start, m: pixels that touch overlap by rounding, which must not close a gap either.
pub(super) const OVERLAP: f64 = 1e-6;
/// The largest grid that is searched, cells: 4 million take about 50 ms.
const MOST_CELLS: usize = 4_000_000;
/// The most cells that all searches of a level look at together.
const MOST_WORK: usize = 20_000_000;

/// Centre and half size.
pub(super) type CentredBox = (DVec2, DVec2);

pub(super) struct FreeSpace {
    level: Aabb,
    solids: Vec<Aabb>,
    /// The cells that the searches of a level have looked at.
    work: Rc<Cell<usize>>,
    /// By the bits of the half size of a box.
    grids: RefCell<BTreeMap<[u64; 2], Rc<Grid>>>,
}

impl FreeSpace {
    pub fn new(level: Aabb, solids: Vec<Aabb>) -> Self {
        Self { level, solids, work: Rc::default(), grids: RefCell::default() }
    }

    pub fn with(&self, more: impl IntoIterator<Item = Aabb>) -> Self {
        let solids = self.solids.iter().copied().chain(more).collect();
        Self { work: self.work.clone(), ..Self::new(self.level, solids) }
    }

    /// Whether a body gets to a place from which it touches a box; true where the level is too large to say, or the body starts in a solid.
    pub fn gets_to(&self, body: CentredBox, target: &Aabb) -> bool {
        let (Some(grid), Some(part)) = (self.grid(body.1), self.part(body)) else { return true };
        let [columns, mut rows] = grid.cells(&grown(target, body.1 + OVERLAP));
        let cells = |row: usize| row * grid.columns() + columns.start()..=row * grid.columns() + columns.end();
        rows.any(|row| !self.may_look_at(columns.clone().count()) || grid.parts[cells(row)].contains(&part))
    }

    /// The connected part of the free space of boxes of that size; `None` where the level is too large to say, or the body starts in a solid.
    pub fn part(&self, (centre, half): CentredBox) -> Option<u32> {
        let grid = self.grid(half)?;
        let [x, y] = grid.cells(&Aabb::new(centre, centre));
        Some(grid.parts[y.start() * grid.columns() + x.start()]).filter(|part| *part != BLOCKED)
    }

    fn grid(&self, half: DVec2) -> Option<Rc<Grid>> {
        let size = half.to_array().map(f64::to_bits);
        let known = self.grids.borrow().get(&size).cloned();
        known.or_else(|| {
            let cells = (4 * self.solids.len() + 5).pow(2);
            let search = cells <= MOST_CELLS && self.may_look_at(cells);
            let grid = search.then(|| Rc::new(Grid::new(half, &self.level, &self.solids)))?;
            self.grids.borrow_mut().insert(size, grid.clone());
            Some(grid)
        })
    }

    /// Whether that many more cells are within what all searches may look at; counts them then.
    fn may_look_at(&self, cells: usize) -> bool {
        let work = self.work.get() + cells;
        let allowed = work <= MOST_WORK;
        self.work.set(if allowed { work } else { self.work.get() });
        allowed
    }
}

struct Grid {
    /// Of x and of y, ascending, without repeats. Cell 2i + 1 is edge i, cell 2i the open interval before it.
    edges: [Vec<f64>; 2],
    /// The connected part of the free space that each cell belongs to, row by row.
    parts: Vec<u32>,
}

const BLOCKED: u32 = 0;
/// Not yet in any part.
const FREE: u32 = u32::MAX;

impl Grid {
    fn new(half: DVec2, level: &Aabb, solids: &[Aabb]) -> Self {
        let solids = solids.iter().map(|solid| grown(solid, half - OVERLAP));
        let solids: Vec<Aabb> = solids.filter(|solid| solid.min.cmplt(solid.max).all()).collect();
        let inside = grown(level, OVERLAP - half);
        let edges = [0, 1].map(|axis| {
            let mut edges: Vec<f64> = solids.iter().chain([&inside]).flat_map(|b| [b.min[axis], b.max[axis]]).collect();
            edges.sort_unstable_by(f64::total_cmp);
            edges.dedup();
            edges
        });
        let mut grid = Self { edges, parts: Vec::new() };
        let columns = grid.columns();
        // How many solids cover each cell: the sum of what begins and ends at it, to its left and above. An edge itself stays free.
        let mut covers = vec![0; columns * (2 * grid.edges[1].len() + 1)];
        for solid in &solids {
            let [x, y] = grid.cells(solid);
            for (row, begins) in [(y.start() + 1, 1), (*y.end(), -1)] {
                covers[row * columns + x.start() + 1] += begins;
                covers[row * columns + x.end()] -= begins;
            }
        }
        for cell in columns + 1..covers.len() {
            covers[cell] += covers[cell - 1] + covers[cell - columns] - covers[cell - columns - 1];
        }
        let [across, down] = grid.cells(&inside);
        let is_free = |cell: usize| covers[cell] == 0 && across.contains(&(cell % columns)) && down.contains(&(cell / columns));
        grid.parts = (0..covers.len()).map(|cell| if is_free(cell) { FREE } else { BLOCKED }).collect();
        grid.flood();
        grid
    }

    /// Numbers the connected parts of the free cells. The outermost cells lie outside the level and are blocked: no neighbour leaves the grid.
    fn flood(&mut self) {
        let (mut open, columns, mut part) = (Vec::new(), self.columns(), BLOCKED);
        for start in 0..self.parts.len() {
            part += u32::from(self.parts[start] == FREE);
            open.push(start);
            while let Some(cell) = open.pop() {
                if self.parts[cell] == FREE {
                    self.parts[cell] = part;
                    open.extend([cell - 1, cell + 1, cell - columns, cell + columns]);
                }
            }
        }
    }

    fn columns(&self) -> usize {
        2 * self.edges[0].len() + 1
    }

    /// The columns and the rows of the cells that hold the points of a rectangle, its edges included.
    fn cells(&self, area: &Aabb) -> [RangeInclusive<usize>; 2] {
        [0, 1].map(|axis| {
            let cell = |value: f64| {
                let before = self.edges[axis].partition_point(|edge| *edge < value);
                2 * before + usize::from(self.edges[axis].get(before) == Some(&value))
            };
            cell(area.min[axis])..=cell(area.max[axis])
        })
    }
}

pub(super) fn grown(bounds: &Aabb, by: DVec2) -> Aabb {
    Aabb::new(bounds.min - by, bounds.max + by)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space(solids: &[[f64; 4]]) -> FreeSpace {
        let aabb = |[x, y, w, h]: [f64; 4]| Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h));
        let solids = solids.iter().copied().map(aabb).collect();
        FreeSpace::new(aabb([0.0, 0.0, 100.0, 100.0]), solids)
    }

    fn body(x: f64, y: f64, half: f64) -> CentredBox {
        (DVec2::new(x, y), DVec2::splat(half))
    }

    #[test]
    fn what_a_search_costs_depends_on_the_grid_and_not_on_how_much_of_it_solids_cover() {
        // 480 solids, each as large as the level but for a hair, and 2000 targets.
        let solids: Vec<[f64; 4]> = (0..480).map(|i| [0.01 * f64::from(i), 0.0, 40.0, 95.0 + 0.01 * f64::from(i)]).collect();
        let space = space(&solids);
        let targets = (0..2000).map(|i| Aabb::new(DVec2::new(50.0, 1.0), DVec2::new(51.0, 1.0 + 0.01 * f64::from(i))));
        assert!(targets.into_iter().all(|target| space.gets_to(body(80.0, 50.0, 1.0), &target)));
        let cells = (2 * (2 * 480 + 2) + 1_usize).pow(2);
        assert!(space.work.get() <= 2 * cells, "{} of {cells} cells", space.work.get());
        // Nothing is searched beyond what all may cost.
        for i in 0..40 {
            let space = space.with([Aabb::new(DVec2::ZERO, DVec2::splat(f64::from(i + 1)))]);
            space.gets_to(body(80.0, 50.0, 1.0), &Aabb::around(DVec2::ONE, DVec2::ONE));
        }
        let work = space.work.get();
        assert!(work <= MOST_WORK && work + 4 * cells > MOST_WORK, "{work}");
    }

    /// At x = 50 … 52.
    #[test]
    fn a_closed_wall_separates_and_a_gap_of_exactly_the_bodys_size_does_not() {
        let wall_with = |gap: f64| space(&[[50.0, 0.0, 2.0, 100.0 - gap]]);
        let (ship, small) = (body(10.0, 50.0, 1.0), body(20.0, 20.0, 0.7));
        let beyond = Aabb::around(DVec2::new(80.0, 20.0), DVec2::ONE);
        assert!(!wall_with(0.0).gets_to(ship, &beyond) && wall_with(2.0).gets_to(ship, &beyond));
        assert!(space(&[]).gets_to(ship, &beyond));
        assert!(!wall_with(1.5).gets_to(ship, &beyond) && wall_with(1.5).gets_to(small, &beyond));
        let parts = |gap: f64, half: f64| [10.0, 80.0].map(|x| wall_with(gap).part(body(x, 20.0, half)));
        let [left, right] = parts(1.5, 0.8);
        assert!(left.is_some() && right.is_some() && left != right);
        let [left, right] = parts(1.5, 0.7);
        assert!(left.is_some() && left == right);
    }
}
