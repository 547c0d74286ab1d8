//! What is called by name: the files of a level's folder, and what its switches work.

use super::nearest::{meant, nearest};
use super::problem::{Problem, quoted};
use super::read::Draft;
use std::collections::BTreeSet;

/// The files of a level, in the order in which problems are listed.
pub const FILES: [&str; 16] = [
    "constants.csv",
    "player.csv",
    "world.csv",
    "objects.csv",
    "objectives.csv",
    "obstacles.csv",
    "hazards.csv",
    "movers.csv",
    "doors.csv",
    "switches.csv",
    "gravity.csv",
    "pods.csv",
    "decoration.csv",
    "background.png",
    "fluids.csv",
    "texts.csv",
];

/// A file that no level has: refused where it is one of [`FILES`] misspelt, else only named. What is no table is the author's own.
pub(super) fn stray(file: &str) -> Option<Result<Problem, Problem>> {
    let table = file.to_lowercase().ends_with(".csv");
    if FILES.contains(&file) || !(table || nearest(file, ["background.png"]).is_some()) {
        return None;
    }
    let known = nearest(file, FILES);
    let expected = known.map_or_else(|| format!("one of {}", FILES.join(", ")), |known| format!("the name {known:?}"));
    let problem = Problem::of_file(file, "a file that no level has", expected);
    Some(if known.is_some() { Err(problem) } else { Ok(problem) })
}

/// All names that something is called by that can be worked.
fn worked(draft: &Draft) -> BTreeSet<&str> {
    let belts = draft.world.iter().filter(|solid| solid.item.belt != 0.0).map(|solid| &solid.item.name);
    let movers = draft.movers.iter().map(|mover| &mover.item.solid.name);
    let doors = draft.doors.iter().map(|door| &door.item.name);
    let streams = draft.streams.iter().map(|stream| &stream.item.name);
    belts.chain(movers).chain(doors).chain(streams).filter_map(|name| name.as_deref()).collect()
}

/// Switches that work what is not there.
pub(super) fn check(draft: &Draft) -> Vec<Problem> {
    let known = worked(draft);
    let mut problems = Vec::new();
    for switch in &draft.switches {
        for work in switch.item.works.iter().filter(|work| !known.contains(work.name.as_str())) {
            let all = known.iter().copied().collect::<Vec<_>>().join(", ");
            let expected = if known.is_empty() {
                "the name of a mover, door, stream or belt; none has one".to_owned()
            } else {
                format!("the name of a mover, door, stream or belt: {all}{}", meant(&work.name, known.iter().copied()))
            };
            problems.push(switch.problem("works", quoted(&work.name), expected));
        }
    }
    problems
}

/// What has a name that no switch knows.
pub(super) fn warn(draft: &Draft) -> Vec<Problem> {
    let works = draft.switches.iter().flat_map(|switch| &switch.item.works);
    let known: BTreeSet<&str> = works.map(|work| work.name.as_str()).collect();
    let doors = draft.doors.iter().map(|door| door.map(|door| door.name.clone()));
    let movers = draft.movers.iter().map(|mover| mover.map(|mover| mover.solid.name.clone()));
    let streams = draft.streams.iter().map(|stream| stream.map(|stream| stream.name.clone()));
    let world = draft.world.iter().map(|solid| solid.map(|solid| solid.name.clone()));
    let named = world.chain(movers).chain(doors).chain(streams);
    named
        .filter_map(|placed| {
            let name = placed.item.as_deref().filter(|name| !known.contains(name))?;
            let found = format!("{}, which no switch works", quoted(name));
            Some(placed.problem(
                "name",
                found,
                format!("a row of switches.csv that works it{}", meant(name, known.iter().copied())),
            ))
        })
        .collect()
}
