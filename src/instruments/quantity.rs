//! A body's measurable quantities at an instant. x counts to the right from the level's left edge and y **up** from its lower edge, as in school.
//! Units of SI as powers of its base units, so that slopes and areas have theirs: m/s a second is m/s², N along m is J.

use crate::physics::{BodyId, DVec2, ForceKind};
use crate::{game::Game, words::tr};

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VectorPart {
    X,
    #[default]
    Y,
    Size,
}

impl VectorPart {
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Size];

    fn of(self, vector: DVec2) -> f64 {
        match self {
            Self::X => vector.x,
            Self::Y => vector.y,
            Self::Size => vector.length(),
        }
    }

    /// The rate of a vector that changes at `rate`; the size of a vector of 0 has none.
    fn rate_of(self, vector: DVec2, rate: DVec2) -> Option<f64> {
        match self {
            Self::X => Some(rate.x),
            Self::Y => Some(rate.y),
            Self::Size => (vector != DVec2::ZERO).then(|| vector.dot(rate) / vector.length()),
        }
    }

    fn written(self, symbol: &str) -> String {
        match self {
            Self::X => format!("{symbol}_x"),
            Self::Y => format!("{symbol}_y"),
            Self::Size => format!("|{symbol}|"),
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quantity {
    /// s, since the start.
    #[default]
    Time,
    /// From the level's left edge, m.
    X,
    /// Above the level's lower edge, m.
    Y,
    /// m/s.
    Velocity(VectorPart),
    /// m/s².
    Acceleration(VectorPart),
    /// Of all forces, N.
    Resultant(VectorPart),
    /// All forces of that kind together, N.
    Force(ForceKind, VectorPart),
    /// m·v, N·s.
    Momentum(VectorPart),
    /// ½·m·v², J.
    Kinetic,
    /// m·g·y in the gravity of the level, J: zones of another gravity and liquids have none in it.
    Potential,
    /// J.
    Mechanical,
}

/// In SI units, y upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    pub time: f64,
    pub constants: BodyConstants,
    /// From the level's lower left corner.
    pub position: DVec2,
    pub velocity: DVec2,
    pub acceleration: DVec2,
    pub resultant: DVec2,
    /// By kind, in the order of [`ForceKind::ALL`].
    pub forces: [DVec2; ForceKind::ALL.len()],
}

/// Constants of a body while the level is flown as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyConstants {
    /// kg.
    pub mass: f64,
    /// The level's gravity on it, N/kg, y upwards.
    pub field: DVec2,
    /// Zero of the potential energy, m: the edges to which the field points.
    pub ground: DVec2,
    /// Height of the level, m.
    pub height: f64,
}

impl BodyConstants {
    pub fn of(game: &Game, id: BodyId) -> Self {
        let (level, body) = (game.level(), game.world().body(id));
        let field = if body.weightless { DVec2::ZERO } else { DVec2::new(level.gravity_x, -level.gravity) };
        let edge = |pull: f64, size: f64| if pull > 0.0 { size } else { 0.0 };
        let ground = DVec2::new(edge(field.x, level.size.x), edge(field.y, level.size.y));
        Self { mass: body.mass, field, ground, height: level.size.y }
    }
}

/// A vector of the engine, whose y counts down.
pub(super) fn upwards(vector: DVec2) -> DVec2 {
    // Subtracted, so that none stays 0 and is not −0.
    DVec2::new(vector.x, 0.0 - vector.y)
}

impl Moment {
    pub fn of(game: &Game, id: BodyId) -> Self {
        let (body, forces) = (game.world().body(id), game.world().forces(id));
        let constants = BodyConstants::of(game, id);
        Self {
            time: game.elapsed(),
            constants,
            position: DVec2::new(body.position.x, constants.height - body.position.y),
            velocity: upwards(body.velocity),
            acceleration: upwards(body.acceleration),
            resultant: upwards(forces.resultant()),
            forces: ForceKind::ALL.map(|kind| upwards(forces.total(kind))),
        }
    }

    fn kinetic(&self) -> f64 {
        0.5 * self.constants.mass * self.velocity.length_squared()
    }

    fn potential(&self) -> f64 {
        let BodyConstants { mass, field, ground, .. } = self.constants;
        0.0 - mass * field.dot(self.position - ground)
    }
}

impl Quantity {
    pub fn of(self, moment: &Moment) -> f64 {
        match self {
            Self::Time => moment.time,
            Self::X => moment.position.x,
            Self::Y => moment.position.y,
            Self::Velocity(part) => part.of(moment.velocity),
            Self::Acceleration(part) => part.of(moment.acceleration),
            Self::Resultant(part) => part.of(moment.resultant),
            Self::Force(kind, part) => part.of(moment.forces[kind as usize]),
            Self::Momentum(part) => part.of(moment.constants.mass * moment.velocity),
            Self::Kinetic => moment.kinetic(),
            Self::Potential => moment.potential(),
            Self::Mechanical => moment.kinetic() + moment.potential(),
        }
    }

    /// Its rate of change at a moment, in its unit a second, where the moment gives it: dr/dt = v, dv/dt = a, d(½mv²)/dt = m·a·v.
    pub fn rate(self, moment: &Moment) -> Option<f64> {
        let Moment { velocity, acceleration, constants: BodyConstants { mass, field, .. }, .. } = *moment;
        match self {
            Self::Time => Some(1.0),
            Self::X => Some(velocity.x),
            Self::Y => Some(velocity.y),
            Self::Velocity(part) => part.rate_of(velocity, acceleration),
            Self::Momentum(part) => part.rate_of(mass * velocity, mass * acceleration),
            Self::Kinetic => Some(mass * acceleration.dot(velocity)),
            Self::Potential => Some(-mass * field.dot(velocity)),
            Self::Mechanical => Some(mass * (acceleration - field).dot(velocity)),
            Self::Acceleration(_) | Self::Resultant(_) | Self::Force(..) => None,
        }
    }

    pub const fn unit(self) -> Unit {
        match self {
            Self::Time => Unit::SECOND,
            Self::X | Self::Y => Unit::METRE,
            Self::Velocity(_) => Unit::METRE.per(Unit::SECOND),
            Self::Acceleration(_) => Unit::METRE.per(Unit::SECOND).per(Unit::SECOND),
            Self::Resultant(_) | Self::Force(..) => Unit::NEWTON,
            Self::Momentum(_) => Unit::NEWTON.times(Unit::SECOND),
            Self::Kinetic | Self::Potential | Self::Mechanical => Unit::JOULE,
        }
    }

    /// For the screen: `t`, `v_y`, `|a|`, `Weight_y`.
    pub fn symbol(self) -> String {
        match self {
            Self::Force(kind, part) => part.written(tr(kind.shown())),
            other => other.stem(),
        }
    }

    /// For files, where forces have the names that they have in all files.
    pub fn stem(self) -> String {
        match self {
            Self::Time => "t".to_owned(),
            Self::X => "x".to_owned(),
            Self::Y => "y".to_owned(),
            Self::Velocity(part) => part.written("v"),
            Self::Acceleration(part) => part.written("a"),
            Self::Resultant(part) => part.written("F"),
            Self::Force(kind, part) => part.written(kind.name()),
            Self::Momentum(part) => part.written("p"),
            Self::Kinetic => "E_kin".to_owned(),
            Self::Potential => "E_pot".to_owned(),
            Self::Mechanical => "E_mech".to_owned(),
        }
    }

    pub fn column(self) -> String {
        format!("{} ({})", self.stem(), self.unit().name())
    }

    /// The heading of an axis: `v_y (m/s)`.
    pub fn heading(self) -> String {
        format!("{} ({})", self.symbol(), self.unit().name())
    }

    /// Its group in words.
    pub const fn family(self) -> &'static str {
        match self {
            Self::Time => "Time",
            Self::X | Self::Y => "Position",
            Self::Velocity(_) => "Velocity",
            Self::Acceleration(_) => "Acceleration",
            Self::Resultant(_) => "Resultant",
            Self::Force(kind, _) => kind.shown(),
            Self::Momentum(_) => "Momentum",
            Self::Kinetic | Self::Potential | Self::Mechanical => "Energy",
        }
    }

    /// Whether the area under a curve of it says anything: that under a place does not.
    pub const fn has_area(self) -> bool {
        !matches!(self, Self::Time | Self::X | Self::Y)
    }

    /// Whether it jumps at an impact, so that a curve of it breaks there. A place never jumps.
    pub const fn jumps(self) -> bool {
        !matches!(self, Self::Time | Self::X | Self::Y | Self::Potential)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    kg: i8,
    m: i8,
    s: i8,
}

impl Unit {
    pub const METRE: Self = Self { kg: 0, m: 1, s: 0 };
    pub const SECOND: Self = Self { kg: 0, m: 0, s: 1 };
    pub const NEWTON: Self = Self { kg: 1, m: 1, s: -2 };
    pub const JOULE: Self = Self { kg: 1, m: 2, s: -2 };

    /// Units with a name of their own.
    const NAMED: [(Self, &'static str); 10] = [
        (Self::NEWTON, "N"),
        (Self::JOULE, "J"),
        (Self { kg: 1, m: 2, s: -3 }, "W"),
        (Self { kg: 1, m: 1, s: -1 }, "N·s"),
        (Self { kg: 1, m: 1, s: -3 }, "N/s"),
        (Self { kg: 1, m: 2, s: -1 }, "J·s"),
        (Self { kg: 1, m: 0, s: -2 }, "N/m"),
        (Self { kg: 1, m: 3, s: -2 }, "J·m"),
        (Self { kg: 2, m: 2, s: -4 }, "N²"),
        (Self { kg: 2, m: 4, s: -4 }, "J²"),
    ];

    pub const fn times(self, other: Self) -> Self {
        Self { kg: self.kg + other.kg, m: self.m + other.m, s: self.s + other.s }
    }

    pub const fn per(self, other: Self) -> Self {
        Self { kg: self.kg - other.kg, m: self.m - other.m, s: self.s - other.s }
    }

    /// Empty for a mere number.
    pub fn name(self) -> String {
        if let Some((_, name)) = Self::NAMED.iter().find(|(unit, _)| *unit == self) {
            return (*name).to_owned();
        }
        let base = [("kg", self.kg), ("m", self.m), ("s", self.s)];
        let powers = |wanted: fn(i8) -> bool| {
            let factor = |(name, power): &(&str, i8)| match power.unsigned_abs() {
                1 => (*name).to_owned(),
                2 => format!("{name}²"),
                3 => format!("{name}³"),
                4 => format!("{name}⁴"),
                more => format!("{name}^{more}"),
            };
            base.iter().filter(|(_, power)| wanted(*power)).map(factor).collect::<Vec<_>>().join("·")
        };
        let (above, below) = (powers(|power| power > 0), powers(|power| power < 0));
        match (above.is_empty(), below.is_empty(), below.contains('·')) {
            (_, true, _) => above,
            (true, false, false) => format!("1/{below}"),
            (false, false, false) => format!("{above}/{below}"),
            (true, false, true) => format!("1/({below})"),
            (false, false, true) => format!("{above}/({below})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn moment(time: f64, motion: impl Fn(f64) -> DVec2) -> Moment {
        // Derivatives by differences: of a parabola these are exact but for rounding.
        let h = 0.25;
        let (before, at, after) = (motion(time - h), motion(time), motion(time + h));
        let (velocity, acceleration) = ((after - before) / (2.0 * h), (after - 2.0 * at + before) / (h * h));
        let constants = BodyConstants { mass: 3.0, field: DVec2::new(0.5, -9.81), ground: DVec2::new(40.0, 0.0), height: 20.0 };
        let forces = [DVec2::ZERO; ForceKind::ALL.len()];
        Moment { time, constants, position: at, velocity, acceleration, resultant: 3.0 * acceleration, forces }
    }

    fn all() -> Vec<Quantity> {
        let vectors = VectorPart::ALL.into_iter().flat_map(|part| [Quantity::Velocity(part), Quantity::Momentum(part)]);
        let plain = [Quantity::Time, Quantity::X, Quantity::Y, Quantity::Kinetic, Quantity::Potential, Quantity::Mechanical];
        vectors.chain(plain).collect()
    }

    proptest! {
        #[test]
        fn a_rate_is_the_slope_of_its_quantity(v in (1.0..9.0, -9.0..9.0), a in (-5.0..5.0, -9.9..9.9), t in -2.0..2.0) {
            let motion = |t: f64| DVec2::new(5.0, 6.0) + DVec2::from(v) * t + 0.5 * DVec2::from(a) * t * t;
            let h = 1e-4;
            for quantity in all() {
                let at = |t: f64| quantity.of(&moment(t, motion));
                let slope = (at(t + h) - at(t - h)) / (2.0 * h);
                let here = moment(t, motion);
                // The size of a velocity has a corner where the motion reverses.
                prop_assume!(here.velocity.length() > 0.1);
                let rate = quantity.rate(&here).unwrap();
                prop_assert!((slope - rate).abs() <= 1e-4 * (1.0 + rate.abs()), "{quantity:?}: {slope}, {rate}");
            }
        }
    }

    #[test]
    fn what_falls_freely_keeps_its_energy_and_headings_have_units() {
        let fall = |t: f64| DVec2::new(5.0 + 0.25 * t * t, 6.0 + 2.0 * t - 0.5 * 9.81 * t * t);
        let energy = |t: f64| Quantity::Mechanical.of(&moment(t, fall));
        assert!((energy(0.0) - energy(3.0)).abs() < 1e-9 * energy(0.0));
        assert!(Quantity::Mechanical.rate(&moment(1.0, fall)).unwrap().abs() < 1e-9);
        let headings = [
            Quantity::Y,
            Quantity::Velocity(VectorPart::Y),
            Quantity::Force(ForceKind::Weight, VectorPart::Size),
            Quantity::Kinetic,
        ];
        assert_eq!(headings.map(Quantity::heading), ["y (m)", "v_y (m/s)", "|Weight| (N)", "E_kin (J)"]);
    }

    #[test]
    fn the_kinds_of_force_stand_in_the_order_of_their_numbers() {
        for (i, kind) in ForceKind::ALL.into_iter().enumerate() {
            assert_eq!(kind as usize, i);
        }
    }

    #[test]
    fn slopes_and_areas_have_the_units_of_school() {
        let (m, s) = (Unit::METRE, Unit::SECOND);
        let v = m.per(s);
        let names = [
            (v, "m/s"),
            (v.per(s), "m/s²"),
            (v.times(s), "m"),
            (Unit::NEWTON.times(m), "J"),
            (Unit::NEWTON.times(s), "N·s"),
            (Unit::NEWTON.times(s).per(s), "N"),
            (Unit::JOULE.per(m), "N"),
            (Unit::JOULE.per(s), "W"),
            (v.per(s).per(s), "m/s³"),
            (m.times(s), "m·s"),
            (v.per(m), "1/s"),
            (m.per(m), ""),
            (s.per(Unit::NEWTON), "s³/(kg·m)"),
            (Unit::JOULE.times(m).times(m), "kg·m⁴/s²"),
        ];
        for (unit, name) in names {
            assert_eq!(unit.name(), name);
        }
    }
}
