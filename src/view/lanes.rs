//! Lanes: curves above one axis to the right, each lane with its own numbers upwards. Charts on paper, each on a sheet of SVG.

use super::{theme, widgets};
use crate::draw::chart::{Sheet, WORDS, dashed, marker, stroke};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, Frame, GRID, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::{draw::svg::svg, words::tr};

/// About how many values to the right have numbers.
const NAMED: usize = 8;
/// From the panel's edges to the lanes: left, top, bottom.
const LEFT: f32 = 88.0;
const TOP: f32 = 40.0;
const BOTTOM: f32 = 60.0;
const LEGEND: f32 = 340.0;
/// Between two lanes: the values to the right above, the name of the lane below.
const BETWEEN: f32 = 60.0;
/// Dashes of a line at a value, canvas units drawn and left out.
const MARK_DASH: (u32, u32) = (2, 5);

pub struct LaneAxes<'a> {
    /// Between the axes.
    pub area: Area,
    /// The upward quantity, with its unit.
    pub name: &'a str,
    /// Values upwards, each with its part of the height.
    pub named: &'a [(f64, String)],
}

impl LaneAxes<'_> {
    /// A line all across at a part of the height.
    pub fn level(&self, up: f64) -> [Vec2; 2] {
        [self.area.part((0.0, up)), self.area.part((1.0, up))]
    }

    /// `across` are the values to the right, each with its part of the width.
    pub fn draw(&self, canvas: &Canvas, across: &[(f64, String)]) {
        let quiet = Style::new(DETAILS, theme::quiet()).middle();
        canvas.rounded(self.area, 0.0, theme::ground());
        for (part, name) in self.named {
            let [from, to] = self.level(*part);
            canvas.hairline(from, to, theme::panel_edge());
            canvas.text(name, from - Vec2::new(10.0, 0.0), quiet.right());
        }
        for (part, name) in across {
            let foot = self.area.part((*part, 0.0));
            canvas.hairline(foot, Vec2::new(foot.x, self.area.min.y), theme::panel_edge());
            canvas.text(name, foot + Vec2::new(0.0, 14.0), quiet.centred());
        }
        canvas.text(tr(self.name), self.area.min - Vec2::new(0.0, 18.0), Style::new(TEXT, theme::text()).middle());
    }
}

/// A sheet of lanes with its legend on a panel.
pub fn draw(canvas: &Canvas, panel: Area, sheet: &Sheet) {
    widgets::panel(canvas, panel);
    let across: Vec<_> = sheet.across.named(NAMED).into_iter().map(|(value, name)| (sheet.across.part(value), name)).collect();
    let width = panel.size.x - LEFT - LEGEND - LEFT / 2.0;
    let room = Area::new(panel.min.x + LEFT, panel.min.y + TOP, width, panel.size.y - TOP - BOTTOM);
    let pitch = (room.size.y + BETWEEN) / sheet.strips.len().max(1) as f32;
    for (strip, top) in sheet.strips.iter().zip((0..).map(|i| room.min.y + i as f32 * pitch)) {
        let axes =
            LaneAxes { area: Area::new(room.min.x, top, room.size.x, pitch - BETWEEN), name: &strip.name, named: &strip.named };
        axes.draw(canvas, &across);
        for mark in &strip.marks {
            let x = sheet.across.part(*mark);
            dashed(canvas, &[axes.area.part((x, 0.0)), axes.area.part((x, 1.0))], MARK_DASH, 1.0, theme::quiet());
        }
        for part in &strip.curves {
            let line: Vec<Vec2> = part.points.iter().map(|(x, up)| axes.area.part((sheet.across.part(*x), *up))).collect();
            let colour = Colour::hex(part.look.colour);
            stroke(canvas, &line, &part.look, colour);
            if let Some(at) = part.marker.and_then(|place| line.get(place)) {
                marker(canvas, *at, part.look.marker, colour);
            }
        }
    }
    let words = Style::new(TEXT, theme::text()).middle();
    canvas.text(tr(&sheet.across_name), Vec2::new(room.centre().x, panel.max().y - 20.0), words.centred());
    let mut at = Vec2::new(panel.max().x - LEGEND, panel.min.y + TOP);
    for (name, look) in &sheet.legend {
        stroke(canvas, &[at, at + Vec2::new(WORDS - 12.0, 0.0)], look, Colour::hex(look.colour));
        canvas.text(&widgets::cut(canvas, tr(name), LEGEND - WORDS, words), at + Vec2::new(WORDS, 0.0), words);
        at.y += canvas.line_height(TEXT);
    }
    for note in &sheet.notes {
        canvas.text(tr(note), at, Style::new(DETAILS, theme::quiet()).middle());
        at.y += canvas.line_height(DETAILS);
    }
}

/// Size of a sheet and height of its title, px.
const PAPER: Vec2 = Vec2::new(1280.0, 640.0);
const HEAD: f32 = 56.0;

/// The curves of the instruments, on white.
pub fn curves(title: &str, shown: &Sheet) -> String {
    let mut canvas = drawn(title, 0.0, |canvas, panel| draw(canvas, panel, shown));
    canvas.put_on_white();
    svg(&canvas, Colour::WHITE)
}

/// A title, and a drawing on the panel below it, `foot` above the lower edge.
pub fn sheet(title: &str, foot: f32, draw: impl FnOnce(&Canvas, Area)) -> String {
    svg(&drawn(title, foot, draw), theme::ground())
}

fn drawn(title: &str, foot: f32, draw: impl FnOnce(&Canvas, Area)) -> Canvas {
    let canvas = Canvas::new(Frame { size: PAPER, ..Frame::default() });
    canvas.text(title, Vec2::new(2.0 * GRID, HEAD / 2.0), Style::new(BUTTON_TEXT, theme::text()).middle());
    draw(&canvas, Area::new(GRID, HEAD, PAPER.x - 2.0 * GRID, PAPER.y - HEAD - GRID - foot));
    canvas
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Controls;
    use crate::instruments::chart::{self, Exported};
    use crate::instruments::curve::fixture::{curve, flown};
    use crate::instruments::quantity::{Quantity, VectorPart};
    use crate::physics::ForceKind;

    #[test]
    fn a_picture_of_curves_names_its_axes_and_has_bounded_size() {
        let track = flown(3000, |tick| Controls { thrust: tick < 60, right: tick % 7 == 0, ..Controls::default() });
        let shown = [Quantity::Y, Quantity::Velocity(VectorPart::Y), Quantity::Force(ForceKind::Reaction, VectorPart::Size)]
            .map(|up| curve(&track, Quantity::Time, up));
        let exported: Vec<Exported> = shown
            .iter()
            .enumerate()
            .map(|(number, curve)| Exported { body: "Ship", curve, track: &track, number, fit: None })
            .collect();
        let picture = curves("Up <and> down", &chart::sheet((0.0, 25.0), &exported));
        let words = ["Up &lt;and&gt; down", "Ship v_y", "y (m)", "v_y (m/s)", "|Normal force| (N)", "t (s)"];
        assert!(words.iter().all(|word| picture.contains(word)), "{words:?} in {picture}");
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
        assert!(picture.len() < 300_000, "{}", picture.len());
    }
}
