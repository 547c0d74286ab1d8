//! The panels at the left: the scales of the arrows, the table. What the instruments draw in the level.

use super::figures::{FigureBar, FigureLine, Subject, in_focus};
use super::measured::{colour, label, pair};
use super::{Instruments, Tool, dock, measure::Measures, measure::TABLE_WORDS, vectors::Vector};
use crate::draw::layout::{Area, DETAILS, GRID, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::view::{camera::Viewport, theme, widgets};
use crate::{game::Game, game::SHIP, instruments::ledger::centre_of_mass, instruments::ledger::velocity_of_centre};
use crate::{number::scalar, ui::Ui, words::tr};

impl Measures {
    /// Draws the ground of each panel, and the scales, which depend on the view.
    pub(super) fn draw_grounds(&self, scene: (&Game, f64), (view, canvas): (&Viewport, &Canvas)) {
        for (tool, area) in self.panels.iter().copied() {
            widgets::panel(canvas, area);
            if tool == Tool::Vectors {
                self.draw_scales(scene, area, (view, canvas));
            }
        }
    }

    fn draw_scales(&self, scene: (&Game, f64), area: Area, (view, canvas): (&Viewport, &Canvas)) {
        for (i, vector) in Vector::ALL.into_iter().enumerate() {
            let a_metre = scalar(self.fitting(vector, scene, view, canvas), vector.unit());
            let words = tr!("{sign}: one square = {a_metre}", sign = vector.sign(), a_metre);
            let at = area.min + GRID + Vec2::new(0.0, i as f32 * dock::line(canvas.frame()));
            canvas.text(&words, at, Style::new(DETAILS, colour(vector)).mono());
        }
    }

    pub(super) fn show_table(&mut self, ui: &mut Ui<'_>, area: Area, game: &Game) {
        match self.buttons(ui, area) {
            Some("From now") => self.figures.count_from(Some(game.ticks())),
            Some("From start") => self.figures.count_from(None),
            Some(_) => self.figures.set_zero(game.world().body(in_focus(&self.focus, game)[0]).position.y),
            None => {}
        }
        let (canvas, frame, table) = (ui.canvas(), &self.frame, self.table());
        let (names, values) = self.columns();
        let right = |column: usize| Vec2::new(dock::width(frame, names + values * (column + 1)), 0.0);
        let (pitch, bars) = self.table_rows();
        let at = |row: usize| area.min + GRID + Vec2::new(0.0, row as f32 * pitch);
        for (column, name) in table.columns.iter().enumerate() {
            canvas.text(name, at(0) + right(column), Style::new(DETAILS, theme::accent()).mono().right());
        }
        for (row, line) in table.lines.iter().enumerate() {
            canvas.text(&line.name, at(row + 1), Style::new(DETAILS, line_colour(line)).mono());
            for (column, value) in line.values.iter().enumerate() {
                canvas.text(value, at(row + 1) + right(column), Style::new(DETAILS, theme::text()).mono().right());
            }
            if line.subject == Subject::Sum {
                let left = at(row + 1) - Vec2::new(0.0, 1.5);
                canvas.hairline(left, left + right(table.columns.len() - 1), theme::quiet());
            }
        }
        let first = at(table.lines.len() + 1) + Vec2::new(0.0, 0.5 * GRID);
        let bars = if bars { &table.bars[..] } else { &[] };
        let column = |i: usize| (dock::width(frame, names + values * i), dock::width(frame, values - 1));
        draw_bars(canvas, bars, (first, pitch), &column);
    }

    fn buttons(&self, ui: &mut Ui<'_>, panel: Area) -> Option<&'static str> {
        let foot = Vec2::new(panel.min.x + GRID, panel.max().y - 2.0 * GRID - dock::line(&self.frame));
        let style = Style::new(DETAILS, theme::text()).centred();
        let mut pressed = None;
        for (area, words) in dock::row(&self.frame, foot, &TABLE_WORDS).into_iter().zip(TABLE_WORDS) {
            if ui.small_button((words, tr(words)), area, style) {
                pressed = Some(words);
            }
        }
        pressed
    }
}

/// Lines from `first` on, a bar in each column, all of a unit to one scale, with momentum's zero in the middle; `column`: its begin and width.
fn draw_bars(canvas: &Canvas, bars: &[FigureBar], (first, line): (Vec2, f32), column: &dyn Fn(usize) -> (f32, f32)) {
    for (row, bar) in bars.iter().enumerate() {
        let all = || bars.iter().filter(|other| other.unit == bar.unit).flat_map(|bar| &bar.values).copied();
        let (least, most) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
        let (least, most) = if bar.unit == "J" { (least, most) } else { (least.min(-most), most.max(-least)) };
        let span = (most - least).max(f64::MIN_POSITIVE);
        let zero = if span > f64::MIN_POSITIVE { (-least / span) as f32 } else { 0.0 };
        let at = first + Vec2::new(0.0, row as f32 * line);
        canvas.text(bar.name, at, Style::new(DETAILS, bar.colour).mono());
        for (i, value) in bar.values.iter().enumerate() {
            let (left, width) = column(i);
            let ends = [zero, zero + (value / span) as f32].map(|part| at.x + left + part * width);
            let bar_at = Area::new(ends[0].min(ends[1]), at.y + 0.15 * line, (ends[1] - ends[0]).abs(), 0.7 * line);
            canvas.rounded(bar_at, 0.0, bar.colour);
            canvas.hairline(Vec2::new(ends[0], at.y), Vec2::new(ends[0], at.y + line), theme::text());
        }
    }
}

fn line_colour(line: &FigureLine) -> Colour {
    match line.subject {
        Subject::Quantity | Subject::Sum => theme::text(),
        Subject::Words => theme::quiet(),
        Subject::Force(kind) => theme::force(kind),
        Subject::Impact => theme::IMPACT,
    }
}

/// The radius of the centre of mass, canvas units.
const MARK: f32 = 9.0;

impl Instruments {
    /// Draws the readings in the level, where that is `seen`, and the ground of the panels above it.
    pub fn draw_in_level(&self, (game, alpha): (&Game, f64), seen: bool, (view, canvas): (&Viewport, &Canvas)) {
        if seen {
            self.measures.draw_in_level((game, alpha), (view, canvas));
        }
        if seen && self.uses(Tool::Centre) {
            draw_centre((game, alpha), view, canvas);
        }
        if seen && self.uses(Tool::Vary) {
            self.vary.draw_places(game.level(), (view, canvas));
        }
        if self.open {
            canvas.end_layer();
            self.measures.draw_grounds((game, alpha), (view, canvas));
        }
    }
}

/// A disc in quarters, as in books, with its speed.
fn draw_centre((game, alpha): (&Game, f64), view: &Viewport, canvas: &Canvas) {
    // An idle ship does not belong to the system.
    let bodies = &game.world().bodies()[game.lead().index()..];
    let (centre, velocity) = (centre_of_mass(bodies), velocity_of_centre(bodies));
    // Between the last two ticks, as everything on the screen.
    let at = view.point(centre - velocity * ((1.0 - alpha) / game.tick_rate()));
    if !canvas.frame().area().contains(at) {
        return;
    }
    canvas.disc(at, MARK + 2.0, theme::ground());
    canvas.disc(at, MARK, theme::text());
    let corner = |x: f32, y: f32| at + MARK * Vec2::new(x, y);
    for (x, y) in [(1.0, 1.0), (-1.0, -1.0)] {
        let arc = [0.0_f32, 22.5, 45.0, 67.5, 90.0].map(|angle| {
            let (sin, cos) = angle.to_radians().sin_cos();
            corner(x * cos, y * sin)
        });
        canvas.convex(&[&[at][..], &arc].concat(), theme::ground());
    }
    let lines = [tr("Centre of mass").to_owned(), format!("v {}", pair(velocity, "m/s"))];
    // Above or below, away from the ship, which is often near.
    let ship = view.point(game.world().body(SHIP).position);
    let up = if ship.y < at.y { 1.0 } else { -1.0 };
    let aside = Vec2::new(
        if ship.x < at.x { MARK } else { -MARK - canvas.width(&lines[1], Style::new(DETAILS, theme::text()).mono()) },
        up * 4.0 * GRID,
    );
    label(&lines, at + aside, theme::text(), canvas);
}
