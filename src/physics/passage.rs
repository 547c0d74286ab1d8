//! The way of one body of a crowd through zones within a tick, contacts left out.
//!
//! Sampling a zone once a tick shifts its border by up to v·h and costs 1e-2 m. So a tick in which a body may cross a border of a stream,
//! or in which it is near a liquid, is parted where its law changes: at the borders, where the submerged part begins or ceases to grow,
//! and where the body turns another side to the medium. In each part it follows its flow, as it would in a small world.
//!
//! What is held at rest is pulled by the forces as they are, and meets no drag on a way that it does not go: so what its contacts have to
//! bear is right to the last bit.
//!
//! Limits: the crossings are those of the free way. What touched something in the last tick may be held, and would not get that far; its
//! crossings are sought on the straight line along its velocity, so that what rests crosses nothing. A slide out of a stream ends
//! millimetres off.

use super::World;
use super::crossing::{border, surface_kink};
use super::flow::{Pose, flow, parabola};
use super::impact_time::Cubic;
use super::tuning::MAX_CROSSINGS;
use glam::DVec2;

impl World {
    /// Where body `i` would be after a tick if it touched nothing. None where a constant force and the air describe that. Leaves the law,
    /// and the streams it is in, as they are at the end.
    pub(super) fn passage(&mut self, i: usize, tick: f64, touched: bool) -> Option<Pose> {
        let mut body = self.bodies[i].clone();
        let at_rest = body.velocity == DVec2::ZERO;
        if touched && at_rest {
            let a = self.media.acceleration(&body, &self.laws[i], body.position, DVec2::ZERO);
            return Some(parabola((body.position, DVec2::ZERO), a, tick));
        }
        if !(self.laws[i].is_near_liquid() || self.is_near_border(i, tick)) {
            return None;
        }
        let streams = self.media.streams.len();
        let mut left = tick;
        let mut crossings = 0;
        loop {
            let law = self.laws[i];
            let end = flow(&self.media, &body, &law, left);
            let path = if touched || at_rest {
                Cubic::parabola(body.position, body.velocity, DVec2::ZERO)
            } else {
                Cubic::hermite(body.position, body.velocity, end.0, end.1, left)
            };
            let (mut first, mut crossed) = (left, None);
            for s in 0..streams {
                if let Some(t) = border(&path, body.half, &self.media.streams[s].zone, self.in_stream[i * streams + s], first) {
                    (first, crossed) = (t, Some(s));
                }
            }
            if law.is_near_liquid() {
                for fluid in &self.media.fluids {
                    if let Some(t) = surface_kink(&path, body.half, &fluid.zone, first) {
                        (first, crossed) = (t, None);
                    }
                }
            }
            if first == left || crossings == MAX_CROSSINGS {
                return Some(end);
            }
            crossings += 1;
            (body.position, body.velocity) = flow(&self.media, &body, &law, first);
            left -= first;
            if let Some(s) = crossed {
                let inside = &mut self.in_stream[i * streams + s];
                *inside = !*inside;
            }
            self.laws[i] = self.law(i, &body);
        }
    }

    /// Whether a body may cross the border of a stream within `t` seconds.
    fn is_near_border(&self, i: usize, t: f64) -> bool {
        let (body, bounds) = (&self.bodies[i], self.bodies[i].bounds());
        let reach = (body.velocity.abs() + self.laws[i].constant.abs() * t) * t;
        let reach = reach.max_element();
        self.media.streams.iter().any(|stream| bounds.gap(&stream.zone).max_element().abs() <= reach)
    }
}
