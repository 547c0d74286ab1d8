//! Records the contacts of an island that a crowd step has solved.

use crate::physics::crowd::Other;
use crate::physics::crowd::dense::Dense;
use crate::physics::crowd::impulses::{ContactImpulse, Record};
use crate::physics::crowd::report::Report;
use crate::physics::data::axis::Axis;
use crate::physics::store::bodies::Bodies;
use crate::physics::store::islands::Island;
use glam::DVec2;

impl Dense {
    /// Records the contacts of an island that has just been solved.
    pub fn record(&mut self, bodies: &Bodies, island: Island<'_>, down: f64) {
        let mut report = std::mem::take(&mut self.report);
        report.records.clear();
        self.record_along(bodies, island, &mut report);
        self.record_across(bodies, island, &mut report);
        let touch = self.contacts.tolerances.touch;
        for record in &report.records {
            if record.normal != 0.0 || record.friction != 0.0 {
                report.list.push(listed(bodies, record, touch, down));
            }
        }
        self.report = report;
    }

    fn record_along(&mut self, bodies: &Bodies, island: Island<'_>, report: &mut Report) {
        let n = bodies.len();
        let mut lack = std::mem::take(&mut report.along);
        for &i in island.members {
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
        let slack = self.contacts.tolerances.hair;
        for &i in island.members.iter().rev() {
            let i = i as usize;
            if lack[i] <= 0.0 || self.anchors.loose[i] {
                continue;
            }
            let presses = |stack: &&crate::physics::crowd::contacts::Contact| {
                let j = stack.second as usize;
                stack.live
                    && self.anchors.held[j]
                    && ((bodies.mean_vy[i] - bodies.mean_vy[j] - stack.bound) * self.dt).abs() <= slack
            };
            let under = &self.contacts.stacks[self.contacts.under(i)];
            let count = under.iter().filter(presses).count();
            let share = lack[i] / count as f64;
            for stack in under.iter().filter(presses) {
                if (stack.second as usize) < n {
                    lack[stack.second as usize] += share;
                }
                report.records.push(Record { a: i as u32, b: stack.second, axis: Axis::Gravity, normal: -share, friction: 0.0 });
            }
        }
        report.along = lack;
    }

    fn record_across(&mut self, bodies: &Bodies, island: Island<'_>, report: &mut Report) {
        let n = bodies.len();
        // What each body still needs: its change, less what its sides gave.
        for &i in island.members {
            let i = i as usize;
            report.across[i] = bodies.mass[i] * (bodies.ux[i] - bodies.free_vx[i]);
        }
        for side in &report.sides {
            for (i, impulse) in [(side.a as usize, side.impulse), (side.b as usize, -side.impulse)] {
                if i < n {
                    report.across[i] += impulse;
                }
            }
        }
        // Stacks come bottom-up within merges and top-down within loads: by the upper body, the last first.
        // Slots are numbered when all is sought anew, for whatever reason: the order is that of the island.
        let (upper, lower) = (|record: &Record| self.place_of(record.a), |record: &Record| (self.place_of(record.b), record.b));
        report.records.sort_unstable_by(|a, b| upper(b).cmp(&upper(a)).then(lower(a).cmp(&lower(b))));
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
                let known = if self.friction.is_awake(upper as usize) {
                    self.friction.impulse(upper as usize, record.b)
                } else {
                    needs / count as f64
                };
                record.friction = if Some(g) == last { needs } else { known };
                needs -= record.friction;
                if (record.b as usize) < n {
                    report.across[record.b as usize] += record.friction;
                }
            }
            k = end;
        }
        for side in &report.sides {
            if side.impulse != 0.0 {
                report.records.push(Record { a: side.a, b: side.b, axis: Axis::Across, normal: -side.impulse, friction: 0.0 });
            }
        }
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
    let gap = |x: &[f64], h: &[f64]| (x[i] - x[j]).abs() - h[i] - h[j];
    let side = |x: &[f64]| if x[j] < x[i] { -1.0 } else { 1.0 };
    let middle = |x: &[f64], h: &[f64]| 0.5 * ((x[i] - h[i]).max(x[j] - h[j]) + (x[i] + h[i]).min(x[j] + h[j]));
    let (point, impact) = match axis {
        Axis::Gravity => {
            let closes = (bodies.vy[i] - bodies.vy[j]) * side(&bodies.y) > touch && !bodies.rides_along(i, j, 0.0);
            let point = DVec2::new(middle(&bodies.px, &bodies.hx), bodies.py[i] + side(&bodies.y) * bodies.hy[i]);
            (point, closes || gap(&bodies.y, &bodies.hy) > touch)
        }
        Axis::Across => {
            let closes = (bodies.vx[i] - bodies.vx[j]) * side(&bodies.x) > touch && !bodies.rides_across(i, j, 0.0);
            let point = DVec2::new(bodies.px[i] + side(&bodies.x) * bodies.hx[i], middle(&bodies.py, &bodies.hy));
            (point, closes || gap(&bodies.x, &bodies.hx) > touch)
        }
    };
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
