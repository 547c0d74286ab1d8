//! The pointer in the picture: it selects, moves, sizes, draws, and drags way points, streams' ends and wires.

use super::view::Snap;
use super::{Editor, EditorTool};
use crate::draw::layout::Vec2;
use crate::level::document::{Document, Kind, Place, RowId, SetCell, number, way_text};
use crate::physics::DVec2;
use crate::settings::Key;
use crate::ui::input::Input;
use crate::words::tr;

/// How near to a handle the pointer has to be, canvas units.
const GRAB: f32 = 9.0;
/// A drag shorter than this is a click, canvas units.
const CLICK: f32 = 4.0;
/// From the middle of a thing to its handles, at least, canvas units: on a small thing they stand outside, and its middle moves it.
const CLEAR: f32 = 2.0 * GRAB;
/// How near an edge has to be to be snapped to, canvas units.
const SNAP_REACH: f64 = 7.0;

/// A point of a selected thing that can be dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Handle {
    /// A corner or side: which edges it moves, −1 … 1 along each axis.
    Size(DVec2),
    Way(usize),
    MoreWay,
    Reach,
    Wire,
}

#[derive(Clone, Debug)]
pub enum PointerDrag {
    /// The view, from where the pointer was.
    Pan(Vec2),
    /// A frame that selects the things inside it, from that point; the rows selected before stay so.
    Frame(DVec2, Vec<RowId>),
    /// The selected things; where the first of them was, and where it was grabbed.
    Move { from: Place, grabbed: DVec2, begun: Vec2, moved: bool },
    /// A handle of a thing, which lay there: from the pointer to the point that the handle stands for, pixels; where the pointer was, and
    /// whether it has left the reach of a click.
    Handle { row: RowId, handle: Handle, from: Place, offset: DVec2, begun: Vec2, moved: bool },
    /// A new thing, from that point.
    Draw(Kind, DVec2),
}

impl Editor {
    pub(super) fn put(&mut self, kind: Kind, place: Place) {
        match self.document.put(kind, place) {
            Ok(row) => {
                self.selection = row.into_iter().collect();
                self.tool = EditorTool::Select;
            }
            Err(refusal) => self.say(refusal),
        }
    }

    /// The handles of the selection, and where they are, pixels: one thing alone has some.
    pub fn handles(&self) -> Vec<(Handle, DVec2)> {
        let [row] = self.selection[..] else { return Vec::new() };
        let Some(place) = self.document.place(row) else { return Vec::new() };
        let mut handles = Vec::new();
        let clear = (place.size * 0.5).max(DVec2::splat(f64::from(CLEAR) / self.view.scale()));
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
                handles.push((Handle::MoreWay, last + DVec2::new(26.0, 0.0) / self.view.scale()));
            }
            Some(Kind::Stream) => handles.push((Handle::Reach, stream_zone(&self.document, row, place).1)),
            Some(Kind::Switch) => {
                handles.push((Handle::Wire, place.centre() - DVec2::new(0.0, clear.y + 22.0 / self.view.scale())));
            }
            _ => {}
        }
        handles
    }

    /// The smallest thing at a point, pixels.
    fn thing_at(&self, at: DVec2) -> Option<RowId> {
        let slack = DVec2::splat(f64::from(CLICK) / self.view.scale());
        let near = self
            .document
            .things()
            .filter(|(_, place)| Place { min: place.min - slack, size: place.size + 2.0 * slack }.contains(at));
        smallest(near)
    }

    fn snap(&self, input: &Input, without: &[RowId]) -> Snap {
        let visible = self.view.visible();
        let level = Place { min: DVec2::ZERO, size: self.document.size() };
        let others =
            self.document.things().filter(|(row, place)| !without.contains(row) && place.meets(&visible)).map(|(_, place)| place);
        let on = self.snapping != input.held(Key::Alt);
        Snap::new(on, SNAP_REACH / self.view.scale(), others.chain([level]))
    }

    pub(super) fn update_hand(&mut self, input: &Input) {
        let inside = self.panes.middle.contains(input.pointer);
        let at = self.view.pixels(input.pointer);
        if inside && input.wheel != 0.0 {
            self.view.zoom(f64::from(input.wheel), input.pointer);
        }
        match self.drag.take() {
            Some(drag) => self.drag_on(drag, input, at),
            None if inside && input.click && input.held(Key::Space) => self.drag = Some(PointerDrag::Pan(input.pointer)),
            None if inside && input.click => self.take_hold(input, at),
            None if inside && input.dragging => {
                self.drag = Some(PointerDrag::Pan(input.pointer));
                if input.right_click && self.tool != EditorTool::Select {
                    self.tool = EditorTool::Select;
                }
            }
            None => {}
        }
    }

    fn take_hold(&mut self, input: &Input, at: DVec2) {
        self.next_gesture();
        if let EditorTool::Add(kind) = self.tool {
            let from = self.snap(input, &[]).point(at);
            self.drag = Some(PointerDrag::Draw(kind, from));
            return;
        }
        let near = |point: DVec2| self.view.point(point).distance(input.pointer) <= GRAB;
        let handle = self.handles().into_iter().rev().find(|(_, point)| near(*point));
        if let (Some((handle, shown)), [row]) = (handle, &self.selection[..])
            && let Some(from) = self.document.place(*row)
        {
            // A handle of a small thing stands beside the edge that it moves.
            let point = if let Handle::Size(side) = handle { from.centre() + side * from.size * 0.5 } else { shown };
            self.drag =
                Some(PointerDrag::Handle { row: *row, handle, from, offset: point - at, begun: input.pointer, moved: false });
            return;
        }
        let more = input.held(Key::Shift) || input.held(Key::Control);
        let Some(row) = self.thing_at(at) else {
            if !more {
                self.selection.clear();
            }
            let kept = self.selection.clone();
            self.drag = Some(PointerDrag::Frame(at, kept));
            return;
        };
        // A thing of several that are selected takes the others along.
        let under = self.selection.iter().find(|row| self.document.place(**row).is_some_and(|place| place.contains(at)));
        match (more, self.selection.iter().position(|known| *known == row)) {
            (true, Some(known)) => {
                let mut fewer = self.selection.clone();
                fewer.remove(known);
                self.selection = fewer;
                return;
            }
            (true, None) => self.selection.push(row),
            (false, None) if under.is_none() || self.selection.len() == 1 => self.selection = vec![row],
            (false, _) => {}
        }
        if let Some(from) = self.selection.first().and_then(|row| self.document.place(*row)) {
            self.drag = Some(PointerDrag::Move { from, grabbed: at, begun: input.pointer, moved: false });
        }
    }

    fn drag_on(&mut self, drag: PointerDrag, input: &Input, at: DVec2) {
        let held = if matches!(drag, PointerDrag::Pan(_)) { input.holding || input.dragging } else { input.holding };
        match drag {
            PointerDrag::Pan(from) => {
                if held {
                    self.view.pan(input.pointer - from);
                    self.drag = Some(PointerDrag::Pan(input.pointer));
                }
            }
            PointerDrag::Frame(from, kept) => {
                let frame = Place::between(from, at);
                let within = self.document.things().filter(|(_, place)| frame.contains(place.min) && frame.contains(place.max()));
                let mut rows: Vec<RowId> = kept.iter().copied().chain(within.map(|(row, _)| row)).collect();
                rows.sort_unstable();
                rows.dedup();
                self.selection = rows;
                self.drag = held.then_some(PointerDrag::Frame(from, kept));
            }
            PointerDrag::Move { from, grabbed, begun, moved } => {
                let moved = moved || input.pointer.distance(begun) > CLICK;
                if moved {
                    let first = self.selection.first().copied();
                    let by_centre = first.and_then(|row| self.document.kind(row)).is_some_and(Kind::by_centre);
                    let to = Place { min: from.min + at - grabbed, ..from };
                    let to = self.snap(input, &self.selection).moved(to, by_centre);
                    let now = first.and_then(|row| self.document.place(row)).unwrap_or(from);
                    let by = to.min - now.min;
                    // Several move by whole pixels: each that lay on a whole pixel still does.
                    self.shift_selection(if self.selection.len() > 1 { by.round() } else { by });
                }
                self.drag = held.then_some(PointerDrag::Move { from, grabbed, begun, moved });
            }
            PointerDrag::Handle { row, mut handle, from, offset, begun, moved } => {
                let moved = moved || input.pointer.distance(begun) > CLICK;
                if moved && handle == Handle::Wire {
                    if !held {
                        return self.end_wire(row, at);
                    }
                } else if moved {
                    let at = self.snap(input, &[row]).point(at + offset);
                    let (next, cells) = self.handle_moved(row, handle, from, at);
                    self.set(&cells);
                    handle = next;
                }
                self.drag = held.then_some(PointerDrag::Handle { row, handle, from, offset, begun, moved });
            }
            PointerDrag::Draw(kind, from) => {
                if held {
                    self.drag = Some(PointerDrag::Draw(kind, from));
                    return;
                }
                let to = self.snap(input, &[]).point(at);
                let mut place = Place::between(from, to);
                let drawn = place.size * self.view.scale();
                if drawn.max_element() < f64::from(CLICK) * 2.0 {
                    // Put down with a click: by the point that its cells name.
                    let size = DVec2::from(kind.schema().usual_size);
                    place = Place { min: if kind.by_centre() { from - size * 0.5 } else { from }, size };
                }
                self.put(kind, place);
            }
        }
    }

    fn end_wire(&mut self, row: RowId, at: DVec2) {
        let near = self.document.things().filter(|(thing, place)| self.document.can_be_worked(*thing) && place.contains(at));
        match smallest(near) {
            Some(thing) => {
                let cells = self.document.rewired(row, thing);
                self.set(&cells);
            }
            None => self.say(tr("A switch works movers, doors, air streams and blocks with a belt: pull its wire onto one.")),
        }
    }

    /// The cells after a handle has been dragged there, and the handle that is dragged from then on.
    fn handle_moved(&self, row: RowId, handle: Handle, from: Place, at: DVec2) -> (Handle, Vec<SetCell>) {
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
            Handle::Wire => (handle, Vec::new()),
        }
    }
}

/// Corners and sides, as in [`Handle::Size`].
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

fn smallest(things: impl Iterator<Item = (RowId, Place)>) -> Option<RowId> {
    things.min_by(|(_, a), (_, b)| a.size.element_product().total_cmp(&b.size.element_product())).map(|(row, _)| row)
}

/// The zone in which a stream blows, and the middle of its far end, pixels.
pub fn stream_zone(document: &Document, row: RowId, place: Place) -> (Place, DVec2) {
    let reach = DVec2::new(
        document.number(row, "stream_width").unwrap_or_default(),
        document.number(row, "stream_height").unwrap_or_default(),
    );
    let (centre, half) = (place.centre(), place.size * 0.5);
    let side = reach.signum() * DVec2::new(f64::from(u8::from(reach.x != 0.0)), f64::from(u8::from(reach.y != 0.0)));
    let end = centre + side * half + reach;
    let across = DVec2::new(if reach.x == 0.0 { half.x } else { 0.0 }, if reach.y == 0.0 { half.y } else { 0.0 });
    (Place::between(centre + side * half - across, end + across), end)
}
