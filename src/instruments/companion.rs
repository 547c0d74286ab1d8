//! A game that follows the moment on the screen to and fro in a flight, tick by tick, although the moment itself may move by several
//! ticks a frame, or jump.

use crate::game::{Game, History, SHIP};

#[derive(Clone, Debug, Default)]
pub struct Companion {
    game: Option<Box<Game>>,
}

impl Companion {
    pub fn tick(&self) -> Option<u64> {
        self.game.as_ref().map(|game| game.ticks())
    }

    /// Goes to that tick, or the nearest one that the flight has, with its forces as the flight read them: the loads of a crowd's
    /// contacts are kept only for ticks before which the forces were read.
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
