use super::measured::{label, pair};
use super::{Instruments, Tool};
use crate::draw::layout::{DETAILS, GRID, Vec2};
use crate::draw::{Canvas, Style};
use crate::game::{Game, SHIP};
use crate::instruments::ledger::{centre_of_mass, velocity_of_centre};
use crate::view::camera::Viewport;
use crate::view::theme;
use crate::words::tr;

/// Canvas units.
const MARK: f32 = 9.0;

impl Instruments {
    /// Draws the readings in the level, where that is `seen`, and the ground of the panels above it.
    pub fn draw_in_level(&self, (game, alpha): (&Game, f64), seen: bool, (view, canvas): (&Viewport, &Canvas)) {
        if seen {
            self.measures.draw_in_level((game, alpha), (view, canvas));
        }
        if seen && self.uses(Tool::Centre) {
            draw_centre((game, alpha), view, canvas);
        }
        if seen && self.uses(Tool::Vary) {
            self.vary.draw_places(game.level(), (view, canvas));
        }
        if self.open {
            canvas.end_layer();
            self.measures.draw_grounds((game, alpha), (view, canvas));
        }
    }
}

/// A disc in quarters, as in books, with its speed.
fn draw_centre((game, alpha): (&Game, f64), view: &Viewport, canvas: &Canvas) {
    // An idle ship does not belong to the system.
    let bodies = &game.world().bodies()[game.lead().index()..];
    let (centre, velocity) = (centre_of_mass(bodies), velocity_of_centre(bodies));
    // Between the last two ticks, as everything on the screen.
    let at = view.point(centre - velocity * ((1.0 - alpha) / game.tick_rate()));
    if !canvas.frame().area().contains(at) {
        return;
    }
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
    let lines = [tr("Centre of mass").to_owned(), format!("v {}", pair(velocity, "m/s"))];
    // Above or below, away from the ship, which is often near.
    let ship = view.point(game.world().body(SHIP).position);
    let up = if ship.y < at.y { 1.0 } else { -1.0 };
    let aside = Vec2::new(
        if ship.x < at.x { MARK } else { -MARK - canvas.width(&lines[1], Style::new(DETAILS, theme::text()).mono()) },
        up * 4.0 * GRID,
    );
    label(&lines, at + aside, theme::text(), canvas);
}
