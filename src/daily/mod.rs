//! The daily flight: a date (UTC) seeds one level of proven rooms. The level is read like any other, and the autopilot flies it to its
//! end before it is offered. The same date gives the same level on every machine.

mod date;
mod rooms;

pub use date::{Date, is_daily, time_of};

use crate::autopilot::{FlightPlan, fly};
use crate::files::{self, create_folder};
use crate::game::{Outcome, Replay};
use crate::level::{self, Files, Landscape, Level, scaffold};
use crate::words::tr;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use rooms::{FLOOR, HallRows, ROOF, ROOMS};
use std::io;
use std::path::Path;
use std::sync::Arc;

/// Rooms a level.
const COUNT: usize = 4;
/// Levels that a date may try, and plans for each.
const LEVELS: u64 = 20;
const PLANS: usize = 40;
/// No proof takes longer, s.
const LONGEST: f64 = 60.0;
/// The ship's share of the autopilot's time for silver.
const SPARE: f64 = 1.3;

/// A daily level with the flight that proves it.
#[derive(Debug)]
pub struct Daily {
    pub level: Arc<Level>,
    /// The files of its folder.
    pub files: Vec<(&'static str, String)>,
    pub proof: Replay,
}

struct InMemory<'a>(&'a [(&'static str, String)]);

impl Files for InMemory<'_> {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        let found = self.0.iter().find(|(file, _)| *file == name);
        found.map(|(_, text)| text.clone().into_bytes()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn project_file(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

impl Daily {
    /// The level of a date. Errors: none of the levels that the date tries is proven.
    pub fn of(date: Date) -> Result<Self, String> {
        let name = date.level_name();
        (0..LEVELS).find_map(|attempt| proven(&name, date, attempt)).ok_or_else(|| tr!("No level of {date} could be proven.", date))
    }

    /// Makes its folder in `levels` where there is none yet; the answer is its name.
    /// Errors: as the loader's and the disk's, in words; no part of the folder is left behind.
    pub fn install(date: Date, levels: &Path) -> Result<String, String> {
        let name = date.level_name();
        if !files::is_folder(&levels.join(&name)) {
            let daily = Self::of(date)?;
            let cannot = |error: io::Error| tr!("Cannot make {path}: {error}", path = levels.join(&name).display(), error);
            scaffold::make(levels, &name, &daily.files).map_err(cannot)?;
            let proof = |folder: &Path| files::put(&folder.join("careful.replay.csv"), daily.proof.to_string().as_bytes());
            create_folder(&levels.join(&name).join("flights"), proof).map_err(cannot)?;
        }
        Ok(name)
    }
}

/// The level of an attempt, where it loads without a warning and a plan completes it without a damaging hit.
fn proven(name: &str, date: Date, attempt: u64) -> Option<Daily> {
    let mut random = Pcg32::seed_from_u64(date.days() * LEVELS + attempt);
    let mut order = ROOMS;
    order.shuffle(&mut random);
    let mut rows = HallRows { x: 360, ..HallRows::default() };
    order.iter().take(COUNT).for_each(|room| room(&mut rows, &mut random));
    let landscape = ["launch", "quarry", "wind", "water", "orbit"][random.random_range(0..Landscape::ALL.len())];
    let mut plan = FlightPlan::parse(&plan_text(&rows)).ok()?;
    for _ in 0..PLANS {
        let files = files_of(&rows, date, (landscape, LONGEST));
        let level = level::read(name, &InMemory(&files)).ok().filter(|loaded| loaded.warnings.is_empty())?.level;
        let (game, _) = fly(&Arc::new(level), &plan, LONGEST).ok()?;
        if game.outcome() == Outcome::Completed && game.collisions() == 0 {
            return finished(name, date, (&rows, landscape), &plan);
        }
        plan = plan.varied(&mut random);
    }
    None
}

/// The level with the times that the proof's own time gives. Medals and the time that scores best change no flight.
fn finished(name: &str, date: Date, (rows, landscape): (&HallRows, &str), plan: &FlightPlan) -> Option<Daily> {
    let level_for = |time: f64| {
        let files = files_of(rows, date, (landscape, time));
        let level = Arc::new(level::read(name, &InMemory(&files)).ok()?.level);
        Some((files, level))
    };
    let (game, _) = fly(&level_for(LONGEST)?.1, plan, LONGEST).ok()?;
    let (files, level) = level_for((SPARE * game.time()).ceil())?;
    let (game, recorder) = fly(&level, plan, LONGEST).ok()?;
    Some(Daily { proof: recorder.finish(&game), level, files })
}

fn plan_text(rows: &HallRows) -> String {
    let (end, landing) = (rows.x + 240, FLOOR as f64 - 25.5);
    format!(
        "par,{LONGEST}\ntop_speed,5\ntilt,70\nstep,x,y,speed,tolerance,object,seconds\nfly,200,480,2,60\n{}fly,{end},600,2,60\nland,{end},{landing},1,50\n",
        rows.plan
    )
}

/// `time` (s) is the time for silver and that which scores best.
fn files_of(rows: &HallRows, date: Date, (landscape, time): (&str, f64)) -> Vec<(&'static str, String)> {
    let width = rows.x + 420;
    let size = format!("width,{width}\nheight,960\ngravity,10\nair_density,1.2041");
    let table = |header: &str, rows: &str| format!("{header}\n{rows}");
    let outer = format!(
        "0,0,{width},{ROOF}\n0,{FLOOR},{width},120\n0,{ROOF},60,{}\n{},{ROOF},60,{}\n",
        FLOOR - ROOF,
        width - 60,
        FLOOR - ROOF
    );
    let pad = format!("PLAYER,{},{},150,30,0.5\n", rows.x + 165, FLOOR - 30);
    let files = [
        (
            "constants.csv",
            format!("name,value\ntitle,Flight of {date}\nworld,{landscape}\n{size}\noptimal_time,{time}\nsilver,{time}\n"),
        ),
        ("player.csv", "x,y,mass,fuel,thrust,air\n180,814.5,100,1500,2000,TRUE\n".to_owned()),
        ("world.csv", table("x,y,width,height", &(outer + &rows.world))),
        ("objectives.csv", table("kind,x,y,width,height,hold", &pad)),
        ("obstacles.csv", table("x,y,width,height", &rows.obstacles)),
        ("hazards.csv", table("x,y,width,height,stream_width,stream_height,force_x,force_y", &rows.hazards)),
        ("fluids.csv", table("x,y,width,height,density,viscosity", &rows.fluids)),
        ("gravity.csv", table("x,y,width,height,field_x,field_y", &rows.gravity)),
        ("switches.csv", table("x,y,width,height,works,weight,by,stays", &rows.switches)),
        ("doors.csv", table("x,y,width,height,name", &rows.doors)),
    ];
    // A table without a row is left out.
    files.into_iter().filter(|(_, text)| text.lines().count() > 1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_date_has_one_level_that_its_own_flight_completes() {
        for days in 20_780..20_795 {
            let date = Date::of_days(days);
            let daily = Daily::of(date).unwrap();
            assert!(level::judge_name(&daily.level.name).is_ok());
            assert_eq!(daily.proof.outcome, Outcome::Completed);
            assert!(daily.proof.verify(Arc::clone(&daily.level), |_| {}).unwrap().is_ok(), "{date}");
            assert!(daily.proof.code().is_ok(), "{date}");
            let again = Daily::of(date).unwrap();
            assert_eq!((again.files, again.proof), (daily.files, daily.proof), "{date}");
        }
    }

    #[test]
    fn a_folder_is_made_once() {
        let levels = tempfile::tempdir().unwrap();
        let date = Date::of_days(20_781);
        let name = Daily::install(date, levels.path()).unwrap();
        let loaded = level::load(&levels.path().join(&name), levels.path()).unwrap();
        assert_eq!(loaded.warnings, []);
        std::fs::write(levels.path().join(&name).join("texts.csv"), "x,y,size,text\n").unwrap();
        assert_eq!(Daily::install(date, levels.path()), Ok(name.clone()));
        assert!(levels.path().join(&name).join("texts.csv").is_file());
    }
}
