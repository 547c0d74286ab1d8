//! Draws what tells that a level is varied: a sign with what is, the ghost of the run before, and how to go on at its end.

use super::Flight;
use crate::draw::layout::{Area, DETAILS, GRID, PADDING, TEXT, Vec2};
use crate::draw::{Canvas, Style};
use crate::game::{GhostPose, SHIP, body_title, object_body};
use crate::physics::{BodyId, DVec2};
use crate::screens::flight::instruments::vary::written;
use crate::view::game_view::drawn_centre;
use crate::view::hud::HudLayout;
use crate::view::{GhostShip, theme, widgets};
use crate::words::tr;

/// What is nearer to where it was in the run before is where it was, m.
const SAME: f64 = 1e-3;
/// What is turned less than this is as it was, degrees.
const AS_TURNED: f64 = 0.01;

impl Flight {
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

    /// What is varied, in a sign beside the timer.
    fn what_if_words(&self) -> Option<String> {
        let variation = self.variation()?;
        let change = |(parameter, value): (crate::level::Parameter, f64)| {
            let usual = parameter.of(&self.run.attempt.level)?;
            let name = tr(parameter.name()).trim_end_matches(" ×").to_lowercase();
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

    /// The sign, and what leads on once the run has ended.
    pub(super) fn draw_what_if(&self, canvas: &Canvas) {
        let Some(words) = self.what_if_words() else { return };
        canvas.end_layer();
        let hud = HudLayout::new(canvas.frame()).status;
        let panel = self.seen.instruments.vary_area().map_or(canvas.size().x, |area| area.min.x);
        let left = hud.max().x + GRID;
        let style = Style::new(DETAILS, theme::accent());
        let room = panel - left - GRID - 2.0 * PADDING;
        let lines = widgets::lines(canvas, &words, room, style);
        let line = canvas.line_height(DETAILS);
        let widest = lines.iter().map(|line| canvas.width(line, style)).fold(0.0, f32::max);
        let area = Area::new(left, hud.min.y, widest + 2.0 * PADDING, lines.len() as f32 * line + PADDING);
        widgets::panel_in(canvas, area, theme::panel().faded(0.9), theme::accent());
        for (i, text) in lines.iter().enumerate() {
            canvas.text(text, area.min + Vec2::new(PADDING, PADDING / 2.0 + i as f32 * line), style);
        }
        if self.tells_of_the_end() && self.open.pause.is_none() {
            let words = tr!("{told} A “what if” counts for nothing: R flies it again, Esc the level as it is.", told = self.told());
            let style = Style::new(TEXT, theme::text()).centred().middle();
            let width = (canvas.width(&words, style) + 2.0 * PADDING).min(canvas.size().x - 2.0 * PADDING);
            let size = Vec2::new(width, canvas.line_height(TEXT) + PADDING);
            let above = Vec2::new(canvas.size().x / 2.0, canvas.size().y - 2.5 * size.y);
            widgets::panel(canvas, Area::around(above, size));
            widgets::fitted(canvas, &words, above, canvas.size().x - 4.0 * PADDING, &[TEXT, DETAILS], theme::text());
        }
    }
}
