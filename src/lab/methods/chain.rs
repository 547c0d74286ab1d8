//! A chain of bodies in contact along one axis: columns, rows, something heavy on something light. The contact solvers of games act
//! on velocities: body j+1 must not come nearer to body j than their gap allows within the step, `v[j+1] − v[j] ≥ −gap/h`, by impulses
//! λ ≥ 0. Here they are solved by sequential impulses (projected Gauss–Seidel; E. Catto, "Iterative Dynamics with Temporal
//! Coherence", GDC 2005), cold or warm-started or in substeps, and directly.
//!
//! Directly: with s_j = v_j + Σ gap/h it reads s non-decreasing with the least Σ m·(s − s_free)², a weighted isotonic regression; the
//! pool-adjacent-violators method solves it in one pass (M. Ayer et al., Annals of Mathematical Statistics 26, 1955).

/// The part of an overlap that a step of sequential impulses takes back (Baumgarte's method with a usual factor).
const BAUMGARTE: f64 = 0.2;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solver {
    /// Sweeps from the impulses of the step before (warm) or from none (cold).
    Sweeps {
        /// A step.
        sweeps: u32,
        warm: bool,
    },
    /// Parts of a step, with one warm-started sweep each.
    Substeps(u32),
    /// Pool adjacent violators.
    Direct,
}

impl Solver {
    pub const fn parts(self) -> u32 {
        if let Self::Substeps(parts) = self { parts } else { 1 }
    }

    const fn sweeps(self) -> u32 {
        match self {
            Self::Sweeps { sweeps, .. } => sweeps,
            Self::Substeps(_) => 1,
            Self::Direct => 0,
        }
    }
}

/// In the axis' order; gravity and pushes are accelerations along it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chain {
    /// Distance of each body from its place when all touch, m.
    pub places: Vec<f64>,
    /// m/s.
    pub velocities: Vec<f64>,
    /// 1/kg; 0 for an immovable body.
    pub inverse_masses: Vec<f64>,
    /// Impulses of the contacts (j, j+1) in the last step, N·s.
    pub impulses: Vec<f64>,
}

impl Chain {
    /// Bodies of these masses (kg) at rest and touching; the first is immovable if `anchored`.
    pub fn new(masses: &[f64], anchored: bool) -> Self {
        let anchor = anchored.then_some(0.0);
        let inverse_masses: Vec<f64> = anchor.into_iter().chain(masses.iter().map(|mass| 1.0 / mass)).collect();
        let n = inverse_masses.len();
        Self { places: vec![0.0; n], velocities: vec![0.0; n], inverse_masses, impulses: vec![0.0; n - 1] }
    }

    /// One step under these accelerations (m/s², one a body).
    pub fn step(&mut self, accelerations: &[f64], solver: Solver, h: f64) {
        let h = h / f64::from(solver.parts());
        for _ in 0..solver.parts() {
            for (v, a) in self.velocities.iter_mut().zip(accelerations) {
                *v += a * h;
            }
            match solver {
                Solver::Direct => self.solve_directly(h),
                Solver::Sweeps { warm: false, .. } => self.impulses.fill(0.0),
                Solver::Sweeps { warm: true, .. } | Solver::Substeps(_) => self.warm_start(),
            }
            for _ in 0..solver.sweeps() {
                self.sweep(h);
            }
            for (x, v) in self.places.iter_mut().zip(&self.velocities) {
                *x += v * h;
            }
        }
    }

    fn apply(&mut self, contact: usize, impulse: f64) {
        self.velocities[contact] -= impulse * self.inverse_masses[contact];
        self.velocities[contact + 1] += impulse * self.inverse_masses[contact + 1];
    }

    fn warm_start(&mut self) {
        for contact in 0..self.impulses.len() {
            self.apply(contact, self.impulses[contact]);
        }
    }

    /// One sweep of sequential impulses over all contacts.
    pub fn sweep(&mut self, h: f64) {
        for contact in 0..self.impulses.len() {
            let gap = self.places[contact + 1] - self.places[contact];
            let bias = if gap > 0.0 { gap } else { BAUMGARTE * gap } / h;
            let approach = self.velocities[contact + 1] - self.velocities[contact] + bias;
            let mass = 1.0 / (self.inverse_masses[contact] + self.inverse_masses[contact + 1]);
            let impulse = (self.impulses[contact] - approach * mass).max(0.0);
            let change = impulse - self.impulses[contact];
            self.impulses[contact] = impulse;
            self.apply(contact, change);
        }
    }

    fn solve_directly(&mut self, h: f64) {
        // Pools as (end, mass, mean of s); an immovable body's pool has infinite mass and keeps its s.
        let mut pools: Vec<(usize, f64, f64)> = Vec::with_capacity(self.places.len());
        let shift = |i: usize| (self.places[i] - self.places[0]) / h;
        for i in 0..self.places.len() {
            let (mut mass, mut s) = (1.0 / self.inverse_masses[i], self.velocities[i] + shift(i));
            while let Some(&(_, below_mass, below_s)) = pools.last() {
                if below_s < s {
                    break;
                }
                s = if below_mass.is_infinite() { below_s } else { below_s + (s - below_s) * (mass / (below_mass + mass)) };
                mass += below_mass;
                pools.pop();
            }
            pools.push((i + 1, mass, s));
        }
        let mut begin = 0;
        for (end, _, s) in pools {
            // Impulses from the far end on: each is the change of momentum of all bodies beyond it.
            let mut impulse = 0.0;
            for i in (begin..end).rev() {
                let v = s - shift(i);
                if self.inverse_masses[i] > 0.0 {
                    impulse += (v - self.velocities[i]) / self.inverse_masses[i];
                }
                if i > begin {
                    self.impulses[i - 1] = impulse;
                }
                self.velocities[i] = v;
            }
            if begin > 0 {
                self.impulses[begin - 1] = 0.0;
            }
            begin = end;
        }
    }
}

/// The relative error of the worst impulse after each sweep from cold, of an anchored chain of these masses (kg) at rest. The exact
/// impulse is the weight of all bodies beyond it times the step.
pub fn swept_loads(masses: &[f64]) -> impl Iterator<Item = f64> + use<> {
    let mut chain = Chain::new(masses, true);
    chain.velocities[1..].fill(-1.0);
    let exact = weights(masses);
    std::iter::repeat_with(move || {
        chain.sweep(1.0);
        worst_load(&chain.impulses, &exact)
    })
}

/// The load of each body of a column, its own mass included, kg.
pub fn weights(masses: &[f64]) -> Vec<f64> {
    (0..masses.len()).map(|i| masses[i..].iter().sum()).collect()
}

/// The relative load furthest from 1.
pub fn worst_load(found: &[f64], exact: &[f64]) -> f64 {
    let ratios = found.iter().zip(exact).map(|(found, exact)| found / exact);
    ratios.fold(1.0, |worst: f64, ratio| if worst.is_nan() || (ratio - 1.0).abs() <= (worst - 1.0).abs() { worst } else { ratio })
}

/// Sweeps from cold until every contact's impulse of an anchored chain of these masses (kg) at rest is within `part` of its exact
/// value; `None` if `most` do not do.
pub fn sweeps_needed(masses: &[f64], part: f64, most: u32) -> Option<u32> {
    (1..=most).zip(swept_loads(masses)).find(|(_, load)| (load - 1.0).abs() <= part).map(|(sweeps, _)| sweeps)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_direct_solver_finds_the_weights() {
        let mut chain = Chain::new(&[1.0, 5.0, 2.0], true);
        chain.step(&[0.0, -10.0, -10.0, -10.0], Solver::Direct, 0.5);
        assert_eq!(chain.velocities, [0.0; 4]);
        assert_eq!(chain.impulses, [40.0, 35.0, 10.0]);
    }

    #[test]
    fn many_sweeps_come_to_the_same() {
        let masses = [3.0, 1.0, 2.0, 4.0];
        let mut swept = Chain::new(&masses, false);
        swept.places = vec![0.0, 0.001, 0.003, 0.5];
        let mut direct = swept.clone();
        let accelerations = [7.0, 0.0, -2.0, 0.0];
        swept.step(&accelerations, Solver::Sweeps { sweeps: 10_000, warm: false }, 0.1);
        direct.step(&accelerations, Solver::Direct, 0.1);
        for i in 0..4 {
            assert!((swept.velocities[i] - direct.velocities[i]).abs() < 1e-12, "{swept:?} {direct:?}");
        }
        for i in 0..3 {
            assert!((swept.impulses[i] - direct.impulses[i]).abs() < 1e-12, "{swept:?} {direct:?}");
        }
    }
}
