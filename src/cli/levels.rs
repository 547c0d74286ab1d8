//! `resultant check`, `new`, `prove`, `edit`, `pack`, `unpack` and `import`: what makes, judges and hands on levels.

use super::{CommandError, Readers, Status, project::Project, shown};
use crate::import::{self, ImportedLevel, SourceFile};
use crate::level::schema::{Count, Kind};
use crate::level::{self, Level, Loaded, NameFault, Problem};
use crate::pack::{self, Installed, Package};
use crate::{files, game::DryRun, physics::World};
use std::ffi::{OsStr, OsString};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{sync::Arc, time::Duration};

#[derive(clap::Args, Debug, Default)]
pub struct CheckArgs {
    /// Names under levels/, or levels' folders; without any, all levels
    #[arg(value_name = "LEVEL")]
    pub levels: Vec<OsString>,
}

/// Results go to `out`, problems and warnings to standard error. Errors: a level that does not exist, or no level at all; nothing is checked then.
pub fn check_levels(args: &CheckArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let err = &mut Readers::of(io::stderr().lock());
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
                let (proven, stale) = pack::proven(&folder, &level);
                loaded.warnings.extend(stale.into_iter().chain(dry_run(&level)));
                describe(&name, &loaded, &world, out, err)?;
                if !proven.is_empty() {
                    writeln!(out, "  proven: {}", proven.join(", "))?;
                }
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

#[derive(clap::Args, Debug)]
pub struct NewArgs {
    /// The level's name: up to 40 letters, digits, - and _
    pub name: String,
    /// A room that shows every table and column, not the few that a level needs
    #[arg(long)]
    show: bool,
}

fn judge_name(name: &str, help: &str) -> Result<(), CommandError> {
    let refused =
        |fault: NameFault| CommandError::Refused(format!("a level cannot be named {name:?}: expected {}{help}", fault.expected()));
    level::judge_name(name).map_err(refused)
}

/// Errors: a name that no level can have, an existing folder, or the disk's; nothing is left behind.
pub fn new_level(args: &NewArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let NewArgs { name, show } = args;
    judge_name(name, "")?;
    let levels = project.levels();
    let folder = levels.join(name);
    let cannot = |why: String| CommandError::Refused(format!("cannot make {}: {why}", folder.display()));
    level::scaffold::judge(&levels, name).map_err(cannot)?;
    let made = match show {
        true => level::scaffold::make(&levels, name, &level::scaffold::show()),
        false => level::scaffold::make(&levels, name, &level::scaffold::FIRST),
    };
    made.map_err(|error| cannot(error.to_string()))?;
    writeln!(out, "{}", folder.display())?;
    Ok(Status::Done)
}

#[derive(clap::Args, Debug)]
pub struct ProveArgs {
    /// A name under levels/, or a level's folder
    level: OsString,
    /// A recorded run, as `run --record` and the game write them, or its code
    replay: PathBuf,
    /// What it proves; for gold and silver its time becomes the medal's
    #[arg(long = "as", value_name = "PRIZE", value_parser = pack::PROVE.map(|(name, _)| name))]
    prize: String,
}

/// Errors: a flight that proves nothing there, or a level that comes with the game; nothing is written then.
pub fn prove_level(args: &ProveArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let folder = project.level_folder(&args.level)?;
    if level::is_shipped(&folder) {
        let found = format!("{}: found a level of the game, expected one of your own", shown(folder.display()));
        return Err(CommandError::Refused(found));
    }
    let replay = super::verify::record(project, &args.replay)?;
    let path = pack::prove(&folder, project.root(), &args.prize, replay).map_err(refused)?;
    writeln!(out, "{}", shown(path.display()))?;
    Ok(Status::Done)
}

#[derive(clap::Args, Debug)]
pub struct EditArgs {
    /// A name under levels/, or a level's folder
    pub level: OsString,
    /// Edit a level that comes with the game itself, and not a copy of it
    #[arg(long)]
    pub original: bool,
}

/// Returns when the window is closed. Errors: no such level; no display.
#[cfg(feature = "window")]
pub fn edit_level(args: &EditArgs, project: &Project, _out: &mut dyn Write) -> Result<Status, CommandError> {
    use crate::{screens::Editor, window::Start};
    let folder = project.level_folder(&args.level)?;
    // A level that does not open is refused before a window opens.
    let name = Editor::open(&folder, project.root()).map_err(CommandError::Refused)?.name().to_owned();
    super::play::show(project, Some(Start::Edit(folder, name, args.original)))
}

#[cfg(not(feature = "window"))]
pub fn edit_level(args: &EditArgs, project: &Project, _out: &mut dyn Write) -> Result<Status, CommandError> {
    project.level_folder(&args.level)?;
    Err(CommandError::Refused("this build of resultant has no window: see --help for what it does without one".into()))
}

const MOST_NAMED: usize = 5;

#[derive(clap::Args, Debug)]
pub struct PackArgs {
    /// A name under levels/, or a level's folder
    level: OsString,
    /// The file to make [default: LEVEL.zip in the working directory]
    #[arg(long, value_name = "FILE.zip")]
    out: Option<PathBuf>,
}

#[derive(clap::Args, Debug)]
pub struct UnpackArgs {
    /// An archive, as `pack` makes it
    #[arg(value_name = "FILE.zip")]
    archive: PathBuf,
    /// Install the level under this name
    #[arg(long = "as", value_name = "NAME")]
    name: Option<String>,
}

/// Errors: a level that is refused or cannot be handed on, an existing file, the disk's; nothing is written then.
pub fn pack_level(args: &PackArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let folder = project.level_folder(&args.level)?;
    let (package, left) = pack::gather(&folder, project.root()).map_err(refused)?;
    let bytes = pack::write(&package).map_err(CommandError::Refused)?;
    let path = args.out.clone().unwrap_or_else(|| PathBuf::from(format!("{}.zip", package.name)));
    // An archive of `pack` can be read by `unpack`.
    pack::read(&bytes, &package.name)
        .map_err(|problem| CommandError::Refused(format!("{}: cannot be packed: {problem}", shown(folder.display()))))?;
    files::create(&path, &bytes).map_err(|error| {
        let why = match error.kind() {
            io::ErrorKind::AlreadyExists => "there is a file of that name already".to_owned(),
            _ => error.to_string(),
        };
        CommandError::Refused(format!("{}: {why}", shown(path.display())))
    })?;
    let loaded = pack::check(&package, project.root()).map_err(refused)?;
    let (_, stale) = pack::proven(&folder, &Arc::new(loaded.level));
    for warning in level::listed(&loaded.warnings).into_iter().chain(level::listed(&stale)) {
        let _ = writeln!(io::stderr(), "warning: {}", shown(warning));
    }
    for file in left {
        let _ = writeln!(io::stderr(), "{}: left out: it belongs to no level", shown(file));
    }
    let (files, flights) = counts(&package);
    writeln!(out, "{}: {files} files, {flights} flights, {} bytes", shown(path.display()), bytes.len())?;
    Ok(Status::Done)
}

/// Errors: a refused archive, level or name; an existing level of that name; nothing is written then.
pub fn unpack_level(args: &UnpackArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let named = shown(args.archive.display());
    let mut package = open(&args.archive).map_err(|problem| CommandError::Refused(format!("{named}: {problem}")))?;
    if let Some(name) = &args.name {
        judge_name(name, "")?;
        package.name.clone_from(name);
    }
    let (files, flights) = counts(&package);
    match pack::install(&package, &project.levels(), project.root(), false).map_err(refused)? {
        Installed::New(folder) => writeln!(out, "{}: {files} files, {flights} flights", shown(folder.display()))?,
        Installed::Already(folder, more) => writeln!(out, "{}: there already{}", shown(folder.display()), beside(&more))?,
    }
    Ok(Status::Done)
}

fn beside(more: &[String]) -> String {
    let named: Vec<String> = more.iter().take(MOST_NAMED).map(shown).collect();
    match more.len() {
        0 => String::new(),
        all if all > named.len() => format!(", and more in its folder: {} and {} others", named.join(", "), all - named.len()),
        _ => format!(", and more in its folder: {}", named.join(", ")),
    }
}

fn open(path: &Path) -> Result<Package, String> {
    let bytes = files::read(path, pack::LARGEST).map_err(|error| error.to_string())?;
    let called = path.file_stem().unwrap_or_default().to_string_lossy();
    pack::read(&bytes, &called)
}

fn counts(package: &Package) -> (usize, usize) {
    let flights = package.files.keys().filter(|path| path.starts_with("flights/")).count();
    (package.files.len(), flights)
}

fn refused(problems: Vec<String>) -> CommandError {
    let lines: Vec<String> = problems.iter().map(shown).collect();
    CommandError::Refused(lines.join("\n"))
}

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
    judge_name(&name, "; --as NAME gives another")?;
    loop {
        let (done, sources) = import::written(&args.map, &name, &project.levels(), project.root());
        match done {
            Err(problems) if !args.watch => return Err(CommandError::Refused(lines(&problems))),
            // A closed standard error does not stop the watch.
            Err(problems) => _ = writeln!(io::stderr(), "{}", lines(&problems)),
            Ok(ImportedLevel { folder, files, said }) => {
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
