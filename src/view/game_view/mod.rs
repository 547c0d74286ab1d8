//! The game's picture: bodies, effects, overlays and head-up display of one attempt.

mod drawing;

use super::camera::{Camera, CanvasWindow, FIT_LEAST, FIT_MARGIN, StirredObjects, Viewport};
use super::details::{Details, Looking};
use super::emitters::{Emitters, dust, objective_colour};
use super::hud::{Hud, HudLayout, HudPart, HudScene, HudShown};
use super::particles::{Barriers, Particle, ParticleLook, Particles};
use super::things::{GENTLE, Touchdown, Wreck};
use super::{art::Pictures, feedback::Feedback, focus::Focus, terrain::Terrain, textbook::BodyPicture};
use super::{hitboxes, mechanisms, theme, world};
use crate::draw::layout::{Area, Frame, LINE, Vec2, words_width};
use crate::game::{Game, GameEvent, GhostPose, Outcome, SHIP};
use crate::physics::{Aabb, BodyId, DVec2, ForceKind};
use crate::{level::Text, number::fixed, settings::Settings, words::tr};
pub use drawing::painting;
use drawing::{OBJECTIVE_REACH, OBSTACLE_REACH};
use std::path::Path;

/// Canvas units. A smaller body is as easy to point at as one with half such sides.
const GRAB: f32 = 12.0;
/// The ship and what it has set in motion share a view of up to this many usual ones, each way, less the margin around them.
const FRAMED: f64 = 1.3;
/// What begins this near to the canvas' top, or ends twice as near to its foot, is a row along that edge, canvas units.
const ROW: f32 = 32.0;
/// Letters are measured at this height, canvas units.
const TALL: f32 = 100.0;
/// Arrows that fly from the goals of a solved level.
const ARROWS: usize = 30;
/// Solids up to this far beyond the view stop particles, m.
const BARRIERS: f64 = 2.0;

pub struct GameView {
    pictures: Pictures,
    terrain: Terrain,
    /// What a view of the whole level has in it, with a margin less, m.
    rooms: Option<Aabb>,
    camera: Camera,
    /// The body that the view keeps in sight: the ship, unless another is followed.
    followed: BodyId,
    particles: Particles,
    emitters: Emitters,
    feedback: Feedback,
    details: Details,
    picture: BodyPicture,
    pub hud: Hud,
    /// For the details, canvas units.
    pub pointer: Option<Vec2>,
    touchdown: Touchdown,
    stirred: StirredObjects,
    /// From the loss of the ship on.
    wreck: Option<Wreck>,
    pub ghosts: Vec<GhostShip>,
    /// Panels above it besides the head-up display, canvas units; the details keep them clear.
    pub panels: Vec<Area>,
    /// Time shown, s: waves and pulses run by it.
    time: f64,
    /// Time shown since the level is solved, s.
    solved: f64,
}

/// A ship of another flight.
#[derive(Clone, Debug, PartialEq)]
pub struct GhostShip {
    pub name: String,
    /// `None` where it is where the ship is.
    pub pose: Option<GhostPose>,
    /// Objects whose places in that flight differ, by their index in the level, each with its centre, m.
    pub objects: Vec<(usize, DVec2)>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Overlays {
    pub settings: Settings,
    /// Details boxes and free-body arrows (Tab).
    pub details: bool,
    /// The forces on a body alone, in place of the level.
    pub picture: bool,
    pub shown: HudShown,
    /// The subject of the details, the instruments and the camera.
    pub focus: Focus,
    /// Hitboxes and figures (F3).
    pub hitboxes: bool,
    /// The flight is a recording: the keys do not fly.
    pub watched: bool,
    pub map: bool,
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
            rooms: terrain.rooms().map(|rooms| shrunk(&rooms)),
            pictures,
            terrain,
            camera: Camera::new(game.world().body(game.lead()).position),
            followed: game.lead(),
            particles: Particles::default(),
            emitters: Emitters::new(level),
            feedback: Feedback::default(),
            details: Details::default(),
            picture: BodyPicture::default(),
            hud: Hud::default(),
            pointer: None,
            touchdown: Touchdown::default(),
            stirred: StirredObjects::default(),
            wreck: None,
            ghosts: Vec::new(),
            panels: Vec::new(),
            time: 0.0,
            solved: f64::from(u8::from(game.outcome() == Outcome::Completed)),
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
                    self.feedback.ring(game.level().objectives[*index].bounds.centre(), objective_colour(game, *index));
                }
                GameEvent::Completed => {
                    let ship = game.world().body(SHIP).position;
                    self.feedback.ring(ship, theme::good());
                    self.feedback.float(ship, tr("Level complete").into(), theme::good());
                    self.answer_to_the_end(game);
                }
                GameEvent::Died => {
                    self.feedback.death();
                    self.feedback.ring(game.world().body(SHIP).position, theme::bad());
                    self.wreck = Wreck::new(game, SHIP);
                }
                GameEvent::Snapped(index) | GameEvent::Hooked(index) => {
                    let ends = game.world().link_ends(&game.world().links()[*index]);
                    self.feedback.ring((ends[0] + ends[1]) * 0.5, theme::text());
                }
                GameEvent::Broke(index) => {
                    let block = game.level().world[*index].bounds;
                    self.feedback.ring(block.centre(), theme::text());
                    mechanisms::debris(&mut self.particles, &block);
                }
                GameEvent::Refuelled(index) => {
                    let pod = &game.level().pods[*index];
                    let words = tr!("+{fuel} fuel", fuel = format_args!("{:.0}", pod.fuel));
                    self.feedback.float(pod.bounds.centre(), words, theme::accent());
                }
                GameEvent::StarTouched(index) => {
                    self.feedback.ring(game.level().stars[*index].bounds.centre(), theme::accent());
                }
                GameEvent::Switched(index, true) => {
                    let switch = game.level().switches[*index].bounds.centre();
                    self.feedback.ring(switch, theme::text());
                    mechanisms::worked_by(game, *index).for_each(|worked| self.feedback.run(switch, worked));
                }
                GameEvent::Switched(_, false) | GameEvent::ObjectiveLost(_) => {}
            }
        }
        self.stirred.after_tick(game);
        let slow = game.world().body(SHIP).velocity.length() < 2.0 * GENTLE;
        if let Some((point, speed)) = self.touchdown.after_tick(game).filter(|(_, speed)| slow && *speed < GENTLE) {
            self.feedback.float(point, tr!("Gentle landing: {speed} m/s", speed = fixed(speed, 1)), theme::good());
        }
    }

    /// The level is solved: arrows of all forces fly from its goals, and light runs along every wire.
    fn answer_to_the_end(&mut self, game: &Game) {
        for (index, goal) in (0..ARROWS).zip(game.level().objectives.iter().cycle()) {
            let kind = ForceKind::ALL[index % ForceKind::ALL.len()];
            let way = DVec2::from_angle(-std::f64::consts::PI * self.particles.between(0.05, 0.95));
            let motion = (goal.bounds.centre(), way * self.particles.between(5.0, 12.0));
            let life = self.particles.between(0.8, 1.4);
            self.particles.add(Particle::new(ParticleLook::Arrow, theme::force(kind), motion, life));
        }
        for (index, switch) in game.level().switches.iter().enumerate() {
            mechanisms::worked_by(game, index).for_each(|worked| self.feedback.run(switch.bounds.centre(), worked));
        }
    }

    /// Advances all effects by `frame_time` s (0 while paused), and lays the details out. `alpha` (0 … 1) is the frame's place in the last tick.
    pub fn update(&mut self, game: &Game, alpha: f64, frame_time: f64, overlays: Overlays, frame: &Frame) {
        let ship = drawn_centre(game, SHIP, alpha);
        self.time += frame_time;
        self.solved = if game.outcome() == Outcome::Completed { self.solved + frame_time } else { 0.0 };
        let followed = overlays.focus.followed.unwrap_or(game.lead());
        self.followed = followed;
        self.camera.follow(drawn_centre(game, followed, alpha), game.world().body(followed).velocity, frame_time);
        self.turn_camera(game, alpha, &overlays, frame, frame_time);
        if game.outcome() == Outcome::Completed && !overlays.map {
            self.camera.close_in(frame_time);
        }
        let view = self.viewport(game, alpha, frame);
        let visible = view.visible();
        self.particles.barriers = Barriers::new(game.world(), &Aabb::new(visible.min - BARRIERS, visible.max + BARRIERS));
        self.particles.advance(frame_time);
        self.particles.keep(overlays.settings.particles);
        self.touchdown.advance(frame_time);
        if let Some(wreck) = &mut self.wreck {
            wreck.advance(frame_time);
        }
        self.emitters.emit(game, ship, angle(game, alpha), &view.visible(), frame_time, &mut self.particles);
        self.feedback.advance(frame_time);
        let centres: Vec<DVec2> = ids(game).map(|id| drawn_centre(game, id, alpha)).collect();
        let figures = overlays.hitboxes.then(|| hitboxes::figures_area(game, frame));
        let mut covered: Vec<Area> = self.panels.iter().copied().chain(figures).collect();
        let (shown, settings) = (overlays.shown, &overlays.settings);
        self.hud.update(&HudScene { game, centres: &centres, view: &view, frame, panels: &covered, shown, settings }, frame_time);
        if overlays.picture {
            let room = beside(&covered, shown.status.then(|| HudLayout::shown(frame, game)).into_iter().flatten(), frame);
            self.picture.arrange(game, followed, room, frame);
        } else if overlays.details {
            let parts = self.hud.stranded().into_iter().chain(self.hud.aside.home(HudPart::Race));
            covered.extend(self.hud.pointers.iter().map(|pointer| pointer.area).chain(parts));
            let (focus, model, velocity) = (&overlays.focus, overlays.hitboxes, settings.velocity);
            let looking = Looking { centres: &centres, focus, pointer: self.pointer, model, velocity };
            self.details.arrange(game, &looking, &covered, &view, frame);
        }
    }

    /// The body at a point of the canvas, the nearest to it where there are several.
    pub fn body_at(&self, game: &Game, alpha: f64, point: Vec2, frame: &Frame) -> Option<BodyId> {
        let view = self.viewport(game, alpha, frame);
        let place = |id: BodyId| view.point(drawn_centre(game, id, alpha));
        let reach = |id: BodyId| {
            let half = game.world().body(id).half;
            Vec2::new(view.length(half.x), view.length(half.y)).max(Vec2::splat(GRAB))
        };
        let under = ids(game).filter(|id| (place(*id) - point).abs().cmple(reach(*id)).all());
        under.min_by(|a, b| place(*a).distance(point).total_cmp(&place(*b).distance(point)))
    }

    /// Drops the effects of another moment: the game has jumped.
    pub fn jump(&mut self, game: &Game) {
        (self.particles, self.feedback, self.touchdown, self.stirred) = Default::default();
        self.wreck = if game.outcome() == Outcome::Failed { Wreck::new(game, SHIP) } else { None };
    }

    /// Only the camera moves, for `frame_time` seconds: bodies at rest may have been moved by hand.
    pub fn follow_jumps(&mut self, game: &Game, overlays: &Overlays, frame: &Frame, frame_time: f64) {
        let body = game.world().body(overlays.focus.followed.unwrap_or(game.lead()));
        self.camera.follow(body.position, body.velocity, frame_time);
        self.turn_camera(game, 1.0, overlays, frame, frame_time);
        if game.outcome() != Outcome::Completed || overlays.map {
            self.camera.closeness = 1.0;
        }
    }

    /// Turns the camera to the whole level, to everything that moves, or to the ship and what it has set in motion.
    fn turn_camera(&mut self, game: &Game, alpha: f64, overlays: &Overlays, frame: &Frame, frame_time: f64) {
        let room = frame.size.as_dvec2() / game.level().metre * FRAMED;
        let stirred = || self.stirred.framed(game, room, |id| drawn_centre(game, id, alpha));
        let (fit, zoom) = match () {
            () if overlays.map => (self.rooms, 1.0),
            () if overlays.focus.fits() => (Some(moving(game, alpha)), overlays.focus.zoom()),
            () if self.followed == SHIP && game.outcome() == Outcome::Running => (stirred(), overlays.focus.zoom()),
            () => (None, overlays.focus.zoom()),
        };
        self.camera.turn(fit, zoom, frame_time);
    }

    /// Growth of the engine's plume, 0 … 1.
    pub const fn burning(&self) -> f64 {
        self.emitters.plume().0
    }

    /// The visible part of the level.
    pub fn viewport(&self, game: &Game, alpha: f64, frame: &Frame) -> Viewport {
        let window = CanvasWindow { size: frame.size.as_dvec2(), pixel: f64::from(frame.pixel) };
        let level = game.level();
        self.camera.viewport(drawn_centre(game, self.followed, alpha), level.size, level.metre, window)
    }
}

/// The part of the canvas between what stands along its edges: rails of buttons at the left, rows at the top and the foot.
fn beside(panels: &[Area], display: impl Iterator<Item = Area>, frame: &Frame) -> Area {
    let (mut low, mut high) = (Vec2::ZERO, frame.size);
    for panel in panels.iter().copied().chain(display) {
        let flat = panel.size.y < 0.3 * frame.size.y;
        if flat && panel.min.y < ROW {
            low.y = low.y.max(panel.max().y);
        } else if flat && panel.max().y > frame.size.y - 2.0 * ROW {
            high.y = high.y.min(panel.min.y);
        } else if panel.max().x < 0.4 * frame.size.x {
            low.x = low.x.max(panel.max().x);
        }
    }
    Area { min: low, size: high - low }
}

/// A box to be fitted with a metre around it: the camera adds its own margin.
fn shrunk(rooms: &Aabb) -> Aabb {
    let half = rooms.size() * 0.5;
    Aabb::around(rooms.centre(), (half - (FIT_MARGIN - 1.0)).max(half.min(DVec2::ONE)))
}

/// The box around the ship, where it plays a part, objects and movers, m; in an experiment with all words that stand beside them in view.
pub fn moving(game: &Game, alpha: f64) -> Aabb {
    let world = game.world();
    let bodies =
        ids(game).skip(usize::from(game.lead() != SHIP)).map(|id| Aabb::around(drawn_centre(game, id, alpha), world.body(id).half));
    let word = |text: &Text| {
        let size = DVec2::new(f64::from(words_width(tr(&text.text), TALL) / TALL), f64::from(LINE)) * text.size;
        // They need less room around them than arrows do.
        let less = FIT_MARGIN - FIT_LEAST;
        Aabb { min: text.position + less, max: text.position + size - less }
    };
    let words = game.level().texts.iter().filter(|_| game.level().experiment).map(word);
    bodies.chain(mechanisms::movers(game)).chain(words).reduce(|all, one| all.union(&one)).unwrap_or(world.body(SHIP).bounds())
}

fn ids(game: &Game) -> impl Iterator<Item = BodyId> {
    (0..game.world().bodies().len() as u32).map(BodyId)
}

/// The drawn centre of a body, m: between its last two places.
pub fn drawn_centre(game: &Game, id: BodyId, alpha: f64) -> DVec2 {
    game.world().previous_position(id).lerp(game.world().body(id).position, alpha)
}

/// The drawn angle of the ship, degrees: between its last two angles, the short way round.
fn angle(game: &Game, alpha: f64) -> f64 {
    let ship = game.ship();
    ship.previous_angle + ((ship.angle - ship.previous_angle + 180.0).rem_euclid(360.0) - 180.0) * alpha
}
