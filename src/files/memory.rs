//! A storage of limited room in memory, for tests.

use super::{Keeper, KeepingFault};
use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

pub struct MemoryStorage {
    kept: Mutex<BTreeMap<String, Vec<u8>>>,
    /// Bytes.
    room: usize,
}

impl MemoryStorage {
    pub fn with_room(room: usize) -> Self {
        Self { kept: Mutex::default(), room }
    }

    fn kept(&self) -> MutexGuard<'_, BTreeMap<String, Vec<u8>>> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Keeper for MemoryStorage {
    fn get(&self, key: &str) -> Result<Option<Vec<u8>>, KeepingFault> {
        Ok(self.kept().get(key).cloned())
    }

    fn set(&self, key: &str, value: &[u8]) -> Result<(), KeepingFault> {
        let mut kept = self.kept();
        let others: usize = kept.iter().filter(|(other, _)| *other != key).map(|(_, value)| value.len()).sum();
        if others + value.len() > self.room {
            return Err(KeepingFault::Full);
        }
        kept.insert(key.to_owned(), value.to_vec());
        Ok(())
    }

    fn remove(&self, key: &str) {
        self.kept().remove(key);
    }

    fn keys(&self) -> Vec<String> {
        self.kept().keys().cloned().collect()
    }
}
