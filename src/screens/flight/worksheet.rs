//! The sheet of an experiment beside its flight: the question, a prediction, without which the world is not let go, a table with a cell a
//! reading, and the answer last. Above the flight, buttons for the sheet and for the free-body picture.

use super::Flight;
use crate::draw::layout::{Area, DETAILS, Frame, GRID, PADDING, TEXT, Vec2, text_room};
use crate::ui::{EntryEvent, Turning, Ui};
use crate::{draw::Style, number::is_plain, settings::Action, ui::input::Input, words::tr};
use crate::{instruments::reading::Wanted, screens::lab::Paragraphs, ui::scroll::BAR_WIDTH, view::theme, view::widgets};
use crate::{screens::screen::Effect, screens::screen::Request, session::journal::Reading, session::journal::Worksheet};

/// Of the sheet, also in heights of the text.
const WIDTH: f32 = 552.0;
const WIDTH_IN_TEXT: f32 = 26.0;
const PREDICTION: &str = "Your prediction";
const ANSWER: &str = "Answer";
const SAVE: &str = "Save";
const NO_PREDICTION: &str = "Make a prediction first.";
const UNSTARTED: &str = "Let the experiment go first.";
const UNREAD: &str = "Write down a reading first: the answer comes last.";
const FIELD: f32 = 38.0;
/// The least width of the table's columns but the first: reading, tick, verdict.
const COLUMNS: [f32; 3] = [104.0, 60.0, 28.0];
/// The pitch of the table's rows, in lines, and the room below the sheet's buttons for what is not written yet, canvas units.
const PITCH: std::ops::RangeInclusive<f32> = 1.0..=1.5;
const BELOW: f32 = 72.0;

fn width(frame: &Frame) -> f32 {
    WIDTH.max(WIDTH_IN_TEXT * frame.text_height(DETAILS))
}

impl Flight {
    /// The buttons of an experiment, at the top left: a label, the words, and the place.
    fn experiment_buttons(&self, frame: &Frame) -> Vec<(&'static str, String, Area)> {
        if self.run.game.level().ship_plays() || self.is_watched() {
            return Vec::new();
        }
        let sheet = self.open.sheet.as_ref().map(|_| (Action::Sheet, Action::Sheet.label()));
        let mut left = 2.0 * GRID;
        let button = |(action, label): (Action, &'static str)| {
            let words = format!("{} [{}]", tr(label), self.seen.observer.keys().label(action));
            let size = text_room(&words, frame.text_height(DETAILS)) + GRID;
            let area = Area { min: Vec2::new(left, 2.0 * GRID), size };
            left += size.x + GRID;
            (label, words, area)
        };
        [(Action::Picture, Action::Picture.label())].into_iter().chain(sheet).map(button).collect()
    }

    /// Their places, and the place of the sheet, where it is open.
    pub(super) fn sheet_areas(&self, frame: &Frame) -> Vec<Area> {
        let buttons = self.experiment_buttons(frame).into_iter().map(|(.., area)| area);
        buttons.chain(self.sheet_area(frame)).collect()
    }

    fn sheet_area(&self, frame: &Frame) -> Option<Area> {
        let size = Vec2::new(width(frame), frame.size.y - 2.0 * GRID);
        let open = self.open.sheet.as_ref().filter(|sheet| sheet.open);
        open.map(|_| Area { min: Vec2::new(frame.size.x - size.x - GRID, GRID), size })
    }

    /// The width that the sheet takes of the canvas.
    pub(super) fn sheet_width(&self, frame: &Frame) -> f32 {
        self.sheet_area(frame).map_or(0.0, |area| area.size.x + 2.0 * GRID)
    }

    /// Shows both, and takes their part out of the input.
    pub(super) fn show_sheet(&mut self, ui: &mut Ui<'_>, rest: &mut Input) -> Option<Request> {
        let (frame, tick) = (ui.frame(), self.run.game.ticks());
        let mut pressed = None;
        let buttons = self.experiment_buttons(&frame);
        ui.by_pointer(|ui| {
            for (label, words, area) in &buttons {
                let on = if *label == Action::Sheet.label() { self.sheet_width(&frame) > 0.0 } else { self.seen.picture };
                let style = Style::new(DETAILS, if on { theme::accent() } else { theme::text() }).centred();
                if ui.small_button((label, words), *area, style) {
                    pressed = Some(*label);
                }
            }
        });
        match pressed {
            Some(label) if label == Action::Sheet.label() => self.turn_sheet(),
            Some(_) => self.seen.picture ^= true,
            None => {}
        }
        let covered = self.sheet_areas(&frame).iter().any(|area| area.contains(ui.input().pointer));
        // Nor does a click on the picture pick a body that lies behind it.
        if covered || self.seen.picture {
            (rest.click, rest.wheel) = (false, 0.0);
        }
        let place = self.sheet_area(&frame);
        let sheet = self.open.sheet.as_mut()?;
        sheet.begun |= tick > 0;
        if sheet.entry.is_open() {
            *rest = rest.without_keys();
        }
        let place = place?;
        // Before the start the keys have no other work.
        if sheet.predicts() { sheet.show(ui, place, tick) } else { ui.by_pointer(|ui| sheet.show(ui, place, tick)) }
    }

    pub(super) fn turn_sheet(&mut self) {
        if let Some(sheet) = &mut self.open.sheet {
            sheet.open ^= true;
            sheet.entry.close();
        }
    }

    pub(super) fn waits_for_prediction(&self) -> bool {
        let predicts = self.open.sheet.as_ref().is_some_and(|sheet| sheet.predicts());
        predicts && self.is_by_hand() && self.run.game.ticks() == 0
    }

    /// The world is to be let go: the prediction stays as it is from now on, or has to be made.
    pub(super) fn ask_for_prediction(&mut self) -> Option<Request> {
        let sheet = self.open.sheet.as_mut()?;
        if !sheet.written.prediction.is_empty() {
            return Some(Request::Do(Effect::Predict));
        }
        self.seen.observer.freeze();
        sheet.open = true;
        sheet.message = Err(tr(NO_PREDICTION).to_owned());
        if sheet.experiment.choices.is_empty() {
            sheet.entry.open(PREDICTION, "");
        }
        None
    }
}

impl Worksheet {
    fn show(&mut self, ui: &mut Ui<'_>, panel: Area, tick: u64) -> Option<Request> {
        self.take_entry(ui, tick);
        ui.canvas().rectangle(panel.inset(-GRID), theme::ground());
        ui.panel(panel);
        let inner = panel.inset(PADDING);
        let mut pen = Paragraphs { canvas: ui.canvas(), at: inner.min, width: inner.size.x };
        pen.write(tr(&self.experiment.title), TEXT, theme::accent());
        pen.write(tr(&self.experiment.question), TEXT, theme::text());
        ui.group();
        self.show_prediction(ui, &mut pen);
        ui.group();
        let (words, colour) = match &self.message {
            Ok(words) => (words.clone(), theme::quiet()),
            Err(problem) => (problem.clone(), theme::bad()),
        };
        let answer = if self.answered { tr(&self.experiment.answer).to_owned() } else { String::new() };
        let written = pen.height(&answer, TEXT) + pen.height(&words, DETAILS);
        let foot = inner.max().y - FIELD - GRID - written.max(BELOW);
        self.show_table(ui, &mut pen, (foot, tick));
        ui.group();
        let places = [0.0, 0.5].map(|part| Area::new(pen.at.x + part * inner.size.x, pen.at.y, 0.5 * inner.size.x - GRID, FIELD));
        let mut pressed = None;
        for (label, area) in [ANSWER, SAVE].into_iter().zip(places) {
            if ui.small_button((label, tr(label)), area, Style::new(TEXT, theme::text()).centred()) {
                pressed = Some(label);
            }
        }
        pen.at.y += FIELD + GRID;
        pen.write(&answer, TEXT, theme::good());
        pen.write(&words, DETAILS, colour);
        self.act(pressed?)
    }

    fn take_entry(&mut self, ui: &mut Ui<'_>, tick: u64) {
        let Some(EntryEvent::Taken(label, text)) = ui.entry_event(&mut self.entry) else { return };
        self.entry.close();
        self.message = Ok(String::new());
        let text = text.trim().to_owned();
        if label == PREDICTION {
            self.written.prediction = text;
        } else if let Some(cell) = self.experiment.readings.iter().position(|wanted| wanted.what == label)
            && self.written.readings[cell].text != text
        {
            self.written.readings[cell] = Reading { text, tick };
        }
    }

    /// The choices beside each other, or a line to write on; what was predicted, once the world has been let go.
    fn show_prediction(&mut self, ui: &mut Ui<'_>, pen: &mut Paragraphs<'_>) {
        let canvas = ui.canvas();
        canvas.text(tr(PREDICTION), pen.at, Style::new(DETAILS, theme::quiet()));
        pen.at.y += canvas.line_height(DETAILS) + 0.5 * GRID;
        let (whole, choices) = (Area { min: pen.at, size: Vec2::new(pen.width, FIELD) }, &self.experiment.choices);
        let unit = self.experiment.predicted().map_or_else(String::new, |wanted| wanted.unit);
        let (prediction, style) = (self.written.prediction.clone(), Style::new(TEXT, theme::text()).middle());
        let left = Vec2::new(whole.min.x, whole.centre().y);
        if !self.predicts() {
            let verdict = self.experiment.judge_prediction(&prediction).filter(|_| self.answered);
            let (judged, colour) = match verdict {
                Some(true) => (tr(" · right"), theme::good()),
                Some(false) => (tr(" · not so"), theme::text()),
                None => ("", theme::text()),
            };
            let none = if prediction.is_empty() { tr("none was made before the start") } else { "" };
            let unit = if is_plain(&prediction) { format!(" {unit}") } else { String::new() };
            let words = format!("{}{unit}{none}{judged}", tr(&prediction));
            canvas.text(&widgets::cut(canvas, &words, pen.width, style), left, Style { colour, ..style });
        } else if choices.is_empty() {
            let area = Area { size: Vec2::new(0.5 * pen.width, FIELD), ..whole };
            canvas.text(&unit, Vec2::new(area.max().x + GRID, left.y), style);
            if ui.entry(PREDICTION, area, (&prediction, style), &mut self.entry) {
                self.entry.open(PREDICTION, &prediction);
            }
        } else {
            let widest = choices.iter().map(|choice| canvas.width(tr(choice), style)).fold(0.0, f32::max) + 2.0 * GRID;
            let columns = if widest * choices.len() as f32 <= pen.width - GRID * choices.len() as f32 { choices.len() } else { 2 };
            let pitch = Vec2::new((pen.width + GRID) / columns as f32, FIELD + 0.5 * GRID);
            for (i, choice) in choices.iter().enumerate() {
                let min = pen.at + pitch * Vec2::new((i % columns) as f32, (i / columns) as f32);
                let colour = if *choice == prediction { theme::accent() } else { theme::text() };
                let area = Area { min, size: Vec2::new(pitch.x - GRID, FIELD) };
                if ui.small_button((choice, tr(choice)), area, Style::new(TEXT, colour).centred()) {
                    (self.written.prediction, self.message) = (choice.clone(), Ok(String::new()));
                }
                if *choice == prediction {
                    canvas.rounded_edge(area.inset(3.0), GRID, 2.0, theme::accent());
                }
            }
            pen.at.y += pitch.y * ((choices.len() - 1) / columns) as f32;
        }
        pen.at.y += FIELD + GRID;
    }

    /// A row a quantity, below a heading where several in turn are of one thing; `foot` is where the panel's room ends.
    fn show_table(&mut self, ui: &mut Ui<'_>, pen: &mut Paragraphs<'_>, (foot, tick): (f32, u64)) {
        let canvas = ui.canvas();
        let quiet = Style::new(DETAILS, theme::quiet()).middle();
        let heads = [tr("Reading"), tr("Tick"), ""].map(|words| canvas.width(words, quiet) + 2.0 * GRID);
        let columns: [f32; 3] = std::array::from_fn(|column| COLUMNS[column].max(heads[column]));
        let widest = pen.width - columns.iter().sum::<f32>() - GRID;
        let rows = rows(&self.experiment.readings, |words, indent| widgets::lines(canvas, words, widest - indent, quiet));
        if rows.is_empty() {
            return;
        }
        let line = canvas.line_height(DETAILS);
        let pitch = ((foot - pen.at.y) / (rows.len() + 1) as f32).clamp(PITCH.start() * line, PITCH.end() * line);
        // A table for which there is no room scrolls.
        let page = (((foot - pen.at.y) / pitch + 0.01) as usize).clamp(2, rows.len() + 1) - 1;
        let right = pen.at.x + pen.width;
        let [cell, ticked, verdict] = [0, 1, 2].map(|column| right - columns[column..].iter().sum::<f32>());
        let middle = |row: usize| pen.at.y + (row as f32 + 0.5) * pitch;
        for (words, x) in [(tr("Quantity"), pen.at.x), (tr("Reading"), cell), (tr("Tick"), ticked + GRID)] {
            canvas.text(words, Vec2::new(x, middle(0)), quiet);
        }
        let bar = Area::new(right + 0.25 * GRID, pen.at.y + pitch, BAR_WIDTH, page as f32 * pitch);
        let shown = ui.scroll("table", (rows.len(), page), bar, Turning::Wheel);
        for (row, (words, indent, index)) in rows[shown].iter().enumerate() {
            let y = middle(row + 1);
            let style = if indent.is_some() { Style::new(DETAILS, theme::text()).middle() } else { quiet };
            canvas.text(words, Vec2::new(pen.at.x + indent.unwrap_or(0.0), y), style);
            let Some(index) = *index else { continue };
            let (wanted, Reading { text, tick: at }) = (&self.experiment.readings[index], self.written.readings[index].clone());
            let area = Area::around(Vec2::new(cell + 0.5 * columns[0], y), Vec2::new(columns[0], pitch - 3.0));
            if ui.entry(&wanted.what, area, (&text, Style::new(DETAILS, theme::text())), &mut self.entry) {
                match (self.answered, self.begun || tick > 0) {
                    (true, _) => self.message = Err(tr("The answer is shown: the readings stay as they are.").to_owned()),
                    (false, false) => self.message = Err(tr(UNSTARTED).to_owned()),
                    (false, true) => self.entry.open(&wanted.what, &text),
                }
            }
            if !text.is_empty() {
                canvas.text(&at.to_string(), Vec2::new(ticked + GRID, y), quiet.mono());
            }
            match wanted.judge(&text) {
                Some(true) => widgets::tick(canvas, Vec2::new(verdict + 0.5 * columns[2], y), 7.0, theme::good()),
                Some(false) => {
                    canvas.text("×", Vec2::new(verdict + 0.5 * columns[2], y), Style::new(TEXT, theme::text()).middle().centred())
                }
                None => {}
            }
        }
        pen.at.y = middle(page) + 0.5 * pitch + GRID;
    }

    fn act(&mut self, pressed: &str) -> Option<Request> {
        let blank = self.written.readings.iter().all(|reading| reading.text.is_empty());
        let lacks = match pressed {
            ANSWER if !self.begun => Some(UNSTARTED),
            ANSWER if blank && !self.written.readings.is_empty() => Some(UNREAD),
            SAVE if blank && self.written.prediction.is_empty() => Some(NO_PREDICTION),
            _ => None,
        };
        self.message = lacks.map_or(Ok(String::new()), |words| Err(tr(words).to_owned()));
        if lacks.is_some() {
            return None;
        }
        if pressed == ANSWER {
            self.answered = true;
            return None;
        }
        if !self.is_unsaved() {
            self.message = Ok(tr("This is saved already.").to_owned());
        }
        self.is_unsaved().then_some(Request::Do(Effect::HandIn))
    }
}

/// The lines of the table's rows: words, how far a quantity's are set in, and the quantity's index on its last line. Several in turn that are of
/// one thing stand below its name, and so does one that does not fit into a line; `cut` cuts words that are set in into lines.
fn rows(wanted: &[Wanted], cut: impl Fn(&str, f32) -> Vec<String>) -> Vec<(String, Option<f32>, Option<usize>)> {
    let of = |wanted: &Wanted| wanted.what.split_once(", ").map(|(of, _)| of.to_owned());
    let mut rows = Vec::new();
    for (i, one) in wanted.iter().enumerate() {
        let same = |other: Option<&Wanted>| other.is_some_and(|other| of(other).is_some() && of(other) == of(one));
        let (follows, leads) = (same(i.checked_sub(1).and_then(|before| wanted.get(before))), same(wanted.get(i + 1)));
        let unit = if one.unit.is_empty() { String::new() } else { format!(" ({})", one.unit) };
        let line = format!("{}{unit}", one.name());
        let grouped = one.what.split_once(", ").filter(|_| follows || leads || cut(&line, 0.0).len() > 1);
        if let Some((of, _)) = grouped.filter(|_| !follows) {
            rows.extend(cut(tr(of), 0.0).into_iter().map(|words| (words, None, None)));
        }
        let words = grouped.map_or(line, |(_, quantity)| format!("{}{unit}", tr(quantity)));
        let indent = if grouped.is_some() { PADDING } else { 0.0 };
        rows.extend(cut(&words, indent).into_iter().map(|words| (words, Some(indent), None)));
        if let Some((_, _, index)) = rows.last_mut() {
            *index = Some(i);
        }
    }
    rows
}
