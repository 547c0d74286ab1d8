//! The reader of a level's files, and their things, row by row, before the checks of the whole level.

use super::image::{self, BACKGROUND, Files, Images};
use super::problem::{Problem, at_most};
use super::schema::blocks::{self, UnboundLink};
use super::schema::typed::{FromRow, RowCells, RowReader};
use super::schema::{Table, bodies, zones};
use super::table::{self, TableRows};
use super::types::{
    AirStream, Decoration, Fluid, GravityZone, Level, Mark, Mover, Object, Objective, ObjectiveKind, Pod, ShipStart, Solid, Star,
    Switch, Text,
};
use super::{numbers::PixelScale, schema::settings::LevelSettings};
use crate::physics::{Aabb, DVec2};
use crate::words::tr;
use std::{collections::BTreeSet, io, path::PathBuf};

/// The most pairs of a shaded stream and a solid: some 10 ms.
const MOST_PAIRS: usize = 4_000_000;

pub(super) struct LevelReader<'a> {
    pub files: &'a dyn Files,
    pub rows: RowReader<'a>,
    pub warnings: Vec<Problem>,
    /// In words, of the files that are no UTF-8 with commas.
    pub dialects: Vec<(&'static str, String)>,
}

impl<'a> LevelReader<'a> {
    /// In an unfinished level a box stands in for a missing picture.
    pub fn new(files: &'a dyn Files, unfinished: bool) -> Self {
        let rows = RowReader { scale: PixelScale::USUAL, images: Images::new(files, unfinished), problems: Vec::new() };
        Self { files, rows, warnings: Vec::new(), dialects: Vec::new() }
    }

    /// `None` where there is no such file, or where it cannot be read, which is reported.
    fn bytes(&mut self, table: Table) -> Option<Vec<u8>> {
        match self.files.level_file(table.file()) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => {
                let found = tr!("a file that cannot be read ({error})", error);
                self.rows.problems.push(table.rows()[0].problem(1, found, tr("a readable file")));
                None
            }
        }
    }

    /// The rows of a file that a level must have; `expected` names these rows.
    pub fn required(&mut self, table: Table, expected: &str) -> Option<TableRows> {
        let before = self.rows.problems.len();
        let bytes = self.bytes(table);
        if bytes.is_none() && self.rows.problems.len() == before {
            self.rows.problems.push(table.rows()[0].problem(1, tr("no file"), expected));
        }
        Some(self.read(table, &bytes?))
    }

    pub fn table(&mut self, table: Table) -> TableRows {
        self.bytes(table).map_or_else(TableRows::default, |bytes| self.read(table, &bytes))
    }

    fn read(&mut self, table: Table, bytes: &[u8]) -> TableRows {
        let rows = table::read(table.rows(), bytes, &mut self.rows.problems);
        self.dialects.extend(rows.dialect.and_then(|dialect| Some((table.file(), dialect.words()?))));
        rows
    }

    pub fn things<T>(&mut self, table: Table, read: fn(&RowCells, &mut RowReader) -> Option<T>) -> Vec<FromRow<T>> {
        let records = self.table(table).records;
        records.iter().filter_map(|record| Some(FromRow::new(record, read(record, &mut self.rows)?))).collect()
    }
}

/// The things of readable rows, in metres.
pub(super) struct Draft {
    /// Width and height in pixels.
    pub size: Option<DVec2>,
    pub scale: PixelScale,
    pub settings: LevelSettings,
    /// `None` in an experiment.
    pub player: Option<FromRow<ShipStart>>,
    pub world: Vec<FromRow<Solid>>,
    pub movers: Vec<FromRow<Mover>>,
    pub doors: Vec<FromRow<Solid>>,
    pub switches: Vec<FromRow<Switch>>,
    /// The objects of objects.csv, then the key objects.
    pub objects: Vec<FromRow<Object>>,
    pub objectives: Vec<FromRow<Objective>>,
    pub obstacles: Vec<FromRow<Aabb>>,
    pub streams: Vec<FromRow<AirStream>>,
    pub fluids: Vec<FromRow<Fluid>>,
    pub fields: Vec<FromRow<GravityZone>>,
    pub pods: Vec<FromRow<Pod>>,
    pub stars: Vec<FromRow<Star>>,
    pub links: Vec<FromRow<UnboundLink>>,
    pub decoration: Vec<FromRow<Decoration>>,
    pub texts: Vec<FromRow<Text>>,
    pub hints: Vec<FromRow<String>>,
}

impl Draft {
    /// Reads all files but constants.csv; `size` is in pixels.
    pub fn read(reader: &mut LevelReader, size: Option<DVec2>, mut settings: LevelSettings) -> Self {
        let player = if settings.is_experiment() { None } else { player(reader) };
        let world = reader.things(Table::World, blocks::solid);
        let mut objects = reader.things(Table::Objects, bodies::object);
        let objectives = objectives(reader, settings.is_experiment(), &mut objects);
        let streams = streams(reader, &world);
        let stars = stars(reader, &mut settings);
        if let Some(Mark::Together(count, _)) = settings.awards.mark.filter(|_| !objectives.is_empty())
            && count as usize > objectives.len()
        {
            let found = tr!("{count} objectives of {all}", count, all = objectives.len());
            reader.rows.problems.push(settings.given.problem("mark_together", found, at_most(objectives.len())));
        }
        Self {
            size,
            scale: reader.rows.scale,
            settings,
            player,
            world,
            movers: reader.things(Table::Movers, blocks::mover),
            doors: reader.things(Table::Doors, blocks::door),
            switches: reader.things(Table::Switches, blocks::switch),
            objects,
            objectives,
            obstacles: reader.things(Table::Obstacles, zones::deadly),
            streams,
            fluids: reader.things(Table::Fluids, zones::fluid),
            fields: reader.things(Table::Gravity, zones::gravity_zone),
            pods: reader.things(Table::Pods, zones::pod),
            stars,
            links: reader.things(Table::Links, blocks::link),
            decoration: reader.things(Table::Decoration, zones::decoration),
            texts: reader.things(Table::Texts, zones::text),
            hints: zones::hints(&reader.table(Table::Hints).records, &mut reader.rows),
        }
    }

    /// Whether something may carry, throw or pull a body to any place that it fits in, with any speed.
    pub fn is_driven(&self) -> bool {
        self.has_moving_surfaces() || !self.links.is_empty()
    }

    pub fn has_moving_surfaces(&self) -> bool {
        !self.movers.is_empty() || self.world.iter().any(|solid| solid.item.belt != 0.0)
    }

    /// Whether something besides may drive a body: streams, gravity zones, liquids and gravity to the side.
    pub fn has_currents(&self) -> bool {
        let zones = !self.streams.is_empty() || !self.fields.is_empty() || !self.fluids.is_empty();
        zones || self.settings.row.gravity_x != 0.0
    }

    /// Whether the engine and weights alone drive bodies.
    pub fn is_calm(&self) -> bool {
        !self.is_driven() && !self.has_currents()
    }

    pub const fn may_start(&self) -> bool {
        self.player.is_some() || self.settings.is_experiment()
    }

    /// The size is in metres.
    pub fn level(self, name: &str, background: bool, size: DVec2) -> Level {
        let experiment = self.settings.is_experiment();
        let LevelSettings { row: settings, awards, .. } = self.settings;
        Level {
            name: name.to_owned(),
            title: settings.title.unwrap_or_else(|| name.to_owned()),
            metre: self.scale.metre,
            size,
            gravity: settings.gravity,
            gravity_x: settings.gravity_x,
            air_density: settings.air_density,
            optimal_time: settings.optimal_time,
            rest_speed: settings.rest_speed,
            friction: settings.friction,
            experiment,
            awards,
            landscape: settings.world,
            overview: settings.overview == 1.0,
            storeys: settings.storeys == 1.0,
            player: self.player.map_or(ShipStart::PARKED, |ship| ship.item),
            world: items(self.world),
            movers: items(self.movers),
            doors: items(self.doors),
            switches: items(self.switches),
            links: blocks::bound(&self.links, &self.objects),
            objects: items(self.objects),
            objectives: items(self.objectives),
            obstacles: items(self.obstacles),
            streams: items(self.streams),
            fluids: items(self.fluids),
            fields: items(self.fields),
            pods: items(self.pods),
            stars: items(self.stars),
            decoration: items(self.decoration),
            texts: items(self.texts),
            hints: items(self.hints),
            background: background.then(|| PathBuf::from(BACKGROUND)),
        }
    }

    pub fn leave_out(&mut self, problems: &[Problem]) {
        let rows: BTreeSet<(&str, usize)> = problems.iter().map(|problem| (problem.file.as_str(), problem.line)).collect();
        fn keep<T>(things: &mut Vec<FromRow<T>>, rows: &BTreeSet<(&str, usize)>) {
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

fn player(reader: &mut LevelReader) -> Option<FromRow<ShipStart>> {
    let one = tr("exactly one row with the ship");
    let table = reader.required(Table::Player, one)?;
    if table.lines.is_empty() {
        reader.rows.problems.push(bodies::SHIP.problem(1, tr("no row"), one));
    }
    for line in table.lines.iter().skip(1) {
        reader.rows.problems.push(bodies::SHIP.problem(*line, tr("one more row"), one));
    }
    let read = |record| Some(FromRow::new(record, bodies::player(record, &mut reader.rows)?));
    let ships: Vec<_> = table.records.iter().map(read).collect();
    ships.into_iter().next().flatten()
}

/// Appends the key objects to `objects`. An experiment has no objectives.
fn objectives(reader: &mut LevelReader, experiment: bool, objects: &mut Vec<FromRow<Object>>) -> Vec<FromRow<Objective>> {
    let wanted = tr("at least one PLAYER or PHYS row");
    let table = if experiment { Some(reader.table(Table::Objectives)) } else { reader.required(Table::Objectives, wanted) };
    let Some(table) = table else { return Vec::new() };
    let mut objectives = Vec::new();
    let (mut first_physics, mut blocks, mut keys) = (None, 0, 0);
    for record in &table.records {
        if record.schema.tag == bodies::KEY.tag {
            keys += 1;
            objects.extend(bodies::key(record, &mut reader.rows).map(|key| FromRow::new(record, key)));
        }
        if experiment || record.schema.tag == bodies::KEY.tag {
            continue;
        }
        blocks += 1;
        let kind = if record.schema.tag == bodies::PAD.tag { ObjectiveKind::Player } else { ObjectiveKind::Physics };
        if kind == ObjectiveKind::Physics {
            first_physics.get_or_insert(record);
        }
        let objective = bodies::objective(kind, record, &mut reader.rows);
        objectives.extend(objective.map(|objective| FromRow::new(record, objective)));
    }
    // The missing row may be an unreadable one, which has a problem of its own.
    let all_read = table.records.len() == table.lines.len();
    if blocks == 0 && all_read && !experiment {
        reader.rows.problems.push(bodies::PAD.problem(1, tr("no objective"), wanted));
    }
    if let (Some(record), 0, true) = (first_physics, keys, all_read) {
        reader.rows.problems.push(record.problem("kind", tr("PHYS without any key object"), tr("at least one OBJECT row")));
    }
    objectives
}

fn stars(reader: &mut LevelReader, settings: &mut LevelSettings) -> Vec<FromRow<Star>> {
    let stars = reader.things(Table::Stars, zones::star);
    let Some(first) = stars.first() else { return stars };
    if let Some(mark) = settings.marked.filter(|_| settings.awards.mark.is_some()) {
        reader.rows.problems.push(first.problem("x", tr!("a star beside {mark}", mark), tr("one mark a level")));
    }
    settings.awards.mark = Some(Mark::Stars);
    stars
}

/// A shaded stream ends at the first solid before it.
fn streams(reader: &mut LevelReader, world: &[FromRow<Solid>]) -> Vec<FromRow<AirStream>> {
    let (mut streams, mut pairs) = (Vec::new(), 0);
    for placed in reader.things(Table::Hazards, zones::stream) {
        let (mut stream, shaded) = placed.item.clone();
        pairs += if shaded { world.len() } else { 0 };
        if pairs > MOST_PAIRS {
            let found = tr!("one more shaded stream beside {count} solids", count = world.len());
            let (most, pairs) = (MOST_PAIRS / world.len(), MOST_PAIRS);
            let expected = tr!("at most {most} in this level: shaded streams times solids are at most {pairs}", most, pairs);
            reader.rows.problems.push(placed.problem("shaded", found, expected));
            break;
        }
        if shaded {
            match image::shaded(&stream, world.iter().map(|solid| solid.item.bounds)) {
                Some(zone) => stream.zone = zone,
                None => {
                    let found = tr("TRUE, with a solid right before the source block");
                    reader.rows.problems.push(placed.problem("shaded", found, tr("free space before it")));
                }
            }
        }
        streams.push(placed.map(|_| stream));
    }
    streams
}

fn items<T>(placed: Vec<FromRow<T>>) -> Vec<T> {
    placed.into_iter().map(|placed| placed.item).collect()
}
