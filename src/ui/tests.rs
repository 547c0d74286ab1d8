use super::*;
use crate::draw::layout::Vec2;
use crate::ui::input::ButtonAnswer;
use crate::ui::text_field::TextField;

/// A screen of one function, and its memory.
#[derive(Default)]
struct Sitting {
    memory: Memory,
}

impl Sitting {
    /// One frame: the pass that acts, then those that show.
    fn give<T>(&mut self, input: &Input, mut screen: impl FnMut(&mut Ui<'_>) -> T) -> T {
        let canvas = Canvas::new(input.frame);
        let acted = self.memory.act(PassInput { input, canvas: &canvas, spectator: &mut (), time: 0.0 }, &mut screen);
        let rest = input.without_edges();
        for _ in 0..2 {
            self.memory.show(PassInput { input: &rest, canvas: &canvas, spectator: &mut (), time: 0.0 }, &mut screen);
        }
        acted
    }

    fn focus(&self) -> &str {
        self.memory.focused().unwrap_or_default()
    }
}

fn press(key: Key) -> Input {
    Input { pressed: [key].into_iter().collect(), pointer: Vec2::splat(-1.0), ..Input::default() }
}

fn grid(ui: &mut Ui<'_>) -> Option<&'static str> {
    let areas = (0..6).map(|i| Area::new((i % 3) as f32 * 200.0, (i / 3) as f32 * 100.0, 90.0, 40.0));
    ui.buttons(areas.collect(), &["a", "b", "c", "d", "e", "f"])
}

#[test]
fn arrows_walk_a_grid_and_stop_at_its_edges() {
    let mut sitting = Sitting::default();
    sitting.give(&Input::default(), grid);
    let walk = [
        (Key::Right, "b"),
        (Key::Down, "e"),
        (Key::Right, "f"),
        (Key::Right, "f"),
        (Key::Down, "f"),
        (Key::Up, "c"),
        (Key::Left, "b"),
    ];
    for (key, focus) in walk {
        let (input, before) = (press(key), sitting.focus().to_owned());
        assert_eq!(sitting.give(&input, grid), None);
        assert_eq!(sitting.focus(), focus, "{key:?}");
        assert_eq!(input.answer.get(), (focus != before).then_some(ButtonAnswer::Moved), "{key:?}");
    }
    let enter = press(Key::Enter);
    assert_eq!((sitting.give(&enter, grid), enter.answer.get()), (Some("b"), Some(ButtonAnswer::Pressed)));
}

#[test]
fn the_mouse_presses_the_button_under_it_and_nothing_else() {
    let mut sitting = Sitting::default();
    let at = |pointer, click| Input { pointer, click, ..Input::default() };
    let second = Vec2::new(245.0, 20.0);
    sitting.give(&Input::default(), grid);
    sitting.memory = Memory::default();
    for _ in 0..2 {
        assert_eq!(sitting.give(&at(second, false), grid), None);
        assert_eq!((sitting.memory.hovered(), sitting.focus()), (None, "a"), "it rests there");
    }
    assert_eq!(sitting.give(&at(second + 1.0, false), grid), None);
    assert_eq!((sitting.memory.hovered(), sitting.focus()), (Some("b"), "b"), "one highlight");
    assert_eq!(sitting.give(&Input { pointer: second + 1.0, ..press(Key::Right) }, grid), None);
    assert_eq!((sitting.memory.hovered(), sitting.focus()), (None, "c"), "one highlight");
    assert_eq!(sitting.give(&at(second, true), grid), Some("b"));
    assert_eq!(sitting.give(&at(Vec2::new(150.0, 20.0), true), grid), None);
    assert_eq!(sitting.memory.hovered(), None);
}

#[test]
fn without_widgets_nothing_is_pressed() {
    let mut sitting = Sitting::default();
    for key in [Key::Enter, Key::Down, Key::Tab] {
        assert_eq!(sitting.give(&press(key), |ui| ui.row(0.0, &[])), None);
    }
}

#[test]
fn a_layer_above_takes_all_and_gives_the_focus_back() {
    let mut sitting = Sitting::default();
    let screen = |open: bool| {
        move |ui: &mut Ui<'_>| {
            let below = ui.row(0.0, &["Back", "Open"]);
            let key = ui.key(Key::Escape);
            if open {
                ui.layer(0.7);
                return (below, key, ui.row(100.0, &["Close", "Back"]));
            }
            (below, key, None)
        }
    };
    sitting.give(&Input::default(), screen(false));
    sitting.give(&press(Key::Right), screen(false));
    assert_eq!(sitting.focus(), "Open");
    sitting.give(&Input::default(), screen(true));
    assert_eq!(sitting.focus(), "Close");
    sitting.give(&press(Key::Right), screen(true));
    assert_eq!(
        sitting.give(&press(Key::Enter), screen(true)),
        (None, false, Some("Back")),
        "the other button of that name is below"
    );
    assert!(!sitting.give(&press(Key::Escape), screen(true)).1);
    sitting.give(&Input::default(), screen(false));
    assert_eq!(sitting.focus(), "Open");
    assert!(sitting.give(&press(Key::Escape), screen(false)).1);
}

#[test]
fn letters_go_to_the_field_wherever_the_focus_is_and_tab_changes_the_group() {
    let (mut sitting, mut field) = (Sitting::default(), TextField::new("bo", 40));
    let mut give = |input: &Input| {
        let typed = sitting.give(input, |ui| {
            let typed = ui.field("Name", Area::new(100.0, 100.0, 400.0, 50.0), &mut field);
            ui.group();
            (typed, ui.row(200.0, &["Save", "Back"]))
        });
        (typed, sitting.focus().to_owned(), field.text())
    };
    give(&Input::default());
    assert_eq!(
        give(&Input { typed: "b".into(), ..Input::default() }),
        ((Some(FieldEvent::Changed), None), "Name".into(), "bob".into())
    );
    assert_eq!(give(&press(Key::Left)).1, "Name", "it moves the caret");
    assert_eq!(give(&press(Key::Tab)).1, "Save");
    assert_eq!(give(&press(Key::Right)).1, "Back");
    let typed = give(&Input { typed: "x".into(), ..Input::default() });
    assert_eq!((typed.1, typed.2), ("Name".into(), "boxb".into()));
    assert_eq!(give(&press(Key::Enter)).0, (Some(FieldEvent::Entered), None));
    give(&press(Key::Down));
    give(&press(Key::Up));
    assert_eq!(give(&Input { typed: "c".into(), ..Input::default() }).2, "c", "all of it was selected");
}

#[test]
fn a_list_scrolls_with_the_focus_and_the_wheel_leaves_the_focus_in_view() {
    let mut sitting = Sitting::default();
    let names: Vec<String> = (0..20).map(|i| format!("row {i}")).collect();
    let mut shown = 0..0;
    let mut give = |input: &Input| {
        let first = Area::new(100.0, 100.0, 400.0, 30.0);
        let rows = Rows { first, pitch: 40.0, page: 5, track: Area::new(600.0, 100.0, 12.0, 200.0) };
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut lines = Vec::new();
        let pressed = sitting.give(input, |ui| {
            lines.clear();
            ui.list("rows", &names, &rows, |_, line, _| lines.push(line))
        });
        shown = lines[0]..lines[lines.len() - 1] + 1;
        (shown.clone(), sitting.focus().to_owned(), pressed)
    };
    give(&Input::default());
    for _ in 0..6 {
        give(&press(Key::Down));
    }
    assert_eq!(give(&Input::default()), (2..7, "row 6".into(), None));
    assert_eq!(give(&Input { wheel: -1.0, ..Input::default() }).0, 5..10);
    assert_eq!(give(&Input { wheel: -1.0, ..Input::default() }), (8..13, "row 9".into(), None));
    assert_eq!(give(&press(Key::Enter)).2, Some(9));
    assert_eq!(give(&press(Key::End)), (15..20, "row 16".into(), None));
}
