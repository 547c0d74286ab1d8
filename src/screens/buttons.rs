//! Buttons by mouse and by keyboard: one press, one action.

use super::input::{ButtonAnswer, Input};
use crate::draw::layout::{Area, Vec2};
use crate::settings::Key;

/// A group of buttons; which one does what is the screen's affair, by its index. One of them is highlighted: the keyboard and the pointer
/// move the same highlight, whichever moved last.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Buttons {
    areas: Vec<Area>,
    focus: usize,
    hover: Option<usize>,
    /// Where the pointer was; `None` before the first frame, so that a pointer that rests takes nothing from the keyboard.
    pointer: Option<Vec2>,
}

impl Buttons {
    /// Buttons whose places are given with [`Buttons::place`]; the keyboard is on the one of that index.
    pub fn focused_on(focus: usize) -> Self {
        Self { focus, ..Self::default() }
    }

    /// Puts the keyboard on the button of that index.
    pub fn focus_on(&mut self, focus: usize) {
        self.focus = focus.min(self.areas.len().saturating_sub(1));
    }

    /// Puts the buttons where they are in this frame. The keyboard stays on a button that there is.
    pub fn place(&mut self, areas: Vec<Area>) {
        self.focus = self.focus.min(areas.len().saturating_sub(1));
        self.hover = self.hover.filter(|hover| *hover < areas.len());
        self.areas = areas;
    }

    /// Follows pointer and keys; the index of the button that was pressed.
    pub fn update(&mut self, input: &Input) -> Option<usize> {
        let before = (self.hover, self.focus);
        let pressed = self.follow(input);
        if pressed.is_some() {
            input.answer(ButtonAnswer::Pressed);
        } else if self.focus != before.1 || self.hover != before.0 && self.hover.is_some() {
            input.answer(ButtonAnswer::Moved);
        }
        pressed
    }

    fn follow(&mut self, input: &Input) -> Option<usize> {
        let under = self.areas.iter().position(|area| area.contains(input.pointer));
        let moved = self.pointer.replace(input.pointer).is_some_and(|before| before != input.pointer);
        if moved || input.click || under != self.hover {
            self.hover = under.filter(|_| moved || input.click);
            self.focus = self.hover.unwrap_or(self.focus);
        }
        if input.click && under.is_some() {
            return under;
        }
        for (key, direction) in [(Key::Up, Vec2::NEG_Y), (Key::Down, Vec2::Y), (Key::Left, Vec2::NEG_X), (Key::Right, Vec2::X)] {
            if input.pressed(key) {
                self.hover = None;
                self.focus = self.neighbour(direction).unwrap_or(self.focus);
            }
        }
        (input.pressed(Key::Enter) && self.focus < self.areas.len()).then_some(self.focus)
    }

    /// Where the buttons are.
    pub fn areas(&self) -> &[Area] {
        &self.areas
    }

    /// The button under the pointer, if the pointer moved last; then it is also the one that has the keyboard.
    pub fn hover(&self) -> Option<usize> {
        self.hover
    }

    /// The button that has the keyboard.
    pub fn focus(&self) -> usize {
        self.focus
    }

    /// The nearest button in a direction; one that lies straight ahead goes before one aside.
    fn neighbour(&self, direction: Vec2) -> Option<usize> {
        let from = self.areas.get(self.focus)?.centre();
        let distance = |area: &Area| {
            let way = area.centre() - from;
            let ahead = way.dot(direction);
            (ahead > 1.0).then(|| ahead + 2.0 * (way - direction * ahead).length())
        };
        let candidates = self.areas.iter().enumerate().filter_map(|(i, area)| Some((i, distance(area)?)));
        candidates.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::Frame;

    fn press(key: Key) -> Input {
        Input { pressed: [key].into_iter().collect(), pointer: Vec2::splat(-1.0), ..Input::default() }
    }

    #[test]
    fn arrows_walk_a_grid_and_stop_at_its_edges() {
        let mut buttons = Buttons::default();
        buttons.place((0..6).map(|i| Area::new((i % 3) as f32 * 200.0, (i / 3) as f32 * 100.0, 90.0, 40.0)).collect());
        for (key, focus) in
            [(Key::Right, 1), (Key::Down, 4), (Key::Right, 5), (Key::Right, 5), (Key::Down, 5), (Key::Up, 2), (Key::Left, 1)]
        {
            let (input, before) = (press(key), buttons.focus());
            assert_eq!(buttons.update(&input), None);
            assert_eq!(buttons.focus(), focus, "{key:?}");
            assert_eq!(input.answer.get(), (focus != before).then_some(ButtonAnswer::Moved), "{key:?}");
        }
        let enter = press(Key::Enter);
        assert_eq!((buttons.update(&enter), enter.answer.get()), (Some(1), Some(ButtonAnswer::Pressed)));
    }

    #[test]
    fn the_mouse_presses_what_is_under_it_and_nothing_else() {
        let mut buttons = Buttons::default();
        buttons.place(Frame::default().column(3, 100.0));
        let at = |pointer, click| Input { pointer, click, ..Input::default() };
        let second = buttons.areas()[1].centre();
        assert_eq!(buttons.update(&at(second, false)), None);
        assert_eq!((buttons.hover(), buttons.focus()), (None, 0), "it rests there");
        assert_eq!(buttons.update(&at(second + 1.0, false)), None);
        assert_eq!((buttons.hover(), buttons.focus()), (Some(1), 1), "one highlight");
        assert_eq!(buttons.update(&Input { pointer: second + 1.0, ..press(Key::Up) }), None);
        assert_eq!((buttons.hover(), buttons.focus()), (None, 0), "one highlight");
        assert_eq!(buttons.update(&at(second, true)), Some(1));
        assert_eq!(buttons.update(&at(Vec2::ZERO, true)), None);
        assert_eq!(buttons.hover(), None);
    }

    #[test]
    fn without_buttons_nothing_is_pressed() {
        let mut buttons = Buttons::default();
        assert_eq!(buttons.update(&press(Key::Enter)), None);
        assert_eq!(buttons.update(&press(Key::Down)), None);
    }
}
