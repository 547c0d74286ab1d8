//! `resultant import MAP`: a map of the editor Tiled becomes a level; with `--watch` again whenever it is saved.

use super::project::Project;
use super::{CommandError, Status, shown};
use crate::import::{self, SourceFile, Written};
use crate::level;
use std::io::{self, Write};
use std::path::PathBuf;
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
        let (done, sources) = import::written(&args.map, &name, &project.levels(), project.root());
        match done {
            Err(problems) if !args.watch => return Err(CommandError::Refused(lines(&problems))),
            // A closed standard error does not stop the watch.
            Err(problems) => _ = writeln!(io::stderr(), "{}", lines(&problems)),
            Ok(Written { folder, files, said }) => {
                if !said.is_empty() {
                    let _ = writeln!(io::stderr(), "{}", lines(&said));
                }
                writeln!(out, "{}: {files} files", shown(folder.display()))?;
                out.flush()?;
            }
        }
        if !args.watch {
            return Ok(Status::Done);
        }
        while sources.iter().all(SourceFile::is_last) {
            std::thread::sleep(LOOK);
        }
    }
}

fn lines(problems: &[String]) -> String {
    problems.iter().map(shown).collect::<Vec<_>>().join("\n")
}
