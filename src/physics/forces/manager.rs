//! The named constant forces on a body; `World::forces` lists with them, at the tick's end, those of laws that change within a tick and of contacts.

use crate::physics::forces::kind::{ForceKind, Source};
use glam::DVec2;

/// One force on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Force {
    /// Its kind, which is also its name.
    pub kind: ForceKind,
    /// The thing that exerts it.
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
    /// Of each axis, the rounding of a balance, in parts of the sum of the magnitudes.
    rounding: DVec2,
}

impl ForceManager {
    /// Adds a force (N), or replaces that of the same source and kind; zero, or what is not finite, removes it. Returns whether anything changed.
    pub fn add(&mut self, source: Source, kind: ForceKind, vector: DVec2) -> bool {
        if vector == DVec2::ZERO || !vector.is_finite() {
            return self.remove(source, kind);
        }
        // In the order of sources and kinds, so that the sum does not depend on when they began; a list of `World::forces` has another.
        let key = (source, kind);
        let same = |force: &Force| (force.source, force.kind) == key;
        if self.forces.iter().filter(|force| same(force)).map(|force| force.vector).eq([vector]) {
            return false;
        }
        self.forces.retain(|force| !same(force));
        let at = self.forces.iter().position(|force| (force.source, force.kind) > key).unwrap_or(self.forces.len());
        self.forces.insert(at, Force { kind, source, vector, point: DVec2::ZERO });
        true
    }

    /// Removes a force. Returns whether it was there.
    pub fn remove(&mut self, source: Source, kind: ForceKind) -> bool {
        let before = self.forces.len();
        self.forces.retain(|force| (force.source, force.kind) != (source, kind));
        self.forces.len() < before
    }

    /// The force of one source and kind, N.
    pub fn get(&self, source: Source, kind: ForceKind) -> Option<DVec2> {
        self.forces.iter().find(|force| (force.source, force.kind) == (source, kind)).map(|force| force.vector)
    }

    /// The forces of one kind.
    pub fn all(&self, kind: ForceKind) -> impl Iterator<Item = &Force> {
        self.forces.iter().filter(move |force| force.kind == kind)
    }

    /// Every single force.
    pub fn forces(&self) -> &[Force] {
        &self.forces
    }

    /// The vector sum of all forces of one kind, N: zero where there is none.
    pub fn total(&self, kind: ForceKind) -> DVec2 {
        self.all(kind).map(|force| force.vector).sum()
    }

    /// The resultant force, N: the sum, in which rounding of forces that balance counts as zero.
    pub fn resultant(&self) -> DVec2 {
        self.sum_of(|_| true)
    }

    /// The resultant without friction and the drag of air and liquids, N: the force that static friction has to hold on a body at rest.
    pub fn resultant_without_resistance(&self) -> DVec2 {
        self.sum_of(|kind| !kind.is_resistance())
    }

    fn sum_of(&self, counts: impl Fn(ForceKind) -> bool) -> DVec2 {
        let counted = || self.forces.iter().filter(|force| counts(force.kind)).map(|force| force.vector);
        let (sum, size): (DVec2, DVec2) = (counted().sum(), counted().map(DVec2::abs).sum());
        // Adding zero turns −0 into 0.
        DVec2::select(sum.abs().cmple(size * self.rounding.max(DVec2::splat(4.0 * f64::EPSILON))), DVec2::ZERO, sum) + DVec2::ZERO
    }

    /// The sum of the pushes, N.
    pub(crate) fn push(&self) -> DVec2 {
        self.forces.iter().fold(DVec2::ZERO, |sum, force| sum + force.vector)
    }

    pub(crate) fn push_of_no_zone(&self) -> DVec2 {
        self.forces.iter().filter(|force| !force.source.is_zone()).fold(DVec2::ZERO, |sum, force| sum + force.vector)
    }

    /// Removes the forces of zones that are not near.
    pub(crate) fn leave_zones(&mut self, near: impl Fn(Source) -> bool) {
        self.forces.retain(|force| !force.source.is_zone() || near(force.source));
    }

    /// Room for eight forces: zones that a body enters allocate nothing then.
    pub(crate) fn with_room() -> Self {
        Self { forces: Vec::with_capacity(8), ..Self::default() }
    }

    pub(crate) fn clear(&mut self) {
        self.forces.clear();
        self.rounding = DVec2::ZERO;
    }

    /// Appends one to a list; zero is none.
    pub(crate) fn list(&mut self, force: Force) {
        if force.vector != DVec2::ZERO {
            self.forces.push(force);
        }
    }

    /// Makes the last force of a kind that which balances those before it along the vertical.
    pub(crate) fn balance(&mut self, kind: ForceKind) {
        if let Some(last) = self.forces.iter().rposition(|force| force.kind == kind) {
            self.forces[last].vector.y = -self.forces[..last].iter().map(|force| force.vector.y).sum::<f64>();
        }
    }

    /// Closes the list of a body with that acceleration, m/s²: where it is 0, contacts balance to 1e-9, and links, differences of places, to 1e-6.
    pub(crate) fn close(&mut self, acceleration: DVec2, linked: bool) {
        let rounding = if linked { 1e-6 } else { 1e-9 };
        self.rounding = DVec2::select(acceleration.cmpeq(DVec2::ZERO), DVec2::splat(rounding), DVec2::ZERO);
    }
}
