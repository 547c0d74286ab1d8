//! The table of the stress tests with a small picture of each failure, and a large one of the selected line.

use super::BACK;
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, EDGE, PADDING, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::{lab::drawing::picture, number::short, screens::screen::Request, ui::Turning, ui::Ui, ui::scroll::bar_beside};
use crate::{lab::stress, lab::stress::Survival, lab::stress::picture::FailurePicture, view::theme, view::widgets, words::tr};
use std::collections::HashMap;

const ROW: f32 = 40.0;
const TABLE: f32 = 768.0;
/// Widest of table and picture together.
const WIDEST: f32 = 1440.0;
const INSIDE: f32 = 8.0;
const WORDS: f32 = 40.0;
/// From the panel's left edge to tests and to methods, and from its right edge to the values.
const COLUMNS: [f32; 3] = [24.0, 48.0, 48.0];
/// From the panel's right edge to a line's picture, and the width of that.
const PICTURE: (f32, f32) = (336.0, 176.0);
/// The same where words are large.
const SMALL_PICTURE: (f32, f32) = (276.0, 96.0);
const BETWEEN: f32 = 16.0;
/// Lines of the words on its test, for which there is always room.
const SENTENCE: usize = 3;

#[derive(Clone, Debug, PartialEq)]
enum SurvivalLine {
    /// With the number that grows, and its unit.
    Test(String, String),
    Method(Survival),
}

#[derive(Debug)]
pub struct SurvivalPage {
    lines: Vec<SurvivalLine>,
    tried: HashMap<&'static str, &'static str>,
    /// One a line, computed when the line comes into view.
    pictures: HashMap<usize, Option<FailurePicture>>,
}

impl SurvivalPage {
    pub(super) fn new(stress: &[Survival]) -> Self {
        let tests = stress.chunk_by(|a, b| a.test == b.test);
        let lines = tests.flat_map(|rows| {
            let head = SurvivalLine::Test(rows[0].test.clone(), rows[0].parameter.clone());
            std::iter::once(head).chain(rows.iter().cloned().map(SurvivalLine::Method))
        });
        Self { lines: lines.collect(), tried: stress::tried(), pictures: HashMap::new() }
    }

    pub(super) fn show(&mut self, ui: &mut Ui<'_>, body: Area) -> Option<Request> {
        let request = ui.tools(&[BACK]).map(|_| Request::Pop);
        let (table, large) = panels(body);
        let quiet = Style::new(TEXT, theme::quiet()).middle().centred();
        let words =
            tr("The largest value that each method survives (≥: all that was tried, 0: nothing), and how it fails just beyond.");
        ui.text(words, Vec2::new(body.centre().x, table.min.y - 20.0), quiet);
        ui.panel(table);
        let (page, rows) = (page(table), table.min.y + INSIDE);
        let track = bar_beside(table, rows, rows + page as f32 * ROW);
        let range = ui.scroll("stress tests", (self.lines.len(), page), track, Turning::Lines);
        if self.lines.is_empty() {
            ui.text(tr("There are no stress tests to show."), table.centre(), quiet);
            return request;
        }
        let is_method = |line: &usize| matches!(self.lines[*line], SurvivalLine::Method(_));
        let pointed = |line: &usize| line_of(table, line - range.start).contains(ui.input().pointer);
        let chosen = range.clone().filter(is_method).find(pointed).or_else(|| range.clone().find(is_method));
        if ui.input().frame_time > 0.0 {
            self.compute_one_more(chosen.into_iter().chain(range.clone()));
        }
        for (place, index) in range.enumerate() {
            let line = line_of(table, place);
            match &self.lines[index] {
                SurvivalLine::Test(test, parameter) => draw_test(ui.canvas(), line, (tr(test), tr(parameter)), place > 0),
                SurvivalLine::Method(row) => self.draw_method(ui.canvas(), line, (index, row), chosen == Some(index)),
            }
        }
        ui.panel(large);
        if let Some((index, SurvivalLine::Method(row))) = chosen.map(|index| (index, &self.lines[index])) {
            self.draw_large(ui.canvas(), large, (index, row));
        }
        request
    }

    /// Computes the first picture that is missing: each takes up to a few milliseconds.
    fn compute_one_more(&mut self, wanted: impl Iterator<Item = usize>) {
        let missing = wanted.filter(|line| !self.pictures.contains_key(line));
        let method = |line: usize| if let SurvivalLine::Method(row) = &self.lines[line] { Some((line, row)) } else { None };
        if let Some((line, row)) = missing.filter_map(method).next() {
            let picture = stress::picture(row);
            self.pictures.insert(line, picture);
        }
    }

    /// `None` until it is computed.
    fn picture(&self, line: usize) -> Option<&FailurePicture> {
        self.pictures.get(&line)?.as_ref()
    }

    fn draw_method(&self, canvas: &Canvas, line: Area, (index, row): (usize, &Survival), chosen: bool) {
        let (left, right, y) = (line.min.x, line.max().x, line.centre().y);
        if row.shipped || chosen {
            let area = Area::new(left + COLUMNS[0], line.min.y + 1.0, right - left - COLUMNS[0] - COLUMNS[2] + 8.0, ROW - 2.0);
            canvas.rounded(area, 6.0, theme::panel_hover());
            if chosen {
                canvas.rounded_edge(area, 6.0, EDGE, theme::accent());
            }
        }
        let name = Style::new(TEXT, if row.shipped { theme::accent() } else { theme::text() }).middle();
        let (from_right, width) = if canvas.frame().text > 1.0 { SMALL_PICTURE } else { PICTURE };
        // A name that is too long for its column takes some of the picture's.
        let widest = right - from_right + width / 2.0 - left - COLUMNS[1] - 8.0;
        let (words, at) = (widgets::cut(canvas, tr(&row.method), widest, name), Vec2::new(left + COLUMNS[1], y));
        canvas.text(&words, at, name);
        if let Some(drawn) = self.picture(index) {
            let from = (right - from_right).max(at.x + canvas.width(&words, name) + 8.0);
            let area = Area::new(from, line.min.y + 3.0, right - from_right + width - from, ROW - 6.0);
            picture::small(canvas, area, drawn, line_colour(row));
        }
        let value = Style::new(TEXT, value_colour(row)).middle().right();
        canvas.text(&row.shown(), Vec2::new(right - COLUMNS[2], y), value);
    }

    fn draw_large(&self, canvas: &Canvas, panel: Area, (index, row): (usize, &Survival)) {
        let (middle, widest) = (panel.centre().x, panel.size.x - 2.0 * PADDING);
        let write = |top: f32, words: &str, size: f32, colour: Colour| {
            let style = Style::new(size, colour).middle().centred();
            let (lines, pitch) = (widgets::lines(canvas, words, widest, style), 1.15 * canvas.frame().text_height(size));
            for (line, words) in lines.iter().enumerate() {
                canvas.text(words, Vec2::new(middle, top + (line as f32 + 0.5) * pitch), style);
            }
            (lines.len(), pitch)
        };
        let name = if row.shipped { theme::accent() } else { theme::text() };
        let mut top = panel.min.y + INSIDE;
        for (words, size, colour) in [(row.method.as_str(), BUTTON_TEXT, name), (row.test.as_str(), TEXT, theme::quiet())] {
            let (lines, pitch) = write(top, tr(words), size, colour);
            top += lines as f32 * pitch;
        }
        let sentence = self.tried.get(row.test.as_str()).map_or("", |sentence| tr(sentence));
        let (lines, pitch) = write(top + INSIDE, sentence, DETAILS, theme::text());
        top += 2.0 * INSIDE + lines.max(if canvas.frame().text > 1.0 { 0 } else { SENTENCE }) as f32 * pitch;
        let Some(drawn) = self.picture(index) else {
            let words = if row.shipped { tr("It refuses all of them.") } else { tr("There is no picture of this.") };
            let stage = Area::new(panel.min.x, top, panel.size.x, panel.max().y - top);
            return canvas.text(words, stage.centre(), Style::new(TEXT, theme::quiet()).middle().centred());
        };
        let survives = row.largest >= row.tried;
        let (words, colour) = if survives { (tr("It still holds at"), theme::good()) } else { (tr("It fails at"), theme::bad()) };
        let words = format!("{words} {}", short(drawn.value));
        let legend = tr("green: exact, and within the tolerance");
        let foot = [(words.as_str(), colour), (tr(&row.parameter), theme::quiet()), (legend, theme::good())];
        let size_of = |words: &str| {
            let fits = |size: &f32| canvas.width(words, Style::new(*size, colour)) <= widest;
            [TEXT, DETAILS].into_iter().find(fits).unwrap_or(DETAILS)
        };
        let height_of = |words: &str| {
            let style = Style::new(size_of(words), colour);
            widgets::lines(canvas, words, widest, style).len() as f32 * 1.15 * canvas.frame().text_height(style.size)
        };
        let foot_top = panel.max().y - INSIDE - foot.iter().map(|(words, _)| height_of(words)).sum::<f32>();
        let stage = Area::new(panel.min.x + PADDING, top, widest, foot_top - INSIDE - top);
        picture::large(canvas, stage, drawn, line_colour(row));
        let mut at = foot_top;
        for (words, colour) in foot {
            let (lines, pitch) = write(at, words, size_of(words), colour);
            at += lines as f32 * pitch;
        }
    }
}

fn panels(body: Area) -> (Area, Area) {
    let width = body.size.x.min(WIDEST);
    let (left, top) = (body.centre().x - width / 2.0, body.min.y + WORDS);
    let lines = page(Area::new(left, top, TABLE, body.size.y - WORDS));
    let height = lines as f32 * ROW + 2.0 * INSIDE;
    let beside = TABLE + BETWEEN;
    (Area::new(left, top, TABLE, height), Area::new(left + beside, top, width - beside, height))
}

fn line_of(panel: Area, place: usize) -> Area {
    Area::new(panel.min.x, panel.min.y + INSIDE + place as f32 * ROW, panel.size.x, ROW)
}

fn page(panel: Area) -> usize {
    ((panel.size.y - 2.0 * INSIDE) / ROW).floor() as usize
}

fn draw_test(canvas: &Canvas, line: Area, (test, parameter): (&str, &str), ruled: bool) {
    let (left, right) = (line.min.x + COLUMNS[0], line.max().x - COLUMNS[2]);
    if ruled {
        canvas.hairline(Vec2::new(left, line.min.y), Vec2::new(right, line.min.y), theme::panel_edge());
    }
    let style = Style::new(TEXT, theme::text()).middle();
    canvas.text(test, Vec2::new(left, line.centre().y), style);
    let room = right - left - canvas.width(test, style) - 24.0;
    let quiet = |size: f32| Style::new(size, theme::quiet()).middle().right();
    // Where it has no room it stands below the large picture alone.
    if let Some(size) = [TEXT, DETAILS].into_iter().find(|size| canvas.width(parameter, quiet(*size)) <= room) {
        canvas.text(parameter, Vec2::new(right, line.centre().y), quiet(size));
    }
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
