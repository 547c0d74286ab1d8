//! Accuracy against speed: scenes with exact answers, the methods that games use and the shipped engine, stress tests, and the charts
//! of all of them. Nothing here reads a clock or a file: `resultant chart` measures, the lab draws.
//!
//! - [`contract`]: the one contract of all methods, by hand and shipped. A new method stands in the table of its family in [`methods`] or
//!   [`scenes`]; scenes, stress tests, side by side and the regions of stability take it from there.
//! - [`methods`]: the methods, written by hand, each a small pure function.
//! - [`scenes`]: models and their exact answers, one file a family.
//! - [`stress`]: where methods fail: the largest value that each survives.
//! - [`side_by_side`]: two methods on a scene, to be watched.
//! - [`stability`]: where methods are stable, on the complex plane, and as CSV.
//! - [`curve`]: the numbers behind a diagram. [`charts`]: all numbers of one run, as CSV and back; [`kept`]: the run that comes with the
//!   game, and other engines' points.
//! - [`savings`]: what each plan leaves out, and what that saves. [`drawing`]: diagrams, on paper and on the screen. [`report`]: the summary,
//!   and what the pages say of all that was measured.

pub mod charts;
pub mod contract;
pub mod curve;
pub mod drawing;
pub mod kept;
pub mod methods;
pub mod report;
pub mod savings;
pub mod scenes;
pub mod side_by_side;
pub mod stability;
pub mod stress;

pub use contract::{LabScene, SceneMethod};

/// s. The tick of the figures that physics engines are usually compared at.
pub const TICK: f64 = 1.0 / 60.0;
/// m. A tenth of a pixel at the default scale of 30 pixels a metre: an error that no one can see.
pub const TOLERANCE: f64 = 1.0 / 300.0;
