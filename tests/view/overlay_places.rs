//! Along every recorded flight and through every experiment, in windows of several sizes and with words of two sizes, the details cover
//! neither the ship nor a hazard nor a goal, nothing of them covers another, and no force is without an arrow inside the window.

use super::onlook::{WINDOWS, centres, kept_free, pixels, window};
use crate::support::shipped::{experiment, experiments, recorded};
use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::game::{Controls, Game, TICK_RATE};
use resultant::level::Level;
use resultant::physics::{Aabb, BodyId, DVec2};
use resultant::view::camera::{Camera, Viewport};
use resultant::view::details::{Details, Looking};
use resultant::view::facts::{FactRow, facts};
use resultant::view::focus::Focus;
use resultant::view::free_body::{arrow_of, head_area};
use resultant::view::game_view::moving;
use resultant::view::hud::HudLayout;
use std::sync::Arc;

/// Words as designed, and the largest that the settings know.
const TEXTS: [f32; 2] = [1.0, 1.5];
/// Between two looks at a flight, s; and for how long an experiment is looked at.
const EVERY: f64 = 0.5;
const WATCHED: f64 = 8.0;
/// An arrow this short could be taken for nothing, canvas units.
const LEAST: f32 = 12.0;

/// The sizes of the forces in experiments that are pushed or carried, N.
const USUAL: std::ops::RangeInclusive<f64> = 20.0..=75.0;

#[derive(Debug, Default)]
struct Seen {
    looks: usize,
    arrows: usize,
    without_place: usize,
    labels: usize,
    boxes: usize,
    without_legend: usize,
    /// Arrows of the forces of experiments.
    usual: usize,
}

struct Onlooker {
    frame: Frame,
    details: Details,
}

impl Onlooker {
    fn all() -> Vec<Self> {
        let frames = WINDOWS.into_iter().flat_map(|size| TEXTS.map(|text| Frame::of_window(size).with_text(text)));
        frames.map(|frame| Self { frame, details: Details::default() }).collect()
    }

    fn look(&mut self, game: &Game, (camera, focus): (&Camera, &Focus), seen: &mut Seen, what: &str) {
        let (world, frame) = (game.world(), self.frame);
        let kept = world.body(focus.followed.unwrap_or(game.lead())).position;
        let view = camera.viewport(kept, game.level().size, game.level().metre, window(&frame));
        let centres = centres(game);
        let looking = Looking { centres: &centres, focus, pointer: None, model: false, velocity: game.level().ship_plays() };
        self.details.arrange(game, &looking, &[], &view, &frame);
        let what = || format!("{what} in {} with words of {}", pixels(&frame), frame.text);
        self.check_areas(game, &view, &what);
        self.check_arrows(game, &centres, (&view, focus), seen, &what);
        if focus.fits() {
            self.check_fit(game, &view, seen, &what);
        }
        let details = &self.details;
        let lead = focus.followed.unwrap_or(game.lead());
        let own = details.boxes.iter().any(|placed| placed.text.body == lead);
        assert!(own || frame.text > 1.0 || !game.level().ship_plays(), "{}: the ship's own box has no place", what());
        seen.looks += 1;
        seen.labels += details.labels.len();
        seen.boxes += details.boxes.len();
        seen.without_legend += usize::from(details.legend.area.is_none());
    }

    /// All that is laid over the level, by name.
    fn laid(&self) -> Vec<(String, Area)> {
        let details = &self.details;
        let boxes = details.boxes.iter().map(|placed| (format!("the box of {}", placed.text.title), placed.area));
        let heads = details.arranged.arrows.iter().map(|arrow| {
            let name = format!("the head of {} on body {}", arrow.name(), arrow.body.0);
            (name, head_area(arrow.from, arrow.to, arrow.shown))
        });
        let labels = details.labels.iter().map(|label| {
            let arrow = &details.arranged.arrows[label.arrow];
            (format!("the label of {} on body {}", arrow.name(), arrow.body.0), label.area)
        });
        let legend = details.legend.area.map(|area| ("the legend".to_owned(), area));
        boxes.chain(heads).chain(labels).chain(details.names.iter().cloned()).chain(legend).collect()
    }

    fn check_areas(&self, game: &Game, view: &Viewport, what: &dyn Fn() -> String) {
        let laid = self.laid();
        let hud = HudLayout::shown(&self.frame, game).into_iter().map(|area| ("the head-up display".to_owned(), area));
        let kept: Vec<(String, Area)> = kept_free(game, view).into_iter().chain(hud).collect();
        for (i, (name, area)) in laid.iter().enumerate() {
            let window = self.frame.area();
            let inside = area.min.cmpge(window.min).all() && area.max().cmple(window.max()).all();
            assert!(inside, "{}: {name} leaves the window: {area:?}", what());
            for (other, place) in &kept {
                assert!(area.gap(place) >= 0.0, "{}: {name} ({area:?}) covers {other} ({place:?})", what());
            }
            for (other, place) in &laid[i + 1..] {
                assert!(area.gap(place) >= 0.0, "{}: {name} ({area:?}) covers {other} ({place:?})", what());
            }
        }
    }

    /// Every listed force has its arrow: inside the window, never too short to see, by one scale or marked.
    fn check_arrows(
        &self,
        game: &Game,
        centres: &[DVec2],
        (view, focus): (&Viewport, &Focus),
        seen: &mut Seen,
        what: &dyn Fn() -> String,
    ) {
        let arranged = &self.details.arranged;
        let inside = |point: Vec2| self.frame.area().contains(point);
        let mut scales = [None; 2];
        for arrow in &arranged.arrows {
            assert!(inside(arrow.from) && inside(arrow.to), "{}: {arrow:?} leaves the window", what());
            assert!(arrow.length() >= LEAST, "{}: {arrow:?} is nearly nothing", what());
            let rows = facts(game, arrow.body).rows;
            let (_, vector) = arrow_of(&rows[arrow.row], &rows).expect("an arrow has a row");
            let ways = (arrow.to - arrow.from).normalize().dot(vector.normalize().as_vec2());
            assert!(ways > 0.999, "{}: {arrow:?} does not point along {vector}", what());
            if arrow.to_scale {
                let scale = vector.length() / f64::from(arrow.length());
                let first = *scales[usize::from(arrow.shown.is_impact())].get_or_insert(scale);
                // The lengths are whole to half a canvas unit.
                let within = 1.0 / f64::from(LEAST);
                assert!((scale / first - 1.0).abs() < within, "{}: {arrow:?} has {scale}, others {first} N a unit", what());
            }
        }
        if focus.followed.is_none() {
            let visible = view.visible();
            let in_view = (game.lead().index()..centres.len())
                .filter(|&i| Aabb::around(centres[i], game.world().bodies()[i].half).touches(&visible, 0.0));
            let arrows_of = |rows: &[FactRow]| rows.iter().filter(|row| arrow_of(row, rows).is_some()).count();
            let forces: usize = in_view.map(|i| arrows_of(&facts(game, BodyId(i as u32)).rows)).sum();
            assert_eq!(arranged.arrows.len() + arranged.left_out, forces, "{}", what());
        }
        let off = arranged.arrows.iter().filter(|arrow| !arrow.to_scale).count();
        let marked = self.details.legend.lines.iter().any(|line| line.contains("not to scale"));
        assert_eq!(marked, off > 0, "{}", what());
        seen.arrows += arranged.arrows.len();
        seen.without_place += arranged.left_out;
    }

    /// In a view that is fitted everything that moves is in the window, and the forces of an experiment's scale are to scale.
    fn check_fit(&self, game: &Game, view: &Viewport, seen: &mut Seen, what: &dyn Fn() -> String) {
        let slack = 1.0 / view.scale;
        let (visible, moving) = (view.visible(), moving(game, 1.0));
        assert!(visible.contains(&moving, slack), "{}: {moving:?} is not in {visible:?}", what());
        // The weights on the water are thousands of newtons.
        let usual = game.level().fluids.is_empty();
        for arrow in self.details.arranged.arrows.iter().filter(|arrow| usual && !arrow.shown.is_impact()) {
            let facts = facts(game, arrow.body);
            let (_, vector) = arrow_of(&facts.rows[arrow.row], &facts.rows).expect("an arrow has a row");
            let of_scale = USUAL.contains(&vector.length());
            seen.usual += usize::from(of_scale);
            assert!(!of_scale || arrow.to_scale, "{}: {} of {}, {vector} N, is not to scale", what(), arrow.name(), facts.title);
        }
    }
}

/// Looks at a game every half second while it is played, at words of either size in turn.
fn watch(level: &Arc<Level>, focus: &Focus, inputs: impl Iterator<Item = Controls>, name: &str, seen: &mut Seen) {
    let mut game = Game::new(Arc::clone(level)).unwrap();
    let lead = focus.followed.unwrap_or(game.lead());
    let mut camera = Camera::new(game.world().body(lead).position);
    let mut onlookers = Onlooker::all();
    let every = (EVERY * game.tick_rate()) as u64;
    let mut look = |game: &Game, camera: &Camera| {
        let what = format!("{name} after {:.1} s", game.elapsed());
        let text = TEXTS[(game.ticks() / every % 2) as usize];
        let in_turn = onlookers.iter_mut().filter(|onlooker| onlooker.frame.text == text);
        in_turn.for_each(|onlooker| onlooker.look(game, (camera, focus), seen, &what));
    };
    let turn = |camera: &mut Camera, game: &Game| {
        camera.turn(focus.fits().then(|| moving(game, 1.0)), focus.zoom(), 1.0 / game.tick_rate());
    };
    turn(&mut camera, &game);
    look(&game, &camera);
    for controls in inputs {
        game.step(controls);
        let body = game.world().body(lead);
        camera.follow(body.position, body.velocity, 1.0 / game.tick_rate());
        turn(&mut camera, &game);
        if game.ticks().is_multiple_of(every) {
            look(&game, &camera);
        }
    }
}

/// Nearly everything has its place: the legend counts the arrows that are left out. (Bodies behind the head-up display have the least room.)
fn check(seen: &Seen) {
    assert!(seen.without_place * 100 <= seen.arrows, "{seen:?}");
    // Where nothing else is free the table of the ship takes the place of the legend: in a small window once in twenty looks.
    assert!(seen.without_legend * 16 <= seen.looks, "{seen:?}");
    assert!(seen.boxes >= seen.looks && seen.labels * 2 >= seen.arrows, "{seen:?}");
}

#[test]
fn along_every_recorded_flight_nothing_is_covered() {
    let mut seen = Seen::default();
    for (level, what, replay) in recorded() {
        watch(&level, &Focus::default(), replay.inputs.into_iter(), &what, &mut seen);
    }
    check(&seen);
}

#[test]
fn through_every_experiment_nothing_is_covered() {
    let mut seen = Seen::default();
    for name in experiments() {
        let level = experiment(&name);
        for focus in [Focus::fitted_on(BodyId(1)), Focus::fitted_on(BodyId(1)).on_nobody()] {
            let nobody = (0..(WATCHED * TICK_RATE) as usize).map(|_| Controls::default());
            watch(&level, &focus, nobody, &name, &mut seen);
        }
    }
    check(&seen);
    assert!(seen.usual > 2000, "{seen:?}");
}
