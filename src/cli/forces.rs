//! The file of forces: every single force and impact, tick by tick, with what exerts it and where it acts.

use super::files::CsvOutput;
use super::telemetry::column;
use crate::game::{Game, obstacle_name, source_name};
use crate::number::{Pair, Shortest, pair};
use crate::physics::{BodyId, DVec2, Impulse};
use serde::Serialize;
use std::io::{self, Write};

/// The first row.
pub const HEADER: &str = "tick,time,object,kind,by,x,y,point_x,point_y";
/// The kind of an impact's row: its vector is an impulse, N·s.
const IMPACT: &str = "impact";

/// A row: an instant and what acts on an object then, numbered as in the telemetry; N (an impact: N·s) and metres.
#[derive(Serialize)]
struct ForceRow<'a> {
    tick: u64,
    time: Shortest,
    object: u32,
    kind: &'a str,
    by: &'a str,
    vector: Pair,
    point: Pair,
}

/// The file while it is written.
pub struct Forces<W: Write>(CsvOutput<W>);

impl<W: Write> Forces<W> {
    /// Begins the file.
    pub fn new(out: W) -> io::Result<Self> {
        Ok(Self(CsvOutput::new(out, HEADER)?))
    }

    /// The rows of the current tick: for each object the forces that act on it at this instant, and then the impacts that it felt since the
    /// tick before, in the order of their times.
    pub fn write_tick(&mut self, game: &Game) -> io::Result<()> {
        let (world, level) = (game.world(), game.level());
        for id in (0..world.bodies().len() as u32).map(BodyId) {
            for force in world.forces(id).forces() {
                let names = (column(force.kind), source_name(level, force.source));
                self.write_row(game, id, (&names.0, &names.1), (force.vector, force.point))?;
            }
            let felt = |impulse: &Impulse| Some((impulse.on(id)?, impulse.point));
            for ((vector, by), point) in world.impulses().iter().filter_map(felt) {
                self.write_row(game, id, (IMPACT, &obstacle_name(level, by)), (vector, point))?;
            }
        }
        Ok(())
    }

    /// Ends the file.
    pub fn into_inner(self) -> io::Result<W> {
        self.0.into_inner()
    }

    fn write_row(&mut self, game: &Game, id: BodyId, (kind, by): (&str, &str), (vector, point): (DVec2, DVec2)) -> io::Result<()> {
        // Adding zero turns −0 into 0: what opposes 0 is 0.
        let vector = pair(vector + DVec2::ZERO);
        self.0.row(&ForceRow {
            tick: game.ticks(),
            time: Shortest(game.elapsed()),
            object: id.0,
            kind,
            by,
            vector,
            point: pair(point),
        })
    }
}
