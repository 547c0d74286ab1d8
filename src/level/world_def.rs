//! A level as the engine sees it.
//!
//! From way points to a path: how long each leg of a mover takes.

use super::types::{Level, Route, SHIP_HALF, Solid};
use super::wiring::Worked;
use crate::physics::{Aabb, BodyDef, DVec2, FieldDef, FluidDef, Leg, Material, Path, StreamDef, SurfaceDef, WorldDef};
use std::collections::BTreeMap;

/// The reach of its own sideways gravity beyond the level, in sizes of the level: no body comes near its end.
const BEYOND: f64 = 2.0;

impl Level {
    /// m.
    pub fn bounds(&self) -> Aabb {
        Aabb::new(DVec2::ZERO, self.size)
    }

    /// False in an experiment: the ship is [parked](super::types::ShipStart::PARKED) there, and neither fuel nor time nor score matter.
    pub const fn ship_plays(&self) -> bool {
        !self.experiment
    }

    /// The world before the first switch is pressed, but all streams blow. Body 0 is the ship, body i + 1 is object i; [`Level::surface`]
    /// names the surfaces; stream i and liquid i are the level's.
    pub fn world_def(&self) -> WorldDef {
        let ship = BodyDef {
            position: self.player.position,
            velocity: self.player.velocity,
            half: SHIP_HALF,
            mass: self.player.mass,
            drag: self.player.drag,
            restitution: self.player.restitution,
            feels_air: self.player.feels_air,
            material: self.rubbing(self.player.material),
            weightless: !self.ship_plays(),
            ..BodyDef::default()
        };
        let objects = self.objects.iter().map(|object| BodyDef {
            position: object.position,
            velocity: object.velocity,
            half: object.size * 0.5,
            mass: object.mass,
            drag: object.drag,
            round: object.circular,
            restitution: object.restitution,
            material: self.rubbing(object.material),
            weightless: object.weightless,
            ..BodyDef::default()
        });
        WorldDef {
            gravity: self.gravity,
            air_density: self.air_density,
            rest_speed: self.rest_speed,
            bounds: Some(self.bounds()),
            edge: self.rubbing(Material::ASPHALT),
            surfaces: self.surfaces(),
            streams: self.streams.iter().map(|stream| StreamDef { zone: stream.zone, force: stream.force }).collect(),
            fields: self.fields(),
            fluids: self
                .fluids
                .iter()
                .map(|fluid| FluidDef { zone: fluid.zone, density: fluid.density, viscosity: fluid.viscosity })
                .collect(),
            bodies: std::iter::once(ship).chain(objects).collect(),
            links: self.links.iter().map(|link| link.def).collect(),
        }
    }

    fn rubbing(&self, material: Material) -> Material {
        let Material { static_friction, kinetic_friction, .. } = material;
        Material {
            static_friction: self.friction * static_friction,
            kinetic_friction: self.friction * kinetic_friction,
            ..material
        }
    }

    /// In the order of [`Level::surface`].
    fn surfaces(&self) -> Vec<SurfaceDef> {
        let off: Vec<bool> = vec![false; self.switches.len()];
        let wires: BTreeMap<Worked, bool> = self.wires().into_iter().map(|wire| (wire.worked, wire.is_on(&off))).collect();
        let starts_on = |worked| wires.get(&worked).copied();
        let block = |solid: &Solid| SurfaceDef {
            sides: solid.sides,
            belt: solid.belt,
            ..SurfaceDef::fixed(solid.bounds, self.rubbing(solid.material))
        };
        let world = self.world.iter().enumerate().map(|(i, solid)| {
            let runs = starts_on(Worked::Belt(i)).unwrap_or(true);
            SurfaceDef { belt: if runs { solid.belt } else { 0.0 }, ..block(solid) }
        });
        let sources = self.streams.iter().map(|stream| SurfaceDef::fixed(stream.source, self.rubbing(Material::STEEL)));
        let movers = self.movers.iter().enumerate().map(|(i, mover)| {
            let runs = starts_on(Worked::Mover(i)).unwrap_or(true);
            SurfaceDef { path: mover.path.clone(), runs, ..block(&mover.solid) }
        });
        let doors = self.doors.iter().enumerate().map(|(i, door)| {
            let open = starts_on(Worked::Door(i)).unwrap_or(false);
            SurfaceDef { present: !open, ..block(door) }
        });
        let plates = self.plates().map(|switch| SurfaceDef::fixed(self.switches[switch].bounds, self.rubbing(Material::STEEL)));
        world.chain(sources).chain(movers).chain(doors).chain(plates).collect()
    }

    /// The zones of gravity.csv, then the level's own sideways gravity.
    fn fields(&self) -> Vec<FieldDef> {
        let zones = self.fields.iter().map(|field| FieldDef { zone: field.zone, strength: field.strength });
        let everywhere = Aabb::new(-self.size * BEYOND, self.size * (1.0 + BEYOND));
        let sideways = FieldDef { zone: everywhere, strength: DVec2::new(self.gravity_x, 0.0) };
        zones.chain((self.gravity_x != 0.0).then_some(sideways)).collect()
    }
}

/// s. The shortest wait, easing or leg: the engine refuses shorter ones.
pub(super) const SHORTEST: f64 = 1e-3;

/// Either its speed or its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoverPace {
    /// Between its easings, m/s.
    Speed(f64),
    /// For the whole route, waits included, s.
    Period(f64),
}

/// How a mover goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RouteShape {
    pub route: Route,
    pub pace: MoverPace,
    /// At each stop, s.
    pub wait: f64,
    /// To get to its speed, and to stop, s.
    pub ease: f64,
}

/// The path from the first stop through the others, which differ from their neighbours.
/// Errors: the shortest possible period, s, where the given one is too short.
pub(super) fn path(stops: &[DVec2], manner: RouteShape) -> Result<Path, f64> {
    let RouteShape { route, wait, ease, .. } = manner;
    let moves = moves(stops, route);
    let speed = speed(&moves, manner)?;
    let mut legs = Vec::new();
    let mut leg = |duration: f64, velocity: DVec2, acceleration: DVec2| {
        if duration > 0.0 {
            legs.push(Leg { duration, velocity, acceleration });
        }
    };
    for step in moves {
        let cruise = step.length() / speed - ease;
        // A move too short for its speed is all easing.
        let (cruise, velocity) =
            if cruise < SHORTEST && ease > 0.0 { (0.0, step / ease) } else { (cruise, step / (cruise + ease)) };
        let pull = if ease > 0.0 { velocity / ease } else { DVec2::ZERO };
        leg(wait, DVec2::ZERO, DVec2::ZERO);
        leg(ease, DVec2::ZERO, pull);
        leg(cruise, velocity, DVec2::ZERO);
        leg(ease, velocity, -pull);
    }
    Ok(Path { legs, repeats: route != Route::Once })
}

/// From stop to stop, in order, m.
fn moves(stops: &[DVec2], route: Route) -> Vec<DVec2> {
    let there = stops.windows(2).map(|pair| pair[1] - pair[0]);
    let back = there.clone().rev().map(|step| -step);
    match (route, stops) {
        (Route::Once, _) => there.collect(),
        (Route::Round, [first, .., last]) if first != last => there.chain([*first - *last]).collect(),
        (Route::Round, _) => there.collect(),
        (Route::Back, _) => there.chain(back).collect(),
    }
}

/// m/s.
fn speed(moves: &[DVec2], RouteShape { pace, wait, ease, .. }: RouteShape) -> Result<f64, f64> {
    let period = match pace {
        MoverPace::Speed(speed) => return Ok(speed),
        MoverPace::Period(period) => period,
    };
    let all: f64 = moves.iter().map(|step| step.length()).sum();
    let shortest = moves.iter().map(|step| step.length()).fold(f64::INFINITY, f64::min);
    // Each move takes its length over the speed, and one easing; the shortest still has to get to the speed.
    let standing = moves.len() as f64 * (wait + ease);
    let fastest = shortest / (ease + SHORTEST);
    let least = standing + all / fastest;
    if period < least { Err(least) } else { Ok(all / (period - standing)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STOPS: [DVec2; 3] = [DVec2::new(1.0, 1.0), DVec2::new(7.0, 1.0), DVec2::new(7.0, 4.0)];

    fn manner(route: Route, pace: MoverPace) -> RouteShape {
        RouteShape { route, pace, wait: 0.5, ease: 1.0 }
    }

    fn duration(path: &Path) -> f64 {
        path.legs.iter().map(|leg| leg.duration).sum()
    }

    fn end(path: &Path) -> DVec2 {
        path.legs.iter().map(|leg| (leg.velocity + leg.acceleration * (0.5 * leg.duration)) * leg.duration).sum()
    }

    #[test]
    fn every_way_takes_its_length_over_the_speed_and_an_easing() {
        for (route, seconds, ends) in [
            (Route::Once, 2.0 * 1.5 + 9.0 / 2.0, DVec2::new(6.0, 3.0)),
            (Route::Back, 4.0 * 1.5 + 18.0 / 2.0, DVec2::ZERO),
            (Route::Round, 3.0 * 1.5 + (9.0 + 45f64.sqrt()) / 2.0, DVec2::ZERO),
        ] {
            let path = path(&STOPS, manner(route, MoverPace::Speed(2.0))).unwrap();
            assert!((duration(&path) - seconds).abs() < 1e-12, "{route:?}");
            assert!(end(&path).distance(ends) < 1e-12, "{route:?}");
            assert_eq!(path.repeats, route != Route::Once);
        }
    }

    #[test]
    fn a_period_gives_the_speed() {
        let timed = path(&STOPS, manner(Route::Back, MoverPace::Period(15.0))).unwrap();
        assert_eq!(timed, path(&STOPS, manner(Route::Back, MoverPace::Speed(2.0))).unwrap());
        let least = path(&STOPS, manner(Route::Back, MoverPace::Period(1.0))).unwrap_err();
        assert!((duration(&path(&STOPS, manner(Route::Back, MoverPace::Period(least))).unwrap()) - least).abs() < 1e-9);
    }

    #[test]
    fn what_is_too_short_for_its_speed_is_eased_all_the_way() {
        let short = [DVec2::ZERO, DVec2::new(0.5, 0.0)];
        let path = path(&short, manner(Route::Once, MoverPace::Speed(2.0))).unwrap();
        assert_eq!(path.legs.len(), 3);
        assert_eq!(path.legs[1].acceleration, DVec2::new(0.5, 0.0));
        assert!(end(&path).distance(short[1]) < 1e-15);
    }
}
