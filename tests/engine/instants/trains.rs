//! The end of bouncing: a train of bounces goes on, ends and is listed as if every bounce were taken one by one, whatever the tick; and where
//! friction stops a slide over tiles nothing is left of it.

use super::*;
use crate::support::{TICK, block};
use resultant::physics::{Body, BodyId, Force, Obstacle, Source};

const PULL: f64 = 15.0;

#[derive(Clone, Copy, Debug)]
struct Throw {
    height: f64,
    speed: DVec2,
    mass: f64,
    e: f64,
    friction: f64,
}

impl Throw {
    fn random(random: &mut Random) -> Self {
        Self {
            height: random.between(0.0, 2.0),
            speed: v(random.between(-9.0, 9.0), random.between(-3.0, 3.0)),
            mass: random.decades(-1.0, 2.0),
            e: random.pick(&[0.02, 0.3, 0.5, 0.7, 0.9, 0.97]),
            friction: random.pick(&[0.0, 0.02, 0.1, 0.4, 0.65, 1.0]),
        }
    }

    fn world(&self) -> World {
        let floor = SurfaceDef::fixed(area(-300.0, 0.0, 300.0, 1.0), rough(self.friction, self.friction));
        let Self { height, speed, mass, e, .. } = *self;
        let body = BodyDef { position: v(0.0, -0.5 - height), velocity: speed, mass, restitution: e, ..BodyDef::default() };
        World::new(WorldDef { gravity: PULL, ..without_air(vec![floor], vec![body]) }).unwrap()
    }

    /// The place, height and velocities at a time, bounce by bounce.
    fn at(&self, time: f64) -> [f64; 4] {
        let (mut x, mut along, mut left) = (0.0, self.speed.x, time);
        let (mut height, mut up) = (self.height, -self.speed.y);
        loop {
            let flight = (up + (up * up + 2.0 * PULL * height).sqrt()) / PULL;
            if flight > left {
                return [x + along * left, height + up * left - 0.5 * PULL * left * left, along, up - PULL * left];
            }
            (x, left) = (x + along * flight, left - flight);
            let hits = PULL * flight - up;
            let rub = (self.friction * (1.0 + self.e) * hits).min(along.abs());
            (height, up, along) = (0.0, self.e * hits, along - rub * along.signum());
            if up < 1e-13 {
                let stops = along.abs() / (self.friction * PULL);
                let slides = left.min(stops);
                let slower = along - along.signum() * self.friction * PULL * slides;
                let slower = if left >= stops { 0.0 } else { slower };
                return [x + 0.5 * (along + slower) * slides, 0.0, slower, 0.0];
            }
        }
    }
}

fn found(world: &World) -> [f64; 4] {
    let (place, speed) = (world.at(0), world.speed(0));
    [place.x, -0.5 - place.y, speed.x, -speed.y]
}

/// What the lists of a tick leave over of a body's change of momentum under its weight alone, N·s.
fn unlisted(world: &World, id: BodyId, before: DVec2, dt: f64) -> f64 {
    let Body { mass, velocity, .. } = *world.body(id);
    ((velocity - before - v(0.0, PULL * dt)) * mass - given_to(world, id)).length()
}

/// The impulses listed of a tick on a body, N·s.
fn given_to(world: &World, id: BodyId) -> DVec2 {
    world.impulses().iter().filter_map(|hit| hit.on(id)).map(|(given, _)| given).sum()
}

fn in_contact(world: &World, id: BodyId) -> bool {
    world.forces(id).forces().len() > 1
}

fn given_up(world: &World) -> (u64, u64) {
    (world.guards().bounces_ended, world.guards().budgets_used_up)
}

/// A light body at rest and one `ratio` times as heavy that comes to it from a side: the light one's mass, kg, where both are less their
/// widths, m, and the speed, m/s.
fn nearing(random: &mut Random, ratio: f64, side: f64, y: f64) -> ([f64; 4], Vec<BodyDef>) {
    let (mass, near) = (random.decades(-2.0, 0.0), random.between(0.0, 2.0));
    let (far, comes) = (near + random.between(0.2, 2.0), random.between(0.3, 3.0));
    let at = |x: f64, mass: f64, speed: f64| elastic(v(side * x, y), mass, side * speed);
    ([mass, near, far, comes], vec![at(near + 0.5, mass, 0.0), at(far + 1.5, mass * ratio, -comes)])
}

/// Three crates on each other and on the floor: what changes the momentum of one that touches nothing as a tick ends is listed. Returns the first that is not, if one is.
fn unlisted_of_three(random: &mut Random, hz: f64) -> Option<(u32, f64)> {
    let body = |k: i32| BodyDef {
        position: v(0.0, -1.0 - 1.3 * f64::from(k)),
        mass: random.decades(-1.0, 2.0),
        restitution: random.between(0.1, 1.0),
        velocity: v(0.0, random.between(-2.0, 2.0)),
        ..BodyDef::default()
    };
    let floor = SurfaceDef::fixed(area(-300.0, 0.0, 300.0, 1.0), rough(0.4, 0.4));
    let bodies: Vec<_> = (0..3).map(body).collect();
    let mut world = World::new(WorldDef { gravity: PULL, ..without_air(vec![floor], bodies) }).unwrap();
    for tick in 1..=(2.0 * hz) as u32 {
        let before = [0, 1, 2].map(|i| world.speed(i));
        world.step(1.0 / hz);
        for hit in world.impulses() {
            let on_floor = matches!(hit.b, Obstacle::Surface(_));
            assert!(!on_floor || hit.vector.y <= 0.0, "{hz} Hz, tick {tick}: {hit:?} pulls");
        }
        for (i, speed) in (0..).zip(before).filter(|(i, _)| !in_contact(&world, BodyId(*i))) {
            let left = unlisted(&world, BodyId(i), speed, 1.0 / hz);
            if left > 1e-9 * world.body(BodyId(i)).mass {
                return Some((tick, left));
            }
        }
    }
    None
}

/// What stops just as a tick ends stays where it is: a crate alone, and one with another on it.
#[test]
fn a_slide_that_ends_with_a_tick_is_not_driven_back() {
    for hz in [64.0, 60.0, 120.0] {
        for friction in [0.5, 0.65] {
            for ticks in 1..60 {
                stops_with_a_tick(hz, friction, ticks, &[66.0]);
                stops_with_a_tick(hz, friction, ticks, &[66.0, 61.0]);
            }
        }
    }
}

/// Crates of these masses (kg), each on the one before, that slide to a stop in just that many ticks under 10 m/s².
fn stops_with_a_tick(hz: f64, friction: f64, ticks: u32, masses: &[f64]) {
    let velocity = v(-friction * 10.0 * f64::from(ticks) / hz, 0.0);
    let body = |(k, &mass): (usize, &f64)| {
        let position = v(0.4 * k as f64, -0.5 - k as f64);
        BodyDef { position, velocity, mass, ..BodyDef::default() }
    };
    let bodies = masses.iter().enumerate().map(body).collect();
    let floor = SurfaceDef::fixed(area(-300.0, 0.0, 300.0, 1.0), rough(friction, friction));
    let mut world = World::new(WorldDef { gravity: 10.0, ..without_air(vec![floor], bodies) }).unwrap();
    let scene = format!("{masses:?} kg at {hz} Hz, {friction}, {ticks} ticks");
    for _ in 0..ticks + 3 {
        world.step(1.0 / hz);
        assert!((0..masses.len()).all(|i| world.speed(i).x <= 0.0), "{scene}: {}", world.speed(0));
    }
    assert!(world.speed(0) == DVec2::ZERO, "{scene}: {}", world.speed(0));
}

/// Some of a row hit a ceiling as they slide along it, and one has pressed on it by less than nothing, by a rounding: what it rubbed is listed.
#[test]
fn a_row_that_slides_along_a_ceiling_is_listed() {
    let row = [
        ((-1.6025884795406407, -0.5), 7.163359812573355e-18, 1.8039726551356547, 0.2031066448938244, Material::ASPHALT),
        ((-2.602588479540641, -0.12029198194794465), -2.1152382640633345, 1.1869570691603943, 0.203344317297006, Material::WOOD),
        ((-3.6025884804142607, -0.4999940487782114), 0.0, 0.07054337345078661, 0.5103374263753958, Material::ASPHALT),
        ((-4.602588480749765, -0.4999999995391942), 0.0, 0.08469903479126592, 0.20531588823942157, Material::RUBBER),
        ((-5.60258848104909, -0.49109828475930756), -2.220558147725464, 9.543503015449184, 0.2127404961045022, Material::ASPHALT),
    ];
    let body = |((x, y), speed, mass, restitution, material)| {
        let velocity = v(3.096012961054195, speed);
        BodyDef { position: v(x, y), velocity, mass, restitution, material, ..BodyDef::default() }
    };
    let fields = vec![FieldDef { zone: area(-1e3, -1e3, 1e3, 1e3), strength: v(15.0, 0.0) }];
    let def = WorldDef { gravity: 0.0, fields, ..without_air(vec![block(-60.0, -2.0, 0.0, -1.0)], row.map(body).to_vec()) };
    let mut world = World::new(def).unwrap();
    for tick in 0..3 {
        let before = [0, 1, 2, 3, 4].map(|i| world.speed(i));
        world.step(TICK);
        assert!((0..5).all(|i| world.at(i).y >= -0.5 - 1e-9 && world.speed(i).x > 0.0));
        for (i, before) in before.into_iter().enumerate() {
            let id = BodyId(i as u32);
            let left = (world.speed(i) - before) * world.body(id).mass - given_to(&world, id) - world.forces(id).resultant() * TICK;
            assert!(left.length() < 1e-12, "tick {tick}, body {i}: {left} N·s are not listed");
        }
    }
}

/// Crates that slide over each other, hit each other and a wall on either side: what has changed the momentum of one on which the same forces act
/// before and after a tick, and that nothing has hit, is listed. Returns the first that is not, if one is.
fn unlisted_of_slides(random: &mut Random, hz: f64) -> Option<String> {
    let mut crates = Vec::new();
    for k in 0..6 {
        let position = v(1.2 * f64::from(k % 3) + random.between(-0.04, 0.04), -0.6 - 1.2 * f64::from(k / 3));
        let half = v(random.between(0.2, 0.55), random.between(0.2, 0.55));
        let (mass, restitution) = (random.decades(-1.0, 1.5), random.pick(&[0.0, 0.4]));
        let velocity = v(random.between(-2.0, 2.0), random.between(-2.0, 2.0));
        let friction = random.between(0.02, 0.9);
        let material = rough(friction, friction);
        crates.push(BodyDef { position, half, mass, restitution, velocity, material, ..BodyDef::default() });
    }
    let walls = [area(-40.0, 0.0, 40.0, 1.0), area(-2.0, -40.0, -1.0, 0.0), area(3.6, -40.0, 4.6, 0.0)];
    let surfaces = walls.map(|wall| SurfaceDef::fixed(wall, rough(0.4, 0.3))).to_vec();
    let mut world = World::new(WorldDef { gravity: PULL, ..without_air(surfaces, crates) }).unwrap();
    let ids = [0, 1, 2, 3, 4, 5].map(BodyId);
    let pushes = |world: &World, id: BodyId| -> Vec<Force> {
        world.forces(id).forces().iter().filter(|force| force.source != Source::Gravity).copied().collect()
    };
    for tick in 1..=(2.0 * hz) as u32 {
        let before = ids.map(|id| (world.body(id).velocity, pushes(&world, id)));
        world.step(1.0 / hz);
        for (id, (speed, push)) in ids.into_iter().zip(before) {
            let hit = world.impulses().iter().any(|hit| hit.impact && hit.on(id).is_some());
            let total: DVec2 = push.iter().map(|force| force.vector).sum();
            let left = unlisted(&world, id, speed + total / (hz * world.body(id).mass), 1.0 / hz);
            if !hit && push == pushes(&world, id) && left > 1e-9 * world.body(id).mass {
                return Some(format!("{id:?} at {hz} Hz, tick {tick}: {left} N·s"));
            }
        }
    }
    None
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn lists_of_any_three_that_bounce_add_up(seed in any::<u64>(), hz in rates()) {
        prop_assert_eq!(unlisted_of_three(&mut Random(seed), hz), None);
        prop_assert_eq!(unlisted_of_slides(&mut Random(seed), hz), None);
    }

    #[test]
    fn a_thrown_crate_stops_where_its_bounces_say(seed in any::<u64>(), hz in rates()) {
        let throw = Throw::random(&mut Random(seed));
        let mut world = throw.world();
        let id = BodyId(0);
        for tick in 1..=(6.0 * hz) as u32 {
            let (before, lay) = (world.speed(0), in_contact(&world, id));
            world.step(1.0 / hz);
            let (found, exact) = (found(&world), throw.at(f64::from(tick) / hz));
            let off = [0, 1].map(|k| (found[k] - exact[k]).abs());
            prop_assert!(off[0].max(off[1]) <= 1e-9, "{:?}, tick {}: {:?}, not {:?}", throw, tick, found, exact);
            prop_assert!((found[2] - exact[2]).abs() <= 1e-9 && (exact[2] != 0.0 || found[2] == 0.0), "tick {}: {:?}, not {:?}", tick, found, exact);
            for hit in world.impulses() {
                prop_assert!(hit.vector.y <= 0.0 && hit.vector.x.abs() <= throw.friction * -hit.vector.y * (1.0 + 1e-9), "tick {}: {:?}", tick, hit);
            }
            if !lay && !in_contact(&world, id) {
                let left = unlisted(&world, id, before, 1.0 / hz);
                prop_assert!(left <= 1e-9 * throw.mass, "{:?}, tick {}: {} N·s", throw, tick, left);
            }
        }
        prop_assert_eq!(world.guards().bounces_ended, 0);
    }

    /// A crate in space that is driven against another one, and bounces on it: after each bounce the gap and the speeds are those of one bounce after the other.
    #[test]
    fn a_pair_that_a_drive_presses_together_bounces_like_one_on_the_ground(seed in any::<u64>(), e in prop::sample::select(vec![0.5, 0.9, 1.0]), hz in rates()) {
        let random = &mut Random(seed);
        let masses = [random.decades(-1.0, 1.0), random.decades(-1.0, 1.0)];
        let (drive, gap, apart) = (random.between(5.0, 30.0), random.between(0.0, 0.02), random.between(0.0, 0.05));
        let at = |x: f64, k: usize, speed: f64| BodyDef { restitution: e, ..elastic(v(x, 0.0), masses[k], speed) };
        let mut world = World::new(in_space(vec![], vec![at(0.0, 0, 0.0), at(1.0 + gap, 1, apart)])).unwrap();
        world.drive(0, drive, 0.0);
        let pull = drive / masses[0];
        for tick in 1..=hz as u32 {
            world.step(1.0 / hz);
            let time = f64::from(tick) / hz;
            let (mut height, mut up, mut left) = (gap, apart, time);
            let exact = loop {
                let flight = (up + (up * up + 2.0 * pull * height).sqrt()) / pull;
                if flight > left {
                    break height + up * left - 0.5 * pull * left * left;
                }
                (height, up, left) = (0.0, e * (pull * flight - up), left - flight);
                if up < 1e-13 {
                    break 0.0;
                }
            };
            let found = world.at(1).x - world.at(0).x - 1.0;
            prop_assert!((found - exact).abs() <= 1e-9, "{:?} kg, tick {}: {} m, not {} m", masses, tick, found, exact);
            let (momentum, whole) = (masses[0] * world.speed(0).x + masses[1] * world.speed(1).x, drive * time + masses[1] * apart);
            prop_assert!((momentum - whole).abs() <= 1e-9, "tick {}: {} N·s, not {} N·s", tick, momentum, whole);
        }
        prop_assert_eq!(given_up(&world), (0, 0));
    }

    /// One goes to and fro between a wall and a heavy one that comes: up to 31 415 hits.
    #[test]
    fn what_is_between_a_wall_and_something_heavy_bounces_without_loss(seed in any::<u64>(), power in 0.0..8.0f64, hz in rates()) {
        let random = &mut Random(seed);
        let (ratio, side) = (10f64.powf(power), random.pick(&[-1.0, 1.0]));
        let ([mass, near, far, comes], rows) = nearing(random, ratio, side, 0.0);
        let wall = SurfaceDef::fixed(if side > 0.0 { area(-1.0, -9.0, 0.0, 9.0) } else { area(0.0, -9.0, 1.0, 9.0) }, Material::ICE);
        let mut world = World::new(in_space(vec![wall], rows)).unwrap();
        // Places less the widths: the light one at `x`, the heavy one at `y`.
        let (mut x, mut y, mut u, mut w, mut now) = (near, far, 0.0, -comes, 0.0);
        let mut hits = 0;
        for tick in 1..=(4.0 * hz) as u32 {
            world.step(1.0 / hz);
            let end = f64::from(tick) / hz;
            loop {
                let to_wall = if u < 0.0 { x / -u } else { f64::INFINITY };
                let to_other = if u > w { (y - x).max(0.0) / (u - w) } else { f64::INFINITY };
                let next = to_wall.min(to_other).min(end - now);
                (x, y, now) = (x + u * next, y + w * next, now + next);
                if to_wall.min(to_other) > next {
                    break;
                }
                hits += 1;
                if to_wall <= to_other {
                    (x, u) = (0.0, -u);
                } else {
                    let part = 2.0 * (u - w) / (1.0 + ratio);
                    (u, w, x) = (u - ratio * part, w + part, y);
                }
            }
            now = end;
            let [light, heavy] = [0, 1].map(|i| side * world.speed(i).x);
            prop_assert!((heavy - w).abs() <= 1e-6, "ratio {}, tick {} at {} Hz, {} hits: {} m/s, not {} m/s", ratio, tick, hz, hits, heavy, w);
            let energy = 0.5 * mass * (light * light + ratio * heavy * heavy);
            prop_assert!((energy / (0.5 * mass * ratio * comes * comes) - 1.0).abs() <= 1e-9, "ratio {}, tick {}: {} J", ratio, tick, energy);
            prop_assert!((side * world.at(1).x - 1.5 - y).abs() <= 1e-6);
        }
        prop_assert_eq!(given_up(&world), (0, 0));
        let [light, heavy] = [0, 1].map(|i| side * world.speed(i).x);
        prop_assert!((light - u).abs() <= 1e-4 && (heavy - w).abs() <= 1e-6, "{} and {} m/s, not {} and {}", light, heavy, u, w);
    }

    /// On a smooth floor, and where drives differ, nothing of that is lost either: the energy is what the drives have given.
    #[test]
    fn what_is_driven_on_a_smooth_floor_bounces_to_and_fro_without_loss(seed in any::<u64>(), power in 0.0..8.0f64, hz in rates()) {
        let random = &mut Random(seed);
        let (ratio, drive) = (10f64.powf(power), random.between(-2.0, 2.0));
        let pushed = [0.0, random.pick(&[0.0, drive])];
        let ([mass, _, _, comes], bodies) = nearing(random, ratio, 1.0, -0.5);
        let surfaces = [area(-1.0, -9.0, 0.0, 0.0), area(-1.0, 0.0, 90.0, 1.0)].map(|of| SurfaceDef::fixed(of, rough(0.0, 0.0)));
        let mut world = World::new(WorldDef { gravity: PULL, ..without_air(surfaces.to_vec(), bodies) }).unwrap();
        let masses = [mass, mass * ratio];
        (0..2).for_each(|i| world.set_drive(BodyId(i as u32), v(masses[i] * pushed[i], 0.0)));
        let energy = |world: &World| -> f64 {
            (0..2).map(|i| masses[i] * (0.5 * world.speed(i).x * world.speed(i).x - pushed[i] * world.at(i).x)).sum()
        };
        let (begun, scale) = (energy(&world), 0.5 * mass * ratio * (comes * comes + 20.0 * pushed[1].abs()));
        for tick in 1..=(3.0 * hz) as u32 {
            world.step(1.0 / hz);
            let gained = energy(&world) - begun;
            prop_assert!(gained.abs() <= 1e-9 * scale, "ratio {}, tick {} at {} Hz: {} J of {} J", ratio, tick, hz, gained, scale);
            prop_assert!(world.speed(0).y == 0.0 && world.speed(1).y == 0.0);
        }
        prop_assert_eq!(given_up(&world), (0, 0));
    }

    /// A light one between the floor and a heavy one that falls on it: whatever the tick, and without loss.
    #[test]
    fn what_is_under_something_heavy_that_falls_bounces_without_loss(seed in any::<u64>(), power in 0.0..6.0f64, hz in rates()) {
        let random = &mut Random(seed);
        let at = |height: f64, mass: f64| elastic(v(0.0, -0.5 - height), mass, 0.0);
        let (low, gap, mass) = (random.between(0.0, 0.5), random.between(0.5, 2.0), random.decades(-2.0, 0.0));
        let bodies = vec![at(low, mass), at(low + 1.0 + gap, mass * 10f64.powf(power))];
        let floor = || SurfaceDef::fixed(area(-9.0, 0.0, 9.0, 1.0), Material::ICE);
        let [mut world, mut fine] =
            [0, 1].map(|_| World::new(WorldDef { gravity: PULL, ..without_air(vec![floor()], bodies.clone()) }).unwrap());
        let energy = |world: &World| -> f64 {
            world.bodies().iter().map(|body| body.mass * (0.5 * body.velocity.y * body.velocity.y - PULL * body.position.y)).sum()
        };
        let begun = energy(&world);
        for tick in 1..=hz as u32 {
            world.step(1.0 / hz);
            fine.steps(8, 0.125 / hz);
            prop_assert!((energy(&world) / begun - 1.0).abs() <= 1e-9, "tick {}: {} J", tick, energy(&world) - begun);
            prop_assert!((world.at(1).y - fine.at(1).y).abs() <= 1e-6, "tick {}: {} m", tick, world.at(1).y - fine.at(1).y);
        }
        prop_assert_eq!(given_up(&world), (0, 0));
    }
}

proptest! {
    #![proptest_config(cases(40))]

    /// Tiles of a third of the body's width are hit together.
    #[test]
    fn what_slides_over_tiles_is_only_slowed(seed in any::<u64>(), hz in rates()) {
        let random = &mut Random(seed);
        let (width, material) = (random.between(0.25, 0.3), random.pick(&Material::FIRM));
        let tile = |i: i32| SurfaceDef::fixed(area(width * f64::from(i), 0.0, width * f64::from(i + 1), 1.0), material);
        let body = BodyDef {
            position: v(4.0, -0.4 - random.between(0.5, 3.0)),
            half: DVec2::splat(0.4),
            velocity: v(random.between(0.3, 3.0), 0.0),
            mass: random.decades(-1.0, 2.0),
            restitution: random.between(0.3, 0.9),
            material: random.pick(&Material::FIRM),
            ..BodyDef::default()
        };
        let mut world = World::new(without_air((0..120).map(tile).collect(), vec![body])).unwrap();
        let mut before = world.speed(0).x;
        for tick in 0..(6.0 * hz) as u32 {
            world.step(1.0 / hz);
            let speed = world.speed(0).x;
            prop_assert!((0.0..=before).contains(&speed), "tick {}: {} m/s after {} m/s", tick, speed, before);
            before = speed;
        }
    }
}
