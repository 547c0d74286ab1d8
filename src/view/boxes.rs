//! Places of the details boxes: near their objects, inside the window, without overlap, and never over the ship, hazards and goals.
//! Plain arithmetic on a grid of cells, whose time does not grow with a crowd.

use crate::draw::layout::{Area, Vec2};
use std::ops::Add;

/// Between a box and its object, canvas units.
const OBJECT_GAP: f32 = 28.0;
/// Between two boxes, and between a box and the window's edge, canvas units.
const GAP: f32 = 8.0;
/// Cost of covering an object, an arrow or words entirely, in canvas units of distance, and of covering a single cell of it.
const COVER_COST: f32 = 300.0;
const CELL_COST: f32 = 10.0;
/// Cost of a change of a box's place beside its object, for each unit of the change: it keeps boxes from jumping about.
const MOVE_COST: f32 = 0.6;
/// The most that a change costs: a box that stands far off comes back when there is room.
const MOVE_MOST: f32 = 120.0;
/// Two boxes change places when both together come nearer by this, canvas units: less makes them flutter.
const EXCHANGE_GAIN: f32 = 40.0;
/// The side of a cell, canvas units: finer finds tighter places, in time that grows with the square.
const CELL: f32 = 16.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxWish {
    pub object: Area,
    pub size: Vec2,
    /// Its corner from the object's middle in the frame before.
    pub before: Option<Vec2>,
}

/// The best place left for each box, clear of each other and `taken`; `kept_clear` is covered only to spare a long distance. `None` without a place.
pub fn place(wishes: &[BoxWish], window: Area, taken: &[Area], kept_clear: &[Area]) -> Vec<Option<Area>> {
    let mut fixed = taken.to_vec();
    let mut map = FreeMap::new(window, taken, kept_clear);
    let place = |wish: &BoxWish| {
        let area = best(wish, window, &fixed, &map)?;
        fixed.push(area);
        map.take(&area);
        Some(area)
    };
    let mut places: Vec<Option<Area>> = wishes.iter().map(place).collect();
    exchange(wishes, &mut places);
    places
}

/// Lets two boxes of one size change places where both come nearer to their objects: their lines no longer cross.
fn exchange(wishes: &[BoxWish], places: &mut [Option<Area>]) {
    for i in 0..places.len() {
        for j in i + 1..places.len() {
            if let (Some(a), Some(b)) = (places[i], places[j])
                && a.size == b.size
            {
                let (first, second) = (wishes[i].object.centre(), wishes[j].object.centre());
                if distance(&b, first) + distance(&a, second) < distance(&a, first) + distance(&b, second) - EXCHANGE_GAIN {
                    places.swap(i, j);
                }
            }
        }
    }
}

fn best(wish: &BoxWish, window: Area, fixed: &[Area], map: &FreeMap) -> Option<Area> {
    let (low, high) = (window.min + GAP, window.max() - wish.size - GAP);
    if high.x < low.x || high.y < low.y {
        return None;
    }
    let middle = wish.object.centre();
    let mut found: Option<(f32, Area)> = None;
    let mut consider = |min: Vec2, free: &dyn Fn(&Area) -> bool| {
        let area = Area { min, size: wish.size };
        let moved = wish.before.map_or(0.0, |before| ((min - middle - before).length() * MOVE_COST).min(MOVE_MOST));
        let cost = distance(&area, middle) + moved;
        let better = |cost: f32| found.is_none_or(|(least, _)| cost < least);
        if better(cost) && free(&area) {
            let cost = cost + map.cost(&area);
            if better(cost) {
                found = Some((cost, area));
            }
        }
    };
    // Exactly: the place before, and beside, above and below the object; then on the grid.
    let exactly = |area: &Area| fixed.iter().all(|other| area.gap(other) >= GAP - 0.01);
    if let Some(before) = wish.before {
        consider((middle + before).clamp(low, high), &exactly);
    }
    let stops = |axis: fn(Vec2) -> f32| {
        let (size, from, to) = (axis(wish.size), axis(wish.object.min), axis(wish.object.max()));
        [to + OBJECT_GAP, from - OBJECT_GAP - size, (from + to - size) * 0.5, from, to - size]
    };
    for x in stops(|v| v.x) {
        for y in stops(|v| v.y) {
            consider(Vec2::new(x, y).clamp(low, high), &exactly);
        }
    }
    let cells = ((high - low) / CELL).floor();
    for column in 0..=cells.x as usize {
        for row in 0..=cells.y as usize {
            consider(low + CELL * Vec2::new(column as f32, row as f32), &|area| map.is_free(area));
        }
    }
    found.map(|(_, area)| area)
}

/// The window in cells. Both tables hold sums over all cells above and to the left, so that a box of any size takes four look-ups.
struct FreeMap {
    min: Vec2,
    columns: usize,
    rows: usize,
    /// Taken cells, with the gap around them.
    taken: Vec<bool>,
    taken_sums: Vec<u32>,
    cost_sums: Vec<f32>,
}

impl FreeMap {
    fn new(window: Area, taken: &[Area], kept_clear: &[Area]) -> Self {
        let cells = (window.size / CELL).ceil();
        let (columns, rows) = (cells.x as usize, cells.y as usize);
        let sums = (columns + 1) * (rows + 1);
        let mut map = Self {
            min: window.min,
            columns,
            rows,
            taken: vec![false; columns * rows],
            taken_sums: vec![0; sums],
            cost_sums: vec![0.0; sums],
        };
        taken.iter().for_each(|area| map.mark(area));
        sum(columns, map.taken.iter().map(|taken| u32::from(*taken)), &mut map.taken_sums);
        let mut costs = vec![0.0; columns * rows];
        for area in kept_clear {
            let [left, top, right, bottom] = map.cells(area);
            let each = (COVER_COST / ((right - left) * (bottom - top)).max(1) as f32).max(CELL_COST);
            (top..bottom)
                .for_each(|row| costs[row * columns + left..row * columns + right].iter_mut().for_each(|cost| *cost += each));
        }
        sum(columns, costs.into_iter(), &mut map.cost_sums);
        map
    }

    /// The cells that an area touches: from column and row to column and row.
    fn cells(&self, area: &Area) -> [usize; 4] {
        let most = Vec2::new(self.columns as f32, self.rows as f32);
        let from = ((area.min - self.min) / CELL).floor().clamp(Vec2::ZERO, most);
        let to = ((area.max() - self.min) / CELL).ceil().clamp(from, most);
        [from.x as usize, from.y as usize, to.x as usize, to.y as usize]
    }

    fn mark(&mut self, area: &Area) {
        let [left, top, right, bottom] = self.cells(&area.inset(-GAP));
        for row in top..bottom {
            self.taken[row * self.columns + left..row * self.columns + right].fill(true);
        }
    }

    fn take(&mut self, area: &Area) {
        self.mark(area);
        sum(self.columns, self.taken.iter().map(|taken| u32::from(*taken)), &mut self.taken_sums);
    }

    fn is_free(&self, area: &Area) -> bool {
        let (sums, [a, b, c, d]) = (&self.taken_sums, self.corners(area));
        sums[d] + sums[a] == sums[b] + sums[c]
    }

    fn cost(&self, area: &Area) -> f32 {
        let (sums, [a, b, c, d]) = (&self.cost_sums, self.corners(area));
        (sums[d] + sums[a] - sums[b] - sums[c]).max(0.0)
    }

    /// The indices of the sums at a box's corners: top left, top right, bottom left, bottom right.
    fn corners(&self, area: &Area) -> [usize; 4] {
        let ([left, top, right, bottom], width) = (self.cells(area), self.columns + 1);
        [top * width + left, top * width + right, bottom * width + left, bottom * width + right]
    }
}

/// Sums of the cells of rows of `columns`, over all cells above and to the left. The first row and column of the sums stay 0.
fn sum<T: Copy + Default + Add<Output = T>>(columns: usize, cells: impl Iterator<Item = T>, sums: &mut [T]) {
    let mut line = T::default();
    for (cell, value) in cells.enumerate() {
        line = if cell % columns == 0 { value } else { line + value };
        // The sums have a column more than the cells.
        let above = cell + cell / columns + 1;
        sums[above + columns + 1] = sums[above] + line;
    }
}

/// 0 inside.
fn distance(area: &Area, point: Vec2) -> f32 {
    (area.min - point).max(point - area.max()).max(Vec2::ZERO).length()
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Area = Area { min: Vec2::ZERO, size: Vec2::new(1280.0, 720.0) };

    fn wish(x: f32, y: f32, size: Vec2) -> BoxWish {
        BoxWish { object: Area::around(Vec2::new(x, y), Vec2::splat(50.0)), size, before: None }
    }

    fn check(places: &[Option<Area>], taken: &[Area]) {
        let all: Vec<Area> = places.iter().flatten().copied().collect();
        for (i, area) in all.iter().enumerate() {
            assert!(area.min.cmpge(Vec2::ZERO).all() && area.max().cmple(WINDOW.size).all(), "{area:?} leaves the window");
            for other in all[i + 1..].iter().chain(taken) {
                assert!(area.gap(other) >= 0.0, "{area:?} overlaps {other:?}");
            }
        }
    }

    #[test]
    fn a_single_box_stands_beside_its_object_wherever_that_is() {
        for x in [0.0, 30.0, 640.0, 1260.0, 1400.0] {
            for y in [0.0, 20.0, 360.0, 700.0, 900.0] {
                let wish = wish(x, y, Vec2::new(310.0, 180.0));
                let places = place(&[wish], WINDOW, &[], &[wish.object]);
                check(&places, &[]);
                let area = places[0].expect("there is room");
                assert!(area.gap(&wish.object) >= 0.0, "the box at ({x}, {y}) covers its object");
                assert!(distance(&area, wish.object.centre().clamp(Vec2::ZERO, WINDOW.size)) < 100.0);
            }
        }
    }

    #[test]
    fn many_boxes_never_overlap_and_stay_inside() {
        let taken = [Area::new(16.0, 16.0, 200.0, 40.0), Area::new(160.0, 680.0, 960.0, 22.0)];
        for count in [5, 12, 30, 60] {
            // Objects in a heap: the worst for boxes that want to be near them.
            let wishes: Vec<BoxWish> = (0..count)
                .map(|i| {
                    wish(
                        560.0 + 37.0 * (i % 6) as f32,
                        420.0 + 23.0 * (i / 6) as f32,
                        Vec2::new(300.0, 40.0 + (i % 3) as f32 * 20.0),
                    )
                })
                .collect();
            let objects: Vec<Area> = wishes.iter().map(|wish| wish.object).collect();
            let places = place(&wishes, WINDOW, &taken, &objects);
            check(&places, &taken);
            assert!(places.iter().flatten().count() >= count.min(18), "only {} of {count}", places.iter().flatten().count());
        }
    }

    #[test]
    fn a_box_keeps_its_place_while_its_object_moves() {
        let first = place(&[wish(600.0, 300.0, Vec2::new(310.0, 180.0))], WINDOW, &[], &[])[0].expect("there is room");
        let mut before = first.min - Vec2::new(600.0, 300.0);
        for step in 1..60 {
            let centre = Vec2::new(600.0 - 4.0 * step as f32, 300.0 + 2.0 * step as f32);
            let moved = BoxWish { before: Some(before), ..wish(centre.x, centre.y, Vec2::new(310.0, 180.0)) };
            let area = place(&[moved], WINDOW, &[], &[])[0].expect("there is room");
            assert!((area.min - centre - before).length() < 1e-3, "the box jumped at step {step}");
            before = area.min - centre;
        }
    }

    #[test]
    fn a_box_larger_than_the_window_has_no_place() {
        assert_eq!(place(&[wish(600.0, 300.0, Vec2::new(2000.0, 100.0))], WINDOW, &[], &[]), [None]);
    }
}
