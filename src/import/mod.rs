//! A map of the editor Tiled becomes a level: objects the rows of the table that their class names, tiles that are solid merged rectangles,
//! pictures copies. One way: the level's folder says which of its files an import made, and the next one replaces these alone.

mod map;
mod objects;
mod tiled;

use crate::files::{self, Manner, Symlinks};
use crate::level::{self, Loaded, Problem, scaffold};
use crate::pack::{self, Installed, Package};
use crate::{level::schema::Table, words::tr};
use map::Reader;
use std::path::{Path, PathBuf};
use std::{collections::BTreeMap, time::SystemTime};

/// Lists the files of a level that an import made.
const LIST: &str = "imported.txt";
const HEAD: &str = "Made by `resultant import`. The next import replaces these files:";

/// A level, and where its rows come from.
struct Imported {
    package: Package,
    /// By file and line the layer and object.
    origins: BTreeMap<(&'static str, usize), String>,
    /// The layers that say nothing of a level, in words.
    left: Vec<String>,
    sources: Vec<SourceFile>,
}

/// A file that was read, and when it had been saved, with its size.
#[derive(Clone, Debug)]
pub struct SourceFile(PathBuf, Option<(SystemTime, u64)>);

impl SourceFile {
    fn now(path: &Path) -> Self {
        let file = std::fs::metadata(path).and_then(|file| Ok((file.modified()?, file.len())));
        Self(path.to_owned(), file.ok())
    }

    /// Whether it has not been saved since.
    pub fn is_last(&self) -> bool {
        Self::now(&self.0).1 == self.1
    }
}

/// A level of a map, in its folder.
#[derive(Debug)]
pub struct ImportedLevel {
    pub folder: PathBuf,
    /// How many.
    pub files: usize,
    /// What of the map is left out, and the level's warnings, a line each.
    pub said: Vec<String>,
}

/// Takes in a file that was handed to the game: a map as a level of that name, or a level as one file. Errors: every problem, a line each; nothing is
/// written then.
pub fn take_in(path: &Path, levels: &Path, project: &Path) -> Result<(Installed, Vec<String>), Vec<String>> {
    let named = |problem: &str| vec![format!("{}: {problem}", path.display())];
    let is = |wanted: &str| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(wanted));
    if is("zip") {
        return pack::install_file(path, levels, project).map(|installed| (installed, Vec::new()));
    }
    // A page has no folder in which the tile sets of a map would lie beside it.
    if cfg!(browser) {
        return Err(named(tr("expected a level as one file (.zip)")));
    }
    if !is("tmj") && !is("tmx") {
        return Err(named(tr("expected a level as one file (.zip), or a map of Tiled (.tmj, .tmx)")));
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    level::judge_name(&name)
        .map_err(|fault| named(&tr!("a level cannot have this name: expected {expected}", expected = fault.expected())))?;
    written(path, &name, levels, project).0.map(|written| (Installed::New(written.folder), written.said))
}

/// Makes a level of a map; `name` is the level's. With it the files that were read. Errors: every problem, a line each, with the layer and the
/// object; nothing is written then.
pub fn written(map: &Path, name: &str, levels: &Path, project: &Path) -> (Result<ImportedLevel, Vec<String>>, Vec<SourceFile>) {
    let imported = match read(map, name) {
        Ok(imported) => imported,
        Err((problems, sources)) => return (Err(problems), sources),
    };
    let in_map = |line: String| if line.starts_with(&*map.to_string_lossy()) { line } else { format!("{}: {line}", map.display()) };
    let done = imported.judge(project).map_err(|problems| problems.into_iter().map(in_map).collect()).and_then(|loaded| {
        let folder = imported.write(levels).map_err(|problem| vec![problem])?;
        let warnings = loaded.warnings.iter().map(|warning| format!("warning: {}", in_map(imported.placed(warning))));
        let said = imported.left.iter().cloned().chain(warnings).collect();
        Ok(ImportedLevel { folder, files: imported.package.files.len(), said })
    });
    (done, imported.sources)
}

/// Reads a map; `name` is the level's. Errors: every problem, a line each, with the layer and the object; and the files that were read.
fn read(path: &Path, name: &str) -> Result<Imported, (Vec<String>, Vec<SourceFile>)> {
    let mut reader = Reader::new(path);
    reader.read();
    let Reader { rows, pictures, problems, left, sources, .. } = reader;
    if !problems.is_empty() {
        return Err((problems, sources));
    }
    let (mut files, mut origins) = (pictures, BTreeMap::new());
    for table in Table::ALL.iter().filter(|table| rows.iter().any(|row| row.kind.table() == **table)) {
        let own: Vec<_> = rows.iter().filter(|row| row.kind.table() == *table).collect();
        // The kinds of a file with several have columns of their own, and no header.
        let columns = own[0].kind.schema().columns;
        let used = |column: &str| own.iter().any(|row| row.cells.contains_key(column));
        let header: Vec<&str> = columns.iter().filter(|column| column.required || used(column.name)).map(|it| it.name).collect();
        let mut text = if table.kinds().len() > 1 { String::new() } else { files::csv_line(&header) };
        let mut line = text.lines().count() + 1;
        for row in own {
            let names: Vec<&str> = match table.kinds().len() {
                1 => header.clone(),
                _ => row.kind.schema().columns.iter().map(|column| column.name).collect(),
            };
            let mut cells: Vec<&str> = names.iter().map(|name| row.cells.get(*name).map_or("", String::as_str)).collect();
            let least = row.kind.schema().columns.iter().filter(|column| column.required).count();
            while table.kinds().len() > 1 && cells.len() > least && cells.last() == Some(&"") {
                cells.pop();
            }
            origins.insert((table.file(), line), row.origin.clone());
            let written = files::csv_line(&cells);
            line += written.lines().count();
            text += &written;
        }
        files.insert(table.file().to_owned(), text.into_bytes());
    }
    let list: String = files.keys().map(|file| format!("{file}\n")).collect();
    files.insert(LIST.to_owned(), format!("{HEAD}\n{list}").into_bytes());
    Ok(Imported { package: Package { name: name.to_owned(), files }, origins, left, sources })
}

impl Imported {
    /// Judges it as a level. Errors: every problem, a line each, with the layer and the object that it comes from.
    fn judge(&self, project: &Path) -> Result<Loaded, Vec<String>> {
        pack::load(&self.package, project).map_err(|problems| problems.iter().map(|problem| self.placed(problem)).collect())
    }

    fn placed(&self, problem: &Problem) -> String {
        let origin = self.origins.iter().find(|((file, line), _)| *file == problem.file && *line == problem.line);
        let Some((_, origin)) = origin else { return problem.to_string() };
        let Problem { column, found, expected, .. } = problem;
        files::found_instead(&format!("{origin}: column {column:?}"), found, expected)
    }

    /// Writes it as `levels/NAME/`, a new level or one that an import made; whatever else lies there stays. The answer is its folder. Errors: a level
    /// of that name that no import made; the disk's, and each file is the old one or the new one.
    fn write(&self, levels: &Path) -> Result<PathBuf, String> {
        let Package { name, files } = &self.package;
        let folder = levels.join(name);
        let refused = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
        if scaffold::taken(levels, name).is_none() {
            let fill = |begun: &Path| files.iter().try_for_each(|(file, bytes)| files::put(&begun.join(file), bytes));
            return files::create_folder(&folder, fill).map(|()| folder.clone()).map_err(|error| refused(&folder, error));
        }
        let old = files::read_text(&folder.join(LIST), files::LEVEL_TABLE).unwrap_or_default();
        let Some(old) = old.strip_prefix(HEAD) else {
            let place = folder.display();
            return Err(format!("{place}: found a level that no import made, expected another name, which --as NAME gives"));
        };
        let manner = Manner { links: Symlinks::Never, durable: true, shared: false };
        // Pictures before the tables that name them.
        let (tables, rest): (Vec<_>, Vec<_>) = files.iter().partition(|(file, _)| file.ends_with(".csv"));
        for (file, bytes) in rest.into_iter().chain(tables) {
            let path = folder.join(file);
            if files::read(&path, bytes.len() as u64).is_ok_and(|there| there == *bytes) {
                continue;
            }
            files::replace_with(&path, bytes, manner).map_err(|error| refused(&path, error))?;
        }
        let plain = |file: &&str| !file.is_empty() && !file.contains(['/', '\\']) && !files.contains_key(*file);
        for gone in old.lines().filter(plain).map(|file| folder.join(file)).filter(|path| files::is_file(path)) {
            files::remove(&gone).map_err(|error| refused(&gone, error))?;
        }
        Ok(folder)
    }
}
