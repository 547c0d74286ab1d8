//! The editor on the screen: the picture and what lies on it, then the panels around it.

use super::ask::Ask;
use super::hand::{Drag, Handle, stream_zone};
use super::layout::{BETWEEN, INSIDE, PROBLEM_LINES};
use super::{AT_LEFT, COMMANDS, Editor, Tool};
use crate::level::document::{Kind, Place, RowId, choices, number, unit};
use crate::level::read_picture;
use crate::physics::DVec2;
use crate::view::canvas::{Canvas, Style};
use crate::view::layout::{Area, BUTTON_TEXT, DETAILS, PADDING, TEXT, Vec2};
use crate::view::{theme, widgets};
use macroquad::color::{Color, WHITE};
use macroquad::shapes::{draw_rectangle, draw_rectangle_lines};
use macroquad::texture::{DrawTextureParams, FilterMode, Image, Texture2D, draw_texture_ex};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The pictures of the level that is edited, read when they are first drawn and again when files have changed.
#[derive(Default)]
pub struct Sheets {
    version: u64,
    textures: BTreeMap<PathBuf, Option<Texture2D>>,
}

impl Sheets {
    fn get(&mut self, path: &Path) -> Option<Texture2D> {
        let read = || {
            let image = Image::from_file_with_format(&read_picture(path).ok()?, None).ok()?;
            let texture = Texture2D::from_image(&image);
            texture.set_filter(FilterMode::Linear);
            Some(texture)
        };
        self.textures.entry(path.to_path_buf()).or_insert_with(read).clone()
    }
}

/// The colours of kinds: those of the game, where it has one.
fn colour(kind: Kind) -> Color {
    let of = |r, g, b| Color::from_rgba(r, g, b, 255);
    match kind {
        Kind::Setting | Kind::Text => theme::text(),
        Kind::Ship => theme::text(),
        Kind::Solid => theme::solid_top(),
        Kind::Mover => of(120, 150, 190),
        Kind::Door => of(190, 140, 90),
        Kind::Switch => of(110, 200, 220),
        Kind::Object => theme::quiet(),
        Kind::Key => theme::accent(),
        Kind::Pad => theme::player_objective(),
        Kind::KeyPad => theme::physics_objective(),
        Kind::Deadly => theme::bad(),
        Kind::Stream => of(150, 170, 200),
        Kind::Fluid => of(70, 130, 190),
        Kind::Gravity => of(150, 110, 210),
        Kind::Pod => theme::good(),
        Kind::Picture => of(140, 140, 140),
    }
}

/// What a block is made of, as a shade of its fill.
fn material(name: &str) -> Color {
    let of = |r, g, b| Color::from_rgba(r, g, b, 255);
    match name.to_ascii_lowercase().as_str() {
        "steel" => of(92, 106, 124),
        "ice" => of(120, 160, 180),
        "rubber" => of(48, 50, 58),
        "wood" => of(112, 84, 60),
        "glass" => of(88, 122, 128),
        "trampoline" => of(96, 60, 92),
        _ => theme::solid(),
    }
}

fn fill(area: Area, colour: Color) {
    draw_rectangle(area.min.x, area.min.y, area.size.x, area.size.y, colour);
}

fn edge(area: Area, width: f32, colour: Color) {
    draw_rectangle_lines(area.min.x, area.min.y, area.size.x, area.size.y, 2.0 * width, colour);
}

impl Editor {
    /// Draws all of it; `time` (s) makes the caret blink.
    pub fn draw(&self, sheets: &mut Sheets, canvas: &Canvas, time: f64) {
        if sheets.version != self.pictures {
            *sheets = Sheets { version: self.pictures, ..Sheets::default() };
        }
        self.draw_picture(sheets, canvas);
        canvas.end_layer();
        self.draw_selection(canvas);
        self.draw_map(canvas);
        canvas.end_layer();
        self.draw_commands(canvas);
        self.draw_tools(canvas);
        self.draw_panel(canvas, time);
        self.draw_problems(canvas);
        if let Some(ask) = &self.ask {
            draw_ask(ask, canvas);
        }
    }

    fn draw_picture(&self, sheets: &mut Sheets, canvas: &Canvas) {
        let level = self.view.rect(&Place { min: DVec2::ZERO, size: self.document.size() });
        fill(self.parts.middle, theme::panel());
        fill(level, theme::ground());
        let background = self.folder.background().and_then(|path| sheets.get(&path));
        match background {
            Some(texture) => draw_picture(&texture, level),
            None => self.draw_grid(canvas, level),
        }
        let visible = self.view.visible();
        let mut things: Vec<(RowId, Kind, Place)> = self
            .document
            .things()
            .filter_map(|(row, place)| Some((row, self.document.kind(row)?, place)))
            .filter(|(row, kind, place)| {
                place.meets(&visible) || *kind == Kind::Stream && stream_zone(&self.document, *row, *place).0.meets(&visible)
            })
            .collect();
        // Zones below, what is solid above them, what moves above that.
        let depth = |kind: Kind| match kind {
            Kind::Picture => 0,
            Kind::Fluid | Kind::Gravity => 1,
            Kind::Stream => 2,
            Kind::Solid => 3,
            Kind::Door | Kind::Mover | Kind::Deadly => 4,
            Kind::Switch | Kind::Pad | Kind::KeyPad | Kind::Pod => 5,
            Kind::Setting | Kind::Object | Kind::Key | Kind::Ship | Kind::Text => 6,
        };
        things.sort_by_key(|(_, kind, _)| depth(*kind));
        for (row, kind, place) in &things {
            self.draw_thing(sheets, canvas, *row, *kind, place);
        }
        edge(level, 1.0, theme::quiet());
        for wire in self.document.wires() {
            if let (Some(from), Some(to)) = (self.document.place(wire.switch), self.document.place(wire.thing)) {
                let colour = theme::faded(colour(Kind::Switch), 0.8);
                let (a, b) = (self.view.point(from.centre()), self.view.point(to.centre()));
                canvas.line(a, b, if wire.inverted { 1.0 } else { 2.0 }, colour);
                canvas.disc(b, 3.5, if wire.inverted { theme::bad() } else { colour });
            }
        }
    }

    /// Paper with a square a metre, a heavy line every ten, where there is no picture.
    fn draw_grid(&self, canvas: &Canvas, level: Area) {
        let metre = self.document.metre() * self.view.scale();
        let steps: &[(f64, Color)] = &[(1.0, theme::grid_fine()), (10.0, theme::grid_heavy())];
        for (metres, colour) in steps.iter().filter(|(metres, _)| metres * metre > 6.0) {
            let step = (metres * metre) as f32;
            let seen = |from: f32, least: f32| ((least - from) / step).ceil().max(0.0) as i32;
            let middle = self.parts.middle;
            let (end_x, end_y) = (level.max().x.min(middle.max().x), level.max().y.min(middle.max().y));
            let (top, left) = (level.min.y.max(middle.min.y), level.min.x.max(middle.min.x));
            for x in (seen(level.min.x, middle.min.x)..).map(|i| level.min.x + i as f32 * step).take_while(|x| *x <= end_x) {
                canvas.hairline(Vec2::new(x, top), Vec2::new(x, end_y), *colour);
            }
            for y in (seen(level.min.y, middle.min.y)..).map(|i| level.min.y + i as f32 * step).take_while(|y| *y <= end_y) {
                canvas.hairline(Vec2::new(left, y), Vec2::new(end_x, y), *colour);
            }
        }
    }

    fn draw_thing(&self, sheets: &mut Sheets, canvas: &Canvas, row: RowId, kind: Kind, place: &Place) {
        let (area, own) = (self.view.rect(place), colour(kind));
        let cell = |column: &str| self.document.cell(row, column).unwrap_or_default();
        match kind {
            Kind::Solid => {
                fill(area, material(cell("material")));
                edge(area, 1.0, theme::faded(own, 0.8));
                self.draw_one_way(canvas, area, cell("one_way"));
            }
            Kind::Mover | Kind::Door => {
                fill(area, theme::faded(own, if kind == Kind::Door { 0.5 } else { 0.75 }));
                edge(area, 1.5, own);
                self.draw_way(canvas, row, place);
            }
            Kind::Stream => {
                let (zone, end) = stream_zone(&self.document, row, *place);
                fill(self.view.rect(&zone), theme::faded(own, 0.12));
                edge(self.view.rect(&zone), 0.5, theme::faded(own, 0.5));
                fill(area, theme::solid());
                edge(area, 1.5, own);
                let force = DVec2::new(
                    self.document.number(row, "force_x").unwrap_or(0.0),
                    self.document.number(row, "force_y").unwrap_or(0.0),
                );
                let (from, to) = (self.view.point(place.centre()), self.view.point(end));
                if force != DVec2::ZERO {
                    arrow(canvas, (from + to) / 2.0, force.normalize().as_vec2(), own);
                }
            }
            Kind::Fluid | Kind::Gravity => {
                let given = ["r", "g", "b"].map(|channel| self.document.number(row, channel));
                let own = match given {
                    [Some(r), Some(g), Some(b)] if kind == Kind::Fluid => Color::from_rgba(r as u8, g as u8, b as u8, 255),
                    _ => own,
                };
                fill(area, theme::faded(own, 0.3));
                edge(area, 1.0, own);
                if kind == Kind::Gravity {
                    let field = DVec2::new(
                        self.document.number(row, "field_x").unwrap_or(0.0),
                        self.document.number(row, "field_y").unwrap_or(0.0),
                    );
                    if field != DVec2::ZERO {
                        arrow(canvas, area.centre(), field.normalize().as_vec2(), own);
                    }
                }
            }
            Kind::Object | Kind::Key | Kind::Picture => self.draw_object(sheets, canvas, row, area),
            Kind::Ship => {
                canvas.rounded(area, area.size.x * 0.25, theme::faded(own, 0.9));
                let centre = area.centre();
                canvas.disc(centre - Vec2::new(0.0, area.size.y * 0.12), area.size.x * 0.16, theme::ground());
                let angle = self.document.number(row, "angle").unwrap_or(0.0).to_radians();
                arrow(canvas, centre, Vec2::new(angle.sin() as f32, -angle.cos() as f32), theme::accent());
            }
            Kind::Text => {
                let size = crate::view::layout::nearest_size(area.size.y);
                if area.size.y > 5.0 {
                    canvas.text(cell("text"), area.min, Style::new(size, own));
                } else {
                    fill(area, theme::faded(own, 0.5));
                }
            }
            Kind::Switch | Kind::Pad | Kind::KeyPad | Kind::Deadly | Kind::Pod | Kind::Setting => {
                let plate = kind != Kind::Switch || !cell("weight").is_empty();
                fill(area, theme::faded(own, if plate { 0.7 } else { 0.25 }));
                edge(area, 1.0, own);
            }
        }
    }

    fn draw_object(&self, sheets: &mut Sheets, canvas: &Canvas, row: RowId, area: Area) {
        let image = self.document.cell(row, "image").unwrap_or_default();
        let channel = |name: &str| self.document.number(row, name).map(|value| value as u8);
        let own = match (channel("r"), channel("g"), channel("b")) {
            (Some(r), Some(g), Some(b)) => Color::from_rgba(r, g, b, 255),
            _ => colour(Kind::Object),
        };
        let round = image.to_ascii_lowercase().starts_with("ball:")
            || self.document.cell(row, "circular").is_some_and(|cell| cell.eq_ignore_ascii_case("true"));
        if !image.contains(':')
            && let Some(texture) = sheets.get(&self.folder.picture(image))
        {
            return draw_picture(&texture, area);
        }
        if round && (area.size.x - area.size.y).abs() < 0.01 * area.size.x {
            canvas.disc(area.centre(), area.size.x / 2.0, own);
        } else {
            fill(area, own);
            edge(area, 1.0, theme::ground());
        }
    }

    fn draw_one_way(&self, canvas: &Canvas, area: Area, side: &str) {
        let (a, b, c) = (area.min, area.max(), 1.5);
        let (from, to) = match side.to_ascii_lowercase().as_str() {
            "top" => (a, Vec2::new(b.x, a.y)),
            "bottom" => (Vec2::new(a.x, b.y), b),
            "left" => (a, Vec2::new(a.x, b.y)),
            "right" => (Vec2::new(b.x, a.y), b),
            _ => return,
        };
        canvas.line(from, to, 2.0 * c, theme::accent());
    }

    /// The way of a mover: lines between the middles of where it stops.
    fn draw_way(&self, canvas: &Canvas, row: RowId, place: &Place) {
        let half = place.size * 0.5;
        let mut from = place.centre();
        for stop in self.document.way_points(row) {
            let to = stop + half;
            canvas.line(self.view.point(from), self.view.point(to), 1.5, theme::faded(colour(Kind::Mover), 0.9));
            edge(self.view.rect(&Place { min: stop, size: place.size }), 0.75, theme::faded(colour(Kind::Mover), 0.6));
            from = to;
        }
    }

    fn draw_selection(&self, canvas: &Canvas) {
        let visible = self.view.visible();
        for place in self.selection.iter().filter_map(|row| self.document.place(*row)).filter(|place| place.meets(&visible)) {
            edge(self.view.rect(&place).inset(-2.0), 1.5, theme::accent());
        }
        for (handle, point) in self.handles() {
            let at = self.view.point(point);
            match handle {
                Handle::Size(_) => {
                    fill(Area::around(at, Vec2::splat(8.0)), theme::accent());
                    fill(Area::around(at, Vec2::splat(5.0)), theme::ground());
                }
                Handle::Way(_) | Handle::Reach => canvas.disc(at, 6.0, theme::accent()),
                Handle::MoreWay => {
                    canvas.ring(at, 8.0, 1.5, theme::accent());
                    fill(Area::around(at, Vec2::new(9.0, 1.5)), theme::accent());
                    fill(Area::around(at, Vec2::new(1.5, 9.0)), theme::accent());
                }
                Handle::Wire => {
                    canvas.disc(at, 6.0, colour(Kind::Switch));
                    canvas.ring(at, 8.0, 1.5, theme::text());
                }
            }
        }
        match &self.drag {
            Some(Drag::Frame(from, _)) => {
                let to = self.view.pixels(self.pointer);
                let area = self.view.rect(&Place::between(*from, to));
                fill(area, theme::faded(theme::accent(), 0.1));
                edge(area, 0.75, theme::accent());
            }
            Some(Drag::Draw(kind, from)) => {
                let to = self.view.pixels(self.pointer);
                let area = self.view.rect(&Place::between(*from, to));
                fill(area, theme::faded(colour(*kind), 0.5));
                edge(area, 1.0, colour(*kind));
                let size = (to - *from).abs();
                let words = format!("{} × {} px", number(size.x.round()), number(size.y.round()));
                canvas.text(&words, area.max() + Vec2::new(8.0, -8.0), Style::new(DETAILS, theme::text()).mono());
            }
            Some(Drag::Handle { row, handle: Handle::Wire, .. }) => {
                if let Some(place) = self.document.place(*row) {
                    canvas.line(self.view.point(place.centre()), self.pointer, 2.0, colour(Kind::Switch));
                }
            }
            Some(Drag::Pan(_) | Drag::Move { .. } | Drag::Handle { .. }) | None => {}
        }
    }

    /// The level in small, with the part in view.
    fn draw_map(&self, canvas: &Canvas) {
        let (scale, corner) = self.map();
        let size = self.document.size().as_vec2() * scale;
        let paper = Area { min: corner, size };
        fill(paper.inset(-3.0), theme::panel_edge());
        fill(paper, theme::ground());
        let point = |pixels: DVec2| (corner + pixels.as_vec2() * scale).clamp(paper.min, paper.max());
        let between = |place: &Place| {
            let (min, max) = (point(place.min), point(place.max()));
            Area { min, size: (max - min).max(Vec2::ONE) }
        };
        for (row, place) in self.document.things() {
            let Some(kind) = self.document.kind(row).filter(|kind| *kind != Kind::Text) else { continue };
            let area = between(&place);
            let least = if matches!(kind, Kind::Ship | Kind::Pad | Kind::KeyPad | Kind::Key) { 3.0 } else { 1.0 };
            fill(
                Area::around(area.centre(), area.size.max(Vec2::splat(least))),
                if kind == Kind::Solid { theme::solid() } else { colour(kind) },
            );
        }
        edge(between(&self.view.visible()), 0.75, theme::accent());
        canvas.end_layer();
    }

    fn draw_commands(&self, canvas: &Canvas) {
        fill(self.parts.top, theme::panel());
        for (i, (label, key)) in COMMANDS.iter().enumerate() {
            let area = self.commands.areas()[i];
            let on = *label == "Snap" && self.snapping;
            let fill = if self.commands.hover() == Some(i) { theme::panel_hover() } else { theme::ground() };
            widgets::panel_in(canvas, area, fill, if on { theme::accent() } else { theme::panel_edge() });
            let middle = area.centre();
            let can = match *label {
                "Undo" => self.document.history().0 > 0,
                "Redo" => self.document.history().1 > 0,
                "Copy" | "Delete" => !self.selection.is_empty(),
                "Save" => self.is_unsaved(),
                _ => true,
            };
            let colour = if can { theme::text() } else { theme::quiet() };
            canvas.text(label, middle - Vec2::new(0.0, 8.0), Style::new(TEXT, colour).centred().middle());
            canvas.text(key, middle + Vec2::new(0.0, 11.0), Style::new(DETAILS, theme::quiet()).centred().middle().mono());
        }
        let (from, to) = (self.commands.areas()[AT_LEFT - 1].max().x, self.commands.areas()[AT_LEFT].min.x);
        let unsaved = self.is_unsaved();
        let name = if unsaved { format!("{} · not saved", self.name) } else { self.name.clone() };
        let colour = if unsaved { theme::accent() } else { theme::text() };
        let middle = Vec2::new((from + to) / 2.0, self.parts.top.centre().y);
        widgets::fitted(canvas, &name, middle, to - from - 2.0 * INSIDE, &[BUTTON_TEXT, TEXT, DETAILS], colour);
    }

    fn draw_tools(&self, canvas: &Canvas) {
        fill(self.parts.left, theme::panel());
        for (i, area) in self.tools.areas().iter().enumerate() {
            let tool = if i == 0 { Tool::Select } else { Tool::Add(Kind::ADDED[i - 1]) };
            let ground = if self.tools.hover() == Some(i) { theme::panel_hover() } else { theme::ground() };
            widgets::panel_in(canvas, *area, ground, if tool == self.tool { theme::accent() } else { theme::panel_edge() });
            let mark = Area::around(Vec2::new(area.min.x + 16.0, area.centre().y), Vec2::new(14.0, 10.0));
            let (label, colour) = match tool {
                Tool::Select => ("Select", theme::text()),
                Tool::Add(kind) => (kind.name(), colour(kind)),
            };
            if tool == Tool::Select {
                edge(mark, 0.75, colour);
            } else {
                fill(mark, colour);
            }
            let at = Vec2::new(mark.max().x + INSIDE, area.centre().y);
            let style = Style::new(TEXT, theme::text()).middle();
            let style =
                if canvas.width(label, style) > area.max().x - at.x - BETWEEN { Style { size: DETAILS, ..style } } else { style };
            canvas.text(label, at, style);
        }
    }

    fn draw_panel(&self, canvas: &Canvas, time: f64) {
        let area = self.parts.right;
        fill(area, theme::panel());
        let left = area.min.x + INSIDE;
        let widest = area.size.x - 2.0 * INSIDE;
        let (heading, place) = match (&self.selection[..], self.panel.kind) {
            ([], _) => ("The level".to_owned(), "constants.csv".to_owned()),
            ([row], Some(kind)) => {
                let line = self.document.line(*row).unwrap_or_default();
                (kind.name().to_owned(), format!("{}:{line}", row.table.file()))
            }
            (rows, Some(kind)) => (format!("{} × {}", rows.len(), kind.name()), kind.table().file().to_owned()),
            (rows, None) => (format!("{} things", rows.len()), "of several kinds".to_owned()),
        };
        canvas.text(&heading, Vec2::new(left, area.min.y + INSIDE), Style::new(TEXT, theme::text()));
        let small = Style::new(DETAILS, theme::quiet()).mono();
        canvas.text(&place, Vec2::new(area.max().x - INSIDE, area.min.y + INSIDE + 3.0), small.right());
        for (i, field) in self.panel.fields.iter().enumerate() {
            let at = self.parts.field(i);
            let typing = self.panel.typing.as_ref().filter(|typing| typing.name == field.name);
            let bad = self.problem_of(field.name).is_some();
            let label = Style::new(DETAILS, if field.required { theme::text() } else { theme::quiet() }).mono().middle();
            canvas.text(field.name, Vec2::new(left, at.centre().y), label);
            canvas.text(unit(field.name), Vec2::new(at.max().x + 6.0, at.centre().y), small.middle());
            let border = if bad {
                theme::bad()
            } else if typing.is_some() {
                theme::accent()
            } else {
                theme::panel_edge()
            };
            widgets::panel_in(canvas, at, theme::ground(), border);
            let style = Style::new(DETAILS, theme::text()).mono().middle();
            let start = Vec2::new(at.min.x + INSIDE, at.centre().y);
            let room = at.size.x - 2.0 * INSIDE;
            match typing {
                Some(typing) if choices(field.name).is_empty() => {
                    // The caret stays in view: what is before it is cut off at the left.
                    let before: Vec<char> = typing.field.before_caret().chars().collect();
                    let skip = (0..=before.len())
                        .find(|skip| canvas.width(&before[*skip..].iter().collect::<String>(), style) <= room)
                        .unwrap_or(0);
                    let text: String = typing.field.text().chars().skip(skip).collect();
                    let mut shown = String::new();
                    for letter in text.chars() {
                        if canvas.width(&format!("{shown}{letter}"), style) > room {
                            break;
                        }
                        shown.push(letter);
                    }
                    canvas.text(&shown, start, style);
                    if time.fract() < 0.5 {
                        let x = start.x + canvas.width(&before[skip..].iter().collect::<String>(), style);
                        fill(Area::new(x, start.y - 9.0, 1.5, 18.0), theme::accent());
                    }
                }
                _ => {
                    let (text, colour) = match field.text.as_deref() {
                        None => ("…", theme::quiet()),
                        Some("") => (field.usual, theme::quiet()),
                        Some(text) => (text, theme::text()),
                    };
                    let style = Style { colour, ..style };
                    canvas.text(&widgets::cut(canvas, text, room, style), start, style);
                }
            }
        }
        self.draw_messages(canvas, left, widest);
    }

    /// What is wrong with what is selected, below its fields.
    fn draw_messages(&self, canvas: &Canvas, left: f32, widest: f32) {
        let mut y = self.parts.field(self.panel.fields.len()).min.y + BETWEEN;
        let columns = (widest / canvas.width("0", Style::new(DETAILS, theme::text()).mono())) as usize;
        let own = self.problems.iter().filter(|(problem, _)| self.is_about(problem));
        for (problem, refused) in own.take(4) {
            let words = format!("{}: found {}, expected {}", problem.column, problem.found, problem.expected);
            for line in wrapped(&words, columns.max(8)) {
                if y + self.parts.line > self.parts.right.max().y {
                    return;
                }
                let colour = if *refused { theme::bad() } else { theme::accent() };
                canvas.text(&line, Vec2::new(left, y), Style::new(DETAILS, colour).mono());
                y += self.parts.line;
            }
        }
    }

    fn is_about(&self, problem: &crate::level::Problem) -> bool {
        match &self.selection[..] {
            [] => problem.file == "constants.csv",
            rows => rows
                .iter()
                .any(|row| row.table.file() == problem.file && self.document.row_at(row.table, problem.line) == Some(*row)),
        }
    }

    /// The problem with a column of what is selected.
    fn problem_of(&self, column: &str) -> Option<&crate::level::Problem> {
        let named = |problem: &crate::level::Problem| {
            let name = crate::level::document::Table::of_file(&problem.file)
                .filter(|_| self.selection.is_empty())
                .and_then(|table| self.document.row_at(table, problem.line))
                .and_then(|row| self.document.cell(row, "name"));
            name.map_or(problem.column == column, |name| name.eq_ignore_ascii_case(column))
        };
        self.problems.iter().map(|(problem, _)| problem).find(|problem| self.is_about(problem) && named(problem))
    }

    fn draw_problems(&self, canvas: &Canvas) {
        let area = self.parts.bottom;
        fill(area, theme::panel());
        let style = Style::new(DETAILS, theme::text()).mono();
        let at = self.view.pixels(self.pointer);
        let metre = self.document.metre();
        let place = format!(
            "{:.0}, {:.0} px   {:.2}, {:.2} m   {:.0} %",
            at.x,
            at.y,
            at.x / metre,
            at.y / metre,
            self.view.scale() * 100.0
        );
        let head = area.min + Vec2::new(INSIDE, INSIDE / 2.0);
        canvas.text(&place, Vec2::new(area.max().x - INSIDE, head.y), Style::new(DETAILS, theme::quiet()).mono().right());
        let refused = self.problems.iter().filter(|(_, refused)| *refused).count();
        let (words, colour) = match (self.remark(), self.problems.len()) {
            (Some(remark), _) => (remark.to_owned(), theme::accent()),
            (None, 0) => ("No problems.".to_owned(), theme::good()),
            (None, all) if refused == 0 => {
                (format!("{all} {} to look at", if all == 1 { "thing" } else { "things" }), theme::accent())
            }
            (None, _) => (format!("{refused} {}", if refused == 1 { "problem" } else { "problems" }), theme::bad()),
        };
        let room = area.size.x - 4.0 * INSIDE - canvas.width(&place, style);
        canvas.text(&widgets::cut(canvas, &words, room, Style { colour, ..style }), head, Style { colour, ..style });
        for (line, index) in self.scroll.range().enumerate().take(PROBLEM_LINES) {
            let (problem, refused) = &self.problems[index];
            let at = self.parts.problem(line);
            if at.contains(self.pointer) {
                fill(at, theme::panel_hover());
            }
            let style = Style { colour: if *refused { theme::text() } else { theme::quiet() }, ..style };
            canvas.text(&widgets::cut(canvas, &problem.to_string(), at.size.x, style), at.min, style);
        }
        if let Some(bar) = self.scroll.bar() {
            widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
        }
    }
}

fn draw_ask(ask: &Ask, canvas: &Canvas) {
    widgets::curtain(canvas, 0.6);
    widgets::panel(canvas, ask.panel);
    let [first, second] = ask.words();
    let (middle, top) = (ask.panel.centre().x, ask.panel.min.y);
    let widest = ask.panel.size.x - 2.0 * PADDING;
    widgets::fitted(canvas, &first, Vec2::new(middle, top + 36.0), widest, &[BUTTON_TEXT, TEXT, DETAILS], theme::text());
    widgets::fitted(canvas, &second, Vec2::new(middle, top + 80.0), widest, &[TEXT, DETAILS], theme::quiet());
    for (i, (label, area)) in ask.answers().iter().zip(ask.buttons().areas()).enumerate() {
        widgets::button(canvas, *area, label, ask.buttons().hover() == Some(i), ask.buttons().focus() == i);
    }
}

fn draw_picture(texture: &Texture2D, area: Area) {
    let size = macroquad::math::Vec2::new(area.size.x, area.size.y);
    draw_texture_ex(
        texture,
        area.min.x,
        area.min.y,
        WHITE,
        DrawTextureParams { dest_size: Some(size), ..DrawTextureParams::default() },
    );
}

/// A short arrow around a point.
fn arrow(canvas: &Canvas, middle: Vec2, way: Vec2, colour: Color) {
    let (tip, tail) = (middle + way * 16.0, middle - way * 16.0);
    canvas.line(tail, tip - way * 6.0, 2.0, colour);
    let side = Vec2::new(-way.y, way.x) * 5.0;
    canvas.convex(&[tip, tip - way * 9.0 + side, tip - way * 9.0 - side], colour);
}

/// A text in lines of at most so many letters.
fn wrapped(text: &str, columns: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_inclusive(' ') {
        for piece in word.chars().collect::<Vec<_>>().chunks(columns) {
            let piece: String = piece.iter().collect();
            let room = columns.saturating_sub(lines.last().map_or(0, |line| line.chars().count()));
            if piece.trim_end().chars().count() > room {
                lines.push(String::new());
            }
            if let Some(line) = lines.last_mut() {
                line.push_str(&piece);
            }
        }
    }
    lines
}
