//! Draws the instruments: what lies in the level, and the rail and the panels above it.

use super::{Instruments, Tool, centre_of_mass};
use crate::game::Game;
use crate::view::camera::Viewport;
use crate::view::canvas::{Canvas, Style};
use crate::view::layout::{DETAILS, GRID, Vec2};
use crate::view::{theme, widgets};

/// Radius of the mark of the centre of mass, canvas units.
const MARK: f32 = 9.0;

impl Instruments {
    /// Draws what lies in the level.
    pub fn draw_in_level(&self, game: &Game, view: &Viewport, canvas: &Canvas) {
        if self.uses(Tool::Centre) {
            draw_centre(view.point(centre_of_mass(game.world())), canvas);
        }
    }

    /// Draws what lies below the flight.
    pub fn draw_below(&self, canvas: &Canvas) {
        if self.uses(Tool::Plot) {
            self.plot.draw(canvas);
        }
    }

    /// Draws the rail and the panels.
    pub fn draw(&self, canvas: &Canvas) {
        if !self.open {
            return;
        }
        canvas.end_layer();
        for (i, (area, tool)) in self.rail.areas().iter().zip(Tool::ALL).enumerate() {
            widgets::button_box(canvas, *area, self.rail.hover() == Some(i), false);
            let colour = if self.uses(tool) { theme::accent() } else { theme::text() };
            let at = Vec2::new(area.min.x + GRID, area.centre().y);
            canvas.text(tool.name(), at, Style::new(DETAILS, colour).middle());
        }
    }
}

/// A disc in quarters, as it is marked in books.
fn draw_centre(at: Vec2, canvas: &Canvas) {
    canvas.disc(at, MARK + 2.0, theme::ground());
    canvas.disc(at, MARK, theme::text());
    let corner = |x: f32, y: f32| at + MARK * Vec2::new(x, y);
    for (x, y) in [(1.0, 1.0), (-1.0, -1.0)] {
        let arc = [0.0_f32, 22.5, 45.0, 67.5, 90.0].map(|angle| {
            let (sin, cos) = angle.to_radians().sin_cos();
            corner(x * cos, y * sin)
        });
        canvas.convex(&[&[at][..], &arc].concat(), theme::ground());
    }
}
