//! In a browser, in the place of Quit: what the browser keeps for the page, as one file and back.

use crate::{draw::Style, draw::layout::TEXT, draw::layout::Vec2, settings::Key, ui::Ui, web, words::tr};
use crate::{screens::screen::Request, screens::screen::Screen, view::theme};

const LINES: [&str; 5] = [
    "The browser keeps your scores, flights, levels and settings for this page, on this computer alone.",
    "It has room for some 5 MB, and forgets them when you clear its data. Where it is full: export, then delete.",
    "Export writes all of it into one file, resultant-data.zip, which any browser takes: Import, or drop it here.",
    "Unzipped beside the game on a desktop it is the game's own levels/, scores/ and settings.csv.",
    "A level as one file (.zip) comes in by the same Import.",
];

const DELETE: &str = "Delete all";

#[derive(Debug, Default)]
pub struct PageData {
    message: String,
    warned: bool,
}

impl Screen for PageData {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        ui.page("Your data", 64.0);
        let middle = Vec2::new(ui.frame().size.x / 2.0, 200.0);
        for (line, number) in LINES.map(tr).into_iter().zip(0_u8..) {
            ui.fitted(line, middle + Vec2::new(0.0, 40.0 * f32::from(number)), &[TEXT], theme::text());
        }
        let style = Style::new(TEXT, theme::accent()).centred().middle();
        ui.text(&self.message, middle + Vec2::new(0.0, 240.0), style);
        let pressed = ui.row(ui.frame().size.y - 88.0, &["Export", "Import", DELETE, "Back"]);
        if ui.key(Key::Escape) {
            return Some(Request::Pop);
        }
        match pressed? {
            "Export" => self.message = web::export(),
            "Import" => web::choose_file(),
            DELETE if self.warned => web::delete(),
            DELETE => {
                tr("Press again to delete all scores, flights, levels and settings of this page.").clone_into(&mut self.message);
                self.warned = true;
            }
            _ => return Some(Request::Pop),
        }
        None
    }
}
