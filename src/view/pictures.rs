//! The pictures of a level: its background and its objects' sprites, from bytes.
//!
//! A level in small: a painting of its rooms, as its card shows it.

use super::{GameView, art, theme};
use crate::draw::layout::{Frame, Vec2};
use crate::draw::{Canvas, Image, Painting, raster};
use crate::game::Game;
use crate::level::Level;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

/// By path.
#[derive(Default)]
pub struct Pictures(BTreeMap<PathBuf, Image>);

impl Pictures {
    /// Asks `read` for the bytes of each picture that the level names. A picture that cannot be read is left out: the loader has
    /// checked all of them, and a file that vanished since is no reason to stop the game.
    pub fn new(level: &Level, read: &dyn Fn(&Path) -> Option<Vec<u8>>) -> Self {
        let paths = level.pictures().chain(&level.background);
        Self(paths.filter_map(|path| Some((path.clone(), Image::File(read(path)?.into())))).collect())
    }

    pub fn get(&self, path: &Path) -> Option<&Image> {
        self.0.get(path)
    }
}

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
