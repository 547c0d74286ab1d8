//! The part of the level in the window: pure arithmetic from the ship, the level and the canvas to one [`Viewport`].
//! The objects that the ship has set in motion: the camera keeps them in view while they move.

use crate::draw::layout::{Area, Vec2};
use crate::game::{Game, SHIP};
use crate::physics::{Aabb, BodyId, DVec2, Event, LinkEnd, Obstacle, Source};

/// Time constant of the camera's approach to the ship, s. Longer lags behind, shorter jerks at every bump.
const EASE_TIME: f64 = 0.12;
/// The camera looks ahead by the way that the ship flies in this time, s, at most so far, m. Larger: more in view; the ship strays from the middle.
const AHEAD_TIME: f64 = 0.5;
const AHEAD_MOST: DVec2 = DVec2::new(9.0, 5.0);
/// Time constant of a turn to the ship's direction, s: slow enough that a bump does not throw the view about.
const AHEAD_EASE: f64 = 0.6;
/// Below this speed the camera looks at the ship itself, m/s: a drifting, turning ship would make it sway.
const AHEAD_FROM: f64 = 2.0;
/// The least distance from the window's edge to the ship's centre, m: below half the ship it could leave the screen while the camera eases.
const SHIP_MARGIN: f64 = 3.0;
/// The most that a level smaller than the window is magnified to fill it.
const MAX_ZOOM: f64 = 1.5;
/// Magnification of a completed level's view, and its time constant, s.
const CLOSE: f64 = 1.35;
const CLOSE_EASE: f64 = 0.45;
/// Margin around the box that the view fits, m: room for arrows.
pub(super) const FIT_MARGIN: f64 = 4.0;
/// Bodies stay at least this far inside of a view that fits them, at any speed, m.
pub(super) const FIT_LEAST: f64 = 1.0;
/// Time constants of the turn from following to fitting, of the approach to the fitted box, and of the zoom, s.
const FIT_EASE: f64 = 0.2;
const FIT_CLOSES: f64 = 0.5;
const ZOOM_EASE: f64 = 0.08;
/// The view widens by this factor at this speed and above, m/s, beginning at the lower one; its time constant, s.
const WIDER: f64 = 0.78;
const WIDENS: [f64; 2] = [8.0, 24.0];
const WIDER_EASE: f64 = 0.9;

/// The point that the camera looks at: it eases after the ship, a little ahead of it, regardless of the window and the level's edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The ship's place, eased, m.
    ship: DVec2,
    /// The offset ahead of that, m.
    ahead: DVec2,
    /// Magnification beyond the usual.
    pub closeness: f64,
    /// The fitted box, eased, m; `None` before the first fit.
    fitted: Option<Aabb>,
    /// 0: follows; 1: fits.
    fits: f64,
    /// The ship's speed, eased, m/s.
    speed: f64,
    /// Scale of the picture, 1 usual; `None` before the first frame.
    zoom: Option<f64>,
}

impl Camera {
    /// Looks at the ship's centre (m) at once.
    pub const fn new(ship: DVec2) -> Self {
        Self { ship, ahead: DVec2::ZERO, closeness: 1.0, fitted: None, fits: 0.0, speed: 0.0, zoom: None }
    }

    /// Eases towards the ship's centre (m) and, from there, ahead by its velocity (m/s); the frame rate does not change the path.
    pub fn follow(&mut self, ship: DVec2, velocity: DVec2, frame_time: f64) {
        let share = |time: f64| 1.0 - (-frame_time.max(0.0) / time).exp();
        let speed = velocity.length();
        self.speed += (speed - self.speed) * share(WIDER_EASE);
        let ahead = velocity * (AHEAD_TIME * (1.0 - AHEAD_FROM / speed.max(AHEAD_FROM)));
        self.ahead += (ahead.clamp(-AHEAD_MOST, AHEAD_MOST) - self.ahead) * share(AHEAD_EASE);
        self.ship += (ship - self.ship) * share(EASE_TIME);
    }

    /// Turns to the box to be fitted (m), or away where there is none, and zooms; at once in its first frame, not at all while no time passes.
    pub fn turn(&mut self, fit: Option<Aabb>, zoom: f64, frame_time: f64) {
        let Some(before) = self.zoom else {
            (self.fitted, self.fits, self.zoom) =
                (fit.map(|bounds| grown(&bounds, FIT_MARGIN)), f64::from(u8::from(fit.is_some())), Some(zoom));
            return;
        };
        if frame_time <= 0.0 {
            return;
        }
        let share = |time: f64| 1.0 - (-frame_time.max(0.0) / time).exp();
        self.zoom = Some(before * (zoom / before).powf(share(ZOOM_EASE)));
        if let Some(bounds) = fit {
            let (wanted, part) = (grown(&bounds, FIT_MARGIN), share(FIT_CLOSES));
            // A box of long ago is forgotten.
            let now = self.fitted.filter(|_| self.fits > 0.05).unwrap_or(wanted);
            let eased = Aabb::new(now.min.lerp(wanted.min, part), now.max.lerp(wanted.max, part));
            self.fitted = Some(eased.union(&grown(&bounds, FIT_LEAST)));
        }
        self.fits += (f64::from(u8::from(fit.is_some())) - self.fits) * share(FIT_EASE);
    }

    /// The view of a level of that size (m) with `kept` (m) in it; `metre` is canvas units a metre at the usual magnification.
    pub fn viewport(&self, kept: DVec2, level: DVec2, metre: f64, window: CanvasWindow) -> Viewport {
        let usual = Viewport::new(self.focus(), kept, level, metre, window);
        let (view, kept) = match &self.fitted {
            Some(bounds) if self.fits > 1e-3 => (usual.towards(bounds, self.fits), kept.lerp(bounds.centre(), self.fits)),
            _ => (usual, kept),
        };
        view.zoomed(kept, self.zoom.unwrap_or(1.0) * self.widening()).closer(kept, self.closeness)
    }

    fn widening(&self) -> f64 {
        let part = ((self.speed - WIDENS[0]) / (WIDENS[1] - WIDENS[0])).clamp(0.0, 1.0);
        1.0 + (WIDER - 1.0) * part * part * (3.0 - 2.0 * part)
    }

    /// Closes in on the ship after a success.
    pub fn close_in(&mut self, frame_time: f64) {
        self.closeness += (CLOSE - self.closeness) * (1.0 - (-frame_time.max(0.0) / CLOSE_EASE).exp());
    }

    /// The point that the camera looks at, m.
    pub fn focus(&self) -> DVec2 {
        self.ship + self.ahead
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CanvasWindow {
    /// Canvas units.
    pub size: DVec2,
    /// Canvas units a physical pixel.
    pub pixel: f64,
}

/// The map from metres of the level to the canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Canvas units a metre.
    pub scale: f64,
    /// The level's top left corner lies at minus this: whole physical pixels, so that everything static moves as one.
    origin: DVec2,
    /// m.
    level: DVec2,
    /// The view may show this much outside of the level, m: room for the arrows of bodies at an edge, where the view is fitted.
    beyond: f64,
    window: CanvasWindow,
}

impl Viewport {
    /// Looks at `focus` (m), but keeps the ship on the screen and the outside of the level off it. A level that is smaller than the window along an
    /// axis even when magnified 1.5 times is centred along it. `level` is its size (m), `metre` canvas units a metre at the usual magnification.
    pub fn new(focus: DVec2, ship: DVec2, level: DVec2, metre: f64, window: CanvasWindow) -> Self {
        let zoom = (window.size / (level * metre)).max_element().clamp(1.0, MAX_ZOOM);
        let usual = Self { scale: metre * zoom, origin: DVec2::ZERO, level, beyond: 0.0, window };
        usual.at(usual.scale, focus, ship)
    }

    /// With a box (m) in its middle, as large as it fits.
    pub fn of(bounds: &Aabb, level: DVec2, window: CanvasWindow) -> Self {
        let scale = (window.size / bounds.size()).min_element();
        let view = Self { scale, origin: DVec2::ZERO, level, beyond: 0.0, window };
        Self { origin: view.snap(bounds.centre() * scale - window.size * 0.5), ..view }
    }

    /// Magnified by `factor` around the ship (m), whose place stays but for the window's and the level's edges.
    pub fn closer(self, ship: DVec2, factor: f64) -> Self {
        let scale = self.scale * factor;
        self.at(scale, ship + ((self.origin + self.window.size * 0.5) / self.scale - ship) / factor, ship)
    }

    /// Turned by a part (0 … 1) towards a view that has a box (m) in it, no closer than usual.
    pub fn towards(self, bounds: &Aabb, part: f64) -> Self {
        let fitting = (self.window.size / bounds.size()).min_element().clamp(self.widest(), self.scale);
        let middle = ((self.origin + self.window.size * 0.5) / self.scale).lerp(bounds.centre(), part);
        Self { beyond: FIT_MARGIN * part, ..self }.at(self.scale * (fitting / self.scale).powf(part), middle, middle)
    }

    /// Magnified by `factor`, down to the whole level in view; a point (m) stays but for the window's and the level's edges.
    pub fn zoomed(self, kept: DVec2, factor: f64) -> Self {
        let scale = (self.scale * factor).max(self.widest());
        if scale == self.scale { self } else { self.closer(kept, scale / self.scale) }
    }

    /// The scale with the whole level in view, at most the present one.
    fn widest(&self) -> f64 {
        (self.window.size / self.level).min_element().min(self.scale)
    }

    /// The view of that scale with a point as near to its middle as the ship and the level's edges allow.
    fn at(self, scale: f64, middle: DVec2, ship: DVec2) -> Self {
        let Self { level, window, beyond, .. } = self;
        let half = window.size / scale * 0.5;
        let reach = (half - SHIP_MARGIN).max(DVec2::ZERO);
        let centre = middle.clamp(ship - reach, ship + reach);
        let along = |centre: f64, half: f64, level: f64| {
            let half = half - beyond;
            if 2.0 * half >= level { level * 0.5 } else { centre.clamp(half, level - half) }
        };
        let centre = DVec2::new(along(centre.x, half.x, level.x), along(centre.y, half.y, level.y));
        Self { scale, origin: self.snap(centre * scale - window.size * 0.5), ..self }
    }

    /// Moved by `offset` canvas units. Where that would show the outside of the level the view moves the other way.
    pub fn shaken(self, offset: DVec2) -> Self {
        let beyond = self.beyond * self.scale;
        let along = |origin: f64, offset: f64, room: f64| {
            let (moved, least, most) = (origin + offset, -beyond, room + beyond);
            if most <= least || (least..=most).contains(&moved) { moved } else { (origin - offset).clamp(least, most) }
        };
        let room = self.level * self.scale - self.window.size;
        let offset = self.snap(offset);
        Self { origin: DVec2::new(along(self.origin.x, offset.x, room.x), along(self.origin.y, offset.y, room.y)), ..self }
    }

    /// In canvas units.
    pub fn length(&self, metres: f64) -> f32 {
        (metres * self.scale) as f32
    }

    /// Canvas units.
    pub fn size(&self) -> Vec2 {
        self.window.size.as_vec2()
    }

    /// A point of the level (m) on the canvas, from the window's top left corner.
    pub fn point(&self, metres: DVec2) -> Vec2 {
        (metres * self.scale - self.origin).as_vec2()
    }

    /// The inverse of [`Viewport::point`], m.
    pub fn metres(&self, point: Vec2) -> DVec2 {
        (point.as_dvec2() + self.origin) / self.scale
    }

    /// A box of the level on the canvas, its edges on whole physical pixels so that adjoining boxes leave no seam.
    pub fn rect(&self, bounds: &Aabb) -> Area {
        let min = self.snap(bounds.min * self.scale - self.origin).as_vec2();
        Area { min, size: self.snap(bounds.max * self.scale - self.origin).as_vec2() - min }
    }

    /// A moving box on the canvas, not rounded to pixels: it glides.
    pub fn exact(&self, bounds: &Aabb) -> Area {
        let min = self.point(bounds.min);
        Area { min, size: self.point(bounds.max) - min }
    }

    /// m.
    pub fn level(&self) -> Aabb {
        Aabb::new(DVec2::ZERO, self.level)
    }

    /// The space in the window, m.
    pub fn visible(&self) -> Aabb {
        Aabb::new(self.origin / self.scale, (self.origin + self.window.size) / self.scale)
    }

    fn snap(&self, point: DVec2) -> DVec2 {
        (point / self.window.pixel).round() * self.window.pixel
    }
}

fn grown(bounds: &Aabb, by: f64) -> Aabb {
    Aabb::new(bounds.min - by, bounds.max + by)
}

/// A slower object rests, m/s; it is forgotten after this time, s.
const RESTS: f64 = 0.3;
const FORGOTTEN: f64 = 1.0;

/// Each with the time for which it has rested, s.
#[derive(Clone, Debug, Default)]
pub struct StirredObjects(Vec<(BodyId, f64)>);

impl StirredObjects {
    /// Takes up a tick: an object that the ship, or one of these objects, hits, pushes or pulls by a link is one of them.
    pub fn after_tick(&mut self, game: &Game) {
        let world = game.world();
        let hits = world.events().iter().filter_map(|event| match *event {
            Event::Impact { a, b: Obstacle::Body(b), .. } => Some((a, b)),
            _ => None,
        });
        let pulls = world.links().iter().filter(|link| link.acts()).filter_map(|link| match link.def().to {
            LinkEnd::Body(b) => Some((link.def().body, b)),
            LinkEnd::Place(_) => None,
        });
        for (a, b) in hits.chain(pulls) {
            for (by, other) in [(a, b), (b, a)] {
                if by == SHIP || self.has(by) {
                    self.add(other);
                }
            }
        }
        for force in world.forces(SHIP).forces() {
            if let Source::Body(body) = force.source {
                self.add(body);
            }
        }
        let tick = 1.0 / game.tick_rate();
        for (body, rested) in &mut self.0 {
            *rested = if world.body(*body).velocity.length() > RESTS { 0.0 } else { *rested + tick };
        }
        self.0.retain(|(_, rested)| *rested < FORGOTTEN);
    }

    fn has(&self, body: BodyId) -> bool {
        self.0.iter().any(|(known, _)| *known == body)
    }

    fn add(&mut self, body: BodyId) {
        if body != SHIP && !self.has(body) {
            // Contact alone moves nothing.
            self.0.push((body, FORGOTTEN * 0.5));
        }
    }

    /// The bodies that have moved by it, in the order in which they began.
    pub fn moving(&self) -> impl Iterator<Item = BodyId> {
        self.0.iter().filter(|(_, rested)| *rested < FORGOTTEN * 0.5).map(|(body, _)| *body)
    }

    /// The box around the ship and as many of them, nearest first, as fit into `room` (m), by their drawn centres, m. `None` without any.
    pub fn framed(&self, game: &Game, room: DVec2, centre: impl Fn(BodyId) -> DVec2) -> Option<Aabb> {
        let area = |body: BodyId| Aabb::around(centre(body), game.world().body(body).half);
        let ship = area(SHIP);
        let mut others: Vec<_> = self.moving().map(area).collect();
        others.sort_by(|a, b| a.centre().distance(ship.centre()).total_cmp(&b.centre().distance(ship.centre())));
        let mut framed = None;
        for other in others {
            let both = framed.unwrap_or(ship).union(&other);
            if both.size().cmpgt(room).any() {
                break;
            }
            framed = Some(both);
        }
        framed
    }
}
