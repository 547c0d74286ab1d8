//! A new file in a folder, whole or not at all, that never takes the place of another one.

use crate::files::{self, read_text};
use crate::words::tr;
use std::io;
use std::path::{Path, PathBuf};

/// Hands a file of the player's to the browser's downloads; elsewhere it lies where the player finds it.
#[cfg(all(feature = "window", browser))]
pub fn hand_out(path: &Path) {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if let Ok(bytes) = files::read(path, files::SCORES) {
        crate::web::download(&name, &bytes);
    }
}

#[cfg(not(all(feature = "window", browser)))]
pub const fn hand_out(_: &Path) {}

/// The most files of one name.
const MOST_OF_A_NAME: u32 = 10_000;

/// A file that is to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewFile {
    /// Its name up to a number, which it gets where there is one already.
    pub stem: String,
    /// Its name from there on, with the full stop.
    pub ending: &'static str,
    /// All of it.
    pub text: String,
    /// What it is, for messages: "the flight".
    pub what: &'static str,
    /// One with these very bytes will do, where it is no larger than that.
    pub same_up_to: u64,
}

impl NewFile {
    /// Writes it into a folder, which is made where there is none; the answer is where.
    ///
    /// # Errors
    /// Whatever the system refuses, with the place. Nothing is left behind then.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, String> {
        if let Some(path) = self.handed_out(folder) {
            return Ok(path);
        }
        let refused = |path: &Path, error: &io::Error| {
            tr!("{path}: cannot keep {what}: {error}", path = path.display(), what = self.what, error)
        };
        files::make_folder(folder).map_err(|error| refused(folder, &error))?;
        for number in 1..=MOST_OF_A_NAME {
            let count = if number > 1 { format!("-{number}") } else { String::new() };
            let path = folder.join(format!("{}{count}{}", self.stem, self.ending));
            if read_text(&path, self.same_up_to).is_ok_and(|kept| kept == self.text) {
                return Ok(path);
            }
            match files::create(&path, self.text.as_bytes()) {
                Ok(()) => return Ok(path),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(refused(&path, &error)),
            }
        }
        Err(tr!("{path}: there are too many files of that name", path = folder.display()))
    }

    /// A page has no folder that the player could open: the browser puts the file among the downloads.
    #[cfg(all(feature = "window", browser))]
    fn handed_out(&self, folder: &Path) -> Option<PathBuf> {
        let name = format!("{}{}", self.stem, self.ending);
        crate::web::download(&name, self.text.as_bytes());
        Some(folder.join(name))
    }

    #[cfg(not(all(feature = "window", browser)))]
    const fn handed_out(&self, _: &Path) -> Option<PathBuf> {
        None
    }
}
