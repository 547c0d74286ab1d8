//! The command line: one file a subcommand, and [`Project`], which finds the game's folders. Standard output gets results, standard error problems.
//! Results go to the writer argument, never to `println!`, which panics on a closed pipe.

#[allow(clippy::disallowed_methods)] // it measures
mod chart;
mod files;
mod levels;
#[allow(clippy::disallowed_methods)] // it measures
mod play;
mod project;
mod run;
mod stats;
mod verify;

use clap::Parser;
pub use project::Project;
use std::io::{self, Write};
use std::time::{Duration, Instant};
use std::{fmt::Display, path::PathBuf, process::ExitCode};

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
    command: Option<Subcommand>,
}

#[derive(clap::Subcommand, Debug)]
enum Subcommand {
    /// Open the game in a level
    Play(play::PlayArgs),
    /// Open the editor of a level
    Edit(levels::EditArgs),
    /// Load levels and print what is in them, or every problem
    Check(levels::CheckArgs),
    /// Play a level without a window and print what that came to
    Run(run::RunArgs),
    /// Measure accuracy against speed and draw the charts
    Chart(chart::ChartArgs),
    /// Make a level folder that loads
    New(levels::NewArgs),
    /// Make a flight the proof of a level's medal, with its time
    Prove(levels::ProveArgs),
    /// Make a level of a map of the editor Tiled, .tmj or .tmx
    Import(levels::ImportArgs),
    /// Make one file of a level, with its pictures and flights, to be handed on
    Pack(levels::PackArgs),
    /// Install the level of such a file under levels/
    Unpack(levels::UnpackArgs),
    /// Fly recorded runs, or all saved scores, again and compare where they lead
    Verify(verify::VerifyArgs),
    /// Print the code of a recorded run: a line of text that `verify` and the game take
    Code(verify::CodeArgs),
    /// Sum up attempts by level and answers by experiment
    Stats(stats::StatsArgs),
    /// Run a list of commands through a map of tiles
    Tiles(play::TilesArgs),
    /// Climb the jumper's tower without a window
    Jumper(play::JumperArgs),
    /// Count the collisions of two blocks and a wall: the first N+1 digits of π
    Pi(play::PiArgs),
}

pub fn main() -> ExitCode {
    let cli = Cli::parse();
    let mut out = io::BufWriter::new(Readers::of(io::stdout().lock()));
    let ended = dispatch(&cli, &mut out).and_then(|status| Ok(out.flush().map(|()| status)?));
    let status = match ended {
        Ok(status) => status,
        Err(CommandError::Refused(problem)) => {
            // A closed standard error changes nothing.
            let _ = writeln!(io::stderr(), "{}", problem.trim_end());
            Status::Refused
        }
        // The reader of a pipe has seen enough.
        Err(CommandError::Output(error)) if error.kind() == io::ErrorKind::BrokenPipe => Status::Done,
        Err(CommandError::Output(error)) => {
            let _ = writeln!(io::stderr(), "cannot write the results: {error}");
            Status::Refused
        }
    };
    ExitCode::from(status as u8)
}

fn dispatch(cli: &Cli, out: &mut dyn Write) -> Result<Status, CommandError> {
    let project = Project::find(cli.data.as_deref())?;
    match &cli.command {
        None => play::run(&play::PlayArgs::default(), &project, out),
        Some(Subcommand::Play(args)) => play::run(args, &project, out),
        Some(Subcommand::Edit(args)) => levels::edit_level(args, &project, out),
        Some(Subcommand::Check(args)) => levels::check_levels(args, &project, out),
        Some(Subcommand::Run(args)) => run::run(args, &project, out),
        Some(Subcommand::Chart(args)) => chart::run(args, &project, out),
        Some(Subcommand::New(args)) => levels::new_level(args, &project, out),
        Some(Subcommand::Prove(args)) => levels::prove_level(args, &project, out),
        Some(Subcommand::Import(args)) => levels::run(args, &project, out),
        Some(Subcommand::Pack(args)) => levels::pack_level(args, &project, out),
        Some(Subcommand::Unpack(args)) => levels::unpack_level(args, &project, out),
        Some(Subcommand::Verify(args)) => verify::verify_flights(args, &project, out),
        Some(Subcommand::Code(args)) => verify::write_code(args, &project, out),
        Some(Subcommand::Stats(args)) => stats::run(args, &project, out),
        Some(Subcommand::Tiles(args)) => play::run_tiles(args, &project, out),
        Some(Subcommand::Jumper(args)) => play::run_jumper(args, &project, out),
        Some(Subcommand::Pi(args)) => play::count_pi(args, &project, out),
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    Done = 0,
    /// A check or verification found a fault, also when nobody reads the report.
    Wrong = 1,
    /// Refused input, or results that could not be written: each file is the old one or the new one, whole.
    Refused = 2,
}

#[derive(Debug)]
pub enum CommandError {
    /// With the reason, a line a problem; ends with [`Status::Refused`].
    Refused(String),
    /// Ends with [`Status::Refused`], too.
    Output(io::Error),
}

impl CommandError {
    pub fn refused(reason: impl Display) -> Self {
        Self::Refused(reason.to_string())
    }
}

impl From<io::Error> for CommandError {
    /// For `?` behind `write!` to the output. Any other fault of reading or writing wants a message with its path.
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

/// Ticks between two looks at the clock, whose cost must not count.
const TICKS_A_LOOK: u64 = 4096;
/// The time before the first line on a long flight, and between two lines.
const SILENCE: Duration = Duration::from_secs(2);

/// The time since the last line on a long flight.
struct Silence(Instant);

impl Silence {
    #[allow(clippy::disallowed_methods)] // a long flight reports from time to time
    pub fn new() -> Self {
        Self(Instant::now())
    }

    /// Whether a line is due; the next silence begins with it.
    pub fn is_over(&mut self) -> bool {
        let over = self.0.elapsed() >= SILENCE;
        if over {
            *self = Self::new();
        }
        over
    }
}

/// A stream until its reader goes away, as `head` does. Later writes go nowhere and change no result.
struct Readers<W> {
    stream: W,
    gone: bool,
}

impl<W: Write> Readers<W> {
    pub const fn of(stream: W) -> Self {
        Self { stream, gone: false }
    }

    /// `done`, or `otherwise` once the reader has gone.
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

/// A name or path with control characters written out, which would move a terminal's cursor or change its colours.
fn shown(name: impl Display) -> String {
    let visible = |c: char| if c == '"' || c == '\'' || c == '\\' { vec![c] } else { c.escape_debug().collect() };
    name.to_string().chars().flat_map(visible).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

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
}
