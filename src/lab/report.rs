//! The numbers in writing: CSV, the table of the stress tests, and a summary that shows all diagrams. Numbers in CSV are in the
//! shortest form that reads back as the same f64; `inf` and `NaN` are runs that blew up.

use super::curve::{Curve, Measured, Origin, Point};
use super::diagram::number;
use super::stress::Survival;
use std::fmt::Write;

/// Where and with what it was measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// Kind of processor and system; no names of machines.
    pub machine: String,
    /// Commit that was measured, if it is known.
    pub commit: Option<String>,
    /// Build profile.
    pub profile: &'static str,
    /// Fewer repetitions.
    pub quick: bool,
}

/// A diagram's points: `method,origin,step,work,error`.
pub fn points_csv(measured: &Measured) -> String {
    let mut text = "method,origin,step,work,error\n".to_owned();
    for curve in &measured.curves {
        let origin = match curve.origin {
            Origin::Lab => "lab",
            Origin::Shipped => "shipped",
            Origin::Peer => "peer",
        };
        for Point { step, work, error } in &curve.points {
            // A string takes all that is written to it.
            let _ = writeln!(text, "{},{origin},{step:e},{work:e},{error:e}", field(&curve.name));
        }
    }
    text
}

/// The stress tests: `test,parameter,method,largest,tried,shipped`.
pub fn stress_csv(rows: &[Survival]) -> String {
    let mut text = "test,parameter,method,largest,tried,shipped\n".to_owned();
    for row in rows {
        let (test, parameter, method) = (field(row.test), field(row.parameter), field(&row.method));
        let _ = writeln!(text, "{test},{parameter},{method},{},{},{}", row.largest, row.tried, row.shipped);
    }
    text
}

/// A CSV field, quoted where it has to be.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

/// Everything on one page, in Markdown.
pub fn summary(setting: &Setting, diagrams: &[Measured], stress: &[Survival]) -> String {
    let mut text = "# Accuracy against speed\n\n".to_owned();
    let commit = setting.commit.as_deref().unwrap_or("unknown");
    let runs = if setting.quick { "few runs a point (--quick)" } else { "medians of several runs" };
    let _ = writeln!(text, "Machine: {}. Commit: {commit}. Build: {}; one thread, {runs}.\n", setting.machine, setting.profile);
    text.push_str(
        "Each point is a method at a step: work to the right, error upwards, so lower left is better. The dashed green line is an \
         error that nobody sees. Methods that lose are shown too.\n\n",
    );
    text.push_str("## Shipped, and the cheapest within the tolerance\n\n");
    text.push_str("| scene | shipped: error | work, ns | cheapest within the tolerance | step, s | error | work, ns |\n");
    text.push_str("|---|---|---|---|---|---|---|\n");
    for measured in diagrams {
        let (error, work) = measured.shipped().map_or(("–".into(), "–".into()), |(_, p)| (shown(p.error), number(p.work)));
        let none = if measured.alike { "none | – | – | –" } else { "– | – | – | –" };
        let cheapest = measured.cheapest().map_or(none.to_owned(), |(curve, p)| {
            format!("{} | {} | {} | {}", curve.name, number(p.step), shown(p.error), number(p.work))
        });
        let _ = writeln!(text, "| [{}](#{}) | {error} | {work} | {cheapest} |", measured.title, measured.name);
    }
    if let Some(measured) = diagrams.iter().find(|measured| measured.name == PI) {
        pi_table(&mut text, measured);
    }
    text.push_str(
        "\n## What each method survives\n\nThe largest value that a method survives; 0: none, ≥: nothing larger was tried.\n\n",
    );
    text.push_str("| test | parameter | method | largest |\n|---|---|---|---|\n");
    for row in stress {
        let largest = format!("{}{}", if row.largest >= row.tried { "≥ " } else { "" }, number(row.largest));
        let (method, largest) =
            if row.shipped { (format!("**{}**", row.method), format!("**{largest}**")) } else { (row.method.clone(), largest) };
        let _ = writeln!(text, "| {} | {} | {method} | {largest} |", row.test, row.parameter);
    }
    text.push_str("\n## Diagrams\n");
    for measured in diagrams {
        let name = &measured.name;
        let _ = writeln!(text, "\n<a id=\"{name}\"></a>\n![{}]({name}.svg)\n\n[numbers]({name}.csv)", measured.title);
    }
    text
}

/// The scene of which [`summary`] makes a table of its own.
pub const PI: &str = "pi";

/// Up to which N each step counts right, and what that costs.
fn pi_table(text: &mut String, measured: &Measured) {
    text.push_str("\n## π from collisions in time steps\n\n| step, s | right up to N | its CPU time, ns |\n|---|---|---|\n");
    let by_hand: Vec<&Curve> = measured.curves.iter().filter(|curve| curve.origin == Origin::Lab).collect();
    let steps = by_hand.first().map_or(0, |curve| curve.points.len());
    for index in 0..steps {
        let right = by_hand.iter().take_while(|curve| curve.points[index].error == 0.0).count();
        let step = number(by_hand[0].points[index].step);
        let _ = match right.checked_sub(1) {
            Some(n) => writeln!(text, "| {step} | {n} | {} |", number(by_hand[n].points[index].work)),
            None => writeln!(text, "| {step} | none | – |"),
        };
    }
    if let Some((curve, point)) = measured.shipped() {
        let _ = writeln!(text, "| {}: at any | all | {} |", curve.name, number(point.work));
    }
}

/// An error as read by people: below rounding it is none.
fn shown(error: f64) -> String {
    if error == 0.0 { "0".to_owned() } else { number(error) }
}

/// The head of the file that `benches/peers` writes.
pub const PEERS_HEAD: &str = "scene,engine,step,work,error";

/// Adds the peers' points to the diagrams of their scenes. Piles have no exact answer by hand: they make a diagram of their own.
///
/// # Errors
/// A sentence with the line of the first row that cannot be read.
pub fn add_peers(text: &str, diagrams: &mut Vec<Measured>) -> Result<(), String> {
    let mut lines = text.lines().enumerate();
    if lines.next().is_none_or(|(_, head)| head.trim() != PEERS_HEAD) {
        return Err(format!("line 1: expected {PEERS_HEAD}"));
    }
    let mut piles = piles();
    for (index, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let number = |i: usize| fields.get(i).and_then(|field| field.parse::<f64>().ok());
        let (Some(step), Some(work), Some(error), 5) = (number(2), number(3), number(4), fields.len()) else {
            return Err(format!("line {}: expected a scene, an engine and three numbers, found {line}", index + 1));
        };
        let (scene, engine) = (fields[0], fields[1]);
        let ours = engine == OURS;
        let pile = scene.starts_with("pile-");
        let Some(measured) = (if pile { Some(&mut piles) } else { diagrams.iter_mut().find(|measured| measured.name == scene) })
        else {
            continue;
        };
        // In the scenes of the lab the shipped engine is measured here and now.
        if ours && !pile {
            continue;
        }
        // The piles' work is a body and step.
        let point = Point { step, work: if pile { work * step } else { work }, error };
        match measured.curves.iter_mut().find(|curve| curve.name == engine) {
            Some(curve) => curve.points.push(point),
            None => {
                let origin = if ours { Origin::Shipped } else { Origin::Peer };
                measured.curves.push(Curve { name: engine.to_owned(), origin, points: vec![point] });
            }
        }
    }
    if !piles.curves.is_empty() {
        diagrams.push(piles);
    }
    Ok(())
}

/// What `benches/peers` calls this engine.
pub const OURS: &str = "Resultant";

fn piles() -> Measured {
    Measured {
        name: "piles".to_owned(),
        title: "Piles of 100, 1000 and 5000 boxes raining into a pit, 10 s".to_owned(),
        error: "worst overlap at any step, m".to_owned(),
        work: "CPU time for a body and step, ns (a point a size)".to_owned(),
        tolerance: super::TOLERANCE,
        shipped_step: 1.0 / 60.0,
        alike: false,
        curves: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peers_are_added_to_their_scenes() {
        let mut diagrams = vec![Measured { name: "fall".into(), ..piles() }];
        let text = "scene,engine,step,work,error\nfall,other,0.01,100,0.5\nfall,Resultant,0.01,10,0\npile-100,other,0.5,10,0.1\n";
        add_peers(text, &mut diagrams).unwrap();
        assert_eq!(diagrams.len(), 2);
        assert_eq!(diagrams[0].curves.len(), 1);
        assert_eq!(diagrams[0].curves[0].points, [Point { step: 0.01, work: 100.0, error: 0.5 }]);
        assert_eq!(diagrams[1].curves[0].points, [Point { step: 0.5, work: 5.0, error: 0.1 }]);
    }

    #[test]
    fn a_bad_row_is_named() {
        let problem = add_peers("scene,engine,step,work,error\nfall,other,0.01,many,0\n", &mut Vec::new()).unwrap_err();
        assert_eq!(problem, "line 2: expected a scene, an engine and three numbers, found fall,other,0.01,many,0");
        assert_eq!(add_peers("", &mut Vec::new()).unwrap_err(), "line 1: expected scene,engine,step,work,error");
    }
}
