//! The work of each force on each body up to the moment on the screen.
//! W = ∫F·dr, tick by tick, so that the readings always obey the law of work and energy, ΔE_kin = Σ W + W_impacts:
//! 1. A force F₀ at a tick's start and F₁ at its end does W = ½(F₀ + F₁)·Δr. That is exact where it is constant, and where it grows evenly
//!    with the distance, as the buoyancy of a floating body does. The engine is switched at a tick's start and does F₁·Δr.
//! 2. Where an impact falls into the tick, F₀ acts up to that corner of the path and F₁ from there on, for it may begin or end a contact.
//! 3. A body that presses on a surface that cannot move gets no work from it: where they touch, the body moves along it.
//! 4. What is then missing to ΔE_kin = ½m(v₁ − v₀)·(v₁ + v₀) is the impacts', where there were any. Else contacts that changed abruptly, as
//!    where a slide ends, did so at one point of the path, for all of them the one that makes the sum right. Where there are none the rest
//!    goes to the forces that changed, by |(F₁ − F₀)·Δr|; so drag alone is exact.
//!
//! Momentum, kinetic and potential energy, of a body and of all; the centre of mass of several.

use super::track::Companion;
use crate::game::{Game, History};
use crate::level::{Level, SurfaceOf};
use crate::physics::{Body, BodyId, DVec2, ForceKind, Link, LinkEnd, Source};
use std::ops::Add;

const KINDS: usize = ForceKind::ALL.len();
/// Two forces closer than this, as parts of them, are one: the rest is rounding.
const SAME: f64 = 1e-12;
/// An impulse below this part of a body's momentum counts as none.
const ROUNDING: f64 = 1e-9;
/// A contact that changes by more than this part of it in a tick does so abruptly: in a smaller one the air's drag may have a part.
const ABRUPT: f64 = 0.1;
/// The most bodies with accounts: the time to ask for all forces grows with the square of their number.
pub const MOST_BODIES: usize = 256;
/// From copy to copy of the accounts at first, ticks, and the most accounts in all copies: as in [`History`], every second one goes beyond that.
const EVERY: u64 = 60;
const ACCOUNTS_IN_COPIES: usize = 32_768;
const FEWEST_COPIES: usize = 16;

/// On a body, or on all of them, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Account {
    /// By each kind of force, in the order of [`ForceKind::ALL`].
    pub by_force: [f64; KINDS],
    pub by_impacts: f64,
}

impl Account {
    /// J.
    pub fn by(&self, kind: ForceKind) -> f64 {
        self.by_force[kind as usize]
    }

    /// The gain of kinetic energy, J.
    pub fn sum(&self) -> f64 {
        self.by_force.iter().sum::<f64>() + self.by_impacts
    }

    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        self.with(other, 1.0)
    }

    /// The work since `other`.
    #[must_use]
    pub fn since(&self, other: &Self) -> Self {
        self.with(other, -1.0)
    }

    fn with(&self, other: &Self, sign: f64) -> Self {
        let mut sum = *self;
        sum.by_force.iter_mut().zip(other.by_force).for_each(|(sum, other)| *sum += sign * other);
        sum.by_impacts += sign * other.by_impacts;
        sum
    }
}

#[derive(Clone, Copy, Debug)]
struct TickEnd {
    position: DVec2,
    velocity: DVec2,
    /// By kind, N; without the pressure of surfaces that cannot move.
    forces: [DVec2; KINDS],
}

impl TickEnd {
    fn of(game: &Game, id: BodyId) -> Self {
        let body = game.world().body(id);
        let mut forces = [DVec2::ZERO; KINDS];
        for force in game.world().forces(id).forces().iter().filter(|force| !is_still(game, force.source, force.kind)) {
            forces[force.kind as usize] += force.vector;
        }
        Self { position: body.position, velocity: body.velocity, forces }
    }
}

fn is_still(game: &Game, source: Source, kind: ForceKind) -> bool {
    let Source::Surface(index) = source else { return false };
    kind != ForceKind::Friction && !matches!(game.level().surface(index as usize), SurfaceOf::Mover(_))
}

#[derive(Clone, Debug, Default)]
pub struct WorkLedger {
    companion: Companion,
    before: Vec<TickEnd>,
    pub accounts: Vec<Account>,
    copies: Vec<(u64, Vec<Account>)>,
    /// How often every second copy went.
    thinned: u32,
}

impl WorkLedger {
    /// Goes to that tick of a flight, by `most` ticks at most. True where it arrives; in a crowd it never does.
    pub fn go(&mut self, history: &History, tick: u64, most: u64) -> bool {
        if self.companion.tick().is_none_or(|at| at > tick) && !self.stand_before(history, tick) {
            return false;
        }
        let (mut companion, every) = (std::mem::take(&mut self.companion), EVERY << self.thinned);
        let there = companion.go_on(history, tick, most, |game| {
            self.take(game);
            if game.ticks() >= self.copies.last().map_or(0, |(at, _)| *at) + every {
                self.copies.push((game.ticks(), self.accounts.clone()));
            }
        });
        self.companion = companion;
        self.thin_out();
        there
    }

    /// The flight was left at that tick: later accounts are void.
    pub fn back_to(&mut self, tick: u64) {
        self.companion.back_to(tick);
        self.copies.retain(|(at, _)| *at <= tick);
    }

    /// Goes to the last copy up to that tick, or to the flight's start; not in a crowd.
    fn stand_before(&mut self, history: &History, tick: u64) -> bool {
        let copy = self.copies.iter().rev().find(|(at, _)| *at <= tick);
        let game = self.companion.stand_at(history, copy.map_or(0, |(at, _)| *at));
        let bodies = game.world().bodies().len();
        if bodies > MOST_BODIES {
            return false;
        }
        self.accounts = copy.map_or_else(|| vec![Account::default(); bodies], |(_, accounts)| accounts.clone());
        self.before = ids(game).map(|id| TickEnd::of(game, id)).collect();
        if self.copies.is_empty() {
            self.copies.push((game.ticks(), self.accounts.clone()));
        }
        true
    }

    fn take(&mut self, game: &Game) {
        for id in ids(game) {
            let (before, after) = (self.before[id.index()], TickEnd::of(game, id));
            self.accounts[id.index()] = self.accounts[id.index()].plus(&BodyTick { game, id, before, after }.account());
            self.before[id.index()] = after;
        }
    }

    fn thin_out(&mut self) {
        let most = (ACCOUNTS_IN_COPIES / self.accounts.len().max(1)).max(FEWEST_COPIES);
        while self.copies.len() > most {
            let mut stays = false;
            self.copies.retain(|_| {
                stays = !stays;
                stays
            });
            self.thinned += 1;
        }
    }
}

fn ids(game: &Game) -> impl Iterator<Item = BodyId> + use<> {
    (0..game.world().bodies().len() as u32).map(BodyId)
}

struct BodyTick<'a> {
    game: &'a Game,
    id: BodyId,
    before: TickEnd,
    after: TickEnd,
}

impl BodyTick<'_> {
    fn account(&self) -> Account {
        let (world, mass) = (self.game.world(), self.game.world().body(self.id).mass);
        let (before, after) = (&self.before, &self.after);
        let way = after.position - before.position;
        // From the tick's start to the first impact, and from the last one to its end.
        let corners = || world.path(self.id).skip(1).take(world.path(self.id).count() - 2);
        let ways = corners().next().zip(corners().last()).filter(|_| self.is_hit());
        let ways = ways.map(|(first, last)| (first - before.position, after.position - last));
        let mut account = Account::default();
        // The work of each by its force at the start, less that by its force at the end, along the whole path.
        let mut changed = [0.0; KINDS];
        for kind in ForceKind::ALL {
            let k = kind as usize;
            let (f0, f1) = (before.forces[k], after.forces[k]);
            let constant = kind == ForceKind::Drive || differ(f0, f1) <= SAME;
            let mean = 0.5 * (f0 + f1);
            account.by_force[k] = match ways {
                _ if constant => f1.dot(way),
                Some((to, from)) => f0.dot(to) + f1.dot(from) + mean.dot(way - to - from),
                None => mean.dot(way),
            };
            changed[k] = if constant { 0.0 } else { (f0 - f1).dot(way) };
        }
        let gained = 0.5 * mass * (after.velocity - before.velocity).dot(after.velocity + before.velocity);
        let missing = gained - account.sum();
        if ways.is_some() || account.by_force == [0.0; KINDS] {
            account.by_impacts = missing;
        } else {
            self.share(missing, &mut account.by_force, &changed);
        }
        account
    }

    /// Whether impacts changed its momentum by more than the rounding that a ride on a lift brings.
    fn is_hit(&self) -> bool {
        let impulses = self.game.world().impulses().iter().filter(|hit| hit.impact).filter_map(|hit| hit.on(self.id));
        let passed_on: f64 = impulses.map(|(impulse, _)| impulse.length()).sum();
        let speeds = self.before.velocity.length() + self.after.velocity.length();
        passed_on > ROUNDING * self.game.world().body(self.id).mass * speeds
    }

    /// Gives the forces the remainder of their sum.
    fn share(&self, missing: f64, works: &mut [f64; KINDS], changed: &[f64; KINDS]) {
        let contacts = [ForceKind::Reaction, ForceKind::Friction, ForceKind::Push].map(|kind| kind as usize);
        let turned = || contacts.into_iter().filter(|k: &usize| differ(self.before.forces[*k], self.after.forces[*k]) > ABRUPT);
        // The part of the path from its middle to the point of the change.
        let further = missing / turned().map(|k| changed[k]).sum::<f64>();
        if further.abs() <= 0.5 + ABRUPT {
            return turned().for_each(|k| works[k] += further * changed[k]);
        }
        let all: f64 = changed.iter().map(|work| work.abs()).sum();
        if all > 0.0 {
            works.iter_mut().zip(changed).for_each(|(work, changed)| *work += missing * (changed.abs() / all));
        } else if let Some(largest) = works.iter_mut().max_by(|a, b| a.abs().total_cmp(&b.abs())) {
            *largest += missing;
        }
    }
}

/// The difference of two forces as a part of the larger one.
fn differ(a: DVec2, b: DVec2) -> f64 {
    let larger = a.length().max(b.length());
    if larger == 0.0 { 0.0 } else { (a - b).length() / larger }
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyState {
    /// Σ m·v, N·s, y downwards.
    pub momentum: DVec2,
    /// Σ ½mv², J.
    pub kinetic: f64,
    /// −Σ m·g·(r − r₀), J: in the level's own gravity, above [`ground`] or another zero; that of zones, which end at borders, has no potential.
    pub potential: f64,
    /// The energy of its springs and ropes, J: half of it where a link leads to another body.
    pub elastic: f64,
}

impl EnergyState {
    pub fn of(game: &Game, id: BodyId) -> Self {
        Self::above(ground(game.level()), game, id)
    }

    /// With potential energy from `zero` (m) on.
    pub fn above(zero: DVec2, game: &Game, id: BodyId) -> Self {
        let (level, body) = (game.level(), game.world().body(id));
        let field = if body.weightless { DVec2::ZERO } else { DVec2::new(level.gravity_x, level.gravity) };
        Self {
            momentum: body.mass * body.velocity,
            kinetic: 0.5 * body.mass * body.velocity.length_squared(),
            potential: -body.mass * field.dot(body.position - zero),
            elastic: elastic(game, id),
        }
    }

    /// J.
    pub fn sum(&self) -> f64 {
        self.kinetic + self.potential + self.elastic
    }
}

impl Add for EnergyState {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            momentum: self.momentum + other.momentum,
            kinetic: self.kinetic + other.kinetic,
            potential: self.potential + other.potential,
            elastic: self.elastic + other.elastic,
        }
    }
}

fn elastic(game: &Game, id: BodyId) -> f64 {
    let world = game.world();
    let stored = |link: &Link| {
        let def = link.def();
        let share = match def.to {
            LinkEnd::Body(other) if other == id || def.body == id => 0.5,
            LinkEnd::Place(_) if def.body == id => 1.0,
            _ => return 0.0,
        };
        let [from, to] = world.link_ends(link);
        share * link.law().energy(from.distance(to))
    };
    world.links().iter().filter(|link| link.acts()).map(stored).sum()
}

/// Where potential energy is zero, m: the corner of the level to which its gravity pulls, so that nothing has less.
pub fn ground(level: &Level) -> DVec2 {
    let along = |gravity: f64, size: f64| if gravity > 0.0 { size } else { 0.0 };
    DVec2::new(along(level.gravity_x, level.size.x), along(level.gravity, level.size.y))
}

/// Σ m·r / Σ m over bodies, m.
pub fn centre_of_mass(bodies: &[Body]) -> DVec2 {
    mean(bodies, |body| body.position)
}

/// Σ m·v / Σ m over bodies, m/s.
pub fn velocity_of_centre(bodies: &[Body]) -> DVec2 {
    mean(bodies, |body| body.velocity)
}

/// By mass.
fn mean(bodies: &[Body], of: fn(&Body) -> DVec2) -> DVec2 {
    let (sum, mass) = bodies.iter().fold((DVec2::ZERO, 0.0), |(sum, mass), body| (sum + body.mass * of(body), mass + body.mass));
    sum / mass
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, World, WorldDef};

    #[test]
    fn potential_energy_counts_from_where_gravity_pulls_to() {
        let level = |gravity_x, gravity| Level { size: DVec2::new(40.0, 20.0), gravity_x, gravity, ..crate::level::fixture() };
        assert_eq!(ground(&level(0.0, 9.81)), DVec2::new(0.0, 20.0));
        assert_eq!(ground(&level(0.0, -9.81)), DVec2::ZERO);
        assert_eq!(ground(&level(2.0, 0.0)), DVec2::new(40.0, 0.0));
        let high = Level { size: DVec2::splat(1000.0), ..level(0.0, 10.0) };
        let game = Game::new(std::sync::Arc::new(high)).expect("a level");
        let ship = game.world().body(BodyId(0));
        let state = EnergyState::of(&game, BodyId(0));
        assert!((state.potential - ship.mass * 10.0 * (1000.0 - ship.position.y)).abs() < 1e-9);
    }

    #[test]
    fn it_lies_nearer_to_the_heavier() {
        let mut world = World::new(WorldDef::default()).expect("an empty world");
        for (mass, x, speed) in [(1.0, 10.0, 8.0), (3.0, 14.0, -4.0)] {
            let (position, velocity) = (DVec2::new(x, 50.0), DVec2::new(speed, 0.0));
            world.add_body(BodyDef { mass, position, velocity, ..BodyDef::default() }).expect("a body");
        }
        assert_eq!(centre_of_mass(world.bodies()), DVec2::new(13.0, 50.0));
        assert_eq!(velocity_of_centre(world.bodies()), DVec2::new(-1.0, 0.0));
    }
}
