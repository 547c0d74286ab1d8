//! The level as the editor draws it. Colours and marks that the editor's panes share.

use super::{Editor, arrange::PictureLayer, handles::stream_zone};
use crate::draw::{Canvas, Colour, Image, Style};
use crate::level::document::{Kind, LinkForm, Place, RowId};
use crate::{draw::layout::Area, draw::layout::Vec2, level::read_picture, physics::DVec2, view::theme};
use std::{collections::BTreeMap, path::PathBuf};

impl Editor {
    pub(super) fn draw_picture(&self, canvas: &Canvas) {
        let level = self.view.rect(&Place { min: DVec2::ZERO, size: self.document.size() });
        canvas.rectangle(self.panes.middle, theme::panel());
        canvas.rectangle(level, theme::ground());
        let background = self.folder.background().and_then(|path| self.picture(path));
        match background {
            Some(image) => canvas.image(&image, level, Colour::WHITE),
            None => self.draw_grid(canvas, level),
        }
        let visible = self.view.visible();
        let mut things: Vec<(RowId, Kind, Place)> = self
            .document
            .things()
            .filter_map(|(row, place)| Some((row, self.document.kind(row)?, place)))
            .filter(|(row, kind, place)| {
                self.arranged.shows_kind(*kind)
                    && (place.meets(&visible)
                        || *kind == Kind::Stream && stream_zone(&self.document, *row, *place).0.meets(&visible))
            })
            .collect();
        // Zones below, solid blocks above them, movers on top.
        let depth = |kind: Kind| match kind {
            Kind::Picture => 0,
            Kind::Fluid | Kind::Gravity => 1,
            Kind::Stream => 2,
            Kind::Solid => 3,
            Kind::Door | Kind::Mover | Kind::Deadly => 4,
            Kind::Setting | Kind::Hint | Kind::Object | Kind::Key | Kind::Ship | Kind::Text => 6,
            _ => 5,
        };
        things.sort_by_key(|(_, kind, _)| depth(*kind));
        for (row, kind, place) in &things {
            self.draw_thing(canvas, *row, *kind, place);
        }
        edge(canvas, level, 1.0, theme::quiet());
        for wire in self.document.wires().into_iter().filter(|_| self.arranged.shows(PictureLayer::Wires)) {
            if let (Some(from), Some(to)) = (self.document.place(wire.switch), self.document.place(wire.thing)) {
                let colour = colour(Kind::Switch).faded(0.8);
                let (a, b) = (self.view.point(from.centre()), self.view.point(to.centre()));
                canvas.line(a, b, if wire.inverted { 1.0 } else { 2.0 }, colour);
                // Open, as in plans of circuits.
                if wire.inverted { canvas.ring(b, 5.0, 2.0, theme::bad()) } else { canvas.disc(b, 3.5, colour) }
            }
        }
    }

    /// The paper of a level without a background: a fine line every metre, a heavy one every ten.
    fn draw_grid(&self, canvas: &Canvas, level: Area) {
        let metre = self.document.metre() * self.view.scale;
        let steps: &[(f64, Colour)] = &[(1.0, theme::grid_fine()), (10.0, theme::grid_heavy())];
        for (metres, colour) in steps.iter().filter(|(metres, _)| metres * metre > 6.0) {
            let step = (metres * metre) as f32;
            let seen = |from: f32, least: f32| ((least - from) / step).ceil().max(0.0) as i32;
            let middle = self.panes.middle;
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

    fn draw_thing(&self, canvas: &Canvas, row: RowId, kind: Kind, place: &Place) {
        let (area, own) = (self.view.rect(place), colour(kind));
        let cell = |column: &str| self.document.cell(row, column).unwrap_or_default();
        match kind {
            Kind::Solid => {
                // Two rectangles instead of one and four lines: a level has thousands of blocks.
                canvas.rectangle(area, own);
                canvas.rectangle(
                    area.inset(canvas.frame().pixel.max(1.0).min(area.size.min_element() * 0.25)),
                    material(cell("material")),
                );
                self.draw_nature(canvas, row, area);
            }
            Kind::Mover | Kind::Door => {
                canvas.rectangle(area, own.faded(if kind == Kind::Door { 0.5 } else { 0.75 }));
                edge(canvas, area, 1.5, own);
                self.draw_nature(canvas, row, area);
                self.draw_path(canvas, row, place);
            }
            Kind::Stream => {
                let (zone, end) = stream_zone(&self.document, row, *place);
                if self.arranged.shows(PictureLayer::Zones) {
                    canvas.rectangle(self.view.rect(&zone), own.faded(0.12));
                    edge(canvas, self.view.rect(&zone), 0.5, own.faded(0.5));
                }
                canvas.rectangle(area, theme::solid());
                edge(canvas, area, 1.5, own);
                let force = DVec2::from(["force_x", "force_y"].map(|column| self.document.number(row, column).unwrap_or(0.0)));
                let (from, to) = (self.view.point(place.centre()), self.view.point(end));
                if force != DVec2::ZERO {
                    arrow(canvas, (from + to) / 2.0, force.normalize().as_vec2(), own);
                }
            }
            Kind::Fluid | Kind::Gravity => {
                let own = self.given_colour(row).unwrap_or(own);
                canvas.rectangle(area, own.faded(0.3));
                edge(canvas, area, 1.0, own);
                if kind == Kind::Gravity {
                    let field = DVec2::from(["field_x", "field_y"].map(|column| self.document.number(row, column).unwrap_or(0.0)));
                    if field != DVec2::ZERO {
                        arrow(canvas, area.centre(), field.normalize().as_vec2(), own);
                    }
                }
            }
            Kind::Link => {
                if let Some([a, b]) = self.document.link_ends(row) {
                    draw_link(canvas, [a, b].map(|end| self.view.point(end)), self.document.link_form(row), own);
                }
                canvas.disc(area.centre(), 4.0, own);
            }
            Kind::Object | Kind::Key => self.draw_object(canvas, (row, area), colour(Kind::Object)),
            Kind::Picture => self.draw_object(canvas, (row, area), theme::solid().faded(0.6)),
            Kind::Ship => {
                canvas.rounded(area, area.size.x * 0.25, own.faded(0.9));
                let centre = area.centre();
                canvas.disc(centre - Vec2::new(0.0, area.size.y * 0.12), area.size.x * 0.16, theme::ground());
                let angle = self.document.number(row, "angle").unwrap_or(0.0).to_radians();
                arrow(canvas, centre, Vec2::new(angle.sin() as f32, -angle.cos() as f32), theme::accent());
            }
            Kind::Text => {
                let size = crate::draw::layout::nearest_size(area.size.y);
                let own = self.given_colour(row).unwrap_or(own);
                if area.size.y > 10.0 {
                    canvas.text(cell("text"), area.min, Style::new(size, own));
                } else {
                    canvas.rectangle(area, own.faded(0.5));
                }
            }
            _ => {
                let own = self.given_colour(row).unwrap_or(own);
                let plate = kind != Kind::Switch || !cell("weight").is_empty();
                canvas.rectangle(area, own.faded(if plate { 0.7 } else { 0.25 }));
                edge(canvas, area, 1.0, own);
            }
        }
    }

    pub(super) fn given_colour(&self, row: RowId) -> Option<Colour> {
        let [r, g, b] = ["r", "g", "b"].map(|name| self.document.number(row, name).map(|value| value as u8));
        Some(Colour::of([r?, g?, b?]))
    }

    fn draw_object(&self, canvas: &Canvas, (row, area): (RowId, Area), plain: Colour) {
        let image = self.document.cell(row, "image").unwrap_or_default();
        let own = self.given_colour(row).unwrap_or(plain);
        let round = image.to_ascii_lowercase().starts_with("ball:")
            || self.document.cell(row, "circular").is_some_and(|cell| cell.eq_ignore_ascii_case("true"));
        if !image.contains(':')
            && let Some(image) = self.picture(self.folder.picture(image))
        {
            return canvas.image(&image, area, Colour::WHITE);
        }
        if round && (area.size.x - area.size.y).abs() < 0.01 * area.size.x {
            canvas.disc(area.centre(), area.size.x / 2.0, own);
        } else {
            canvas.rectangle(area, own);
        }
    }

    fn picture(&self, path: PathBuf) -> Option<Image> {
        let read = |path: &PathBuf| Some(Image::File(read_picture(path).ok()?.into()));
        self.sheets.borrow_mut().entry(path).or_insert_with_key(read).clone()
    }

    fn draw_path(&self, canvas: &Canvas, row: RowId, place: &Place) {
        let half = place.size * 0.5;
        let mut from = place.centre();
        for stop in self.document.way_points(row) {
            let to = stop + half;
            canvas.line(self.view.point(from), self.view.point(to), 1.5, colour(Kind::Mover).faded(0.9));
            edge(canvas, self.view.rect(&Place { min: stop, size: place.size }), 0.75, colour(Kind::Mover).faded(0.6));
            from = to;
        }
    }
}

/// The pictures by path, read when they are first drawn; `None`: the file is no picture.
pub type Sheets = BTreeMap<PathBuf, Option<Image>>;

pub fn colour(kind: Kind) -> Colour {
    let of = |r, g, b| Colour::of([r, g, b]);
    match kind {
        Kind::Setting | Kind::Hint | Kind::Text | Kind::Ship => theme::text(),
        Kind::Solid => theme::solid_top(),
        Kind::Mover => of(120, 150, 190),
        Kind::Door => of(190, 140, 90),
        Kind::Switch => of(110, 200, 220),
        Kind::Object => theme::quiet(),
        Kind::Key | Kind::Star => theme::accent(),
        Kind::Pad => theme::player_objective(),
        Kind::KeyPad => theme::physics_objective(),
        Kind::Link => of(204, 121, 167),
        Kind::Deadly => theme::bad(),
        Kind::Stream => of(150, 170, 200),
        Kind::Fluid => of(70, 130, 190),
        Kind::Gravity => of(150, 110, 210),
        Kind::Pod => theme::good(),
        Kind::Picture => of(140, 140, 140),
    }
}

pub fn material(name: &str) -> Colour {
    let of = |r, g, b| Colour::of([r, g, b]);
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

/// A rectangle's edge, inside it: at least a pixel of the window.
pub fn edge(canvas: &Canvas, area: Area, width: f32, colour: Colour) {
    canvas.rectangle_edge(area, width.max(canvas.frame().pixel), colour);
}

/// An arrow of 32 canvas units around a point, along a unit vector.
pub fn arrow(canvas: &Canvas, middle: Vec2, along: Vec2, colour: Colour) {
    let (tip, tail) = (middle + along * 16.0, middle - along * 16.0);
    canvas.line(tail, tip - along * 6.0, 2.0, colour);
    let side = Vec2::new(-along.y, along.x) * 5.0;
    canvas.convex(&[tip, tip - along * 9.0 + side, tip - along * 9.0 - side], colour);
}

pub(super) fn draw_link(canvas: &Canvas, [from, to]: [Vec2; 2], form: LinkForm, own: Colour) {
    match form {
        LinkForm::Spring => {
            let turns = ((to - from).length() / 7.0).clamp(3.0, 24.0) as usize;
            let across = (to - from).perp().normalize_or_zero() * 4.0;
            let point = |i: usize| {
                let side = if i == 0 || i == turns { 0.0 } else { [1.0, -1.0][i % 2] };
                from + (to - from) * (i as f32 / turns as f32) + across * side
            };
            (0..turns).for_each(|i| canvas.line(point(i), point(i + 1), 1.5, own));
        }
        LinkForm::Magnet => canvas.dashed(&[from, to], &[5.0, 4.0], 2.0, own),
        LinkForm::Rope => canvas.line(from, to, 2.0, own),
        LinkForm::Winch => {
            canvas.line(from, to, 2.0, own);
            canvas.ring(from, 4.0, 2.0, own);
        }
    }
}
