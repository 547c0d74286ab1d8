//! The file of forces: each force and impact of each tick, with its source and its point.

use super::files::CsvOutput;
use super::telemetry::column;
use crate::game::{Game, obstacle_name, source_name};
use crate::number::{Pair, Shortest, pair};
use crate::physics::{BodyId, DVec2, Impulse};
use serde::Serialize;
use std::io::{self, Write};

pub const HEADER: &str = "tick,time,object,kind,by,x,y,point_x,point_y";
/// The kind of an impact, whose vector is an impulse, N·s.
const IMPACT: &str = "impact";
/// And that of what a contact had passed on in the tick in which it ended.
const ENDED: &str = "ended_contact";

/// Objects have the telemetry's numbers; N (an impact: N·s) and metres.
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

pub struct Forces<W: Write>(CsvOutput<W>);

impl<W: Write> Forces<W> {
    pub fn new(out: W) -> io::Result<Self> {
        Ok(Self(CsvOutput::new(out, HEADER)?))
    }

    /// For each object of the current tick, the forces at this instant and then the impacts since the tick before, in time order.
    pub fn write_tick(&mut self, game: &Game) -> io::Result<()> {
        let (world, level) = (game.world(), game.level());
        for id in (0..world.bodies().len() as u32).map(BodyId) {
            for force in world.forces(id).forces() {
                let names = (column(force.kind), source_name(level, force.source));
                self.write_row(game, id, (&names.0, &names.1), (force.vector, force.point))?;
            }
            let felt = |impulse: &Impulse| Some((impulse.on(id)?, impulse.point, if impulse.impact { IMPACT } else { ENDED }));
            for ((vector, by), point, kind) in world.impulses().iter().filter_map(felt) {
                self.write_row(game, id, (kind, &obstacle_name(level, by)), (vector, point))?;
            }
        }
        Ok(())
    }

    pub fn into_inner(self) -> io::Result<W> {
        self.0.into_inner()
    }

    fn write_row(&mut self, game: &Game, id: BodyId, (kind, by): (&str, &str), (vector, point): (DVec2, DVec2)) -> io::Result<()> {
        // Adding zero turns −0 into 0.
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
