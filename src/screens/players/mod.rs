//! The list of players: the one who plays is chosen, or a new one is named.

use crate::draw::layout::{Area, BUTTON_TEXT, GAP, PADDING, TEXT, Vec2};
use crate::screens::screen::{Effect, Request, Screen};
use crate::ui::{Rows, Ui, prompt::NameEntry, prompt::NameField, scroll::bar_beside};
use crate::{draw::Style, session::Session, settings::Key, words::tr};
use crate::{scores::Name, scores::PlayerRecord, view::theme, view::widgets};

const PAGE: usize = 7;
/// Width and height of a player's button, and from one to the next.
const ROW: Vec2 = Vec2::new(560.0, 48.0);
const PITCH: f32 = ROW.y + 8.0;
/// Room for the scroll bar, on both sides, so that rows stand in the middle.
const BAR: f32 = 24.0;
/// From the canvas' top to the list, in a window of the design's height.
const TOP: f32 = 144.0;
const NEW: &str = "New Player";

/// The list of players, or the field for a new one.
#[derive(Debug)]
pub struct PlayerList {
    candidates: Vec<PlayerRecord>,
    current: Name,
    field: Option<NameField>,
    trouble: Option<String>,
}

impl PlayerList {
    /// With what others have written meanwhile.
    pub fn open(session: &mut Session) -> Self {
        session.journal.read();
        let mut candidates = session.journal.players().all().to_vec();
        candidates.sort_by_key(|candidate| candidate.name().as_str().to_lowercase());
        let (current, trouble) = (session.journal.current().clone(), session.journal.trouble().map(str::to_owned));
        let mut screen = Self { candidates, current, field: None, trouble };
        screen.field = screen.is_nameless().then(|| NameField::new(""));
        screen
    }

    /// Whether nobody has a name yet: without any there is only the field.
    fn is_nameless(&self) -> bool {
        self.candidates.iter().all(|candidate| candidate.name().is_guest())
    }

    fn show_field(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        ui.page("New player", ui.frame().size.y * 0.2);
        match self.field.as_mut()?.show(ui, (tr("What you complete is kept under this name."), "Done"))? {
            NameEntry::Name(name) => return Some(Request::Do(Effect::Choose(name, true))),
            NameEntry::Back if self.is_nameless() => return Some(Request::Pop),
            NameEntry::Back => self.field = None,
        }
        ui.focus(Some(NEW));
        None
    }

    fn show_rows(&self, ui: &mut Ui<'_>, list: Area) -> Option<usize> {
        let names: Vec<&str> = self.candidates.iter().map(|candidate| candidate.name().as_str()).collect();
        if let (true, Some(at)) = (ui.opens(), names.iter().position(|name| *name == self.current.as_str())) {
            ui.reveal("players", at);
            ui.start_at(names[at]);
        }
        let rows = Rows {
            first: Area { min: list.min + Vec2::new(PADDING + BAR, PADDING), size: ROW },
            pitch: PITCH,
            page: PAGE,
            track: bar_beside(list, list.min.y + PADDING, list.max().y - PADDING),
        };
        ui.list("players", &names, &rows, |canvas, index, (area, touch)| {
            let (name, done) = (self.candidates[index].name(), self.candidates[index].done());
            widgets::button_box(canvas, area, touch.hover, touch.focus);
            let (left, right) = (area.min.x + PADDING, area.max().x - PADDING);
            let colour = if *name == self.current { theme::accent() } else { theme::text() };
            canvas.text(name.as_str(), Vec2::new(left, area.centre().y), Style::new(BUTTON_TEXT, colour).mono().middle());
            let done = if done == 1 { tr("1 level done").to_owned() } else { tr!("{count} levels done", count = done) };
            canvas.text(&done, Vec2::new(right, area.centre().y), Style::new(TEXT, theme::quiet()).right().middle());
        })
    }
}

impl Screen for PlayerList {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        if self.field.is_some() {
            return self.show_field(ui);
        }
        let size = Vec2::new(ROW.x + 2.0 * (PADDING + BAR), PAGE as f32 * PITCH - 8.0 + 2.0 * PADDING);
        let canvas = ui.frame().size;
        let list = Area { min: Vec2::new((canvas.x - size.x) / 2.0, TOP + (canvas.y - 720.0) / 2.0), size };
        ui.page("Who plays?", list.min.y - 64.0);
        ui.panel(list);
        if let Some(trouble) = &self.trouble {
            ui.fitted(trouble, Vec2::new(list.centre().x, list.min.y - 24.0), &[TEXT], theme::bad());
        }
        let chosen = self.show_rows(ui, list);
        let pressed = ui.row(list.max().y + 2.0 * GAP, &[NEW, "Back"]);
        if let Some(index) = chosen {
            return Some(Request::Do(Effect::Choose(self.candidates[index].name().clone(), false)));
        }
        if pressed == Some(NEW) {
            self.field = Some(NameField::new(""));
            ui.focus(None);
        }
        (ui.key(Key::Escape) || pressed == Some("Back")).then_some(Request::Pop)
    }

    fn lies_over(&self) -> bool {
        true
    }
}
