//! constants.csv: a row for each setting of a level.

use super::facts::{Column, FileSchema, Holds, RowSchema};
use super::typed::{Row as _, RowCells, RowReader, Word, by_word, number, one_of, rows, words};
use super::values::Together;
use crate::level::numbers::{self, PixelScale};
use crate::level::problem::{Problem, meant, quoted};
use crate::level::types::{Awards, Landscape, Mark};
use crate::{files::Dialect, words::tr};

pub static CONSTANTS: FileSchema = FileSchema {
    name: "constants.csv",
    help: "The settings of the level. width and height are needed where there is no background.png; silver and gold and one mark \
           (mark_hits, mark_fuel, mark_pushes, mark_speed, mark_burns, mark_together, or stars.csv) are what the level's medals ask for.",
    sample: "title,{name}\ngravity,15\ngravity_x,0\nair_density,1.2041\noptimal_time,60\nmetre,30\nrest_speed,0\nfriction,1\n\
             experiment,0\noverview,0\nstoreys,0\nworld,quarry\nsilver,30\ngold,15\nmark_hits,0\nwidth,1280\nheight,720\n",
};
pub static SETTING: RowSchema = RowSchema::new(&CONSTANTS, "Setting", SettingRow::COLUMNS, (51.0, 51.0));

const TIME: Column = number(numbers::MEDAL_TIME, "the longest time for this medal; gold is no longer than silver").maybe_filled();
const SIDE: Column = Column::new(Holds::Size, "size of the level, where there is no background.png");

by_word!(Landscape);

impl Word for Landscape {
    fn words() -> Vec<(&'static str, Self)> {
        ["launch", "quarry", "wind", "water", "orbit"].into_iter().zip(Self::ALL).collect()
    }
}

rows! {
    SettingRow {
        name: String = words("a setting", "the setting"),
        value: String = Column::new(Holds::Any("a value"), "its value"),
    }

    #[derive(Default)]
    SettingsRow {
        title: Option<String> = words("words", "shown in place of the level's name").maybe(),
        width: Option<f64> = SIDE.maybe_filled(),
        height: Option<f64> = SIDE.maybe_filled(),
        gravity: f64 = number(numbers::GRAVITY, "pull downwards").unless_given("15"),
        gravity_x: f64 = number(numbers::GRAVITY, "pull to the right; not in a level with liquids").or("0"),
        air_density: f64 = number(numbers::AIR_DENSITY, "mass of a volume of air").unless_given("1.2041"),
        optimal_time: f64 = number(numbers::OPTIMAL_TIME, "the time that scores best").unless_given("60"),
        metre: f64 = number(numbers::METRE, "the scale of all pixels").or("30"),
        rest_speed: f64 =
            number(numbers::REST_SPEED, "a slower rebound is none; with 0 a body bounces until its series of bounces ends").or("0"),
        friction: f64 = number(numbers::FRICTION, "factor of all coefficients of friction").or("1"),
        experiment: f64 = number(numbers::YES, "1: the level shows a law, the ship plays no part and nothing is scored").or("0"),
        overview: f64 = number(numbers::YES, "1: the whole level is in view until the first key").or("0"),
        storeys: f64 = number(numbers::YES, "1: five worlds lie one above the other, from the sea up to orbit").or("0"),
        world: Option<Landscape> = one_of::<Landscape>("the world whose colours, sky and music it has").maybe(),
        silver: Option<f64> = TIME,
        gold: Option<f64> = TIME,
        mark_hits: Option<f64> = number(numbers::MARK_COUNT, "mark for no more damaging hits than this; a whole number").maybe_filled(),
        mark_fuel: Option<f64> = number(numbers::MARK_FUEL, "mark for no less fuel left than this").maybe_filled(),
        mark_pushes: Option<f64> =
            number(numbers::MARK_COUNT, "mark for no more pushes of objects by the ship than this; a whole number").maybe_filled(),
        mark_speed: Option<f64> = number(numbers::MARK_SPEED, "mark for no higher speed than this").maybe_filled(),
        mark_burns: Option<f64> = number(numbers::MARK_COUNT, "mark for no more burns of the engine than this, each after at least 0.1 s without; a whole number")
            .maybe_filled(),
        mark_together: Option<Together> = Column::new(Holds::Together, "mark for that number of objectives met within that number of seconds").maybe_filled(),
    }
}

/// The settings of constants.csv, each as a column.
pub static SETTINGS: &[Column] = SettingsRow::COLUMNS;

pub(in crate::level) struct LevelSettings {
    pub row: SettingsRow,
    pub awards: Awards,
    /// The setting that asks for the mark.
    pub marked: Option<&'static str>,
    pub given: RowCells,
}

impl LevelSettings {
    pub const fn is_experiment(&self) -> bool {
        self.row.experiment == 1.0
    }
}

/// An unknown setting is a warning. The reader gets the level's scale.
pub(in crate::level) fn settings(rows: Vec<RowCells>, reader: &mut RowReader, warnings: &mut Vec<Problem>) -> LevelSettings {
    let given = named(rows, reader, warnings);
    let metre = given.text("metre").and_then(|text| numbers::METRE.parse(&given.dialect.number(text)).ok());
    reader.scale = PixelScale { metre: metre.unwrap_or(PixelScale::USUAL.metre) };
    // In an unfinished level the usual number stands for a refused one.
    let row: SettingsRow = given.read_cells(reader).0.unwrap_or_default();
    let (awards, marked) = awards(&row, &given, reader);
    LevelSettings { row, awards, marked, given }
}

fn named(rows: Vec<RowCells>, reader: &mut RowReader, warnings: &mut Vec<Problem>) -> RowCells {
    let names = || SETTINGS.iter().map(|setting| setting.name);
    let mut given = RowCells { schema: &SETTING, dialect: Dialect::PLAIN, line: 1, cells: Vec::new(), is_settings: true };
    for record in rows {
        let dialect = record.dialect;
        let Some(SettingRow { name, .. }) = record.read(reader) else { continue };
        let Some(known) = names().find(|known| known.eq_ignore_ascii_case(&name)) else {
            let expected = tr!("one of {list}", list = names().collect::<Vec<_>>().join(", ")) + &meant(&name, names());
            warnings.push(record.problem("name", tr!("the unknown constant {name}", name = quoted(&name)), expected));
            continue;
        };
        if given.text(known).is_some() {
            let found = tr!("{name} a second time", name = quoted(known));
            reader.problems.push(record.problem("name", found, tr("each constant once")));
        } else if let Some((_, value)) = record.cells.into_iter().find(|(column, _)| *column == "value") {
            given.dialect = dialect;
            given.cells.push((known, value));
        }
    }
    given
}

/// Gold takes no longer than silver, and a level has one mark.
fn awards(row: &SettingsRow, given: &RowCells, reader: &mut RowReader) -> (Awards, Option<&'static str>) {
    let SettingsRow { silver, gold, .. } = *row;
    let marks = [
        ("mark_hits", row.mark_hits, Mark::Hits as fn(u32) -> Mark),
        ("mark_pushes", row.mark_pushes, Mark::Pushes),
        ("mark_burns", row.mark_burns, Mark::Burns),
    ];
    let mut marked: Vec<(&'static str, Mark)> = Vec::new();
    for (name, value, mark) in marks.into_iter().filter_map(|(name, value, mark)| Some((name, value?, mark))) {
        if value.fract() == 0.0 {
            // Whole and at most a million, so the conversion is exact.
            marked.push((name, mark(value as u32)));
        } else {
            reader.problems.push(given.problem(name, quoted(&value.to_string()), tr("a whole number")));
        }
    }
    marked.extend(row.mark_fuel.map(|value| ("mark_fuel", Mark::Fuel(value))));
    marked.extend(row.mark_speed.map(|value| ("mark_speed", Mark::Speed(value))));
    marked.extend(row.mark_together.map(|Together { count, within }| ("mark_together", Mark::Together(count, within))));
    marked.sort_by_key(|(name, _)| SETTINGS.iter().position(|setting| setting.name == *name));
    if let [(first, _), more @ ..] = &marked[..] {
        reader.problems.extend(more.iter().map(|(name, _)| {
            let found = tr!("{name} beside {first}", name, first);
            Problem::new(CONSTANTS.name, given.line_of(name), "name", found, tr("one mark a level"))
        }));
    }
    if let (Some(silver), Some(gold)) = (silver, gold)
        && gold > silver
    {
        let expected = tr!("no longer than silver, which is {silver} s", silver);
        reader.problems.push(given.problem("gold", quoted(&gold.to_string()), expected));
    }
    let (name, mark) = marked.first().copied().unzip();
    (Awards { silver, gold, mark }, name)
}
