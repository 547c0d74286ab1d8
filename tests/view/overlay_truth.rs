//! Lessons are played, and the text of the details is read on every frame, the very strings that are drawn: within the digits shown the
//! forces add up to mass times acceleration, and forces and impacts of half a second to the change of momentum.

use super::onlook::{centres, numbers_in, power_of, window};
use crate::support::shipped::{experiment, fixture, record};
use resultant::draw::layout::Frame;
use resultant::game::{Controls, Game, READABLE};
use resultant::level::Level;
use resultant::physics::{BodyId, DVec2};
use resultant::view::camera::Viewport;
use resultant::view::details::{BoxLine, BoxText, Details, Looking};
use resultant::view::facts::ArrowKind;
use resultant::view::focus::Focus;
use std::sync::Arc;

/// Smaller impacts, by their change of velocity, are not shown, m/s.
const UNTOLD: f64 = 1e-3;

/// A number or a vector as it is shown, y downwards, and half of its last digit.
#[derive(Clone, Copy, Debug, Default)]
struct Read {
    value: DVec2,
    half: f64,
}

impl Read {
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, half: self.half + other.half }
    }
}

fn read(line: &BoxLine) -> Read {
    let text = line.value.replace('−', "-");
    let text = text.trim();
    let (numbers, unit) = match text.strip_prefix('(') {
        Some(vector) => vector.split_once(')').expect("a bracket closes"),
        None => text.split_once(' ').expect("a unit follows"),
    };
    let one = prefix(unit.trim());
    let (x, y, decimals) = numbers_in(numbers);
    // Forces below a billionth are not written.
    let nothing = numbers.split(',').all(|number| number.trim() == "0");
    let half = if nothing { 1e-9 } else { 0.5 * one * 0.1f64.powi(decimals) + 1e-9 };
    Read { value: DVec2::new(x, -y) * one, half }
}

/// How many plain units one of these is.
fn prefix(unit: &str) -> f64 {
    match unit {
        "Mt" => return 1e9,
        "kt" => return 1e6,
        "t" => return 1e3,
        "kg" | "m/s" | "m/s²" => return 1.0,
        "g" => return 1e-3,
        "mg" => return 1e-6,
        _ => {}
    }
    power_of(["m/s²", "m/s", "N·s", "N"].into_iter().find_map(|plain| unit.strip_suffix(plain)).expect("a unit"))
}

#[derive(Clone, Copy, Debug)]
struct Told {
    mass: Read,
    velocity: Read,
    acceleration: Read,
    resultant: Read,
    forces: Read,
    impacts: Read,
}

impl Told {
    fn of(text: &BoxText) -> Self {
        let named =
            |name: &str| read(text.lines.iter().find(|line| line.label == name).unwrap_or_else(|| panic!("{name}: {text:?}")));
        let sum = |sort: fn(ArrowKind) -> bool| {
            text.lines.iter().filter(|line| line.shown.is_some_and(sort)).map(read).fold(Read::default(), Read::add)
        };
        Self {
            mass: named("Mass"),
            velocity: named("Velocity"),
            acceleration: named("Acceleration"),
            resultant: named("Resultant"),
            forces: sum(|shown| matches!(shown, ArrowKind::Force(_))),
            impacts: sum(ArrowKind::is_impact),
        }
    }

    /// Σ F = m·a and Σ F = the resultant, in each direction, within half of every last digit.
    fn check_sum(&self, what: &str) {
        let Self { mass, acceleration, resultant, forces, .. } = *self;
        let (m, a) = (mass.value.x, acceleration.value);
        for axis in 0..2 {
            let off = (forces.value[axis] - resultant.value[axis]).abs();
            assert!(off <= forces.half + resultant.half, "{what}: {forces:?} is not {resultant:?}");
            let within = forces.half + mass.half * a[axis].abs() + m * acceleration.half + mass.half * acceleration.half;
            let off = (forces.value[axis] - m * a[axis]).abs();
            assert!(off <= within, "{what}: {forces:?} is not {mass:?} times {acceleration:?}: {off} N apart, {within} at most");
        }
    }
}

/// A body's box, frame by frame, each a tick after the other.
struct Reader {
    body: BodyId,
    focus: Focus,
    details: Details,
    told: Vec<Told>,
}

/// Counts of the frames of a lesson.
#[derive(Debug, Default)]
struct Seen {
    frames: usize,
    moving: usize,
    impacts: usize,
    /// Frames in which digits alone were left open.
    sharp: usize,
}

impl Reader {
    fn new(body: BodyId) -> Self {
        let mut focus = Focus::default();
        focus.pick(Some(body), false);
        Self { body, focus, details: Details::default(), told: Vec::new() }
    }

    fn read(&mut self, game: &Game, seen: &mut Seen, name: &str) {
        let frame = Frame::default();
        let centres = centres(game);
        let (middle, level) = (centres[self.body.index()], game.level());
        let view = Viewport::new(middle, middle, level.size, level.metre, window(&frame));
        let looking = Looking { centres: &centres, focus: &self.focus, pointer: None, model: false, velocity: false };
        self.details.arrange(game, &looking, &[], &view, &frame);
        // Partners of the followed body have boxes, too.
        let own = self.details.boxes.iter().find(|placed| placed.text.body == self.body);
        let placed = own.unwrap_or_else(|| panic!("{name}: no box of {:?}", self.body));
        let told = Told::of(&placed.text);
        let what = format!("{name}, tick {}, {}", game.ticks(), placed.text.title);
        told.check_sum(&what);
        self.told.push(told);
        self.check_momentum(game, seen, &what);
        seen.frames += 1;
        seen.moving += usize::from(told.velocity.value != DVec2::ZERO);
        seen.impacts += usize::from(told.impacts.value != DVec2::ZERO);
    }

    /// m·Δv = ∫F dt + impulses over the time in which impacts can be read. A force may change at any moment of a tick: the tick's integral then
    /// lies between the integrals of the force before and after.
    fn check_momentum(&self, game: &Game, seen: &mut Seen, what: &str) {
        let (dt, ticks) = (1.0 / game.tick_rate(), (READABLE * game.tick_rate()) as usize + 1);
        let Some(start) = self.told.len().checked_sub(ticks + 1) else { return };
        let (window, last) = (&self.told[start..], self.told[self.told.len() - 1]);
        let (m, mass_half) = (last.mass.value.x, last.mass.half);
        let (mut given, mut digits, mut changes) = (last.impacts.value, last.impacts.half + m * UNTOLD, DVec2::ZERO);
        for pair in window.windows(2) {
            let [before, after] = [pair[0].forces, pair[1].forces];
            given += (before.value + after.value) * (0.5 * dt);
            digits += 0.5 * (before.half + after.half) * dt;
            changes += (after.value - before.value).abs() * (0.5 * dt);
        }
        let change = last.velocity.value - window[0].velocity.value;
        let velocities = last.velocity.half + window[0].velocity.half;
        for axis in 0..2 {
            let within = digits + m * velocities + mass_half * (change[axis].abs() + velocities);
            let off = (m * change[axis] - given[axis]).abs();
            assert!(off <= within + changes[axis], "{what}: {off} N·s of {given} apart, {within} + {changes} at most");
        }
        seen.sharp += usize::from(changes.max_element() <= digits);
    }
}

/// Plays a lesson and reads the boxes of some of its bodies on every frame.
fn play(name: &str, level: Arc<Level>, inputs: impl Iterator<Item = Controls>) -> Seen {
    let mut game = Game::new(level).unwrap();
    let first = u32::from(!game.level().ship_plays());
    let mut readers: Vec<_> = (first..game.world().bodies().len().min(4) as u32).map(|body| Reader::new(BodyId(body))).collect();
    let mut seen = Seen::default();
    readers.iter_mut().for_each(|reader| reader.read(&game, &mut seen, name));
    for controls in inputs {
        game.step(controls);
        readers.iter_mut().for_each(|reader| reader.read(&game, &mut seen, name));
    }
    seen
}

#[test]
fn in_an_experiment_the_text_obeys_newtons_laws_on_every_frame() {
    let mut all = Seen::default();
    for name in ["third-law", "momentum", "bounce", "friction", "buoyancy"] {
        let seen = play(name, experiment(name), (0..600).map(|_| Controls::default()));
        assert!(seen.moving > 200, "{name}: {seen:?}");
        all.impacts += seen.impacts;
        all.sharp += seen.sharp;
    }
    assert!(all.impacts > 100 && all.sharp > 1000, "{all:?}");
}

#[test]
fn in_a_flight_the_text_obeys_newtons_laws_on_every_frame() {
    for name in ["1", "2"] {
        let inputs = record(name, "careful").inputs;
        let seen = play(&format!("level {name}"), fixture(name), inputs.into_iter());
        assert!(seen.moving > 500 && seen.sharp > 1000, "{name}: {seen:?}");
    }
}
