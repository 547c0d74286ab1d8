//! A package as a `.zip`, and back. Limits hold for the unpacked bytes, not for the sizes that an archive names.

use super::package::{Cost, LARGEST, MEMORY, MOST_FILES, Package, UNPACKED, limit};
use super::path;
use crate::words::tr;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{Cursor, Read, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

/// The table of every level with a ship, and one of every experiment: its folder is the level's folder.
const HEARTS: [&str; 2] = ["player.csv", "constants.csv"];
/// The record at an archive's end: first bytes, length without a comment, and the place of the number of entries.
const END: &[u8] = b"PK\x05\x06";
const END_LENGTH: usize = 22;
const END_COUNT: usize = 10;
/// The mask of the file type in a Unix mode, and the two types of a level's files; 0 in an archive without modes.
const KIND: u32 = 0o170_000;
const PLAIN: [u32; 3] = [0, 0o100_000, 0o040_000];

/// The same package always makes the same bytes.
pub fn write(package: &Package) -> Result<Vec<u8>, String> {
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let refused = |error: &dyn std::fmt::Display| tr!("cannot pack: {error}", error);
    for (path, bytes) in &package.files {
        archive.start_file(format!("{}/{path}", package.name), options).map_err(|error| refused(&error))?;
        archive.write_all(bytes).map_err(|error| refused(&error))?;
    }
    Ok(archive.finish().map_err(|error| refused(&error))?.into_inner())
}

/// The package in an archive, which need not be a level; `called` names one whose files lie in no folder. Errors: a damaged archive; too many bytes,
/// entries or too much memory; paths that lead elsewhere, or are one on some system; links, devices, files of no level; files of several levels.
pub fn read(bytes: &[u8], called: &str) -> Result<Package, String> {
    let mut archive = open(bytes)?;
    let cost = cost(&mut archive, bytes.len() as u64)?;
    if cost > MEMORY {
        return Err(tr!("found a level that needs {cost} bytes of memory, expected at most {most}", cost, most = MEMORY));
    }
    let mut found = PackEntries::default();
    // The first part may be the level's folder: the whole path is judged once that is known.
    let most = |parts: &[String]| (0..parts.len().min(2)).filter_map(|from| limit(&parts[from..].join("/"))).max();
    for index in 0..archive.len() {
        found.entry(&mut archive, index, &most)?;
    }
    found.package(called)
}

/// The files below a folder of an archive, by their paths from there; `limit` is the most bytes of a path, `None` for one that does not belong.
/// Errors: as [`read`], without the rules of a level; a file outside of the folder.
#[cfg(any(browser, test))]
pub(super) fn read_below(bytes: &[u8], folder: &str, limit: impl Fn(&str) -> Option<u64>) -> Result<PackedBytes, String> {
    let (mut archive, mut found) = (open(bytes)?, PackEntries::default());
    let most = |parts: &[String]| limit(&parts.strip_prefix(&[folder.to_owned()])?.join("/"));
    for index in 0..archive.len() {
        found.entry(&mut archive, index, &most)?;
    }
    Ok(found.files.into_iter().map(|(parts, bytes)| (parts[1..].join("/"), bytes)).collect())
}

#[cfg(any(browser, test))]
type PackedBytes = BTreeMap<String, Vec<u8>>;
type Archive<'a> = ZipArchive<Cursor<&'a [u8]>>;

fn open(bytes: &[u8]) -> Result<Archive<'_>, String> {
    if bytes.len() as u64 > LARGEST {
        let found = tr!("{count} bytes", count = bytes.len());
        return Err(tr!("found {found}, expected at most {most} bytes", found, most = LARGEST));
    }
    let count = entries(bytes).ok_or(tr("found no ZIP archive, expected one as `resultant pack` makes it"))?;
    if count > MOST_FILES {
        return Err(tr!("found {count} files, expected at most {most}", count, most = MOST_FILES));
    }
    let archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| tr!("found a damaged archive: {error}", error))?;
    // The reader has one entry a name, but another program may take the second of two.
    if archive.len() != count {
        return Err(tr!("found {count} entries of {names} names, expected one entry a name", count, names = archive.len()));
    }
    Ok(archive)
}

/// The memory of a level, by the sizes in its archive. Of each picture only the head is unpacked.
fn cost(archive: &mut Archive, packed: u64) -> Result<u64, String> {
    let mut cost = Cost::of_archive(packed);
    for index in 0..archive.len() {
        let entry = archive.by_index(index).map_err(|error| tr!("found an entry that cannot be read: {error}", error))?;
        let (name, size) = (String::from_utf8_lossy(entry.name_raw()).into_owned(), entry.size());
        let mut head = Vec::new();
        // The reader of the file reports a damaged head.
        let _ = entry.take(Cost::HEAD).read_to_end(&mut head);
        cost.add(&name, size, &head);
    }
    Ok(cost.bytes())
}

fn no_file_of_a_level(place: &str) -> String {
    tr!("{place}: found a file that belongs to no level, expected CSV, PNG, TXT, MD", place)
}

fn entries(bytes: &[u8]) -> Option<usize> {
    let last = bytes.len().checked_sub(END_LENGTH)?;
    let first = last.saturating_sub(usize::from(u16::MAX));
    let at = (first..=last).rev().find(|&at| bytes[at..].starts_with(END))?;
    Some(usize::from(u16::from_le_bytes([bytes[at + END_COUNT], bytes[at + END_COUNT + 1]])))
}

#[derive(Default)]
struct PackEntries {
    /// By the parts of their paths.
    files: BTreeMap<Vec<String>, Vec<u8>>,
    /// All paths of files and the folders around them, [`path::folded`].
    taken: BTreeSet<String>,
    folders: BTreeSet<String>,
    unpacked: u64,
}

impl PackEntries {
    /// `most` is the most bytes of a path; `None` for one that does not belong.
    fn entry(&mut self, archive: &mut Archive, index: usize, most: &dyn Fn(&[String]) -> Option<u64>) -> Result<(), String> {
        let mut entry = archive.by_index(index).map_err(|error| tr!("found an entry that cannot be read: {error}", error))?;
        let Some(parts) = path::parts(entry.name_raw())? else { return Ok(()) };
        let shown = format!("{:?}", parts.join("/"));
        if entry.is_symlink() {
            return Err(format!("{shown}: {}", tr("found a link, expected a regular file")));
        }
        if entry.unix_mode().is_some_and(|mode| !PLAIN.contains(&(mode & KIND))) {
            return Err(format!("{shown}: {}", tr("found a pipe or a device, expected a regular file")));
        }
        if entry.is_dir() {
            return Ok(());
        }
        let most = most(&parts).ok_or_else(|| no_file_of_a_level(&shown))?;
        let left = UNPACKED - self.unpacked;
        if entry.size() > left {
            return Err(tr!("{place}: found more than {most} bytes up to here, expected no more", place = shown, most = UNPACKED));
        }
        // The archive's own size was judged: an entry that unpacks to more is refused.
        let most = most.min(entry.size());
        let mut bytes = Vec::new();
        let read = entry.by_ref().take(most + 1).read_to_end(&mut bytes);
        read.map_err(|error| tr!("{place}: found a damaged file: {error}", place = shown, error))?;
        if bytes.len() as u64 > most {
            return Err(tr!("{place}: found more than {most} bytes, expected no more", place = shown, most));
        }
        self.unpacked += bytes.len() as u64;
        self.take_name(&parts)?;
        self.files.insert(parts, bytes);
        Ok(())
    }

    /// Refuses a second path that is the same on some system, and a file where there is a folder.
    fn take_name(&mut self, parts: &[String]) -> Result<(), String> {
        let folded: Vec<String> = parts.iter().map(|part| path::folded(part)).collect();
        let whole = folded.join("/");
        let around: Vec<String> = (1..folded.len()).map(|end| folded[..end].join("/")).collect();
        let clash = self.folders.contains(&whole) || around.iter().any(|folder| self.taken.contains(folder));
        if clash || !self.taken.insert(whole) {
            return Err(tr!(
                "{place}: found that name twice, expected names that differ in more than their case and the encoding of accents",
                place = format_args!("{:?}", parts.join("/"))
            ));
        }
        self.folders.extend(around);
        Ok(())
    }

    /// The level's folder is the folder of its heart.
    fn package(self, called: &str) -> Result<Package, String> {
        let is = |parts: &&Vec<String>, heart: &str| parts.last().is_some_and(|name| name == heart);
        let named = |heart: &str| self.files.keys().filter(|parts| is(parts, heart)).collect::<Vec<_>>();
        let quoted = |parts: &[String]| format!("{:?}", parts.join("/"));
        let hearts = HEARTS.map(named).into_iter().find(|found| !found.is_empty()).unwrap_or_default();
        let folder = match hearts.as_slice() {
            [] => return Err(tr!("found no {file}, expected a level's folder", file = HEARTS[0])),
            [heart] if heart.len() <= 2 => heart[..heart.len() - 1].to_vec(),
            [heart] => return Err(tr!("found the level in {path}, expected its folder at the top", path = quoted(heart))),
            [first, second, ..] => {
                let (first, second) = (quoted(first), quoted(second));
                return Err(tr!("found {first} and {second}, expected one level", first, second));
            }
        };
        let name = folder.first().map_or(called, String::as_str).to_owned();
        path::judge_folder(&name)?;
        let mut files = BTreeMap::new();
        for (parts, bytes) in self.files {
            let Some(own) = parts.strip_prefix(folder.as_slice()) else {
                return Err(tr!("{place}: found a file beside the level's folder, expected all in it", place = quoted(&parts)));
            };
            let own = own.join("/");
            let most = limit(&own).ok_or_else(|| no_file_of_a_level(&format!("{own:?}")))?;
            if bytes.len() as u64 > most {
                let found = tr!("{count} bytes", count = bytes.len());
                return Err(format!("{own:?}: {}", tr!("found {found}, expected at most {most} bytes", found, most)));
            }
            files.insert(own, bytes);
        }
        Ok(Package { name, files })
    }
}
