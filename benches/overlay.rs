//! What it costs to lay the details out for a frame, with thirty bodies in view: a sixtieth of a second is 16.7 ms.

use criterion::{Criterion, criterion_group, criterion_main};
use resultant::draw::layout::{Frame, Vec2};
use resultant::game::{Controls, Game};
use resultant::level;
use resultant::physics::DVec2;
use resultant::view::camera::{CanvasWindow, Viewport};
use resultant::view::details::{Details, Looking};
use resultant::view::focus::Focus;
use std::path::Path;
use std::sync::Arc;

/// Thirty bodies that fall, bounce and lie about each other in view of the ship.
fn crowd() -> Game {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut level = level::load(&root.join("levels/experiments/bounce"), root).expect("the experiment loads").level;
    let one = level.objects[0].clone();
    let place = |i: usize| DVec2::new(3.0 + 1.3 * (i % 15) as f64, level.size.y - 2.0 - 3.0 * (i / 15) as f64);
    level.objects = (0..30).map(|i| level::Object { position: place(i), ..one.clone() }).collect();
    Game::new(Arc::new(level)).expect("the level makes a world")
}

fn arranging(c: &mut Criterion) {
    let mut group = c.benchmark_group("details of 30 bodies");
    for (name, pixels) in [("900 × 500", Vec2::new(900.0, 500.0)), ("1920 × 1080", Vec2::new(1920.0, 1080.0))] {
        let (mut game, frame, mut details) = (crowd(), Frame::of_window(pixels), Details::default());
        let window = CanvasWindow { size: frame.size.as_dvec2(), pixel: f64::from(frame.pixel) };
        group.bench_function(name, |b| {
            b.iter(|| {
                game.step(Controls::default());
                let centres: Vec<DVec2> = game.world().bodies().iter().map(|body| body.position).collect();
                let middle = DVec2::new(12.0, game.level().size.y);
                let view = Viewport::new(middle, middle, game.level().size, game.level().metre, window);
                let looking = Looking { centres: &centres, focus: &Focus::default(), pointer: None, model: false, velocity: true };
                details.arrange(&game, &looking, &[], &view, &frame);
                details.arranged.arrows.len()
            });
        });
        println!("{} arrows, {} boxes, {} left out", details.arranged.arrows.len(), details.boxes.len(), details.left_out);
    }
    group.finish();
}

criterion_group!(benches, arranging);
criterion_main!(benches);
