//! `resultant tiles`: runs a list of commands through a map of tiles.

use super::project::Project;
use super::stop::{CommandError, Status};
use crate::classics::tile_run::{Command, InputError, Map, Runner};
use crate::files::{TILE_COMMANDS, TILE_MAP};
use crate::number::Shortest;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

#[derive(clap::Args, Debug)]
#[command(after_help = "Prints `tile X Y`, the column and row of the last tile. With --trace, before it, a CSV line a frame:\n  \
    frame,x,y,vx,vy,on_ground\nframe counts from 0; the numbers are the shortest that read back as the same f64; on_ground is 0 or 1.\n\n\
    MAP: a row a line; # solid, . empty, one s or S the start; outside everything is solid.\n\
    COMMANDS: `NAME VALUE` a line; NAME is LEFT, RIGHT, JUMP or WAIT.")]
pub struct TilesArgs {
    /// The file with the map
    map: PathBuf,
    /// The file with the commands, one a frame
    commands: PathBuf,
    /// Print every frame
    #[arg(long)]
    trace: bool,
}

/// Errors: a refused file, with file and line; nothing was run then.
pub fn run(args: &TilesArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let map = read(project, &args.map, TILE_MAP, Map::parse)?;
    let commands = read(project, &args.commands, TILE_COMMANDS, Command::parse_all)?;
    let mut runner = Runner::new(&map);
    for (frame, &command) in commands.iter().enumerate() {
        runner.frame(&map, command);
        if args.trace {
            write_frame(out, frame, &runner)?;
        }
    }
    let (column, row) = runner.tile();
    writeln!(out, "tile {column} {row}")?;
    Ok(Status::Done)
}

fn read<T>(project: &Project, path: &Path, at_most: u64, parse: impl Fn(&str) -> Result<T, InputError>) -> Result<T, CommandError> {
    parse(&project.read_text(path, at_most)?).map_err(|error| CommandError::Refused(format!("{}:{error}", path.display())))
}

fn write_frame(out: &mut dyn Write, frame: usize, runner: &Runner) -> io::Result<()> {
    let [x, y, vx, vy] = [runner.x, runner.y, runner.vx, runner.vy].map(Shortest);
    writeln!(out, "{frame},{x},{y},{vx},{vy},{}", u8::from(runner.on_ground))
}
