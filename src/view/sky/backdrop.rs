//! The tools of a sky: shapes that are cut to the air, layers that move with the camera, soft lights.

use super::{PARALLAX, WorldPalette, beam, random};
use crate::draw::layout::{Area, Vec2};
use crate::draw::{Canvas, Colour, Image, Quad, Quads};
use crate::view::art::{self, Tile};
use std::f32::consts::TAU;

/// Cells of the sky's mesh across and down a usual canvas.
const CELL: Vec2 = Vec2::new(1280.0 / 24.0, 720.0 / 14.0);

type Point = (Vec2, Colour);

pub(super) struct Backdrop<'a> {
    pub(super) size: Vec2,
    pub(super) palette: WorldPalette,
    /// s.
    pub(super) time: f32,
    /// How far the layers have moved to the left and up.
    pub(super) shift: [Vec2; 3],
    /// The height of the level's floor where the camera usually is, from the canvas' top, and how far the camera is below that.
    pub(super) floor: f32,
    pub(super) climb: f32,
    pub(super) air: &'a [Area],
    pub(super) canvas: &'a Canvas,
    pub(super) quads: Quads,
    /// Soft lights, above the quadrangles since the last [`Self::flush`].
    pub(super) sprites: Vec<(Quad, [Vec2; 4])>,
}

impl Backdrop<'_> {
    /// What follows lies above all before.
    pub(super) fn flush(&mut self) {
        self.canvas.quads(std::mem::take(&mut self.quads));
        self.canvas.textured(&Image::Sheet, std::mem::take(&mut self.sprites));
    }

    pub(super) fn fill(&mut self, corners: &[Point]) {
        let (low, high) = corners.iter().fold((Vec2::MAX, Vec2::MIN), |(low, high), (at, _)| (low.min(*at), high.max(*at)));
        let air = self.air;
        for area in air {
            if low.cmpge(area.max()).any() || high.cmple(area.min).any() {
                continue;
            }
            if low.cmpge(area.min).all() && high.cmple(area.max()).all() {
                self.add(corners);
                return;
            }
            // Colours run evenly over a triangle: where it is cut, no seam shows.
            for i in 1..corners.len() - 1 {
                let mut part = vec![corners[0], corners[i], corners[i + 1]];
                for axis in 0..2 {
                    part = beyond(&beyond(&part, axis, 1.0, area.min[axis]), axis, -1.0, area.max()[axis]);
                }
                if part.len() > 2 {
                    self.add(&part);
                }
            }
        }
    }

    fn add(&mut self, corners: &[Point]) {
        let (a, last) = (corners[0], corners.len() - 1);
        for i in (1..last).step_by(2) {
            let (b, c, d) = (corners[i], corners[i + 1], corners[(i + 2).min(last)]);
            self.quads.quad([a.0, b.0, c.0, d.0], [a.1, b.1, c.1, d.1]);
        }
    }

    pub(super) fn quad(&mut self, corners: [Vec2; 4], colours: [Colour; 4]) {
        let points: [Point; 4] = std::array::from_fn(|i| (corners[i], colours[i]));
        self.fill(&points);
    }

    pub(super) fn block(&mut self, min: Vec2, size: Vec2, colour: Colour) {
        self.quad(Area { min, size }.corners(), [colour; 4]);
    }

    pub(super) fn line(&mut self, from: Vec2, to: Vec2, width: f32, colours: [Colour; 2]) {
        let across = (to - from).perp().normalize_or_zero() * width / 2.0;
        self.quad([from + across, to + across, to - across, from - across], [colours[0], colours[1], colours[1], colours[0]]);
    }

    /// A soft light, cut to the air.
    pub(super) fn light(&mut self, centre: Vec2, radius: f32, colour: Colour) {
        let (all, place) = (Area::around(centre, Vec2::splat(2.0 * radius)), art::place(Tile::Glow));
        for area in in_air(self.air, all) {
            let part = |at: Vec2| place.min + (at - all.min) / all.size * place.size;
            self.sprites.push((Quad { corners: area.corners(), colours: [colour; 4] }, area.corners().map(part)));
        }
    }

    /// The sky with its large glows: a mesh over the air. `lit` adds glows to a tone at a point.
    pub(super) fn sky(&mut self, lit: impl Fn(Vec2, Colour) -> Colour) {
        let (palette, height) = (self.palette, self.size.y);
        let tone = |at: Vec2| lit(at, palette.sky_at(at.y / height));
        for area in self.air {
            let cuts = |axis: usize| {
                let (from, to, step) = (area.min[axis], area.max()[axis], CELL[axis]);
                let inner = ((from / step).floor() as i32 + 1..).map(move |i| i as f32 * step).take_while(move |at| *at < to);
                std::iter::once(from).chain(inner).chain([to]).collect::<Vec<f32>>()
            };
            let rows = cuts(1);
            for x in cuts(0).windows(2) {
                for y in rows.windows(2) {
                    let corners = Area::new(x[0], y[0], x[1] - x[0], y[1] - y[0]).corners();
                    self.quads.quad(corners, corners.map(tone));
                }
            }
        }
    }

    /// Things of a layer that stand a step apart, each by its number and its place across; `reach` of them stand out of view.
    pub(super) fn across(&self, layer: usize, step: f32, reach: f32) -> impl Iterator<Item = (i64, f32)> + use<> {
        let shift = self.shift[layer].x;
        let (first, last) = (((shift - reach) / step).floor() as i64, ((shift + self.size.x + reach) / step).ceil() as i64);
        (first..=last).map(move |i| (i, i as f32 * step - shift))
    }

    /// A height in a layer, from the canvas' top: shares of the canvas above the level's floor; the camera's climb moves it a little.
    pub(super) fn ground(&self, layer: usize, above: f32) -> f32 {
        self.floor - self.size.y * above - self.climb * PARALLAX[layer]
    }

    /// A layer from its top, a height by the number of a step, down to the canvas' foot, darker by `fog`'s colour; its top has a line of light.
    pub(super) fn ridge(
        &mut self,
        layer: usize,
        (step, top): (f32, impl Fn(i64) -> f32),
        fog: (Colour, f32),
        light: Option<Colour>,
    ) {
        let (high, foot) = (self.palette.layers[layer], self.size.y);
        let low = high.mixed(fog.0, fog.1);
        for (i, x) in self.across(layer, step, step) {
            let [a, b] = [Vec2::new(x, top(i)), Vec2::new(x + step, top(i + 1))];
            let fade = |at: Vec2| Vec2::new(at.x, (at.y + 150.0).min(foot.max(at.y)));
            self.quad([a, b, fade(b), fade(a)], [high, high, low, low]);
            self.quad([fade(a), fade(b), Vec2::new(b.x, foot), Vec2::new(a.x, foot)], [low; 4]);
            if let Some(colour) = light {
                // It fades away from the light's side.
                let strength = |x: f32| {
                    let share = (x / self.size.x).clamp(0.0, 1.0) as f64;
                    let near = match self.palette.light.x {
                        x if x < 0.0 => 1.0 - share,
                        x if x > 0.0 => share,
                        _ => 0.6,
                    };
                    colour.faded((0.15 + 0.65 * near) as f32)
                };
                self.line(a, b, 1.5, [strength(a.x), strength(b.x)]);
            }
        }
    }

    /// A strip of haze across the canvas, strongest at its middle.
    pub(super) fn haze(&mut self, middle: f32, reach: f32, colour: Colour) {
        let clear = colour.faded(0.0);
        let row = |y: f32| [Vec2::new(0.0, y), Vec2::new(self.size.x, y)];
        let ([a, b], [c, d], [e, f]) = (row(middle - reach), row(middle), row(middle + reach));
        self.quad([a, b, d, c], [clear, clear, colour, colour]);
        self.quad([c, d, f, e], [colour, colour, clear, clear]);
    }

    pub(super) fn beam(&mut self, from: Vec2, way: Vec2, spread: (f32, f32), colour: Colour) {
        for quad in beam(from, way, spread, colour).0 {
            self.quad(quad.corners, quad.colours);
        }
    }

    /// A disc with a colour by the unit vector from its middle to its edge.
    pub(super) fn disc(&mut self, centre: Vec2, radius: f32, colour: impl Fn(Vec2) -> Colour) {
        const SIDES: u32 = 48;
        let rim = |i: u32| Vec2::from_angle(i as f32 * TAU / SIDES as f32);
        self.fill(&(0..SIDES).map(|i| (centre + rim(i) * radius, colour(rim(i)))).collect::<Vec<_>>());
    }

    pub(super) fn lattice(&mut self, foot: Vec2, height: f32, width: f32, colour: Colour) {
        let at = |side: f32, up: f32| foot + Vec2::new(side * width / 2.0, -up);
        for side in [-1.0, 1.0] {
            self.line(at(side, 0.0), at(side, height), 2.0, [colour; 2]);
        }
        let braces = (height / (width * 1.2)) as u32;
        for brace in 0..braces {
            let [low, high] = [brace, brace + 1].map(|i| i as f32 * height / braces as f32);
            self.line(at(-1.0, low), at(1.0, high), 1.2, [colour; 2]);
            self.line(at(1.0, low), at(-1.0, high), 1.2, [colour; 2]);
        }
    }

    /// Specks that drift with the time, each by its place, size and glimmer (0 … 1).
    pub(super) fn specks(&self, count: i64, drift: Vec2, layer: usize) -> impl Iterator<Item = (Vec2, f32, f32)> + use<> {
        let (time, size, shift) = (self.time, self.size, self.shift[layer]);
        (0..count).map(move |i| {
            let pace = 0.5 + random(i, 5);
            let at = Vec2::new(random(i, 3), random(i, 4)) * size + drift * (time * pace) - shift;
            (Vec2::new(at.x.rem_euclid(size.x), at.y.rem_euclid(size.y)), random(i, 6), 0.5 + 0.5 * (time * pace + i as f32).sin())
        })
    }

    /// Specks as soft lights; every eighth has a halo.
    pub(super) fn dots(&mut self, (count, drift, layer): (i64, Vec2, usize), (largest, colour): (f32, Colour)) {
        for (i, (at, size, glimmer)) in self.specks(count, drift, layer).enumerate() {
            let bright = (0.3 + 0.7 * glimmer) * (0.3 + 0.7 * size);
            self.light(at, 1.4 + 2.0 * size * largest, colour.faded(bright));
            if i % 8 == 0 {
                self.light(at, 5.0 + 4.0 * largest, colour.faded(0.3 * bright));
            }
        }
    }
}

/// The parts of a box in the air.
pub(super) fn in_air(air: &[Area], all: Area) -> impl Iterator<Item = Area> {
    let ends = air.iter().map(move |area| (all.min.max(area.min), all.max().min(area.max())));
    ends.filter(|(min, max)| min.cmplt(*max).all()).map(|(min, max)| Area { min, size: max - min })
}

/// The part of a convex outline on one side of a line along an axis.
fn beyond(corners: &[Point], axis: usize, way: f32, limit: f32) -> Vec<Point> {
    let mut part = Vec::with_capacity(corners.len() + 1);
    for (i, &to) in corners.iter().enumerate() {
        let from = corners[(i + corners.len() - 1) % corners.len()];
        let [a, b] = [from, to].map(|(at, _)| (at[axis] - limit) * way);
        if (a < 0.0) != (b < 0.0) {
            let share = a / (a - b);
            let mix = |from: f32, to: f32| from + (to - from) * share;
            let (p, q) = (from.1, to.1);
            part.push((from.0.lerp(to.0, share), Colour::new(mix(p.r, q.r), mix(p.g, q.g), mix(p.b, q.b), mix(p.a, q.a))));
        }
        if b >= 0.0 {
            part.push(to);
        }
    }
    part
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::Frame;
    use crate::level::Landscape;

    #[test]
    fn what_is_cut_to_the_air_keeps_its_area_and_stays_in_it() {
        let canvas = Canvas::new(Frame::default());
        let air = [Area::new(0.0, 0.0, 60.0, 50.0), Area::new(60.0, 20.0, 40.0, 80.0)];
        let palette = WorldPalette::of(Landscape::Launch);
        let mut sky = Backdrop {
            size: Vec2::splat(100.0),
            palette,
            time: 0.0,
            shift: [Vec2::ZERO; 3],
            floor: 50.0,
            climb: 0.0,
            air: &air,
            canvas: &canvas,
            quads: Quads::default(),
            sprites: Vec::new(),
        };
        sky.quad(Area::new(40.0, 10.0, 40.0, 60.0).corners(), [Colour::WHITE; 4]);
        let area = |quad: &Quad| {
            let at = quad.corners;
            ((at[2] - at[0]).perp_dot(at[3] - at[1]) / 2.0).abs()
        };
        let all: f32 = sky.quads.0.iter().map(area).sum();
        assert!((all - (20.0 * 40.0 + 20.0 * 50.0)).abs() < 0.1, "{all}");
        let inside = |at: &Vec2| air.iter().any(|area| at.cmpge(area.min).all() && at.cmple(area.max()).all());
        assert!(sky.quads.0.iter().flat_map(|quad| &quad.corners).all(inside));
    }
}
