//! Emitters of particles, with rates and directions: the engine's plume, dust, objectives, key objects and air streams.

use super::particles::{Particle, ParticleLook, Particles};
use super::theme;
use crate::draw::Colour;
use crate::game::{Game, Outcome, SHIP, object_body};
use crate::level::{Level, ObjectiveKind, SHIP_HALF};
use crate::physics::{Aabb, DVec2, ForceKind};

/// Particles of the plume a second, at full thrust.
const PLUME_RATE: f64 = 110.0;
/// The plume's speed relative to the ship, m/s.
const PLUME_SPEED: f64 = 7.0;
/// Time in which the plume grows to its full size, s.
const PLUME_GROWTH: f64 = 0.06;
/// Sparks a second and metre of an objective's outline.
const OBJECTIVE_RATE: f64 = 1.3;
const KEY_RATE: f64 = 9.0;
/// Streaks a second and square metre of an air stream.
const STREAM_RATE: f64 = 1.2;
/// Streaks a second and newton of the force of a stream or the air on the ship, and at most.
const FELT_RATE: f64 = 0.12;
const MOST_FELT: f64 = 70.0;
/// The streaks of a felt force begin up to this far around the ship, m.
const FELT_REACH: f64 = 1.6;
/// The most particles a second of all objectives, key objects and streams in view together: with more they thin out.
const MOST_A_SECOND: f64 = 260.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Emitter {
    Objective(usize),
    Key(usize),
    Stream(usize),
}

/// Each emitter keeps the fraction of its next particle.
pub struct Emitters {
    all: Vec<(Emitter, f64)>,
    plume: f64,
    /// Of the streaks of the air, and of the streams' streaks.
    felt: [f64; 2],
    /// Growth of the plume, 0 … 1.
    strength: f64,
    /// The engine's last direction: 1 along the nose, −1 against it.
    way: f64,
}

impl Emitters {
    pub fn new(level: &Level) -> Self {
        let keys = (0..level.objects.len()).filter(|&i| level.objects[i].key.is_some());
        let streams = (0..level.streams.len()).map(Emitter::Stream);
        let all = (0..level.objectives.len()).map(Emitter::Objective).chain(keys.map(Emitter::Key)).chain(streams);
        Self { all: all.map(|emitter| (emitter, 0.0)).collect(), plume: 0.0, felt: [0.0; 2], strength: 0.0, way: 1.0 }
    }

    /// Growth of the plume (0 … 1), and its side: the tail (1) or the nose (−1).
    pub const fn plume(&self) -> (f64, f64) {
        (self.strength, self.way)
    }

    /// Emits the particles of `frame_time` seconds in view. `ship` is the ship's drawn centre.
    pub fn emit(&mut self, game: &Game, ship: DVec2, angle: f64, visible: &Aabb, frame_time: f64, particles: &mut Particles) {
        self.emit_plume(game, ship, angle, frame_time, particles);
        self.emit_felt(game, ship, frame_time, particles);
        let rates: Vec<f64> = self.all.iter().map(|(emitter, _)| rate(*emitter, game, visible)).collect();
        let thinned = thinning(rates.iter().sum());
        for ((emitter, ready), rate) in self.all.iter_mut().zip(rates) {
            *ready += rate * thinned * frame_time;
            while *ready >= 1.0 {
                *ready -= 1.0;
                particles_of(*emitter, game, particles);
            }
        }
    }

    /// Streaks past the ship for the drag of the air and the pull of streams: their rate grows with the force.
    fn emit_felt(&mut self, game: &Game, ship: DVec2, frame_time: f64, particles: &mut Particles) {
        if game.outcome() != Outcome::Running {
            return;
        }
        let forces = game.world().forces(SHIP);
        for (ready, kind) in self.felt.iter_mut().zip([ForceKind::AirResistance, ForceKind::Wind]) {
            let force = forces.total(kind);
            let strength = force.length();
            *ready += (strength * FELT_RATE).min(MOST_FELT) * frame_time;
            while *ready >= 1.0 {
                *ready -= 1.0;
                let way = force / strength;
                let place = way * -particles.between(0.2, 1.2) + way.perp() * particles.between(-1.0, 1.0);
                let motion = (ship + place * FELT_REACH, game.world().body(SHIP).velocity + way * particles.between(6.0, 10.0));
                particles.add(Particle::new(ParticleLook::Streak, theme::force(kind), motion, 0.3));
            }
        }
    }

    fn emit_plume(&mut self, game: &Game, ship: DVec2, angle: f64, frame_time: f64, particles: &mut Particles) {
        let burning = f64::from(game.ship().burning);
        if burning != 0.0 {
            self.way = burning;
        }
        let change = frame_time / PLUME_GROWTH;
        self.strength = if burning == 0.0 { self.strength - change } else { self.strength + change }.clamp(0.0, 1.0);
        if burning == 0.0 {
            return;
        }
        let (sin, cos) = angle.to_radians().sin_cos();
        let out = DVec2::new(-sin, cos) * burning;
        let across = out.perp();
        let moving = game.world().body(SHIP).velocity * 0.5;
        self.plume += PLUME_RATE * self.strength * frame_time;
        while self.plume >= 1.0 {
            self.plume -= 1.0;
            let spread = particles.between(-1.0, 1.0);
            let along = particles.between(0.0, 0.25);
            let speed = PLUME_SPEED * particles.between(0.75, 1.15);
            let life = particles.between(0.5, 1.5);
            let position = ship + out * (SHIP_HALF.y + along) + across * (spread * 0.16);
            let velocity = moving + out * speed + across * (spread * 1.3);
            particles.launch(ship, Particle::new(ParticleLook::Plume, theme::accent(), (position, velocity), life));
        }
    }
}

/// Dust of an impact: its amount grows with the speed.
pub fn dust(particles: &mut Particles, point: DVec2, normal: DVec2, speed: f64) {
    let along = normal.perp();
    for _ in 0..(4.0 + speed * 1.4).min(26.0) as usize {
        let sideways = particles.between(-1.0, 1.0);
        let away = particles.between(0.1, 0.6);
        let life = particles.between(0.3, 0.8);
        let velocity = (along * sideways + normal * away) * (0.8 + speed * 0.25).min(5.0);
        particles.add(Particle::new(ParticleLook::Dust, theme::quiet(), (point + along * (sideways * 0.4), velocity), life));
    }
}

/// The kind's colour, or green while the objective is met.
pub fn objective_colour(game: &Game, index: usize) -> Colour {
    match game.level().objectives[index].kind {
        _ if game.met()[index] => theme::good(),
        _ if !game.is_open(index) => theme::quiet(),
        ObjectiveKind::Player => theme::player_objective(),
        ObjectiveKind::Physics => theme::physics_objective(),
    }
}

/// The share of their wishes that all emitters together may emit, from the sum of the wishes a second.
fn thinning(wanted: f64) -> f64 {
    if wanted > MOST_A_SECOND { MOST_A_SECOND / wanted } else { 1.0 }
}

/// Particles a second that an emitter wishes to emit: none out of view.
fn rate(emitter: Emitter, game: &Game, visible: &Aabb) -> f64 {
    let level = game.level();
    let (bounds, rate) = match emitter {
        Emitter::Objective(i) => {
            let bounds = level.objectives[i].bounds;
            (bounds, (OBJECTIVE_RATE * 2.0 * bounds.size().element_sum()).min(30.0))
        }
        Emitter::Key(i) => (game.world().body(object_body(i)).bounds(), KEY_RATE),
        Emitter::Stream(i) if !game.world().blows(i) => return 0.0,
        Emitter::Stream(i) => {
            let zone = &level.streams[i].zone;
            let shown = (zone.max.min(visible.max) - zone.min.max(visible.min)).max(DVec2::ZERO);
            (*zone, STREAM_RATE * shown.x * shown.y)
        }
    };
    if bounds.touches(visible, 0.0) { rate } else { 0.0 }
}

fn particles_of(emitter: Emitter, game: &Game, particles: &mut Particles) {
    let level = game.level();
    match emitter {
        Emitter::Objective(i) => {
            let (position, out) = on_outline(&level.objectives[i].bounds, particles);
            let velocity = out * particles.between(0.2, 0.7) + DVec2::new(0.0, particles.between(-0.9, -0.2));
            spark(particles, position, velocity, objective_colour(game, i));
        }
        Emitter::Key(i) => {
            let body = game.world().body(object_body(i));
            let (position, out) = on_outline(&body.bounds(), particles);
            let velocity = body.velocity * 0.3 + out * particles.between(0.3, 0.9);
            spark(particles, position, velocity, Colour::of(level.objects[i].key.unwrap_or_default()));
        }
        Emitter::Stream(i) => {
            let stream = &level.streams[i];
            let way = stream.force.normalize_or_zero();
            let speed = (3.0 + stream.force.length() / 300.0).min(12.0) * particles.between(0.8, 1.2);
            let life = particles.between(0.5, 1.0);
            let size = stream.zone.size();
            let place = DVec2::new(particles.between(0.03, 0.97), particles.between(0.03, 0.97));
            // It begins far enough upstream that its whole path lies in the zone.
            let position = stream.zone.min + place * size;
            let room = (stream.zone.max - position).max(DVec2::ZERO).min(size);
            let axis = usize::from(way.x.abs() <= way.y.abs());
            let ahead = if way[axis] > 0.0 { room[axis] } else { size[axis] - room[axis] };
            let life = life.min(ahead / speed);
            if life as f32 > 0.1 {
                particles.add(Particle::new(ParticleLook::Streak, theme::force(ForceKind::Wind), (position, way * speed), life));
            }
        }
    }
}

fn spark(particles: &mut Particles, position: DVec2, velocity: DVec2, colour: Colour) {
    let life = particles.between(0.6, 1.3);
    particles.add(Particle::new(ParticleLook::Spark, colour, (position, velocity), life));
}

/// A random point on a box's outline and the outward direction there.
fn on_outline(bounds: &Aabb, particles: &mut Particles) -> (DVec2, DVec2) {
    let size = bounds.size();
    let along = particles.between(0.0, 2.0 * size.element_sum());
    let (min, max) = (bounds.min, bounds.max);
    if along < size.x {
        (DVec2::new(min.x + along, min.y), DVec2::NEG_Y)
    } else if along < 2.0 * size.x {
        (DVec2::new(min.x + along - size.x, max.y), DVec2::Y)
    } else if along < 2.0 * size.x + size.y {
        (DVec2::new(min.x, min.y + along - 2.0 * size.x), DVec2::NEG_X)
    } else {
        (DVec2::new(max.x, min.y + along - 2.0 * size.x - size.y), DVec2::X)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_emitters_thin_out_and_few_do_not() {
        assert_eq!(thinning(50.0), 1.0);
        assert!((1e4 * thinning(1e4) - MOST_A_SECOND).abs() < 1e-9);
    }

    #[test]
    fn dust_grows_with_the_impact_and_stays_bounded() {
        let count = |speed: f64| {
            let mut particles = Particles::default();
            dust(&mut particles, DVec2::ZERO, DVec2::NEG_Y, speed);
            particles.all.len()
        };
        assert!(count(2.0) < count(9.0) && count(9.0) < count(15.0));
        assert_eq!(count(1e6), 26);
    }

    #[test]
    fn sparks_begin_on_the_outline() {
        let bounds = Aabb::new(DVec2::new(1.0, 2.0), DVec2::new(4.0, 3.0));
        let mut particles = Particles::default();
        for _ in 0..200 {
            let (p, out) = on_outline(&bounds, &mut particles);
            assert!(bounds.contains(&Aabb::new(p, p), 1e-9) && !bounds.contains(&Aabb::new(p + out * 0.01, p + out * 0.01), 0.0));
        }
    }
}
