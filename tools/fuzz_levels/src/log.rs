//! What came of each level, a line of JSON each: kept from call to call.

use crate::play::Played;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

/// A log that is written to.
pub struct Log {
    file: File,
    held: BTreeSet<u64>,
}

impl Log {
    /// Opens the log, or begins it.
    ///
    /// # Errors
    /// It cannot be read or written.
    pub fn open(path: &Path) -> Result<Self, String> {
        let held = if path.exists() { read(&[path.to_owned()])?.into_keys().collect() } else { BTreeSet::new() };
        let file = OpenOptions::new().create(true).append(true).open(path);
        let mut file = file.map_err(|error| format!("{}: {error}", path.display()))?;
        // What was cut off in the middle of a line stays a line of its own.
        writeln!(file).map_err(|error| error.to_string())?;
        Ok(Self { file, held })
    }

    /// Whether that level was played before.
    pub fn holds(&self, seed: u64) -> bool {
        self.held.contains(&seed)
    }

    /// # Errors
    /// The line cannot be written.
    pub fn add(&mut self, level: &Played) -> Result<(), String> {
        let mut line = serde_json::to_vec(level).map_err(|error| error.to_string())?;
        line.push(b'\n');
        self.file.write_all(&line).map_err(|error| error.to_string())
    }
}

/// All levels of these logs by their seeds. Lines that were cut off are passed over.
///
/// # Errors
/// A log cannot be read.
pub fn read(paths: &[PathBuf]) -> Result<BTreeMap<u64, Played>, String> {
    let mut levels = BTreeMap::new();
    for path in paths {
        let told = |error: std::io::Error| format!("{}: {error}", path.display());
        for line in BufReader::new(File::open(path).map_err(told)?).lines() {
            if let Ok(level) = serde_json::from_str::<Played>(&line.map_err(told)?) {
                levels.insert(level.seed, level);
            }
        }
    }
    Ok(levels)
}
