//! The canvas: what every drawing goes through. Shapes are macroquad's, in canvas units; text is kept until the shapes of its layer
//! are drawn, because each change between shapes and text costs a draw call.

use super::fonts::{Face, Fonts, font_size, glyph_size, runs};
use super::layout::{Frame, LINE, Vec2};
use super::theme;
use macroquad::camera::{Camera2D, set_camera, set_default_camera};
use macroquad::color::{Color, WHITE};
use macroquad::material::{Material, MaterialParams, gl_use_default_material, gl_use_material, load_material};
use macroquad::miniquad::ShaderSource;
use macroquad::text::{TextParams, draw_text_ex, measure_text};
use macroquad::texture::{DrawTextureParams, FilterMode, Image, Texture2D, draw_texture_ex};
use macroquad::window::{clear_background, screen_dpi_scale, screen_height, screen_width};
use std::cell::RefCell;

/// Where a text lies from the point that it is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Align {
    /// To the right of it.
    #[default]
    Left,
    /// On both sides.
    Centre,
    /// To the left of it.
    Right,
}

/// How a line of text looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// One of [`super::layout::TEXT_SIZES`].
    pub size: f32,
    /// Its colour.
    pub colour: Color,
    /// Its face.
    pub face: Face,
    /// Where it lies from its point.
    pub align: Align,
    /// Whether its point is at the middle of its capitals' height instead of at the top of its line.
    pub middle: bool,
}

impl Style {
    /// Words that begin at their point.
    pub const fn new(size: f32, colour: Color) -> Self {
        Self { size, colour, face: Face::Sans, align: Align::Left, middle: false }
    }

    /// The same in the monospaced face.
    pub const fn mono(self) -> Self {
        Self { face: Face::Mono, ..self }
    }

    /// The same on both sides of its point.
    pub const fn centred(self) -> Self {
        Self { align: Align::Centre, ..self }
    }

    /// The same to the left of its point.
    pub const fn right(self) -> Self {
        Self { align: Align::Right, ..self }
    }

    /// The same with its point at the middle of the capitals' height.
    pub const fn middle(self) -> Self {
        Self { middle: true, ..self }
    }
}

/// From the top of a line to its baseline, in heights of the text (both faces within 1 %).
const ASCENT: f32 = 0.93;
/// Half the height of a capital, in heights of the text.
const HALF_CAPITAL: f32 = 0.355;

struct Line {
    text: String,
    /// Where the baseline begins, logical pixels of the window.
    at: Vec2,
    size: u16,
    face: Face,
    colour: Color,
}

/// The canvas of one window.
pub struct Canvas {
    fonts: Fonts,
    frame: Frame,
    /// Width and height of the whole window, canvas units.
    window: Vec2,
    /// Physical pixels a logical one: macroquad's units.
    dpi: f32,
    lines: RefCell<Vec<Line>>,
    /// The picture that is shown again while nothing changes.
    kept: Option<Texture2D>,
    /// Draws it without its opacity, which is that of what was drawn last; `None` where there can be none.
    copying: Option<Material>,
}

impl Canvas {
    /// A canvas for the window that is open.
    ///
    /// # Errors
    /// A typeface that cannot be read, in words.
    pub fn new() -> Result<Self, String> {
        Ok(Self {
            fonts: Fonts::load()?,
            frame: Frame::default(),
            window: Frame::default().size,
            dpi: 1.0,
            lines: RefCell::new(Vec::new()),
            kept: None,
            copying: copying(),
        })
    }

    /// Lays what follows out on another part of the canvas, from its top left corner; the answer is the one before, to be given back.
    pub const fn use_frame(&mut self, frame: Frame) -> Frame {
        std::mem::replace(&mut self.frame, frame)
    }

    /// Lays the canvas out for the window's present size, with words `text` times as large as usual.
    ///
    /// # Errors
    /// A typeface that cannot be read, in words.
    pub fn begin(&mut self, text: f32) -> Result<(), String> {
        self.dpi = screen_dpi_scale();
        self.frame = Frame::of_window(Vec2::new(screen_width(), screen_height()) * self.dpi).with_text(text);
        self.window = self.frame.size;
        self.fonts.prepare(&self.frame, self.dpi)?;
        self.lines.get_mut().clear();
        self.use_canvas_units();
        Ok(())
    }

    /// Clears the window: what follows is drawn afresh.
    pub fn clear(&self) {
        clear_background(theme::ground());
    }

    /// Draws the text kept so far. What is drawn afterwards lies above it: a panel over a screen, for example.
    pub fn end_layer(&self) {
        set_default_camera();
        for line in self.lines.borrow_mut().drain(..) {
            let params = TextParams {
                font: Some(self.fonts.get(line.face)),
                font_size: line.size,
                color: line.colour,
                ..TextParams::default()
            };
            draw_text_ex(&line.text, line.at.x, line.at.y, params);
        }
        self.use_canvas_units();
    }

    /// Keeps what has been drawn in this frame, to be shown again.
    pub fn keep(&mut self) {
        if self.copying.is_none() {
            return;
        }
        let size = (Vec2::new(screen_width(), screen_height()) * self.dpi).round();
        let kept = self.kept.take().filter(|kept| kept.size() == size).unwrap_or_else(|| {
            let kept = Texture2D::from_image(&Image::gen_image_color(size.x as u16, size.y as u16, theme::ground()));
            kept.set_filter(FilterMode::Nearest);
            kept
        });
        self.end_layer();
        kept.grab_screen();
        self.kept = Some(kept);
        // macroquad does not know that this texture is bound now; to draw it makes that so.
        self.show_kept();
    }

    /// Shows what was kept, in a window of the same size; whether there is such a picture.
    pub fn show_kept(&self) -> bool {
        let Some((kept, copying)) = self.kept.as_ref().zip(self.copying.as_ref()) else { return false };
        let params = DrawTextureParams { dest_size: Some(self.window), flip_y: true, ..DrawTextureParams::default() };
        gl_use_material(copying);
        draw_texture_ex(kept, 0.0, 0.0, WHITE, params);
        gl_use_default_material();
        true
    }

    /// Width and height of the canvas, and its scale.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Width and height of the canvas in canvas units: at least 1280 × 720.
    pub fn size(&self) -> Vec2 {
        self.frame.size
    }

    /// A point of the window (as macroquad reports the mouse) on the canvas.
    pub fn to_canvas(&self, logical: Vec2) -> Vec2 {
        logical * self.dpi * self.frame.pixel
    }

    /// Writes one line of text; `at` is the top of the line (or the middle of its capitals) at its left, middle or right end.
    pub fn text(&self, text: &str, at: Vec2, style: Style) {
        let height = f32::from(glyph_size(self.font_size(style), self.dpi)) * self.frame.pixel;
        let left = match style.align {
            Align::Left => at.x,
            Align::Centre => at.x - self.width(text, style) / 2.0,
            Align::Right => at.x - self.width(text, style),
        };
        let baseline = at.y + height * if style.middle { HALF_CAPITAL } else { ASCENT };
        let mut from = left;
        for (text, face) in runs(text, style.face) {
            let physical = (Vec2::new(from, baseline) / self.frame.pixel).round();
            from += self.run_width(&text, Style { face, ..style });
            let (size, colour) = (self.font_size(style), style.colour);
            self.lines.borrow_mut().push(Line { text, at: physical / self.dpi, size, face, colour });
        }
    }

    /// The width of a line of text in canvas units.
    pub fn width(&self, text: &str, style: Style) -> f32 {
        runs(text, style.face).iter().map(|(run, face)| self.run_width(run, Style { face: *face, ..style })).sum()
    }

    fn run_width(&self, text: &str, style: Style) -> f32 {
        let logical = measure_text(text, Some(self.fonts.get(style.face)), self.font_size(style), 1.0).width;
        logical * self.dpi * self.frame.pixel
    }

    /// From one line to the next in canvas units.
    pub fn line_height(&self, size: f32) -> f32 {
        self.frame.text_height(size) * LINE
    }

    fn font_size(&self, style: Style) -> u16 {
        font_size(&self.frame, self.dpi, style.size)
    }

    fn use_canvas_units(&self) {
        let size = self.window;
        set_camera(&Camera2D { target: size / 2.0, zoom: Vec2::new(2.0, 2.0) / size, ..Camera2D::default() });
    }
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
