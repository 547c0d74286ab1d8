//! Other engines' points, from the file that `benches/peers` wrote: the same scenes, measured on one machine in one run.

use super::TOLERANCE;
use super::curve::{Curve, Measured, Origin, Point};

/// The columns that are read of the file that `benches/peers` writes; more may follow.
pub const PEERS_HEAD: &str = "scene,engine,step,work,error";
/// How many these are.
const COLUMNS: usize = 5;

/// Adds the peers' points to the diagrams of their scenes. Piles have no exact answer by hand: they make a diagram of their own.
///
/// # Errors
/// A sentence with the line of the first row that cannot be read.
pub fn add_peers(text: &str, diagrams: &mut Vec<Measured>) -> Result<(), String> {
    let mut lines = text.lines().enumerate();
    if lines.next().is_none_or(|(_, head)| !head.split(',').map(str::trim).take(COLUMNS).eq(PEERS_HEAD.split(','))) {
        return Err(format!("line 1: expected {PEERS_HEAD}"));
    }
    let mut piles = piles();
    for (index, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let number = |i: usize| fields.get(i).and_then(|field| field.parse::<f64>().ok());
        let (Some(step), Some(work), Some(error)) = (number(2), number(3), number(4)) else {
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
        tolerance: TOLERANCE,
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
        let text = "scene,engine,step,work,error,overlap\nfall,other,0.01,100,0.5,0\nfall,Resultant,0.01,10,0\npile-100,other,0.5,10,0.1\n";
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
