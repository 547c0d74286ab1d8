//! Reading regular files up to a size.

use crate::words::tr;
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, IsTerminal, Read};
use std::path::Path;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symlinks {
    /// The file at the link's end.
    Followed,
    /// The link itself: it is no file to read, and a new file replaces it. For hidden files of the game, in a folder that a stranger may own.
    Never,
}

pub(super) fn read_file(path: &Path, at_most: u64, links: Symlinks) -> io::Result<Vec<u8>> {
    let file = if let Some(descriptor) = descriptor(path) {
        judge_input(descriptor)?;
        File::open(path)?
    } else {
        let (file, found) = open(OpenOptions::new().read(true), path, links)?;
        if found.len() > at_most {
            return Err(too_large(Some(found.len()), at_most));
        }
        file
    };
    let mut bytes = Vec::new();
    // A file may have grown since, and a stream shows its size only now.
    file.take(at_most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > at_most { Err(too_large(None, at_most)) } else { Ok(bytes) }
}

/// Opens an existing regular file only: a pipe waits for its other end, and a device may act on being opened. Errors: no regular file; the system's.
pub(super) fn open(options: &OpenOptions, path: &Path, links: Symlinks) -> io::Result<(File, Metadata)> {
    judge(&match links {
        Symlinks::Followed => fs::metadata(path)?,
        Symlinks::Never => fs::symlink_metadata(path)?,
    })?;
    #[cfg(not(unix))]
    let _ = links;
    #[cfg(unix)]
    let options = &{
        use std::os::unix::fs::OpenOptionsExt;
        let never = if links == Symlinks::Never { libc::O_NOFOLLOW } else { 0 };
        let mut options = options.clone();
        options.custom_flags(libc::O_NONBLOCK | never);
        options
    };
    let file = options.open(path)?;
    // Another program may have replaced the file since the first look.
    let found = file.metadata()?;
    judge(&found)?;
    Ok((file, found))
}

/// The number of an open file of this process, where the path names one.
fn descriptor(path: &Path) -> Option<i32> {
    let standard = ["/dev/stdin", "/dev/stdout", "/dev/stderr"].iter().position(|passed| path == Path::new(passed));
    let numbered = || {
        let folder = path.parent()?;
        let of_this_process = ["/dev/fd", "/proc/self/fd"].iter().any(|passed| folder == Path::new(passed));
        path.file_name()?.to_str()?.parse().ok().filter(|number| of_this_process && *number >= 0)
    };
    standard.map(|number| number as i32).or_else(numbered)
}

/// Refuses what never ends for this process: its outputs, and what it holds open for writing, too, but a terminal as input, which a user ends.
fn judge_input(descriptor: i32) -> io::Result<()> {
    let of_a_terminal = || descriptor == 0 && io::stdin().is_terminal();
    let regular = || fs::metadata(format!("/dev/fd/{descriptor}")).is_ok_and(|found| found.is_file());
    let reads = match mode(descriptor) {
        _ if OUTPUTS.contains(&descriptor) => false,
        Some(WRITES) => false,
        Some(BOTH) => regular() || of_a_terminal(),
        _ => true,
    };
    let refusal = tr("found an output of this program, expected a file or an input");
    if reads { Ok(()) } else { Err(io::Error::new(io::ErrorKind::InvalidInput, refusal)) }
}

/// Standard output and standard error.
const OUTPUTS: [i32; 2] = [1, 2];
/// The access modes of open(2) beside reading.
const WRITES: u32 = 1;
const BOTH: u32 = 2;

/// The access mode of an open file; `None` where the system does not say. There it opens no file again that is open for writing alone.
fn mode(descriptor: i32) -> Option<u32> {
    let info = fs::read_to_string(format!("/proc/self/fdinfo/{descriptor}")).ok()?;
    let flags = info.lines().find_map(|line| line.strip_prefix("flags:"))?;
    u32::from_str_radix(flags.trim(), 8).ok().map(|flags| flags & (WRITES | BOTH))
}

pub(super) fn judge(found: &Metadata) -> io::Result<()> {
    let (kind, other) = match found.file_type() {
        kind if kind.is_file() => return Ok(()),
        kind if kind.is_dir() => (io::ErrorKind::IsADirectory, tr("found a folder, expected a file")),
        kind if kind.is_symlink() => (io::ErrorKind::InvalidInput, tr("found a link, expected a regular file")),
        _ => (io::ErrorKind::InvalidInput, tr("found a pipe or a device, expected a regular file")),
    };
    Err(io::Error::new(kind, other))
}

pub fn too_large(bytes: Option<u64>, at_most: u64) -> io::Error {
    let found = bytes.map_or(tr("more").to_owned(), |count| tr!("{count} bytes", count));
    io::Error::new(io::ErrorKind::FileTooLarge, tr!("found {found}, expected at most {most} bytes", found, most = at_most))
}

#[cfg(test)]
mod tests {
    use super::super::{read, read_text};
    use super::*;

    #[test]
    fn a_file_is_read_up_to_its_limit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        fs::write(&path, "12345").unwrap();
        assert_eq!(read(&path, 5).unwrap(), b"12345");
        let error = read(&path, 4).unwrap_err();
        assert_eq!(
            (error.kind(), error.to_string().as_str()),
            (io::ErrorKind::FileTooLarge, "found 5 bytes, expected at most 4 bytes")
        );
        assert_eq!(read(&folder.path().join("none"), 5).unwrap_err().kind(), io::ErrorKind::NotFound);
        assert_eq!(read(folder.path(), 5).unwrap_err().to_string(), "found a folder, expected a file");
        fs::write(&path, b"\xff").unwrap();
        assert!(read_text(&path, 5).unwrap_err().to_string().contains("UTF-8"));
    }

    #[cfg(unix)]
    #[test]
    fn what_never_ends_is_not_begun() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let link = folder.path().join("link");
        std::os::unix::fs::symlink("/dev/zero", &link).unwrap();
        for path in [pipe.as_path(), &link, Path::new("/dev/zero"), Path::new("/dev/null")] {
            let error = read(path, 1 << 30).unwrap_err();
            assert_eq!(error.to_string(), "found a pipe or a device, expected a regular file", "{}", path.display());
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn what_was_passed_on_open_is_read_to_the_limit_whatever_it_is() {
        use std::os::fd::AsRawFd;
        let zeros = File::open("/dev/zero").unwrap();
        let path = format!("/proc/self/fd/{}", zeros.as_raw_fd());
        assert_eq!(read(Path::new(&path), 1000).unwrap_err().to_string(), "found more, expected at most 1000 bytes");
        let nothing = File::open("/dev/null").unwrap();
        assert_eq!(read(Path::new(&format!("/dev/fd/{}", nothing.as_raw_fd())), 0).unwrap(), b"");
    }
}
