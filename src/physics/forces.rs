//! The force manager: the named forces that act on one body, each with its source.

use super::BodyId;
use glam::DVec2;

/// The kinds of force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ForceKind {
    /// m·g downwards.
    Weight,
    /// The ship's engine, along the nose or against it.
    Drive,
    /// What a supporting surface or object exerts along the contact's normal; never pulls.
    Reaction,
    /// Against sliding along a contact.
    Friction,
    /// ½·ρ·C_d·(w·|u_y| + h·|u_x|)·u for boxes, ½·ρ·C_d·d·|u|·u for round things, against the motion u relative to the air.
    AirResistance,
    /// An air stream's constant force.
    Wind,
    /// ρ·g·V of the displaced liquid, upwards.
    Buoyancy,
    /// The drag of a liquid: quadratic, viscous, and the waves that a body makes which its surface cuts.
    ViscousDrag,
    /// What another object presses with.
    Push,
}

impl ForceKind {
    /// All kinds in the order in which they are listed everywhere.
    pub const ALL: [Self; 9] = [
        Self::Weight,
        Self::Drive,
        Self::Reaction,
        Self::Friction,
        Self::AirResistance,
        Self::Wind,
        Self::Buoyancy,
        Self::ViscousDrag,
        Self::Push,
    ];

    /// The name on the screen: that of school, which calls the Reaction of a contact its normal force.
    pub const fn shown(self) -> &'static str {
        match self {
            Self::Reaction => "Normal force",
            other => other.name(),
        }
    }

    /// The name in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Weight => "Weight",
            Self::Drive => "Drive",
            Self::Reaction => "Reaction",
            Self::Friction => "Friction",
            Self::AirResistance => "Air Resistance",
            Self::Wind => "Wind",
            Self::Buoyancy => "Buoyancy",
            Self::ViscousDrag => "Viscous Drag",
            Self::Push => "Push",
        }
    }
}

/// What exerts a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Source {
    /// The field of gravity.
    Gravity,
    /// The body's own engine.
    Engine,
    /// The air.
    Air,
    /// The air stream of that index in [`super::WorldDef::streams`].
    Stream(u32),
    /// The field of that index in [`super::WorldDef::fields`].
    Field(u32),
    /// The liquid of that index in [`super::WorldDef::fluids`].
    Fluid(u32),
    /// The immovable surface of that index in [`super::World::surfaces`].
    Surface(u32),
    /// Another body.
    Body(BodyId),
}

/// One force on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Force {
    /// Its kind, which is also its name.
    pub kind: ForceKind,
    /// What exerts it.
    pub source: Source,
    /// Its vector, N.
    pub vector: DVec2,
    /// Where it acts, m: the middle of the contact, or the centre of the body.
    pub point: DVec2,
}

/// The forces that act on one body and their resultant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForceManager {
    forces: Vec<Force>,
    resultant: DVec2,
}

impl ForceManager {
    /// Empties it, keeping its buffer; returns the list to be filled.
    pub(super) fn renew(&mut self) -> &mut Vec<Force> {
        self.forces.clear();
        self.resultant = DVec2::ZERO;
        &mut self.forces
    }

    pub(super) fn add(&mut self, force: Force) {
        self.forces.push(force);
    }

    /// Closes the list: the resultant is the sum of its forces, or what the contact solver found (exactly zero at rest, where a sum
    /// in another order could be one rounding off). Returns it.
    pub(super) fn close(&mut self, solved: Option<DVec2>) -> DVec2 {
        // Adding zero turns −0 into 0.
        self.resultant = solved.unwrap_or_else(|| self.forces.iter().map(|force| force.vector).sum()) + DVec2::ZERO;
        self.resultant
    }

    /// Every single force, in the order in which it was added.
    pub fn forces(&self) -> &[Force] {
        &self.forces
    }

    /// The vector sum of all forces of one kind, N: zero where there is none.
    pub fn total(&self, kind: ForceKind) -> DVec2 {
        self.forces.iter().filter(|force| force.kind == kind).map(|force| force.vector).sum()
    }

    /// The resultant force, N.
    pub fn resultant(&self) -> DVec2 {
        self.resultant
    }
}
