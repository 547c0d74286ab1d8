//! `resultant pi`: counts the collisions of two blocks and a wall.

use super::project::Project;
use super::stop::{CommandError, Status};
use crate::classics::pi::{Blocks, count, step_through};
use std::io::Write;
use std::time::Instant;

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
pub fn run(args: &PiArgs, _: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let started = Instant::now();
    let stepped = match args.dt {
        Some(dt) => Some(step_through(args.n, dt, args.substeps).map_err(|problem| CommandError::Refused(format!("--{problem}")))?),
        None => None,
    };
    let stepped_seconds = started.elapsed().as_secs_f64();

    let started = Instant::now();
    if args.n <= MAX_N_WITH_POSITIONS {
        let mut blocks = Blocks::new(args.n);
        while blocks.collide().is_some() {}
        writeln!(out, "collisions={}", blocks.collisions())?;
        writeln!(out, "seconds={:.6}", started.elapsed().as_secs_f64())?;
        writeln!(out, "last_time={}", blocks.time())?;
        writeln!(out, "last_position={}", blocks.positions(blocks.time()).1)?;
    } else {
        writeln!(out, "collisions={}", count(args.n))?;
        writeln!(out, "seconds={:.6}", started.elapsed().as_secs_f64())?;
    }
    if let Some(stepped) = stepped {
        writeln!(out, "stepped={}\nsteps={}\nstepped_seconds={stepped_seconds:.6}", stepped.collisions, stepped.steps)?;
    }
    Ok(Status::Done)
}
