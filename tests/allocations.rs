//! A step allocates nothing once its scratch has grown to the scene.

use glam::DVec2;
use resultant::physics::Aabb;
use resultant::physics::pile::{Pile, PileBody, PileDef, PileSurface};
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

struct Counting;

static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is handed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn a_warm_step_allocates_nothing() {
    let surface = |left, top, right, bottom| PileSurface {
        bounds: Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom)),
        static_friction: 0.9,
        kinetic_friction: 0.65,
    };
    let bodies = (0..400)
        .map(|i| PileBody {
            position: DVec2::new(0.5 + f64::from(i % 20), -1.0 - 1.1 * f64::from(i / 20)),
            half: DVec2::splat(0.3 + 0.01 * f64::from(i % 13)),
            velocity: DVec2::new(f64::from(i % 5) - 2.0, 0.0),
            ..PileBody::default()
        })
        .collect();
    let surfaces = vec![surface(-5.0, 0.0, 25.0, 1.0), surface(-1.0, -99.0, 0.0, 0.0), surface(20.0, -99.0, 21.0, 0.0)];
    let mut pile = Pile::new(PileDef { bodies, surfaces, sleep: false, ..PileDef::default() }).unwrap();
    (0..120).for_each(|_| pile.step(1.0 / 60.0));
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    (0..300).for_each(|_| pile.step(1.0 / 60.0));
    assert_eq!(ALLOCATIONS.load(Ordering::Relaxed), before);
}
