//! The art: every picture of the game is painted by this code at the start, onto one texture, so that whatever is drawn with it goes
//! to the graphics card in one batch. What an author brings along (sprites, a background) is in [`super::pictures`].

mod materials;
mod paint;
mod shapes;
mod ship;

use crate::level::SHIP_PIXELS;
use crate::physics::{Aabb, DVec2, Material};
use crate::view::camera::Viewport;
use macroquad::color::Color;
use macroquad::math::{Rect, Vec2};
use macroquad::texture::{DrawTextureParams, FilterMode, Texture2D, draw_texture_ex};
use materials::TILE_METRES;
use paint::Picture;

/// Width and height of the texture, pixels.
const SHEET: usize = 1024;
/// Pixels round each picture that filtering may reach.
const GUTTER: usize = 2;
/// The ship is painted at this many times the size at which it is usually drawn.
const SHIP_DETAIL: usize = 4;

/// A picture on the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tile {
    /// The ship, nose up.
    Ship,
    /// A disc with a soft edge.
    Disc,
    /// A light that falls off to its rim.
    Glow,
    /// The engine's flame, its root at the top.
    Flame,
    /// Stripes of danger: a pattern that tiles.
    Hatching,
    /// What a surface is made of: a pattern that tiles.
    Material(&'static str),
}

/// The texture and where on it each picture lies.
pub struct Art {
    texture: Texture2D,
    ship: Rect,
    /// The ship at half the size: filtering takes the mean of four pixels and no more, so that a ship drawn small needs it.
    small_ship: Rect,
    disc: Rect,
    glow: Rect,
    flame: Rect,
    hatching: Rect,
    materials: Vec<(&'static str, Rect)>,
}

impl Art {
    /// Paints everything.
    pub fn new() -> Self {
        let mut sheet = Sheet::new();
        let pixels = SHIP_PIXELS as usize * SHIP_DETAIL;
        let materials =
            Material::ALL.iter().map(|material| (material.name, sheet.add(&materials::pattern(material.name), true))).collect();
        let hatching = sheet.add(&shapes::hatching(192), true);
        let large = ship::ship(pixels);
        let (ship, small_ship) = (sheet.add(&large, false), sheet.add(&large.halved(), false));
        let glow = sheet.add(&shapes::glow(128), false);
        let flame = sheet.add(&shapes::flame(64, 128), false);
        let disc = sheet.add(&shapes::disc(24), false);
        let texture = Texture2D::from_rgba8(SHEET as u16, SHEET as u16, sheet.picture.bytes());
        texture.set_filter(FilterMode::Linear);
        Self { texture, ship, small_ship, disc, glow, flame, hatching, materials }
    }

    /// Draws a picture around `centre`, turned clockwise by `rotation` radians. `pixel` is the size of a physical pixel.
    pub fn draw(&self, tile: Tile, centre: Vec2, size: Vec2, rotation: f32, colour: Color) {
        self.quad(self.source(tile, size), centre - size / 2.0, size, rotation, colour);
    }

    /// Fills a box of the level with a pattern that lies fixed in the level: boxes that adjoin show no seam.
    pub fn fill(&self, tile: Tile, bounds: &Aabb, view: &Viewport, colour: Color) {
        let shown = Aabb::new(bounds.min.max(view.visible().min), bounds.max.min(view.visible().max));
        let source = self.source(tile, Vec2::ZERO);
        for piece in pieces(&shown) {
            let offset = (piece.min - (piece.min / TILE_METRES).floor() * TILE_METRES) / TILE_METRES;
            let part = piece.size() / TILE_METRES;
            let target = view.rect(&piece);
            let source = Rect::new(
                source.x + source.w * offset.x as f32,
                source.y + source.h * offset.y as f32,
                source.w * part.x as f32,
                source.h * part.y as f32,
            );
            self.quad(source, target.point(), target.size(), 0.0, colour);
        }
    }

    /// A glow around a box, reaching `reach` beyond each of its sides.
    pub fn halo(&self, around: Rect, reach: f32, colour: Color) {
        let g = self.glow;
        let half = g.w / 2.0;
        // Columns and rows of the picture: its left half, its middle stretched along the box, its right half.
        let columns = [
            (around.x - reach, reach, g.x, half),
            (around.x, around.w, g.x + half, 0.0),
            (around.right(), reach, g.x + half, half),
        ];
        let rows = [
            (around.y - reach, reach, g.y, half),
            (around.y, around.h, g.y + half, 0.0),
            (around.bottom(), reach, g.y + half, half),
        ];
        for (x, w, u, du) in columns {
            for (y, h, v, dv) in rows {
                if w > 0.0 && h > 0.0 {
                    self.quad(Rect::new(u, v, du, dv), Vec2::new(x, y), Vec2::new(w, h), 0.0, colour);
                }
            }
        }
    }

    fn source(&self, tile: Tile, size: Vec2) -> Rect {
        match tile {
            Tile::Ship if size.x * 1.5 > self.small_ship.w => self.ship,
            Tile::Ship => self.small_ship,
            Tile::Disc => self.disc,
            Tile::Glow => self.glow,
            Tile::Flame => self.flame,
            Tile::Hatching => self.hatching,
            Tile::Material(name) => {
                self.materials.iter().find(|(material, _)| *material == name).map_or(self.materials[0].1, |(_, rect)| *rect)
            }
        }
    }

    fn quad(&self, source: Rect, at: Vec2, size: Vec2, rotation: f32, colour: Color) {
        let params = DrawTextureParams { dest_size: Some(size), source: Some(source), rotation, ..DrawTextureParams::default() };
        draw_texture_ex(&self.texture, at.x, at.y, colour, params);
    }
}

impl Default for Art {
    fn default() -> Self {
        Self::new()
    }
}

/// The window's icon: the ship at the three sizes that a desktop asks for.
pub fn icon() -> macroquad::miniquad::conf::Icon {
    fn bytes<const N: usize>(size: usize) -> [u8; N] {
        let picture = ship::ship(2 * size).halved();
        std::array::from_fn(|i| picture.bytes()[i])
    }
    macroquad::miniquad::conf::Icon { small: bytes(16), medium: bytes(32), big: bytes(64) }
}

/// Cuts a box at the lines where a pattern begins anew.
fn pieces(bounds: &Aabb) -> Vec<Aabb> {
    let cuts = |from: f64, to: f64| {
        let first = (from / TILE_METRES).floor() as i64 + 1;
        let inner = (first..).map(|i| i as f64 * TILE_METRES).take_while(move |cut| *cut < to);
        let edges: Vec<f64> = std::iter::once(from).chain(inner).chain(std::iter::once(to)).collect();
        edges
    };
    if bounds.size().min_element() <= 0.0 {
        return Vec::new();
    }
    let (columns, rows) = (cuts(bounds.min.x, bounds.max.x), cuts(bounds.min.y, bounds.max.y));
    let mut pieces = Vec::with_capacity((columns.len() - 1) * (rows.len() - 1));
    for x in columns.windows(2) {
        for y in rows.windows(2) {
            pieces.push(Aabb::new(DVec2::new(x[0], y[0]), DVec2::new(x[1], y[1])));
        }
    }
    pieces
}

/// Pictures laid out in rows on one large one.
struct Sheet {
    picture: Picture,
    next: (usize, usize),
    row_height: usize,
}

impl Sheet {
    fn new() -> Self {
        Self { picture: Picture::new(SHEET, SHEET, [255; 3]), next: (0, 0), row_height: 0 }
    }

    fn add(&mut self, picture: &Picture, tiles: bool) -> Rect {
        let (width, height) = (picture.width() + 2 * GUTTER, picture.height() + 2 * GUTTER);
        if self.next.0 + width > SHEET {
            self.next = (0, self.next.1 + self.row_height);
            self.row_height = 0;
        }
        let (x, y) = (self.next.0 + GUTTER, self.next.1 + GUTTER);
        self.picture.place(picture, x, y, GUTTER, tiles);
        self.next.0 += width;
        self.row_height = self.row_height.max(height);
        Rect::new(x as f32, y as f32, picture.width() as f32, picture.height() as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_cover_the_box_and_none_crosses_a_pattern_line() {
        let bounds = Aabb::new(DVec2::new(-1.5, 3.9), DVec2::new(8.0, 12.5));
        let pieces = pieces(&bounds);
        let area: f64 = pieces.iter().map(|p| p.size().x * p.size().y).sum();
        assert!((area - 9.5 * 8.6).abs() < 1e-9);
        for piece in pieces {
            assert!(bounds.contains(&piece, 1e-12));
            assert_eq!((piece.min / TILE_METRES).floor(), ((piece.max - 1e-9) / TILE_METRES).floor());
        }
    }

    #[test]
    fn the_icon_is_the_ship_and_not_blank() {
        let icon = icon();
        assert!(icon.big.chunks(4).filter(|p| p[3] > 200).count() > 64 * 64 / 3);
        assert!(icon.small.chunks(4).filter(|p| p[3] > 200).count() > 16 * 16 / 3);
    }
}
