//! Where methods are stable: each method's own step on the damped oscillator x″ = −|λ|²·x + 2·Re λ·x′, z = h·λ, whose matrix two starts give; it is
//! stable where no eigenvalue of that is greater than 1. For methods that treat places and velocities alike these are R(z) of y′ = λ·y; for others
//! there is none (E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, IV.2; *Geometric Numerical Integration*, I.1). Games meet two
//! rays: a swing at iω·h, and drag alone, v′ = −v/τ, at −h/τ, with one eigenvalue, asked by itself. Near v_t quadratic drag has 1/τ = 2·g/v_t.

pub use super::contract::SHIPPED;
use super::methods::motion::{ADAPTIVE, MotionLaw, MotionStep, PointState, third_order};
use super::{TICK, methods::METHODS, scenes::flight::LIGHT, scenes::oscillator};
use super::{curve::shortest, curve::table, stress::G, stress::largest_to};
use crate::{physics::DVec2, words::tr};
use std::collections::HashMap;

/// The window: real parts, and imaginary parts. The plane below the real axis mirrors it.
pub const REAL: (f64, f64) = (-5.0, 1.5);
pub const IMAGINARY: (f64, f64) = (0.0, 3.5);
/// Cells of the grid for 1.
const FINENESS: usize = 24;
/// Cells of the grid, to the right and upwards.
pub const CELLS: (usize, usize) =
    (((REAL.1 - REAL.0) * FINENESS as f64) as usize, ((IMAGINARY.1 - IMAGINARY.0) * FINENESS as f64) as usize);
/// A growth above 1 by less than this in a step is rounding: methods that keep an amplitude for ever lie just on 1.
const ROUNDING: f64 = 1e-9;
/// The end of the two rays.
pub const FAR: f64 = 100.0;
/// The search on the rays begins here: a method that fails at this value fails everywhere but at 0.
const NEAR: f64 = 0.02;
/// Relative precision of the limits.
const FINE: f64 = 1e-6;
/// The name of a part of the adaptive method's step.
pub const PART: &str = "adaptive 3(2), one part";

/// Real and imaginary part.
pub type Complex = (f64, f64);

#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    pub name: &'static str,
    /// Whether a factor of z alone says what a step does; else the region is that of the damped oscillator only.
    pub single: bool,
    /// In pieces.
    pub edge: Vec<Vec<Complex>>,
    /// In the middle of each cell, row by row from the real axis on.
    pub inside: Vec<bool>,
    /// The largest stable h/τ of drag alone, at most [`FAR`].
    pub drag: f64,
    /// The largest stable ω·h of a swing without drag, at most [`FAR`]; 0 where every swing grows.
    pub swing: f64,
}

/// Of all methods; of the adaptive one, the region of its parts: it takes enough of them to stay inside.
pub fn regions() -> Vec<Region> {
    let of = |(name, step)| if name == ADAPTIVE { Region::of(PART, third_order) } else { Region::of(name, step) };
    METHODS.into_iter().map(of).collect()
}

/// The largest factor of an oscillation in a step at z = h·λ.
pub fn growth(step: MotionStep, z: Complex) -> f64 {
    let [a, b, c, d] = matrix(step, z);
    let (half_trace, determinant) = (0.5 * (a + d), a * d - b * c);
    let under_root = half_trace * half_trace - determinant;
    if under_root < 0.0 { determinant.sqrt() } else { half_trace.abs() + under_root.sqrt() }
}

/// Whether the step's matrix is a function of the oscillator's own, (0, 1; −|λ|², 2·Re λ): p + q times that.
fn has_single_z(step: MotionStep) -> bool {
    let (re, im) = (-0.3, 0.7);
    let [a, b, c, d] = matrix(step, (re, im));
    let differs = |found: f64, wanted: f64| (found - wanted).abs() > ROUNDING;
    !differs(c, -b * (re * re + im * im)) && !differs(d, a + 2.0 * re * b)
}

/// Of place and velocity, row by row.
fn matrix(step: MotionStep, (re, im): Complex) -> [f64; 4] {
    let law = MotionLaw { viscous: -2.0 * re, spring: re * re + im * im, ..MotionLaw::default() };
    let taken = |x: f64, v: f64| {
        let end = step(&law, PointState { x: DVec2::new(x, 0.0), v: DVec2::new(v, 0.0) }, 1.0);
        (end.x.x, end.v.x)
    };
    let ((a, c), (b, d)) = (taken(1.0, 0.0), taken(0.0, 1.0));
    [a, b, c, d]
}

/// The factor of a velocity in a step of drag alone, at h/τ = `part`.
pub fn growth_of_drag(step: MotionStep, part: f64) -> f64 {
    let law = MotionLaw { viscous: part, ..MotionLaw::default() };
    step(&law, PointState { x: DVec2::ZERO, v: DVec2::new(1.0, 0.0) }, 1.0).v.x.abs()
}

impl Region {
    fn of(name: &'static str, step: MotionStep) -> Self {
        let holds = |growth: f64| growth <= 1.0 + ROUNDING;
        let middle = |i: usize| place((i % CELLS.0) as f64 + 0.5, (i / CELLS.0) as f64 + 0.5);
        Self {
            name,
            single: has_single_z(step),
            edge: edge(|z| growth(step, z) - 1.0 - ROUNDING),
            inside: (0..CELLS.0 * CELLS.1).map(|i| holds(growth(step, middle(i)))).collect(),
            drag: largest_to(FINE, (NEAR, FAR), |part| holds(growth_of_drag(step, part))),
            swing: largest_to(FINE, (NEAR, FAR), |turn| holds(growth(step, (0.0, turn)))),
        }
    }

    /// Its limits on the two rays, where they are in the window.
    pub fn marks(&self) -> impl Iterator<Item = Complex> {
        let seen = |&(re, im): &Complex| re >= REAL.0 && im <= IMAGINARY.1;
        [(-self.drag, 0.0), (0.0, self.swing)].into_iter().filter(seen)
    }
}

/// A region without limits on the rays.
pub const SHIPPED_LIMITS: [f64; 2] = [FAR; 2];

/// Two motions of the lab's scenes at 1/60 s, each on its ray.
pub fn examples() -> [(&'static str, Complex); 2] {
    let fading = 2.0 * G / LIGHT * TICK;
    [("the floating box, h = 1/60 s", (0.0, oscillator::omega() * TICK)), ("a fall at v_t = 0.18 m/s, h = 1/60 s", (-fading, 0.0))]
}

/// For people.
pub fn limit(value: f64) -> String {
    match value {
        0.0 => tr("none").to_owned(),
        FAR.. => tr("any").to_owned(),
        _ => format!("{value:.2}"),
    }
}

/// The place that is `right` and `up` cells from the corner.
pub fn place(right: f64, up: f64) -> Complex {
    (REAL.0 + right / FINENESS as f64, IMAGINARY.0 + up / FINENESS as f64)
}

/// A side of a cell: the corner where it begins, and whether it leads upwards.
type CellSide = (usize, usize, bool);

/// The lines where a function is 0: between the corners of each cell that differ in its sign, joined to lines ("marching squares").
fn edge(f: impl Fn(Complex) -> f64) -> Vec<Vec<Complex>> {
    let (columns, rows) = CELLS;
    // A growth that is not finite counts as growth.
    let value = |i: usize, j: usize| f(place(i as f64, j as f64)).min(f64::MAX);
    let values: Vec<f64> = (0..(columns + 1) * (rows + 1)).map(|k| value(k % (columns + 1), k / (columns + 1))).collect();
    let at = |i: usize, j: usize| values[j * (columns + 1) + i];
    let crossing = |(i, j, upwards): CellSide| {
        let (from, to) = (at(i, j), if upwards { at(i, j + 1) } else { at(i + 1, j) });
        let part = (from / (from - to)).clamp(0.0, 1.0);
        if upwards { place(i as f64, j as f64 + part) } else { place(i as f64 + part, j as f64) }
    };
    let mut ways: HashMap<CellSide, Vec<CellSide>> = HashMap::new();
    let mut met: Vec<CellSide> = Vec::new();
    for k in 0..columns * rows {
        let (i, j) = (k % columns, k / columns);
        let sides = [((i, j, false), (i, j), (i + 1, j)), ((i + 1, j, true), (i + 1, j), (i + 1, j + 1))];
        let others = [((i, j + 1, false), (i, j + 1), (i + 1, j + 1)), ((i, j, true), (i, j), (i, j + 1))];
        let crosses = |(_, a, b): &(CellSide, (usize, usize), (usize, usize))| (at(a.0, a.1) <= 0.0) != (at(b.0, b.1) <= 0.0);
        let crossed: Vec<CellSide> = sides.into_iter().chain(others).filter(crosses).map(|(side, ..)| side).collect();
        for pair in crossed.chunks_exact(2) {
            ways.entry(pair[0]).or_default().push(pair[1]);
            ways.entry(pair[1]).or_default().push(pair[0]);
            met.extend(pair);
        }
    }
    // Open lines first, from one of their ends; then closed ones.
    met.sort_by_key(|side| (ways.get(side).map_or(0, Vec::len), *side));
    let mut lines = Vec::new();
    for start in met {
        let mut line = vec![crossing(start)];
        let mut side = start;
        while let Some(next) = ways.get_mut(&side).and_then(Vec::pop) {
            if let Some(back) = ways.get_mut(&next) {
                back.retain(|other| *other != side);
            }
            line.push(crossing(next));
            side = next;
        }
        if line.len() > 1 {
            lines.push(line);
        }
    }
    lines
}

pub const SVG: &str = "stability.svg";
pub const TITLE: &str = "Where methods are stable: the plane of z = h·λ";

/// Two files: the edges, point by point, and the limits on the two rays.
pub fn csv(regions: &[Region]) -> [(&'static str, String); 2] {
    let points = regions.iter().flat_map(|region| {
        region.edge.iter().enumerate().flat_map(move |(piece, line)| {
            line.iter().map(move |(re, im)| vec![region.name.to_owned(), piece.to_string(), shortest(*re), shortest(*im)])
        })
    });
    let limits = regions.iter().map(|region| vec![region.name.to_owned(), shortest(region.drag), shortest(region.swing)]);
    [
        ("stability.csv", table(&["method", "piece", "re", "im"], points)),
        ("stability-limits.csv", table(&["method", "drag_alone", "swing"], limits)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::methods::motion::{explicit_euler, rk4, semi_implicit_euler, velocity_verlet};

    fn region(name: &str) -> Region {
        regions().into_iter().find(|region| region.name == name).unwrap()
    }

    /// |R(z)| with R the exponential series up to a power.
    fn of_series(order: u32, (re, im): Complex) -> f64 {
        let (mut sum, mut term) = ((1.0, 0.0), (1.0, 0.0));
        for k in 1..=order {
            let by = f64::from(k);
            term = ((term.0 * re - term.1 * im) / by, (term.0 * im + term.1 * re) / by);
            sum = (sum.0 + term.0, sum.1 + term.1);
        }
        f64::hypot(sum.0, sum.1)
    }

    #[test]
    fn methods_that_treat_all_alike_have_the_polynomial_of_the_textbook() {
        let orders = [("explicit Euler", 1), ("midpoint", 2), ("Heun", 2), (PART, 3), ("RK4", 4)];
        for (name, order) in orders {
            let (_, step) = METHODS.into_iter().find(|(other, _)| *other == name).unwrap_or(("", third_order));
            for z in [(-1.0, 0.5), (-2.5, 1.5), (0.3, 2.0), (-0.1, 2.8), (-4.0, 0.0)] {
                let (found, exact) = (growth(step, z), of_series(order, z));
                assert!((found / exact - 1.0).abs() < 1e-7, "{name} at {z:?}: {found}, {exact}");
            }
            // All of the edge, which is interpolated between corners, lies on |R| = 1.
            for z in region(name).edge.concat() {
                assert!((of_series(order, z) - 1.0).abs() < 0.02, "{name} at {z:?}: {}", of_series(order, z));
            }
        }
    }

    #[test]
    fn the_limits_on_both_rays_are_those_of_the_textbook() {
        for (name, drag, swing) in [
            ("explicit Euler", 2.0, 0.0),
            ("semi-implicit Euler", 2.0, 2.0),
            ("velocity Verlet", 2.0, 2.0),
            ("midpoint", 2.0, 0.0),
            ("Heun", 2.0, 0.0),
            (PART, 2.512_745_33, 3f64.sqrt()),
            ("RK4", 2.785_293_56, 8f64.sqrt()),
            ("Yoshida 4", FAR, 1.573_401_94),
            ("implicit Euler", FAR, FAR),
            ("implicit midpoint", FAR, FAR),
            ("trapezoid", FAR, FAR),
            ("linearised drag", FAR, 2.0),
            ("exact drag (Lie)", FAR, 2.0),
            ("Strang", FAR, 2.0),
        ] {
            let found = region(name);
            let near = |found: f64, exact: f64| (found - exact).abs() <= 2e-6 * exact;
            assert!(near(found.drag, drag) && near(found.swing, swing), "{name}: {} {}", found.drag, found.swing);
        }
    }

    #[test]
    fn splittings_and_their_kin_have_no_single_z() {
        let without: Vec<&str> = regions().iter().filter(|region| !region.single).map(|region| region.name).collect();
        assert_eq!(
            without,
            ["semi-implicit Euler", "velocity Verlet", "Yoshida 4", "linearised drag", "exact drag (Lie)", "Strang"]
        );
    }

    #[test]
    fn what_lies_inside_fades_and_what_lies_outside_grows() {
        for (step, inside, outside) in [
            (explicit_euler as MotionStep, (-1.0, 0.9), (-1.0, 1.1)),
            (rk4, (-1.5, 2.0), (-2.0, 2.5)),
            (semi_implicit_euler, (-0.3, 1.0), (-0.9, 0.0)),
            (velocity_verlet, (-0.3, 1.0), (0.1, 1.0)),
        ] {
            for (z, fades) in [(inside, true), (outside, false)] {
                let law = MotionLaw { viscous: -2.0 * z.0, spring: z.0 * z.0 + z.1 * z.1, ..MotionLaw::default() };
                let mut point = PointState { x: DVec2::new(1.0, 0.0), v: DVec2::new(0.3, 0.0) };
                (0..400).for_each(|_| point = step(&law, point, 1.0));
                assert_eq!(point.x.length() < 1e-3, fades, "{z:?}: {point:?}");
                assert_eq!(growth(step, z) < 1.0, fades);
            }
        }
    }

    #[test]
    fn an_edge_is_found_whole() {
        // A circle in the middle, and an arc that the window cuts off.
        let circle = edge(|(re, im)| f64::hypot(re + 2.0, im - 1.75) - 1.0);
        assert_eq!(circle.len(), 1);
        assert!(circle[0].first() == circle[0].last() && circle[0].len() > 100);
        let arc = edge(|(re, im)| f64::hypot(re + 2.0, im) - 1.0);
        assert!(arc.len() == 1 && arc[0].iter().all(|(re, im)| (f64::hypot(re + 2.0, *im) - 1.0).abs() < 0.01));
        assert!(edge(|_| 1.0).is_empty() && edge(|_| f64::NAN).is_empty());
    }

    #[test]
    fn the_files_name_every_method_and_hold_every_edge() {
        let regions = regions();
        let [(_, edges), (_, limits)] = csv(&regions);
        for region in &regions {
            assert!(limits.contains(&format!("\n{},", quoted(region.name))), "{}", region.name);
            let points = edges.lines().filter(|line| line.starts_with(&format!("{},", quoted(region.name)))).count();
            assert_eq!(points, region.edge.iter().map(Vec::len).sum::<usize>());
            assert!(points > 50, "{}", region.name);
        }
    }

    fn quoted(name: &str) -> String {
        if name.contains(',') { format!("\"{name}\"") } else { name.to_owned() }
    }
}
