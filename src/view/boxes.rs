//! Where the details boxes go: near their objects, inside the window, out of each other's way. Plain arithmetic.

use super::layout::{Area, Vec2};

/// Between a box and its object, canvas units.
const OBJECT_GAP: f32 = 28.0;
/// Between a box and another, and between a box and the window's edge, canvas units.
const GAP: f32 = 8.0;
/// How much it costs to cover an object or an arrow, a little and entirely, in canvas units of distance.
const TOUCH_COST: f32 = 40.0;
const COVER_COST: f32 = 260.0;
/// How much it costs a box to change its place beside its object, for each unit of the change: what keeps boxes from jumping about.
const MOVE_COST: f32 = 0.6;
/// How much nearer two boxes together must come for it to be worth their changing places, canvas units: less makes them flutter.
const EXCHANGE_GAIN: f32 = 40.0;

/// A box that wants a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wish {
    /// The object that it belongs to.
    pub object: Area,
    /// The size of the box.
    pub size: Vec2,
    /// Where its corner was from the object's middle in the frame before.
    pub before: Option<Vec2>,
}

/// Gives each box, in order, the best place left: none overlaps another or one of `taken`, all lie inside `window`. What is in
/// `kept_clear` (objects, arrows) is covered only when that spares a long way. `None` where no place is left.
pub fn place(wishes: &[Wish], window: Area, taken: &[Area], kept_clear: &[Area]) -> Vec<Option<Area>> {
    let mut fixed = taken.to_vec();
    let mut places: Vec<Option<Area>> = wishes
        .iter()
        .map(|wish| {
            let area = best(wish, window, &fixed, kept_clear);
            fixed.extend(area);
            area
        })
        .collect();
    exchange(wishes, &mut places);
    places
}

/// Lets two boxes of one size change places where that brings them nearer to their objects: their lines no longer cross.
fn exchange(wishes: &[Wish], places: &mut [Option<Area>]) {
    for i in 0..places.len() {
        for j in i + 1..places.len() {
            if let (Some(a), Some(b)) = (places[i], places[j])
                && a.size == b.size
            {
                let (first, second) = (wishes[i].object.centre(), wishes[j].object.centre());
                let now = distance(&a, first) + distance(&b, second);
                if distance(&b, first) + distance(&a, second) < now - EXCHANGE_GAIN {
                    places.swap(i, j);
                }
            }
        }
    }
}

fn best(wish: &Wish, window: Area, fixed: &[Area], kept_clear: &[Area]) -> Option<Area> {
    let (low, high) = (window.min + GAP, window.max() - wish.size - GAP);
    if high.x < low.x || high.y < low.y {
        return None;
    }
    let middle = wish.object.centre();
    let columns = stops(wish, fixed, |v| v.x).into_iter().chain(wish.before.map(|before| middle.x + before.x));
    let rows: Vec<f32> = stops(wish, fixed, |v| v.y).into_iter().chain(wish.before.map(|before| middle.y + before.y)).collect();
    let mut found: Option<(f32, Area)> = None;
    for x in columns {
        for &y in &rows {
            let area = Area { min: Vec2::new(x, y).clamp(low, high), size: wish.size };
            let away = distance(&area, middle);
            let moved = wish.before.map_or(0.0, |before| (area.min - middle - before).length() * MOVE_COST);
            let cost = away + moved;
            if found.is_some_and(|(least, _)| cost >= least) || fixed.iter().any(|other| apart(&area, other) < GAP - 0.01) {
                continue;
            }
            let covered: f32 = kept_clear.iter().map(|other| cost_of_covering(covered(&area, other))).sum();
            let cost = cost + covered;
            if found.is_none_or(|(least, _)| cost < least) {
                found = Some((cost, area));
            }
        }
    }
    found.map(|(_, area)| area)
}

/// Where along one axis a box can begin: beside, above and below its object, flush with it, and against what already has its place.
fn stops(wish: &Wish, fixed: &[Area], axis: impl Fn(Vec2) -> f32) -> Vec<f32> {
    let (size, from, to) = (axis(wish.size), axis(wish.object.min), axis(wish.object.max()));
    let own = [to + OBJECT_GAP, from - OBJECT_GAP - size, (from + to - size) * 0.5, from, to - size, f32::MIN, f32::MAX];
    let others = fixed.iter().flat_map(|other| [axis(other.max()) + GAP, axis(other.min) - GAP - size]);
    own.into_iter().chain(others).collect()
}

/// From a box to a point, 0 inside.
fn distance(area: &Area, point: Vec2) -> f32 {
    (area.min - point).max(point - area.max()).max(Vec2::ZERO).length()
}

/// The gap between two boxes, negative where they overlap.
fn apart(a: &Area, b: &Area) -> f32 {
    (b.min - a.max()).max(a.min - b.max()).max_element()
}

/// Whether a box overlaps none of the others.
pub fn covers_none(area: &Area, others: &[Area]) -> bool {
    others.iter().all(|other| apart(area, other) >= 0.0)
}

fn cost_of_covering(share: f32) -> f32 {
    if share > 0.0 { TOUCH_COST + share * COVER_COST } else { 0.0 }
}

/// The share of `other` that `area` covers.
fn covered(area: &Area, other: &Area) -> f32 {
    let shared = (area.max().min(other.max()) - area.min.max(other.min)).max(Vec2::ZERO);
    shared.x * shared.y / (other.size.x * other.size.y).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Area = Area { min: Vec2::ZERO, size: Vec2::new(1280.0, 720.0) };

    fn wish(x: f32, y: f32, size: Vec2) -> Wish {
        Wish { object: Area::around(Vec2::new(x, y), Vec2::splat(50.0)), size, before: None }
    }

    fn check(places: &[Option<Area>], taken: &[Area]) {
        let all: Vec<Area> = places.iter().flatten().copied().collect();
        for (i, area) in all.iter().enumerate() {
            assert!(area.min.cmpge(Vec2::ZERO).all() && area.max().cmple(WINDOW.size).all(), "{area:?} leaves the window");
            for other in all[i + 1..].iter().chain(taken) {
                assert!(apart(area, other) >= 0.0, "{area:?} overlaps {other:?}");
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
                assert_eq!(covered(&area, &wish.object), 0.0, "the box at ({x}, {y}) covers its object");
                assert!(distance(&area, wish.object.centre().clamp(Vec2::ZERO, WINDOW.size)) < 100.0);
            }
        }
    }

    #[test]
    fn many_boxes_never_overlap_and_stay_inside() {
        let taken = [Area::new(16.0, 16.0, 200.0, 40.0), Area::new(160.0, 680.0, 960.0, 22.0)];
        for count in [5, 12, 30, 60] {
            // Objects in a heap: the worst for boxes that want to be near them.
            let wishes: Vec<Wish> = (0..count)
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
            let moved = Wish { before: Some(before), ..wish(centre.x, centre.y, Vec2::new(310.0, 180.0)) };
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
