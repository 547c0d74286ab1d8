//! The state of the objectives: touch, hold time and turn.

use super::event::GameEvent;
use super::ship::SHIP;
use super::touch::TOUCH;
use crate::level::{Level, Objective, ObjectiveKind};
use crate::physics::{BodyId, World};

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

/// Whether the ship, or a key object that fits, touches an objective.
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
