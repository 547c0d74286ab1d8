//! Rows of gravity.csv, pods.csv and decoration.csv.

use super::blocks::one_of;
use super::image::Images;
use super::problem::Problem;
use super::quantity::{self as q, Scale};
use super::rows::{bounds, place, point};
use super::table::{CellText, Layout, Record, cell};
use super::types::{Decoration, Field, Pod};
use crate::physics::{Aabb, DVec2};
use serde::Deserialize;

pub(super) const GRAVITY: Layout = Layout { file: "gravity.csv", columns: "x,y,width,height,field_x,field_y" };
pub(super) const PODS: Layout = Layout { file: "pods.csv", columns: "x,y,width,height,fuel" };
pub(super) const DECORATION: Layout = Layout { file: "decoration.csv", columns: "x,y,image,[layer]" };

/// A row of any of these files.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct ExtraRow {
    x: CellText,
    y: CellText,
    width: CellText,
    height: CellText,
    field_x: CellText,
    field_y: CellText,
    fuel: CellText,
    image: CellText,
    layer: CellText,
}

pub(super) fn field(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Field> {
    let row: ExtraRow = record.row();
    let zone = bounds(record, place!(row), scale, problems);
    let x = record.number(cell!(row.field_x), q::GRAVITY, problems);
    let y = record.number(cell!(row.field_y), q::GRAVITY, problems);
    Some(Field { zone: zone?, strength: DVec2::new(x?, y?) })
}

pub(super) fn pod(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Pod> {
    let row: ExtraRow = record.row();
    let bounds = bounds(record, place!(row), scale, problems);
    let fuel = record.number(cell!(row.fuel), q::FUEL, problems);
    Some(Pod { bounds: bounds?, fuel: fuel? })
}

/// A picture, or a plain shape, by its top left corner.
pub(super) fn decoration(record: &Record, scale: Scale, images: &mut Images, problems: &mut Vec<Problem>) -> Option<Decoration> {
    let row: ExtraRow = record.row();
    let corner = point(record, [cell!(row.x), cell!(row.y)], scale, problems);
    let text = row.image.as_str()?;
    let shape = match images.look(text, scale) {
        Ok((look, width, height)) => Some((look, scale.metres(width, height))),
        Err((found, expected)) => {
            problems.push(record.problem("image", found, expected));
            None
        }
    };
    let in_front = one_of(record, cell!(row.layer), false, &[("behind", false), ("front", true)], problems);
    let (corner, (look, size)) = (corner?, shape?);
    Some(Decoration { bounds: Aabb::new(corner, corner + size), look, in_front: in_front? })
}
