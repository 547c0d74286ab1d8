//! The findings of a run in writing: a page with all tables and diagrams, and the cheapest method of each scene.

use super::charts::Charts;
use super::curve::{ALIKE, EXACT, Measured, MethodCurve, WorkPoint};
use super::figures::measured;
use super::rows::{shortest, table};
use super::savings::{self, Saving, TITLE as SAVINGS};
use super::stability::{Region, SHIPPED, SHIPPED_LIMITS, SVG, TITLE, limit};
use crate::draw::chart::look::CurveOrigin;
use crate::number::{short, step};
use std::fmt::Write;

/// The shipped engine's cost in a scene, beside the cheapest there.
struct SceneVerdict<'a> {
    measured: &'a Measured,
    shipped: WorkPoint,
    /// The shipped engine at the step at which it is the cheapest within the tolerance.
    stretched: Option<WorkPoint>,
    cheapest: Option<(&'a MethodCurve, WorkPoint)>,
    as_exact: Option<(&'a MethodCurve, WorkPoint)>,
}

impl<'a> SceneVerdict<'a> {
    fn of(measured: &'a Measured) -> Option<Self> {
        let shipped = measured.shipped_point()?;
        let (curve, _) = measured.shipped()?;
        let within = curve.points.iter().copied().filter(|point| measured.alike && point.error <= measured.tolerance);
        let stretched = within.min_by(|a, b| a.work.total_cmp(&b.work));
        Some(Self { measured, shipped, stretched, cheapest: measured.cheapest(), as_exact: measured.cheapest_as_exact() })
    }

    fn ratio(&self, other: WorkPoint) -> f64 {
        self.shipped.work / other.work
    }
}

/// The cheapest method of each scene, and how much more the shipped one costs.
pub fn shipped_csv(diagrams: &[Measured]) -> String {
    let head = [
        ["scene", "shipped_step", "shipped_error", "shipped_work", "shipped_cheapest_step", "shipped_cheapest_work"].as_slice(),
        &["cheapest", "step", "error", "work", "shipped_costs_times"],
        &["as_exact", "as_exact_step", "as_exact_error", "as_exact_work", "shipped_costs_times_as_exact"],
    ];
    let rows = diagrams.iter().filter_map(SceneVerdict::of).map(|verdict| {
        let WorkPoint { step, work, error, .. } = verdict.shipped;
        let best = |best: Option<(&MethodCurve, WorkPoint)>| match best {
            None => vec![String::new(); 5],
            Some((curve, point)) => {
                let numbers = [point.step, point.error, point.work, verdict.ratio(point)].map(shortest);
                std::iter::once(curve.name.clone()).chain(numbers).collect()
            }
        };
        let stretched = verdict.stretched.map_or([String::new(), String::new()], |point| [point.step, point.work].map(shortest));
        let ours = [[verdict.measured.name.clone(), shortest(step)], [shortest(error), shortest(work)], stretched].concat();
        [ours, best(verdict.cheapest), best(verdict.as_exact)].concat()
    });
    table(&head.concat(), rows)
}

pub fn summary(charts: &Charts, regions: &[Region]) -> String {
    let Charts { diagrams, stress, savings, .. } = charts;
    // Writing to a string never fails.
    let mut text = format!("# Accuracy against speed\n\n{}\n\n", measured(charts));
    text.push_str(
        "Each point is a method at a step: CPU time of its thread to the right, error upwards, so lower left is better. The dotted \
         green line is an error that nobody sees. Methods that lose are shown too.\n\n",
    );
    verdicts(&mut text, diagrams);
    if let Some(measured) = diagrams.iter().find(|measured| measured.name == PI) {
        pi_table(&mut text, measured);
    }
    stability_table(&mut text, regions);
    text.push_str(
        "\n## What each method survives\n\nThe largest value that a method survives; 0: none, ≥: nothing larger was tried.\n\n",
    );
    text.push_str("| test | parameter | method | largest |\n|---|---|---|---|\n");
    for row in stress {
        let largest = row.shown();
        let (method, largest) =
            if row.shipped { (format!("**{}**", row.method), format!("**{largest}**")) } else { (row.method.clone(), largest) };
        let _ = writeln!(text, "| {} | {} | {method} | {largest} |", row.test, row.parameter);
    }
    savings_table(&mut text, savings);
    text.push_str("\n## Diagrams\n");
    for measured in diagrams {
        let name = &measured.name;
        let _ = writeln!(text, "\n<a id=\"{name}\"></a>\n![{}]({name}.svg)\n\n[numbers]({name}.csv)", measured.title);
        if measured.over_time.is_some() {
            let _ = writeln!(text, "\n![{}, over time]({name}-over-time.svg)\n\n[numbers]({name}-over-time.csv)", measured.title);
        }
    }
    text
}

fn stability_table(text: &mut String, regions: &[Region]) {
    let _ = writeln!(text, "\n## {TITLE}\n\n![{TITLE}]({SVG})\n");
    text.push_str("| method | drag alone, stable up to h/τ | a swing, stable up to ω·h |\n|---|---|---|\n");
    for region in regions {
        let _ = writeln!(text, "| {} | {} | {} |", region.name, limit(region.drag), limit(region.swing));
    }
    let [drag, swing] = SHIPPED_LIMITS.map(limit);
    let _ = writeln!(text, "| **{SHIPPED}** | **{drag}** | **{swing}** |");
}

fn savings_table(text: &mut String, savings: &[Saving]) {
    let _ = writeln!(text, "\n## {SAVINGS}\n\n![{SAVINGS}](savings.svg)\n\n{}\n", savings::sentence(savings).unwrap_or_default());
    text.push_str(
        "| of | name | runs | left out | ns a tick | with every part | times | same bits |\n|---|---|---|---|---|---|---|---|\n",
    );
    for row in savings {
        let Saving { of, scene, parts, left_out, planned, everything, same_bits, .. } = row;
        let (own, all, times) = (short(planned.0), short(everything.0), short(row.times()));
        let _ = writeln!(
            text,
            "| {of} | {scene} | {parts} | {left_out} | {own} | {all} | × {times} | {} |",
            if *same_bits { "yes" } else { "**no**" }
        );
    }
}

fn verdicts(text: &mut String, diagrams: &[Measured]) {
    text.push_str("## What the shipped engine costs, and what is cheapest\n\n");
    let all: Vec<SceneVerdict<'_>> = diagrams.iter().filter_map(SceneVerdict::of).collect();
    // Scenes in which only engines take part say nothing about loops by hand.
    let has_loop = |measured: &Measured| measured.curves.iter().any(|curve| curve.origin == CurveOrigin::Lab);
    let alike = || all.iter().filter(|verdict| verdict.measured.alike && has_loop(verdict.measured));
    let by_hand = |best: &Option<(&MethodCurve, WorkPoint)>| best.is_some_and(|(curve, _)| curve.origin == CurveOrigin::Lab);
    let (scenes, loses) = (alike().count(), alike().filter(|verdict| by_hand(&verdict.cheapest)).count());
    let still = alike().filter(|verdict| by_hand(&verdict.as_exact)).count();
    let _ = writeln!(
        text,
        "In {loses} of {scenes} scenes a bare loop by hand is the cheapest within the tolerance, and in {still} one that is as exact \
         as the shipped engine is cheaper than it: as exact is an error of at most {ALIKE} times its own, and below {EXACT:e} all count \
         as exact. Such a loop solves that one scene and knows the form of its answer. The shipped \
         engine is a general world, the same in all scenes: it looks for contacts, keeps every force by name, and ticks at the \
         game's own rate whatever the scene would bear.\n"
    );
    text.push_str(
        "| scene | shipped: error | ns | at its cheapest step, ns | cheapest within the tolerance | error | ns | shipped costs | ",
    );
    text.push_str("cheapest as exact as shipped | ns | shipped costs |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for verdict in &all {
        let Measured { title, name, .. } = verdict.measured;
        let (error, work) = (short(verdict.shipped.error), short(verdict.shipped.work));
        let stretched =
            verdict.stretched.map_or("–".to_owned(), |point| format!("{} at {}", short(point.work), step(point.step)));
        let named = |(curve, point): (&MethodCurve, WorkPoint)| format!("{} at {}", curve.name, curve.setting(point));
        let none = if verdict.measured.alike { "none" } else { "–" };
        let cheapest = verdict.cheapest.map_or(format!("{none} | – | – | –"), |best| {
            let (error, work) = (short(best.1.error), short(best.1.work));
            format!("{} | {error} | {work} | × {}", named(best), short(verdict.ratio(best.1)))
        });
        let as_exact = verdict.as_exact.map_or("– | – | –".to_owned(), |best| {
            format!("{} | {} | × {}", named(best), short(best.1.work), short(verdict.ratio(best.1)))
        });
        let _ = writeln!(text, "| [{title}](#{name}) | {error} | {work} | {stretched} | {cheapest} | {as_exact} |");
    }
}

pub const PI: &str = "pi";

/// The largest N that each step counts right, and its cost.
fn pi_table(text: &mut String, measured: &Measured) {
    text.push_str("\n## π from collisions in time steps\n\n| step | right up to N | its CPU time, ns |\n|---|---|---|\n");
    let by_hand: Vec<&MethodCurve> = measured.curves.iter().filter(|curve| curve.origin == CurveOrigin::Lab).collect();
    let steps = by_hand.first().map_or(0, |curve| curve.points.len());
    for index in 0..steps {
        let mut points = by_hand.iter().map_while(|curve| curve.points.get(index));
        let Some(step) = points.clone().next().map(|point| step(point.step)) else { break };
        let last_right = points.by_ref().take_while(|point| point.error == 0.0).enumerate().last();
        let _ = match last_right {
            Some((n, point)) => writeln!(text, "| {step} | {n} | {} |", short(point.work)),
            None => writeln!(text, "| {step} | none | – |"),
        };
    }
    if let Some((curve, Some(point))) = measured.shipped().map(|(curve, mut points)| (curve, points.next())) {
        let _ = writeln!(text, "| {}: at any | all | {} |", curve.name, short(point.work));
    }
}
