//! The command line: one file a subcommand, and [`Project`], which says where the game's folders are. Here are the arguments that
//! all share and what becomes of their results: standard output gets results, standard error problems, and the exit status is
//! [`Status`]. What a subcommand does is not here, and no rule of the game either.
//!
//! Each subcommand's file has `pub struct Args` and `pub fn run(&Args, &Project, &mut dyn Write) -> Result<Status, Stop>`. It
//! writes its results to the writer, never with `println!`, which panics when the reader has gone away.

mod chart;
mod check;
mod earned;
mod edit;
mod files;
mod forces;
mod jumper;
mod new;
mod pack;
mod pi;
mod play;
mod project;
mod run;
mod telemetry;
mod tiles;
mod verify;

pub use project::Project;

use crate::level::{self, Level};
use clap::Parser;
use std::fmt::Display;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

/// A rocket ship flown by named forces
#[derive(Parser, Debug)]
#[command(version, about, after_help = "Without a command the game opens.")]
#[command(after_long_help = "Without a command the game opens.\n\nExit status: 0 done; 1 a check or verification found something \
    wrong; 2 the input was refused, or its results could not be written: each file is the old one or the new one, whole.")]
struct Cli {
    /// The folder that holds assets/, levels/ and scores/
    #[arg(long, global = true, value_name = "DIR")]
    data: Option<PathBuf>,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(clap::Subcommand, Debug)]
enum Command {
    /// Open the game in a level
    Play(play::Args),
    /// Open the editor of a level
    Edit(edit::Args),
    /// Load levels and print what is in them, or every problem
    Check(check::Args),
    /// Play a level without a window and print what that came to
    Run(run::Args),
    /// Measure accuracy against speed and draw the charts
    Chart(chart::Args),
    /// Make a level folder that loads
    New(new::Args),
    /// Make one file of a level, with its pictures and flights, to be handed on
    Pack(pack::PackArgs),
    /// Install the level of such a file under levels/
    Unpack(pack::UnpackArgs),
    /// Fly recorded runs, or all saved scores, again and compare where they lead
    Verify(verify::Args),
    /// Run a list of commands through a map of tiles
    Tiles(tiles::Args),
    /// Climb the jumper's tower without a window
    Jumper(jumper::Args),
    /// Count the collisions of two blocks and a wall: the first N+1 digits of π
    Pi(pi::Args),
}

/// How a subcommand ended, as its exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    /// It did what was asked.
    Done = 0,
    /// A check or verification found something wrong, also when nobody reads what.
    Wrong = 1,
    /// The input was refused, or the results could not be written: each file is the old one or the new one, whole.
    Refused = 2,
}

/// Why a subcommand ended early.
#[derive(Debug)]
pub enum Stop {
    /// The input was refused, for this reason; ends with [`Status::Refused`]. Of several problems each has its line.
    Refused(String),
    /// Results could not be written; ends with [`Status::Refused`], too.
    Output(io::Error),
}

impl Stop {
    /// The input was refused, for this reason.
    pub fn refused(reason: impl Display) -> Self {
        Self::Refused(reason.to_string())
    }
}

impl From<io::Error> for Stop {
    /// For `?` behind `write!` to the output. Whatever else fails to be read or written wants a message with its path.
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

/// A stream that someone reads, for as long as they do: a reader that has gone away has seen enough, as `head` does. What is written
/// after that goes nowhere, and changes neither what is done nor how it ends.
struct Readers<W> {
    stream: W,
    gone: bool,
}

impl<W: Write> Readers<W> {
    const fn of(stream: W) -> Self {
        Self { stream, gone: false }
    }

    /// `done`, unless nobody reads: then it is as if `otherwise` had been done.
    fn unless_gone<T>(&mut self, done: impl FnOnce(&mut W) -> io::Result<T>, otherwise: T) -> io::Result<T> {
        if self.gone {
            return Ok(otherwise);
        }
        done(&mut self.stream).or_else(|error| {
            self.gone = error.kind() == io::ErrorKind::BrokenPipe;
            if self.gone { Ok(otherwise) } else { Err(error) }
        })
    }
}

impl<W: Write> Write for Readers<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.unless_gone(|stream| stream.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.unless_gone(Write::flush, ())
    }
}

/// Parses the command line, runs what it asks for and says how that ended.
pub fn main() -> ExitCode {
    let cli = Cli::parse();
    let mut out = io::BufWriter::new(Readers::of(io::stdout().lock()));
    let ended = dispatch(&cli, &mut out).and_then(|status| Ok(out.flush().map(|()| status)?));
    let status = match ended {
        Ok(status) => status,
        Err(Stop::Refused(problem)) => {
            // Nothing can be done about a standard error that is closed.
            let _ = writeln!(io::stderr(), "{}", problem.trim_end());
            Status::Refused
        }
        // A file of results that is a pipe: whoever reads has seen enough.
        Err(Stop::Output(error)) if error.kind() == io::ErrorKind::BrokenPipe => Status::Done,
        Err(Stop::Output(error)) => {
            let _ = writeln!(io::stderr(), "cannot write the results: {error}");
            Status::Refused
        }
    };
    ExitCode::from(status as u8)
}

fn dispatch(cli: &Cli, out: &mut dyn Write) -> Result<Status, Stop> {
    let project = Project::find(cli.data.as_deref())?;
    match &cli.command {
        None => play::run(&play::Args::default(), &project, out),
        Some(Command::Play(args)) => play::run(args, &project, out),
        Some(Command::Edit(args)) => edit::run(args, &project, out),
        Some(Command::Check(args)) => check::run(args, &project, out),
        Some(Command::Run(args)) => run::run(args, &project, out),
        Some(Command::Chart(args)) => chart::run(args, &project, out),
        Some(Command::New(args)) => new::run(args, &project, out),
        Some(Command::Pack(args)) => pack::pack(args, &project, out),
        Some(Command::Unpack(args)) => pack::unpack(args, &project, out),
        Some(Command::Verify(args)) => verify::run(args, &project, out),
        Some(Command::Tiles(args)) => tiles::run(args, &project, out),
        Some(Command::Jumper(args)) => jumper::run(args, &project, out),
        Some(Command::Pi(args)) => pi::run(args, &project, out),
    }
}

/// The level that the command line names, ready to be played.
///
/// # Errors
/// There is no such level, or it is refused, with every problem.
fn load_level(project: &Project, name: impl AsRef<Path>) -> Result<Arc<Level>, Stop> {
    load_folder(project, &project.level_folder(name)?)
}

/// The level in a folder, ready to be played.
///
/// # Errors
/// It is refused, with every problem.
fn load_folder(project: &Project, folder: &Path) -> Result<Arc<Level>, Stop> {
    let loaded = level::load(folder, project.root()).map_err(|problems| Stop::Refused(level::told(&problems).join("\n")))?;
    Ok(Arc::new(loaded.level))
}

/// A name or a path as it is shown: what would move a terminal's cursor or change its colours is written out.
fn shown(name: impl Display) -> String {
    let visible = |c: char| if c == '"' || c == '\'' || c == '\\' { vec![c] } else { c.escape_debug().collect() };
    name.to_string().chars().flat_map(visible).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn what_is_shown_leaves_the_terminal_as_it_is() {
        assert_eq!(shown("höhle-2 \"a\\b\" '→'"), "höhle-2 \"a\\b\" '→'");
        assert_eq!(shown("a\u{1b}[31m\r\n\u{9b}2J\u{202e}\u{7f}"), "a\\u{1b}[31m\\r\\n\\u{9b}2J\\u{202e}\\u{7f}");
    }

    #[test]
    fn a_reader_that_has_gone_away_changes_nothing_and_a_full_disk_does() {
        struct Failing(io::ErrorKind);
        impl Write for Failing {
            fn write(&mut self, _: &[u8]) -> io::Result<usize> {
                Err(self.0.into())
            }
            fn flush(&mut self) -> io::Result<()> {
                Err(self.0.into())
            }
        }
        let mut gone = Readers::of(Failing(io::ErrorKind::BrokenPipe));
        assert!(gone.flush().is_ok() && gone.write_all(b"told to no one").is_ok());
        assert!(Readers::of(Failing(io::ErrorKind::StorageFull)).write_all(b"results").is_err());
    }

    #[test]
    fn the_definition_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn data_is_taken_anywhere() {
        for line in [["resultant", "--data", "d", "play", "1"], ["resultant", "play", "1", "--data", "d"]] {
            assert_eq!(Cli::parse_from(line).data, Some(PathBuf::from("d")), "{line:?}");
        }
    }
}
