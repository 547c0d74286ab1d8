//! The file of forces: every single force and impact, tick by tick, with what exerts it and where it acts.

use super::number::Shortest;
use super::telemetry::{column, write_vector};
use crate::game::{Game, obstacle_name, source_name};
use crate::physics::{BodyId, DVec2, Impulse};
use std::io::{self, Write};

/// The first row.
pub const HEADER: &str = "tick,time,object,kind,by,x,y,point_x,point_y";
/// The kind of a row that tells of an impact: its vector is an impulse, N·s.
const IMPACT: &str = "impact";

/// The rows of the current tick: for each object, numbered as in the telemetry, the forces that act on it at this instant (N), and then the
/// impacts that it felt since the tick before (N·s), in the order of their times. Points in metres.
pub fn write_tick(out: &mut impl Write, game: &Game) -> io::Result<()> {
    let (world, level) = (game.world(), game.level());
    for id in (0..world.bodies().len() as u32).map(BodyId) {
        for force in world.forces(id).forces() {
            write_row(out, game, id, (&column(force.kind), &source_name(level, force.source)), (force.vector, force.point))?;
        }
        let felt = |impulse: &Impulse| Some((impulse.on(id)?, impulse.point));
        for ((vector, by), point) in world.impulses().iter().filter_map(felt) {
            write_row(out, game, id, (IMPACT, &obstacle_name(level, by)), (vector, point))?;
        }
    }
    Ok(())
}

fn write_row(
    out: &mut impl Write,
    game: &Game,
    id: BodyId,
    (kind, by): (&str, &str),
    (vector, point): (DVec2, DVec2),
) -> io::Result<()> {
    write!(out, "{},{},{},{kind},{by}", game.ticks(), Shortest(game.time()), id.0)?;
    // Adding zero turns −0 into 0: what opposes 0 is 0.
    write_vector(out, vector + DVec2::ZERO)?;
    write_vector(out, point)?;
    writeln!(out)
}
