//! Text files that a subcommand is told to read, and files that it is told to write.
//!
//! New content is collected in a file without a name, so that a program that is stopped leaves nothing behind. When all of it is there,
//! it is staged beside its target, written to the disk, and takes the target's place in one step: a target is the old file or the new
//! one, whole, after a kill, a full disk or an error at any moment.

use super::Stop;
use crate::files::{self, Links, Replacement};
use serde::Serialize;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

/// The text of a file of at most so many bytes (one of the sizes in [`crate::files`]).
///
/// # Errors
/// It cannot be read, is no regular file or too large, or is no UTF-8.
pub fn read_text(path: &Path, at_most: u64) -> Result<String, Stop> {
    let bytes = files::read(path, at_most).map_err(|error| refused(path, &error))?;
    String::from_utf8(bytes).map_err(|error| {
        let good = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + good.iter().filter(|&&byte| byte == b'\n').count();
        Stop::Refused(format!("{}:{line}: found letters that are not UTF-8, expected a file saved as UTF-8", path.display()))
    })
}

/// A file to be written. Standard output, and what the caller has passed on open (`/dev/fd/3`), is written to as it is.
pub struct NewFile {
    path: PathBuf,
    writer: BufWriter<Place>,
}

/// A CSV file of rows, while it is written.
pub struct Table<W: Write>(csv::Writer<W>);

impl<W: Write> Table<W> {
    /// Begins with the names of the columns, separated by commas. A row's fields may hold several cells each, so that they are not the
    /// names.
    pub fn new(out: W, header: &str) -> io::Result<Self> {
        let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(out);
        writer.write_record(header.split(',')).map_err(plain)?;
        Ok(Self(writer))
    }

    /// Adds a row.
    pub fn row(&mut self, row: &impl Serialize) -> io::Result<()> {
        self.0.serialize(row).map_err(plain)
    }

    /// Ends the rows; what they were written to.
    pub fn into_inner(self) -> io::Result<W> {
        self.0.into_inner().map_err(|error| error.into_error())
    }
}

/// What the system said, as it said it: whoever reads a pipe may have gone away.
fn plain(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// A file that is written, and not in its place yet.
pub struct Staged {
    path: PathBuf,
    fresh: Option<Replacement>,
}

enum Place {
    /// Without a name, to be staged beside its target.
    Collected(File),
    Itself(File),
}

impl NewFile {
    /// Begins the file.
    ///
    /// # Errors
    /// Nothing can be written there, or what is there is read-only; nothing has been written then.
    pub fn create(path: &Path) -> Result<Self, Stop> {
        let place = Place::find(path).map_err(|error| refused(path, &error))?;
        Ok(Self { path: path.to_path_buf(), writer: BufWriter::new(place) })
    }

    /// Begins those of a subcommand's output files that are asked for, each by the name of its argument. `inputs` are the files that
    /// the subcommand reads.
    ///
    /// # Errors
    /// As [`NewFile::create`]; two outputs are one file, or an output is an input. Nothing has been written then.
    pub fn create_all<const N: usize>(outputs: [(&str, Option<&Path>); N], inputs: &[PathBuf]) -> Result<[Option<Self>; N], Stop> {
        let read: Vec<Identity> = inputs.iter().filter_map(|path| Identity::of(path)).collect();
        let mut written: Vec<(Identity, &str)> = Vec::new();
        for (argument, path) in outputs.iter().filter_map(|(argument, path)| Some((argument, (*path)?))) {
            let Some(identity) = Identity::of(path) else { continue };
            if read.contains(&identity) {
                let path = path.display();
                return Err(Stop::Refused(format!("{argument} {path}: this file is read by the same command, expected another")));
            }
            if let Some((_, other)) = written.iter().find(|(other, _)| *other == identity) {
                let path = path.display();
                return Err(Stop::Refused(format!("{argument} {path}: {other} is written to this file, expected another")));
            }
            written.push((identity, argument));
        }
        let mut files = [const { None }; N];
        for (file, (_, path)) in files.iter_mut().zip(outputs) {
            *file = path.map(Self::create).transpose()?;
        }
        Ok(files)
    }

    /// Writes what was collected to the disk, beside the target.
    ///
    /// # Errors
    /// The disk is full or gone.
    pub fn stage(self) -> Result<Staged, Stop> {
        let Self { path, writer } = self;
        let written = writer.into_inner().map_err(io::IntoInnerError::into_error).and_then(|place| match place {
            Place::Collected(mut collected) => {
                let mut fresh = Replacement::begin(&path, Links::Followed)?;
                collected.rewind()?;
                io::copy(&mut collected, fresh.file())?;
                fresh.seal()?;
                Ok(Some(fresh))
            }
            Place::Itself(_) => Ok(None),
        });
        written.map_err(|error| Stop::Output(named(&path, &error))).map(|fresh| Staged { path, fresh })
    }
}

impl Staged {
    /// Puts files in their places, each in one step, once all of them are staged.
    ///
    /// # Errors
    /// What the system says; that file and those behind it are as they were then.
    pub fn place_all(staged: impl IntoIterator<Item = Self>) -> Result<(), Stop> {
        for Self { path, fresh } in staged {
            fresh.map_or(Ok(()), Replacement::finish).map_err(|error| Stop::Output(named(&path, &error)))?;
        }
        Ok(())
    }
}

impl Place {
    fn find(path: &Path) -> io::Result<Self> {
        if let Some(output) = standard_output(path)? {
            return Ok(Self::Itself(output));
        }
        if files::is_passed_on(path) {
            return Ok(Self::Itself(OpenOptions::new().write(true).open(path)?));
        }
        let (target, found) = files::target(path, Links::Followed)?;
        if let Some(found) = found {
            one_name(&found)?;
            // A file that this user may not write to is not replaced either.
            files::open(OpenOptions::new().write(true), &target, Links::Never)?;
        }
        let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let closed = |error: io::Error| {
            let why = format!("{error}: the file is written beside its place first, and its folder takes no new file");
            io::Error::new(error.kind(), why)
        };
        tempfile::tempfile_in(folder).map(Self::Collected).map_err(closed)
    }
}

/// Refuses a file with further names (hard links): they would go on leading to the old content.
#[cfg(unix)]
fn one_name(found: &fs::Metadata) -> io::Result<()> {
    match std::os::unix::fs::MetadataExt::nlink(found) {
        0 | 1 => Ok(()),
        names => {
            let why =
                format!("the file has {names} names (hard links), which cannot all get the new content at once, expected one");
            Err(io::Error::new(io::ErrorKind::InvalidInput, why))
        }
    }
}

#[cfg(not(unix))]
fn one_name(_: &fs::Metadata) -> io::Result<()> {
    Ok(())
}

/// This program's standard output, if that is the file that the path leads to: two that write to one file from its beginning would
/// write over each other.
#[cfg(unix)]
fn standard_output(path: &Path) -> io::Result<Option<File>> {
    use std::os::fd::AsFd;
    let output = File::from(io::stdout().as_fd().try_clone_to_owned()?);
    let same = Identity::of_file(&output.metadata()?).is_some_and(|output| Identity::of(path) == Some(output));
    Ok(same.then_some(output))
}

#[cfg(not(unix))]
fn standard_output(_: &Path) -> io::Result<Option<File>> {
    Ok(None)
}

/// Which regular file a path leads to, or would lead to if it were made.
#[derive(PartialEq)]
enum Identity {
    #[cfg(unix)]
    Node(u64, u64),
    Path(PathBuf),
}

impl Identity {
    /// `None` for what is no regular file, or cannot be reached.
    fn of(path: &Path) -> Option<Self> {
        match fs::metadata(path) {
            #[cfg(unix)]
            Ok(found) => Self::of_file(&found),
            #[cfg(not(unix))]
            Ok(found) => found.is_file().then(|| path.canonicalize().ok().map(Self::Path)).flatten(),
            Err(_) => {
                let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
                Some(Self::Path(folder.canonicalize().ok()?.join(path.file_name()?)))
            }
        }
    }

    #[cfg(unix)]
    fn of_file(found: &fs::Metadata) -> Option<Self> {
        use std::os::unix::fs::MetadataExt;
        found.is_file().then(|| Self::Node(found.dev(), found.ino()))
    }
}

impl Write for Place {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Collected(file) | Self::Itself(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Collected(file) | Self::Itself(file) => file.flush(),
        }
    }
}

impl Write for NewFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes).map_err(|error| named(&self.path, &error))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush().map_err(|error| named(&self.path, &error))
    }
}

/// An error with the file that it is about.
fn named(path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}

fn refused(path: &Path, error: &io::Error) -> Stop {
    Stop::Refused(format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn write(path: &Path, text: &str) {
        let mut file = NewFile::create(path).unwrap();
        file.write_all(text.as_bytes()).unwrap();
        Staged::place_all([file.stage().unwrap()]).unwrap();
    }

    fn names(folder: &Path) -> usize {
        fs::read_dir(folder).unwrap().count()
    }

    #[test]
    fn a_file_appears_whole_when_it_is_finished() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.csv");
        let unfinished = || {
            let mut file = NewFile::create(&path).unwrap();
            file.write_all(b"half").unwrap();
            file.flush().unwrap();
            file
        };
        let begun = unfinished();
        assert_eq!(names(folder.path()), 0, "whatever stops the program now leaves nothing behind");
        drop(begun);
        fs::write(&path, "old").unwrap();
        let begun = unfinished();
        assert_eq!((fs::read_to_string(&path).unwrap().as_str(), names(folder.path())), ("old", 1));
        drop(begun);
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        for text in ["new and longer", "shorter", ""] {
            write(&path, text);
            assert_eq!((fs::read_to_string(&path).unwrap().as_str(), names(folder.path())), (text, 1));
        }
    }

    #[cfg(unix)]
    #[test]
    fn modes_and_links_are_kept_and_a_file_with_two_names_is_refused() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("out.csv"), "old").unwrap();
        fs::set_permissions(path("out.csv"), fs::Permissions::from_mode(0o640)).unwrap();
        symlink("out.csv", path("soft")).unwrap();
        write(&path("soft"), "new");
        assert_eq!(fs::read_to_string(path("out.csv")).unwrap(), "new");
        assert!(fs::symlink_metadata(path("soft")).unwrap().is_symlink());
        assert_eq!(fs::metadata(path("out.csv")).unwrap().permissions().mode() & 0o777, 0o640);
        assert_eq!(names(folder.path()), 2);
        fs::hard_link(path("out.csv"), path("hard")).unwrap();
        for name in ["out.csv", "hard", "soft"] {
            let Err(Stop::Refused(problem)) = NewFile::create(&path(name)) else { panic!("begun") };
            assert!(problem.contains("the file has 2 names (hard links)"), "{problem}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn no_pipe_and_no_device_is_opened() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for path in [pipe.as_path(), Path::new("/dev/null"), Path::new("/dev/full")] {
            let Err(Stop::Refused(problem)) = NewFile::create(path) else { panic!("begun") };
            assert!(problem.ends_with("found a pipe or a device, expected a regular file"), "{problem}");
        }
    }

    #[test]
    fn where_nothing_can_be_written_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let read_only = folder.path().join("read-only");
        fs::write(&read_only, "kept").unwrap();
        let mut permissions = fs::metadata(&read_only).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&read_only, permissions).unwrap();
        let too_long = folder.path().join("x".repeat(300));
        for path in [folder.path().to_path_buf(), folder.path().join("missing/out.csv"), too_long, read_only.clone()] {
            assert!(matches!(NewFile::create(&path), Err(Stop::Refused(_))), "{}", path.display());
        }
        assert_eq!(fs::read_to_string(read_only).unwrap(), "kept");
        assert_eq!(names(folder.path()), 1);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_nothing_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("link");
        std::os::unix::fs::symlink("nowhere", &link).unwrap();
        let Err(Stop::Refused(problem)) = NewFile::create(&link) else { panic!("begun") };
        assert!(problem.contains("a link that leads to no file"), "{problem}");
    }

    #[test]
    fn outputs_that_are_one_file_or_an_input_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("below")).unwrap();
        fs::write(path("in"), "read").unwrap();
        fs::hard_link(path("in"), path("in-too")).unwrap();
        let refusal = |a: &str, b: &str| {
            let (a, b) = (path(a), path(b));
            let created = NewFile::create_all([("--a", Some(a.as_path())), ("--b", Some(&b)), ("--c", None)], &[path("in")]);
            created.map(|files| files.map(|file| file.is_some())).map_err(|stop| match stop {
                Stop::Refused(problem) => problem,
                Stop::Output(error) => panic!("{error}"),
            })
        };
        assert_eq!(refusal("one", "two"), Ok([true, true, false]));
        for same in ["one", "./one", "below/../one"] {
            let problem = refusal("one", same).unwrap_err();
            assert!(
                problem.starts_with("--b ") && problem.ends_with(": --a is written to this file, expected another"),
                "{problem}"
            );
        }
        for input in ["in", "in-too"] {
            assert!(refusal("one", input).unwrap_err().ends_with("this file is read by the same command, expected another"));
        }
        assert_eq!(fs::read_to_string(path("in")).unwrap(), "read");
        assert!(!path("one").exists());
    }

    #[test]
    fn text_that_is_none_is_refused_with_its_line() {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), b"a\nb\n\xff\n").unwrap();
        let Err(Stop::Refused(problem)) = read_text(file.path(), 100) else { panic!("read") };
        assert!(problem.contains(":3: found letters that are not UTF-8"), "{problem}");
        assert!(read_text(file.path(), 5).is_err(), "six bytes");
    }
}
