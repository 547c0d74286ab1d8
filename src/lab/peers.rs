//! Other engines' points, from the file that `benches/peers` wrote: the same scenes, measured on one machine in one run. A scene of
//! the lab gets their points into its diagram; the others, which no method by hand could run, make diagrams of their own.

use super::TOLERANCE;
use super::curve::{Curve, MOST_CURVES, Measured, NUMBERS, Origin, Point};

/// The columns that are read of the file that `benches/peers` writes; more may follow.
pub const PEERS_HEAD: &str = "scene,engine,step,work,error";
/// How many these are.
const COLUMNS: usize = 5;
/// How many letters of a line that cannot be read are shown.
const MOST_SHOWN: usize = 120;
/// What `benches/peers` calls this engine.
pub const OURS: &str = "Resultant";
/// What its scenes end with in which bodies that rest may sleep, as they always may in the lab.
const SLEEP: &str = "-sleep";

/// A diagram that only engines take part in, and which scenes are in it: those of that name, or of that name and a size.
struct Family {
    scenes: &'static str,
    name: &'static str,
    title: &'static str,
    error: &'static str,
    tolerance: f64,
    /// Whether its scenes come in sizes: a point a size, work a body and step.
    sizes: bool,
}

const OVERLAP: &str = "worst overlap at any step, m";

const FAMILIES: [Family; 9] = [
    Family::of_sizes("pile", "piles", "Piles of 100, 1000 and 5000 boxes raining into a pit, 10 s", OVERLAP),
    Family::of_sizes("masses", "piles-of-masses", "Boxes of 0.5 to 50 kg raining into a pit, 10 s", OVERLAP),
    Family::of_sizes("restitutions", "piles-that-bounce", "Boxes of mixed restitutions raining into a pit, 10 s", OVERLAP),
    Family::of_sizes("settled", "settled", "Settled piles that may sleep, 10 s", "largest movement, m"),
    Family::of_sizes("flight", "flights", "Free flight of many bodies, 5 s", "worst error of position at the end, m"),
    Family::of_sizes(
        "flight-drag",
        "flights-with-drag",
        "Flight of many bodies with drag, 5 s",
        "worst error of position at the end, m",
    ),
    Family {
        // A tenth of a pixel of the fourth apex, 20 m · 0.5⁸.
        tolerance: TOLERANCE / 0.078_125,
        ..Family::single("bounce-fourth", "The fourth bounce at restitution 0.5, from 20 m", "relative error of its height")
    },
    Family::single("column-100", "A column of 100 equal blocks, 10 s", "largest movement of a body at rest, m"),
    Family::single("wall-10-km-s", "A box of 0.2 m at 10 km/s against a wall of 5 cm", "error of position at the end, m"),
];

impl Family {
    const fn single(name: &'static str, title: &'static str, error: &'static str) -> Self {
        Self { scenes: name, name, title, error, tolerance: TOLERANCE, sizes: false }
    }

    const fn of_sizes(scenes: &'static str, name: &'static str, title: &'static str, error: &'static str) -> Self {
        Self { scenes, name, title, error, tolerance: TOLERANCE, sizes: true }
    }

    fn has(&self, scene: &str) -> bool {
        let size = |rest: &str| rest.strip_prefix('-').is_some_and(|size| size.parse::<u32>().is_ok());
        if self.sizes { scene.strip_prefix(self.scenes).is_some_and(size) } else { scene == self.scenes }
    }

    fn diagram(&self, step: f64) -> Measured {
        let work = if self.sizes { "CPU time for a body and step, ns (a point a size)" } else { super::scene::WORK };
        Measured {
            name: self.name.to_owned(),
            title: self.title.to_owned(),
            error: self.error.to_owned(),
            work: work.to_owned(),
            tolerance: self.tolerance,
            shipped_step: step,
            alike: !self.sizes,
            note: String::new(),
            over_time: None,
            curves: Vec::new(),
        }
    }
}

/// Adds the peers' points to the diagrams of their scenes, and diagrams for the scenes that only engines take part in. Scenes that are
/// neither are left out.
///
/// # Errors
/// A sentence with the line of the first row that cannot be read.
pub fn add_peers(text: &str, diagrams: &mut Vec<Measured>) -> Result<(), String> {
    let mut lines = text.lines().enumerate();
    if lines.next().is_none_or(|(_, head)| !head.split(',').map(str::trim).take(COLUMNS).eq(PEERS_HEAD.split(','))) {
        return Err(format!("line 1: expected {PEERS_HEAD}"));
    }
    let mut families = FAMILIES.map(|family| (family, None::<Measured>));
    for (index, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let number = |i: usize| fields.get(i).and_then(|field| field.parse::<f64>().ok());
        let above_zero = |i: usize| number(i).filter(|value| NUMBERS.contains(value));
        let error = number(4).filter(|error| error.is_nan() || *error >= 0.0);
        let (Some(step), Some(work), Some(error)) = (above_zero(2), above_zero(3), error) else {
            let (least, most) = (NUMBERS.start(), NUMBERS.end());
            return Err(format!(
                "line {}: expected a scene, an engine, step and work from {least:e} to {most:e} and an error of 0 or more, found {}",
                index + 1,
                line.chars().take(MOST_SHOWN).collect::<String>()
            ));
        };
        let too_many = |()| format!("line {}: found another engine, expected at most {MOST_CURVES} curves in a diagram", index + 1);
        let (scene, ours) = (fields[0], fields[1] == OURS);
        let (scene, engine) = match scene.strip_suffix(SLEEP) {
            // Ours with sleep is what the lab measures.
            Some(_) if ours => continue,
            Some(scene) => (scene, format!("{}, with sleep", fields[1])),
            None => (scene, fields[1].to_owned()),
        };
        if let Some(measured) = diagrams.iter_mut().find(|measured| measured.name == scene) {
            // In the scenes of the lab the shipped engine is measured here and now.
            if !ours {
                add(measured, &engine, Origin::Peer, Point { step, work, error }).map_err(too_many)?;
            }
        } else if let Some((family, measured)) = families.iter_mut().find(|(family, _)| family.has(scene)) {
            let work = if family.sizes { (work * step).clamp(*NUMBERS.start(), *NUMBERS.end()) } else { work };
            let origin = if ours { Origin::Shipped } else { Origin::Peer };
            add(measured.get_or_insert_with(|| family.diagram(step)), &engine, origin, Point { step, work, error })
                .map_err(too_many)?;
        }
    }
    diagrams.extend(families.into_iter().filter_map(|(_, measured)| measured));
    Ok(())
}

/// Adds a point to a curve of that name.
///
/// # Errors
/// There are [`MOST_CURVES`] others.
fn add(measured: &mut Measured, name: &str, origin: Origin, point: Point) -> Result<(), ()> {
    match measured.curves.iter().position(|curve| curve.name == name) {
        Some(index) => measured.curves[index].points.push(point),
        None if measured.curves.len() >= MOST_CURVES => return Err(()),
        None => measured.curves.push(Curve { name: name.to_owned(), origin, points: vec![point] }),
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peers_are_added_to_their_scenes_and_the_rest_make_their_own() {
        let mut diagrams = vec![Measured { name: "fall".into(), ..FAMILIES[0].diagram(0.01) }];
        let text = "scene,engine,step,work,error,overlap\nfall,other,0.01,100,0.5,0\nfall-sleep,other,0.01,50,0.5,0\n\
                    fall,Resultant,0.01,10,0\npile-100,other,0.5,10,0.1\npile-100,Resultant,0.5,1,0\npile-1000,Resultant,0.5,2,0\n\
                    column-100,other,0.01,7,0\nunheard-of,other,0.01,7,0\nflight-drag-1000,other,0.5,8,NaN\n";
        add_peers(text, &mut diagrams).unwrap();
        let names: Vec<&str> = diagrams.iter().map(|measured| measured.name.as_str()).collect();
        assert_eq!(names, ["fall", "piles", "flights-with-drag", "column-100"]);
        let curves =
            |i: usize| diagrams[i].curves.iter().map(|curve| (curve.name.as_str(), curve.points.clone())).collect::<Vec<_>>();
        let point = |step, work, error| Point { step, work, error };
        assert_eq!(curves(0), [("other", vec![point(0.01, 100.0, 0.5)]), ("other, with sleep", vec![point(0.01, 50.0, 0.5)])]);
        assert_eq!(curves(1), [("other", vec![point(0.5, 5.0, 0.1)]), (OURS, vec![point(0.5, 0.5, 0.0), point(0.5, 1.0, 0.0)])]);
        assert_eq!(curves(3), [("other", vec![point(0.01, 7.0, 0.0)])]);
        let (_, shipped) = diagrams[1].shipped().unwrap();
        assert_eq!(shipped.count(), 2, "every size is shipped");
    }

    #[test]
    fn a_bad_row_is_named() {
        let problem = add_peers("scene,engine,step,work,error\nfall,other,0.01,many,0\n", &mut Vec::new()).unwrap_err();
        assert_eq!(
            problem,
            "line 2: expected a scene, an engine, step and work from 1e-100 to 1e100 and an error of 0 or more, found fall,other,0.01,many,0"
        );
        assert_eq!(add_peers("", &mut Vec::new()).unwrap_err(), "line 1: expected scene,engine,step,work,error");
    }

    #[test]
    fn numbers_that_cannot_be_are_refused() {
        for row in [
            "fall,other,0,1,0",
            "fall,other,0.1,1.8e308,0",
            "fall,other,0.1,NaN,0",
            "fall,other,0.1,1,-1",
            "fall,other,0.1,inf,0",
            "fall,other",
        ] {
            let problem = add_peers(&format!("{PEERS_HEAD}\n{row}\n"), &mut Vec::new()).unwrap_err();
            assert_eq!(
                problem,
                format!(
                    "line 2: expected a scene, an engine, step and work from 1e-100 to 1e100 and an error of 0 or more, found {row}"
                )
            );
        }
    }
}
