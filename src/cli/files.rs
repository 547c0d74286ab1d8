//! Text files that a subcommand is told to read, and files that it is told to write.

use super::Stop;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// The text of a file.
///
/// # Errors
/// It cannot be read, or is no UTF-8.
pub fn read_text(path: &Path) -> Result<String, Stop> {
    let bytes = std::fs::read(path).map_err(|error| refused(path, &error))?;
    String::from_utf8(bytes).map_err(|error| {
        let good = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + good.iter().filter(|&&byte| byte == b'\n').count();
        Stop::Refused(format!("{}:{line}: found letters that are not UTF-8, expected a file saved as UTF-8", path.display()))
    })
}

/// A file to be written that appears whole or not at all: until it is finished, an older one stays as it is. What is no ordinary
/// file (a pipe, /dev/stdout) is written to as it is.
pub struct NewFile {
    path: PathBuf,
    writer: BufWriter<Place>,
}

enum Place {
    Beside(tempfile::NamedTempFile, PathBuf),
    Itself(File),
}

impl NewFile {
    /// Begins the file.
    ///
    /// # Errors
    /// Nothing can be written there; nothing has been written then.
    pub fn create(path: &Path) -> Result<Self, Stop> {
        let place = Place::find(path).map_err(|error| refused(path, &error))?;
        Ok(Self { path: path.to_path_buf(), writer: BufWriter::new(place) })
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// The disk is full or gone.
    pub fn finish(self) -> Result<(), Stop> {
        let finished = self.writer.into_inner().map_err(io::IntoInnerError::into_error).and_then(|place| match place {
            Place::Beside(file, target) => file.persist(target).map(drop).map_err(|error| error.error),
            Place::Itself(_) => Ok(()),
        });
        finished.map_err(|error| Stop::Output(io::Error::new(error.kind(), format!("{}: {error}", self.path.display()))))
    }
}

impl Place {
    fn find(path: &Path) -> io::Result<Self> {
        // The file behind a link is what is meant.
        let target = path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
        if target.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        if target.exists() && !target.is_file() {
            return Ok(Self::Itself(File::create(target)?));
        }
        let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut builder = tempfile::Builder::new();
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // As for any new file; tempfile's own would be for the user's eyes only.
            builder.permissions(std::fs::Permissions::from_mode(0o666));
        }
        // The kind alone: the user knows nothing of the temporary file's name.
        let file = builder.tempfile_in(folder).map_err(|error| io::Error::from(error.kind()))?;
        Ok(Self::Beside(file, target))
    }
}

impl Write for Place {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Beside(file, _) => file.write(bytes),
            Self::Itself(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Beside(file, _) => file.flush(),
            Self::Itself(file) => file.flush(),
        }
    }
}

impl Write for NewFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
    }
}

fn refused(path: &Path, error: &io::Error) -> Stop {
    Stop::Refused(format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_appears_whole_when_it_is_finished() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.csv");
        std::fs::write(&path, "old").unwrap();

        let mut dropped = NewFile::create(&path).unwrap();
        dropped.write_all(b"half").unwrap();
        dropped.flush().unwrap();
        drop(dropped);
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "old");

        let mut file = NewFile::create(&path).unwrap();
        file.write_all(b"new").unwrap();
        file.finish().unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "new");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left beside it");
    }

    #[test]
    fn where_nothing_can_be_written_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        for path in [folder.path().to_path_buf(), folder.path().join("missing/out.csv")] {
            assert!(matches!(NewFile::create(&path), Err(Stop::Refused(_))), "{}", path.display());
        }
    }

    #[test]
    fn text_that_is_none_is_refused_with_its_line() {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), b"a\nb\n\xff\n").unwrap();
        let Err(Stop::Refused(problem)) = read_text(file.path()) else { panic!("read") };
        assert!(problem.contains(":3: found letters that are not UTF-8"), "{problem}");
    }
}
