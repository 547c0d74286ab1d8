//! The panels around the picture.

use super::*;
use crate::draw::layout::wrapped;

impl Editor {
    pub(super) fn draw_commands(&self, canvas: &Canvas, tip: &mut Tip) {
        canvas.rectangle(self.parts.top, theme::panel());
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
            let line = |part: f32| middle + Vec2::new(0.0, part * area.size.y);
            canvas.text(label, line(-0.19), Style::new(TEXT, colour).centred().middle());
            canvas.text(key, line(0.27), Style::new(DETAILS, theme::quiet()).centred().middle().mono());
        }
        let (from, to) = (self.commands.areas()[AT_LEFT - 1].max().x, self.commands.areas()[AT_LEFT].min.x);
        let unsaved = self.is_unsaved();
        let name = if unsaved { format!("{} · not saved", self.name) } else { self.name.clone() };
        let colour = if unsaved { theme::accent() } else { theme::text() };
        let middle = Vec2::new((from + to) / 2.0, self.parts.top.centre().y);
        let room = to - from - 2.0 * INSIDE;
        let area = Area::around(middle, Vec2::new(room, self.parts.top.size.y));
        let name = tip.cut(canvas, &name, area, room, Style::new(DETAILS, colour));
        widgets::fitted(canvas, &name, middle, room, &[BUTTON_TEXT, TEXT, DETAILS], colour);
    }

    pub(super) fn draw_tools(&self, canvas: &Canvas) {
        canvas.rectangle(self.parts.left, theme::panel());
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
                edge(canvas, mark, 0.75, colour);
            } else {
                canvas.rectangle(mark, colour);
            }
            let at = Vec2::new(mark.max().x + INSIDE, area.centre().y);
            canvas.text(label, at, Style::new(DETAILS, theme::text()).middle());
        }
    }

    pub(super) fn draw_panel(&self, canvas: &Canvas, time: f64, tip: &mut Tip) {
        let area = self.parts.right;
        canvas.rectangle(area, theme::panel());
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
            let label = Style::new(DETAILS, if field.column.required { theme::text() } else { theme::quiet() }).mono().middle();
            canvas.text(field.name, Vec2::new(left, at.centre().y), label);
            tip.explain(field.column, Area { min: Vec2::new(left, at.min.y), size: Vec2::new(at.min.x - left, at.size.y) });
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
            match typing {
                Some(typing) if field.column.choices().is_empty() => {
                    typing.field.draw(canvas, at, (DETAILS, INSIDE), Some(time));
                }
                _ => {
                    let (text, colour) = match field.text.as_deref() {
                        None => ("…", theme::quiet()),
                        Some("") => (field.column.usual, theme::quiet()),
                        Some(text) => (text, theme::text()),
                    };
                    let (style, unit) = (Style { colour, ..style }, field.column.unit());
                    let whole = at.size.x - 2.0 * INSIDE;
                    // The unit gives way to a long text.
                    let beside = whole - canvas.width(&unit, small) - INSIDE;
                    let fits = canvas.width(text, style) <= beside;
                    canvas.text(&tip.cut(canvas, text, at, if fits { beside } else { whole }, style), start, style);
                    if fits {
                        canvas.text(&unit, Vec2::new(at.max().x - INSIDE, start.y), small.middle().right());
                    }
                }
            }
        }
        let below = self.draw_offers(canvas, tip);
        self.draw_messages(canvas, (left, below), widest);
    }

    /// The pictures that are there, where what is selected shows one; where they end.
    fn draw_offers(&self, canvas: &Canvas, tip: &mut Tip) -> f32 {
        let (fields, offers) = (self.panel.fields.len(), self.offers());
        let top = self.parts.field(fields).min.y;
        if offers.is_empty() {
            return top;
        }
        let style = Style::new(DETAILS, theme::quiet()).mono();
        let more = self.offered.len() - offers.len();
        let words = if more > 0 { format!("Pictures, and {more} more to write:") } else { "Pictures to click:".to_owned() };
        canvas.text(&words, self.parts.offer(fields, 0).min - Vec2::new(0.0, self.parts.line), style);
        for (index, picture) in offers.iter().enumerate() {
            let area = self.parts.offer(fields, index);
            if area.contains(self.pointer) {
                canvas.rectangle(area, theme::panel_hover());
            }
            let taken = self.selection.iter().all(|row| self.document.cell(*row, "image") == Some(picture));
            let style = Style { colour: if taken { theme::accent() } else { theme::text() }, ..style };
            canvas.text(&tip.cut(canvas, picture, area, area.size.x - INSIDE, style), area.min + Vec2::new(INSIDE, 0.0), style);
        }
        self.parts.offer(fields, offers.len()).min.y
    }

    /// What is wrong with what is selected, below its fields.
    fn draw_messages(&self, canvas: &Canvas, (left, top): (f32, f32), widest: f32) {
        let mut y = top + BETWEEN;
        let columns = (widest / self.parts.letter) as usize;
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

    pub(super) fn draw_problems(&self, canvas: &Canvas, fps: f64, tip: &mut Tip) {
        let area = self.parts.bottom;
        canvas.rectangle(area, theme::panel());
        let style = Style::new(DETAILS, theme::text()).mono();
        let at = self.pointed();
        let metre = self.document.metre();
        let fps = if self.figures { format!("{fps:.0} fps   ") } else { String::new() };
        let zoom = self.view.scale() * 100.0;
        let place = format!("{fps}{:.0}, {:.0} px   {:.2}, {:.2} m   {zoom:.0} %", at.x, at.y, at.x / metre, at.y / metre);
        let head = area.min + Vec2::new(INSIDE, INSIDE * 0.75);
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
        let shown = widgets::cut(canvas, &words, room, Style { colour, ..style });
        if shown != words {
            tip.whole = Some(words);
        }
        canvas.text(&shown, head, Style { colour, ..style });
        for (line, index) in self.scroll.range().enumerate().take(PROBLEM_LINES) {
            let Some((problem, refused)) = self.problems.get(index) else { break };
            let at = self.parts.problem(line);
            if at.contains(self.pointer) {
                canvas.rectangle(at, theme::panel_hover());
            }
            let style = Style { colour: if *refused { theme::text() } else { theme::quiet() }, ..style };
            canvas.text(&tip.cut(canvas, &problem.to_string(), at, at.size.x, style), at.min, style);
        }
        if let Some(bar) = self.scroll.bar() {
            widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
        }
    }

    /// Words in whole, in as many lines as they need, above the picture's lower edge.
    pub(super) fn draw_banner(&self, canvas: &Canvas, words: &str) {
        let widest = self.parts.middle.size.x - 4.0 * INSIDE;
        let lines = wrapped(words, (widest / self.parts.letter) as usize, 4);
        let longest = lines.iter().map(|line| line.chars().count()).max().unwrap_or_default();
        let size =
            Vec2::new(longest as f32 * self.parts.letter + 2.0 * INSIDE, lines.len() as f32 * self.parts.line + 1.5 * INSIDE);
        let middle = self.parts.middle;
        let area = Area { min: Vec2::new(middle.min.x + INSIDE, middle.max().y - INSIDE - size.y), size };
        canvas.end_layer();
        widgets::panel_in(canvas, area, theme::panel(), theme::accent());
        for (i, line) in lines.iter().enumerate() {
            let at = area.min + Vec2::new(INSIDE, 0.75 * INSIDE + i as f32 * self.parts.line);
            canvas.text(line, at, Style::new(DETAILS, theme::text()).mono());
        }
    }
}

pub(super) fn draw_ask(ask: &Ask, canvas: &Canvas) {
    widgets::curtain(canvas, 0.6);
    widgets::panel(canvas, ask.panel);
    let middle = ask.panel.centre().x;
    for (i, (line, first)) in ask.lines().iter().enumerate() {
        let colour = if *first { theme::text() } else { theme::quiet() };
        let at = Vec2::new(middle, ask.panel.min.y + 1.5 * PADDING + i as f32 * canvas.line_height(TEXT));
        canvas.text(line, at, Style::new(TEXT, colour).centred());
    }
    for (i, (label, area)) in ask.answers().iter().zip(ask.buttons().areas()).enumerate() {
        widgets::button(canvas, *area, label, ask.buttons().hover() == Some(i), ask.buttons().focus() == i);
    }
}
