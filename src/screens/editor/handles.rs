//! The handles of what is selected: the points that can be dragged, and what that changes.

use super::Editor;
use crate::level::document::{Document, Kind, Place, RowId, SetCell, number, way_text};
use crate::physics::DVec2;

/// How near to a handle the pointer has to be, canvas units.
pub(super) const GRAB: f32 = 9.0;
/// From the middle of a thing to its handles, at least, canvas units: on a small thing they stand outside, and its middle moves it.
const CLEAR: f32 = 2.0 * GRAB;
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Handle {
    /// A corner or side: which edges it moves, −1 … 1 along each axis.
    Size(DVec2),
    Way(usize),
    MoreWay,
    Reach,
    /// Led onto a thing, to work it or no longer.
    Wire,
    /// An end of a link, led onto a body or to a place.
    End(usize),
}

impl Editor {
    /// The handles of the selection, and where they are, pixels: one thing alone has some.
    pub fn handles(&self) -> Vec<(Handle, DVec2)> {
        let [row] = self.selection[..] else { return Vec::new() };
        let Some(place) = self.document.place(row) else { return Vec::new() };
        let mut handles = Vec::new();
        let clear = (place.size * 0.5).max(DVec2::splat(f64::from(CLEAR) / self.view.scale));
        if self.document.is_sizable(row) {
            for side in SIDES {
                handles.push((Handle::Size(side), place.centre() + side * clear));
            }
        }
        match self.document.kind(row) {
            Some(Kind::Mover) => {
                let way = self.document.way_points(row);
                let half = place.size * 0.5;
                handles.extend(way.iter().enumerate().map(|(i, point)| (Handle::Way(i), *point + half)));
                let last = way.last().copied().unwrap_or(place.min) + half;
                handles.push((Handle::MoreWay, last + DVec2::new(26.0, 0.0) / self.view.scale));
            }
            Some(Kind::Stream) => handles.push((Handle::Reach, stream_zone(&self.document, row, place).1)),
            Some(Kind::Switch) => {
                handles.push((Handle::Wire, place.centre() - DVec2::new(0.0, clear.y + 22.0 / self.view.scale)));
            }
            Some(Kind::Link) => {
                let ends = self.document.link_ends(row).into_iter().flatten();
                handles.extend(ends.enumerate().map(|(end, point)| (Handle::End(end), point)));
            }
            _ => {}
        }
        handles
    }

    /// The cells after a handle has been dragged there, and the handle that is dragged from then on.
    pub(super) fn handle_moved(&self, row: RowId, handle: Handle, from: Place, at: DVec2) -> (Handle, Vec<SetCell>) {
        match handle {
            Handle::Size(side) => {
                let by_centre = self.document.kind(row).is_some_and(Kind::by_centre);
                let along = |axis: usize| {
                    let (near, far) = (from.min[axis], from.max()[axis]);
                    let (fixed, away) = if side[axis] < 0.0 { (far, -1.0) } else { (near, 1.0) };
                    let mut size = ((at[axis] - fixed) * away).max(1.0);
                    if by_centre {
                        // Its cells name its middle: that is to be a whole pixel.
                        let half = ((fixed + 0.5 * size * away).round() - fixed) * away;
                        size = 2.0 * if half < 0.5 { half + 1.0 } else { half };
                    }
                    match side[axis] {
                        0.0 => (near, far),
                        side if side < 0.0 => (far - size, far),
                        _ => (near, near + size),
                    }
                };
                let ((left, right), (top, bottom)) = (along(0), along(1));
                let to = Place { min: DVec2::new(left, top), size: DVec2::new(right - left, bottom - top) };
                (handle, self.document.placed(row, to))
            }
            Handle::Way(index) => {
                let mut way = self.document.way_points(row);
                if let Some(point) = way.get_mut(index) {
                    *point = at - (from.size * 0.5).floor();
                }
                (handle, vec![SetCell { row, column: "way_points", text: way_text(&way) }])
            }
            Handle::MoreWay => {
                let mut way = self.document.way_points(row);
                way.push(at - (from.size * 0.5).floor());
                (Handle::Way(way.len() - 1), vec![SetCell { row, column: "way_points", text: way_text(&way) }])
            }
            Handle::Reach => {
                let away = at - from.centre();
                // The axis along which it is pulled further out of the source, in sizes of the source.
                let across = away.x.abs() / from.size.x > away.y.abs() / from.size.y;
                let beyond = |axis: usize| {
                    if away[axis] < 0.0 { (at[axis] - from.min[axis]).min(-1.0) } else { (at[axis] - from.max()[axis]).max(1.0) }
                };
                let (wide, high) = if across { (beyond(0), 0.0) } else { (0.0, beyond(1)) };
                let cell = |column, value| SetCell { row, column, text: number(value) };
                (handle, vec![cell("stream_width", wide), cell("stream_height", high)])
            }
            Handle::Wire | Handle::End(_) => (handle, Vec::new()),
        }
    }
}

const SIDES: [DVec2; 8] = [
    DVec2::new(-1.0, 0.0),
    DVec2::new(1.0, 0.0),
    DVec2::new(0.0, -1.0),
    DVec2::new(0.0, 1.0),
    DVec2::new(-1.0, -1.0),
    DVec2::new(1.0, -1.0),
    DVec2::new(-1.0, 1.0),
    DVec2::new(1.0, 1.0),
];

/// The zone in which a stream blows, and the middle of its far end, pixels.
pub fn stream_zone(document: &Document, row: RowId, place: Place) -> (Place, DVec2) {
    let reach = DVec2::from(["stream_width", "stream_height"].map(|column| document.number(row, column).unwrap_or_default()));
    let (centre, half) = (place.centre(), place.size * 0.5);
    let side = reach.signum() * DVec2::new(f64::from(u8::from(reach.x != 0.0)), f64::from(u8::from(reach.y != 0.0)));
    let end = centre + side * half + reach;
    let across = DVec2::new(if reach.x == 0.0 { half.x } else { 0.0 }, if reach.y == 0.0 { half.y } else { 0.0 });
    (Place::between(centre + side * half - across, end + across), end)
}
