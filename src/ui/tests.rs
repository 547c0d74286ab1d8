use super::*;
use crate::draw::{Shape, Style, layout::Vec2};
use crate::ui::{input::ButtonAnswer, text_field::TextField};

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

#[test]
fn a_slider_follows_the_pointer_that_holds_it_and_the_keys_that_it_has() {
    let mut sitting = Sitting::default();
    let mut part = 0.5;
    let mut give = |input: &Input, by_pointer: bool| {
        let show = |ui: &mut Ui<'_>| {
            // A knob's radius inside the ends: from 105.2 to 194.8.
            let shown = SliderShown { part, mark: 0.5, knob: Some(crate::view::theme::text()) };
            let area = Area::new(100.0, 100.0, 100.0, 20.0);
            ui.slider("Mass", area, &shown)
        };
        let moved = sitting.give(input, |ui| if by_pointer { ui.by_pointer(show) } else { show(ui) });
        if let Some(SliderMove::To { part: to, .. }) = moved {
            part = to;
        }
        (moved, sitting.focus().to_owned())
    };
    let at = |x: f32, click: bool| Input { pointer: Vec2::new(x, 110.0), click, holding: true, ..Input::default() };
    give(&Input::default(), false);
    assert_eq!(give(&press(Key::Right), false).0, Some(SliderMove::Step(1.0)));
    assert_eq!(give(&press(Key::Left), false).0, Some(SliderMove::Step(-1.0)));
    assert_eq!(give(&at(150.0, true), false).0, None, "the knob is there");
    assert_eq!(give(&at(194.8, false), false).0, Some(SliderMove::To { part: 1.0, goes_on: true }));
    assert_eq!(give(&at(900.0, false), false).0, None, "at its end it stays");
    assert_eq!(give(&at(-900.0, false), false).0, Some(SliderMove::To { part: 0.0, goes_on: true }));
    assert_eq!(give(&Input { pointer: Vec2::new(150.0, 110.0), ..Input::default() }, false).0, None, "it is released");
    assert_eq!(give(&at(150.0, false), false).0, None, "a pointer that comes with its button down holds nothing");
    // By the pointer alone.
    assert_eq!(give(&Input::default(), true).1, "");
    assert_eq!(give(&press(Key::Right), true).0, None);
    assert!(matches!(give(&at(194.8, true), true).0, Some(SliderMove::To { goes_on: false, .. })));
}

#[test]
fn an_entry_opens_on_a_click_and_is_taken_by_enter_or_a_click_elsewhere() {
    let (mut sitting, mut entry) = (Sitting::default(), EntryField::default());
    let (mass, speed) = (Area::new(100.0, 100.0, 90.0, 20.0), Area::new(100.0, 130.0, 90.0, 20.0));
    let style = Style::new(crate::draw::layout::DETAILS, crate::view::theme::text());
    let mut give = |input: &Input| {
        let event = sitting.give(input, |ui| {
            let event = ui.entry_event(&mut entry);
            for (label, area) in [("Mass", mass), ("Speed", speed)] {
                if ui.entry(label, area, ("12.5 kg", style), &mut entry) {
                    entry.open(label, "12.5");
                }
            }
            event
        });
        (event, entry.text())
    };
    let click = |area: Area| Input { pointer: area.centre(), click: true, holding: true, ..Input::default() };
    let typed = |text: &str| Input { typed: text.into(), pointer: mass.centre(), ..Input::default() };
    give(&Input::default());
    assert_eq!(give(&click(mass)), (None, Some("12.5".into())));
    assert_eq!(give(&click(mass)), (None, Some("12.5".into())), "it is open");
    assert_eq!(give(&typed("7")), (Some(EntryEvent::Changed), Some("7".into())), "all of it was selected");
    assert_eq!(give(&press(Key::Up)).0, Some(EntryEvent::Stepped("Mass".into(), 1.0)));
    let enter = Input { typed: "5".into(), ..press(Key::Enter) };
    assert_eq!(give(&enter), (Some(EntryEvent::Taken("Mass".into(), "75".into())), Some("75".into())), "the screen may refuse it");
    let (event, text) = give(&click(speed));
    assert_eq!((event, text), (Some(EntryEvent::Taken("Mass".into(), "75".into())), Some("12.5".into())), "the other one is open");
    assert_eq!(give(&press(Key::Escape)), (Some(EntryEvent::GivenUp), None));
    assert_eq!(give(&typed("7")), (None, None));
}

#[test]
fn a_tooltip_stands_beside_the_pointer_inside_the_window_and_only_there() {
    let mut sitting = Sitting::default();
    let area = Area::new(1200.0, 680.0, 80.0, 40.0);
    let words = "Friction: the largest share of the contact force that acts along the surface, 0 … 3";
    let mut shown = |pointer: Vec2| {
        let input = Input { pointer, ..Input::default() };
        let canvas = Canvas::new(input.frame);
        let stage = PassInput { input: &input, canvas: &canvas, spectator: &mut (), time: 0.0 };
        sitting.memory.show(stage, |ui| ui.tip(area, words));
        let shapes = canvas.shapes();
        let text = |shape: &Shape| if let Shape::Text { text, at, .. } = shape { Some((text.clone(), *at)) } else { None };
        shapes.iter().filter_map(text).collect::<Vec<_>>()
    };
    assert!(shown(Vec2::ZERO).is_empty());
    let lines = shown(area.centre());
    assert!(lines.len() == 2 && lines.iter().all(|(_, at)| at.x > 0.0 && at.y < area.centre().y), "above the pointer: {lines:?}");
    assert_eq!(lines.iter().map(|(text, _)| text.trim()).collect::<Vec<_>>().join(" "), words);
}
