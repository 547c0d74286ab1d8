//! Names: those of the files in a level's folder, and those of the things that its switches work.

use super::problem::{MOST_PROBLEMS, Problem, at_most, meant, nearest, quoted};
use super::{draft::Draft, image::BACKGROUND, schema::FILES, schema::typed::FromRow, wiring::names_in};
use crate::words::tr;
use std::collections::{BTreeMap, BTreeSet};

/// A file that no level has, among the `names` in a level's folder.
pub(super) enum Stray {
    /// A table misspelt, where the level has none of the right name.
    Misspelt(Problem),
    /// A file that only looks like that one, by its ending: it is not read.
    LookAlike(&'static str, Problem),
    /// A copy of a table that is there, or another table.
    Other(Problem),
}

/// Files that are no tables are the author's own.
pub(super) fn stray(file: &str, names: &[String]) -> Option<Stray> {
    if FILES.contains(&file) {
        return None;
    }
    let problem = |expected: String| Problem::of_file(file, tr("a file that no level has"), expected);
    let named = |known: &str| tr!("the name {known}", known = format_args!("{known:?}"));
    let is_there = |known: &str| names.iter().any(|name| name == known);
    if let Some(known) = look_alike(file) {
        return Some(Stray::LookAlike(known, problem(named(known))));
    }
    match meant_file(file) {
        Some(known) if is_there(known) => Some(Stray::Other(problem(tr!("{known} alone: it is the file that is read", known)))),
        Some(known) => Some(Stray::Misspelt(problem(named(known)))),
        None if !file.to_lowercase().ends_with(".csv") => None,
        None => {
            // `world (1).csv`, `world - Kopie.csv`, `world_old.csv`.
            let more = |known: &str| file.strip_prefix(known.trim_end_matches(".csv"));
            let is_copy = |known: &str| more(known).is_some_and(|more| more.starts_with(|c: char| !c.is_alphanumeric()));
            Some(Stray::Other(problem(match FILES.into_iter().find(|known| is_there(known) && is_copy(known)) {
                Some(known) => tr!("{known} alone: it is the file that is read", known),
                None => tr!("one of {list}", list = FILES.join(", ")),
            })))
        }
    }
}

/// The file whose name a system or a program has given another ending: `world.csv.txt`, `background.jpg`, `Background.PNG`.
fn look_alike(file: &str) -> Option<&'static str> {
    const PICTURES: [&str; 7] = ["png", "jpg", "jpeg", "bmp", "gif", "webp", "tiff"];
    let file = file.to_lowercase();
    let (stem, ending) = file.rsplit_once('.')?;
    let is_picture = BACKGROUND.starts_with(&format!("{stem}.")) && PICTURES.contains(&ending);
    let table = |known: &&str| stem == *known && ending == "txt";
    FILES.into_iter().find(|known| table(known) || *known == BACKGROUND && is_picture)
}

/// The most flights of a wrong name among the warnings.
const MOST_FLIGHTS: usize = 20;

/// The files in a level's folder `flights` that look like flights, and are none for their names.
pub(super) fn misnamed_flights(names: &[String]) -> Vec<Problem> {
    let is_slip = |name: &&String| {
        let name = name.to_lowercase();
        !name.starts_with('.') && !name.ends_with(".replay.csv") && [".csv", ".replay"].iter().any(|part| name.contains(part))
    };
    let slips = names.iter().filter(is_slip).take(MOST_FLIGHTS);
    let problem = |name: &String| {
        let replay = format!("\"{}.replay.csv\"", name.split('.').next().unwrap_or_default());
        let expected = tr!("a name such as {name}", name = replay);
        Problem::of_file(&format!("flights/{name}"), tr("a file that is no flight by its name"), expected)
    };
    slips.map(problem).collect()
}

/// The file that a name misspells: stem and ending are each near enough, whatever the case; the ending alone, which all tables share, is not.
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

pub(super) fn warn(draft: &Draft) -> Vec<Problem> {
    let works = draft.switches.iter().flat_map(|switch| &switch.item.works);
    let known: BTreeSet<&str> = works.map(|work| work.name.as_str()).collect();
    let doors = draft.doors.iter().map(|door| door.map(|door| door.name.clone()));
    let movers = draft.movers.iter().map(|mover| mover.map(|mover| mover.solid.name.clone()));
    let streams = draft.streams.iter().map(|stream| stream.map(|stream| stream.name.clone()));
    let world = draft.world.iter().map(|solid| solid.map(|solid| solid.name.clone()));
    let links = draft.links.iter().map(|link| link.map(|link| link.name.clone()));
    let warning = |placed: FromRow<Option<String>>| {
        let name = names_in(placed.item.as_deref()?).find(|name| !known.contains(name))?;
        let found = tr!("{name}, which no switch works", name = quoted(name));
        let meant = meant(name, known.iter().copied().take(MOST_NAMES));
        Some(placed.problem("name", found, tr("a row of switches.csv that works it").to_owned() + &meant))
    };
    world.chain(movers).chain(doors).chain(streams).chain(links).filter_map(warning).take(MOST_PROBLEMS).collect()
}

#[cfg(test)]
mod tests {
    use super::{FILES, Stray, misnamed_flights, stray};

    fn expected(file: &str, names: &[&str]) -> Option<(&'static str, String)> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
        stray(file, &names).map(|stray| match stray {
            Stray::Misspelt(problem) => ("misspelt", problem.expected),
            Stray::LookAlike(_, problem) => ("alike", problem.expected),
            Stray::Other(problem) => ("other", problem.expected),
        })
    }

    #[test]
    fn a_name_is_refused_for_its_stem_and_never_for_the_ending_that_all_tables_share() {
        for own in ["notes", "foo", "plan", "tool", "scores", "inventory", "a", "todo", "levels", "history"] {
            let file = format!("{own}.csv");
            assert!(expected(&file, &[]).is_some_and(|(kind, _)| kind == "other"), "{file}");
        }
        for own in ["world.txt", "movers.md", "readme", "picture.png", "player.png", ".csv.new", "world", "world.csv.bak"] {
            assert_eq!(expected(own, &[]), None, "{own}");
        }
        for (file, meant) in [
            ("wrold.csv", "world.csv"),
            ("player.CSV", "player.csv"),
            ("movers.cvs", "movers.csv"),
            ("backgroud.PNG", "background.png"),
            ("constant.csv", "constants.csv"),
        ] {
            assert_eq!(expected(file, &[]), Some(("misspelt", format!("the name {meant:?}"))), "{file}");
        }
        assert!(FILES.iter().all(|file| expected(file, &[]).is_none()));
    }

    #[test]
    fn copies_and_files_with_another_ending_are_named_and_refuse_no_level() {
        for copy in ["world2.csv", "worlds.csv", "world (1).csv", "world - Kopie.csv", "world-old.csv"] {
            let alone = "world.csv alone: it is the file that is read".to_owned();
            assert_eq!(expected(copy, &["world.csv"]), Some(("other", alone)), "{copy}");
        }
        for (file, meant) in
            [("world.csv.txt", "world.csv"), ("background.jpg", "background.png"), ("Background.PNG", "background.png")]
        {
            assert_eq!(expected(file, &[]), Some(("alike", format!("the name {meant:?}"))), "{file}");
        }
        let names = ["gold.csv", "a.replay.csv", ".hidden.csv", "notes.txt", "b.replay.csv.txt"].map(str::to_owned);
        let problems: Vec<String> = misnamed_flights(&names).iter().map(ToString::to_string).collect();
        assert_eq!(
            problems,
            [
                "flights/gold.csv: found a file that is no flight by its name, expected a name such as \"gold.replay.csv\"",
                "flights/b.replay.csv.txt: found a file that is no flight by its name, expected a name such as \"b.replay.csv\"",
            ]
        );
    }
}
