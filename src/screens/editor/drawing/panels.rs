//! The panels around the picture.

use super::*;
use crate::level::Problem;
use crate::view::layout::wrapped;
use macroquad::time::get_fps;

impl Editor {
    pub(super) fn draw_commands(&self, canvas: &Canvas) {
        fill(self.parts.top, theme::panel());
        for (i, (label, key)) in COMMANDS.iter().enumerate() {
            let area = self.commands.areas()[i];
            let on = *label == "Snap" && self.snapping;
            let fill = if self.commands.hover() == Some(i) { theme::panel_hover() } else { theme::ground() };
            widgets::panel_in(canvas, area, fill, if on { theme::accent() } else { theme::panel_edge() });
            let middle = area.centre();
            let can = match *label {
                "Undo" => self.document.history().0 > 0,
                "Redo" => self.document.history().1 > 0,
                "Copy" | "Delete" => !self.selection.is_empty(),
                "Save" => self.is_unsaved(),
                _ => true,
            };
            let colour = if can { theme::text() } else { theme::quiet() };
            canvas.text(label, middle - Vec2::new(0.0, 10.0), Style::new(TEXT, colour).centred().middle());
            canvas.text(key, middle + Vec2::new(0.0, 12.0), Style::new(DETAILS, theme::quiet()).centred().middle().mono());
        }
        let (from, to) = (self.commands.areas()[AT_LEFT - 1].max().x, self.commands.areas()[AT_LEFT].min.x);
        let unsaved = self.is_unsaved();
        let name = if unsaved { format!("{} · not saved", self.name) } else { self.name.clone() };
        let colour = if unsaved { theme::accent() } else { theme::text() };
        let middle = Vec2::new((from + to) / 2.0, self.parts.top.centre().y);
        widgets::fitted(canvas, &name, middle, to - from - 2.0 * INSIDE, &[BUTTON_TEXT, TEXT, DETAILS], colour);
    }

    pub(super) fn draw_tools(&self, canvas: &Canvas) {
        fill(self.parts.left, theme::panel());
        for (i, area) in self.tools.areas().iter().enumerate() {
            let tool = if i == 0 { Tool::Select } else { Tool::Add(Kind::ADDED[i - 1]) };
            let ground = if self.tools.hover() == Some(i) { theme::panel_hover() } else { theme::ground() };
            widgets::panel_in(canvas, *area, ground, if tool == self.tool { theme::accent() } else { theme::panel_edge() });
            let mark = Area::around(Vec2::new(area.min.x + 16.0, area.centre().y), Vec2::new(14.0, 10.0));
            let (label, colour) = match tool {
                Tool::Select => ("Select", theme::text()),
                Tool::Add(kind) => (kind.name(), colour(kind)),
            };
            if tool == Tool::Select {
                edge(mark, 0.75, colour);
            } else {
                fill(mark, colour);
            }
            let at = Vec2::new(mark.max().x + INSIDE, area.centre().y);
            let style = Style::new(TEXT, theme::text()).middle();
            let style =
                if canvas.width(label, style) > area.max().x - at.x - BETWEEN { Style { size: DETAILS, ..style } } else { style };
            canvas.text(label, at, style);
        }
    }

    pub(super) fn draw_panel(&self, canvas: &Canvas, time: f64) {
        let area = self.parts.right;
        fill(area, theme::panel());
        let left = area.min.x + INSIDE;
        let widest = area.size.x - 2.0 * INSIDE;
        let (heading, place) = match (&self.selection[..], self.panel.kind) {
            ([], _) => ("The level".to_owned(), "constants.csv".to_owned()),
            ([row], Some(kind)) => {
                let line = self.document.line(*row).unwrap_or_default();
                (kind.name().to_owned(), format!("{}:{line}", row.table.file()))
            }
            (rows, Some(kind)) => (format!("{} × {}", rows.len(), kind.name()), kind.table().file().to_owned()),
            (rows, None) => (format!("{} things", rows.len()), "of several kinds".to_owned()),
        };
        canvas.text(&heading, Vec2::new(left, area.min.y + INSIDE), Style::new(TEXT, theme::text()));
        let small = Style::new(DETAILS, theme::quiet()).mono();
        canvas.text(&place, Vec2::new(area.max().x - INSIDE, area.min.y + INSIDE + 3.0), small.right());
        for (i, field) in self.panel.fields.iter().enumerate() {
            let at = self.parts.field(i);
            let typing = self.panel.typing.as_ref().filter(|typing| typing.name == field.name);
            let bad = self.is_wrong(field.name);
            let label = Style::new(DETAILS, if field.required { theme::text() } else { theme::quiet() }).mono().middle();
            canvas.text(field.name, Vec2::new(left, at.centre().y), label);
            canvas.text(unit(field.name), Vec2::new(at.max().x + 6.0, at.centre().y), small.middle());
            let border = if bad {
                theme::bad()
            } else if typing.is_some() {
                theme::accent()
            } else {
                theme::panel_edge()
            };
            widgets::panel_in(canvas, at, theme::ground(), border);
            let style = Style::new(DETAILS, theme::text()).mono().middle();
            let start = Vec2::new(at.min.x + INSIDE, at.centre().y);
            let room = at.size.x - 2.0 * INSIDE;
            match typing {
                Some(typing) if choices(field.name).is_empty() => {
                    // The caret stays in view: what is before it is cut off at the left.
                    let before: Vec<char> = typing.field.before_caret().chars().collect();
                    let skip = (0..=before.len())
                        .find(|skip| canvas.width(&before[*skip..].iter().collect::<String>(), style) <= room)
                        .unwrap_or(0);
                    let text: String = typing.field.text().chars().skip(skip).collect();
                    let mut shown = String::new();
                    for letter in text.chars() {
                        if canvas.width(&format!("{shown}{letter}"), style) > room {
                            break;
                        }
                        shown.push(letter);
                    }
                    canvas.text(&shown, start, style);
                    if time.fract() < 0.5 {
                        let x = start.x + canvas.width(&before[skip..].iter().collect::<String>(), style);
                        fill(Area::new(x, start.y - 9.0, 1.5, 18.0), theme::accent());
                    }
                }
                _ => {
                    let (text, colour) = match field.text.as_deref() {
                        None => ("…", theme::quiet()),
                        Some("") => (field.usual, theme::quiet()),
                        Some(text) => (text, theme::text()),
                    };
                    let style = Style { colour, ..style };
                    canvas.text(&widgets::cut(canvas, text, room, style), start, style);
                }
            }
        }
        self.draw_messages(canvas, left, widest);
    }

    /// What is wrong with what is selected, below its fields.
    fn draw_messages(&self, canvas: &Canvas, left: f32, widest: f32) {
        let mut y = self.parts.field(self.panel.fields.len()).min.y + BETWEEN;
        let columns = (widest / canvas.width("0", Style::new(DETAILS, theme::text()).mono())) as usize;
        let own = self.problems.iter().zip(&self.about).filter(|((problem, _), row)| self.is_about(problem, **row));
        for ((problem, refused), _) in own.take(4) {
            let words = format!("{}: found {}, expected {}", problem.column, problem.found, problem.expected);
            for line in wrapped(&words, columns.max(8), 0) {
                if y + self.parts.line > self.parts.right.max().y {
                    return;
                }
                let colour = if *refused { theme::bad() } else { theme::accent() };
                canvas.text(&line, Vec2::new(left, y), Style::new(DETAILS, colour).mono());
                y += self.parts.line;
            }
        }
    }

    /// Whether a problem is about what is selected, or about the level's settings where nothing is.
    fn is_about(&self, problem: &Problem, row: Option<RowId>) -> bool {
        if self.selection.is_empty() {
            problem.file == "constants.csv"
        } else {
            row.is_some_and(|row| self.selection.contains(&row))
        }
    }

    /// Whether something is wrong with a column of what is selected.
    fn is_wrong(&self, column: &str) -> bool {
        let named = |problem: &Problem, row: Option<RowId>| match (self.selection.is_empty(), row) {
            (true, Some(row)) => self.document.cell(row, "name").is_some_and(|name| name.eq_ignore_ascii_case(column)),
            _ => problem.column == column,
        };
        let mut all = self.problems.iter().zip(&self.about);
        all.any(|((problem, _), row)| named(problem, *row) && self.is_about(problem, *row))
    }

    pub(super) fn draw_problems(&self, canvas: &Canvas) {
        let area = self.parts.bottom;
        fill(area, theme::panel());
        let style = Style::new(DETAILS, theme::text()).mono();
        let at = self.pointed();
        let metre = self.document.metre();
        let fps = if self.figures { format!("{} fps   ", get_fps().max(0)) } else { String::new() };
        let zoom = self.view.scale() * 100.0;
        let place = format!("{fps}{:.0}, {:.0} px   {:.2}, {:.2} m   {zoom:.0} %", at.x, at.y, at.x / metre, at.y / metre);
        let head = area.min + Vec2::new(INSIDE, INSIDE / 2.0);
        let end = self.parts.problem(0).max().x;
        canvas.text(&place, Vec2::new(end, head.y), Style::new(DETAILS, theme::quiet()).mono().right());
        let refused = self.problems.iter().filter(|(_, refused)| *refused).count();
        let (words, colour) = match (self.remark(), self.problems.len()) {
            (Some(remark), _) => (remark.to_owned(), theme::accent()),
            (None, 0) => ("No problems.".to_owned(), theme::good()),
            (None, all) if refused == 0 => {
                (format!("{all} {} to look at", if all == 1 { "thing" } else { "things" }), theme::accent())
            }
            (None, _) => (format!("{refused} {}", if refused == 1 { "problem" } else { "problems" }), theme::bad()),
        };
        let room = end - head.x - 2.0 * INSIDE - canvas.width(&place, style);
        canvas.text(&widgets::cut(canvas, &words, room, Style { colour, ..style }), head, Style { colour, ..style });
        for (line, index) in self.scroll.range().enumerate().take(PROBLEM_LINES) {
            let (problem, refused) = &self.problems[index];
            let at = self.parts.problem(line);
            if at.contains(self.pointer) {
                fill(at, theme::panel_hover());
            }
            let style = Style { colour: if *refused { theme::text() } else { theme::quiet() }, ..style };
            canvas.text(&widgets::cut(canvas, &problem.to_string(), at.size.x, style), at.min, style);
        }
        if let Some(bar) = self.scroll.bar() {
            widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
        }
    }
}

pub(super) fn draw_ask(ask: &Ask, canvas: &Canvas) {
    widgets::curtain(canvas, 0.6);
    widgets::panel(canvas, ask.panel);
    let [first, second] = ask.words();
    let (middle, top) = (ask.panel.centre().x, ask.panel.min.y);
    let widest = ask.panel.size.x - 2.0 * PADDING;
    widgets::fitted(canvas, &first, Vec2::new(middle, top + 36.0), widest, &[BUTTON_TEXT, TEXT, DETAILS], theme::text());
    widgets::fitted(canvas, &second, Vec2::new(middle, top + 80.0), widest, &[TEXT, DETAILS], theme::quiet());
    for (i, (label, area)) in ask.answers().iter().zip(ask.buttons().areas()).enumerate() {
        widgets::button(canvas, *area, label, ask.buttons().hover() == Some(i), ask.buttons().focus() == i);
    }
}
