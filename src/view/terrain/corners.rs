//! Rounded outer corners of rock, in the drawing alone: what collides is the box.

use super::ROCK;
use super::silhouette::{Corner, RockEdge};
use crate::draw::layout::Vec2;
use crate::draw::{Colour, Quads};
use crate::level::Level;
use crate::physics::{Aabb, DVec2};
use crate::view::camera::Viewport;
use std::f64::consts::FRAC_PI_2;

/// m.
const RADIUS: f64 = 0.25;
const STEPS: u32 = 5;

/// An outer corner of rock before open sky.
#[derive(Clone, Copy, Debug)]
pub struct RockCorner {
    /// m.
    at: DVec2,
    /// The unit vector along the edge that ends here; the next one runs along `inward`.
    along: DVec2,
    inward: DVec2,
}

/// The corners with room for the radius on both edges. A corner in a liquid, a stream or a mechanism keeps its box's shape.
pub fn corners(edges: &[RockEdge], level: &Level) -> Vec<RockCorner> {
    let taken: Vec<Aabb> = (level.fluids.iter().map(|fluid| fluid.zone))
        .chain(level.streams.iter().flat_map(|stream| [stream.zone, stream.source]))
        .chain(level.doors.iter().map(|door| door.bounds))
        .chain(level.movers.iter().map(|mover| mover.solid.bounds))
        .chain(level.world.iter().filter(|solid| !solid.is_rock()).map(|solid| solid.bounds))
        .chain(level.switches.iter().map(|switch| switch.bounds))
        .chain(level.objectives.iter().map(|objective| objective.bounds))
        .chain(level.obstacles.iter().copied())
        .collect();
    let long = |edge: &RockEdge| edge.kind == ROCK && edge.length() >= 2.0 * RADIUS && edge.depth >= RADIUS;
    let rounded = edges.iter().filter(|edge| edge.corners[1] == Corner::Outer && long(edge)).filter(|edge| {
        let goes_on = |next: &&RockEdge| next.from == edge.to && next.inward == -edge.along() && long(next);
        edges.iter().any(|next| goes_on(&next))
            && taken.iter().all(|other| !Aabb::around(edge.to, DVec2::ZERO).touches(other, RADIUS))
    });
    rounded.map(|edge| RockCorner { at: edge.to, along: edge.along(), inward: edge.inward }).collect()
}

/// Covers the tip of each corner in view with the colour of the sky behind it and draws the edge round it.
pub fn draw(
    corners: &[RockCorner],
    view: &Viewport,
    quads: &mut Quads,
    sky: impl Fn(Vec2) -> Colour,
    edge: impl Fn(DVec2) -> Colour,
) {
    let visible = view.visible();
    for RockCorner { at, along, inward } in
        corners.iter().filter(|corner| visible.contains(&Aabb::around(corner.at, DVec2::ZERO), 0.0))
    {
        let centre = *at + (*inward - *along) * RADIUS;
        let out = |step: u32| {
            let (sin, cos) = (f64::from(step) / f64::from(STEPS) * FRAC_PI_2).sin_cos();
            *along * sin - *inward * cos
        };
        let tip = view.point(*at);
        let behind = sky(tip);
        for step in 0..STEPS {
            let [a, b] = [step, step + 1].map(|step| view.point(centre + out(step) * RADIUS));
            quads.triangle([tip, a, b], behind);
            let colour = edge(-(out(step) + out(step + 1)) * 0.5);
            let inner = [step, step + 1].map(|step| view.point(centre + out(step) * RADIUS) - out(step).as_vec2() * 2.5);
            quads.quad([a, b, inner[1], inner[0]], [colour; 4]);
        }
    }
}
