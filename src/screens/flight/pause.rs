//! The pause panel, and the settings above it.

use super::Flight;
use crate::draw::layout::{Area, HEADING, PADDING, Vec2, WIDE_BUTTON};
use crate::screens::screen::{Destination, Effect, Purpose, Request, Screen};
use crate::screens::settings::SettingsPanel;
use crate::settings::Action;
use crate::ui::{Ui, input::Input};
use crate::view::{theme, widgets};
use crate::words::tr;

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

impl Flight {
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
