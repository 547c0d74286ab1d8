//! Solid rectangles as one mass: their union in rows without overlap, and its outline as closed loops and as straight edges with
//! their kinds. Plain geometry in metres, y down.

use super::sweep::{SweepRow, SweepSpan, SweptBox, TOUCH, rows, stop, stops};
use crate::physics::{Aabb, DVec2};

/// The join of an edge with the next one of its loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corner {
    Outer,
    Inner,
    /// The line goes straight on, of another kind.
    Straight,
}

/// A straight piece of the outline, of one kind, with the mass on its right hand (y down); lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RockEdge {
    pub from: DVec2,
    pub to: DVec2,
    /// The unit vector into the mass.
    pub inward: DVec2,
    pub kind: usize,
    /// At its beginning and its end.
    pub corners: [Corner; 2],
    /// The least depth of the mass behind it, m; at most [`DEPTH`].
    pub depth: f64,
}

impl RockEdge {
    /// m.
    pub fn length(&self) -> f64 {
        (self.to - self.from).length()
    }

    /// The unit vector from its beginning to its end.
    pub fn along(&self) -> DVec2 {
        (self.to - self.from).normalize_or_zero()
    }

    pub fn bounds(&self) -> Aabb {
        Aabb::new(self.from.min(self.to), self.from.max(self.to))
    }
}

/// The greatest depth behind an edge that is measured, m.
pub const DEPTH: f64 = 4.0;

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Silhouette {
    columns: Vec<f64>,
    heights: Vec<f64>,
    rows: Vec<SweepRow>,
    pub loops: Vec<Vec<DVec2>>,
    pub edges: Vec<RockEdge>,
}

impl Silhouette {
    /// Rectangles, each of a kind; where some overlap, the kind is that of the last one.
    pub fn new(boxes: &[(Aabb, usize)]) -> Self {
        let boxes: Vec<&(Aabb, usize)> = boxes.iter().filter(|(bounds, _)| bounds.size().min_element() > TOUCH).collect();
        let columns = stops(boxes.iter().flat_map(|(bounds, _)| [bounds.min.x, bounds.max.x]));
        let heights = stops(boxes.iter().flat_map(|(bounds, _)| [bounds.min.y, bounds.max.y]));
        let swept = |(bounds, kind): &&(Aabb, usize)| SweptBox {
            columns: [stop(&columns, bounds.min.x), stop(&columns, bounds.max.x)],
            rows: [stop(&heights, bounds.min.y), stop(&heights, bounds.max.y)],
            kind: *kind,
        };
        let rows = rows(&boxes.iter().map(swept).collect::<Vec<_>>(), heights.len());
        let mut mass = Self { columns, heights, rows, loops: Vec::new(), edges: Vec::new() };
        for corners in loops(&mass.rows) {
            mass.loops.push(corners.iter().map(|&at| mass.point(at)).collect());
            mass.add_edges(&corners);
        }
        mass
    }

    /// Rectangles without overlap that fill the mass, each with its kind.
    pub fn pieces(&self) -> impl Iterator<Item = (Aabb, usize)> {
        self.rows.iter().flat_map(move |row| {
            let piece = move |span: &SweepSpan| {
                let (min, max) = (self.point((span.from, row.top)), self.point((span.to, row.bottom)));
                (Aabb::new(min, max), span.kind)
            };
            row.spans.iter().map(piece)
        })
    }

    /// The boxes of a space without the mass, or with that kind alone; those above each other of the same width are one.
    pub fn open(&self, within: &Aabb, but: usize) -> Vec<Aabb> {
        let mut open: Vec<Aabb> = Vec::new();
        let mut above: Vec<usize> = Vec::new();
        for row in &self.rows {
            let (top, bottom) = (self.heights[row.top].max(within.min.y), self.heights[row.bottom].min(within.max.y));
            let solid = row.spans.iter().filter(|it| it.kind != but).map(|it| (self.columns[it.from], self.columns[it.to]));
            let (mut from, mut here) = (within.min.x, Vec::new());
            for (left, right) in solid.chain([(within.max.x, within.max.x)]) {
                let free = Aabb::new(DVec2::new(from, top), DVec2::new(left.min(within.max.x), bottom));
                if free.size().min_element() > TOUCH {
                    let goes_on = |i: &usize| (open[*i].min.x, open[*i].max.x, open[*i].max.y) == (free.min.x, free.max.x, top);
                    here.push(above.iter().copied().find(goes_on).unwrap_or(open.len()));
                    match open.get_mut(here[here.len() - 1]) {
                        Some(higher) => higher.max.y = bottom,
                        None => open.push(free),
                    }
                }
                from = from.max(right);
            }
            above = here;
        }
        open
    }

    /// Whether all of a box lies in the mass and is of that kind.
    pub fn holds(&self, bounds: &Aabb, kind: usize) -> bool {
        let (lowest, last) = (self.heights.first(), self.heights.last());
        let inside = lowest.is_some_and(|top| *top <= bounds.min.y) && last.is_some_and(|bottom| *bottom >= bounds.max.y);
        let first = self.rows.partition_point(|row| self.heights[row.bottom] <= bounds.min.y);
        let over = |span: &SweepSpan| {
            span.kind == kind && self.columns[span.from] <= bounds.min.x && self.columns[span.to] >= bounds.max.x
        };
        inside
            && self.rows[first..]
                .iter()
                .take_while(|row| self.heights[row.top] < bounds.max.y)
                .all(|row| row.spans.iter().any(over))
    }

    /// The free distance from a point along a unit vector (parallel to neither axis) inside one kind, m; at most `limit`.
    pub fn reach(&self, kind: usize, (from, direction): (DVec2, DVec2), limit: f64) -> f64 {
        let mut gone = 0.0;
        while gone < limit {
            let at = from + direction * gone;
            // Just beyond the line under `at`.
            let ahead = at + direction * TOUCH;
            let Some(row) = self.row_at(ahead.y) else { break };
            let holds = |span: &&SweepSpan| self.columns[span.from] <= ahead.x && ahead.x < self.columns[span.to];
            let Some(span) = row.spans.iter().find(holds).filter(|span| span.kind == kind) else { break };
            let end = |low: usize, high: usize, stops: &[f64], way: f64| if way > 0.0 { stops[high] } else { stops[low] };
            let across = (end(span.from, span.to, &self.columns, direction.x) - at.x) / direction.x;
            gone += across.min((end(row.top, row.bottom, &self.heights, direction.y) - at.y) / direction.y).max(TOUCH);
        }
        gone.min(limit)
    }

    fn row_at(&self, y: f64) -> Option<&SweepRow> {
        self.rows[..self.rows.partition_point(|row| self.heights[row.top] <= y)].last().filter(|row| y < self.heights[row.bottom])
    }

    fn point(&self, (column, height): (usize, usize)) -> DVec2 {
        DVec2::new(self.columns[column], self.heights[height])
    }

    /// Cuts the sides of a loop where their kind changes.
    fn add_edges(&mut self, corners: &[(usize, usize)]) {
        let n = corners.len();
        let way = |i: usize| unit(corners[i % n], corners[(i + 1) % n]);
        for i in 0..n {
            let (from, to) = (corners[i], corners[(i + 1) % n]);
            let ends = [turn(way(i + n - 1), way(i)), turn(way(i), way(i + 1))];
            let inward = right(way(i));
            let pieces = self.kinds(from, to, inward);
            let last = pieces.len() - 1;
            for (j, &(a, b, kind)) in pieces.iter().enumerate() {
                self.edges.push(RockEdge {
                    from: self.point(a),
                    to: self.point(b),
                    inward: DVec2::new(f64::from(inward.0), f64::from(inward.1)),
                    kind,
                    corners: [if j == 0 { ends[0] } else { Corner::Straight }, if j == last { ends[1] } else { Corner::Straight }],
                    depth: self.depth(a, b, inward),
                });
            }
        }
    }

    /// The pieces of a side by the kind behind them, in walking order.
    fn kinds(&self, from: EdgePlace, to: EdgePlace, inward: (i8, i8)) -> Vec<(EdgePlace, EdgePlace, usize)> {
        let along: Vec<(EdgePlace, EdgePlace, usize)> = if inward.0 == 0 {
            let (left, right) = (from.0.min(to.0), from.0.max(to.0));
            let spans = self.row_beside(from.1, inward.1).into_iter().flat_map(|row| &row.spans);
            let inside = spans.filter(|span| span.to > left && span.from < right);
            inside.map(|span| ((span.from.max(left), from.1), (span.to.min(right), from.1), span.kind)).collect()
        } else {
            let (top, bottom) = (from.1.min(to.1), from.1.max(to.1));
            let touches = |span: &&SweepSpan| if inward.0 > 0 { span.from == from.0 } else { span.to == from.0 };
            let ends = |row: &SweepRow| ((from.0, row.top.max(top)), (from.0, row.bottom.min(bottom)));
            let cut = |row: &SweepRow| row.spans.iter().find(touches).map(|span| (ends(row).0, ends(row).1, span.kind));
            self.rows_between(top, bottom).iter().filter_map(cut).collect()
        };
        let mut pieces: Vec<(EdgePlace, EdgePlace, usize)> = Vec::new();
        let mut add = |a: EdgePlace, b: EdgePlace, kind: usize| match pieces.last_mut() {
            Some(last) if last.2 == kind => last.1 = b,
            _ => pieces.push((a, b, kind)),
        };
        if from < to {
            along.into_iter().for_each(|(a, b, kind)| add(a, b, kind));
        } else {
            along.into_iter().rev().for_each(|(a, b, kind)| add(b, a, kind));
        }
        pieces
    }

    fn row_beside(&self, height: usize, way: i8) -> Option<&SweepRow> {
        let next = self.rows.partition_point(|row| row.top < height);
        let row = if way > 0 { self.rows.get(next) } else { self.rows[..next].last() };
        row.filter(|row| if way > 0 { row.top == height } else { row.bottom == height })
    }

    fn rows_between(&self, top: usize, bottom: usize) -> &[SweepRow] {
        let first = self.rows.partition_point(|row| row.bottom <= top);
        let end = self.rows.partition_point(|row| row.top < bottom);
        &self.rows[first..end.max(first)]
    }

    /// The depth of the mass behind a side, of any kind, m.
    fn depth(&self, from: EdgePlace, to: EdgePlace, inward: (i8, i8)) -> f64 {
        if inward.0 == 0 {
            let (left, right) = (from.0.min(to.0), from.0.max(to.0));
            let (start, mut height) = (from.1, from.1);
            while let Some(row) = self.row_beside(height, inward.1)
                && row.covered().iter().any(|&(a, b)| a <= left && b >= right)
                && (self.heights[height] - self.heights[start]).abs() < DEPTH
            {
                height = if inward.1 > 0 { row.bottom } else { row.top };
            }
            (self.heights[height] - self.heights[start]).abs().min(DEPTH)
        } else {
            let (top, bottom) = (from.1.min(to.1), from.1.max(to.1));
            let behind = |row: &SweepRow| {
                let covered = row.covered();
                let span = covered.iter().find(|(a, b)| if inward.0 > 0 { *a == from.0 } else { *b == from.0 });
                span.map_or(0.0, |&(a, b)| self.columns[b] - self.columns[a])
            };
            self.rows_between(top, bottom).iter().map(behind).fold(DEPTH, f64::min)
        }
    }
}

/// A crossing of a column and a height, by their indices.
type EdgePlace = (usize, usize);

/// The loops round the rows' mass, by their corners.
fn loops(rows: &[SweepRow]) -> Vec<Vec<EdgePlace>> {
    let mut sides: Vec<(EdgePlace, EdgePlace)> = Vec::new();
    let mut above: Vec<(usize, usize)> = Vec::new();
    for row in rows {
        let covered = row.covered();
        level_sides(&above, &covered, row.top, &mut sides);
        for &(from, to) in &covered {
            sides.push(((to, row.top), (to, row.bottom)));
            sides.push(((from, row.bottom), (from, row.top)));
        }
        above = covered;
    }
    if let Some(last) = rows.last() {
        level_sides(&above, &[], last.bottom, &mut sides);
    }
    sides.sort_unstable();
    let mut walked = vec![false; sides.len()];
    let mut loops = Vec::new();
    for first in 0..sides.len() {
        let (mut side, mut corners) = (first, Vec::new());
        while !walked[side] {
            walked[side] = true;
            let next = following(&sides, side);
            if unit(sides[side].0, sides[side].1) != unit(sides[next].0, sides[next].1) {
                corners.push(sides[next].0);
            }
            side = next;
        }
        if !corners.is_empty() {
            loops.push(corners);
        }
    }
    loops
}

/// The sides along a height: where only the row below covers, and where only the row above does.
fn level_sides(above: &[(usize, usize)], below: &[(usize, usize)], height: usize, sides: &mut Vec<(EdgePlace, EdgePlace)>) {
    let mut cuts: Vec<usize> = above.iter().chain(below).flat_map(|&(a, b)| [a, b]).collect();
    cuts.sort_unstable();
    cuts.dedup();
    let in_it = |covered: &[(usize, usize)], cut: usize| {
        covered[..covered.partition_point(|(from, _)| *from <= cut)].last().is_some_and(|(_, to)| cut < *to)
    };
    for pair in cuts.windows(2) {
        match (in_it(above, pair[0]), in_it(below, pair[0])) {
            (false, true) => sides.push(((pair[0], height), (pair[1], height))),
            (true, false) => sides.push(((pair[1], height), (pair[0], height))),
            _ => {}
        }
    }
}

/// The side that begins at another's end. Of two, the one that turns to the right: round the same corner of the mass.
fn following(sides: &[(EdgePlace, EdgePlace)], side: usize) -> usize {
    let (from, to) = sides[side];
    let mut next = (sides.partition_point(|(start, _)| *start < to)..sides.len()).take_while(|&i| sides[i].0 == to);
    let one = next.next().unwrap_or(side);
    next.next().filter(|&i| unit(sides[i].0, sides[i].1) == right(unit(from, to))).unwrap_or(one)
}

fn unit(from: EdgePlace, to: EdgePlace) -> (i8, i8) {
    let sign = |a: usize, b: usize| b.cmp(&a) as i8;
    (sign(from.0, to.0), sign(from.1, to.1))
}

/// The direction to the right hand of another (y down).
const fn right((x, y): (i8, i8)) -> (i8, i8) {
    (-y, x)
}

fn turn(before: (i8, i8), after: (i8, i8)) -> Corner {
    if after == right(before) { Corner::Outer } else { Corner::Inner }
}
