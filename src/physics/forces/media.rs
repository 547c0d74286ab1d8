//! The media of a world, and weight: m·g downwards. A weightless body has none.

use crate::physics::data::{Aabb, Body, Cubic, FieldDef, FluidDef, Part, Pose, StreamDef, called};
use crate::physics::forces::{manager::ForceManager, zones::FAR, zones::Stream, zones::ZoneList, zones::border};
use glam::DVec2;
use std::cell::Cell;

#[derive(Clone, Debug)]
pub(crate) struct Media {
    /// N/kg downwards.
    pub gravity: f64,
    /// kg/m³.
    pub air_density: f64,
    /// Whether the plan has drag of the air.
    pub airy: bool,
    /// Air streams, and behind them fields.
    pub streams: Vec<Stream>,
    pub fluids: Vec<FluidDef>,
    ended_early: Cell<u64>,
}

impl Media {
    pub fn new(gravity: f64, air_density: f64, (streams, fields): (&[StreamDef], &[FieldDef]), fluids: Vec<FluidDef>) -> Self {
        let streams = (0..).zip(streams).map(Stream::wind).chain((0..).zip(fields).map(Stream::field)).collect();
        Self { gravity, air_density, airy: true, streams, fluids, ended_early: Cell::new(0) }
    }

    /// N/kg downwards.
    pub fn gravity_on(&self, body: &Body) -> f64 {
        if body.weightless { 0.0 } else { self.gravity }
    }

    /// N.
    pub fn weight(&self, body: &Body) -> DVec2 {
        DVec2::new(0.0, body.mass * self.gravity_on(body))
    }

    /// Counts a flow that did not get to its end by its own steps.
    pub fn end_early(&self) {
        self.ended_early.set(self.ended_early.get() + 1);
    }

    /// How many, since this was asked last.
    pub fn take_ended_early(&self) -> u64 {
        self.ended_early.take()
    }

    /// The streams and fields that a box touches within `slop` metres.
    pub fn streams_at(&self, near: &Aabb, slop: f64) -> ZoneList {
        if self.streams.is_empty() {
            return ZoneList::default();
        }
        called(Part::Streams);
        ZoneList::touching(self.streams.iter().map(|stream| &stream.zone), near, slop)
    }

    pub fn liquids_at(&self, near: &Aabb) -> ZoneList {
        ZoneList::touching(self.fluids.iter().map(|fluid| &fluid.zone), near, 0.0)
    }

    pub fn wets(&self, near: &Aabb) -> bool {
        if self.fluids.is_empty() {
            return false;
        }
        called(Part::Liquids);
        self.fluids.iter().any(|fluid| near.touches(&fluid.zone, 0.0))
    }

    fn felt<'a>(&'a self, body: &'a Body) -> impl Iterator<Item = &'a Stream> {
        self.streams.iter().filter(|stream| stream.is_felt(body))
    }

    /// Lets the streams and fields that a body feels enter its force manager, and the others leave it.
    pub fn feel(&self, body: &Body, forces: &mut ForceManager) {
        called(Part::Streams);
        forces.leave_zones(|source| self.streams.iter().any(|stream| stream.source == source && stream.is_felt(body)));
        self.felt(body).for_each(|stream| _ = forces.add(stream.source, stream.kind, stream.on(body)));
    }

    /// The force of all streams and fields that a body feels besides a `push`, N.
    pub fn force_of_streams(&self, body: &Body, push: DVec2) -> DVec2 {
        self.felt(body).fold(push, |force, stream| force + stream.on(body))
    }

    /// Whether a body that ends the tick in a pose crosses the border of a stream or field.
    pub fn crosses_border(&self, body: &Body, end: Pose, dt: f64) -> bool {
        let way = Cubic::hermite(body.position, body.velocity, end.0, end.1, dt);
        let near = self.streams_at(&way.swept(body.half, dt), FAR);
        let crosses = |stream: &Stream| border(&way, body.half, &stream.zone, stream.is_felt(body), dt).is_some();
        near.iter().any(|stream| crosses(&self.streams[stream as usize]))
    }
}

/// The acceleration along y by gravity and a force per mass, m/s²; 0 where they balance but for rounding.
pub(crate) fn fall(gravity: f64, force: f64) -> f64 {
    let sum = gravity + force;
    if sum.abs() <= 4.0 * f64::EPSILON * gravity.abs() { 0.0 } else { sum }
}
