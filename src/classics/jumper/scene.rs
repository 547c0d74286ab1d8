//! The climb: one or two players with their keys, the view that rises with the higher one, and the score.

use super::engine::{self, Cuboid, CuboidHit, Dynamic};
use super::tower::{DEPTH, Tower, WIDTH};
use crate::game::TICK_RATE;
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

/// The keys that a player holds during a tick.
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

#[derive(Clone, Debug)]
pub struct Climber {
    jump_held: bool,
    jumped: bool,
    air_jump_left: bool,
    direction: f64,
    stagger: u32,
    out: bool,
}

impl Climber {
    fn new() -> Self {
        Self { jump_held: false, jumped: false, air_jump_left: false, direction: 0.0, stagger: 0, out: false }
    }

    /// Whether the view has left this player behind.
    pub fn is_out(&self) -> bool {
        self.out
    }

    /// The direction last taken: −1 left, 1 right, 0 standing.
    pub fn direction(&self) -> f64 {
        self.direction
    }

    pub fn has_jumped(&self) -> bool {
        self.jumped
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
    tower: Tower,
    players: Vec<Climber>,
    bodies: Vec<Dynamic>,
    bottom: f64,
    previous_bottom: f64,
    height: f64,
    ticks: u64,
    hits: Vec<CuboidHit>,
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
            players: starts.iter().map(|_| Climber::new()).collect(),
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
        engine::step(&mut self.bodies, self.tower.statics(), GRAVITY, 1.0 / TICK_RATE, &mut self.hits);
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

    /// The greatest height that a player's feet have reached, m.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The height in whole metres, for the leaderboard.
    pub fn score(&self) -> i64 {
        self.height.floor() as i64
    }

    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    pub fn players(&self) -> impl Iterator<Item = (&Climber, &Dynamic)> {
        self.players.iter().zip(&self.bodies)
    }

    /// Walls and platforms near the view.
    pub fn tower(&self) -> &Tower {
        &self.tower
    }

    /// The view's lower edge at a fraction `alpha` of the last tick, m.
    pub fn view_bottom(&self, alpha: f64) -> f64 {
        self.previous_bottom + alpha * (self.bottom - self.previous_bottom)
    }

    pub fn hits(&self) -> &[CuboidHit] {
        &self.hits
    }
}

const _: () = assert!(STARTS[0] >= 0.0 && STARTS[1] + PLAYER_SIZE <= WIDTH);
