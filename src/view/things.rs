//! Objects and the ship with its flame: nothing that moves looks like the static world. Its legs give way under a landing; a gentle one is praised.
//! The wreck of a lost ship: pieces that fly, fall and bounce by the engine's own laws, in a world of their own: the game does not change.

use super::art::{self, Pictures, Tile};
use super::{camera::Viewport, theme, zones::diamond};
use crate::draw::layout::{Area, DETAILS, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{Game, GhostPose, SHIP};
use crate::level::{Level, Look, Object, SHIP_HALF};
use crate::physics::{Aabb, BodyDef, BodyId, DVec2, Event, ForceKind, Obstacle, World, WorldDef};
use std::f64::consts::PI;

/// Plain movable objects: brighter than everything at rest.
const PLAIN: Colour = Colour::hex(0xB9C6DA);
/// Length of the fully grown flame, m.
const FLAME: f64 = 1.25;
/// The least length of a flame close to a deck, m, and the most that it widens there.
const FLAME_LEAST: f64 = 0.12;
const FLAME_SPREAD: f64 = 1.7;
/// Roots of the two flames of reverse thrust on the nose, m from the centre (to the side, forwards).
const RETRO: (f64, f64) = (0.36, 0.50);

#[derive(Clone, Copy)]
pub struct Brushes<'a> {
    pub pictures: &'a Pictures,
    pub view: &'a Viewport,
    pub canvas: &'a Canvas,
}

/// An object around `centre` (m): its picture, or a box or ball; keys in their colour, with glow and sign; `light` multiplies other colours.
pub fn draw_object(object: &Object, centre: DVec2, light: Colour, brushes: Brushes<'_>) {
    let Brushes { pictures, view, canvas } = brushes;
    let bounds = Aabb::around(centre, object.size * 0.5);
    if !bounds.touches(&view.visible(), 1.0) {
        return;
    }
    let area = view.exact(&bounds);
    let key = object.key.map(Colour::of);
    let round = object.circular || object.look == Look::Ball;
    match key {
        Some(colour) if round => {
            art::draw(canvas, Tile::Glow, Area::around(area.centre(), area.size * 1.3 + 40.0), 0.0, colour.faded(0.75))
        }
        Some(colour) => art::halo(canvas, area, 20.0, colour.faded(0.55)),
        None => {}
    }
    let picture = match &object.look {
        Look::Image(path) => pictures.get(path),
        Look::Box | Look::Ball => None,
    };
    let plain = Colour::new(PLAIN.r * light.r, PLAIN.g * light.g, PLAIN.b * light.b, 1.0);
    match picture {
        Some(image) => canvas.image(image, area, if key.is_some() { Colour::WHITE } else { light }),
        None if round => ball(canvas, area, key.unwrap_or(plain)),
        None => crate_box(canvas, area, key.unwrap_or(plain)),
    }
    if key.is_some() && picture.is_none() {
        diamond(canvas, area.centre(), area.size.x.min(area.size.y) * 0.20, Colour::WHITE);
    }
}

fn crate_box(canvas: &Canvas, area: Area, colour: Colour) {
    let dark = shaded(colour, 0.45);
    let frame = (area.size.x.min(area.size.y) * 0.14).clamp(1.5, 6.0);
    canvas.rectangle(area, shaded(colour, 0.78));
    let (a, b) = (area.min + frame, area.max() - frame);
    canvas.line(a, b, frame * 0.8, shaded(colour, 0.6));
    canvas.line(Vec2::new(b.x, a.y), Vec2::new(a.x, b.y), frame * 0.8, shaded(colour, 0.6));
    canvas.rectangle_edge(area, frame, colour);
    canvas.rectangle_edge(area, 1.0, dark);
}

fn ball(canvas: &Canvas, area: Area, colour: Colour) {
    let half = area.size / 2.0;
    let outline = |scale: f32, offset: Vec2| ellipse(Area::around(area.centre() + offset, area.size * scale));
    canvas.convex(&outline(1.0, Vec2::ZERO), shaded(colour, 0.42));
    canvas.convex(&outline(0.9, Vec2::ZERO), shaded(colour, 0.82));
    canvas.convex(&outline(0.66, half * Vec2::new(-0.14, -0.16)), colour);
    canvas.convex(&outline(0.18, half * Vec2::new(-0.34, -0.40)), Colour::WHITE.faded(0.85));
}

fn shaded(colour: Colour, light: f32) -> Colour {
    Colour::new(colour.r * light, colour.g * light, colour.b * light, colour.a)
}

/// Tilted further than by this cosine the ship does not stand on its legs.
const UPRIGHT: f64 = 0.9;

#[derive(Clone, Copy, Debug)]
pub struct ShipPose {
    /// m.
    pub centre: DVec2,
    /// Clockwise, degrees.
    pub angle: f64,
    /// Compression of its legs, as a part of its height.
    pub squash: f64,
    /// Multiplies its colours.
    pub light: Colour,
    /// Free distance of its flame from the ship's centre, m.
    pub room: f64,
}

/// The plume has grown to `strength`, out of the tail (`way` 1) or of the nose (−1); `flicker` (0 … 1) varies the flame.
pub fn draw_ship(ship: &ShipPose, (strength, way): (f64, f64), flicker: f64, view: &Viewport, canvas: &Canvas) {
    let (centre, rotation) = (ship.centre, ship.angle.to_radians());
    let (sin, cos) = rotation.sin_cos();
    let (nose, right) = (DVec2::new(sin, -cos), DVec2::new(cos, sin));
    let flames: &[_] = if way > 0.0 { &[(0.0, 0.80, 1.0)] } else { &[(-RETRO.0, RETRO.1, 0.55), (RETRO.0, RETRO.1, 0.55)] };
    if strength > 0.0 {
        for &(side, out, size) in flames {
            let whole = FLAME * size * strength * (0.85 + 0.15 * flicker);
            // A deck cuts the flame off, and it spreads.
            let length = whole.min((ship.room - out).max(FLAME_LEAST));
            let spread = (whole / length).sqrt().min(FLAME_SPREAD);
            let middle = centre + right * side - nose * (out * way) - nose * (way * length * 0.5);
            let glow = Area::around(view.point(middle), Vec2::splat(view.length(2.2 * length)));
            art::draw(canvas, Tile::Glow, glow, 0.0, Colour::hex(0xFF9F1C).faded(0.35));
            let turn = if way > 0.0 { rotation } else { rotation + PI };
            let size = Vec2::new(view.length(0.75 * size * spread), view.length(length));
            art::draw(canvas, Tile::Flame, Area::around(view.point(middle), size), turn as f32, Colour::WHITE);
        }
    }
    // Only the top comes down, and only while the ship stands on its legs.
    let squash = ship.squash * ((cos - UPRIGHT) / (1.0 - UPRIGHT)).max(0.0);
    let height = 2.0 * SHIP_HALF.y * (1.0 - squash);
    let standing = centre + DVec2::new(0.0, SHIP_HALF.y * squash);
    let size = Vec2::new(view.length(2.0 * SHIP_HALF.y), view.length(height));
    art::draw(canvas, Tile::Ship, Area::around(view.point(standing), size), rotation as f32, ship.light);
}

/// A ghost is pale and blue, and a ring goes round it: clear enough to follow, too faint to pass for the ship.
const PALE: Colour = Colour::new(0.72, 0.84, 1.0, 0.7);
/// Opacity of its ring, its outline and its name.
const GHOST_EDGE: f32 = 0.75;
/// Radius of the ring, in halves of the ship.
const GHOST_RING: f64 = 1.2;

/// A ship of another flight: pale, without light or flame, with its name below it.
pub fn draw_ghost(name: Option<&str>, pose: GhostPose, Brushes { view, canvas, .. }: Brushes<'_>) {
    let size = Vec2::splat(view.length(2.0 * SHIP_HALF.y));
    art::draw(canvas, Tile::Ship, Area::around(view.point(pose.centre), size), pose.angle.to_radians() as f32, PALE);
    canvas.ring(view.point(pose.centre), view.length(SHIP_HALF.y * GHOST_RING), 1.5, PALE.faded(GHOST_EDGE));
    if let Some(name) = name {
        let below = view.point(pose.centre + DVec2::new(0.0, SHIP_HALF.y * GHOST_RING + 0.4));
        canvas.text(name, below, Style::new(DETAILS, theme::text().faded(0.85)).centred().middle());
    }
}

/// An object of another flight: its pale outline, with its name below it.
pub fn draw_ghost_object(name: Option<&str>, (object, centre): (&Object, DVec2), Brushes { view, canvas, .. }: Brushes<'_>) {
    let area = view.exact(&Aabb::around(centre, object.size * 0.5));
    let (fill, edge) = (PALE.faded(0.30), Colour::new(PALE.r, PALE.g, PALE.b, 1.0));
    let corners: Vec<Vec2> = if object.circular || object.look == Look::Ball { ellipse(area) } else { area.corners().to_vec() };
    canvas.convex(&corners, fill);
    canvas.convex_edge(&corners, 1.5, edge);
    if let Some(name) = name {
        let below = view.point(centre + DVec2::new(0.0, object.size.y / 2.0)) + Vec2::new(0.0, canvas.line_height(DETAILS) * 0.6);
        canvas.text(name, below, Style::new(DETAILS, theme::text().faded(0.85)).centred().middle());
    }
}

/// The corners of an ellipse that fills an area.
pub fn ellipse(area: Area) -> Vec<Vec2> {
    const SIDES: usize = 40;
    let turn = |i: usize| Vec2::from_angle(std::f32::consts::TAU * i as f32 / SIDES as f32);
    (0..SIDES).map(|i| area.centre() + turn(i) * area.size / 2.0).collect()
}

/// The least flight before a landing, s: a box that tips to rest is no landing.
const FLOWN: f64 = 0.4;
/// A slower landing is gentle, m/s.
pub const GENTLE: f64 = 2.0;
/// Time in which the legs straighten, s; the speed that presses them down fully, m/s; and that depth, of the height.
const SPRING: f64 = 0.22;
const FULL: f64 = 8.0;
const DEPTH: f64 = 0.14;

/// Whether the ship flies, and the compression of its legs.
#[derive(Clone, Debug, Default)]
pub struct Touchdown {
    /// Ticks since the last touch.
    flown: u64,
    /// The last landing's speed (m/s) and age (s).
    last: Option<(f64, f64)>,
}

impl Touchdown {
    /// Takes up a tick; returns the place (m) and the speed (m/s) of its landing.
    pub fn after_tick(&mut self, game: &Game) -> Option<(DVec2, f64)> {
        let flown = self.flown as f64 / game.tick_rate();
        let landing = landing(game.world().events()).filter(|_| flown >= FLOWN);
        self.flown = if landing.is_some() || touches(game) { 0 } else { self.flown + 1 };
        if let Some((_, speed)) = landing {
            self.last = Some((speed, 0.0));
        }
        landing
    }

    pub fn advance(&mut self, frame_time: f64) {
        self.last = self.last.map(|(speed, age)| (speed, age + frame_time)).filter(|(_, age)| *age < SPRING);
    }

    /// Compression of the ship as a part of its height, 0 … 0.14.
    pub fn squash(&self) -> f64 {
        self.last.map_or(0.0, |(speed, age)| DEPTH * (speed / FULL).min(1.0) * (PI * (age / SPRING).sqrt()).sin())
    }
}

fn touches(game: &Game) -> bool {
    let forces = game.world().forces(SHIP);
    forces.forces().iter().any(|force| matches!(force.kind, ForceKind::Reaction | ForceKind::Push))
}

/// The hardest hit of the ship from above in a tick with these events.
fn landing(events: &[Event]) -> Option<(DVec2, f64)> {
    let hits = events.iter().filter_map(|event| match *event {
        Event::Impact { a, b, point, speed, normal } => {
            // The normal points away from the hit body: up, where the ship is `a`.
            let up = match b {
                _ if a == SHIP => -normal.y,
                Obstacle::Body(SHIP) => normal.y,
                _ => 0.0,
            };
            (up > 0.5).then_some((point, speed))
        }
        Event::Crushed { .. } | Event::Snapped { .. } | Event::Hooked { .. } => None,
    });
    hits.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Pause before the ship breaks, s.
const HIT_STOP: f64 = 0.09;
/// Pieces along each axis.
const PIECES: u32 = 3;
/// The share of its cell that a piece fills: pieces do not begin in each other.
const FILLED: f64 = 0.9;
/// Speed of the pieces away from the ship's middle, m/s a metre, and the share of the ship's speed that they keep.
const BURST: f64 = 6.0;
const KEPT: f64 = 0.6;
/// s; and the most ticks a frame: after a hitch pieces may skip time, but must not freeze the game.
const TICK: f64 = 1.0 / 120.0;
const MOST_TICKS: u32 = 8;

pub struct Wreck {
    world: World,
    /// Since the ship was lost, s.
    age: f64,
    /// Time not yet simulated, s.
    left: f64,
}

impl Wreck {
    /// The pieces of a game's ship; `None` where there is no room for them.
    pub fn new(game: &Game, ship: BodyId) -> Option<Self> {
        let body = game.world().body(ship);
        Some(Self { world: World::new(definition(game.level(), body.position, body.velocity)).ok()?, age: 0.0, left: 0.0 })
    }

    pub fn advance(&mut self, frame_time: f64) {
        self.age += frame_time;
        if self.is_whole() {
            return;
        }
        self.left = (self.left + frame_time).min(f64::from(MOST_TICKS) * TICK);
        while self.left >= TICK {
            self.left -= TICK;
            self.world.step(TICK);
        }
    }

    pub fn is_whole(&self) -> bool {
        self.age < HIT_STOP
    }

    pub fn draw(&self, view: &Viewport, canvas: &Canvas) {
        for (i, body) in self.world.bodies().iter().enumerate() {
            let area = view.rect(&body.bounds());
            canvas.rectangle(area, colour(i as u32));
            canvas.rectangle_edge(area, 1.0, theme::ground());
        }
    }
}

fn colour(piece: u32) -> Colour {
    match (piece % PIECES, piece / PIECES) {
        (1, 0) => theme::accent(),
        (_, 0) => Colour::WHITE,
        (1, 1) => Colour::hex(0x6FB7E8),
        (_, 1) => Colour::hex(0xE6EBF2),
        _ => theme::solid_top(),
    }
}

fn definition(level: &Level, centre: DVec2, velocity: DVec2) -> WorldDef {
    let cell = SHIP_HALF * 2.0 / f64::from(PIECES);
    let piece = |i: u32| {
        let from_middle = (DVec2::new(f64::from(i % PIECES), f64::from(i / PIECES)) - 0.5 * f64::from(PIECES - 1)) * cell;
        BodyDef {
            position: centre + from_middle,
            // Each a little differently, so that the wreck has no symmetry.
            velocity: velocity * KEPT + from_middle * BURST * (1.0 + 0.25 * f64::from(i * 5 % 7)),
            half: cell * 0.5 * FILLED,
            mass: level.player.mass / f64::from(PIECES * PIECES),
            restitution: 0.4,
            ..BodyDef::default()
        }
    };
    WorldDef { bodies: (0..PIECES * PIECES).map(piece).collect(), links: Vec::new(), ..level.world_def() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::BodyId;

    fn hit(a: u32, b: Obstacle, normal: DVec2) -> Event {
        Event::Impact { a: BodyId(a), b, point: DVec2::ZERO, normal, speed: 3.0 }
    }

    #[test]
    fn a_landing_is_what_hits_the_ship_from_below() {
        let floor = Obstacle::Surface(0);
        assert_eq!(landing(&[hit(0, floor, DVec2::NEG_Y)]).map(|(_, speed)| speed), Some(3.0));
        assert!(landing(&[hit(0, floor, DVec2::Y), hit(0, floor, DVec2::X), hit(1, floor, DVec2::NEG_Y)]).is_none());
        assert!(landing(&[hit(1, Obstacle::Body(SHIP), DVec2::Y)]).is_some(), "it lands on a crate");
    }

    #[test]
    fn the_legs_straighten_again() {
        let mut touchdown = Touchdown { flown: 0, last: Some((100.0, 0.0)) };
        let mut deepest: f64 = 0.0;
        for _ in 0..30 {
            touchdown.advance(0.01);
            deepest = deepest.max(touchdown.squash());
        }
        assert!(deepest > 0.05 && deepest <= DEPTH);
        assert_eq!(touchdown.squash(), 0.0);
    }

    #[test]
    fn the_pieces_take_the_ships_mass_fall_and_come_to_rest_inside_the_level() {
        let level = crate::level::fixture();
        let mut world = World::new(definition(&level, level.player.position, DVec2::new(4.0, -9.0))).unwrap();
        let mass: f64 = world.bodies().iter().map(|body| body.mass).sum();
        assert!((mass - level.player.mass).abs() < 1e-9);
        for _ in 0..1200 {
            world.step(TICK);
        }
        for body in world.bodies() {
            assert!(body.velocity.length() < 0.1 && level.bounds().contains(&body.bounds(), 1e-6), "{body:?}");
        }
    }
}
