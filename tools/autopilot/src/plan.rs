//! The text of a plan: settings of the pilot and steps to take, in pixels of the level. README.md describes it.

use rand::{Rng, RngExt};
use std::fmt;

/// What a step wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepKind {
    /// To be at a place, at a speed.
    Fly,
    /// The same with a load on the roof, or pressing on something below: what it does counts as a force on the ship.
    Carry,
    /// To hold the nose at an angle and burn for a while.
    Burn,
    /// To come to rest at a place.
    Land,
    /// To push an object along the ground.
    Push,
    /// To run into an object and go on pushing.
    Ram,
    /// To brake by thrusting backwards, until the ship moves no faster along its nose.
    Stop,
    /// To press nothing for a while.
    Hold,
    /// To press nothing until an object comes to a place, or for a while.
    Wait,
    /// To stay at a place in the air for a while.
    Hover,
    /// To go on if an object is at a place; if it has not come there after a while, to go back some steps.
    Again,
    /// To keep the nose at an angle and burn while the ship rises slower than wanted, up or down to a height.
    Lean,
    /// To skip some steps if an object is at a place; if it has not come there after a while, to take them.
    Unless,
}

/// A row of the plan. Lengths in pixels, everything else in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanStep {
    pub kind: StepKind,
    pub x: f64,
    pub y: f64,
    pub speed: f64,
    pub tolerance: f64,
    /// The body that is pushed or waited for: 1 is the level's first object.
    pub object: u32,
    pub seconds: f64,
    /// Steps to go back, or to skip.
    pub back: u32,
}

/// How the pilot flies.
#[derive(Clone, Debug, PartialEq)]
pub struct PilotSettings {
    /// Ticks from one decision to the next.
    pub beat: u32,
    /// The ship turns for multiples of this number of ticks.
    pub turn: u32,
    /// How fast an error of the velocity is mended, 1/s.
    pub grip: f64,
    /// The deceleration that is relied on ahead of a way point, m/s².
    pub brake: f64,
    /// m/s.
    pub top_speed: f64,
    /// Degrees by which the nose may lean from upright in flight.
    pub tilt: f64,
    /// The share of the engine that may thrust backwards in flight: 0 for none, 1 for all of it.
    pub reverse: f64,
    /// The time that the flight must not exceed, s.
    pub par: f64,
}

/// A plan, with its text for writing it again.
#[derive(Clone, Debug, PartialEq)]
pub struct FlightPlan {
    pub settings: PilotSettings,
    pub steps: Vec<PlanStep>,
    lines: Vec<Line>,
}

/// A line of the text.
#[derive(Clone, Debug, PartialEq)]
enum Line {
    /// A comment, a blank line or the header.
    Kept(String),
    Setting(&'static str),
    Step(usize),
}

const SETTINGS: [&str; 8] = ["beat", "turn", "grip", "brake", "top_speed", "tilt", "reverse", "par"];
const KINDS: [(&str, StepKind); 13] = [
    ("fly", StepKind::Fly),
    ("carry", StepKind::Carry),
    ("burn", StepKind::Burn),
    ("land", StepKind::Land),
    ("push", StepKind::Push),
    ("ram", StepKind::Ram),
    ("stop", StepKind::Stop),
    ("hold", StepKind::Hold),
    ("wait", StepKind::Wait),
    ("hover", StepKind::Hover),
    ("lean", StepKind::Lean),
    ("again", StepKind::Again),
    ("unless", StepKind::Unless),
];

impl PilotSettings {
    fn get(&self, name: &str) -> f64 {
        match name {
            "beat" => f64::from(self.beat),
            "turn" => f64::from(self.turn),
            "grip" => self.grip,
            "brake" => self.brake,
            "top_speed" => self.top_speed,
            "tilt" => self.tilt,
            "reverse" => self.reverse,
            _ => self.par,
        }
    }

    fn set(&mut self, name: &str, value: f64) {
        match name {
            "beat" => self.beat = value as u32,
            "turn" => self.turn = value as u32,
            "grip" => self.grip = value,
            "brake" => self.brake = value,
            "top_speed" => self.top_speed = value,
            "tilt" => self.tilt = value,
            "reverse" => self.reverse = value,
            _ => self.par = value,
        }
    }
}

impl FlightPlan {
    /// Reads a plan.
    pub fn parse(text: &str) -> Result<Self, String> {
        let settings =
            PilotSettings { beat: 10, turn: 5, grip: 2.5, brake: 6.0, top_speed: 12.0, tilt: 80.0, reverse: 0.0, par: 60.0 };
        let mut plan = Self { settings, steps: Vec::new(), lines: Vec::new() };
        for (number, line) in (1..).zip(text.lines()) {
            let cells: Vec<&str> = line.split(',').map(str::trim).collect();
            if line.trim().is_empty() || line.starts_with('#') || line.starts_with("step,") {
                plan.lines.push(Line::Kept(line.to_owned()));
                continue;
            }
            let cell = |index: usize| match cells.get(index) {
                None | Some(&"") => Ok(0.0),
                Some(cell) => match cell.parse::<f64>() {
                    Ok(value) if value.is_finite() => Ok(value),
                    _ => Err(format!("line {number}: found {cell:?}, expected a number")),
                },
            };
            if let Some(name) = SETTINGS.into_iter().find(|&name| name == cells[0]) {
                let value = cell(1)?;
                if value < 0.0 || (value == 0.0 && name != "reverse") || (matches!(name, "beat" | "turn") && value < 1.0) {
                    return Err(format!("line {number}: found {value}, expected {name} above 0"));
                }
                plan.settings.set(name, value);
                plan.lines.push(Line::Setting(name));
            } else if let Some((_, kind)) = KINDS.into_iter().find(|&(name, _)| name == cells[0]) {
                let (x, y, speed, tolerance) = (cell(1)?, cell(2)?, cell(3)?, cell(4)?);
                plan.lines.push(Line::Step(plan.steps.len()));
                plan.steps.push(PlanStep {
                    kind,
                    x,
                    y,
                    speed,
                    tolerance,
                    object: cell(5)? as u32,
                    seconds: cell(6)?,
                    back: cell(7)? as u32,
                });
            } else {
                return Err(format!(
                    "line {number}: found {:?}, expected a setting ({}) or a step ({})",
                    cells[0],
                    SETTINGS.join(", "),
                    KINDS.map(|(name, _)| name).join(", ")
                ));
            }
        }
        if plan.steps.is_empty() { Err("the plan has no step".to_owned()) } else { Ok(plan) }
    }

    /// A plan like this one with some of its numbers changed: way points by some pixels, speeds and gains by some per cent. They stay
    /// round, so that the plan can be read.
    pub fn varied(&self, random: &mut impl Rng) -> Self {
        let mut plan = self.clone();
        let scale = [1.0, 0.5, 0.2][random.random_range(0..3)];
        let often = [0.15, 0.4][random.random_range(0..2)];
        let mut vary = |value: &mut f64, span: f64, grain: f64, least: f64| {
            if random.random_bool(often) {
                let moved = *value + span * scale * random.random_range(-1.0..1.0);
                *value = ((moved / grain).round() * grain).max(least);
                // 0.30000000000000004 is not round.
                *value = (*value * 1000.0).round() / 1000.0;
            }
        };
        let settings = &mut plan.settings;
        vary(&mut settings.grip, 0.8, 0.05, 0.5);
        vary(&mut settings.brake, 2.0, 0.1, 2.0);
        vary(&mut settings.top_speed, 3.0, 0.1, 2.0);
        vary(&mut settings.tilt, 20.0, 1.0, 30.0);
        for step in &mut plan.steps {
            match step.kind {
                StepKind::Fly | StepKind::Carry => {
                    vary(&mut step.x, 30.0, 1.0, 0.0);
                    vary(&mut step.y, 30.0, 1.0, 0.0);
                    vary(&mut step.speed, 3.0, 0.1, 0.0);
                    vary(&mut step.tolerance, 15.0, 1.0, 10.0);
                }
                StepKind::Land => {
                    vary(&mut step.x, 20.0, 1.0, 0.0);
                    vary(&mut step.speed, 1.0, 0.1, 0.5);
                }
                StepKind::Push => {
                    vary(&mut step.x, 10.0, 1.0, 0.0);
                    if step.speed > 0.0 {
                        vary(&mut step.speed, 0.5, 0.1, 0.5);
                    }
                }
                StepKind::Ram => vary(&mut step.speed, 0.5, 0.1, 0.5),
                StepKind::Stop | StepKind::Again | StepKind::Unless => {}
                StepKind::Burn => {
                    vary(&mut step.x, 5.0, 1.0, -180.0);
                    vary(&mut step.seconds, 0.3, 0.05, 0.0);
                }
                StepKind::Hold | StepKind::Wait => vary(&mut step.seconds, 0.3, 0.05, 0.0),
                StepKind::Lean => {
                    vary(&mut step.x, 6.0, 1.0, -180.0);
                    vary(&mut step.y, 20.0, 1.0, 0.0);
                    vary(&mut step.speed, 0.8, 0.1, -20.0);
                    if step.seconds > 0.0 {
                        vary(&mut step.seconds, 0.3, 0.05, 0.05);
                    }
                }
                StepKind::Hover => {
                    vary(&mut step.x, 20.0, 1.0, 0.0);
                    vary(&mut step.y, 20.0, 1.0, 0.0);
                    vary(&mut step.seconds, 0.3, 0.05, 0.0);
                }
            }
        }
        if random.random_bool(0.1) {
            plan.settings.beat = [10, 15, 20, 25][random.random_range(0..4)];
        }
        if random.random_bool(0.1) {
            plan.settings.turn = [5, 10][random.random_range(0..2)];
        }
        plan
    }
}

impl fmt::Display for FlightPlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in &self.lines {
            match *line {
                Line::Kept(ref text) => writeln!(f, "{text}")?,
                Line::Setting(name) => writeln!(f, "{name},{}", self.settings.get(name))?,
                Line::Step(index) => {
                    let step = &self.steps[index];
                    let name = KINDS.into_iter().find(|&(_, kind)| kind == step.kind).map_or("", |(name, _)| name);
                    let numbers =
                        [step.x, step.y, step.speed, step.tolerance, f64::from(step.object), step.seconds, f64::from(step.back)];
                    let cells = numbers.map(|number| if number == 0.0 { String::new() } else { number.to_string() });
                    writeln!(f, "{}", format!("{name},{}", cells.join(",")).trim_end_matches(','))?;
                }
            }
        }
        Ok(())
    }
}
