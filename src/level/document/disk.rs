//! The only part of the document that knows the disk: opening, saving, and keeping what is not saved yet.
//!
//! Each file is replaced whole. Before the first one is, everything stands in
//! `.autosave`, in the level's folder, and that goes when the last one is there: whenever the program ends, however it ends, each file is
//! the old one or the new one, and what was edited is in the one or the other. The loader and `check` pass over hidden names.

use super::{Document, Table};
use crate::files::{self, Links, Replacement};
use crate::level::folder::{Disk, load_from};
use crate::level::image::png_size;
use crate::level::read::{BACKGROUND, Files, read, read_unfinished};
use crate::level::{Loaded, Problem};
use crate::physics::DVec2;
use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What is not saved yet.
const KEPT: &str = ".autosave";
/// How that file begins.
const MARK: &str = "resultant autosave 1\n";
/// How it ends: what has no such end was cut short.
const END: &str = "end\n";
/// The largest such file that is read: all tables at their limits, and room for their names.
const KEPT_MOST: u64 = (files::LEVEL_TABLE + 100) * Table::ALL.len() as u64;

/// A level's folder as a document knows it.
#[derive(Clone, Debug)]
pub struct Folder {
    folder: PathBuf,
    project: PathBuf,
    /// What the files held when they were opened or saved last, by [`Table`].
    known: Vec<Option<Vec<u8>>>,
}

/// A level that has been opened.
#[derive(Debug)]
pub struct Opened {
    /// What is on disk.
    pub document: Document,
    /// Where.
    pub folder: Folder,
    /// What was edited and not saved before the program ended, where that is something else.
    pub kept: Option<Kept>,
}

/// The bytes of all files as they were edited and not saved, by [`Table`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kept(Vec<Option<Vec<u8>>>);

/// Why a level could not be saved.
#[derive(Debug)]
pub enum SaveError {
    /// Another program has written these files since: nothing was written.
    Changed(Vec<Table>),
    /// The system refused that file; those before it are written, and all of it is kept beside them.
    File(String, io::Error),
}

impl fmt::Display for SaveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Changed(tables) => {
                let files: Vec<&str> = tables.iter().map(|table| table.file()).collect();
                write!(f, "another program has changed {}", files.join(", "))
            }
            Self::File(file, error) => write!(f, "{file}: {error}"),
        }
    }
}

impl Folder {
    /// Opens the level in `folder`; images are looked up there, then under `project`.
    ///
    /// # Errors
    /// A file that cannot be read, in words. What is in the files is not judged: a level that is refused can be opened.
    pub fn open(folder: &Path, project: &Path) -> Result<Opened, String> {
        if !folder.is_dir() {
            return Err(format!("there is no folder {}", folder.display()));
        }
        let mut known = Vec::new();
        for table in Table::ALL {
            known.push(read_table(folder, *table).map_err(|error| format!("{}: {error}", table.file()))?);
        }
        let mut document = Document::new(|table| known[table.index()].clone());
        let kept = files::read_with(&folder.join(KEPT), KEPT_MOST, Links::Never)
            .ok()
            .and_then(|bytes| parse(&bytes))
            .filter(|kept| kept.0 != known);
        let folder = Self { folder: folder.to_path_buf(), project: project.to_path_buf(), known };
        folder.measure(&mut document);
        Ok(Opened { document, folder, kept })
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.folder
    }

    /// The level's name.
    pub fn name(&self) -> String {
        let resolved = self.folder.canonicalize().unwrap_or_else(|_| self.folder.clone());
        resolved.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    }

    fn disk(&self) -> Disk<'_> {
        Disk { folder: &self.folder, project: &self.project }
    }

    /// Tells the document how large its pictures are.
    pub fn measure(&self, document: &mut Document) {
        let disk = self.disk();
        let side = |(width, height)| DVec2::new(width, height);
        document.tell_sizes(BTreeMap::new(), None);
        let background = png_size(disk.level_file(BACKGROUND), BACKGROUND).ok().map(side);
        let size = |name: &String| {
            let path = disk.picture(Path::new(&name.replace('\\', "/")));
            let (width, height) = png_size(files::read(&path, files::PICTURE), name).ok()?;
            Some((name.clone(), side((width, height))))
        };
        let pictures = document.unknown_pictures().iter().filter_map(size).collect();
        document.tell_sizes(pictures, background);
    }

    /// Where the picture of a cell is, to be drawn.
    pub fn picture(&self, name: &str) -> PathBuf {
        self.disk().picture(Path::new(&name.replace('\\', "/")))
    }

    /// Where the background is, if there is one.
    pub fn background(&self) -> Option<PathBuf> {
        Some(self.folder.join(BACKGROUND)).filter(|path| path.is_file())
    }

    /// What the loader says of the document, as it is in memory.
    ///
    /// # Errors
    /// As [`load`](crate::level::load).
    pub fn check(&self, document: &Document) -> Result<Loaded, Vec<Problem>> {
        let disk = self.disk();
        load_from(&disk, &document.over(&disk), read)
    }

    /// The document as far as it can be flown, to try it out.
    ///
    /// # Errors
    /// As [`load_unfinished`](crate::level::load_unfinished).
    pub fn unfinished(&self, document: &Document) -> Result<Loaded, Vec<Problem>> {
        let disk = self.disk();
        load_from(&disk, &document.over(&disk), read_unfinished)
    }

    /// Whether the document has something that is not on disk.
    pub fn is_unsaved(&self, document: &Document) -> bool {
        Table::ALL.iter().any(|table| document.bytes(*table) != self.known[table.index()].as_deref())
    }

    /// The files that another program has changed since they were opened or saved, with what they hold now; a file that cannot be read has
    /// not changed yet.
    pub fn changed(&self) -> Vec<(Table, Option<Vec<u8>>)> {
        let now = Table::ALL.iter().filter_map(|table| Some((*table, read_table(&self.folder, *table).ok()?)));
        now.filter(|(table, bytes)| *bytes != self.known[table.index()]).collect()
    }

    /// Takes over what other programs have written, where the document has nothing else there, or where `all` is to be theirs; the files
    /// that were edited here, too, and are left as they are. Whether anything was taken over.
    pub fn take_over(&mut self, document: &mut Document, all: bool) -> (bool, Vec<Table>) {
        let (mut taken, mut both) = (false, Vec::new());
        for (table, bytes) in self.changed() {
            let edited = document.bytes(table) != self.known[table.index()].as_deref();
            if document.bytes(table) == bytes.as_deref() {
                self.known[table.index()] = bytes;
            } else if edited && !all {
                both.push(table);
            } else {
                document.replace(table, bytes.clone());
                (self.known[table.index()], taken) = (bytes, true);
            }
        }
        (taken, both)
    }

    /// Writes every file that has changed. With `over`, also over what another program has written since.
    ///
    /// # Errors
    /// See [`SaveError`]; nothing of the document is lost.
    pub fn save(&mut self, document: &Document, over: bool) -> Result<(), SaveError> {
        let edited = |table: &Table| document.bytes(*table) != self.known[table.index()].as_deref();
        let changed: Vec<Table> = Table::ALL.iter().copied().filter(edited).collect();
        let theirs: Vec<Table> =
            self.changed().into_iter().filter(|(table, _)| changed.contains(table)).map(|(table, _)| table).collect();
        if !over && !theirs.is_empty() {
            return Err(SaveError::Changed(theirs));
        }
        self.write_kept(document, true).map_err(|error| SaveError::File(KEPT.to_owned(), error))?;
        for table in changed {
            let path = self.folder.join(table.file());
            let written = match document.bytes(table) {
                Some(bytes) => files::replace(&path, bytes, Links::Followed),
                None => fs::remove_file(&path),
            };
            written.map_err(|error| SaveError::File(table.file().to_owned(), error))?;
            self.known[table.index()] = document.bytes(table).map(<[u8]>::to_vec);
        }
        files::sync_folder(&self.folder);
        self.forget();
        Ok(())
    }

    /// Keeps what is not saved beside the files, for when the program ends without being asked to; nothing where all is saved.
    ///
    /// # Errors
    /// What the system says.
    pub fn keep(&self, document: &Document) -> io::Result<()> {
        if self.is_unsaved(document) {
            return self.write_kept(document, false);
        }
        self.forget();
        Ok(())
    }

    /// Throws away what was kept.
    pub fn forget(&self) {
        // Where there is none, that is as well.
        let _ = fs::remove_file(self.folder.join(KEPT));
    }

    fn write_kept(&self, document: &Document, durable: bool) -> io::Result<()> {
        let mut all = MARK.as_bytes().to_vec();
        for table in Table::ALL {
            if let Some(bytes) = document.bytes(*table) {
                all.extend_from_slice(format!("{} {}\n", table.file(), bytes.len()).as_bytes());
                all.extend_from_slice(bytes);
            }
        }
        all.extend_from_slice(END.as_bytes());
        let mut kept = Replacement::begin(&self.folder.join(KEPT), Links::Never)?;
        kept.file().write_all(&all)?;
        if durable {
            kept.seal()?;
        }
        kept.finish()
    }
}

impl Document {
    /// Takes over what was kept: one operation, which can be undone.
    pub fn restore(&mut self, kept: Kept) {
        self.replace_all(kept.0);
    }
}

fn read_table(folder: &Path, table: Table) -> io::Result<Option<Vec<u8>>> {
    match files::read(&folder.join(table.file()), files::LEVEL_TABLE) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// What a file of unsaved edits holds; `None` where it is none, or not whole.
fn parse(bytes: &[u8]) -> Option<Kept> {
    let mut rest = bytes.strip_prefix(MARK.as_bytes())?;
    let mut kept = vec![None; Table::ALL.len()];
    while rest != END.as_bytes() {
        let end = rest.iter().position(|byte| *byte == b'\n')?;
        let (file, length) = std::str::from_utf8(&rest[..end]).ok()?.split_once(' ')?;
        let bytes = rest.get(end + 1..)?.get(..length.parse().ok()?)?;
        kept[Table::of_file(file)?.index()] = Some(bytes.to_vec());
        rest = &rest[end + 1 + bytes.len()..];
    }
    Some(Kept(kept))
}
