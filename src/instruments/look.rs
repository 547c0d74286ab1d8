//! Up to four curves of a flight differ by colour, dash and marker. A force has the colour that it has everywhere.

use super::quantity::Quantity;
use crate::draw::chart::look::{CurveLook, CurveOrigin};
use crate::physics::ForceKind;

pub const RESULTANT: u32 = 0xFFFFFF;
/// By the curve's number: none of them is the colour of a force.
const COLOURS: [u32; 4] = [0x7FA7FF, 0xF28DB2, 0x9AD14B, 0xE6EBF2];

/// As 0xRRGGBB.
pub const fn force(kind: ForceKind) -> u32 {
    match kind {
        ForceKind::Weight => 0xB79CED,
        ForceKind::Drive => 0xFF9F1C,
        ForceKind::Reaction => 0x56B4E9,
        ForceKind::Friction => 0xD55E00,
        ForceKind::AirResistance => 0x8FD3FF,
        ForceKind::Wind => 0xDCE6F5,
        ForceKind::Buoyancy => 0x009E73,
        ForceKind::ViscousDrag => 0xA3A847,
        ForceKind::Push => 0xF0E442,
        ForceKind::Spring => 0xCC79A7,
        ForceKind::Tension => 0xE8A0C8,
        ForceKind::Magnetic => 0xF2545B,
    }
}

pub fn of(number: usize, up: Quantity) -> CurveLook {
    let colour = match up {
        Quantity::Force(kind, _) => force(kind),
        Quantity::Resultant(_) => RESULTANT,
        _ => COLOURS[number % COLOURS.len()],
    };
    // Dash and marker are the Lab's.
    CurveLook { colour, ..CurveLook::of(number, CurveOrigin::Lab) }
}
