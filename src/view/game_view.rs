//! The game's picture: bodies, effects, overlays and head-up display of one attempt.

use super::barriers::Barriers;
use super::camera::{Camera, CanvasWindow, Viewport};
use super::details::{Details, Looking};
use super::emitters::{Emitters, dust, objective_colour};
use super::feedback::Feedback;
use super::focus::Focus;
use super::hud::{Hud, HudScene, HudShown};
use super::particles::Particles;
use super::pictures::Pictures;
use super::terrain::Terrain;
use super::things::Brushes;
use super::touchdown::{GENTLE, Touchdown};
use super::wreck::Wreck;
use super::{decoration, hitboxes, hud, mechanisms, theme, things, world, zones};
use crate::draw::layout::{Area, Frame, Vec2};
use crate::draw::{Canvas, Colour};
use crate::game::{Game, GameEvent, Outcome, Pose, SHIP};
use crate::level::{SHIP_HALF, SurfaceOf};
use crate::number::fixed;
use crate::physics::{Aabb, BodyId, DVec2};
use crate::settings::Settings;
use std::path::Path;

/// Canvas units. A smaller body is as easy to point at as one with half such sides.
const GRAB: f32 = 12.0;
/// Reach (m) and strength on the rock of the light of the engine, an objective, a death box and a key object.
const ENGINE_REACH: f64 = 8.0;
const ENGINE_LIGHT: f32 = 0.95;
const OBJECTIVE_REACH: f64 = 4.0;
const OBJECTIVE_LIGHT: f32 = 0.7;
const OBSTACLE_REACH: f64 = 3.0;
const OBSTACLE_LIGHT: f32 = 0.6;
const KEY_REACH: f64 = 3.0;
const KEY_LIGHT: f32 = 0.6;

/// Solids up to this far beyond the view stop particles, m.
const BARRIERS: f64 = 2.0;
/// The longest reach of the engine's flame from the ship's centre, m.
const FLAME_REACH: f64 = 3.0;

/// A ghost nearer than this to the ship or to another ghost has no name, m.
const NAMED_APART: f64 = 2.5;

/// The view of one attempt: its state besides the game's own.
pub struct GameView {
    pictures: Pictures,
    terrain: Terrain,
    camera: Camera,
    /// The body that the view keeps in sight: the ship, unless another is followed.
    followed: BodyId,
    particles: Particles,
    emitters: Emitters,
    feedback: Feedback,
    details: Details,
    hud: Hud,
    /// Canvas units.
    pointer: Option<Vec2>,
    touchdown: Touchdown,
    /// From the loss of the ship on.
    wreck: Option<Wreck>,
    ghosts: Vec<GhostShip>,
    /// Panels above it besides the head-up display, canvas units.
    panels: Vec<Area>,
    /// Time shown, s: waves and pulses run by it.
    time: f64,
}

/// A ship of another flight.
#[derive(Clone, Debug, PartialEq)]
pub struct GhostShip {
    /// Name of the flight.
    pub name: String,
    /// `None` where it is where the ship is.
    pub pose: Option<Pose>,
    /// Objects whose places in that flight differ, by their index in the level, each with its centre, m.
    pub objects: Vec<(usize, DVec2)>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Overlays {
    pub settings: Settings,
    /// Details boxes and free-body arrows (Tab).
    pub details: bool,
    /// The visible parts of the head-up display.
    pub shown: HudShown,
    /// The subject of the details, the instruments and the camera.
    pub focus: Focus,
    /// Hitboxes and figures (F3).
    pub hitboxes: bool,
    /// The flight is a recording: the keys do not fly.
    pub watched: bool,
}

impl Overlays {
    fn followed(&self, game: &Game) -> BodyId {
        self.focus.followed().unwrap_or(game.lead())
    }
}

impl GameView {
    /// The view of a game that begins. `read` returns the bytes of a picture that the level names.
    pub fn new(game: &Game, read: &dyn Fn(&Path) -> Option<Vec<u8>>) -> Self {
        let level = game.level();
        let pictures = Pictures::new(level, read);
        let over_picture = level.background.as_ref().is_some_and(|path| pictures.get(path).is_some());
        let lamps = level.objectives.iter().map(|objective| (objective.bounds, OBJECTIVE_REACH));
        let lamps = lamps.chain(level.obstacles.iter().map(|bounds| (*bounds, OBSTACLE_REACH)));
        let terrain = Terrain::new(level, lamps, &world::text_areas(level), over_picture);
        Self {
            pictures,
            terrain,
            camera: Camera::new(game.world().body(game.lead()).position),
            followed: game.lead(),
            particles: Particles::new(),
            emitters: Emitters::new(level),
            feedback: Feedback::default(),
            details: Details::default(),
            hud: Hud::default(),
            pointer: None,
            touchdown: Touchdown::default(),
            wreck: None,
            ghosts: Vec::new(),
            panels: Vec::new(),
            time: 0.0,
        }
    }

    /// The view of a game that goes on in another level: the camera stays.
    #[must_use]
    pub fn goes_on(&self, game: &Game, read: &dyn Fn(&Path) -> Option<Vec<u8>>) -> Self {
        Self { camera: self.camera, time: self.time, ..Self::new(game, read) }
    }

    /// Takes the events of the last tick. Call it once a tick.
    pub fn after_tick(&mut self, game: &Game) {
        for event in game.events() {
            match event {
                GameEvent::Impact { point, speed, normal } => dust(&mut self.particles, *point, *normal, *speed),
                GameEvent::DamagingHit { point, .. } => self.feedback.hit(*point),
                GameEvent::Crushed { point } => self.feedback.ring(*point, theme::bad()),
                GameEvent::ObjectiveMet(index) => {
                    let centre = game.level().objectives[*index].bounds.centre();
                    self.feedback.ring(centre, objective_colour(game, *index));
                }
                GameEvent::Completed => {
                    let ship = game.world().body(SHIP).position;
                    self.feedback.ring(ship, theme::good());
                    self.feedback.float(ship, "Level complete".into(), theme::good());
                }
                GameEvent::Died => {
                    self.feedback.death();
                    self.feedback.ring(game.world().body(SHIP).position, theme::bad());
                    self.wreck = Wreck::new(game, SHIP);
                }
                GameEvent::Broke(index) => {
                    let block = game.level().world[*index].bounds;
                    self.feedback.ring(block.centre(), theme::text());
                    mechanisms::debris(&mut self.particles, &block);
                }
                GameEvent::Refuelled(index) => {
                    let pod = &game.level().pods[*index];
                    self.feedback.float(pod.bounds.centre(), format!("+{:.0} fuel", pod.fuel), theme::accent());
                }
                GameEvent::Switched(index, true) => {
                    self.feedback.ring(game.level().switches[*index].bounds.centre(), theme::text())
                }
                GameEvent::Switched(_, false) | GameEvent::ObjectiveLost(_) => {}
            }
        }
        if let Some(landing) = self.touchdown.after_tick(game).filter(|landing| landing.speed < GENTLE) {
            self.feedback.float(landing.point, format!("Gentle landing: {} m/s", fixed(landing.speed, 1)), theme::good());
        }
    }

    /// Advances all effects by `frame_time` seconds (0 while paused), and lays the details out. `alpha` (0 … 1) is the frame's
    /// place between the last tick but one and the last.
    pub fn update(&mut self, game: &Game, alpha: f64, frame_time: f64, overlays: Overlays, frame: &Frame) {
        let ship = centre(game, SHIP, alpha);
        self.time += frame_time;
        let followed = overlays.followed(game);
        self.followed = followed;
        self.camera.follow(centre(game, followed, alpha), game.world().body(followed).velocity, frame_time);
        self.camera.turn(overlays.focus.fits().then(|| moving(game, alpha)), overlays.focus.zoom(), frame_time);
        if game.outcome() == Outcome::Completed {
            self.camera.close_in(frame_time);
        }
        let view = self.viewport(game, alpha, frame);
        let visible = view.visible();
        self.particles.set_barriers(Barriers::new(game.world(), &Aabb::new(visible.min - BARRIERS, visible.max + BARRIERS)));
        self.particles.advance(frame_time);
        self.particles.keep(overlays.settings.particles);
        self.touchdown.advance(frame_time);
        if let Some(wreck) = &mut self.wreck {
            wreck.advance(frame_time);
        }
        self.emitters.emit(game, ship, angle(game, alpha), &view.visible(), frame_time, &mut self.particles);
        self.feedback.advance(frame_time);
        let centres: Vec<DVec2> = ids(game).map(|id| centre(game, id, alpha)).collect();
        let figures = overlays.hitboxes.then(|| hitboxes::figures_area(game, frame));
        let mut covered: Vec<Area> = self.panels.iter().copied().chain(figures).collect();
        let (shown, settings) = (overlays.shown, &overlays.settings);
        let scene = HudScene { game, centres: &centres, view: &view, frame, panels: &covered, shown, settings };
        self.hud.update(&scene, frame_time);
        if overlays.details {
            covered.extend(self.hud.pointers().iter().map(|pointer| pointer.area).chain(self.hud.stranded()));
            let looking = Looking {
                centres: &centres,
                focus: &overlays.focus,
                pointer: self.pointer,
                model: overlays.hitboxes,
                velocity: overlays.settings.velocity,
            };
            self.details.arrange(game, &looking, &covered, &view, frame);
        }
    }

    /// The body at a point of the canvas, the nearest to it where there are several.
    pub fn body_at(&self, game: &Game, alpha: f64, point: Vec2, frame: &Frame) -> Option<BodyId> {
        let view = self.viewport(game, alpha, frame);
        let place = |id: BodyId| view.point(centre(game, id, alpha));
        let reach = |id: BodyId| {
            let half = game.world().body(id).half;
            Vec2::new(view.length(half.x), view.length(half.y)).max(Vec2::splat(GRAB))
        };
        let under = ids(game).filter(|id| (place(*id) - point).abs().cmple(reach(*id)).all());
        under.min_by(|a, b| place(*a).distance(point).total_cmp(&place(*b).distance(point)))
    }

    /// Drops the effects of another moment: the game has jumped.
    pub fn jump(&mut self, game: &Game) {
        self.particles = Particles::new();
        self.feedback = Feedback::default();
        self.touchdown = Touchdown::default();
        self.wreck = if game.outcome() == Outcome::Failed { Wreck::new(game, SHIP) } else { None };
    }

    /// Only the camera moves, for `frame_time` seconds: bodies at rest may have been moved by hand.
    pub fn follow_jumps(&mut self, game: &Game, overlays: &Overlays, frame_time: f64) {
        let body = game.world().body(overlays.followed(game));
        self.camera.follow(body.position, body.velocity, frame_time);
        self.camera.turn(overlays.focus.fits().then(|| moving(game, 1.0)), overlays.focus.zoom(), frame_time);
        if game.outcome() != Outcome::Completed {
            self.camera.open_up();
        }
    }

    /// The pointer, canvas units, for the details.
    pub const fn point_at(&mut self, pointer: Vec2) {
        self.pointer = Some(pointer);
    }

    /// Panels above the view, which the details keep clear.
    pub fn set_panels(&mut self, panels: Vec<Area>) {
        self.panels = panels;
    }

    pub fn set_ghosts(&mut self, ghosts: Vec<GhostShip>) {
        self.ghosts = ghosts;
    }

    pub const fn hud(&self) -> &Hud {
        &self.hud
    }

    /// Growth of the engine's plume, 0 … 1.
    pub const fn burning(&self) -> f64 {
        self.emitters.plume().0
    }

    /// `figures` is the line beside the hitboxes: frames a second and cost of a tick.
    pub fn draw(&self, game: &Game, alpha: f64, overlays: Overlays, figures: &str, canvas: &Canvas) {
        let shake = self.feedback.shake() * (f64::from(overlays.settings.shake) / 100.0);
        let view = self.viewport(game, alpha, canvas.frame()).shaken(shake);
        self.draw_level(game, alpha, &view, canvas);
        canvas.end_layer();
        if overlays.hitboxes {
            hitboxes::draw(game, figures, &view, canvas);
        }
        if overlays.details {
            self.details.draw(canvas);
        }
        let plays = game.level().ship_plays();
        if plays && overlays.settings.velocity && self.wreck.is_none() {
            hud::draw_velocity(game.world().body(SHIP).velocity, centre(game, SHIP, alpha), &view, canvas);
        }
        if overlays.settings.flash {
            self.feedback.draw_flash(canvas);
        }
        self.hud.draw(game, &overlays.settings, !overlays.watched, canvas);
        canvas.end_layer();
    }

    fn draw_level(&self, game: &Game, alpha: f64, view: &Viewport, canvas: &Canvas) {
        let (level, time) = (game.level(), self.time);
        let (ship, plume) = ((centre(game, SHIP, alpha), angle(game, alpha)), self.emitters.plume());
        let flicker = 0.5 + 0.5 * (time * 71.0).sin() * (time * 43.0).cos();
        world::draw_ground(level, self.terrain.tint(), &self.pictures, view, canvas);
        decoration::draw(level, false, &self.pictures, (view, canvas));
        mechanisms::draw_fields(level, view, canvas, time);
        zones::draw_streams(game, view, canvas, time);
        // Below everything that could be in them: see [`zones::draw_fluids`].
        zones::draw_fluids(level, view, canvas, time);
        zones::draw_objectives(game, view, canvas, time);
        mechanisms::draw_areas(game, view, canvas, time);
        // Solids hide smoke and dust.
        self.particles.draw(view, canvas);
        self.terrain.draw(view, canvas);
        decoration::draw_on_rock(level, &self.terrain, &self.pictures, (view, canvas));
        self.draw_lights(game, alpha, flicker, (view, canvas));
        zones::draw_sources(level, view, canvas);
        mechanisms::draw(game, alpha, view, canvas, time);
        zones::draw_obstacles(level, view, canvas, time);
        world::draw_texts(level, view, canvas);
        // Bodies hide the words on walls, pads and plates.
        canvas.end_layer();
        let brushes = Brushes { pictures: &self.pictures, view, canvas };
        for (object, id) in level.objects.iter().zip(ids(game).skip(1)) {
            let at = centre(game, id, alpha);
            things::draw_object(object, at, zones::in_liquid(&level.fluids, &Aabb::around(at, object.size * 0.5)), brushes);
        }
        for (i, ghost) in self.ghosts.iter().enumerate() {
            for (index, at) in &ghost.objects {
                let apart =
                    at.distance(game.world().body(BodyId(*index as u32 + 1)).position) > level.objects[*index].size.max_element();
                things::draw_ghost_object(apart.then_some(ghost.name.as_str()), (&level.objects[*index], *at), brushes);
            }
            let Some(pose) = ghost.pose else { continue };
            // A name on another, or on the ship, could not be read.
            let others = self.ghosts[..i].iter().filter_map(|other| Some(other.pose?.centre)).chain([ship.0]);
            let apart = others.into_iter().all(|other| other.distance(pose.centre) > NAMED_APART);
            things::draw_ghost(apart.then_some(ghost.name.as_str()), pose, brushes);
        }
        match &self.wreck {
            Some(wreck) if !wreck.is_whole() => wreck.draw(view, canvas),
            _ => {
                let light = zones::in_liquid(&level.fluids, &Aabb::around(ship.0, SHIP_HALF));
                let (sin, cos) = ship.1.to_radians().sin_cos();
                let room = self.particles.barriers().room(ship.0, DVec2::new(-sin, cos) * plume.1, FLAME_REACH);
                let pose = things::ShipPose { centre: ship.0, angle: ship.1, squash: self.touchdown.squash(), light, room };
                things::draw_ship(&pose, plume, flicker, view, canvas);
            }
        }
        zones::draw_holds(game, ship.0, view, canvas);
        decoration::draw(level, true, &self.pictures, (view, canvas));
        self.feedback.draw_in_level(view, canvas);
    }

    /// The light of objectives, death boxes, key objects and the engine on the rock near them.
    fn draw_lights(&self, game: &Game, alpha: f64, flicker: f64, (view, canvas): (&Viewport, &Canvas)) {
        let level = game.level();
        for index in 0..level.objectives.len() {
            self.terrain.draw_lamp(index, objective_colour(game, index).faded(OBJECTIVE_LIGHT), (view, canvas));
        }
        for index in 0..level.obstacles.len() {
            self.terrain.draw_lamp(level.objectives.len() + index, theme::bad().faded(OBSTACLE_LIGHT), (view, canvas));
        }
        for (object, id) in level.objects.iter().zip(ids(game).skip(1)) {
            if let Some([r, g, b]) = object.key {
                let colour = Colour::of([r, g, b]).faded(KEY_LIGHT);
                self.terrain.draw_moving_light(centre(game, id, alpha), KEY_REACH, colour, (view, canvas));
            }
        }
        let (strength, way) = self.emitters.plume();
        if strength > 0.0 {
            let (sin, cos) = angle(game, alpha).to_radians().sin_cos();
            let flame = centre(game, SHIP, alpha) + DVec2::new(-sin, cos) * (way * (SHIP_HALF.y + 0.3));
            let light = strength * (0.8 + 0.2 * flicker);
            self.terrain.draw_moving_light(
                flame,
                ENGINE_REACH * light,
                theme::accent().faded(ENGINE_LIGHT * light as f32),
                (view, canvas),
            );
        }
    }

    /// The visible part of the level.
    pub fn viewport(&self, game: &Game, alpha: f64, frame: &Frame) -> Viewport {
        let window = CanvasWindow { size: frame.size.as_dvec2(), pixel: f64::from(frame.pixel) };
        let level = game.level();
        let kept = centre(game, self.followed, alpha);
        self.camera.viewport(kept, level.size, level.metre, window)
    }
}

/// The box around the ship, where it plays a part, objects and movers, m.
pub fn moving(game: &Game, alpha: f64) -> Aabb {
    let (level, world) = (game.level(), game.world());
    let bodies =
        ids(game).skip(usize::from(game.lead() != SHIP)).map(|id| Aabb::around(centre(game, id, alpha), world.body(id).half));
    let movers = (0..level.movers.len()).map(|mover| world.surfaces()[level.surface_index(SurfaceOf::Mover(mover))].bounds);
    bodies.chain(movers).reduce(|all, one| all.union(&one)).unwrap_or(world.body(SHIP).bounds())
}

fn ids(game: &Game) -> impl Iterator<Item = BodyId> {
    (0..game.world().bodies().len() as u32).map(BodyId)
}

/// The drawn centre of a body, m: between its last two places.
fn centre(game: &Game, id: BodyId, alpha: f64) -> DVec2 {
    game.world().previous_position(id).lerp(game.world().body(id).position, alpha)
}

/// The drawn angle of the ship, degrees: between its last two angles, the short way round.
fn angle(game: &Game, alpha: f64) -> f64 {
    let ship = game.ship();
    let turn = (ship.angle - ship.previous_angle + 180.0).rem_euclid(360.0) - 180.0;
    ship.previous_angle + turn * alpha
}
