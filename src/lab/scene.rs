//! A scene: a question with an exact answer, and the methods that are to answer it.

use super::TOLERANCE;
use super::contract::{By, contenders};
use super::course::Moment;

/// The ladder of steps, s. The game's tick is among them.
pub(super) const LADDER: [f64; 7] = [1.0 / 15.0, 1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0, 1.0 / 480.0, 1.0 / 960.0];

/// What the work is, where nothing else is said.
pub(super) const WORK: &str = "CPU time for a simulated second and body, ns";

/// A question with an exact answer.
pub struct Scene {
    /// Name of its files.
    pub name: &'static str,
    /// Heading of its diagram.
    pub title: String,
    /// What the error is, with its unit, for the axis.
    pub error: &'static str,
    /// The largest error that nobody sees, in the error's unit.
    pub tolerance: f64,
    /// What the work is, with its unit, for the axis.
    pub work: &'static str,
    /// Work is divided by this: simulated seconds × bodies.
    pub share: f64,
    /// Steps to try, s, from the coarsest.
    pub steps: Vec<f64>,
    /// The step at which the game ships, s.
    pub shipped_step: f64,
    /// Whether all methods answer the same question, so that the cheapest right one can be named.
    pub alike: bool,
    /// What a reader of its diagram should know; empty where that is nothing.
    pub note: &'static str,
    /// What answers it; the shipped engine is the last.
    pub methods: Vec<Method>,
}

/// A way to answer a scene.
pub struct Method {
    /// Its name in the legend.
    pub name: String,
    /// Whether it is the engine as it is shipped.
    pub shipped: bool,
    /// Runs the whole scene at a step (s) and returns the error.
    pub run: Box<dyn Fn(f64) -> f64>,
    /// Runs it at a step (s) and tells how it fares meanwhile, where the scene is one to be followed.
    pub course: Option<Box<dyn Fn(f64) -> Vec<Moment>>>,
}

impl Scene {
    /// A scene of so many simulated seconds and bodies, on the usual ladder, whose error is a distance.
    pub(super) fn new(name: &'static str, title: impl Into<String>, seconds: f64, bodies: usize) -> Self {
        Self {
            name,
            title: title.into(),
            error: "error of position at the end, m",
            tolerance: TOLERANCE,
            work: WORK,
            share: seconds * bodies as f64,
            steps: LADDER.to_vec(),
            shipped_step: 1.0 / crate::game::TICK_RATE,
            alike: true,
            note: "",
            methods: Vec::new(),
        }
    }

    /// With another measure of the error.
    pub(super) fn measuring(self, error: &'static str) -> Self {
        Self { error, ..self }
    }

    /// With another error that nobody sees, in the error's unit.
    pub(super) fn within(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// With other steps, s.
    pub(super) fn at_steps(self, steps: &[f64]) -> Self {
        Self { steps: steps.to_vec(), ..self }
    }

    /// With something that a reader of its diagram should know.
    pub(super) fn noting(self, note: &'static str) -> Self {
        Self { note, ..self }
    }

    /// With one method more.
    pub(super) fn method(mut self, name: impl Into<String>, run: impl Fn(f64) -> f64 + 'static) -> Self {
        self.methods.push(Method { name: name.into(), shipped: false, run: Box::new(run), course: None });
        self
    }

    /// With methods by hand and the shipped engine; `error` runs the whole scene at a step (s).
    pub(super) fn by<S: Copy + 'static>(
        mut self,
        by_hand: impl IntoIterator<Item = (&'static str, S)>,
        error: impl Fn(By<S>, f64) -> f64 + Clone + 'static,
    ) -> Self {
        for (name, by) in contenders(by_hand) {
            let error = error.clone();
            self = self.method(name, move |h| error(by, h));
        }
        self.shipped()
    }

    /// The last method is the engine as it is shipped.
    pub(super) fn shipped(mut self) -> Self {
        if let Some(method) = self.methods.last_mut() {
            method.shipped = true;
        }
        self
    }

    /// The same methods by hand and the shipped engine, followed over time.
    pub(super) fn followed<S: Copy + 'static>(
        mut self,
        by_hand: impl IntoIterator<Item = (&'static str, S)>,
        course: impl Fn(By<S>, f64) -> Vec<Moment> + Clone + 'static,
    ) -> Self {
        for (method, (_, by)) in self.methods.iter_mut().zip(contenders(by_hand)) {
            let course = course.clone();
            method.course = Some(Box::new(move |h| course(by, h)));
        }
        self
    }
}

impl std::fmt::Debug for Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let methods: Vec<_> = self.methods.iter().map(|method| &method.name).collect();
        f.debug_struct("Scene").field("name", &self.name).field("methods", &methods).finish_non_exhaustive()
    }
}
