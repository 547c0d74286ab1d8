//! A run in writing: a page with all tables and diagrams, the cheapest method of each scene, and what other pages say of what was measured:
//! texts between marks, as in `<!-- chart:savings -->…<!-- end -->`. `resultant chart` writes them; a test compares them with the charts.

use super::curve::{ALIKE, EXACT, GROWTH, Measured, MethodCurve, PI, WorkPoint, shortest, table};
use super::savings::{self, Saving, TITLE as SAVINGS};
use super::stability::{Region, SHIPPED, SHIPPED_LIMITS, SVG, TITLE, limit};
use super::{charts::Charts, kept::PeerRow};
use crate::{draw::chart::CurveOrigin, number::short, number::step};
use std::{collections::BTreeSet, fmt::Write};

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
        let shipped = measured.shipped_point().filter(|_| measured.name != GROWTH)?;
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

/// The pages with marks, below the project's folder.
pub const PAGES: [&str; 3] = ["docs/accuracy.md", "docs/physics.md", "benches/peers/README.md"];

const BEGIN: &str = "<!-- chart:";
const END: &str = "<!-- end -->";

/// s. The step of the table of engines, and the finest of theirs.
const USUAL: f64 = 1.0 / 60.0;
const FINE: f64 = 1.0 / 480.0;

#[derive(Clone, Copy, Debug)]
pub struct PageFigures<'a> {
    pub charts: &'a Charts,
    pub peers: &'a [PeerRow],
}

impl PageFigures<'_> {
    /// The page with the present texts between its marks. Errors: a mark without an end, or of something that was not measured.
    pub fn fill(&self, page: &str) -> Result<String, String> {
        let mut parts = page.split(BEGIN);
        let mut text = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let marked = part.split_once(" -->").and_then(|(name, rest)| Some((name, rest.split_once(END)?.1)));
            let (name, rest) = marked.ok_or_else(|| format!("{BEGIN}{part:.20}: found no end of the mark, expected {END}"))?;
            let words = self.text(name).ok_or_else(|| format!("{BEGIN}{name}: found no such figure in the charts"))?;
            text.extend([BEGIN, name, " -->", &words, END, rest]);
        }
        Ok(text)
    }

    fn text(&self, name: &str) -> Option<String> {
        match name {
            "measured" => Some(measured(self.charts)),
            "savings" => savings::sentence(&self.charts.savings),
            "throw" => self.throw(),
            "overlap" => self.overlap(),
            "general" => self.general(),
            "column" => self.column(),
            "water" => self.water(),
            "peers" => self.table(),
            _ => None,
        }
    }

    fn diagram(&self, name: &str) -> Option<&Measured> {
        self.charts.diagrams.iter().find(|measured| measured.name == name)
    }

    fn throw(&self) -> Option<String> {
        let measured = self.diagram("projectile")?;
        let first = measured.curves.iter().filter(|curve| curve.order().is_some_and(|order| order < 1.5)).collect::<Vec<_>>();
        let finest = first.iter().flat_map(|curve| &curve.points).map(|point| point.step).reduce(f64::min)?;
        let within = |curve: &&&MethodCurve| curve.points.iter().any(|point| point.error <= measured.tolerance);
        let times = measured.tolerance / measured.shipped_point()?.error;
        Some(format!(
            "{} of {} methods of first order reach the error that nobody sees down to a step of {}; that of the shipped engine is {} \
             times smaller at {}",
            first.iter().filter(within).count(),
            first.len(),
            step(finest),
            short(times),
            step(measured.shipped_step)
        ))
    }

    fn overlap(&self) -> Option<String> {
        let piles =
            self.peers.iter().filter(|row| ["pile-", "masses-", "restitutions-"].iter().any(|of| row.scene.starts_with(of)));
        let deepest = |ours: bool| piles.clone().filter(move |row| row.ours() == ours).map(|row| row.overlap);
        let (least, most) = (deepest(false).reduce(f64::min)?, deepest(false).reduce(f64::max)?);
        let ours = short(deepest(true).reduce(f64::max)?);
        Some(format!(
            "its boxes overlap by at most {ours} m after any step, those of the others by {} to {} m",
            short(least),
            short(most)
        ))
    }

    /// A scene's cost at the game's tick beside the cheapest loop that is as exact.
    fn general(&self) -> Option<String> {
        let beside = |scene: &str| {
            let measured = self.diagram(scene)?;
            let (shipped, (curve, loop_of_one)) = (measured.shipped_point()?, measured.cheapest_as_exact()?);
            let (times, each) = (short(shipped.work / loop_of_one.work), short(shipped.work * shipped.step));
            Some(format!("{each} ns a step, {times} times as long as “{}” at {}", curve.name, step(loop_of_one.step)))
        };
        Some(format!("a fall without drag takes {}; a box in a thick liquid {}", beside("fall")?, beside("liquid")?))
    }

    /// The rows of a scene at a step: those of the usual settings, or the stiff ones.
    fn rows(&self, scene: &str, at: f64, stiff: bool) -> impl Iterator<Item = &PeerRow> {
        let rows = self.peers.iter().filter(move |row| row.scene == scene && (row.point.step / at - 1.0).abs() < 1e-6);
        rows.filter(move |row| !row.ours() && row.settings.starts_with("32 ") == stiff)
    }

    fn ours(&self, scene: &str, at: f64) -> Option<WorkPoint> {
        let row = |row: &&PeerRow| row.ours() && row.scene == scene && (row.point.step / at - 1.0).abs() < 1e-6;
        self.peers.iter().find(row).map(|row| row.point)
    }

    fn column(&self) -> Option<String> {
        let sunk = |at, stiff| self.rows("column", at, stiff).map(|row| 1e3 * row.point.error).reduce(f64::max).map(short);
        let stiff = self.rows("column", USUAL, true).map(|row| row.point.work).reduce(f64::min)?;
        // A quick run has no fine steps.
        let fine = sunk(FINE, false).map_or_else(String::new, |fine| format!(" and {fine} mm at 480"));
        Some(format!(
            "a column of 20 sinks by up to {} mm at 60 steps a second{fine}, and by {} mm with the stiff settings, which take {} times \
             Resultant's time or more",
            sunk(USUAL, false)?,
            sunk(USUAL, true)?,
            short(stiff / self.ours("column", USUAL)?.work)
        ))
    }

    fn water(&self) -> Option<String> {
        let off = self.rows("afloat-64", USUAL, false).map(|row| row.point.error).reduce(f64::min)?;
        let ours = self.ours("afloat-64", USUAL)?.error;
        Some(format!(
            "leaves crates {} mm or more off their depth after 20 s; Resultant's are {} mm off",
            short(1e3 * off),
            short(1e3 * ours)
        ))
    }

    fn table(&self) -> Option<String> {
        let mut text = "\n\n| scene | Resultant, ns | spread | the fastest other takes | its error | Resultant's |\n|---|---|---|---|---|---|\n".to_owned();
        let mut scenes: Vec<&str> = self.peers.iter().map(|row| row.scene.as_str()).collect();
        scenes.dedup();
        for scene in scenes {
            let ours = self.ours(scene, USUAL)?;
            let peer = self.rows(scene, USUAL, false).min_by(|a, b| a.point.work.total_cmp(&b.point.work))?;
            let times = peer.point.work / ours.work;
            let (mark, percent) = (if times < 1.0 { "**" } else { "" }, (100.0 * ours.spread).round());
            let (each, theirs, own) = (short(ours.work * ours.step), short(peer.point.error), short(ours.error));
            let _ = writeln!(
                text,
                "| `{scene}` | {each} | {percent} % | {mark}× {}{mark} {} | {theirs} | {own} |",
                short(times),
                peer.engine
            );
        }
        Some(text)
    }
}

/// With what the charts were measured, and whether that is this build.
pub fn measured(charts: &Charts) -> String {
    let setting = &charts.setting;
    let ours = charts.diagrams.iter().flat_map(|measured| &measured.curves).filter(|curve| curve.origin != CurveOrigin::Peer);
    let versions: BTreeSet<&str> = ours.map(|curve| curve.version.as_str()).collect();
    let versions = versions.into_iter().map(|version| format!("`{version}`")).collect::<Vec<_>>().join(", ");
    let runs = if setting.quick { "few runs a point (`--quick`)" } else { "medians of several runs" };
    let names = charts.stale();
    let some = if names.len() > charts.diagrams.len() { String::new() } else { format!(": {}", names.join(", ")) };
    let stale = if names.is_empty() { String::new() } else { format!(" **Measured with another build than this one{some}.**") };
    format!("Measured on {}, {} build, {runs}; sources of the engine: {versions}.{stale}", setting.machine, setting.profile)
}
