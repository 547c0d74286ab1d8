//! Ropes, hooks and winches, and pans that hang and bear.

use super::*;

/// Kinetic energy, height and stretch keep their sum over 1000 swings, and the period is that of the elliptic integral.
#[test]
fn a_swing_without_loss_keeps_its_energy() {
    let (m, g, k, length) = (50.0, 5.0, 5e4, 6.0);
    let start = DVec2::new(length * 0.6, length * 0.8);
    let mut world = world(g, vec![body(start.x, start.y, m)], Vec::new());
    hung(&mut world, DVec2::ZERO, rope(length, k, 0.0));
    let energy = |world: &World| {
        let stretch = (world.at(0).length() - length).max(0.0);
        measured(world, g, 0.0) + 0.5 * k * stretch * stretch
    };
    // Heights count from the lowest point: 1.2 m.
    let (begun, scale) = (energy(&world), m * g * 1.2);
    let (mut turns, mut before) = (0, world.speed(0).x);
    for tick in 0..900_000 {
        world.step(DT);
        let off = (energy(&world) - begun).abs() / scale;
        assert!(off < 1e-9, "{off} after {turns} swings, tick {tick}");
        let now = world.speed(0).x;
        turns += u32::from(before * now < 0.0);
        before = now;
        if turns == 2000 {
            return;
        }
    }
    panic!("{turns} turns");
}

/// A ball is thrown up from a slack rope's anchor, and the rope becomes taut on the way down at an instant within a tick.
#[test]
fn a_rope_never_pushes_and_becomes_taut_within_a_tick() {
    for hz in [30.0, 120.0, 333.0] {
        let (m, g, k, length) = (2.0, 10.0, 3000.0, 1.0);
        let mut world = world(g, vec![body(0.0, 0.5, m)], Vec::new());
        hung(&mut world, DVec2::ZERO, rope(length, k, 0.0));
        // Free fall over 0.5 m, then a spring that is hit at v, and let go at the same height.
        let (fall, omega) = ((2.0 * 0.5 / g).sqrt(), (k / m).sqrt());
        let (v, sag) = (g * fall, g / (omega * omega));
        let taut = (2.0 / omega) * (std::f64::consts::PI - (v / (omega * sag)).atan());
        let period = 2.0 * fall + taut;
        for tick in 1..=(hz * 20.0) as u32 {
            world.step(1.0 / hz);
            let t = (f64::from(tick) / hz) % period;
            let exact = if t < fall {
                0.5 + 0.5 * g * t * t
            } else if t < fall + taut {
                let s = t - fall;
                length + sag - sag * (omega * s).cos() + v / omega * (omega * s).sin()
            } else {
                let s = period - t;
                0.5 + 0.5 * g * s * s
            };
            assert!((world.at(0).y - exact).abs() < 1e-8, "{hz} Hz, tick {tick}: {}, not {exact}", world.at(0).y);
            let tension = world.forces(A).total(ForceKind::Tension).y;
            assert!(tension <= 0.0, "the rope pushes with {tension} N");
            assert_eq!(tension < 0.0, world.at(0).y > length);
        }
    }
}

#[test]
fn a_hook_takes_hold_where_its_ends_touch() {
    let moving = BodyDef { velocity: DVec2::new(2.0, 0.0), restitution: 1.0, ..body(0.0, 0.0, 1.0) };
    let mut world = world(0.0, vec![moving, BodyDef { restitution: 1.0, ..body(1.0, 0.0, 1.0) }], Vec::new());
    let tow = LinkDef { hook: true, as_found: true, ..LinkDef::new(A, LinkEnd::Body(B), rope(0.0, 500.0, 0.0)) };
    world.link(tow).unwrap();
    world.steps(47, DT);
    assert!(!world.links()[0].acts());
    world.steps(2, DT);
    assert!(world.links()[0].acts());
    // The blow has passed the motion on; the rope keeps both together from then on.
    let begun = world.links()[0].law().length().unwrap();
    assert!((begun - 0.2).abs() < 0.02, "{begun} m");
    let mut farthest: f64 = 0.0;
    for _ in 0..600 {
        world.step(DT);
        farthest = farthest.max(world.at(1).x - world.at(0).x);
        assert!((world.speed(0).x + world.speed(1).x - 2.0).abs() < 1e-9);
    }
    assert!(farthest < begun + 0.1, "{farthest} m");
    world.set_linked(0, false);
    world.steps(10, DT);
    assert!(!world.links()[0].acts() && world.forces(A).forces().is_empty());
}

/// A steady winch lifts with the weight of its load, and stops where its length ends.
#[test]
fn a_winch_lifts_its_load() {
    let (m, g, k) = (10.0, 10.0, 4e4);
    let mut world = world(g, vec![body(0.0, 8.0, m)], Vec::new());
    let hoist = LinkDef { rate: -1.5, ..LinkDef::new(A, LinkEnd::Place(DVec2::ZERO), rope(8.0, k, 600.0)) };
    world.link(hoist).unwrap();
    world.set_winding(0, false);
    world.steps(600, DT);
    assert_eq!(world.methods().asleep, 1);
    let before = world.at(0).y;
    world.set_winding(0, true);
    world.steps(240, DT);
    assert!((before - world.at(0).y - 3.0).abs() < 0.05 && (world.speed(0).y + 1.5).abs() < 1e-6, "{}", world.at(0));
    world.set_winding(0, false);
    let length = world.links()[0].law().length().unwrap();
    assert!((length - 5.0).abs() < 1e-9, "{length} m");
    world.steps(1200, DT);
    assert_eq!(world.speed(0), DVec2::ZERO);
}

/// A winch on a flying ship drags a crate along a floor against a step, until its rope breaks: the forces listed are those of one instant, and the
/// energy of the crate is what they gave it (`World::validate`).
#[test]
fn a_winch_drags_a_load_until_its_rope_breaks() {
    for (material, gravity, breaks) in [(Material::WOOD, 10.0, 900.0), (Material::ICE, 10.0, 700.0), (Material::WOOD, 0.0, 400.0)] {
        let ship = BodyDef { half: DVec2::splat(0.5), weightless: true, ..body(-6.0, -3.0, 100.0) };
        let load = BodyDef { half: DVec2::splat(0.5), restitution: 0.3, ..body(3.0, -0.5, 60.0) };
        let surfaces = vec![SurfaceDef { material, ..floor() }, block(-2.0, -0.4, -1.0, 0.0)];
        let mut world = world(gravity, vec![ship, load], surfaces);
        let rope = LinkDef { rate: -1.5, breaks: Some(breaks), ..LinkDef::new(A, LinkEnd::Body(B), rope(9.5, 2000.0, 100.0)) };
        world.link(rope).unwrap();
        let (mut dragged, mut snapped) = (false, None);
        for tick in 0..1200 {
            let hold = (DVec2::new(-6.0, -3.0) - world.at(0)) * 2000.0 - world.speed(0) * 800.0;
            world.set_drive(A, hold);
            world.step(DT);
            world.validate().unwrap_or_else(|fault| panic!("tick {tick}: {fault}"));
            let [ship, load] = [A, B].map(|id| world.forces(id).total(ForceKind::Tension));
            assert!((ship + load).length() <= 1e-9 * ship.length(), "tick {tick}: {ship} N on the ship, {load} N on the load");
            dragged |= ship != DVec2::ZERO && world.speed(1).x < -0.5;
            snapped = snapped.or(world.events().contains(&Event::Snapped { link: 0 }).then_some(tick));
            assert_eq!(world.links()[0].is_broken(), snapped.is_some());
            assert!(snapped.is_none() || load == DVec2::ZERO, "tick {tick}: a broken rope pulls with {load} N");
        }
        assert!(dragged && snapped.is_some(), "{gravity} m/s², {snapped:?}");
    }
}

/// Stiff and damped to the engine's limits: the energy does not rise, at every rate of ticks.
#[test]
fn the_stiffest_links_are_stable() {
    for (hz, k, c) in [(120.0, 4e6, 0.0), (120.0, 1e7, 1e4), (30.0, 1e7, 1e4), (30.0, 1e7, 0.0), (30.0, 0.0, 1e4)] {
        let turning = BodyDef { velocity: DVec2::new(0.0, 3.0), weightless: true, ..body(50.0, 0.0, 2.0) };
        let mut world =
            world(10.0, vec![body(0.5, 3.0, 1.0), turning, BodyDef { weightless: true, ..body(52.05, 0.0, 2.0) }], vec![]);
        hung(&mut world, DVec2::ZERO, rope(3.0, k, c));
        world.link(LinkDef::new(B, LinkEnd::Body(BodyId(2)), damped_spring(2.0, k, c))).unwrap();
        let energy = |world: &World| {
            let (rope, spring) = ((world.at(0).length() - 3.0).max(0.0), world.at(1).distance(world.at(2)) - 2.0);
            measured(world, 0.0, 0.0) - 10.0 * world.at(0).y + 0.5 * k * (rope * rope + spring * spring)
        };
        let begun = energy(&world);
        for tick in 0..1200 {
            world.step(1.0 / hz);
            let gained = energy(&world) - begun;
            assert!(gained < 1e-6 * (begun.abs() + 100.0), "{hz} Hz, {k} N/m, {c} N·s/m, tick {tick}: {gained} J of {begun} J");
        }
    }
}

/// A crate on a pan that hangs: both at rest to the bit, and asleep, until a force acts on the crate.
#[test]
fn what_stands_on_a_pan_that_hangs_comes_to_rest_exactly() {
    for (air, k, c) in [(0.0, 1000.0, 200.0), (1.2041, 1000.0, 20.0), (0.0, 20000.0, 200.0), (1.2041, 20000.0, 200.0)] {
        for law in [LinkLaw::Spring, LinkLaw::Rope] {
            let pan = sized(0.0, 4.0, 10.0, 1.0, 0.1);
            let load = sized(0.3, 3.0, 4.0, 0.4, 0.4);
            let def = WorldDef { gravity: 5.0, air_density: air, bodies: vec![pan, load], ..WorldDef::default() };
            let mut world = World::new(def).unwrap();
            hung(&mut world, DVec2::ZERO, law(Spring { length: 3.95, stiffness: k, damping: c }));
            world.steps(6000, DT);
            for id in [A, B] {
                let body = world.body(id);
                assert_eq!((body.velocity, body.acceleration), (DVec2::ZERO, DVec2::ZERO), "{k} N/m");
                assert_eq!(world.forces(id).resultant(), DVec2::ZERO, "{k} N/m");
            }
            let low = world.at(0).y - 3.95 - 70.0 / k;
            assert!(low.abs() < 1e-11 && world.methods().asleep == 2, "{k} N/m: {low} m beside the balance");
            let at = world.at(1);
            world.drive(1, 0.0, 1.0);
            world.steps(60, DT);
            assert!(world.at(1).y > at.y, "a force wakes them");
        }
    }
}

/// A load presses a pan on a spring to the floor, where both sleep, and lets go: the spring's work is booked from the first tick on
/// (`World::validate` at each).
#[test]
fn a_spring_that_was_held_down_in_its_sleep_works_at_once() {
    let pan = sized(0.0, -1.0, 10.0, 1.0, 0.1);
    let load = sized(0.3, -1.5, 40.0, 0.4, 0.4);
    let mut world = world(5.0, vec![pan, load], vec![floor()]);
    hung(&mut world, DVec2::new(0.0, 5.0), damped_spring(6.1, 1000.0, 100.0));
    world.drive(1, 0.0, 2000.0);
    world.steps(1200, DT);
    assert!(world.methods().asleep == 2 && (world.at(0).y + 0.1).abs() < 1e-12, "{:?} at {}", world.methods(), world.at(0));
    world.drive(1, 0.0, 0.0);
    world.step(DT);
    assert!(world.speed(1).y < -0.1, "{}", world.speed(1));
    world.steps(600, DT);
}

/// A crate that falls on a pan whose spring is as stiff as a level may have it: the pan bears it, and no energy comes from nothing.
#[test]
fn a_stiff_pan_bears_what_falls_on_it() {
    let stiff = [(4e6, 200.0, 4.0), (4e6, 0.0, 4.0), (4e6, 2000.0, 40.0), (4e7, 0.0, 4.0), (4e7, 0.0, 40.0), (1e3, 1e5, 40.0)];
    // From high above on a soft one: the spring holds it in the tick of the blow as well.
    for ((k, c, m), fall) in stiff.map(|law| (law, 1.0)).into_iter().chain([((1000.0, 200.0, 4.0), 24.0)]) {
        let (length, g) = (3.95, 10.0);
        let balance = length + 10.0 * g / k;
        let mut world = world(g, vec![sized(0.0, balance, 10.0, 1.0, 0.1), sized(0.0, balance - fall, m, 0.4, 0.4)], Vec::new());
        hung(&mut world, DVec2::ZERO, damped_spring(length, k, c));
        let energy = |world: &World| measured(world, g, 0.0) + 0.5 * k * (world.at(0).y - length).powi(2);
        let begun = energy(&world);
        for tick in 0..1200 {
            world.step(DT);
            world.validate().unwrap_or_else(|fault| panic!("{k} N/m, {m} kg, tick {tick}: {fault}"));
            let gained = energy(&world) - begun;
            assert!(gained < 1e-9 * m * g, "{k} N/m, {m} kg, tick {tick}: gained {gained} J");
            let gap = world.at(0).y - world.at(1).y - 0.5;
            assert!(tick < 600 || gap < 0.02, "{k} N/m, {m} kg, tick {tick}: thrown off by {gap} m");
        }
        let low = world.at(0).y - balance - m * g / k;
        assert!(fall < 2.0 || low.abs() < 1e-3, "{low} m beside its balance");
    }
}
