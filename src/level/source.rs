//! The source of the loader's bytes.

use std::io;

/// The picture behind a level, in its folder.
pub const BACKGROUND: &str = "background.png";

/// A level's folder and its project, as the loader asks for their files.
pub trait Files {
    /// A file of the level folder, by name.
    /// Errors: [`io::ErrorKind::NotFound`] where there is none; any other where it cannot be read.
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>>;

    /// A file of the project, by its path from the project's folder with forward slashes.
    fn project_file(&self, path: &str) -> io::Result<Vec<u8>>;

    /// The names of all files of the level folder, where they can be listed.
    fn names(&self) -> Vec<String> {
        Vec::new()
    }

    /// The names of all files in its folder `flights`, where they can be listed.
    fn flights(&self) -> Vec<String> {
        Vec::new()
    }
}
