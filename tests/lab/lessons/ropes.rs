//! Figures of the experiments with springs and ropes, and of the two carts.

use super::{Figure, G, Run, figure, up};
use resultant::game::TICK_RATE;
use resultant::physics::{DVec2, ForceKind};
use std::f64::consts::TAU;

/// How much a rope of 10⁶ N/m that is a little longer under its load changes a figure, at most.
const STRETCH: f64 = 2e-4;

fn on_a_rope(what: impl Into<String>, unit: &'static str, exact: f64, found: f64) -> Figure {
    Figure { within: STRETCH, ..figure(what, unit, exact, found) }
}

fn tension(run: &Run, object: usize) -> f64 {
    run.total(object, ForceKind::Tension).length()
}

/// The period of a small swing times this is that of one from an angle, °: 2/π·K(sin(θ/2)), by the arithmetic-geometric mean (Gauss).
pub fn longer(angle: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * angle.to_radians()).cos());
    while a - b > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    1.0 / a
}

/// The period of a pendulum that was let go at the right of its anchor, s: of its passages to the left, the first and the tenth after it.
fn swing(run: &mut Run, object: usize, anchor: f64) -> f64 {
    let mut passages = Vec::new();
    while passages.len() < 11 {
        let (began, before) = (run.game.elapsed(), run.body(object));
        let out = before.position.x - anchor;
        run.until(began + 1.0 / TICK_RATE);
        if out > 0.0 && run.body(object).position.x <= anchor {
            let straight = -out / before.velocity.x;
            passages.push(began - (out + 0.5 * before.acceleration.x * straight * straight) / before.velocity.x);
        }
    }
    (passages[10] - passages[0]) / 10.0
}

/// Of an object whose rope hangs from there, m, with that length and angle, °.
pub fn period(run: &Run, object: usize, what: &str, anchor: f64, (length, angle, gravity): (f64, f64, f64)) -> Figure {
    let exact = TAU * (length / gravity).sqrt() * longer(angle);
    on_a_rope(format!("{what}, period"), "s", exact, swing(&mut run.again(), object, anchor))
}

pub fn pendulum() -> Vec<Figure> {
    let run = Run::new("pendulum");
    let balls = [("first ball", 10.0, 3.0, 10.0), ("4 kg", 13.5, 3.0, 10.0), ("12 m", 18.5, 12.0, 10.0), ("60°", 25.5, 3.0, 60.0)];
    let periods = balls.into_iter().enumerate();
    let mut figures: Vec<Figure> =
        periods.map(|(i, (what, anchor, length, angle))| period(&run, i + 1, what, anchor, (length, angle, G))).collect();
    // It is fastest, and its rope pulls hardest, where it is lowest: once in a second.
    let (mut again, mut speed, mut pull) = (run.again(), 0.0_f64, 0.0_f64);
    while again.game.elapsed() < 2.0 {
        again.until(again.game.elapsed() + 1.0 / TICK_RATE);
        (speed, pull) = (speed.max(again.speed(4)), pull.max(tension(&again, 4)));
    }
    let squared = 2.0 * G * 3.0 * (1.0 - 60.0_f64.to_radians().cos());
    figures.push(on_a_rope("60°, speed in the middle", "m/s", squared.sqrt(), speed));
    figures.push(on_a_rope("60°, force of the rope in the middle", "N", G + squared / 3.0, pull));
    figures
}

pub fn circle(run: &mut Run, object: usize, what: &str, [mass, speed, radius]: [f64; 3]) -> Figure {
    on_a_rope(format!("{what}, force of the rope"), "N", mass * speed * speed / radius, tension(run.until(1.5), object))
}

/// The time of a turn around there: of all that is turned in 5 s.
fn turn(run: &mut Run, object: usize, middle: DVec2) -> f64 {
    let (mut turned, mut before) = (0.0, run.body(object).position - middle);
    while run.game.elapsed() < 5.0 {
        run.until(run.game.elapsed() + 1.0 / TICK_RATE);
        let now = run.body(object).position - middle;
        turned += before.perp_dot(now).atan2(before.dot(now)).abs();
        before = now;
    }
    TAU * 5.0 / turned
}

pub fn circular_motion() -> Vec<Figure> {
    let mut run = Run::new("circular-motion");
    let first = circle(&mut run, 1, "first ball", [2.0, 6.0, 3.0]);
    let around = turn(&mut run.again(), 1, DVec2::new(200.0, 190.0) / 30.0);
    let mut figures = vec![first, on_a_rope("first ball, time of a turn", "s", TAU * 3.0 / 6.0, around)];
    for (object, what, of) in [(2, "12 m/s", [2.0, 12.0, 3.0]), (3, "4 kg", [4.0, 6.0, 3.0]), (4, "6 m", [2.0, 6.0, 6.0])] {
        figures.push(circle(&mut run, object, what, of));
    }
    let pulled = tension(&run, 5);
    assert!((pulled - 24.0).abs() < 24.0 * STRETCH, "not cut yet: {pulled}");
    let flown = run.until(2.5).body(5);
    assert!(flown.velocity.x > 0.0 && flown.velocity.y.abs() < 6.0 * 2.0 / TICK_RATE, "along the tangent: {flown:?}");
    figures.push(figure("cut, force of the rope after it", "N", 0.0, tension(&run, 5)));
    figures.push(on_a_rope("cut, speed after it", "m/s", 6.0, run.speed(5)));
    figures
}

pub fn broken(run: &mut Run) -> Vec<Figure> {
    let (pull, speed) = (tension(run.until(1.0), 2), run.speed(2));
    vec![figure("12 m/s, force of the rope", "N", 0.0, pull), on_a_rope("12 m/s, speed after 1 s", "m/s", 12.0, speed)]
}

/// Two carts after they have met, by their names.
pub fn carts(run: &mut Run, what: [&str; 2], [m1, m2]: [f64; 2], [v1, v2]: [f64; 2], e: f64) -> Vec<Figure> {
    run.until_hit(1, 6.0);
    let ([u1, u2], middle) = ([1, 2].map(|object| run.body(object).velocity.x), (m1 * v1 + m2 * v2) / (m1 + m2));
    let exact = [middle - e * (v1 - v2) * m2 / (m1 + m2), middle + e * (v1 - v2) * m1 / (m1 + m2)];
    let energy = |a: f64, b: f64| 0.5 * (m1 * a * a + m2 * b * b);
    vec![
        figure(format!("{}, velocity after it", what[0]), "m/s", exact[0], u1),
        figure(format!("{}, velocity after it", what[1]), "m/s", exact[1], u2),
        figure("together, momentum", "N·s", m1 * v1 + m2 * v2, m1 * u1 + m2 * u2),
        figure("together, kinetic energy after it", "J", energy(exact[0], exact[1]), energy(u1, u2)),
    ]
}

pub fn collision_lab() -> Vec<Figure> {
    let mut run = Run::new("collision-lab");
    let [v1, v2] = [1, 2].map(|object| run.body(object).velocity.x);
    let before = figure("together, kinetic energy before it", "J", 13.5, v1 * v1 + 0.5 * v2 * v2);
    let mut figures = carts(&mut run, ["2 kg", "1 kg"], [2.0, 1.0], [3.0, -3.0], 0.5);
    figures.insert(3, before);
    figures
}

/// How much longer than 3 m the spring of an object is, m; it hangs from 4 m below the level's upper edge.
pub fn stretch(run: &Run, object: usize) -> f64 {
    run.body(object).position.y - 4.0 - 3.0
}

/// The slope of the spring's force over the place, as a plot has it, N/m.
fn stiffness(run: &mut Run, object: usize) -> f64 {
    let mut at = |time: f64| {
        let pull = run.until(time).total(object, ForceKind::Spring);
        (stretch(run, object), up(pull))
    };
    let ((s1, f1), (s2, f2)) = (at(0.25), at(0.5));
    (f2 - f1) / (s2 - s1)
}

/// How long the spring is where its ball turns round below: after the tick that turns it v²/2a are left.
fn largest_stretch(run: &Run, object: usize) -> f64 {
    let mut again = run.again();
    while again.until(again.game.elapsed() + 1.0 / TICK_RATE).body(object).velocity.y >= 0.0 {}
    let body = again.body(object);
    stretch(&again, object) - body.velocity.y * body.velocity.y / (2.0 * body.acceleration.y)
}

/// A ball that was let go from the unloaded length of a spring.
pub fn let_go(run: &mut Run, object: usize, (what, mass): (&str, f64), (k, gravity): (f64, f64)) -> Vec<Figure> {
    let lowest = figure(format!("{what} spring, largest stretch"), "m", 2.0 * mass * gravity / k, largest_stretch(run, object));
    vec![
        figure(format!("{what} spring, force for each metre"), "N/m", k, stiffness(run, object)),
        Figure { within: 1e-6, ..lowest },
    ]
}

pub fn hooke() -> Vec<Figure> {
    let mut run = Run::new("hooke");
    run.until(10.0);
    let rest = |object, mass: f64| figure(format!("{mass} kg at rest, stretch"), "m", mass * G / 50.0, stretch(&run, object));
    let mut figures = vec![rest(3, 2.0), rest(4, 4.0)];
    figures.extend(let_go(&mut run.again(), 1, ("soft", 4.0), (50.0, G)));
    figures.extend(let_go(&mut run.again(), 2, ("hard", 4.0), (100.0, G)));
    figures
}

/// The period of a ball on a spring of 8 m from 10 m, s, and its speed in the middle, m/s: of its passages to the left, the first and
/// the tenth after it. ω² = −a/x takes a passage into its tick.
pub fn spring_swing(run: &mut Run, object: usize) -> (f64, f64) {
    let (mut passages, mut speed) = (Vec::new(), 0.0);
    let out = |run: &Run| run.body(object).position.x - 18.0;
    while passages.len() < 11 {
        let (before, body) = (out(run), run.body(object));
        run.until(run.game.elapsed() + 1.0 / TICK_RATE);
        if before > 0.0 && out(run) <= 0.0 {
            let omega = (-body.acceleration.x / before).sqrt();
            passages.push(run.game.elapsed() - 1.0 / TICK_RATE + (-before * omega / body.velocity.x).atan() / omega);
            speed = body.velocity.x.hypot(before * omega);
        }
    }
    ((passages[10] - passages[0]) / 10.0, speed)
}

pub fn spring_period(run: &mut Run, object: usize, what: &str, [mass, k]: [f64; 2]) -> Figure {
    figure(format!("{what}, period"), "s", TAU * (mass / k).sqrt(), spring_swing(run, object).0)
}

pub fn swings() -> Vec<Figure> {
    let run = Run::new("spring-swing");
    let balls = [("first ball", [1.0, 10.0]), ("wider swing", [1.0, 10.0]), ("4 kg", [4.0, 10.0]), ("harder spring", [1.0, 40.0])];
    let mut figures: Vec<Figure> =
        balls.into_iter().enumerate().map(|(i, (what, of))| spring_period(&mut run.again(), i + 1, what, of)).collect();
    for (object, what, wide) in [(1, "first ball", 1.0), (2, "wider swing", 2.0)] {
        let speed = spring_swing(&mut run.again(), object).1;
        figures.push(figure(format!("{what}, speed in the middle"), "m/s", wide * 10.0_f64.sqrt(), speed));
    }
    figures
}
