//! Everything that the browser keeps for the page, as a file of the player's and back.

use super::keeper::{self, PageStorage};
use super::{PageWord, download, say};
use crate::files::{self, Keeper, PageFiles};
use crate::pack;
use std::path::Path;

fn kept() -> &'static PageFiles<PageStorage> {
    keeper::storage().home()
}

/// Lets the player keep everything as one file; the answer says how that went.
pub fn export() -> String {
    match pack::export(kept()) {
        Ok(archive) => {
            download("resultant-data.zip", &archive);
            format!("resultant-data.zip: {} kB", archive.len().div_ceil(1000))
        }
        Err(problem) => problem,
    }
}

/// Whether a dropped file holds everything of some page.
pub fn is_export(path: &Path) -> bool {
    files::read(path, pack::LARGEST).is_ok_and(|bytes| pack::is_export(&bytes))
}

/// Takes a dropped file over, and lets the page begin again; or says why not.
pub fn import(path: &Path) {
    let imported = files::read(path, pack::LARGEST).map_err(|error| error.to_string());
    match imported.and_then(|bytes| pack::import(kept(), &bytes)) {
        Ok(words) => say(PageWord::Begin, &words),
        Err(problem) => say(PageWord::Notice, &format!("Not imported: {problem}")),
    }
}

/// Deletes everything, and lets the page begin again.
pub fn delete() {
    let storage = &kept().0;
    storage.keys().iter().for_each(|key| storage.remove(key));
    say(PageWord::Begin, "Everything of this page is deleted");
}
