//! m·Δv = ∫F dt + impulses.

use super::flown::{Acting, Flown, Row, bounces, collisions, pushed_row, recorded, splash, stack};
use resultant::physics::{Aabb, ForceKind};

/// The forces at the start of a tick and at its end, if they are the same. The engine, which is switched at the start, and forces that
/// vary within a tick do not count.
fn same_laws<'a>(flown: &'a Flown, tick: usize, object: usize, alike: impl Fn(&Acting, &Acting) -> bool + 'a) -> bool {
    let all = |tick: usize| flown.forces(tick, object).filter(|acting| acting.kind != "drive");
    all(tick - 1).count() == all(tick).count() && all(tick - 1).zip(all(tick)).all(|(a, b)| alike(a, b))
}

/// In free flight also where impacts fall into the tick.
#[test]
fn constant_forces_and_impacts_change_the_momentum_by_just_what_they_say() {
    for (name, flown, least) in
        [("row", pushed_row(), 0.9), ("stack", stack(), 0.95), ("collisions", collisions(), 0.99), ("bounces", bounces(), 0.9)]
    {
        let (mut held, mut with_impacts, mut all) = (0, 0, 0);
        for (tick, object) in flown.all().filter(|(tick, _)| *tick > 0) {
            all += 1;
            let (before, after) = (&flown.rows[tick - 1][object], &flown.rows[tick][object]);
            let close = |a: &Acting, b: &Acting| {
                a.kind == b.kind && a.by == b.by && (a.vector - b.vector).length() <= 1e-12 * a.vector.length()
            };
            let in_contact = flown.forces(tick, object).any(|acting| matches!(&*acting.kind, "reaction" | "push"));
            let hit = flown.impacts(tick, object).next().is_some();
            if !same_laws(&flown, tick, object, close) || (hit && in_contact) {
                continue;
            }
            held += 1;
            with_impacts += usize::from(hit);
            let mass = flown.body(object).mass;
            let gained = (after.velocity - before.velocity) * mass;
            let given = after.resultant * flown.dt + after.impulse;
            let size = mass * before.velocity.length().max(after.velocity.length())
                + flown.forces(tick, object).map(|acting| acting.vector.length()).sum::<f64>() * flown.dt;
            let error = (gained - given).length() / size.max(f64::MIN_POSITIVE);
            assert!(error <= 1e-9, "{name}, tick {tick}, object {object}: m·Δv = {gained}, F·Δt + J = {given}");
        }
        assert!(held as f64 >= least * all as f64, "{name}: only {held} of {all} ticks");
        assert!(with_impacts > 0 || !matches!(name, "collisions" | "bounces"));
    }
}

/// For each liquid, whether the object is out of it, in part or all inside: where that changes its forces have a corner, as they have where
/// a velocity changes its sign.
fn wet(flown: &Flown, object: usize, row: &Row) -> Vec<(bool, bool)> {
    let (half, position) = (flown.body(object).half, row.position);
    let gap = |zone: &Aabb| (position - zone.centre()).abs() - zone.size() * 0.5;
    let wet = |zone: &Aabb| ((gap(zone) - half).max_element() < 0.0, (gap(zone) + half).max_element() < 0.0);
    flown.level.fluids.iter().map(|fluid| wet(&fluid.zone)).collect()
}

/// m·Δv = ∫F dt + impulses over pairs of ticks whose forces are of the same kinds: Simpson's rule is closer to it than the trapezium, whose
/// distance from Simpson's is the bound; and over all that the error of Simpson's rule is small.
#[test]
fn drag_and_buoyancy_change_the_momentum_by_their_integral() {
    for (name, flown, bound) in [
        ("splash", splash("480"), 5e-4),
        ("level 1", recorded("1"), 1e-6),
        ("level 2", recorded("2"), 1e-6),
        ("level 3", recorded("3"), 1e-3),
    ] {
        let (mut held, mut all, mut worst) = (0, 0, 0.0_f64);
        for (tick, object) in flown.all().filter(|(tick, _)| *tick > 1) {
            all += 1;
            let [first, middle, last] = [2, 1, 0].map(|back| &flown.rows[tick - back][object]);
            let contact = |acting: &Acting| matches!(&*acting.kind, "reaction" | "friction" | "push" | "impact" | "ended_contact");
            let named = |a: &Acting, b: &Acting| a.kind == b.kind && a.by == b.by;
            let touched = [2, 1, 0].iter().any(|back| flown.acting[tick - back][object].iter().any(contact));
            let drive = ForceKind::Drive;
            if touched
                || (first.velocity * last.velocity).min_element() < 0.0
                || wet(&flown, object, first) != wet(&flown, object, middle)
                || wet(&flown, object, middle) != wet(&flown, object, last)
                || !same_laws(&flown, tick - 1, object, named)
                || !same_laws(&flown, tick, object, named)
                || middle.total(drive) != last.total(drive)
            {
                continue;
            }
            held += 1;
            let mass = flown.body(object).mass;
            // The engine was switched at the first row, and burns from there on.
            let start = first.resultant - first.total(drive) + middle.total(drive);
            let (dt, gained) = (flown.dt, (last.velocity - first.velocity) * mass);
            let simpson = (start + middle.resultant * 4.0 + last.resultant) * (dt / 3.0);
            let trapezium = (start + middle.resultant * 2.0 + last.resultant) * (dt / 2.0);
            let size = mass * last.velocity.length() + flown.forces(tick, object).map(|a| a.vector.length()).sum::<f64>() * dt;
            let error = (gained - simpson).length();
            worst = worst.max(error / size);
            let most = (simpson - trapezium).length() + 1e-9 * size;
            assert!(error <= most, "{name}, tick {tick}, object {object}: m·Δv = {gained}, {simpson}, {trapezium}");
        }
        assert!(held > 400 && worst <= bound, "{name}: {held} of {all} ticks, at worst {worst:e}");
    }
}
