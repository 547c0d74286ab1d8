//! The palette: a physicist's notebook at night. A colour always means the same; sizes are in [`super::layout`].

use crate::physics::ForceKind;
use macroquad::color::Color;

/// What everything lies on.
pub const GROUND: Color = rgb(0x10141B);
/// Panels and buttons.
pub const PANEL: Color = rgb(0x1B2230);
/// A button under the pointer.
pub const PANEL_HOVER: Color = rgb(0x28324A);
/// The edge of a panel.
pub const PANEL_EDGE: Color = rgb(0x2C3648);
/// A line of the graph paper every metre.
pub const GRID_FINE: Color = rgb(0x1A2130);
/// A line of the graph paper every ten metres.
pub const GRID_HEAVY: Color = rgb(0x232C3D);
/// Whatever is solid and never moves.
pub const SOLID: Color = rgb(0x3A4456);
/// Its top edge.
pub const SOLID_TOP: Color = rgb(0x566379);
/// Words.
pub const TEXT: Color = rgb(0xE6EBF2);
/// Words of less weight.
pub const QUIET: Color = rgb(0x93A0B4);
/// The title, the ship's trim, keyboard focus, fuel.
pub const ACCENT: Color = rgb(0xFF9F1C);
/// What helped.
pub const GOOD: Color = rgb(0x4CC38A);
/// What cost, and what kills.
pub const BAD: Color = rgb(0xF2555A);
/// An objective for the ship; the best score.
pub const PLAYER_OBJECTIVE: Color = rgb(0xF2C744);
/// An objective for a key object.
pub const PHYSICS_OBJECTIVE: Color = rgb(0xD65DB1);
/// The resultant force.
pub const RESULTANT: Color = rgb(0xFFFFFF);

/// An impact. Told apart from every force, in normal sight and in the three common kinds of colour blindness, by 11 units of CIEDE2000
/// at least (colours simulated after Machado, Oliveira and Fernandes, 2009).
pub const IMPACT: Color = rgb(0xAE62FF);

/// The colour of a force, wherever it is shown.
pub const fn force(kind: ForceKind) -> Color {
    match kind {
        ForceKind::Weight => rgb(0xB79CED),
        ForceKind::Drive => rgb(0xFF9F1C),
        ForceKind::Reaction => rgb(0x56B4E9),
        ForceKind::Friction => rgb(0xD55E00),
        ForceKind::AirResistance => rgb(0x8FD3FF),
        ForceKind::Wind => rgb(0xDCE6F5),
        ForceKind::Buoyancy => rgb(0x009E73),
        ForceKind::ViscousDrag => rgb(0xA3A847),
        ForceKind::Push => rgb(0xF0E442),
    }
}

/// A colour that lets `alpha` (0 … 1) of itself cover what is below.
pub const fn faded(colour: Color, alpha: f32) -> Color {
    Color::new(colour.r, colour.g, colour.b, colour.a * alpha)
}

/// A colour written as 0xRRGGBB.
pub const fn rgb(hex: u32) -> Color {
    Color::new(((hex >> 16) & 0xFF) as f32 / 255.0, ((hex >> 8) & 0xFF) as f32 / 255.0, (hex & 0xFF) as f32 / 255.0, 1.0)
}
