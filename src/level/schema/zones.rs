//! Rows of zones that are not solid: death boxes, air streams, liquids, gravity, pods; and of words and pictures.

use super::bodies::colour_if_given;
use super::facts::{Column, Count, FileSchema, Holds, RowSchema};
use super::typed::{Row as _, RowCells, RowReader, Word, X, Y, boolean, by_word, channel, number, one_of, rows, words};
use crate::level::numbers::{self, corners};
use crate::level::problem::{at_most, quoted};
use crate::level::types::{AirStream, Decoration, Fluid, GravityZone, Pod, Star, StarTouch, Text};
use crate::physics::{Aabb, DVec2};
use crate::{level::schema::typed::FromRow, words::tr};

pub static OBSTACLES: FileSchema =
    FileSchema { name: "obstacles.csv", help: "Death boxes: red that destroys the ship.", sample: "900,660,120,20\n" };
pub static DEADLY: RowSchema = RowSchema::new(&OBSTACLES, "Death box", DeadlyRow::COLUMNS, (120.0, 20.0))
    .counted(&[Count::always("death box", "death boxes", |level| level.obstacles.len())]);

pub static HAZARDS: FileSchema = FileSchema {
    name: "hazards.csv",
    help: "Air streams, at most 64 a level. The source block is solid steel; the stream blows from it to one side, through solids unless it \
           is shaded.",
    sample: "400,660,80,20,0,-200,0,-400,FALSE,fan\n",
};
pub static STREAM: RowSchema = RowSchema::new(&HAZARDS, "Air stream", StreamRow::COLUMNS, (80.0, 20.0))
    .fresh(&[("stream_width", "0"), ("force_x", "0"), ("force_y", "-600")])
    .counted(&[Count::always("air stream", "air streams", |level| level.streams.len())]);

pub static FLUIDS: FileSchema = FileSchema {
    name: "fluids.csv",
    help: "Zones of thick liquid, at most 16 a level, which may touch but not overlap.",
    sample: "0,560,80,120,900,50,120,90,40\n",
};
pub static FLUID: RowSchema = RowSchema::new(&FLUIDS, "Liquid", FluidRow::COLUMNS, (200.0, 120.0))
    .fresh(&[("density", "900"), ("viscosity", "20")])
    .counted(&[Count::always("liquid", "liquids", |level| level.fluids.len())]);

pub static TEXTS: FileSchema = FileSchema {
    name: "texts.csv",
    help: "Words in the level, pale where no colour is given. Words with a comma stand in quotes.",
    sample: "100,480,24,\"Space: thrust, arrows: rotate\",230,235,242\n",
};
pub static TEXT: RowSchema = RowSchema::new(&TEXTS, "Words", TextRow::COLUMNS, (200.0, 24.0))
    .fresh(&[("text", "Words")])
    .counted(&[Count::always("text", "texts", |level| level.texts.len())]);

/// The most hints of a level, and the most letters of one.
const MOST_HINTS: usize = 3;
const HINT_LENGTH: usize = 90;

pub static HINTS: FileSchema = FileSchema {
    name: "hints.csv",
    help: "Hints, at most 3 a level, which the pause panel gives one at a time after three losses. They leave recorded flights as they are.",
    sample: "",
};
pub static HINT: RowSchema =
    RowSchema::new(&HINTS, "Hint", HintRow::COLUMNS, (51.0, 51.0))
        .counted(&[Count::if_any("hint", "hints", |level| level.hints.len())]);

pub static GRAVITY: FileSchema = FileSchema {
    name: "gravity.csv",
    help: "Zones with a gravity of their own, which adds to that of the level, at most 64 a level. A body that touches one feels it.",
    sample: "860,60,120,200,0,-12\n",
};
pub static GRAVITY_ZONE: RowSchema = RowSchema::new(&GRAVITY, "Gravity zone", GravityRow::COLUMNS, (200.0, 120.0))
    .fresh(&[("field_x", "0"), ("field_y", "-20")])
    .counted(&[Count::if_any("gravity zone", "gravity zones", |level| level.fields.len())]);

pub static PODS: FileSchema =
    FileSchema { name: "pods.csv", help: "Fuel that the ship takes up by touching it.", sample: "700,620,30,40,100\n" };
pub static POD: RowSchema = RowSchema::new(&PODS, "Fuel pod", PodRow::COLUMNS, (30.0, 40.0))
    .fresh(&[("fuel", "100")])
    .counted(&[Count::if_any("pod", "pods", |level| level.pods.len())]);

pub static STARS: FileSchema = FileSchema {
    name: "stars.csv",
    help: "Stars: a flight that touches all of them and completes the level earns its mark. They are in nobody's way.",
    sample: "",
};
pub static STAR: RowSchema =
    RowSchema::new(&STARS, "Star", StarRow::COLUMNS, (30.0, 30.0))
        .counted(&[Count::if_any("star", "stars", |level| level.stars.len())]);

pub static DECORATION: FileSchema = FileSchema {
    name: "decoration.csv",
    help: "Pictures and plain shapes that nothing touches. One behind lies on rock, and below goals and hazards.",
    sample: "",
};
pub static PICTURE: RowSchema = RowSchema::new(&DECORATION, "Picture", DecorationRow::COLUMNS, (51.0, 51.0))
    .fresh(&[("layer", "behind")])
    .counted(&[Count::if_any("decoration", "decorations", |level| level.decoration.len())]);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::level) enum Layer {
    Behind,
    Front,
}

by_word!(Layer, StarTouch);

impl Word for Layer {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("behind", Self::Behind), ("front", Self::Front)]
    }
}

impl Word for StarTouch {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("ship", Self::Ship), ("key", Self::Key), ("object", Self::Object)]
    }
}

const LETTERS: Column = channel("a channel of its colour").maybe();

rows! {
    DeadlyRow {
        rectangle,
    }

    StreamRow {
        rectangle,
        stream_width: f64 = Column::new(Holds::Reach, "how far it blows to the right, or to the left where it is negative; or give a height"),
        stream_height: f64 = Column::new(Holds::Reach, "how far it blows down, or up where it is negative; or give a width"),
        force_x: f64 = number(numbers::FORCE, "force on a body in it, to the right"),
        force_y: f64 = number(numbers::FORCE, "force on a body in it, downwards"),
        shaded: bool = boolean("whether it ends, in all of its width, at the first block of world.csv").or("FALSE"),
        name: Option<String> = Column::new(Holds::Name, "the name by which switches work it").maybe(),
    }

    FluidRow {
        rectangle,
        density: f64 = number(numbers::DENSITY, "its mass a volume"),
        viscosity: f64 = number(numbers::VISCOSITY, "how it resists motion"),
        r: u8 = channel("red channel of its colour").or("58"),
        g: u8 = channel("green channel of its colour").or("110"),
        b: u8 = channel("blue channel of its colour").or("165"),
    }

    TextRow {
        x: f64 = X,
        y: f64 = Y,
        size: f64 = Column::new(Holds::Size, "height of its letters"),
        text: String = words("words", "the words"),
        r: Option<u8> = LETTERS,
        g: Option<u8> = LETTERS,
        b: Option<u8> = LETTERS,
    }

    HintRow {
        text: String = words("words, at most 90 letters", "one hint"),
    }

    GravityRow {
        rectangle,
        field_x: f64 = number(numbers::GRAVITY, "its pull to the right"),
        field_y: f64 = number(numbers::GRAVITY, "its pull downwards"),
    }

    PodRow {
        rectangle,
        fuel: f64 = number(numbers::FUEL, "fuel in it; the ship takes as much as its tank holds"),
    }

    StarRow {
        rectangle,
        by: StarTouch = one_of::<StarTouch>("what has to touch it: the ship, a key object, or any object").or("ship"),
    }

    DecorationRow {
        x: f64 = X,
        y: f64 = Y,
        image: String = Column::new(Holds::Picture { of_body: false }, "how it looks, and its size"),
        layer: Layer = one_of::<Layer>("behind or in front of moving bodies").or("behind"),
    }
}

pub fn deadly(record: &RowCells, reader: &mut RowReader) -> Option<Aabb> {
    let DeadlyRow { x, y, width, height } = record.read(reader)?;
    Some(reader.scale.bounds([x, y, width, height]))
}

/// The stream, and whether it is shaded.
pub fn stream(record: &RowCells, reader: &mut RowReader) -> Option<(AirStream, bool)> {
    let row: StreamRow = record.read(reader)?;
    let ((min, max), reach) = (corners([row.x, row.y, row.width, row.height]), reach_of(&row, record, reader)?);
    // The zone lies before the blowing side and is as wide as that side.
    let beyond = |reach: f64, min: f64, max: f64| match reach {
        reach if reach > 0.0 => (max, max + reach),
        reach if reach < 0.0 => (min + reach, min),
        _ => (min, max),
    };
    let (left, right) = beyond(reach.x, min.x, max.x);
    let (top, bottom) = beyond(reach.y, min.y, max.y);
    let zone = reader.scale.rectangle(DVec2::new(left, top), DVec2::new(right, bottom));
    let source = reader.scale.rectangle(min, max);
    Some((AirStream { source, zone, force: DVec2::new(row.force_x, row.force_y), name: row.name }, row.shaded))
}

/// Exactly one of the two stream sizes, pixels.
fn reach_of(row: &StreamRow, record: &RowCells, reader: &mut RowReader) -> Option<DVec2> {
    let (column, found) = match (row.stream_width, row.stream_height) {
        (0.0, 0.0) => ("stream_width", tr("0 for both stream sizes").to_owned()),
        (across, down) if across == 0.0 || down == 0.0 => {
            let column = if down == 0.0 { "stream_width" } else { "stream_height" };
            let Err(expected) = reader.scale.size().judge((across + down).abs()) else { return Some(DVec2::new(across, down)) };
            let expected = tr!("0 or, but for its sign, {expected}", expected);
            reader.problems.push(record.problem(column, quoted(record.text(column)?), expected));
            return None;
        }
        (across, down) => ("stream_height", tr!("{down} beside a stream_width of {across}", down, across)),
    };
    reader.problems.push(record.problem(column, found, tr("exactly one stream size other than 0")));
    None
}

pub fn fluid(record: &RowCells, reader: &mut RowReader) -> Option<Fluid> {
    let FluidRow { x, y, width, height, density, viscosity, r, g, b } = record.read(reader)?;
    Some(Fluid { zone: reader.scale.bounds([x, y, width, height]), density, viscosity, colour: [r, g, b] })
}

pub fn text(record: &RowCells, reader: &mut RowReader) -> Option<Text> {
    let before = reader.problems.len();
    let row: Option<TextRow> = record.read(reader);
    let colour = row.as_ref().and_then(|row| colour_if_given([row.r, row.g, row.b], record, reader));
    // A comma in the words is more likely than a wrong colour.
    let of_colour = reader.problems[before..].iter_mut().filter(|problem| ["r", "g", "b"].contains(&problem.column.as_str()));
    of_colour.for_each(|problem| problem.expected += tr(" (words that hold a comma stand in quotes)"));
    let TextRow { x, y, size, text, .. } = row?;
    Some(Text { position: reader.scale.metres(x, y), size: size / reader.scale.metre, text, colour: colour? })
}

pub fn hints(records: &[RowCells], reader: &mut RowReader) -> Vec<FromRow<String>> {
    let mut hints = Vec::new();
    for record in records {
        let Some(HintRow { text }) = record.read(reader) else { continue };
        let (letters, before) = (text.chars().count(), hints.len());
        let mut refuse = |found, expected| reader.problems.push(record.problem("text", found, expected));
        match (before < MOST_HINTS, letters <= HINT_LENGTH) {
            (false, _) => refuse(tr("one more hint").to_owned(), at_most(MOST_HINTS)),
            (_, false) => refuse(tr!("{count} letters", count = letters), tr!("at most {most}", most = HINT_LENGTH)),
            _ => hints.push(FromRow::new(record, text)),
        }
    }
    hints
}

pub fn gravity_zone(record: &RowCells, reader: &mut RowReader) -> Option<GravityZone> {
    let GravityRow { x, y, width, height, field_x, field_y } = record.read(reader)?;
    Some(GravityZone { zone: reader.scale.bounds([x, y, width, height]), strength: DVec2::new(field_x, field_y) })
}

pub fn pod(record: &RowCells, reader: &mut RowReader) -> Option<Pod> {
    let PodRow { x, y, width, height, fuel } = record.read(reader)?;
    Some(Pod { bounds: reader.scale.bounds([x, y, width, height]), fuel })
}

pub fn star(record: &RowCells, reader: &mut RowReader) -> Option<Star> {
    let StarRow { x, y, width, height, by } = record.read(reader)?;
    Some(Star { bounds: reader.scale.bounds([x, y, width, height]), by })
}

pub fn decoration(record: &RowCells, reader: &mut RowReader) -> Option<Decoration> {
    let DecorationRow { x, y, image, layer } = record.read(reader)?;
    let (look, width, height) = reader.images.look(&image, reader.scale).ok()?;
    let corner = reader.scale.metres(x, y);
    let bounds = Aabb::new(corner, corner + reader.scale.metres(width, height));
    Some(Decoration { bounds, look, in_front: layer == Layer::Front })
}
