//! The list of classics.

pub mod jumper;
pub mod pi;
pub mod tile_run;

use crate::screens::screen::{Classic, Destination, Request, Screen};
use crate::{draw::layout::TEXT, draw::layout::Vec2, view::theme};
use crate::{settings::Key, ui::Ui, words::tr};

/// The classics, the words on their buttons, and what each is.
const ALL: [(Classic, &str, &str); 3] = [
    (Classic::TileRun, "Tile Run", "A point runs and jumps through a map of tiles, one command a frame, exact to the last bit."),
    (Classic::Jumper, "Jumper", "Climb an endless tower, alone or together, before the view leaves you behind."),
    (Classic::Pi, "π from Collisions", "Two blocks and a wall: count their collisions, and read the digits of π."),
];
/// From the canvas' top to the heading, to the first button and to what a classic is, of the canvas' height.
const AT: [f32; 3] = [0.2, 0.3, 0.8];

#[derive(Debug)]
pub struct Classics {
    left: Option<Classic>,
    problem: Option<String>,
}

impl Classics {
    /// The list, with the focus on the one that was left, and with why one cannot be had.
    pub fn new(left: Option<Classic>, problem: Option<String>) -> Self {
        Self { left, problem }
    }
}

impl Screen for Classics {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let [heading, buttons, words] = AT.map(|at| (ui.frame().size.y * at).round());
        ui.page("Classics", heading);
        if let Some((_, label, _)) = ALL.iter().find(|(classic, ..)| Some(*classic) == self.left) {
            ui.start_at(label);
        }
        let pressed = ui.column(buttons, &[ALL[0].1, ALL[1].1, ALL[2].1, "Back"]);
        let about = ALL.iter().find(|(_, label, _)| ui.has_focus(label)).map_or("", |(.., about)| tr(about));
        let (words_of, colour) = self.problem.as_ref().map_or((about, theme::quiet()), |problem| (problem, theme::bad()));
        ui.fitted(words_of, Vec2::new(ui.frame().size.x / 2.0, words), &[TEXT], colour);
        if ui.key(Key::Escape) {
            return Some(Request::Pop);
        }
        let pressed = pressed?;
        let classic = ALL.iter().find(|(_, label, _)| *label == pressed);
        Some(classic.map_or(Request::Pop, |(classic, ..)| Request::Reset(Destination::Classic(*classic))))
    }
}
