//! The telemetry file: where everything is and what acts on it, tick by tick.

use super::number::Shortest;
use crate::game::{Game, SHIP};
use crate::level::Object;
use crate::physics::{BodyId, DVec2, ForceKind};
use std::io::{self, Write};

/// The first row.
pub const HEADER: &str = "tick,time,object,kind,x,y,vx,vy,ax,ay,angle,fuel,resultant_x,resultant_y,weight_x,weight_y,drive_x,drive_y,\
    reaction_x,reaction_y,friction_x,friction_y,air_resistance_x,air_resistance_y,wind_x,wind_y,buoyancy_x,buoyancy_y,viscous_drag_x,\
    viscous_drag_y,push_x,push_y";

/// The rows of the current tick, one an object: the ship, then the objects in the level's order. Metres, m/s, m/s², N, degrees;
/// an object has neither angle nor fuel: both are 0. Forces, acceleration and resultant are those that acted during the tick that
/// led to the row; before the first tick those at the start.
pub fn write_tick(out: &mut impl Write, game: &Game) -> io::Result<()> {
    let ship = game.ship();
    write_row(out, game, SHIP, "ship", ship.angle, ship.fuel)?;
    for (body, object) in (1..).zip(&game.level().objects) {
        write_row(out, game, BodyId(body), kind(object), 0.0, 0.0)?;
    }
    Ok(())
}

fn kind(object: &Object) -> &'static str {
    if object.key.is_some() { "key" } else { "object" }
}

fn write_row(out: &mut impl Write, game: &Game, id: BodyId, kind: &str, angle: f64, fuel: f64) -> io::Result<()> {
    let (body, forces) = (game.world().body(id), game.world().forces(id));
    write!(out, "{},{},{},{kind}", game.ticks(), Shortest(game.time()), id.0)?;
    for vector in [body.position, body.velocity, body.acceleration] {
        write_vector(out, vector)?;
    }
    write!(out, ",{},{}", Shortest(angle), Shortest(fuel))?;
    write_vector(out, forces.resultant())?;
    for kind in ForceKind::ALL {
        write_vector(out, forces.total(kind))?;
    }
    writeln!(out)
}

fn write_vector(out: &mut impl Write, vector: DVec2) -> io::Result<()> {
    write!(out, ",{},{}", Shortest(vector.x), Shortest(vector.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_columns_are_those_of_the_forces_in_their_order() {
        let forces = ForceKind::ALL.map(|kind| {
            let name = kind.name().to_lowercase().replace(' ', "_");
            format!(",{name}_x,{name}_y")
        });
        assert!(HEADER.ends_with(&format!("resultant_x,resultant_y{}", forces.concat())), "{HEADER}");
    }
}
