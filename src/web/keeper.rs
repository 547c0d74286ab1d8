//! The browser's storage of a page, the files that the page holds while it is open, and all that is kept as one file of the player's and back.

use super::{DROPPED, PageWord, download, resultant_get, resultant_keys, resultant_remove, resultant_set, say, taken};
use crate::files::{self, AboveShipped, Keeper, KeepingFault, PageFiles};
use crate::pack;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::{collections::BTreeMap, path::Path};

static STORAGE: LazyLock<AboveShipped<PageFiles<PageStorage>>> =
    LazyLock::new(|| AboveShipped::new(PageFiles(PageStorage), Path::new("")));
static HELD: Mutex<BTreeMap<String, Vec<u8>>> = Mutex::new(BTreeMap::new());

/// The script's answers where there is no value.
const NONE: i32 = -1;
const FULL: i32 = -2;
const DAMAGED: i32 = -4;

#[derive(Debug)]
pub struct PageStorage;

pub fn storage() -> &'static AboveShipped<PageFiles<PageStorage>> {
    &STORAGE
}

fn held() -> MutexGuard<'static, BTreeMap<String, Vec<u8>>> {
    HELD.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Holds a dropped file until the page is closed; the one before goes.
pub(super) fn hold(key: String, bytes: Vec<u8>) {
    let mut held = held();
    held.clear();
    held.insert(key, bytes);
}

fn is_held(key: &str) -> bool {
    key.strip_prefix(DROPPED).is_some_and(|rest| rest.starts_with('/'))
}

fn fault(answer: i32) -> KeepingFault {
    match answer {
        FULL => KeepingFault::Full,
        DAMAGED => KeepingFault::Damaged,
        _ => KeepingFault::Forbidden,
    }
}

impl Keeper for PageStorage {
    fn get(&self, key: &str) -> Result<Option<Vec<u8>>, KeepingFault> {
        if is_held(key) {
            return Ok(held().get(key).cloned());
        }
        // SAFETY: pointer and length are of one string.
        match unsafe { resultant_get(key.as_ptr(), key.len()) } {
            NONE => Ok(None),
            length if length >= 0 => Ok(Some(taken(length))),
            other => Err(fault(other)),
        }
    }

    fn set(&self, key: &str, value: &[u8]) -> Result<(), KeepingFault> {
        // SAFETY: pointers and lengths are of one string and one slice.
        match unsafe { resultant_set(key.as_ptr(), key.len(), value.as_ptr(), value.len()) } {
            0 => Ok(()),
            other => Err(fault(other)),
        }
    }

    fn remove(&self, key: &str) {
        // SAFETY: pointer and length are of one string.
        unsafe { resultant_remove(key.as_ptr(), key.len()) }
    }

    fn keys(&self) -> Vec<String> {
        // SAFETY: it takes nothing.
        let list = String::from_utf8(taken(unsafe { resultant_keys() })).unwrap_or_default();
        let kept = list.split('\0').filter(|key| !key.is_empty()).map(str::to_owned);
        kept.chain(held().keys().cloned()).collect()
    }
}

fn kept() -> &'static PageFiles<PageStorage> {
    storage().home()
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
