//! One of the two plotted objects: its track in this flight, and in the flight before.

use crate::game::History;
use crate::instruments::track::BodyTrack;
use crate::physics::BodyId;

#[derive(Clone, Debug, Default)]
pub(super) struct PlotObject {
    /// The body that stays, whichever body is followed.
    pub kept: Option<BodyId>,
    now: Option<BodyTrack>,
    before: Option<BodyTrack>,
}

/// Reads on, at most `most` ticks; another body's track from its start.
fn read(read: &mut Option<BodyTrack>, body: Option<BodyId>, history: Option<&History>, most: u64) {
    let wanted = body.zip(history);
    if read.as_ref().map(BodyTrack::body) != wanted.map(|(body, _)| body) {
        // A flight of another level may lack the body.
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

impl PlotObject {
    /// Reads the flight first, and with the remaining ticks the one before.
    pub fn read(&mut self, body: Option<BodyId>, history: &History, before: Option<&History>, most: u64) {
        read(&mut self.now, body, Some(history), most);
        read(&mut self.before, body, before, most);
    }

    /// As far as it is read.
    pub fn track(&self) -> Option<&BodyTrack> {
        self.now.as_ref().filter(|track| !track.is_empty())
    }

    pub fn before(&self) -> Option<&BodyTrack> {
        self.before.as_ref().filter(|track| !track.is_empty())
    }

    pub fn has_all_of(&self, history: &History) -> bool {
        self.track().is_none_or(|track| track.tick_of(track.len() - 1) >= history.ticks())
    }

    /// The flight was left at that tick; the run before may also differ beyond its own end.
    pub fn back_to(&mut self, history: &History, tick: u64) {
        if let Some(track) = &mut self.now {
            track.back_to(history, tick);
        }
        self.before = None;
    }

    pub fn forget(&mut self) {
        (self.now, self.before) = (None, None);
    }
}
