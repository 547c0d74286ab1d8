//! Reads a flight from its start, a few ticks a frame, so that whatever is asked for late is known from the first tick on: the flight's history
//! is flown again beside it, and costs memory for nothing that nobody asked for.

use crate::game::{Game, History};

/// The reader of a flight.
pub trait Reader {
    /// It begins with this game.
    fn begin(&mut self, start: &Game);
    /// The next tick led to this game.
    fn tick(&mut self, game: &Game);
    /// Whatever was read after that tick has not been.
    fn back_to(&mut self, tick: u64);
}

/// How far a flight has been read.
#[derive(Clone, Debug, Default)]
pub struct Walk {
    /// The game there; none before it has begun.
    game: Option<Box<Game>>,
}

impl Walk {
    /// Reads on, by `most` ticks at most, up to where the flight is.
    pub fn read(&mut self, history: &History, most: u64, reader: &mut impl Reader) {
        let game = self.game.get_or_insert_with(|| {
            let start = Box::new(history.at(0));
            reader.begin(&start);
            start
        });
        for _ in 0..most {
            let next = game.ticks() + 1;
            if next > history.ticks() {
                return;
            }
            history.seek(game, next);
            reader.tick(game);
        }
    }

    /// The flight was left at that tick and goes on otherwise: what was read after it is forgotten.
    pub fn back_to(&mut self, history: &History, tick: u64, reader: &mut impl Reader) {
        if let Some(game) = self.game.as_mut().filter(|game| game.ticks() > tick) {
            history.seek(game, tick);
            reader.back_to(tick);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Controls;
    use crate::level;
    use std::path::Path;
    use std::sync::Arc;

    /// The ticks that were read, and the ship's heights there, m.
    #[derive(Default)]
    struct Heights(Vec<(u64, f64)>);

    impl Reader for Heights {
        fn begin(&mut self, start: &Game) {
            self.tick(start);
        }

        fn tick(&mut self, game: &Game) {
            self.0.push((game.ticks(), game.world().body(crate::game::SHIP).position.y));
        }

        fn back_to(&mut self, tick: u64) {
            self.0.retain(|(at, _)| *at <= tick);
        }
    }

    #[test]
    fn a_flight_is_read_as_it_was_flown_also_where_it_was_left() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let level = Arc::new(level::load(&root.join("levels/1"), root).expect("it ships").level);
        let mut game = Game::new(level).expect("it loads");
        let mut history = History::new(&game);
        let mut flown = vec![game.world().body(crate::game::SHIP).position.y];
        let fly = |game: &mut Game, history: &mut History, flown: &mut Vec<f64>, ticks: usize, thrust: bool| {
            for _ in 0..ticks {
                let controls = Controls { thrust, ..Controls::default() };
                game.step(controls);
                history.note(game, controls);
                flown.push(game.world().body(crate::game::SHIP).position.y);
            }
        };
        fly(&mut game, &mut history, &mut flown, 200, true);
        let (mut walk, mut heights) = (Walk::default(), Heights::default());
        walk.read(&history, 150, &mut heights);
        assert_eq!(heights.0.len(), 151);
        walk.read(&history, 150, &mut heights);
        history = history.until(120);
        game = history.at(120);
        flown.truncate(121);
        walk.back_to(&history, 120, &mut heights);
        fly(&mut game, &mut history, &mut flown, 60, false);
        walk.read(&history, u64::MAX, &mut heights);
        let expected: Vec<(u64, f64)> = (0..).zip(flown).collect();
        assert_eq!(heights.0, expected);
    }
}
