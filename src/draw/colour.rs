//! Colours.

/// A colour in straight (not premultiplied) sRGB, each part 0 … 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Colour {
    pub r: f32,
    pub g: f32,
    pub b: f32,
    /// Opacity.
    pub a: f32,
}

impl Colour {
    /// A picture that is drawn with it keeps its colours.
    pub const WHITE: Self = Self::new(1.0, 1.0, 1.0, 1.0);

    /// Each part 0 … 1.
    pub const fn new(r: f32, g: f32, b: f32, a: f32) -> Self {
        Self { r, g, b, a }
    }

    /// Opaque; each part 0 … 255.
    pub const fn of([r, g, b]: [u8; 3]) -> Self {
        Self::new(r as f32 / 255.0, g as f32 / 255.0, b as f32 / 255.0, 1.0)
    }

    /// Opaque, from 0xRRGGBB.
    pub const fn hex(hex: u32) -> Self {
        Self::of([(hex >> 16) as u8, (hex >> 8) as u8, hex as u8])
    }

    /// `alpha` (0 … 1) multiplies the opacity.
    pub const fn faded(self, alpha: f32) -> Self {
        Self::new(self.r, self.g, self.b, self.a * alpha)
    }

    /// Opaque, `share` (0 … 1) of the difference to another colour.
    pub fn mixed(self, other: Self, share: f32) -> Self {
        let mix = |from: f32, to: f32| from + (to - from) * share;
        Self::new(mix(self.r, other.r), mix(self.g, other.g), mix(self.b, other.b), 1.0)
    }
}
