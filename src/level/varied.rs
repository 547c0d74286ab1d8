//! The numbers of a level that can be varied, each with the loader's limits and its cells.

use super::document::{Document, RowId, SetCell};
use super::links::{self, TooMuch};
use super::numbers::{self as q, NumberRange};
use super::problem::Problem;
use super::schema::{Kind, Table};
use super::types::{Level, Object, SHIP_HALF};
use super::winnable;
use crate::physics::BodyId;
use crate::words::tr;

/// Bodies are counted as in the level's world: 0 is the ship, i + 1 is object i.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Parameter {
    /// kg.
    Mass(usize),
    Drag(usize),
    /// Coefficient, 0 … 1.
    Restitution(usize),
    /// At the start, m/s to the right.
    VelocityX(usize),
    /// At the start, m/s upwards.
    VelocityY(usize),
    /// N.
    Thrust,
    /// N/kg, downwards.
    Gravity,
    /// kg/m³.
    Air,
    /// Factor of all coefficients of friction.
    Friction,
    /// Factor of the forces of all air streams, 1 in the unvaried level.
    Wind,
}

impl Parameter {
    /// The parameters of a body of the level, and of the level.
    pub fn all(level: &Level, body: usize) -> Vec<Self> {
        let mut all = Vec::new();
        if Self::Mass(body).of(level).is_some() {
            all.push(Self::Mass(body));
            all.extend((body == 0).then_some(Self::Thrust));
            all.extend([Self::VelocityX, Self::VelocityY, Self::Restitution, Self::Drag].map(|of| of(body)));
        }
        all.extend([Self::Gravity, Self::Air, Self::Friction]);
        all.extend((!level.streams.is_empty()).then_some(Self::Wind));
        all
    }

    /// Its label, its accepted numbers and its column.
    const fn facts(self) -> (&'static str, NumberRange, &'static str) {
        match self {
            Self::Mass(_) => ("Mass", q::MASS, "mass"),
            Self::Drag(_) => ("Drag coefficient", q::DRAG, "drag"),
            Self::Restitution(_) => ("Restitution", q::RESTITUTION, "restitution"),
            Self::VelocityX(_) => ("Start velocity →", q::VELOCITY, "vx"),
            Self::VelocityY(_) => ("Start velocity ↑", q::VELOCITY, "vy"),
            Self::Thrust => ("Thrust", q::THRUST, "thrust"),
            Self::Gravity => ("Gravity", q::GRAVITY, "gravity"),
            Self::Air => ("Air density", q::AIR_DENSITY, "air_density"),
            Self::Friction => ("All friction ×", q::FRICTION, "friction"),
            Self::Wind => ("All wind ×", q::WIND, "force_x"),
        }
    }

    pub const fn name(self) -> &'static str {
        self.facts().0
    }

    /// Empty where it has none.
    pub const fn unit(self) -> &'static str {
        self.facts().1.unit
    }

    pub const fn body(self) -> Option<usize> {
        match self {
            Self::Mass(i) | Self::Drag(i) | Self::Restitution(i) | Self::VelocityX(i) | Self::VelocityY(i) => Some(i),
            Self::Thrust => Some(0),
            Self::Gravity | Self::Air | Self::Friction | Self::Wind => None,
        }
    }

    /// Whether only a flight from its start shows its effect.
    pub const fn is_of_the_start(self) -> bool {
        matches!(self, Self::VelocityX(_) | Self::VelocityY(_))
    }

    /// The least and the most that it may be.
    pub const fn limits(self) -> (f64, f64) {
        let (_, range, _) = self.facts();
        (range.low, range.high)
    }

    /// The number that a text holds, as in a level's file.
    /// Errors: the number that is expected instead, in words.
    pub fn parse(self, text: &str) -> Result<f64, String> {
        // The game itself writes a true minus.
        self.facts().1.parse(&text.trim().replace('−', "-"))
    }

    /// Its value; `None` where the level has no such body, as an experiment has no ship.
    pub fn of(self, level: &Level) -> Option<f64> {
        let (player, object) = (&level.player, |i: usize| level.objects.get(i - 1));
        let of_ship = |value: f64| level.ship_plays().then_some(value);
        let of = |i: usize, ship: f64, value: fn(&Object) -> f64| if i == 0 { of_ship(ship) } else { object(i).map(value) };
        match self {
            Self::Mass(i) => of(i, player.mass, |object| object.mass),
            Self::Drag(i) => of(i, player.drag, |object| object.drag),
            Self::Restitution(i) => of(i, player.restitution, |object| object.restitution),
            Self::VelocityX(i) => of(i, player.velocity.x, |object| object.velocity.x),
            // Adding zero turns a negative zero into zero.
            Self::VelocityY(i) => of(i, player.velocity.y, |object| object.velocity.y).map(|down| 0.0 - down),
            Self::Thrust => of_ship(player.thrust),
            Self::Gravity => Some(level.gravity),
            Self::Air => Some(level.air_density),
            Self::Friction => Some(level.friction),
            Self::Wind => Some(1.0),
        }
    }

    fn put(self, level: &mut Level, value: f64) {
        let (player, objects) = (&mut level.player, &mut level.objects);
        macro_rules! field {
            ($i:ident, $($field:ident).+, $value:expr) => {
                match $i {
                    0 => player.$($field).+ = $value,
                    _ => objects[$i - 1].$($field).+ = $value,
                }
            };
        }
        match self {
            Self::Mass(i) => field!(i, mass, value),
            Self::Drag(i) => field!(i, drag, value),
            Self::Restitution(i) => field!(i, restitution, value),
            Self::VelocityX(i) => field!(i, velocity.x, value),
            Self::VelocityY(i) => field!(i, velocity.y, 0.0 - value),
            Self::Thrust => player.thrust = value,
            Self::Gravity => level.gravity = value,
            Self::Air => level.air_density = value,
            Self::Friction => level.friction = value,
            Self::Wind => level.streams.iter_mut().for_each(|stream| stream.force *= value),
        }
    }

    /// Its file and its column.
    fn place(self, level: &Level) -> (&'static str, &'static str) {
        let is_key = |body: usize| level.objects.get(body - 1).is_some_and(|object| object.key.is_some());
        let table = match self.body() {
            None if self == Self::Wind => Table::Hazards,
            None => Table::Constants,
            Some(0) => Table::Player,
            Some(body) if is_key(body) => Table::Objectives,
            Some(_) => Table::Objects,
        };
        (table.file(), self.facts().2)
    }
}

/// The level with other numbers, judged by the loader's rules.
/// Errors: every number that is not accepted, by file and column, with line 0.
pub fn varied(level: &Level, changes: &[(Parameter, f64)]) -> Result<Level, Vec<Problem>> {
    let mut problems = Vec::new();
    let mut refuse = |parameter: Parameter, found: String, expected: String| {
        let (file, column) = parameter.place(level);
        problems.push(Problem::new(file, 0, column, found, expected));
    };
    let mut varied = level.clone();
    for (parameter, value) in changes {
        if parameter.of(level).is_none() {
            refuse(
                *parameter,
                tr!("no object {number}", number = parameter.body().unwrap_or_default()),
                tr("an object of the level").to_owned(),
            );
        } else if let Err(expected) = parameter.facts().1.judge(*value) {
            refuse(*parameter, value.to_string(), expected);
        } else {
            parameter.put(&mut varied, *value);
        }
    }
    let changed = |parameter: &Parameter| changes.iter().any(|(changed, _)| changed == parameter);
    let (thrust, mass) = (varied.player.thrust, varied.player.mass);
    if let Some(expected) = winnable::judge(thrust, mass) {
        let parameter = if changed(&Parameter::Thrust) { Parameter::Thrust } else { Parameter::Mass(0) };
        refuse(parameter, tr!("{thrust} N on a ship of {mass} kg", thrust, mass), expected);
    }
    let lightest = varied.objects.iter().map(|object| object.mass).fold(mass, f64::min);
    let strongest = varied.streams.iter().map(|stream| stream.force.abs().max_element()).fold(0.0, f64::max);
    if let Err(expected) = q::FORCE.judge(strongest) {
        refuse(Parameter::Wind, format!("{strongest} N"), expected);
    } else if let Some(expected) = winnable::judge(strongest, lightest) {
        refuse(Parameter::Wind, tr!("{force} N on {mass} kg", force = strongest, mass = lightest), expected);
    }
    let body = |body: BodyId| match body.index().checked_sub(1) {
        None => Some((mass, SHIP_HALF)),
        Some(object) => varied.objects.get(object).map(|object| (object.mass, object.size * 0.5)),
    };
    let mut loads = vec![(0.0, 0.0); varied.objects.len() + 1];
    for link in &varied.links {
        if let Some(TooMuch { body, found, expected, .. }) = links::load(&link.def, &mut loads, body) {
            refuse(Parameter::Mass(body.index()), found, expected);
        }
    }
    if problems.is_empty() { Ok(varied) } else { Err(problems) }
}

impl Document {
    /// Writes the parameters of a varied level into the cells of its files.
    /// Errors: as [`Document::set`]; a body or stream without a row.
    pub fn vary(&mut self, varied: &Level, parameters: &[Parameter], gesture: Option<u64>) -> Result<(), String> {
        let mut cells = Vec::new();
        for parameter in parameters {
            let (_, column) = parameter.place(varied);
            let value = match parameter {
                Parameter::Wind => {
                    for (row, stream) in self.rows(Table::Hazards).zip(&varied.streams) {
                        let cell = |column, force: f64| SetCell { row, column, text: force.to_string() };
                        cells.extend([cell("force_x", stream.force.x), cell("force_y", stream.force.y)]);
                    }
                    continue;
                }
                // The files count y downwards.
                Parameter::VelocityY(_) => parameter.of(varied).map(|up| 0.0 - up),
                _ => parameter.of(varied),
            };
            let text = value.ok_or(tr("there is no such object"))?.to_string();
            match parameter.body() {
                None => self.set_setting(column, &text, gesture)?,
                Some(body) => {
                    cells.push(SetCell { row: self.row_of(body).ok_or(tr("there is no such row any more"))?, column, text })
                }
            }
        }
        self.set(&cells, gesture)
    }

    /// Objects come before key objects, each in the order of their file.
    fn row_of(&self, body: usize) -> Option<RowId> {
        let keys = self.rows(Table::Objectives).filter(|row| self.kind(*row) == Some(Kind::Key));
        match body.checked_sub(1) {
            None => self.rows(Table::Player).next(),
            Some(object) => self.rows(Table::Objects).chain(keys).nth(object),
        }
    }
}
