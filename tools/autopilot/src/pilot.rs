//! The pilot: it looks at the game, compares it with the plan and holds keys, a beat at a time.
//!
//! A way point asks for a velocity: towards it, as fast as can still be braked away. The difference to the ship's own velocity asks for
//! an acceleration, and what all other forces do is taken off it. What is left is the engine's part: the nose is turned that way, and
//! the engine burns for such a share of the beats as its part along the nose asks for.

use crate::judgement::Judgement;
use crate::plan::{FlightPlan, PlanStep, StepKind};
use crate::sight::Sight;
use resultant::game::{Controls, ROTATION_RATE, SHIP};
use resultant::physics::{BodyId, DVec2, Force, ForceKind, Source};

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
/// A way point that was left behind counts as passed within this factor of its tolerance.
const PASSED: f64 = 4.0;
/// Ticks from one decision to the next while something is pushed.
const PUSH_BEAT: u32 = 5;
/// Who has not got to a place for so long, s, tries again from the one before.
const PATIENCE: f64 = 6.0;
/// What moves no faster than this, m/s, after so long, s, is not moved by going on.
const STUCK: f64 = 0.1;
const TRIED: f64 = 2.0;
/// Heights of the ground are taken for the same within this, m.
const ABOUT: f64 = 1.2;
/// Beats for which the ship backs off from what holds it.
const AWAY: u32 = 6;

/// The forces besides the engine's that act in free flight.
const ACTING: [ForceKind; 8] = [
    ForceKind::Weight,
    ForceKind::Wind,
    ForceKind::AirResistance,
    ForceKind::Buoyancy,
    ForceKind::ViscousDrag,
    ForceKind::Spring,
    ForceKind::Tension,
    ForceKind::Magnetic,
];

/// Flies a game by a plan.
#[derive(Clone, Debug)]
pub struct Autopilot<'a> {
    plan: &'a FlightPlan,
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
    judgement: Option<Judgement>,
    /// Beats for which the ship goes on to back off, and how fast, m/s.
    away: (u32, DVec2),
}

impl<'a> Autopilot<'a> {
    pub fn new(plan: &'a FlightPlan, sight: &Sight) -> Self {
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
            judgement: None,
            away: (0, DVec2::ZERO),
        };
        pilot.begin(0, sight);
        pilot
    }

    /// The same pilot, who misjudges.
    pub fn with(mut self, judgement: Judgement) -> Self {
        self.judgement = Some(judgement);
        self.judgement.iter_mut().for_each(Judgement::misjudge);
        self
    }

    /// The step that is being taken; as many as there are once all are done.
    pub fn step(&self) -> usize {
        self.step
    }

    /// Whether the ship is meant to be in free flight.
    pub fn flies(&self) -> bool {
        self.plan.steps.get(self.step).is_some_and(|step| matches!(step.kind, StepKind::Fly | StepKind::Carry | StepKind::Hover))
    }

    /// Whether it is meant to push something.
    pub fn pushes(&self) -> bool {
        self.plan.steps.get(self.step).is_some_and(|step| matches!(step.kind, StepKind::Push | StepKind::Ram))
    }

    /// How far the ship is from the place of its step, m.
    pub fn distance(&self, sight: &Sight) -> f64 {
        self.place(sight).distance(sight.position)
    }

    /// The keys of the next tick, of a pilot who sees the game as it is.
    pub fn keys(&mut self, sight: &Sight) -> Controls {
        if self.is_due() {
            self.look(sight);
        }
        self.press()
    }

    /// Whether a beat is over and the pilot looks again.
    pub fn is_due(&self) -> bool {
        self.left == 0
    }

    /// Looks at the game and decides what is held during the next beat.
    pub fn look(&mut self, sight: &Sight) {
        // One that goes back and forth acts all the same.
        for _ in 0..self.plan.steps.len() {
            match self.next(sight) {
                Some(next) if self.step < self.plan.steps.len() => self.begin(next, sight),
                _ => break,
            }
        }
        self.decide(sight);
    }

    /// The keys of the next tick of the beat.
    pub fn press(&mut self) -> Controls {
        self.left -= 1;
        let controls = Controls { thrust: self.thrust, reverse: self.reverse, left: self.turn < 0, right: self.turn > 0 };
        self.turn -= self.turn.signum();
        controls
    }

    /// The step to begin now, if any: the next one where this one is done, an earlier one where something has to be tried again.
    fn next(&self, sight: &Sight) -> Option<usize> {
        let step = self.current();
        if self.is_done(sight) {
            let skipped = if step.kind == StepKind::Unless { step.back as usize } else { 0 };
            return Some((self.step + 1 + skipped).min(self.plan.steps.len()));
        }
        match step.kind {
            StepKind::Unless if self.waited(sight, step.seconds) => Some(self.step + 1),
            StepKind::Again if self.waited(sight, step.seconds) => Some(self.step.saturating_sub(step.back as usize)),
            // Stuck: once more, a landing from the way point before.
            StepKind::Fly | StepKind::Carry if self.judgement.is_some() && self.waited(sight, PATIENCE) => Some(self.step),
            StepKind::Land if self.judgement.is_some() && (self.waited(sight, PATIENCE) || self.stands_wrong(sight)) => {
                Some(self.before(self.step))
            }
            StepKind::Push | StepKind::Ram if self.judgement.is_some() && self.has_missed(sight) => {
                let landed = self.plan.steps[..self.step].iter().rposition(|step| step.kind == StepKind::Land);
                Some(landed.filter(|landed| landed + 1 == self.step).map_or(self.step + 1, |landed| self.before(landed)))
            }
            _ => None,
        }
    }

    /// The way point before a step, if that is what was before it, or the step itself.
    fn before(&self, step: usize) -> usize {
        step - usize::from(step > 0 && self.plan.steps[step - 1].kind == StepKind::Fly)
    }

    /// Whether the ship stands on something about at that height, m.
    fn stands_at(&self, y: f64, sight: &Sight) -> bool {
        let stands = sight.game.world().forces(SHIP).total(ForceKind::Reaction).y < 0.0;
        stands && (y - sight.position.y).abs() < ABOUT
    }

    /// Whether the ship has come down where it was not to.
    fn stands_wrong(&self, sight: &Sight) -> bool {
        let stands = sight.game.world().forces(SHIP).total(ForceKind::Reaction).y < 0.0;
        stands && self.waited(sight, TRIED) && sight.velocity.length() < STUCK
    }

    /// Whether what is to be pushed is not in front of the ship any more, or does not move.
    fn has_missed(&self, sight: &Sight) -> bool {
        let (ship, object) = (sight.body(SHIP), sight.body(BodyId(self.current().object)));
        let way = (self.place(sight).x - self.pushed_from).signum();
        let beside = (ship.position.y - object.position.y).abs() < ship.half.y + object.half.y;
        let rests = ship.velocity.length().max(object.velocity.length()) < STUCK;
        !beside || (object.position.x - ship.position.x) * way < 0.0 || (rests && self.waited(sight, TRIED))
    }

    /// Where the step leads, m.
    fn place(&self, sight: &Sight) -> DVec2 {
        let step = self.current();
        if step.kind == StepKind::Burn {
            return sight.position;
        }
        let beside = matches!(step.kind, StepKind::Fly | StepKind::Carry | StepKind::Land | StepKind::Hover) && step.object > 0;
        let from = if beside { sight.body(BodyId(step.object)).position } else { DVec2::ZERO };
        let mut off = self.judgement.as_ref().map_or(DVec2::ZERO, |judgement| judgement.off);
        if step.kind == StepKind::Land {
            // One feels when one stands.
            off.y = 0.0;
        }
        from + DVec2::new(step.x, step.y) / sight.game.level().metre + off
    }

    /// The speed that the step asks for, m/s.
    fn speed(&self) -> f64 {
        self.current().speed * self.judgement.as_ref().map_or(1.0, |judgement| judgement.speed)
    }

    /// Whether the step has gone on for `seconds`.
    fn waited(&self, sight: &Sight, seconds: f64) -> bool {
        (sight.game.ticks() - self.since) as f64 >= seconds * sight.game.tick_rate()
    }

    /// The present step; after the last one that one goes on.
    fn current(&self) -> &'a PlanStep {
        &self.plan.steps[self.step.min(self.plan.steps.len() - 1)]
    }

    fn begin(&mut self, step: usize, sight: &Sight) {
        self.step = step;
        self.judgement.iter_mut().for_each(Judgement::misjudge);
        self.from = sight.position;
        self.since = sight.game.ticks();
        self.pushed_from = sight.body(BodyId(self.current().object)).position.x;
    }

    fn is_done(&self, sight: &Sight) -> bool {
        let (step, speed, velocity) = (self.current(), self.speed(), sight.velocity);
        let (to, tolerance) = (self.place(sight), step.tolerance / sight.game.level().metre);
        let waited = || self.waited(sight, step.seconds);
        match step.kind {
            StepKind::Fly | StepKind::Carry => {
                let off = sight.position.distance(to);
                off <= tolerance || (off <= PASSED * tolerance && (to - sight.position).dot(to - self.from) < 0.0)
            }
            StepKind::Land => {
                velocity.x.abs() < LANDED
                    && velocity.y.abs() < 0.1 * LANDED
                    && (to.y - sight.position.y < SET_DOWN || (self.judgement.is_some() && self.stands_at(to.y, sight)))
                    && (to.x - sight.position.x).abs() <= tolerance
            }
            StepKind::Push => {
                let object = sight.body(BodyId(step.object));
                let way = (to.x - self.pushed_from).signum();
                let late = step.seconds > 0.0 && waited();
                late || (object.position.x - to.x) * way >= 0.0 || (speed > 0.0 && object.velocity.x * way >= speed)
            }
            StepKind::Ram => {
                let way = (to.x - self.pushed_from).signum();
                let late = step.seconds > 0.0 && waited();
                late || (sight.body(BodyId(step.object)).position.x - to.x) * way >= 0.0
            }
            StepKind::Lean => {
                let down = (step.y / sight.game.level().metre - self.from.y).signum();
                (step.seconds > 0.0 && waited()) || (step.y > 0.0 && (sight.position.y - to.y) * down >= 0.0)
            }
            StepKind::Stop => velocity.dot(resultant::game::nose(sight.angle)) <= speed,
            StepKind::Hold | StepKind::Hover | StepKind::Burn => waited(),
            StepKind::Again | StepKind::Unless => sight.body(BodyId(step.object)).position.distance(to) <= tolerance,
            StepKind::Wait => {
                sight.body(BodyId(step.object)).position.distance(to) <= tolerance || (step.seconds > 0.0 && waited())
            }
        }
    }

    /// Chooses what is held during the next beat.
    fn decide(&mut self, sight: &Sight) {
        let (step, speed) = (self.current(), self.speed());
        let over = self.step >= self.plan.steps.len();
        let (velocity, to) = (sight.velocity, self.place(sight));
        let beat = self.plan.settings.beat;
        self.reverse = step.kind == StepKind::Stop && !over;
        match step.kind {
            StepKind::Fly | StepKind::Carry => {
                self.steer(sight, wanted_velocity(self.plan, to - sight.position, if over { 0.0 } else { speed }))
            }
            StepKind::Hover => self.steer(sight, wanted_velocity(self.plan, to - sight.position, 0.0)),
            StepKind::Burn if !over => {
                self.turn_to(sight, step.x, beat);
                self.owed = (self.owed + if self.turn == 0 { speed.clamp(-1.0, 1.0) } else { 0.0 }).clamp(-1.5, 1.5);
                (self.thrust, self.reverse) = (self.owed >= 0.5, self.owed <= -0.5);
                self.owed -= f64::from(i8::from(self.thrust) - i8::from(self.reverse));
            }
            StepKind::Land => {
                let away = to - sight.position;
                if away.y < SET_DOWN && velocity.length() < 1.0 + speed && away.x.abs() < step.tolerance / sight.game.level().metre
                {
                    self.turn_to(sight, 0.0, beat);
                    (self.thrust, self.owed) = (false, 0.0);
                } else {
                    let sideways = wanted_velocity(self.plan, DVec2::new(away.x, 0.0), 0.0);
                    let down = wanted_velocity(self.plan, DVec2::new(0.0, away.y.max(1e-3)), speed);
                    self.steer(sight, sideways + down);
                }
            }
            StepKind::Lean if !over => {
                self.turn_to(sight, step.x, PUSH_BEAT);
                let along = if step.x.abs() > 90.0 { velocity.y } else { -velocity.y };
                (self.thrust, self.owed) = (along < speed, 0.0);
            }
            StepKind::Push if !over => {
                let way = (to.x - self.pushed_from).signum();
                self.turn_to(sight, 90.0 * way, PUSH_BEAT);
                let closing = (velocity.x - sight.body(BodyId(step.object)).velocity.x) * way;
                self.thrust = self.turn == 0 && closing < CLOSING;
                self.owed = 0.0;
            }
            StepKind::Ram if !over => {
                let way = (to.x - self.pushed_from).signum();
                self.turn_to(sight, 90.0 * way, PUSH_BEAT);
                self.thrust = self.turn == 0 && velocity.x * way < speed;
                self.owed = 0.0;
            }
            StepKind::Lean
            | StepKind::Burn
            | StepKind::Push
            | StepKind::Ram
            | StepKind::Stop
            | StepKind::Hold
            | StepKind::Wait
            | StepKind::Again
            | StepKind::Unless => {
                (self.turn, self.thrust, self.left) = (0, false, PUSH_BEAT);
            }
        }
    }

    /// Turns and burns for a beat so that the ship's velocity becomes the wanted one.
    fn steer(&mut self, sight: &Sight, mut wanted: DVec2) {
        let settings = &self.plan.settings;
        let (forces, player) = (sight.game.world().forces(SHIP), &sight.game.level().player);
        let others: DVec2 = ACTING.map(|kind| forces.total(kind)).into_iter().sum();
        let carries = self.current().kind == StepKind::Carry;
        let load = |force: &&Force| carries && matches!(force.source, Source::Body(_));
        let others = others + forces.forces().iter().filter(load).map(|force| force.vector).sum::<DVec2>();
        if forces.total(ForceKind::Reaction).y < 0.0 && !carries {
            wanted.y = wanted.y.min(-TAKE_OFF);
        }
        // Held by what is in the way: up or from under a roof, and away from what presses from the side, else on.
        if self.judgement.is_some() && sight.velocity.length() < STUCK && self.waited(sight, TRIED) && self.flies() {
            let pressed = forces.total(ForceKind::Push).x;
            let side = if pressed.abs() > 1.0 { pressed } else { wanted.x };
            let under = forces.total(ForceKind::Reaction).y > 0.0;
            self.away = (AWAY, TAKE_OFF * DVec2::new(side.signum(), if under { 1.0 } else { -1.0 }));
        }
        if self.away.0 > 0 {
            self.away.0 -= 1;
            wanted = self.away.1;
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

fn degrees_a_tick(sight: &Sight) -> f64 {
    ROTATION_RATE / sight.game.tick_rate()
}

/// As fast as can be braked to `speed` over the way that is left.
fn wanted_velocity(plan: &FlightPlan, way: DVec2, speed: f64) -> DVec2 {
    let settings = &plan.settings;
    let most = (speed * speed + 2.0 * settings.brake * way.length()).sqrt();
    // Close to the goal the law of braking would ask for leaps.
    let gentle = speed + settings.grip * way.length();
    way.normalize_or_zero() * most.min(gentle).min(settings.top_speed.max(speed))
}
