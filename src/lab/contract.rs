//! The one contract of the lab. A [`Model`] is a motion that can be stepped: by methods by hand, and by the shipped engine in a world that
//! holds the same. Scenes, stress tests and side by side run each method of a model through [`Model::end`] or
//! [`Model::running`], and differ only in their questions to the states.

use crate::physics::World;

/// The name of the shipped engine in legends and tables.
pub const SHIPPED: &str = "shipped engine";

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By<S> {
    Hand(S),
    Engine,
}

/// The shipped engine stands behind the methods by hand.
pub fn contenders<S>(by_hand: impl IntoIterator<Item = (&'static str, S)>) -> impl Iterator<Item = (&'static str, By<S>)> {
    let by_hand = by_hand.into_iter().map(|(name, method)| (name, By::Hand(method)));
    by_hand.chain(std::iter::once_with(|| (SHIPPED, By::Engine)))
}

pub struct Entrant<R, P> {
    pub name: String,
    pub shipped: bool,
    pub run: Box<dyn Fn(f64) -> R>,
    /// The result and the course of the run, where the scene is one to be followed.
    pub shown: Option<Box<dyn Fn(f64) -> P>>,
}

impl<R: 'static, P: 'static> Entrant<R, P> {
    pub fn new(name: impl Into<String>, run: impl Fn(f64) -> R + 'static) -> Self {
        Self { name: name.into(), shipped: false, run: Box::new(run), shown: None }
    }

    pub fn shipped(run: impl Fn(f64) -> R + 'static) -> Self {
        Self { shipped: true, ..Self::new(SHIPPED, run) }
    }

    #[must_use]
    pub fn showing(self, show: impl Fn(f64) -> P + 'static) -> Self {
        Self { shown: Some(Box::new(show)), ..self }
    }

    pub fn all<S: Copy + 'static>(
        by_hand: impl IntoIterator<Item = (&'static str, S)>,
        run: impl Fn(By<S>, f64) -> R + Clone + 'static,
    ) -> Vec<Self> {
        let entrant = |(name, by): (&'static str, By<S>)| {
            let run = run.clone();
            Self { shipped: matches!(by, By::Engine), ..Self::new(name, move |value| run(by, value)) }
        };
        contenders(by_hand).map(entrant).collect()
    }

    pub fn all_showing<S: Copy + 'static>(
        by_hand: impl IntoIterator<Item = (&'static str, S)> + Clone,
        run: impl Fn(By<S>, f64) -> R + Clone + 'static,
        show: impl Fn(By<S>, f64) -> P + Clone + 'static,
    ) -> Vec<Self> {
        let shows = contenders(by_hand.clone()).map(|(_, by)| {
            let show = show.clone();
            move |value| show(by, value)
        });
        Self::all(by_hand, run).into_iter().zip(shows).map(|(entrant, show)| entrant.showing(show)).collect()
    }
}

pub trait Model: Clone {
    type State: Clone;
    /// A method by hand: a function, or its settings.
    type Method: Copy;

    /// The state at 0 s.
    fn start(&self) -> Self::State;

    /// A step of `h` s by hand.
    fn step(&self, method: Self::Method, state: &mut Self::State, h: f64);

    /// `None` where the engine refuses the motion.
    fn world(&self) -> Option<World>;

    /// Takes the state over from that world, `time` s after the start.
    fn read(&self, world: &World, time: f64, state: &mut Self::State);

    /// The state after `seconds`, in steps of `h` s.
    fn end(&self, by: By<Self::Method>, seconds: f64, h: f64) -> Option<Self::State> {
        let steps = steps(seconds, h);
        let mut state = self.start();
        match by {
            By::Hand(method) => (0..steps).for_each(|_| self.step(method, &mut state, h)),
            By::Engine => {
                let mut world = self.world()?;
                (0..steps).for_each(|_| world.step(h));
                self.read(&world, seconds, &mut state);
            }
        }
        Some(state)
    }

    fn running(&self, by: By<Self::Method>, h: f64) -> Running<Self> {
        let stepper = match by {
            By::Hand(method) => Some(Stepper::Hand(method)),
            By::Engine => self.world().map(|world| Stepper::Engine(Box::new(world))),
        };
        Running { model: self.clone(), state: self.start(), stepper, h, steps: 0 }
    }
}

fn steps(seconds: f64, h: f64) -> u64 {
    (seconds / h).round() as u64
}

pub struct Running<M: Model> {
    model: M,
    state: M::State,
    /// None where the engine refuses the model.
    stepper: Option<Stepper<M::Method>>,
    h: f64,
    steps: u64,
}

enum Stepper<S> {
    Hand(S),
    Engine(Box<World>),
}

impl<M: Model> Running<M> {
    /// An answer from the time (s) and the state after each step for `seconds`; none where the engine refuses the model.
    pub fn each<T>(mut self, seconds: f64, mut ask: impl FnMut(f64, &M::State) -> T) -> impl Iterator<Item = T> {
        (0..steps(seconds, self.h)).map_while(move |_| self.step().map(|(time, state)| ask(time, state)))
    }

    /// The time after the step, s, and the state. `None` where the engine refuses the model.
    pub fn step(&mut self) -> Option<(f64, &M::State)> {
        self.steps += 1;
        let time = self.steps as f64 * self.h;
        match self.stepper.as_mut()? {
            Stepper::Hand(method) => self.model.step(*method, &mut self.state, self.h),
            Stepper::Engine(world) => {
                world.step(self.h);
                self.model.read(world, time, &mut self.state);
            }
        }
        Some((time, &self.state))
    }
}
