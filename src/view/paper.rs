//! Charts on paper, each on a sheet of SVG.

use super::{lanes, theme};
use crate::draw::chart::Sheet;
use crate::draw::layout::{Area, BUTTON_TEXT, Frame, GRID, Vec2};
use crate::draw::svg::svg;
use crate::draw::{Canvas, Colour, Style};

/// Size of a sheet and height of its title, px.
const PAPER: Vec2 = Vec2::new(1280.0, 640.0);
const HEAD: f32 = 56.0;

/// The curves of the instruments, on white.
pub fn curves(title: &str, shown: &Sheet) -> String {
    let mut canvas = drawn(title, 0.0, |canvas, panel| lanes::draw(canvas, panel, shown));
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
    let inset = Area::new(GRID, HEAD, PAPER.x - 2.0 * GRID, PAPER.y - HEAD - GRID - foot);
    draw(&canvas, inset);
    canvas
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Controls;
    use crate::instruments::curve::fixture::{curve, flown};
    use crate::instruments::export::{self, Exported};
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
        let picture = curves("Up <and> down", &export::sheet((0.0, 25.0), &exported));
        let words = ["Up &lt;and&gt; down", "Ship v_y", "y (m)", "v_y (m/s)", "|Normal force| (N)", "t (s)"];
        assert!(words.iter().all(|word| picture.contains(word)), "{words:?} in {picture}");
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
        assert!(picture.len() < 300_000, "{}", picture.len());
    }
}
