//! The impacts of the last half second, because one tick is too short to read. Time is the game's: impacts stand still in a pause.
//! No rule depends on them.

use super::ship::SHIP;
use crate::physics::{BodyId, DVec2, Event, Impulse, Obstacle};
use std::collections::VecDeque;

/// From this speed along the contact's normal a hit of the ship costs points, m/s.
pub const DAMAGING_SPEED: f64 = 10.0;
/// A hit this much slower counts as one of [`DAMAGING_SPEED`], m/s: a fall from 100 px at 15 N/kg ends at exactly 10 m/s on paper,
/// and a rounding below that in the engine.
const SPEED_ROUNDING: f64 = 1e-9;
/// From this speed along the contact's normal an impact raises dust, m/s. Lower, and a box that tips to rest smokes.
pub const DUST_SPEED: f64 = 2.0;

/// How long an impact stays readable, s. Shorter, and it is gone before a player finds it; longer, and it passes for the next one.
pub const READABLE: f64 = 0.5;
/// The most impacts in memory. With fewer, impacts of a large crowd go too soon.
const MOST: usize = 8192;

/// The impact of a body or surface on a body in one tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Felt {
    pub tick: u64,
    pub by: Obstacle,
    /// N·s.
    pub impulse: DVec2,
}

#[derive(Clone, Debug, Default)]
pub struct Impacts {
    kept: VecDeque<(u64, Impulse)>,
}

impl Impacts {
    /// Takes up the impacts of the tick just made, and drops the ones older than `ticks`.
    pub fn note(&mut self, tick: u64, ticks: u64, impulses: &[Impulse]) {
        while self.kept.front().is_some_and(|(at, _)| at + ticks < tick) {
            self.kept.pop_front();
        }
        self.kept.extend(impulses.iter().filter(|impulse| impulse.impact).map(|impulse| (tick, *impulse)));
        self.kept.drain(..self.kept.len().saturating_sub(MOST));
    }

    /// The impacts on a body, the largest first; all impacts of one body or surface in one tick are one.
    pub fn on(&self, body: BodyId) -> Vec<Felt> {
        let mut all: Vec<Felt> = Vec::new();
        for (tick, impulse) in &self.kept {
            let Some((vector, by)) = impulse.on(body) else { continue };
            match all.iter_mut().rev().take_while(|felt| felt.tick == *tick).find(|felt| felt.by == by) {
                Some(felt) => felt.impulse += vector,
                None => all.push(Felt { tick: *tick, by, impulse: vector }),
            }
        }
        // Of equal impacts the latest first.
        all.sort_by(|a, b| b.impulse.length_squared().total_cmp(&a.impulse.length_squared()).then(b.tick.cmp(&a.tick)));
        all
    }
}

/// Point and speed (m/s) of the ship's hardest hit in a tick with these events: a hit of several surfaces at once counts once. The
/// speed is relative, so that a moving body hits the resting ship as hard. Resting and sliding contacts are no impacts.
pub(super) fn damaging_hit(events: &[Event]) -> Option<(DVec2, f64)> {
    let hits = events.iter().filter_map(|event| {
        let &Event::Impact { a, b, point, speed, .. } = event else { return None };
        ((a == SHIP || b == Obstacle::Body(SHIP)) && speed >= DAMAGING_SPEED - SPEED_ROUNDING).then_some((point, speed))
    });
    hits.max_by(|(_, a), (_, b)| a.total_cmp(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn impulse(a: u32, b: Obstacle, x: f64) -> Impulse {
        Impulse { a: BodyId(a), b, vector: DVec2::new(x, 0.0), point: DVec2::ZERO, at: 0.0, impact: true }
    }

    #[test]
    fn both_ends_feel_it_the_largest_first_for_so_many_ticks() {
        let (wall, other) = (Obstacle::Surface(4), Obstacle::Body(BodyId(2)));
        let mut impacts = Impacts::default();
        impacts.note(10, 60, &[impulse(1, wall, 1.0), impulse(1, other, 2.0), impulse(1, wall, 0.5)]);
        impacts.note(11, 60, &[impulse(1, wall, 9.0)]);
        let felt = |impacts: &Impacts, body: u32| -> Vec<(u64, Obstacle, f64)> {
            impacts.on(BodyId(body)).into_iter().map(|felt| (felt.tick, felt.by, felt.impulse.x)).collect()
        };
        assert_eq!(felt(&impacts, 1), [(11, wall, 9.0), (10, other, 2.0), (10, wall, 1.5)]);
        assert_eq!(felt(&impacts, 2), [(10, Obstacle::Body(BodyId(1)), -2.0)]);
        assert_eq!(felt(&impacts, 3), []);
        impacts.note(70, 60, &[]);
        assert_eq!(felt(&impacts, 1).len(), 3, "60 ticks later");
        impacts.note(71, 60, &[]);
        assert_eq!(felt(&impacts, 1), [(11, wall, 9.0)]);
        impacts.note(72, 60, &[]);
        assert_eq!(felt(&impacts, 1), []);
    }

    #[test]
    fn the_memory_has_an_end() {
        let mut impacts = Impacts::default();
        let many = vec![impulse(0, Obstacle::Surface(0), 1.0); MOST + 7];
        impacts.note(0, 60, &many[..5]);
        impacts.note(1, 60, &many);
        assert_eq!((impacts.kept.len(), impacts.kept[0].0), (MOST, 1));
    }

    fn impact(a: u32, b: Obstacle, speed: f64) -> Event {
        Event::Impact { a: BodyId(a), b, point: DVec2::new(speed, 0.0), normal: DVec2::NEG_Y, speed }
    }

    #[test]
    fn ten_metres_a_second_damage_and_a_micrometre_less_does_not() {
        let floor = Obstacle::Surface(0);
        assert_eq!(damaging_hit(&[impact(0, floor, 10.0)]), Some((DVec2::new(10.0, 0.0), 10.0)));
        assert_eq!(damaging_hit(&[impact(0, floor, 10.0 - 1e-6)]), None);
        assert!(damaging_hit(&[impact(0, floor, 10.0_f64.next_down())]).is_some(), "rounding");
        assert_eq!(damaging_hit(&[]), None);
    }

    #[test]
    fn several_surfaces_in_one_hit_count_once_as_the_hardest() {
        let events = [9.0, 12.0, 14.0, 11.0].map(|speed| impact(0, Obstacle::Surface(speed as u32), speed));
        assert_eq!(damaging_hit(&events), Some((DVec2::new(14.0, 0.0), 14.0)));
    }

    #[test]
    fn only_the_ship_is_damaged_whichever_of_a_pair_it_is() {
        assert_eq!(damaging_hit(&[impact(1, Obstacle::Surface(0), 50.0), impact(1, Obstacle::Body(BodyId(2)), 50.0)]), None);
        assert!(damaging_hit(&[impact(1, Obstacle::Body(SHIP), 50.0)]).is_some());
        assert!(damaging_hit(&[impact(0, Obstacle::Body(BodyId(1)), 50.0)]).is_some());
    }
}
