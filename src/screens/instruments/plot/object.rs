//! One of the two objects whose curves are drawn: its way through the flight, and through the flight before.

use crate::game::History;
use crate::instruments::track::BodyTrack;
use crate::physics::BodyId;

/// The object.
#[derive(Clone, Debug, Default)]
pub(super) struct Object {
    /// Who it stays, whoever is followed.
    pub kept: Option<BodyId>,
    now: Option<BodyTrack>,
    before: Option<BodyTrack>,
}

/// Reads on, so many ticks at most; another body's way from its start.
fn read(read: &mut Option<BodyTrack>, body: Option<BodyId>, history: Option<&History>, most: u64) {
    let wanted = body.zip(history);
    if read.as_ref().map(BodyTrack::body) != wanted.map(|(body, _)| body) {
        // A flight of another level may not have had it.
        let there = |(body, history): &(BodyId, &History)| body.index() < history.at(0).world().bodies().len();
        *read = wanted.filter(there).map(|(body, _)| BodyTrack::new(body));
    }
    if let (Some(track), Some(history)) = (read, history) {
        if !track.is_empty() && track.tick_of(track.len() - 1) > history.ticks() {
            track.back_to(history, history.ticks());
        }
        track.read(history, most);
    }
}

impl Object {
    /// Reads on: the flight first, and what is left of the ticks of the one before.
    pub fn read(&mut self, body: Option<BodyId>, history: &History, before: Option<&History>, most: u64) {
        read(&mut self.now, body, Some(history), most);
        read(&mut self.before, body, before, most);
    }

    /// Its way through the flight, as far as it is known.
    pub fn track(&self) -> Option<&BodyTrack> {
        self.now.as_ref().filter(|track| !track.is_empty())
    }

    /// The same through the flight before.
    pub fn before(&self) -> Option<&BodyTrack> {
        self.before.as_ref().filter(|track| !track.is_empty())
    }

    /// Whether all of a flight is known.
    pub fn has_all_of(&self, history: &History) -> bool {
        self.track().is_none_or(|track| track.tick_of(track.len() - 1) >= history.ticks())
    }

    /// The flight was left at that tick; what the run before does beyond its own end may be otherwise, too.
    pub fn back_to(&mut self, history: &History, tick: u64) {
        if let Some(track) = &mut self.now {
            track.back_to(history, tick);
        }
        self.before = None;
    }

    /// Other flights are to be read.
    pub fn forget(&mut self) {
        (self.now, self.before) = (None, None);
    }
}
