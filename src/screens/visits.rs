//! Recorded flights: listed, watched, raced and kept.

use crate::game::{Reel, Replay, TICK_RATE};
use crate::level::Level;
use crate::scores::{Board, subject};
use crate::screens::App;
use crate::screens::boards::flights::Flights;
use crate::screens::flight::Flight;
use crate::screens::screen::{Purpose, Request, Screen};
use crate::session::attempt::{Attempt, Rival};
use crate::session::recordings::{self, FlightCandidate, FlightSource, Visit};
use crate::ui::Spectator;
use crate::words::tr;
use std::sync::Arc;

impl App {
    /// Grants a request about recorded flights; `None`: the screen stays.
    pub(super) fn visit(&mut self, request: Request, spectator: &mut dyn Spectator) -> Option<Box<dyn Screen>> {
        let granted: Result<Box<dyn Screen>, String> = match request {
            Request::Flights(visit) => return Some(self.flights(visit)),
            Request::Watch(visit, candidate) => self.watch(visit, &candidate, spectator),
            Request::Race(visit, candidates) => self.race(&visit, &candidates).map(|attempt| self.flight(attempt, spectator)),
            Request::Keep(visit, candidate) => {
                let kept = self.keep(&visit, &candidate);
                self.tell_flights(kept);
                return None;
            }
            Request::CopyCode(visit, candidate) => {
                let code = self.named_record(&visit, &candidate).and_then(|(_, replay)| replay.code());
                let copied = code.map(|code| {
                    let words = tr!("Copied: {count} characters", count = code.len());
                    self.clipboard.keep(code);
                    words
                });
                self.tell_flights(copied);
                return None;
            }
            Request::PasteCode(visit, code) => {
                let pasted = self.paste(&visit, code);
                self.tell_flights(pasted);
                return None;
            }
            _ => return None,
        };
        granted.map_err(|problem| self.tell_flights(Err(problem))).ok()
    }

    /// The flights of a level, or why there is no such level.
    fn flights(&mut self, visit: Visit) -> Box<dyn Screen> {
        self.last_level = Some(visit.level.clone());
        let level = match self.library.load(&visit.level) {
            Ok(level) => level,
            Err(refusal) => return self.refused(Purpose::Play, &visit.level, refusal),
        };
        let (board, problem) = match self.scores.load(&visit.level) {
            Ok(loaded) => (loaded.board, None),
            Err(error) => (Board::default(), Some(error.to_string())),
        };
        let folder = self.places.levels.join(&visit.level);
        let candidates = recordings::candidates(&visit, &folder, &board, self.journal.current());
        let mut screen = Flights::new(visit, subject(&level.name, &level.title), candidates);
        if let Some(problem) = problem {
            screen.tell(problem, true);
        }
        Box::new(screen)
    }

    /// The level of a flight that is looked at.
    fn level_of(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<Arc<Level>, String> {
        match (&candidate.source, &visit.flown) {
            // As it was then.
            (FlightSource::Flown, Some(flown)) => Ok(flown.level.clone()),
            _ => self.library.load(&visit.level).map_err(|refusal| refusal.into_iter().next().unwrap_or_default()),
        }
    }

    fn watch(&self, visit: Visit, candidate: &FlightCandidate, spectator: &mut dyn Spectator) -> Result<Box<dyn Screen>, String> {
        let level = self.level_of(&visit, candidate)?;
        let title = format!("{} · {}", tr(&level.title), candidate.name);
        let reel = match (&candidate.source, &visit.flown) {
            (FlightSource::Flown, Some(flown)) => Reel::flown(flown.history.clone()),
            _ => {
                let replay = recordings::record(&visit, candidate, &self.scores, &level)?;
                Reel::new(level, &replay.inputs, replay.tick_rate).map_err(|error| error.to_string())?
            }
        };
        Ok(Box::new(Flight::watch(title, reel, Request::Flights(visit), spectator)))
    }

    /// A flight by hand against those.
    fn race(&self, visit: &Visit, candidates: &[FlightCandidate]) -> Result<Attempt, String> {
        let level = self.library.load(&visit.level).map_err(|refusal| refusal.into_iter().next().unwrap_or_default())?;
        let rival = |candidate: &FlightCandidate| {
            let replay = recordings::record(visit, candidate, &self.scores, &level)?;
            if replay.tick_rate != TICK_RATE {
                return Err(tr!(
                    "{name}: flown at {rate} ticks a second, the game has {here}.",
                    name = candidate.name,
                    rate = replay.tick_rate,
                    here = TICK_RATE
                ));
            }
            Ok(Rival { name: candidate.name.clone(), inputs: Arc::new(replay.inputs) })
        };
        let rivals = candidates.iter().map(rival).collect::<Result<_, String>>()?;
        Ok(Attempt { rivals, ..Attempt::by_hand(level) })
    }

    /// Keeps a flight as a file, and says where.
    fn keep(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<String, String> {
        let (_, replay) = self.named_record(visit, candidate)?;
        let path = recordings::keep(&self.places.root.join("flights"), &visit.level, &candidate.name, &replay)?;
        Ok(tr!("Kept as {path}", path = path.display()))
    }

    /// A record with the player's name where it was just flown, and its level.
    fn named_record(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<(Arc<Level>, Replay), String> {
        let level = self.level_of(visit, candidate)?;
        let mut replay = recordings::record(visit, candidate, &self.scores, &level)?;
        let player = self.journal.current();
        if candidate.source == FlightSource::Flown && !player.is_guest() {
            replay.player = Some(player.to_string());
        }
        Ok((level, replay))
    }

    /// Flies the flight of a code, and lists it where it holds. Its length is bounded: two seconds at most.
    fn paste(&mut self, visit: &Visit, code: String) -> Result<String, String> {
        let replay = Replay::from_code(&code).map_err(|problem| tr!("No code of a flight: {problem}", problem))?;
        if replay.level != visit.level {
            return Err(tr!(
                "This flight is of level {level}, here are those of level {here}.",
                level = replay.level,
                here = visit.level
            ));
        }
        let name = replay.player.clone().unwrap_or_else(|| tr("Somebody").to_owned());
        let about = tr("by its code, proven").to_owned();
        let (score, time) = (Some(replay.score), Some(replay.time));
        let candidate = FlightCandidate { name, about, score, time, source: FlightSource::Code(code) };
        let level = self.level_of(visit, &candidate)?;
        let flown = replay.verify(level, |_| {}).map_err(|error| error.to_string())?;
        flown.map_err(|mismatch| tr!("This flight does not hold: {mismatch}", mismatch))?;
        let words = tr!("Proven: {name}", name = candidate.name);
        if let Some(screen) = self.screen.get_mut::<Flights>() {
            screen.add(candidate);
        }
        Ok(words)
    }

    /// Says on the list of flights what became of something.
    fn tell_flights(&mut self, became: Result<String, String>) {
        if let Some(screen) = self.screen.get_mut::<Flights>() {
            let bad = became.is_err();
            screen.tell(became.unwrap_or_else(|problem| problem), bad);
        }
    }
}
