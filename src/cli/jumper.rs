//! `resultant jumper`: a climb without a window.

use super::project::Project;
use super::stop::{CommandError, Status};
use crate::classics::jumper::inputs::{Climb, parse};
use crate::classics::jumper::scene::{JumpKeys, JumperScene};
use crate::files::INPUTS;
use crate::game::TICK_RATE;
use crate::number::Shortest;
use std::io::Write;
use std::path::PathBuf;

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

/// Climbs until the inputs end or all players are out.
/// Errors: inputs that are refused, with file and line.
pub fn run(args: &JumperArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
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
    writeln!(out, "score={}\nheight={}\nticks={}", scene.score(), Shortest(scene.height()), scene.ticks())?;
    for (number, (_, body)) in (1..).zip(scene.players()) {
        let place = body.cuboid.location;
        writeln!(out, "x{number}={}\nz{number}={}", Shortest(place.x), Shortest(place.z))?;
    }
    Ok(Status::Done)
}
