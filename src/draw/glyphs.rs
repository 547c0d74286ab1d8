//! The glyphs of the words on the screen. They lie on square atlases; a glyph is put there when it is first written and stays where it is, so
//! that nothing is copied, and the memory depends on what is written alone.

use super::shape::MOST_QUADS;
use super::text::{self, Typeface};
use glam::Vec2;
use macroquad::color::Color;
use macroquad::models::{Mesh, Vertex, draw_mesh};
use macroquad::texture::{FilterMode, Image, Texture2D};
use std::collections::HashMap;

/// The side of a page, pixels; a taller or wider glyph has one of its own.
const SIDE: u16 = 1024;
/// Between glyphs, pixels.
const GAP: u16 = 1;
/// Pages that are kept for windows of other sizes, some 4 MB each.
const MOST_PAGES: usize = 8;

pub struct Glyphs {
    faces: [fontdue::Font; 2],
    /// By sign, face and height in physical pixels.
    known: HashMap<(char, Typeface, u16), Glyph>,
    atlases: Vec<Atlas>,
}

#[derive(Clone, Copy)]
struct Glyph {
    page: usize,
    /// On the page, pixels.
    at: Vec2,
    size: Vec2,
    /// From the pen's place on the baseline to the top left corner, pixels, y down.
    from: Vec2,
}

struct Atlas {
    room: Room,
    /// What is to be drawn from this page, and the page.
    mesh: Mesh,
}

impl Glyphs {
    /// Fails on a typeface that cannot be read.
    pub fn new() -> Result<Self, String> {
        Ok(Self { faces: [face(Typeface::Sans)?, face(Typeface::Mono)?], known: HashMap::new(), atlases: Vec::new() })
    }

    pub fn begin(&mut self) {
        if self.atlases.len() > MOST_PAGES {
            self.known.clear();
            self.atlases.clear();
        }
    }

    /// Writes a run of one face, `height` physical pixels high, from a point on its baseline (physical pixels; `pixel` canvas units each).
    pub fn write(&mut self, (run, face): (&str, Typeface), height: u16, mut at: Vec2, (pixel, colour): (f32, Color)) {
        for sign in run.chars() {
            let glyph = *self
                .known
                .entry((sign, face, height))
                .or_insert_with(|| make(&self.faces[face as usize], sign, height, &mut self.atlases));
            if let Some(page) = self.atlases.get_mut(glyph.page) {
                page.add(&glyph, at, (pixel, colour));
            }
            at.x += text::run_width(sign.encode_utf8(&mut [0; 4]), face, f32::from(height));
        }
    }

    pub fn draw(&mut self) {
        self.atlases.iter_mut().for_each(Atlas::draw);
    }
}

/// Draws a glyph on the last page with room for it, or on a new one.
fn make(face: &fontdue::Font, sign: char, height: u16, atlases: &mut Vec<Atlas>) -> Glyph {
    let (metrics, coverage) = face.rasterize(sign, f32::from(height));
    let [wide, high] = [metrics.width, metrics.height].map(|side| side.min(usize::from(u16::MAX)) as u16);
    let place = atlases.iter_mut().enumerate().find_map(|(index, page)| Some((index, page.room.place(wide, high)?)));
    let (page, [x, y]) = place.unwrap_or_else(|| {
        atlases.push(Atlas::new(SIDE.max(wide.saturating_add(GAP)).max(high.saturating_add(GAP))));
        let index = atlases.len() - 1;
        (index, atlases[index].room.place(wide, high).unwrap_or_default())
    });
    if wide > 0 && high > 0 {
        let bytes = coverage.iter().flat_map(|coverage| [255, 255, 255, *coverage]).collect();
        let image = Image { bytes, width: wide, height: high };
        let texture = atlases[page].mesh.texture.as_ref();
        texture.into_iter().for_each(|texture| texture.update_part(&image, x.into(), y.into(), wide.into(), high.into()));
    }
    let size = Vec2::new(wide.into(), high.into());
    let from = Vec2::new(metrics.xmin as f32, -(metrics.ymin as f32) - size.y);
    Glyph { page, at: Vec2::new(x.into(), y.into()), size, from }
}

impl Atlas {
    fn new(side: u16) -> Self {
        let texture = Texture2D::from_rgba8(side, side, &vec![0; 4 * usize::from(side) * usize::from(side)]);
        // Glyphs are drawn at the size at which they were made: the nearest sample keeps them sharp between pixels.
        texture.set_filter(FilterMode::Nearest);
        Self { room: Room::new(side), mesh: Mesh { vertices: Vec::new(), indices: Vec::new(), texture: Some(texture) } }
    }

    fn add(&mut self, glyph: &Glyph, at: Vec2, (pixel, colour): (f32, Color)) {
        if glyph.size.min_element() == 0.0 {
            return;
        }
        let first = self.mesh.vertices.len() as u16;
        let side = f32::from(self.room.side);
        // Between two pixels the nearest sample would leave out a glyph's last column.
        let from = (at + glyph.from).round();
        self.mesh.vertices.extend([Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y].map(|corner| {
            let (to, of) = ((from + corner * glyph.size) * pixel, (glyph.at + corner * glyph.size) / side);
            Vertex::new(to.x, to.y, 0.0, of.x, of.y, colour)
        }));
        self.mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|i| first + i));
        if self.mesh.indices.len() >= 6 * MOST_QUADS {
            self.draw();
        }
    }

    fn draw(&mut self) {
        if !self.mesh.indices.is_empty() {
            draw_mesh(&self.mesh);
            self.mesh.vertices.clear();
            self.mesh.indices.clear();
        }
    }
}

/// The room of a page: rows of glyphs of about one height.
struct Room {
    side: u16,
    /// The top, the height and the taken width of each, from the top down.
    rows: Vec<[u16; 3]>,
}

impl Room {
    const fn new(side: u16) -> Self {
        Self { side, rows: Vec::new() }
    }

    /// The top left corner of free room of that size; `None` where none is left.
    fn place(&mut self, wide: u16, high: u16) -> Option<[u16; 2]> {
        let [wide, high] = [wide, high].map(|side| side.saturating_add(GAP));
        let side = self.side;
        let fits = |[_, height, taken]: &&mut [u16; 3]| {
            high <= *height && *height <= high.saturating_add(high / 2) && wide <= side - *taken
        };
        if let Some([top, _, taken]) = self.rows.iter_mut().find(fits) {
            *taken += wide;
            return Some([*taken - wide, *top]);
        }
        let top = self.rows.last().map_or(0, |[top, height, _]| top + height);
        if high > side - top || wide > side {
            return None;
        }
        self.rows.push([top, high, wide]);
        Some([0, top])
    }
}

fn face(face: Typeface) -> Result<fontdue::Font, String> {
    let (name, bytes) = face.file();
    fontdue::Font::from_bytes(bytes, fontdue::FontSettings::default())
        .map_err(|error| format!("the typeface {name} cannot be read: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn glyphs_have_room_of_their_own_until_a_page_is_full() {
        let mut room = Room::new(64);
        let sizes = [(10, 12), (3, 1), (8, 13), (20, 30), (10, 9), (0, 0), (63, 12), (12, 12), (30, 30)];
        let mut placed: Vec<[u16; 4]> = Vec::new();
        for (wide, high) in sizes.into_iter().cycle().take(40) {
            let Some([x, y]) = room.place(wide, high) else { continue };
            assert!(x + wide < 64 && y + high < 64, "{x} {y} {wide} {high}");
            for [left, top, w, h] in &placed {
                assert!(x >= left + w + GAP || *left >= x + wide + GAP || y >= top + h + GAP || *top >= y + high + GAP);
            }
            placed.push([x, y, wide, high]);
        }
        assert!(placed.len() > sizes.len() - 2, "{}", placed.len());
        assert_eq!((room.place(64, 1), room.place(1, 64), room.place(30, 30)), (None, None, None));
        assert_eq!(room.place(u16::MAX, u16::MAX), None);
    }
}
