//! Draws the overlay from its layout.
//! The legend: the scale of the arrows, the meaning of the marks, the boxes and arrows left out, and on demand the parts of the model.

use super::{Details, Looking, PADDING, PlacedBox};
use crate::draw::layout::{Area, CORNER, DETAILS, Frame, LINE, MONO_ADVANCE, Vec2, wrapped};
use crate::draw::{Canvas, Colour, Style};
use crate::view::boxes::{self, BoxWish};
use crate::view::scale::{self, Arrow, ArrowScale};
use crate::view::{theme, world};
use crate::{game::Game, number::scalar, words::tr};

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
        scale::draw(&self.arranged.arrows, lit, canvas);
        for placed in &self.boxes {
            self.draw_box(placed, canvas);
        }
        scale::draw_labels(&self.arranged.arrows, &self.labels, lit, canvas);
        self.names.iter().for_each(|(name, area)| world::draw_name(name, *area, canvas));
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
            let (bar, colour) = (placed.line(i), line.shown.map_or(theme::quiet(), scale::colour));
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

/// The longest line of the legend, characters: longer ones are wrapped and leave room for the boxes.
const LEGEND_WIDTH: usize = 46;
/// Further lines of a note stand below the first one's words, behind the dot.
const LEGEND_INDENT: usize = 2;

#[derive(Clone, Debug, Default)]
pub struct LegendNote {
    pub lines: Vec<String>,
    /// `None` without room.
    pub area: Option<Area>,
}

impl LegendNote {
    pub(super) fn size(lines: &[String], frame: &Frame) -> Vec2 {
        let text = frame.text_height(DETAILS);
        let longest = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0);
        Vec2::new(longest as f32 * MONO_ADVANCE * text, lines.len() as f32 * text * LINE) + 2.0 * PADDING
    }
}

impl Details {
    /// As near to the top right as there is room.
    pub(super) fn place_legend(
        &mut self,
        game: &Game,
        (scale, looking): (&ArrowScale, &Looking),
        frame: &Frame,
        (taken, kept_clear): (&[Area], &[Area]),
    ) {
        let pointed = looking.pointer.zip(self.legend.area).is_some_and(|(pointer, area)| area.contains(pointer));
        let lines = self.legend_lines(game, scale, looking.model || pointed);
        let (size, corner) = (LegendNote::size(&lines, frame), Vec2::new(frame.size.x, 0.0));
        let stays = self.legend.area.filter(|area| area.size == size).map(|area| area.min - corner);
        let wish = BoxWish { object: Area { min: corner, size: Vec2::ZERO }, size, before: stays };
        self.legend = LegendNote { lines, area: boxes::place(&[wish], frame.area(), taken, kept_clear)[0] };
    }

    fn legend_lines(&self, game: &Game, scale: &ArrowScale, model: bool) -> Vec<String> {
        let has = |impact: bool| self.arranged.arrows.iter().any(|arrow| impact == arrow.shown.is_impact());
        let mut lines = Vec::new();
        if has(false) {
            lines.push(tr!("Arrows: 1 square = {force}", force = scalar(scale.newtons, "N")));
        }
        if has(true) {
            lines.push(tr!("Impulses: 1 square = {impulse}", impulse = scalar(scale.newton_seconds, "N·s")));
        }
        if self.arranged.arrows.iter().any(|arrow| !arrow.to_scale) {
            lines.push(tr("Marked //: not to scale").to_owned());
        }
        // The boxes are those of the frame before: their places depend on the legend's.
        let left_out = [
            (self.left_out, ["1 more object without a box", "{count} more objects without a box"]),
            (self.arranged.left_out, ["1 more arrow without room", "{count} more arrows without room"]),
        ];
        for (count, [one, more]) in left_out.into_iter().filter(|(count, _)| *count > 0) {
            lines.push(if count == 1 { tr(one).to_owned() } else { tr!(more, count) });
        }
        if model {
            lines.push(tr("Model at work:").to_owned());
            let parts = game.world().plan().parts().into_iter();
            lines.extend(parts.flat_map(|part| wrapped(&format!("· {}", tr(part)), LEGEND_WIDTH, LEGEND_INDENT)));
        } else {
            lines.push(tr("Point here: the model").to_owned());
        }
        lines
    }
}
