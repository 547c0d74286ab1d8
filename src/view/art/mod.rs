//! The art: the game paints its own pictures onto one sheet, so that they go to the graphics card in one batch. The pictures of a
//! level's author (sprites, a background) are in [`super::pictures`].

mod materials;
mod paint;
mod shapes;
mod ship;

use crate::draw::layout::Area;
use crate::draw::{Canvas, Colour, Image};
use crate::level::SHIP_PIXELS;
use crate::physics::{Aabb, DVec2, Material};
use crate::view::camera::Viewport;
use materials::TILE_METRES;
use paint::Pixels;
use std::sync::LazyLock;

/// Width and height of the sheet, pixels.
const SHEET: usize = 1024;
/// Pixels round each picture that filtering may read.
const GUTTER: usize = 2;
/// Width and height of the ship, pixels: four times the size at which it is usually drawn.
const SHIP: usize = 4 * SHIP_PIXELS as usize;

/// A picture on the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tile {
    /// The ship, nose up.
    Ship,
    /// The ship at half the size: filtering takes the mean of four pixels and no more, so that a ship drawn small needs it.
    SmallShip,
    /// A disc with a soft edge.
    Disc,
    /// A light that falls off to its rim.
    Glow,
    /// The engine's flame, its root at the top.
    Flame,
    /// Stripes of danger: a pattern that tiles.
    Hatching,
    /// The material of that name: a pattern that tiles.
    Material(&'static str),
}

impl Tile {
    const fn size(self) -> (usize, usize) {
        match self {
            Self::Ship => (SHIP, SHIP),
            Self::SmallShip => (SHIP / 2, SHIP / 2),
            Self::Disc => (24, 24),
            Self::Glow => (128, 128),
            Self::Flame => (64, 128),
            Self::Hatching => (192, 192),
            Self::Material(_) => (materials::SIZE, materials::SIZE),
        }
    }

    /// The ship, which takes longest, is painted once and handed in.
    fn paint(self, ship: &Pixels) -> Pixels {
        let (width, height) = self.size();
        match self {
            Self::Ship => ship.clone(),
            Self::SmallShip => ship.halved(),
            Self::Disc => shapes::disc(width),
            Self::Glow => shapes::glow(width),
            Self::Flame => shapes::flame(width, height),
            Self::Hatching => shapes::hatching(width),
            Self::Material(name) => materials::pattern(name),
        }
    }
}

/// The place of each picture on the sheet, pixels: in rows from the top.
static PLACES: LazyLock<Vec<(Tile, Area)>> = LazyLock::new(|| {
    let others = [Tile::Hatching, Tile::Ship, Tile::SmallShip, Tile::Glow, Tile::Flame, Tile::Disc];
    let (mut next, mut row) = ((0, 0), 0);
    let place = |tile: Tile| {
        let (width, height) = tile.size();
        if next.0 + width + 2 * GUTTER > SHEET {
            next = (0, next.1 + row);
            row = 0;
        }
        let at = [next.0 + GUTTER, next.1 + GUTTER, width, height].map(|pixels| pixels as f32);
        next.0 += width + 2 * GUTTER;
        row = row.max(height + 2 * GUTTER);
        (tile, Area::new(at[0], at[1], at[2], at[3]))
    };
    Material::ALL.iter().map(|material| Tile::Material(material.name)).chain(others).map(place).collect()
});

/// RGBA, painted at each call.
pub fn sheet() -> Vec<u8> {
    let mut sheet = Pixels::new(SHEET, SHEET, [255; 3]);
    let ship = ship::ship(SHIP);
    for (tile, area) in PLACES.iter() {
        let tiles = matches!(tile, Tile::Hatching | Tile::Material(_));
        sheet.place(&tile.paint(&ship), (area.min.x as usize, area.min.y as usize), GUTTER, tiles);
    }
    sheet.into_bytes()
}

/// The place of a picture on the sheet. A material without a picture looks like the first.
fn place(tile: Tile) -> Area {
    let found = PLACES.iter().find(|(known, _)| *known == tile).unwrap_or(&PLACES[0]).1;
    Area { min: found.min / SHEET as f32, size: found.size / SHEET as f32 }
}

/// Draws a picture over an area, turned clockwise around its middle by `turn` radians, its colours multiplied by `tint`.
pub fn draw(canvas: &Canvas, tile: Tile, area: Area, turn: f32, tint: Colour) {
    let small = tile == Tile::Ship && area.size.x * 1.5 <= (SHIP / 2) as f32;
    let part = place(if small { Tile::SmallShip } else { tile });
    canvas.picture(&Image::Sheet, part, area, (turn, tint));
}

/// Fills a box of the level with a pattern that lies fixed in the level: boxes that adjoin show no seam.
pub fn fill(canvas: &Canvas, tile: Tile, bounds: &Aabb, view: &Viewport, tint: Colour) {
    let shown = Aabb::new(bounds.min.max(view.visible().min), bounds.max.min(view.visible().max));
    let all = place(tile);
    for piece in pieces(&shown) {
        let offset = (piece.min - (piece.min / TILE_METRES).floor() * TILE_METRES) / TILE_METRES;
        let size = piece.size() / TILE_METRES;
        let part = Area { min: all.min + all.size * offset.as_vec2(), size: all.size * size.as_vec2() };
        canvas.picture(&Image::Sheet, part, view.rect(&piece), (0.0, tint));
    }
}

/// A glow around a box, reaching `reach` beyond each of its sides.
pub fn halo(canvas: &Canvas, around: Area, reach: f32, tint: Colour) {
    let glow = place(Tile::Glow);
    // Along each axis: the picture's first half, its middle stretched along the box, its second half.
    let stretches = |axis: usize| {
        let (middle, half) = (glow.centre()[axis], glow.size[axis] / 2.0);
        [
            (around.min[axis] - reach, reach, glow.min[axis], half),
            (around.min[axis], around.size[axis], middle, 0.0),
            (around.max()[axis], reach, middle, half),
        ]
    };
    for (x, w, u, du) in stretches(0) {
        for (y, h, v, dv) in stretches(1) {
            if w > 0.0 && h > 0.0 {
                canvas.picture(&Image::Sheet, Area::new(u, v, du, dv), Area::new(x, y, w, h), (0.0, tint));
            }
        }
    }
}

/// The ship as a picture of `side` pixels a side, RGBA: for the window's icon.
pub fn icon(side: usize) -> Vec<u8> {
    ship::ship(2 * side).halved().into_bytes()
}

/// Cuts a box at the lines where a pattern begins again.
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
    fn every_picture_has_its_own_place_on_the_sheet() {
        let ship = ship::ship(SHIP);
        for (i, (tile, area)) in PLACES.iter().enumerate() {
            assert!(area.min.min_element() > 0.0 && area.max().max_element() < SHEET as f32, "{tile:?}: {area:?}");
            assert!(PLACES[..i].iter().all(|(_, other)| area.gap(other) >= 2.0 * GUTTER as f32), "{tile:?}: {area:?}");
            assert_eq!(tile.paint(&ship).size(), tile.size(), "{tile:?}");
        }
    }

    #[test]
    fn the_icon_is_the_ship_and_not_blank() {
        for side in [16, 64] {
            assert!(icon(side).chunks(4).filter(|p| p[3] > 200).count() > side * side / 3);
        }
    }

    /// `UPDATE_DOCS=1 cargo test --lib icon` draws the file.
    #[test]
    fn the_icon_for_desktops_is_the_same_ship() {
        const SIDE: u32 = 256;
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/platform/linux/resultant.png");
        let drawn = icon(SIDE as usize);
        if std::env::var_os("UPDATE_DOCS").is_some() {
            let mut encoder = png::Encoder::new(std::fs::File::create(path).unwrap(), SIDE, SIDE);
            encoder.set_color(png::ColorType::Rgba);
            encoder.write_header().unwrap().write_image_data(&drawn).unwrap();
        }
        let mut picture = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(path).unwrap())).read_info().unwrap();
        let mut kept = vec![0; picture.output_buffer_size().unwrap()];
        picture.next_frame(&mut kept).unwrap();
        assert!(kept == drawn, "platform/linux/resultant.png is stale");
    }
}
