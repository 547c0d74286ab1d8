//! The texts of the sheets, `docs/lessons`: each suggested change, and a level with that change.

use crate::support::shipped::project;
use resultant::files::EXPERIMENTS;
use resultant::level::{self, Files, Level};
use sheets::Lesson;
use std::collections::BTreeMap;
use std::io;
use std::path::PathBuf;

pub fn text(name: &str) -> String {
    let path = project().join("docs/lessons").join(format!("{name}.md"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Its parts, without the figures, which the list of experiments has.
pub fn lesson(text: &str) -> Lesson<'_> {
    Lesson::read(text, "").unwrap_or_else(|problem| panic!("{problem} in {text}"))
}

/// A suggestion: the change, and the rows of its figures, each with its answer.
#[derive(Debug)]
pub struct Variation<'a> {
    pub change: &'a str,
    pub rows: Vec<[&'a str; 2]>,
}

/// All suggestions of a sheet; a row without a change goes on with the one above.
pub fn variations(text: &str) -> Vec<Variation<'_>> {
    let mut found: Vec<Variation> = Vec::new();
    for [change, what, answer] in lesson(text).changes {
        if !change.is_empty() {
            found.push(Variation { change, rows: Vec::new() });
        }
        found.last_mut().expect("the first row has a change").rows.push([what, answer]);
    }
    found
}

struct Tables(BTreeMap<String, String>);

impl Files for Tables {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        self.0.get(name).map(|text| text.clone().into_bytes()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn project_file(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

pub fn level(name: &str, change: &str) -> Level {
    let folder = project().join(EXPERIMENTS).join(name);
    let files = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let read = |path: PathBuf| {
        let file = path.file_name().unwrap().to_str().unwrap().to_owned();
        (file, std::fs::read_to_string(&path).unwrap())
    };
    let mut tables = Tables(files.map(|entry| read(entry.unwrap().path())).collect());
    for part in change.split("; ").filter(|part| !part.is_empty()) {
        tables.edit(part).unwrap_or_else(|| panic!("{name}: {part:?} says no change of a table"));
    }
    let loaded = level::read(name, &tables).unwrap_or_else(|problems| panic!("{name}, {change}: {problems:?}"));
    assert!(loaded.warnings.is_empty(), "{name}, {change}: {:?}", loaded.warnings);
    loaded.level
}

impl Tables {
    /// Makes a change that reads `COLUMN` VALUE (REMARK) in row N of `FILE`, … in every row of `FILE`, or … in `constants.csv`.
    fn edit(&mut self, part: &str) -> Option<()> {
        let (what, place) = part.rsplit_once(" in ")?;
        let (column, value) = what.strip_prefix('`')?.split_once("` ")?;
        let value = value.split_once(" (").map_or(value, |(value, _)| value);
        let (row, file) = place.split_once(" of ").unwrap_or(("", place));
        let text = self.0.get_mut(file.trim_matches('`'))?;
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let mut rows = (0..lines.len()).filter(|i| !lines[*i].starts_with('#') && !lines[*i].is_empty());
        let head: Vec<String> = lines[rows.next()?].split(',').map(str::to_owned).collect();
        let rows: Vec<usize> = rows.collect();
        if head == ["name", "value"] {
            let there = rows.into_iter().find(|i| lines[*i].split(',').next() == Some(column));
            lines[there?] = format!("{column},{value}");
        } else {
            let at = head.iter().position(|name| name == column)?;
            let wanted = match row {
                "every row" => rows,
                row => vec![*rows.get(row.strip_prefix("row ")?.parse::<usize>().ok()?.checked_sub(1)?)?],
            };
            for i in wanted {
                let mut cells: Vec<&str> = lines[i].split(',').collect();
                *cells.get_mut(at)? = value;
                lines[i] = cells.join(",");
            }
        }
        *text = lines.join("\n") + "\n";
        Some(())
    }
}
