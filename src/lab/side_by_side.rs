//! Methods on the same scene at the same time, to be watched: boxes that move, a step at a time, and how they really move. How they
//! are drawn is not here.

use super::methods::bounce::Ball;
use super::methods::chain::Chain;
use super::methods::impact::Block;
use super::methods::motion::{self, Step};
use super::scenes::{bouncing, collisions, drag, stacks};
use super::{reference, shipped};
use crate::physics::{Aabb, BodyDef, DVec2, World, WorldDef};

/// s. The steps that can be chosen.
pub const STEPS: [f64; 5] = [1.0 / 15.0, 1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0];
/// Which of them comes first: the one at which physics engines are usually run.
pub const USUAL_STEP: usize = 2;
/// N/kg.
const G: f64 = 9.81;
/// m/s. Of the box that meets a thin wall: it travels further in a step than both are thick.
const FAST: f64 = 43.0;
/// m. From where a box falls to bounce for ever.
const DROP: f64 = 2.0;

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
    vec![bounce(), throw(), wall(), cradle(), column(), heavy_on_light()]
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

const SHIPPED: &str = "shipped engine";

fn bounce() -> Exhibit {
    let at = |height: f64| vec![square(0.0, -0.5 - height, 0.5)];
    let mut methods: Vec<(&'static str, Start)> = Vec::new();
    for (name, bounce) in bouncing::METHODS {
        let start = move |h: f64| -> Motion {
            let mut ball: Ball = (DROP, 0.0);
            Box::new(move || {
                ball = bounce(ball, G, 1.0, h);
                at(ball.0)
            })
        };
        methods.push((name, Box::new(start)));
    }
    let body = BodyDef { restitution: 1.0, ..shipped::crate_at(0.0, DROP, 1.0) };
    methods.push((SHIPPED, Box::new(move |h| engine(shipped::on_floor(G, 0.0, vec![body.clone()]), h))));
    Exhibit {
        title: "A box bounces without loss",
        view: area(-3.0, -4.0, 3.0, 0.5),
        solid: vec![area(-3.0, 0.0, 3.0, 0.5)],
        start: at(DROP),
        exact: known(move |t| {
            // From floor to floor it takes twice the fall.
            let fall = (2.0 * DROP / G).sqrt();
            let since = (t + fall) % (2.0 * fall);
            at(G * since * (fall - 0.5 * since))
        }),
        methods,
        first: 0,
        seconds: 60.0,
        speed: 1.0,
    }
}

/// Blocks that stand on each other, and shall.
fn standing(title: &'static str, view: Aabb, masses: &'static [f64]) -> Exhibit {
    let at = |i: usize, moved: f64| square(0.0, -0.5 - i as f64 - moved, 0.5);
    let mut methods: Vec<(&'static str, Start)> = Vec::new();
    for (name, solver) in stacks::SOLVERS {
        let start = move |h: f64| -> Motion {
            let mut chain = Chain::new(masses, true);
            let mut accelerations = vec![-G; masses.len() + 1];
            accelerations[0] = 0.0;
            Box::new(move || {
                chain.step(&accelerations, solver, h);
                chain.places[1..].iter().enumerate().map(|(i, moved)| at(i, *moved)).collect()
            })
        };
        methods.push((name, Box::new(start)));
    }
    let blocks = || masses.iter().enumerate().map(|(i, mass)| shipped::crate_at(0.0, i as f64, *mass)).collect();
    methods.push((SHIPPED, Box::new(move |h| engine(shipped::on_floor(G, 1.0, blocks()), h))));
    let places: Vec<Aabb> = (0..masses.len()).map(|i| at(i, 0.0)).collect();
    let solid = vec![area(view.min.x, 0.0, view.max.x, view.max.y)];
    Exhibit {
        title,
        view,
        solid,
        start: places.clone(),
        exact: known(move |_| places.clone()),
        methods,
        first: 0,
        seconds: 20.0,
        speed: 1.0,
    }
}

fn column() -> Exhibit {
    standing("A column of 20 blocks stands", area(-11.0, -21.0, 11.0, 1.0), &[1.0; 20])
}

fn heavy_on_light() -> Exhibit {
    standing("10 000 kg rest on 1 kg", area(-2.0, -2.5, 2.0, 0.25), &[1.0, 10_000.0])
}

/// Blocks on a line that hit each other, and where they are at any time.
fn line(blocks: Vec<Block>, places: impl Fn(f64) -> Vec<f64> + Clone + 'static) -> (Vec<Aabb>, Start, Vec<(&'static str, Start)>) {
    let boxes = |blocks: &[Block]| -> Vec<Aabb> {
        let movable = blocks.iter().filter(|block| block.mass.is_finite());
        movable.map(|block| Aabb::around(DVec2::new(block.x, 0.0), DVec2::new(block.half, 0.5))).collect()
    };
    let mut methods: Vec<(&'static str, Start)> = Vec::new();
    for (name, line) in collisions::METHODS {
        let blocks = blocks.clone();
        let start = move |h: f64| -> Motion {
            let mut blocks = blocks.clone();
            Box::new(move || {
                line(&mut blocks, 1.0, h);
                boxes(&blocks)
            })
        };
        methods.push((name, Box::new(start)));
    }
    let (start, known_blocks) = (boxes(&blocks), blocks.clone());
    methods.push((SHIPPED, Box::new(move |h| engine(shipped::line(&blocks, 1.0), h))));
    let exact = known(move |t| {
        let placed = known_blocks.iter().zip(places(t)).map(|(block, x)| Block { x, ..*block });
        boxes(&placed.collect::<Vec<_>>())
    });
    (start, exact, methods)
}

fn wall() -> Exhibit {
    let (flying, wall) =
        (Block { x: -14.7, v: FAST, mass: 1.0, half: 0.25 }, Block { x: 0.0, v: 0.0, mass: f64::INFINITY, half: 0.05 });
    let touch = wall.x - wall.half - flying.half;
    let (start, exact, methods) = line(vec![flying, wall], move |t| {
        let way = flying.x + FAST * t;
        vec![if way > touch { 2.0 * touch - way } else { way }, wall.x]
    });
    Exhibit {
        title: "A fast box meets a thin wall",
        view: area(-15.0, -7.0, 5.0, 7.0),
        solid: vec![area(-wall.half, -5.0, wall.half, 5.0)],
        start,
        exact,
        methods,
        first: 0,
        seconds: 0.6,
        speed: 0.1,
    }
}

fn cradle() -> Exhibit {
    let blocks = collisions::cradle_of(5);
    let rest: Vec<f64> = blocks.iter().map(|block| block.x).collect();
    let (start, exact, methods) = line(blocks, move |t| {
        let mut places = rest.clone();
        let way = rest[0] + collisions::STRIKE * t;
        places[0] = way.min(0.0);
        places[4] += way.max(0.0);
        places
    });
    Exhibit {
        title: "Newton's cradle of five blocks",
        view: area(-3.0, -5.0, 11.0, 5.0),
        solid: vec![],
        start,
        exact,
        methods,
        first: 2,
        seconds: 2.5,
        speed: 0.5,
    }
}

fn throw() -> Exhibit {
    let (law, start) = drag::thrown();
    // Twice its size, to be seen from afar.
    let at = |x: DVec2| vec![Aabb::around(x, DVec2::ONE)];
    let by = move |step: Step| -> Start {
        Box::new(move |h| {
            let mut point = start;
            Box::new(move || {
                point = step(&law, point, h);
                at(point.x)
            })
        })
    };
    let mut methods: Vec<(&'static str, Start)> = motion::METHODS.iter().map(|(name, step)| (*name, by(*step))).collect();
    methods.push((
        SHIPPED,
        Box::new(move |h| {
            let mut motion = engine(shipped::in_air(&law, start), h);
            let mut time = 0.0;
            Box::new(move || {
                time += h;
                let drift = law.wind * time;
                motion().into_iter().flat_map(|body| at(body.centre() + drift)).collect()
            })
        }),
    ));
    Exhibit {
        title: "A throw with drag and wind",
        view: area(-2.0, -14.0, 34.0, 8.0),
        solid: vec![],
        start: at(start.x),
        exact: by(reference::drag_in_two_dimensions),
        methods,
        first: 1,
        seconds: 3.0,
        speed: 1.0,
    }
}

#[cfg(test)]
mod tests {
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
            met = exhibit.start.iter().chain(&exhibit.solid).fold(met, |met, body| met.union(body));
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
