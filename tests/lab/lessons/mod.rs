//! The experiments: each level flown and held against its exact answer, and every figure and every suggested change of its sheet with it.

mod pages;
mod ropes;
mod sheet;
mod variations;

use crate::support::shipped::project;
use resultant::files;
use resultant::game::{Controls, Game, TICK_RATE};
use resultant::level::{self, Level};
use resultant::physics::{Body, BodyId, DVec2, ForceKind, Impulse, Material};
use std::sync::Arc;

/// N/kg, in all of them.
const G: f64 = 9.81;
/// A figure of a body's motion, exactly and by the game.
struct Figure {
    what: String,
    unit: &'static str,
    exact: f64,
    found: f64,
    /// Relative: how far the two may be apart.
    within: f64,
}

impl Figure {
    fn check(&self, run: &str) {
        let Self { what, exact, found, within, .. } = self;
        assert!((found - exact).abs() <= within * exact.abs().max(1.0), "{run}, {what}: {found}, exactly {exact}");
    }

    /// As a sheet's table has it.
    fn row(&self) -> [String; 2] {
        [self.what.clone(), format!("{} {}", three(self.exact), self.unit)]
    }
}

struct Run {
    game: Game,
    start: Vec<Body>,
}

impl Run {
    fn new(name: &str) -> Self {
        Self::varied(name, "")
    }

    fn varied(name: &str, change: &str) -> Self {
        Self::of(Arc::new(sheet::level(name, change)))
    }

    fn of(level: Arc<Level>) -> Self {
        let game = Game::new(level).unwrap();
        let start = game.world().bodies().to_vec();
        Self { game, start }
    }

    fn again(&self) -> Self {
        Self::of(Arc::new(self.game.level().clone()))
    }

    fn until(&mut self, seconds: f64) -> &mut Self {
        while (self.game.ticks() as f64) < (seconds * TICK_RATE).round() {
            self.game.step(Controls::default());
        }
        self
    }

    fn body(&self, object: usize) -> Body {
        self.game.world().bodies()[object].clone()
    }

    /// From where it began, m.
    fn way(&self, object: usize) -> DVec2 {
        self.body(object).position - self.start[object].position
    }

    fn speed(&self, object: usize) -> f64 {
        self.body(object).velocity.length()
    }

    fn total(&self, object: usize, kind: ForceKind) -> DVec2 {
        self.game.world().forces(BodyId(object as u32)).total(kind)
    }

    /// How high it comes, m above the floor, where it began so high above that and flies freely now.
    fn height_reached(&self, object: usize, began: f64, gravity: f64) -> f64 {
        let speed = self.body(object).velocity.y;
        began - self.way(object).y + speed * speed / (2.0 * gravity)
    }

    /// The forces that press on an object along a direction, N; opposite forces do not count.
    fn press(&self, object: usize, along: impl Fn(DVec2) -> f64) -> f64 {
        let forces = self.game.world().forces(BodyId(object as u32));
        let contact = |kind| matches!(kind, ForceKind::Reaction | ForceKind::Push);
        forces.forces().iter().filter(|force| contact(force.kind)).map(|force| along(force.vector).max(0.0)).sum()
    }

    fn push(&self, crate_number: usize, exact: f64) -> Figure {
        let found = self.press(crate_number, |force| force.x);
        figure(format!("crate {crate_number}, push from behind"), "N", exact, found)
    }

    /// All that has hit an object in the last tick, N·s.
    fn impulse(&self, object: usize) -> DVec2 {
        let on = |impulse: &Impulse| Some(impulse.on(BodyId(object as u32))?.0);
        self.game.world().impulses().iter().filter_map(on).sum()
    }

    /// Goes on until an object is hit, at most for so long; the impulse on it, N·s, and how it was before.
    fn until_hit(&mut self, object: usize, at_most: f64) -> (DVec2, Body) {
        loop {
            let before = self.body(object);
            self.game.step(Controls::default());
            let felt = self.impulse(object);
            if felt != DVec2::ZERO {
                return (felt, before);
            }
            assert!((self.game.ticks() as f64) < at_most * TICK_RATE, "object {object} is not hit");
        }
    }
}

fn up(force: DVec2) -> f64 {
    -force.y
}

fn figure(what: impl Into<String>, unit: &'static str, exact: f64, found: f64) -> Figure {
    Figure { what: what.into(), unit, exact, found, within: 1e-9 }
}

fn free_fall() -> Vec<Figure> {
    let (mut figures, height) = (Vec::new(), 20.0);
    let mut run = Run::new("free-fall");
    for (object, mass) in [(1, 1), (2, 10), (3, 100)] {
        run.until(1.0);
        figures.push(figure(format!("{mass} kg, distance after 1 s"), "m", 0.5 * G, run.way(object).y));
        figures.push(figure(format!("{mass} kg, speed after 1 s"), "m/s", G, run.speed(object)));
    }
    let landed = variations::landing_speed(&mut run, 1);
    figures.push(figure("any, speed at the floor", "m/s", (2.0 * G * height).sqrt(), landed));
    figures.push(figure("any, time of the fall", "s", (2.0 * height / G).sqrt(), landed / G));
    figures
}

fn terminal_velocity() -> Vec<Figure> {
    let (density, drag) = (1.2041, 0.5);
    let mut run = Run::new("terminal-velocity");
    run.until(5.0);
    let mut figures = Vec::new();
    for (object, mass) in [(1, 1.0), (2, 4.0), (3, 9.0)] {
        let terminal = (2.0 * mass * G / (density * drag)).sqrt();
        let after = terminal * (G * 5.0 / terminal).tanh();
        let way = terminal * terminal / G * (G * 5.0 / terminal).cosh().ln();
        figures.push(figure(format!("{mass} kg, speed after 5 s"), "m/s", after, run.speed(object)));
        figures.push(figure(format!("{mass} kg, distance after 5 s"), "m", way, run.way(object).y));
        // Drag at this speed gives the terminal speed.
        let resistance = run.total(object, ForceKind::AirResistance).length();
        let found = run.speed(object) * (mass * G / resistance).sqrt();
        figures.push(figure(format!("{mass} kg, terminal speed"), "m/s", terminal, found));
    }
    figures
}

fn force_mass_acceleration() -> Vec<Figure> {
    let mut run = Run::new("force-mass-acceleration");
    run.until(3.0);
    let mut figures = Vec::new();
    for (object, mass) in [(1, 5.0), (2, 10.0), (3, 20.0)] {
        let exact = 20.0 / mass;
        figures.push(figure(format!("{mass} kg, acceleration"), "m/s²", exact, run.body(object).acceleration.x));
        figures.push(figure(format!("{mass} kg, speed after 3 s"), "m/s", exact * 3.0, run.speed(object)));
        figures.push(figure(format!("{mass} kg, distance after 3 s"), "m", exact * 4.5, run.way(object).x));
    }
    figures
}

/// A crate of 10 kg, pushed along a floor of such a material.
fn slide(run: &Run, object: usize, (what, push): (&str, f64), floor: Material) -> Vec<Figure> {
    let (weight, mass) = (10.0 * G, 10.0);
    let most = floor.static_friction * weight;
    let holds = push <= most;
    let pull = if holds { 0.0 } else { push / mass - floor.kinetic_friction * G };
    let friction = if holds { push } else { floor.kinetic_friction * weight };
    vec![
        figure(format!("{what}, largest static friction"), "N", most, most),
        figure(format!("{what}, friction"), "N", friction, run.total(object, ForceKind::Friction).length()),
        figure(format!("{what}, acceleration"), "m/s²", pull, run.body(object).acceleration.x),
        figure(format!("{what}, distance after 3 s"), "m", pull * 4.5, run.way(object).x),
    ]
}

fn friction() -> Vec<Figure> {
    let mut run = Run::new("friction");
    run.until(3.0);
    let floors = [("steel", Material::STEEL), ("wood", Material::WOOD), ("asphalt", Material::ASPHALT)];
    floors.into_iter().enumerate().flat_map(|(i, (name, floor))| slide(&run, i + 1, (name, 60.0), floor)).collect()
}

fn wind_and_friction() -> Vec<Figure> {
    let mut run = Run::new("wind-and-friction");
    run.until(3.0);
    let winds = [("45 N", 45.0), ("55 N", 55.0), ("75 N", 75.0)];
    winds.into_iter().enumerate().flat_map(|(i, wind)| slide(&run, i + 1, wind, Material::WOOD)).collect()
}

fn third_law() -> Vec<Figure> {
    let mut run = Run::new("third-law");
    let (on_first, _) = run.until_hit(1, 3.0);
    let on_second = run.impulse(2);
    let exact = 1.5 * 6.0 * 5.0 * 10.0 / 15.0;
    run.until(4.0);
    vec![
        figure("5 kg, impulse backwards", "N·s", exact, -on_first.x),
        figure("10 kg, impulse forwards", "N·s", exact, on_second.x),
        figure("5 kg, velocity after it", "m/s", 6.0 - exact / 5.0, run.body(1).velocity.x),
        figure("10 kg, velocity after it", "m/s", exact / 10.0, run.body(2).velocity.x),
    ]
}

fn momentum() -> Vec<Figure> {
    let mut run = Run::new("momentum");
    run.until(4.0);
    let (m1, m2, v) = (2.0, 4.0, 6.0);
    let mut figures = Vec::new();
    for (lane, e) in [(0, 1.0), (1, 0.5), (2, 0.0)] {
        let (first, second) = (run.body(2 * lane + 1), run.body(2 * lane + 2));
        let together = m1 * v / (m1 + m2);
        let (v1, v2) = (together - e * m2 * v / (m1 + m2), together + e * m1 * v / (m1 + m2));
        let energy = |v1: f64, v2: f64| 0.5 * m1 * v1 * v1 + 0.5 * m2 * v2 * v2;
        figures.push(figure(format!("e = {e}, 2 kg after it"), "m/s", v1, first.velocity.x));
        figures.push(figure(format!("e = {e}, 4 kg after it"), "m/s", v2, second.velocity.x));
        figures.push(figure(format!("e = {e}, momentum"), "N·s", m1 * v, m1 * first.velocity.x + m2 * second.velocity.x));
        figures.push(figure(format!("e = {e}, kinetic energy"), "J", energy(v1, v2), energy(first.velocity.x, second.velocity.x)));
    }
    figures
}

fn bounce() -> Vec<Figure> {
    let (height, mut figures) = (10.0, Vec::new());
    for (object, e) in [(1, 0.9), (2, 0.7), (3, 0.5)] {
        let mut run = Run::new("bounce");
        run.until_hit(object, 3.0);
        // On its way up: its energies of motion and height give the height that it reaches.
        let found = run.height_reached(object, height, G);
        figures.push(figure(format!("e = {e}, height of the first bounce"), "m", height * e * e, found));
        figures.push(figure(format!("e = {e}, energy that is left"), "%", 100.0 * e * e, 100.0 * found / height));
    }
    figures
}

fn buoyancy() -> Vec<Figure> {
    let mut run = Run::new("buoyancy");
    run.until(60.0);
    let mut figures = Vec::new();
    for (object, mass) in [(1, 300.0), (2, 500.0), (3, 900.0)] {
        // The water begins 11 m below the level's upper edge.
        let depth = run.body(object).position.y + 0.5 - 11.0;
        figures.push(Figure { within: 1e-6, ..figure(format!("{mass} kg, depth"), "m", mass / 1000.0, depth) });
        let lift = -run.total(object, ForceKind::Buoyancy).y;
        figures.push(Figure { within: 1e-6, ..figure(format!("{mass} kg, buoyancy"), "N", mass * G, lift) });
    }
    figures
}

fn pushed_row() -> Vec<Figure> {
    let mut run = Run::new("pushed-row");
    run.until(5.0);
    let mut figures = vec![figure("all, acceleration", "m/s²", 2.0, run.body(1).acceleration.x)];
    figures.extend((1..=5).map(|object| run.push(object, 20.0 * (6 - object) as f64)));
    figures
}

fn lift() -> Vec<Figure> {
    let mut run = Run::new("lift");
    let mut figures = Vec::new();
    for (time, what, pull) in [(1.0, "standing", 0.0), (4.0, "starting", 2.0), (6.5, "at 4 m/s", 0.0), (9.0, "stopping", -2.0)] {
        run.until(time);
        figures.push(figure(format!("{what}, normal force"), "N", 40.0 * (G + pull), -run.total(1, ForceKind::Reaction).y));
    }
    figures
}

fn projectile() -> Vec<Figure> {
    let mut figures = Vec::new();
    for (object, angle) in [(3, 30.0_f64), (2, 45.0), (1, 60.0)] {
        let mut run = Run::new("projectile");
        run.until(1.0);
        let (sine, speed) = (angle.to_radians().sin(), 20.0);
        let (top, along) = (run.height_reached(object, 0.0, G), run.body(object).velocity.x);
        let way = variations::landing(&mut run, object, G);
        let range = speed * speed * (2.0 * angle.to_radians()).sin() / G;
        figures.push(figure(format!("{angle}°, height"), "m", speed * speed * sine * sine / (2.0 * G), top));
        figures.push(figure(format!("{angle}°, range"), "m", range, way));
        figures.push(figure(format!("{angle}°, time of flight"), "s", 2.0 * speed * sine / G, way / along));
    }
    figures
}

type Figures = fn() -> Vec<Figure>;

const EXPERIMENTS: [(&str, Figures); 17] = [
    ("free-fall", free_fall),
    ("terminal-velocity", terminal_velocity),
    ("force-mass-acceleration", force_mass_acceleration),
    ("friction", friction),
    ("third-law", third_law),
    ("momentum", momentum),
    ("bounce", bounce),
    ("buoyancy", buoyancy),
    ("wind-and-friction", wind_and_friction),
    ("pushed-row", pushed_row),
    ("lift", lift),
    ("projectile", projectile),
    ("hooke", ropes::hooke),
    ("spring-swing", ropes::swings),
    ("pendulum", ropes::pendulum),
    ("circular-motion", ropes::circular_motion),
    ("collision-lab", ropes::collision_lab),
];

fn three(value: f64) -> String {
    if value.abs() < 1e-9 {
        return "0".to_owned();
    }
    let decimals = (2 - value.abs().log10().floor() as i32).max(0) as usize;
    format!("{value:.decimals$}").replace('-', "−")
}

#[test]
fn every_experiment_has_its_exact_answer_and_its_sheet_names_it() {
    for ((name, figures), listed) in EXPERIMENTS.into_iter().zip(sheets::listed(project()).unwrap()) {
        let figures = figures();
        figures.iter().for_each(|figure| figure.check(name));
        let rows: Vec<[String; 2]> = figures.iter().map(Figure::row).collect();
        let rows: Vec<_> = rows.iter().map(|row| row.each_ref().map(String::as_str)).collect();
        assert_eq!((listed.folder.as_str(), sheets::figures(&listed.readings).unwrap()), (name, rows));
    }
}

/// Each change is made in the experiment's files and flown, and agrees with its sheet.
#[test]
fn every_suggested_change_does_what_its_sheet_says() {
    let mut flown = 0;
    for (name, _) in EXPERIMENTS {
        let text = sheet::text(name);
        let (suggested, outcomes) = (sheet::variations(&text), variations::of(name));
        assert_eq!(suggested.len(), outcomes.len(), "{name}: {suggested:#?}");
        for (suggested, outcome) in suggested.iter().zip(outcomes) {
            let change = &suggested.change;
            let figures = outcome(&mut Run::varied(name, change));
            let rows: Vec<[String; 2]> = figures.iter().map(Figure::row).collect();
            assert_eq!(suggested.rows, rows, "{name}, {change}");
            figures.iter().for_each(|figure| figure.check(&format!("{name}, {change}")));
            flown += 1;
        }
    }
    assert!(flown >= 63, "{flown}");
}

#[test]
fn the_list_of_experiments_names_those_that_are_there() {
    let root = project().join(files::EXPERIMENTS);
    let list = std::fs::read_to_string(root.join("experiments.csv")).unwrap();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(list.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let listed: Vec<&str> = rows.iter().map(|row| &row[0]).collect();
    assert_eq!(listed, EXPERIMENTS.map(|(name, _)| name));
    // A number that is right is a figure, or how many times another one a figure is.
    for (row, (name, figures)) in rows.iter().zip(EXPERIMENTS) {
        if let Ok(right) = row[5].split(' ').next().unwrap().parse::<f64>() {
            let exact: Vec<f64> = figures().iter().map(|figure| figure.exact).chain([1.0]).collect();
            let is_right = |(a, b): (f64, f64)| (a / b - right).abs() < 1e-9;
            let found = exact.iter().any(|a| exact.iter().any(|b| is_right((*a, *b))));
            assert!(found, "{name}: {right} is none of {exact:?}");
        }
    }
    assert_eq!(level::list(&root).len(), listed.len());
}
