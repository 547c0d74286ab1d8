//! A list that is longer than its window: its first line in view, by keys, wheel and a bar that can be dragged.

use super::input::{Input, Repeat};
use crate::{draw::layout::Area, draw::layout::Vec2, settings::Key};

const WHEEL_LINES: f32 = 3.0;
/// Canvas units.
pub const BAR_WIDTH: f32 = 12.0;
/// The handle is never shorter, so that the pointer can take it.
const SHORTEST_HANDLE: f32 = 32.0;
const KEYS: [Key; 6] = [Key::Up, Key::Down, Key::PageUp, Key::PageDown, Key::Home, Key::End];

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    pub track: Area,
    /// Shows and moves the part in view.
    pub handle: Area,
    pub held: bool,
}

/// The part of a list in view; never past either end.
#[derive(Clone, Debug, Default)]
pub struct Scroll {
    first: usize,
    lines: usize,
    page: usize,
    track: Area,
    /// The fraction of a line that the wheel has turned so far.
    turned: f32,
    /// Where the pointer holds the handle, from its top.
    grabbed: Option<f32>,
    repeat: Repeat,
    /// Whether keys turn whole pages, each of which begins at a multiple of its length.
    pub(super) pages: bool,
    /// A line to be shown once the page is known.
    wanted: Option<usize>,
}

impl Scroll {
    /// `page` lines fit; the bar runs on `track`.
    pub fn place(&mut self, lines: usize, page: usize, track: Area) {
        (self.lines, self.page, self.track) = (lines, page, track);
        if let Some(line) = self.wanted.take_if(|_| page > 0) {
            self.show(line);
        }
        // Where there are pages, the first line of the last one.
        let last_page = lines.saturating_sub(1) / page.max(1) * page;
        self.first = self.first.min(if self.pages { last_page } else { self.last_first() });
    }

    /// Brings a line into view, in the middle where that can be.
    pub fn show(&mut self, line: usize) {
        if self.page == 0 {
            self.wanted = Some(line);
        }
        self.first =
            if self.pages { line - line % self.page.max(1) } else { line.saturating_sub(self.page / 2).min(self.last_first()) };
    }

    /// Scrolls as little as brings a line into view.
    pub fn bring(&mut self, line: usize) {
        self.first = self.first.clamp((line + 1).saturating_sub(self.page), line);
    }

    pub fn update(&mut self, input: &Input) {
        for key in self.repeat.strokes(input, &KEYS) {
            match key {
                Key::Up | Key::PageUp if self.pages => self.first = self.first.saturating_sub(1) / self.page.max(1) * self.page,
                Key::Down | Key::PageDown if self.pages => {
                    let next = (self.first / self.page.max(1) + 1) * self.page;
                    // A view of the last line has no next page.
                    self.first = if self.first + self.page < self.lines { next } else { self.first };
                }
                Key::Up => self.by(-1),
                Key::Down => self.by(1),
                Key::PageUp => self.by(-(self.page as isize)),
                Key::PageDown => self.by(self.page as isize),
                Key::Home => self.first = 0,
                Key::End => self.first = self.last_first(),
                _ => {}
            }
        }
        self.turned -= input.wheel * WHEEL_LINES;
        if self.turned.trunc() != 0.0 {
            self.by(self.turned.trunc() as isize);
        }
        self.turned = self.turned.fract();
        self.drag(input);
    }

    pub fn range(&self) -> std::ops::Range<usize> {
        self.first..(self.first + self.page).min(self.lines)
    }

    /// `None` when all lines are in view.
    pub fn bar(&self) -> Option<Bar> {
        let last = self.last_first();
        if last == 0 {
            return None;
        }
        let first = self.first.min(last);
        let height = (self.track.size.y * self.page as f32 / self.lines as f32).max(SHORTEST_HANDLE).min(self.track.size.y);
        let top = self.track.min.y + (self.track.size.y - height) * first as f32 / last as f32;
        let handle = Area::new(self.track.min.x, top, self.track.size.x, height);
        Some(Bar { track: self.track, handle, held: self.grabbed.is_some() })
    }

    fn drag(&mut self, input: &Input) {
        let Some(Bar { track, handle, .. }) = self.bar() else {
            self.grabbed = None;
            return;
        };
        if input.click && track.contains(input.pointer) {
            // Beside the handle the bar jumps to the pointer, which then holds its middle.
            let on_handle = handle.contains(input.pointer);
            self.grabbed = Some(if on_handle { input.pointer.y - handle.min.y } else { handle.size.y / 2.0 });
        }
        if !input.holding && !input.click {
            self.grabbed = None;
        }
        if let Some(grabbed) = self.grabbed {
            let room = track.size.y - handle.size.y;
            let part = if room > 0.0 { ((input.pointer.y - grabbed - track.min.y) / room).clamp(0.0, 1.0) } else { 0.0 };
            self.first = (part * self.last_first() as f32).round() as usize;
        }
    }

    fn by(&mut self, lines: isize) {
        self.first = self.first.saturating_add_signed(lines).min(self.last_first());
    }

    /// The first line at which the wheel and the bar end, with a full view.
    fn last_first(&self) -> usize {
        self.lines.saturating_sub(self.page)
    }
}

/// A bar at the right edge inside a panel.
pub fn bar_beside(panel: Area, top: f32, bottom: f32) -> Area {
    Area { min: Vec2::new(panel.max().x - BAR_WIDTH - 8.0, top), size: Vec2::new(BAR_WIDTH, bottom - top) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn long_list() -> Scroll {
        let mut scroll = Scroll::default();
        scroll.place(25, 10, Area::new(500.0, 100.0, 12.0, 300.0));
        scroll
    }

    fn press(key: Key) -> Input {
        Input { pressed: [key].into_iter().collect(), ..Input::default() }
    }

    #[test]
    fn keys_scroll_and_stop_at_both_ends() {
        let mut scroll = long_list();
        scroll.update(&press(Key::Up));
        assert_eq!(scroll.range(), 0..10);
        scroll.update(&press(Key::Down));
        assert_eq!(scroll.range(), 1..11);
        for _ in 0..5 {
            scroll.update(&press(Key::PageDown));
        }
        assert_eq!(scroll.range(), 15..25);
        scroll.update(&press(Key::Home));
        assert_eq!(scroll.range(), 0..10);
        scroll.update(&press(Key::End));
        scroll.update(&press(Key::Down));
        assert_eq!(scroll.range(), 15..25);
    }

    #[test]
    fn the_wheel_adds_up_parts_of_notches() {
        let mut scroll = long_list();
        let turn = |wheel| Input { wheel, ..Input::default() };
        scroll.update(&turn(-1.0));
        assert_eq!(scroll.range().start, 3);
        scroll.update(&turn(-0.25));
        assert_eq!(scroll.range().start, 3);
        scroll.update(&turn(-0.25));
        assert_eq!(scroll.range().start, 4);
        scroll.update(&turn(100.0));
        assert_eq!(scroll.range().start, 0);
        scroll.update(&turn(-100.0));
        assert_eq!(scroll.range().start, 15);
    }

    #[test]
    fn the_handle_follows_the_pointer_while_it_is_held() {
        let mut scroll = long_list();
        let at = |y, click, holding| Input { pointer: Vec2::new(505.0, y), click, holding, ..Input::default() };
        scroll.update(&at(110.0, true, true));
        assert_eq!(scroll.range().start, 0, "grabbed, not moved");
        scroll.update(&at(110.0 + 90.0, false, true));
        assert_eq!(scroll.range().start, 8, "half of the way of 180 is half of 15 lines");
        scroll.update(&at(5000.0, false, true));
        assert_eq!(scroll.range().start, 15);
        scroll.update(&at(-5000.0, false, true));
        assert_eq!(scroll.range().start, 0);
        scroll.update(&at(300.0, false, false));
        assert_eq!(scroll.range().start, 0, "let go");
    }

    #[test]
    fn a_short_list_does_not_scroll() {
        let mut scroll = Scroll::default();
        scroll.place(10, 10, Area::new(500.0, 100.0, 12.0, 300.0));
        scroll.update(&press(Key::End));
        scroll.update(&Input { wheel: -5.0, ..Input::default() });
        assert_eq!((scroll.range(), scroll.bar()), (0..10, None));
    }

    #[test]
    fn keys_turn_aligned_pages() {
        let mut scroll = Scroll { pages: true, ..Scroll::default() };
        scroll.place(24, 10, Area::new(500.0, 100.0, 12.0, 300.0));
        let mut after = |key: Key| {
            scroll.update(&press(key));
            scroll.range()
        };
        assert_eq!([Key::Down, Key::PageDown, Key::Down].map(&mut after), [10..20, 20..24, 20..24]);
        assert_eq!([Key::Up, Key::PageUp, Key::Up].map(&mut after), [10..20, 0..10, 0..10]);
        scroll.update(&Input { wheel: -1.0, ..Input::default() });
        assert_eq!(scroll.range(), 3..13, "the wheel turns lines");
        scroll.update(&press(Key::Down));
        assert_eq!(scroll.range(), 10..20, "and the keys are aligned again");
        scroll.update(&Input { wheel: -1.0, ..Input::default() });
        scroll.update(&press(Key::Up));
        assert_eq!(scroll.range(), 10..20);
        scroll.update(&press(Key::End));
        assert_eq!(scroll.range(), 14..24);
        for (line, page) in [(0, 0..10), (9, 0..10), (10, 10..20), (23, 20..24)] {
            scroll.show(line);
            assert_eq!(scroll.range(), page);
        }
    }

    #[test]
    fn a_line_is_brought_into_view() {
        let mut scroll = long_list();
        for (line, first) in [(0, 0), (12, 7), (24, 15)] {
            scroll.show(line);
            assert_eq!(scroll.range().start, first);
            assert!(scroll.range().contains(&line));
        }
    }
}
