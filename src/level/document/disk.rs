//! The only part of the document that knows the disk: opening, saving, and keeping what is not saved yet.
//!
//! Each file is replaced whole. Before the first one is, everything stands in
//! `.autosave`, in the level's folder, and that goes when the last one is there: whenever the program ends, however it ends, each file is
//! the old one or the new one, and what was edited is in the one or the other. The loader and `check` pass over hidden names. Of several
//! editors of one level each has an `.autosave` of its own.

use super::{Document, Table};
use crate::files::{self, Links, Replacement};
use crate::level::folder::{Disk, load_from};
use crate::level::image::png_size;
use crate::level::read::{BACKGROUND, Files, read, read_unfinished};
use crate::level::{Loaded, Problem};
use crate::physics::DVec2;
use std::collections::BTreeMap;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What is not saved yet.
const KEPT: &str = ".autosave";
/// How many editors of one level keep what is not saved.
const MOST_EDITORS: u32 = 100;
/// The folder of the pictures that levels share, how deep they lie in it, and the most that are offered, or looked at in one folder.
const ASSETS: &str = "assets";
const ASSETS_DEPTH: u32 = 3;
const MOST_PICTURES: usize = 1000;
/// How many copies of one file are kept beside it.
const MOST_COPIES: u32 = 10_000;
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
    desk: Arc<Desk>,
}

/// Which of a level's editors this one is, for as long as it has the level open: a lock says so to the others.
#[derive(Debug)]
struct Desk {
    /// Where what is not saved is kept.
    kept: PathBuf,
    /// Whether another editor has the level open.
    shared: bool,
    /// Held until this editor ends.
    lock: Option<(File, PathBuf)>,
}

impl Desk {
    /// The first, also where another editor has it.
    fn alone(folder: &Path) -> Self {
        Self { kept: folder.join(KEPT), shared: false, lock: None }
    }

    /// The first that nobody has; one where something was left goes before the others.
    fn take(folder: &Path) -> Self {
        let left = (1..=MOST_EDITORS).filter(|number| fs::symlink_metadata(Self::name(folder, *number)).is_ok());
        let mut desks = left.chain(1..=MOST_EDITORS).filter_map(|number| Some((number, Self::at(folder, number)?)));
        let Some((number, mut desk)) = desks.next() else { return Self { kept: folder.join(KEPT), shared: true, lock: None } };
        desk.shared = number != 1 && Self::at(folder, 1).is_none();
        desk
    }

    /// That one; `None` where another editor has it. Where no lock can be made, as in a folder that is read-only, nothing can be kept either.
    fn at(folder: &Path, number: u32) -> Option<Self> {
        let kept = Self::name(folder, number);
        let path = kept.with_extension("lock");
        // No link is followed, and no pipe opened.
        let file = match File::create_new(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                files::open(File::options().write(true), &path, Links::Never).ok()?.0
            }
            Ok(file) => file,
            Err(_) => return Some(Self { kept, shared: false, lock: None }),
        };
        // An editor that ends takes its lock file away: the lock of a file that has gone is none.
        let own = file.try_lock().is_ok() && is_at(&file, &path);
        own.then(|| Self { kept, shared: false, lock: Some((file, path)) })
    }

    fn name(folder: &Path, number: u32) -> PathBuf {
        folder.join(if number == 1 { KEPT.to_owned() } else { format!("{KEPT}-{number}") })
    }
}

impl Drop for Desk {
    fn drop(&mut self) {
        if let Some((_, path)) = &self.lock {
            // Where it stays, the next editor takes it over.
            let _ = fs::remove_file(path);
        }
    }
}

/// Whether that is the file of that name.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let same = |a: fs::Metadata, b: fs::Metadata| a.dev() == b.dev() && a.ino() == b.ino();
    file.metadata().ok().zip(fs::symlink_metadata(path).ok()).is_some_and(|(a, b)| same(a, b))
}

/// Elsewhere a file that is open keeps its name.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// Whose files stay where another program has written into those that are edited here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// What is edited here.
    Mine,
    /// What the other program wrote.
    Theirs,
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
    /// What is to be saved cannot even be kept beside the files: nothing was written.
    NotKept(io::Error),
    /// The system refused that file; those before it are written, and all of it is kept beside them.
    File(String, io::Error),
}

impl fmt::Display for SaveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Changed(tables) => {
                let files: Vec<&str> = tables.iter().map(|table| table.file()).collect();
                write!(f, "Not saved: another program has changed {}", files.join(", "))
            }
            Self::NotKept(error) => write!(f, "Neither saved nor kept beside the files: {error}"),
            Self::File(file, error) => write!(f, "Not saved, but kept beside the files: {file}: {error}"),
        }
    }
}

impl Folder {
    /// Opens the level in `folder`; images are looked up there, then under `project`.
    ///
    /// # Errors
    /// A file that cannot be read, in words. What is in the files is not judged: a level that is refused can be opened.
    pub fn open(folder: &Path, project: &Path) -> Result<Opened, String> {
        Self::open_at(folder, project, Desk::alone)
    }

    /// The same, for an editor: of several of one level each keeps what is not saved in a place of its own.
    ///
    /// # Errors
    /// As [`Folder::open`].
    pub fn open_to_edit(folder: &Path, project: &Path) -> Result<Opened, String> {
        Self::open_at(folder, project, Desk::take)
    }

    fn open_at(folder: &Path, project: &Path, desk: fn(&Path) -> Desk) -> Result<Opened, String> {
        if !folder.is_dir() {
            return Err(format!("there is no folder {}", folder.display()));
        }
        let mut known = Vec::new();
        for table in Table::ALL {
            known.push(read_table(folder, *table).map_err(|error| format!("{}: {error}", table.file()))?);
        }
        let mut document = Document::new(|table| known[table.index()].clone());
        let desk = desk(folder);
        let kept = files::read_with(&desk.kept, KEPT_MOST, Links::Never)
            .ok()
            .and_then(|bytes| parse(&bytes))
            .filter(|kept| kept.0 != known);
        let folder = Self { folder: folder.to_path_buf(), project: project.to_path_buf(), known, desk: Arc::new(desk) };
        folder.measure(&mut document);
        Ok(Opened { document, folder, kept })
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.folder
    }

    /// Whether another editor has the level open.
    pub fn is_shared(&self) -> bool {
        self.desk.shared
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

    /// The pictures that cells can name: those beside the tables, then those of the project's assets.
    pub fn pictures(&self) -> Vec<String> {
        let mut own = pictures_in(&self.folder, "", 0);
        own.retain(|name| name != BACKGROUND);
        own.extend(pictures_in(&self.project.join(ASSETS), &format!("{ASSETS}/"), ASSETS_DEPTH));
        own.truncate(MOST_PICTURES);
        own
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

    /// Takes over what other programs have written, where the document has nothing else there; the files that were edited here, too, and
    /// are left as they are. Whether anything was taken over.
    pub fn take_over(&mut self, document: &mut Document) -> (bool, Vec<Table>) {
        let (mut taken, mut both) = (false, Vec::new());
        for (table, bytes) in self.changed() {
            let edited = document.bytes(table) != self.known[table.index()].as_deref();
            if document.bytes(table) == bytes.as_deref() {
                self.known[table.index()] = bytes;
            } else if edited {
                both.push(table);
            } else {
                document.replace(table, bytes.clone());
                (self.known[table.index()], taken) = (bytes, true);
            }
        }
        (taken, both)
    }

    /// Lets one side's files stay where both have written; a copy of the other side's is left beside each, and is one undo away. The names of
    /// the copies.
    ///
    /// # Errors
    /// A copy that cannot be written, in words; nothing has changed then.
    pub fn settle(&mut self, document: &mut Document, side: Side) -> Result<Vec<String>, String> {
        self.take_over(document);
        let (both, mut copies) = (self.changed(), Vec::new());
        let mut files: [Vec<Option<Vec<u8>>>; 2] = [(); 2].map(|()| document.all_bytes());
        for (table, bytes) in &both {
            files[1][table.index()].clone_from(bytes);
            let (word, left) = match side {
                Side::Mine => ("theirs", bytes.as_deref()),
                Side::Theirs => ("mine", document.bytes(*table)),
            };
            if let Some(left) = left {
                let stem = format!("{}.{word}", table.file());
                copies.push(self.copy_beside(&stem, left).map_err(|error| format!("{stem}: {error}"))?);
            }
        }
        let [mine, theirs] = files;
        document.replace_all(theirs);
        if side == Side::Mine {
            document.replace_all(mine);
        }
        both.into_iter().for_each(|(table, bytes)| self.known[table.index()] = bytes);
        Ok(copies)
    }

    /// Writes a new file into the folder, whose name ends with the first number that no other has; that name.
    fn copy_beside(&self, stem: &str, bytes: &[u8]) -> io::Result<String> {
        for number in 1..=MOST_COPIES {
            let name = format!("{stem}-{number}");
            match files::create(&self.folder.join(&name), bytes) {
                Ok(()) => return Ok(name),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::ErrorKind::AlreadyExists.into())
    }

    /// Writes every file that has changed.
    ///
    /// # Errors
    /// See [`SaveError`]; nothing of the document is lost.
    pub fn save(&mut self, document: &Document) -> Result<(), SaveError> {
        let edited = |table: &Table| document.bytes(*table) != self.known[table.index()].as_deref();
        let changed: Vec<Table> = Table::ALL.iter().copied().filter(edited).collect();
        let theirs: Vec<Table> =
            self.changed().into_iter().filter(|(table, _)| changed.contains(table)).map(|(table, _)| table).collect();
        if !theirs.is_empty() {
            return Err(SaveError::Changed(theirs));
        }
        self.write_kept(document, true).map_err(SaveError::NotKept)?;
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
        let _ = fs::remove_file(&self.desk.kept);
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
        let mut kept = Replacement::begin(&self.desk.kept, Links::Never)?;
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

/// The pictures in a folder, and in the folders in it down to that depth, in order; each with its path behind `before`.
fn pictures_in(folder: &Path, before: &str, depth: u32) -> Vec<String> {
    let mut entries: Vec<_> = fs::read_dir(folder).into_iter().flatten().flatten().take(MOST_PICTURES).collect();
    entries.sort_unstable_by_key(fs::DirEntry::file_name);
    let mut names = Vec::new();
    for entry in entries {
        let Ok(name) = entry.file_name().into_string() else { continue };
        if name.to_ascii_lowercase().ends_with(".png") {
            names.push(format!("{before}{name}"));
        } else if depth > 0 && entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            names.extend(pictures_in(&entry.path(), &format!("{before}{name}/"), depth - 1));
        }
    }
    names
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
