//! The browser's storage of a page, and the files that the page holds only while it is open.

use super::{DROPPED, resultant_get, resultant_keys, resultant_remove, resultant_set, taken};
use crate::files::{AboveShipped, Keeper, KeepingFault, PageFiles};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

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
