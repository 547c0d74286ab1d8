//! Flights through liquids, foreseen for several ticks.
//!
//! As long as a body goes on as the power series of its motion says ([`super::series`]), a tick is one look at a polynomial. A series holds
//! between kinks and turns: as no component of the velocity changes its sign before, the body is where it holds throughout a tick if it is
//! at both ends. A body that something meets, that is driven otherwise, or that is not where the series left it, is told anew: what is
//! foreseen of one says nothing about others.

use super::Body;
use super::bath::Forms;
use super::flow::{Course, Pose, flow_through};
use super::liquid::series;
use super::media::{Law, Media};
use super::series::Series;
use glam::DVec2;

/// Ticks for which a body is not foreseen that something has met before its first tick was over.
const PAUSE: u8 = 16;
/// The same where there is no series, or none that lasts for some ticks: at first, twice as long each time, and at most.
const FIRST_PAUSE: u8 = 2;
const LONGEST_PAUSE: u8 = 32;
/// Ticks that a series has to last to be worth it.
const FEWEST: f64 = 3.0;
/// Work of a tick that was foreseen.
const WORK: u64 = 60;

/// What is foreseen of a body.
#[derive(Clone, Debug, Default)]
pub(super) struct Ahead {
    pub series: Series,
    /// How much of it is over, s.
    pub gone: f64,
    /// Whether the body is still on it.
    pub goes_on: bool,
    /// Whether some of it is in the air: where liquids overlap, that ends before the body is under all of them.
    pub in_air: bool,
    /// Where the last tick left the body, and under which force, N.
    pub at: Pose,
    pub force: DVec2,
    /// Ticks for which it is not foreseen, and the last such pause.
    pub pause: u8,
    pub last_pause: u8,
    /// Whether the body was near nothing but a liquid in the last tick. What was not may be in an island again, which finds out where it gets.
    pub alone: bool,
    /// The law around it, also as forms.
    pub law: Law,
    pub forms: Forms,
}

impl Ahead {
    /// Where a body is at the end of a tick of `t` seconds, if that has been foreseen.
    pub fn follow(&mut self, media: &Media, body: &Body, force: DVec2, t: f64) -> Option<Course> {
        if !self.goes_on {
            return None;
        }
        self.goes_on = self.at == (body.position, body.velocity) && self.force == force;
        if !self.goes_on {
            if self.gone <= t {
                (self.pause, self.last_pause) = (PAUSE, PAUSE);
            }
            return None;
        }
        self.go_to(media, body, self.gone + t)
    }

    /// The same, foreseeing it from here, under the law of now.
    pub fn begin(&mut self, media: &Media, body: &Body, force: DVec2, t: f64) -> Option<Course> {
        if self.pause > 0 {
            self.pause -= 1;
            return None;
        }
        let Some((series, forms)) = series(media, body, &self.law, FEWEST * t) else {
            self.last_pause = (2 * self.last_pause).clamp(FIRST_PAUSE, LONGEST_PAUSE);
            self.pause = self.last_pause;
            return None;
        };
        self.last_pause = 0;
        self.in_air = forms.shows_air(self.law.displaced.apart(body.position));
        (self.series, self.forms, self.force) = (series, forms, force);
        self.go_to(media, body, t)
    }

    /// Where a body is at the end of a tick of `t` seconds, found step by step.
    pub fn flow(&mut self, media: &Media, body: &Body, t: f64) -> Course {
        let course = flow_through(media, body, &self.law, t);
        self.law.first = course.next;
        course
    }

    fn go_to(&mut self, media: &Media, body: &Body, at: f64) -> Option<Course> {
        let Law { constant, displaced, liquids, .. } = &self.law;
        let (x, v) = self.series.at(at);
        let apart = displaced.apart(x);
        let holds = self.series.goes_as(v) && displaced.holds(x) && self.forms.shows_air(apart) == self.in_air;
        self.goes_on = holds && self.series.holds(at);
        if !self.goes_on {
            return None;
        }
        media.spend(WORK);
        (self.gone, self.at) = (at, (x, v));
        let waves = body.drag * displaced.waves(media, body, apart, liquids);
        // What has no velocity up or down may be in balance.
        let pull = (v.y != 0.0).then(|| self.forms.pull(*constant, apart, v, waves));
        Some(Course { end: self.at, time: at, next: f64::INFINITY, pull })
    }
}
