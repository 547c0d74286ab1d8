//! Input and output files of subcommands. New content goes into a hidden file beside its target, and takes the target's place in one step
//! once it is complete.

use super::CommandError;
use crate::files::{self, Replacement, Symlinks};
use serde::Serialize;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// The text of the file `from`, which messages call `path`; `at_most` is in bytes (one of the sizes in [`crate::files`]). Errors: a file that cannot
/// be read, is no regular one, too large, or no UTF-8.
pub fn read_text(path: &Path, from: &Path, at_most: u64) -> Result<String, CommandError> {
    let bytes = files::read(from, at_most).map_err(|error| refused(path, &error))?;
    files::Encoding::text(&bytes).map_err(|line| {
        let (found, expected) = files::CellFault::NotUtf8.words();
        CommandError::Refused(files::found_instead(&format!("{}:{line}", path.display()), found, expected))
    })
}

pub struct CsvOutput<W: Write>(csv::Writer<W>);

impl<W: Write> CsvOutput<W> {
    /// `header` is the columns' names with commas between: a field of a row may hold several cells, so that the fields' names do not serve.
    pub fn new(out: W, header: &str) -> io::Result<Self> {
        let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(out);
        writer.write_record(header.split(',')).map_err(plain)?;
        Ok(Self(writer))
    }

    pub fn row(&mut self, row: &impl Serialize) -> io::Result<()> {
        self.0.serialize(row).map_err(plain)
    }

    pub fn into_inner(self) -> io::Result<W> {
        self.0.into_inner().map_err(|error| error.into_error())
    }
}

/// The system's error inside, such as a closed pipe.
fn plain(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

const STANDARD: [&str; 2] = ["-", "/dev/stdout"];

pub struct OutputFile {
    path: PathBuf,
    writer: BufWriter<OutputTarget>,
}

enum OutputTarget {
    File(Box<Replacement>),
    Standard(io::Stdout),
}

impl OutputTarget {
    fn writer(&mut self) -> &mut dyn Write {
        match self {
            Self::File(file) => file,
            Self::Standard(out) => out,
        }
    }
}

impl Write for OutputTarget {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer().flush()
    }
}

/// A complete file beside its target; nothing of standard output.
pub struct Staged {
    path: PathBuf,
    fresh: Option<Replacement>,
}

impl OutputFile {
    /// Errors: a folder that cannot be written, a read-only file there, or no regular one; nothing has been written then.
    pub fn create(path: &Path) -> Result<Self, CommandError> {
        let target = if is_standard(path) {
            OutputTarget::Standard(io::stdout())
        } else {
            let begun = Replacement::begin(path, Symlinks::Followed).map_err(|error| refused(path, &error))?;
            OutputTarget::File(Box::new(begun))
        };
        Ok(Self { path: path.to_path_buf(), writer: BufWriter::new(target) })
    }

    /// Creates the wanted output files, each by its argument's name. `inputs` are the files that the subcommand reads. Errors: as
    /// [`OutputFile::create`]; two outputs are one file, or an output is an input. Nothing has been written then.
    pub fn create_all<const N: usize>(
        outputs: [(&str, Option<&Path>); N],
        inputs: &[PathBuf],
    ) -> Result<[Option<Self>; N], CommandError> {
        let mut taken: Vec<(PathBuf, String)> =
            inputs.iter().map(|path| (resolved(path), "this file is read by the same command".to_owned())).collect();
        let mut files = [const { None }; N];
        for (argument, path) in outputs.iter().filter_map(|(argument, path)| Some((argument, (*path)?))) {
            let file = resolved(path);
            if let Some((_, why)) = taken.iter().find(|(other, _)| *other == file && !is_standard(path)) {
                return Err(CommandError::Refused(format!("{argument} {}: {why}, expected another", path.display())));
            }
            taken.push((file, format!("{argument} is written to this file")));
        }
        for (file, (_, path)) in files.iter_mut().zip(outputs) {
            *file = path.map(Self::create).transpose()?;
        }
        Ok(files)
    }

    pub fn stage(self) -> Result<Staged, CommandError> {
        let Self { path, writer } = self;
        let staged = writer.into_inner().map_err(io::IntoInnerError::into_error).and_then(|target| match target {
            OutputTarget::File(mut file) => file.seal().map(|()| Some(*file)),
            OutputTarget::Standard(mut out) => out.flush().map(|()| None),
        });
        let fresh = staged.map_err(|error| CommandError::Output(named(&path, &error)))?;
        Ok(Staged { path, fresh })
    }
}

impl Staged {
    /// Puts each file in its place in one step. After an error that file and the following ones are as before.
    pub fn place_all(staged: impl IntoIterator<Item = Self>) -> Result<(), CommandError> {
        for Self { path, fresh } in staged {
            fresh.map_or(Ok(()), Replacement::finish).map_err(|error| CommandError::Output(named(&path, &error)))?;
        }
        Ok(())
    }
}

fn is_standard(path: &Path) -> bool {
    STANDARD.iter().any(|name| path == Path::new(name))
}

/// Without links; the file need not exist yet.
fn resolved(path: &Path) -> PathBuf {
    let beside = || Some(files::around(path).canonicalize().ok()?.join(path.file_name()?));
    path.canonicalize().ok().or_else(beside).unwrap_or_else(|| path.to_path_buf())
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes).map_err(|error| named(&self.path, &error))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush().map_err(|error| named(&self.path, &error))
    }
}

fn named(path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}

fn refused(path: &Path, error: &io::Error) -> CommandError {
    CommandError::Refused(format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn write(path: &Path, text: &str) {
        let mut file = OutputFile::create(path).unwrap();
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
            let mut file = OutputFile::create(&path).unwrap();
            file.write_all(b"half").unwrap();
            file.flush().unwrap();
            file
        };
        drop(unfinished());
        assert_eq!(names(folder.path()), 0);
        fs::write(&path, "old").unwrap();
        let begun = unfinished();
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        drop(begun);
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        for text in ["new and longer", "shorter", ""] {
            write(&path, text);
            assert_eq!((fs::read_to_string(&path).unwrap().as_str(), names(folder.path())), (text, 1));
        }
    }

    #[cfg(unix)]
    #[test]
    fn modes_and_links_are_kept() {
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
    }

    #[cfg(unix)]
    #[test]
    fn no_pipe_and_no_device_is_opened() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for path in [pipe.as_path(), Path::new("/dev/null"), Path::new("/dev/full")] {
            let Err(CommandError::Refused(problem)) = OutputFile::create(path) else { panic!("begun") };
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
            assert!(matches!(OutputFile::create(&path), Err(CommandError::Refused(_))), "{}", path.display());
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
        let Err(CommandError::Refused(problem)) = OutputFile::create(&link) else { panic!("begun") };
        assert!(problem.contains("a link that leads to no file"), "{problem}");
    }

    #[test]
    fn outputs_that_are_one_file_or_an_input_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("below")).unwrap();
        fs::write(path("in"), "read").unwrap();
        let refusal = |a: &str, b: &str| {
            let (a, b) = (path(a), path(b));
            let created = OutputFile::create_all([("--a", Some(a.as_path())), ("--b", Some(&b)), ("--c", None)], &[path("in")]);
            created.map(|files| files.map(|file| file.is_some())).map_err(|stop| match stop {
                CommandError::Refused(problem) => problem,
                CommandError::Output(error) => panic!("{error}"),
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
        assert!(refusal("one", "in").unwrap_err().ends_with("this file is read by the same command, expected another"));
        assert_eq!(fs::read_to_string(path("in")).unwrap(), "read");
        assert!(!path("one").exists());
    }

    #[test]
    fn text_that_is_none_is_refused_with_its_line() {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), b"a\nb\n\xff\n").unwrap();
        let Err(CommandError::Refused(problem)) = read_text(file.path(), file.path(), 100) else { panic!("read") };
        assert!(problem.contains(":3: found letters that are not UTF-8"), "{problem}");
        assert!(read_text(file.path(), file.path(), 5).is_err(), "six bytes");
    }
}
