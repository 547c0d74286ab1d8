//! A uniform grid, filled by a counting sort.
//!
//! Cells lie in rows, so that what one row of a range has to offer is one contiguous range of items. Count the items of each cell
//! in `start`, sum up, then place them from the last to the first: `start` of a cell counts down to where its items begin.

/// A box as left, right, top, bottom, m.
pub(crate) type Edges = [f64; 4];

/// Whether two boxes overlap or touch.
pub(crate) fn overlap(a: &Edges, b: &Edges) -> bool {
    (a[0] <= b[1]) & (b[0] <= a[1]) & (a[2] <= b[3]) & (b[2] <= a[3])
}

/// A uniform grid over a rectangle; what lies outside counts to the cells of its edge.
#[derive(Clone, Debug, Default)]
pub(crate) struct Grid {
    left: f64,
    top: f64,
    per_metre: f64,
    pub columns: usize,
    pub rows: usize,
    pub start: Vec<u32>,
    pub items: Vec<u32>,
}

impl Grid {
    /// Lays cells of about that width over the area, but no more than `most`, all empty.
    pub fn lay(&mut self, area: Edges, cell: f64, most: f64) {
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
    pub fn column(&self, x: f64) -> usize {
        (((x - self.left) * self.per_metre) as usize).min(self.columns - 1)
    }

    pub fn row(&self, y: f64) -> usize {
        (((y - self.top) * self.per_metre) as usize).min(self.rows - 1)
    }

    /// Turns counts a cell into the start of each cell's range.
    pub fn sum_up(&mut self) {
        let mut sum = 0;
        for count in &mut self.start {
            sum += *count;
            *count = sum;
        }
        self.items.clear();
        self.items.resize(sum as usize, 0);
    }
}
