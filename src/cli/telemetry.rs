//! The telemetry file: state and forces of each object, tick by tick.

use super::files::CsvOutput;
use crate::game::{Game, SHIP};
use crate::level::Object;
use crate::number::{Pair, Shortest, pair};
use crate::physics::{BodyId, DVec2, ForceKind, Obstacle, World};
use serde::Serialize;
use std::io::{self, Write};

pub fn header() -> String {
    let forces = ForceKind::ALL.map(|kind| format!("{0}_x,{0}_y,", column(kind))).concat();
    format!("tick,time,object,kind,x,y,vx,vy,ax,ay,angle,fuel,resultant_x,resultant_y,{forces}impulse_x,impulse_y")
}

/// Metres, m/s, m/s², N, degrees; an object has angle and fuel 0. A row describes its own instant, with the engine's drive of the
/// tick before it; only the impulse (N·s) sums all impacts since the row before.
#[derive(Serialize)]
struct BodyRow {
    tick: u64,
    time: Shortest,
    object: u32,
    kind: &'static str,
    position: Pair,
    velocity: Pair,
    acceleration: Pair,
    angle: Shortest,
    fuel: Shortest,
    resultant: Pair,
    forces: [Pair; ForceKind::ALL.len()],
    impulse: Pair,
}

pub struct Telemetry<W: Write>(CsvOutput<W>);

impl<W: Write> Telemetry<W> {
    pub fn new(out: W) -> io::Result<Self> {
        Ok(Self(CsvOutput::new(out, &header())?))
    }

    /// A row an object: the ship, then the objects in the level's order.
    pub fn write_tick(&mut self, game: &Game) -> io::Result<()> {
        let (ship, impulses) = (game.ship(), impulses(game.world()));
        self.0.row(&row(game, (SHIP, impulses[0]), "ship", (ship.angle, ship.fuel)))?;
        for ((body, object), impulse) in (1..).zip(&game.level().objects).zip(&impulses[1..]) {
            self.0.row(&row(game, (BodyId(body), *impulse), kind(object), (0.0, 0.0)))?;
        }
        Ok(())
    }

    pub fn into_inner(self) -> io::Result<W> {
        self.0.into_inner()
    }
}

/// N·s: the sum of the last tick's impacts on each body.
fn impulses(world: &World) -> Vec<DVec2> {
    let mut sums = vec![DVec2::ZERO; world.bodies().len()];
    for impulse in world.impulses() {
        sums[impulse.a.index()] += impulse.vector;
        if let Obstacle::Body(b) = impulse.b {
            sums[b.index()] -= impulse.vector;
        }
    }
    sums
}

/// A kind of force in the names of columns and rows.
pub fn column(kind: ForceKind) -> String {
    kind.name().to_lowercase().replace(' ', "_")
}

fn kind(object: &Object) -> &'static str {
    if object.key.is_some() { "key" } else { "object" }
}

fn row(game: &Game, (id, impulse): (BodyId, DVec2), kind: &'static str, (angle, fuel): (f64, f64)) -> BodyRow {
    let (body, forces) = (game.world().body(id), game.world().forces(id));
    BodyRow {
        tick: game.ticks(),
        time: Shortest(game.elapsed()),
        object: id.0,
        kind,
        position: pair(body.position),
        velocity: pair(body.velocity),
        acceleration: pair(body.acceleration),
        angle: Shortest(angle),
        fuel: Shortest(fuel),
        resultant: pair(forces.resultant()),
        forces: ForceKind::ALL.map(|kind| pair(forces.total(kind))),
        impulse: pair(impulse),
    }
}
