//! Records the contacts of an island that a crowd step has solved.

use crate::physics::crowd::Other;
use crate::physics::crowd::bodies::Bodies;
use crate::physics::crowd::dense::Dense;
use crate::physics::crowd::impulses::{ContactImpulse, Edge, Record};
use crate::physics::crowd::report::Report;
use crate::physics::data::axis::Axis;
use glam::DVec2;

impl Dense {
    /// Records the contacts of an island that has just been solved.
    pub fn record(&mut self, bodies: &Bodies, members: &[u32], down: f64) {
        let mut report = std::mem::take(&mut self.report);
        report.records.clear();
        self.record_along(bodies, members, &mut report);
        self.record_across(bodies, members, &mut report);
        let touch = self.contacts.tolerances.touch;
        for record in &report.records {
            if record.normal != 0.0 || record.friction != 0.0 {
                report.list.push(listed(bodies, record, touch, down));
            }
        }
        self.report = report;
    }

    fn record_along(&mut self, bodies: &Bodies, members: &[u32], report: &mut Report) {
        let n = bodies.len();
        let mut lack = std::mem::take(&mut report.along);
        for &i in members {
            let i = i as usize;
            lack[i] = bodies.mass[i] * (bodies.free_vy[i] - bodies.uy[i]) + self.walls.held_up[i];
        }
        let mut edges = std::mem::take(&mut self.anchors.edges);
        let loose = &self.anchors.loose;
        report.drain(&mut edges, &mut lack, |i| i >= n || !loose[i]);
        for edge in &edges {
            report.records.push(Record { a: edge.a, b: edge.b, axis: Axis::Gravity, normal: -edge.impulse, friction: 0.0 });
        }
        self.anchors.edges = edges;
        let passed_on = members.iter().map(|i| *i as usize).filter(|i| self.anchors.loose[*i]);
        passed_on.for_each(|i| lack[i] = 0.0);
        let records = &mut report.records;
        self.contacts.hand_down(bodies, &self.anchors, members, &mut lack, |a, b, share| {
            records.push(Record { a, b, axis: Axis::Gravity, normal: -share, friction: 0.0 });
        });
        report.along = lack;
    }

    fn record_across(&mut self, bodies: &Bodies, members: &[u32], report: &mut Report) {
        let n = bodies.len();
        // What each body still needs: its change, less what its sides gave.
        for &i in members {
            let i = i as usize;
            report.across[i] = bodies.mass[i] * (bodies.ux[i] - bodies.free_vx[i]);
        }
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
        let pushes = |side: &Edge| Record { a: side.a, b: side.b, axis: Axis::Across, normal: -side.impulse, friction: 0.0 };
        report.records.extend(report.sides.iter().map(pushes));
        self.walls.record(&mut report.records);
    }
}

/// A record for the outside.
fn listed(bodies: &Bodies, record: &Record, touch: f64, down: f64) -> ContactImpulse {
    let n = bodies.len();
    let Record { mut a, mut b, axis, mut normal, mut friction } = *record;
    if a as usize >= n {
        (a, b, normal, friction) = (b, a, -normal, -friction);
    }
    let (i, j) = (a as usize, b as usize);
    let ([x, half, v, p], [far, far_half], rides) = match axis {
        Axis::Gravity => ([&bodies.y, &bodies.hy, &bodies.vy, &bodies.py], [&bodies.px, &bodies.hx], bodies.rides_along(i, j, 0.0)),
        Axis::Across => ([&bodies.x, &bodies.hx, &bodies.vx, &bodies.px], [&bodies.py, &bodies.hy], bodies.rides_across(i, j, 0.0)),
    };
    let (side, gap) = (if x[j] < x[i] { -1.0 } else { 1.0 }, (x[i] - x[j]).abs() - half[i] - half[j]);
    let impact = gap > touch || ((v[i] - v[j]) * side > touch && !rides);
    let (from, to) = ((far[i] - far_half[i]).max(far[j] - far_half[j]), (far[i] + far_half[i]).min(far[j] + far_half[j]));
    let (at, middle) = (p[i] + side * half[i], 0.5 * (from + to));
    let point = if axis == Axis::Gravity { DVec2::new(middle, at) } else { DVec2::new(at, middle) };
    let (along, other) = if axis == Axis::Gravity { (down, 1.0) } else { (1.0, down) };
    let b = if j < n { Other::Body(j) } else { Other::Surface(j - n) };
    let a = i;
    ContactImpulse {
        a,
        b,
        axis,
        normal: normal * along,
        friction: friction * other,
        point: point * DVec2::new(1.0, down),
        impact,
        solved: 0,
    }
}
