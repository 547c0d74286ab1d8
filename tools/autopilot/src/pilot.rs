//! The pilot: it looks at the game, compares it with the plan and holds keys, a beat at a time.
//!
//! A way point asks for a velocity: towards it, as fast as can still be braked away. The difference to the ship's own velocity asks for
//! an acceleration, and what all other forces do is taken off it. What is left is the engine's part: the nose is turned that way, and
//! the engine burns for such a share of the beats as its part along the nose asks for.

use crate::plan::{Kind, Plan, Step};
use crate::sight::Sight;
use resultant::game::{Controls, ROTATION_RATE, SHIP};
use resultant::physics::{BodyId, DVec2, ForceKind};

/// The share of the engine's acceleration that the wanted one has upwards at least: falling is left to gravity, the nose stays up.
const UPRIGHT: f64 = 0.25;
/// Closer than this to its resting place the ship drops, m.
const SET_DOWN: f64 = 0.08;
/// Slower than this the ship has landed, m/s: what is left of it ends by friction, or takes long on ice.
const LANDED: f64 = 1.0;
/// What stands on something takes off at this speed before it flies anywhere, m/s.
const TAKE_OFF: f64 = 2.0;
/// No more thrust is given while the ship closes in on what it pushes faster than this, m/s.
const CLOSING: f64 = 2.0;
/// A way point that was left behind counts as passed within so many times its tolerance.
const PASSED: f64 = 4.0;
/// Ticks from one decision to the next while something is pushed.
const PUSH_BEAT: u32 = 5;

/// Flies a game by a plan.
#[derive(Clone, Debug)]
pub struct Pilot<'a> {
    plan: &'a Plan,
    step: usize,
    /// Where the ship was when the step began, m.
    from: DVec2,
    /// When, in ticks.
    since: u64,
    /// Where the pushed object was, m.
    pushed_from: f64,
    /// Beats of thrust that are owed.
    owed: f64,
    /// What is held for the rest of the beat.
    turn: i32,
    thrust: bool,
    reverse: bool,
    left: u32,
}

impl<'a> Pilot<'a> {
    pub fn new(plan: &'a Plan, sight: &Sight) -> Self {
        let mut pilot = Self {
            plan,
            step: 0,
            from: DVec2::ZERO,
            since: 0,
            pushed_from: 0.0,
            owed: 0.0,
            turn: 0,
            thrust: false,
            reverse: false,
            left: 0,
        };
        pilot.begin(0, sight);
        pilot
    }

    /// The step that is being taken; as many as there are once all are done.
    pub fn step(&self) -> usize {
        self.step
    }

    /// Whether the ship is meant to be in free flight.
    pub fn flies(&self) -> bool {
        self.plan.steps.get(self.step).is_some_and(|step| matches!(step.kind, Kind::Fly | Kind::Hover))
    }

    /// Whether it is meant to push something.
    pub fn pushes(&self) -> bool {
        self.plan.steps.get(self.step).is_some_and(|step| matches!(step.kind, Kind::Push | Kind::Ram))
    }

    /// How far the ship is from the place of its step, m.
    pub fn distance(&self, sight: &Sight) -> f64 {
        place(self.current(), sight).distance(sight.position)
    }

    /// The keys of the next tick.
    pub fn keys(&mut self, sight: &Sight) -> Controls {
        if self.left == 0 {
            while self.step < self.plan.steps.len() && self.is_done(sight) {
                self.begin(self.step + 1, sight);
            }
            self.decide(sight);
        }
        self.left -= 1;
        let controls = Controls { thrust: self.thrust, reverse: self.reverse, left: self.turn < 0, right: self.turn > 0 };
        self.turn -= self.turn.signum();
        controls
    }

    /// The present step; after the last one that one goes on.
    fn current(&self) -> &'a Step {
        &self.plan.steps[self.step.min(self.plan.steps.len() - 1)]
    }

    fn begin(&mut self, step: usize, sight: &Sight) {
        self.step = step;
        self.from = sight.position;
        self.since = sight.game.ticks();
        self.pushed_from = sight.body(BodyId(self.current().object)).position.x;
    }

    fn is_done(&self, sight: &Sight) -> bool {
        let (step, velocity) = (self.current(), sight.velocity);
        let (to, tolerance) = (place(step, sight), step.tolerance / sight.game.level().metre);
        let waited = || (sight.game.ticks() - self.since) as f64 >= step.seconds * sight.game.tick_rate();
        match step.kind {
            Kind::Fly => {
                let off = sight.position.distance(to);
                off <= tolerance || (off <= PASSED * tolerance && (to - sight.position).dot(to - self.from) < 0.0)
            }
            Kind::Land => {
                velocity.x.abs() < LANDED
                    && velocity.y.abs() < 0.1 * LANDED
                    && to.y - sight.position.y < SET_DOWN
                    && (to.x - sight.position.x).abs() <= tolerance
            }
            Kind::Push => {
                let object = sight.body(BodyId(step.object));
                let way = (to.x - self.pushed_from).signum();
                (object.position.x - to.x) * way >= 0.0 || (step.speed > 0.0 && object.velocity.x * way >= step.speed)
            }
            Kind::Ram => {
                let way = (to.x - self.pushed_from).signum();
                let late = step.seconds > 0.0 && waited();
                late || (sight.body(BodyId(step.object)).position.x - to.x) * way >= 0.0
            }
            Kind::Stop => velocity.dot(resultant::game::nose(sight.angle)) <= step.speed,
            Kind::Hold | Kind::Hover => waited(),
            Kind::Wait => sight.body(BodyId(step.object)).position.distance(to) <= tolerance || (step.seconds > 0.0 && waited()),
        }
    }

    /// Chooses what is held during the next beat.
    fn decide(&mut self, sight: &Sight) {
        let step = self.current();
        let over = self.step >= self.plan.steps.len();
        let (velocity, to) = (sight.velocity, place(step, sight));
        let beat = self.plan.settings.beat;
        self.reverse = step.kind == Kind::Stop && !over;
        match step.kind {
            Kind::Fly => self.steer(sight, wanted_velocity(self.plan, to - sight.position, if over { 0.0 } else { step.speed })),
            Kind::Hover => self.steer(sight, wanted_velocity(self.plan, to - sight.position, 0.0)),
            Kind::Land => {
                let away = to - sight.position;
                if away.y < SET_DOWN
                    && velocity.length() < 1.0 + step.speed
                    && away.x.abs() < step.tolerance / sight.game.level().metre
                {
                    self.turn_to(sight, 0.0, beat);
                    (self.thrust, self.owed) = (false, 0.0);
                } else {
                    let sideways = wanted_velocity(self.plan, DVec2::new(away.x, 0.0), 0.0);
                    let down = wanted_velocity(self.plan, DVec2::new(0.0, away.y.max(1e-3)), step.speed);
                    self.steer(sight, sideways + down);
                }
            }
            Kind::Push if !over => {
                let way = (to.x - self.pushed_from).signum();
                self.turn_to(sight, 90.0 * way, PUSH_BEAT);
                let closing = (velocity.x - sight.body(BodyId(step.object)).velocity.x) * way;
                self.thrust = self.turn == 0 && closing < CLOSING;
                self.owed = 0.0;
            }
            Kind::Ram if !over => {
                let way = (to.x - self.pushed_from).signum();
                self.turn_to(sight, 90.0 * way, PUSH_BEAT);
                self.thrust = self.turn == 0 && velocity.x * way < step.speed;
                self.owed = 0.0;
            }
            Kind::Push | Kind::Ram | Kind::Stop | Kind::Hold | Kind::Wait => {
                (self.turn, self.thrust, self.left) = (0, false, PUSH_BEAT);
            }
        }
    }

    /// Turns and burns for a beat so that the ship's velocity becomes the wanted one.
    fn steer(&mut self, sight: &Sight, mut wanted: DVec2) {
        let settings = &self.plan.settings;
        let (forces, player) = (sight.game.world().forces(SHIP), &sight.game.level().player);
        let others = [ForceKind::Weight, ForceKind::Wind, ForceKind::AirResistance, ForceKind::Buoyancy, ForceKind::ViscousDrag];
        let others: DVec2 = others.map(|kind| forces.total(kind)).into_iter().sum();
        if forces.total(ForceKind::Reaction).y < 0.0 {
            wanted.y = wanted.y.min(-TAKE_OFF);
        }
        let full = player.thrust / player.mass;
        let engine = (wanted - sight.velocity) * settings.grip - others / player.mass;

        // What the engine is to do downwards it does backwards, where the plan lets it: the nose stays up.
        let backwards = settings.reverse > 0.0 && engine.y > UPRIGHT * full;
        let nose = if backwards { -engine } else { engine };
        let lean = libm::atan2(nose.x, (-nose.y).max(UPRIGHT * full)).to_degrees();
        self.turn_to(sight, lean.clamp(-settings.tilt, settings.tilt), settings.beat);

        let angle = sight.angle + f64::from(self.turn) * degrees_a_tick(sight);
        let along = engine.dot(resultant::game::nose(angle)) / full;
        self.owed = (self.owed + along.clamp(-settings.reverse, 1.0)).clamp(-1.5, 1.5);
        (self.thrust, self.reverse) = (self.owed >= 0.5, self.owed <= -0.5);
        self.owed -= f64::from(i8::from(self.thrust) - i8::from(self.reverse));
    }

    /// Turns towards an angle for at most a beat, in whole multiples of the plan's smallest turn.
    fn turn_to(&mut self, sight: &Sight, angle: f64, beat: u32) {
        let grain = f64::from(self.plan.settings.turn.min(beat));
        let error = (angle - sight.angle + 180.0).rem_euclid(360.0) - 180.0;
        let most = (f64::from(beat) / grain).floor();
        let turns = (error / degrees_a_tick(sight) / grain).round().clamp(-most, most);
        self.turn = (turns * grain) as i32;
        self.left = beat;
    }
}

/// Where a step leads, m.
fn place(step: &Step, sight: &Sight) -> DVec2 {
    DVec2::new(step.x, step.y) / sight.game.level().metre
}

fn degrees_a_tick(sight: &Sight) -> f64 {
    ROTATION_RATE / sight.game.tick_rate()
}

/// As fast as can be braked to `speed` over the way that is left.
fn wanted_velocity(plan: &Plan, way: DVec2, speed: f64) -> DVec2 {
    let settings = &plan.settings;
    let most = (speed * speed + 2.0 * settings.brake * way.length()).sqrt();
    // Close to the goal the law of braking would ask for leaps.
    let gentle = speed + settings.grip * way.length();
    way.normalize_or_zero() * most.min(gentle).min(settings.top_speed.max(speed))
}
