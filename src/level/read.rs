//! A level folder's files, put together: a valid level, or everything that is wrong with it.

use super::awards::{self, Awards};
use super::image::{Images, png_size};
use super::placement;
use super::problem::{Problem, quoted};
use super::quantity::{self as q, Quantity, Scale};
use super::rows::{self, ConstantRow, Placed};
use super::strength;
use super::table::{self, Layout, Record, Table, cell};
use super::types::{Fluid, Level, Object, Objective, ObjectiveKind, Player, SHIP_HEIGHT, SHIP_PIXELS, Solid, Stream, Text};
use crate::physics::{Aabb, DVec2};
use std::io;
use std::path::PathBuf;

/// The picture behind a level, in its folder.
pub(super) const BACKGROUND: &str = "background.png";

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
    pub world: Vec<Placed<Solid>>,
    /// Those of objects.csv, then the key objects.
    pub objects: Vec<Placed<Object>>,
    pub objectives: Vec<Placed<Objective>>,
    pub obstacles: Vec<Placed<Aabb>>,
    pub streams: Vec<Placed<Stream>>,
    pub fluids: Vec<Placed<Fluid>>,
    pub texts: Vec<Placed<Text>>,
}

/// Reads a level from its files. The paths in it are as the author wrote them: images from the project's folder, the background
/// from the level's.
///
/// # Errors
/// Every problem in every file, in the order of files and lines.
pub fn read(name: &str, files: &dyn Files) -> Result<Loaded, Vec<Problem>> {
    let mut reader = Reader { files, scale: Scale { metre: 1.0 }, problems: Vec::new(), warnings: Vec::new() };
    let constants = reader.constants();
    let background = reader.background();
    let size = match background {
        Some(size) => size.ok(),
        None => reader.plain_size(&constants),
    };
    let draft = reader.draft(size);
    reader.problems.extend(strength::check(&draft));
    reader.problems.extend(placement::check(&draft));
    let Reader { mut problems, mut warnings, .. } = reader;
    // A level without a readable player or size has a problem already.
    let (Some(player), Some(size), true) = (&draft.player, draft.size, problems.is_empty()) else {
        problems.sort_by_key(|problem| (file_order(&problem.file), problem.line));
        if problems.len() > table::MOST_PROBLEMS {
            problems.truncate(table::MOST_PROBLEMS);
            problems.extend(problems.last().map(|last| table::too_many(&last.file, last.line)));
        }
        return Err(problems);
    };
    warnings.extend(placement::warn(&draft, &player.item, size / draft.scale.metre));
    Ok(Loaded {
        level: Level {
            name: name.to_owned(),
            title: constants.title.clone().unwrap_or_else(|| name.to_owned()),
            metre: draft.scale.metre,
            size: size / draft.scale.metre,
            gravity: constants.gravity,
            air_density: constants.air_density,
            optimal_time: constants.optimal_time,
            rest_speed: constants.rest_speed,
            awards: constants.awards,
            player: player.item.clone(),
            world: items(draft.world),
            objects: items(draft.objects),
            objectives: items(draft.objectives),
            obstacles: items(draft.obstacles),
            streams: items(draft.streams),
            fluids: items(draft.fluids),
            texts: items(draft.texts),
            background: background.map(|_| PathBuf::from(BACKGROUND)),
        },
        warnings,
    })
}

/// The settings of constants.csv.
struct Constants {
    gravity: f64,
    air_density: f64,
    optimal_time: f64,
    rest_speed: f64,
    awards: Awards,
    title: Option<String>,
    width: Option<f64>,
    height: Option<f64>,
    /// Whether width and height are given, whatever they hold.
    sized: [bool; 2],
}

const CONSTANT_NAMES: [&str; 8] = ["gravity", "air_density", "optimal_time", "title", "metre", "rest_speed", "width", "height"];

/// All that constants.csv can name.
fn constant_names() -> impl Iterator<Item = &'static str> {
    CONSTANT_NAMES.into_iter().chain(awards::SETTINGS.map(|(name, _)| name))
}

struct Reader<'a> {
    files: &'a dyn Files,
    scale: Scale,
    problems: Vec<Problem>,
    warnings: Vec<Problem>,
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

    /// An optional file's rows.
    fn table(&mut self, layout: Layout) -> Table {
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

    /// Reads the constants, and sets the scale.
    fn constants(&mut self) -> Constants {
        let mut given: Vec<(&str, Record)> = Vec::new();
        for record in self.table(rows::CONSTANTS).records {
            let row: ConstantRow = record.row();
            let Some(name) = record.words(cell!(row.name), &mut self.problems) else { continue };
            let known = constant_names().find(|known| known.eq_ignore_ascii_case(&name));
            let Some(known) = known else {
                let expected = format!("one of {}", constant_names().collect::<Vec<_>>().join(", "));
                self.warnings.push(record.problem("name", format!("the unknown constant {}", quoted(&name)), expected));
                continue;
            };
            if given.iter().any(|(earlier, _)| *earlier == known) {
                self.problems.push(record.problem("name", format!("{} a second time", quoted(known)), "each constant once"));
            } else {
                given.push((known, record));
            }
        }
        let find = |name: &str| given.iter().find(|(given, _)| *given == name).map(|(_, record)| record);
        let metre = SHIP_PIXELS / SHIP_HEIGHT;
        let metre = self.constant(find("metre"), "metre", q::METRE).unwrap_or(metre);
        self.scale = Scale { metre };
        let size = self.scale.size();
        let awards = awards::SETTINGS.map(|(name, quantity)| Some((name, find(name)?, self.constant(find(name), name, quantity)?)));
        let awards = Awards::of(&awards.into_iter().flatten().collect::<Vec<_>>(), &mut self.problems);
        let mut constant = |name: &str, quantity: Quantity| self.constant(find(name), name, quantity);
        Constants {
            gravity: constant("gravity", q::GRAVITY).unwrap_or(15.0),
            air_density: constant("air_density", q::DENSITY).unwrap_or(1.2041),
            optimal_time: constant("optimal_time", q::OPTIMAL_TIME).unwrap_or(60.0),
            rest_speed: constant("rest_speed", q::REST_SPEED).unwrap_or(0.0),
            awards,
            title: find("title").and_then(value).filter(|title| !title.is_empty()),
            width: constant("width", size),
            height: constant("height", size),
            sized: ["width", "height"].map(|name| find(name).is_some()),
        }
    }

    /// The number in one row of constants.csv; `None` where it is not given or not accepted.
    fn constant(&mut self, record: Option<&Record>, name: &str, quantity: Quantity) -> Option<f64> {
        let record = record?;
        let text = value(record)?;
        let optional = matches!(name, "metre" | "rest_speed");
        if text.is_empty() && optional {
            return None;
        }
        let found = || if text.is_empty() { format!("nothing for {name}") } else { format!("{} for {name}", quoted(&text)) };
        quantity.parse(&text).map_err(|expected| self.problems.push(record.problem("value", found(), expected))).ok()
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
        Some(size.map_err(|(found, expected)| self.problems.push(Problem::new(BACKGROUND, 1, "image", found, expected))))
    }

    /// The size in pixels that constants.csv gives.
    fn plain_size(&mut self, constants: &Constants) -> Option<DVec2> {
        for (name, _) in ["width", "height"].into_iter().zip(constants.sized).filter(|(_, given)| !given) {
            let expected = format!("the level's {name} in pixels, as there is no {BACKGROUND}");
            self.problems.push(rows::CONSTANTS.problem(1, format!("no {name}"), expected));
        }
        Some(DVec2::new(constants.width?, constants.height?))
    }

    fn draft(&mut self, size: Option<DVec2>) -> Draft {
        let mut images = Images::new(self.files);
        let scale = self.scale;
        let player = self.player();
        let world = self.things(rows::WORLD, rows::solid);
        let mut objects = Vec::new();
        for record in self.table(rows::OBJECTS).records {
            let object = rows::object(&record, scale, &mut images, &mut self.problems);
            objects.extend(object.map(|object| Placed::new(&record, object)));
        }
        let objectives = self.objectives(&mut objects, &mut images);
        Draft {
            size,
            scale,
            player,
            world,
            objects,
            objectives,
            obstacles: self.things(rows::OBSTACLES, rows::rectangle),
            streams: self.things(rows::HAZARDS, rows::stream),
            fluids: self.things(rows::FLUIDS, rows::fluid),
            texts: self.things(rows::TEXTS, rows::text),
        }
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
            self.problems.push(rows::PLAYER.problem(*line, format!("row {}", i + 1), one));
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

/// What a row of constants.csv gives.
fn value(record: &Record) -> Option<String> {
    let ConstantRow { value, .. } = record.row();
    value.as_str().map(str::to_owned)
}

fn items<T>(placed: Vec<Placed<T>>) -> Vec<T> {
    placed.into_iter().map(|placed| placed.item).collect()
}

/// Problems are listed file by file, in the order in which levels.md names the files.
fn file_order(file: &str) -> usize {
    let files = ["constants.csv", "player.csv", "world.csv", "objects.csv", "objectives.csv", "obstacles.csv", "hazards.csv"];
    files.iter().position(|known| *known == file).unwrap_or(files.len())
}
