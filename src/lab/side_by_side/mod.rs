//! Methods on the same scene at the same time, to be watched: boxes that move, a step at a time, and how they really move. How they
//! are drawn is not here.

mod motions;

use crate::physics::{Aabb, DVec2, World, WorldDef};

/// s. The steps that can be chosen.
pub const STEPS: [f64; 5] = [1.0 / 15.0, 1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0];
/// Which of them comes first: the one at which physics engines are usually run.
pub const USUAL_STEP: usize = 2;

/// Something that moves: makes one step and says where everything is, m.
pub type Motion = Box<dyn FnMut() -> Vec<Aabb>>;

/// What starts a motion from the beginning, in steps of so many seconds.
pub type Start = Box<dyn Fn(f64) -> Motion>;

/// A scene and the methods that can be watched on it.
pub struct Exhibit {
    /// Its heading.
    pub title: &'static str,
    /// What of the world is seen, m.
    pub view: Aabb,
    /// What does not move, m.
    pub solid: Vec<Aabb>,
    /// Where everything is at the beginning, m.
    pub start: Vec<Aabb>,
    /// How it really moves.
    pub exact: Start,
    /// By name; the last one is the shipped engine.
    pub methods: Vec<(&'static str, Start)>,
    /// The one to begin with: it is seen to fail.
    pub first: usize,
    /// How long it lasts, s.
    pub seconds: f64,
    /// Seconds of the scene a second: what is fast is slowed down.
    pub speed: f64,
}

impl std::fmt::Debug for Exhibit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Exhibit").field("title", &self.title).finish_non_exhaustive()
    }
}

/// All of them.
pub fn exhibits() -> Vec<Exhibit> {
    motions::all()
}

/// The largest distance by which a box is not where it should be, m; infinite where one is nowhere.
pub fn error(found: &[Aabb], exact: &[Aabb]) -> f64 {
    if found.len() != exact.len() {
        return f64::INFINITY;
    }
    let distances = found.iter().zip(exact).map(|(found, exact)| (found.centre() - exact.centre()).length());
    distances.fold(0.0, |worst: f64, distance| if distance.is_finite() { worst.max(distance) } else { f64::INFINITY })
}

/// Boxes whose places are known at any time, s.
fn known(places: impl Fn(f64) -> Vec<Aabb> + Clone + 'static) -> Start {
    Box::new(move |h| {
        let (places, mut steps) = (places.clone(), 0.0);
        Box::new(move || {
            steps += 1.0;
            places(steps * h)
        })
    })
}

fn area(left: f64, top: f64, right: f64, bottom: f64) -> Aabb {
    Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
}

fn square(x: f64, y: f64, half: f64) -> Aabb {
    Aabb::around(DVec2::new(x, y), DVec2::splat(half))
}

/// The shipped engine on such a world.
fn engine(def: WorldDef, h: f64) -> Motion {
    let mut world = World::new(def).ok();
    Box::new(move || {
        let Some(world) = &mut world else { return Vec::new() };
        world.step(h);
        world.bodies().iter().map(|body| body.bounds()).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::motions::{FAST, SHIPPED};
    use super::*;

    /// s.
    const STEP: f64 = STEPS[USUAL_STEP];

    /// How far a method is from the truth, at the worst of all ticks up to the end.
    fn worst_at(exhibit: &Exhibit, method: &str, h: f64) -> f64 {
        let (_, start) = exhibit.methods.iter().find(|(name, _)| *name == method).unwrap();
        let (mut motion, mut exact) = (start(h), (exhibit.exact)(h));
        (0..(exhibit.seconds / h) as usize).map(|_| error(&motion(), &exact())).fold(0.0, f64::max)
    }

    #[test]
    fn the_methods_part_and_the_shipped_engine_stays_with_the_truth() {
        let apart = [0.5, 0.1, 5.0, 1.0, 0.5, 0.5];
        let exhibits = exhibits();
        assert_eq!(exhibits.len(), apart.len());
        for (exhibit, apart) in exhibits.iter().zip(apart) {
            for (step, h) in STEPS.into_iter().enumerate() {
                let ours = worst_at(exhibit, SHIPPED, h);
                assert!(ours < 1e-6, "{}: {ours} m at step {step}", exhibit.title);
            }
            let method = exhibit.methods[exhibit.first].0;
            let theirs = worst_at(exhibit, method, STEP);
            assert!(theirs > apart, "{}, {method}: {theirs} m", exhibit.title);
        }
    }

    /// What moves fills its view, and does not leave it while it is right.
    #[test]
    fn what_moves_is_seen_all_the_while_and_no_speck() {
        for exhibit in exhibits() {
            let mut exact = (exhibit.exact)(STEP);
            let mut met = exhibit.start[0];
            for _ in 0..(exhibit.seconds / STEP) as usize {
                met = exact().iter().fold(met, |met, body| met.union(body));
            }
            // What is solid goes on beyond the view.
            let seen = |body: &Aabb| Aabb::new(body.min.max(exhibit.view.min), body.max.min(exhibit.view.max));
            met = exhibit.start.iter().copied().chain(exhibit.solid.iter().map(seen)).fold(met, |met, body| met.union(&body));
            let (used, whole) = (met.size(), exhibit.view.size());
            assert!(used.x > 0.6 * whole.x || used.y > 0.6 * whole.y, "{}: {used} of {whole}", exhibit.title);
        }
    }

    #[test]
    fn all_begin_in_the_same_place_and_in_view() {
        for exhibit in exhibits() {
            let first = (exhibit.exact)(STEP)();
            assert_eq!(exhibit.start.len(), first.len());
            let most = FAST * STEP + 1e-9;
            assert!(error(&exhibit.start, &first) <= most, "{}", exhibit.title);
            for body in &exhibit.start {
                assert!(body.min.cmpge(exhibit.view.min).all() && body.max.cmple(exhibit.view.max).all(), "{}", exhibit.title);
            }
        }
    }
}
