//! Accuracy against speed: scenes with exact answers, the methods that games use and the shipped engine, stress tests, and the charts of all of them.
//! Nothing here reads a clock or a file: `resultant chart` measures, the lab draws. A new method stands in the table of its family in [`methods`] or
//! [`scenes`]: scenes, [`stress`], [`side_by_side`] and [`stability`] take it from there by the one [`contract`].

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
