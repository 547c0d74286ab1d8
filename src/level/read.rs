//! A level folder's files, put together: a valid level, or all its problems.

use super::draft::{Draft, LevelReader};
use super::image::{BACKGROUND, Files, png_size};
use super::names::{self, Stray};
use super::problem::{MOST_PROBLEMS, Problem, too_many};
use super::schema::settings::{LevelSettings, SETTING, settings};
use super::schema::{FILES, Table};
use super::winnable::{self, Checked};
use super::{certain, links, placement, types::Level};
use crate::{physics::DVec2, words::tr};
use std::io;

#[derive(Clone, Debug, PartialEq)]
pub struct Loaded {
    pub level: Level,
    /// Probable mistakes that do no harm.
    pub warnings: Vec<Problem>,
    /// The files that are no UTF-8 with commas, and what they are instead.
    pub dialects: Vec<(&'static str, String)>,
}

/// The paths in the level are as the author wrote them: images from the project's folder, the background from the level's.
/// Errors: every problem in every file, in the order of files and lines.
pub fn read(name: &str, files: &dyn Files) -> Result<Loaded, Vec<Problem>> {
    let Gathered { background, draft, dialects, unused_sizes, mut problems, mut warnings } = gather(files, false);
    // A thing outside of the level may stand where the author takes another size.
    let refused = |problems: Vec<Problem>| Err(in_order(problems.into_iter().chain(unused_sizes).collect()));
    problems.extend(names::check(&draft));
    problems.extend(links::check(&draft));
    problems.extend(links::check_strength(&draft));
    problems.extend(placement::check_zones(&draft));
    problems.extend(placement::check(&draft));
    // A level without a readable player or size has a problem already.
    let (true, Some(size), true) = (draft.may_start(), draft.size, problems.is_empty()) else {
        return refused(problems);
    };
    let size = size / draft.scale.metre;
    warnings.extend(names::warn(&draft));
    if let Some(ship) = &draft.player {
        let space = placement::space(&draft, size);
        let checked = Checked { draft: &draft, ship, size, space: &space };
        let problems = winnable::check(&checked);
        if !problems.is_empty() {
            return refused(problems);
        }
        warnings.extend(certain::warn(&checked));
    }
    Ok(Loaded { level: draft.level(name, background, size), warnings, dialects })
}

/// As [`read()`], of an unfinished level: a ship and a size are enough. A row that cannot be read or placed is left out, an object whose picture is
/// missing is a box, and the problems stand among the warnings. Errors: every problem of a level without a ship, a place for it or a size.
pub fn read_unfinished(name: &str, files: &dyn Files) -> Result<Loaded, Vec<Problem>> {
    let Gathered { background, mut draft, dialects, mut problems, mut warnings, .. } = gather(files, true);
    problems.extend(names::check(&draft));
    let mut misplaced = links::check_strength(&draft);
    misplaced.extend(placement::check_zones(&draft));
    misplaced.extend(placement::check(&draft));
    draft.leave_out(&misplaced);
    problems.extend(misplaced);
    let (true, Some(size)) = (draft.may_start(), draft.size) else { return Err(in_order(problems)) };
    warnings.splice(..0, in_order(problems));
    let size = size / draft.scale.metre;
    Ok(Loaded { level: draft.level(name, background, size), warnings, dialects })
}

struct Gathered {
    background: bool,
    draft: Draft,
    dialects: Vec<(&'static str, String)>,
    /// Among the warnings.
    unused_sizes: Vec<Problem>,
    problems: Vec<Problem>,
    warnings: Vec<Problem>,
}

fn gather(files: &dyn Files, unfinished: bool) -> Gathered {
    let mut reader = LevelReader::new(files, unfinished);
    let look_alikes = strays(&mut reader);
    let rows = reader.table(Table::Constants).records;
    let settings = settings(rows, &mut reader.rows, &mut reader.warnings);
    let background = background(&mut reader);
    if let Some(Ok(DVec2 { x, y })) = background {
        reader.rows.images.pixels = (x * y) as u64;
    }
    let mut unused_sizes = Vec::new();
    let size = match background {
        Some(size) if size.is_ok() || !unfinished => {
            let size = size.ok();
            unused_sizes = size.map_or_else(Vec::new, |size| sizes_that_are_not_used(&settings, size));
            size
        }
        _ => plain_size(&settings, &mut reader),
    };
    reader.warnings.extend(unused_sizes.iter().cloned());
    let draft = Draft::read(&mut reader, size, settings);
    for (known, problem) in look_alikes {
        // A level that is refused for want of a file names the one that looks like it.
        let wanted = if known == BACKGROUND {
            size.is_none()
        } else {
            reader.rows.problems.iter().any(|problem| problem.file == known && problem.found == tr("no file"))
        };
        if wanted { &mut reader.rows.problems } else { &mut reader.warnings }.push(problem);
    }
    let background = background.is_some_and(|size| size.is_ok());
    Gathered {
        background,
        draft,
        dialects: reader.dialects,
        unused_sizes,
        problems: reader.rows.problems,
        warnings: reader.warnings,
    }
}

/// Tells files that no level has; the answer is those that look like a file of a level.
fn strays(reader: &mut LevelReader) -> Vec<(&'static str, Problem)> {
    let (names, mut look_alikes) = (reader.files.names(), Vec::new());
    for file in &names {
        match names::stray(file, &names) {
            Some(Stray::Misspelt(problem)) => reader.rows.problems.push(problem),
            Some(Stray::LookAlike(known, problem)) => look_alikes.push((known, problem)),
            Some(Stray::Other(warning)) => reader.warnings.push(warning),
            None => {}
        }
    }
    reader.warnings.extend(names::misnamed_flights(&reader.files.flights()));
    look_alikes
}

/// The size of background.png in pixels: `None` where there is none, `Err` where it is refused.
fn background(reader: &mut LevelReader) -> Option<Result<DVec2, ()>> {
    let bytes = reader.files.level_file(BACKGROUND);
    if bytes.as_ref().is_err_and(|error| error.kind() == io::ErrorKind::NotFound) {
        return None;
    }
    let range = reader.rows.scale.size();
    let size = png_size(bytes, BACKGROUND).and_then(|(width, height)| {
        for side in [width, height] {
            range.judge(side).map_err(|expected| (tr!("an image side of {side} pixels", side), expected))?;
        }
        Ok(DVec2::new(width, height))
    });
    Some(size.map_err(|(found, expected)| reader.rows.problems.push(Problem::of_file(BACKGROUND, found, expected))))
}

/// Where constants.csv gives another size than the background.
fn sizes_that_are_not_used(settings: &LevelSettings, background: DVec2) -> Vec<Problem> {
    let sides = [("width", settings.row.width, background.x), ("height", settings.row.height, background.y)];
    let unused = sides.into_iter().filter_map(|(name, given, used)| Some((name, given.filter(|given| *given != used)?, used)));
    let problem = |(name, given, used)| {
        let expected = tr!("{used}, the {name} of {background}, which is used", used, name, background = BACKGROUND);
        SETTING.problem(1, tr!("a {name} of {given}", name, given), expected)
    };
    unused.map(problem).collect()
}

fn plain_size(settings: &LevelSettings, reader: &mut LevelReader) -> Option<DVec2> {
    for name in ["width", "height"].into_iter().filter(|name| settings.given.text(name).is_none()) {
        let expected = tr!("the level's {name} in pixels, as there is no {background}", name, background = BACKGROUND);
        reader.rows.problems.push(SETTING.problem(1, tr!("no {column}", column = name), expected));
    }
    Some(DVec2::new(settings.row.width?, settings.row.height?))
}

/// The problems by files and lines, and at most [`MOST_PROBLEMS`] of them.
fn in_order(mut problems: Vec<Problem>) -> Vec<Problem> {
    let order = |file: &str| FILES.iter().position(|known| *known == file).unwrap_or(FILES.len());
    problems.sort_by_key(|problem| (order(&problem.file), problem.line));
    if problems.len() > MOST_PROBLEMS {
        problems.truncate(MOST_PROBLEMS);
        problems.extend(problems.last().map(|last| too_many(&last.file, last.line)));
    }
    problems
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Texts(Vec<(&'static str, String)>);

    impl Files for Texts {
        fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
            let file = self.0.iter().find(|(file, _)| *file == name);
            file.map(|(_, text)| text.clone().into_bytes()).ok_or_else(|| io::ErrorKind::NotFound.into())
        }

        fn project_file(&self, _: &str) -> io::Result<Vec<u8>> {
            Err(io::ErrorKind::NotFound.into())
        }
    }

    /// Rows until a file is as large as one may be.
    fn full(row: impl Fn(usize) -> String) -> String {
        let mut text = String::new();
        for i in 0.. {
            let row = row(i);
            if (text.len() + row.len()) as u64 > crate::files::LEVEL_TABLE {
                break;
            }
            text += &row;
        }
        text
    }

    fn level(files: &[(&'static str, String)]) -> Result<Loaded, Vec<Problem>> {
        let own = [
            ("constants.csv", "width,100000\nheight,100000\n".to_owned()),
            ("player.csv", "50000,99900,100,500,3000\n".to_owned()),
            ("objectives.csv", "PLAYER,99000,99000,10,10\n".to_owned()),
        ];
        let given = files.iter().cloned().chain(own.into_iter().filter(|(own, _)| files.iter().all(|(file, _)| file != own)));
        read("l", &Texts(given.collect()))
    }

    /// Tables as large as they may be, of things that lie apart, in rows, all in one place, and across each other: a look at each pair would take
    /// minutes.
    #[test]
    fn tables_at_their_limit_are_checked() {
        let spread = |i: usize| (i % 150 * 600, i / 150 * 600);
        let worlds: [fn(usize) -> String; 3] = [
            |i| format!("{},{},9,9\n", i % 150 * 600 + 300, i / 150 * 600),
            |i| format!("{},0,1,90000\n", 3 * i),
            |_| "5,5,9,9\n".to_owned(),
        ];
        for world in worlds {
            let objects = full(|i| format!("{},{},box:40x40,1,1,FALSE,0\n", spread(i).0 + 30, spread(i).1 + 30));
            let keys = full(|i| {
                format!("OBJECT,{},{},box:40x40,1,1,1,1,0,1\nPHYS,{},5,9,9\n", spread(i).0 + 90, spread(i).1 + 30, 20 * i)
            });
            let loaded = level(&[("world.csv", full(world)), ("objects.csv", objects), ("objectives.csv", keys)]);
            assert!(loaded.map_or_else(|problems| problems.len() <= MOST_PROBLEMS + 1, |_| true));
        }
        // All in one place: the check stops at the most problems that are listed.
        let heaped = level(&[("objects.csv", full(|_| "500,500,box:40x40,1,1,FALSE,0\n".to_owned()))]);
        assert!(heaped.is_err_and(|problems| problems.len() == MOST_PROBLEMS + 1));
        let rows = |i: usize| format!("{},{},box:40x40,1,1,FALSE,0\n", i % 2400 * 40 + 20, i / 2400 * 40 + 20);
        assert!(level(&[("objects.csv", full(rows))]).is_ok(), "side by side");
    }

    #[test]
    fn what_would_take_too_long_is_refused_in_words() {
        let floors = full(|i| format!("{},99990,1,1\n", i % 90000));
        let streams = full(|i| format!("{},5,9,9,0,90,0,1,TRUE\n", 20 * i));
        let shaded = level(&[("world.csv", floors), ("hazards.csv", streams)]);
        let problems = shaded.unwrap_err().iter().map(ToString::to_string).collect::<String>();
        assert!(problems.contains("one more shaded stream beside ") && problems.contains("are at most 4000000"), "{problems}");
        let doors = full(|i| format!("{},5,9,9,gate\n", 20 * i));
        let switches = full(|i| format!("{},55,9,9,gate\n", 20 * i));
        let wired = level(&[("doors.csv", doors), ("switches.csv", switches)]);
        let problems = wired.unwrap_err().iter().map(ToString::to_string).collect::<String>();
        assert!(
            problems.starts_with("switches.csv:1: column \"works\": found ") && problems.ends_with("at most 100000 in a level"),
            "{problems}"
        );
    }
}
