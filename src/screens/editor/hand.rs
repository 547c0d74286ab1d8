//! The pointer in the picture: it selects, moves, sizes, draws, and pulls links and handles.

use super::{Editor, handles::GRAB, handles::Handle, tools::EditorTool, view::Snap};
use crate::level::document::{Kind, LinkForm, Place, RowId, Table};
use crate::{draw::layout::Vec2, physics::DVec2, settings::Key, ui::input::Input, words::tr};

/// A drag shorter than this is a click, canvas units.
const CLICK: f32 = 4.0;
/// How near an edge has to be to be snapped to, canvas units.
const SNAP_REACH: f64 = 7.0;

#[derive(Clone, Debug)]
pub enum PointerDrag {
    /// The view, from where the pointer was.
    Pan(Vec2),
    /// A frame that selects the things inside it, from that point; the rows selected before stay so.
    Frame(DVec2, Vec<RowId>),
    /// The selected things; where the first of them was, and where it was grabbed; whether copies of them are moved.
    Move { from: Place, grabbed: DVec2, begun: Vec2, moved: bool, doubles: bool },
    /// Of a thing, which lay there: from the pointer to the handle's point, pixels; where the pointer was, and whether it has left a click's reach.
    Handle { row: RowId, handle: Handle, from: Place, offset: DVec2, begun: Vec2, moved: bool },
    /// A new thing, from that point, snapped and as it was pressed.
    Draw(Kind, [DVec2; 2]),
    /// A new link, from that point.
    Link(LinkForm, DVec2),
}

impl Editor {
    pub(super) fn put(&mut self, kind: Kind, place: Place) {
        match self.document.put(kind, place) {
            Ok(row) => self.selection = row.into_iter().collect(),
            Err(refusal) => self.say(refusal),
        }
    }

    /// The smallest thing at a point, pixels.
    fn thing_at(&self, at: DVec2) -> Option<RowId> {
        let slack = DVec2::splat(f64::from(CLICK) / self.view.scale);
        let near =
            self.at_hand().filter(|(_, place)| Place { min: place.min - slack, size: place.size + 2.0 * slack }.contains(at));
        smallest(near).or_else(|| self.link_near(at, slack.x))
    }

    /// The link whose line passes a point this near, pixels.
    fn link_near(&self, at: DVec2, slack: f64) -> Option<RowId> {
        self.at_hand().map(|(row, _)| row).filter(|row| row.table == Table::Links).find(|row| {
            self.document.link_ends(*row).is_some_and(|[a, b]| {
                let share = ((at - a).dot(b - a) / a.distance_squared(b).max(1.0)).clamp(0.0, 1.0);
                (a + (b - a) * share).distance(at) <= slack
            })
        })
    }

    fn snap(&self, input: &Input, without: &[RowId]) -> Snap {
        let visible = self.view.visible();
        let level = Place { min: DVec2::ZERO, size: self.document.size() };
        let others =
            self.document.things().filter(|(row, place)| !without.contains(row) && place.meets(&visible)).map(|(_, place)| place);
        let on = self.snapping != input.held(Key::Control);
        Snap::new(on, SNAP_REACH / self.view.scale, others.chain([level]))
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
        self.gesture += 1;
        match self.tool {
            EditorTool::Add(kind) => {
                let from = self.snap(input, &[]).point(at);
                return self.drag = Some(PointerDrag::Draw(kind, [from, at.round()]));
            }
            EditorTool::Link(form) => return self.drag = Some(PointerDrag::Link(form, at)),
            EditorTool::Select | EditorTool::Fly => {}
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
            (true, Some(_)) => {
                let known = std::mem::take(&mut self.selection);
                self.select(&[row]);
                let whole = std::mem::replace(&mut self.selection, known);
                return self.selection.retain(|known| !whole.contains(known));
            }
            (true, None) => self.select(&[self.selection.as_slice(), &[row]].concat()),
            (false, None) if under.is_none() || self.selection.len() == 1 => self.select(&[row]),
            (false, _) => {}
        }
        if let Some(from) = self.selection.first().and_then(|row| self.document.place(*row)) {
            let doubles = input.held(Key::Alt);
            self.drag = Some(PointerDrag::Move { from, grabbed: at, begun: input.pointer, moved: false, doubles });
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
                let within = self.at_hand().filter(|(_, place)| frame.contains(place.min) && frame.contains(place.max()));
                let mut rows: Vec<RowId> = kept.iter().copied().chain(within.map(|(row, _)| row)).collect();
                rows.sort_unstable();
                rows.dedup();
                self.select(&rows);
                self.drag = held.then_some(PointerDrag::Frame(from, kept));
            }
            PointerDrag::Move { from, grabbed, begun, moved, doubles } => {
                let begins = !moved && input.pointer.distance(begun) > CLICK;
                let moved = moved || begins;
                if begins && doubles {
                    self.double(DVec2::ZERO, Some(self.gesture));
                }
                if moved {
                    let first = self.selection.first().copied();
                    let by_centre = first.and_then(|row| self.document.kind(row)).is_some_and(Kind::by_centre);
                    let to = Place { min: from.min + at - grabbed, ..from };
                    let to = self.snap(input, &self.document.with_ends(&self.selection)).moved(to, by_centre);
                    let now = first.and_then(|row| self.document.place(row)).unwrap_or(from);
                    let by = to.min - now.min;
                    // Several move by whole pixels: each that lay on a whole pixel still does.
                    self.shift_selection(if self.selection.len() > 1 { by.round() } else { by });
                }
                self.drag = held.then_some(PointerDrag::Move { from, grabbed, begun, moved, doubles });
            }
            PointerDrag::Handle { row, mut handle, from, offset, begun, moved } => {
                let moved = moved || input.pointer.distance(begun) > CLICK;
                if moved && matches!(handle, Handle::Wire | Handle::End(_)) {
                    // Only where it is let go it changes something.
                    if !held {
                        return self.end_led(row, handle, self.link_end(input, at));
                    }
                } else if moved {
                    let at = self.snap(input, &[row]).point(at + offset);
                    let (next, cells) = self.handle_moved(row, handle, from, at);
                    self.set(&cells);
                    handle = next;
                }
                self.drag = held.then_some(PointerDrag::Handle { row, handle, from, offset, begun, moved });
            }
            PointerDrag::Draw(kind, [from, pressed]) => {
                if held {
                    self.drag = Some(PointerDrag::Draw(kind, [from, pressed]));
                    return;
                }
                let to = self.snap(input, &[]).point(at);
                // Both ends of a low pad may snap to one edge: then it begins where it was pressed.
                let flat = (to - from).abs().cmplt(DVec2::ONE)
                    & ((at - pressed).abs() * self.view.scale).cmpge(DVec2::splat(f64::from(CLICK)));
                let mut place = Place::between(DVec2::select(flat, pressed, from), to);
                let drawn = place.size * self.view.scale;
                if drawn.max_element() < f64::from(CLICK) * 2.0 {
                    // Put down with a click: by the point that its cells name.
                    let size = DVec2::from(kind.schema().usual_size);
                    place = Place { min: if kind.by_centre() { from - size * 0.5 } else { from }, size };
                }
                self.put(kind, place);
            }
            PointerDrag::Link(form, from) => {
                if held {
                    return self.drag = Some(PointerDrag::Link(form, from));
                }
                match self.document.link(form, [from, at].map(|end| self.link_end(input, end)), self.gesture) {
                    Ok(rows) => self.selection = rows,
                    Err(refusal) => self.say(refusal),
                }
            }
        }
    }

    /// The end of a link at a point, pixels: in a body as it is, else snapped.
    fn link_end(&self, input: &Input, at: DVec2) -> DVec2 {
        if self.document.body_at(at).is_some() { at } else { self.snap(input, &[]).point(at) }
    }

    fn end_led(&mut self, row: RowId, handle: Handle, at: DVec2) {
        if let Handle::End(end) = handle {
            match self.document.led(row, end, at) {
                Ok(cells) => self.set(&cells),
                Err(refusal) => self.say(refusal),
            }
            return;
        }
        let near = self.document.things().filter(|(thing, place)| self.document.can_be_worked(*thing) && place.contains(at));
        match smallest(near) {
            Some(thing) => {
                let cells = self.document.rewired(row, thing);
                self.set(&cells);
            }
            None => {
                self.say(tr("A switch works movers, doors, air streams, links and blocks with a belt: pull its wire onto one."))
            }
        }
    }
}

fn smallest(things: impl Iterator<Item = (RowId, Place)>) -> Option<RowId> {
    things.min_by(|(_, a), (_, b)| a.size.element_product().total_cmp(&b.size.element_product())).map(|(row, _)| row)
}
