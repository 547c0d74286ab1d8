//! Which part of the level the window shows: pure arithmetic from the ship, the level and the canvas to one [`Viewport`].

use crate::draw::layout::{Area, Vec2};
use crate::physics::{Aabb, DVec2};

/// Time in which the camera closes in on the ship to 1/e of the distance, s. Longer swims behind, shorter jerks at every bump.
const EASE_TIME: f64 = 0.12;
/// How far ahead of the ship the camera looks: as far as it flies in this time, s, but so far at most, m across and down. More shows
/// more of what comes, but the ship itself strays from the middle.
const AHEAD_TIME: f64 = 0.5;
const AHEAD_MOST: DVec2 = DVec2::new(9.0, 5.0);
/// Time in which it turns its look to where the ship flies now, s: slow enough that a bump does not throw it about.
const AHEAD_EASE: f64 = 0.6;
/// Slower than this it looks at the ship itself, m/s: what drifts and turns would make it sway.
const AHEAD_FROM: f64 = 2.0;
/// How far from the window's edge the ship's centre stays at least, m (in a window that has the room). Below half the ship it
/// could leave the screen while the camera still eases.
const SHIP_MARGIN: f64 = 3.0;
/// How much a level smaller than the window is magnified at most so that nothing outside of it is shown.
const MAX_ZOOM: f64 = 1.5;
/// When a level is done, the camera closes in on the ship: by how much at most, and the time in which it does to 1/e, s.
const CLOSE: f64 = 1.35;
const CLOSE_EASE: f64 = 0.45;
/// Around what is fitted into the window, m: room for arrows.
const FIT_MARGIN: f64 = 4.0;
/// What moves stays so far inside of a view that is fitted to it, however fast it goes, m.
const FIT_LEAST: f64 = 1.0;
/// Times in which the view turns from following to fitting, in which it closes in on what is fitted, and in which it zooms, to 1/e, s.
const FIT_EASE: f64 = 0.2;
const FIT_CLOSES: f64 = 0.5;
const ZOOM_EASE: f64 = 0.08;

/// The point that the camera looks at: it eases after the ship, a little ahead of it, and knows nothing of the window or the level's
/// edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where the ship is, eased, m.
    ship: DVec2,
    /// How far ahead of that it looks, m.
    ahead: DVec2,
    /// How much it magnifies beyond the usual.
    closeness: f64,
    /// What is fitted into the window, eased, m; nothing while nothing ever was.
    fitted: Option<Aabb>,
    /// How far the view has turned from following (0) to fitting (1).
    fits: f64,
    /// How many times as large as usual everything is drawn; not known before the first frame.
    zoom: Option<f64>,
}

impl Camera {
    /// A camera that looks at the ship's centre (m) at once.
    pub const fn new(ship: DVec2) -> Self {
        Self { ship, ahead: DVec2::ZERO, closeness: 1.0, fitted: None, fits: 0.0, zoom: None }
    }

    /// Stands back to the usual distance.
    pub const fn open_up(&mut self) {
        self.closeness = 1.0;
    }

    /// Eases towards the ship's centre (m) and, from there, ahead by its velocity (m/s), during `frame_time` seconds; the way does not
    /// depend on the frame rate.
    pub fn follow(&mut self, ship: DVec2, velocity: DVec2, frame_time: f64) {
        let share = |time: f64| 1.0 - (-frame_time.max(0.0) / time).exp();
        let speed = velocity.length();
        let ahead = velocity * (AHEAD_TIME * (1.0 - AHEAD_FROM / speed.max(AHEAD_FROM)));
        self.ahead += (ahead.clamp(-AHEAD_MOST, AHEAD_MOST) - self.ahead) * share(AHEAD_EASE);
        self.ship += (ship - self.ship) * share(EASE_TIME);
    }

    /// Turns to what is to be fitted into the window (m), or away from it where that is nothing, and zooms; at once in its first frame.
    pub fn turn(&mut self, fit: Option<Aabb>, zoom: f64, frame_time: f64) {
        let Some(before) = self.zoom else {
            (self.fitted, self.fits, self.zoom) =
                (fit.map(|bounds| grown(&bounds, FIT_MARGIN)), f64::from(u8::from(fit.is_some())), Some(zoom));
            return;
        };
        let share = |time: f64| 1.0 - (-frame_time.max(0.0) / time).exp();
        self.zoom = Some(before * (zoom / before).powf(share(ZOOM_EASE)));
        self.fits += (f64::from(u8::from(fit.is_some())) - self.fits) * share(FIT_EASE);
        if let Some(bounds) = fit {
            let (wanted, part) = (grown(&bounds, FIT_MARGIN), share(FIT_CLOSES));
            let now = self.fitted.unwrap_or(wanted);
            let eased = Aabb::new(now.min.lerp(wanted.min, part), now.max.lerp(wanted.max, part));
            self.fitted = Some(eased.union(&grown(&bounds, FIT_LEAST)));
        }
    }

    /// The view of a level of that size (m) with `kept` (m) in it; `metre` is the canvas units a metre at the usual magnification.
    pub fn viewport(&self, kept: DVec2, level: DVec2, metre: f64, window: CanvasWindow) -> Viewport {
        let usual = Viewport::new(self.focus(), kept, level, metre, window);
        let (view, kept) = match &self.fitted {
            Some(bounds) if self.fits > 1e-3 => (usual.towards(bounds, self.fits), kept.lerp(bounds.centre(), self.fits)),
            _ => (usual, kept),
        };
        view.zoomed(kept, self.zoom.unwrap_or(1.0)).closer(kept, self.closeness)
    }

    /// Closes in on the ship, `frame_time` seconds of the moment that a success has.
    pub fn close_in(&mut self, frame_time: f64) {
        self.closeness += (CLOSE - self.closeness) * (1.0 - (-frame_time.max(0.0) / CLOSE_EASE).exp());
    }

    /// How much it magnifies beyond the usual, 1 …
    pub fn closeness(&self) -> f64 {
        self.closeness
    }

    /// The point it looks at, m.
    pub fn focus(&self) -> DVec2 {
        self.ship + self.ahead
    }
}

/// The window as the camera needs it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CanvasWindow {
    /// Width and height, canvas units.
    pub size: DVec2,
    /// Canvas units a physical pixel.
    pub pixel: f64,
}

/// Where metres of the level lie on the canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Canvas units a metre.
    scale: f64,
    /// The level's top left corner is drawn at minus this: whole physical pixels, so that everything static moves as one.
    origin: DVec2,
    /// The level's size, m.
    level: DVec2,
    /// How far outside of the level it may show, m: room for the arrows of what lies at an edge, where the view is fitted.
    beyond: f64,
    window: CanvasWindow,
}

impl Viewport {
    /// Looks at `focus` (m), but keeps the ship on the screen and everything outside of the level off it. A level that is smaller
    /// than the window along an axis even when magnified 1.5 times is centred along that axis.
    ///
    /// `level` is the level's size (m), `metre` the canvas units a metre at the usual magnification.
    pub fn new(focus: DVec2, ship: DVec2, level: DVec2, metre: f64, window: CanvasWindow) -> Self {
        let zoom = (window.size / (level * metre)).max_element().clamp(1.0, MAX_ZOOM);
        let usual = Self { scale: metre * zoom, origin: DVec2::ZERO, level, beyond: 0.0, window };
        usual.at(usual.scale, focus, ship)
    }

    /// The same view magnified by `factor` around the ship (m), which stays where it is, but for the window's and the level's edges.
    pub fn closer(self, ship: DVec2, factor: f64) -> Self {
        let scale = self.scale * factor;
        let middle = (self.origin + self.window.size * 0.5) / self.scale;
        self.at(scale, ship + (middle - ship) / factor, ship)
    }

    /// The same view turned by a part (0 … 1) towards one that has a box (m) in it, no closer than usual.
    pub fn towards(self, bounds: &Aabb, part: f64) -> Self {
        let fitting = (self.window.size / bounds.size()).min_element().clamp(self.widest(), self.scale);
        let middle = ((self.origin + self.window.size * 0.5) / self.scale).lerp(bounds.centre(), part);
        let view = Self { beyond: FIT_MARGIN * part, ..self };
        view.at(self.scale * (fitting / self.scale).powf(part), middle, middle)
    }

    /// The same view with everything drawn `factor` times as large, but no smaller than with the whole level in view; a point (m) stays
    /// where it is, but for the window's and the level's edges.
    pub fn zoomed(self, kept: DVec2, factor: f64) -> Self {
        let scale = (self.scale * factor).max(self.widest());
        if scale == self.scale { self } else { self.closer(kept, scale / self.scale) }
    }

    /// The scale at which the whole level is in view, or the usual one where it is so already.
    fn widest(&self) -> f64 {
        (self.window.size / self.level).min_element().min(self.scale)
    }

    /// The view of that scale with a point as near to its middle as the ship and the level's edges let it.
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

    /// The same view moved by `offset` canvas units. Where that would show something outside of the level it moves the other way.
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

    /// Canvas units a metre.
    pub const fn scale(&self) -> f64 {
        self.scale
    }

    /// A length in metres as canvas units.
    pub fn length(&self, metres: f64) -> f32 {
        (metres * self.scale) as f32
    }

    /// The window's size, canvas units.
    pub fn size(&self) -> Vec2 {
        self.window.size.as_vec2()
    }

    /// Where a point of the level lies, canvas units from the window's top left corner.
    pub fn point(&self, metres: DVec2) -> Vec2 {
        (metres * self.scale - self.origin).as_vec2()
    }

    /// The point of the level, m, that lies there: what [`Viewport::point`] undoes.
    pub fn metres(&self, point: Vec2) -> DVec2 {
        (point.as_dvec2() + self.origin) / self.scale
    }

    /// Where a box of the level lies, its edges on whole physical pixels so that boxes that adjoin leave no seam.
    pub fn rect(&self, bounds: &Aabb) -> Area {
        let min = self.snap(bounds.min * self.scale - self.origin).as_vec2();
        let max = self.snap(bounds.max * self.scale - self.origin).as_vec2();
        Area { min, size: max - min }
    }

    /// The level, m.
    pub fn level(&self) -> Aabb {
        Aabb::new(DVec2::ZERO, self.level)
    }

    /// The part of space that the window shows, m.
    pub fn visible(&self) -> Aabb {
        Aabb::new(self.origin / self.scale, (self.origin + self.window.size) / self.scale)
    }

    fn snap(&self, point: DVec2) -> DVec2 {
        (point / self.window.pixel).round() * self.window.pixel
    }
}

/// The box whose edges lie so far outside.
fn grown(bounds: &Aabb, by: f64) -> Aabb {
    Aabb::new(bounds.min - by, bounds.max + by)
}
