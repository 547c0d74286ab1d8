//! A level as it is edited: an operation leaves all other bytes alone, everything can be undone, and nothing is lost.

mod bytes;
mod disk;

use resultant::files::EXPERIMENTS;
use resultant::level;
use resultant::level::document::{Document, Table};
use std::path::{Path, PathBuf};

/// The folders of all levels that come with the game, and of the loader's fixtures.
fn folders() -> Vec<PathBuf> {
    let below = |folder: &str| {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        level::list(&folder).into_iter().map(move |name| folder.join(name))
    };
    let all: Vec<PathBuf> = ["levels", EXPERIMENTS, "tests/fixtures/levels"].into_iter().flat_map(below).collect();
    assert!(all.len() > 15, "{all:?}");
    all
}

fn all_bytes(document: &Document) -> Vec<Option<Vec<u8>>> {
    Table::ALL.iter().map(|table| document.bytes(*table).map(<[u8]>::to_vec)).collect()
}
