//! The flights of a level: the one just flown, the level's own, and those of its board. One is watched or kept as a file, one or several are raced.

use crate::draw::layout::{Area, Frame, TEXT, Vec2};
use crate::screens::screen::{Destination, Effect, Request, Screen};
use crate::session::recordings::{self, FlightCandidate, FlightSource, Visit};
use crate::ui::{Spectator, Turning, Ui, input::Stroke, scroll::bar_beside};
use crate::{draw::Style, level::Level, session::Session, view::theme, view::widgets, words::tr};
use crate::{number::clock, scores::Board, scores::subject, screens::flight::race::MOST_RIVALS, settings::Action, settings::Key};
use std::ops::Range;

const PAGE: usize = 10;
/// Height of a row, and width of the panel, also in heights of the text.
const ROW: f32 = 40.0;
const WIDTH: f32 = 920.0;
const WIDTH_IN_TEXT: f32 = 50.0;
/// From the panel's top to its first row, from the canvas' top to the panel, and from the panel down to the buttons.
const HEAD: f32 = 48.0;
const TOP: f32 = 120.0;
const FOOT: f32 = 44.0;
/// From a row's ends to the panel's sides: room for the scroll bar, on both sides, so that rows stand in the middle.
const ROW_INSET: f32 = 24.0;
/// Width of a row's end where it is chosen for a race.
const BOX: f32 = 120.0;
/// Where the columns stand, from the panel's left edge: whose, what it is, time and score (their right ends), the box (its middle).
const COLUMNS: [f32; 5] = [40.0, 224.0, 660.0, 756.0, 828.0];

fn width(frame: &Frame) -> f32 {
    WIDTH.max(WIDTH_IN_TEXT * frame.text_height(TEXT))
}

/// Where a column stands in a panel of that width.
fn column(number: usize, width: f32) -> Vec2 {
    Vec2::new(COLUMNS[number] * width / WIDTH, 0.0)
}
const KEYS: [Key; 6] = [Key::Up, Key::Down, Key::PageUp, Key::PageDown, Key::Home, Key::End];

#[derive(Debug)]
pub struct Flights {
    visit: Visit,
    subject: String,
    pub candidates: Vec<FlightCandidate>,
    read: Vec<bool>,
    marked: Vec<usize>,
    chosen: usize,
    shown: Range<usize>,
    /// What became of something that was asked for, and whether that is bad.
    message: Option<(String, bool)>,
}

impl Flights {
    pub fn open(visit: Visit, level: &Level, session: &mut Session) -> Self {
        session.last_level = Some(visit.level.clone());
        let (board, problem) = match session.scores.load(&visit.level) {
            Ok(loaded) => (loaded.board, None),
            Err(error) => (Board::default(), Some(error.to_string())),
        };
        let folder = session.places.levels.join(&visit.level);
        let candidates = recordings::candidates(&visit, &folder, &board, session.journal.current());
        let (read, subject) = (vec![false; candidates.len()], subject(&level.name, &level.title));
        let wanted = |candidate: &FlightCandidate| matches!(&candidate.source, FlightSource::Row(file) if Some(file) == visit.chosen.as_ref());
        let chosen = candidates.iter().position(wanted).unwrap_or(0);
        let message = problem.map(|problem| (problem, true));
        Self { visit, subject, read, candidates, marked: Vec::new(), chosen, shown: 0..PAGE, message }
    }

    /// Those that would be raced: the marked ones, or the one that is chosen.
    pub fn rivals(&self) -> Vec<FlightCandidate> {
        let one = [self.chosen];
        let all = if self.marked.is_empty() { &one[..] } else { &self.marked };
        all.iter().filter_map(|index| self.candidates.get(*index)).cloned().collect()
    }

    pub fn message(&self) -> Option<&str> {
        self.message.as_ref().map(|(words, _)| words.as_str())
    }

    /// Adds a flight that has been proven, and chooses it.
    pub fn add(&mut self, candidate: FlightCandidate) {
        self.candidates.retain(|other| other.source != candidate.source);
        self.candidates.push(candidate);
        self.read.resize(self.candidates.len(), true);
        self.chosen = self.candidates.len() - 1;
        self.marked.clear();
    }

    fn mark(&mut self, index: usize) {
        self.message = None;
        if let Some(at) = self.marked.iter().position(|marked| *marked == index) {
            self.marked.remove(at);
        } else if self.marked.len() == MOST_RIVALS {
            self.refuse(tr!("At most {count} at a time can be raced.", count = MOST_RIVALS));
        } else if index < self.candidates.len() {
            self.marked.push(index);
        }
    }

    fn choose(&mut self, ui: &mut Ui<'_>) {
        let last = self.candidates.len().saturating_sub(1);
        for key in ui.strokes(&KEYS) {
            self.chosen = match key {
                Key::Up => self.chosen.saturating_sub(1),
                Key::Down => self.chosen + 1,
                Key::PageUp => self.chosen.saturating_sub(PAGE),
                Key::PageDown => self.chosen + PAGE,
                Key::Home => 0,
                _ => last,
            }
            .min(last);
            if !self.shown.contains(&self.chosen) {
                ui.reveal("flights", self.chosen);
            }
        }
        if ui.key(Key::Space) || ui.acts(Action::Details) {
            self.mark(self.chosen);
        }
    }

    /// The rows in view; a click chooses one, and at its end marks it.
    fn show_rows(&mut self, ui: &mut Ui<'_>, panel: Area) {
        let rows = panel.min.y + HEAD;
        let bar = bar_beside(panel, rows, rows + PAGE as f32 * ROW);
        self.shown = ui.scroll("flights", (self.candidates.len(), PAGE), bar, Turning::Wheel);
        for (line, index) in self.shown.clone().enumerate() {
            let top = rows + line as f32 * ROW;
            let area = Area::new(panel.min.x + ROW_INSET, top + 2.0, panel.size.x - 2.0 * ROW_INSET, ROW - 4.0);
            if ui.input().click && area.contains(ui.input().pointer) {
                self.chosen = index;
                if ui.input().pointer.x > area.max().x - BOX {
                    self.mark(index);
                }
            }
            if index == self.chosen {
                widgets::picked_row(ui.canvas(), area);
            }
            self.show_row(ui, index, Vec2::new(panel.min.x, area.centre().y));
        }
    }

    fn show_row(&self, ui: &Ui<'_>, index: usize, left: Vec2) {
        let candidate = &self.candidates[index];
        let column = |i: usize| left + column(i, width(&ui.frame()));
        let words = Style::new(TEXT, theme::text()).middle();
        ui.text(&candidate.name, column(0), words);
        ui.text(&candidate.about, column(1), Style::new(TEXT, theme::quiet()).middle());
        for (at, number) in [(2, candidate.time.map(clock)), (3, candidate.score.map(|score| score.to_string()))] {
            ui.text(number.as_deref().unwrap_or_default(), column(at), words.mono().right());
        }
        let tick = Area::around(column(4), Vec2::splat(20.0));
        ui.canvas().rounded(tick, 4.0, theme::ground());
        ui.canvas().rounded_edge(tick, 4.0, 2.0, theme::solid_top());
        if self.marked.contains(&index) {
            widgets::tick(ui.canvas(), tick.centre(), 7.0, theme::accent());
        }
    }
}

impl Screen for Flights {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.choose(ui);
        let (size, width) = (ui.frame().size, width(&ui.frame()));
        let corner = Vec2::new((size.x - width) / 2.0, TOP + (size.y - 720.0) / 2.0);
        let panel = Area { min: corner, size: Vec2::new(width, HEAD + PAGE as f32 * ROW + 16.0) };
        ui.page(&tr!("Flights of {subject}", subject = self.subject), panel.min.y - 64.0);
        ui.panel(panel);
        let quiet = Style::new(TEXT, theme::quiet()).middle();
        let heads = [
            (tr("Whose"), 0, quiet),
            (tr("Time"), 2, quiet.right()),
            (tr("Score"), 3, quiet.right()),
            (tr("Race"), 4, quiet.centred()),
        ];
        for (head, number, style) in heads {
            ui.text(head, panel.min + column(number, width) + Vec2::new(0.0, HEAD / 2.0 + 2.0), style);
        }
        if self.candidates.is_empty() {
            ui.text(tr("No flights yet: fly one and save its score."), panel.centre(), quiet.centred());
        }
        self.show_rows(ui, panel);
        let hint = (tr("↑ ↓ choose, Space marks who is raced"), theme::quiet());
        let coloured = |(words, bad)| (words, if bad { theme::bad() } else { theme::good() });
        let (words, colour) = self.message.as_ref().map_or(hint, |(words, bad)| coloured((words.as_str(), *bad)));
        ui.fitted(words, Vec2::new(size.x / 2.0, panel.min.y - 24.0), &[TEXT], colour);
        let pressed = ui.row(panel.max().y + FOOT, &["Watch", "Race", "Keep as File", "Copy Code", "Paste Code", "Back"]);
        if ui.key(Key::Escape) || pressed == Some("Back") {
            return Some(Request::Pop);
        }
        let pastes = |stroke: &Stroke| matches!(stroke, Stroke::Key(Key::V, held) if held.has(Key::Control));
        if pressed == Some("Paste Code") || ui.input().strokes(&[Key::V]).iter().any(pastes) {
            let code = ui.input().clipboard.text();
            return Some(Request::Do(Effect::PasteCode(code.trim().to_owned())));
        }
        let chosen = self.candidates.get(self.chosen)?.clone();
        Some(match pressed? {
            "Copy Code" => Request::Do(Effect::CopyCode(chosen)),
            "Watch" => Request::Push(Destination::Watch(self.visit.clone(), chosen)),
            "Race" => Request::Reset(Destination::Race(self.visit.clone(), self.rivals())),
            _ => Request::Do(Effect::Keep(chosen)),
        })
    }

    fn reads(&self, effect: &Effect, _: &Session) -> Option<String> {
        match effect {
            // What was just flown is there.
            Effect::Keep(candidate) | Effect::CopyCode(candidate) if candidate.source == FlightSource::Flown => None,
            Effect::Keep(_) | Effect::CopyCode(_) | Effect::PasteCode(_) => Some(self.visit.level.clone()),
            _ => None,
        }
    }

    fn carry_out(&mut self, effect: Effect, session: &mut Session, _: &mut dyn Spectator) -> Option<Request> {
        let done = match effect {
            Effect::Keep(candidate) => session.keep_flight(&self.visit, &candidate),
            Effect::CopyCode(candidate) => session.copy_code(&self.visit, &candidate),
            Effect::PasteCode(code) => session.prove_code(&self.visit, code).map(|candidate| {
                let words = tr!("Proven: {name}", name = candidate.name);
                self.add(candidate);
                words
            }),
            _ => return None,
        };
        match done {
            Ok(words) => self.message = Some((words, false)),
            Err(problem) => self.refuse(problem),
        }
        None
    }

    fn refuse(&mut self, reason: String) {
        self.message = Some((reason, true));
    }

    /// Reads one record in view for its time and score: one file is enough for a frame. One that cannot be read says so when it is asked for.
    fn attend(&mut self, session: &mut Session) {
        let Some(index) = self.shown.clone().find(|&index| self.read.get(index) == Some(&false)) else { return };
        self.read[index] = true;
        let candidate = &mut self.candidates[index];
        if let Ok(replay) = recordings::read(&self.visit, &candidate.source, &session.scores) {
            (candidate.time, candidate.score) = (Some(replay.time), candidate.score.or(Some(replay.score)));
        }
    }

    fn tune(&self) -> Option<&str> {
        None
    }
}
