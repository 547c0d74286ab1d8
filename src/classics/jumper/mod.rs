//! Jumper: one or two players climb an endless tower of platforms, and the view, which only rises, leaves slow players behind.
//!
//! The world has three axes: x across, y depth, z up; the scene plays in x–z. Lengths are in metres, velocities in m/s.
//! [`engine`] has cuboids that know no player, and the [`Tower`] of platforms.
//!
//! Recorded keys of a climb: held keys and their number of ticks, as a CSV file that people can write.
//!
//! ```text
//! ticks,left1,right1,jump1,left2,right2,jump2
//! 60,0,1,0,1,0,0
//! 30,0,1,1,0,0,0
//! ```
//!
//! Each row holds its keys (0 or 1) for that many ticks; the last three columns are the second player's and may be left out. Blank
//! lines and lines that start with `#` are skipped.

pub mod engine;

use crate::files::{CsvFile, CsvRow};
use crate::game::TICK_RATE;
use engine::{Cuboid, CuboidHit, DEPTH, Dynamic, Tower, WIDTH};
use glam::DVec3;

/// The name of the climbs' leaderboard.
pub const LEADERBOARD: &str = "jumper";
/// m/s².
const GRAVITY: f64 = 10.0;
/// The height of the view, m.
pub const VISIBLE: f64 = 20.0;
/// The view rises so that the higher player's feet are at most this far above its lower edge, m.
const HEADROOM_FROM: f64 = 0.5 * VISIBLE;
/// Width and height of a player, m.
pub const PLAYER_SIZE: f64 = 0.3;
/// Where the players start, m.
const STARTS: [f64; 2] = [5.0, 10.0];
/// Walking, m/s.
const WALK: f64 = 4.0;
/// Along x after the direction was changed in the air, m/s.
const DRIFT: f64 = 2.5;
/// Jumping while standing, m/s.
const STANDING_JUMP: f64 = 6.0;
/// Jumping while walking, m/s.
const WALKING_JUMP: f64 = 8.0;
/// The one more jump in the air, m/s.
const AIR_JUMP: f64 = 6.0;
/// The part of the upward velocity that remains when the player lets go of the jump key while rising.
const CUT: f64 = 0.5;
/// Ticks. After bumping into the other player walking is off: else it would undo the bounce within a tick.
const STAGGER: u32 = 24;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct JumpKeys {
    pub left: bool,
    pub right: bool,
    /// Jump, once for each press.
    pub jump: bool,
}

impl JumpKeys {
    /// −1 left, 1 right, 0 neither or both.
    fn direction(self) -> f64 {
        f64::from(i8::from(self.right) - i8::from(self.left))
    }
}

#[derive(Clone, Debug, Default)]
pub struct Climber {
    jump_held: bool,
    pub jumped: bool,
    air_jump_left: bool,
    pub direction: f64,
    stagger: u32,
    out: bool,
}

impl Climber {
    /// Whether the view has left this player behind.
    pub fn is_out(&self) -> bool {
        self.out
    }

    fn obey(&mut self, keys: JumpKeys, body: &mut Dynamic) {
        self.jumped = false;
        self.stagger = self.stagger.saturating_sub(1);
        self.air_jump_left |= body.on_ground;
        if self.stagger == 0 {
            self.walk(keys.direction(), body);
        }
        match (self.jump_held, keys.jump) {
            (false, true) => self.jump(body),
            (true, false) if body.velocity.z > 0.0 => body.velocity.z *= CUT,
            _ => {}
        }
        self.jump_held = keys.jump;
    }

    fn walk(&mut self, direction: f64, body: &mut Dynamic) {
        if body.on_ground {
            body.velocity.x = WALK * direction;
            self.direction = direction;
        } else if direction != 0.0 && direction != self.direction {
            body.velocity.x = DRIFT * direction;
            self.direction = direction;
        }
    }

    fn jump(&mut self, body: &mut Dynamic) {
        if body.on_ground {
            body.velocity.z = if self.direction == 0.0 { STANDING_JUMP } else { WALKING_JUMP };
        } else if self.air_jump_left {
            body.velocity.z = AIR_JUMP;
            self.air_jump_left = false;
        } else {
            return;
        }
        self.jumped = true;
    }
}

#[derive(Clone, Debug)]
pub struct JumperScene {
    pub tower: Tower,
    players: Vec<Climber>,
    bodies: Vec<Dynamic>,
    bottom: f64,
    previous_bottom: f64,
    pub height: f64,
    pub ticks: u64,
    pub hits: Vec<CuboidHit>,
}

impl JumperScene {
    /// The start of a climb of one player or, with `two`, of both, on the tower of that seed.
    pub fn new(seed: u64, two: bool) -> Self {
        let starts = &STARTS[..1 + usize::from(two)];
        let dimensions = DVec3::new(PLAYER_SIZE, DEPTH, PLAYER_SIZE);
        let body = |&x: &f64| Dynamic {
            on_ground: true,
            ..Dynamic::new(Cuboid { location: DVec3::new(x, 0.0, 0.0), dimensions }, DVec3::ZERO, 1.0)
        };
        let mut tower = Tower::new(seed);
        tower.grow_to(VISIBLE + 1.0);
        Self {
            tower,
            players: starts.iter().map(|_| Climber::default()).collect(),
            bodies: starts.iter().map(body).collect(),
            bottom: 0.0,
            previous_bottom: 0.0,
            height: 0.0,
            ticks: 0,
            hits: Vec::new(),
        }
    }

    /// One tick of 1/[`TICK_RATE`] s; the second player's keys count only where there are two. After the end nothing changes.
    pub fn tick(&mut self, keys: [JumpKeys; 2]) {
        if self.is_over() {
            return;
        }
        for ((player, body), keys) in self.players.iter_mut().zip(&mut self.bodies).zip(keys) {
            player.obey(if player.out { JumpKeys::default() } else { keys }, body);
        }
        engine::step(&mut self.bodies, &self.tower.statics, GRAVITY, 1.0 / TICK_RATE, &mut self.hits);
        if self.hits.iter().any(|hit| matches!(hit, CuboidHit::Pair(..))) {
            self.players.iter_mut().for_each(|player| player.stagger = STAGGER);
        }
        self.raise_view();
        self.ticks += 1;
    }

    fn raise_view(&mut self) {
        self.previous_bottom = self.bottom;
        let climbing = self.players.iter().zip(&self.bodies).filter(|(player, _)| !player.out);
        let highest = climbing.map(|(_, body)| body.cuboid.location.z).fold(0.0, f64::max);
        self.height = self.height.max(highest);
        self.bottom = self.bottom.max(highest - HEADROOM_FROM);
        for (player, body) in self.players.iter_mut().zip(&self.bodies) {
            player.out |= body.cuboid.end().z < self.bottom;
        }
        self.tower.grow_to(self.bottom + VISIBLE + 1.0);
        self.tower.drop_below(self.bottom - 1.0);
    }

    pub fn is_over(&self) -> bool {
        self.players.iter().all(|player| player.out)
    }

    /// The height in whole metres, for the leaderboard.
    pub fn score(&self) -> i64 {
        self.height.floor() as i64
    }

    pub fn players(&self) -> impl Iterator<Item = (&Climber, &Dynamic)> {
        self.players.iter().zip(&self.bodies)
    }

    /// The view's lower edge at a fraction `alpha` of the last tick, m.
    pub fn view_bottom(&self, alpha: f64) -> f64 {
        self.previous_bottom + alpha * (self.bottom - self.previous_bottom)
    }
}

const _: () = assert!(STARTS[0] >= 0.0 && STARTS[1] + PLAYER_SIZE <= WIDTH);

const HEADER: [&str; 7] = ["ticks", "left1", "right1", "jump1", "left2", "right2", "jump2"];
/// The columns of one player, and of both.
const ONE_PLAYER: usize = 4;
const BOTH_PLAYERS: usize = HEADER.len();
/// The most ticks that a file can hold: a day. More is a slip of the pen, and would be climbed for minutes without a word.
const MOST_TICKS: u64 = 24 * 3600 * TICK_RATE as u64;

/// The keys of both players for a number of ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Climb {
    pub ticks: u64,
    pub keys: [JumpKeys; 2],
}

/// Reads the text of a file of keys; `file` is its name in messages. Errors: the first problem as `FILE:LINE: MESSAGE`: another header, a wrong
/// number of cells, ticks that are no whole number from 1 or more than a day's in all, a key that is neither 0 nor 1.
pub fn parse(file: &str, text: &str) -> Result<Vec<Climb>, String> {
    let columns = CsvFile { name: file, columns: &HEADER, comments: true };
    let mut rows = columns.rows(text.as_bytes());
    let header = rows.next().ok_or_else(|| format!("{file}:1: found \"\", expected the header {}", columns.header()))?;
    if !header.is_header(ONE_PLAYER) || !matches!(header.used(), ONE_PLAYER | BOTH_PLAYERS) {
        return Err(header.row_problem(format_args!("{:?}", header.joined()), format_args!("the header {}", columns.header())));
    }
    let mut total = 0;
    let climbs = rows.map(|row| {
        let climb = climb(&row, header.used())?;
        total += climb.ticks;
        if total > MOST_TICKS {
            return Err(row.row_problem(format_args!("{total} ticks up to here"), format_args!("at most {MOST_TICKS} in all")));
        }
        Ok(climb)
    });
    climbs.collect()
}

fn climb(row: &CsvRow<'_>, columns: usize) -> Result<Climb, String> {
    if row.used() != columns {
        return Err(row.row_problem(format_args!("{} cells", row.used()), columns));
    }
    let expected = format!("a whole number from 1 to {MOST_TICKS}");
    let ticks = row.parse("ticks", &expected, |ticks| (1..=MOST_TICKS).contains(ticks))?;
    let key = |index: usize| if index < columns { row.bit(HEADER[index]) } else { Ok(false) };
    let player = |from: usize| Ok::<_, String>(JumpKeys { left: key(from)?, right: key(from + 1)?, jump: key(from + 2)? });
    Ok(Climb { ticks, keys: [player(1)?, player(4)?] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_one_or_both_players_are_read() {
        let none = JumpKeys::default();
        let one = Climb { ticks: 5, keys: [JumpKeys { right: true, ..none }, none] };
        assert_eq!(parse("keys.csv", "\u{feff}ticks,left1,right1,jump1\r\n\r\n 5, 0,1,0\r\n"), Ok(vec![one]));
        let both = Climb { ticks: 1, keys: [JumpKeys { left: true, ..none }, JumpKeys { jump: true, ..none }] };
        assert_eq!(parse("keys.csv", "ticks,left1,right1,jump1,left2,right2,jump2\n1,1,0,0,0,0,1"), Ok(vec![both]));
    }

    #[test]
    fn bad_files_are_refused_with_their_line() {
        const GOOD: &str = "ticks,left1,right1,jump1";
        for (rows, problem) in [
            ("", "1: found \"\", expected the header ticks,left1,right1,jump1,left2,right2,jump2"),
            ("5,0,1,0", "1: found \"5,0,1,0\", expected the header ticks,left1,right1,jump1,left2,right2,jump2"),
            ("+0,0,0,0", "2: column \"ticks\": found \"0\", expected a whole number from 1 to 10368000"),
            ("+5,0,0", "2: found 3 cells, expected 4"),
            ("+10368000,0,0,0\n1,0,0,0", "3: found 10368001 ticks up to here, expected at most 10368000 in all"),
            ("+\n5,0,0,2", "3: column \"jump1\": found \"2\", expected 0 or 1"),
        ] {
            let text = rows.strip_prefix('+').map_or(rows.to_owned(), |rows| format!("{GOOD}\n{rows}"));
            assert_eq!(parse("keys.csv", &text), Err(format!("keys.csv:{problem}")), "{rows:?}");
        }
    }
}
