//! The head-up display covers nothing that matters, in windows of several sizes and shapes: at the start of every shipped level no hazard, no
//! goal and no text; along every recorded flight it steps aside. Arrows point to every goal and key outside the view.

use super::onlook::{WINDOWS, centres, kept_free, on_canvas, pixels, window};
use crate::support::shipped::{experiment, levels, load, recorded};
use resultant::draw::layout::{Area, Frame, LINE, Vec2, nearest_size, words_width};
use resultant::game::{Controls, Game, Outcome, SHIP};
use resultant::level::{Level, ObjectiveKind};
use resultant::physics::{Aabb, BodyId};
use resultant::settings::Settings;
use resultant::view::camera::{Camera, Viewport};
use resultant::view::hud::HudLayout;
use resultant::view::hud::{Hud, HudPart, HudScene, HudShown, PointerTarget, in_view};
use std::sync::Arc;

/// Between two looks at a flight, ticks of 1/120 s.
const EVERY: u64 = 12;
/// All parts, as in a race.
const ALL: HudShown = HudShown { status: true, fuel: true, rivals: RIVALS, medal: true };

const PARTS: [HudPart; 3] = [HudPart::Status, HudPart::Fuel, HudPart::Race];

/// The ghosts of an ordinary race. More need a wider strip, through which the world is seen.
const RIVALS: usize = 2;

/// The places of hazards, goals and texts on the canvas, by name.
fn shown(level: &Level, view: &Viewport, frame: &Frame) -> Vec<(String, Area)> {
    let named = |name| move |bounds: &Aabb| (format!("{name} at {}", bounds.min * level.metre), on_canvas(bounds, view));
    let texts = level.texts.iter().map(|text| {
        let height = frame.text_height(nearest_size(view.length(text.size)));
        let size = Vec2::new(words_width(&text.text, height), LINE * height);
        (text.text.clone(), Area { min: view.point(text.position), size })
    });
    let objectives = level.objectives.iter().map(|objective| named("the goal")(&objective.bounds));
    let obstacles = level.obstacles.iter().map(named("the death box"));
    let sources = level.streams.iter().map(|stream| named("the source of a stream")(&stream.source));
    obstacles.chain(objectives).chain(sources).chain(texts).collect()
}

/// A display in a window, and the world below it.
struct Onlooker {
    frame: Frame,
    hud: Hud,
}

impl Onlooker {
    fn all() -> Vec<Self> {
        WINDOWS.map(|size| Self { frame: Frame::of_window(size), hud: Hud::default() }).into()
    }

    fn look(&mut self, game: &Game, camera: &Camera, shown: HudShown, frame_time: f64) -> Viewport {
        let ship = game.world().body(SHIP).position;
        let view = Viewport::new(camera.focus(), ship, game.level().size, game.level().metre, window(&self.frame));
        let centres = centres(game);
        let settings = Settings::default();
        let scene = HudScene { game, centres: &centres, view: &view, frame: &self.frame, panels: &[], shown, settings: &settings };
        self.hud.update(&scene, frame_time);
        view
    }

    fn solid(&self) -> Vec<Area> {
        let aside = &self.hud.aside;
        PARTS.into_iter().filter(|part| aside.of(*part) < 1.0).filter_map(|part| aside.home(part)).collect()
    }
}

fn key_box(game: &Game, index: usize) -> Aabb {
    game.world().body(BodyId(index as u32 + 1)).bounds()
}

#[derive(Debug, Default)]
struct Seen {
    looks: usize,
    aside: usize,
    arrows: usize,
    /// Arrows without a place.
    missing: usize,
}

fn check(onlooker: &Onlooker, game: &Game, view: &Viewport, seen: &mut Seen, what: &str) {
    let (hud, frame) = (&onlooker.hud, &onlooker.frame);
    let what = || format!("{what} after {:.1} s in {}", game.ticks() as f64 / game.tick_rate(), pixels(frame));
    let key = |i: usize| (format!("the key {i}"), on_canvas(&key_box(game, i), view));
    let keys = (0..game.level().objects.len()).filter(|&i| game.level().objects[i].key.is_some()).map(key);
    let free: Vec<(String, Area)> = kept_free(game, view).into_iter().chain(keys).collect();
    for part in onlooker.solid() {
        for (name, area) in &free {
            assert!(part.gap(area) >= 0.0, "{}: {name} ({area:?}) lies behind {part:?}", what());
        }
    }
    seen.looks += 1;
    seen.aside += usize::from(PARTS.into_iter().any(|part| hud.aside.of(part) == 1.0));
    seen.arrows += hud.pointers.len();
    // Arrows: inside, over no part of the display, over no other and not over the ship.
    let ship = on_canvas(&game.world().body(SHIP).bounds(), view);
    for (i, pointer) in hud.pointers.iter().enumerate() {
        let area = pointer.area;
        let inside = area.min.cmpge(Vec2::ZERO).all() && area.max().cmple(frame.size).all();
        let others: Vec<Area> = hud.pointers[..i].iter().map(|other| other.area).collect();
        let homes: Vec<Area> = hud.aside.homes().collect();
        assert!(inside, "{}: {pointer:?} leaves the window", what());
        assert!(area.covers_none(&others) && area.covers_none(&homes) && area.gap(&ship) >= 0.0, "{}: {pointer:?}", what());
    }
    // What is open and out of view may have an arrow, three of it at most, and nothing else.
    let level = game.level();
    let has = |target: PointerTarget| hud.pointers.iter().find(|pointer| pointer.target == target);
    let centre = game.world().body(SHIP).position;
    let mut wanted = 0;
    let mut ask = |target: PointerTarget, bounds: Aabb| {
        let (seen, pointer) = (in_view(&view.exact(&bounds), frame), has(target));
        assert!(pointer.is_none() || !seen, "{}: {target:?}", what());
        wanted += usize::from(!seen);
        if let Some(pointer) = pointer {
            let metres = bounds.centre().distance(centre);
            assert_eq!(pointer.words, format!("{metres:.0} m"), "{}: {target:?}", what());
            let along = (view.point(bounds.centre()) - pointer.area.centre()).normalize();
            assert!(pointer.along.dot(along) > 0.999, "{}: {pointer:?}", what());
        }
    };
    if game.outcome() == Outcome::Running {
        for (index, objective) in level.objectives.iter().enumerate().filter(|(index, _)| !game.met()[*index]) {
            ask(PointerTarget::Objective(index), objective.bounds);
        }
        let physics = || (0..level.objectives.len()).filter(|&i| level.objectives[i].kind == ObjectiveKind::Physics);
        for index in (0..level.objects.len()).filter(|&index| level.objects[index].key.is_some()) {
            let (key, colour) = (key_box(game, index), level.objects[index].key.unwrap());
            if !physics().any(|i| level.objectives[i].fits(colour) && !game.met()[i]) {
                continue;
            }
            let met = |i: usize| game.met()[i] && level.objectives[i].fits(colour) && key.touches(&level.objectives[i].bounds, 0.0);
            if !physics().any(met) {
                ask(PointerTarget::Key(index), key);
            }
        }
    }
    assert!(hud.pointers.len() <= wanted.min(3), "{}: {:?}", what(), hud.pointers);
    seen.missing += wanted.min(3) - hud.pointers.len();
}

fn fly(level: &Arc<Level>, inputs: impl Iterator<Item = Controls>, seen: &mut Seen, what: &str) {
    let mut game = Game::new(Arc::clone(level)).unwrap();
    let mut camera = Camera::new(game.world().body(SHIP).position);
    let mut onlookers = Onlooker::all();
    for controls in inputs {
        game.step(controls);
        let ship = game.world().body(SHIP);
        camera.follow(ship.position, ship.velocity, 1.0 / game.tick_rate());
        if game.ticks().is_multiple_of(EVERY) {
            for onlooker in &mut onlookers {
                let view = onlooker.look(&game, &camera, ALL, EVERY as f64 / game.tick_rate());
                check(onlooker, &game, &view, seen, what);
            }
        }
    }
}

#[test]
fn along_every_recorded_flight_the_display_steps_aside_and_points_to_what_is_outside() {
    let mut seen = Seen::default();
    for (level, what, replay) in recorded() {
        fly(&level, replay.inputs.into_iter(), &mut seen, &what);
    }
    assert!(seen.looks > 10_000 && seen.arrows > seen.looks / 2 && seen.missing < seen.arrows / 20, "{seen:?}");
    assert!(seen.aside > 0 && seen.aside < seen.looks / 2, "{seen:?}: it is away more than it is there");
}

#[test]
fn at_the_start_of_every_level_the_display_is_at_home_and_covers_no_hazard_no_goal_and_no_text() {
    for name in levels() {
        let level = load(&name);
        let game = Game::new(Arc::clone(&level)).unwrap();
        let camera = Camera::new(game.world().body(SHIP).position);
        for mut onlooker in Onlooker::all() {
            let view = onlooker.look(&game, &camera, HudShown { rivals: 0, medal: false, ..ALL }, 1.0);
            let window = pixels(&onlooker.frame);
            assert_eq!(onlooker.solid().len(), 2, "level {name} in {window}: {:?}", onlooker.hud.aside);
            check(&onlooker, &game, &view, &mut Seen::default(), &format!("level {name}"));
            let layout = HudLayout::new(&onlooker.frame);
            let parts: Vec<Area> = layout.areas().into_iter().chain([layout.race(&onlooker.frame, RIVALS)]).collect();
            for (what, area) in shown(&level, &view, &onlooker.frame) {
                for part in parts.iter().chain(onlooker.hud.pointers.iter().map(|pointer| &pointer.area)) {
                    assert!(part.gap(&area) >= 0.0, "level {name} in {window}: {part:?} covers {what} ({area:?})");
                }
            }
        }
    }
}

#[test]
fn an_experiment_shows_no_display_and_a_level_without_an_engine_no_fuel() {
    let level = experiment("free-fall");
    let game = Game::new(Arc::clone(&level)).unwrap();
    let camera = Camera::new(game.world().body(SHIP).position);
    for mut onlooker in Onlooker::all() {
        onlooker.look(&game, &camera, HudShown::default(), 1.0);
        assert!(onlooker.solid().is_empty() && onlooker.hud.pointers.is_empty() && onlooker.hud.stranded().is_none());
    }
    let mut player = level.player.clone();
    assert!(!player.has_engine());
    player.thrust = 1.0;
    assert!(!player.has_engine());
    player.fuel = 1.0;
    assert!(player.has_engine());
}
