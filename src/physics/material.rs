//! What surfaces are made of: coefficients of friction, and whether they throw back.

/// A surface material: the coefficients of friction of whatever slides on it, both ≥ 0, and of restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Its name as authors write it.
    pub name: &'static str,
    /// Coefficient of static friction μ_s.
    pub static_friction: f64,
    /// Coefficient of kinetic friction μ_k, at most μ_s.
    pub kinetic_friction: f64,
    /// Coefficient of restitution, 0 … 1; a pair bounces with the largest of its two bodies and materials.
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

    /// The material of that name, in any case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|material| material.name.eq_ignore_ascii_case(name))
    }
}
