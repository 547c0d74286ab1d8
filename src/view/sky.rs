//! The sky of a world of levels: a gradient of two tones, a far and a near layer that move with the camera, and weather. All of it is
//! drawn by code, in canvas units; plain palettes leave it out.

use super::camera::Viewport;
use super::terrain::drafting::chance;
use super::theme;
use crate::draw::layout::{Area, Vec2};
use crate::draw::{Canvas, Colour, Quads};
use crate::level::Landscape;
use crate::physics::DVec2;
use std::f32::consts::TAU;

/// The colours of a world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldPalette {
    /// The upper and the lower tone.
    pub sky: [Colour; 2],
    /// The far and the near layer.
    pub layers: [Colour; 2],
    /// Hatching, dimension lines and edges of rock.
    pub ink: Colour,
    pub rock: Colour,
    /// The light on edges that face it.
    pub rim: Colour,
    /// The unit vector towards that light, y down.
    pub light: DVec2,
}

impl WorldPalette {
    pub fn of(landscape: Landscape) -> Self {
        match landscape {
            Landscape::Launch => Self::new([0x0A0F24, 0x1B2A52], [0x16224A, 0x101A3A], 0x9DB4E0, 0x252F4C, 0xFFE9BE, DVec2::NEG_Y),
            Landscape::Quarry => {
                Self::new([0x1B1026, 0x43222F], [0x301A28, 0x24141F], 0xE0B98A, 0x3A281E, 0xFFC46B, DVec2::new(-0.8, -0.6))
            }
            Landscape::Wind => {
                Self::new([0x07262B, 0x13484A], [0x0F3A3D, 0x0A2C30], 0xD2BC7C, 0x2F342B, 0xFFDF8A, DVec2::new(0.6, -0.8))
            }
            Landscape::Water => Self::new([0x0F4038, 0x03110F], [0x0B2F2A, 0x07211E], 0x86C9AB, 0x18322B, 0xC8FFE6, DVec2::NEG_Y),
            Landscape::Orbit => {
                Self::new([0x020308, 0x05070F], [0x0B1020, 0x12182B], 0xB3B9CC, 0x2B2E39, 0x86C8FF, DVec2::new(-0.6, 0.8))
            }
        }
    }

    fn new(sky: [u32; 2], layers: [u32; 2], ink: u32, rock: u32, rim: u32, light: DVec2) -> Self {
        let pair = |tones: [u32; 2]| tones.map(Colour::hex);
        Self { sky: pair(sky), layers: pair(layers), ink: Colour::hex(ink), rock: Colour::hex(rock), rim: Colour::hex(rim), light }
    }
}

/// Shares of the camera's motion that the far and the near layer take part in.
const PARALLAX: [f32; 2] = [0.12, 0.3];

/// Draws a world's sky over the whole canvas. `time` (s) moves wheels, dust and bubbles.
pub fn draw(landscape: Landscape, view: &Viewport, canvas: &Canvas, time: f64) {
    if theme::is_plain() {
        return;
    }
    let palette = WorldPalette::of(landscape);
    let mut quads = Quads::default();
    gradient(&mut quads, Area { min: Vec2::ZERO, size: view.size() }, palette.sky);
    let origin = view.point(DVec2::ZERO);
    let sky = Backdrop { size: view.size(), palette, time: time as f32, shift: PARALLAX.map(|share| -origin * share) };
    match landscape {
        Landscape::Launch => sky.launch_site(&mut quads),
        Landscape::Quarry => sky.quarry(&mut quads),
        Landscape::Wind => sky.wind_works(&mut quads),
        Landscape::Water => sky.deep_water(&mut quads),
        Landscape::Orbit => sky.orbit(&mut quads),
    }
    canvas.quads(quads);
}

/// From the upper to the lower tone.
pub fn gradient(quads: &mut Quads, area: Area, [top, bottom]: [Colour; 2]) {
    let (a, b) = (area.min, area.max());
    quads.quad([a, Vec2::new(b.x, a.y), b, Vec2::new(a.x, b.y)], [top, top, bottom, bottom]);
}

fn block(quads: &mut Quads, min: Vec2, size: Vec2, colour: Colour) {
    gradient(quads, Area { min, size }, [colour; 2]);
}

/// A disc whose colour runs from its middle to its edge.
fn disc(quads: &mut Quads, centre: Vec2, radius: f32, [middle, edge]: [Colour; 2]) {
    const SIDES: u32 = 40;
    let rim = |i: u32| centre + Vec2::from_angle(i as f32 * TAU / SIDES as f32) * radius;
    for i in 0..SIDES {
        quads.quad([centre, rim(i), rim(i + 1), centre], [middle, edge, edge, middle]);
    }
}

/// A number from 0 to 1 by two whole numbers, the same on every run.
fn random(i: i64, salt: i64) -> f32 {
    chance(i.wrapping_mul(31) + salt, DVec2::X * salt as f64) as f32
}

struct Backdrop {
    size: Vec2,
    palette: WorldPalette,
    /// s.
    time: f32,
    /// How far the far and the near layer have moved to the left and up.
    shift: [Vec2; 2],
}

impl Backdrop {
    /// Things of a layer that stand a step apart, each by its number and its place across; `reach` of them stand out of view.
    fn across(&self, layer: usize, step: f32, reach: f32) -> impl Iterator<Item = (i64, f32)> + use<> {
        let shift = self.shift[layer].x;
        let (first, last) = (((shift - reach) / step).floor() as i64, ((shift + self.size.x + reach) / step).ceil() as i64);
        (first..=last).map(move |i| (i, i as f32 * step - shift))
    }

    /// The height of a layer's ground, from the canvas' top, at a share of it; the camera's climb moves it a little.
    fn ground(&self, layer: usize, share: f32) -> f32 {
        let climb = (self.shift[layer].y * 0.5).clamp(-0.2 * self.size.y, 0.2 * self.size.y);
        self.size.y * share - climb
    }

    /// Blocks side by side from the ground line to the canvas' foot, some higher than others.
    fn skyline(&self, quads: &mut Quads, layer: usize, (step, ground, rise): (f32, f32, f32)) {
        let base = self.ground(layer, ground);
        for (i, x) in self.across(layer, step, 0.0) {
            let top = base - rise * random(i, layer as i64 + 1);
            block(quads, Vec2::new(x, top), Vec2::new(step + 0.5, (self.size.y - top).max(0.0)), self.palette.layers[layer]);
        }
    }

    /// Specks that drift with the time, each by its place, size and glimmer (0 … 1).
    fn specks(&self, count: i64, drift: Vec2, layer: usize) -> impl Iterator<Item = (Vec2, f32, f32)> + use<'_> {
        (0..count).map(move |i| {
            let pace = 0.5 + random(i, 5);
            let at = Vec2::new(random(i, 3), random(i, 4)) * self.size + drift * (self.time * pace) - self.shift[layer];
            let at = Vec2::new(at.x.rem_euclid(self.size.x), at.y.rem_euclid(self.size.y));
            (at, random(i, 6), 0.5 + 0.5 * (self.time * pace + i as f32).sin())
        })
    }

    fn dots(&self, quads: &mut Quads, (count, drift, layer): (i64, Vec2, usize), (largest, colour): (f32, Colour)) {
        for (at, size, glimmer) in self.specks(count, drift, layer) {
            block(quads, at, Vec2::splat(1.0 + size * largest), colour.faded((0.3 + 0.7 * glimmer) * (0.3 + 0.7 * size)));
        }
    }

    /// Stars, masts with floodlights, and their beams on the pads.
    fn launch_site(&self, quads: &mut Quads) {
        self.dots(quads, (90, Vec2::ZERO, 0), (1.6, self.palette.ink.faded(0.6)));
        self.skyline(quads, 0, (90.0, 0.72, 70.0));
        let base = self.ground(0, 0.72);
        for (i, x) in self.across(0, 330.0, 120.0) {
            let height = 150.0 + 120.0 * random(i, 7);
            let (foot, top) = (Vec2::new(x, base), Vec2::new(x, base - height));
            block(quads, top, Vec2::new(5.0, height), self.palette.layers[0]);
            block(quads, top - Vec2::new(12.0, 4.0), Vec2::new(29.0, 7.0), self.palette.layers[0]);
            let (beam, side) = (self.palette.rim, if i.rem_euclid(2) == 0 { 1.0 } else { -1.0 });
            let spread = [foot + Vec2::new(side * 240.0, 40.0), foot + Vec2::new(side * 90.0, 40.0)];
            quads.quad([top, top, spread[0], spread[1]], [beam.faded(0.22), beam.faded(0.22), beam.faded(0.0), beam.faded(0.0)]);
            let blink = if (self.time * 0.7 + random(i, 8)).fract() < 0.5 { 0.9 } else { 0.25 };
            block(quads, top - Vec2::new(0.0, 9.0), Vec2::splat(4.0), theme::bad().faded(blink));
        }
        self.skyline(quads, 1, (150.0, 0.9, 60.0));
    }

    /// A low sun, terraces, a crane, and dust in the air.
    fn quarry(&self, quads: &mut Quads) {
        let sun = Vec2::new(self.size.x * 0.2, self.ground(0, 0.62)) - Vec2::X * (self.shift[0].x * 0.1).clamp(-200.0, 200.0);
        let glow = self.palette.rim;
        disc(quads, sun, self.size.y * 0.6, [glow.faded(0.30), glow.faded(0.0)]);
        disc(quads, sun, 46.0, [glow.faded(0.85), glow.faded(0.75)]);
        for (terrace, share) in [0.62, 0.70, 0.78].into_iter().enumerate() {
            let (step, rise) = (260.0 - 60.0 * terrace as f32, 46.0);
            self.skyline(quads, 0, (step, share, rise));
        }
        for (i, x) in self.across(1, 760.0, 300.0) {
            let (base, height) = (self.ground(1, 0.9), 210.0 + 70.0 * random(i, 9));
            let near = self.palette.layers[1];
            block(quads, Vec2::new(x, base - height), Vec2::new(9.0, height), near);
            block(quads, Vec2::new(x - 70.0, base - height), Vec2::new(280.0, 7.0), near);
            block(
                quads,
                Vec2::new(x + 180.0, base - height),
                Vec2::new(2.0, 60.0 + 20.0 * (self.time * 0.3 + i as f32).sin()),
                near,
            );
        }
        self.skyline(quads, 1, (120.0, 0.9, 60.0));
        self.dots(quads, (70, Vec2::new(9.0, -3.0), 1), (2.5, glow.faded(0.35)));
    }

    /// Turning wheels on towers, and streaks of wind.
    fn wind_works(&self, quads: &mut Quads) {
        self.skyline(quads, 0, (140.0, 0.8, 50.0));
        for (layer, step, share) in [(0, 300.0, 0.78), (1, 520.0, 0.92)] {
            for (i, x) in self.across(layer, step, 200.0) {
                let radius = (70.0 + 60.0 * random(i, 10)) * (1.0 + 0.4 * layer as f32);
                let foot = self.ground(layer, share);
                let hub = Vec2::new(x, foot - radius * (1.5 + 0.5 * random(i, 11)));
                self.wheel(quads, (hub, radius, foot), layer, 0.25 + 0.3 * random(i, 12));
            }
        }
        self.skyline(quads, 1, (190.0, 0.93, 40.0));
        for (at, size, glimmer) in self.specks(26, Vec2::new(150.0, 0.0), 1) {
            let (clear, streak) = (self.palette.ink.faded(0.0), self.palette.ink.faded(0.16 * glimmer));
            quads.stroke([at - Vec2::new(40.0 + 90.0 * size, 0.0), at], 1.3, [clear, streak]);
        }
    }

    /// A tower from the ground to a wheel's hub, and eight spokes with a rim. `pace` is in radians a second.
    fn wheel(&self, quads: &mut Quads, (hub, radius, foot): (Vec2, f32, f32), layer: usize, pace: f32) {
        let brass = self.palette.layers[layer].mixed(self.palette.ink, 0.12 + 0.08 * layer as f32);
        block(quads, hub - Vec2::new(4.0, 0.0), Vec2::new(8.0, (foot - hub.y).max(0.0)), self.palette.layers[layer]);
        let rim = |spoke: u32| hub + Vec2::from_angle(spoke as f32 * TAU / 8.0 + self.time * pace) * radius;
        for spoke in 0..8 {
            quads.stroke([hub, rim(spoke)], 3.0, [brass; 2]);
            quads.stroke([rim(spoke), rim(spoke + 1)], 3.0, [brass; 2]);
        }
    }

    /// Shafts of light from the surface that sway, columns of weed, and bubbles.
    fn deep_water(&self, quads: &mut Quads) {
        let light = self.palette.rim;
        for (i, x) in self.across(0, 210.0, 260.0) {
            let sway = 26.0 * (self.time * 0.4 + i as f32 * 1.7).sin();
            let (width, bright) = (40.0 + 60.0 * random(i, 13), 0.05 + 0.08 * random(i, 14));
            let foot = Vec2::new(x - 170.0 + sway, self.size.y * 0.85);
            quads.quad(
                [Vec2::new(x, 0.0), Vec2::new(x + width, 0.0), foot + Vec2::X * width * 1.8, foot],
                [light.faded(bright), light.faded(bright), light.faded(0.0), light.faded(0.0)],
            );
        }
        for (layer, step) in [(0, 120.0), (1, 210.0)] {
            for (i, x) in self.across(layer, step, 60.0) {
                self.weed(quads, Vec2::new(x, self.size.y), self.size.y * (0.15 + 0.3 * random(i, 15)), (layer, i));
            }
        }
        self.dots(quads, (40, Vec2::new(0.0, -26.0), 1), (4.0, light.faded(0.22)));
    }

    /// A plant from its foot up, which sways more towards its tip.
    fn weed(&self, quads: &mut Quads, foot: Vec2, height: f32, (layer, i): (usize, i64)) {
        const JOINTS: u32 = 6;
        let colour = self.palette.layers[layer];
        let at = |joint: u32| {
            let share = joint as f32 / JOINTS as f32;
            foot + Vec2::new(22.0 * share * (self.time * 0.6 + i as f32 + share * 3.0).sin(), -height * share)
        };
        for joint in 0..JOINTS {
            let half = |joint: u32| Vec2::X * (9.0 * (1.0 - joint as f32 / (JOINTS + 1) as f32));
            let (low, high) = (at(joint), at(joint + 1));
            quads.quad([low - half(joint), low + half(joint), high + half(joint + 1), high - half(joint + 1)], [colour; 4]);
        }
    }

    /// Stars in two depths, the earth with its air, and a moon.
    fn orbit(&self, quads: &mut Quads) {
        self.dots(quads, (120, Vec2::ZERO, 0), (1.4, self.palette.ink.faded(0.55)));
        self.dots(quads, (50, Vec2::ZERO, 1), (2.2, self.palette.ink.faded(0.8)));
        let drift = Vec2::new(self.shift[0].x, self.shift[0].y) * 0.25;
        let radius = self.size.y * 0.95;
        let earth = Vec2::new(self.size.x * 0.12, self.size.y * 1.45) - drift;
        let air = self.palette.rim;
        disc(quads, earth, radius * 1.12, [air.faded(0.55), air.faded(0.0)]);
        disc(quads, earth, radius, [Colour::hex(0x0B2A4A), Colour::hex(0x2B6CA8)]);
        let moon = Vec2::new(self.size.x * 0.82, self.size.y * 0.2) - drift * 1.5;
        disc(quads, moon, 34.0, [Colour::hex(0x4A4E5C), Colour::hex(0x6B7080)]);
        disc(quads, moon + Vec2::new(11.0, -8.0), 7.0, [Colour::hex(0x3C404D), Colour::hex(0x4A4E5C)]);
        disc(quads, moon + Vec2::new(-12.0, 10.0), 5.0, [Colour::hex(0x3C404D), Colour::hex(0x4A4E5C)]);
    }
}
