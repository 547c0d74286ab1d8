//! "What if": a panel with a slider and a number for all that can be varied of the object that is followed, and of the level. What it asks
//! for is flown by whoever shows the flight.

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

/// The level that is varied, and how.
#[derive(Clone, Copy, Debug)]
pub struct Varied<'a> {
    /// As it is in its files.
    pub level: &'a Level,
    /// What is varied; none while the level is flown as it is.
    pub variation: Option<&'a Variation>,
    /// How much has been flown again, 0 … 1, while it is.
    pub progress: Option<f64>,
}

/// From where on a change holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum From {
    /// The flight is flown again from its start.
    #[default]
    Start,
    /// It goes on from where it is.
    Now,
}

/// What the panel asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// The flight varied like that, from there on; whether that goes on with what was asked for last: the same slider, further.
    Vary(Variation, From, bool),
    /// The level as it is, from its start.
    Restore,
    /// The level as it is varied, as a level of that name; of any, where the name is empty.
    Save(String),
}

/// A number on the panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// What it is.
    pub parameter: Parameter,
    /// What it is in the level.
    pub usual: f64,
    /// What it is now.
    pub value: f64,
    /// Whether it can be varied now.
    pub open: bool,
}

impl Line {
    /// Whether it is another number than in the level.
    pub fn is_varied(&self) -> bool {
        self.value != self.usual
    }
}

/// What is being written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entry {
    /// The number of that line.
    Number(Parameter),
    /// The name of the level that is saved.
    Name,
}

/// The panel.
#[derive(Clone, Debug, Default)]
pub struct Vary {
    /// What the lines are of: 0 is the ship; and what that is called.
    body: usize,
    title: String,
    lines: Vec<Line>,
    layout: Layout,
    from: From,
    /// The slider that the pointer holds.
    held: Option<Parameter>,
    /// The number that was changed last, by steps or by its slider: further ones go on with it.
    last: Option<Parameter>,
    entry: Option<(Entry, TextField)>,
    /// What was said last, and whether it is bad.
    told: Option<(String, bool)>,
    pointer: Vec2,
    progress: Option<f64>,
    /// Whether anything is varied, of whatever object.
    is_varied: bool,
    wish: Option<Wish>,
}

impl Vary {
    /// One frame; the answer is what is left of the input for the flight. Where nothing can be varied, or the panel is not open, it is all.
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
            // What is typed flies nothing.
            (rest.pressed, rest.held, rest.typed) = (Keys::default(), Keys::default(), String::new());
            self.follow_keys(input, varied.level, varied.variation);
        }
        self.follow_pointer(input, varied.level, varied.variation);
        let own = self.layout.panel.contains(input.pointer) || self.held.is_some();
        rest.click &= !own;
        rest.wheel = if own { 0.0 } else { rest.wheel };
        rest
    }

    /// What is asked for, once.
    pub const fn take_wish(&mut self) -> Option<Wish> {
        self.wish.take()
    }

    /// Says what became of something.
    pub fn tell(&mut self, words: String, bad: bool) {
        self.told = Some((words, bad));
    }

    /// What it covers.
    pub fn area(&self) -> Option<Area> {
        (!self.lines.is_empty()).then_some(self.layout.panel)
    }

    /// Its lines, from the top; none while it is closed.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// Where the parts of a line are: its slider, its number, its reset.
    pub fn parts(&self, parameter: Parameter) -> Option<[Area; 3]> {
        let line = self.lines.iter().position(|line| line.parameter == parameter)?;
        Some([self.layout.slider(line), self.layout.number(line), self.layout.reset(line)])
    }

    /// Where its buttons are: from the start, from now, reset all, save.
    pub const fn buttons(&self) -> &[Area; 4] {
        &self.layout.buttons
    }

    /// What is being written, and its text so far.
    pub fn entry(&self) -> Option<(Entry, String)> {
        self.entry.as_ref().map(|(entry, field)| (*entry, field.text()))
    }

    /// What was said last, and whether it is bad.
    pub fn told(&self) -> Option<(&str, bool)> {
        self.told.as_ref().map(|(words, bad)| (words.as_str(), *bad))
    }

    /// What its first lines are of.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// How much has been flown again, 0 … 1, while it is.
    pub const fn progress(&self) -> Option<f64> {
        self.progress
    }

    /// Where the pointer was last.
    pub const fn pointer(&self) -> Vec2 {
        self.pointer
    }

    /// From where on changes hold.
    pub const fn from(&self) -> From {
        self.from
    }

    fn read(&mut self, varied: &Varied, body: usize) {
        if body != self.body {
            (self.body, self.held, self.last) = (body, None, None);
            self.entry = self.entry.take().filter(|(entry, _)| *entry == Entry::Name);
        }
        self.progress = varied.progress;
        self.is_varied = varied.variation.is_some_and(|variation| !variation.is_empty());
        self.title = body_title(varied.level, BodyId(self.body as u32));
        let line = |parameter: Parameter| {
            let usual = parameter.of(varied.level)?;
            let value = varied.variation.and_then(|variation| variation.get(parameter)).unwrap_or(usual);
            Some(Line { parameter, usual, value, open: self.from == From::Start || !parameter.is_of_the_start() })
        };
        self.lines = Parameter::all(varied.level, body).into_iter().filter_map(line).collect();
    }

    fn line(&self, parameter: Parameter) -> Option<Line> {
        self.lines.iter().copied().find(|line| line.parameter == parameter)
    }

    /// Asks for a number, where it is another one; whether it goes on with the change before.
    fn ask(&mut self, line: Line, value: f64, level: &Level, (variation, goes_on): (Option<&Variation>, bool)) {
        if value == line.value {
            return;
        }
        let mut asked = variation.cloned().unwrap_or_default();
        asked.set(line.parameter, value, level);
        self.told = None;
        self.wish = Some(Wish::Vary(asked, self.from, goes_on && self.last == Some(line.parameter)));
        self.last = Some(line.parameter);
    }

    /// Asks for a number so many fine steps further, which it answers.
    fn step(&mut self, line: Line, steps: f64, level: &Level, variation: Option<&Variation>) -> f64 {
        let value = SliderTrack::of(line.parameter, line.usual).stepped(line.value, steps, line.parameter.limits());
        self.ask(line, value, level, (variation, true));
        value
    }

    /// Keys while something is written: Enter takes it, Esc gives it up, up and down are fine steps.
    fn follow_keys(&mut self, input: &Input, level: &Level, variation: Option<&Variation>) {
        let Some((entry, field)) = &mut self.entry else { return };
        // What was typed in the same frame as Enter is taken with it.
        if field.update(input) {
            self.told = None;
        }
        let steps = f64::from(u8::from(input.pressed(Key::Up))) - f64::from(u8::from(input.pressed(Key::Down)));
        if input.pressed(Key::Escape) {
            (self.entry, self.told) = (None, None);
        } else if input.pressed(Key::Enter) {
            self.take_entry(level, variation);
        } else if let (Entry::Number(parameter), true) = (*entry, steps != 0.0) {
            let Some(line) = self.line(parameter) else { return };
            let value = self.step(line, steps, level, variation);
            self.entry = Some((Entry::Number(parameter), TextField::selected(&value.to_string(), MOST)));
        }
    }

    /// Takes what was written; what will not do stays, with what is expected.
    fn take_entry(&mut self, level: &Level, variation: Option<&Variation>) {
        let Some((entry, field)) = self.entry.take() else { return };
        match entry {
            Entry::Name => self.wish = Some(Wish::Save(field.text().trim().to_owned())),
            Entry::Number(parameter) => match (parameter.parse(&field.text()), self.line(parameter)) {
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
            // Whoever clicks elsewhere has written what they wanted.
            if !self.entry_area().is_some_and(|area| area.contains(at)) {
                self.take_entry(level, variation);
            }
            match self.layout.button_at(at) {
                Some(Button::FromStart) => self.from = From::Start,
                Some(Button::FromNow) => self.from = From::Now,
                Some(Button::Restore) if variation.is_some() => self.wish = Some(Wish::Restore),
                Some(Button::Save) if self.is_varied => {
                    if written != Some(Entry::Name) {
                        (self.entry, self.told) = (Some((Entry::Name, TextField::new("", MOST))), None);
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
            // A click that moves nothing changes nothing: the number need not be one that a slider sets.
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

    /// A click on a line: its slider is held, its number is written, or it is as in the level again.
    fn click_line(&mut self, at: Vec2, level: &Level, variation: Option<&Variation>) {
        let Some(index) = self.layout.line_at(at, self.lines.len()).filter(|line| self.lines[*line].open) else { return };
        let line = self.lines[index];
        if self.layout.reset(index).contains(at) {
            self.ask(line, line.usual, level, (variation, false));
        } else if self.layout.number(index).contains(at) {
            if self.entry.as_ref().is_none_or(|(entry, _)| *entry != Entry::Number(line.parameter)) {
                self.entry = Some((Entry::Number(line.parameter), TextField::selected(&line.value.to_string(), MOST)));
            }
        } else if self.layout.slider(index).contains(at) {
            self.held = Some(line.parameter);
        }
    }

    fn entry_area(&self) -> Option<Area> {
        match self.entry.as_ref()?.0 {
            Entry::Name => Some(self.layout.field),
            Entry::Number(parameter) => self.parts(parameter).map(|[_, number, _]| number),
        }
    }
}
