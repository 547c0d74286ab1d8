//! A scene: a question with an exact answer, and the methods that are to answer it.

use super::TOLERANCE;
use super::contract::Entrant;
use super::course::CoursePoint;

/// The ladder of steps, s. The game's tick is among them.
pub(super) const LADDER: [f64; 7] = [1.0 / 15.0, 1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0, 1.0 / 480.0, 1.0 / 960.0];

pub(super) const WORK: &str = "CPU time for a simulated second and body, ns";

pub struct LabScene {
    pub name: &'static str,
    pub title: String,
    /// With its unit, for the axis.
    pub error: &'static str,
    /// In the error's unit: the largest error that no eye sees.
    pub tolerance: f64,
    /// With its unit, for the axis.
    pub work: &'static str,
    /// Work is divided by this: simulated seconds × bodies.
    pub share: f64,
    /// Steps to try, s, from the coarsest.
    pub steps: Vec<f64>,
    /// The step at which the game ships, s.
    pub shipped_step: f64,
    /// Whether all methods answer the same question, so that the cheapest right one can be named.
    pub alike: bool,
    /// A note for the reader of the diagram, or empty.
    pub note: &'static str,
    /// The shipped engine is the last.
    pub methods: Vec<SceneMethod>,
}

/// A method in a scene: a step (s) gives the error of the whole scene, and its course.
pub type SceneMethod = Entrant<f64, Vec<CoursePoint>>;

impl LabScene {
    /// A scene of `seconds` and `bodies` on the usual ladder, whose error is a distance.
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
}

impl std::fmt::Debug for LabScene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let methods: Vec<_> = self.methods.iter().map(|method| &method.name).collect();
        f.debug_struct("Scene").field("name", &self.name).field("methods", &methods).finish_non_exhaustive()
    }
}
