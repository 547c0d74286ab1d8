//! The kinds of rows: which columns each file has, as a layout and as a struct, and how one record becomes one thing of the level.
//!
//! Every function reports all problems of its row before it gives up.

use super::blocks;
use super::image::Images;
use super::nearest::meant;
use super::problem::{Problem, quoted};
use super::quantity::{self as q, Scale};
use super::table::{CellText, Given, Layout, Record, cell};
use super::types::{Fluid, Look, Object, Objective, ObjectiveKind, Player, SHIP_DRAG, Stream, Text};
use crate::physics::{Aabb, DVec2, Material};
use serde::Deserialize;

pub(super) const CONSTANTS: Layout = Layout { file: "constants.csv", columns: "name,value" };
pub(super) const PLAYER: Layout =
    Layout { file: "player.csv", columns: "x,y,mass,fuel,thrust,[air],[vx],[vy],[angle],[material],[drag],[restitution]" };
pub(super) const OBJECTS: Layout =
    Layout { file: "objects.csv", columns: "x,y,image,mass,drag,circular,restitution,[vx],[vy],[material],[weightless]" };
pub(super) const OBSTACLES: Layout = Layout { file: "obstacles.csv", columns: "x,y,width,height" };
pub(super) const HAZARDS: Layout =
    Layout { file: "hazards.csv", columns: "x,y,width,height,stream_width,stream_height,force_x,force_y,[shaded],[name]" };
pub(super) const FLUIDS: Layout = Layout { file: "fluids.csv", columns: "x,y,width,height,density,viscosity,[r],[g],[b]" };
pub(super) const TEXTS: Layout = Layout { file: "texts.csv", columns: "x,y,size,text,[r],[g],[b]" };
/// The rows PLAYER and PHYS of objectives.csv, and what all its rows begin with.
pub(super) const BLOCKS: Layout = Layout { file: "objectives.csv", columns: "kind,x,y,width,height,[hold],[order],[r],[g],[b]" };
/// The rows OBJECT of objectives.csv; restitution and drag stand the other way round than in objects.csv.
pub(super) const KEY_OBJECTS: Layout =
    Layout { file: "objectives.csv", columns: "kind,x,y,image,mass,r,g,b,restitution,drag,[vx],[vy],[material],[weightless]" };

/// A row of constants.csv.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct ConstantRow {
    pub name: CellText,
    pub value: CellText,
}

/// A row of player.csv.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct PlayerRow {
    x: CellText,
    y: CellText,
    mass: CellText,
    fuel: CellText,
    thrust: CellText,
    air: CellText,
    vx: CellText,
    vy: CellText,
    angle: CellText,
    material: CellText,
    drag: CellText,
    restitution: CellText,
}

/// A row of obstacles.csv, and what tells the kinds of objectives.csv apart.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct BlockRow {
    kind: CellText,
    x: CellText,
    y: CellText,
    width: CellText,
    height: CellText,
}

/// A PLAYER or PHYS row of objectives.csv.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct ObjectiveRow {
    x: CellText,
    y: CellText,
    width: CellText,
    height: CellText,
    hold: CellText,
    order: CellText,
    r: CellText,
    g: CellText,
    b: CellText,
}

/// A row of objects.csv, or an OBJECT row of objectives.csv.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct ObjectRow {
    x: CellText,
    y: CellText,
    image: CellText,
    mass: CellText,
    r: CellText,
    g: CellText,
    b: CellText,
    drag: CellText,
    circular: CellText,
    restitution: CellText,
    vx: CellText,
    vy: CellText,
    material: CellText,
    weightless: CellText,
}

/// A row of hazards.csv.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct StreamRow {
    x: CellText,
    y: CellText,
    width: CellText,
    height: CellText,
    stream_width: CellText,
    stream_height: CellText,
    force_x: CellText,
    force_y: CellText,
    shaded: CellText,
    name: CellText,
}

/// A row of fluids.csv.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct FluidRow {
    x: CellText,
    y: CellText,
    width: CellText,
    height: CellText,
    density: CellText,
    viscosity: CellText,
    r: CellText,
    g: CellText,
    b: CellText,
}

/// A row of texts.csv.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct TextRow {
    x: CellText,
    y: CellText,
    size: CellText,
    text: CellText,
    r: CellText,
    g: CellText,
    b: CellText,
}

/// The cells x, y, width and height of a row.
macro_rules! place {
    ($row:ident) => {
        [cell!($row.x), cell!($row.y), cell!($row.width), cell!($row.height)]
    };
}
pub(super) use place;

/// A liquid's colour where the author gives none: a calm blue that stands apart from every colour with a meaning.
const FLUID_COLOUR: [u8; 3] = [58, 110, 165];

/// The largest number of a turn.
const MOST_TURNS: u32 = 1000;

/// A thing of the level and the row that it comes from.
#[derive(Clone, Debug)]
pub(super) struct Placed<T> {
    pub file: &'static str,
    pub line: usize,
    pub item: T,
}

impl<T> Placed<T> {
    pub fn new(record: &Record, item: T) -> Self {
        Self { file: record.file, line: record.line, item }
    }

    /// Something made of the thing, from the same row.
    pub fn map<U>(&self, make: impl FnOnce(&T) -> U) -> Placed<U> {
        Placed { file: self.file, line: self.line, item: make(&self.item) }
    }

    /// A problem with where the thing is.
    pub fn problem(&self, column: &str, found: impl Into<String>, expected: impl Into<String>) -> Problem {
        Problem::new(self.file, self.line, column, found, expected)
    }
}

/// The layout of an objectives.csv row, by its first cell in any case.
pub(super) fn objective_layout(kind: &str) -> Option<Layout> {
    match kind.to_ascii_uppercase().as_str() {
        "PLAYER" | "PHYS" => Some(BLOCKS),
        "OBJECT" => Some(KEY_OBJECTS),
        _ => None,
    }
}

/// The kind of an objective block; `None` for a key object.
pub(super) fn objective_kind(record: &Record) -> Option<ObjectiveKind> {
    let BlockRow { kind, .. } = record.row();
    match kind.as_str()?.to_ascii_uppercase().as_str() {
        "PLAYER" => Some(ObjectiveKind::Player),
        "PHYS" => Some(ObjectiveKind::Physics),
        _ => None,
    }
}

/// A PLAYER or PHYS row of objectives.csv.
pub(super) fn objective(kind: ObjectiveKind, record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Objective> {
    let row: ObjectiveRow = record.row();
    let bounds = bounds(record, place!(row), scale, problems);
    let hold = record.number_or(cell!(row.hold), 0.0, q::HOLD, problems);
    let order = if row.order.is_given() { record.whole(cell!(row.order), (1, MOST_TURNS), problems).map(Some) } else { Some(None) };
    let channels = [cell!(row.r), cell!(row.g), cell!(row.b)];
    let colour = match channels.iter().find(|(_, text)| text.is_given()) {
        None => Some(None),
        Some((column, text)) if kind == ObjectiveKind::Player => {
            problems.push(record.problem(column, quoted(text.as_str()?), "nothing: only key objects have a colour that can fit"));
            None
        }
        Some(_) => colour_if_given(record, channels, problems),
    };
    Some(Objective { kind, bounds: bounds?, hold: hold?, order: order?, colour: colour? })
}

pub(super) fn player(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Player> {
    let row: PlayerRow = record.row();
    let position = point(record, [cell!(row.x), cell!(row.y)], scale, problems);
    let mass = record.number(cell!(row.mass), q::MASS, problems);
    let fuel = record.number(cell!(row.fuel), q::FUEL, problems);
    let thrust = record.number(cell!(row.thrust), q::THRUST, problems);
    let feels_air = if row.air.is_given() { record.boolean(cell!(row.air), problems) } else { Some(true) };
    let velocity = velocity(record, [cell!(row.vx), cell!(row.vy)], problems);
    let angle = record.number_or(cell!(row.angle), 0.0, q::ANGLE, problems);
    let material = material(record, cell!(row.material), problems);
    let drag = record.number_or(cell!(row.drag), SHIP_DRAG, q::DRAG, problems);
    let restitution = record.number_or(cell!(row.restitution), 0.0, q::RESTITUTION, problems);
    Some(Player {
        position: position?,
        velocity: velocity?,
        angle: angle?,
        mass: mass?,
        fuel: fuel?,
        thrust: thrust?,
        feels_air: feels_air?,
        material: material?,
        drag: drag?,
        restitution: restitution?,
    })
}

/// A row of objects.csv, or an OBJECT row of objectives.csv.
pub(super) fn object(record: &Record, scale: Scale, images: &mut Images, problems: &mut Vec<Problem>) -> Option<Object> {
    let is_key = record.file == KEY_OBJECTS.file;
    let row: ObjectRow = record.row();
    let position = point(record, [cell!(row.x), cell!(row.y)], scale, problems);
    let shape = row.image.as_str().and_then(|cell| match images.look(cell, scale) {
        Ok(shape) => Some(shape),
        Err((found, expected)) => {
            problems.push(record.problem("image", found, expected));
            images.stand_in.clone()
        }
    });
    let mass = record.number(cell!(row.mass), q::MASS, problems);
    let channels = [cell!(row.r), cell!(row.g), cell!(row.b)];
    let key = if is_key { colour(record, channels, None, problems).map(Some) } else { Some(None) };
    let drag = record.number(cell!(row.drag), q::DRAG, problems);
    let circular = if is_key { None } else { Some(record.boolean(cell!(row.circular), problems)) };
    let restitution = record.number(cell!(row.restitution), q::RESTITUTION, problems);
    let velocity = velocity(record, [cell!(row.vx), cell!(row.vy)], problems);
    let material = material(record, cell!(row.material), problems);
    let weightless = if row.weightless.is_given() { record.boolean(cell!(row.weightless), problems) } else { Some(false) };
    let (look, width, height) = shape?;
    Some(Object {
        position: position?,
        velocity: velocity?,
        size: scale.metres(width, height),
        mass: mass?,
        drag: drag?,
        restitution: restitution?,
        circular: circular.unwrap_or(Some(look == Look::Ball))?,
        look,
        material: material?,
        key: key?,
        weightless: weightless?,
    })
}

/// A row of hazards.csv: the stream, and whether it ends at the first solid in its way.
pub(super) fn stream(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<(Stream, bool)> {
    let row: StreamRow = record.row();
    let source = pixels(record, place!(row), scale, problems);
    let (wide, high) = (cell!(row.stream_width), cell!(row.stream_height));
    let reach = [wide, high].map(|cell| record.number(cell, scale.coordinate(), problems));
    let force_x = record.number(cell!(row.force_x), q::FORCE, problems);
    let force_y = record.number(cell!(row.force_y), q::FORCE, problems);
    let reach = match reach {
        [Some(0.0), Some(0.0)] => Err((wide, "0 for both stream sizes".to_owned())),
        [Some(across), Some(0.0)] => Ok((wide, DVec2::new(across, 0.0))),
        [Some(0.0), Some(down)] => Ok((high, DVec2::new(0.0, down))),
        [Some(across), Some(down)] => Err((high, format!("{down} beside a stream_width of {across}"))),
        _ => return None,
    };
    let reach = match reach {
        Ok(((column, text), reach)) => match scale.size().parse(&(reach.x + reach.y).abs().to_string()) {
            Ok(_) => Some(reach),
            Err(expected) => {
                problems.push(record.problem(column, quoted(text.as_str()?), format!("0 or, but for its sign, {expected}")));
                None
            }
        },
        Err(((column, _), found)) => {
            problems.push(record.problem(column, found, "exactly one stream size other than 0"));
            None
        }
    };
    let shaded = if row.shaded.is_given() { record.boolean(cell!(row.shaded), problems) } else { Some(false) };
    let name = if row.name.is_given() { blocks::name(record, cell!(row.name), problems).map(Some) } else { Some(None) };
    let ((min, max), reach) = (source?, reach?);
    // The zone lies before the side that it blows from and is as wide as that side.
    let beyond = |reach: f64, min: f64, max: f64| match reach {
        reach if reach > 0.0 => (max, max + reach),
        reach if reach < 0.0 => (min + reach, min),
        _ => (min, max),
    };
    let (left, right) = beyond(reach.x, min.x, max.x);
    let (top, bottom) = beyond(reach.y, min.y, max.y);
    let zone = scale.rectangle(DVec2::new(left, top), DVec2::new(right, bottom));
    let source = scale.rectangle(min, max);
    Some((Stream { source, zone, force: DVec2::new(force_x?, force_y?), name: name? }, shaded?))
}

pub(super) fn fluid(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Fluid> {
    let row: FluidRow = record.row();
    let zone = bounds(record, place!(row), scale, problems);
    let density = record.number(cell!(row.density), q::DENSITY, problems);
    let viscosity = record.number(cell!(row.viscosity), q::VISCOSITY, problems);
    let colour = colour(record, [cell!(row.r), cell!(row.g), cell!(row.b)], Some(FLUID_COLOUR), problems);
    Some(Fluid { zone: zone?, density: density?, viscosity: viscosity?, colour: colour? })
}

pub(super) fn text(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Text> {
    let row: TextRow = record.row();
    let position = point(record, [cell!(row.x), cell!(row.y)], scale, problems);
    let size = record.number(cell!(row.size), scale.size(), problems);
    let text = record.words(cell!(row.text), problems);
    let before = problems.len();
    let colour = colour_if_given(record, [cell!(row.r), cell!(row.g), cell!(row.b)], problems);
    // More likely than a wrong colour.
    problems[before..].iter_mut().for_each(|problem| problem.expected += " (words that hold a comma stand in quotes)");
    Some(Text { position: position?, size: size? / scale.metre, text: text?, colour: colour? })
}

/// A row that is a block and nothing more: where it is, in metres.
pub(super) fn rectangle(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Aabb> {
    let row: BlockRow = record.row();
    bounds(record, place!(row), scale, problems)
}

/// The cells x, y, width and height, in metres.
pub(super) fn bounds(record: &Record, place: [Given; 4], scale: Scale, problems: &mut Vec<Problem>) -> Option<Aabb> {
    let (min, max) = pixels(record, place, scale, problems)?;
    Some(scale.rectangle(min, max))
}

/// The cells x, y, width and height as two corners in pixels.
fn pixels(record: &Record, place: [Given; 4], scale: Scale, problems: &mut Vec<Problem>) -> Option<(DVec2, DVec2)> {
    let [x, y, width, height] = place;
    let x = record.number(x, scale.coordinate(), problems);
    let y = record.number(y, scale.coordinate(), problems);
    let width = record.number(width, scale.size(), problems);
    let height = record.number(height, scale.size(), problems);
    let min = DVec2::new(x?, y?);
    Some((min, min + DVec2::new(width?, height?)))
}

/// The cells x and y, in metres.
pub(super) fn point(record: &Record, [x, y]: [Given; 2], scale: Scale, problems: &mut Vec<Problem>) -> Option<DVec2> {
    let x = record.number(x, scale.coordinate(), problems);
    let y = record.number(y, scale.coordinate(), problems);
    Some(scale.metres(x?, y?))
}

/// The cells vx and vy, m/s.
fn velocity(record: &Record, [x, y]: [Given; 2], problems: &mut Vec<Problem>) -> Option<DVec2> {
    let x = record.number_or(x, 0.0, q::VELOCITY, problems);
    let y = record.number_or(y, 0.0, q::VELOCITY, problems);
    Some(DVec2::new(x?, y?))
}

/// The cell material, Asphalt where it is left out.
pub(super) fn material(record: &Record, cell: Given, problems: &mut Vec<Problem>) -> Option<Material> {
    if !cell.1.is_given() {
        return Some(Material::ASPHALT);
    }
    let names = Material::ALL.map(|material| material.name).join(", ");
    record.parse(cell, problems, |name| {
        let known = || Material::ALL.iter().map(|material| material.name);
        Material::named(name).ok_or_else(|| format!("one of {names}{}", meant(name, known())))
    })
}

/// The cells r, g and b, which may be left out together.
fn colour_if_given(record: &Record, cells: [Given; 3], problems: &mut Vec<Problem>) -> Option<Option<[u8; 3]>> {
    if cells.iter().all(|(_, text)| !text.is_given()) {
        return Some(None);
    }
    let before = problems.len();
    let colour = colour(record, cells, None, problems);
    // A cell that is no colour says enough.
    if let (Some((column, _)), true) = (cells.iter().find(|(_, text)| text.as_str().is_none()), problems.len() == before) {
        problems.push(record.problem(column, "nothing", COLOURS));
    }
    colour.map(Some)
}

/// What is expected of a colour's channel.
const COLOURS: &str = "a whole number from 0 to 255";

/// The cells r, g and b; required where there is no default.
fn colour(record: &Record, cells: [Given; 3], default: Option<[u8; 3]>, problems: &mut Vec<Problem>) -> Option<[u8; 3]> {
    let channels = [0, 1, 2].map(|i| match default {
        Some(default) if !cells[i].1.is_given() => Some(default[i]),
        _ => record.parse(cells[i], problems, |text| match q::COLOUR.parse(text) {
            // In range and whole, so the conversion is exact.
            Ok(value) if value.fract() == 0.0 => Ok(value as u8),
            _ => Err(COLOURS.into()),
        }),
    });
    let [r, g, b] = channels;
    Some([r?, g?, b?])
}
