//! What every chart has: axes, looks of curves, and a sheet of lanes as values, for paper and screen alike.

pub mod axes;
pub mod look;

use axes::Linear;
use look::CurveLook;

/// A picture of curves above one axis: a strip for each kind of number, one above the other.
pub struct Sheet {
    pub across: Linear,
    /// The quantity to the right, with its unit.
    pub across_name: String,
    /// From the top.
    pub strips: Vec<Strip>,
    pub legend: Vec<(String, CurveLook)>,
    /// Lines below the legend.
    pub notes: Vec<String>,
}

pub struct Strip {
    /// With its unit.
    pub name: String,
    /// Values upwards, each with its part of the height.
    pub named: Vec<(f64, String)>,
    /// Values to the right with an upright line.
    pub marks: Vec<f64>,
    pub curves: Vec<Piece>,
}

pub struct Piece {
    pub look: CurveLook,
    /// Values to the right, and parts of the height.
    pub points: Vec<(f64, f64)>,
    /// The point with the curve's marker, if any has it.
    pub marker: Option<usize>,
}
