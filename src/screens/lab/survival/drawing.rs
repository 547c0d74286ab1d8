use super::{ROW, SurvivalLine, SurvivalPage, TABLE, WIDEST, body, line_of, panel};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, Frame, PADDING, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::axes::number;
use crate::lab::stress::Survival;
use crate::view::{picture, theme, widgets};

/// From the panel's left edge to tests and to methods, and from its right edge to the values.
const COLUMNS: [f32; 3] = [24.0, 48.0, 48.0];
/// From the panel's right edge to a line's picture, and the width of that.
const PICTURE: (f32, f32) = (336.0, 176.0);
const BETWEEN: f32 = 16.0;
/// From the large picture's panel to the picture: at its top, and at its foot.
const HEAD: f32 = 88.0;
const FOOT: f32 = 92.0;

impl SurvivalPage {
    pub(in crate::screens::lab) fn draw(&self, canvas: &Canvas) {
        let panel = panel(canvas.frame());
        let quiet = Style::new(TEXT, theme::quiet()).middle();
        let words =
            "The largest value that each method survives (≥: all that was tried, 0: nothing), and how it fails just beyond.";
        canvas.text(words, Vec2::new(canvas.size().x / 2.0, panel.min.y - 20.0), quiet.centred());
        widgets::panel(canvas, panel);
        self.toolbar.draw(canvas, &[("Back", "Esc")]);
        if self.lines.is_empty() {
            return canvas.text("There are no stress tests to show.", panel.centre(), quiet.centred());
        }
        for (place, index) in self.scroll.range().enumerate() {
            let line = line_of(panel, place);
            match &self.lines[index] {
                SurvivalLine::Test(test, parameter) => draw_test(canvas, line, (test, parameter), place > 0),
                SurvivalLine::Method(row) => self.draw_method(canvas, line, (index, row)),
            }
        }
        if let Some(bar) = self.scroll.bar() {
            widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
        }
        self.draw_large(canvas, large_panel(canvas.frame()));
    }

    fn draw_method(&self, canvas: &Canvas, line: Area, (index, row): (usize, &Survival)) {
        let (left, right, y) = (line.min.x, panel(canvas.frame()).max().x, line.centre().y);
        if row.shipped || self.chosen() == Some(index) {
            let area = Area::new(left + COLUMNS[0], line.min.y + 1.0, right - left - COLUMNS[0] - COLUMNS[2] + 8.0, ROW - 2.0);
            canvas.rounded(area, 6.0, theme::panel_hover());
        }
        let name = Style::new(TEXT, if row.shipped { theme::accent() } else { theme::quiet() }).middle();
        let widest = right - PICTURE.0 - left - COLUMNS[1] - 8.0;
        canvas.text(&widgets::cut(canvas, &row.method, widest, name), Vec2::new(left + COLUMNS[1], y), name);
        if let Some(drawn) = self.picture(index) {
            let area = Area::new(right - PICTURE.0, line.min.y + 3.0, PICTURE.1, ROW - 6.0);
            picture::small(canvas, area, drawn, line_colour(row));
        }
        let value = Style::new(TEXT, value_colour(row)).middle().right();
        canvas.text(&row.shown(), Vec2::new(right - COLUMNS[2], y), value);
    }

    fn draw_large(&self, canvas: &Canvas, panel: Area) {
        widgets::panel(canvas, panel);
        let Some((index, SurvivalLine::Method(row))) = self.chosen().map(|index| (index, &self.lines[index])) else { return };
        let (middle, widest) = (panel.centre().x, panel.size.x - 2.0 * PADDING);
        let name = if row.shipped { theme::accent() } else { theme::text() };
        widgets::fitted(canvas, &row.method, Vec2::new(middle, panel.min.y + 28.0), widest, &[BUTTON_TEXT, TEXT], name);
        widgets::fitted(canvas, &row.test, Vec2::new(middle, panel.min.y + 58.0), widest, &[TEXT, DETAILS], theme::quiet());
        let stage = Area::new(panel.min.x + PADDING, panel.min.y + HEAD, widest, panel.size.y - HEAD - FOOT);
        let Some(drawn) = self.picture(index) else {
            let words = if row.shipped { "It refuses all of them." } else { "There is no picture of this." };
            let style = Style::new(TEXT, theme::quiet()).middle().centred();
            return canvas.text(words, stage.centre(), style);
        };
        picture::large(canvas, stage, drawn, line_colour(row));
        let survives = row.largest >= row.tried;
        let (words, colour) = if survives { ("It still holds at", theme::good()) } else { ("It fails at", theme::bad()) };
        let words = format!("{words} {}", number(drawn.value));
        let foot = stage.max().y;
        widgets::fitted(canvas, &words, Vec2::new(middle, foot + 24.0), widest, &[TEXT], colour);
        widgets::fitted(canvas, &row.parameter, Vec2::new(middle, foot + 48.0), widest, &[TEXT, DETAILS], theme::quiet());
        let legend = "green: what is right, and how far off still counts";
        widgets::fitted(canvas, legend, Vec2::new(middle, foot + 72.0), widest, &[TEXT, DETAILS], theme::good());
    }
}

fn large_panel(frame: &Frame) -> Area {
    let (body, table) = (body(frame), panel(frame));
    let left = table.max().x + BETWEEN;
    Area::new(left, table.min.y, body.size.x.min(WIDEST) - TABLE - BETWEEN, table.size.y)
}

fn draw_test(canvas: &Canvas, line: Area, (test, parameter): (&str, &str), ruled: bool) {
    let (left, right) = (line.min.x + COLUMNS[0], panel(canvas.frame()).max().x - COLUMNS[2]);
    if ruled {
        canvas.hairline(Vec2::new(left, line.min.y), Vec2::new(right, line.min.y), theme::panel_edge());
    }
    let style = Style::new(TEXT, theme::text()).middle();
    canvas.text(test, Vec2::new(left, line.centre().y), style);
    let room = right - left - canvas.width(test, style) - 24.0;
    let quiet = |size: f32| Style::new(size, theme::quiet()).middle().right();
    let size = if canvas.width(parameter, quiet(TEXT)) <= room { TEXT } else { DETAILS };
    canvas.text(parameter, Vec2::new(right, line.centre().y), quiet(size));
}

fn line_colour(row: &Survival) -> Colour {
    if row.shipped { theme::accent() } else { theme::player_objective() }
}

fn value_colour(row: &Survival) -> Colour {
    match row.largest {
        largest if largest >= row.tried => theme::good(),
        0.0 => theme::bad(),
        _ => theme::text(),
    }
}
