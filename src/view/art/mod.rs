//! The game paints its own pictures onto one sheet, so that they go to the graphics card in one batch; beside it the pictures of a level's author.
//! The ship, a lander nose up, stays in the circle that touches its 1.7 m box from inside: the box does not turn with it, and nothing may leave it.

mod paint;
pub mod rock;

use super::camera::Viewport;
use crate::draw::layout::{Area, Vec2};
use crate::draw::{Canvas, Colour, Image, Painting, Quads};
use crate::level::{Level, SHIP_PIXELS};
use crate::physics::{Aabb, DVec2, Material};
use paint::TILE_METRES;
use std::path::{Path, PathBuf};
use std::{collections::BTreeMap, sync::LazyLock};

/// Width and height of the sheet, pixels.
pub const SHEET: usize = 1024;
/// Pixels round each picture that filtering may read.
const GUTTER: usize = 2;
/// Width and height of the ship, pixels: four times the size at which it is usually drawn.
const SHIP: usize = 4 * SHIP_PIXELS as usize;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tile {
    Ship,
    /// The ship at half the size: filtering takes the mean of four pixels and no more, so that a ship drawn small needs it.
    SmallShip,
    Disc,
    /// A light that falls off to its rim.
    Glow,
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
            Self::Material(_) => (paint::SIZE, paint::SIZE),
        }
    }

    /// The ship, which takes longest, is painted once and handed in.
    fn paint(self, ship: &Painting) -> Painting {
        let (width, height) = self.size();
        match self {
            Self::Ship => ship.clone(),
            Self::SmallShip => ship.halved(),
            Self::Disc => radial(width, |r| (1.0 - r).clamp(0.0, 0.25) * 4.0),
            Self::Glow => radial(width, |r| (1.0 - r * r).max(0.0).powi(3)),
            Self::Flame => flame(width, height),
            Self::Hatching => hatching(width),
            Self::Material(name) => paint::pattern(name),
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

/// Painted at each call.
pub fn sheet() -> Painting {
    let mut sheet = Painting::new(SHEET, SHEET, [255; 3]);
    let ship = ship(SHIP);
    for (tile, area) in PLACES.iter() {
        let tiles = matches!(tile, Tile::Hatching | Tile::Material(_));
        sheet.place(&tile.paint(&ship), (area.min.x as usize, area.min.y as usize), GUTTER, tiles);
    }
    sheet
}

/// The place of a picture on the sheet. A material without a picture looks like the first.
pub(super) fn place(tile: Tile) -> Area {
    let found = PLACES.iter().find(|(known, _)| *known == tile).unwrap_or(&PLACES[0]).1;
    Area { min: found.min / SHEET as f32, size: found.size / SHEET as f32 }
}

/// Draws a picture over an area, turned clockwise around its middle by `turn` radians, its colours multiplied by `tint`.
pub fn draw(canvas: &Canvas, tile: Tile, area: Area, turn: f32, tint: Colour) {
    let small = tile == Tile::Ship && area.size.x * 1.5 <= (SHIP / 2) as f32;
    canvas.picture(&Image::Sheet, place(if small { Tile::SmallShip } else { tile }), area, (turn, tint));
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

/// A glow around a box, which reaches `reach` beyond each of its sides and falls to nothing there without a slope.
pub fn halo(canvas: &Canvas, around: Area, reach: f32, tint: Colour) {
    const BANDS: u32 = 4;
    const STEPS: u32 = 3;
    let (middles, quarter) = (around.corners(), std::f32::consts::FRAC_PI_2);
    let outline: Vec<(Vec2, Vec2)> = (0..4_u8)
        .flat_map(|corner| {
            let from = quarter * (f32::from(corner) + 2.0);
            (0..=STEPS).map(move |step| (middles[corner as usize], Vec2::from_angle(from + quarter * step as f32 / STEPS as f32)))
        })
        .collect();
    let light = |band: u32| {
        let out = band as f32 / BANDS as f32;
        (out * reach, tint.faded((1.0 - out * out).powi(3)))
    };
    let mut quads = Quads::default();
    for (i, a) in outline.iter().enumerate() {
        let b = outline[(i + 1) % outline.len()];
        for band in 0..BANDS {
            let ((near, bright), (far, dim)) = (light(band), light(band + 1));
            quads.quad([a.0 + a.1 * near, b.0 + b.1 * near, b.0 + b.1 * far, a.0 + a.1 * far], [bright, bright, dim, dim]);
        }
    }
    canvas.quads(quads);
}

/// The ship as a picture of `side` pixels a side, RGBA: for the window's icon.
pub fn icon(side: usize) -> Vec<u8> {
    ship(2 * side).halved().bytes
}

#[derive(Default)]
pub struct Pictures(BTreeMap<PathBuf, Image>);

impl Pictures {
    /// A picture that `read` cannot read is left out: the loader has checked all, and a file that vanished since is no reason to stop the game.
    pub fn new(level: &Level, read: &dyn Fn(&Path) -> Option<Vec<u8>>) -> Self {
        let paths = level.pictures().chain(&level.background);
        Self(paths.filter_map(|path| Some((path.clone(), Image::File(read(path)?.into())))).collect())
    }

    pub fn get(&self, path: &Path) -> Option<&Image> {
        self.0.get(path)
    }
}

/// Cuts a box at the lines where a pattern begins again.
fn pieces(bounds: &Aabb) -> Vec<Aabb> {
    let cuts = |from: f64, to: f64| {
        let inner = ((from / TILE_METRES).floor() as i64 + 1..).map(|i| i as f64 * TILE_METRES).take_while(move |cut| *cut < to);
        std::iter::once(from).chain(inner).chain([to]).collect::<Vec<f64>>()
    };
    if bounds.size().min_element() <= 0.0 {
        return Vec::new();
    }
    let (columns, rows) = (cuts(bounds.min.x, bounds.max.x), cuts(bounds.min.y, bounds.max.y));
    let row = |x: &[f64]| rows.windows(2).map(|y| Aabb::new(DVec2::new(x[0], y[0]), DVec2::new(x[1], y[1]))).collect::<Vec<_>>();
    columns.windows(2).flat_map(row).collect()
}

const SHELL: [u8; 3] = [0xF4, 0xF6, 0xFA];
const SHELL_SHADE: [u8; 3] = [0xB4, 0xBF, 0xD0];
const BELLY: [u8; 3] = [0x5A, 0x68, 0x80];
const BELLY_SHADE: [u8; 3] = [0x3C, 0x48, 0x5C];
const TRIM: [u8; 3] = [0xFF, 0x9F, 0x1C];
const OUTLINE: [u8; 3] = [0x1B, 0x22, 0x30];
const GLASS: [u8; 3] = [0x2B, 0x6C, 0xB8];
const GLINT: [u8; 3] = [0xBF, 0xE3, 0xFF];

/// Width of the dark line round the hull.
const RIM: f32 = 0.04;
/// Where the shell ends and the belly begins.
const WAIST: f32 = 0.30;

/// `size` is width and height, pixels.
pub fn ship(size: usize) -> Painting {
    let mut p = Painting::new(size, size, OUTLINE);
    // Fins: they give the tail its width and tell it from the nose.
    p.fill(|x, y| fin(x.abs(), y, 0.0), |_, _| OUTLINE);
    p.fill(|x, y| fin(x.abs(), y, RIM), |x, _| if x > 0.0 { [0xE0, 0x86, 0x10] } else { TRIM });
    p.fill(|x, y| nozzle(x, y, 0.0), |_, _| OUTLINE);
    p.fill(|x, y| nozzle(x, y, RIM), |x, _| mix([0x8A, 0x97, 0xAD], BELLY_SHADE, x * 2.0 + 0.5));
    // The hull: belly below the waist, shell above, a trim band between, an orange tip on the nose.
    p.fill(|x, y| hull(x, y, 0.0), |_, _| OUTLINE);
    p.fill(|x, y| hull(x, y, RIM) && y > WAIST, |x, _| mix(BELLY, BELLY_SHADE, x * 0.8 + 0.4));
    p.fill(|x, y| hull(x, y, RIM) && y <= WAIST, |x, _| mix(SHELL, SHELL_SHADE, x * 1.1 - 0.05));
    p.fill(|x, y| hull(x, y, RIM) && (WAIST - 0.06..WAIST + 0.08).contains(&y), |_, _| TRIM);
    p.fill(|x, y| hull(x, y, RIM) && y < -0.62, |x, _| mix(TRIM, [0xD9, 0x7A, 0x08], x * 2.0 + 0.3));
    // The window.
    p.fill(|x, y| round(x, y + 0.17, 0.315), |_, _| OUTLINE);
    p.fill(|x, y| round(x, y + 0.17, 0.26), |x, y| mix(GLASS, [0x14, 0x33, 0x66], (x + y + 0.17) * 1.6 + 0.5));
    p.fill(|x, y| round(x + 0.09, y + 0.27, 0.075), |_, _| GLINT);
    p
}

fn round(x: f32, y: f32, radius: f32) -> bool {
    x * x + y * y < radius * radius
}

/// An egg with its narrow end up, from the tip of the nose to above the nozzle.
fn hull(x: f32, y: f32, inset: f32) -> bool {
    let (height, power, blunt) = if y < 0.16 { (1.13 - inset * 1.6, 2.2, 0.64) } else { (0.66 - inset, 2.6, 0.5) };
    let along = (y - 0.16).abs() / height;
    along < 1.0 && x.abs() < (0.76 - inset) * (1.0 - along.powf(power)).powf(blunt)
}

fn nozzle(x: f32, y: f32, inset: f32) -> bool {
    (0.70..0.955 - inset).contains(&y) && x.abs() < 0.15 + (y - 0.70) * 0.2 - inset
}

/// The right fin, a swept quadrilateral.
fn fin(x: f32, y: f32, inset: f32) -> bool {
    let corners = [(0.50, -0.06), (0.89, 0.36), (0.72, 0.64), (0.30, 0.74)];
    (0..4).all(|i| {
        let ((ax, ay), (bx, by)) = (corners[i], corners[(i + 1) % 4]);
        let (dx, dy) = (bx - ax, by - ay);
        (dx * (y - ay) - dy * (x - ax)) / dx.hypot(dy) > inset
    })
}

fn mix(a: [u8; 3], b: [u8; 3], t: f32) -> [u8; 3] {
    let t = t.clamp(0.0, 1.0);
    std::array::from_fn(|i| (f32::from(a[i]) * (1.0 - t) + f32::from(b[i]) * t).round() as u8)
}

/// White; maps the distance from the middle (1 at the rim) to alpha.
fn radial(size: usize, alpha: impl Fn(f32) -> f32) -> Painting {
    Painting::of(size, size, |x, y| {
        let from = |p: usize| (p as f32 + 0.5) / size as f32 * 2.0 - 1.0;
        [255, 255, 255, (alpha(from(x).hypot(from(y))) * 255.0).round() as u8]
    })
}

/// The engine's flame, its root at the top: white hot in the middle, orange at the rim, gone at the end.
pub fn flame(width: usize, height: usize) -> Painting {
    Painting::of(width, height, |x, y| {
        let (u, v) = ((x as f32 + 0.5) / width as f32 * 2.0 - 1.0, (y as f32 + 0.5) / height as f32);
        let half = 0.55 * (1.0 - v).powf(0.7) * (0.75 + 1.6 * v * (1.0 - v));
        let inside = 1.0 - u.abs() / half.max(1e-3);
        let alpha = (inside * 2.5).clamp(0.0, 1.0) * (1.0 - v).powf(0.6);
        let hot = (inside * 1.5 - v * 0.9).clamp(0.0, 1.0);
        [255, (150.0 + 100.0 * hot) as u8, (28.0 + 200.0 * hot * hot) as u8, (alpha * 255.0) as u8]
    })
}

pub fn hatching(size: usize) -> Painting {
    Painting::of(size, size, |x, y| {
        let period = size / 8;
        let across = (x + y) % period;
        // The stripe's two edges are blended over a pixel.
        let edge = (across.min(period / 2).min(period - across) as f32).min(1.0);
        let inside = if across < period / 2 { 0.5 + 0.5 * edge } else { 0.5 - 0.5 * edge };
        let mix = |dark: f32, bright: f32| (dark + (bright - dark) * inside) as u8;
        [mix(70.0, 226.0), mix(16.0, 60.0), mix(26.0, 68.0), 255]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::DVec2;

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
        let ship = ship(SHIP);
        for (i, (tile, area)) in PLACES.iter().enumerate() {
            assert!(area.min.min_element() > 0.0 && area.max().max_element() < SHEET as f32, "{tile:?}: {area:?}");
            assert!(PLACES[..i].iter().all(|(_, other)| area.gap(other) >= 2.0 * GUTTER as f32), "{tile:?}: {area:?}");
            let picture = tile.paint(&ship);
            assert_eq!((picture.width, picture.height()), tile.size(), "{tile:?}");
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

    /// How far the picture reaches along both axes when it is turned, in halves of its box: to the far corners of every pixel that shows
    /// anything, and half a pixel more, over which filtering spreads it.
    fn reaches(picture: &Painting, degrees: f32) -> [f32; 4] {
        let size = picture.width;
        let (sin, cos) = degrees.to_radians().sin_cos();
        let mut reaches = [0.0_f32; 4];
        for y in 0..size {
            for x in (0..size).filter(|&x| picture.at(x, y)[3] > 0) {
                for (dx, dy) in [(-0.5, -0.5), (1.5, -0.5), (-0.5, 1.5), (1.5, 1.5)] {
                    let place = |pixel: usize, by: f32| (pixel as f32 + by) / size as f32 * 2.0 - 1.0;
                    let (u, v) = (place(x, dx), place(y, dy));
                    let (across, down) = (u * cos - v * sin, u * sin + v * cos);
                    for (reach, far) in reaches.iter_mut().zip([-across, across, -down, down]) {
                        *reach = reach.max(far);
                    }
                }
            }
        }
        reaches
    }

    #[test]
    fn nothing_drawn_of_the_ship_leaves_its_box_at_any_angle_and_it_fills_it_well() {
        let pixels = super::SHIP;
        for picture in [ship(pixels), ship(pixels).halved()] {
            for degrees in (0..360).step_by(5) {
                for reach in reaches(&picture, degrees as f32) {
                    assert!((0.75..=1.0).contains(&reach), "at {degrees}° it reaches {reach} of half its box");
                }
            }
        }
    }

    #[test]
    fn what_red_kills_is_what_is_drawn_within_half_a_pixel() {
        use crate::level::{SHIP_BODY, SHIP_HALF, SHIP_PIXELS};
        const HALF_A_PIXEL: f64 = 0.5;
        let picture = ship(super::SHIP);
        let size = picture.width;
        // Pixels of the box that is 51 of them wide, from its centre.
        let pixels = |i: usize| ((i as f64 + 0.5) / size as f64 - 0.5) * SHIP_PIXELS;
        let drawn: Vec<DVec2> = (0..size * size)
            .filter(|i| picture.at(i % size, i / size)[3] > 127)
            .map(|i| DVec2::new(pixels(i % size), pixels(i / size)))
            .collect();
        let body = SHIP_BODY.map(|corner| corner / SHIP_HALF.x * (SHIP_PIXELS / 2.0));
        for (i, from) in body.iter().enumerate() {
            let to = body[(i + 1) % body.len()];
            let outward = (*from - to).perp().normalize();
            let reach = drawn.iter().map(|pixel| outward.dot(*pixel)).fold(f64::NEG_INFINITY, f64::max);
            let off = reach - outward.dot(*from);
            assert!(off.abs() <= HALF_A_PIXEL, "side {i}: the picture reaches {off} pixels beyond it");
            let turn = (to - *from).perp_dot(body[(i + 2) % body.len()] - to);
            assert!(turn > 0.0, "corner {i} is not convex");
            let nearest = drawn.iter().map(|pixel| pixel.distance(*from)).fold(f64::INFINITY, f64::min);
            assert!(nearest <= HALF_A_PIXEL, "corner {i}: the picture is {nearest} pixels away");
            assert!(from.length() <= SHIP_PIXELS / 2.0, "corner {i} leaves the box when it turns");
        }
    }

    #[test]
    fn the_nose_differs_from_the_tail_and_left_mirrors_right() {
        let picture = ship(102);
        for y in 0..102 {
            for x in 0..51 {
                assert_eq!(picture.at(x, y)[3], picture.at(101 - x, y)[3]);
            }
        }
        let wide = |y: usize| (0..102).filter(|&x| picture.at(x, y)[3] > 127).count();
        assert!(wide(8) + 20 < wide(80), "nose {} px, tail {} px", wide(8), wide(80));
    }
}
