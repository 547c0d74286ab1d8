//! Looks on while an engine runs: how deep anything has sunk into anything, and what still moves.

use crate::engine::{Engine, Spec, V};

/// An [`Engine`] that runs, whichever it is.
pub trait Run {
    /// One step.
    fn step(&mut self, dt: f64);
    /// A body's centre, m.
    fn position(&mut self, body: usize) -> V;
    /// m/s.
    fn velocity(&mut self, body: usize) -> V;
    /// The deepest overlap of any two things after any step so far, m.
    fn overlap(&self) -> f64;
    /// See [`Engine::QUADRATIC`].
    fn quadratic(&self) -> bool;
}

/// An engine that is looked at after every step.
pub struct Watched<'a, E> {
    engine: &'a mut E,
    spec: &'a Spec,
    worst: f64,
    /// s since the start, for what moves by itself.
    time: f64,
    /// Bodies from left to right.
    order: Vec<usize>,
    places: Vec<V>,
}

impl<'a, E: Engine> Watched<'a, E> {
    /// Begins to look on.
    pub fn new(engine: &'a mut E, spec: &'a Spec) -> Self {
        let n = spec.bodies.len();
        Self { time: 0.0, engine, spec, worst: 0.0, order: (0..n).collect(), places: vec![(0.0, 0.0); n] }
    }

    /// The speed of the fastest body, m/s.
    pub fn speed(&mut self) -> f64 {
        let speed = |i| {
            let (u, w) = self.engine.velocity(i);
            u.hypot(w)
        };
        (0..self.spec.bodies.len()).map(speed).fold(0.0, f64::max)
    }

    fn look(&mut self) {
        let (bodies, places) = (&self.spec.bodies, &mut self.places);
        for (i, place) in places.iter_mut().enumerate() {
            *place = self.engine.position(i);
        }
        let left = |i: usize| places[i].0 - bodies[i].half.0;
        self.order.sort_by(|&i, &j| left(i).total_cmp(&left(j)));
        let lift = self.spec.lift.as_ref().map(|lift| (lift.at(self.time), lift.place.1));
        for (at, &i) in self.order.iter().enumerate() {
            let ((x, y), (w, h)) = (places[i], bodies[i].half);
            let near = self.order[at + 1..].iter().take_while(|&&j| left(j) < x + w);
            let others = near.map(|&j| (places[j], bodies[j].half)).chain(self.spec.statics.iter().copied()).chain(lift);
            for (place, half) in others {
                let depth = (w + half.0 - (x - place.0).abs()).min(h + half.1 - (y - place.1).abs());
                self.worst = self.worst.max(depth);
            }
        }
    }
}

impl<E: Engine> Run for Watched<'_, E> {
    fn step(&mut self, dt: f64) {
        self.engine.step(dt);
        self.time += dt;
        self.look();
    }

    fn position(&mut self, body: usize) -> V {
        self.engine.position(body)
    }

    fn velocity(&mut self, body: usize) -> V {
        self.engine.velocity(body)
    }

    fn overlap(&self) -> f64 {
        self.worst
    }

    fn quadratic(&self) -> bool {
        E::QUADRATIC
    }
}
