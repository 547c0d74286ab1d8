//! Draws the game: from the ground up, words after the shapes of their layer.

use super::{GameView, Overlays, angle, drawn_centre, ids};
use crate::draw::layout::{Area, Frame, Vec2};
use crate::draw::{Canvas, Colour, Image, Painting, raster};
use crate::game::{Game, SHIP, object_body};
use crate::level::{Level, SHIP_HALF};
use crate::physics::{Aabb, DVec2};
use crate::view::camera::{CanvasWindow, Viewport};
use crate::view::emitters::objective_colour;
use crate::view::things::{Brushes, ShipPose};
use crate::view::{art, hitboxes, hud, labels, mechanisms, theme, things, world, zones};
use std::sync::{Arc, LazyLock};

/// Reach (m) and strength on the rock of the light of the engine, an objective, a death box and a key object.
const ENGINE_REACH: f64 = 8.0;
const ENGINE_LIGHT: f32 = 0.95;
pub(super) const OBJECTIVE_REACH: f64 = 4.0;
const OBJECTIVE_LIGHT: f32 = 0.7;
pub(super) const OBSTACLE_REACH: f64 = 3.0;
const OBSTACLE_LIGHT: f32 = 0.6;
const KEY_REACH: f64 = 3.0;
const KEY_LIGHT: f32 = 0.6;

/// The light that goes out from the ship over the rock when the level is solved: for how long, s, and how far, m.
const WAVE_TIME: f64 = 0.9;
const WAVE_REACH: f64 = 14.0;
/// In a solved level so much more time passes for water, wheels and belts than for all else, s a second.
const HURRY: f64 = 2.0;
/// Within this time doors open and columns of light rise, s.
const ANSWER: f64 = 0.6;

/// The longest reach of the engine's flame from the ship's centre, m.
const FLAME_REACH: f64 = 3.0;

/// Round the rooms on a card, m.
const ROUND: f64 = 0.8;

/// A ghost nearer than this to the ship or to another ghost has no name, m.
const NAMED_APART: f64 = 2.5;

/// Width and height of a level's painting, pixels.
const SIZE: [usize; 2] = [384, 216];

static SHEET: LazyLock<Painting> = LazyLock::new(art::sheet);

/// The level at its start as its card shows it, its rooms as large as they fit; `None` where it does not begin.
pub fn painting(level: &Arc<Level>) -> Option<Image> {
    let game = Game::new(level.clone()).ok()?;
    let canvas = Canvas::new(Frame::of_window(Vec2::new(2.0 * SIZE[0] as f32, 2.0 * SIZE[1] as f32)));
    GameView::new(&game, &|_| None).draw_rooms(&game, &canvas);
    Some(Image::Painted(Arc::new(raster::paint(&canvas, 2 * SIZE[0], theme::ground(), &SHEET).halved())))
}

impl GameView {
    /// `figures` is the line beside the hitboxes: frames a second and cost of a tick.
    pub fn draw(&self, game: &Game, alpha: f64, overlays: Overlays, figures: &str, canvas: &Canvas) {
        let shake = self.feedback.shake() * (f64::from(overlays.settings.shake) / 100.0);
        let view = self.viewport(game, alpha, canvas.frame()).shaken(shake);
        if overlays.picture {
            self.picture.draw(canvas);
            self.hud.draw(game, &overlays.settings, !overlays.watched, canvas);
            return canvas.end_layer();
        }
        self.draw_level(game, alpha, &view, canvas);
        canvas.end_layer();
        if overlays.hitboxes {
            hitboxes::draw(game, figures, &view, canvas);
        }
        if overlays.details {
            self.details.draw(canvas);
        }
        if game.level().ship_plays() && overlays.settings.velocity && self.wreck.is_none() {
            hud::draw_velocity(game.world().body(SHIP).velocity, drawn_centre(game, SHIP, alpha), &view, canvas);
        }
        if overlays.shown.fuel && self.wreck.is_none() {
            hud::draw_fuel_ring(game, drawn_centre(game, SHIP, alpha), &view, canvas);
        }
        if overlays.settings.flash {
            self.feedback.draw_flash(canvas);
        }
        self.hud.draw(game, &overlays.settings, !overlays.watched, canvas);
        canvas.end_layer();
    }

    fn draw_rooms(&self, game: &Game, canvas: &Canvas) {
        let (level, frame) = (game.level(), canvas.frame());
        let rooms = self.terrain.rooms().unwrap_or(level.bounds());
        let window = CanvasWindow { size: frame.size.as_dvec2(), pixel: f64::from(frame.pixel) };
        self.draw_level(game, 1.0, &Viewport::of(&Aabb::new(rooms.min - ROUND, rooms.max + ROUND), level.size, window), canvas);
    }

    fn draw_level(&self, game: &Game, alpha: f64, view: &Viewport, canvas: &Canvas) {
        let answer = self.answer();
        // Water, wheels and belts are livelier then.
        let (level, time) = (game.level(), self.time + HURRY * self.solved);
        let ship = (drawn_centre(game, SHIP, alpha), angle(game, alpha));
        let flicker = 0.5 + 0.5 * (time * 71.0).sin() * (time * 43.0).cos();
        world::draw_ground(level, &self.terrain, &self.pictures, (view, canvas), time);
        world::draw_decoration(level, false, &self.pictures, (view, canvas));
        mechanisms::draw_fields(level, view, canvas, time);
        zones::draw_streams(game, view, canvas, time);
        // Below everything that could be in them: see [`zones::draw_fluids`].
        zones::draw_fluids(level, view, canvas, time);
        self.terrain.draw_shade(view, canvas);
        zones::draw_objectives(game, view, canvas, (self.time, answer));
        mechanisms::draw_areas(game, view, canvas, time);
        mechanisms::draw_stars(game, view, canvas);
        // Solids hide smoke and dust.
        self.particles.draw(view, canvas);
        let labels = labels::place(level, view, canvas.frame(), self.hud.aside.homes());
        let taken: Vec<Area> =
            labels.iter().map(|label| label.area).chain(labels::things(level, view)).chain(self.hud.aside.homes()).collect();
        self.terrain.draw(view, canvas, &taken);
        world::draw_on_rock(level, &self.terrain, &self.pictures, (view, canvas));
        self.draw_lights(game, alpha, flicker, (view, canvas));
        zones::draw_sources(level, view, canvas);
        mechanisms::draw(game, alpha, (view, canvas), (time, answer));
        zones::draw_obstacles(level, view, canvas, time);
        zones::draw_labels(game, &labels, view, canvas);
        // Bodies hide the words on walls, pads and plates.
        canvas.end_layer();
        world::draw_links(game, |id| drawn_centre(game, id, alpha), (view, canvas), time);
        let brushes = Brushes { pictures: &self.pictures, view, canvas };
        for (object, id) in level.objects.iter().zip(ids(game).skip(1)) {
            let at = drawn_centre(game, id, alpha);
            things::draw_object(object, at, zones::in_liquid(&level.fluids, &Aabb::around(at, object.size * 0.5)), brushes);
        }
        self.draw_ghosts(game, ship.0, brushes);
        self.draw_ship(level, ship, flicker, (view, canvas));
        zones::draw_holds(game, ship.0, view, canvas);
        world::draw_decoration(level, true, &self.pictures, (view, canvas));
        self.feedback.draw_in_level(view, canvas);
    }

    /// What the level has made of being solved, 0 … 1.
    fn answer(&self) -> f32 {
        let part = (self.solved / ANSWER).min(1.0) as f32;
        part * part * (3.0 - 2.0 * part)
    }

    fn draw_ghosts(&self, game: &Game, ship: DVec2, brushes: Brushes<'_>) {
        let level = game.level();
        for (i, ghost) in self.ghosts.iter().enumerate() {
            for (index, at) in &ghost.objects {
                let apart = at.distance(game.world().body(object_body(*index)).position) > level.objects[*index].size.max_element();
                things::draw_ghost_object(apart.then_some(ghost.name.as_str()), (&level.objects[*index], *at), brushes);
            }
            let Some(pose) = ghost.pose else { continue };
            // A name on another, or on the ship, could not be read.
            let others = self.ghosts[..i].iter().filter_map(|other| Some(other.pose?.centre)).chain([ship]);
            let apart = others.into_iter().all(|other| other.distance(pose.centre) > NAMED_APART);
            things::draw_ghost(apart.then_some(ghost.name.as_str()), pose, brushes);
        }
    }

    fn draw_ship(&self, level: &Level, (centre, angle): (DVec2, f64), flicker: f64, (view, canvas): (&Viewport, &Canvas)) {
        if let Some(wreck) = self.wreck.as_ref().filter(|wreck| !wreck.is_whole()) {
            return wreck.draw(view, canvas);
        }
        let plume = self.emitters.plume();
        let light = zones::in_liquid(&level.fluids, &Aabb::around(centre, SHIP_HALF));
        let (sin, cos) = angle.to_radians().sin_cos();
        let room = self.particles.barriers.room(centre, DVec2::new(-sin, cos) * plume.1, FLAME_REACH);
        things::draw_ship(&ShipPose { centre, angle, squash: self.touchdown.squash(), light, room }, plume, flicker, view, canvas);
    }

    /// The light of objectives, death boxes, key objects and the engine on the rock near them.
    fn draw_lights(&self, game: &Game, alpha: f64, flicker: f64, (view, canvas): (&Viewport, &Canvas)) {
        let level = game.level();
        let lamp = OBJECTIVE_LIGHT + (1.0 - OBJECTIVE_LIGHT) * self.answer();
        for index in 0..level.objectives.len() {
            self.terrain.draw_lamp(index, objective_colour(game, index).faded(lamp), (view, canvas));
        }
        let wave = self.solved / WAVE_TIME;
        if wave > 0.0 && wave < 1.0 {
            let colour = theme::good().faded(1.0 - wave as f32);
            self.terrain.draw_moving_light(drawn_centre(game, SHIP, alpha), WAVE_REACH * wave.sqrt(), colour, (view, canvas));
        }
        for index in 0..level.obstacles.len() {
            self.terrain.draw_lamp(level.objectives.len() + index, theme::bad().faded(OBSTACLE_LIGHT), (view, canvas));
        }
        for (object, id) in level.objects.iter().zip(ids(game).skip(1)) {
            if let Some(key) = object.key {
                let colour = Colour::of(key).faded(KEY_LIGHT);
                self.terrain.draw_moving_light(drawn_centre(game, id, alpha), KEY_REACH, colour, (view, canvas));
            }
        }
        let (strength, way) = self.emitters.plume();
        if strength > 0.0 {
            let (sin, cos) = angle(game, alpha).to_radians().sin_cos();
            let flame = drawn_centre(game, SHIP, alpha) + DVec2::new(-sin, cos) * (way * (SHIP_HALF.y + 0.3));
            let light = strength * (0.8 + 0.2 * flicker);
            let colour = theme::accent().faded(ENGINE_LIGHT * light as f32);
            self.terrain.draw_moving_light(flame, ENGINE_REACH * light, colour, (view, canvas));
        }
    }
}
