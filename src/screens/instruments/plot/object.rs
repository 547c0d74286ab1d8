//! One of the two objects whose curves are drawn: its way through the flight, and through the flight before.

use crate::game::History;
use crate::instruments::track::Track;
use crate::instruments::walk::Walk;
use crate::physics::BodyId;

/// The object.
#[derive(Clone, Debug, Default)]
pub(super) struct Object {
    /// Who it stays, whoever is followed.
    pub kept: Option<BodyId>,
    now: Option<Read>,
    before: Option<Read>,
}

/// A body's way as far as it has been read.
#[derive(Clone, Debug)]
struct Read {
    track: Track,
    walk: Walk,
}

impl Read {
    fn of(body: BodyId) -> Self {
        Self { track: Track::new(body), walk: Walk::default() }
    }
}

/// Reads on, so many ticks at most; another body's way from its start.
fn read(read: &mut Option<Read>, body: Option<BodyId>, history: Option<&History>, most: u64) {
    let wanted = body.zip(history);
    if read.as_ref().map(|read| read.track.body()) != wanted.map(|(body, _)| body) {
        // A flight of another level may not have had it.
        let there = |(body, history): &(BodyId, &History)| body.index() < history.at(0).world().bodies().len();
        *read = wanted.filter(there).map(|(body, _)| Read::of(body));
    }
    if let (Some(Read { track, walk }), Some(history)) = (read, history) {
        if !track.is_empty() && track.tick_of(track.len() - 1) > history.ticks() {
            walk.back_to(history, history.ticks(), track);
        }
        walk.read(history, most, track);
    }
}

impl Object {
    /// Reads on: the flight first, and what is left of the ticks of the one before.
    pub fn read(&mut self, body: Option<BodyId>, history: &History, before: Option<&History>, most: u64) {
        read(&mut self.now, body, Some(history), most);
        read(&mut self.before, body, before, most);
    }

    /// Its way through the flight, as far as it is known.
    pub fn track(&self) -> Option<&Track> {
        self.now.as_ref().map(|read| &read.track).filter(|track| !track.is_empty())
    }

    /// The same through the flight before.
    pub fn before(&self) -> Option<&Track> {
        self.before.as_ref().map(|read| &read.track).filter(|track| !track.is_empty())
    }

    /// Whether all of a flight is known.
    pub fn has_all_of(&self, history: &History) -> bool {
        self.track().is_none_or(|track| track.tick_of(track.len() - 1) >= history.ticks())
    }

    /// The flight was left at that tick; what the run before does beyond its own end may be otherwise, too.
    pub fn back_to(&mut self, history: &History, tick: u64) {
        if let Some(Read { track, walk }) = &mut self.now {
            walk.back_to(history, tick, track);
        }
        self.before = None;
    }

    /// Other flights are to be read.
    pub fn forget(&mut self) {
        (self.now, self.before) = (None, None);
    }
}
