//! Blocks on a line that hit each other with restitution e, by each method of finding the impact and of answering it:
//! v₁ −= (1+e)·(m₂/(m₁+m₂))·w, v₂ += (1+e)·(m₁/(m₁+m₂))·w with w = v₁ − v₂, and nothing else acts.

/// A block; the order of the blocks gives its neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineBlock {
    /// Centre, m.
    pub x: f64,
    /// m/s.
    pub v: f64,
    /// kg; infinite for a wall.
    pub mass: f64,
    /// Half its width, m.
    pub half: f64,
}

/// One step: blocks from left to right, restitution, step (s).
pub type ImpactStep = fn(&mut [LineBlock], f64, f64);

/// Impacts in one step, at most.
const MOST: u32 = 10_000;

fn gap(a: &LineBlock, b: &LineBlock) -> f64 {
    b.x - a.x - a.half - b.half
}

fn bounce(blocks: &mut [LineBlock], i: usize, e: f64) {
    let (a, b) = (blocks[i], blocks[i + 1]);
    let w = (1.0 + e) * (a.v - b.v);
    let part = |mine: f64, other: f64| if other.is_infinite() { 1.0 } else { other / (mine + other) };
    if a.mass.is_finite() {
        blocks[i].v -= part(a.mass, b.mass) * w;
    }
    if b.mass.is_finite() {
        blocks[i + 1].v += part(b.mass, a.mass) * w;
    }
}

fn advance(blocks: &mut [LineBlock], t: f64) {
    for block in blocks {
        block.x += block.v * t;
    }
}

/// Everything moves, then each pair that overlaps and approaches bounces; an overlap deeper than both blocks are wide is a passage, and goes unseen.
pub fn discrete(blocks: &mut [LineBlock], e: f64, h: f64) {
    advance(blocks, h);
    for i in 0..blocks.len() - 1 {
        let (a, b) = (blocks[i], blocks[i + 1]);
        let overlap = gap(&a, &b) < 0.0 && gap(&a, &b) > -2.0 * (a.half + b.half);
        if overlap && a.v > b.v {
            bounce(blocks, i, e);
        }
    }
}

/// The first impact within the step, as (contact, time in the step). Equal times: the faster approach, then the order.
fn first(blocks: &[LineBlock], left: f64) -> Option<(usize, f64)> {
    let mut found: Option<(usize, f64, f64)> = None;
    for i in 0..blocks.len() - 1 {
        let w = blocks[i].v - blocks[i + 1].v;
        if w <= 0.0 {
            continue;
        }
        let t = (gap(&blocks[i], &blocks[i + 1]) / w).max(0.0);
        if t <= left && found.is_none_or(|(_, at, speed)| t < at || (t == at && w > speed)) {
            found = Some((i, t, w));
        }
    }
    found.map(|(i, t, _)| (i, t))
}

/// The path is swept: at the first impact everything stops where it is and bounces, and the rest of the step is lost.
pub fn swept(blocks: &mut [LineBlock], e: f64, h: f64) {
    match first(blocks, h) {
        None => advance(blocks, h),
        Some((i, t)) => {
            advance(blocks, t);
            bounce(blocks, i, e);
        }
    }
}

/// Exact times of impact, one after the other, until the step is over.
pub fn exact(blocks: &mut [LineBlock], e: f64, h: f64) {
    let mut left = h;
    for _ in 0..MOST {
        let Some((i, t)) = first(blocks, left) else { break };
        advance(blocks, t);
        bounce(blocks, i, e);
        left -= t;
    }
    advance(blocks, left);
}

/// All that touch at once, each for −e times its approach (many sweeps): right momentum and, at e = 1, energy, but 3 of a cradle leave with −⅓, ⅔, ⅔.
pub fn at_once(blocks: &mut [LineBlock], e: f64, h: f64) {
    let Some((_, t)) = first(blocks, h) else { return advance(blocks, h) };
    advance(blocks, t);
    let contacts = blocks.len() - 1;
    let touching: Vec<bool> = (0..contacts).map(|i| gap(&blocks[i], &blocks[i + 1]) <= TOUCHING).collect();
    let wanted: Vec<f64> = (0..contacts).map(|i| -e * (blocks[i].v - blocks[i + 1].v)).collect();
    let mut impulses = vec![0.0; contacts];
    for _ in 0..MOST {
        for i in (0..contacts).filter(|&i| touching[i]) {
            let (wa, wb) = (1.0 / blocks[i].mass, 1.0 / blocks[i + 1].mass);
            let miss = blocks[i].v - blocks[i + 1].v - wanted[i];
            let impulse = f64::max(impulses[i] + miss / (wa + wb), 0.0);
            blocks[i].v -= (impulse - impulses[i]) * wa;
            blocks[i + 1].v += (impulse - impulses[i]) * wb;
            impulses[i] = impulse;
        }
    }
    advance(blocks, h - t);
}

/// Sweeps over all contacts in [`speculative`].
const SWEEPS: u32 = 20;

/// Pairs that would meet just touch at the step's end and bounce then (E. Catto, "Continuous Collision", GDC 2013; restitution as in Box2D).
pub fn speculative(blocks: &mut [LineBlock], e: f64, h: f64) {
    let contacts = blocks.len() - 1;
    let approach: Vec<f64> = (0..contacts).map(|i| blocks[i].v - blocks[i + 1].v).collect();
    let mut impulses = vec![0.0; contacts];
    let push = |blocks: &mut [LineBlock], i: usize, most: f64, impulse: &mut f64| {
        let (wa, wb) = (1.0 / blocks[i].mass, 1.0 / blocks[i + 1].mass);
        let pushed = f64::max(*impulse + (blocks[i].v - blocks[i + 1].v - most) / (wa + wb), 0.0);
        blocks[i].v -= (pushed - *impulse) * wa;
        blocks[i + 1].v += (pushed - *impulse) * wb;
        *impulse = pushed;
    };
    for _ in 0..SWEEPS {
        for i in 0..contacts {
            let most = gap(&blocks[i], &blocks[i + 1]).max(0.0) / h;
            push(blocks, i, most, &mut impulses[i]);
        }
    }
    advance(blocks, h);
    for (i, impulse) in impulses.iter_mut().enumerate().filter(|(i, impulse)| **impulse > 0.0 && approach[*i] > 0.0) {
        push(blocks, i, -e * approach[i], impulse);
    }
}

/// m. Gaps up to this count as touching in [`at_once`].
const TOUCHING: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exact_impact_is_the_same_at_any_step() {
        let start = [LineBlock { x: 0.0, v: 25.7, mass: 75.0, half: 0.5 }, LineBlock { x: 11.0, v: -11.3, mass: 150.0, half: 0.5 }];
        let (mut whole, mut cut) = (start, start);
        exact(&mut whole, 1.0, 2.0);
        for _ in 0..200 {
            exact(&mut cut, 1.0, 0.01);
        }
        for (a, b) in whole.iter().zip(&cut) {
            assert!((a.x - b.x).abs() < 1e-12 && a.v == b.v);
        }
        // From the pair formula, by hand.
        assert!((whole[0].v + 23.633_333_333_333_333).abs() < 1e-12 && (whole[1].v - 13.366_666_666_666_667).abs() < 1e-12);
    }

    /// However fast, it only just touches at the step's end, and leaves with e times its approach; a row that is hit keeps its momentum, but all
    /// of it moves.
    #[test]
    fn speculative_contacts_let_nothing_through_and_know_no_order() {
        let wall = LineBlock { x: 10.0, v: 0.0, mass: f64::INFINITY, half: 0.05 };
        for speed in [1e3, 1e6] {
            let mut blocks = [LineBlock { x: 0.0, v: speed, mass: 1.0, half: 0.5 }, wall];
            speculative(&mut blocks, 0.5, 0.1);
            assert!((blocks[0].x - 9.45).abs() < 1e-9 && (blocks[0].v + 0.5 * speed).abs() < 1e-9 * speed, "{blocks:?}");
        }
        let block = |i: usize| LineBlock { x: i as f64, v: if i == 0 { 3.0 } else { 0.0 }, mass: 1.0, half: 0.5 };
        let mut row: Vec<_> = (0..3).map(block).collect();
        speculative(&mut row, 1.0, 0.1);
        assert!((row.iter().map(|block| block.v).sum::<f64>() - 3.0).abs() < 1e-9);
        assert!(row[1].v > 0.5 && row[2].v < 2.0, "{row:?}");
    }
}
