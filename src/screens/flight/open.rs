//! What is open over a flight: panels, notices, the level's files; the pause panel with the settings; a flight's path for the level's picture.

use super::{Flight, signs::Hints, signs::News};
use crate::draw::layout::{Area, HEADING, PADDING, Vec2, WIDE_BUTTON};
use crate::game::{Game, GameError, GameEvent, History, SHIP};
use crate::screens::screen::{Destination, Effect, Purpose, Request, Screen};
use crate::session::{Session, folder_watch::FolderWatch, journal::Worksheet, library::Attempt, worker::Ticket};
use crate::ui::{Spectator, Ui, input::Input};
use crate::view::{theme, widgets};
use crate::{level::Level, physics::DVec2, screens::settings::SettingsPanel, settings::Action, words::tr};
use std::sync::Arc;

pub(super) const RESUME: &str = "Resume";
const RESTART: &str = "Restart";
const HINT: &str = "Hint";
const SETTINGS: &str = "Settings";
const LEVEL_SELECT: &str = "Level Select";
/// In an experiment in place of the list of levels.
const EXPERIMENTS: &str = "Back to experiments";
const MENU: &str = "Main Menu";
const EDIT: &str = "Edit Level";

/// From the middle of the canvas up to the first button.
const TOP: f32 = 152.0;

#[derive(Debug, Default)]
pub(super) struct Open {
    /// The label of the pause panel's last button, while the panel is open.
    pub pause: Option<&'static str>,
    pub settings: Option<Box<SettingsPanel>>,
    pub settings_problems: Vec<String>,
    /// The state of the level's files, while it is shown.
    pub news: Option<News>,
    pub hints: Hints,
    /// Age of the introduction, while it is shown, s.
    pub introduced: Option<f64>,
    pub done: bool,
    /// Of an experiment that is listed.
    pub sheet: Option<Box<Worksheet>>,
    /// Whether the flight tries out an edited level: it does not count.
    pub test: bool,
    pub trail: FlownTrail,
    /// Whether that level is in memory only.
    pub in_memory: bool,
    pub watch: Option<FolderWatch>,
    pub reading: Option<Ticket>,
}

impl Flight {
    /// An attempt at its start, whose level's files are watched.
    /// Errors: the level makes no world; so of all that follow.
    pub fn open(attempt: Attempt, session: &mut Session, spectator: &mut dyn Spectator) -> Result<Self, GameError> {
        let comes = session.last_flown.replace(attempt.level.name.clone()).as_ref() != Some(&attempt.level.name);
        let introduced =
            (comes && attempt.level.ship_plays() && attempt.inputs.is_none() && attempt.rivals.is_empty()).then_some(0.0);
        session.last_level = Some(attempt.level.name.clone());
        let watch = Some(session.library.watch(&attempt.level));
        let mut flight = Self::new(attempt, spectator)?;
        (flight.open.watch, flight.open.introduced) = (watch, introduced);
        flight.tell_of_settings(&session.settings, &session.settings_problems);
        flight.take_sheet(session);
        Ok(flight)
    }

    /// An attempt at an edited level, from its start or from where a flight was stopped: Esc, F5 and its end lead back to the editor.
    pub(in crate::screens) fn test(
        (level, in_memory): (Arc<Level>, bool),
        (left, on): (Vec<String>, Option<Box<Game>>),
        session: &Session,
        spectator: &mut dyn Spectator,
    ) -> Result<Self, GameError> {
        let news = (!left.is_empty()).then_some(News::Unfinished(left));
        let mut flight = Self::new(Attempt::by_hand(level), spectator)?;
        flight.open = Open { test: true, in_memory, news, ..flight.open };
        if let Some(game) = on {
            flight.run.history = History::new(&game);
            (flight.run.game, flight.run.assisted) = (*game, true);
            spectator.goes_on(&flight.run.game);
        }
        flight.tell_of_settings(&session.settings, &[]);
        Ok(flight)
    }

    pub(super) fn switch_overlays(&mut self, input: &Input) {
        self.seen.details ^= input.acts(Action::Details);
        self.seen.hitboxes ^= input.acts(Action::Hitboxes);
        self.seen.picture ^= input.acts(Action::Picture);
        if input.acts(Action::Sheet) {
            self.turn_sheet();
        }
    }

    pub(super) fn show_pause(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let chosen = self.open.pause?;
        ui.layer(0.45);
        let list = if self.run.attempt.level.experiment { EXPERIMENTS } else { LEVEL_SELECT };
        let mut labels = vec![RESUME, RESTART, SETTINGS, list, MENU, EDIT];
        if self.offers_hint() {
            labels.insert(2, HINT);
        }
        let middle = ui.frame().size / 2.0;
        let places = ui.frame().column(labels.len(), middle.y - TOP);
        let (top, width) = (middle.y - TOP - HEADING - 2.5 * PADDING, WIDE_BUTTON.x + 4.0 * PADDING);
        let foot = places.last().map_or(middle.y, |last| last.max().y) + 1.5 * PADDING;
        let panel = Area::new(middle.x - width / 2.0, top, width, foot - top);
        ui.panel(panel);
        let heading = Vec2::new(middle.x, top + PADDING + HEADING * 0.65);
        widgets::fitted(ui.canvas(), tr("Paused"), heading, width, &[HEADING], theme::text());
        self.show_hints(ui, top);
        ui.start_at(chosen);
        let pressed = ui.buttons(places, &labels);
        if self.open.settings.is_some() {
            return self.show_settings(ui);
        }
        if ui.is_live() {
            self.switch_overlays(ui.input());
        }
        if ui.acts(Action::Pause) {
            self.open.pause = None;
            return None;
        }
        if ui.acts(Action::Restart) {
            return Some(Request::Do(Effect::Restart));
        }
        self.open.pause = Some(pressed?);
        match pressed? {
            RESUME => self.open.pause = None,
            HINT => self.give_hint(),
            RESTART => return Some(Request::Do(Effect::Restart)),
            SETTINGS => {
                let panel = SettingsPanel::new(ui.input().settings, self.open.settings_problems.clone());
                self.open.settings = Some(Box::new(panel));
            }
            LEVEL_SELECT => return Some(Request::Reset(Destination::Levels(Purpose::Play))),
            MENU => return Some(Request::Reset(Destination::Menu)),
            EDIT => {
                let name = self.run.attempt.level.name.clone();
                return Some(Request::Push(Destination::Edit { name, original: false }));
            }
            _ => return Some(Request::Reset(Destination::Lab(Some(self.run.attempt.level.name.clone())))),
        }
        None
    }

    fn show_settings(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        ui.layer(1.0);
        match self.open.settings.as_mut()?.show(ui)? {
            Request::Pop => {
                self.open.settings = None;
                None
            }
            request => Some(request),
        }
    }
}

/// From one point of the path to the next, ticks.
const EVERY: u64 = 4;
/// The most impacts in memory: a crowd has more, and the picture is full.
const MOST: usize = 500;

#[derive(Clone, Debug, Default)]
pub struct FlownTrail {
    path: Vec<(u64, DVec2)>,
    impacts: Vec<(u64, Bump)>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bump {
    /// m.
    pub at: DVec2,
    /// Along the normal, m/s.
    pub speed: f64,
    /// Whether it cost the ship points.
    pub damages: bool,
}

impl FlownTrail {
    /// Takes up the tick just made. A flight that was taken back goes on from there.
    pub fn note(&mut self, game: &Game) {
        let now = game.ticks();
        self.path.truncate(self.path.partition_point(|(tick, _)| *tick < now));
        self.impacts.truncate(self.impacts.partition_point(|(tick, _)| *tick < now));
        if self.path.last().is_none_or(|(tick, _)| tick + EVERY <= now) {
            self.path.push((now, game.world().body(SHIP).position));
        }
        let bump = |event: &GameEvent| match event {
            GameEvent::Impact { point, speed, .. } => Some(Bump { at: *point, speed: *speed, damages: false }),
            GameEvent::DamagingHit { point, speed } => Some(Bump { at: *point, speed: *speed, damages: true }),
            _ => None,
        };
        let room = MOST.saturating_sub(self.impacts.len());
        self.impacts.extend(game.events().iter().filter_map(bump).take(room).map(|bump| (now, bump)));
    }

    /// Goes on as another one does from its first tick.
    pub fn go_on_with(&mut self, other: &Self) {
        let Some((first, _)) = other.path.first() else { return };
        self.path.retain(|(tick, _)| tick < first);
        self.impacts.retain(|(tick, _)| tick < first);
        self.path.extend(&other.path);
        self.impacts.extend(&other.impacts);
    }

    /// Of the ship, m.
    pub fn path(&self) -> impl Iterator<Item = DVec2> + '_ {
        self.path.iter().map(|(_, at)| *at)
    }

    pub fn impacts(&self) -> impl Iterator<Item = Bump> + '_ {
        self.impacts.iter().map(|(_, bump)| *bump)
    }
}
