//! A level in small: a painting of its rooms, as its card shows it.

use super::{GameView, art, theme};
use crate::draw::layout::{Frame, Vec2};
use crate::draw::{Canvas, Image, Painting, raster};
use crate::game::Game;
use crate::level::Level;
use std::sync::{Arc, LazyLock};

/// Width and height of the painting, pixels.
const SIZE: [usize; 2] = [384, 216];

static SHEET: LazyLock<Painting> = LazyLock::new(|| Painting { width: art::SHEET, bytes: art::sheet() });

/// The level at its start, its rooms as large as they fit; `None` where it does not begin.
pub fn painting(level: &Arc<Level>) -> Option<Image> {
    let game = Game::new(level.clone()).ok()?;
    let canvas = Canvas::new(Frame::of_window(Vec2::new(2.0 * SIZE[0] as f32, 2.0 * SIZE[1] as f32)));
    GameView::new(&game, &|_| None).draw_rooms(&game, &canvas);
    Some(Image::Painted(Arc::new(art::halved(raster::paint(&canvas, 2 * SIZE[0], theme::ground(), &SHEET)))))
}
