//! Accuracy against speed: scenes with exact answers, the methods that games use and the engine as it is shipped, what each of them
//! survives, and the charts that show it. Nothing here reads a clock or a file: `resultant chart` measures, this draws.
//!
//! - [`methods`]: the methods, written by hand, each a small pure function.
//! - [`contract`]: the one contract between methods, the shipped engine, and all that runs them.
//! - [`scenes`]: what they are run on, one file a family; each scene knows its exact answer.
//! - [`stress`]: where methods fail: the largest value that each survives.
//! - [`stability`]: where methods are stable, on the complex plane; [`stability_diagram`]: as CSV.
//! - [`side_by_side`]: two methods on a scene, to be watched.
//! - [`reference`](mod@reference): answers that have no closed form, found finely and in two ways.
//! - [`measured`] and [`curve`]: the numbers behind a diagram; [`course`]: error and energy over time. [`charts`]: all that one run measured, as CSV and back; [`kept`]: the run that comes with
//!   the game; [`peers`]: other engines' points.
//! - [`axes`], [`linear`], [`timeline`] and [`look`]: what a diagram is made of, on paper and on the screen. [`report`]:
//!   the summary.

pub mod axes;
pub mod charts;
pub mod contract;
pub mod course;
pub mod curve;
pub mod kept;
pub mod linear;
pub mod look;
pub mod measured;
pub mod methods;
pub mod peers;
pub mod reference;
pub mod report;
mod rows;
mod scene;
pub mod scenes;
mod shipped;
pub mod side_by_side;
pub mod stability;
pub mod stability_diagram;
pub mod stress;
pub mod timeline;

pub use scene::{Answer, LabScene};

/// m. A tenth of a pixel at the default scale of 30 pixels a metre: an error that no one can see.
pub const TOLERANCE: f64 = 1.0 / 300.0;
