//! The one contract of the lab. A [`Model`] is a motion that can be stepped: by methods by hand, and by the shipped engine in a world that
//! holds the same. Scenes, stress tests and side by side run each method of a model through [`Model::end`] or
//! [`Model::running`], and differ only in their questions to the states.

use crate::physics::World;

/// The name of the shipped engine in legends and tables.
pub const SHIPPED: &str = "shipped engine";

/// The stepper of a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By<S> {
    /// A method by hand.
    Hand(S),
    /// The engine as it is shipped.
    Engine,
}

/// Methods by name, the shipped engine behind those by hand.
pub fn contenders<S>(by_hand: impl IntoIterator<Item = (&'static str, S)>) -> impl Iterator<Item = (&'static str, By<S>)> {
    let by_hand = by_hand.into_iter().map(|(name, method)| (name, By::Hand(method)));
    by_hand.chain(std::iter::once_with(|| (SHIPPED, By::Engine)))
}

/// A method in a scene or a stress test. Its runs depend on one number: a step (s), or the value that a test makes larger.
pub struct Entrant<R, P> {
    /// Its name in the legend.
    pub name: String,
    /// Whether it is the engine as it is shipped.
    pub shipped: bool,
    /// Runs it and gives the result.
    pub run: Box<dyn Fn(f64) -> R>,
    /// Runs it and gives the course of the run, where the scene is one to be followed.
    pub shown: Option<Box<dyn Fn(f64) -> P>>,
}

impl<R: 'static, P: 'static> Entrant<R, P> {
    /// A method by hand.
    pub fn new(name: impl Into<String>, run: impl Fn(f64) -> R + 'static) -> Self {
        Self { name: name.into(), shipped: false, run: Box::new(run), shown: None }
    }

    /// The engine as it is shipped.
    pub fn shipped(run: impl Fn(f64) -> R + 'static) -> Self {
        Self { shipped: true, ..Self::new(SHIPPED, run) }
    }

    /// One that shows its course.
    #[must_use]
    pub fn showing(self, show: impl Fn(f64) -> P + 'static) -> Self {
        Self { shown: Some(Box::new(show)), ..self }
    }

    /// Methods by hand and the shipped engine.
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

    /// The same, each of which shows its course.
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

/// A motion that methods step.
pub trait Model: Clone {
    /// All of it that changes.
    type State: Clone;
    /// A method by hand: a function, or its settings.
    type Method: Copy;

    /// The state at 0 s.
    fn start(&self) -> Self::State;

    /// A step of `h` s by hand.
    fn step(&self, method: Self::Method, state: &mut Self::State, h: f64);

    /// The same motion in the shipped engine; nothing where the engine refuses it.
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

    /// The model at its start, to be stepped by `h` s at a time.
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

/// A model on its course.
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

    /// One step: the time after it, s, and the state. Nothing where the engine refuses the model.
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
