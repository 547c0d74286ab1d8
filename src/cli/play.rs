//! `resultant` and `resultant play` open the game; `jumper`, `pi` and `tiles` run the classics without a window.

use super::{CommandError, Status, project::Project};
use crate::classics::jumper::{Climb, JumpKeys, JumperScene, parse};
use crate::classics::pi::{Blocks, count, step_through};
use crate::classics::tile_run::{Command, InputError, Map, Runner};
use crate::files::{INPUTS, TILE_COMMANDS, TILE_MAP};
use crate::{game::TICK_RATE, number::Shortest};
use std::path::{Path, PathBuf};
use std::{ffi::OsString, io::Write, time::Instant};

#[derive(clap::Args, Debug, Default)]
pub struct PlayArgs {
    /// A name under levels/, or a level's folder; without it the game opens with its menu
    pub level: Option<OsString>,
    /// Play these recorded inputs instead of the keys, from the first tick on
    #[arg(long, value_name = "FILE", requires = "level")]
    pub inputs: Option<PathBuf>,
}

#[cfg(feature = "window")]
pub use window::{run, show};

#[cfg(feature = "window")]
mod window {
    use super::{PlayArgs, Project};
    use crate::cli::{CommandError, Status, shown};
    use crate::window::{Start, open};
    use crate::{files::INPUTS, game::Inputs, level, screens::Places, session::library::Attempt};
    use std::{ffi::OsStr, io::Write, path::Path, sync::Arc};

    /// Returns when the window is closed. Errors: a refused level or inputs; a missing folder of levels; no display.
    pub fn run(args: &PlayArgs, project: &Project, _out: &mut dyn Write) -> Result<Status, CommandError> {
        // A level that is named needs no others beside it.
        if args.level.is_none() && !crate::files::is_folder(&project.levels()) {
            let missing = project.levels();
            return Err(CommandError::Refused(format!(
                "there is no folder {}, which holds the game's levels: say with --data DIR where levels/ is",
                missing.display()
            )));
        }
        show(project, args.level.as_deref().map(|level| start(level, args.inputs.as_deref(), project)).transpose()?)
    }

    /// Returns when the window is closed.
    pub fn show(project: &Project, start: Option<Start>) -> Result<Status, CommandError> {
        project.settle().into_iter().for_each(|line| drop(writeln!(std::io::stderr(), "{line}")));
        let (root, settings) = (project.root().to_path_buf(), project.settings_folder().join("settings.csv"));
        let places = Places { root, levels: project.levels(), scores: project.scores(), settings };
        open(places, start).map_err(CommandError::Refused)?;
        Ok(Status::Done)
    }

    /// Before a window opens. An unfinished level is tried out, with its problems on standard error.
    fn start(level: &OsStr, inputs: Option<&Path>, project: &Project) -> Result<Start, CommandError> {
        let folder = project.level_folder(level)?;
        let loaded = match level::load(&folder, project.root()) {
            Ok(loaded) => loaded,
            Err(problems) => {
                let problems = level::listed(&problems);
                let lines: String = problems.iter().map(|problem| format!("{}/{problem}\n", shown(level.display()))).collect();
                let unfinished = level::load_unfinished(&folder, project.root()).ok().filter(|_| inputs.is_none());
                let Some(unfinished) = unfinished else { return Err(CommandError::Refused(lines)) };
                let _ = writeln!(
                    std::io::stderr(),
                    "{lines}{}: not finished yet, its flights count for nothing",
                    shown(level.display())
                );
                return Ok(Start::Test(folder, Arc::new(unfinished.level), problems));
            }
        };
        let inputs = inputs.map(|file| {
            Inputs::parse(&file.display().to_string(), &project.read_text(file, INPUTS)?).map_err(CommandError::refused)
        });
        let attempt = Attempt { level: Arc::new(loaded.level), inputs: inputs.transpose()?.map(Arc::new), rivals: Vec::new() };
        Ok(Start::Play(folder, attempt))
    }
}

#[cfg(not(feature = "window"))]
pub fn run(args: &PlayArgs, project: &Project, _out: &mut dyn Write) -> Result<Status, CommandError> {
    args.level.as_ref().map(|level| project.load_level(level)).transpose()?;
    Err(CommandError::Refused("this build of resultant has no window: see --help for what it does without one".into()))
}

/// 10 s.
const TICKS_WITHOUT_INPUTS: u64 = 10 * TICK_RATE as u64;

#[derive(clap::Args, Debug)]
#[command(after_help = "Prints lines key=value: outcome (climbing; out when all players are), score (whole metres), height (m), \
    ticks, and each player's x and z (m).\n\nINPUTS: a CSV with the header ticks,left1,right1,jump1,left2,right2,jump2 (the last \
    three may be left out); each row holds its keys (0 or 1) for that many ticks of 1/120 s.")]
pub struct JumperArgs {
    /// The tower's seed: the same seed builds the same tower
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// How many climb
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=2))]
    players: u8,
    /// The file with what they hold down; without it nobody moves for 10 s
    #[arg(long, value_name = "FILE")]
    inputs: Option<PathBuf>,
}

/// Climbs until the inputs end or all players are out. Errors: inputs that are refused, with file and line.
pub fn run_jumper(args: &JumperArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let rows = match &args.inputs {
        Some(path) => parse(&path.display().to_string(), &project.read_text(path, INPUTS)?).map_err(CommandError::Refused)?,
        None => vec![Climb { ticks: TICKS_WITHOUT_INPUTS, keys: [JumpKeys::default(); 2] }],
    };
    let mut scene = JumperScene::new(args.seed, args.players == 2);
    for row in rows {
        for _ in 0..row.ticks {
            if scene.is_over() {
                break;
            }
            scene.tick(row.keys);
        }
    }
    writeln!(out, "outcome={}", if scene.is_over() { "out" } else { "climbing" })?;
    writeln!(out, "score={}\nheight={}\nticks={}", scene.score(), Shortest(scene.height), scene.ticks)?;
    for (number, (_, body)) in (1..).zip(scene.players()) {
        let place = body.cuboid.location;
        writeln!(out, "x{number}={}\nz{number}={}", Shortest(place.x), Shortest(place.z))?;
    }
    Ok(Status::Done)
}

/// Up to this N the blocks have positions and times; beyond it velocities alone, which is much faster.
const MAX_N_WITH_POSITIONS: u32 = 7;

#[derive(clap::Args, Debug)]
#[command(
    after_help = "A wall, a block at rest, and one of 100^N times its mass moving towards it at 1 m/s collide as often as the \
    first N+1 digits of π say.\n\nPrints lines key=value:\n  \
    collisions       the count, from jumping from collision to collision\n  \
    seconds          how long that took to compute\n  \
    last_time        N ≤ 7: when the last collision was, s from the start\n  \
    last_position    N ≤ 7: the heavy block's side towards the wall then, less the light block's width, m\n  \
    stepped          with --dt: the count from moving in steps, right or wrong\n  \
    steps            with --dt: how many steps were made\n  \
    stepped_seconds  with --dt: how long that took to compute"
)]
pub struct PiArgs {
    /// How many digits follow the 3, from 0 to 9
    #[arg(value_name = "N", value_parser = clap::value_parser!(u32).range(0..=9), allow_negative_numbers = true)]
    n: u32,
    /// Also move in steps of this length, s, for comparison; it fails where collisions come faster
    #[arg(long, value_name = "DT", allow_negative_numbers = true)]
    dt: Option<f64>,
    /// Cut each step into this number of parts
    #[arg(long, value_name = "K", requires = "dt", default_value_t = 1, allow_negative_numbers = true)]
    substeps: u32,
}

/// Errors: a step that is not above 0 and finite, or too small.
pub fn count_pi(args: &PiArgs, _: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let started = Instant::now();
    let stepped = args.dt.map(|dt| step_through(args.n, dt, args.substeps)).transpose();
    let stepped = stepped.map_err(|problem| CommandError::Refused(format!("--{problem}")))?;
    let stepped_seconds = started.elapsed().as_secs_f64();

    let started = Instant::now();
    if args.n <= MAX_N_WITH_POSITIONS {
        let mut blocks = Blocks::new(args.n);
        while blocks.collide().is_some() {}
        writeln!(out, "collisions={}", blocks.collisions)?;
        writeln!(out, "seconds={:.6}", started.elapsed().as_secs_f64())?;
        writeln!(out, "last_time={}", blocks.time)?;
        writeln!(out, "last_position={}", blocks.positions(blocks.time).1)?;
    } else {
        writeln!(out, "collisions={}", count(args.n))?;
        writeln!(out, "seconds={:.6}", started.elapsed().as_secs_f64())?;
    }
    if let Some(stepped) = stepped {
        writeln!(out, "stepped={}\nsteps={}\nstepped_seconds={stepped_seconds:.6}", stepped.collisions, stepped.steps)?;
    }
    Ok(Status::Done)
}

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
pub fn run_tiles(args: &TilesArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let map = read(project, &args.map, TILE_MAP, Map::parse)?;
    let commands = read(project, &args.commands, TILE_COMMANDS, Command::parse_all)?;
    let mut runner = Runner::new(&map);
    for (frame, &command) in commands.iter().enumerate() {
        runner.frame(&map, command);
        if args.trace {
            let [x, y, vx, vy] = [runner.x, runner.y, runner.vx, runner.vy].map(Shortest);
            writeln!(out, "{frame},{x},{y},{vx},{vy},{}", u8::from(runner.on_ground))?;
        }
    }
    let (column, row) = runner.tile();
    writeln!(out, "tile {column} {row}")?;
    Ok(Status::Done)
}

fn read<T>(project: &Project, path: &Path, at_most: u64, parse: impl Fn(&str) -> Result<T, InputError>) -> Result<T, CommandError> {
    parse(&project.read_text(path, at_most)?).map_err(|error| CommandError::Refused(format!("{}:{error}", path.display())))
}
