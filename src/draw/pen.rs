//! The pen of the window: plays what a canvas has recorded with macroquad. Text is kept until the shapes of its layer are drawn, because
//! each change between shapes and text costs a draw call.

use super::canvas::Canvas;
use super::colour::Colour;
use super::layout::{Frame, TEXT_SIZES, TITLE, Vec2};
use super::quads::Quad;
use super::shape::{Image, Shape};
use super::soft::Soft;
use super::text::{self, Typeface};
use macroquad::camera::{Camera2D, set_camera, set_default_camera};
use macroquad::color::{Color, WHITE};
use macroquad::material::{Material, MaterialParams, gl_use_default_material, gl_use_material, load_material};
use macroquad::math::Rect;
use macroquad::miniquad::ShaderSource;
use macroquad::models::{Mesh, Vertex, draw_mesh};
use macroquad::shapes::{draw_line, draw_rectangle, draw_rectangle_lines};
use macroquad::text::{Font, TextParams, draw_text_ex, load_ttf_font_from_bytes};
use macroquad::texture::{DrawTextureParams, FilterMode, Image as Pixels, Texture2D, draw_texture_ex};
use macroquad::window::{clear_background, screen_dpi_scale, screen_height, screen_width};
use std::cmp::Reverse;
use std::sync::Arc;

/// The signs beyond printable ASCII that the game writes.
const SIGNS: &str = "′½₀₁₂₃₄√ωλτ−×·÷°±≈≤≥∞→←↑↓‹›–—…µμρπΔ‘’“”„«»£ßäöüÄÖÜàâæçèéêëîïôùûœÀÂÇÈÉÊÎÔŒ⁰¹²³⁴⁵⁶⁷⁸⁹⁻";
/// All that is written in the size of the title: by the menu, and by the digits of π.
const TITLE_SIGNS: &str = "0123456789Resultant";
/// The side of a fresh atlas (pixels), the largest that is asked for at once, and the room around a glyph there.
const ATLAS: f32 = 512.0;
const LARGEST_ATLAS: f32 = 4096.0;
const AROUND_GLYPH: f32 = 4.0;
/// A glyph's row in an atlas, and the thickness of a dash, in heights of the text.
const ROW: f32 = 1.1;
const DASH: f32 = 0.1;
/// The most quadrangles of one draw call: the library keeps room for 5000 indices.
const MOST_QUADS: usize = 800;

pub struct WindowPen {
    fonts: Fonts,
    /// Those of the size before: two screens may set their words in two sizes by turns.
    fonts_before: Option<Fonts>,
    soft: Soft,
    mesh: Mesh,
    sheet: Texture2D,
    /// The drawn files with their textures; `None`: the file is no picture.
    files: Vec<(Arc<[u8]>, Option<Texture2D>)>,
    /// The picture that is shown again while nothing changes.
    kept: Option<Texture2D>,
    /// Draws the kept picture without its opacity, which is that of the last shape; `None` where no material is available.
    copying: Option<Material>,
}

impl WindowPen {
    /// The sheet is square, its bytes RGBA. Fails on a typeface that cannot be read.
    pub fn new(sheet: &[u8]) -> Result<Self, String> {
        let side = (sheet.len() / 4).isqrt() as u16;
        let sheet = Texture2D::from_rgba8(side, side, sheet);
        sheet.set_filter(FilterMode::Linear);
        Ok(Self {
            fonts: Fonts::load(TEXT_SIZES.map(|size| size as u16))?,
            fonts_before: None,
            soft: Soft::default(),
            mesh: Mesh { vertices: Vec::new(), indices: Vec::new(), texture: None },
            sheet,
            files: Vec::new(),
            kept: None,
            copying: copying(),
        })
    }

    /// Lays a canvas out for the window's present size, with words `text` times as large as usual. Fails on a typeface that cannot
    /// be read.
    pub fn begin(&mut self, canvas: &mut Canvas, text: f32) -> Result<(), String> {
        let dpi = screen_dpi_scale();
        canvas.begin(Frame::of_window(Vec2::new(screen_width(), screen_height()) * dpi).with_text(text), dpi);
        let sizes = TEXT_SIZES.map(|size| canvas.glyph_height(size) as u16);
        if self.fonts.sizes != sizes {
            let before = self.fonts_before.take().filter(|fonts| fonts.sizes == sizes);
            let fonts = before.map_or_else(|| Fonts::load(sizes), Ok)?;
            self.fonts_before = Some(std::mem::replace(&mut self.fonts, fonts));
        }
        Ok(())
    }

    pub fn play(&mut self, canvas: &Canvas, ground: Colour) {
        clear_background(ground.into());
        use_canvas_units(canvas);
        self.soft.begin(canvas.frame().pixel);
        let shapes = canvas.shapes();
        for layer in shapes.split(|shape| matches!(shape, Shape::Layer)) {
            layer.iter().for_each(|shape| self.draw(shape, canvas));
            let mut words = layer.iter().filter(|shape| matches!(shape, Shape::Text { .. })).peekable();
            if words.peek().is_some() {
                set_default_camera();
                words.for_each(|shape| self.write(shape, canvas));
                use_canvas_units(canvas);
            }
        }
        // Files that only this pen holds are no longer drawn.
        drop(shapes);
        self.files.retain(|(bytes, _)| Arc::strong_count(bytes) > 1);
    }

    fn draw(&mut self, shape: &Shape, canvas: &Canvas) {
        match shape {
            Shape::Fill { outline, colour } => {
                self.soft.fill(outline, *colour);
                self.draw_soft();
            }
            Shape::Edge { outline, width, colour } => {
                self.soft.edge(outline, *width, *colour);
                self.draw_soft();
            }
            Shape::Hairline { from, to, colour } => {
                let pixel = canvas.frame().pixel;
                let [from, to] = [from, to].map(|point| ((*point / pixel).floor() + 0.5) * pixel);
                draw_line(from.x, from.y, to.x, to.y, pixel, (*colour).into());
            }
            Shape::Rectangle { area, colour } => {
                draw_rectangle(area.min.x, area.min.y, area.size.x, area.size.y, (*colour).into());
            }
            Shape::RectangleEdge { area, width, colour } => {
                draw_rectangle_lines(area.min.x, area.min.y, area.size.x, area.size.y, 2.0 * width, (*colour).into());
            }
            Shape::Quads(quads) => quads.0.chunks(MOST_QUADS).for_each(|quads| self.draw_quads(quads)),
            Shape::Picture { image, part, area, turn, tint } => {
                if let Some(texture) = self.texture(image) {
                    let (at, size) = (part.min * texture.size(), part.size * texture.size());
                    let source = Some(Rect::new(at.x, at.y, size.x, size.y));
                    let params =
                        DrawTextureParams { dest_size: Some(area.size), source, rotation: *turn, ..DrawTextureParams::default() };
                    draw_texture_ex(texture, area.min.x, area.min.y, (*tint).into(), params);
                }
            }
            Shape::Text { .. } | Shape::Layer => {}
        }
    }

    fn draw_soft(&mut self) {
        self.mesh.vertices.clear();
        self.mesh.vertices.extend(self.soft.vertices.iter().map(vertex));
        self.mesh.indices.clone_from(&self.soft.indices);
        draw_mesh(&self.mesh);
    }

    fn draw_quads(&mut self, quads: &[Quad]) {
        self.mesh.vertices.clear();
        self.mesh.indices.clear();
        for quad in quads {
            let first = self.mesh.vertices.len() as u16;
            self.mesh.vertices.extend(quad.corners.into_iter().zip(quad.colours).map(|corner| vertex(&corner)));
            self.mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|i| first + i));
        }
        draw_mesh(&self.mesh);
    }

    fn write(&self, shape: &Shape, canvas: &Canvas) {
        let Shape::Text { text, at, style } = shape else { return };
        let (size, height, pixel) = (canvas.font_size(style.size), canvas.glyph_height(style.size), canvas.frame().pixel);
        let mut from = canvas.baseline(text, *at, *style);
        for (run, face) in text::runs(text, style.face) {
            let at = (from / pixel).round() / canvas.dpi();
            from.x += text::run_width(run, face, height) * pixel;
            let font = Some(self.fonts.get(face));
            let params = TextParams { font, font_size: size, color: style.colour.into(), ..TextParams::default() };
            draw_text_ex(run, at.x, at.y, params);
        }
    }

    fn texture(&mut self, image: &Image) -> Option<&Texture2D> {
        let Image::File(file) = image else { return Some(&self.sheet) };
        let known = self.files.iter().position(|(bytes, _)| Arc::ptr_eq(bytes, file));
        let index = known.unwrap_or_else(|| {
            let texture = Pixels::from_file_with_format(file, None).ok().map(|pixels| Texture2D::from_image(&pixels));
            texture.iter().for_each(|texture| texture.set_filter(FilterMode::Linear));
            self.files.push((file.clone(), texture));
            self.files.len() - 1
        });
        self.files[index].1.as_ref()
    }

    /// Keeps this frame's picture for later frames.
    pub fn keep(&mut self, canvas: &Canvas) {
        if self.copying.is_none() {
            return;
        }
        let size = (Vec2::new(screen_width(), screen_height()) * canvas.dpi()).round();
        let kept = self.kept.take().filter(|kept| kept.size() == size).unwrap_or_else(|| {
            let kept = Texture2D::from_image(&Pixels::gen_image_color(size.x as u16, size.y as u16, WHITE));
            kept.set_filter(FilterMode::Nearest);
            kept
        });
        // Flushes the batch, so that all of it is in the picture.
        use_canvas_units(canvas);
        kept.grab_screen();
        self.kept = Some(kept);
        // macroquad does not know that this texture is bound now; to draw it makes that so.
        self.show_kept(canvas);
    }

    /// Shows the kept picture in a window of the same size; `false` where none is kept.
    pub fn show_kept(&self, canvas: &Canvas) -> bool {
        let Some((kept, copying)) = self.kept.as_ref().zip(self.copying.as_ref()) else { return false };
        let params = DrawTextureParams { dest_size: Some(canvas.window()), flip_y: true, ..DrawTextureParams::default() };
        use_canvas_units(canvas);
        gl_use_material(copying);
        draw_texture_ex(kept, 0.0, 0.0, WHITE, params);
        gl_use_default_material();
        true
    }
}

fn use_canvas_units(canvas: &Canvas) {
    let size = canvas.window();
    set_camera(&Camera2D { target: size / 2.0, zoom: Vec2::new(2.0, 2.0) / size, ..Camera2D::default() });
}

fn vertex((at, colour): &(Vec2, Colour)) -> Vertex {
    Vertex::new(at.x, at.y, 0.0, 0.0, 0.0, (*colour).into())
}

/// Copies a texture's colours as they are.
fn copying() -> Option<Material> {
    const VERTEX: &str = "#version 100
        attribute vec3 position;
        attribute vec2 texcoord;
        varying highp vec2 at;
        uniform mat4 Model;
        uniform mat4 Projection;
        void main() {
            gl_Position = Projection * Model * vec4(position, 1.0);
            at = texcoord;
        }";
    const FRAGMENT: &str = "#version 100
        precision mediump float;
        varying highp vec2 at;
        uniform sampler2D Texture;
        void main() { gl_FragColor = vec4(texture2D(Texture, at).rgb, 1.0); }";
    load_material(ShaderSource::Glsl { vertex: VERTEX, fragment: FRAGMENT }, MaterialParams::default()).ok()
}

impl From<Colour> for Color {
    fn from(colour: Colour) -> Self {
        Self::new(colour.r, colour.g, colour.b, colour.a)
    }
}

/// The faces with the glyphs that have been made ready. Glyphs are made ready between frames: an atlas that grows while a frame is being
/// drawn leaves black boxes behind. The glyphs of a window's size have an atlas of their own.
struct Fonts {
    sans: Font,
    mono: Font,
    /// Heights of glyphs, physical pixels, in the order of [`TEXT_SIZES`].
    sizes: [u16; TEXT_SIZES.len()],
}

impl Fonts {
    fn load(sizes: [u16; TEXT_SIZES.len()]) -> Result<Self, String> {
        let mut fonts = Self { sans: font(Typeface::Sans)?, mono: font(Typeface::Mono)?, sizes };
        let all: String = (' '..='~').chain(SIGNS.chars()).collect();
        // The tallest glyphs first: a row of an atlas is as high as its tallest glyph.
        let mut lines: Vec<(&str, u16)> =
            TEXT_SIZES.iter().zip(sizes).map(|(size, height)| (if *size == TITLE { TITLE_SIGNS } else { &all }, height)).collect();
        lines.sort_unstable_by_key(|(_, height)| Reverse(*height));
        for (font, face) in [(&mut fonts.sans, Typeface::Sans), (&mut fonts.mono, Typeface::Mono)] {
            grow(font, face, atlas_side(&lines, face));
            for (signs, height) in &lines {
                font.populate_font_cache(&signs.chars().collect::<Vec<_>>(), *height);
            }
        }
        Ok(fonts)
    }

    const fn get(&self, face: Typeface) -> &Font {
        match face {
            Typeface::Sans => &self.sans,
            Typeface::Mono => &self.mono,
        }
    }
}

/// The side of an atlas (a power of two, pixels) with room for lines of signs of some heights, and for a tenth more.
fn atlas_side(lines: &[(&str, u16)], face: Typeface) -> f32 {
    let height = |side: f32| -> f32 {
        let rows = lines.iter().map(|(signs, height)| {
            let height = f32::from(*height);
            let length = text::run_width(signs, face, height) + AROUND_GLYPH * signs.chars().count() as f32;
            ((length / side).ceil() + 1.0) * (ROW * height + AROUND_GLYPH)
        });
        rows.sum::<f32>() + DASH * side
    };
    let mut side = ATLAS;
    while side < LARGEST_ATLAS && height(side) > 0.9 * side {
        side *= 2.0;
    }
    side
}

/// Lets an empty atlas grow to its side at once, by a dash of that length. An atlas that grows later is copied glyph by glyph in any
/// order, wastes the most of its rows, and grows again: to 4096 or 8192 pixels a side.
fn grow(font: &mut Font, face: Typeface, side: f32) {
    if side > ATLAS {
        let dash = 0.8 * side / text::run_width("—", face, 1.0);
        font.populate_font_cache(&['—'], dash as u16);
    }
}

fn font(face: Typeface) -> Result<Font, String> {
    let (name, bytes) = face.file();
    let mut font = load_ttf_font_from_bytes(bytes).map_err(|error| format!("the typeface {name} cannot be read: {error}"))?;
    // Glyphs are drawn at the size at which they were made: the nearest sample keeps them sharp between pixels.
    font.set_filter(FilterMode::Nearest);
    Ok(font)
}
