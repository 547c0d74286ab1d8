//! Surfaces: what is solid and moves for nobody, on *legs* of constant acceleration, so that times of impact are roots of polynomials there as well.

use crate::physics::data::domain::{self, DefError, LARGEST, expect, number, rectangle, vector};
use crate::physics::data::{aabb::Aabb, material::Material};
use glam::DVec2;

/// The solid sides of a surface. A body that comes from another side passes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sides {
    /// For what comes from the left.
    pub left: bool,
    /// For what comes from the right.
    pub right: bool,
    /// For what comes from above.
    pub top: bool,
    /// For what comes from below.
    pub bottom: bool,
}

impl Default for Sides {
    fn default() -> Self {
        Self::ALL
    }
}

impl Sides {
    /// Solid all around.
    pub const ALL: Self = Self { left: true, right: true, top: true, bottom: true };
    /// One-way: solid for what comes from above.
    pub const TOP: Self = Self { left: false, right: false, top: true, bottom: false };

    /// Whether it is solid for what lies on the side of smaller (`false`) or larger (`true`) coordinates along an axis (0: x, 1: y).
    pub const fn face(&self, axis: usize, larger: bool) -> bool {
        match (axis, larger) {
            (0, false) => self.left,
            (0, true) => self.right,
            (_, false) => self.top,
            (_, true) => self.bottom,
        }
    }
}

/// A part of a path with constant acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// s, > 0.
    pub duration: f64,
    /// At its start, m/s.
    pub velocity: DVec2,
    /// m/s².
    pub acceleration: DVec2,
}

/// The path of a surface from its first place. After its last leg it begins again, or stands still.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// None: it never moves.
    pub legs: Vec<Leg>,
    /// Whether it begins again after the last leg; the legs must lead back to the start then.
    pub repeats: bool,
}

/// Where a surface on a path is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PathPoint {
    /// From the start of the path, m.
    pub offset: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// m/s².
    pub acceleration: DVec2,
    /// How long it goes on like this, s; infinite where it stands still for ever.
    pub lasts: f64,
}

impl PathPoint {
    pub(crate) fn at_rest(self) -> Self {
        Self { offset: self.offset, lasts: f64::INFINITY, ..Self::default() }
    }
}

impl Path {
    /// To `offset` (m) and back for ever: `travel` s each way, with `ease` s (≤ `travel`/2) to speed up and to slow down, and `wait` s at either end.
    pub fn shuttle(offset: DVec2, travel: f64, ease: f64, wait: f64) -> Self {
        let mut legs = Vec::new();
        for way in [offset, -offset] {
            let cruise = way / (travel - ease);
            let mut leg = |duration: f64, velocity: DVec2, acceleration: DVec2| {
                // A negative duration is refused later.
                if duration != 0.0 {
                    legs.push(Leg { duration, velocity, acceleration });
                }
            };
            let pull = if ease > 0.0 { cruise / ease } else { DVec2::ZERO };
            leg(wait, DVec2::ZERO, DVec2::ZERO);
            leg(ease, DVec2::ZERO, pull);
            leg(travel - 2.0 * ease, cruise, DVec2::ZERO);
            leg(ease, cruise, -pull);
        }
        Self { legs, repeats: true }
    }

    /// With this velocity (m/s) for ever, or as long as numbers last.
    pub fn steady(velocity: DVec2) -> Self {
        Self { legs: vec![Leg { duration: LARGEST, velocity, acceleration: DVec2::ZERO }], repeats: false }
    }

    /// Whether the surface never moves.
    pub fn is_still(&self) -> bool {
        self.legs.is_empty()
    }

    /// The time since the present round began: a small number loses fewer digits.
    fn wrap(&self, clock: f64) -> f64 {
        let period: f64 = self.legs.iter().map(|leg| leg.duration).sum();
        if self.repeats && clock >= period { clock % period } else { clock }
    }

    /// Its point `clock` seconds (≥ 0) after it began.
    pub fn at(&self, clock: f64) -> PathPoint {
        let (mut left, mut offset) = (self.wrap(clock), DVec2::ZERO);
        for &Leg { duration, velocity, acceleration } in &self.legs {
            if left < duration - CLOCK_ROUNDING * clock {
                offset += (velocity + acceleration * (0.5 * left)) * left;
                return PathPoint { offset, velocity: velocity + acceleration * left, acceleration, lasts: duration - left };
            }
            offset += (velocity + acceleration * (0.5 * duration)) * duration;
            left = (left - duration).max(0.0);
        }
        // Rounding may have put the clock at the end of a round.
        if self.repeats && clock != 0.0 { self.at(0.0) } else { PathPoint { offset, ..PathPoint::default() }.at_rest() }
    }

    /// Refuses a leg that is not finite or lasts no time, and a repeated path that does not lead back.
    fn check(&self) -> Result<(), DefError> {
        expect(!self.repeats || !self.legs.is_empty(), || "a repeated path has no leg".into())?;
        let (mut offset, mut longest) = (DVec2::ZERO, 0.0f64);
        for leg in &self.legs {
            // Shorter ones than a millisecond would part a tick without end.
            number("the duration of a leg of a path", leg.duration, 1e-3)?;
            vector("a path's velocity", leg.velocity)?;
            vector("a path's acceleration", leg.acceleration)?;
            offset += (leg.velocity + leg.acceleration * (0.5 * leg.duration)) * leg.duration;
            vector("where a path leads", if self.legs.len() > 1 { offset } else { DVec2::ZERO })?;
            longest = longest.max(offset.length());
        }
        // 1e-9 is the rounding of the sum.
        let end = offset.length();
        let leads_back = !self.repeats || end <= 1e-9 * longest;
        expect(leads_back, || format!("a repeated path ends {end} m from its start, expected 0 m"))
    }
}

/// Relative to the clock of a path: a shorter leg is over. Smaller: a tick never gets beyond a leg that lasts less than a rounding.
const CLOCK_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Something solid that moves for nobody.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceDef {
    /// Where it is at the start, m.
    pub bounds: Aabb,
    /// What slides on it.
    pub material: Material,
    /// How it moves.
    pub path: Path,
    /// From which sides it is solid.
    pub sides: Sides,
    /// The speed of its skin, m/s, clockwise around it: the top runs to the right.
    pub belt: f64,
    /// Whether it is there from the start.
    pub present: bool,
    /// Whether it goes along its path from the start.
    pub runs: bool,
}

impl Default for SurfaceDef {
    fn default() -> Self {
        Self::fixed(Aabb::new(DVec2::ZERO, DVec2::ONE), Material::ASPHALT)
    }
}

impl SurfaceDef {
    /// A surface that stands still and is solid all around.
    pub fn fixed(bounds: Aabb, material: Material) -> Self {
        Self { bounds, material, path: Path::default(), sides: Sides::ALL, belt: 0.0, present: true, runs: true }
    }

    pub(crate) fn check(&self) -> Result<(), DefError> {
        rectangle("a surface", &self.bounds)?;
        domain::material(&self.material)?;
        number("the speed of a belt", self.belt, -LARGEST)?;
        self.path.check()
    }
}

/// A surface of a world, as it is now.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Where it is, m.
    pub bounds: Aabb,
    /// How fast it moves, m/s; without the speed of its belt.
    pub velocity: DVec2,
    /// What slides on it.
    pub material: Material,
    /// Whether it is there: what is absent touches nothing.
    pub present: bool,
    pub(crate) def: SurfaceDef,
    pub(crate) clock: f64,
    /// How fast its belt runs now, m/s.
    pub(crate) belt: f64,
    pub(crate) runs: bool,
    /// Whether it shall be there as soon as nothing is in its way.
    pub(crate) wanted: bool,
    /// Whether it moved in the last tick: what touched it then has to know when that is over.
    pub(crate) moved: bool,
}

impl Surface {
    pub(crate) fn new(def: SurfaceDef) -> Self {
        let SurfaceDef { bounds, material, present, belt, runs, .. } = def;
        let (velocity, clock, wanted, moved) = (DVec2::ZERO, 0.0, present, false);
        let mut surface = Self { bounds, velocity, material, present, def, clock, belt, runs, wanted, moved };
        surface.go_on(0.0);
        surface
    }

    /// Velocity of its skin on the side with that outward normal, m/s.
    pub fn skin(&self, outward: DVec2) -> DVec2 {
        self.velocity + outward.perp() * self.belt
    }

    /// From which sides it is solid.
    pub const fn sides(&self) -> Sides {
        self.def.sides
    }

    /// Its point `t` seconds from now, with its centre in place of the offset.
    pub(crate) fn at(&self, t: f64) -> PathPoint {
        let moves = self.runs && !self.def.path.is_still();
        let mut point = self.def.path.at(self.clock + if moves { t } else { 0.0 });
        point.offset += self.def.bounds.centre();
        if moves { point } else { point.at_rest() }
    }

    /// Lets `t` seconds pass on its path.
    pub(crate) fn go_on(&mut self, t: f64) {
        if self.def.path.is_still() {
            return;
        }
        self.moved = self.moves_within(t);
        if self.runs {
            self.clock = self.def.path.wrap(self.clock + t);
        }
        let point = self.at(0.0);
        self.bounds = Aabb::around(point.offset, self.def.bounds.size() * 0.5);
        self.velocity = point.velocity;
    }

    pub(crate) fn moves_within(&self, t: f64) -> bool {
        let point = self.at(0.0);
        self.present && (point.velocity != DVec2::ZERO || point.acceleration != DVec2::ZERO || point.lasts <= t)
    }

    /// Velocity at which it arrives in `t` seconds, before a next leg may begin there, m/s.
    pub(crate) fn arrives(&self, t: f64) -> DVec2 {
        self.legs(t).last().map_or(self.velocity, |(point, leg)| point.velocity + point.acceleration * leg)
    }

    /// The legs of its path within `t` seconds: the start of each, and its duration.
    fn legs(&self, t: f64) -> impl Iterator<Item = (PathPoint, f64)> {
        let mut next = Some(0.0);
        std::iter::from_fn(move || {
            let from = next?;
            let (point, left) = (self.at(from), t - from);
            next = (point.lasts < left * (1.0 - CLOCK_ROUNDING)).then_some(from + point.lasts);
            Some((point, if next.is_some() { point.lasts } else { left }))
        })
    }

    /// What it sweeps within the next `t` seconds, m.
    pub(crate) fn swept(&self, t: f64) -> Aabb {
        let (mut swept, half) = (self.bounds, self.bounds.size() * 0.5);
        if !self.moves_within(t) {
            return swept;
        }
        for (point, leg) in self.legs(t) {
            // A turn within the leg leads as far beyond its ends.
            let turn = point.acceleration.abs() * (0.5 * leg * leg);
            let end = point.offset + (point.velocity + point.acceleration * (0.5 * leg)) * leg;
            swept = swept.union(&Aabb::around(point.offset, half + turn)).union(&Aabb::around(end, half + turn));
        }
        swept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shuttle_goes_there_and_comes_back() {
        let path = Path::shuttle(DVec2::new(0.0, -6.0), 4.0, 1.0, 0.5);
        path.check().unwrap();
        assert_eq!(path.at(0.25), PathPoint { lasts: 0.25, ..PathPoint::default() });
        let there = path.at(4.5);
        assert!((there.offset - DVec2::new(0.0, -6.0)).length() < 1e-14 && there.velocity == DVec2::ZERO);
        let middle = path.at(2.5);
        assert!((middle.offset.y + 3.0).abs() < 1e-14 && middle.velocity == DVec2::new(0.0, -2.0));
        assert!(path.at(9.0 + 2.5).offset.distance(middle.offset) < 1e-12);
        // A quarter of a second into the first leg that speeds up: ½·2·0.25².
        assert!((path.at(0.75).offset.y + 0.0625).abs() < 1e-15);
    }

    #[test]
    fn a_path_that_does_not_lead_back_cannot_repeat() {
        let leg = Leg { duration: 1.0, velocity: DVec2::X, acceleration: DVec2::ZERO };
        assert!(Path { legs: vec![leg], repeats: true }.check().is_err());
        let once = Path { legs: vec![leg], repeats: false };
        once.check().unwrap();
        assert_eq!(once.at(7.0), PathPoint { offset: DVec2::X, lasts: f64::INFINITY, ..PathPoint::default() });
    }
}
