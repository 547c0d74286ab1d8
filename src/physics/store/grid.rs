//! Boxes that stand, in a uniform grid filled by a counting sort.

/// Up to this many boxes are tested one by one.
const FEW: usize = 8;
/// The most cells of a grid.
const MOST_CELLS: f64 = 65_536.0;

/// A box as left, right, top, bottom, m.
pub(crate) type Edges = [f64; 4];

/// Whether two boxes overlap or touch.
pub(crate) fn overlap(a: &Edges, b: &Edges) -> bool {
    (a[0] <= b[1]) & (b[0] <= a[1]) & (a[2] <= b[3]) & (b[2] <= a[3])
}

/// Whether the first box contains the second.
pub(crate) fn contains(outer: &Edges, inner: &Edges) -> bool {
    (outer[0] <= inner[0]) & (inner[1] <= outer[1]) & (outer[2] <= inner[2]) & (inner[3] <= outer[3])
}

/// A uniform grid over a rectangle; what lies outside counts to the cells of its edge.
#[derive(Clone, Debug, Default)]
pub(crate) struct Grid {
    left: f64,
    top: f64,
    per_metre: f64,
    columns: usize,
    rows: usize,
    start: Vec<u32>,
    items: Vec<u32>,
}

impl Grid {
    /// The grid of some boxes.
    pub fn of(boxes: &[Edges]) -> Self {
        let mut grid = Self::default();
        if boxes.len() <= FEW {
            return grid;
        }
        let area = boxes.iter().fold([f64::MAX, f64::MIN, f64::MAX, f64::MIN], |a, e| {
            [a[0].min(e[0]), a[1].max(e[1]), a[2].min(e[2]), a[3].max(e[3])]
        });
        let mean = boxes.iter().map(|e| (e[1] - e[0]).min(e[3] - e[2])).sum::<f64>() / boxes.len() as f64;
        grid.lay(area, 2.0 * mean, MOST_CELLS);
        // Counts the boxes of each cell, sums up, then places them from the last to the first.
        for place in [false, true] {
            for (j, e) in boxes.iter().enumerate().rev() {
                for row in grid.row(e[2])..=grid.row(e[3]) {
                    for column in grid.column(e[0])..=grid.column(e[1]) {
                        let start = &mut grid.start[row * grid.columns + column];
                        if place {
                            *start -= 1;
                            grid.items[*start as usize] = j as u32;
                        } else {
                            *start += 1;
                        }
                    }
                }
            }
            if !place {
                grid.sum_up();
            }
        }
        grid
    }

    /// Calls `take` once with each of the boxes that overlaps `mine`.
    pub fn find(&self, boxes: &[Edges], mine: &Edges, mut take: impl FnMut(usize)) {
        let every = |take: &mut dyn FnMut(usize)| {
            (0..boxes.len()).filter(|j| overlap(mine, &boxes[*j])).for_each(take);
        };
        if self.start.is_empty() {
            return every(&mut take);
        }
        let (columns, rows) = (self.column(mine[0])..=self.column(mine[1]), self.row(mine[2])..=self.row(mine[3]));
        if columns.clone().count() * rows.clone().count() > boxes.len() {
            return every(&mut take);
        }
        for row in rows.clone() {
            for column in columns.clone() {
                let cell = row * self.columns + column;
                for &j in &self.items[self.start[cell] as usize..self.start[cell + 1] as usize] {
                    let e = &boxes[j as usize];
                    // A box counts in the first of the cells that it shares with `mine`.
                    let first = (self.column(e[0]).max(*columns.start()), self.row(e[2]).max(*rows.start()));
                    if first == (column, row) && overlap(mine, e) {
                        take(j as usize);
                    }
                }
            }
        }
    }

    /// Lays cells of about that width over the area, but no more than `most`, all empty.
    fn lay(&mut self, area: Edges, cell: f64, most: f64) {
        let (width, height) = (area[1] - area[0], area[3] - area[2]);
        let mut cell = cell.max(1e-6).max(width / most).max(height / most);
        while (width / cell + 1.0) * (height / cell + 1.0) > most {
            cell *= 1.5;
        }
        (self.left, self.top, self.per_metre) = (area[0], area[2], 1.0 / cell);
        self.columns = (width / cell) as usize + 1;
        self.rows = (height / cell) as usize + 1;
        self.start.clear();
        self.start.resize(self.columns * self.rows + 1, 0);
    }

    /// Float to integer saturates, so whatever lies beyond an edge lands in the edge's cells.
    fn column(&self, x: f64) -> usize {
        (((x - self.left) * self.per_metre) as usize).min(self.columns - 1)
    }

    fn row(&self, y: f64) -> usize {
        (((y - self.top) * self.per_metre) as usize).min(self.rows - 1)
    }

    /// Turns counts a cell into the start of each cell's range.
    fn sum_up(&mut self) {
        let mut sum = 0;
        for count in &mut self.start {
            sum += *count;
            *count = sum;
        }
        self.items.clear();
        self.items.resize(sum as usize, 0);
    }
}
