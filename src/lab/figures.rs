//! What the pages say of what was measured: texts between marks, as in `<!-- chart:savings -->…<!-- end -->`. `resultant chart` writes
//! them; a test compares them with the charts.

use super::charts::Charts;
use super::curve::{Measured, MethodCurve, WorkPoint};
use super::kept::PeerRow;
use super::savings;
use crate::draw::chart::look::CurveOrigin;
use crate::number::{short, step};
use std::collections::BTreeSet;
use std::fmt::Write;

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
    /// The page with the present texts between its marks.
    ///
    /// # Errors
    /// A mark without an end, or of something that was not measured.
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

    /// Every scene at the usual step and settings.
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
            // Writing to a string never fails.
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
