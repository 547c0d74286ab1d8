//! `resultant import MAP`: a map of the editor Tiled becomes a level; with `--watch` again whenever it is saved.

use super::project::Project;
use super::{CommandError, Status, shown};
use crate::import::{self, SourceFile};
use crate::level;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Between two looks at the files of a map.
const LOOK: Duration = Duration::from_millis(250);

#[derive(clap::Args, Debug)]
pub struct ImportArgs {
    /// A map: .tmj or .tmx, orthogonal
    #[arg(value_name = "MAP")]
    map: PathBuf,
    /// The level's name [default: that of the map's file]
    #[arg(long = "as", value_name = "NAME")]
    name: Option<String>,
    /// Stay, and import again whenever the map or one of its files is saved
    #[arg(long)]
    watch: bool,
}

/// Errors: a map that is refused, with layer and object, or a level of that name that no import made; nothing is written then.
pub fn run(args: &ImportArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let stem = args.map.file_stem().unwrap_or_default().to_string_lossy();
    let name = args.name.clone().unwrap_or_else(|| stem.into_owned());
    if let Err(fault) = level::judge_name(&name) {
        let expected = fault.expected();
        return Err(CommandError::Refused(format!(
            "a level cannot be named {name:?}: expected {expected}; --as NAME gives another"
        )));
    }
    loop {
        let (done, sources) = once(&args.map, &name, project, out)?;
        match done {
            Err(problems) if !args.watch => return Err(CommandError::Refused(lines(&problems))),
            Ok(()) if !args.watch => return Ok(Status::Done),
            // A closed standard error does not stop the watch.
            Err(problems) => _ = writeln!(io::stderr(), "{}", lines(&problems)),
            Ok(()) => out.flush()?,
        }
        while sources.iter().all(SourceFile::is_last) {
            std::thread::sleep(LOOK);
        }
    }
}

fn lines(problems: &[String]) -> String {
    problems.iter().map(shown).collect::<Vec<_>>().join("\n")
}

/// What became of it, and the files that were read.
type Once = (Result<(), Vec<String>>, Vec<SourceFile>);

fn once(map: &Path, name: &str, project: &Project, out: &mut dyn Write) -> Result<Once, CommandError> {
    let imported = match import::read(map, name) {
        Ok(imported) => imported,
        Err((problems, sources)) => return Ok((Err(problems), sources)),
    };
    let in_map = |line: String| if line.starts_with(&*map.to_string_lossy()) { line } else { format!("{}: {line}", map.display()) };
    let loaded = match imported.judge(project.root()) {
        Ok(loaded) => loaded,
        Err(problems) => return Ok((Err(problems.into_iter().map(in_map).collect()), imported.sources)),
    };
    let folder = match imported.write(&project.levels()) {
        Ok(folder) => folder,
        Err(problem) => return Ok((Err(vec![problem]), imported.sources)),
    };
    let warnings = loaded.warnings.iter().map(|warning| format!("warning: {}", in_map(imported.placed(warning))));
    for line in imported.left.iter().cloned().chain(warnings) {
        let _ = writeln!(io::stderr(), "{}", shown(line));
    }
    writeln!(out, "{}: {} files", shown(folder.display()), imported.package.files.len())?;
    Ok((Ok(()), imported.sources))
}
