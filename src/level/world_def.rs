//! A level as the engine sees it; and the ship's body as it is drawn, which red destroys: solids, pads, keys and zones act on the box around it.

use super::types::{Fluid, Level, SHIP_HALF, Solid};
use super::wiring::Worked;
use crate::physics::{Aabb, BodyDef, DVec2, FieldDef, FluidDef, Material, StreamDef, SurfaceDef, WorldDef};
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
                .map(|&Fluid { zone, density, viscosity, .. }| FluidDef { zone, density, viscosity })
                .collect(),
            bodies: std::iter::once(ship).chain(objects).collect(),
            links: self.links.iter().map(|link| link.def).collect(),
        }
    }

    fn rubbing(&self, material: Material) -> Material {
        let of = |coefficient: f64| self.friction * coefficient;
        Material { static_friction: of(material.static_friction), kinetic_friction: of(material.kinetic_friction), ..material }
    }

    /// In the order of [`Level::surface`].
    fn surfaces(&self) -> Vec<SurfaceDef> {
        let off: Vec<bool> = vec![false; self.switches.len()];
        let wires: BTreeMap<Worked, bool> = self.wires().into_iter().map(|wire| (wire.worked, wire.is_on(&off))).collect();
        let starts_on = |worked| wires.get(&worked).copied();
        let block = |&Solid { sides, belt, bounds, material, .. }: &Solid| SurfaceDef {
            sides,
            belt,
            ..SurfaceDef::fixed(bounds, self.rubbing(material))
        };
        let belt = |i, solid: &Solid| if starts_on(Worked::Belt(i)).unwrap_or(true) { solid.belt } else { 0.0 };
        let world = self.world.iter().enumerate().map(|(i, solid)| SurfaceDef { belt: belt(i, solid), ..block(solid) });
        let sources = self.streams.iter().map(|stream| SurfaceDef::fixed(stream.source, self.rubbing(Material::STEEL)));
        let movers = self.movers.iter().enumerate().map(|(i, mover)| {
            let runs = starts_on(Worked::Mover(i)).unwrap_or(true);
            SurfaceDef { path: mover.path.clone(), runs, ..block(&mover.solid) }
        });
        let open = |i| starts_on(Worked::Door(i)).unwrap_or(false);
        let doors = self.doors.iter().enumerate().map(|(i, door)| SurfaceDef { present: !open(i), ..block(door) });
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

/// Its corners with the nose up, m from its centre, clockwise: the convex hull of the hull, the fins and the nozzle of the picture. All of
/// them lie in the circle that touches the box from inside.
pub const SHIP_BODY: [DVec2; 15] = [
    DVec2::new(0.0, -0.8245),
    DVec2::new(0.1445, -0.786),
    DVec2::new(0.3145, -0.6732),
    DVec2::new(0.4632, -0.5066),
    DVec2::new(0.5738, -0.3035),
    DVec2::new(0.7565, 0.306),
    DVec2::new(0.612, 0.544),
    DVec2::new(0.1709, 0.8118),
    DVec2::new(-0.1709, 0.8118),
    DVec2::new(-0.612, 0.544),
    DVec2::new(-0.7565, 0.306),
    DVec2::new(-0.5738, -0.3035),
    DVec2::new(-0.4632, -0.5066),
    DVec2::new(-0.3145, -0.6732),
    DVec2::new(-0.1445, -0.786),
];

/// The corners of [`SHIP_BODY`] at an angle, degrees clockwise.
pub fn ship_body(angle: f64) -> [DVec2; SHIP_BODY.len()] {
    let DVec2 { x: sin, y } = nose(angle);
    SHIP_BODY.map(|corner| DVec2::new(corner.x * -y - corner.y * sin, corner.x * sin + corner.y * -y))
}

/// Whether a convex body, given by its corners about its centre in order, touches `target` anywhere while the centre moves straight from
/// `from` to `to`. The centres at which the two touch make a convex polygon whose sides have the normals of the body's sides, turned round,
/// and of the target's: the segment is clipped by one after the other (Cyrus and Beck 1978), which is exact at any speed. Touching
/// counts, and so does a gap of less than `slop`, m.
pub fn sweep_touches(corners: &[DVec2], from: DVec2, to: DVec2, target: &Aabb, slop: f64) -> bool {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let meets = |outward: DVec2| {
        let reach = corners.iter().map(|corner| outward.dot(*corner)).fold(f64::NEG_INFINITY, f64::max);
        let nearest = DVec2::select(outward.cmpge(DVec2::ZERO), target.min, target.max).dot(outward);
        // The depth of the body's farthest corner behind the target's nearest one at the start, and its growth.
        let (deep, deeper) = (reach + outward.dot(from) - nearest + slop * outward.length(), outward.dot(to - from));
        if deeper > 0.0 {
            enter = enter.max(-deep / deeper);
        } else if deeper < 0.0 {
            leave = leave.min(-deep / deeper);
        }
        (deeper != 0.0 || deep >= 0.0) && enter <= leave
    };
    let sides = (0..corners.len()).map(|i| (corners[(i + 1) % corners.len()] - corners[i]).perp() * -1.0);
    [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].into_iter().chain(sides).all(meets)
}

/// The unit vector `angle` degrees clockwise from straight up. Quarter turns are taken out first: right angles are exact, many turns cost no digits.
pub fn nose(angle: f64) -> DVec2 {
    let quarters = (angle / 90.0).round();
    let (sin, cos) = libm::sincos((angle - quarters * 90.0).to_radians());
    match quarters.rem_euclid(4.0) as u8 {
        0 => DVec2::new(sin, -cos),
        1 => DVec2::new(cos, sin),
        2 => DVec2::new(-sin, cos),
        _ => DVec2::new(-cos, -sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nose_points_where_the_angle_says() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        for (angle, expected) in [
            (0.0, DVec2::new(0.0, -1.0)),
            (90.0, DVec2::new(1.0, 0.0)),
            (180.0, DVec2::new(0.0, 1.0)),
            (270.0, DVec2::new(-1.0, 0.0)),
            (-90.0, DVec2::new(-1.0, 0.0)),
            (-360_000.0, DVec2::new(0.0, -1.0)),
        ] {
            assert_eq!(nose(angle), expected, "{angle} degrees");
        }
        for (angle, expected) in
            [(45.0, DVec2::new(half, -half)), (-45.0, DVec2::new(-half, -half)), (585.0, DVec2::new(-half, half))]
        {
            assert!(nose(angle).distance(expected) < 1e-15, "{angle} degrees: {}", nose(angle));
        }
        for angle in (-720..720).map(|tenth| f64::from(tenth) * 0.7) {
            let (sin, cos) = angle.to_radians().sin_cos();
            assert!(nose(angle).distance(DVec2::new(sin, -cos)) < 1e-14, "{angle} degrees");
        }
    }
}
