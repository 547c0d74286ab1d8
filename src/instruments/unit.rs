//! Units of SI as powers of its base units, so that slopes and areas have theirs: m/s a second is m/s², N along m is J.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    kg: i8,
    m: i8,
    s: i8,
}

impl Unit {
    /// m.
    pub const METRE: Self = Self { kg: 0, m: 1, s: 0 };
    /// s.
    pub const SECOND: Self = Self { kg: 0, m: 0, s: 1 };
    /// kg·m/s².
    pub const NEWTON: Self = Self { kg: 1, m: 1, s: -2 };
    /// N·m.
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
