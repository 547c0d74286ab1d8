//! `resultant run`: plays a level without a window, and writes the telemetry, state and forces of each object tick by tick, and the file of forces.

use super::files::{CsvOutput, OutputFile, Staged};
use super::{CommandError, Status, project::Project};
use crate::game::{Game, Inputs, MOST_TICKS, Outcome, Recorder, SHIP, TICK_RATE, obstacle_name, source_name};
use crate::number::{Pair, Shortest, pair};
use crate::physics::{BodyId, DVec2, ForceKind, Impulse, Obstacle, World};
use crate::{files::INPUTS, level::FILES};
use serde::Serialize;
use std::io::{self, Write};
use std::{ffi::OsString, ops::RangeInclusive, path::PathBuf};

/// Of a run without inputs, s.
const DEFAULT_SECONDS: f64 = 10.0;
/// Hz.
const RATES: RangeInclusive<f64> = 30.0..=480.0;
/// A time this little above a whole number of ticks is that number, ticks: 0.1 s is no binary number. Larger, and a run could end visibly early.
const WHOLE_TICK: f64 = 1e-6;

#[derive(clap::Args, Debug)]
#[command(
    after_long_help = "Prints key=value: outcome (completed, failed, running), time (s, from the first tick with an input; from the start where there is none), score, objectives (met/all), \
    collisions (damaging), fuel (fraction left), ticks, hash (of the whole state), x and y (where the ship's centre ended, m \
    from the level's top left corner) and, when it failed, killed_by (obstacle N: the Nth row of obstacles.csv; crushed by …: what \
    squeezed the ship). With --diagnostics a line guard_NAME=COUNT for each guard of the engine follows.\n\n\
    A file of forces has a row a force a tick: tick,time,object,kind,by,x,y,point_x,point_y, in N and m, y counted downwards. by is \
    gravity, engine, air, stream N, fluid N, world N (the Nth row of hazards.csv, fluids.csv, world.csv), hazard N (the source block of \
    stream N), edge left, right, top or bottom, or object N (as in the telemetry; 0 is the ship). Rows of the kind impact tell what \
    an impact since the tick before passed on, in N·s.\n\n\
    The output - is standard output.\n\n\
    An inputs file is a CSV with the header ticks,thrust,reverse,left,right; each row holds its keys (0 or 1) for that many \
    ticks. After the last row nothing is pressed."
)]
pub struct RunArgs {
    /// A name under levels/, or a level's folder
    level: OsString,
    /// What is pressed when
    #[arg(long, value_name = "FILE")]
    inputs: Option<PathBuf>,
    /// How long to play unless the level ends before [default: until the inputs end; without inputs 10]
    #[arg(long, value_name = "S", value_parser = parse_seconds, allow_negative_numbers = true)]
    seconds: Option<f64>,
    /// Ticks a second
    #[arg(long, value_name = "HZ", value_parser = parse_tick_rate, allow_negative_numbers = true, default_value_t = TICK_RATE)]
    tick: f64,
    /// Write where everything is and what acts on it, a CSV row an object a tick
    #[arg(long, value_name = "OUT.csv")]
    telemetry: Option<PathBuf>,
    /// Write every single force and impact, what exerts it and where it acts, a CSV row a force a tick
    #[arg(long, value_name = "OUT.csv")]
    forces: Option<PathBuf>,
    /// Print how often each guard of the engine acted
    #[arg(long)]
    diagnostics: bool,
    /// Write the run as a replay, for `verify`
    #[arg(long, value_name = "OUT.csv")]
    record: Option<PathBuf>,
}

fn parse_seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| *seconds >= 0.0 && seconds.is_finite());
    seconds.ok_or_else(|| "expected seconds, 0 or more".into())
}

fn parse_tick_rate(text: &str) -> Result<f64, String> {
    let rate = text.parse().ok().filter(|rate| RATES.contains(rate));
    rate.ok_or_else(|| format!("expected {} to {} ticks a second", RATES.start(), RATES.end()))
}

/// Plays until the level or the time ends. Errors: a refused level or inputs, more than [`MOST_TICKS`], an output that cannot be written or is an
/// input; nothing was run then.
pub fn run(args: &RunArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let level = project.load_level(&args.level)?;
    let parsed = |path: &PathBuf| {
        Inputs::parse(&path.display().to_string(), &project.read_text(path, INPUTS)?).map_err(CommandError::refused)
    };
    let inputs = args.inputs.as_ref().map(parsed).transpose()?;
    let last = last_tick(args, inputs.as_ref())?;
    let folder = project.level_folder(&args.level)?;
    // Also a background that is not there yet.
    let mut read: Vec<PathBuf> = FILES.iter().map(|file| folder.join(file)).chain(level.pictures().cloned()).collect();
    read.extend(args.inputs.iter().map(|path| project.input(path)));
    let mut game = Game::with_tick_rate(level, args.tick).map_err(CommandError::refused)?;
    let outputs =
        [("--telemetry", args.telemetry.as_deref()), ("--forces", args.forces.as_deref()), ("--record", args.record.as_deref())];
    let [telemetry, forces, record] = OutputFile::create_all(outputs, &read)?;
    let mut tables = [
        telemetry.map(|file| CsvOutput::new(file, &header())).transpose()?,
        forces.map(|file| CsvOutput::new(file, HEADER)).transpose()?,
    ];
    let flown = fly(&mut game, inputs.unwrap_or_default(), last, &mut tables)?;
    let stage = |table: CsvOutput<OutputFile>| table.into_inner()?.stage();
    let mut staged = tables.into_iter().flatten().map(stage).collect::<Result<Vec<_>, CommandError>>()?;
    if let Some(mut file) = record {
        write!(file, "{}", flown.finish(&game))?;
        staged.push(file.stage()?);
    }
    print(&game, out)?;
    if args.diagnostics {
        for (name, count) in game.world().guards().all() {
            writeln!(out, "guard_{name}={count}")?;
        }
    }
    // If the results cannot be printed, no file changes either.
    out.flush()?;
    Staged::place_all(staged)?;
    Ok(Status::Done)
}

fn last_tick(args: &RunArgs, inputs: Option<&Inputs>) -> Result<u64, CommandError> {
    let seconds = match (args.seconds, inputs) {
        (Some(seconds), _) => seconds,
        (None, Some(inputs)) => return Ok(inputs.ticks()),
        (None, None) => DEFAULT_SECONDS,
    };
    let ticks = (seconds * args.tick - WHOLE_TICK).ceil().max(0.0);
    if ticks > MOST_TICKS as f64 {
        let RunArgs { tick, .. } = args;
        return Err(CommandError::Refused(format!("{seconds} s of {tick} ticks a second, expected at most {MOST_TICKS} ticks")));
    }
    Ok(ticks as u64)
}

/// The telemetry and the forces of a run in flight.
type Tables = [Option<CsvOutput<OutputFile>>; 2];

fn write_tick([telemetry, forces]: &mut Tables, game: &Game) -> io::Result<()> {
    telemetry.iter_mut().try_for_each(|table| write_bodies(table, game))?;
    forces.iter_mut().try_for_each(|table| write_forces(table, game))
}

fn fly(game: &mut Game, inputs: Inputs, last: u64, tables: &mut Tables) -> io::Result<Recorder> {
    write_tick(tables, game)?;
    let mut flown = Recorder::default();
    let mut playback = inputs.into_iter();
    while game.outcome() == Outcome::Running && game.ticks() < last {
        let controls = playback.next().unwrap_or_default();
        game.step(controls);
        flown.note(game, controls);
        write_tick(tables, game)?;
    }
    Ok(flown)
}

fn print(game: &Game, out: &mut dyn Write) -> io::Result<()> {
    let result = game.result();
    writeln!(out, "outcome={}\ntime={}\nscore={}", result.outcome.name(), Shortest(result.time), result.score.total)?;
    writeln!(out, "objectives={}/{}\ncollisions={}", result.objectives_met, result.objectives_all, result.collisions)?;
    writeln!(out, "fuel={}\nticks={}\nhash={:016x}", Shortest(result.fuel), game.ticks(), game.hash())?;
    let place = game.world().body(SHIP).position;
    writeln!(out, "x={}\ny={}", Shortest(place.x), Shortest(place.y))?;
    game.killed_by().map_or(Ok(()), |death| writeln!(out, "killed_by={}", death.name(game.level())))
}

pub fn header() -> String {
    let forces = ForceKind::ALL.map(|kind| format!("{0}_x,{0}_y,", column(kind))).concat();
    format!("tick,time,object,kind,x,y,vx,vy,ax,ay,angle,fuel,resultant_x,resultant_y,{forces}impulse_x,impulse_y")
}

/// Metres, m/s, m/s², N, degrees; an object has angle and fuel 0. A row describes its own instant, with the engine's drive of the
/// tick before it; only the impulse (N·s) sums all impacts since the row before.
#[derive(Serialize)]
struct BodyRow {
    tick: u64,
    time: Shortest,
    object: u32,
    kind: &'static str,
    position: Pair,
    velocity: Pair,
    acceleration: Pair,
    angle: Shortest,
    fuel: Shortest,
    resultant: Pair,
    forces: [Pair; ForceKind::ALL.len()],
    impulse: Pair,
}

/// A row an object: the ship, then the objects in the level's order.
fn write_bodies(table: &mut CsvOutput<OutputFile>, game: &Game) -> io::Result<()> {
    let (ship, impulses) = (game.ship(), impulses(game.world()));
    table.row(&row(game, (SHIP, impulses[0]), "ship", (ship.angle, ship.fuel)))?;
    for ((body, object), impulse) in (1..).zip(&game.level().objects).zip(&impulses[1..]) {
        let kind = if object.key.is_some() { "key" } else { "object" };
        table.row(&row(game, (BodyId(body), *impulse), kind, (0.0, 0.0)))?;
    }
    Ok(())
}

/// N·s: the sum of the last tick's impacts on each body.
fn impulses(world: &World) -> Vec<DVec2> {
    let mut sums = vec![DVec2::ZERO; world.bodies().len()];
    for impulse in world.impulses() {
        sums[impulse.a.index()] += impulse.vector;
        if let Obstacle::Body(b) = impulse.b {
            sums[b.index()] -= impulse.vector;
        }
    }
    sums
}

/// A kind of force in the names of columns and rows.
pub fn column(kind: ForceKind) -> String {
    kind.name().to_lowercase().replace(' ', "_")
}

fn row(game: &Game, (id, impulse): (BodyId, DVec2), kind: &'static str, (angle, fuel): (f64, f64)) -> BodyRow {
    let (body, forces) = (game.world().body(id), game.world().forces(id));
    BodyRow {
        tick: game.ticks(),
        time: Shortest(game.elapsed()),
        object: id.0,
        kind,
        position: pair(body.position),
        velocity: pair(body.velocity),
        acceleration: pair(body.acceleration),
        angle: Shortest(angle),
        fuel: Shortest(fuel),
        resultant: pair(forces.resultant()),
        forces: ForceKind::ALL.map(|kind| pair(forces.total(kind))),
        impulse: pair(impulse),
    }
}

pub const HEADER: &str = "tick,time,object,kind,by,x,y,point_x,point_y";
/// The kind of an impact, whose vector is an impulse, N·s.
const IMPACT: &str = "impact";
/// And that of what a contact had passed on in the tick in which it ended.
const ENDED: &str = "ended_contact";

/// Objects have the telemetry's numbers; N (an impact: N·s) and metres.
#[derive(Serialize)]
struct ForceRow<'a> {
    tick: u64,
    time: Shortest,
    object: u32,
    kind: &'a str,
    by: &'a str,
    vector: Pair,
    point: Pair,
}

/// For each object of the current tick, the forces at this instant and then the impacts since the tick before, in time order.
fn write_forces(table: &mut CsvOutput<OutputFile>, game: &Game) -> io::Result<()> {
    let (world, level) = (game.world(), game.level());
    let (tick, time) = (game.ticks(), Shortest(game.elapsed()));
    for object in 0..world.bodies().len() as u32 {
        let id = BodyId(object);
        let mut write = |kind: &str, by: &str, vector: DVec2, point: DVec2| {
            // Adding zero turns −0 into 0.
            let vector = pair(vector + DVec2::ZERO);
            table.row(&ForceRow { tick, time, object, kind, by, vector, point: pair(point) })
        };
        for force in world.forces(id).forces() {
            write(&column(force.kind), &source_name(level, force.source), force.vector, force.point)?;
        }
        let felt = |impulse: &Impulse| Some((impulse.on(id)?, impulse.point, if impulse.impact { IMPACT } else { ENDED }));
        for ((vector, by), point, kind) in world.impulses().iter().filter_map(felt) {
            write(kind, &obstacle_name(level, by), vector, point)?;
        }
    }
    Ok(())
}
