//! Switches, fragile blocks and pods, tick by tick. A switch that is pressed at a tick's end works its parts as the next tick begins: until then
//! forces and motions are those of one world. A fragile block takes the blow that breaks it, and is gone after that tick.
//! The state of the objectives: touch, hold time and turn.

use super::{event::GameEvent, impacts::TOUCH, ship::SHIP};
use crate::level::{Level, Objective, ObjectiveKind, Presser, SurfaceOf, Switch, SwitchStay, Wire, Worked};
use crate::physics::{BodyId, Obstacle, World};

#[derive(Clone, Debug)]
pub struct Mechanisms {
    pressed: Vec<bool>,
    on: Vec<bool>,
    wires: Vec<Wire>,
    works: Vec<bool>,
    /// Indices in `Level::world`.
    fragile: Vec<usize>,
    broken: Vec<bool>,
    taken: Vec<bool>,
}

impl Mechanisms {
    /// Also sets the world by its switches.
    pub fn new(level: &Level, world: &mut World) -> Self {
        let off = vec![false; level.switches.len()];
        let wires = level.wires();
        let works: Vec<bool> = wires.iter().map(|wire| wire.is_on(&off)).collect();
        for (wire, on) in wires.iter().zip(&works) {
            work(wire.worked, *on, level, world);
        }
        let fragile = (0..level.world.len()).filter(|&block| level.world[block].breaks.is_some()).collect();
        let (broken, taken) = (vec![false; level.world.len()], vec![false; level.pods.len()]);
        Self { pressed: off.clone(), on: off, wires, works, fragile, broken, taken }
    }

    /// Works the parts of the switches that the last tick's end found pressed.
    pub fn work(&mut self, level: &Level, world: &mut World) {
        for (wire, on) in self.wires.iter().zip(&mut self.works) {
            if wire.is_on(&self.on) != *on {
                *on = !*on;
                work(wire.worked, *on, level, world);
            }
        }
    }

    pub fn note(&mut self, level: &Level, world: &mut World, events: &mut Vec<GameEvent>) {
        for (index, switch) in level.switches.iter().enumerate() {
            let pressed = is_pressed(switch, index, level, world);
            let pushed = pressed && !self.pressed[index];
            self.on[index] = match switch.latch {
                SwitchStay::Held => pressed,
                SwitchStay::Latched => self.on[index] || pressed,
                SwitchStay::Toggled => self.on[index] != pushed,
            };
            if pressed != self.pressed[index] {
                self.pressed[index] = pressed;
                events.push(GameEvent::Switched(index, pressed));
            }
        }
        for &index in &self.fragile {
            let breaks = level.world[index].breaks.filter(|_| !self.broken[index]);
            let surface = Obstacle::Surface(index as u32);
            let hits = || world.impulses().iter().filter(|impulse| impulse.impact && impulse.b == surface);
            let hit = |least: f64| hits().any(|impulse| impulse.vector.length() > least);
            if breaks.is_some_and(hit) {
                self.broken[index] = true;
                world.set_present(index, false);
                events.push(GameEvent::Broke(index));
            }
        }
    }

    /// False for a pod that is gone.
    pub fn take_pod(&mut self, index: usize) -> bool {
        !std::mem::replace(&mut self.taken[index], true)
    }

    pub fn on(&self) -> &[bool] {
        &self.on
    }

    pub fn is_pressed(&self, switch: usize) -> bool {
        self.pressed[switch]
    }

    /// A part without a switch is on, except a door, which is closed.
    pub fn is_on(&self, worked: Worked) -> bool {
        let found = self.wires.iter().position(|wire| wire.worked == worked);
        found.map_or(!matches!(worked, Worked::Door(_)), |wire| self.works[wire])
    }

    pub fn is_broken(&self, block: usize) -> bool {
        self.broken[block]
    }

    pub fn is_taken(&self, pod: usize) -> bool {
        self.taken[pod]
    }

    /// Feeds every bit of the state to `write`. A level without mechanisms has none.
    pub fn hash_state(&self, write: &mut impl FnMut(u64)) {
        let broken = self.fragile.iter().map(|&block| &self.broken[block]);
        let flags = self.pressed.iter().chain(&self.on).chain(&self.works).chain(broken).chain(&self.taken);
        flags.for_each(|flag| write(u64::from(*flag)));
    }
}

fn work(worked: Worked, on: bool, level: &Level, world: &mut World) {
    match worked {
        Worked::Mover(index) => world.set_running(level.surface_index(SurfaceOf::Mover(index)), on),
        Worked::Door(index) => world.set_present(level.surface_index(SurfaceOf::Door(index)), !on),
        Worked::Belt(index) => world.set_belt(index, if on { level.world[index].belt } else { 0.0 }),
        Worked::Stream(index) => world.set_blowing(index, on),
        Worked::Link(index) if level.links[index].def.rate != 0.0 => world.set_winding(index, on),
        Worked::Link(index) => world.set_linked(index, on),
    }
}

/// A plate is pressed by weight, an area by the touch of a body.
fn is_pressed(switch: &Switch, index: usize, level: &Level, world: &World) -> bool {
    if let Some(weight) = switch.weight {
        return world.load_on(level.surface_index(SurfaceOf::Plate(index))) > weight;
    }
    let counts = |body: BodyId| match switch.by {
        Presser::Any => true,
        Presser::Ship => body == SHIP,
        Presser::Object => body != SHIP,
        Presser::Key => body.index().checked_sub(1).is_some_and(|object| level.objects[object].key.is_some()),
    };
    let bodies = (0..world.bodies().len() as u32).map(BodyId);
    bodies.filter(|body| counts(*body)).any(|body| world.body(body).bounds().touches(&switch.bounds, TOUCH))
}

/// s. A hold this much shorter counts: few hold times are whole ticks.
const ROUNDING: f64 = 1e-9;

#[derive(Clone, Debug)]
pub struct Objectives {
    tick_rate: f64,
    met: Vec<bool>,
    /// Ticks of unbroken touch; `None` without a touch, or before the objective's turn.
    held: Vec<Option<u64>>,
}

impl Objectives {
    pub fn new(level: &Level, world: &World, tick_rate: f64) -> Self {
        let count = level.objectives.len();
        let mut objectives = Self { tick_rate, met: vec![false; count], held: vec![None; count] };
        objectives.note(level, world, &mut Vec::new());
        objectives
    }

    /// Looks at a tick's end, and adds an event for each change of an objective.
    pub fn note(&mut self, level: &Level, world: &World, events: &mut Vec<GameEvent>) {
        for (index, objective) in level.objectives.iter().enumerate() {
            let touched = self.is_open(level, index) && is_touched(objective, level, world);
            self.held[index] = touched.then(|| self.held[index].map_or(0, |ticks| ticks + 1));
            let kept = objective.order.is_some() && self.met[index];
            let met = kept || self.held[index].is_some_and(|ticks| ticks as f64 / self.tick_rate >= objective.hold - ROUNDING);
            if met != self.met[index] {
                self.met[index] = met;
                events.push(if met { GameEvent::ObjectiveMet(index) } else { GameEvent::ObjectiveLost(index) });
            }
        }
    }

    /// Whether all objectives with smaller numbers are met.
    pub fn is_open(&self, level: &Level, index: usize) -> bool {
        let before = |other: &Objective| other.order.is_some() && other.order < level.objectives[index].order;
        level.objectives.iter().zip(&self.met).all(|(other, &met)| met || !before(other))
    }

    pub fn met(&self) -> &[bool] {
        &self.met
    }

    /// False without any objective.
    pub fn are_all_met(&self) -> bool {
        !self.met.is_empty() && self.met.iter().all(|&met| met)
    }

    /// The share of an objective's hold time that has passed, 0 … 1.
    pub fn held(&self, objective: &Objective, index: usize) -> f64 {
        let seconds = self.held[index].map_or(0.0, |ticks| ticks as f64 / self.tick_rate);
        if objective.hold > 0.0 { (seconds / objective.hold).min(1.0) } else { 0.0 }
    }

    /// Feeds every bit of the state to `write`. The touch is state only where an objective has a hold time.
    pub fn hash_state(&self, level: &Level, write: &mut impl FnMut(u64)) {
        self.met.iter().for_each(|&met| write(u64::from(met)));
        for (_, held) in level.objectives.iter().zip(&self.held).filter(|(objective, _)| objective.hold > 0.0) {
            write(held.map_or(0, |ticks| ticks + 1));
        }
    }
}

fn is_touched(objective: &Objective, level: &Level, world: &World) -> bool {
    let touches = |body: BodyId| world.body(body).bounds().touches(&objective.bounds, TOUCH);
    match objective.kind {
        ObjectiveKind::Player => touches(SHIP),
        ObjectiveKind::Physics => (1..)
            .zip(&level.objects)
            .filter(|(_, object)| object.key.is_some_and(|key| objective.fits(key)))
            .any(|(body, _)| touches(BodyId(body))),
    }
}
