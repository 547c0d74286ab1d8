//! The kinds of force, and their sources. A kind is a line here; its colour stands in `instruments/chart.rs`, its arrow in `view/scale.rs`.

use crate::physics::data::body::BodyId;

macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident: $name:literal, $does:literal;)*) => {
        /// The kinds of force, in the order in which they are listed everywhere.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum ForceKind {
            $($(#[$doc])* $kind,)*
        }

        impl ForceKind {
            /// All kinds.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$kind),*];

            /// The name in files.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $name,)*
                }
            }

            /// The action of the body on the source of the force, by the third law.
            pub const fn does(self) -> &'static str {
                match self {
                    $(Self::$kind => $does,)*
                }
            }
        }
    };
}

kinds! {
    /// m·g downwards, and m times the strength of each field.
    Weight: "Weight", "pulls";
    /// The ship's engine, along the nose or against it.
    Drive: "Drive", "pushes";
    /// Of a supporting surface or object along the contact's normal; never pulls. School calls it the normal force.
    Reaction: "Reaction", "presses on";
    /// Against sliding along a contact.
    Friction: "Friction", "rubs on";
    /// ½·ρ·C_d·(w·|u_y| + h·|u_x|)·u for boxes, ½·ρ·C_d·d·|u|·u for round things, against the motion u relative to the air.
    AirResistance: "Air Resistance", "drags";
    /// An air stream's constant force.
    Wind: "Wind", "holds back";
    /// ρ·g·V of the displaced liquid, upwards.
    Buoyancy: "Buoyancy", "presses on";
    /// The drag of a liquid: quadratic, viscous, and the waves of a body that its surface cuts.
    ViscousDrag: "Viscous Drag", "drags";
    /// Of another object beside the body.
    Push: "Push", "pushes";
    /// Of a spring between two bodies, or a body and a place.
    Spring: "Spring", "pulls";
    /// Of a rope that is taut; never pushes.
    Tension: "Tension", "pulls";
    /// Of a magnet: it falls with the square of the distance.
    Magnetic: "Magnetic Force", "pulls";
}

impl ForceKind {
    /// The name on the screen.
    pub const fn shown(self) -> &'static str {
        if matches!(self, Self::Reaction) { "Normal force" } else { self.name() }
    }

    /// Whether it only resists a motion: static friction need not hold against such forces.
    pub const fn is_resistance(self) -> bool {
        matches!(self, Self::Friction | Self::AirResistance | Self::ViscousDrag)
    }
}

/// The exerting thing of a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Source {
    /// The field of gravity.
    Gravity,
    /// The body's own engine.
    Engine,
    /// The air.
    Air,
    /// The air stream of that index in [`crate::physics::data::def::WorldDef::streams`].
    Stream(u32),
    /// The field of that index in [`crate::physics::data::def::WorldDef::fields`].
    Field(u32),
    /// The liquid of that index in [`crate::physics::data::def::WorldDef::fluids`].
    Fluid(u32),
    /// The immovable surface of that index in `World::surfaces`.
    Surface(u32),
    /// Another body.
    Body(BodyId),
    /// The link of that index in `World::links`.
    Link(u32),
}

impl Source {
    pub(crate) const fn number(self) -> u64 {
        let (kind, index) = match self {
            Self::Gravity => (0, 0),
            Self::Engine => (1, 0),
            Self::Air => (2, 0),
            Self::Stream(index) => (3, index),
            Self::Field(index) => (4, index),
            Self::Fluid(index) => (5, index),
            Self::Surface(index) => (6, index),
            Self::Body(BodyId(index)) => (7, index),
            Self::Link(index) => (8, index),
        };
        (kind << 32) | index as u64
    }

    pub(crate) const fn is_zone(self) -> bool {
        matches!(self, Self::Stream(_) | Self::Field(_))
    }
}
