//! Draws the overlay from its layout.

use super::{Details, LegendNote, PADDING, PlacedBox};
use crate::draw::layout::{Area, CORNER, DETAILS, MONO_ADVANCE, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::view::arrows::{self, Arrow};
use crate::view::names;
use crate::view::theme;

impl Details {
    pub fn draw(&self, canvas: &Canvas) {
        for place in &self.lit_places {
            canvas.rounded_edge(*place, 0.0, 3.0, theme::accent());
        }
        for placed in &self.boxes {
            let near = placed.object.clamp(placed.area.min, placed.area.max());
            canvas.line(near, placed.object, 1.5, theme::quiet().faded(0.6));
            canvas.disc(near, 3.0, theme::quiet());
        }
        let lit = |arrow: &Arrow| self.lit.contains(&(arrow.body, arrow.row));
        arrows::draw(&self.arranged.arrows, lit, canvas);
        for placed in &self.boxes {
            self.draw_box(placed, canvas);
        }
        arrows::draw_labels(&self.arranged.arrows, &self.labels, lit, canvas);
        self.names.iter().for_each(|(name, area)| names::draw(name, *area, canvas));
        draw_note(&self.legend, theme::quiet(), canvas);
        if let Some(tip) = &self.tip {
            canvas.end_layer();
            draw_note(tip, theme::text(), canvas);
        }
    }

    fn draw_box(&self, placed: &PlacedBox, canvas: &Canvas) {
        let PlacedBox { text, area, .. } = placed;
        panel(canvas, *area);
        canvas.text(&text.title, area.min + PADDING, Style::new(DETAILS, theme::accent()).mono());
        let numbers = Vec2::new(text.column() as f32 * MONO_ADVANCE * canvas.frame().text_height(DETAILS), 0.0);
        for (i, line) in text.lines.iter().enumerate() {
            let (bar, colour) = (placed.line(i), line.shown.map_or(theme::quiet(), arrows::colour));
            if self.lit.contains(&(text.body, line.row)) {
                let bar = Area { min: bar.min + Vec2::X * PADDING.x * 0.5, size: bar.size - Vec2::X * PADDING.x };
                canvas.rounded(bar, 3.0, colour.faded(0.3));
            }
            let at = bar.min + Vec2::X * PADDING.x;
            canvas.text(&line.label, at, Style::new(DETAILS, colour).mono());
            let colour = if line.nothing { theme::quiet() } else { theme::text() };
            canvas.text(&line.value, at + numbers, Style::new(DETAILS, colour).mono());
        }
    }
}

fn draw_note(note: &LegendNote, colour: Colour, canvas: &Canvas) {
    let Some(area) = note.area else { return };
    panel(canvas, area);
    for (i, line) in note.lines.iter().enumerate() {
        let at = area.min + PADDING + Vec2::new(0.0, i as f32 * canvas.line_height(DETAILS));
        canvas.text(line, at, Style::new(DETAILS, colour).mono());
    }
}

fn panel(canvas: &Canvas, area: Area) {
    canvas.rounded(area, CORNER, theme::panel().faded(0.97));
    canvas.rounded_edge(area, CORNER, 1.5, theme::panel_edge());
}
