//! The command line: one file a subcommand, and [`Project`], which finds the game's folders. Standard output gets results, standard
//! error problems. Results go to the writer argument, never to `println!`, which panics on a closed pipe.

#[allow(clippy::disallowed_methods)] // it measures
mod chart;
mod check;
mod code;
mod edit;
mod files;
mod forces;
mod jumper;
mod new;
mod pack;
#[allow(clippy::disallowed_methods)] // it measures
mod pi;
mod play;
mod project;
mod run;
mod stats;
#[allow(clippy::disallowed_methods)] // a long flight reports from time to time
mod stop;
mod telemetry;
mod tiles;
mod verify;
mod verify_scores;

pub use project::Project;
pub use stop::{CommandError, Status};

use clap::Parser;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use stop::Readers;

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
    Edit(edit::EditArgs),
    /// Load levels and print what is in them, or every problem
    Check(check::CheckArgs),
    /// Play a level without a window and print what that came to
    Run(run::RunArgs),
    /// Measure accuracy against speed and draw the charts
    Chart(chart::ChartArgs),
    /// Make a level folder that loads
    New(new::NewArgs),
    /// Make one file of a level, with its pictures and flights, to be handed on
    Pack(pack::PackArgs),
    /// Install the level of such a file under levels/
    Unpack(pack::UnpackArgs),
    /// Fly recorded runs, or all saved scores, again and compare where they lead
    Verify(verify::VerifyArgs),
    /// Print the code of a recorded run: a line of text that `verify` and the game take
    Code(code::CodeArgs),
    /// Sum up attempts by level and answers by experiment
    Stats(stats::StatsArgs),
    /// Run a list of commands through a map of tiles
    Tiles(tiles::TilesArgs),
    /// Climb the jumper's tower without a window
    Jumper(jumper::JumperArgs),
    /// Count the collisions of two blocks and a wall: the first N+1 digits of π
    Pi(pi::PiArgs),
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
        Some(Subcommand::Edit(args)) => edit::run(args, &project, out),
        Some(Subcommand::Check(args)) => check::run(args, &project, out),
        Some(Subcommand::Run(args)) => run::run(args, &project, out),
        Some(Subcommand::Chart(args)) => chart::run(args, &project, out),
        Some(Subcommand::New(args)) => new::run(args, &project, out),
        Some(Subcommand::Pack(args)) => pack::pack(args, &project, out),
        Some(Subcommand::Unpack(args)) => pack::unpack(args, &project, out),
        Some(Subcommand::Verify(args)) => verify::run(args, &project, out),
        Some(Subcommand::Code(args)) => code::run(args, &project, out),
        Some(Subcommand::Stats(args)) => stats::run(args, &project, out),
        Some(Subcommand::Tiles(args)) => tiles::run(args, &project, out),
        Some(Subcommand::Jumper(args)) => jumper::run(args, &project, out),
        Some(Subcommand::Pi(args)) => pi::run(args, &project, out),
    }
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
}
