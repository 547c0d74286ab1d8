//! A game that goes along with the moment that is shown, to and fro in a flight, tick by tick: the moment itself may move by several ticks a
//! frame, or jump.

use crate::game::{Game, History, SHIP};

/// The game, once it stands somewhere.
#[derive(Clone, Debug, Default)]
pub struct Companion {
    game: Option<Box<Game>>,
}

impl Companion {
    /// After how many ticks it stands, if it does.
    pub fn tick(&self) -> Option<u64> {
        self.game.as_ref().map(|game| game.ticks())
    }

    /// Stands at that tick, or the nearest one that the flight has, with its forces as they were read when it was flown: the loads of a
    /// crowd's contacts are kept only for ticks before which the forces were read.
    pub fn stand_at(&mut self, history: &History, tick: u64) -> &Game {
        let game = self.game.get_or_insert_with(|| Box::new(history.at(0)));
        history.seek(game, tick.saturating_sub(1));
        game.world().forces(SHIP);
        history.seek(game, tick);
        game
    }

    /// Goes on to that tick, by `most` ticks at most; `met` sees the game after each. Whether it stands there now.
    pub fn go_on(&mut self, history: &History, tick: u64, most: u64, mut met: impl FnMut(&Game)) -> bool {
        let Some(game) = &mut self.game else { return false };
        let last = tick.min(history.ticks());
        for next in (game.ticks() + 1..=last).take(usize::try_from(most).unwrap_or(usize::MAX)) {
            history.seek(game, next);
            met(game);
        }
        game.ticks() == last
    }

    /// The flight was left at that tick: what it was later has not been.
    pub fn back_to(&mut self, tick: u64) {
        self.game = self.game.take().filter(|game| game.ticks() <= tick);
    }
}
