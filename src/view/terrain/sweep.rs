//! Rectangles cut into rows: a sweep down through their sides, and in each row one from left to right. Columns and heights are
//! indices of the sorted sides, so that shared sides are equal to the bit.

use std::collections::BTreeSet;

/// Sides this close count as one line, m: far below a pixel, far above the rounding error of a sum of two coordinates.
pub const TOUCH: f64 = 1e-6;

/// A stretch of a row between two columns, of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SweepSpan {
    pub from: usize,
    pub to: usize,
    pub kind: usize,
}

/// The mass between two heights where it does not change. Rows follow each other without a gap; some are empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SweepRow {
    pub top: usize,
    pub bottom: usize,
    /// From left to right; neighbours that touch differ in kind.
    pub spans: Vec<SweepSpan>,
}

impl SweepRow {
    /// The spans of all kinds, touching ones merged.
    pub fn covered(&self) -> Vec<(usize, usize)> {
        let mut all: Vec<(usize, usize)> = Vec::new();
        for span in &self.spans {
            match all.last_mut() {
                Some(last) if last.1 == span.from => last.1 = span.to,
                _ => all.push((span.from, span.to)),
            }
        }
        all
    }
}

pub struct SweptBox {
    pub columns: [usize; 2],
    pub rows: [usize; 2],
    pub kind: usize,
}

/// The values in order, each once; values within [`TOUCH`] count as one.
pub fn stops(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut stops: Vec<f64> = values.collect();
    stops.sort_by(f64::total_cmp);
    stops.dedup_by(|b, a| *b - *a <= TOUCH);
    stops
}

/// The index of a value's stop.
pub fn stop(stops: &[f64], value: f64) -> usize {
    stops.partition_point(|stop| *stop <= value).saturating_sub(1)
}

/// The rows from the first height to the last, equal neighbours merged.
pub fn rows(boxes: &[SweptBox], heights: usize) -> Vec<SweepRow> {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by_key(|&i| boxes[i].rows[0]);
    let mut order = order.into_iter().peekable();
    let mut active: Vec<usize> = Vec::new();
    let mut rows: Vec<SweepRow> = Vec::new();
    for height in 0..heights.saturating_sub(1) {
        active.retain(|&i| boxes[i].rows[1] > height);
        while let Some(i) = order.next_if(|&i| boxes[i].rows[0] <= height) {
            active.push(i);
        }
        let spans = spans(boxes, &active);
        match rows.last_mut() {
            Some(row) if row.spans == spans => row.bottom = height + 1,
            _ => rows.push(SweepRow { top: height, bottom: height + 1, spans }),
        }
    }
    rows
}

/// The spans of a row under some boxes: a sweep from left to right, the last box on top.
fn spans(boxes: &[SweptBox], active: &[usize]) -> Vec<SweepSpan> {
    let mut events: Vec<(usize, bool, usize)> =
        active.iter().flat_map(|&i| [(boxes[i].columns[0], true, i), (boxes[i].columns[1], false, i)]).collect();
    events.sort_unstable();
    let mut here: BTreeSet<usize> = BTreeSet::new();
    let mut spans: Vec<SweepSpan> = Vec::new();
    let mut before: usize = 0;
    for (column, begins, i) in events {
        if let Some(&top) = here.last()
            && column > before
        {
            let kind = boxes[top].kind;
            match spans.last_mut() {
                Some(last) if last.to == before && last.kind == kind => last.to = column,
                _ => spans.push(SweepSpan { from: before, to: column, kind }),
            }
        }
        before = column;
        if begins {
            here.insert(i)
        } else {
            here.remove(&i)
        };
    }
    spans
}
