//! The impacts of the last half second, because one tick is too short to read: no rule depends on them. Touching boxes, and the pushes of objects.

use super::ship::SHIP;
use crate::level::{SHIP_HALF, sweep_touches};
use crate::physics::{Aabb, BodyId, DVec2, Event, ForceManager, Impulse, Obstacle, Source, World};
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

/// Boxes closer than this touch, m. It covers the rounding from pixels to metres; a much larger gap would be visible.
pub const TOUCH: f64 = 1e-9;

/// Whether a body with these corners about its centre touched a box at any moment of the last tick, at whatever speed.
pub(super) fn has_passed(world: &World, body: BodyId, corners: &[DVec2], target: &Aabb) -> bool {
    let mut from = world.previous_position(body);
    world.path(body).any(|to| sweep_touches(corners, std::mem::replace(&mut from, to), to, target, TOUCH))
}

/// About the ship's centre, clockwise.
pub(super) const SHIP_BOX: [DVec2; 4] = [
    DVec2::new(-SHIP_HALF.x, -SHIP_HALF.y),
    DVec2::new(SHIP_HALF.x, -SHIP_HALF.y),
    DVec2::new(SHIP_HALF.x, SHIP_HALF.y),
    DVec2::new(-SHIP_HALF.x, SHIP_HALF.y),
];

/// Touches of the ship and one object less than this apart are one push, s. Shorter, and an object that bounces along before the
/// ship counts again and again; longer, and two deliberate nudges count as one.
pub const APART: f64 = 0.5;

/// A push begins when the ship touches an object that it has not touched for [`APART`], whichever of the two moves.
#[derive(Clone, Debug)]
pub struct PushCount {
    pub count: u32,
    /// By object, the tick after the last touch; 0 for never.
    touched: Vec<u64>,
}

impl PushCount {
    pub fn new(objects: usize) -> Self {
        Self { count: 0, touched: vec![0; objects] }
    }

    /// Takes the forces on the ship at a tick's end, and the impacts of that tick. `apart` is [`APART`] in ticks.
    pub fn note(&mut self, tick: u64, apart: f64, forces: &ForceManager, impulses: &[Impulse]) {
        let pressing = forces.forces().iter().filter_map(|force| if let Source::Body(by) = force.source { Some(by) } else { None });
        let hitting = impulses.iter().filter_map(|impulse| match impulse.on(SHIP) {
            Some((_, Obstacle::Body(by))) => Some(by),
            Some((_, Obstacle::Surface(_))) | None => None,
        });
        for body in pressing.chain(hitting) {
            let Some(last) = self.touched.get_mut(body.index().wrapping_sub(1)) else { continue };
            self.count += u32::from(*last == 0 || (tick + 1 - *last) as f64 >= apart);
            *last = tick + 1;
        }
    }

    /// Feeds every bit of the state to `write`; before the first push there is none.
    pub fn hash_state(&self, write: &mut impl FnMut(u64)) {
        if self.count > 0 {
            write(u64::from(self.count));
            self.touched.iter().for_each(|&tick| write(tick));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::level::ship_body;
    use proptest::prelude::*;
    use proptest::test_runner::FileFailurePersistence;

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

    const TARGET: Aabb = Aabb::new(DVec2::new(2.0, 3.0), DVec2::new(4.0, 3.1));
    const HALF: DVec2 = DVec2::new(0.5, 0.25);

    fn corners() -> [DVec2; 4] {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| HALF * DVec2::new(x, y))
    }

    fn touches(from: [f64; 2], to: [f64; 2]) -> bool {
        sweep_touches(&corners(), from.into(), to.into(), &TARGET, TOUCH)
    }

    #[test]
    fn what_flies_through_within_one_sweep_touches() {
        assert!(touches([3.0, -1000.0], [3.0, 1000.0]));
        assert!(touches([3.0, 1000.0], [3.0, -1000.0]));
        assert!(touches([-100.0, 3.05], [100.0, 3.05]));
        assert!(touches([3.0, 3.05], [3.0, 3.05]), "inside, at rest");
    }

    #[test]
    fn what_stops_short_or_passes_by_does_not() {
        assert!(!touches([3.0, 0.0], [3.0, 2.7]));
        assert!(!touches([3.0, 2.7], [3.0, 2.7]));
        assert!(!touches([0.0, 0.0], [0.0, 100.0]));
        assert!(!touches([0.0, 3.5], [2.5, 0.0]), "past the corner");
        assert!(!touches([3.0, 3.4], [3.0, 100.0]), "flying away");
    }

    #[test]
    fn touching_counts() {
        assert!(touches([3.0, 0.0], [3.0, 2.75]), "ends at the edge");
        assert!(touches([0.0, 2.75], [10.0, 2.75]), "slides along the edge");
        assert!(touches([1.5, 2.75], [1.5, 2.75]), "corner to corner");
        assert!(!touches([1.5, 2.75 - 1e-6], [1.5, 2.75 - 1e-6]), "a micrometre away");
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions"))),
            ..ProptestConfig::default()
        })]

        #[test]
        fn a_sweep_finds_whatever_a_walk_along_it_finds(x0 in -5.0..10.0, y0 in -5.0..10.0, x1 in -5.0..10.0, y1 in -5.0..10.0) {
            let (from, to) = (DVec2::new(x0, y0), DVec2::new(x1, y1));
            let touches_at = |t: f64, slop: f64| Aabb::around(from.lerp(to, t), HALF).touches(&TARGET, slop);
            let walked = (0..=1000).any(|i| touches_at(f64::from(i) / 1000.0, 0.0));
            // A step is at most 22 mm.
            let nearly = (0..=1000).any(|i| touches_at(f64::from(i) / 1000.0, 0.022));
            let swept = sweep_touches(&corners(), from, to, &TARGET, TOUCH);
            prop_assert!(swept || !walked, "the sweep misses a touch");
            prop_assert!(nearly || !swept, "the sweep invents a touch");
        }

        #[test]
        fn the_ships_body_touches_what_a_walk_of_its_outline_touches(
            angle in -360.0..360.0, x0 in -4.0..10.0, y0 in -4.0..10.0, x1 in -4.0..10.0, y1 in -4.0..10.0,
        ) {
            let (from, to, body) = (DVec2::new(x0, y0), DVec2::new(x1, y1), ship_body(angle));
            let target = Aabb::new(DVec2::new(2.0, 3.0), DVec2::new(4.0, 5.0));
            // Points of the outline are at most 10 mm apart, at places at most 20 mm apart: none is nearer to a corner of the
            // target than the sweep by more than that.
            let outline = || (0..body.len()).flat_map(|i| {
                let (a, b) = (body[i], body[(i + 1) % body.len()]);
                (0..64).map(move |part| a.lerp(b, f64::from(part) / 64.0))
            });
            let gap = |point: DVec2| (target.min - point).max(point - target.max).max(DVec2::ZERO).length();
            let nearest = (0..=1000)
                .flat_map(|i| outline().map(move |point| from.lerp(to, f64::from(i) / 1000.0) + point))
                .map(gap)
                .fold(f64::INFINITY, f64::min);
            let swept = sweep_touches(&body, from, to, &target, TOUCH);
            prop_assert!(swept || nearest > 0.0, "the sweep misses a touch");
            prop_assert!(!swept || nearest < 0.04, "the sweep invents a touch, {nearest} m away");
        }
    }
}
