//! Bodies in contact along an axis, by contact solvers of games: v\[j+1\] − v\[j\] ≥ −gap/h by impulses λ ≥ 0, and across friction within ±μ·λ.
//! Sequential impulses (projected Gauss–Seidel): E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005. Soft: "Solver2D", 2024.
//! Positions: M. Macklin et al., "XPBD", Motion in Games 2016, and "Small Steps in Physics Simulation", SCA 2019. Directly, with s_j = v_j + Σ gap/h:
//! a weighted isotonic regression by pooling adjacent violators (M. Ayer et al., Annals of Mathematical Statistics 26, 1955).

/// The part of an overlap that a step of sequential impulses takes back (Baumgarte's method with a usual factor).
const BAUMGARTE: f64 = 0.2;
/// Hz and 1: the stiffness and the damping of soft contacts, as in that paper.
const SOFT: (f64, f64) = (30.0, 10.0);
/// The stiffness of soft contacts in substeps a period, at most: stiffer ones ring.
const SOFTEST: f64 = 0.25;
/// m/s. The fastest way out of an overlap of soft contacts.
const OUTWARDS: f64 = 4.0;

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
    /// The same with soft contacts and a second sweep without.
    Soft(u32),
    /// Parts of a step that move bodies instead of pushing them (XPBD without compliance).
    Positions(u32),
    /// Pool adjacent violators.
    Direct,
}

impl Solver {
    pub const fn parts(self) -> u32 {
        if let Self::Substeps(parts) | Self::Soft(parts) | Self::Positions(parts) = self { parts } else { 1 }
    }
}

/// Of a soft contact: the part of an overlap taken back a second, of a rigid impulse given, and of the impulse so far forgotten. Rigid: Baumgarte's.
#[derive(Clone, Copy)]
struct Softness {
    rate: f64,
    mass: f64,
    forgets: f64,
    /// m/s. Below 0: the fastest way out.
    fastest: f64,
}

impl Softness {
    fn rigid(rate: f64) -> Self {
        Self { rate, mass: 1.0, forgets: 0.0, fastest: f64::NEG_INFINITY }
    }

    fn soft(h: f64) -> Self {
        let omega = std::f64::consts::TAU * SOFT.0.min(SOFTEST / h);
        let damped = 2.0 * SOFT.1 + h * omega;
        let stiff = h * omega * damped;
        Self { rate: omega / damped, mass: stiff / (1.0 + stiff), forgets: 1.0 / (1.0 + stiff), fastest: -OUTWARDS }
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
    /// Across the axis, from each body's first place, m; then the velocities, and the frictions of the contacts.
    pub across: Vec<f64>,
    /// m/s.
    pub slips: Vec<f64>,
    /// N·s.
    pub frictions: Vec<f64>,
    /// μ. 0: nothing moves across.
    pub friction: f64,
    /// Of all movable bodies across the axis, m/s².
    pub pull: f64,
}

impl Chain {
    /// Bodies of these masses (kg) at rest and touching; the first is immovable if `anchored`.
    pub fn new(masses: &[f64], anchored: bool) -> Self {
        let anchor = anchored.then_some(0.0);
        let inverse_masses: Vec<f64> = anchor.into_iter().chain(masses.iter().map(|mass| 1.0 / mass)).collect();
        let n = inverse_masses.len();
        let [bodies, contacts] = [n, n - 1].map(|length| vec![0.0; length]);
        Self {
            places: bodies.clone(),
            velocities: bodies.clone(),
            inverse_masses,
            impulses: contacts.clone(),
            across: bodies.clone(),
            slips: bodies,
            frictions: contacts,
            ..Self::default()
        }
    }

    /// One step under these accelerations (m/s², one a body).
    pub fn step(&mut self, accelerations: &[f64], solver: Solver, h: f64) {
        let h = h / f64::from(solver.parts());
        for _ in 0..solver.parts() {
            for (v, a) in self.velocities.iter_mut().zip(accelerations) {
                *v += a * h;
            }
            for (v, inverse) in self.slips.iter_mut().zip(&self.inverse_masses) {
                *v += if *inverse > 0.0 { self.pull * h } else { 0.0 };
            }
            match solver {
                Solver::Direct => self.solve_directly(h),
                Solver::Sweeps { sweeps, warm } => {
                    if warm {
                        self.warm_start();
                    } else {
                        self.impulses.fill(0.0);
                        self.frictions.fill(0.0);
                    }
                    (0..sweeps).for_each(|_| self.sweep(h));
                }
                Solver::Substeps(_) => {
                    self.warm_start();
                    self.sweep(h);
                }
                Solver::Soft(_) => {
                    self.warm_start();
                    self.sweep_with(h, Softness::soft(h));
                    self.advance(h);
                    self.sweep_with(h, Softness::rigid(0.0));
                    continue;
                }
                Solver::Positions(_) => {
                    self.project(h);
                    continue;
                }
            }
            self.advance(h);
        }
    }

    fn advance(&mut self, h: f64) {
        let along = self.places.iter_mut().zip(&self.velocities);
        along.chain(self.across.iter_mut().zip(&self.slips)).for_each(|(x, v)| *x += v * h);
    }

    fn warm_start(&mut self) {
        for contact in 0..self.impulses.len() {
            apply(&mut self.velocities, &self.inverse_masses, contact, self.impulses[contact]);
            apply(&mut self.slips, &self.inverse_masses, contact, self.frictions[contact]);
        }
    }

    fn mass(&self, contact: usize) -> f64 {
        1.0 / (self.inverse_masses[contact] + self.inverse_masses[contact + 1])
    }

    fn gap(&self, contact: usize) -> f64 {
        self.places[contact + 1] - self.places[contact]
    }

    /// One sweep of sequential impulses over all contacts.
    pub fn sweep(&mut self, h: f64) {
        self.sweep_with(h, Softness::rigid(BAUMGARTE / h));
    }

    fn sweep_with(&mut self, h: f64, Softness { rate, mass, forgets, fastest }: Softness) {
        for contact in 0..self.impulses.len() {
            let gap = self.gap(contact);
            // Bodies that are apart may come as near as they are.
            let (bias, mass, forgets) = if gap > 0.0 { (gap / h, 1.0, 0.0) } else { ((rate * gap).max(fastest), mass, forgets) };
            let approach = self.velocities[contact + 1] - self.velocities[contact] + bias;
            let known = self.impulses[contact];
            let impulse = (known - approach * mass * self.mass(contact) - known * forgets).max(0.0);
            self.impulses[contact] = impulse;
            apply(&mut self.velocities, &self.inverse_masses, contact, impulse - known);
            if self.friction > 0.0 {
                let (slip, known, most) =
                    (self.slips[contact + 1] - self.slips[contact], self.frictions[contact], self.friction * impulse);
                let held = (known - slip * self.mass(contact)).clamp(-most, most);
                self.frictions[contact] = held;
                apply(&mut self.slips, &self.inverse_masses, contact, held - known);
            }
        }
    }

    /// Moves all bodies, then those that overlap out of each other, and those that slip back as far as friction reaches.
    fn project(&mut self, h: f64) {
        let before = (self.places.clone(), self.across.clone());
        self.advance(h);
        for contact in 0..self.impulses.len() {
            let (mass, weights) = (self.mass(contact), [self.inverse_masses[contact], self.inverse_masses[contact + 1]]);
            let push = (-self.gap(contact) * mass).max(0.0);
            self.places[contact] -= push * weights[0];
            self.places[contact + 1] += push * weights[1];
            self.impulses[contact] = push / h;
            let moved = |body: usize| self.across[body] - before.1[body];
            let hold = ((moved(contact) - moved(contact + 1)) * mass).clamp(-self.friction * push, self.friction * push);
            self.across[contact] -= hold * weights[0];
            self.across[contact + 1] += hold * weights[1];
        }
        for (velocities, places, before) in
            [(&mut self.velocities, &self.places, before.0), (&mut self.slips, &self.across, before.1)]
        {
            velocities.iter_mut().zip(places).zip(before).for_each(|((v, x), before)| *v = (x - before) / h);
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

fn apply(velocities: &mut [f64], inverse_masses: &[f64], contact: usize, impulse: f64) {
    velocities[contact] -= impulse * inverse_masses[contact];
    velocities[contact + 1] += impulse * inverse_masses[contact + 1];
}

/// The worst relative impulse after each sweep from cold, of an anchored chain of these masses (kg) at rest; exact: the weight beyond it times h.
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

/// Sweeps from cold until every impulse of such a chain is within `part` of its exact value; `None` if `most` do not do.
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

    /// At rest a soft contact is sunk in by as much as its spring needs: r·d per second against the impulse that it forgets.
    #[test]
    fn a_soft_contact_rests_where_its_spring_bears_the_weight() {
        let (h, parts) = (1.0 / 60.0, 4);
        let mut chain = Chain::new(&[2.0], true);
        (0..600).for_each(|_| chain.step(&[0.0, -9.81], Solver::Soft(parts), h));
        let part = h / f64::from(parts);
        let Softness { rate, mass, forgets, .. } = Softness::soft(part);
        // The weight's impulse j is what is left of it: j = j − mass·(v + r·d)·m − forgets·j, with v = −g·part before.
        let sunk = 9.81 * part * forgets / (mass * rate);
        assert!((chain.places[1] / -sunk - 1.0).abs() < 1e-6, "{} for {sunk}", chain.places[1]);
        assert!((chain.impulses[0] / (2.0 * 9.81 * part) - 1.0).abs() < 1e-9);
    }

    /// Moved out, a body on the floor lies still and bears its weight; across, friction holds up to μ·λ and no further.
    #[test]
    fn positions_and_impulses_hold_up_to_the_limit_of_friction() {
        for solver in [Solver::Positions(10), Solver::Soft(10), Solver::Sweeps { sweeps: 10, warm: true }] {
            let run = |pull: f64| {
                let mut chain = Chain { friction: 0.5, pull, ..Chain::new(&[3.0], true) };
                (0..120).for_each(|_| chain.step(&[0.0, -10.0], solver, 1.0 / 60.0));
                chain
            };
            let (held, slides) = (run(4.9), run(7.0));
            assert!((held.impulses[0] * 60.0 * f64::from(solver.parts()) - 30.0).abs() < 0.2, "{solver:?}: {held:?}");
            assert!(held.across[1].abs() < 5e-3 && held.slips[1].abs() < 1e-9, "{solver:?}: {held:?}");
            // 2 m/s² are left of 7.
            assert!((slides.slips[1] / 4.0 - 1.0).abs() < 0.02, "{solver:?}: {slides:?}");
        }
    }
}
