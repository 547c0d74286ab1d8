//! The sheet of an experiment beside the pause panel: its question, the pupil's guess and readings, and the answer, once a guess is
//! there.

use crate::draw::Style;
use crate::draw::layout::{Area, BUTTON_TEXT, GAP, GRID, PADDING, ROW_BUTTON, TEXT, Vec2};
use crate::instruments::reading;
use crate::screens::lab::Paragraphs;
use crate::screens::screen::{Effect, Request};
use crate::session::answers::{MOST_LETTERS, Worksheet};
use crate::ui::text_field::TextField;
use crate::ui::{FieldEvent, Ui};
use crate::view::{theme, widgets};
use crate::words::tr;

pub(super) const WIDTH: f32 = 640.0;
const GUESS: &str = "Your guess";
const READINGS: &str = "Your readings";
const ANSWER: &str = "Answer";
const SAVE: &str = "Save";
const NO_GUESS: &str = "Make a guess first.";
const LINE_HEIGHT: f32 = 44.0;

impl Worksheet {
    /// Whether letters go into one of its fields.
    pub(super) fn is_typed_into(ui: &Ui<'_>) -> bool {
        ui.has_focus(GUESS) || ui.has_focus(READINGS)
    }

    pub(super) fn show(&mut self, ui: &mut Ui<'_>, panel: Area) -> Option<Request> {
        ui.panel(panel);
        let inner = panel.inset(1.5 * PADDING);
        let mut pen = Paragraphs { canvas: ui.canvas(), at: inner.min, width: inner.size.x };
        pen.write(tr(&self.experiment.title), BUTTON_TEXT, theme::accent());
        pen.write(tr(&self.experiment.question), TEXT, theme::text());
        ui.group();
        let label = |words: &str, pen: &mut Paragraphs<'_>| {
            pen.write(words, TEXT, theme::quiet());
            let line = Area { min: pen.at - Vec2::new(0.0, GRID), size: Vec2::new(inner.size.x, LINE_HEIGHT) };
            pen.at.y += LINE_HEIGHT + GRID;
            line
        };
        let line = label(tr(GUESS), &mut pen);
        self.show_guess(ui, line);
        ui.group();
        let wanted = reading::named(&self.experiment.readings);
        let words =
            if wanted.is_empty() { tr(READINGS).to_owned() } else { tr!("Your readings of {quantities}", quantities = wanted) };
        let line = label(&words, &mut pen);
        if ui.line(READINGS, line, &mut self.readings) == Some(FieldEvent::Changed) {
            self.message = Ok(String::new());
        }
        ui.group();
        let size = Vec2::new(ROW_BUTTON.x, LINE_HEIGHT);
        let places = [0.0, size.x + GAP].map(|right| Area { min: pen.at + Vec2::new(right, 0.0), size });
        let pressed = ui.buttons(places.to_vec(), &[ANSWER, SAVE]);
        pen.at.y += LINE_HEIGHT + PADDING;
        if self.answered {
            pen.write(tr(&self.experiment.answer), TEXT, theme::good());
        }
        let (words, colour) = match &self.message {
            Ok(words) => (words, theme::quiet()),
            Err(problem) => (problem, theme::bad()),
        };
        pen.write(words, TEXT, colour);
        self.act(pressed?)
    }

    /// The choices beside each other, or a line to write on.
    fn show_guess(&mut self, ui: &mut Ui<'_>, line: Area) {
        let guess = self.guess.text();
        if self.answered {
            let (judged, colour) = match self.experiment.judge_guess(&guess) {
                Some(true) => (tr(" · right"), theme::good()),
                Some(false) => (tr(" · not so"), theme::text()),
                None => ("", theme::text()),
            };
            let style = Style::new(TEXT, colour).middle();
            let guess = widgets::cut(ui.canvas(), &format!("{}{judged}", tr(&guess)), line.size.x, style);
            return ui.text(&guess, Vec2::new(line.min.x, line.centre().y), style);
        }
        let choices = &self.experiment.choices;
        if choices.is_empty() {
            match ui.line(GUESS, line, &mut self.guess) {
                Some(FieldEvent::Entered) => ui.focus(Some(READINGS)),
                Some(FieldEvent::Changed) => self.message = Ok(String::new()),
                None => {}
            }
            return;
        }
        let pitch = (line.size.x + GRID) / choices.len() as f32;
        for (i, choice) in choices.iter().enumerate() {
            let min = line.min + Vec2::new(i as f32 * pitch, 0.0);
            let area = Area { min, size: Vec2::new(pitch - GRID, line.size.y) };
            let colour = if *choice == guess { theme::accent() } else { theme::text() };
            if ui.small_button((choice, tr(choice)), area, Style::new(TEXT, colour).centred()) {
                (self.guess, self.message) = (TextField::new(choice, MOST_LETTERS.0), Ok(String::new()));
            }
        }
    }

    fn act(&mut self, pressed: &str) -> Option<Request> {
        if self.written()[0].is_empty() {
            self.message = Err(tr(NO_GUESS).to_owned());
            return None;
        }
        self.message = Ok(String::new());
        if pressed == ANSWER {
            self.answered = true;
            return None;
        }
        let row = self.take_unsaved();
        if row.is_none() {
            self.message = Ok(tr("This is saved already.").to_owned());
        }
        row.map(|row| Request::Do(Effect::HandIn(row)))
    }
}
