//! The sky of a world of levels: a sky with its glows, three layers that move with the camera, small lights, and weather. All of it
//! is drawn by code, in canvas units, in the air alone; plain palettes leave it out.

use super::{camera::Viewport, terrain::chance, theme};
use crate::draw::layout::{Area, Vec2};
use crate::draw::{Canvas, Colour, Quads};
use crate::{level::Landscape, physics::DVec2};
use backdrop::Backdrop;

mod backdrop;
mod scenes;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldPalette {
    /// The tones of the sky, each at its share of the way down.
    pub sky: &'static [(f32, Colour)],
    /// The tops of the far, the middle and the near layer.
    pub layers: [Colour; 3],
    /// Hatching, dimension lines and edges of rock.
    pub ink: Colour,
    /// Rock at its edge, and deep inside.
    pub rock: [Colour; 2],
    /// The light on edges that face it.
    pub rim: Colour,
    /// The unit vector towards that light, y down.
    pub light: DVec2,
}

const fn tone(share: f32, hex: u32) -> (f32, Colour) {
    (share, Colour::hex(hex))
}

impl WorldPalette {
    pub const fn of(landscape: Landscape) -> Self {
        match landscape {
            Landscape::Launch => Self {
                sky: const {
                    &[tone(0.0, 0x040817), tone(0.35, 0x0A1536), tone(0.72, 0x1B2F62), tone(0.92, 0x33457C), tone(1.0, 0x4A4F7E)]
                },
                layers: [Colour::hex(0x16244F), Colour::hex(0x15224E), Colour::hex(0x0E1838)],
                ink: Colour::hex(0x9DB4E0),
                rock: [Colour::hex(0x435480), Colour::hex(0x090D1C)],
                rim: Colour::hex(0xFFE3B0),
                light: DVec2::NEG_Y,
            },
            Landscape::Quarry => Self {
                sky: const {
                    &[tone(0.0, 0x170D2B), tone(0.30, 0x35173B), tone(0.58, 0x62283F), tone(0.82, 0x803A3A), tone(1.0, 0x944838)]
                },
                layers: [Colour::hex(0x7A3A3C), Colour::hex(0x54242E), Colour::hex(0x2E131E)],
                ink: Colour::hex(0xE0B98A),
                rock: [Colour::hex(0x7A4A2E), Colour::hex(0x12090A)],
                rim: Colour::hex(0xFFB45E),
                light: DVec2::new(-0.8, -0.6),
            },
            Landscape::Wind => Self {
                sky: const {
                    &[tone(0.0, 0x041A24), tone(0.35, 0x0C3A4A), tone(0.66, 0x215864), tone(0.86, 0x56735F), tone(1.0, 0x857A4C)]
                },
                layers: [Colour::hex(0x5E6B50), Colour::hex(0x46524A), Colour::hex(0x16343A)],
                ink: Colour::hex(0xD2BC7C),
                rock: [Colour::hex(0x5E5136), Colour::hex(0x0D0B08)],
                rim: Colour::hex(0xFFDF8A),
                light: DVec2::new(0.6, -0.8),
            },
            Landscape::Water => Self {
                sky: const {
                    &[tone(0.0, 0x2C6A50), tone(0.14, 0x184A38), tone(0.36, 0x0E382A), tone(0.62, 0x0A3828), tone(1.0, 0x042018)]
                },
                layers: [Colour::hex(0x20664A), Colour::hex(0x144C36), Colour::hex(0x176142)],
                ink: Colour::hex(0x86C9AB),
                rock: [Colour::hex(0x2F5E4C), Colour::hex(0x04100E)],
                rim: Colour::hex(0xC8FFE6),
                light: DVec2::NEG_Y,
            },
            Landscape::Orbit => Self {
                sky: const { &[tone(0.0, 0x010208), tone(0.5, 0x04060F), tone(1.0, 0x070B18)] },
                layers: [Colour::hex(0x2B3A6E), Colour::hex(0x3A3566), Colour::hex(0x24406A)],
                ink: Colour::hex(0xB3B9CC),
                rock: [Colour::hex(0x57524C), Colour::hex(0x0D0C0B)],
                rim: Colour::hex(0xA9D6FF),
                light: DVec2::new(-0.6, 0.8),
            },
        }
    }

    /// The two worlds between which a `share` of the level's height, from its top, lies, and how far it is from the first to the second.
    pub fn storeys(share: f64) -> (Self, Self, f32) {
        const ALL: [Landscape; 5] = [Landscape::Orbit, Landscape::Launch, Landscape::Wind, Landscape::Quarry, Landscape::Water];
        let at = (share * ALL.len() as f64 - 0.5).clamp(0.0, ALL.len() as f64 - 1.0);
        let above = (at as usize).min(ALL.len() - 2);
        let t = (at - above as f64) as f32;
        (Self::of(ALL[above]), Self::of(ALL[above + 1]), t * t * (3.0 - 2.0 * t))
    }

    /// The sky at a share (0 … 1) of the way down, without its glows.
    pub fn sky_at(&self, share: f32) -> Colour {
        let next = self.sky.iter().position(|(at, _)| *at > share).unwrap_or(self.sky.len() - 1).max(1);
        let ((from, above), (to, below)) = (self.sky[next - 1], self.sky[next]);
        above.mixed(below, ((share - from) / (to - from)).clamp(0.0, 1.0))
    }
}

/// Shares of the camera's motion that the layers take part in.
const PARALLAX: [f32; 3] = [0.06, 0.15, 0.30];
/// The tone of a storey's air, as a share of the way down its world's sky.
const STOREY_TONE: f32 = 0.5;
/// The light of lamps on masts and over pads.
pub const LAMP: Colour = Colour::hex(0xFFE6BC);

/// In the `air`, canvas units; its ground lies about the level's `floor`, m. Where worlds lie in `storeys`, the air has their colours.
pub fn draw(
    (landscape, storeys): (Landscape, bool),
    (air, floor): (&[Area], f64),
    (view, canvas): (&Viewport, &Canvas),
    time: f64,
) {
    if theme::is_plain() {
        return;
    }
    let origin = view.point(DVec2::ZERO);
    // The camera's place with the floor in view, as far as the level's edges allow.
    let (seen, level) = (view.visible(), view.level().max.y);
    let half = (seen.size().y * 0.5).min(level * 0.5);
    let usual = floor.clamp(half, level - half);
    let climb = view.length(seen.centre().y - usual);
    let mut sky = Backdrop {
        size: view.size(),
        palette: WorldPalette::of(landscape),
        time: time as f32,
        shift: PARALLAX.map(|share| -origin * share),
        floor: view.size().y * 0.5 + view.length(floor - usual),
        climb,
        air,
        canvas,
        quads: Quads::default(),
        sprites: Vec::new(),
    };
    match landscape {
        Landscape::Launch => sky.launch_site(),
        Landscape::Quarry => sky.quarry(),
        Landscape::Wind => sky.wind_works(),
        Landscape::Water => sky.deep_water(),
        Landscape::Orbit => sky.orbit(),
    }
    if storeys {
        // Space fades into the air of the worlds below it.
        let colour = |at: Vec2| {
            let (above, below, t) = WorldPalette::storeys(f64::from(at.y - origin.y) / f64::from(view.length(level)));
            let opaque = if above == WorldPalette::of(Landscape::Orbit) { t } else { 1.0 };
            above.sky_at(STOREY_TONE).mixed(below.sky_at(STOREY_TONE), t).faded(opaque)
        };
        sky.sky(|at, _| colour(at));
    }
    sky.flush();
}

/// A light that falls to nothing at its rim, without a slope there; `out` is 1 at the rim.
fn glow(out: f32) -> f32 {
    (1.0 - out * out).max(0.0).powi(3)
}

/// A cone of light that fades across and along, with its reach and half its angle (rad); `way` is a unit vector.
pub fn beam(from: Vec2, way: Vec2, (reach, half): (f32, f32), colour: Colour) -> Quads {
    const RAYS: i32 = 6;
    const STEPS: i32 = 4;
    let at = |ray: i32, step: i32| {
        let (across, along) = (ray as f32 / RAYS as f32 * 2.0 - 1.0, step as f32 / STEPS as f32);
        let strength = (1.0 - across * across).powf(1.6) * (1.0 - along * along).powf(1.5);
        (from + Vec2::from_angle(across * half).rotate(way) * reach * along, colour.faded(strength))
    };
    let mut quads = Quads::default();
    for ray in 0..RAYS {
        for step in 0..STEPS {
            let corners = [at(ray, step), at(ray + 1, step), at(ray + 1, step + 1), at(ray, step + 1)];
            quads.quad(corners.map(|corner| corner.0), corners.map(|corner| corner.1));
        }
    }
    quads
}

/// A number from 0 to 1 by two whole numbers, the same on every run.
fn random(i: i64, salt: i64) -> f32 {
    chance(i.wrapping_mul(31) + salt, DVec2::X * salt as f64) as f32
}

/// A smooth line of −1 … 1.
fn rolling(x: f32, salt: i64) -> f32 {
    let (i, t) = (x.floor() as i64, x - x.floor());
    let (a, b) = (random(i, salt), random(i + 1, salt));
    2.0 * (a + (b - a) * t * t * (3.0 - 2.0 * t)) - 1.0
}
