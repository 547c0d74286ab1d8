//! Two methods on the same scene at the same time, to be watched: boxes that move, a step at a time. How they are drawn is not here.

use super::methods::bounce::Ball;
use super::methods::chain::Chain;
use super::methods::impact::{Block, discrete, exact, swept};
use super::methods::motion::{Step, explicit_euler, linearised_drag, rk4, semi_implicit_euler, strang, velocity_verlet};
use super::scenes::{bouncing, drag, stacks};
use super::shipped;
use crate::physics::{Aabb, BodyDef, DVec2, World, WorldDef};

/// s. The step of every exhibit: the one at which physics engines are usually run.
pub const STEP: f64 = 1.0 / 60.0;
/// N/kg.
const G: f64 = 9.81;
/// Blocks of the column.
const COLUMN: usize = 20;
/// m/s. Of the box that meets a thin wall: it travels further in a step than both are thick.
const FAST: f64 = 43.0;

/// Something that moves: makes one step and says where everything is, m.
pub type Motion = Box<dyn FnMut() -> Vec<Aabb>>;

/// A method's name, and what starts its motion from the beginning.
pub type Method = (&'static str, Box<dyn Fn() -> Motion>);

/// A scene and the methods that can be watched on it.
pub struct Exhibit {
    /// Its heading.
    pub title: &'static str,
    /// What of the world is seen, m.
    pub view: Aabb,
    /// What does not move, m.
    pub solid: Vec<Aabb>,
    /// The last one is the shipped engine.
    pub methods: Vec<Method>,
}

impl std::fmt::Debug for Exhibit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Exhibit").field("title", &self.title).finish_non_exhaustive()
    }
}

/// All of them.
pub fn exhibits() -> Vec<Exhibit> {
    vec![bounce(), column(), wall(), throw()]
}

fn area(left: f64, top: f64, right: f64, bottom: f64) -> Aabb {
    Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
}

fn square(x: f64, y: f64, half: f64) -> Aabb {
    Aabb::around(DVec2::new(x, y), DVec2::splat(half))
}

/// The shipped engine on such a world.
fn engine(def: WorldDef) -> Motion {
    let mut world = World::new(def).ok();
    Box::new(move || {
        let Some(world) = &mut world else { return Vec::new() };
        world.step(STEP);
        world.bodies().iter().map(|body| body.bounds()).collect()
    })
}

const SHIPPED: &str = "shipped engine";

fn bounce() -> Exhibit {
    let mut methods: Vec<Method> = Vec::new();
    for (name, bounce) in bouncing::METHODS {
        let start = move || -> Motion {
            let mut ball: Ball = (2.0, 0.0);
            Box::new(move || {
                ball = bounce(ball, G, 1.0, STEP);
                vec![square(0.0, -0.5 - ball.0, 0.5)]
            })
        };
        methods.push((name, Box::new(start)));
    }
    let body = BodyDef { restitution: 1.0, ..shipped::crate_at(0.0, 2.0, 1.0) };
    methods.push((SHIPPED, Box::new(move || engine(shipped::on_floor(G, 0.0, vec![body.clone()])))));
    Exhibit {
        title: "A box bounces without loss",
        view: area(-3.0, -5.5, 3.0, 0.5),
        solid: vec![area(-3.0, 0.0, 3.0, 0.5)],
        methods,
    }
}

fn column() -> Exhibit {
    let mut methods: Vec<Method> = Vec::new();
    for (name, solver) in stacks::SOLVERS {
        let start = move || -> Motion {
            let mut chain = Chain::new(&[1.0; COLUMN], true);
            let mut accelerations = [-G; COLUMN + 1];
            accelerations[0] = 0.0;
            Box::new(move || {
                chain.step(&accelerations, solver, STEP);
                let heights = chain.places[1..].iter().enumerate().map(|(i, x)| i as f64 + x);
                heights.map(|height| square(0.0, -0.5 - height, 0.5)).collect()
            })
        };
        methods.push((name, Box::new(start)));
    }
    let blocks = || (0..COLUMN).map(|i| shipped::crate_at(0.0, i as f64, 1.0)).collect();
    methods.push((SHIPPED, Box::new(move || engine(shipped::on_floor(G, 1.0, blocks())))));
    Exhibit { title: "A column stands", view: area(-11.0, -21.0, 11.0, 1.0), solid: vec![area(-11.0, 0.0, 11.0, 1.0)], methods }
}

fn wall() -> Exhibit {
    let blocks = [Block { x: -14.7, v: FAST, mass: 1.0, half: 0.25 }, Block { x: 0.0, v: 0.0, mass: f64::INFINITY, half: 0.05 }];
    let mut methods: Vec<Method> = Vec::new();
    for (name, line) in [
        ("overlap at tick ends", discrete as super::methods::impact::Line),
        ("swept, rest of tick lost", swept),
        ("exact time of impact", exact),
    ] {
        let start = move || -> Motion {
            let mut blocks = blocks;
            Box::new(move || {
                line(&mut blocks, 1.0, STEP);
                vec![square(blocks[0].x, 0.0, blocks[0].half)]
            })
        };
        methods.push((name, Box::new(start)));
    }
    methods.push((SHIPPED, Box::new(move || engine(shipped::line(&blocks, 1.0)))));
    Exhibit {
        title: "A fast box meets a thin wall",
        view: area(-15.0, -7.5, 5.0, 7.5),
        solid: vec![area(-0.05, -5.0, 0.05, 5.0)],
        methods,
    }
}

fn throw() -> Exhibit {
    let (law, start) = drag::thrown();
    let mut methods: Vec<Method> = Vec::new();
    let steps: [(&'static str, Step); 6] = [
        ("explicit Euler", explicit_euler),
        ("semi-implicit Euler", semi_implicit_euler),
        ("velocity Verlet", velocity_verlet),
        ("RK4", rk4),
        ("linearised drag", linearised_drag),
        ("Strang", strang),
    ];
    for (name, step) in steps {
        let start = move || -> Motion {
            let mut point = start;
            Box::new(move || {
                point = step(&law, point, STEP);
                vec![square(point.x.x, point.x.y, 0.5)]
            })
        };
        methods.push((name, Box::new(start)));
    }
    methods.push((
        SHIPPED,
        Box::new(move || {
            let mut motion = engine(shipped::in_air(&law, start));
            let mut time = 0.0;
            Box::new(move || {
                time += STEP;
                let drift = law.wind * time;
                motion().into_iter().map(|body| Aabb::new(body.min + drift, body.max + drift)).collect()
            })
        }),
    ));
    Exhibit { title: "A throw with drag and wind", view: area(-2.0, -20.0, 48.0, 30.0), solid: vec![], methods }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the first box is after so many seconds.
    fn after(exhibit: &Exhibit, method: &str, seconds: f64) -> DVec2 {
        let (_, start) = exhibit.methods.iter().find(|(name, _)| *name == method).unwrap();
        let mut motion = start();
        let steps = (seconds / STEP).round() as usize;
        (0..steps).map(|_| motion()).last().unwrap().last().unwrap().centre()
    }

    #[test]
    fn the_methods_part() {
        let [bounce, column, wall, throw] = &exhibits()[..] else { panic!("four exhibits") };
        // Without loss it rises to 2 m again; snapping has lost half a metre by then.
        let top = |method| (0..600).map(|i| -0.5 - after(bounce, method, 30.0 + f64::from(i) * STEP).y).fold(0.0, f64::max);
        assert!((top(SHIPPED) - 2.0).abs() < 0.01);
        assert!((top("snap to the floor") - 2.0).abs() > 0.05);
        assert_eq!(after(column, SHIPPED, 10.0).y, 0.5 - COLUMN as f64);
        assert!(after(column, "impulses, 4 sweeps, warm", 10.0).y > 0.6 - COLUMN as f64);
        assert!(after(wall, "overlap at tick ends", 1.0).x > 0.0, "it gets through");
        assert!(after(wall, SHIPPED, 1.0).x < 0.0);
        assert!((after(throw, SHIPPED, 3.0) - after(throw, "RK4", 3.0)).length() < 1e-6);
        assert!((after(throw, SHIPPED, 3.0) - after(throw, "semi-implicit Euler", 3.0)).length() > 0.1);
    }
}
