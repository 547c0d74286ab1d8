//! Figures of the two experiments with springs.

use super::{Figure, G, Run, figure, up};
use resultant::game::TICK_RATE;
use resultant::physics::ForceKind;

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
    let rest =
        |(object, mass): (usize, f64)| figure(format!("{mass} kg at rest, stretch"), "m", mass * G / 50.0, stretch(&run, object));
    let mut figures = vec![rest((3, 2.0)), rest((4, 4.0))];
    figures.extend(let_go(&mut run.again(), 1, ("soft", 4.0), (50.0, G)));
    figures.extend(let_go(&mut run.again(), 2, ("hard", 4.0), (100.0, G)));
    figures
}

/// The period of a ball on a spring of 8 m from 10 m, s, and its speed in the middle, m/s: of its passages to the left, the first and
/// the tenth after it. ω² = −a/x takes a passage into its tick.
pub fn swing(run: &mut Run, object: usize) -> (f64, f64) {
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

pub fn period(run: &mut Run, object: usize, what: &str, [mass, k]: [f64; 2]) -> Figure {
    figure(format!("{what}, period"), "s", std::f64::consts::TAU * (mass / k).sqrt(), swing(run, object).0)
}

pub fn swings() -> Vec<Figure> {
    let run = Run::new("spring-swing");
    let balls = [("first ball", [1.0, 10.0]), ("wider swing", [1.0, 10.0]), ("4 kg", [4.0, 10.0]), ("harder spring", [1.0, 40.0])];
    let mut figures: Vec<Figure> =
        balls.into_iter().enumerate().map(|(i, (what, of))| period(&mut run.again(), i + 1, what, of)).collect();
    for (object, what, wide) in [(1, "first ball", 1.0), (2, "wider swing", 2.0)] {
        let speed = swing(&mut run.again(), object).1;
        figures.push(figure(format!("{what}, speed in the middle"), "m/s", wide * 10.0_f64.sqrt(), speed));
    }
    figures
}
