//! The plot: up to four curves of two objects, in a band below the flight. The player chooses the quantities by mouse; each curve
//! begins at the first tick. An upright line stands at the world's moment, and leads to another one.

mod choices;
mod drawing;
mod hand;
mod panel;

use super::Stage;
use crate::draw::layout::{Area, Frame, Vec2};
use crate::instruments::chart::{Chart, ChartMember, TimeWindow};
use crate::instruments::{curve::Curve, fit::FitLaw, track::BodyTrack};
use crate::{game::History, game::body_title, instruments::quantity::Quantity, instruments::quantity::VectorPart};
use crate::{physics::BodyId, physics::DVec2, ui::Ui, ui::input::Input};
use crate::{screens::flight::pilot::Ahead, session::library::NewFile, words::tr};
use choices::PlotObject;
pub use hand::PlotPlaces;
use hand::{Hand, MOST_LINES, READINGS};
use panel::{Fitted, Format, Pick};
use std::path::PathBuf;

/// s.
const SHORTEST: f64 = 0.1;
/// The window of a flight that has just begun, s.
const AT_LEAST: f64 = 1.0;
/// An object this far from its start has shown its axis of motion, m.
const MOVED: f64 = 0.05;
/// The quantities of curves along an axis: a new curve takes the first of them that is missing.
const fn along(axis: VectorPart) -> [Quantity; MOST_LINES] {
    let place = if matches!(axis, VectorPart::X) { Quantity::X } else { Quantity::Y };
    [place, Quantity::Velocity(axis), Quantity::Acceleration(axis), Quantity::Resultant(axis)]
}

#[derive(Clone, Debug)]
struct PlotLine {
    whose: usize,
    up: Quantity,
    now: Curve,
    before: Curve,
    read: Option<BodyId>,
}

impl PlotLine {
    fn new(whose: usize, across: Quantity, up: Quantity) -> Self {
        Self { whose, up, now: Curve::new(across, up), before: Curve::new(across, up), read: None }
    }
}

#[derive(Clone, Debug, Default)]
pub struct Plot {
    lines: Vec<PlotLine>,
    across: Quantity,
    /// The axis of the object's motion, until the player chooses.
    axis: VectorPart,
    settled: bool,
    objects: [PlotObject; 2],
    names: [Option<String>; 2],
    compared: bool,
    level: String,
    tick_rate: f64,
    /// `None`: the whole flight.
    window: Option<TimeWindow>,
    span: Option<(u64, u64)>,
    selected: usize,
    /// The law that goes through the selected curve, and its figures for the present stretch.
    law: Option<FitLaw>,
    fitted: Option<Fitted>,
    pick: Option<Pick>,
    hand: Hand,
    large: bool,
    message: Option<(String, bool)>,
    waiting: Option<Format>,
    pub export: Option<NewFile>,
    pub seek: Option<u64>,
    now: u64,
    ahead: Ahead,
    places: Option<PlotPlaces>,
}

impl Plot {
    /// Shows the panel at the foot of the input's frame; returns the rest of the input.
    pub fn show(&mut self, ui: &mut Ui<'_>, input: &Input, stage: &Stage) -> Input {
        self.read(input.worked(), stage);
        self.refit();
        let places = PlotPlaces::new(&input.frame, self.large);
        let chart = self.chart();
        let picking = self.is_picking();
        self.draw_panel(&places, &chart, ui.canvas());
        let buttons = self.show_buttons(ui, &places);
        let chosen = self.pick.and_then(|pick| self.show_picker(ui, pick, &places));
        if let Some(action) = chosen.or(buttons) {
            self.act(action);
        } else if picking {
            // A click beside the open list closes it.
            let beside = input.click && !self.picker(&places).is_some_and(|list| list.contains(input.pointer));
            self.pick = self.pick.filter(|_| !beside);
        } else {
            self.follow_pointer(input, (&places, &chart), stage.seekable);
        }
        let mut rest = input.clone();
        // A click beside the open list only closes it.
        if picking || places.panel.contains(input.pointer) || self.hand != Hand::Empty {
            (rest.click, rest.wheel, rest.pointed) = (false, 0.0, None);
        }
        self.places = Some(places);
        rest
    }

    pub fn is_picking(&self) -> bool {
        self.pick.is_some()
    }

    pub fn above(&self, frame: &Frame) -> Frame {
        Frame { size: Vec2::new(frame.size.x, PlotPlaces::new(frame, self.large).panel.min.y), ..*frame }
    }

    pub fn area(&self, frame: &Frame) -> Area {
        PlotPlaces::new(frame, self.large).panel
    }

    pub fn report_export(&mut self, outcome: Result<PathBuf, String>) {
        self.message = Some(match outcome {
            Ok(path) => (tr!("Written: {path}", path = path.display()), false),
            Err(problem) => (problem, true),
        });
    }

    pub fn back_to(&mut self, history: &History, tick: u64) {
        self.objects.iter_mut().for_each(|object| object.back_to(history, tick));
        self.span = self.span.filter(|(_, to)| *to <= tick);
        self.refresh(false);
    }

    #[must_use]
    pub fn of_another_flight(mut self) -> Self {
        self.objects.iter_mut().for_each(|object| object.kept = None);
        self.flown_again();
        (self.span, self.window, self.waiting, self.seek) = (None, None, None, None);
        self
    }

    /// The flight, or the run before, is another one: both are read from their first ticks.
    pub fn flown_again(&mut self) {
        self.objects.iter_mut().for_each(PlotObject::forget);
        self.refresh(true);
    }

    fn read(&mut self, frame_time: f64, stage: &Stage) {
        let game = stage.game;
        let there = |body: &BodyId| body.index() < game.world().bodies().len();
        let focus = [Some(stage.focus.followed.unwrap_or(game.lead())), stage.focus.compared];
        let most = self.ahead.ticks(frame_time);
        for ((object, name), focus) in self.objects.iter_mut().zip(&mut self.names).zip(focus) {
            let body = object.kept.or(focus).filter(there);
            object.read(body, stage.history, stage.before, most);
            *name = body.map(|body| body_title(game.level(), body));
        }
        (self.now, self.tick_rate) = (game.ticks(), game.tick_rate());
        self.level.clone_from(&game.level().name);
        if self.lines.is_empty() && !self.settled {
            self.lines.extend(along(self.axis)[..2].iter().map(|up| PlotLine::new(0, self.across, *up)));
        }
        self.settle();
        let compared = self.names[1].is_some();
        if compared && !self.compared && 2 * self.lines.len() <= MOST_LINES && self.lines.iter().all(|line| line.whose == 0) {
            // The compared object takes over the plotted quantities.
            self.lines.extend(self.lines.clone().into_iter().map(|line| PlotLine::new(1, self.across, line.up)));
        }
        self.compared = compared;
        self.refresh(false);
        let is_read = |track: &BodyTrack| track.tick_of(track.len() - 1) >= stage.history.ticks();
        let all = self.objects.iter().all(|object| object.track().is_none_or(is_read));
        if let (Some(format), true, true) = (self.waiting, all, frame_time > 0.0) {
            self.waiting = None;
            self.make_file(format, game);
        }
    }

    /// Plots along the axis in which the object moves, or is about to, until it has moved.
    fn settle(&mut self) {
        let Some(track) = self.objects[0].track().filter(|_| !self.settled) else { return };
        let (first, last) = (track.moment(0), track.moment(track.len() - 1));
        let moved = last.position - first.position;
        self.settled = moved.length() > MOVED;
        let motion = if self.settled { [moved; 3] } else { [last.velocity, last.acceleration, moved] };
        let Some(motion) = motion.into_iter().find(|motion| *motion != DVec2::ZERO) else { return };
        let axis = if motion.x.abs() > motion.y.abs() { VectorPart::X } else { VectorPart::Y };
        for (before, now) in along(self.axis).into_iter().zip(along(axis)) {
            self.lines.iter_mut().filter(|line| line.up == before).for_each(|line| line.up = now);
        }
        self.axis = axis;
    }

    /// Follows the tracks; begins at their start where they are of another flight.
    fn refresh(&mut self, restart: bool) {
        for line in &mut self.lines {
            let object = &self.objects[line.whose];
            let body = object.track().map(|track| track.body);
            if restart || line.read != body || (line.now.across, line.now.up) != (self.across, line.up) {
                *line = PlotLine { read: body, ..PlotLine::new(line.whose, self.across, line.up) };
            }
            if let Some(track) = object.track() {
                line.now.follow(track);
            }
            if let Some(track) = object.before() {
                line.before.follow(track);
            }
        }
    }

    /// Each non-empty curve with its number and its body's track.
    fn shown(&self) -> impl Iterator<Item = (usize, &PlotLine, &BodyTrack)> {
        let track = |line: &PlotLine| self.objects[line.whose].track();
        self.lines.iter().enumerate().filter_map(move |(i, line)| Some((i, line, track(line).filter(|_| !line.now.is_empty())?)))
    }

    /// s.
    fn window(&self) -> TimeWindow {
        self.window.unwrap_or_else(|| self.whole())
    }

    fn whole(&self) -> TimeWindow {
        let tracks = || self.objects.iter().flat_map(|object| [object.track(), object.before()]).flatten();
        let from = tracks().map(|track| track.time(0)).fold(f64::INFINITY, f64::min);
        let to = tracks().map(|track| track.time(track.len() - 1)).fold(0.0, f64::max);
        if from.is_finite() { (from, to.max(from + AT_LEAST)) } else { (0.0, AT_LEAST) }
    }

    fn chart(&self) -> Chart {
        let window = self.window();
        let mut members: Vec<ChartMember> = self.shown().map(|(i, line, track)| (i, &line.now, track.places(window))).collect();
        let before = |(i, line, _): (usize, &'_ PlotLine, &BodyTrack)| Some((i, self.objects[line.whose].before()?.places(window)));
        let places: Vec<_> = self.shown().filter_map(before).collect();
        members.extend(places.into_iter().map(|(i, places)| (i, &self.lines[i].before, places)));
        Chart::of(self.across, window, &members)
    }

    fn name(&self, whose: usize) -> &str {
        self.names[whose].as_deref().unwrap_or(tr("nobody"))
    }
}
