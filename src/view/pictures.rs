//! The pictures of a level: its background and its objects' sprites, from bytes.

use crate::draw::Image;
use crate::level::Level;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

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
