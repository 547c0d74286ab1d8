//! The Lab's charts, on the screen and on paper.

pub mod diagram;
pub mod overview;
pub mod picture;
pub mod plane;
pub mod timeline;

use super::methods::{METHODS, motion};
use super::scenes::{bouncing, collisions, stacks};
use super::stability::PART;
use crate::draw::chart::{CurveLook, CurveOrigin};

/// A method has the same look in all charts; what is unknown here, that of its place.
fn look_of(name: &str, origin: CurveOrigin, index: usize) -> CurveLook {
    let name = if name == PART { motion::ADAPTIVE } else { name };
    let motions = METHODS.iter().map(|(name, _)| *name).chain(["exact flow"]);
    let contacts = bouncing::SLIDE_METHODS.iter().map(|(name, _)| *name).chain(bouncing::METHODS.iter().map(|(name, _)| *name));
    let solvers = collisions::METHODS.iter().map(|(name, _)| *name).chain(stacks::SOLVERS.iter().map(|(name, _)| *name));
    let known = motions.chain(contacts).chain(solvers).position(|known| known == name);
    CurveLook::of(known.unwrap_or(index), origin)
}
