//! "What if": a slider and a number for each quantity of the followed object and the level that can vary. The flight fulfils its wishes.

mod places;

use super::Stage;
use crate::draw::layout::{Area, DETAILS, Frame, GRID, Vec2};
use crate::ui::{EntryEvent, EntryField, SliderMove, SliderShown, Ui, WidgetKind};
use crate::{draw::Style, game::body_title, number::scalar, physics::BodyId};
use crate::{instruments::vary::SliderTrack, instruments::vary::Variation, level::Level, level::Parameter};
use crate::{view::theme, view::widgets, words::decimals, words::tr};
use places::{DragHold, Layout};

const NAME: &str = "Name of the level";
const INSIDE: f32 = 0.75 * GRID;

#[derive(Clone, Copy, Debug)]
pub struct Varied<'a> {
    pub level: &'a Level,
    /// `None` while the level is flown as it is.
    pub variation: Option<&'a Variation>,
    /// The progress of the flight, 0 … 1, while it is flown again.
    pub progress: Option<f64>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VaryFrom {
    #[default]
    Start,
    Now,
}

#[derive(Clone, Debug, PartialEq)]
pub enum VaryWish {
    /// The varied flight, from there on; the flag says that it continues the last wish: the same slider, further.
    Vary(Variation, VaryFrom, bool),
    /// The level as it is, from its start.
    Restore,
    /// The varied level as a level of that name; of any, where the name is empty.
    Save(String),
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct VaryLine {
    parameter: Parameter,
    usual: f64,
    value: f64,
    open: bool,
}

impl VaryLine {
    fn is_varied(&self) -> bool {
        self.value != self.usual
    }

    fn number_label(&self) -> String {
        format!("{}: number", self.parameter.name())
    }
}

#[derive(Clone, Debug, Default)]
pub struct Vary {
    /// The object of the lines, where 0 is the ship; and its name.
    body: usize,
    title: String,
    lines: Vec<VaryLine>,
    layout: Layout,
    from: VaryFrom,
    /// The last changed number: further changes go on with it.
    last: Option<Parameter>,
    entry: EntryField,
    message: Option<(String, bool)>,
    progress: Option<f64>,
    is_varied: bool,
    pub wish: Option<VaryWish>,
    /// In an experiment, which has more lines: whether those of the level are shown, not those of the object; `None` elsewhere.
    of_level: Option<bool>,
    /// What the pointer leads in the level, and the place in [`Parameter::places`] of what it could lead.
    hold: Option<DragHold>,
    over: Option<usize>,
}

impl Vary {
    /// Shows the panel at the right of that frame, where it is open and something can vary.
    pub fn show(&mut self, ui: &mut Ui<'_>, frame: &Frame, stage: &Stage, open: bool) {
        let Some(varied) = stage.varied.filter(|_| open) else {
            (self.lines, self.layout, self.entry) = (Vec::new(), Layout::default(), EntryField::default());
            return;
        };
        self.read(&varied, stage.focus.followed.unwrap_or(stage.game.lead()).index());
        self.layout = Layout::new(frame, self.lines.len());
        let names_level = self.entry.is_open_at(NAME);
        if let Some(event) = ui.entry_event(&mut self.entry) {
            self.follow_entry(event, &varied);
        }
        ui.panel(self.layout.panel);
        self.show_heading(ui);
        for index in 0..self.lines.len() {
            self.show_line(ui, index, &varied);
        }
        self.show_buttons(ui, varied.variation.is_some(), names_level);
        self.show_foot(ui);
    }

    pub fn set_message(&mut self, words: String, bad: bool) {
        self.message = Some((words, bad));
    }

    pub fn area(&self) -> Option<Area> {
        (!self.lines.is_empty()).then_some(self.layout.panel)
    }

    pub const fn is_typing(&self) -> bool {
        self.entry.is_open()
    }

    fn read(&mut self, varied: &Varied, body: usize) {
        if body != self.body {
            (self.body, self.last) = (body, None);
            if !self.entry.is_open_at(NAME) {
                self.entry.close();
            }
        }
        self.progress = varied.progress;
        self.is_varied = varied.variation.is_some_and(|variation| !variation.is_empty());
        self.title = body_title(varied.level, BodyId(self.body as u32));
        self.of_level = varied.level.experiment.then_some(self.of_level == Some(true));
        let shown = |parameter: &Parameter| self.of_level.is_none_or(|of_level| parameter.is_of_a_body() != of_level);
        self.lines = Parameter::all(varied.level, body).into_iter().filter(shown).filter_map(|of| self.line(of, varied)).collect();
    }

    fn line(&self, parameter: Parameter, varied: &Varied) -> Option<VaryLine> {
        let usual = parameter.of(varied.level)?;
        let value = varied.variation.and_then(|variation| variation.get(parameter)).unwrap_or(usual);
        Some(VaryLine { parameter, usual, value, open: self.from == VaryFrom::Start || !parameter.is_of_the_start() })
    }

    /// Asks for a number, where it changes; `goes_on` says that it continues the change before, of the same number or by the same hand.
    fn ask(&mut self, line: VaryLine, value: f64, varied: &Varied, goes_on: bool) {
        if value == line.value {
            return;
        }
        let mut asked = match &self.wish {
            Some(VaryWish::Vary(asked, ..)) => asked.clone(),
            _ => varied.variation.cloned().unwrap_or_default(),
        };
        asked.set(line.parameter, value, varied.level);
        self.message = None;
        self.wish = Some(VaryWish::Vary(asked, self.from, goes_on));
        self.last = Some(line.parameter);
    }

    /// Asks for a number `steps` fine steps further, and returns it.
    fn step(&mut self, line: VaryLine, steps: f64, varied: &Varied) -> f64 {
        let value = SliderTrack::of(line.parameter, line.usual).stepped(line.value, steps, line.parameter.limits());
        self.ask(line, value, varied, self.last == Some(line.parameter));
        value
    }

    fn follow_entry(&mut self, event: EntryEvent, varied: &Varied) {
        let line = |label: &str| self.lines.iter().copied().find(|line| line.number_label() == label);
        match event {
            EntryEvent::Changed | EntryEvent::GivenUp => self.message = None,
            EntryEvent::Stepped(label, steps) => {
                if let Some(line) = line(&label) {
                    let value = self.step(line, steps, varied);
                    self.entry.open(&label, &typed(line.parameter, value));
                }
            }
            EntryEvent::Taken(label, text) => match line(&label).map(|line| (line, line.parameter.parse(&text))) {
                Some((_, Err(expected))) => self.set_message(tr!("Expected {expected}.", expected), true),
                Some((line, Ok(value))) => {
                    self.entry.close();
                    self.ask(line, value, varied, false);
                }
                None => {
                    self.entry.close();
                    self.wish = Some(VaryWish::Save(text.trim().to_owned()));
                }
            },
        }
    }

    fn show_heading(&mut self, ui: &mut Ui<'_>) {
        let heading = self.layout.heading();
        let at = |x: f32| Vec2::new(x, heading.centre().y);
        let style = Style::new(DETAILS, theme::accent()).middle();
        if let Some(of_level) = self.of_level {
            let what = if of_level { tr("level") } else { &self.title };
            ui.text(&tr!("What if: {changes}", changes = what), at(heading.min.x), style);
            if button(ui, if of_level { "Object" } else { "Level and things" }, self.layout.page(), (true, false)) {
                self.of_level = Some(!of_level);
                self.entry.close();
            }
            return;
        }
        ui.text(&tr!("What if: {body} and level", body = self.title), at(heading.min.x), style);
        let hint = Style { colour: theme::quiet(), ..style };
        ui.text(tr("Tab, N: another object"), at(heading.max().x), hint.right());
    }

    fn show_line(&mut self, ui: &mut Ui<'_>, index: usize, varied: &Varied) {
        let line = self.lines[index];
        let [name, slider, number, reset] = self.layout.cells(index);
        let colour = if line.open { theme::text() } else { theme::quiet() };
        let style = Style::new(DETAILS, if line.is_varied() { theme::accent() } else { colour }).middle();
        let whole = line.parameter.shown();
        let words = widgets::cut(ui.canvas(), &whole, name.size.x, style);
        ui.text(&words, Vec2::new(name.min.x, name.centre().y), style);
        if words != whole {
            ui.tip(name, &whole);
        }
        let track = SliderTrack::of(line.parameter, line.usual);
        let knob = if line.is_varied() { theme::accent() } else { theme::text() };
        let shown = SliderShown { part: track.part(line.value), mark: track.part(line.usual), knob: line.open.then_some(knob) };
        match ui.slider(&line.parameter.name(), slider, &shown) {
            Some(SliderMove::To { part, goes_on }) => {
                self.ask(line, track.value(part), varied, goes_on && self.last == Some(line.parameter));
            }
            Some(SliderMove::Step(steps)) => {
                self.step(line, steps, varied);
            }
            None => {}
        }
        let notches = ui.wheel(self.layout.row(index));
        if line.open && notches != 0.0 {
            self.step(line, f64::from(notches), varied);
        }
        let label = line.number_label();
        let words = written(line.parameter, line.value);
        if ui.entry(&label, number, (&words, Style::new(DETAILS, colour)), &mut self.entry) && line.open {
            self.entry.open(&label, &typed(line.parameter, line.value));
        }
        if line.is_varied() {
            self.show_reset(ui, line, reset, varied);
        }
    }

    /// The button with the level's own value.
    fn show_reset(&mut self, ui: &mut Ui<'_>, line: VaryLine, area: Area, varied: &Varied) {
        let touch = ui.touch(&format!("{}: reset", line.parameter.name()), area, WidgetKind::Button);
        let fill = if touch.hover { theme::panel_hover() } else { theme::panel() };
        widgets::panel_in(ui.canvas(), area, fill, theme::panel_edge());
        let back = format!("← {}", written(line.parameter, line.usual));
        widgets::fitted(ui.canvas(), &back, area.centre(), area.size.x - INSIDE, &[DETAILS], theme::quiet());
        if touch.pressed && line.open {
            self.ask(line, line.usual, varied, false);
        }
    }

    fn show_buttons(&mut self, ui: &mut Ui<'_>, was_varied: bool, names_level: bool) {
        let [start, now, restore, save] = self.layout.buttons;
        if button(ui, "From the start", start, (true, self.from == VaryFrom::Start)) {
            self.from = VaryFrom::Start;
        }
        if button(ui, "From now", now, (true, self.from == VaryFrom::Now)) {
            self.from = VaryFrom::Now;
        }
        if button(ui, "Reset all", restore, (true, false)) && was_varied {
            self.wish = Some(VaryWish::Restore);
        }
        if button(ui, "Save as level", save, (self.is_varied, false)) && self.is_varied && !names_level {
            self.entry.open(NAME, "");
            self.message = None;
        }
    }

    /// The name of the new level, or the last message, or the progress of the flight.
    fn show_foot(&mut self, ui: &mut Ui<'_>) {
        let field = self.layout.field;
        let names_level = self.entry.is_open_at(NAME);
        if names_level && self.message.is_none() {
            let style = Style::new(DETAILS, theme::quiet()).middle().right();
            ui.entry(NAME, field, ("", style), &mut self.entry);
            if self.entry.text().is_some_and(|text| text.is_empty()) {
                ui.text(tr("its name, or Enter for any"), Vec2::new(field.max().x - INSIDE, field.centre().y), style);
            }
            return;
        }
        let flown_again;
        let (words, colour) = match (&self.message, self.progress) {
            (Some((words, bad)), _) => (words.as_str(), if *bad { theme::bad() } else { theme::good() }),
            (None, Some(progress)) => {
                flown_again = tr!("Flown again: {percent} %", percent = format_args!("{:.0}", 100.0 * progress));
                (flown_again.as_str(), theme::accent())
            }
            (None, None) if self.is_typing() => (tr("Enter takes it, Esc gives it up, ↑ ↓ step"), theme::quiet()),
            (None, None) if self.of_level.is_some() => {
                (tr("Drag a slider or a thing in the level, or click a number"), theme::quiet())
            }
            (None, None) => (tr("Drag, turn the wheel, or click a number to type"), theme::quiet()),
        };
        widgets::fitted(ui.canvas(), words, field.centre(), field.size.x, &[DETAILS], colour);
        ui.tip(field, words);
    }
}

/// A button that is open or closed, and whose edge says that it is chosen.
fn button(ui: &mut Ui<'_>, label: &str, area: Area, (open, chosen): (bool, bool)) -> bool {
    let touch = ui.touch(label, area, WidgetKind::Button);
    let fill = if open && touch.hover { theme::panel_hover() } else { theme::ground() };
    let edge = if chosen { theme::accent() } else { theme::panel_edge() };
    widgets::panel_in(ui.canvas(), area, fill, edge);
    let colour = if open { theme::text() } else { theme::quiet() };
    widgets::fitted(ui.canvas(), tr(label), area.centre(), area.size.x - 2.0 * INSIDE, &[DETAILS], colour);
    touch.pressed
}

fn typed(parameter: Parameter, value: f64) -> String {
    parameter.choice(value).map_or_else(|| decimals(&value.to_string()).into_owned(), |choice| tr(choice).to_owned())
}

/// With its unit; a factor with its sign.
pub fn written(parameter: Parameter, value: f64) -> String {
    if let Some(choice) = parameter.choice(value) {
        return tr(choice).to_owned();
    }
    if matches!(parameter, Parameter::Breaks(_)) && value >= parameter.limits().1 {
        return tr("never").to_owned();
    }
    let text = scalar(value, parameter.unit());
    match parameter {
        Parameter::Friction | Parameter::Wind => format!("× {}", text.trim()),
        _ => text.trim().to_owned(),
    }
}
