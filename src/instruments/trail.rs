//! The places of bodies at every tenth of a second before the moment on the screen, as in a stroboscope's picture.
//!
//! Tenths are exact instants of the game's time: a tick of their own where the rate is a multiple of ten, and else a point between two ticks,
//! on the parabola through both with the velocity of the later one.

use super::track::Companion;
use crate::game::{Game, History};
use crate::physics::{BodyId, DVec2};
use std::collections::VecDeque;

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
    who: Vec<BodyId>,
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

    pub fn who(&self) -> &[BodyId] {
        &self.who
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
    use crate::game::Controls;
    use crate::level;
    use std::path::Path;
    use std::sync::Arc;

    const BALL: [BodyId; 1] = [BodyId(1)];

    fn flown(rate: f64, seconds: f64) -> History {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let level = Arc::new(level::load(&root.join("experiments/projectile"), root).expect("it ships").level);
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
