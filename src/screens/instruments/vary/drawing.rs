//! The panel: a line a number, with slider, value and the level's own value.

use super::{Vary, VaryEntry, VaryFrom, VaryLine};
use crate::draw::layout::{Area, DETAILS, GRID, Vec2};
use crate::draw::{Canvas, Style};
use crate::instruments::vary::SliderTrack;
use crate::level::Parameter;
use crate::screens::text_field::TextField;
use crate::view::quantity::scalar;
use crate::view::{theme, widgets};

/// From the edge of a button or field to its content.
const INSIDE: f32 = 0.75 * GRID;
const APART: f32 = 2.0;

/// With its unit; a factor with its sign.
pub fn written(parameter: Parameter, value: f64) -> String {
    let text = scalar(value, parameter.unit());
    match parameter {
        Parameter::Friction | Parameter::Wind => format!("× {}", text.trim()),
        _ => text.trim().to_owned(),
    }
}

impl Vary {
    pub fn draw(&self, canvas: &Canvas) {
        if self.lines.is_empty() {
            return;
        }
        let layout = &self.layout;
        widgets::panel_in(canvas, layout.panel, theme::panel(), theme::panel_edge());
        let heading = layout.heading();
        let at = Vec2::new(heading.min.x, heading.centre().y);
        canvas.text(&format!("What if: {} and level", self.title), at, Style::new(DETAILS, theme::accent()).middle());
        let hint = Style::new(DETAILS, theme::quiet()).middle().right();
        canvas.text("Tab, N: another object", Vec2::new(heading.max().x, at.y), hint);
        for (i, line) in self.lines.iter().enumerate() {
            self.draw_line(i, line, canvas);
        }
        let buttons = [
            ("From the start", true, self.from == VaryFrom::Start),
            ("From now", true, self.from == VaryFrom::Now),
            ("Reset all", true, false),
            ("Save as level", self.is_varied, false),
        ];
        for ((label, open, chosen), area) in buttons.into_iter().zip(layout.buttons) {
            self.draw_button((label, open, chosen), area, canvas);
        }
        self.draw_foot(canvas);
    }

    fn draw_button(&self, (label, open, chosen): (&str, bool, bool), area: Area, canvas: &Canvas) {
        let area = Area::new(area.min.x, area.min.y + APART, area.size.x, area.size.y - 2.0 * APART);
        let fill = if open && area.contains(self.pointer) { theme::panel_hover() } else { theme::ground() };
        let edge = if chosen { theme::accent() } else { theme::panel_edge() };
        widgets::panel_in(canvas, area, fill, edge);
        let colour = if open { theme::text() } else { theme::quiet() };
        widgets::fitted(canvas, label, area.centre(), area.size.x - 2.0 * INSIDE, &[DETAILS], colour);
    }

    fn draw_line(&self, index: usize, line: &VaryLine, canvas: &Canvas) {
        let layout = &self.layout;
        let (colour, quiet) = (if line.open { theme::text() } else { theme::quiet() }, theme::quiet());
        let varied = line.is_varied();
        let name = layout.name(index);
        let at = Vec2::new(name.min.x, name.centre().y);
        let style = Style::new(DETAILS, if varied { theme::accent() } else { colour }).middle();
        canvas.text(&widgets::cut(canvas, line.parameter.name(), name.size.x, style), at, style);

        let track = SliderTrack::of(line.parameter, line.usual);
        let (begins, ends) = layout.way();
        let x = |value: f64| begins + (ends - begins) * track.part(value) as f32;
        canvas.line(Vec2::new(begins, at.y), Vec2::new(ends, at.y), 3.0, theme::solid());
        let usual = x(line.usual);
        canvas.line(Vec2::new(usual, at.y - layout.knob()), Vec2::new(usual, at.y + layout.knob()), 2.0, quiet);
        if line.open {
            let held = self.held == Some(line.parameter);
            let fill = if varied || held { theme::accent() } else { theme::text() };
            canvas.disc(Vec2::new(x(line.value), at.y), layout.knob(), fill);
        }

        let number = inner(layout.number(index));
        match &self.entry {
            Some((VaryEntry::Number(parameter), field)) if *parameter == line.parameter => draw_field(field, number, canvas),
            _ => {
                let hover = line.open && number.contains(self.pointer);
                widgets::panel_in(canvas, number, if hover { theme::panel_hover() } else { theme::ground() }, theme::panel_edge());
                let style = Style::new(DETAILS, colour).mono().middle().right();
                let text = written(line.parameter, line.value);
                let text = widgets::cut(canvas, &text, number.size.x - 2.0 * INSIDE, style);
                canvas.text(&text, Vec2::new(number.max().x - INSIDE, at.y), style);
            }
        }
        if varied {
            let reset = inner(layout.reset(index));
            let hover = reset.contains(self.pointer);
            widgets::panel_in(canvas, reset, if hover { theme::panel_hover() } else { theme::panel() }, theme::panel_edge());
            let back = format!("← {}", written(line.parameter, line.usual));
            widgets::fitted(canvas, &back, reset.centre(), reset.size.x - INSIDE, &[DETAILS], quiet);
        }
    }

    /// The name of the new level, or the last message, or the progress of the flight.
    fn draw_foot(&self, canvas: &Canvas) {
        let field = self.layout.field;
        let (middle, widest) = (field.centre(), field.size.x);
        let say = |words: &str, colour| widgets::fitted(canvas, words, middle, widest, &[DETAILS], colour);
        match (&self.entry, &self.message, self.progress) {
            (Some((VaryEntry::Name, text)), None, _) => {
                draw_field(text, inner(field), canvas);
                if text.text().is_empty() {
                    let style = Style::new(DETAILS, theme::quiet()).middle().right();
                    canvas.text("its name, or Enter for any", Vec2::new(field.max().x - INSIDE, middle.y), style);
                }
            }
            (_, Some((words, bad)), _) => say(words, if *bad { theme::bad() } else { theme::good() }),
            (_, None, Some(progress)) => say(&format!("Flown again: {:.0} %", 100.0 * progress), theme::accent()),
            (Some(_), None, None) => say("Enter takes it, Esc gives it up, ↑ ↓ step", theme::quiet()),
            (None, None, None) => say("Drag, turn the wheel, or click a number to type", theme::quiet()),
        }
    }
}

/// Apart from its neighbours' fields.
fn inner(cell: Area) -> Area {
    Area::new(cell.min.x, cell.min.y + APART, cell.size.x, cell.size.y - 2.0 * APART)
}

fn draw_field(field: &TextField, area: Area, canvas: &Canvas) {
    widgets::panel_in(canvas, area, theme::ground(), theme::accent());
    field.draw(canvas, area, (DETAILS, INSIDE), Some(0.0));
}
