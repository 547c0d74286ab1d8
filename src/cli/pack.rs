//! `resultant pack` and `resultant unpack`: a level as one file, and back.

use super::project::Project;
use super::stop::{CommandError, Status, shown};
use crate::files;
use crate::level;
use crate::pack::{self, Installed, Package};
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The most files that a line names.
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
pub fn pack(args: &PackArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
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
    let stale = pack::stale(&folder, &Arc::new(loaded.level));
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
pub fn unpack(args: &UnpackArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let named = shown(args.archive.display());
    let mut package = open(&args.archive).map_err(|problem| CommandError::Refused(format!("{named}: {problem}")))?;
    if let Some(name) = &args.name {
        if let Err(fault) = level::judge_name(name) {
            return Err(CommandError::Refused(format!("a level cannot be named {name:?}: expected {}", fault.expected())));
        }
        package.name.clone_from(name);
    }
    let (files, flights) = counts(&package);
    match pack::install(&package, &project.levels(), project.root(), false).map_err(refused)? {
        Installed::New(folder) => writeln!(out, "{}: {files} files, {flights} flights", shown(folder.display()))?,
        Installed::Already(folder, more) => writeln!(out, "{}: there already{}", shown(folder.display()), beside(&more))?,
    }
    Ok(Status::Done)
}

/// The further files of an existing level's folder, in words.
fn beside(more: &[String]) -> String {
    let named: Vec<String> = more.iter().take(MOST_NAMED).map(shown).collect();
    match more.len() {
        0 => String::new(),
        all if all > named.len() => format!(", and more in its folder: {} and {} others", named.join(", "), all - named.len()),
        _ => format!(", and more in its folder: {}", named.join(", ")),
    }
}

/// The error is in words.
fn open(path: &Path) -> Result<Package, String> {
    let bytes = files::read(path, pack::LARGEST).map_err(|error| error.to_string())?;
    let called = path.file_stem().unwrap_or_default().to_string_lossy();
    pack::read(&bytes, &called)
}

/// The number of files, and of flights among them.
fn counts(package: &Package) -> (usize, usize) {
    let flights = package.files.keys().filter(|path| path.starts_with("flights/")).count();
    (package.files.len(), flights)
}

fn refused(problems: Vec<String>) -> CommandError {
    let lines: Vec<String> = problems.iter().map(shown).collect();
    CommandError::Refused(lines.join("\n"))
}
