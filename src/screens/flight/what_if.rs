//! "What if": the level with other numbers, flown again by the same controls or on from where it is, beside the run before as a ghost, below a sign
//! with what is varied. Nothing of it counts: only a fresh attempt at the level as it is does.

use super::instruments::vary::{Varied, VaryFrom, VaryWish, written};
use super::{END_PAUSE, Flight};
use crate::draw::layout::{Area, DETAILS, Frame, GRID, PADDING, TEXT, Vec2};
use crate::game::{Again, Controls, Game, GhostPose, History, Outcome, SHIP, Tape, body_title, object_body};
use crate::view::{GhostShip, game_view::drawn_centre, hud::HudLayout, theme, widgets};
use crate::words::tr;
use crate::{draw::Canvas, draw::Style, level::Parameter, level::Problem, physics::BodyId, physics::DVec2, settings::Key};
use crate::{instruments::vary::Variation, screens::screen::Effect, screens::screen::Request, ui::Spectator, ui::input::Input};
use std::sync::Arc;

/// Ticks that are flown again in a frame: at least, at first and at most.
pub(super) const AGAIN: [u64; 3] = [60, 1200, 20_000];

#[derive(Debug)]
pub(super) struct WhatIf {
    variation: Variation,
    before: Before,
    /// The controls up to the moment that is shown, and that moment: a run that ends sooner does not lose them.
    tape: Tape,
    moment: u64,
    again: Option<Box<Again>>,
}

/// The run before the last change: as it was, and beyond its end by the controls of the run that is shown.
#[derive(Debug)]
struct Before {
    history: History,
    /// Up to which tick it had been flown when the change was made.
    known: u64,
    /// Where it is at the moment that is shown.
    game: Box<Game>,
}

impl Before {
    fn new(history: &History, game: &Game) -> Self {
        Self { known: history.ticks(), game: Box::new(game.clone()), history: history.clone() }
    }

    /// Shows it at a moment, or at its end.
    fn show(&mut self, tick: u64) {
        if self.game.ticks() != tick.min(self.history.ticks()) {
            self.history.seek(&mut self.game, tick);
        }
    }

    /// The run that is shown has made a tick with these controls.
    fn after_tick(&mut self, shown: &Game, controls: Controls) {
        let beyond = self.history.ticks() + 1 == shown.ticks() && self.game.outcome() == Outcome::Running;
        if beyond && self.game.ticks() + 1 == shown.ticks() {
            self.game.set_lasting_fuel(shown.lasting_fuel());
            self.game.step(controls);
            self.history.note(&self.game, controls);
        } else {
            self.show(shown.ticks());
        }
    }

    /// The run that is shown goes on otherwise from there: what was flown beyond its end by its controls has not been.
    fn back_to(&mut self, tick: u64) {
        let kept = tick.max(self.known);
        if kept < self.history.ticks() {
            self.history = self.history.until(kept);
        }
        self.show(tick);
    }
}

/// What is nearer to where it was in the run before is where it was, m.
const SAME: f64 = 1e-3;
/// What is turned less than this is as it was, degrees.
const AS_TURNED: f64 = 0.01;
const NARROWEST: f32 = 200.0;

impl Flight {
    pub(super) fn varied(&self) -> Varied<'_> {
        Varied {
            level: &self.run.attempt.level,
            variation: self.variation(),
            progress: self.run.what_if.as_ref().and_then(|what_if| Some(what_if.again.as_ref()?.progress())),
        }
    }

    /// What is varied; none while the level is flown as it is. It may be empty: then all was taken back, but what was flown counts no more.
    pub fn variation(&self) -> Option<&Variation> {
        self.run.what_if.as_ref().map(|what_if| &what_if.variation)
    }

    /// The run before the last change, where the level is varied.
    pub fn before(&self) -> Option<&History> {
        self.run.what_if.as_ref().map(|what_if| &what_if.before.history)
    }

    /// The game of that run at the moment that is shown, or where it ended before.
    pub fn game_before(&self) -> Option<&Game> {
        self.run.what_if.as_ref().map(|what_if| &*what_if.before.game)
    }

    pub(super) fn fulfil(&mut self, wish: VaryWish, spectator: &mut dyn Spectator) -> Option<Request> {
        match wish {
            VaryWish::Vary(variation, from, goes_on) => {
                if let Err(words) = self.vary(variation, from, goes_on) {
                    self.seen.instruments.vary.set_message(words, true);
                }
                let ticks = self.pilot.ahead.ticks(0.0);
                self.fly_again(ticks, spectator);
                None
            }
            VaryWish::Restore => Some(self.restore()),
            VaryWish::Save(name) => Some(Request::Do(Effect::SaveVaried(self.variation()?.clone(), name))),
        }
    }

    /// The level as it is, from its start: a fresh attempt. Until that has begun what is shown counts no more than before.
    fn restore(&mut self) -> Request {
        if let Some(what_if) = &mut self.run.what_if {
            what_if.variation = Variation::default();
        }
        Request::Do(Effect::Restart)
    }

    /// Varies the level from there on.
    /// Errors: what the loader or the engine would not accept, in words; nothing has changed then.
    fn vary(&mut self, variation: Variation, from: VaryFrom, goes_on: bool) -> Result<(), String> {
        let expected = |problems: Vec<Problem>| {
            problems.first().map_or_else(String::new, |problem| tr!("Expected {expected}.", expected = problem.expected))
        };
        let level = Arc::new(variation.apply(&self.run.attempt.level).map_err(expected)?);
        self.leave_what_came_after();
        let running = self.run.game.outcome() == Outcome::Running;
        let (tape, moment) = match self.run.what_if.take() {
            Some(what_if) if !running && what_if.moment > self.run.game.ticks() => {
                let kept = (what_if.tape.clone(), what_if.moment);
                self.run.what_if = Some(what_if);
                kept
            }
            what_if => {
                self.run.what_if = what_if;
                (self.run.history.tape(), self.run.game.ticks())
            }
        };
        let again = match from {
            VaryFrom::Start => Some(Box::new(tape.fly_in(level.clone(), moment).map_err(|error| error.to_string())?)),
            VaryFrom::Now if !running => return Err(tr("This run has ended: a change holds from its start.").to_owned()),
            VaryFrom::Now => None,
        };
        let before = match self.run.what_if.take() {
            Some(what_if) if goes_on => what_if.before,
            _ => Before::new(&self.run.history, &self.run.game),
        };
        if again.is_none() {
            // What was accepted above is accepted by the engine.
            self.run.history.go_on_in(&mut self.run.game, level).map_err(|error| error.to_string())?;
        }
        self.run.assisted = true;
        self.run.what_if = Some(Box::new(WhatIf { variation, before, tape, moment, again }));
        self.seen.instruments.flown_again();
        Ok(())
    }

    /// One frame of a level that is varied: whether it is still being flown again.
    pub(super) fn update_what_if(&mut self, frame_time: f64, spectator: &mut dyn Spectator) -> bool {
        let Some(what_if) = &self.run.what_if else { return false };
        if what_if.again.is_some() && frame_time > 0.0 {
            let ticks = self.pilot.ahead.ticks(frame_time);
            self.fly_again(ticks, spectator);
        }
        self.is_flown_again()
    }

    /// Whether a varied level is being flown again up to the moment that was shown.
    pub fn is_flown_again(&self) -> bool {
        self.run.what_if.as_ref().is_some_and(|what_if| what_if.again.is_some())
    }

    /// Flies on what is flown again, and shows it once it is where it was to be.
    fn fly_again(&mut self, ticks: u64, spectator: &mut dyn Spectator) {
        let Some(what_if) = &mut self.run.what_if else { return };
        if !what_if.again.as_mut().is_some_and(|again| again.fly(ticks)) {
            return;
        }
        let Some(again) = what_if.again.take() else { return };
        (self.run.game, self.run.history) = again.done();
        what_if.before.show(self.run.game.ticks());
        self.run.ended = 0.0;
        self.play_on_from(self.run.game.ticks());
        self.seen.instruments.flown_again();
        spectator.jumped(&self.run.game);
    }

    pub(super) fn after_tick_of_what_if(&mut self, controls: Controls) {
        if let Some(what_if) = &mut self.run.what_if {
            what_if.before.after_tick(&self.run.game, controls);
        }
    }

    /// The game has been brought to another moment of its history; whether it goes on otherwise from there.
    pub(super) fn show_before(&mut self, goes_on_otherwise: bool) {
        let tick = self.run.game.ticks();
        match &mut self.run.what_if {
            Some(what_if) if goes_on_otherwise => what_if.before.back_to(tick),
            Some(what_if) => what_if.before.show(tick),
            None => {}
        }
    }

    /// A run that counts for nothing has ended: Esc or Enter lead back to the level as it is.
    pub(super) fn end_what_if(&mut self, input: &Input) -> Option<Request> {
        self.run.ended += input.frame_time;
        (input.pressed(Key::Escape) || input.pressed(Key::Enter)).then(|| self.restore())
    }

    /// Begins a level again with the numbers that it was varied by: from the start, beside the run before where the level is the same.
    /// Errors: what is not accepted in the level as it is now, in words: it is flown as it is then.
    pub(super) fn begin_varied(&mut self, varied: Box<WhatIf>, same: bool) -> Result<(), String> {
        if varied.variation.is_empty() {
            return Ok(());
        }
        let gone = tr("The level has changed: it is flown as it is now.");
        let level = Arc::new(varied.variation.apply(&self.run.attempt.level).map_err(|_| gone)?);
        let game = Game::new(level).map_err(|error| error.to_string())?;
        let mut before = if same { varied.before } else { Before::new(&self.run.history, &self.run.game) };
        before.show(0);
        before.known = before.history.ticks();
        (self.run.history, self.run.game, self.run.assisted) = (History::new(&game), game, true);
        let (tape, moment) = (self.run.history.tape(), 0);
        self.run.what_if = Some(Box::new(WhatIf { before, tape, moment, again: None, ..*varied }));
        Ok(())
    }

    /// Those who are not there: who flies along, or the run before the last change.
    pub fn ghosts(&self) -> Vec<GhostShip> {
        let race = self.race().map(|race| race.poses(&self.run.game, self.alpha()));
        race.into_iter().flatten().chain(self.ghost_before()).collect()
    }

    fn ghost_before(&self) -> Option<GhostShip> {
        let (before, alpha) = (self.game_before()?, self.alpha());
        let elsewhere = |id: BodyId| {
            Some(drawn_centre(before, id, alpha)).filter(|then| then.distance(drawn_centre(&self.run.game, id, alpha)) > SAME)
        };
        let angle = before.ship().angle;
        let turned = (angle - self.run.game.ship().angle).abs() > AS_TURNED;
        let centre: Option<DVec2> = elsewhere(SHIP).or_else(|| turned.then(|| drawn_centre(before, SHIP, alpha)));
        let object = |i: usize| Some((i, elsewhere(object_body(i))?));
        Some(GhostShip {
            name: tr("before").to_owned(),
            pose: centre.map(|centre| GhostPose { centre, angle }),
            objects: (0..before.level().objects.len()).filter_map(object).collect(),
        })
    }

    fn what_if_words(&self) -> Option<String> {
        let variation = self.variation()?;
        let change = |(parameter, value): (Parameter, f64)| {
            let usual = parameter.of(&self.run.attempt.level)?;
            let name = parameter.shown().trim_end_matches(" ×").to_lowercase();
            let body = parameter.body().filter(|body| *body > 0).map(|body| BodyId(body as u32));
            let of = body.map_or_else(String::new, |body| body_title(&self.run.attempt.level, body) + ": ");
            Some(tr!(
                "{name} {value} (was {usual})",
                name = of + &name,
                value = written(parameter, value),
                usual = written(parameter, usual)
            ))
        };
        let changes: Vec<String> = variation.changes().filter_map(change).collect();
        Some(if changes.is_empty() {
            tr("What if: all as it was; R flies it so that it counts").into()
        } else {
            tr!("What if: {changes}", changes = changes.join(", "))
        })
    }

    /// The sign's upper left corner and the room to its right: between the timer and the panel, or below that where no room is left.
    pub(super) fn what_if_room(&self, frame: &Frame) -> (Vec2, f32) {
        let (hud, end) = (HudLayout::new(frame).status, frame.size.x - self.sheet_width(frame));
        let corner = Vec2::new(hud.max().x + GRID, hud.min.y);
        match self.seen.instruments.vary_area() {
            Some(panel) if panel.min.x - corner.x < NARROWEST => {
                (Vec2::new(panel.min.x, panel.max().y + GRID), panel.size.x - 2.0 * PADDING)
            }
            panel => (corner, panel.map_or(end, |panel| panel.min.x) - corner.x - GRID - 2.0 * PADDING),
        }
    }

    pub(super) fn draw_what_if(&self, canvas: &Canvas) {
        let Some(words) = self.what_if_words() else { return };
        canvas.end_layer();
        let style = Style::new(DETAILS, theme::accent());
        let (corner, room) = self.what_if_room(canvas.frame());
        let lines = widgets::lines(canvas, &words, room, style);
        let line = canvas.line_height(DETAILS);
        let widest = lines.iter().map(|line| canvas.width(line, style)).fold(0.0, f32::max);
        let area = Area::new(corner.x, corner.y, widest + 2.0 * PADDING, lines.len() as f32 * line + PADDING);
        widgets::panel_in(canvas, area, theme::panel().faded(0.9), theme::accent());
        for (i, text) in lines.iter().enumerate() {
            canvas.text(text, area.min + Vec2::new(PADDING, PADDING / 2.0 + i as f32 * line), style);
        }
        let ended = self.run.game.outcome() != Outcome::Running && self.run.ended >= END_PAUSE;
        if ended && self.open.pause.is_none() {
            let words =
                tr!("{end} A “what if” counts for nothing: R flies it again, Esc the level as it is.", end = self.end_words());
            let style = Style::new(TEXT, theme::text()).centred().middle();
            let width = (canvas.width(&words, style) + 2.0 * PADDING).min(canvas.size().x - 2.0 * PADDING);
            let size = Vec2::new(width, canvas.line_height(TEXT) + PADDING);
            let above = Vec2::new(canvas.size().x / 2.0, canvas.size().y - 2.5 * size.y);
            widgets::panel(canvas, Area::around(above, size));
            widgets::fitted(canvas, &words, above, canvas.size().x - 4.0 * PADDING, &[TEXT, DETAILS], theme::text());
        }
    }
}
