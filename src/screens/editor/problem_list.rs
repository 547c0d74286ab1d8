//! The pane below the picture: the pointer's place, the last remark, and the problems, a line each.

use super::layout::{INSIDE, PROBLEM_LINES};
use super::{CHECK_AFTER, Editor, EditorPass};
use crate::draw::layout::{Area, DETAILS, Vec2, wrapped};
use crate::level::document::{Kind, RowId, Table};
use crate::ui::{Ui, WidgetKind, input::Input};
use crate::{draw::Canvas, draw::Style, view::theme, view::widgets};
use crate::{level::Problem, settings::Keys, words::tr};
use std::sync::Arc;

impl Editor {
    pub(super) fn check(&mut self) {
        if !self.document.unknown_pictures().is_empty() {
            self.folder.measure(&mut self.document);
        }
        (self.level, self.problems) = match self.folder.check(&self.document) {
            Ok(loaded) => (Some(Arc::new(loaded.level)), loaded.warnings.into_iter().map(|warning| (warning, false)).collect()),
            Err(problems) => (None, problems.into_iter().map(|problem| (problem, true)).collect()),
        };
        let row = |problem: &Problem| self.document.row_at(Table::of_file(&problem.file)?, problem.line);
        self.about = self.problems.iter().map(|(problem, _)| row(problem)).collect();
        self.checked = (Some(self.document.version()), CHECK_AFTER);
    }

    pub(super) fn show_problems(&mut self, ui: &mut Ui<'_>, pass: &mut EditorPass) {
        let (canvas, pointed) = (ui.canvas(), self.panes.bottom.contains(self.pointer));
        let lines = self.problems.len().min(PROBLEM_LINES);
        let (first, bottom) = (self.panes.problem(0), self.panes.bottom);
        let room = Area::new(bottom.max().x - 14.0, first.min.y, 12.0, lines as f32 * self.panes.line);
        self.scroll.place(self.problems.len(), lines.max(1), room);
        if pointed && pass.open && self.drag.is_none() {
            // Keys that scroll elsewhere move the selection here.
            self.scroll.update(&Input { pressed: Keys::default(), ..ui.input().clone() });
        }
        canvas.rectangle(bottom, theme::panel());
        let place = self.place_in_words(if self.figures { ui.spectator.frames() } else { 0.0 });
        let style = Style::new(DETAILS, theme::quiet()).mono();
        canvas.text(&place, Vec2::new(first.max().x, bottom.min.y + INSIDE * 0.75), style.right());
        self.draw_state(canvas, first.size.x - 2.0 * INSIDE - canvas.width(&place, style), pass);
        let mut pressed = None;
        for (line, index) in self.scroll.range().enumerate().take(PROBLEM_LINES) {
            let Some((problem, refused)) = self.problems.get(index) else { break };
            let (at, words) = (self.panes.problem(line), problem.to_string());
            let touch = ui.touch(&words, at, WidgetKind::Tool);
            if touch.hover {
                canvas.rectangle(at, theme::panel_hover());
            }
            let style = Style { colour: if *refused { theme::text() } else { theme::quiet() }, ..style };
            let signed = format!("{} {words}", if *refused { "×" } else { "·" });
            canvas.text(&pass.cut(canvas, &signed, (at, at.size.x), style), at.min, style);
            pressed = pressed.or(touch.pressed.then(|| problem.clone()));
        }
        if let Some(bar) = self.scroll.bar() {
            widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
        }
        if pass.open && self.drag.is_none() && pointed && ui.input().click {
            pass.close(None);
            if let Some(problem) = pressed {
                self.go_to(&problem);
            }
        }
    }

    /// The pointer's place in pixels and metres, the scale, and the frames a second where there are some.
    fn place_in_words(&self, frames: f64) -> String {
        let (at, metre) = (self.view.pixels(self.pointer), self.document.metre());
        let frames = if frames > 0.0 { format!("{frames:.0} fps   ") } else { String::new() };
        let zoom = self.view.scale * 100.0;
        format!("{frames}{:.0}, {:.0} px   {:.2}, {:.2} m   {zoom:.0} %", at.x, at.y, at.x / metre, at.y / metre)
    }

    /// The last remark while it is shown, else the number of problems; in whole above the picture where there is no room.
    fn draw_state(&self, canvas: &Canvas, room: f32, pass: &mut EditorPass) {
        let refused = self.problems.iter().filter(|(_, refused)| *refused).count();
        let counted = |count: usize, [one, more]: [&str; 2]| if count == 1 { tr(one).to_owned() } else { tr!(more, count) };
        let (words, colour) = match (&self.remark, self.problems.len()) {
            (Some((remark, _)), _) => (remark.clone(), theme::accent()),
            (None, 0) => (tr("No problems.").to_owned(), theme::good()),
            (None, all) if refused == 0 => (counted(all, ["1 thing to look at", "{count} things to look at"]), theme::accent()),
            (None, _) => (counted(refused, ["1 problem", "{count} problems"]), theme::bad()),
        };
        let style = Style::new(DETAILS, colour).mono();
        let shown = widgets::cut(canvas, &words, room, style);
        canvas.text(&shown, self.panes.bottom.min + Vec2::new(INSIDE, INSIDE * 0.75), style);
        if shown != words {
            pass.tip = Some(words);
        }
    }

    pub(super) fn draw_banner(&self, canvas: &Canvas, words: &str) {
        let (middle, letter, line) = (self.panes.middle, self.panes.letter, self.panes.line);
        let lines = wrapped(words, ((middle.size.x - 4.0 * INSIDE) / letter) as usize, 4);
        let longest = lines.iter().map(|line| line.chars().count()).max().unwrap_or_default();
        let size = Vec2::new(longest as f32 * letter + 2.0 * INSIDE, lines.len() as f32 * line + 1.5 * INSIDE);
        let area = Area { min: Vec2::new(middle.min.x + INSIDE, middle.max().y - INSIDE - size.y), size };
        canvas.end_layer();
        widgets::panel_in(canvas, area, theme::panel(), theme::accent());
        for (i, words) in lines.iter().enumerate() {
            let at = area.min + Vec2::new(INSIDE, 0.75 * INSIDE + i as f32 * line);
            canvas.text(words, at, Style::new(DETAILS, theme::text()).mono());
        }
    }

    /// Selects the row of a problem and brings it into view, where it is not; another time it puts the keyboard into its column.
    fn go_to(&mut self, problem: &Problem) {
        let row = Table::of_file(&problem.file).and_then(|table| self.document.row_at(table, problem.line));
        let before = std::mem::take(&mut self.selection);
        let Some(row) = row else { return self.say(tr!("{file} has no such row.", file = problem.file)) };
        self.gesture += 1;
        if self.document.kind(row) == Some(Kind::Setting) {
            let name = self.document.cell(row, "name").unwrap_or_default().to_owned();
            self.panel.read(&self.document, &[]);
            return self.panel.focus(&name, self.gesture);
        }
        self.selection = vec![row];
        self.panel.read(&self.document, &self.selection);
        self.panel.typing = None;
        if before == [row] {
            self.panel.focus(&problem.column, self.gesture);
        }
        if let Some(place) = self.document.place(row).filter(|place| !self.view.visible().meets(place)) {
            self.view.centre(place.centre());
        }
    }

    /// Whether a problem is about the selection, or about the level's settings where that is empty.
    pub(super) fn is_about(&self, problem: &Problem, row: Option<RowId>) -> bool {
        if self.selection.is_empty() {
            problem.file == "constants.csv"
        } else {
            row.is_some_and(|row| self.selection.contains(&row))
        }
    }

    pub(super) fn is_wrong(&self, column: &str) -> bool {
        let named = |problem: &Problem, row: Option<RowId>| match (self.selection.is_empty(), row) {
            (true, Some(row)) => self.document.cell(row, "name").is_some_and(|name| name.eq_ignore_ascii_case(column)),
            _ => problem.column == column,
        };
        let mut all = self.problems.iter().zip(&self.about);
        all.any(|((problem, _), row)| named(problem, *row) && self.is_about(problem, *row))
    }
}
