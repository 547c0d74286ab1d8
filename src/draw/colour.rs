//! Colours.

/// What the lightness of a colour (CIE L*, 0 … 100) becomes on white: words and lines dark, grounds light, each in its order.
const ON_WHITE: [(f32, f32); 8] =
    [(0.0, 98.0), (12.0, 93.0), (30.0, 70.0), (40.0, 58.0), (60.0, 48.0), (88.0, 28.0), (94.0, 8.0), (100.0, 0.0)];

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

    /// For a projector and for paper: light becomes dark and dark light, and the hue stays.
    pub fn on_white(self) -> Self {
        let linear =
            [self.r, self.g, self.b].map(|part| if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) });
        let luminance = (0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]).max(1e-6);
        let lightness = if luminance > 216.0 / 24389.0 { 116.0 * luminance.cbrt() - 16.0 } else { luminance * 24389.0 / 27.0 };
        let above = ON_WHITE.iter().position(|(from, _)| lightness <= *from).unwrap_or(ON_WHITE.len() - 1).max(1);
        let [(from, low), (to, high)] = [ON_WHITE[above - 1], ON_WHITE[above]];
        let wanted = (low + (high - low) * (lightness - from) / (to - from)).clamp(0.0, 100.0);
        let wanted = if wanted > 8.0 { ((wanted + 16.0) / 116.0).powi(3) } else { wanted * 27.0 / 24389.0 };
        // A ground that becomes much lighter keeps less of its tint.
        let tint = (luminance / wanted).sqrt().min(1.0);
        let [r, g, b] = linear.map(|part| {
            let part = (wanted * (1.0 + tint * (part / luminance - 1.0))).clamp(0.0, 1.0);
            if part <= 0.003_130_8 { 12.92 * part } else { 1.055 * part.powf(1.0 / 2.4) - 0.055 }
        });
        Self { r, g, b, a: self.a }
    }

    /// Opaque, `share` (0 … 1) of the difference to another colour.
    pub fn mixed(self, other: Self, share: f32) -> Self {
        let mix = |from: f32, to: f32| from + (to - from) * share;
        Self::new(mix(self.r, other.r), mix(self.g, other.g), mix(self.b, other.b), 1.0)
    }
}
