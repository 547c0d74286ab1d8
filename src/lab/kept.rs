//! The charts that come with the game, shown where `resultant chart` has not been run, and other engines' points, which `benches/peers` wrote.
//! A scene of the lab gets these as curves, one a version and setting; scenes that no method by hand could run make diagrams of their own.

use super::curve::{GROWTH, MOST_CURVES, Measured, NUMBERS, WorkPoint, curve_of, not_negative, rows, work_point};
use super::{TOLERANCE, charts::Charts};
use crate::{draw::chart::CurveOrigin, files::CsvRow, files::SHIPPED};

/// Errors: as [`Charts::read`]: a file was damaged before the build.
pub fn charts() -> Result<Charts, String> {
    Charts::read(|name| {
        let path = format!("docs/charts/{name}");
        let file = SHIPPED.iter().find(|(file, _)| *file == path).and_then(|(_, bytes)| str::from_utf8(bytes).ok());
        file.map(str::to_owned).ok_or_else(|| format!("{name}: not among the charts that come with the game"))
    })
}

/// The file that `benches/peers` writes beside the charts.
pub const PEERS: &str = "peers.csv";
pub const PEERS_HEAD: [&str; 10] =
    ["scene", "engine", "version", "settings", "step", "work", "spread", "error", "overlap", "speed"];

/// One engine on one scene. Work is CPU time for a simulated second and body.
#[derive(Clone, Debug, PartialEq)]
pub struct PeerRow {
    pub scene: String,
    pub engine: String,
    /// Of the engine; of this one [`crate::physics::SOURCES`].
    pub version: String,
    pub settings: String,
    pub point: WorkPoint,
    /// The deepest overlap after any step, m.
    pub overlap: f64,
}

impl PeerRow {
    pub fn ours(&self) -> bool {
        self.engine == OURS
    }
}

/// Whether `benches/peers` runs a scene of that name.
pub fn is_of_peers(scene: &str) -> bool {
    const SINGLE: &str = "fall slide bounce-perfect bounce-apexes bounce-fourth head-on cradle column column-100 heavy-on-light \
        pushed-row wall-10-km-s settled-100 settled-1000 settled-5000 islands-200 tower-hit afloat-64 asleep-1000 lift";
    const OF_SIZES: [&str; 5] = ["pile", "masses", "restitutions", "flight", "flight-drag"];
    let scene = scene.strip_suffix(SLEEP).unwrap_or(scene);
    SINGLE.split_whitespace().any(|name| name == scene) || OF_SIZES.iter().any(|scenes| size_of(scenes, scene).is_some())
}

/// The size at the end of a scene's name.
fn size_of(scenes: &str, scene: &str) -> Option<u32> {
    scene.strip_prefix(scenes)?.strip_prefix('-')?.parse().ok()
}

/// `file` names the text. Errors: file and line of the first row that cannot be read.
pub fn peer_rows(file: &str, text: &str) -> Result<Vec<PeerRow>, String> {
    let row = |row: CsvRow<'_>| {
        let word = |column| row.get(column).to_owned();
        Ok(PeerRow {
            scene: word("scene"),
            engine: word("engine"),
            version: word("version"),
            settings: word("settings"),
            point: work_point(&row)?,
            overlap: not_negative(&row, "overlap")?,
        })
    };
    rows(file, text, &PEERS_HEAD)?.into_iter().map(row).collect()
}

/// The name of this engine in that file.
pub const OURS: &str = "Resultant";
/// The ending of scenes in which resting bodies may sleep, as they always may in the lab.
const SLEEP: &str = "-sleep";

/// What the points of a diagram for engines only stand for.
#[derive(Clone, Copy, PartialEq)]
enum FamilyPoints {
    Steps,
    /// A point a size: an error, and the work a body and step.
    Sizes,
    /// A point a size: the time of a step, s, and the number of bodies.
    Growth,
}

/// A diagram for engines only; its scenes bear its name, or its name and a size.
struct Family {
    scenes: &'static str,
    name: &'static str,
    title: &'static str,
    error: &'static str,
    points: FamilyPoints,
    /// For the reader: a limit of a peer's own that decides its error.
    note: &'static str,
}

const FAMILIES: [Family; 4] = [
    Family::of_sizes("pile", "piles", "Piles of 100, 1000 and 5000 boxes raining into a pit, 10 s", "worst overlap at any step, m"),
    Family::of_sizes(
        "flight-drag",
        "flights-with-drag",
        "Flight of many bodies with drag, 5 s",
        "worst error of position at the end, m",
    ),
    Family {
        points: FamilyPoints::Steps,
        note: "As they come, Rapier and Box2D let nothing be faster than 400 m/s: the box is caught on its way, not at the wall.",
        ..Family::of_sizes(
            "wall-10-km-s",
            "wall-10-km-s",
            "A box of 0.2 m at 10 km/s against a wall of 5 cm",
            "error of position at the end, m",
        )
    },
    Family {
        points: FamilyPoints::Growth,
        note: "Slope 1: twice as many boxes take twice the time; slope 2: four times.",
        ..Family::of_sizes("pile", GROWTH, "How the time of a pile grows with its number of boxes", "CPU time of a step, s")
    },
];

impl Family {
    const fn of_sizes(scenes: &'static str, name: &'static str, title: &'static str, error: &'static str) -> Self {
        Self { scenes, name, title, error, points: FamilyPoints::Sizes, note: "" }
    }

    /// The point of a scene in the diagram; none where the scene is of another one.
    fn point(&self, scene: &str, point: WorkPoint) -> Option<WorkPoint> {
        if self.points == FamilyPoints::Steps {
            return (scene == self.scenes).then_some(point);
        }
        let size = f64::from(size_of(self.scenes, scene)?);
        let each = (point.work * point.step).clamp(*NUMBERS.start(), *NUMBERS.end());
        Some(match self.points {
            FamilyPoints::Growth => WorkPoint { work: size, error: each * size / 1e9, ..point },
            _ => WorkPoint { work: each, ..point },
        })
    }

    fn diagram(&self, step: f64) -> Measured {
        let (work, tolerance) = match self.points {
            FamilyPoints::Steps => (super::contract::WORK, TOLERANCE),
            FamilyPoints::Sizes => ("CPU time for a body and step, ns (a point a size)", TOLERANCE),
            // A step that takes as long as what it simulates.
            FamilyPoints::Growth => ("number of boxes", step),
        };
        let of_steps = self.points == FamilyPoints::Steps;
        Measured {
            name: self.name.to_owned(),
            title: self.title.to_owned(),
            error: self.error.to_owned(),
            work: work.to_owned(),
            tolerance,
            // Of sizes, the only one there is; else the step at which the game ships.
            shipped_step: if of_steps { 1.0 / crate::game::TICK_RATE } else { step },
            alike: of_steps,
            note: self.note.to_owned(),
            over_time: None,
            curves: Vec::new(),
        }
    }
}

/// Adds the peers' points to their scenes, and diagrams for engines only; leaves out other scenes. Errors: more curves than [`MOST_CURVES`].
pub fn add_peers(peers: &[PeerRow], diagrams: &mut Vec<Measured>) -> Result<(), String> {
    let mut families = FAMILIES.map(|family| (family, None::<Measured>));
    for row in peers {
        let PeerRow { scene, point, .. } = row;
        let (scene, sleeps) = match scene.strip_suffix(SLEEP) {
            // The lab measures this engine with sleep.
            Some(_) if row.ours() => continue,
            Some(scene) => (scene, true),
            None => (scene.as_str(), false),
        };
        let origin = if row.ours() { CurveOrigin::Shipped } else { CurveOrigin::Peer };
        let too_many = || format!("{PEERS}: {scene}: found an engine more, expected at most {MOST_CURVES} curves in a diagram");
        let add = |measured: &mut Measured, point: WorkPoint| {
            let curve = curve_of(&mut measured.curves, &curve_name(row, sleeps), origin).ok_or_else(too_many)?;
            curve.version.clone_from(&row.version);
            curve.points.push(point);
            Ok::<(), String>(())
        };
        if let Some(measured) = diagrams.iter_mut().find(|measured| measured.name == scene) {
            // In the scenes of the lab the shipped engine is measured here and now.
            if !row.ours() {
                add(measured, *point)?;
            }
            continue;
        }
        for (family, measured) in &mut families {
            if let Some(point) = family.point(scene, *point) {
                add(measured.get_or_insert_with(|| family.diagram(point.step)), point)?;
            }
        }
    }
    diagrams.extend(families.into_iter().filter_map(|(_, measured)| measured));
    Ok(())
}

/// The legend of a curve: the engine with its version and settings, of which a frequency is the stiffness of contacts; ours needs neither.
fn curve_name(row: &PeerRow, sleeps: bool) -> String {
    if row.ours() {
        return row.engine.clone();
    }
    let stiff =
        row.settings.split(", ").map(|part| if part.ends_with(" Hz") { format!("stiffness {part}") } else { part.to_owned() });
    let settings = stiff.collect::<Vec<_>>().join(", ");
    let settings = [settings.as_str(), if sleeps { "with sleep" } else { "" }].into_iter().filter(|words| !words.is_empty());
    settings.fold(format!("{} {}", row.engine, row.version), |name, words| format!("{name}, {words}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::scenes;

    #[test]
    fn every_scene_has_its_chart() {
        let charts = charts().unwrap();
        let kept: Vec<&str> = charts.diagrams.iter().map(|measured| measured.name.as_str()).collect();
        let scenes: Vec<&str> = scenes::all().iter().map(|scene| scene.name).collect();
        // Behind the scenes of the lab stand the scenes of engines only.
        assert_eq!(kept[..scenes.len()], scenes);
        let followed = charts.diagrams.iter().filter(|measured| measured.over_time.is_some());
        let mut kept: Vec<String> = ["setting", "scenes", "stress", "savings"].into_iter().chain(kept).map(str::to_owned).collect();
        kept.extend(followed.map(|measured| format!("{}-over-time", measured.name)));
        kept.sort();
        let named = |file: &str| Some(file.strip_prefix("docs/charts/")?.strip_suffix(".csv")?.to_owned());
        let mut built_in: Vec<String> = SHIPPED.iter().filter_map(|(file, _)| named(file)).collect();
        built_in.sort();
        assert_eq!(built_in, kept, "docs/charts has other files than its scenes.csv names");
        assert!(!charts.stress.is_empty());
    }

    /// A file of such rows, each without its end from the error on.
    fn file(rows: &[&str]) -> String {
        let rows = rows.iter().map(|row| format!("{row},0,0\n"));
        std::iter::once(format!("{}\n", PEERS_HEAD.join(","))).chain(rows).collect()
    }

    #[test]
    fn peers_are_added_to_their_scenes_and_the_rest_make_their_own() {
        let mut diagrams = vec![Measured { name: "fall".into(), ..FAMILIES[0].diagram(0.01) }];
        let text = file(&[
            "fall,other,1.2,\"4 parts, soft\",0.01,100,0,0.5",
            "fall,other,1.2,\"4 parts, soft\",0.005,200,0,0.25",
            "fall,other,1.2,\"32 parts, stiff\",0.01,800,0,0.1",
            "fall-sleep,other,1.2,\"4 parts, soft\",0.01,50,0,0.5",
            "fall,Resultant,0.1.0,,0.01,10,0,0",
            "pile-100,other,1.2,,0.5,10,0,0.1",
            "pile-100,Resultant,0.1.0,,0.5,1,0,0",
            "pile-1000,Resultant,0.1.0,,0.5,2,0,0",
            "wall-10-km-s,other,1.2,\"4 parts, 30 Hz\",0.01,7,0,0",
            "wall-10-km-s,Resultant,0.1.0,,0.01,9,0,0",
            "wall-10-km-s,Resultant,0.1.0,,8.333333333333333e-3,8,0,0",
            "unheard-of,other,1.2,,0.01,7,0,0",
            "flight-drag-1000,other,1.2,,0.5,8,0,NaN",
        ]);
        add_peers(&peer_rows(PEERS, &text).unwrap(), &mut diagrams).unwrap();
        let names: Vec<&str> = diagrams.iter().map(|measured| measured.name.as_str()).collect();
        assert_eq!(names, ["fall", "piles", "flights-with-drag", "wall-10-km-s", GROWTH]);
        let curves =
            |i: usize| diagrams[i].curves.iter().map(|curve| (curve.name.as_str(), curve.points.clone())).collect::<Vec<_>>();
        let point = |step, work, error| WorkPoint { step, work, spread: 0.0, error };
        assert_eq!(
            curves(0),
            [
                ("other 1.2, 4 parts, soft", vec![point(0.01, 100.0, 0.5), point(0.005, 200.0, 0.25)]),
                ("other 1.2, 32 parts, stiff", vec![point(0.01, 800.0, 0.1)]),
                ("other 1.2, 4 parts, soft, with sleep", vec![point(0.01, 50.0, 0.5)])
            ]
        );
        assert_eq!(
            curves(1),
            [("other 1.2", vec![point(0.5, 5.0, 0.1)]), (OURS, vec![point(0.5, 0.5, 0.0), point(0.5, 1.0, 0.0)])]
        );
        let (_, shipped) = diagrams[1].shipped().unwrap();
        assert_eq!(shipped.count(), 2, "every size is shipped");
        assert_eq!(curves(3)[0].0, "other 1.2, 4 parts, stiffness 30 Hz");
        // Half a nanosecond a body and step of 100, and one of 1000.
        assert_eq!(curves(4)[1].1, [point(0.5, 100.0, 0.5e-7), point(0.5, 1000.0, 1e-6)]);
        assert_eq!(diagrams[3].shipped_point().map(|point| point.work), Some(8.0), "the point at the game's own step");
    }

    #[test]
    fn numbers_that_cannot_be_are_refused_by_line_and_column() {
        let above_zero = "a number above 0, from 1e-100 to 1e100";
        for (row, column, found, expected) in [
            ("fall,other,1,,0,1,0,0", "step", "0", above_zero),
            ("fall,other,1,,0.1,1.8e308,0,0", "work", "1.8e308", above_zero),
            ("fall,other,1,,0.1,NaN,0,0", "work", "NaN", above_zero),
            ("fall,other,1,,0.1,many,0,0", "work", "many", above_zero),
            ("fall,other,1,,0.1,1,0,-1", "error", "-1", "an error of 0 or more, inf or NaN"),
            ("fall,other,1,,inf,1,0,0", "step", "inf", above_zero),
        ] {
            let problem = peer_rows(PEERS, &file(&[row])).unwrap_err();
            assert_eq!(problem, format!("peers.csv:2: column \"{column}\": found \"{found}\", expected {expected}"));
        }
        let head = PEERS_HEAD.join(",");
        let problem = peer_rows(PEERS, "scene,engine,step,work,error\n").unwrap_err();
        assert_eq!(problem, format!("peers.csv:1: found \"scene,engine,step,work,error\", expected the head {head}"));
        assert!(peer_rows(PEERS, "").unwrap_err().starts_with("peers.csv: found nothing"));
    }
}
