//! Methods on the same scene at the same time, to be watched: boxes that move, a step at a time, and their exact places; without their drawing.

use super::contract::{By, Model, contenders};
use super::{methods::INTEGRATORS, methods::METHODS, scenes::flight, scenes::flight::FlyingBody};
use super::{methods::chain::Chain, methods::impact::LineBlock, scenes::springs};
use super::{methods::motion::MotionStep, methods::motion::PointState, scenes::collisions, scenes::collisions::BlockLine};
use super::{scenes::bouncing, scenes::bouncing::BouncingBall, scenes::stacks, scenes::stacks::ContactChain};
use crate::physics::{Aabb, DVec2};

/// s. The player chooses among these steps.
pub const STEPS: [f64; 5] = [1.0 / 15.0, 1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0];
/// The index of the step that physics engines usually run at.
pub const USUAL_STEP: usize = 2;

/// Makes one step and returns the place of each box, m.
pub type BoxMotion = Box<dyn FnMut() -> Vec<Aabb>>;

pub type MotionStart = Box<dyn Fn(f64) -> BoxMotion>;

pub struct Exhibit {
    pub title: &'static str,
    /// m.
    pub view: Aabb,
    /// m.
    pub solid: Vec<Aabb>,
    /// The place to which its body is bound, m.
    pub bound: Option<DVec2>,
    /// m.
    pub start: Vec<Aabb>,
    pub exact: MotionStart,
    /// By name; the last one is the shipped engine.
    pub methods: Vec<(&'static str, MotionStart)>,
    /// The method to begin with: it visibly fails.
    pub first: usize,
    /// s.
    pub seconds: f64,
    /// Seconds of the scene a second of watching: fast scenes are slowed down.
    pub speed: f64,
}

impl std::fmt::Debug for Exhibit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Exhibit").field("title", &self.title).finish_non_exhaustive()
    }
}

/// m/s. Speed of the box that meets a thin wall: a step is longer than both are thick.
const FAST: f64 = 43.0;
/// m. Start of the box that bounces for ever.
const DROP: f64 = 2.0;
/// m. All below y = 0.
const GROUND: Aabb = Aabb { min: DVec2::new(-1e3, 0.0), max: DVec2::new(1e3, 1e3) };

pub fn exhibits() -> Vec<Exhibit> {
    vec![bounce(), throw(), oscillator(), pendulum(), wall(), cradle(), column(), heavy_on_light()]
}

/// The largest distance of a box from its exact place, m; infinite where one is not finite.
pub fn error(found: &[Aabb], exact: &[Aabb]) -> f64 {
    if found.len() != exact.len() {
        return f64::INFINITY;
    }
    let distances = found.iter().zip(exact).map(|(found, exact)| (found.centre() - exact.centre()).length());
    distances.fold(0.0, |worst: f64, distance| if distance.is_finite() { worst.max(distance) } else { f64::INFINITY })
}

impl Exhibit {
    /// A model with methods by hand and the shipped engine; `boxes` shows a state, and `exact` the boxes at a time, s.
    fn of<M: Model + 'static>(
        title: &'static str,
        model: M,
        by_hand: impl IntoIterator<Item = (&'static str, M::Method)>,
        boxes: impl Fn(&M::State) -> Vec<Aabb> + Copy + 'static,
        exact: impl Fn(f64) -> Vec<Aabb> + Clone + 'static,
    ) -> Self
    where
        M::Method: 'static,
    {
        let start = boxes(&model.start());
        let methods = contenders(by_hand).map(|(name, by)| {
            let model = model.clone();
            let begin = move |h: f64| -> BoxMotion {
                let mut running = model.running(by, h);
                Box::new(move || running.step().map_or_else(Vec::new, |(_, state)| boxes(state)))
            };
            (name, Box::new(begin) as MotionStart)
        });
        let methods = methods.collect();
        Self {
            title,
            view: GROUND,
            solid: Vec::new(),
            bound: None,
            start,
            exact: known(exact),
            methods,
            first: 0,
            seconds: 20.0,
            speed: 1.0,
        }
    }
}

/// Boxes whose places are known at any time, s.
fn known(places: impl Fn(f64) -> Vec<Aabb> + Clone + 'static) -> MotionStart {
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

fn bounce() -> Exhibit {
    let ball = BouncingBall { height: DROP, e: 1.0, rest_speed: 0.0 };
    let at = |height: f64| vec![Aabb::around(DVec2::new(0.0, -0.5 - height), DVec2::splat(0.5))];
    let exact = move |t| at(ball.height_at(t));
    Exhibit {
        view: area(-4.0, -3.4, 4.0, 0.5),
        solid: vec![GROUND],
        seconds: 60.0,
        ..Exhibit::of("A box bounces without loss", ball, bouncing::METHODS, move |ball| at(ball.0), exact)
    }
}

fn standing(title: &'static str, view: Aabb, masses: Vec<f64>) -> Exhibit {
    let at = |(i, moved): (usize, &f64)| Aabb::around(DVec2::new(0.0, -0.5 - i as f64 - moved), DVec2::splat(0.5));
    let places: Vec<Aabb> = masses.iter().map(|_| &0.0).enumerate().map(at).collect();
    let boxes = move |chain: &Chain| chain.places[1..].iter().enumerate().map(at).collect();
    let exhibit = Exhibit::of(title, ContactChain::standing(masses), stacks::SOLVERS, boxes, move |_| places.clone());
    Exhibit { view, solid: vec![GROUND], ..exhibit }
}

fn column() -> Exhibit {
    standing("A column of 20 blocks stands", area(-11.0, -21.0, 11.0, 1.0), vec![1.0; 20])
}

fn heavy_on_light() -> Exhibit {
    standing("10 000 kg rest on 1 kg", area(-2.0, -2.5, 2.0, 0.25), vec![1.0, 10_000.0])
}

/// Blocks on a line that hit each other; `places` gives the places of all blocks at a time, s.
fn line(title: &'static str, line: BlockLine, places: impl Fn(f64) -> Vec<f64> + Clone + 'static) -> Exhibit {
    let boxes = |blocks: &Vec<LineBlock>| -> Vec<Aabb> {
        let movable = blocks.iter().filter(|block| block.mass.is_finite());
        movable.map(|block| Aabb::around(DVec2::new(block.x, 0.0), DVec2::new(block.half, 0.5))).collect()
    };
    let blocks = line.blocks.clone();
    let exact = move |t| boxes(&blocks.iter().zip(places(t)).map(|(block, x)| LineBlock { x, ..*block }).collect());
    Exhibit::of(title, line, collisions::METHODS, boxes, exact)
}

fn wall() -> Exhibit {
    let flying = LineBlock { x: -14.7, v: FAST, mass: 1.0, half: 0.25 };
    let wall = LineBlock { x: 0.0, v: 0.0, mass: f64::INFINITY, half: 0.05 };
    let touch = wall.x - wall.half - flying.half;
    let places = move |t| {
        let free = flying.x + FAST * t;
        vec![if free > touch { 2.0 * touch - free } else { free }, wall.x]
    };
    Exhibit {
        view: area(-15.2, -5.2, 4.8, 5.2),
        solid: vec![area(-wall.half, -1e3, wall.half, 1e3)],
        seconds: 0.6,
        speed: 0.1,
        ..line("A fast box meets a thin wall", BlockLine::of(vec![flying, wall]), places)
    }
}

fn cradle() -> Exhibit {
    let blocks = BlockLine::cradle(5);
    let known = blocks.clone();
    let places = move |t| (0..5).map(|block| known.cradle_place(block, t)).collect();
    Exhibit {
        view: area(-2.8, -3.6, 10.8, 3.6),
        first: 3,
        seconds: 2.5,
        speed: 0.5,
        ..line("Newton's cradle of five blocks", blocks, places)
    }
}

fn throw() -> Exhibit {
    // Twice its size, to be seen from afar.
    let exhibit = by_reference("A throw with drag and wind", flight::thrown(), &METHODS, 1.0);
    Exhibit { view: area(-2.0, -14.0, 34.0, 8.0), first: 1, seconds: 3.0, ..exhibit }
}

/// A body whose exact motion is that of the reference, shown as a box of `2·half` m.
fn by_reference(title: &'static str, body: FlyingBody, methods: &[(&'static str, MotionStep)], half: f64) -> Exhibit {
    let at = move |point: &PointState| vec![Aabb::around(point.x, DVec2::splat(half))];
    let exact = body.clone();
    let exhibit = Exhibit::of(title, body, methods.iter().copied(), at, |_| Vec::new());
    let exact = move |h: f64| -> BoxMotion {
        let mut running = exact.running(By::Hand(flight::drag_in_two_dimensions), h);
        Box::new(move || running.step().map_or_else(Vec::new, |(_, point)| at(point)))
    };
    Exhibit { exact: Box::new(exact), ..exhibit }
}

/// On a circle, so that the gain of explicit Euler shows as a spiral.
fn oscillator() -> Exhibit {
    let (omega, radius) = (2.0, 2.0);
    let at = |place: DVec2| vec![Aabb::around(place, DVec2::splat(0.3))];
    let body = springs::oscillator(omega * omega, radius, true);
    let exact = move |t: f64| at(DVec2::from_angle(omega * t) * radius);
    let exhibit = Exhibit::of("A body on a spring goes round", body, INTEGRATORS.iter().copied(), move |point| at(point.x), exact);
    Exhibit { view: area(-5.4, -3.2, 5.4, 3.2), bound: Some(DVec2::ZERO), seconds: 30.0, ..exhibit }
}

fn pendulum() -> Exhibit {
    let exhibit = by_reference("A pendulum swings", springs::pendulum(4.0, 1.0), INTEGRATORS, 0.3);
    Exhibit { view: area(-4.4, -0.4, 4.4, 4.8), bound: Some(DVec2::ZERO), seconds: 20.0, ..exhibit }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::contract::SHIPPED;

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
        let apart = [0.5, 0.1, 1.0, 0.5, 5.0, 1.0, 0.5, 0.5];
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

    /// Moving boxes fill their view, and do not leave it while the method is right.
    #[test]
    fn what_moves_is_seen_all_the_while_and_no_speck() {
        for exhibit in exhibits() {
            let mut exact = (exhibit.exact)(STEP);
            let mut met = exhibit.start[0];
            for _ in 0..(exhibit.seconds / STEP) as usize {
                met = exact().iter().fold(met, |met, body| met.union(body));
            }
            // Immovable things go on beyond the view.
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
