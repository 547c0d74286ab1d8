//! The pictures that a level brings along: its background and its objects' sprites. Their bytes are handed in.

use crate::level::Level;
use macroquad::texture::{FilterMode, Image, Texture2D};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The textures of a level's pictures, by path.
#[derive(Default)]
pub struct Pictures {
    textures: BTreeMap<PathBuf, Texture2D>,
}

impl Pictures {
    /// Asks `read` for the bytes of each picture that the level names. What cannot be had or is no picture is left out: the loader has
    /// checked them all, and a file that vanished since is no reason to stop the game.
    pub fn new(level: &Level, read: &dyn Fn(&Path) -> Option<Vec<u8>>) -> Self {
        let mut textures = BTreeMap::new();
        for path in level.pictures().chain(&level.background) {
            if !textures.contains_key(path)
                && let Some(image) = read(path).and_then(|bytes| Image::from_file_with_format(&bytes, None).ok())
            {
                let texture = Texture2D::from_image(&image);
                texture.set_filter(FilterMode::Linear);
                textures.insert(path.clone(), texture);
            }
        }
        Self { textures }
    }

    /// The texture of a picture.
    pub fn get(&self, path: &Path) -> Option<&Texture2D> {
        self.textures.get(path)
    }
}
