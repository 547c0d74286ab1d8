//! Where a box can get among solids, exactly: its centre moves like a point among the solids grown by its half size. Their edges cut the level into
//! a grid, whose cells are the open intervals between two edges and the edges themselves (a box may slide through a gap of exactly its size).
//! A doubtful place counts as reached: objects are no obstacles to each other, and none is too heavy to push.

use crate::physics::{Aabb, DVec2};
use std::cell::{Cell, RefCell};
use std::{collections::BTreeMap, ops::RangeInclusive, rc::Rc};

/// How far things may overlap at the start, m: pixels that touch overlap by rounding, which must not close a gap either.
pub(super) const OVERLAP: f64 = 1e-6;
/// The largest grid that is searched, cells: 4 million take about 50 ms; and the most sizes of boxes.
const MOST_CELLS: usize = 4_000_000;
const MOST_SIZES: usize = 16;
/// The most cells that all searches of a level look at together.
pub(super) const MOST_WORK: u64 = 20_000_000;

/// The cost of a level's searches so far, in cells looked at.
#[derive(Debug, Default)]
pub(super) struct SearchWork(Cell<u64>);

impl SearchWork {
    /// Whether the budget allows `cells` more cells; takes them from it then.
    pub fn spend(&self, cells: usize) -> bool {
        let allowed = self.0.get() + cells as u64 <= MOST_WORK;
        self.count(if allowed { cells } else { 0 });
        allowed
    }

    /// Counts looks that have a bound of their own.
    pub fn count(&self, looks: usize) {
        self.0.set(self.0.get() + looks as u64);
    }

    #[cfg(test)]
    pub fn spent(&self) -> u64 {
        self.0.get()
    }
}

pub(super) struct FreeSpace {
    level: Aabb,
    solids: Vec<Aabb>,
    pub work: Rc<SearchWork>,
    /// Of each size; `None` where the level is too large to search.
    grids: RefCell<Vec<(DVec2, Option<Grid>)>>,
}

/// A connected part of the free space of one size: the index of its grid, and the part's number.
type FreePart = (usize, u32);

/// Centre and half size.
pub(super) type CentredBox = (DVec2, DVec2);

impl FreeSpace {
    pub fn new(level: Aabb, solids: Vec<Aabb>, work: Rc<SearchWork>) -> Self {
        Self { level, solids, work, grids: RefCell::default() }
    }

    pub fn with(&self, more: impl IntoIterator<Item = Aabb>) -> Self {
        Self::new(self.level, self.solids.iter().copied().chain(more).collect(), self.work.clone())
    }

    /// Whether a body gets to a place from which it touches a box; true where the level is too large to say, or the body starts in a solid.
    pub fn gets_to(&self, body: CentredBox, target: &Aabb) -> bool {
        let Some((grid, part)) = self.part(body) else { return true };
        let grids = self.grids.borrow();
        let Some(grid) = &grids[grid].1 else { return true };
        grid.has(part, &grown(target, body.1 + OVERLAP), &self.work)
    }

    /// The indices of the bodies that neither the ship reaches nor a body that it pushes or that is `moved` otherwise; none where the level is
    /// too large to say.
    pub fn unreached(&self, ship: CentredBox, bodies: &[CentredBox], moved: impl Fn(usize) -> bool) -> Vec<usize> {
        let parts: Option<Vec<FreePart>> = bodies.iter().chain([&ship]).map(|body| self.part(*body)).collect();
        let Some(parts) = parts else { return Vec::new() };
        let mut waiting: BTreeMap<FreePart, Vec<usize>> = BTreeMap::new();
        (0..bodies.len()).for_each(|body| waiting.entry(parts[body]).or_default().push(body));
        let begins = (0..parts.len()).filter(|body| *body == bodies.len() || moved(*body));
        let mut reached: Vec<FreePart> = begins.map(|body| parts[body]).collect();
        while let Some(from) = reached.pop() {
            waiting.remove(&from);
            waiting.retain(|part, _| {
                let touched = self.touch(from, *part);
                reached.extend(touched.then_some(*part));
                !touched
            });
        }
        let mut unreached: Vec<usize> = waiting.into_values().flatten().collect();
        unreached.sort_unstable();
        unreached
    }

    /// Whether a box in one part can touch a box in another one.
    fn touch(&self, (from, part): FreePart, (to, other): FreePart) -> bool {
        let grids = self.grids.borrow();
        let (Some(from), Some(to)) = (&grids[from].1, &grids[to].1) else { return true };
        let mut cells = (0..to.parts.len()).filter(|cell| to.parts[*cell] == other);
        !self.work.spend(to.parts.len())
            || cells.any(|cell| from.has(part, &grown(&to.area(cell), from.half + to.half + OVERLAP), &self.work))
    }

    /// `None` where the level is too large to search, or the body starts in a solid.
    fn part(&self, (centre, half): CentredBox) -> Option<FreePart> {
        let known = self.grids.borrow().iter().position(|(known, _)| *known == half);
        let mut grids = self.grids.borrow_mut();
        let index = known.unwrap_or_else(|| {
            let cells = (4 * self.solids.len() + 5).pow(2);
            let search = grids.len() < MOST_SIZES && cells <= MOST_CELLS && self.work.spend(cells);
            grids.push((half, search.then(|| Grid::new(half, &self.level, &self.solids))));
            grids.len() - 1
        });
        let grid = grids[index].1.as_ref()?;
        let [x, y] = grid.cells(&Aabb::new(centre, centre));
        let part = grid.parts[y.start() * grid.columns() + x.start()];
        (part != BLOCKED).then_some((index, part))
    }
}

struct Grid {
    half: DVec2,
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
        let grown = solids.iter().map(|solid| grown(solid, half - OVERLAP));
        let grown: Vec<Aabb> = grown.filter(|grown| grown.min.cmplt(grown.max).all()).collect();
        let inside = Aabb::new(level.min + half - OVERLAP, level.max - half + OVERLAP);
        let edges = [0, 1].map(|axis| {
            let mut edges: Vec<f64> = grown.iter().chain([&inside]).flat_map(|b| [b.min[axis], b.max[axis]]).collect();
            edges.sort_unstable_by(f64::total_cmp);
            edges.dedup();
            edges
        });
        let mut grid = Self { half, edges, parts: Vec::new() };
        let solids: Vec<_> = grown.iter().map(|solid| grid.cells(solid)).collect();
        let [across, down] = grid.cells(&inside);
        for row in 0..2 * grid.edges[1].len() + 1 {
            // How many solids begin less how many end at each cell: an edge itself stays free.
            let mut begun = vec![0; grid.columns()];
            for [x, _] in solids.iter().filter(|[_, y]| (y.start() + 1..*y.end()).contains(&row)) {
                begun[x.start() + 1] += 1;
                begun[*x.end()] -= 1;
            }
            let mut over = 0;
            grid.parts.extend(begun.iter().enumerate().map(|(column, begun)| {
                over += begun;
                if over == 0 && across.contains(&column) && down.contains(&row) { FREE } else { BLOCKED }
            }));
        }
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

    fn area(&self, cell: usize) -> Aabb {
        let [x, y] = [cell % self.columns(), cell / self.columns()];
        let at = |x: usize, y: usize| DVec2::new(self.edges[0][x / 2], self.edges[1][y / 2]);
        Aabb::new(at(x - 1, y - 1), at(x, y))
    }

    /// Whether a part has a point in a rectangle, its edges included; true where a look would cost too much.
    fn has(&self, part: u32, area: &Aabb, work: &SearchWork) -> bool {
        let [columns, mut rows] = self.cells(area);
        let cells = |row: usize| row * self.columns() + columns.start()..=row * self.columns() + columns.end();
        rows.any(|row| !work.spend(columns.clone().count()) || self.parts[cells(row)].contains(&part))
    }
}

pub(super) fn grown(bounds: &Aabb, by: DVec2) -> Aabb {
    Aabb::new(bounds.min - by, bounds.max + by)
}

/// The points that two boxes share: none where its sides are negative.
pub(super) fn shared(a: &Aabb, b: &Aabb) -> Aabb {
    Aabb::new(a.min.max(b.min), a.max.min(b.max))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space(solids: &[[f64; 4]]) -> FreeSpace {
        let aabb = |[x, y, w, h]: [f64; 4]| Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h));
        let solids = solids.iter().copied().map(aabb).collect();
        FreeSpace::new(aabb([0.0, 0.0, 100.0, 100.0]), solids, Rc::default())
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
