//! The camera: it follows the ship, shows nothing outside of the level, and never loses the ship, in windows and levels of any size.

use crate::onlook::{self, pixels};
use crate::support::area;
use crate::support::rooms::{crate_at, yard};
use crate::support::shipped::{experiment, experiments};
use resultant::draw::layout::{Area, Frame, Vec2, nearest_size, words_width};
use resultant::game::{Controls, Game, SHIP};
use resultant::level::Object;
use resultant::physics::{Aabb, BodyId, DVec2};
use resultant::view::camera::{Camera, CanvasWindow, Viewport};
use resultant::view::focus::Focus;
use resultant::view::{GameView, Overlays};
use std::sync::Arc;

const METRE: f64 = 30.0;
const HALF_SHIP: DVec2 = DVec2::splat(0.85);
const WINDOWS: [CanvasWindow; 4] = [
    CanvasWindow { size: DVec2::new(1280.0, 720.0), pixel: 1.0 },
    CanvasWindow { size: DVec2::new(1296.0, 720.0), pixel: 1.44 },
    CanvasWindow { size: DVec2::new(1280.0, 720.0), pixel: 2.0 / 3.0 },
    CanvasWindow { size: DVec2::new(1280.0, 2000.0), pixel: 1.0 },
];

fn view(focus: DVec2, ship: DVec2, level: DVec2, window: CanvasWindow) -> Viewport {
    Viewport::new(focus, ship, level, METRE, window)
}

/// Places of the ship from one corner of a level to the other.
fn places(level: DVec2) -> impl Iterator<Item = DVec2> {
    let room = level - 2.0 * HALF_SHIP;
    (0..=10).flat_map(move |i| (0..=10).map(move |j| HALF_SHIP + room * DVec2::new(f64::from(i), f64::from(j)) / 10.0))
}

#[test]
fn in_a_large_level_the_ship_is_in_the_middle_of_the_window_except_near_an_edge() {
    let (level, middle) = (DVec2::new(200.0, 150.0), DVec2::new(90.0, 60.0));
    for window in WINDOWS {
        for (ship, expected) in [(middle, window.size * 0.5), (HALF_SHIP, HALF_SHIP * METRE)] {
            let at = view(ship, ship, level, window).point(ship).as_dvec2();
            assert!((at - expected).abs().max_element() <= window.pixel, "{at} in {window:?}");
        }
    }
    let view = view(middle, middle, level, WINDOWS[0]);
    assert_eq!((view.point(middle + 1.0) - view.point(middle)).as_dvec2(), DVec2::splat(30.0), "a metre, and down is down");
}

#[test]
fn nothing_outside_of_a_level_larger_than_the_window_is_shown_wherever_the_ship_is() {
    let level = DVec2::new(120.0, 90.0);
    for window in WINDOWS {
        for ship in places(level) {
            for shake in [DVec2::ZERO, DVec2::new(6.0, -6.0), DVec2::new(-6.0, 6.0), DVec2::new(6.0, 6.0), DVec2::new(-6.0, -6.0)] {
                let visible = view(ship, ship, level, window).shaken(shake).visible();
                // Whole pixels: half of one is the most that rounding can show.
                let slack = window.pixel / METRE;
                assert!(Aabb::new(DVec2::ZERO, level).contains(&visible, slack), "{visible:?} at {ship} shaken by {shake}");
            }
        }
    }
}

#[test]
fn the_ship_never_leaves_the_screen_however_far_the_camera_lags() {
    for level in [DVec2::new(120.0, 90.0), DVec2::new(20.0, 300.0), DVec2::new(500.0, 12.0), DVec2::new(30.0, 15.0)] {
        for window in WINDOWS {
            for ship in places(level) {
                for focus in [DVec2::ZERO, level, DVec2::splat(-1e4), DVec2::splat(1e4)] {
                    let visible = view(focus, ship, level, window).visible();
                    let slack = window.pixel / METRE;
                    assert!(visible.contains(&Aabb::around(ship, HALF_SHIP), slack), "{ship} is not in {visible:?} of {level}");
                }
            }
        }
    }
}

#[test]
fn a_level_a_little_smaller_than_the_window_is_magnified_until_it_fills_it() {
    // 40 m × 22 m at 30 units a metre would leave a strip in a window of 1280 × 720.
    let (level, ship) = (DVec2::new(40.0, 22.0), DVec2::new(3.0, 20.0));
    let view = view(ship, ship, level, WINDOWS[0]);
    assert!(view.scale > METRE && view.scale <= 1.5 * METRE);
    assert!(Aabb::new(DVec2::ZERO, level).contains(&view.visible(), 1.0 / METRE));
}

#[test]
fn a_level_much_smaller_than_the_window_is_centred_and_stands_still() {
    let level = DVec2::new(10.0, 6.0);
    for window in WINDOWS {
        let views: Vec<Viewport> = places(level).map(|ship| view(ship, ship, level, window)).collect();
        assert!(views.windows(2).all(|pair| pair[0] == pair[1]), "the view moves with the ship");
        let middle = views[0].point(level * 0.5).as_dvec2();
        assert!((middle - window.size * 0.5).abs().max_element() <= window.pixel);
    }
}

#[test]
fn closing_in_keeps_the_ship_where_it_is_and_shows_nothing_outside() {
    let level = DVec2::new(120.0, 90.0);
    for window in WINDOWS {
        for ship in places(level) {
            let usual = view(ship, ship, level, window);
            let close = usual.closer(ship, 1.35);
            assert_eq!(close.scale, 1.35 * usual.scale);
            let (before, after) = (usual.point(ship).as_dvec2(), close.point(ship).as_dvec2());
            let free = |at: f64, size: f64| (3.0 * close.scale..=size - 3.0 * close.scale).contains(&at);
            if free(before.x, window.size.x) && free(before.y, window.size.y) {
                assert!((after - before).abs().max_element() <= 2.0 * window.pixel, "the ship at {ship}: {before}, then {after}");
            }
            assert!(Aabb::new(DVec2::ZERO, level).contains(&close.visible(), window.pixel / METRE));
            assert!(close.visible().contains(&Aabb::around(ship, HALF_SHIP), window.pixel / METRE));
        }
        // One that is smaller than the window stays in its middle.
        let small = DVec2::new(10.0, 6.0);
        let close = view(small, small, small, window).closer(small, 1.35);
        let off = (close.point(small * 0.5).as_dvec2() - window.size * 0.5).abs().max_element();
        assert!(off <= window.pixel, "{off}");
    }
    let mut camera = Camera::new(DVec2::ZERO);
    assert_eq!(camera.closeness, 1.0);
    (0..240).for_each(|_| camera.close_in(1.0 / 60.0));
    assert!((camera.closeness - 1.35).abs() < 1e-3);
}

#[test]
fn a_level_taller_than_wide_is_centred_across_and_followed_along() {
    let level = DVec2::new(20.0, 200.0);
    let (low, high) = (DVec2::new(4.0, 150.0), DVec2::new(16.0, 60.0));
    let (a, b) = (view(low, low, level, WINDOWS[0]), view(high, high, level, WINDOWS[0]));
    assert_eq!(a.point(DVec2::ZERO).x, b.point(DVec2::ZERO).x);
    assert!((a.point(low).y - 360.0).abs() <= 1.0 && (b.point(high).y - 360.0).abs() <= 1.0);
}

#[test]
fn the_camera_eases_the_same_way_at_every_frame_rate() {
    let target = DVec2::new(10.0, -4.0);
    let after = |frames: u32| {
        let mut camera = Camera::new(DVec2::ZERO);
        (0..frames).for_each(|_| camera.follow(target, DVec2::new(8.0, -3.0), 0.25 / f64::from(frames)));
        camera.focus()
    };
    let (slow, fast) = (after(8), after(36));
    assert!((slow - fast).length() < 1e-9, "{slow} against {fast}");
    assert!((slow - target).length() < 0.2 * target.length(), "it has not come near");
    assert!((after(1) - fast).length() < 1e-9);
}

#[test]
fn a_shake_moves_the_view_and_where_it_may_not_go_outwards_it_goes_inwards() {
    let level = DVec2::new(120.0, 90.0);
    let corner = HALF_SHIP;
    let still = view(corner, corner, level, WINDOWS[0]);
    let shaken = still.shaken(DVec2::new(-5.0, -3.0));
    assert_eq!((shaken.point(corner) - still.point(corner)).as_dvec2(), DVec2::new(-5.0, -3.0));
}

#[test]
fn it_looks_ahead_of_a_ship_that_flies_and_at_one_that_rests() {
    let follow = |camera: &mut Camera, ship: &mut DVec2, velocity: DVec2, seconds: f64| {
        for _ in 0..(seconds * 60.0) as usize {
            *ship += velocity / 60.0;
            camera.follow(*ship, velocity, 1.0 / 60.0);
        }
        camera.focus() - *ship
    };
    let (mut camera, mut ship) = (Camera::new(DVec2::ZERO), DVec2::ZERO);
    // It must more than make up for its lag.
    let flying = follow(&mut camera, &mut ship, DVec2::new(12.0, -6.0), 4.0);
    assert!(flying.x > 1.5 && flying.y < -0.7, "{flying}");
    let fast = follow(&mut camera, &mut ship, DVec2::new(40.0, 0.0), 4.0);
    assert!(fast.x < 7.0, "{fast}: the ship would be near the edge");
    let resting = follow(&mut camera, &mut ship, DVec2::ZERO, 6.0);
    assert!(resting.length() < 0.02, "{resting}");
    // A drifting ship does not sway it.
    let drifting = follow(&mut camera, &mut ship, DVec2::new(1.5, 1.5), 4.0);
    assert!(drifting.length() < 0.4, "{drifting}");
}

#[test]
fn a_bump_does_not_throw_it_about() {
    let mut camera = Camera::new(DVec2::ZERO);
    for i in 0..60 {
        // Thrown to and fro between two walls close together, at 15 m/s.
        let velocity = DVec2::new(if i / 3 % 2 == 0 { 15.0 } else { -15.0 }, 0.0);
        let before = camera.focus();
        camera.follow(DVec2::ZERO, velocity, 1.0 / 60.0);
        assert!((camera.focus() - before).length() * 60.0 < 13.0, "it jerks at {i}");
        assert!(camera.focus().length() < 1.5);
    }
}

/// A camera that has turned to `fit` for `frames` frames.
fn turned(fit: Option<Aabb>, zoom: f64, frames: u32) -> Camera {
    let mut camera = Camera::new(DVec2::new(60.0, 45.0));
    (0..frames).for_each(|_| camera.turn(fit, zoom, 1.0 / 60.0));
    camera
}

#[test]
fn a_fitted_view_holds_what_moves_and_is_no_closer_than_usual() {
    let level = DVec2::new(120.0, 90.0);
    for window in WINDOWS {
        let usual = view(level * 0.5, level * 0.5, level, window).scale;
        for [left, top, right, bottom] in
            [[1.0, 1.0, 2.0, 2.0], [5.0, 5.0, 70.0, 20.0], [80.0, 1.0, 119.0, 89.0], [0.0, 0.0, 120.0, 90.0]]
        {
            let bounds = area(left, top, right, bottom);
            let fitted = turned(Some(bounds), 1.0, 1).viewport(DVec2::splat(60.0), level, METRE, window);
            assert!(fitted.visible().contains(&bounds, window.pixel / fitted.scale), "{bounds:?} in {:?}", fitted.visible());
            assert!(fitted.scale <= usual && fitted.visible().size().min_element() > 0.0);
        }
    }
}

/// At any speed of the ship; the view opens at once and closes slowly.
#[test]
fn what_is_fitted_never_leaves_the_view() {
    let (level, window) = (DVec2::new(400.0, 200.0), WINDOWS[0]);
    let bounds = |x: f64| Aabb::new(DVec2::new(10.0, 90.0), DVec2::new(x + 1.0, 91.0));
    let mut camera = turned(Some(bounds(10.0)), 1.0, 1);
    let wide = |camera: &Camera| camera.viewport(DVec2::splat(50.0), level, METRE, window).visible();
    for step in 0..60 {
        // 300 m/s.
        let now = bounds(10.0 + 5.0 * f64::from(step));
        camera.turn(Some(now), 1.0, 1.0 / 60.0);
        assert!(wide(&camera).contains(&now, 0.1), "{now:?} in {:?}", wide(&camera));
    }
    let opened = wide(&camera).size().x;
    camera.turn(Some(bounds(10.0)), 1.0, 1.0 / 60.0);
    assert!(wide(&camera).size().x > 0.9 * opened, "it does not jump");
    (0..600).for_each(|_| camera.turn(Some(bounds(10.0)), 1.0, 1.0 / 60.0));
    assert!(wide(&camera).size().x < 0.5 * opened);
}

#[test]
fn zooming_draws_larger_and_smaller_as_far_as_the_whole_level() {
    let (level, ship) = (DVec2::new(200.0, 150.0), DVec2::new(90.0, 60.0));
    for window in WINDOWS {
        let at = |zoom: f64| {
            let mut camera = Camera::new(ship);
            camera.turn(None, zoom, 1.0 / 60.0);
            camera.viewport(ship, level, METRE, window)
        };
        let usual = at(1.0);
        assert_eq!((at(2.0).scale, at(0.5).scale), (2.0 * usual.scale, 0.5 * usual.scale));
        assert!(at(2.0).visible().contains(&Aabb::around(ship, HALF_SHIP), 0.0));
        assert!(at(1e-3).visible().contains(&Aabb::new(DVec2::ZERO, level), window.pixel / at(1e-3).scale));
        assert_eq!(at(1e-3).scale, at(1e-6).scale, "no further than the whole level");
    }
    // It turns to another zoom by and by.
    let mut camera = turned(None, 1.0, 1);
    camera.turn(None, 2.0, 1.0 / 60.0);
    let after = camera.viewport(ship, level, METRE, WINDOWS[0]).scale;
    assert!(after > METRE && after < 1.5 * METRE, "{after}");
}

#[test]
fn a_fast_ship_has_a_wider_view_and_one_that_rests_the_usual_one() {
    let (level, ship) = (DVec2::new(400.0, 300.0), DVec2::new(200.0, 150.0));
    let mut camera = Camera::new(ship);
    let mut scale = |speed: f64| {
        (0..600).for_each(|_| camera.follow(ship, DVec2::new(speed, 0.0), 1.0 / 60.0));
        camera.viewport(ship, level, METRE, WINDOWS[0]).scale / METRE
    };
    assert!((scale(5.0) - 1.0).abs() < 1e-9);
    let (fast, faster) = (scale(16.0), scale(40.0));
    assert!(fast < 0.95 && faster < fast && faster > 0.7, "{fast}, {faster}");
    assert!(scale(0.0) > 0.999);
}

/// A ship that hits a crate, which flies off faster than the ship.
#[test]
fn the_ship_and_what_it_has_set_in_motion_stay_in_view_and_the_map_shows_all() {
    let mut level = yard();
    (level.gravity, level.air_density) = (0.0, 0.0);
    let struck = Object { restitution: 1.0, ..crate_at(DVec2::new(14.0, 30.0), DVec2::ZERO, None) };
    level.objects = vec![struck, crate_at(DVec2::new(10.0, 95.0), DVec2::ZERO, None)];
    level.objectives.truncate(1);
    (level.player.position, level.player.velocity) = (DVec2::new(10.0, 30.0), DVec2::new(12.0, 0.0));
    let mut game = Game::new(Arc::new(level)).unwrap();
    let (frame, mut view) = (Frame::of_window(Vec2::new(1280.0, 720.0)), GameView::new(&game, &|_| None));
    let overlays = Overlays::default();
    let seen = |view: &GameView, game: &Game, body: u32| {
        let at = view.viewport(game, 1.0, &frame).point(game.world().body(BodyId(body)).position);
        frame.area().contains(at)
    };
    let mut farthest: f64 = 0.0;
    for _ in 0..480 {
        game.step(Controls::default());
        view.after_tick(&game);
        view.update(&game, 1.0, 1.0 / 120.0, overlays, &frame);
        let apart = game.world().body(BodyId(1)).position.distance(game.world().body(SHIP).position);
        farthest = farthest.max(apart);
        if apart < 35.0 {
            assert!(seen(&view, &game, 0) && seen(&view, &game, 1), "{apart} m apart at tick {}", game.ticks());
        }
    }
    assert!(farthest > 12.0, "{farthest}");
    assert!(!seen(&view, &game, 2), "a crate that stands still does not matter");
    (0..240).for_each(|_| view.update(&game, 1.0, 1.0 / 120.0, Overlays { map: true, ..overlays }, &frame));
    let (all, visible) = (game.level().size, view.viewport(&game, 1.0, &frame).visible());
    assert!(visible.contains(&Aabb::new(DVec2::ZERO, all), 0.1), "{visible:?} of {all}");
}

/// The part of the canvas that the sheet of an experiment takes, canvas units.
const SHEET: f32 = 568.0;

#[test]
fn all_words_of_an_experiment_are_in_view_at_its_start_beside_its_sheet() {
    for name in experiments() {
        let game = Game::new(experiment(&name)).unwrap();
        for size in onlook::WINDOWS {
            let whole = Frame::of_window(size);
            for frame in [whole, Frame { size: whole.size - SHEET * Vec2::X, ..whole }] {
                // A tall window has no room for both.
                if frame.size.x < frame.size.y {
                    continue;
                }
                let mut view = GameView::new(&game, &|_| None);
                let overlays = Overlays { focus: Focus::fitted_on(game.lead()), ..Overlays::default() };
                view.update(&game, 1.0, 1.0 / 60.0, overlays, &frame);
                let viewport = view.viewport(&game, 1.0, &frame);
                for text in &game.level().texts {
                    let height = frame.text_height(nearest_size(viewport.length(text.size)));
                    let at = Area { min: viewport.point(text.position), size: Vec2::new(words_width(&text.text, height), height) };
                    let inside = at.min.cmpge(Vec2::ZERO).all() && at.max().cmple(frame.size).all();
                    assert!(inside, "{name} in {}: {:?} at {at:?} of {:?}", pixels(&frame), text.text, frame.size);
                }
            }
        }
    }
}
