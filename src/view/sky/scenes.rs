//! What stands in the sky of each world.

use super::backdrop::{Backdrop, in_air};
use super::{LAMP, glow, random, rolling};
use crate::draw::layout::{Area, Vec2};
use crate::{draw::Colour, view::art};
use std::f32::consts::{PI, TAU};

/// The sun's radius, and that of the earth.
const SUN: f32 = 44.0;
const EARTH: f32 = 235.0;

impl Backdrop<'_> {
    pub(super) fn launch_site(&mut self) {
        let horizon = self.ground(0, 0.03);
        self.sky(|at, tone| tone.mixed(Colour::hex(0xFF9A55), 0.20 * glow(((at.y - horizon) / 200.0).abs().min(1.0))));
        self.dots((120, Vec2::ZERO, 0), (0.7, self.palette.ink.faded(0.95)));
        self.flush();
        let base = self.ground(0, 0.10);
        let hills = |i: i64| base - 34.0 * rolling(i as f32 * 0.3, 20) - 12.0 * rolling(i as f32, 21);
        self.ridge(0, (44.0, hills), (self.palette.sky[3].1, 0.30), Some(self.palette.ink.faded(0.35)));
        self.haze(base + 40.0, 46.0, self.palette.sky[4].1.faded(0.36));
        let (base, steel) = (self.ground(1, 0.035), Colour::hex(0x2A3D78));
        for (i, x) in self.across(1, 430.0, 200.0) {
            let height = 210.0 + 110.0 * random(i, 7);
            let top = Vec2::new(x, base - height);
            self.lattice(Vec2::new(x, base), height, 15.0, steel);
            for arm in [0.35, 0.72, 0.92] {
                self.block(Vec2::new(x, base - height * arm), Vec2::new(40.0, 2.5), steel);
            }
            let blink = if (self.time * 0.7 + random(i, 8)).fract() < 0.5 { 1.0 } else { 0.35 };
            self.line(top, top - Vec2::new(0.0, 18.0), 1.5, [steel; 2]);
            self.light(top - Vec2::new(0.0, 18.0), 22.0, Colour::hex(0xFF4A4A).faded(0.55 * blink));
            self.light(top - Vec2::new(0.0, 18.0), 5.0, Colour::hex(0xFF9A9A).faded(blink));
            if i.rem_euclid(2) == 0 {
                self.rocket(Vec2::new(x + 66.0, base + 8.0), 190.0);
            }
        }
        self.ridge(1, (52.0, |i| base + 6.0 - 12.0 * rolling(i as f32 * 0.4, 22)), (self.palette.sky[3].1, 0.16), None);
        self.haze(base + 60.0, 40.0, self.palette.sky[4].1.faded(0.30));
        let base = self.ground(2, -0.01);
        for (i, x) in self.across(2, 310.0, 300.0) {
            let top = Vec2::new(x, base - 190.0 - 60.0 * random(i, 9));
            self.block(top, Vec2::new(3.0, base - top.y), self.palette.layers[2]);
            let side = if i.rem_euclid(2) == 0 { 0.62 } else { -0.62 };
            self.beam(top, Vec2::new(side, 1.0).normalize(), (250.0, 0.30), LAMP.faded(0.34));
            self.light(top, 34.0, LAMP.faded(0.55));
            self.light(top, 9.0, Colour::WHITE.faded(0.95));
        }
        self.ridge(2, (70.0, |i| base - 9.0 * rolling(i as f32 * 0.5, 23)), (Colour::hex(0x060A18), 0.6), None);
    }

    fn rocket(&mut self, foot: Vec2, height: f32) {
        let (dark, lit) = (self.palette.layers[1], Colour::hex(0x5468A4));
        for (offset, half, low, tall) in [(-20.0, 5.0, 0.0, 0.56), (20.0, 5.0, 0.0, 0.56), (0.0, 10.0, 0.0, 0.84)] {
            let at = |side: f32, up: f32| foot + Vec2::new(offset + side * half, -(low + up * height));
            for (from, to, [a, b]) in [(-1.0, 0.2, [dark, lit]), (0.2, 1.0, [lit, dark.mixed(lit, 0.5)])] {
                self.quad([at(from, 0.0), at(to, 0.0), at(to, tall), at(from, tall)], [a, b, b, a]);
                for step in 0..5 {
                    let [low, high] = [step, step + 1].map(|step| step as f32 / 5.0);
                    let wide = |part: f32| (1.0 - part * part).max(0.0);
                    let up = |part: f32| tall + part * half * 0.022;
                    let corners = [(from, low), (to, low), (to, high), (from, high)];
                    self.quad(corners.map(|(side, part)| at(side * wide(part), up(part))), [a, b, b, a]);
                }
            }
        }
    }

    pub(super) fn quarry(&mut self) {
        let [white, gold, amber, red] = [0xFFF2C4, 0xFFC873, 0xF58A42, 0xE06A3A].map(Colour::hex);
        let drift = self.shift[0] * Vec2::new(0.3, 0.0);
        let sun = Vec2::new((self.size.x * 0.275 - drift.x).clamp(120.0, self.size.x - 120.0), self.ground(0, 0.16));
        self.sky(|at, tone| {
            let out = (at - sun).length();
            tone.mixed(red, 0.42 * glow(out / 620.0)).mixed(amber, 0.55 * glow(out / 300.0)).mixed(gold, 0.45 * glow(out / 130.0))
        });
        self.dots((34, Vec2::ZERO, 0), (0.4, self.palette.ink.faded(0.5)));
        self.flush();
        for ray in 0..7_u8 {
            let angle = -PI * (0.10 + 0.80 * f32::from(ray) / 6.0) + 0.05 * random(i64::from(ray), 30);
            self.beam(sun, Vec2::from_angle(angle), (420.0, 0.07), gold.faded(0.11));
        }
        self.disc(sun, SUN, |way| white.mixed(gold, 0.5 + 0.5 * way.y).faded(0.5));
        for (i, y) in [-20.0, -4.0, 12.0, 27.0].into_iter().enumerate() {
            let bar = red.mixed(self.palette.sky[2].1, 0.4).faded(0.55 + 0.09 * i as f32);
            self.streak(sun + Vec2::new(9.0 - 5.0 * i as f32, y), Vec2::new(110.0, 3.0 + i as f32), bar);
        }
        for (i, x) in self.across(0, 380.0, 300.0) {
            let at = Vec2::new(x + 120.0 * random(i, 31), self.ground(0, 0.16 + 0.30 * random(i, 32)));
            self.streak(at, Vec2::new(150.0 + 90.0 * random(i, 33), 9.0), red.faded(0.12));
        }
        let base = self.ground(0, 0.095);
        self.terrace(0, (base, 52.0, 150.0), (self.palette.layers[1], 0.45), amber.faded(0.9));
        self.haze(base + 58.0, 44.0, red.faded(0.16));
        let (foot, iron) = (self.ground(1, 0.0), self.palette.layers[1].mixed(self.palette.layers[2], 0.6));
        for (i, x) in self.across(1, 640.0, 300.0) {
            let height = 230.0 + 50.0 * random(i, 9);
            self.lattice(Vec2::new(x + 60.0, foot), height, 10.0, iron);
            let [a, b] = [Vec2::new(x - 10.0, foot - height + 14.0), Vec2::new(x + 190.0, foot - height - 22.0)];
            self.line(a, b, 3.0, [iron; 2]);
            let hook = 66.0 + 8.0 * (self.time * 0.3 + i as f32).sin();
            self.line(b + Vec2::new(-40.0, 8.0), b + Vec2::new(-40.0, hook), 1.2, [iron; 2]);
        }
        let base = self.ground(1, 0.035);
        self.terrace(1, (base, 46.0, 190.0), (self.palette.layers[2], 0.6), amber.faded(0.55));
        self.haze(base + 70.0, 50.0, red.faded(0.12));
        self.terrace(2, (self.ground(2, -0.03), 50.0, 240.0), (Colour::hex(0x12090A), 0.6), gold.faded(0.25));
        self.dots((60, Vec2::new(9.0, -3.0), 2), (1.0, gold.faded(0.45)));
    }

    fn streak(&mut self, centre: Vec2, reach: Vec2, colour: Colour) {
        let clear = colour.faded(0.0);
        for way in [Vec2::new(-1.0, -1.0), Vec2::new(1.0, -1.0), Vec2::ONE, Vec2::new(-1.0, 1.0)] {
            let [x, y] = [Vec2::X, Vec2::Y].map(|axis| centre + reach * way * axis);
            self.fill(&[(centre, colour), (x, clear), (y, clear)]);
        }
    }

    fn terrace(&mut self, layer: usize, (base, rise, wide): (f32, f32, f32), fog: (Colour, f32), light: Colour) {
        let step = wide / 5.0;
        let height = move |i: i64| {
            let level = |k: i64| (random(k, 40 + layer as i64) * 4.0).floor() / 4.0;
            let (k, part) = (i.div_euclid(5), i.rem_euclid(5));
            let up = if part == 0 { level(k).midpoint(level(k - 1)) } else { level(k) };
            base - rise * up - 1.5 * random(i, 44)
        };
        self.ridge(layer, (step, height), fog, Some(light));
    }

    pub(super) fn wind_works(&mut self) {
        let sun = Vec2::new(self.size.x * 0.92, self.size.y * 0.02);
        let warm = Colour::hex(0xFFE9B0);
        self.sky(|at, tone| tone.mixed(warm, 0.16 * glow((at - sun).length() / 760.0)));
        for (i, x) in self.across(0, 300.0, 300.0) {
            let at = Vec2::new(x + 160.0 * random(i, 31), self.ground(0, 0.10 + 0.5 * random(i, 32)));
            self.streak(at, Vec2::new(170.0 + 120.0 * random(i, 33), 7.0), warm.faded(0.07));
        }
        let base = self.ground(0, 0.06);
        for (i, x) in self.across(0, 260.0, 200.0) {
            self.mill(Vec2::new(x, base + 10.0), 120.0 + 50.0 * random(i, 10), i);
        }
        let hills = |i: i64| base - 22.0 * rolling(i as f32 * 0.35, 50) - 5.0 * rolling(i as f32, 51);
        self.ridge(0, (48.0, hills), (self.palette.sky[4].1, 0.35), Some(warm.faded(0.4)));
        self.haze(base + 30.0, 50.0, self.palette.sky[4].1.faded(0.34));
        for (i, x) in self.across(1, 330.0, 220.0) {
            let radius = 62.0 + 88.0 * random(i, 11);
            let hub = Vec2::new(x, self.ground(1, -0.04) - radius * (1.0 + 0.9 * random(i, 12)));
            self.wheel(hub, radius, (0.10 + 0.12 * random(i, 13)) * if i.rem_euclid(2) == 0 { 1.0 } else { -1.0 });
        }
        let base = self.ground(2, -0.05);
        let cliffs = |i: i64| base - 46.0 * rolling(i as f32 * 0.22, 52).max(-0.2) - 7.0 * random(i, 53);
        self.ridge(2, (34.0, cliffs), (Colour::hex(0x06161C), 0.7), Some(warm.faded(0.22)));
        for (at, size, glimmer) in self.specks(22, Vec2::new(150.0, 0.0), 2) {
            let streak = self.palette.ink.faded(0.20 * glimmer);
            self.line(at - Vec2::new(40.0 + 90.0 * size, 0.0), at, 1.5, [streak.faded(0.0), streak]);
        }
    }

    fn mill(&mut self, foot: Vec2, height: f32, i: i64) {
        let fog = self.palette.sky_at((foot.y - height * 0.5) / self.size.y);
        let [body, sail] = [0.30, 0.45].map(|share| fog.mixed(Colour::hex(0xA48F58), share));
        let dark = fog.mixed(self.palette.layers[2], 0.4);
        let hub = foot - Vec2::new(0.0, height);
        let at = |side: f32, up: f32| foot + Vec2::new(side * (11.0 - 5.0 * up), -height * up);
        self.quad([at(-1.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(-1.0, 1.0)], [dark, body, body, dark]);
        for blade in 0..4_u8 {
            let way = Vec2::from_angle(f32::from(blade) * PI / 2.0 + self.time * 0.35 + i as f32);
            let (side, long) = (way.perp() * 11.0, height * 0.62);
            self.line(hub, hub + way * long, 2.0, [dark, body]);
            let (root, tip) = (hub + way * 14.0, hub + way * long);
            self.quad([root, tip, tip + side, root + side], [dark, sail, sail, body]);
        }
    }

    /// A toothed wheel with spokes on a post, brighter where it faces the light. `pace` is in radians a second.
    fn wheel(&mut self, hub: Vec2, radius: f32, pace: f32) {
        let (dark, brass, light) = (self.palette.layers[1], Colour::hex(0xA48F58), self.palette.light.as_vec2());
        let lit = move |way: Vec2| dark.mixed(brass, 0.66 * (0.5 + 0.5 * way.dot(light)).powf(1.5)).faded(0.92);
        let teeth = (radius / 5.0) as u32;
        let post = dark.mixed(self.palette.layers[2], 0.6).faded(0.92);
        self.block(hub - Vec2::new(5.0, 0.0), Vec2::new(10.0, (self.size.y - hub.y).max(0.0)), post);
        let turned = |wheel: &Self, part: f32| Vec2::from_angle(part / teeth as f32 * TAU + wheel.time * pace);
        let ring = |wheel: &mut Self, from: f32, to: f32, (inner, outer): (f32, f32)| {
            let [a, b] = [turned(wheel, from), turned(wheel, to)];
            let corners = [a * inner, b * inner, b * outer, a * outer].map(|way| hub + way * radius);
            wheel.quad(corners, [lit(-a), lit(-b), lit(b), lit(a)]);
        };
        for tooth in 0..teeth {
            let at = tooth as f32;
            ring(self, at, at + 1.0, (0.84, 0.94));
            ring(self, at, at + 0.5, (0.93, 1.0));
            ring(self, at, at + 1.0, (0.55, 0.585));
        }
        for spoke in 0..8_u8 {
            let way = Vec2::from_angle(f32::from(spoke) * TAU / 8.0 + self.time * pace);
            self.line(hub, hub + way * radius * 0.86, radius * 0.07, [dark.faded(0.92), lit(way.perp())]);
        }
        let hole = self.palette.layers[2];
        self.disc(hub, radius * 0.13, lit);
        self.disc(hub, radius * 0.07, |_| hole);
    }

    pub(super) fn deep_water(&mut self) {
        self.sky(|_, tone| tone);
        let light = Colour::hex(0xCFFFE4);
        for (i, x) in self.across(0, 210.0, 320.0) {
            let sway = 0.06 * (self.time * 0.4 + i as f32 * 1.7).sin();
            let (half, bright) = (0.05 + 0.05 * random(i, 13), 0.18 + 0.18 * random(i, 14));
            let way = Vec2::from_angle(PI * 0.5 + 0.34 + sway);
            let from = Vec2::new(x, -0.3 * self.size.y);
            self.beam(from, way, (self.size.y * (0.95 + 0.4 * random(i, 16)), half), light.faded(bright));
        }
        let (fog, deep) = (Colour::hex(0x0E4836), self.palette.sky[4].1);
        let base = self.ground(0, 0.13);
        let mounds = |i: i64| base - 74.0 * rolling(i as f32 * 0.16, 60).max(-0.4) - 9.0 * rolling(i as f32 * 0.7, 61);
        self.ridge(0, (30.0, mounds), (fog, 0.75), None);
        self.weeds(1, 0.34, Colour::hex(0x0F4A3C).mixed(fog, 0.25));
        self.haze(base + 60.0, 80.0, fog.faded(0.42));
        let base = self.ground(1, 0.03);
        let mounds = |i: i64| base - 60.0 * rolling(i as f32 * 0.13, 62).max(-0.3) - 8.0 * rolling(i as f32 * 0.6, 63);
        self.ridge(1, (30.0, mounds), (deep, 0.6), None);
        self.weeds(2, 0.42, self.palette.layers[2]);
        self.haze(self.ground(2, 0.0), 120.0, deep.faded(0.6));
        self.dots((36, Vec2::new(0.0, -26.0), 2), (1.3, light.faded(0.24)));
    }

    fn weeds(&mut self, layer: usize, tallest: f32, colour: Colour) {
        for (i, x) in self.across(layer, 118.0, 60.0).filter(|(i, _)| random(*i, 17) > 0.2) {
            for blade in 0..3_i64 {
                let foot = Vec2::new(x + 16.0 * blade as f32, self.ground(layer, -0.02));
                self.weed(foot, self.size.y * tallest * (0.35 + 0.65 * random(i * 3 + blade, 15)), (i * 3 + blade, colour));
            }
        }
    }

    /// A plant from its foot up, which sways more towards its tip and is lighter there.
    fn weed(&mut self, foot: Vec2, height: f32, (i, colour): (i64, Colour)) {
        const JOINTS: u32 = 9;
        let deep = self.palette.sky[4].1;
        let time = self.time;
        let at = |joint: u32| {
            let share = joint as f32 / JOINTS as f32;
            let bend = (time * 0.6 + i as f32 + share * 3.0).sin() + 0.8 * (i as f32 * 1.3).sin();
            foot + Vec2::new(20.0 * share * bend, -height * share)
        };
        let half = |joint: u32| Vec2::X * (6.5 * (PI * (0.16 + 0.84 * joint as f32 / JOINTS as f32)).sin());
        for joint in 0..JOINTS {
            let (low, high) = (at(joint), at(joint + 1));
            let [a, b] = [joint, joint + 1].map(|joint| deep.mixed(colour, 0.3 + 0.7 * joint as f32 / JOINTS as f32));
            let corners = [low - half(joint), low + half(joint), high + half(joint + 1), high - half(joint + 1)];
            self.quad(corners, [a, a.mixed(deep, 0.25), b.mixed(deep, 0.25), b]);
        }
    }

    pub(super) fn orbit(&mut self) {
        let (size, shift) = (self.size, self.shift[0]);
        let clouds: [(f32, f32, f32, usize); 5] = [
            (0.46, 0.42, 230.0, 1),
            (0.63, 0.31, 250.0, 0),
            (0.80, 0.20, 210.0, 2),
            (0.95, 0.12, 230.0, 0),
            (0.22, 0.60, 240.0, 2),
        ];
        let tones = self.palette.layers;
        self.sky(|at, tone| {
            clouds.iter().fold(tone, |tone, (x, y, reach, kind)| {
                tone.mixed(tones[*kind], 0.55 * glow((at - Vec2::new(x * size.x, y * size.y) + shift).length() / reach))
            })
        });
        self.dots((150, Vec2::ZERO, 0), (0.35, self.palette.ink.faded(0.75)));
        self.dots((40, Vec2::ZERO, 1), (0.7, self.palette.ink.faded(0.9)));
        let moon = Vec2::new(size.x * 0.82, size.y * 0.26) - shift;
        let grey = |light: f32| Colour::hex(0x07080C).mixed(Colour::hex(0x77746E), light.clamp(0.0, 1.0));
        let towards = Vec2::new(-0.86, -0.5);
        self.disc(moon, 30.0, |way| grey(0.45 + 0.62 * way.dot(towards)));
        for (x, y, radius) in [(-9.0, -8.0, 7.0), (4.0, 6.0, 5.0), (-14.0, 8.0, 4.0), (6.0, -14.0, 4.0), (-2.0, 17.0, 3.5)] {
            self.disc(moon + Vec2::new(x, y), radius, |way| grey(0.40 - 0.02 * x - 0.16 * way.dot(towards)));
        }
        self.flush();
        let all = Area::around(Vec2::new(size.x * 0.41, size.y * 0.48) - shift, Vec2::splat(2.0 * EARTH * art::rock::AIR));
        for area in in_air(self.air, all) {
            let part = Area { min: (area.min - all.min) / all.size, size: area.size / all.size };
            self.canvas.picture(&art::rock::EARTH, part, area, (0.0, Colour::WHITE));
        }
    }
}
