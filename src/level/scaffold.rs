//! New folders for levels: made, copied, renamed. A folder has a hidden name, which no list of levels shows, until it is whole.

use super::document::{Document, Table};
use super::{folder::judge_name, problem::quoted, schema::sample};
use crate::files::{self, FileKind, create_folder, put};
use crate::words::tr;
use std::{io, path::Path};

const MOST_NAMES: usize = 1000;

/// The files of a first level: a floor, a wall, and a pad behind it.
pub const FIRST: [(&str, &str); 4] = [
    BARE[0],
    BARE[1],
    ("world.csv", "x,y,width,height,material\n0,680,1280,40,Asphalt\n560,500,160,180,Wood\n"),
    ("objectives.csv", "kind,x,y,width,height,hold\nPLAYER,1000,670,120,10,1\n"),
];

/// The files of a level that shows every table and column, but those of links, stars, hints and decoration.
pub fn show() -> Vec<(&'static str, String)> {
    Table::ALL.iter().filter_map(|table| Some((table.file(), sample(*table)?))).collect()
}

/// The files of a room with the ship alone, for the editor.
pub const BARE: [(&str, &str); 2] = [
    ("constants.csv", "name,value\ntitle,{name}\nwidth,1280\nheight,720\n"),
    ("player.csv", "x,y,mass,fuel,thrust\n150,640,100,500,2500\n"),
];

/// Makes `levels/NAME/` with these files, in which `{name}` stands for the name.
/// Errors: the folder exists already, or the disk refuses; no part of it is left behind.
pub fn make(levels: &Path, name: &str, files: &[(&str, impl AsRef<str>)]) -> io::Result<()> {
    build(levels, name, |folder| {
        files.iter().try_for_each(|(file, text)| put(&folder.join(file), text.as_ref().replace("{name}", name).as_bytes()))
    })
}

/// Makes `levels/NAME/` with the files of another level's folder, without hidden files and folders.
pub fn copy(from: &Path, levels: &Path, name: &str) -> io::Result<()> {
    build(levels, name, |folder| copy_files(from, folder, |_| true))
}

fn copy_files(from: &Path, to: &Path, wanted: impl Fn(&str) -> bool) -> io::Result<()> {
    for file in files::names(from)? {
        let (name, path) = (file.to_string_lossy(), from.join(&file));
        if !name.starts_with('.') && wanted(&name) && files::look(&path)?.kind == FileKind::File {
            files::copy(&path, &to.join(&file))?;
        }
    }
    Ok(())
}

/// As [`copy`], with the tables as they stand in a document of that level.
pub fn copy_edited(from: &Path, levels: &Path, name: &str, document: &Document) -> io::Result<()> {
    build(levels, name, |folder| {
        copy_files(from, folder, |file| Table::of_file(file).is_none())?;
        let tables = Table::ALL.iter().filter_map(|table| Some((table.file(), document.bytes(*table)?)));
        tables.into_iter().try_for_each(|(file, bytes)| put(&folder.join(file), bytes))
    })
}

/// A free name for a level that is made of another one: the other's name with `word` behind it.
pub fn free_name(levels: &Path, of: &str, word: &str) -> String {
    let names = |stem: String| (1_u32..).map(move |n| if n == 1 { stem.clone() } else { format!("{stem}-{n}") });
    let free = |name: &String| judge(levels, name).is_ok();
    // The plain word where the other name is no word, or too long for one more.
    let of_its_own = names(format!("{of}-{word}")).take(MOST_NAMES).find(free);
    of_its_own.or_else(|| names(word.to_owned()).find(free)).unwrap_or_default()
}

/// Errors: a folder has that name already, or the disk refuses; the old name stays then.
pub fn rename(levels: &Path, from: &str, to: &str) -> io::Result<()> {
    if taken(levels, to).is_some_and(|other| other != from) {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    files::rename(&levels.join(from), &levels.join(to))
}

/// Errors: the reason why a new level may not have that name, in words.
pub fn judge(levels: &Path, name: &str) -> Result<(), String> {
    judge_name(name).map_err(|fault| tr!("{name}: expected {expected}", name = quoted(name), expected = fault.expected()))?;
    match taken(levels, name) {
        None => Ok(()),
        Some(other) if other == name => Err(tr!("{name}: there is one of that name already", name = quoted(name))),
        Some(other) => {
            let (name, other) = (quoted(name), quoted(&other));
            Err(tr!("{name}: {other} is there already, the same folder on some systems", name, other))
        }
    }
}

/// The entry of `levels` that has that name in some case: on some systems `Tower` and `tower` are one folder.
pub fn taken(levels: &Path, name: &str) -> Option<String> {
    if files::is_taken(&levels.join(name)) {
        return Some(name.to_owned());
    }
    let lower = name.to_lowercase();
    files::text_names(levels).into_iter().find(|other| other.to_lowercase() == lower)
}

fn build(levels: &Path, name: &str, fill: impl FnOnce(&Path) -> io::Result<()>) -> io::Result<()> {
    if taken(levels, name).is_some() {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    create_folder(&levels.join(name), fill)
}
