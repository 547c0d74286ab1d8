//! "What if": a panel with a slider and a number for each quantity that can vary, of the followed object and of the level. The
//! flight's screen fulfils its wishes.

mod drawing;
mod layout;

pub use drawing::written;

use super::Stage;
use crate::draw::layout::{Area, Vec2};
use crate::game::body_title;
use crate::instruments::vary::{SliderTrack, Variation};
use crate::level::{Level, Parameter};
use crate::physics::BodyId;
use crate::screens::text_field::TextField;
use crate::screens::{ButtonAnswer, Input, Key, Keys};
use layout::{Button, Layout};

/// The most letters of a number, and of a level's name.
const MOST: usize = 40;

#[derive(Clone, Copy, Debug)]
pub struct Varied<'a> {
    pub level: &'a Level,
    /// `None` while the level is flown as it is.
    pub variation: Option<&'a Variation>,
    /// The progress of the flight, 0 … 1, while it is flown again.
    pub progress: Option<f64>,
}

/// The start of a change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VaryFrom {
    /// The flight starts again.
    #[default]
    Start,
    /// The flight goes on from its moment.
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
pub struct VaryLine {
    pub parameter: Parameter,
    pub usual: f64,
    pub value: f64,
    pub open: bool,
}

impl VaryLine {
    pub fn is_varied(&self) -> bool {
        self.value != self.usual
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VaryEntry {
    /// The index of its line.
    Number(Parameter),
    /// Of the level to save.
    Name,
}

#[derive(Clone, Debug, Default)]
pub struct Vary {
    /// The object of the lines, where 0 is the ship; and its name.
    body: usize,
    title: String,
    lines: Vec<VaryLine>,
    layout: Layout,
    from: VaryFrom,
    held: Option<Parameter>,
    /// The last changed number: further changes go on with it.
    last: Option<Parameter>,
    entry: Option<(VaryEntry, TextField)>,
    /// The last message, and whether it is bad.
    message: Option<(String, bool)>,
    pointer: Vec2,
    progress: Option<f64>,
    is_varied: bool,
    wish: Option<VaryWish>,
}

impl Vary {
    /// Returns the input that remains for the flight: all of it where nothing can vary or the panel is closed.
    pub fn update(&mut self, input: &Input, stage: &Stage, open: bool) -> Input {
        let Some(varied) = stage.varied.filter(|_| open) else {
            (self.lines, self.layout, self.entry, self.held) = (Vec::new(), Layout::default(), None, None);
            return input.clone();
        };
        self.read(&varied, stage.focus.followed().map_or(0, |body| body.index()));
        self.layout = Layout::new(&input.frame, self.lines.len());
        self.pointer = input.pointer;
        let mut rest = input.clone();
        if self.entry.is_some() {
            // Typing flies nothing.
            (rest.pressed, rest.held, rest.typed) = (Keys::default(), Keys::default(), String::new());
            self.follow_keys(input, varied.level, varied.variation);
        }
        self.follow_pointer(input, varied.level, varied.variation);
        let own = self.layout.panel.contains(input.pointer) || self.held.is_some();
        rest.click &= !own;
        rest.wheel = if own { 0.0 } else { rest.wheel };
        rest
    }

    /// Once.
    pub const fn take_wish(&mut self) -> Option<VaryWish> {
        self.wish.take()
    }

    pub fn tell(&mut self, words: String, bad: bool) {
        self.message = Some((words, bad));
    }

    pub fn area(&self) -> Option<Area> {
        (!self.lines.is_empty()).then_some(self.layout.panel)
    }

    /// From the top; none while the panel is closed.
    pub fn lines(&self) -> &[VaryLine] {
        &self.lines
    }

    /// Slider, number, reset.
    pub fn parts(&self, parameter: Parameter) -> Option<[Area; 3]> {
        let line = self.lines.iter().position(|line| line.parameter == parameter)?;
        Some([self.layout.slider(line), self.layout.number(line), self.layout.reset(line)])
    }

    /// From the start, from now, reset all, save.
    pub const fn buttons(&self) -> &[Area; 4] {
        &self.layout.buttons
    }

    pub fn entry(&self) -> Option<(VaryEntry, String)> {
        self.entry.as_ref().map(|(entry, field)| (*entry, field.text()))
    }

    /// And whether it is bad.
    pub fn message(&self) -> Option<(&str, bool)> {
        self.message.as_ref().map(|(words, bad)| (words.as_str(), *bad))
    }

    pub fn title(&self) -> &str {
        &self.title
    }

    /// 0 … 1, while the flight is flown again.
    pub const fn progress(&self) -> Option<f64> {
        self.progress
    }

    pub const fn pointer(&self) -> Vec2 {
        self.pointer
    }

    pub const fn from(&self) -> VaryFrom {
        self.from
    }

    fn read(&mut self, varied: &Varied, body: usize) {
        if body != self.body {
            (self.body, self.held, self.last) = (body, None, None);
            self.entry = self.entry.take().filter(|(entry, _)| *entry == VaryEntry::Name);
        }
        self.progress = varied.progress;
        self.is_varied = varied.variation.is_some_and(|variation| !variation.is_empty());
        self.title = body_title(varied.level, BodyId(self.body as u32));
        let line = |parameter: Parameter| {
            let usual = parameter.of(varied.level)?;
            let value = varied.variation.and_then(|variation| variation.get(parameter)).unwrap_or(usual);
            Some(VaryLine { parameter, usual, value, open: self.from == VaryFrom::Start || !parameter.is_of_the_start() })
        };
        self.lines = Parameter::all(varied.level, body).into_iter().filter_map(line).collect();
    }

    fn line(&self, parameter: Parameter) -> Option<VaryLine> {
        self.lines.iter().copied().find(|line| line.parameter == parameter)
    }

    /// Asks for a number, where it changes; `goes_on` says that it continues the change before.
    fn ask(&mut self, line: VaryLine, value: f64, level: &Level, (variation, goes_on): (Option<&Variation>, bool)) {
        if value == line.value {
            return;
        }
        let mut asked = variation.cloned().unwrap_or_default();
        asked.set(line.parameter, value, level);
        self.message = None;
        self.wish = Some(VaryWish::Vary(asked, self.from, goes_on && self.last == Some(line.parameter)));
        self.last = Some(line.parameter);
    }

    /// Asks for a number `steps` fine steps further, and returns it.
    fn step(&mut self, line: VaryLine, steps: f64, level: &Level, variation: Option<&Variation>) -> f64 {
        let value = SliderTrack::of(line.parameter, line.usual).stepped(line.value, steps, line.parameter.limits());
        self.ask(line, value, level, (variation, true));
        value
    }

    /// Keys of a field: Enter accepts, Esc gives up, up and down are fine steps.
    fn follow_keys(&mut self, input: &Input, level: &Level, variation: Option<&Variation>) {
        let Some((entry, field)) = &mut self.entry else { return };
        // Letters of the same frame as Enter belong to the text.
        if field.update(input) {
            self.message = None;
        }
        let steps = f64::from(u8::from(input.pressed(Key::Up))) - f64::from(u8::from(input.pressed(Key::Down)));
        if input.pressed(Key::Escape) {
            (self.entry, self.message) = (None, None);
        } else if input.pressed(Key::Enter) {
            self.take_entry(level, variation);
        } else if let (VaryEntry::Number(parameter), true) = (*entry, steps != 0.0) {
            let Some(line) = self.line(parameter) else { return };
            let value = self.step(line, steps, level, variation);
            self.entry = Some((VaryEntry::Number(parameter), TextField::selected(&value.to_string(), MOST)));
        }
    }

    /// Accepts the text; a bad one stays, with a message.
    fn take_entry(&mut self, level: &Level, variation: Option<&Variation>) {
        let Some((entry, field)) = self.entry.take() else { return };
        match entry {
            VaryEntry::Name => self.wish = Some(VaryWish::Save(field.text().trim().to_owned())),
            VaryEntry::Number(parameter) => match (parameter.parse(&field.text()), self.line(parameter)) {
                (Ok(value), Some(line)) => self.ask(line, value, level, (variation, false)),
                (Err(expected), _) => {
                    self.tell(format!("Expected {expected}."), true);
                    self.entry = Some((entry, field));
                }
                (Ok(_), None) => {}
            },
        }
    }

    fn follow_pointer(&mut self, input: &Input, level: &Level, variation: Option<&Variation>) {
        let at = input.pointer;
        if input.click && self.layout.panel.contains(at) {
            input.answer(ButtonAnswer::Pressed);
            let written = self.entry.as_ref().map(|(entry, _)| *entry);
            // A click elsewhere accepts the text.
            if !self.entry_area().is_some_and(|area| area.contains(at)) {
                self.take_entry(level, variation);
            }
            match self.layout.button_at(at) {
                Some(Button::FromStart) => self.from = VaryFrom::Start,
                Some(Button::FromNow) => self.from = VaryFrom::Now,
                Some(Button::Restore) if variation.is_some() => self.wish = Some(VaryWish::Restore),
                Some(Button::Save) if self.is_varied => {
                    if written != Some(VaryEntry::Name) {
                        (self.entry, self.message) = (Some((VaryEntry::Name, TextField::new("", MOST))), None);
                    }
                }
                Some(Button::Restore | Button::Save) | None => {}
            }
            self.click_line(at, level, variation);
        }
        if !input.holding && !input.click {
            self.held = None;
        }
        if let Some(line) = self.held.and_then(|held| self.line(held)) {
            let part = self.layout.part(at);
            // A click that moves nothing changes nothing: the number need not lie on the slider's steps.
            let track = SliderTrack::of(line.parameter, line.usual);
            if (track.part(line.value) - part).abs() > self.layout.half_a_pixel() {
                self.ask(line, track.value(part), level, (variation, !input.click));
            }
        }
        let over = self.layout.line_at(at, self.lines.len()).filter(|line| self.lines[*line].open);
        if let (Some(line), true) = (over, input.wheel != 0.0) {
            self.step(self.lines[line], f64::from(input.wheel), level, variation);
        }
    }

    /// Holds the slider, opens the number's field, or resets the number.
    fn click_line(&mut self, at: Vec2, level: &Level, variation: Option<&Variation>) {
        let Some(index) = self.layout.line_at(at, self.lines.len()).filter(|line| self.lines[*line].open) else { return };
        let line = self.lines[index];
        if self.layout.reset(index).contains(at) {
            self.ask(line, line.usual, level, (variation, false));
        } else if self.layout.number(index).contains(at) {
            if self.entry.as_ref().is_none_or(|(entry, _)| *entry != VaryEntry::Number(line.parameter)) {
                self.entry = Some((VaryEntry::Number(line.parameter), TextField::selected(&line.value.to_string(), MOST)));
            }
        } else if self.layout.slider(index).contains(at) {
            self.held = Some(line.parameter);
        }
    }

    fn entry_area(&self) -> Option<Area> {
        match self.entry.as_ref()?.0 {
            VaryEntry::Name => Some(self.layout.field),
            VaryEntry::Number(parameter) => self.parts(parameter).map(|[_, number, _]| number),
        }
    }
}
