//! What a screen is.

use super::scene::GameScene;
use super::{Input, Motion, Noise, Request};
use crate::draw::layout::Frame;
use crate::settings::Settings;
use crate::ui::Ui;
use std::any::Any;
use std::fmt;
use std::path::{Path, PathBuf};

/// The tune of the menus.
const MENU_TUNE: &str = "0";

/// A screen: one function that shows it and answers for it, and a few facts that most leave as they are.
pub trait Screen: Any + fmt::Debug {
    /// One pass over it: the request for another screen, or for something that outlasts it.
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request>;

    /// How it moves by itself, where the player does this.
    fn motion(&self, _input: &Input) -> Motion {
        Motion::Still
    }

    /// The name that its tune follows from; `None`: the tune before goes on.
    fn tune(&self) -> Option<&str> {
        Some(MENU_TUNE)
    }

    /// What was heard of it in the last frame; the ticks of a flight are heard by the spectator.
    fn noises(&self) -> Vec<Noise> {
        Vec::new()
    }

    /// Whether it may be left for a file or a folder that is dropped on the window: nothing that is typed or edited gets lost.
    fn takes(&self, _path: &Path) -> bool {
        true
    }

    /// The score on it that only the player can save, in words: it is lost with the window.
    fn unsaved(&self) -> Option<String> {
        None
    }

    /// How large its words are, in a window with `pixel` canvas units a pixel; 1 as designed.
    fn text_scale(&self, _settings: &Settings, _pixel: f32) -> f32 {
        1.0
    }

    /// Takes over the settings that hold now, and the problems of their file, a line each.
    fn tell_of_settings(&mut self, _settings: &Settings, _problems: &[String]) {}

    /// Takes over what became of a curve that was to be kept as a file.
    fn report_export(&mut self, _told: Result<PathBuf, String>) {}

    /// The game on it, in a canvas of that frame: the window's view draws it below the widgets.
    fn scene(&self, _frame: &Frame) -> Option<GameScene<'_>> {
        None
    }
}

impl dyn Screen {
    /// Whether it is of that type.
    pub fn is<T: Screen>(&self) -> bool {
        (self as &dyn Any).is::<T>()
    }

    /// The screen, where it is of that type.
    pub fn get<T: Screen>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }

    /// The screen, where it is of that type.
    pub fn get_mut<T: Screen>(&mut self) -> Option<&mut T> {
        (self as &mut dyn Any).downcast_mut()
    }
}

/// The empty screen: it stands where another one is taken away.
impl Screen for () {
    fn show(&mut self, _: &mut Ui<'_>) -> Option<Request> {
        None
    }
}
