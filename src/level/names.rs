//! Names: those of the files in a level's folder, and those of the things that its switches work.

use super::draft::Draft;
use super::nearest::{meant, nearest};
use super::problem::{MOST_PROBLEMS, Problem, at_most, quoted};
use super::schema::FILES;
use super::wiring::names_in;
use crate::words::tr;
use std::collections::{BTreeMap, BTreeSet};

/// A file that no level has: refused where it is one of [`FILES`] misspelt, a warning for any other table. Other files are the author's own.
pub(super) fn stray(file: &str) -> Option<Result<Problem, Problem>> {
    if FILES.contains(&file) {
        return None;
    }
    let known = meant_file(file);
    if known.is_none() && !file.to_lowercase().ends_with(".csv") {
        return None;
    }
    let expected = known.map_or_else(
        || tr!("one of {list}", list = FILES.join(", ")),
        |known| tr!("the name {known}", known = format_args!("{known:?}")),
    );
    let problem = Problem::of_file(file, tr("a file that no level has"), expected);
    Some(if known.is_some() { Err(problem) } else { Ok(problem) })
}

/// The file of a level that a name misspells: stem and ending are each near enough, whatever the case. The ending alone, which all tables
/// share, makes no name near.
fn meant_file(file: &str) -> Option<&'static str> {
    let (stem, ending) = file.rsplit_once('.')?;
    let near = FILES.iter().filter(|known| known.rsplit_once('.').is_some_and(|(_, own)| nearest(ending, [own]).is_some()));
    let stems = near.filter_map(|known| known.rsplit_once('.').map(|(stem, _)| stem));
    let stem = nearest(stem, stems)?;
    FILES.into_iter().find(|known| known.rsplit_once('.').is_some_and(|(own, _)| own == stem))
}

/// The most names that a message lists and compares with an unknown one; a table can hold thousands.
const MOST_NAMES: usize = 100;
/// The most wires of a level: the game looks at each in every tick.
const MOST_WIRES: usize = 100_000;

/// The names that switches can work, each with the number of its things.
fn worked(draft: &Draft) -> BTreeMap<&str, usize> {
    let mut things: BTreeMap<&str, usize> = BTreeMap::new();
    let solids = draft.world.iter().filter(|solid| solid.item.belt != 0.0).chain(&draft.doors).map(|solid| &solid.item.name);
    let movers = draft.movers.iter().map(|mover| &mover.item.solid.name);
    let streams = draft.streams.iter().map(|stream| &stream.item.name);
    let links = draft.links.iter().map(|link| &link.item.name);
    for name in solids.chain(movers).chain(streams).chain(links).flatten().flat_map(|name| names_in(name)) {
        *things.entry(name).or_default() += 1;
    }
    things
}

/// Switches that work a name that no thing has.
pub(super) fn check(draft: &Draft) -> Vec<Problem> {
    let known = worked(draft);
    let works = draft.switches.iter().flat_map(|switch| &switch.item.works);
    let wires: usize = works.filter_map(|work| known.get(work.name.as_str())).sum();
    if let Some(switch) = draft.switches.first().filter(|_| wires > MOST_WIRES) {
        let found = tr!("{wires} wires from switches to what they work, counted in all rows", wires);
        return vec![switch.problem("works", found, at_most(MOST_WIRES))];
    }
    let mut all = known.keys().copied().take(MOST_NAMES).collect::<Vec<_>>().join(", ");
    if known.len() > MOST_NAMES {
        all += &tr!(" and {count} more", count = known.len() - MOST_NAMES);
    }
    let mut problems = Vec::new();
    for switch in &draft.switches {
        for work in switch.item.works.iter().filter(|work| !known.contains_key(work.name.as_str())) {
            if problems.len() > MOST_PROBLEMS {
                return problems;
            }
            let expected = if known.is_empty() {
                tr("the name of a mover, door, stream, belt or link; none has one").to_owned()
            } else {
                let meant = meant(&work.name, known.keys().copied().take(MOST_NAMES));
                tr!("the name of a mover, door, stream, belt or link: {all}", all) + &meant
            };
            problems.push(switch.problem("works", quoted(&work.name), expected));
        }
    }
    problems
}

/// Things with a name that no switch works.
pub(super) fn warn(draft: &Draft) -> Vec<Problem> {
    let works = draft.switches.iter().flat_map(|switch| &switch.item.works);
    let known: BTreeSet<&str> = works.map(|work| work.name.as_str()).collect();
    let doors = draft.doors.iter().map(|door| door.map(|door| door.name.clone()));
    let movers = draft.movers.iter().map(|mover| mover.map(|mover| mover.solid.name.clone()));
    let streams = draft.streams.iter().map(|stream| stream.map(|stream| stream.name.clone()));
    let world = draft.world.iter().map(|solid| solid.map(|solid| solid.name.clone()));
    let links = draft.links.iter().map(|link| link.map(|link| link.name.clone()));
    let named = world.chain(movers).chain(doors).chain(streams).chain(links);
    named
        .filter_map(|placed| {
            let name = names_in(placed.item.as_deref()?).find(|name| !known.contains(name))?;
            let found = tr!("{name}, which no switch works", name = quoted(name));
            let meant = meant(name, known.iter().copied().take(MOST_NAMES));
            Some(placed.problem("name", found, tr("a row of switches.csv that works it").to_owned() + &meant))
        })
        .take(MOST_PROBLEMS)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{FILES, stray};

    #[test]
    fn a_name_is_refused_for_its_stem_and_never_for_the_ending_that_all_tables_share() {
        for own in ["notes", "foo", "plan", "tool", "scores", "inventory", "a", "todo", "levels", "history"] {
            let file = format!("{own}.csv");
            assert!(matches!(stray(&file), Some(Ok(_))), "{file}: {:?}", stray(&file));
        }
        for own in ["world.txt", "movers.md", "readme", "picture.png", "player.png", ".csv.new", "world"] {
            assert_eq!(stray(own), None, "{own}");
        }
        for (file, meant) in [
            ("wrold.csv", "world.csv"),
            ("player.CSV", "player.csv"),
            ("movers.cvs", "movers.csv"),
            ("Background.png", "background.png"),
            ("backgroud.PNG", "background.png"),
            ("constant.csv", "constants.csv"),
        ] {
            let Some(Err(problem)) = stray(file) else { panic!("{file}: {:?}", stray(file)) };
            assert_eq!(problem.expected, format!("the name {meant:?}"), "{file}");
        }
        assert!(FILES.iter().all(|file| stray(file).is_none()));
    }
}
