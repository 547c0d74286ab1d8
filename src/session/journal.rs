//! Who plays, and what they have done: known at once, and on disk as soon as that can be.

use crate::game::{Game, Medals, Outcome, RunResult};
use crate::number::{clock, hundredths};
use crate::scores::{AttemptRow, Deed, Name, PlayerRecord, Players, Scores, ScoresError, damage_text};
use crate::words::tr;

/// What a lost attempt brings.
const LOST: &str = "A lost attempt scores 0 and cannot be saved.";

/// The players, and what waits to be written down.
#[derive(Debug)]
pub struct Journal {
    scores: Scores,
    players: Players,
    current: Name,
    /// What is not on disk yet.
    deeds: Vec<Deed>,
    attempts: Vec<AttemptRow>,
    /// The deeds of this sitting before the player had a name.
    by_guest: Vec<Deed>,
    trouble: Option<String>,
}

impl Journal {
    /// What is on disk; who was chosen last plays on.
    pub fn new(scores: Scores) -> Self {
        let mut journal = Self {
            scores,
            players: Players::default(),
            current: Name::guest(),
            deeds: Vec::new(),
            attempts: Vec::new(),
            by_guest: Vec::new(),
            trouble: None,
        };
        journal.read();
        if let Some(player) = journal.players.all().first() {
            journal.current = player.name().clone();
        }
        journal
    }

    /// Reads what others have written meanwhile.
    pub fn read(&mut self) {
        match self.scores.players() {
            Ok((players, damage)) => {
                self.players = players;
                self.trouble = (!damage.is_empty()).then(|| damage_text(&damage));
            }
            Err(error) => self.trouble = Some(error.to_string()),
        }
        self.deeds.iter().for_each(|deed| self.players.apply(deed));
    }

    /// Who plays.
    pub fn current(&self) -> &Name {
        &self.current
    }

    /// All players.
    pub fn players(&self) -> &Players {
        &self.players
    }

    fn player(&self) -> Option<&PlayerRecord> {
        self.players.get(&self.current)
    }

    /// The player's best time in a level, s; `None` until it is done.
    pub fn best(&self, level: &str) -> Option<f64> {
        self.player().and_then(|player| player.best(level))
    }

    /// The medals that a level has brought the player.
    pub fn medals(&self, level: &str) -> Medals {
        self.player().map(|player| player.medals(level)).unwrap_or_default()
    }

    /// What went wrong with writing or reading, while it does.
    pub fn trouble(&self) -> Option<&str> {
        self.trouble.as_deref()
    }

    /// Somebody plays from now on. Who has just said their name also gets what they have done in this sitting without one.
    pub fn choose(&mut self, name: Name, named: bool) {
        self.apply(Deed::Chosen(name.clone()));
        if named && self.current.is_guest() {
            for deed in std::mem::take(&mut self.by_guest) {
                if let Deed::Done { level, time, medals, .. } = deed {
                    self.apply(Deed::Done { player: name.clone(), level, time, medals });
                }
            }
        }
        self.current = name;
        self.save();
    }

    /// Takes note of an attempt that has ended. The answer says what it brought the player, or why it cannot be written down.
    pub fn note(&mut self, game: &Game, assisted: bool) -> String {
        let (level, time, player) = (game.level().name.clone(), game.time(), self.current.clone());
        self.attempts.push(AttemptRow {
            level: level.clone(),
            player: player.clone(),
            result: game.outcome().name(),
            time,
            fuel: game.fuel(),
            hits: game.collisions(),
            cause: game.killed_by().map(|death| death.name(game.level())).unwrap_or_default(),
            assisted,
        });
        let mut brought = game.result().death.map_or(tr(LOST).to_owned(), |death| format!("{death}. {}", tr(LOST)));
        if game.outcome() == Outcome::Completed {
            let before = self.best(&level);
            let medals = Medals::of(&game.level().awards, &RunResult { assisted, ..game.result() });
            let deed = Deed::Done { player: player.clone(), level: level.clone(), time: (!assisted).then_some(time), medals };
            if player.is_guest() {
                self.by_guest.push(deed.clone());
            }
            self.apply(deed);
            let shown = clock(time);
            brought = match before {
                _ if assisted => tr!("{player}: done, with help: neither time nor score is saved.", player),
                None => tr!("{player}: done for the first time, in {time}.", player, time = shown),
                Some(before) if hundredths(time) < hundredths(before) => {
                    tr!("{player}: your best time! It was {before}, it is {time}.", player, before = clock(before), time = shown)
                }
                Some(before) => tr!("{player}: {time}, your best time is {best}.", player, time = shown, best = clock(before)),
            };
        }
        self.save();
        self.trouble.clone().unwrap_or(brought)
    }

    fn apply(&mut self, deed: Deed) {
        self.players.apply(&deed);
        self.deeds.push(deed);
    }

    /// Tries once more to write down what waits.
    pub fn try_again(&mut self) {
        if !self.is_written() {
            self.save();
        }
    }

    /// Writes down what waits. What cannot be written waits for the next deed, the menu or the end of the sitting.
    fn save(&mut self) {
        self.trouble = self.close().err().map(|error| error.to_string());
    }

    /// Writes down what waits.
    ///
    /// # Errors
    /// Why it cannot be; it still waits then.
    pub fn close(&mut self) -> Result<(), ScoresError> {
        // A list that cannot be written holds up no other.
        let deeds = if self.deeds.is_empty() { Ok(()) } else { self.record_deeds() };
        let attempts = self.scores.append(&self.attempts);
        if attempts.is_ok() {
            self.attempts.clear();
        }
        deeds.and(attempts)
    }

    fn record_deeds(&mut self) -> Result<(), ScoresError> {
        self.players = self.scores.record(&self.deeds)?;
        self.deeds.clear();
        Ok(())
    }

    pub fn is_written(&self) -> bool {
        self.deeds.is_empty() && self.attempts.is_empty()
    }
}
