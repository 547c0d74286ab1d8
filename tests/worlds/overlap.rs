//! How deep things are in each other.

use resultant::physics::{Aabb, World};

/// The deepest overlap of any two bodies, or of a body and a surface, m.
pub fn worst_overlap(world: &World) -> f64 {
    let mut boxes: Vec<Aabb> = world.bodies().iter().map(|body| body.bounds()).collect();
    boxes.sort_by(|a, b| a.min.x.total_cmp(&b.min.x));
    let depth = |a: &Aabb, b: &Aabb| -a.gap(b).max_element();
    let mut worst = 0.0f64;
    for (i, a) in boxes.iter().enumerate() {
        worst = boxes[i + 1..].iter().take_while(|b| b.min.x < a.max.x).map(|b| depth(a, b)).fold(worst, f64::max);
        worst = world.surfaces().iter().map(|b| depth(a, &b.bounds)).fold(worst, f64::max);
    }
    worst
}
