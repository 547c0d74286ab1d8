//! Levels with other numbers: judged by the loader's rules, and written into their files.

use super::document::{Document, RowId, SetCell};
use super::links::{self, TooMuch};
use super::schema::{Kind, Table};
use super::types::{Level, Mover, SHIP_HALF};
use super::{numbers as q, parameter::Parameter, problem::Problem, reach::OVERLAP};
use crate::physics::{Aabb, BodyId, DVec2, Sides, WorldDef};
use crate::words::tr;

/// The level with other numbers, judged by the loader's rules. Errors: every number that is not accepted, by file and column, with line 0.
pub fn varied(level: &Level, changes: &[(Parameter, f64)]) -> Result<Level, Vec<Problem>> {
    let mut problems = Vec::new();
    let mut refuse = |parameter: Parameter, found: String, expected: String| {
        let (table, column) = parameter.place(level);
        problems.push(Problem::new(table.file(), 0, column, found, expected));
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
        } else if let Err(expected) = parameter.put(&mut varied, *value) {
            refuse(*parameter, value.to_string(), expected);
        }
    }
    if let Some((parameter, _)) = changes.iter().find(|(parameter, _)| parameter.moves())
        && problems_of_places(&varied)
    {
        refuse(
            *parameter,
            tr("something outside of the level, or inside another one").to_owned(),
            tr("a start in free space").to_owned(),
        );
    }
    let changed = |parameter: &Parameter| changes.iter().any(|(changed, _)| changed == parameter);
    let (thrust, mass) = (varied.player.thrust, varied.player.mass);
    if let Some(expected) = links::judge(thrust, mass) {
        let parameter = if changed(&Parameter::Thrust) { Parameter::Thrust } else { Parameter::Mass(0) };
        refuse(parameter, tr!("{thrust} N on a ship of {mass} kg", thrust, mass), expected);
    }
    let lightest = varied.objects.iter().map(|object| object.mass).fold(mass, f64::min);
    let strongest = varied.streams.iter().map(|stream| stream.force.abs().max_element()).fold(0.0, f64::max);
    if let Err(expected) = q::FORCE.judge(strongest) {
        refuse(Parameter::Wind, format!("{strongest} N"), expected);
    } else if let Some(expected) = links::judge(strongest, lightest) {
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

/// Whether a body or a mover leaves the level, or a body starts in a solid or another body.
fn problems_of_places(level: &Level) -> bool {
    let WorldDef { surfaces, bodies, .. } = level.world_def();
    let solids = surfaces.iter().filter(|surface| surface.present && surface.sides == Sides::ALL).map(|surface| surface.bounds);
    let first = usize::from(!level.ship_plays());
    let bodies: Vec<Aabb> = bodies[first..].iter().map(|body| Aabb::around(body.position, body.half)).collect();
    let mut things: Vec<Aabb> = solids.collect();
    let stops = |mover: &Mover| {
        let half = mover.solid.bounds.size() * 0.5;
        mover.stops.iter().map(move |stop| Aabb::around(*stop, half)).collect::<Vec<_>>()
    };
    let leaves = |thing: &Aabb| !level.bounds().contains(thing, OVERLAP);
    let stands = |stops: &[DVec2]| stops.windows(2).any(|pair| pair[0].distance(pair[1]) < q::MIN_SIZE);
    let inside = bodies.iter().any(|body| {
        let inside = leaves(body) || things.iter().any(|other| other.overlaps(body, OVERLAP));
        things.push(*body);
        inside
    });
    inside || level.movers.iter().any(|mover| stands(&mover.stops) || stops(mover).iter().any(leaves))
}

impl Document {
    /// Writes the parameters of a varied level into the cells of its files. Errors: as [`Document::set`]; a body or stream without a row.
    pub fn vary(&mut self, varied: &Level, parameters: &[Parameter], gesture: Option<u64>) -> Result<(), String> {
        let mut cells = Vec::new();
        let twice = |of: &&Parameter| matches!(of, Parameter::Stream(_)) && parameters.contains(&Parameter::Wind);
        for parameter in parameters.iter().filter(|of| !twice(of)) {
            let (table, column) = parameter.place(varied);
            if let Parameter::Wind | Parameter::Stream(_) = parameter {
                let own = |(i, _): &(usize, _)| parameter.thing().is_none_or(|thing| thing == *i);
                for (_, (row, stream)) in self.rows(Table::Hazards).zip(&varied.streams).enumerate().filter(own) {
                    let cell = |column, force: f64| SetCell { row, column, text: force.to_string() };
                    cells.extend([cell("force_x", stream.force.x), cell("force_y", stream.force.y)]);
                }
                continue;
            }
            let text = parameter.text(varied).ok_or(tr("there is no such object"))?;
            let row = match (parameter.body(), parameter.thing()) {
                (Some(body), _) => self.row_of(body),
                (None, Some(thing)) => self.rows(table).nth(thing),
                (None, None) => {
                    self.set_setting(column, &text, gesture)?;
                    continue;
                }
            };
            cells.push(SetCell { row: row.ok_or(tr("there is no such row any more"))?, column, text });
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
