//! Rows of bodies, player.csv and objects.csv, and of objectives.csv, which has key objects beside the objectives.

use super::facts::{Column, Count, FileSchema, Holds, RowSchema, whole_number};
use super::typed::{
    CENTRE_X, CENTRE_Y, MATERIAL, Row as _, RowCells, RowReader, VX, VY, boolean, channel, number, rows, whole, words,
};
use crate::level::types::{Look, Object, Objective, ObjectiveKind, ShipStart};
use crate::physics::{DVec2, Material};
use crate::{level::numbers, level::problem::quoted, words::tr};

pub static PLAYER: FileSchema = FileSchema {
    name: "player.csv",
    help: "The ship, exactly one row. It is 51 pixels high at the usual scale.",
    sample: "150,650,100,500,2500,TRUE,0,0,0,Asphalt,1.15,0\n",
};
pub static SHIP: RowSchema = RowSchema::new(&PLAYER, "Ship", ShipRow::COLUMNS, (51.0, 51.0)).by_centre();

pub static OBJECTS: FileSchema =
    FileSchema { name: "objects.csv", help: "Things that move.", sample: "600,660,box:40x40,50,1.05,FALSE,0.2,0,0,Wood,FALSE\n" };
pub static OBJECT: RowSchema = RowSchema::new(&OBJECTS, "Object", ObjectRow::COLUMNS, (40.0, 40.0))
    .fresh(&[("mass", "50"), ("drag", "1.05"), ("circular", "FALSE"), ("restitution", "0.2")])
    .by_centre()
    .counted(&[
        Count::always("object", "objects", |level| level.objects.iter().filter(|object| object.key.is_none()).count()),
        Count::always("key object", "key objects", |level| level.objects.iter().filter(|object| object.key.is_some()).count()),
    ]);

pub static OBJECTIVES: FileSchema = FileSchema {
    name: "objectives.csv",
    help: "Objectives for the ship (PLAYER) and for key objects (PHYS), and the key objects (OBJECT). The first cell says which it is, and \
           the columns of these rows never change places.",
    sample: "PLAYER,1120,430,100,10,1\n",
};
pub static PAD: RowSchema = RowSchema::new(&OBJECTIVES, "Ship's pad", ObjectiveRow::COLUMNS, (120.0, 10.0))
    .tagged("PLAYER")
    .fresh(&[("kind", "PLAYER"), ("hold", "1")])
    .counted(&[Count::always("player objective", "player objectives", |level| level.objectives_of(ObjectiveKind::Player))]);
pub static KEY_PAD: RowSchema = RowSchema::new(&OBJECTIVES, "Key's pad", ObjectiveRow::COLUMNS, (120.0, 10.0))
    .tagged("PHYS")
    .fresh(&[("kind", "PHYS")])
    .counted(&[Count::always("physics objective", "physics objectives", |level| level.objectives_of(ObjectiveKind::Physics))]);
pub static KEY: RowSchema = RowSchema::new(&OBJECTIVES, "Key object", KeyRow::COLUMNS, (40.0, 40.0))
    .tagged("OBJECT")
    .fresh(&[("kind", "OBJECT"), ("mass", "50"), ("r", "240"), ("g", "170"), ("b", "40"), ("restitution", "0.2"), ("drag", "1.05")])
    .by_centre();

const KIND: Column = words("PLAYER, PHYS or OBJECT", "the kind of the row");
const MASS: Column = number(numbers::MASS, "its inertia and its weight");
const DRAG: Column = number(numbers::DRAG, "coefficient of its air resistance");
const RESTITUTION: Column = number(numbers::RESTITUTION, "share of a blow's speed that it gives back");
const PICTURE: Column = Column::new(Holds::Picture { of_body: true }, "how it looks, and its size");
const WEIGHTLESS: Column = boolean("whether no gravity acts on it").or("FALSE");
const OBJECT_NAME: Column = Column::new(Holds::BodyName, "the name by which links find it").maybe();
const ONLY_KEYS: Column = channel("a channel of the only keys that fit; all keys fit where none is given").maybe();

rows! {
    ShipRow {
        x: f64 = CENTRE_X,
        y: f64 = CENTRE_Y,
        mass: f64 = MASS,
        fuel: f64 = number(numbers::FUEL, "fuel in the tank, 20 units a second of burning"),
        thrust: f64 = number(numbers::THRUST, "force of the engine"),
        air: bool = boolean("whether air acts on it").or("TRUE"),
        vx: f64 = VX,
        vy: f64 = VY,
        angle: f64 = number(numbers::ANGLE, "clockwise turn; at 0 the nose points up").or("0"),
        material: Material = MATERIAL,
        drag: f64 = DRAG.or("1.15"),
        restitution: f64 = RESTITUTION.or("0"),
    }

    ObjectRow {
        x: f64 = CENTRE_X,
        y: f64 = CENTRE_Y,
        image: String = PICTURE,
        mass: f64 = MASS,
        drag: f64 = DRAG,
        circular: bool = boolean("whether it is drawn round, and air and liquids act on it as on a ball"),
        restitution: f64 = RESTITUTION,
        vx: f64 = VX,
        vy: f64 = VY,
        material: Material = MATERIAL,
        weightless: bool = WEIGHTLESS,
        name: Option<String> = OBJECT_NAME,
    }

    ObjectiveRow {
        kind: String = KIND,
        rectangle,
        hold: f64 = number(numbers::HOLD, "how long it has to be touched without a break").or("0"),
        order: Option<u32> = whole(1, 1000, "its turn: after all with smaller numbers, and met for good").maybe(),
        r: Option<u8> = ONLY_KEYS,
        g: Option<u8> = ONLY_KEYS,
        b: Option<u8> = ONLY_KEYS,
    }

    /// Restitution stands before drag, unlike in objects.csv, as in the original's files.
    KeyRow {
        kind: String = KIND,
        x: f64 = CENTRE_X,
        y: f64 = CENTRE_Y,
        image: String = PICTURE,
        mass: f64 = MASS,
        r: u8 = channel("red channel of its colour"),
        g: u8 = channel("green channel of its colour"),
        b: u8 = channel("blue channel of its colour"),
        restitution: f64 = RESTITUTION,
        drag: f64 = DRAG,
        vx: f64 = VX,
        vy: f64 = VY,
        material: Material = MATERIAL,
        weightless: bool = WEIGHTLESS,
        name: Option<String> = OBJECT_NAME,
    }
}

pub fn player(record: &RowCells, reader: &mut RowReader) -> Option<ShipStart> {
    let row: ShipRow = record.read(reader)?;
    Some(ShipStart {
        position: reader.scale.metres(row.x, row.y),
        velocity: DVec2::new(row.vx, row.vy),
        angle: row.angle,
        mass: row.mass,
        fuel: row.fuel,
        thrust: row.thrust,
        feels_air: row.air,
        material: row.material,
        drag: row.drag,
        restitution: row.restitution,
    })
}

/// A key is round where it is drawn as a ball.
macro_rules! body {
    ($row:ident, $reader:ident, $key:expr, $circular:expr) => {{
        let (look, width, height) = $reader.images.look(&$row.image, $reader.scale).ok()?;
        Some(Object {
            position: $reader.scale.metres($row.x, $row.y),
            velocity: DVec2::new($row.vx, $row.vy),
            size: $reader.scale.metres(width, height),
            mass: $row.mass,
            drag: $row.drag,
            restitution: $row.restitution,
            circular: $circular.unwrap_or(look == Look::Ball),
            look,
            material: $row.material,
            key: $key,
            weightless: $row.weightless,
            name: $row.name,
        })
    }};
}

pub fn object(record: &RowCells, reader: &mut RowReader) -> Option<Object> {
    let row: ObjectRow = record.read(reader)?;
    body!(row, reader, None, Some(row.circular))
}

pub fn key(record: &RowCells, reader: &mut RowReader) -> Option<Object> {
    let row: KeyRow = record.read(reader)?;
    body!(row, reader, Some([row.r, row.g, row.b]), None)
}

pub fn objective(kind: ObjectiveKind, record: &RowCells, reader: &mut RowReader) -> Option<Objective> {
    let row: ObjectiveRow = record.read(reader)?;
    let channels = [row.r, row.g, row.b];
    let coloured = ["r", "g", "b"].into_iter().zip(channels).find(|(_, channel)| channel.is_some());
    if let Some((column, _)) = coloured.filter(|_| kind == ObjectiveKind::Player) {
        let found = quoted(record.text(column).unwrap_or_default());
        reader.problems.push(record.problem(column, found, tr("nothing: only key objects have a colour that can fit")));
        return None;
    }
    let colour = colour_if_given(channels, record, reader)?;
    let bounds = reader.scale.bounds([row.x, row.y, row.width, row.height]);
    Some(Objective { kind, bounds, hold: row.hold, order: row.order, colour })
}

/// The colour of three channels that are given together or not at all.
pub(super) fn colour_if_given(channels: [Option<u8>; 3], record: &RowCells, reader: &mut RowReader) -> Option<Option<[u8; 3]>> {
    match channels {
        [None, None, None] => Some(None),
        [Some(r), Some(g), Some(b)] => Some(Some([r, g, b])),
        _ => {
            let (column, _) = ["r", "g", "b"].into_iter().zip(channels).find(|(_, channel)| channel.is_none())?;
            reader.problems.push(record.problem(column, tr("nothing"), whole_number(0, 255)));
            None
        }
    }
}
