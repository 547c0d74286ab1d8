//! `resultant check [LEVEL…]`: loads levels, and says what is in them or everything that is wrong with them.

use super::project::Project;
use super::stop::{CommandError, Readers, Status, shown};
use crate::game::DryRun;
use crate::level::schema::{Count, Kind};
use crate::level::{self, Level, Loaded, Problem};
use crate::pack;
use crate::physics::World;
use std::ffi::{OsStr, OsString};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[derive(clap::Args, Debug, Default)]
pub struct CheckArgs {
    /// Names under levels/, or levels' folders; without any, all levels
    #[arg(value_name = "LEVEL")]
    pub levels: Vec<OsString>,
}

/// Results go to `out`, problems and warnings to standard error.
/// Errors: a level that does not exist, or no level at all; nothing is checked then.
pub fn run(args: &CheckArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    check(args, project, out, &mut Readers::of(io::stderr().lock()))
}

fn check(args: &CheckArgs, project: &Project, out: &mut dyn Write, err: &mut dyn Write) -> Result<Status, CommandError> {
    let all = || level::list(&project.levels()).into_iter().map(OsString::from).collect();
    let names: Vec<OsString> = if args.levels.is_empty() { all() } else { args.levels.clone() };
    if names.is_empty() {
        let levels = project.levels();
        let why = std::fs::read_dir(&levels).err().map_or(String::new(), |error| format!(", which cannot be read: {error}"));
        return Err(CommandError::Refused(format!("no level folder in {}{why}", levels.display())));
    }
    let folders = names.iter().map(|name| project.level_folder(name)).collect::<Result<Vec<PathBuf>, CommandError>>()?;
    let (mut status, mut refused) = (Status::Done, 0);
    for (name, folder) in names.iter().zip(folders) {
        let name = called(name, &folder);
        let made = level::load(&folder, project.root()).map_err(|problems| (problems.len(), level::listed(&problems))).and_then(
            |loaded| match World::new(loaded.level.world_def()) {
                Ok(world) => Ok((loaded, world)),
                Err(refusal) => Err((1, vec![refusal.to_string()])),
            },
        );
        match made {
            Ok((mut loaded, world)) => {
                let level = Arc::new(loaded.level.clone());
                loaded.warnings.extend(pack::stale(&folder, &level));
                loaded.warnings.extend(dry_run(&level));
                describe(&name, &loaded, &world, out, err)?;
            }
            Err((problems, lines)) => {
                (status, refused) = (Status::Wrong, refused + 1);
                writeln!(err, "{name}: refused, {}", count(problems, "problem", "problems"))?;
                lines.iter().try_for_each(|line| writeln!(err, "{line}"))?;
            }
        }
    }
    if names.len() > 1 {
        writeln!(out, "{} levels: {} ok, {refused} refused", names.len(), names.len() - refused)?;
    }
    Ok(status)
}

/// A level that needs no pilot, or leaves none a chance.
fn dry_run(level: &Arc<Level>) -> Option<Problem> {
    let (found, expected) = match DryRun::of(level).ok()? {
        DryRun::Waits => return None,
        DryRun::Won(time) => (format!("a level that is won after {time:.2} s without a key"), "something to do"),
        DryRun::Lost(time, by) => {
            (format!("a level that is lost after {time:.2} s without a key: {by}"), "a start that waits for the pilot")
        }
        DryRun::Stuck => ("a ship that no key moves".to_owned(), "a start from which the engine moves it"),
    };
    Some(Problem { file: "player.csv".to_owned(), line: 0, column: String::new(), found, expected: expected.to_owned() })
}

/// A level's name as on the command line; for a place such as `.`, the name of its folder.
fn called(name: &OsStr, folder: &Path) -> String {
    let place = Path::new(name).file_name().is_none();
    let resolved = folder.canonicalize().ok().filter(|_| place);
    let own = resolved.as_deref().and_then(Path::file_name).map(|own| own.to_string_lossy().into_owned());
    shown(own.unwrap_or_else(|| name.to_string_lossy().into_owned()))
}

/// Prints a good level's content, its parts of the physics model, and its warnings.
fn describe(name: &str, loaded: &Loaded, world: &World, out: &mut dyn Write, err: &mut dyn Write) -> io::Result<()> {
    for warning in level::listed(&loaded.warnings) {
        writeln!(err, "{name}: warning: {warning}")?;
    }
    writeln!(out, "{name}: ok")?;
    writeln!(out, "  contents: {}", contents(&loaded.level))?;
    if !loaded.dialects.is_empty() {
        let files: Vec<String> = loaded.dialects.iter().map(|(file, words)| format!("{file}: {words}")).collect();
        writeln!(out, "  dialects: {}", files.join("; "))?;
    }
    writeln!(out, "  physics: {}", world.plan().parts().join("; "))
}

fn contents(level: &Level) -> String {
    let mut counts: Vec<&Count> = Kind::ALL.iter().flat_map(|kind| kind.schema().counts).collect();
    counts.sort_by_key(|count| !count.at_none);
    let counted = |Count { one, many, at_none, of }: &Count| {
        let n = of(level);
        (n > 0 || *at_none).then(|| count(n, one, many))
    };
    counts.into_iter().filter_map(counted).collect::<Vec<_>>().join(", ")
}

fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
