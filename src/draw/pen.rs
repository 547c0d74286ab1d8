//! The pen of the window: plays what a canvas has recorded with macroquad. Text is kept until the shapes of its layer are drawn, because
//! each change between shapes and text costs a draw call.

use super::layout::{Frame, Vec2};
use super::shape::{Colour, Image, MOST_QUADS, Quad, Shape};
use super::{canvas::Canvas, glyphs::Glyphs, raster::Soft, text};
use macroquad::camera::{Camera2D, set_camera};
use macroquad::color::{Color, WHITE};
use macroquad::material::{Material, MaterialParams, gl_use_default_material, gl_use_material, load_material};
use macroquad::math::Rect;
use macroquad::miniquad::ShaderSource;
use macroquad::models::{Mesh, Vertex, draw_mesh};
use macroquad::shapes::{draw_line, draw_rectangle, draw_rectangle_lines};
use macroquad::texture::{DrawTextureParams, FilterMode, Image as Pixels, Texture2D, draw_texture_ex};
use macroquad::window::{clear_background, screen_dpi_scale, screen_height, screen_width};
use std::sync::Arc;

pub struct WindowPen {
    glyphs: Glyphs,
    soft: Soft,
    mesh: Mesh,
    /// Of the drawn images; `None`: the file is no picture.
    textures: Vec<(Image, Option<Texture2D>)>,
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
            glyphs: Glyphs::new()?,
            soft: Soft::default(),
            mesh: Mesh { vertices: Vec::new(), indices: Vec::new(), texture: None },
            textures: vec![(Image::Sheet, Some(sheet))],
            kept: None,
            copying: copying(),
        })
    }

    /// Lays a canvas out for the window's present size, with words as large as they are wanted.
    pub fn begin(&mut self, canvas: &mut Canvas, with_words: impl FnOnce(Frame) -> Frame) {
        let dpi = screen_dpi_scale();
        canvas.begin(with_words(Frame::of_window(Vec2::new(screen_width(), screen_height()) * dpi)), dpi, false);
        self.glyphs.begin();
    }

    pub fn play(&mut self, canvas: &Canvas, ground: Colour) {
        clear_background(ground.into());
        use_canvas_units(canvas);
        self.soft.pixel = canvas.frame().pixel;
        let shapes = canvas.shapes();
        for layer in shapes.split(|shape| matches!(shape, Shape::Layer)) {
            layer.iter().for_each(|shape| self.draw(shape, canvas));
            layer.iter().for_each(|shape| self.write(shape, canvas));
            self.glyphs.draw();
        }
        // Images that only this pen holds are no longer drawn.
        drop(shapes);
        self.textures.retain(|(image, _)| match image {
            Image::Sheet => true,
            Image::File(bytes) => Arc::strong_count(bytes) > 1,
            Image::Painted(painting) => Arc::strong_count(painting) > 1,
        });
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
            Shape::Quads(quads) => {
                quads.0.chunks(MOST_QUADS).for_each(|quads| self.draw_quads(quads.iter().map(|quad| (quad, &[Vec2::ZERO; 4]))));
            }
            Shape::Textured { image, quads } => {
                self.mesh.texture = self.texture(image).cloned();
                quads.chunks(MOST_QUADS).for_each(|quads| self.draw_quads(quads.iter().map(|(quad, places)| (quad, places))));
                self.mesh.texture = None;
            }
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
        self.mesh.vertices.extend(self.soft.vertices.iter().map(|(at, colour)| vertex(*at, Vec2::ZERO, *colour)));
        self.mesh.indices.clone_from(&self.soft.indices);
        draw_mesh(&self.mesh);
    }

    /// With their places in the mesh's texture.
    fn draw_quads<'a>(&mut self, quads: impl Iterator<Item = (&'a Quad, &'a [Vec2; 4])>) {
        self.mesh.vertices.clear();
        self.mesh.indices.clear();
        for (quad, places) in quads {
            let first = self.mesh.vertices.len() as u16;
            self.mesh.vertices.extend((0..4).map(|i| vertex(quad.corners[i], places[i], quad.colours[i])));
            self.mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|i| first + i));
        }
        draw_mesh(&self.mesh);
    }

    fn write(&mut self, shape: &Shape, canvas: &Canvas) {
        let Shape::Text { text, at, style } = shape else { return };
        let (height, pixel) = (canvas.glyph_height(style.size), canvas.frame().pixel);
        let mut from = canvas.baseline(text, *at, *style);
        for (run, face) in text::runs(text, style.face) {
            self.glyphs.write((run, face), height as u16, (from / pixel).round(), (pixel, style.colour.into()));
            from.x += text::run_width(run, face, height) * pixel;
        }
    }

    fn texture(&mut self, image: &Image) -> Option<&Texture2D> {
        let is_same = |known: &Image| match (known, image) {
            (Image::File(a), Image::File(b)) => Arc::ptr_eq(a, b),
            (Image::Painted(a), Image::Painted(b)) => Arc::ptr_eq(a, b),
            _ => matches!((known, image), (Image::Sheet, Image::Sheet)),
        };
        let index = self.textures.iter().position(|(known, _)| is_same(known)).unwrap_or_else(|| {
            let texture = match image {
                Image::Sheet => None,
                Image::File(file) => Pixels::from_file_with_format(file, None).ok().map(|pixels| Texture2D::from_image(&pixels)),
                Image::Painted(painting) => {
                    Some(Texture2D::from_rgba8(painting.width as u16, painting.height() as u16, &painting.bytes))
                }
            };
            texture.iter().for_each(|texture| texture.set_filter(FilterMode::Linear));
            self.textures.push((image.clone(), texture));
            self.textures.len() - 1
        });
        self.textures[index].1.as_ref()
    }

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

fn vertex(at: Vec2, place: Vec2, colour: Colour) -> Vertex {
    Vertex::new(at.x, at.y, 0.0, place.x, place.y, colour.into())
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
