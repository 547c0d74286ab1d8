//! A level as it is edited: an operation leaves all other bytes alone, everything can be undone, and nothing is lost.

mod bytes;
mod disk;

use resultant::level::document::{Document, Table};
use std::path::{Path, PathBuf};

/// The folders of all levels that come with the game, and of the loader's fixtures.
fn folders() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let below = |folder: &str| {
        let entries = std::fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap().path());
        entries.filter(|path| path.is_dir()).collect::<Vec<_>>()
    };
    let mut all = below("levels");
    all.extend(below("tests/fixtures/levels"));
    assert!(all.len() > 15, "{all:?}");
    all
}

fn all_bytes(document: &Document) -> Vec<Option<Vec<u8>>> {
    Table::ALL.iter().map(|table| document.bytes(*table).map(<[u8]>::to_vec)).collect()
}
