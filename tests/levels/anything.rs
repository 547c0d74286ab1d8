//! Whatever is in the files.

use crate::fixtures;
use crate::support::strategies::cases;
use proptest::prelude::*;
use resultant::level::{self, FILES, Files};
use resultant::physics::{BodyId, World};
use std::collections::BTreeMap;
use std::io;

/// A level's files in memory; every image is the ball.
struct Memory {
    files: BTreeMap<String, Vec<u8>>,
    ball: Vec<u8>,
}

impl Files for Memory {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        self.files.get(name).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn project_file(&self, _path: &str) -> io::Result<Vec<u8>> {
        Ok(self.ball.clone())
    }
}

const BASES: [&str; 3] = ["good_original", "good_any_order", "good_spreadsheet"];

/// Texts in place of a cell: numbers at and beyond every limit, words, separators, line ends, broken quotes.
const SPOILS: &str = "|0|-0|1|-1|1e-9|1e-320|1e6|-1e6|1e12|3e7|-3e7|1e300|1e999|nan|inf|255|0.5|\"1,5\"|TRUE|false|Ice|x|mass|box:1x1|ball:1e7x0.03|../a|\
    a.png|OBJECT|PHYS|#|\"|\n|\r\n|,|;|\u{feff}|\0|gravity|metre";

fn spoils() -> impl Strategy<Value = &'static str> {
    prop::sample::select(SPOILS.split('|').collect::<Vec<_>>())
}

fn spoilt() -> impl Strategy<Value = BTreeMap<String, Vec<u8>>> {
    let change = (0..FILES.len(), any::<prop::sample::Index>(), spoils());
    (0..BASES.len(), prop::collection::vec(change, 0..4)).prop_map(|(base, changes)| {
        let folder = fixtures().join("levels").join(BASES[base]);
        let read = |name: &str| Some((name.to_owned(), std::fs::read(folder.join(name)).ok()?));
        let mut files: BTreeMap<_, _> = FILES.into_iter().filter_map(read).collect();
        for (file, cell, spoil) in changes {
            let Some(bytes) = files.get_mut(FILES[file]).filter(|_| FILES[file].ends_with(".csv")) else { continue };
            let text = String::from_utf8_lossy(bytes).into_owned();
            let mut cells: Vec<&str> = text.split_inclusive([',', '\n']).collect();
            let i = cell.index(cells.len());
            let end = if cells[i].ends_with('\n') { "\n" } else { "," };
            let new = format!("{spoil}{end}");
            cells[i] = &new;
            *bytes = cells.concat().into_bytes();
        }
        files
    })
}

fn arbitrary() -> impl Strategy<Value = BTreeMap<String, Vec<u8>>> {
    let text = prop::collection::vec(spoils(), 0..40).prop_map(|cells| cells.join(",").into_bytes());
    let bytes = prop_oneof![prop::collection::vec(any::<u8>(), 0..80), text, any::<String>().prop_map(String::into_bytes)];
    prop::collection::btree_map(prop::sample::select(&FILES[..]).prop_map(str::to_owned), bytes, 0..FILES.len())
}

proptest! {
    #![proptest_config(cases(2000))]

    /// The loader never panics; a refused level has at least one problem, each on one line that names its place; and an accepted one builds a
    /// world in which nothing becomes infinite or NaN.
    #[test]
    fn any_text_is_refused_in_words_or_becomes_a_finite_world(files in prop_oneof![3 => spoilt(), 1 => arbitrary()]) {
        let ball = std::fs::read(fixtures().join("assets/sprites/ball.png")).unwrap();
        match level::read("any", &Memory { files, ball }) {
            Err(problems) => {
                prop_assert!(!problems.is_empty());
                for problem in problems {
                    let text = problem.to_string();
                    let place = match problem.line {
                        0 => format!("{}: found ", problem.file),
                        line => format!("{}:{line}: column \"", problem.file),
                    };
                    prop_assert!(text.starts_with(&place), "{text}");
                    prop_assert!(!text.contains(['\n', '\r']), "{text}");
                }
            }
            Ok(loaded) => {
                let mut world = World::new(loaded.level.world_def()).unwrap();
                (0..20).for_each(|_| world.step(1.0 / 120.0));
                for (i, body) in world.bodies().iter().enumerate() {
                    let resultant = world.forces(BodyId(i as u32)).resultant();
                    let finite = [body.position, body.velocity, body.acceleration, resultant].iter().all(|v| v.is_finite());
                    prop_assert!(finite, "{body:?} {resultant:?}");
                }
            }
        }
    }
}
