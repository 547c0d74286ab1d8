//! The scenes, one file a family. A scene builds its exact answer once; its methods return how far from it they end.

pub mod bouncing;
pub mod collisions;
pub mod flight;
pub mod oscillator;
pub mod springs;
pub mod stacks;

use super::LabScene;

/// In the order of the report.
pub fn all() -> Vec<LabScene> {
    vec![
        flight::fall(),
        flight::rise(),
        flight::liquid(),
        flight::projectile(),
        flight::gust(),
        oscillator::swing(),
        oscillator::energy_kept(),
        springs::pendulum_swing(),
        springs::shock_absorber(),
        springs::orbit(),
        bouncing::to_a_stop(),
        bouncing::perfect(),
        bouncing::apexes(),
        collisions::cradle(),
        stacks::column(),
        stacks::heavy_on_light(),
        stacks::pushed_row(),
        stacks::friction_tower(),
        stacks::time_to_rest(),
        collisions::thin_wall(),
        collisions::digits(),
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
