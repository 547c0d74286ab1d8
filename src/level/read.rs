//! A level folder's files, put together: a valid level, or everything that is wrong with it.

use super::constants::Constants;
use super::image::{Images, png_size};
use super::placement;
use super::problem::Problem;
use super::quantity::Scale;
use super::reach::Work;
use super::rows::{self, Placed};
use super::shade;
use super::strength;
use super::table::{self, Layout, Record, Table};
use super::types::{
    Decoration, Field, Fluid, Level, Mover, Object, Objective, ObjectiveKind, Player, Pod, Solid, Stream, Switch, Text,
};
use super::winnable;
use super::words;
use super::{blocks, extras, gates, names, power, pushed};
use crate::physics::{Aabb, DVec2};
use std::collections::BTreeSet;
use std::io;
use std::path::PathBuf;
use std::rc::Rc;

/// How many pairs of a shaded stream and a solid are looked at: some 10 ms.
const MOST_PAIRS: usize = 4_000_000;

/// The picture behind a level, in its folder.
pub const BACKGROUND: &str = "background.png";

/// Where the loader gets bytes from.
pub trait Files {
    /// A file of the level folder, by name.
    ///
    /// # Errors
    /// [`io::ErrorKind::NotFound`] where there is none; anything else where it cannot be read.
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>>;

    /// A file of the project, by its path from the project's folder with forward slashes.
    ///
    /// # Errors
    /// As [`Files::level_file`].
    fn project_file(&self, path: &str) -> io::Result<Vec<u8>>;

    /// The names of all files of the level folder, as far as they can be told.
    fn names(&self) -> Vec<String> {
        Vec::new()
    }
}

/// A level that can be played, and what is odd about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded {
    /// The level.
    pub level: Level,
    /// Things that are probably mistakes but harm nothing.
    pub warnings: Vec<Problem>,
}

/// What the files hold, as far as it could be read; in metres.
pub(super) struct Draft {
    /// Width and height in pixels.
    pub size: Option<DVec2>,
    pub scale: Scale,
    pub player: Option<Placed<Player>>,
    /// N/kg, downwards and to the right.
    pub gravity: [f64; 2],
    pub world: Vec<Placed<Solid>>,
    pub movers: Vec<Placed<Mover>>,
    pub doors: Vec<Placed<Solid>>,
    pub switches: Vec<Placed<Switch>>,
    /// Those of objects.csv, then the key objects.
    pub objects: Vec<Placed<Object>>,
    pub objectives: Vec<Placed<Objective>>,
    pub obstacles: Vec<Placed<Aabb>>,
    pub streams: Vec<Placed<Stream>>,
    pub fluids: Vec<Placed<Fluid>>,
    pub fields: Vec<Placed<Field>>,
    pub pods: Vec<Placed<Pod>>,
    pub decoration: Vec<Placed<Decoration>>,
    pub texts: Vec<Placed<Text>>,
}

/// Reads a level from its files. The paths in it are as the author wrote them: images from the project's folder, the background
/// from the level's.
///
/// # Errors
/// Every problem in every file, in the order of files and lines.
pub fn read(name: &str, files: &dyn Files) -> Result<Loaded, Vec<Problem>> {
    read_counting(name, files, &Rc::default())
}

/// As [`read()`]; what its searches cost is counted.
fn read_counting(name: &str, files: &dyn Files, work: &Rc<Work>) -> Result<Loaded, Vec<Problem>> {
    let Gathered { constants, background, draft, mut problems, mut warnings } = gather(files, false);
    problems.extend(names::check(&draft));
    problems.extend(strength::check(&draft));
    problems.extend(placement::check_zones(&draft));
    problems.extend(placement::check(&draft, work));
    // A level without a readable player or size has a problem already.
    let (Some(player), Some(size), true) = (&draft.player, draft.size, problems.is_empty()) else {
        return Err(in_order(problems));
    };
    let space = placement::space(&draft, size / draft.scale.metre, work.clone());
    let problems = winnable::check(&draft, &player.item, &space);
    if !problems.is_empty() {
        return Err(in_order(problems));
    }
    warnings.extend(names::warn(&draft));
    warnings.extend(winnable::same_turns(&draft));
    warnings.extend(words::warn(&draft, size / draft.scale.metre));
    warnings.extend(placement::warn(&draft, &player.item, &space));
    warnings.extend(gates::warn(&draft, &player.item, &constants, &space));
    warnings.extend(pushed::warn(&draft, &player.item, &constants, &space));
    warnings.extend(power::warn(&draft, player, &constants, &space));
    let (player, size) = (player.item.clone(), size / draft.scale.metre);
    Ok(Loaded { level: level(name, &constants, background, draft, player, size), warnings })
}

/// As [`read()`], of a level that is not finished: a ship and a size are enough. A row that cannot be read or placed is left out, an
/// object whose picture is missing is a box, and the problems stand among the warnings.
///
/// # Errors
/// Every problem, where there is no ship, no place for it or no size.
pub fn read_unfinished(name: &str, files: &dyn Files) -> Result<Loaded, Vec<Problem>> {
    let Gathered { constants, background, mut draft, mut problems, mut warnings } = gather(files, true);
    problems.extend(names::check(&draft));
    let mut misplaced = strength::check(&draft);
    misplaced.extend(placement::check_zones(&draft));
    misplaced.extend(placement::check(&draft, &Work::default()));
    draft.leave_out(&misplaced);
    problems.extend(misplaced);
    let (Some(player), Some(size)) = (&draft.player, draft.size) else { return Err(in_order(problems)) };
    warnings.splice(..0, in_order(problems));
    let (player, size) = (player.item.clone(), size / draft.scale.metre);
    Ok(Loaded { level: level(name, &constants, background, draft, player, size), warnings })
}

/// All that a level's files hold, each row judged by itself.
struct Gathered {
    constants: Constants,
    /// Whether there is a background.
    background: bool,
    draft: Draft,
    problems: Vec<Problem>,
    warnings: Vec<Problem>,
}

fn gather(files: &dyn Files, unfinished: bool) -> Gathered {
    let mut reader =
        Reader { files, unfinished, scale: Scale { metre: 1.0 }, pixels: 0, problems: Vec::new(), warnings: Vec::new() };
    reader.strays();
    let constants = reader.constants();
    let background = reader.background();
    if let Some(Ok(DVec2 { x, y })) = background {
        reader.pixels = (x * y) as u64;
    }
    let size = match background {
        Some(size) if size.is_ok() || !unfinished => {
            reader.sizes_that_are_not_used(&constants, size);
            size.ok()
        }
        _ => reader.plain_size(&constants),
    };
    let draft = reader.draft(size, [constants.gravity, constants.gravity_x]);
    let background = background.is_some_and(|size| size.is_ok());
    let Reader { problems, warnings, .. } = reader;
    Gathered { constants, background, draft, problems, warnings }
}

/// The problems by files and lines, and no more than anybody reads.
fn in_order(mut problems: Vec<Problem>) -> Vec<Problem> {
    problems.sort_by_key(|problem| (file_order(&problem.file), problem.line));
    if problems.len() > table::MOST_PROBLEMS {
        problems.truncate(table::MOST_PROBLEMS);
        problems.extend(problems.last().map(|last| table::too_many(&last.file, last.line)));
    }
    problems
}

/// The level of a draft, with its size in metres.
fn level(name: &str, constants: &Constants, background: bool, draft: Draft, player: Player, size: DVec2) -> Level {
    Level {
        name: name.to_owned(),
        title: constants.title.clone().unwrap_or_else(|| name.to_owned()),
        metre: draft.scale.metre,
        size,
        gravity: constants.gravity,
        gravity_x: constants.gravity_x,
        air_density: constants.air_density,
        optimal_time: constants.optimal_time,
        rest_speed: constants.rest_speed,
        friction: constants.friction,
        experiment: constants.experiment,
        awards: constants.awards,
        player,
        world: items(draft.world),
        movers: items(draft.movers),
        doors: items(draft.doors),
        switches: items(draft.switches),
        objects: items(draft.objects),
        objectives: items(draft.objectives),
        obstacles: items(draft.obstacles),
        streams: items(draft.streams),
        fluids: items(draft.fluids),
        fields: items(draft.fields),
        pods: items(draft.pods),
        decoration: items(draft.decoration),
        texts: items(draft.texts),
        background: background.then(|| PathBuf::from(BACKGROUND)),
    }
}

impl Draft {
    /// Leaves out every row that one of the problems names.
    fn leave_out(&mut self, problems: &[Problem]) {
        let rows: BTreeSet<(&str, usize)> = problems.iter().map(|problem| (problem.file.as_str(), problem.line)).collect();
        fn keep<T>(things: &mut Vec<Placed<T>>, rows: &BTreeSet<(&str, usize)>) {
            things.retain(|thing| !rows.contains(&(thing.file, thing.line)));
        }
        self.player = self.player.take().filter(|ship| !rows.contains(&(ship.file, ship.line)));
        keep(&mut self.objects, &rows);
        keep(&mut self.movers, &rows);
        keep(&mut self.streams, &rows);
        keep(&mut self.fluids, &rows);
        keep(&mut self.fields, &rows);
    }
}

/// What is being read, and what has been found out.
pub(super) struct Reader<'a> {
    files: &'a dyn Files,
    /// Whether what is missing may be missing.
    unfinished: bool,
    pub scale: Scale,
    /// Of the background.
    pixels: u64,
    pub problems: Vec<Problem>,
    pub warnings: Vec<Problem>,
}

impl Reader<'_> {
    /// A file's bytes; `None` where there is none or where it cannot be read, which is reported.
    fn bytes(&mut self, layout: Layout) -> Option<Vec<u8>> {
        match self.files.level_file(layout.file) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => {
                self.problems.push(layout.problem(1, format!("a file that cannot be read ({error})"), "a readable file"));
                None
            }
        }
    }

    /// Names what lies in the folder and is no file of a level.
    fn strays(&mut self) {
        for file in self.files.names() {
            match names::stray(&file) {
                Some(Err(problem)) => self.problems.push(problem),
                Some(Ok(warning)) => self.warnings.push(warning),
                None => {}
            }
        }
    }

    /// An optional file's rows.
    pub fn table(&mut self, layout: Layout) -> Table {
        let Some(bytes) = self.bytes(layout) else { return Table::default() };
        let table = table::read(layout, &bytes, &mut self.problems);
        if table.lines.is_empty() {
            self.warnings.push(layout.problem(1, "no row in the file", "at least one row, or no file"));
        }
        table
    }

    /// An optional file's things.
    fn things<T>(&mut self, layout: Layout, read: impl Fn(&Record, Scale, &mut Vec<Problem>) -> Option<T>) -> Vec<Placed<T>> {
        let records = self.table(layout).records;
        records.iter().filter_map(|record| Some(Placed::new(record, read(record, self.scale, &mut self.problems)?))).collect()
    }

    /// The size of background.png in pixels: `None` where there is none, `Err` where it is refused.
    fn background(&mut self) -> Option<Result<DVec2, ()>> {
        let bytes = self.files.level_file(BACKGROUND);
        if bytes.as_ref().is_err_and(|error| error.kind() == io::ErrorKind::NotFound) {
            return None;
        }
        let size = png_size(bytes, BACKGROUND).and_then(|(width, height)| {
            for side in [width, height] {
                let range = self.scale.size();
                range.parse(&side.to_string()).map_err(|expected| (format!("an image side of {side} pixels"), expected))?;
            }
            Ok(DVec2::new(width, height))
        });
        Some(size.map_err(|(found, expected)| self.problems.push(Problem::of_file(BACKGROUND, found, expected))))
    }

    /// Says so where constants.csv gives another size than the background.
    fn sizes_that_are_not_used(&mut self, constants: &Constants, background: Result<DVec2, ()>) {
        let Ok(DVec2 { x, y }) = background else { return };
        for (name, given, used) in [("width", constants.width, x), ("height", constants.height, y)] {
            if let Some(given) = given.filter(|given| *given != used) {
                let expected = format!("{used}, the {name} of {BACKGROUND}, which is used");
                self.warnings.push(rows::CONSTANTS.problem(1, format!("a {name} of {given}"), expected));
            }
        }
    }

    /// The size in pixels that constants.csv gives.
    fn plain_size(&mut self, constants: &Constants) -> Option<DVec2> {
        for (name, _) in ["width", "height"].into_iter().zip(constants.sized).filter(|(_, given)| !given) {
            let expected = format!("the level's {name} in pixels, as there is no {BACKGROUND}");
            self.problems.push(rows::CONSTANTS.problem(1, format!("no {name}"), expected));
        }
        Some(DVec2::new(constants.width?, constants.height?))
    }

    fn draft(&mut self, size: Option<DVec2>, gravity: [f64; 2]) -> Draft {
        let mut images = Images::new(self.files, self.pixels, self.unfinished);
        let scale = self.scale;
        let player = self.player();
        let world = self.things(blocks::WORLD, blocks::solid);
        let mut objects = Vec::new();
        for record in self.table(rows::OBJECTS).records {
            let object = rows::object(&record, scale, &mut images, &mut self.problems);
            objects.extend(object.map(|object| Placed::new(&record, object)));
        }
        let objectives = self.objectives(&mut objects, &mut images);
        let streams = self.streams(&world);
        let mut decoration = Vec::new();
        for record in self.table(extras::DECORATION).records {
            let picture = extras::decoration(&record, scale, &mut images, &mut self.problems);
            decoration.extend(picture.map(|picture| Placed::new(&record, picture)));
        }
        Draft {
            size,
            scale,
            gravity,
            player,
            world,
            movers: self.things(blocks::MOVERS, blocks::mover),
            doors: self.things(blocks::DOORS, blocks::solid),
            switches: self.things(blocks::SWITCHES, blocks::switch),
            objects,
            objectives,
            obstacles: self.things(rows::OBSTACLES, rows::rectangle),
            streams,
            fluids: self.things(rows::FLUIDS, rows::fluid),
            fields: self.things(extras::GRAVITY, extras::field),
            pods: self.things(extras::PODS, extras::pod),
            decoration,
            texts: self.things(rows::TEXTS, rows::text),
        }
    }

    /// The streams; those that are shaded end at the first solid in their way.
    fn streams(&mut self, world: &[Placed<Solid>]) -> Vec<Placed<Stream>> {
        let mut streams = Vec::new();
        let mut pairs = 0;
        for placed in self.things(rows::HAZARDS, rows::stream) {
            let (mut stream, shaded) = placed.item.clone();
            pairs += if shaded { world.len() } else { 0 };
            if pairs > MOST_PAIRS {
                let found = format!("one more shaded stream beside {} solids", world.len());
                let expected = format!(
                    "at most {} in this level: shaded streams times solids are at most {MOST_PAIRS}",
                    MOST_PAIRS / world.len()
                );
                self.problems.push(placed.problem("shaded", found, expected));
                break;
            }
            if shaded {
                let solids = world.iter().map(|solid| solid.item.bounds);
                match shade::shaded(&stream, solids) {
                    Some(zone) => stream.zone = zone,
                    None => self.problems.push(placed.problem(
                        "shaded",
                        "TRUE, with a solid right before the source block",
                        "free space before it",
                    )),
                }
            }
            streams.push(placed.map(|_| stream));
        }
        streams
    }

    /// Exactly one row of player.csv.
    fn player(&mut self) -> Option<Placed<Player>> {
        let one = "exactly one row with the ship";
        let before = self.problems.len();
        let Some(bytes) = self.bytes(rows::PLAYER) else {
            if self.problems.len() == before {
                self.problems.push(rows::PLAYER.problem(1, "no file", one));
            }
            return None;
        };
        let table = table::read(rows::PLAYER, &bytes, &mut self.problems);
        if table.lines.is_empty() {
            self.problems.push(rows::PLAYER.problem(1, "no row", one));
        }
        for (i, line) in table.lines.iter().enumerate().skip(1) {
            let found = format!("{} row", if i == 1 { "a second" } else { "one more" });
            self.problems.push(rows::PLAYER.problem(*line, found, one));
        }
        let mut players = Vec::new();
        for record in &table.records {
            players.push(rows::player(record, self.scale, &mut self.problems).map(|player| Placed::new(record, player)));
        }
        players.into_iter().next().flatten()
    }

    /// The objective blocks; the key objects go behind `objects`.
    fn objectives(&mut self, objects: &mut Vec<Placed<Object>>, images: &mut Images) -> Vec<Placed<Objective>> {
        let wanted = "at least one PLAYER or PHYS row";
        let before = self.problems.len();
        let Some(bytes) = self.bytes(rows::BLOCKS) else {
            if self.problems.len() == before {
                self.problems.push(rows::BLOCKS.problem(1, "no file", wanted));
            }
            return Vec::new();
        };
        let table = table::read_by_kind(rows::BLOCKS, rows::objective_layout, &bytes, &mut self.problems);
        let mut objectives = Vec::new();
        let (mut first_physics, mut blocks, mut keys) = (None, 0, 0);
        for record in &table.records {
            let Some(kind) = rows::objective_kind(record) else {
                keys += 1;
                let object = rows::object(record, self.scale, images, &mut self.problems);
                objects.extend(object.map(|object| Placed::new(record, object)));
                continue;
            };
            blocks += 1;
            if kind == ObjectiveKind::Physics {
                first_physics.get_or_insert(record);
            }
            let objective = rows::objective(kind, record, self.scale, &mut self.problems);
            objectives.extend(objective.map(|objective| Placed::new(record, objective)));
        }
        // A row that could not be read may be what is missing: then its own problem is enough.
        let all_read = table.records.len() == table.lines.len();
        if blocks == 0 && all_read {
            self.problems.push(rows::BLOCKS.problem(1, "no objective", wanted));
        }
        if let (Some(record), 0, true) = (first_physics, keys, all_read) {
            self.problems.push(record.problem("kind", "PHYS without any key object", "at least one OBJECT row"));
        }
        objectives
    }
}

fn items<T>(placed: Vec<Placed<T>>) -> Vec<T> {
    placed.into_iter().map(|placed| placed.item).collect()
}

/// Problems are listed file by file, in the order in which levels.md names the files.
fn file_order(file: &str) -> usize {
    names::FILES.iter().position(|known| *known == file).unwrap_or(names::FILES.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Files in memory.
    struct Held(Vec<(&'static str, String)>);

    impl Files for Held {
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

    fn level(files: &[(&'static str, String)]) -> (Result<Loaded, Vec<Problem>>, u64) {
        let own = [
            ("constants.csv", "width,100000\nheight,100000\n".to_owned()),
            ("player.csv", "50000,99900,100,500,3000\n".to_owned()),
            ("objectives.csv", "PLAYER,99000,99000,10,10\n".to_owned()),
        ];
        let work = Rc::new(Work::default());
        let given = files.iter().cloned().chain(own.into_iter().filter(|(own, _)| files.iter().all(|(file, _)| file != own)));
        (read_counting("l", &Held(given.collect()), &work), work.spent())
    }

    /// Tables as large as they may be, of things that lie apart, in rows, all in one place, and across each other.
    #[test]
    fn tables_at_their_limit_are_checked_in_bounded_work() {
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
            let (_, work) = level(&[("world.csv", full(world)), ("objects.csv", objects), ("objectives.csv", keys)]);
            assert!(work <= 2 * super::super::reach::MOST_WORK, "{work}");
        }
        // All in one place: the check stops at the most problems that are listed.
        let heap = full(|_| "500,500,box:40x40,1,1,FALSE,0\n".to_owned());
        let rows = heap.lines().count() as u64;
        let (heaped, work) = level(&[("objects.csv", heap)]);
        assert!(heaped.is_err_and(|problems| problems.len() <= table::MOST_PROBLEMS + 1));
        assert!(work <= (rows + 1) * (table::MOST_PROBLEMS as u64 + 5), "{work} for {rows} rows");
        // Side by side: a few looks a row.
        let rows = |i: usize| format!("{},{},box:40x40,1,1,FALSE,0\n", i % 2400 * 40 + 20, i / 2400 * 40 + 20);
        let objects = full(rows);
        let count = objects.lines().count() as u64;
        let (side_by_side, _) = level(&[("objects.csv", objects)]);
        assert!(side_by_side.is_ok(), "{count} rows");
    }

    #[test]
    fn what_would_take_too_long_is_refused_in_words() {
        let floors = full(|i| format!("{},99990,1,1\n", i % 90000));
        let streams = full(|i| format!("{},5,9,9,0,90,0,1,TRUE\n", 20 * i));
        let (shaded, _) = level(&[("world.csv", floors), ("hazards.csv", streams)]);
        let told = shaded.unwrap_err().iter().map(ToString::to_string).collect::<String>();
        assert!(told.contains("one more shaded stream beside ") && told.contains("are at most 4000000"), "{told}");
        let doors = full(|i| format!("{},5,9,9,gate\n", 20 * i));
        let switches = full(|i| format!("{},55,9,9,gate\n", 20 * i));
        let (wired, _) = level(&[("doors.csv", doors), ("switches.csv", switches)]);
        let told = wired.unwrap_err().iter().map(ToString::to_string).collect::<String>();
        assert!(
            told.starts_with("switches.csv:1: column \"works\": found ") && told.ends_with("at most 100000 in a level"),
            "{told}"
        );
    }
}
