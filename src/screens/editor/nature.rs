//! The marks of what a block is: its material, a belt, a trampoline, a block that breaks, a side that lets through. And colours to choose.

use super::{Editor, EditorPass, layout::BETWEEN, layout::INSIDE, picture::edge, picture::material};
use crate::{draw::Canvas, draw::Colour, level::Landscape, view::sky::WorldPalette, view::theme};
use crate::{draw::layout::Area, draw::layout::Vec2, level::document::RowId, level::document::SetCell, ui::Ui, ui::WidgetKind};

/// The steps of marks along a block, canvas units, and the most of them.
const STEP: f32 = 18.0;
const MOST_MARKS: f32 = 60.0;

/// Told apart with any kind of sight: bright and dark, warm and cold.
const SWATCHES: [u32; 10] = [0xF0AA28, 0xE6503C, 0xD65DB1, 0x8C6EE6, 0x5096F0, 0x46C8DC, 0x4CC38A, 0xC8DC5A, 0xEBEBEB, 0x3C4048];

impl Editor {
    pub(super) fn draw_nature(&self, canvas: &Canvas, row: RowId, area: Area) {
        let cell = |column: &str| self.document.cell(row, column).unwrap_or_default();
        let count = (area.size.x / STEP).clamp(1.0, MOST_MARKS) as usize;
        let step = area.size.x / count as f32;
        let middle = |i: usize| Vec2::new(area.min.x + (i as f32 + 0.5) * step, area.min.y);
        let belt = self.document.number(row, "belt").unwrap_or(0.0);
        if belt != 0.0 {
            // Its upper side runs to the right where the belt is above 0.
            let (along, high) = (Vec2::new(5.0 * belt.signum() as f32, 0.0), Vec2::new(0.0, 5.0_f32.min(area.size.y / 2.0)));
            for tip in (0..count).map(|i| middle(i) + high + along / 2.0) {
                canvas.line(tip - along - high, tip, 2.0, theme::accent());
                canvas.line(tip - along + high, tip, 2.0, theme::accent());
            }
        }
        if cell("material").eq_ignore_ascii_case("trampoline") {
            let deep = Vec2::new(0.0, 6.0_f32.min(area.size.y));
            let side = Vec2::new(step / 2.0, 0.0);
            for top in (0..count).map(middle) {
                canvas.line(top - side, top + deep, 1.5, theme::physics_objective());
                canvas.line(top + deep, top + side, 1.5, theme::physics_objective());
            }
        }
        if !cell("breaks").is_empty() {
            let at = |x: f32, y: f32| area.min + Vec2::new(x, y) * area.size;
            [[at(0.2, 0.0), at(0.3, 1.0)], [at(0.25, 0.5), at(0.8, 0.0)], [at(0.6, 0.2), at(0.9, 1.0)]]
                .into_iter()
                .for_each(|[from, to]| canvas.line(from, to, 1.5, theme::ground()));
            canvas.dashed(&[at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0), at(0.0, 0.0)], &[6.0, 4.0], 1.5, theme::bad());
        }
        let (a, b) = (area.min, area.max());
        let (from, to) = match cell("one_way").to_ascii_lowercase().as_str() {
            "top" => (a, Vec2::new(b.x, a.y)),
            "bottom" => (Vec2::new(a.x, b.y), b),
            "left" => (a, Vec2::new(a.x, b.y)),
            "right" => (Vec2::new(b.x, a.y), b),
            _ => return,
        };
        canvas.line(from, to, 3.0, theme::accent());
    }

    fn has_colour(&self) -> bool {
        ["r", "g", "b"].iter().all(|name| self.panel.fields.iter().any(|field| field.column.name == *name))
    }

    /// How many fields' room the panel needs: the colours to choose take one.
    pub(super) fn fields(&self) -> usize {
        self.panel.fields.len() + usize::from(self.has_colour())
    }

    /// The colours below the fields: a click writes one into the cells.
    pub(super) fn show_swatches(&mut self, ui: &mut Ui<'_>, pass: &mut EditorPass) {
        if !self.has_colour() {
            return;
        }
        let row = self.panes.field(self.panel.fields.len());
        let left = self.panes.right.min.x + INSIDE;
        let width = (row.max().x - left + BETWEEN) / SWATCHES.len() as f32;
        let mut taken = None;
        for (index, hex) in SWATCHES.into_iter().enumerate() {
            let [_, r, g, b] = hex.to_be_bytes();
            let area = Area::new(left + index as f32 * width, row.min.y, width - BETWEEN, row.size.y);
            let touch = ui.touch(&format!("#{r:02X}{g:02X}{b:02X}"), area, WidgetKind::Tool);
            ui.canvas().rectangle(area, Colour::of([r, g, b]));
            let own = |row: &RowId| self.given_colour(*row) == Some(Colour::of([r, g, b]));
            if touch.hover || self.selection.iter().all(own) {
                edge(ui.canvas(), area.inset(-2.0), 2.0, theme::accent());
            }
            taken = taken.or(touch.pressed.then_some([r, g, b]));
        }
        if let Some(colour) = taken.filter(|_| pass.open) {
            pass.close(None);
            self.gesture += 1;
            self.panel.typing = None;
            let cells = |row: &RowId| {
                let cell = |(column, channel): (&'static str, u8)| SetCell { row: *row, column, text: channel.to_string() };
                ["r", "g", "b"].into_iter().zip(colour).map(cell).collect::<Vec<_>>()
            };
            self.set(&self.selection.iter().flat_map(cells).collect::<Vec<_>>());
        }
    }
}

/// The worlds in small at the right of a setting's field; the one that is pressed, by its word.
pub(super) fn show_worlds(
    ui: &mut Ui<'_>,
    pass: &mut EditorPass,
    (field, now): (Area, &str),
    words: &[&'static str],
) -> Option<&'static str> {
    let size = Vec2::new(0.65, 1.0) * (field.size.y - 2.0 * BETWEEN);
    let (pitch, mut pressed) = (size.x + 2.0, None);
    let left = field.max().x - BETWEEN - Landscape::ALL.len() as f32 * pitch;
    let worlds = words.iter().filter(|word| !word.is_empty()).zip(Landscape::ALL);
    for (index, (word, landscape)) in worlds.enumerate() {
        let area = Area { min: Vec2::new(left + index as f32 * pitch, field.min.y + BETWEEN), size };
        let touch = ui.touch(word, area, WidgetKind::Tool);
        let palette = WorldPalette::of(landscape);
        let hill = Area { min: area.min + size * Vec2::new(0.0, 0.5), size: size * Vec2::new(1.0, 0.5) };
        ui.canvas().rectangle(area, palette.layers[0]);
        ui.canvas().rectangle(hill, palette.rock[0]);
        ui.canvas().line(hill.min, Vec2::new(hill.max().x, hill.min.y), 2.0, palette.ink);
        if touch.hover {
            pass.tip = Some((*word).to_owned());
        }
        if touch.hover || now.eq_ignore_ascii_case(word) {
            edge(ui.canvas(), area.inset(-1.5), 1.5, theme::accent());
        }
        pressed = pressed.or(touch.pressed.then_some(*word));
    }
    pressed
}

pub(super) fn draw_material(canvas: &Canvas, field: Area, name: &str) {
    let side = field.size.y - 2.0 * BETWEEN;
    let area = Area::new(field.max().x - side - BETWEEN, field.min.y + BETWEEN, side, side);
    canvas.rectangle(area, material(name));
    edge(canvas, area, 1.0, theme::solid_top());
}
