//! The scenes, one file a family. A scene builds its exact answer once; its methods return how far from it they end.

pub mod bouncing;
pub mod collisions;
pub mod flight;
pub mod oscillator;
pub mod pi;
pub mod sliding;
pub mod springs;
pub mod stacks;
pub mod tunnelling;

use super::LabScene;

/// In the order of the report.
pub fn all() -> Vec<LabScene> {
    vec![
        flight::fall(),
        flight::parabola(),
        flight::fall_with_drag(),
        flight::rise(),
        flight::drag_without_weight(),
        flight::liquid(),
        flight::projectile(),
        flight::gust(),
        oscillator::swing(),
        oscillator::energy_kept(),
        springs::swing(),
        springs::pendulum_swing(),
        sliding::to_a_stop(),
        bouncing::perfect(),
        bouncing::apexes(),
        collisions::head_on(),
        collisions::cradle(),
        stacks::column(),
        stacks::heavy_on_light(),
        stacks::pushed_row(),
        tunnelling::thin_wall(),
        tunnelling::bodies(),
        pi::digits(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shipped_engine_keeps_every_scene_within_a_tenth_of_a_pixel() {
        for scene in all() {
            for method in scene.methods.iter().filter(|method| method.shipped) {
                let error = (method.run)(scene.shipped_step);
                assert!(error <= scene.tolerance, "{}: {error}", scene.name);
            }
        }
    }
}
