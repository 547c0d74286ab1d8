//! The figures of each change that a sheet suggests, exactly and by the game, in the order of the sheet.

use super::ropes::{self, carts, circle, let_go, spring_period, spring_swing, stretch};
use super::{Figure, G, Run, figure, up};
use crate::support::motion::rk4;
use resultant::physics::{DVec2, ForceKind};

/// The figures of a change.
pub type Outcome = fn(&mut Run) -> Vec<Figure>;

pub fn of(name: &str) -> Vec<Outcome> {
    match name {
        "free-fall" => vec![
            |run| vec![time_of_fall(run, "any, time of the fall", 20.0, 1.62)],
            |run| vec![time_of_fall(run, "any, time of the fall", 20.0, 3.71)],
            |run| vec![time_of_fall(run, "any, time of the fall", 20.0, 24.8)],
            |run| {
                let time = time_of_fall(run, "any, time of the fall from 10 m", 10.0, G);
                vec![time, figure("any, speed at the floor", "m/s", (20.0 * G).sqrt(), landing_speed(run, 2))]
            },
            |run| {
                let masses = [(1, 1.0), (2, 10.0), (3, 100.0)];
                let one = |(object, mass): (usize, f64)| {
                    let exact = speed_after_fall(terminal(mass, 1.2041, 0.5), 20.0);
                    figure(format!("{mass} kg, speed at the floor"), "m/s", exact, landing_speed(run, object))
                };
                masses.into_iter().map(one).collect()
            },
        ],
        "terminal-velocity" => vec![
            |run| vec![terminal_speed(run, 2, 4.0, terminal(4.0, 1.2041, 1.0))],
            // Twice the area is as much as twice the coefficient.
            |run| vec![terminal_speed(run, 2, 4.0, terminal(4.0, 1.2041, 1.0))],
            |run| vec![terminal_speed(run, 1, 1.0, terminal(1.0, 65.0, 0.5))],
            |run| {
                let terminal = terminal(1.0, 0.02, 0.5);
                let speed = terminal_speed(run, 1, 1.0, terminal);
                let landed = landing_speed(run, 1);
                vec![speed, figure("1 kg, speed at the floor", "m/s", speed_after_fall(terminal, 97.0), landed)]
            },
        ],
        "force-mass-acceleration" => {
            vec![|run| vec![acceleration(run, 2, "10 kg", 4.0)], |run| vec![acceleration(run, 3, "40 kg", 0.5)], |run| {
                let back = -run.until(1.5).way(1).x;
                let after = run.until(3.0).body(1).velocity.x;
                vec![
                    figure("5 kg, distance back after 1.5 s, where it turns round", "m", 4.5, back),
                    figure("5 kg, velocity after 3 s", "m/s", 6.0, after),
                ]
            }]
        }
        "friction" => vec![
            |run| vec![acceleration(run, 1, "on ice", 6.0 - 0.03 * G)],
            |run| stands(run, 1, "on rubber"),
            |run| stands(run, 2, "on glass"),
            |run| vec![acceleration(run, 3, "on asphalt", 0.0)],
            |run| vec![acceleration(run, 3, "on asphalt", 8.9 - 0.65 * G)],
            |run| stands(run, 2, "20 kg on wood"),
            |run| vec![acceleration(run, 1, "20 kg on steel", 6.0 - 0.2 * G)],
        ],
        "third-law" => vec![
            |run| collision(run, 20.0, 0.0, 0.5),
            |run| collision(run, 10.0, 0.0, 0.0),
            |run| collision(run, 10.0, 0.0, 1.0),
            |run| collision(run, 10.0, -3.0, 0.0),
        ],
        "momentum" => vec![|run| elastic(run, 2.0, 0.0), |run| elastic(run, 1000.0, 0.0), |run| elastic(run, 4.0, -3.0)],
        "bounce" => vec![
            |run| vec![figure("e = 1, height of a bounce after 20 s", "m", 10.0, run.until(20.0).height_reached(1, 10.0, G))],
            |run| {
                run.until_hit(1, 3.0);
                vec![figure("e = 0.9, height of the first bounce from 5 m", "m", 4.05, run.height_reached(1, 5.0, G))]
            },
            |run| {
                run.until_hit(1, 5.0);
                vec![figure("e = 0.9, energy that is left", "%", 81.0, 10.0 * run.height_reached(1, 10.0, 1.62))]
            },
        ],
        "buoyancy" => vec![
            |run| vec![figure("1100 kg, normal force by the bottom", "N", 100.0 * G, run.until(60.0).press(3, up))],
            |run| vec![depth(run, 1.0 / 1025.0)],
            |run| vec![depth(run, 1.0 / 13534.0)],
            |run| {
                let depth = depth(run, 1e-3);
                let lift = -run.total(1, ForceKind::Buoyancy).y;
                vec![depth, Figure { within: 1e-6, ..figure("300 kg, buoyancy", "N", 300.0 * 24.8, lift) }]
            },
        ],
        "wind-and-friction" => vec![
            |run| vec![acceleration(run, 1, "49 N", 0.0)],
            |run| vec![acceleration(run, 1, "49.1 N", 4.91 - 0.4 * G)],
            |run| vec![acceleration(run, 2, "12 kg in 55 N", 0.0)],
            |run| {
                let found = run.until(3.0).body(1).velocity.x;
                vec![figure("45 N, velocity after 3 s", "m/s", 2.0 + 3.0 * (4.5 - 0.4 * G), found)]
            },
        ],
        "pushed-row" => vec![
            |run| vec![run.until(4.0).push(1, 200.0)],
            |run| vec![run.until(5.0).push(1, 180.0), run.push(5, 100.0)],
            |run| vec![run.until(5.0).push(1, 180.0), run.push(2, 80.0)],
            |run| vec![run.until(5.0).push(1, 200.0), run.push(5, 40.0)],
        ],
        "lift" => vec![
            |run| vec![figure("starting, normal force", "N", 40.0 * (G - 2.0), run.until(4.0).press(1, up))],
            |run| vec![figure("starting, normal force", "N", 0.0, run.until(3.5).press(1, up))],
            |run| {
                let standing = figure("standing, normal force", "N", 40.0 * 1.62, run.until(1.0).press(1, up));
                vec![standing, figure("starting, normal force", "N", 40.0 * (1.62 + 2.0), run.until(4.0).press(1, up))]
            },
        ],
        "projectile" => vec![
            |run| vec![range(run, 2, 40.0, G), height(run, 2, 40.0, G)],
            |run| vec![range(run, 2, 45.0, 24.8), height(run, 1, 60.0, 24.8)],
            |run| [(3, 30.0), (2, 45.0), (1, 60.0)].into_iter().map(|(object, angle)| range_in_air(run, object, angle)).collect(),
        ],
        "hooke" => vec![
            |run| let_go(run, 1, ("soft", 4.0), (200.0, G)),
            |run| let_go(run, 1, ("soft", 8.0), (50.0, G)),
            |run| let_go(run, 1, ("soft", 4.0), (50.0, 1.62)),
            |run| {
                run.until(60.0);
                vec![figure("4 kg, stretch after 60 s", "m", 4.0 * G / 50.0, stretch(run, 1))]
            },
        ],
        "spring-swing" => vec![
            |run| vec![spring_period(run, 1, "first ball", [2.0, 10.0])],
            |run| vec![spring_period(run, 3, "4 kg", [4.0, 160.0])],
            |run| {
                let speed = spring_swing(&mut run.again(), 1).1;
                let period = spring_period(run, 1, "first ball", [1.0, 10.0]);
                vec![period, figure("first ball, speed in the middle", "m/s", 0.5 * 10.0_f64.sqrt(), speed)]
            },
            |run| vec![spring_period(run, 1, "first ball", [1.0, 10.0])],
        ],
        "pendulum" => vec![
            |run| vec![ropes::period(run, 1, "first ball", 10.0, (3.0, 10.0, 1.62))],
            |run| vec![ropes::period(run, 1, "first ball", 10.0, (3.0, 10.0, G))],
            |run| vec![ropes::period(run, 1, "first ball", 10.0, (0.75, 10.0, G))],
            |run| vec![ropes::period(run, 4, "30°", 25.5, (3.0, 30.0, G))],
        ],
        "circular-motion" => vec![
            |run| vec![circle(run, 1, "first ball", [6.0, 6.0, 3.0])],
            |run| vec![circle(run, 1, "first ball", [2.0, 9.0, 3.0])],
            |run| vec![circle(run, 1, "first ball", [2.0, 6.0, 1.5])],
            ropes::broken,
        ],
        "collision-lab" => vec![
            |run| carts(run, ["2 kg", "1 kg"], [2.0, 1.0], [3.0, -3.0], 0.0),
            |run| carts(run, ["2 kg", "1 kg"], [2.0, 1.0], [3.0, -3.0], 1.0),
            |run| carts(run, ["first cart", "second cart"], [1.0, 1.0], [3.0, -3.0], 1.0).into_iter().take(2).collect(),
            |run| carts(run, ["2 kg", "1 kg"], [2.0, 1.0], [3.0, 0.0], 0.5).into_iter().take(3).collect(),
        ],
        other => panic!("{other} has no variations"),
    }
}

/// The terminal speed of a mass in air of that density, m/s, for C·A of that size, m².
fn terminal(mass: f64, density: f64, drag: f64) -> f64 {
    (2.0 * mass * G / (density * drag)).sqrt()
}

/// The speed after a fall from rest, m/s.
fn speed_after_fall(terminal: f64, height: f64) -> f64 {
    terminal * (1.0 - (-2.0 * G * height / (terminal * terminal)).exp()).sqrt()
}

/// How fast an object meets the floor, at which it stops, m/s; whatever it did before.
pub fn landing_speed(run: &mut Run, object: usize) -> f64 {
    let mut again = run.again();
    let (hit, before) = again.until_hit(object, 15.0);
    hit.length() / before.mass
}

fn time_of_fall(run: &mut Run, what: &str, height: f64, gravity: f64) -> Figure {
    let found = landing_speed(run, 1) / gravity;
    figure(what, "s", (2.0 * height / gravity).sqrt(), found)
}

/// Drag at the ball's speed gives the terminal speed.
fn terminal_speed(run: &mut Run, object: usize, mass: f64, exact: f64) -> Figure {
    let resistance = run.until(2.0).total(object, ForceKind::AirResistance).length();
    let found = run.speed(object) * (mass * G / resistance).sqrt();
    figure(format!("{mass} kg, terminal speed"), "m/s", exact, found)
}

fn acceleration(run: &mut Run, object: usize, what: &str, exact: f64) -> Figure {
    let found = run.until(1.0).body(object).acceleration.x;
    figure(format!("{what}, acceleration"), "m/s²", exact, found)
}

/// A crate that 60 N do not move.
fn stands(run: &mut Run, object: usize, what: &str) -> Vec<Figure> {
    let acceleration = acceleration(run, object, what, 0.0);
    vec![figure(format!("{what}, friction"), "N", 60.0, run.total(object, ForceKind::Friction).length()), acceleration]
}

/// The speeds of a pair after its impact, with the impulse on each: 6 m/s on another velocity.
fn pair([m1, m2]: [f64; 2], velocity: f64, e: f64) -> (f64, [f64; 2]) {
    let impulse = (1.0 + e) * (6.0 - velocity) * m1 * m2 / (m1 + m2);
    (impulse, [6.0 - impulse / m1, velocity + impulse / m2])
}

fn collision(run: &mut Run, mass: f64, velocity: f64, e: f64) -> Vec<Figure> {
    let (impulse, [first, second]) = pair([5.0, mass], velocity, e);
    let (on_first, _) = run.until_hit(1, 3.0);
    assert_eq!(on_first, -run.impulse(2), "the other one feels the opposite");
    run.until(4.0);
    vec![
        figure("impulse on each", "N·s", impulse, on_first.length()),
        figure("5 kg, velocity after it", "m/s", first, run.body(1).velocity.x),
        figure(format!("{mass} kg, velocity after it"), "m/s", second, run.body(2).velocity.x),
    ]
}

fn elastic(run: &mut Run, mass: f64, velocity: f64) -> Vec<Figure> {
    let (_, [first, second]) = pair([2.0, mass], velocity, 1.0);
    run.until_hit(1, 3.0);
    let found = [1, 2].map(|object| run.body(object).velocity.x);
    vec![
        figure("e = 1, first crate after it", "m/s", first, found[0]),
        figure("e = 1, second crate after it", "m/s", second, found[1]),
        figure("e = 1, momentum", "N·s", 12.0 + mass * velocity, 2.0 * found[0] + mass * found[1]),
    ]
}

/// How deep 300 kg lie in a liquid of which a kilogram takes `volume` m³. Its surface is 11 m below the level's upper edge.
fn depth(run: &mut Run, volume: f64) -> Figure {
    let found = run.until(60.0).body(1).position.y + 0.5 - 11.0;
    Figure { within: 1e-6, ..figure("300 kg, depth", "m", 300.0 * volume, found) }
}

/// How far a ball lands from where it started, and where it stays, m.
pub fn landing(run: &mut Run, object: usize, gravity: f64) -> f64 {
    let mut again = run.again();
    let (hit, before) = again.until_hit(object, 10.0);
    let landed = again.body(object).position.x;
    // The rest of the last tick: until it is as fast downwards as the floor stopped it.
    let left = (-hit.y / before.mass - before.velocity.y) / gravity;
    let way = before.position.x - again.start[object].position.x + before.velocity.x * left;
    again.until(10.0);
    assert!(again.speed(object) == 0.0 && (again.body(object).position.x - landed).abs() < 1e-9, "it slides on");
    way
}

fn range(run: &mut Run, object: usize, angle: f64, gravity: f64) -> Figure {
    let exact = 400.0 * (2.0 * angle.to_radians()).sin() / gravity;
    figure(format!("{angle}°, range"), "m", exact, landing(run, object, gravity))
}

fn height(run: &mut Run, object: usize, angle: f64, gravity: f64) -> Figure {
    let sine = angle.to_radians().sin();
    let found = run.until(0.25).height_reached(object, 0.0, gravity);
    figure(format!("{angle}°, height"), "m", 400.0 * sine * sine / (2.0 * gravity), found)
}

/// The range in air, against Runge and Kutta's method at steps of 1e-4 s; there is no closed form.
fn range_in_air(run: &mut Run, object: usize, angle: f64) -> Figure {
    let k = 1.2041 * 0.5 / (2.0 * 2.0);
    let pull = |v: DVec2| DVec2::new(0.0, -G) - k * v.length() * v;
    let (mut at, mut v, h) = (DVec2::ZERO, 20.0 * DVec2::from_angle(angle.to_radians()), 1e-4);
    let exact = loop {
        let (next, faster) = rk4((at, v), 1, h, |_, v| pull(v));
        v = faster;
        if next.y < 0.0 && v.y < 0.0 {
            break at.x + (next.x - at.x) * at.y / (at.y - next.y);
        }
        at = next;
    };
    // The last part of a tick is taken for a parabola here, and the engine's tick is of second order.
    Figure { within: 1e-3, ..figure(format!("{angle}°, range"), "m", exact, landing(run, object, G)) }
}
