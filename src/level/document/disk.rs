//! The only part of the document that knows the disk. Each file is replaced whole; `.autosave` in the level's folder, which the loader passes over,
//! holds all edits from before the first replacement until after the last: no edit is lost. One editor of a level at a time.

use super::model::{self, Document, Kept};
use crate::files::{self, Lock, Manner, Symlinks};
use crate::level::folder::{LevelDisk, load_from};
use crate::level::image::{BACKGROUND, Files, png_size};
use crate::level::read::{Loaded, read, read_unfinished};
use crate::{level::problem::Problem, level::schema::Table, physics::DVec2, words::tr};
use std::path::{Path, PathBuf};
use std::{collections::BTreeMap, env, fmt, io, process, sync::Arc, time::Duration};

const KEPT: &str = ".autosave";
const ASSETS: &str = "assets";
const ASSETS_DEPTH: u32 = 3;
/// The most pictures that are offered, and the most entries of one folder.
const MOST_PICTURES: usize = 1000;

#[derive(Clone, Debug)]
pub struct LevelFolder {
    folder: PathBuf,
    project: PathBuf,
    /// The files' bytes when they were opened or saved last, by [`Table`].
    known: Vec<Option<Vec<u8>>>,
    _lock: Option<Arc<EditorLock>>,
}

/// The side whose files stay where another program has written into files that are edited here: the document's or the other program's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeptSide {
    Mine,
    Theirs,
}

#[derive(Debug)]
pub struct Opened {
    pub document: Document,
    pub folder: LevelFolder,
    /// Edits that an earlier editor has not saved, where they differ from the files.
    pub kept: Option<Kept>,
}

#[derive(Debug)]
pub enum LevelSaveError {
    /// Another program has written these files: no file was written.
    Changed(Vec<Table>),
    /// The edits cannot even be kept beside the files: no file was written.
    NotKept(io::Error),
    /// The system refused that file; the files before it are written, and all edits are kept beside them.
    File(String, io::Error),
}

impl fmt::Display for LevelSaveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Changed(tables) => {
                let files: Vec<&str> = tables.iter().map(|table| table.file()).collect();
                f.write_str(&tr!("Not saved: another program has changed {files}", files = files.join(", ")))
            }
            Self::NotKept(error) => f.write_str(&tr!("Neither saved nor kept beside the files: {error}", error)),
            Self::File(file, error) => f.write_str(&tr!("Not saved, but kept beside the files: {file}: {error}", file, error)),
        }
    }
}

impl LevelFolder {
    /// Images are looked up in `folder`, then under `project`. A level that the loader refuses can be opened. Errors: an unreadable file, in words.
    pub fn open(folder: &Path, project: &Path) -> Result<Opened, String> {
        Self::open_with(folder, project, None)
    }

    /// As [`LevelFolder::open`], for the level's only editor. Errors: another one has it open, by its user and process.
    pub fn open_to_edit(folder: &Path, project: &Path) -> Result<Opened, String> {
        let lock = if files::is_folder(folder) { EditorLock::take(folder)? } else { None };
        Self::open_with(folder, project, lock)
    }

    fn open_with(folder: &Path, project: &Path, lock: Option<EditorLock>) -> Result<Opened, String> {
        if !files::is_folder(folder) {
            return Err(tr!("there is no folder {path}", path = folder.display()));
        }
        let mut known = Vec::new();
        for table in Table::ALL {
            known.push(read_table(folder, *table).map_err(|error| format!("{}: {error}", table.file()))?);
        }
        let mut document = Document::new(|table| known[table.index()].clone());
        let kept = files::read_with(&folder.join(KEPT), model::MOST, Symlinks::Never).ok();
        let kept = kept.and_then(|bytes| model::parse(&bytes)).filter(|kept| kept.0 != known);
        let folder = Self { folder: folder.to_path_buf(), project: project.to_path_buf(), known, _lock: lock.map(Arc::new) };
        folder.measure(&mut document);
        Ok(Opened { document, folder, kept })
    }

    pub fn path(&self) -> &Path {
        &self.folder
    }

    pub fn name(&self) -> String {
        let resolved = files::resolve(&self.folder).unwrap_or_else(|_| self.folder.clone());
        resolved.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    }

    fn disk(&self) -> LevelDisk<'_> {
        LevelDisk { folder: &self.folder, project: &self.project }
    }

    pub fn measure(&self, document: &mut Document) {
        let side = |(width, height)| DVec2::new(width, height);
        document.tell_sizes(BTreeMap::new(), None);
        let background = png_size(self.disk().level_file(BACKGROUND), BACKGROUND).ok().map(side);
        let size = |name: &str| png_size(files::read(&self.picture(name), files::PICTURE), name).ok().map(side);
        let pictures = document.unknown_pictures().into_iter().filter_map(|name| Some((name.clone(), size(&name)?))).collect();
        document.tell_sizes(pictures, background);
    }

    pub fn picture(&self, name: &str) -> PathBuf {
        self.disk().picture(Path::new(&name.replace('\\', "/")))
    }

    /// The pictures that cells can name: first in the level's folder, then in the project's assets.
    pub fn pictures(&self) -> Vec<String> {
        let mut own = pictures_in(&self.folder, "", 0);
        own.retain(|name| name != BACKGROUND);
        own.extend(pictures_in(&self.project.join(ASSETS), &format!("{ASSETS}/"), ASSETS_DEPTH));
        own.truncate(MOST_PICTURES);
        own
    }

    pub fn background(&self) -> Option<PathBuf> {
        Some(self.folder.join(BACKGROUND)).filter(|path| files::is_file(path))
    }

    /// Loads the document from memory.
    pub fn check(&self, document: &Document) -> Result<Loaded, Vec<Problem>> {
        let disk = self.disk();
        load_from(&disk, &document.over(&disk), read)
    }

    /// As [`load_unfinished`](crate::level::load_unfinished), from memory.
    pub fn unfinished(&self, document: &Document) -> Result<Loaded, Vec<Problem>> {
        let disk = self.disk();
        load_from(&disk, &document.over(&disk), read_unfinished)
    }

    pub fn is_unsaved(&self, document: &Document) -> bool {
        Table::ALL.iter().any(|table| self.is_edited(*table, document))
    }

    fn is_edited(&self, table: Table, document: &Document) -> bool {
        document.bytes(table) != self.known[table.index()].as_deref()
    }

    /// The files that another program has changed since they were opened or saved, with their bytes now; an unreadable file counts as unchanged.
    pub fn changed(&self) -> Vec<(Table, Option<Vec<u8>>)> {
        let now = Table::ALL.iter().filter_map(|table| Some((*table, read_table(&self.folder, *table).ok()?)));
        now.filter(|(table, bytes)| *bytes != self.known[table.index()]).collect()
    }

    /// Takes over the changes of other programs in files without edits. Returns whether there were any, and the changed files with edits, which stay.
    pub fn take_over(&mut self, document: &mut Document) -> (bool, Vec<Table>) {
        let (mut taken, mut both) = (false, Vec::new());
        for (table, bytes) in self.changed() {
            if document.bytes(table) == bytes.as_deref() {
                self.known[table.index()] = bytes;
            } else if self.is_edited(table, document) {
                both.push(table);
            } else {
                document.replace(table, bytes.clone());
                (self.known[table.index()], taken) = (bytes, true);
            }
        }
        (taken, both)
    }

    /// Keeps one side's files where both have written; a copy of the other side's is left beside each, and is one undo away. Returns the names of the
    /// copies. Errors: a copy that cannot be written, in words; the document stays.
    pub fn settle(&mut self, document: &mut Document, side: KeptSide) -> Result<Vec<String>, String> {
        self.take_over(document);
        let (both, mut copies) = (self.changed(), Vec::new());
        let mut files: [Vec<Option<Vec<u8>>>; 2] = [(); 2].map(|()| document.all_bytes());
        for (table, bytes) in &both {
            files[1][table.index()].clone_from(bytes);
            let (word, left) = match side {
                KeptSide::Mine => ("theirs", bytes.as_deref()),
                KeptSide::Theirs => ("mine", document.bytes(*table)),
            };
            if let Some(left) = left {
                let stem = format!("{}.{word}", table.file());
                let copy = files::create_numbered(&self.folder.join(&stem), left).map_err(|error| format!("{stem}: {error}"))?;
                copies.extend(copy.file_name().map(|name| name.to_string_lossy().into_owned()));
            }
        }
        let [mine, theirs] = files;
        document.replace_all(theirs);
        if side == KeptSide::Mine {
            document.replace_all(mine);
        }
        both.into_iter().for_each(|(table, bytes)| self.known[table.index()] = bytes);
        Ok(copies)
    }

    /// Writes every file that has changed. Errors: see [`LevelSaveError`]; no edit is lost.
    pub fn save(&mut self, document: &Document) -> Result<(), LevelSaveError> {
        let changed: Vec<Table> = Table::ALL.iter().copied().filter(|table| self.is_edited(*table, document)).collect();
        let theirs = self.changed().into_iter().map(|(table, _)| table).filter(|table| changed.contains(table));
        let theirs: Vec<Table> = theirs.collect();
        if !theirs.is_empty() {
            return Err(LevelSaveError::Changed(theirs));
        }
        self.write_kept(document, true).map_err(LevelSaveError::NotKept)?;
        for table in changed {
            let path = self.folder.join(table.file());
            let written = match document.bytes(table) {
                Some(bytes) => files::replace(&path, bytes, Symlinks::Followed),
                None => files::remove(&path),
            };
            written.map_err(|error| LevelSaveError::File(table.file().to_owned(), error))?;
            self.known[table.index()] = document.bytes(table).map(<[u8]>::to_vec);
        }
        files::sync_folder(&self.folder);
        self.forget();
        Ok(())
    }

    /// Keeps unsaved edits beside the files, in case the program ends without a save. Errors: the error of the system.
    pub fn keep(&self, document: &Document) -> io::Result<()> {
        if self.is_unsaved(document) {
            return self.write_kept(document, false);
        }
        self.forget();
        Ok(())
    }

    pub fn forget(&self) {
        let _ = files::remove(&self.folder.join(KEPT));
    }

    fn write_kept(&self, document: &Document, durable: bool) -> io::Result<()> {
        let manner = Manner { links: Symlinks::Never, durable, shared: false };
        files::replace_with(&self.folder.join(KEPT), &model::encoded(document), manner)
    }
}

fn read_table(folder: &Path, table: Table) -> io::Result<Option<Vec<u8>>> {
    files::read_if_there(&folder.join(table.file()), files::LEVEL_TABLE)
}

/// The pictures in a folder and its folders down to that depth, in order, each as a path that begins with `before`.
fn pictures_in(folder: &Path, before: &str, depth: u32) -> Vec<String> {
    let mut names = Vec::new();
    for name in files::text_names(folder).into_iter().take(MOST_PICTURES) {
        if name.to_ascii_lowercase().ends_with(".png") {
            names.push(format!("{before}{name}"));
        } else if depth > 0 && !files::is_link(&folder.join(&name)) && files::is_folder(&folder.join(&name)) {
            names.extend(pictures_in(&folder.join(&name), &format!("{before}{name}/"), depth - 1));
        }
    }
    names
}

/// Bytes of a holder's name that are read.
const MOST: u64 = 200;

/// Held until the editor ends. The system frees it when the process ends.
#[derive(Debug)]
struct EditorLock {
    _lock: Lock,
    path: PathBuf,
}

impl EditorLock {
    /// `None` in a folder that takes no lock, such as a read-only one. Errors: another editor has the level, by its user and process, in words.
    pub fn take(folder: &Path) -> Result<Option<Self>, String> {
        let path = folder.join(".autosave.lock");
        match Lock::wait(&path, Duration::ZERO) {
            Ok(lock) => {
                let user = ["USER", "USERNAME"].iter().find_map(|name| env::var(name).ok()).unwrap_or_default();
                // A page has no number, and to ask for one ends it.
                let who = if cfg!(target_family = "wasm") { user } else { format!("{user} ({})", process::id()) };
                // Without it the refusal names nobody.
                let _ = lock.sign(&who);
                Ok(Some(Self { _lock: lock, path }))
            }
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => {
                let bytes = files::read_with(&path, MOST, Symlinks::Never).unwrap_or_default();
                let who: String = String::from_utf8_lossy(&bytes).chars().filter(|letter| !letter.is_control()).collect();
                Err(tr!("another editor has this level open: {who}. Close it there, and try again.", who))
            }
            Err(_) => Ok(None),
        }
    }
}

impl Drop for EditorLock {
    fn drop(&mut self) {
        // The next editor takes over a file that stays.
        let _ = files::remove(&self.path);
    }
}
