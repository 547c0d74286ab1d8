//! The scenes: what moves in each, how it really moves, and the methods that can be watched.

use super::{Exhibit, Motion, Start, area, engine, known, square};
use crate::lab::methods::bounce::Ball;
use crate::lab::methods::chain::Chain;
use crate::lab::methods::impact::Block;
use crate::lab::methods::motion::{self, Step};
use crate::lab::scenes::{bouncing, collisions, drag, stacks};
use crate::lab::{reference, shipped};
use crate::physics::{Aabb, BodyDef, DVec2};

/// N/kg.
const G: f64 = 9.81;
/// m/s. Of the box that meets a thin wall: it travels further in a step than both are thick.
pub(super) const FAST: f64 = 43.0;
/// m. From where a box falls to bounce for ever.
const DROP: f64 = 2.0;
/// m. All below y = 0.
const GROUND: Aabb = Aabb { min: DVec2::new(-1e3, 0.0), max: DVec2::new(1e3, 1e3) };
/// What the engine is called.
pub(super) const SHIPPED: &str = "shipped engine";

/// All of them.
pub(super) fn all() -> Vec<Exhibit> {
    vec![bounce(), throw(), wall(), cradle(), column(), heavy_on_light()]
}

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
        view: area(-4.0, -3.4, 4.0, 0.5),
        solid: vec![GROUND],
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
    Exhibit {
        title,
        view,
        solid: vec![GROUND],
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
        view: area(-15.2, -5.2, 4.8, 5.2),
        solid: vec![area(-wall.half, -1e3, wall.half, 1e3)],
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
        view: area(-2.8, -3.6, 10.8, 3.6),
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
