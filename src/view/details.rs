//! The details overlay: a box for each body in view, tied to it by a thin line, the free-body arrows with their labels, and a legend
//! with the arrows' scale and the parts of the model that are at work.

use super::arrows::{self, Arrow, Label, Scale, place_labels};
use super::boxes::{self, Wish, covers_none};
use super::camera::Viewport;
use super::canvas::{Canvas, Style};
use super::facts::{Facts, Value, facts};
use super::focus::Focus;
use super::layout::{Area, CORNER, DETAILS, Frame, GRID, HudLayout, LINE, MONO_ADVANCE, Vec2};
use super::quantity::{number_width, quantity, scalar};
use super::theme::{self, faded};
use crate::game::{Game, SHIP};
use crate::level::Text;
use crate::physics::{Aabb, BodyId, DVec2};

/// Inside a box's edge, canvas units: above and below less than in a panel, for there may be many.
const PADDING: Vec2 = Vec2::new(2.0 * GRID, GRID);
/// Characters of the longest name in a box, and of the longest unit, with the space before each of the two other columns.
const NAME_WIDTH: usize = 15;
const UNIT_WIDTH: usize = 6;
/// Numbers are given room for this many characters at least, so that boxes seldom change their width: "−0.123".
const NUMBER_WIDTH: usize = 6;
/// The longest line of the legend, characters: longer ones are wrapped, so that it leaves room for the boxes.
const LEGEND_WIDTH: usize = 46;
/// About the mean width of a letter of the sans face, in heights of the text.
const WORDS_ADVANCE: f32 = 0.5;

/// A box with its place.
struct Placed {
    facts: Facts,
    area: Area,
    object: Vec2,
}

/// The overlay as it is laid out for one frame.
#[derive(Default)]
pub struct Details {
    boxes: Vec<Placed>,
    arrows: Vec<Arrow>,
    labels: Vec<Label>,
    legend: Vec<String>,
    legend_area: Area,
    /// Whether the legend is at the left: it changes sides when the ship comes to it.
    legend_left: bool,
    /// Bodies in view without a box.
    left_out: usize,
    /// Where each body's box was from its middle, so that it stays there.
    before: Vec<Option<Vec2>>,
    /// How many boxes were full ones.
    full: Option<usize>,
}

impl Details {
    /// Lays everything out anew. `centres` says where each body is drawn (m), `focus` of whom is told, `covered` what else stands on the screen.
    pub fn arrange(
        &mut self,
        game: &Game,
        (centres, focus): (&[DVec2], &Focus),
        covered: Option<Area>,
        view: &Viewport,
        frame: &Frame,
    ) {
        self.before.resize(centres.len(), None);
        let visible = view.visible();
        let bounds = |i: usize| Aabb::around(centres[i], game.world().bodies()[i].half);
        let mut shown: Vec<usize> =
            (0..centres.len()).filter(|&i| focus.shows(id(i)) && bounds(i).touches(&visible, 0.0)).collect();
        // Those near the ship choose first; the sort is stable, and the ship is nearest to itself.
        let from_ship = |i: &usize| centres[*i].distance_squared(centres[SHIP.index()]);
        shown.sort_by(|a, b| from_ship(a).total_cmp(&from_ship(b)));

        let scale = Scale::of(game, focus);
        self.arrows = shown.iter().flat_map(|&i| arrows::arrows(game, (id(i), centres[i]), &scale, view)).collect();
        let objects: Vec<Area> = shown.iter().map(|&i| on_canvas(&bounds(i), view)).collect();
        let level = game.level();
        let goals = level.objectives.iter().map(|objective| &objective.bounds);
        let marks = level.obstacles.iter().chain(goals).map(|bounds| on_canvas(bounds, view));
        let words = level.texts.iter().map(|text| words_area(text, view));
        let kept_clear: Vec<Area> =
            objects.iter().copied().chain(self.arrows.iter().map(Arrow::area)).chain(marks).chain(words).collect();
        self.legend = legend(game, &scale);
        let hud = HudLayout::new(frame);
        let below = covered.map_or(hud.status.max().y, |area| area.max().y) + 2.0 * GRID;
        let ship = on_canvas(&bounds(SHIP.index()), view).inset(-2.0 * GRID);
        let place = |left: bool| legend_area(&self.legend, frame, left.then_some(below));
        self.legend_left ^= !covers_none(&place(self.legend_left), &[ship]);
        self.legend_area = place(self.legend_left);
        let taken: Vec<Area> = hud.areas().into_iter().chain([self.legend_area]).chain(covered).collect();

        let (all, places) = self.fit(game, &shown, &objects, frame, &taken, &kept_clear);
        self.left_out = places.iter().filter(|place| place.is_none()).count();
        self.before.fill(None);
        self.boxes.clear();
        for (((facts, place), body), object) in all.into_iter().zip(places).zip(shown).zip(objects) {
            if let Some(area) = place {
                self.before[body] = Some(area.min - object.centre());
                self.boxes.push(Placed { facts, area, object: object.centre() });
            }
        }
        if self.left_out > 0 {
            let more = format!("{} more objects without a box", self.left_out);
            self.legend.push(more);
            self.legend_area = legend_area(&self.legend, frame, self.legend_left.then_some(below));
        }
        let taken: Vec<Area> = taken.into_iter().chain(self.boxes.iter().map(|placed| placed.area)).collect();
        let width = |name: &str| name.chars().count() as f32 * MONO_ADVANCE * frame.text_height(DETAILS);
        self.labels = place_labels(&self.arrows, frame.text_height(DETAILS) * 1.1, width, frame.area(), &taken);
    }

    /// The boxes and their places: as many full ones as go in, for the first bodies, and short ones for the rest. The number of full
    /// ones is found from that of the frame before, for it seldom changes.
    fn fit(
        &mut self,
        game: &Game,
        shown: &[usize],
        objects: &[Area],
        frame: &Frame,
        taken: &[Area],
        kept_clear: &[Area],
    ) -> (Vec<Facts>, Vec<Option<Area>>) {
        let told: Vec<Facts> = shown.iter().map(|&body| facts(game, id(body))).collect();
        let sizes: Vec<[Vec2; 2]> = told.iter().map(|full| [full, &full.short()].map(|facts| box_size(facts, frame))).collect();
        let try_full = |full: usize| {
            let wish = |(i, (&body, &object)): (usize, (&usize, &Area))| Wish {
                object,
                size: sizes[i][usize::from(i >= full)],
                before: self.before[body],
            };
            let wishes: Vec<Wish> = shown.iter().zip(objects).enumerate().map(wish).collect();
            boxes::place(&wishes, frame.area(), taken, kept_clear)
        };
        let fits = |places: &Vec<Option<Area>>| places.iter().all(Option::is_some);
        let mut full = self.full.unwrap_or(shown.len()).clamp(1, shown.len().max(1));
        let mut best = try_full(full);
        while !fits(&best) && full > 1 {
            full -= 1;
            best = try_full(full);
        }
        if fits(&best) && full < shown.len() {
            let more = try_full(full + 1);
            if fits(&more) {
                (full, best) = (full + 1, more);
            }
        }
        self.full = Some(full);
        let told = told.into_iter().enumerate().map(|(i, facts)| if i < full { facts } else { facts.short() }).collect();
        (told, best)
    }

    /// Draws the shapes and the words.
    pub fn draw(&self, canvas: &Canvas) {
        for placed in &self.boxes {
            let near = placed.object.clamp(placed.area.min, placed.area.max());
            canvas.line(near, placed.object, 1.5, faded(theme::quiet(), 0.6));
            canvas.disc(near, 3.0, theme::quiet());
        }
        arrows::draw(&self.arrows, canvas);
        for placed in &self.boxes {
            draw_box(placed, canvas);
        }
        arrows::draw_labels(&self.arrows, &self.labels, canvas);
        self.draw_legend(canvas);
    }

    fn draw_legend(&self, canvas: &Canvas) {
        panel(canvas, self.legend_area);
        for (i, line) in self.legend.iter().enumerate() {
            let at = self.legend_area.min + PADDING + Vec2::new(0.0, i as f32 * canvas.line_height(DETAILS));
            canvas.text(line, at, Style::new(DETAILS, theme::quiet()).mono());
        }
    }
}

fn draw_box(placed: &Placed, canvas: &Canvas) {
    panel(canvas, placed.area);
    let line = canvas.line_height(DETAILS);
    let at = |row: usize| placed.area.min + PADDING + Vec2::new(0.0, row as f32 * line);
    canvas.text(&placed.facts.title, at(0), Style::new(DETAILS, theme::accent()).mono());
    let width = number_width(&placed.facts.rows, NUMBER_WIDTH);
    let numbers = Vec2::new(NAME_WIDTH as f32 * MONO_ADVANCE * canvas.frame().text_height(DETAILS), 0.0);
    for (i, row) in placed.facts.rows.iter().enumerate() {
        let colour = row.shown.map_or(theme::quiet(), arrows::colour);
        canvas.text(row.name, at(i + 1), Style::new(DETAILS, colour).mono());
        let colour = if matches!(row.value, Value::Vector(DVec2::ZERO) | Value::Words(_)) { theme::quiet() } else { theme::text() };
        canvas.text(&quantity(row, width), at(i + 1) + numbers, Style::new(DETAILS, colour).mono());
    }
}

fn panel(canvas: &Canvas, area: Area) {
    canvas.rounded(area, CORNER, faded(theme::panel(), 0.97));
    canvas.rounded_edge(area, CORNER, 1.5, theme::panel_edge());
}

/// The size of a box: its longest possible line at the width of its numbers, and its lines.
fn box_size(facts: &Facts, frame: &Frame) -> Vec2 {
    let text = frame.text_height(DETAILS);
    // Brackets, comma and space stand between and around the two numbers.
    let characters = NAME_WIDTH + 2 * number_width(&facts.rows, NUMBER_WIDTH) + 4 + UNIT_WIDTH;
    let lines = facts.rows.len() + 1;
    Vec2::new(characters as f32 * MONO_ADVANCE * text, lines as f32 * text * LINE) + 2.0 * PADDING
}

fn legend(game: &Game, scale: &Scale) -> Vec<String> {
    let plan = game.world().plan().parts();
    let (newtons, newton_seconds) = (scalar(scale.newtons, "N"), scalar(scale.newton_seconds, "N·s"));
    let mut lines = vec![format!("Arrows: one square = {newtons}"), format!("Impacts: one square = {newton_seconds}")];
    if !plan.is_empty() {
        lines.push("Model at work:".to_owned());
        lines.extend(plan.into_iter().flat_map(|part| wrapped(&format!("· {part}"), LEGEND_WIDTH)));
    }
    lines
}

/// Words in lines of at most `width` characters, if no word is longer; from the second on they stand below the first one's words.
fn wrapped(words: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            Some(_) => lines.push(format!("  {word}")),
            None => lines.push(word.to_owned()),
        }
    }
    lines
}

/// About where words of the level stand.
fn words_area(text: &Text, view: &Viewport) -> Area {
    let letters = text.text.chars().count() as f32;
    Area { min: view.point(text.position), size: Vec2::new(letters * WORDS_ADVANCE, 1.0) * view.length(text.size) }
}

/// At the top right, or at the left so far down.
fn legend_area(lines: &[String], frame: &Frame, left: Option<f32>) -> Area {
    let text = frame.text_height(DETAILS);
    let longest = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0);
    let size = Vec2::new(longest as f32 * MONO_ADVANCE * text, lines.len() as f32 * text * LINE) + 2.0 * PADDING;
    let right = Vec2::new(frame.size.x - size.x - 2.0 * GRID, 2.0 * GRID);
    Area { min: left.map_or(right, |top| Vec2::new(2.0 * GRID, top)), size }
}

fn on_canvas(bounds: &Aabb, view: &Viewport) -> Area {
    let min = view.point(bounds.min);
    Area { min, size: view.point(bounds.max) - min }
}

const fn id(body: usize) -> BodyId {
    BodyId(body as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_of_the_legend_are_wrapped_below_their_words() {
        assert_eq!(wrapped("· one two three", 46), ["· one two three"]);
        assert_eq!(wrapped("· one two three four", 9), ["· one two", "  three", "  four"]);
        assert_eq!(wrapped("· incompressible", 9), ["·", "  incompressible"]);
    }
}
