//! The scenes with exact answers, at several steps, with the peers' usual settings and with stiff ones: those of the lab that every
//! engine can run, under the lab's names, and three more.

use crate::engine::{Box, Spec};
use crate::scenes::{FRICTION, G, STEP, Scene, crate_at, fallen, run, scene, spec};
use crate::watch::Run;

/// s. The game's tick is among them.
const STEPS: [f64; 5] = [1.0 / 30.0, STEP, 1.0 / 120.0, 1.0 / 240.0, 1.0 / 480.0];
/// m. From where a box falls to bounce.
const DROP: f64 = 1.0;
/// Restitution of the ball whose first apexes are compared.
const LOSSY: f64 = 0.9;
/// Apexes that are compared.
const APEXES: usize = 10;

/// All of them, and those that may sleep at the usual step.
pub fn scenes() -> Vec<Scene> {
    let at_all_steps =
        |name, what, seconds, spec, error| Scene { steps: &STEPS, stiffly: true, ..scene(name, what, seconds, spec, error) };
    let column = |n: usize| spec((0..n).map(|i| crate_at(0.0, i as f64, 1.0)).collect());
    let heavy = spec(vec![crate_at(0.0, 0.0, 1.0), crate_at(0.0, 1.0, 10_000.0)]);
    let bounce = |e: f64, height: f64| spec(vec![Box { restitution: e, ..crate_at(0.0, height, 1.0) }]);
    let fall = Spec { statics: vec![], ..spec(vec![crate_at(0.0, 0.0, 1.0)]) };
    let mut scenes = vec![
        at_all_steps("fall", "position after 10 s, m", 10.0, fall, fallen),
        at_all_steps("slide", "distance, m", 10.0, slide(), slide_error),
        at_all_steps("bounce-perfect", "worst place within 60 s at e = 1, m", 60.0, bounce(1.0, DROP), path_error),
        at_all_steps("bounce-apexes", "worst of ten apexes at e = 0.9, m", 6.0, bounce(LOSSY, DROP), apexes_error),
        at_all_steps("bounce-fourth", "fourth apex at e = 0.5 from 20 m, relative", 8.0, bounce(0.5, 20.0), fourth_error),
        at_all_steps("head-on", "worst position 10 s after, m", 10.0, line(&HEAD_ON), head_on_error),
        at_all_steps("cradle", "worst position of five after 10 s, m", 10.0, line(&CRADLE), cradle_error),
        at_all_steps("column", "largest movement in a column of 20, m", 10.0, column(20), sag),
        Scene { pile: true, ..at_all_steps("column-100", "largest movement in a column of 100, m", 10.0, column(100), sag) },
        at_all_steps("heavy-on-light", "largest movement of 10 000 kg on 1 kg, m", 10.0, heavy, sag),
        at_all_steps("pushed-row", "worst position in a row of 20 after 1 s, m", 1.0, row(), row_error),
        at_all_steps("wall-10-km-s", "position after 0.5 s, m", 0.5, thin(), wall_error),
    ];
    for name in ["slide", "column", "column-100", "heavy-on-light"] {
        let awake = scenes.iter().find(|scene| scene.name == name);
        let asleep = awake.map(|scene| Scene {
            name: with_sleep(name),
            steps: &[STEP],
            stiffly: false,
            spec: Spec { sleep: true, ..scene.spec.clone() },
            ..scene.clone()
        });
        scenes.extend(asleep);
    }
    scenes
}

fn slide() -> Spec {
    Spec { gravity: 15.0, ..spec(vec![Box { velocity: (10.0, 0.0), ..crate_at(0.0, 0.0, 1.0) }]) }
}

fn row() -> Spec {
    let block = |i: usize| Box { velocity: (1e-3, 0.0), ..crate_at(i as f64, 0.0, 1.0) };
    let mut row: Vec<_> = (0..20).map(block).collect();
    row[0].force = 20.0 * (1.0 + FRICTION * G);
    spec(row)
}

fn thin() -> Spec {
    Spec {
        gravity: 0.0,
        swept: true,
        statics: vec![((2500.0, 0.0), (0.025, 10.0))],
        ..spec(vec![Box { velocity: (10_000.0, 0.0), half: (0.1, 0.1), ..crate_at(0.0, 0.0, 1.0) }])
    }
}

/// Place (m), velocity (m/s) and mass (kg) of blocks of 1 m on a line: the lab's head-on collision and its cradle.
const HEAD_ON: [(f64, f64, f64); 2] = [(0.0, 25.7, 75.0), (11.0, -11.3, 150.0)];
const CRADLE: [(f64, f64, f64); 5] = [(-2.0, 3.0, 1.0), (1.0, 0.0, 1.0), (2.0, 0.0, 1.0), (3.0, 0.0, 1.0), (4.0, 0.0, 1.0)];

fn line(blocks: &[(f64, f64, f64)]) -> Spec {
    let block = |&(x, v, mass): &(f64, f64, f64)| Box { velocity: (v, 0.0), restitution: 1.0, ..crate_at(x, 0.0, mass) };
    Spec { gravity: 0.0, statics: vec![], ..spec(blocks.iter().map(block).collect()) }
}

/// What a scene is called when what rests may sleep.
fn with_sleep(name: &str) -> &'static str {
    match name {
        "slide" => "slide-sleep",
        "column" => "column-sleep",
        "column-100" => "column-100-sleep",
        _ => "heavy-on-light-sleep",
    }
}

/// The largest distance of a block from its place, m.
fn worst_place(engine: &mut dyn Run, places: &[f64]) -> f64 {
    let off = |(i, x): (usize, &f64)| (engine.position(i).0 - x).abs();
    places.iter().enumerate().map(off).fold(0.0, f64::max)
}

fn head_on_error(engine: &mut dyn Run, _: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    let [(x, v, m), (y, w, n)] = HEAD_ON;
    let meet = (y - x - 1.0) / (v - w);
    let left = steps as f64 * step - meet;
    let common = (m * v + n * w) / (m + n);
    let after = |x: f64, v: f64| x + v * meet + (2.0 * common - v) * left;
    worst_place(engine, &[after(x, v), after(y, w)])
}

/// The last one leaves alone.
fn cradle_error(engine: &mut dyn Run, _: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    let mut places = CRADLE.map(|(x, _, _)| x);
    let (from, strike, _) = CRADLE[0];
    places[0] = places[1] - 1.0;
    places[4] += strike * (steps as f64 * step - (places[0] - from) / strike);
    worst_place(engine, &places)
}

fn slide_error(engine: &mut dyn Run, spec: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    (engine.position(0).0 - 100.0 / (2.0 * spec.friction * spec.gravity)).abs()
}

/// The height over the floor that its energy reaches.
fn reach(engine: &mut dyn Run) -> f64 {
    let (y, v) = (engine.position(0).1, engine.velocity(0).1);
    -0.5 - y + v * v / (2.0 * G)
}

/// Its height at any time: from floor to floor it takes twice the fall. A height alone would forgive a ball that is late.
fn path_error(engine: &mut dyn Run, _: &Spec, steps: usize, step: f64) -> f64 {
    let fall = (2.0 * DROP / G).sqrt();
    let mut worst: f64 = 0.0;
    for done in 1..=steps {
        engine.step(step);
        let since = (done as f64 * step + fall) % (2.0 * fall);
        let height = G * since * (fall - 0.5 * since);
        worst = worst.max((-0.5 - engine.position(0).1 - height).abs());
    }
    worst
}

/// The height that its energy reaches at each of its first `most` turns; fewer where it turns less often.
fn apexes(engine: &mut dyn Run, most: usize, steps: usize, step: f64) -> Vec<f64> {
    let (mut rising, mut found) = (false, Vec::new());
    for _ in 0..steps {
        engine.step(step);
        // Upwards is negative.
        let v = engine.velocity(0).1;
        if rising && v >= 0.0 {
            found.push(reach(engine));
        }
        rising = v < 0.0;
    }
    found.truncate(most);
    found
}

fn apexes_error(engine: &mut dyn Run, _: &Spec, steps: usize, step: f64) -> f64 {
    let found = apexes(engine, APEXES, steps, step);
    if found.len() < APEXES {
        return DROP;
    }
    let exact = |i: usize| DROP * (LOSSY * LOSSY).powi(i as i32 + 1);
    let off = |(i, height): (usize, &f64)| (height - exact(i)).abs();
    found.iter().enumerate().map(off).fold(0.0, f64::max)
}

fn fourth_error(engine: &mut dyn Run, _: &Spec, steps: usize, step: f64) -> f64 {
    // Where there is none, all of it is missing.
    let fourth = apexes(engine, 4, steps, step).get(3).copied().unwrap_or(0.0);
    (fourth / (20.0 * 0.25 * 0.25 * 0.25 * 0.25) - 1.0).abs()
}

fn sag(engine: &mut dyn Run, spec: &Spec, steps: usize, step: f64) -> f64 {
    let mut worst: f64 = 0.0;
    for _ in 0..steps {
        engine.step(step);
        let moved = |(i, body): (usize, &Box)| (engine.position(i).1 - body.position.1).abs();
        worst = spec.bodies.iter().enumerate().map(moved).fold(worst, f64::max);
    }
    worst
}

fn row_error(engine: &mut dyn Run, spec: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    let t = steps as f64 * step;
    let exact = 1e-3 * t + 0.5 * t * t;
    let off = |(i, body): (usize, &Box)| (engine.position(i).0 - body.position.0 - exact).abs();
    spec.bodies.iter().enumerate().map(off).fold(0.0, f64::max)
}

/// It has to lie at the wall.
fn wall_error(engine: &mut dyn Run, spec: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    let ((x, _), (half, _)) = spec.statics[0];
    (engine.position(0).0 - (x - half - spec.bodies[0].half.0)).abs()
}
