//! An adversary of levels: it plays one for hours of the level's time, many times over, at random and greedily, and reports places that let
//! no ship go, ways out of the level, broken rules, and ways round the level's idea.

mod player;
mod way;

use super::random::Random;
use player::{Player, Style, wanted};
use resultant::game::{Controls, Game, GameEvent, Outcome, ROTATION_RATE, SHIP};
use resultant::level::Level;
use resultant::physics::{Aabb, DVec2};
use std::fmt;
use std::sync::Arc;
use way::Space;

/// How long an attempt goes on, s.
const LONGEST: f64 = 60.0;
/// Ticks between two checks of every law of the engine; the cheap ones are asked after every tick.
const LAWS: u64 = 20;
/// A ship that has stayed within this distance, m, for so long, s, may be trapped.
const STAYED: (f64, f64) = (3.0, 10.0);
/// A ship that tries to leave for this long, s, and gets no farther than this, m, is trapped.
const ESCAPE: (f64, f64) = (4.0, 4.0);
/// Nobody comes nearer to anything that is wanted in this time, s: there is no way from here.
const WAY_BACK: f64 = 20.0;
/// A level is not to be finished in less than this share of the time for gold.
const CHEAP: f64 = 0.6;
/// Beyond the edge by more than rounding, m.
const OUTSIDE: f64 = 1e-6;
/// Findings of one kind closer together than this, m, are one.
const SAME_PLACE: f64 = 4.0;

/// A kind of finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The ship cannot get anywhere any more, however much fuel there is.
    Trapped,
    /// Something left the level.
    Outside,
    /// A number is none.
    NotFinite,
    /// A rule of the game or a law of the engine does not hold.
    Broken,
    /// The level was finished too fast.
    Cheap,
}

/// Something that was found, and how to see it again.
#[derive(Clone, Debug)]
pub struct Finding {
    pub kind: Kind,
    /// Of the attempt.
    pub seed: u64,
    /// When, s.
    pub time: f64,
    /// Where the ship was, m.
    pub place: DVec2,
    pub what: String,
}

#[derive(Clone, Debug, Default)]
pub struct Report {
    pub attempts: u64,
    /// s of the level's time.
    pub seconds: f64,
    pub completed: u64,
    pub lost: u64,
    /// The shortest time to the end, s.
    pub best: Option<f64>,
    pub findings: Vec<Finding>,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { attempts, seconds, completed, lost, best, findings } = self;
        write!(f, "{attempts} attempts, {:.1} minutes, {completed} completed, {lost} lost", seconds / 60.0)?;
        if let Some(best) = best {
            write!(f, ", the fastest in {best:.2} s")?;
        }
        for Finding { kind, seed, time, place, what } in findings {
            write!(f, "\n  {kind:?} at ({:.1}, {:.1}) m after {time:.2} s, attempt {seed}: {what}", place.x, place.y)?;
        }
        Ok(())
    }
}

/// Plays a level for `seconds` of its time.
pub fn hunt(level: &Arc<Level>, seconds: f64, seed: u64) -> Report {
    let space = Space::of(level);
    let mut report = Report::default();
    while report.seconds < seconds {
        let seed = seed.wrapping_mul(1_000_003).wrapping_add(report.attempts);
        report.attempts += 1;
        attempt(level, &space, seed, &mut report);
    }
    report
}

/// One attempt. Every other wandering one has fuel for ever, and does not count as a way to finish.
fn attempt(level: &Arc<Level>, space: &Space, seed: u64, report: &mut Report) {
    let style = [Style::Greedy, Style::Random, Style::Wander, Style::Greedy][seed as usize % 4];
    let endless = style == Style::Wander;
    let mut player = Player::new(style, seed, space);
    let Ok(mut game) = Game::new(Arc::clone(level)) else { return };
    game.set_lasting_fuel(endless);
    let mut watch = Watch { last: (game.fuel(), 0), stayed: (game.world().body(SHIP).position, 0.0) };
    while game.outcome() == Outcome::Running && game.elapsed() < LONGEST && !game.is_stranded() {
        game.step(player.keys(&game));
        if let Err((kind, what)) = watch.look(&game, space) {
            report.add(&game, (kind, seed), what);
            break;
        }
    }
    report.seconds += game.elapsed();
    report.lost += u64::from(game.outcome() == Outcome::Failed);
    if game.outcome() == Outcome::Completed && !endless {
        report.completed += 1;
        report.best = Some(report.best.map_or(game.time(), |best| best.min(game.time())));
        if let Some(gold) = level.awards.gold.filter(|gold| game.time() < CHEAP * gold) {
            let what = format!("finished in {:.2} s, gold is {gold} s", game.time());
            report.add(&game, (Kind::Cheap, seed), what);
        }
    }
}

impl Report {
    fn add(&mut self, game: &Game, (kind, seed): (Kind, u64), what: String) {
        let place = game.world().body(SHIP).position;
        let known = |other: &Finding| other.kind == kind && other.place.distance(place) < SAME_PLACE;
        if !self.findings.iter().any(known) {
            self.findings.push(Finding { kind, seed, time: game.elapsed(), place, what });
        }
    }
}

/// The record of an attempt, for its checks.
struct Watch {
    /// Fuel and hits a tick ago.
    last: (f64, u32),
    /// Around where the ship has been, and since when, s.
    stayed: (DVec2, f64),
}

impl Watch {
    fn look(&mut self, game: &Game, space: &Space) -> Result<(), (Kind, String)> {
        let bodies = game.world().bodies();
        if let Some(body) = bodies.iter().position(|body| !(body.position.is_finite() && body.velocity.is_finite())) {
            return Err((Kind::NotFinite, format!("body {body}: {:?}", bodies[body])));
        }
        let edge = game.level().bounds();
        if let Some(body) = bodies.iter().position(|body| !edge.contains(&body.bounds(), OUTSIDE)) {
            return Err((Kind::Outside, format!("body {body} is at {}", bodies[body].position)));
        }
        self.rules(game).map_err(|what| (Kind::Broken, what))?;
        let (at, now) = (game.world().body(SHIP).position, game.elapsed());
        if at.distance(self.stayed.0) > STAYED.0 {
            self.stayed = (at, now);
        } else if now - self.stayed.1 > STAYED.1 && game.fuel() > 0.0 {
            self.stayed.1 = now;
            if is_trapped(game, space) {
                return Err((Kind::Trapped, "no keys lead away from here".to_owned()));
            }
        }
        Ok(())
    }

    fn rules(&mut self, game: &Game) -> Result<(), String> {
        let (fuel, hits) = std::mem::replace(&mut self.last, (game.fuel(), game.collisions()));
        let refuelled = game.events().iter().any(|event| matches!(event, GameEvent::Refuelled(_)));
        if game.fuel() > fuel && !refuelled || game.collisions() < hits {
            return Err(format!("fuel {fuel} became {}, {hits} hits became {}", game.fuel(), game.collisions()));
        }
        let result = game.result();
        let all_met = result.objectives_met == result.objectives_all;
        let ended_right = match result.outcome {
            Outcome::Running => !all_met && result.score.total == 0,
            Outcome::Completed => all_met && result.score.total > 0,
            Outcome::Failed => result.death.is_some() && result.score.total == 0,
        };
        if !ended_right {
            return Err(format!("{result:?}"));
        }
        if game.ticks().is_multiple_of(LAWS) { game.world().validate() } else { Ok(()) }
    }
}

/// Whether the ship cannot get away with all the fuel in the world: neither in any direction held on to, nor on the ways to its goals.
fn is_trapped(game: &Game, space: &Space) -> bool {
    let mut game = game.clone();
    game.set_lasting_fuel(true);
    let from = game.world().body(SHIP).position;
    let got_away = |game: &Game| game.outcome() != Outcome::Running || game.world().body(SHIP).position.distance(from) > ESCAPE.0;
    let straight = (0..16).any(|direction| {
        let mut game = game.clone();
        let angle = f64::from(direction) * 22.5;
        for _ in 0..(ESCAPE.1 * game.tick_rate()) as u32 {
            let error = (angle - game.ship().angle + 180.0).rem_euclid(360.0) - 180.0;
            let there = error.abs() * game.tick_rate() < ROTATION_RATE;
            game.step(Controls { thrust: there, reverse: false, left: !there && error < 0.0, right: !there && error > 0.0 });
        }
        got_away(&game)
    });
    let start = Aabb::around(game.level().player.position, DVec2::ZERO);
    let lead_on = || {
        wanted(&game).into_iter().chain([start]).any(|goal| {
            let (mut game, mut player) = (game.clone(), Player::after(&goal, space));
            let until = game.elapsed() + WAY_BACK;
            while game.outcome() == Outcome::Running && game.elapsed() < until && !got_away(&game) {
                game.step(player.keys(&game));
            }
            got_away(&game)
        })
    };
    !straight && !lead_on()
}
