//! Records the contacts of an island that a crowd step has solved.

use crate::physics::crowd::{ACROSS, ALONG, ContactImpulse, Edge, Record, bodies::Bodies, bodies::Frame, dense::Dense};
use crate::physics::{crowd::report::Report, data::on_axis};
use glam::DVec2;

impl Dense {
    pub fn record(&mut self, bodies: &Bodies, frame: Frame) {
        let mut report = std::mem::take(&mut self.report);
        report.records.clear();
        self.record_along(bodies, &mut report);
        self.record_across(bodies, &mut report);
        let touch = self.contacts.tolerances.touch;
        let acting = report.records.iter().filter(|record| record.normal != 0.0 || record.friction != 0.0);
        report.list.extend(acting.map(|record| listed(bodies, record, touch, frame)));
        self.report = report;
    }

    fn record_along(&mut self, bodies: &Bodies, report: &mut Report) {
        let n = bodies.len();
        let mut lack = std::mem::take(&mut report.along);
        (0..n).for_each(|i| lack[i] = bodies[i].mass * (bodies[i].free.y - bodies[i].end.y) + self.walls.held_up[i]);
        let mut edges = std::mem::take(&mut self.anchors.edges);
        let loose = &self.anchors.loose;
        report.drain(&mut edges, &mut lack, |i| i >= n || !loose[i]);
        let parted = |edge: &Edge| Record { a: edge.a, b: edge.b, axis: ALONG, normal: -edge.impulse, friction: 0.0 };
        report.records.extend(edges.iter().map(parted));
        self.anchors.edges = edges;
        (0..n).filter(|i| self.anchors.loose[*i]).for_each(|i| lack[i] = 0.0);
        self.contacts.hand_down(bodies, &self.anchors, &mut lack, |a, b, share| {
            report.records.push(Record { a, b, axis: ALONG, normal: -share, friction: 0.0 });
        });
        report.along = lack;
    }

    fn record_across(&mut self, bodies: &Bodies, report: &mut Report) {
        let n = bodies.len();
        (0..n).for_each(|i| report.across[i] = bodies[i].mass * (bodies[i].end.x - bodies[i].free.x));
        for side in &report.sides {
            report.across[side.a as usize] += side.impulse;
            report.across[side.b as usize] -= side.impulse;
        }
        // Stacks come bottom-up within merges and top-down within loads: by the upper body, the last first.
        report.records.sort_unstable_by(|a, b| b.a.cmp(&a.a).then(a.b.cmp(&b.b)));
        let bears = |record: &Record| record.normal < 0.0 || (record.b as usize >= n && record.normal != 0.0);
        let mut k = 0;
        while k < report.records.len() {
            let upper = report.records[k].a;
            let end = k + report.records[k..].iter().take_while(|record| record.a == upper).count();
            let mut needs = report.across[upper as usize];
            let group = &mut report.records[k..end];
            let count = group.iter().filter(|record| bears(record)).count();
            let last = group.iter().rposition(bears);
            for (g, record) in group.iter_mut().enumerate().filter(|(_, record)| bears(record)) {
                let known = if self.friction.is_awake[upper as usize] {
                    self.friction.impulse(upper as usize, record.b)
                } else {
                    needs / count as f64
                };
                record.friction = if Some(g) == last { needs } else { known };
                needs -= record.friction;
                report.across[record.b as usize] += record.friction;
            }
            k = end;
        }
        let pushes = |side: &Edge| Record { a: side.a, b: side.b, axis: ACROSS, normal: -side.impulse, friction: 0.0 };
        report.records.extend(report.sides.iter().map(pushes));
        self.walls.record(&mut report.records);
    }
}

fn listed(bodies: &Bodies, record: &Record, touch: f64, frame: Frame) -> ContactImpulse {
    let n = bodies.len();
    let Record { mut a, mut b, axis, mut normal, mut friction } = *record;
    if a as usize >= n {
        (a, b, normal, friction) = (b, a, -normal, -friction);
    }
    let (first, second, far) = (&bodies[a as usize], &bodies[b as usize], 1 - axis);
    let side = if second.from[axis] < first.from[axis] { -1.0 } else { 1.0 };
    let gap = (first.from - second.from).abs()[axis] - first.half[axis] - second.half[axis];
    let closes = (first.before - second.before)[axis] * side > touch && !bodies.rides(a as usize, b as usize, axis, 0.0);
    let (from, to) = ((first.to - first.half).max(second.to - second.half), (first.to + first.half).min(second.to + second.half));
    let mut point = DVec2::ZERO;
    (point[axis], point[far]) = (first.to[axis] + side * first.half[axis], 0.5 * (from[far] + to[far]));
    let (vector, axis) = (frame.turn(on_axis(axis, normal, friction)), frame.axis(axis));
    let (normal, friction, point) = (vector[axis], vector[1 - axis], frame.turn(point));
    ContactImpulse { a, b, axis, normal, friction, point, impact: gap > touch || closes, solved: 0 }
}
