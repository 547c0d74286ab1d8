//! Particles: a pool of short-lived dots and streaks, for show: their random numbers are their own and nothing reads them back.
//! Barriers of exhaust, dust and sparks: the solid surfaces near the view, sorted into columns so that a particle looks at few of them.

use super::art::{self, Tile};
use super::camera::Viewport;
use crate::draw::layout::{Area, Vec2};
use crate::draw::{Canvas, Colour};
use crate::physics::{Aabb, DVec2, Sides, World};
use rand::{Rng, SeedableRng};
use rand_pcg::Pcg32;
use std::f32::consts::FRAC_PI_2;

/// The most particles: more cost frames and hide the game.
const MOST: usize = 1500;
/// The share of the speed into a solid that exhaust, dust and sparks turn along it.
const SPLAY: f64 = 0.6;

/// Acceleration of sparks and dust downwards, m/s²: less than a stone's, for air carries them, and equal in every level.
const SPARK_WEIGHT: f64 = 3.0;
const DUST_WEIGHT: f64 = 1.5;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParticleLook {
    /// Orange fire that turns into white smoke.
    Plume,
    /// A puff that spreads and settles.
    Dust,
    Spark,
    /// A stroke along its path.
    Streak,
    Arrow,
}

/// In SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    pub position: DVec2,
    pub velocity: DVec2,
    pub age: f32,
    /// Age at its death.
    pub life: f32,
    pub look: ParticleLook,
    /// The plume has its own colours.
    pub colour: Colour,
}

impl Particle {
    /// Position in m, velocity in m/s; `life` is the age at its death, s.
    pub const fn new(look: ParticleLook, colour: Colour, (position, velocity): (DVec2, DVec2), life: f64) -> Self {
        Self { position, velocity, age: 0.0, life: life as f32, look, colour }
    }

    /// Present radius, canvas units, and colour.
    pub fn appearance(&self) -> (f32, Colour) {
        let t = (self.age / self.life).clamp(0.0, 1.0);
        let mix = |from: f32, to: f32| from + (to - from) * t;
        match self.look {
            ParticleLook::Plume => {
                (mix(2.0, 5.0), Colour::new(1.0, mix(174.0, 255.0) / 255.0, mix(0.0, 255.0) / 255.0, 0.85 * (1.0 - t)))
            }
            ParticleLook::Dust => (mix(1.5, 4.5), self.colour.faded(0.7 * (1.0 - t))),
            ParticleLook::Spark => (mix(2.2, 0.8), self.colour.faded(0.9 * (1.0 - t))),
            ParticleLook::Arrow => (1.3, self.colour.faded(1.0 - t * t)),
            // Fades in as well, for it appears in the middle of the stream.
            ParticleLook::Streak => (1.1, self.colour.faded(0.75 * (t * 4.0).min(1.0) * ((1.0 - t) * 3.0).min(1.0))),
        }
    }

    /// Moves it in a straight line to a point, or to the first solid before that, along which it goes on; wind blows through solids.
    fn go(&mut self, to: DVec2, barriers: &Barriers) {
        let Some((at, axis)) = barriers.stop(self.position, to).filter(|_| self.look != ParticleLook::Streak) else {
            self.position = to;
            return;
        };
        let along = 1 - axis;
        self.position = at;
        self.velocity[along] += SPLAY * self.velocity[axis].abs() * self.velocity[along].signum();
        self.velocity[axis] = 0.0;
    }

    /// Rate of slowing, 1/s, and acceleration downwards, m/s²: smoke rises by its warmth, and a streak follows the stream.
    const fn drag_and_weight(&self) -> (f64, f64) {
        match self.look {
            ParticleLook::Plume => (1.6, 0.0),
            ParticleLook::Dust => (2.5, DUST_WEIGHT),
            ParticleLook::Spark => (0.5, SPARK_WEIGHT),
            ParticleLook::Arrow => (2.0, 0.0),
            ParticleLook::Streak => (0.0, 0.0),
        }
    }
}

pub struct Particles {
    pub all: Vec<Particle>,
    most: usize,
    /// Of the present frame.
    pub barriers: Barriers,
    random: Pcg32,
}

impl Particles {
    /// A full pool drops the particle.
    pub fn add(&mut self, particle: Particle) {
        if self.all.len() < self.most {
            self.all.push(particle);
        }
    }

    /// Adds a particle from a point, before the first solid on its path from there; a full pool drops it.
    pub fn launch(&mut self, from: DVec2, particle: Particle) {
        let to = particle.position;
        let mut particle = Particle { position: from, ..particle };
        particle.go(to, &self.barriers);
        self.add(particle);
    }

    /// Uniform between the two.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.random.next_u32()) / f64::from(u32::MAX)
    }

    /// Moves and ages all by `frame_time` seconds.
    pub fn advance(&mut self, frame_time: f64) {
        for particle in &mut self.all {
            particle.age += frame_time as f32;
            let (drag, weight) = particle.drag_and_weight();
            let weight = DVec2::new(0.0, weight);
            particle.go(particle.position + (particle.velocity + 0.5 * frame_time * weight) * frame_time, &self.barriers);
            particle.velocity = (particle.velocity + frame_time * weight) * (-drag * frame_time).exp();
        }
        self.all.retain(|particle| particle.age < particle.life);
    }

    /// Limits the pool to `share` % of its capacity, the player's setting.
    pub fn keep(&mut self, share: u8) {
        self.most = MOST * usize::from(share) / 100;
        self.all.truncate(self.most);
    }

    pub fn draw(&self, view: &Viewport, canvas: &Canvas) {
        let visible = view.visible();
        for particle in &self.all {
            if particle.position.cmpge(visible.min - 1.0).all() && particle.position.cmple(visible.max + 1.0).all() {
                let ((radius, colour), DVec2 { x, y }) = (particle.appearance(), particle.velocity);
                let (length, rotation) = match particle.look {
                    ParticleLook::Arrow => {
                        draw_arrow(particle, colour, view, canvas);
                        continue;
                    }
                    ParticleLook::Streak => (view.length(particle.velocity.length() * 0.1), (x as f32).atan2(-y as f32)),
                    ParticleLook::Plume | ParticleLook::Dust | ParticleLook::Spark => (2.0 * radius, FRAC_PI_2),
                };
                let area = Area::around(view.point(particle.position), Vec2::new(2.0 * radius, length));
                art::draw(canvas, Tile::Disc, area, rotation, colour);
            }
        }
    }
}

/// Its length is its way in this time, s, and what it keeps at rest, canvas units; its head's length.
const ARROW_TIME: f64 = 0.07;
const ARROW: f32 = 12.0;
const ARROW_HEAD: f32 = 7.0;

fn draw_arrow(particle: &Particle, colour: Colour, view: &Viewport, canvas: &Canvas) {
    let along = particle.velocity.normalize_or_zero().as_vec2();
    let tip = view.point(particle.position);
    let neck = tip - along * ARROW_HEAD;
    canvas.line(neck - along * (ARROW + view.length(particle.velocity.length() * ARROW_TIME)), neck, 2.2, colour);
    let side = along.perp() * (0.5 * ARROW_HEAD);
    canvas.convex(&[tip, neck + side, neck - side], colour);
}

impl Default for Particles {
    fn default() -> Self {
        Self { all: Vec::with_capacity(MOST), most: MOST, barriers: Barriers::default(), random: Pcg32::seed_from_u64(0x5245_5355) }
    }
}

/// Columns over the width of the view.
const COLUMNS: usize = 64;
/// Gap that a stopped particle keeps to its surface, m.
const CLEAR: f64 = 1e-3;

/// The surfaces of one moment.
#[derive(Clone, Debug, Default)]
pub struct Barriers {
    left: f64,
    /// Columns a metre.
    scale: f64,
    columns: Vec<Vec<(Aabb, Sides)>>,
}

impl Barriers {
    pub fn new(world: &World, within: &Aabb) -> Self {
        let width = within.size().x;
        let scale = if width > 0.0 { COLUMNS as f64 / width } else { 0.0 };
        let mut barriers = Self { left: within.min.x, scale, columns: vec![Vec::new(); COLUMNS] };
        for surface in world.surfaces().iter().filter(|surface| surface.present && surface.bounds.touches(within, 0.0)) {
            let (from, to) = (barriers.column(surface.bounds.min.x), barriers.column(surface.bounds.max.x));
            barriers.columns[from..=to].iter_mut().for_each(|column| column.push((surface.bounds, surface.sides())));
        }
        barriers
    }

    /// The first stop on the straight path between two points, a little before a surface, m, and the axis (0: x, 1: y) along which it meets that. A path that begins inside a surface leads out of it.
    pub fn stop(&self, from: DVec2, to: DVec2) -> Option<(DVec2, usize)> {
        if self.columns.is_empty() {
            return None;
        }
        let (first, last) = (self.column(from.x.min(to.x)), self.column(from.x.max(to.x)));
        let met = self.columns[first..=last].iter().flatten().filter_map(|(bounds, sides)| meets(bounds, *sides, from, to));
        let (part, axis) = met.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let way = to - from;
        let mut at = from + way * part;
        at[axis] -= CLEAR * way[axis].signum();
        Some((at, axis))
    }

    /// The distance from a point to the first stop along a unit vector, at most `reach`, m.
    pub fn room(&self, from: DVec2, along: DVec2, reach: f64) -> f64 {
        self.stop(from, from + along * reach).map_or(reach, |(at, _)| at.distance(from))
    }

    fn column(&self, x: f64) -> usize {
        // The cast takes places left of the view to 0.
        (((x - self.left) * self.scale) as usize).min(COLUMNS - 1)
    }
}

/// The free part (0 … 1) of a path before it enters a box through a solid face, and the axis of that face.
fn meets(bounds: &Aabb, sides: Sides, from: DVec2, to: DVec2) -> Option<(f64, usize)> {
    let (enters, leaves, axis) = stretch(bounds, from, to - from)?;
    (enters >= 0.0 && enters < leaves.min(1.0) && sides.face(axis, to[axis] - from[axis] < 0.0)).then_some((enters, axis))
}

/// The parts of a way at which a line enters and leaves a box, and the axis along which it enters; `None` where it passes by.
pub fn stretch(bounds: &Aabb, from: DVec2, way: DVec2) -> Option<(f64, f64, usize)> {
    let (mut enters, mut leaves, mut axis) = (f64::NEG_INFINITY, f64::INFINITY, 0);
    for i in 0..2 {
        if way[i] == 0.0 {
            if from[i] <= bounds.min[i] || from[i] >= bounds.max[i] {
                return None;
            }
            continue;
        }
        let (a, b) = ((bounds.min[i] - from[i]) / way[i], (bounds.max[i] - from[i]) / way[i]);
        if a.min(b) > enters {
            (enters, axis) = (a.min(b), i);
        }
        leaves = leaves.min(a.max(b));
    }
    Some((enters, leaves, axis))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Aabb, Material, SurfaceDef, World, WorldDef};

    fn particle(look: ParticleLook, life: f64) -> Particle {
        Particle::new(look, Colour::WHITE, (DVec2::ZERO, DVec2::X), life)
    }

    #[test]
    fn the_plume_goes_from_orange_to_white_smoke_and_grows() {
        let (radius, colour) = particle(ParticleLook::Plume, 1.0).appearance();
        assert_eq!((radius, (colour.r, colour.g, colour.b)), (2.0, (1.0, 174.0 / 255.0, 0.0)));
        let (radius, colour) = Particle { age: 1.0, ..particle(ParticleLook::Plume, 1.0) }.appearance();
        assert_eq!((radius, (colour.r, colour.g, colour.b), colour.a), (5.0, (1.0, 1.0, 1.0), 0.0));
    }

    #[test]
    fn exhaust_spreads_on_a_deck_and_wind_blows_through_it() {
        let bounds = Aabb::new(DVec2::new(-5.0, 2.0), DVec2::new(5.0, 2.2));
        let surfaces = vec![SurfaceDef::fixed(bounds, Material::STEEL)];
        let world = World::new(WorldDef { surfaces, ..WorldDef::default() }).expect("a valid world");
        let barriers = Barriers::new(&world, &Aabb::around(DVec2::ZERO, DVec2::splat(8.0)));
        let mut pool = Particles { barriers, ..Particles::default() };
        let velocity = DVec2::new(0.5, 7.0);
        for look in [ParticleLook::Plume, ParticleLook::Dust, ParticleLook::Spark, ParticleLook::Streak] {
            pool.launch(DVec2::ZERO, Particle { velocity, position: DVec2::new(0.0, 3.0), ..particle(look, 2.0) });
            pool.add(Particle { velocity, ..particle(look, 2.0) });
        }
        for _ in 0..60 {
            pool.advance(1.0 / 60.0);
        }
        assert_eq!(pool.all.len(), 8);
        for particle in pool.all {
            assert_eq!(particle.position.y < 2.0, particle.look != ParticleLook::Streak, "{particle:?}");
            assert!(particle.look == ParticleLook::Streak || particle.position.x > 0.5, "it goes on along the deck: {particle:?}");
        }
    }

    #[test]
    fn sparks_and_dust_fall_and_smoke_and_streaks_do_not() {
        for (look, least, most) in [
            (ParticleLook::Spark, 1.0, 1.5),
            (ParticleLook::Dust, 0.2, 0.5),
            (ParticleLook::Plume, 0.0, 0.0),
            (ParticleLook::Streak, 0.0, 0.0),
        ] {
            for frames in [15, 60, 240] {
                let mut pool = Particles::default();
                pool.add(particle(look, 2.0));
                (0..frames).for_each(|_| pool.advance(1.0 / f64::from(frames)));
                let fallen = pool.all[0].position.y;
                assert!((least..=most).contains(&fallen), "{look:?} at {frames} frames a second: {fallen} m in a second");
            }
        }
    }

    #[test]
    fn the_pool_never_exceeds_its_cap_and_empties_with_age() {
        let mut pool = Particles::default();
        for _ in 0..2 * MOST {
            pool.add(particle(ParticleLook::Dust, 0.5));
        }
        assert_eq!(pool.all.len(), MOST);
        pool.advance(0.3);
        assert_eq!(pool.all.len(), MOST);
        pool.advance(0.3);
        assert!(pool.all.is_empty());
    }

    /// A deck 4 m wide and 0.2 m thick, its top at y = 2.
    fn deck(sides: Sides) -> Barriers {
        let bounds = Aabb::new(DVec2::new(3.0, 2.0), DVec2::new(7.0, 2.2));
        let surface = SurfaceDef { sides, ..SurfaceDef::fixed(bounds, Material::STEEL) };
        let world = World::new(WorldDef { surfaces: vec![surface], ..WorldDef::default() }).expect("a valid world");
        Barriers::new(&world, &Aabb::new(DVec2::ZERO, DVec2::splat(10.0)))
    }

    #[test]
    fn a_path_ends_at_the_deck_however_long_it_is() {
        let deck = deck(Sides::ALL);
        for (from, to) in [((5.0, 1.0), (5.0, 3.0)), ((5.0, 1.0), (5.0, 1e6)), ((1.0, 0.5), (6.0, 4.0)), ((5.0, 2.0), (5.5, 2.1))] {
            let stop = deck.stop(DVec2::from(from), DVec2::from(to)).expect("it meets the deck");
            assert!(stop.1 == 1 && (stop.0.y - 2.0).abs() < 2.0 * CLEAR && stop.0.y < 2.0, "{stop:?}");
        }
        for (from, to) in
            [((5.0, 1.0), (5.0, 1.9)), ((1.0, 1.0), (1.0, 9.0)), ((5.0, 2.1), (5.0, 9.0)), ((5.0, 1.999), (9.0, 1.999))]
        {
            assert_eq!(deck.stop(DVec2::from(from), DVec2::from(to)), None);
        }
        let room = deck.room(DVec2::new(5.0, 1.15), DVec2::Y, 2.0);
        assert!((room - 0.85).abs() < 2.0 * CLEAR, "{room}");
        assert_eq!(deck.room(DVec2::new(5.0, 1.15), DVec2::NEG_Y, 2.0), 2.0);
    }

    #[test]
    fn a_one_way_deck_stops_what_comes_from_its_side_alone() {
        let deck = deck(Sides::TOP);
        assert!(deck.stop(DVec2::new(5.0, 1.0), DVec2::new(5.0, 3.0)).is_some());
        assert!(deck.stop(DVec2::new(5.0, 3.0), DVec2::new(5.0, 1.0)).is_none());
    }
}
