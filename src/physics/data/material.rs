//! Materials: coefficients of friction and restitution.

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Coefficients {
    pub static_friction: f64,
    pub kinetic_friction: f64,
    pub restitution: f64,
}

impl Coefficients {
    pub fn rubs_like(&self, other: &Self) -> bool {
        self.static_friction == other.static_friction && self.kinetic_friction == other.kinetic_friction
    }

    /// Those of a body in contact with a body or a surface: the larger restitution; the surface's friction, or the smaller of two bodies'.
    pub fn with(self, other: Self, is_surface: bool) -> Self {
        let friction = |mine: f64, other: f64| if is_surface { other } else { mine.min(other) };
        Self {
            static_friction: friction(self.static_friction, other.static_friction),
            kinetic_friction: friction(self.kinetic_friction, other.kinetic_friction),
            restitution: self.restitution.max(other.restitution),
        }
    }
}

/// A material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Its name as authors write it.
    pub name: &'static str,
    /// Coefficient of static friction μ_s.
    pub static_friction: f64,
    /// Coefficient of kinetic friction μ_k, at most μ_s.
    pub kinetic_friction: f64,
    /// Coefficient of restitution, 0 … 1; a body takes the larger of its own and its material's.
    pub restitution: f64,
}

impl Material {
    /// The default of everything solid. Its 0.65 is fixed by the golden numbers.
    pub const ASPHALT: Self = Self::new("Asphalt", 0.9, 0.65);
    /// Steel.
    pub const STEEL: Self = Self::new("Steel", 0.3, 0.2);
    /// Ice.
    pub const ICE: Self = Self::new("Ice", 0.1, 0.03);
    /// Rubber.
    pub const RUBBER: Self = Self::new("Rubber", 1.15, 0.9);
    /// Wood.
    pub const WOOD: Self = Self::new("Wood", 0.5, 0.4);
    /// Glass.
    pub const GLASS: Self = Self::new("Glass", 0.9, 0.4);
    /// Throws back what falls on it with nine tenths of its speed.
    pub const TRAMPOLINE: Self = Self { restitution: 0.9, ..Self::new("Trampoline", 1.15, 0.9) };
    /// Those that throw nothing back.
    pub const FIRM: [Self; 6] = [Self::ASPHALT, Self::STEEL, Self::ICE, Self::RUBBER, Self::WOOD, Self::GLASS];
    /// All that an author can name.
    pub const ALL: [Self; 7] = [Self::ASPHALT, Self::STEEL, Self::ICE, Self::RUBBER, Self::WOOD, Self::GLASS, Self::TRAMPOLINE];

    const fn new(name: &'static str, static_friction: f64, kinetic_friction: f64) -> Self {
        Self { name, static_friction, kinetic_friction, restitution: 0.0 }
    }

    pub(crate) const fn coefficients(&self) -> Coefficients {
        let Self { static_friction, kinetic_friction, restitution, .. } = *self;
        Coefficients { static_friction, kinetic_friction, restitution }
    }

    /// The material of that name, in any case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|material| material.name.eq_ignore_ascii_case(name))
    }
}
