//! All moments of one body in a flight, flown again beside its history, a few ticks a frame; a free fall costs 80 bytes a tick. A [`Companion`]
//! follows the moment on the screen to and fro; a [`Trail`] is the places of bodies at every tenth of a second before it, as under a stroboscope.

use super::quantity::{BodyConstants, Moment, Quantity, VectorPart, upwards};
use crate::game::{Game, History, SHIP};
use crate::physics::{BodyId, DVec2, ForceKind};
use std::{collections::VecDeque, ops::Range};

/// An impact that changed the velocity by less, m/s, does not show in a curve.
const SMALLEST_JUMP: f64 = 1e-3;

#[derive(Clone, Debug)]
pub struct BodyTrack {
    companion: Companion,
    pub body: BodyId,
    /// From which place on they hold, since the level may be varied during the flight.
    constants: Vec<(usize, BodyConstants)>,
    begins: u64,
    /// Ticks a second.
    pub rate: f64,
    position: Vec<DVec2>,
    velocity: Vec<DVec2>,
    acceleration: Vec<DVec2>,
    resultant: Vec<DVec2>,
    /// By kind, each up to the last tick in which it acted.
    forces: [Vec<DVec2>; ForceKind::ALL.len()],
    /// The impulses of each tick, up to the last one that had any, N·s.
    pub(super) impulses: Vec<DVec2>,
    /// The places of the ticks with an impact, in order.
    pub impacts: Vec<usize>,
}

impl BodyTrack {
    pub fn new(body: BodyId) -> Self {
        Self {
            companion: Companion::default(),
            body,
            constants: Vec::new(),
            begins: 0,
            rate: 1.0,
            position: Vec::new(),
            velocity: Vec::new(),
            acceleration: Vec::new(),
            resultant: Vec::new(),
            forces: std::array::from_fn(|_| Vec::new()),
            impulses: Vec::new(),
            impacts: Vec::new(),
        }
    }

    /// The number of ticks, the start included.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    pub const fn tick_of(&self, place: usize) -> u64 {
        self.begins + place as u64
    }

    /// The place of a tick, or the nearest to it.
    pub fn place(&self, tick: u64) -> usize {
        (tick.saturating_sub(self.begins) as usize).min(self.len().saturating_sub(1))
    }

    /// s.
    pub fn time(&self, place: usize) -> f64 {
        self.tick_of(place) as f64 / self.rate
    }

    /// The places within a stretch of time, and one more on either side, so that a curve reaches the edges.
    pub fn places(&self, (from, to): (f64, f64)) -> Range<usize> {
        let place = |time: f64| (time * self.rate - self.begins as f64).clamp(0.0, self.len() as f64);
        let first = (place(from).floor() as usize).saturating_sub(1);
        first..(place(to).ceil() as usize + 2).min(self.len()).max(first)
    }

    /// For a place below [`BodyTrack::len`].
    pub fn moment(&self, place: usize) -> Moment {
        Moment {
            time: self.time(place),
            constants: self.constants[self.constants.partition_point(|(from, _)| *from <= place).saturating_sub(1)].1,
            position: self.position[place],
            velocity: self.velocity[place],
            acceleration: self.acceleration[place],
            resultant: self.resultant[place],
            forces: std::array::from_fn(|kind| self.forces[kind].get(place).copied().unwrap_or_default()),
        }
    }

    /// ∫ up dt from one place to another, exactly, where a law has it, also across impacts: of v by the places, of p by m·Δr, of the resultant
    /// by m·Δv less what impacts passed on, of a by the same without m. Nothing of other quantities, and of the sizes of vectors.
    pub fn swept(&self, up: Quantity, from: usize, to: usize) -> Option<f64> {
        let (Quantity::Velocity(part) | Quantity::Momentum(part) | Quantity::Resultant(part) | Quantity::Acceleration(part)) = up
        else {
            return None;
        };
        let last = to.min(self.len().saturating_sub(1));
        let stretches = self.constants.iter().enumerate().map(|(i, (first, constants))| {
            // A tick has the constants that hold at its end.
            let end = self.constants.get(i + 1).map_or(usize::MAX, |(next, _)| next.saturating_sub(1));
            (from.max(first.saturating_sub(1)), last.min(end), constants.mass)
        });
        let all = stretches.filter(|(from, to, _)| from < to).map(|(from, to, mass)| {
            let velocity = || self.velocity[to] - self.velocity[from];
            let impulses = || self.impulses.iter().take(to + 1).skip(from + 1).sum::<DVec2>();
            match up {
                Quantity::Velocity(_) => self.position[to] - self.position[from],
                Quantity::Momentum(_) => mass * (self.position[to] - self.position[from]),
                Quantity::Resultant(_) => mass * velocity() - impulses(),
                _ => velocity() - impulses() / mass,
            }
        });
        match part {
            VectorPart::X => Some(all.map(|vector| vector.x).sum()),
            VectorPart::Y => Some(all.map(|vector| vector.y).sum()),
            VectorPart::Size => None,
        }
    }

    pub fn felt(&self, kind: ForceKind) -> bool {
        !self.forces[kind as usize].is_empty()
    }

    /// Reads on, by `most` ticks at most, up to the end of the flight.
    pub fn read(&mut self, history: &History, most: u64) {
        let mut companion = std::mem::take(&mut self.companion);
        if companion.tick().is_none() {
            self.begin(companion.stand_at(history, 0));
        }
        companion.go_on(history, u64::MAX, most, |game| self.tick(game));
        self.companion = companion;
    }

    /// The flight was left at that tick and goes on otherwise: later moments are void.
    pub fn back_to(&mut self, history: &History, tick: u64) {
        if self.companion.tick().is_some_and(|at| at > tick) {
            self.companion.stand_at(history, tick);
            self.forget_after(tick);
        }
    }

    pub(super) fn begin(&mut self, start: &Game) {
        *self = Self { begins: start.ticks(), rate: start.tick_rate(), ..Self::new(self.body) };
        self.tick(start);
    }

    pub(super) fn tick(&mut self, game: &Game) {
        let (place, moment) = (self.len(), Moment::of(game, self.body));
        if self.constants.last().is_none_or(|(_, constants)| *constants != moment.constants) {
            self.constants.push((place, moment.constants));
        }
        self.position.push(moment.position);
        self.velocity.push(moment.velocity);
        self.acceleration.push(moment.acceleration);
        self.resultant.push(moment.resultant);
        for (forces, force) in self.forces.iter_mut().zip(moment.forces) {
            if force != DVec2::ZERO {
                forces.resize(place, DVec2::ZERO);
                forces.push(force);
            }
        }
        let felt: DVec2 = game.world().impulses().iter().filter(|it| it.impact).filter_map(|it| Some(it.on(self.body)?.0)).sum();
        if place > 0 && felt != DVec2::ZERO {
            self.impulses.resize(place, DVec2::ZERO);
            self.impulses.push(upwards(felt));
        }
        if place > 0 && felt.length() >= SMALLEST_JUMP * moment.constants.mass {
            self.impacts.push(place);
        }
    }

    pub(super) fn forget_after(&mut self, tick: u64) {
        let length = ((tick + 1).saturating_sub(self.begins) as usize).min(self.len());
        for column in [&mut self.position, &mut self.velocity, &mut self.acceleration, &mut self.resultant] {
            column.truncate(length);
        }
        self.forces.iter_mut().for_each(|column| column.truncate(length));
        self.impulses.truncate(length);
        self.impacts.retain(|place| *place < length);
        self.constants.retain(|(from, _)| *from < length);
    }
}

#[derive(Clone, Debug, Default)]
pub struct Companion {
    game: Option<Box<Game>>,
}

impl Companion {
    pub fn tick(&self) -> Option<u64> {
        self.game.as_ref().map(|game| game.ticks())
    }

    /// Goes to that tick or the nearest one, with forces as the flight read them: a crowd's loads are kept for ticks before which they were read.
    pub fn stand_at(&mut self, history: &History, tick: u64) -> &Game {
        let game = self.game.get_or_insert_with(|| Box::new(history.at(0)));
        history.seek(game, tick.saturating_sub(1));
        game.world().forces(SHIP);
        history.seek(game, tick);
        game
    }

    /// Goes on to that tick, by `most` ticks at most; `met` sees the game after each. True where it arrives.
    pub fn go_on(&mut self, history: &History, tick: u64, most: u64, mut met: impl FnMut(&Game)) -> bool {
        let Some(game) = &mut self.game else { return false };
        let last = tick.min(history.ticks());
        for next in (game.ticks() + 1..=last).take(usize::try_from(most).unwrap_or(usize::MAX)) {
            history.seek(game, next);
            met(game);
        }
        game.ticks() == last
    }

    /// The flight was left at that tick: later ticks are void.
    pub fn back_to(&mut self, tick: u64) {
        self.game = self.game.take().filter(|game| game.ticks() <= tick);
    }
}

pub const DOTS_A_SECOND: u64 = 10;
/// s.
pub const LASTS: u64 = 5;
/// More bodies get no trail.
pub const MOST: usize = 64;

/// All places at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Dots {
    /// Tenths of a second since the flight's start.
    pub number: u64,
    /// One a body, m.
    pub places: Vec<DVec2>,
}

#[derive(Clone, Debug, Default)]
pub struct Trail {
    companion: Companion,
    pub who: Vec<BodyId>,
    /// The first known tick.
    from: u64,
    dots: VecDeque<Dots>,
}

impl Trail {
    /// Goes to that tick of a flight, by `most` ticks at most, with the trails of the first [`MOST`] of those bodies.
    pub fn go(&mut self, history: &History, tick: u64, most: u64, who: &[BodyId]) {
        let who = &who[..who.len().min(MOST)];
        let rate = history.start().tick_rate();
        let window = (LASTS as f64 * rate).ceil() as u64;
        let begins = history.start().ticks();
        let needed = tick.saturating_sub(window).max(begins);
        if self.who != who || self.from > needed || self.companion.tick().is_none_or(|at| at < needed) {
            // Twice as far back, so that stepping back does not begin again each time.
            let from = needed.saturating_sub(window).max(begins);
            let start = self.companion.stand_at(history, from);
            (self.who, self.from) = (who.to_vec(), from);
            self.dots.clear();
            self.dots.extend(dots_of_tick(start, who));
        }
        let (dots, who) = (&mut self.dots, &self.who);
        self.companion.go_on(history, tick, most, |game| dots.extend(dots_of_tick(game, who)));
        let at = self.companion.tick().unwrap_or(tick);
        if at.saturating_sub(self.from) > 3 * window {
            self.from = at - 2 * window;
            let from = self.from as f64;
            self.dots.retain(|dots| dots.number as f64 * rate >= from * DOTS_A_SECOND as f64);
        }
    }

    /// The dots up to that tick, not older than [`LASTS`], the oldest first.
    pub fn dots(&self, tick: u64, rate: f64) -> impl Iterator<Item = &Dots> {
        let newest = tick as f64 * DOTS_A_SECOND as f64 / rate;
        let oldest = newest - (LASTS * DOTS_A_SECOND) as f64;
        self.dots.iter().filter(move |dots| (oldest..=newest).contains(&(dots.number as f64)))
    }

    /// The flight was left at that tick: later dots are void.
    pub fn back_to(&mut self, tick: u64) {
        self.companion.back_to(tick);
    }
}

/// The dots of the instants after the tick before, up to the one that led to this game; of the start too.
fn dots_of_tick(game: &Game, who: &[BodyId]) -> Vec<Dots> {
    let (rate, tick) = (game.tick_rate(), game.ticks());
    // The number of tenths up to a tick, the start included.
    let up_to = |tick: u64| (tick as f64 * DOTS_A_SECOND as f64 / rate).floor() as u64 + 1;
    let first = if tick == 0 { 0 } else { up_to(tick - 1) };
    let place = |id: &BodyId, back: f64| {
        let (body, before) = (game.world().body(*id), game.world().previous_position(*id));
        // x(−s) = x₁ − v₁·s + ½a·s², s in ticks, so that x(−1) is its place before.
        let velocity = body.velocity / rate;
        body.position - velocity * back + (before - body.position + velocity) * (back * back)
    };
    let dots = |number: u64| {
        let back = (tick as f64 - number as f64 * rate / DOTS_A_SECOND as f64).max(0.0);
        Dots { number, places: who.iter().map(|id| place(id, back)).collect() }
    };
    (first..up_to(tick)).map(dots).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::EXPERIMENTS;
    use crate::game::{Controls, SHIP};
    use crate::level;
    use std::path::Path;
    use std::sync::Arc;

    #[test]
    fn a_flight_is_read_as_it_was_flown_also_where_it_was_left() {
        let mut game = Game::new(Arc::new(level::fixture())).expect("it loads");
        let mut history = History::new(&game);
        let mut flown = vec![game.world().body(SHIP).position.y];
        let fly = |game: &mut Game, history: &mut History, flown: &mut Vec<f64>, ticks: usize, thrust: bool| {
            for _ in 0..ticks {
                let controls = Controls { thrust, ..Controls::default() };
                game.step(controls);
                history.note(game, controls);
                flown.push(game.world().body(SHIP).position.y);
            }
        };
        fly(&mut game, &mut history, &mut flown, 200, true);
        let mut track = BodyTrack::new(SHIP);
        track.read(&history, 150);
        assert_eq!(track.len(), 151);
        track.read(&history, 150);
        history = history.until(120);
        game = history.at(120);
        flown.truncate(121);
        track.back_to(&history, 120);
        fly(&mut game, &mut history, &mut flown, 60, false);
        track.read(&history, u64::MAX);
        let read: Vec<f64> = (0..track.len()).map(|place| track.moment(place).position.y).collect();
        let expected: Vec<f64> = flown.into_iter().map(|y| track.moment(0).constants.height - y).collect();
        assert_eq!(read, expected);
    }

    const BALL: [BodyId; 1] = [BodyId(1)];

    fn flown(rate: f64, seconds: f64) -> History {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let level = Arc::new(level::load(&root.join(EXPERIMENTS).join("projectile"), root).expect("it ships").level);
        let mut game = Game::with_tick_rate(level, rate).expect("it loads");
        let mut history = History::new(&game);
        for _ in 0..(seconds * rate) as u32 {
            game.step(Controls::default());
            history.note(&game, Controls::default());
        }
        history
    }

    fn trail(history: &History, tick: u64) -> Trail {
        let mut trail = Trail::default();
        trail.go(history, tick, u64::MAX, &BALL);
        trail
    }

    #[test]
    fn dots_are_at_exact_tenths_also_between_ticks() {
        let bodies: Vec<BodyId> = (0..4).map(BodyId).collect();
        let exact = flown(120.0, 1.0);
        for rate in [60.0, 64.0, 128.0, 7.0] {
            let history = flown(rate, 1.0);
            let mut trail = Trail::default();
            trail.go(&history, rate as u64, u64::MAX, &bodies);
            let dots: Vec<&Dots> = trail.dots(rate as u64, rate).collect();
            assert_eq!(dots.iter().map(|dots| dots.number).collect::<Vec<_>>(), (0..=10).collect::<Vec<_>>());
            for dots in dots {
                let there = exact.at(dots.number * 12);
                for (place, body) in dots.places.iter().zip(there.world().bodies()) {
                    assert!(place.distance(body.position) < 1e-9, "{rate} Hz, tenth {}", dots.number);
                }
            }
        }
    }

    #[test]
    fn a_trail_is_the_same_however_its_moment_was_come_to_and_does_not_grow_without_end() {
        let history = flown(120.0, 20.0);
        let mut walked = Trail::default();
        let mut most = 0;
        let there_and_back = (0..=2400).step_by(97).chain((600..2400).rev().step_by(131)).chain([0, 2400, 17, 1200, 1199, 1198]);
        for tick in there_and_back {
            walked.go(&history, tick, u64::MAX, &BALL);
            most = most.max(walked.dots.len());
            let fresh = trail(&history, tick);
            assert!(walked.dots(tick, 120.0).eq(fresh.dots(tick, 120.0)), "tick {tick}");
            let oldest = (tick / 12).saturating_sub(if tick % 12 == 0 { 50 } else { 49 });
            assert_eq!(fresh.dots(tick, 120.0).next().map(|dots| dots.number), Some(oldest), "tick {tick}");
        }
        assert!(most <= 3 * 50 + 2, "{most} dots");
    }
}
