//! A picture of a method's failure, which the method computes: a few lines over time, or over another quantity, beside the exact one.

/// Right and up.
pub type Polyline = Vec<(f64, f64)>;

/// Points of a line, at most: more would be closer together than pixels.
const MOST: usize = 160;
/// A line stays in view this far from the exact one, in heights of that.
const BEYOND: f64 = 1.0;
/// The same where the exact value is a band.
const BEYOND_BAND: f64 = 40.0;
/// The free margin above and below, in heights of the view.
const MARGIN: f64 = 0.08;

#[derive(Clone, Debug, Default, PartialEq)]
pub struct FailurePicture {
    pub value: f64,
    /// With its unit.
    pub across: &'static str,
    /// With its unit.
    pub up: &'static str,
    pub found: Vec<Polyline>,
    pub exact: Vec<Polyline>,
    /// The band that counts as right.
    pub right: Option<(f64, f64)>,
    /// Lower and upper side of an obstacle.
    pub solid: Option<(f64, f64)>,
}

type ValueSpan = (f64, f64);

impl FailurePicture {
    pub(super) fn of(across: &'static str, up: &'static str) -> Self {
        Self { across, up, ..Self::default() }
    }

    pub(super) fn found(mut self, line: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.found.push(thinned(line.into_iter().collect()));
        self
    }

    pub(super) fn exact(mut self, line: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.exact.push(thinned(line.into_iter().collect()));
        self
    }

    /// Adds the exact height and its tolerance.
    pub(super) fn within(mut self, height: f64, off: f64) -> Self {
        let (from, to) = self.across_span();
        self.right = Some((height - off, height + off));
        self.exact(vec![(from, height), (to, height)])
    }

    pub(super) fn solid(self, from: f64, to: f64) -> Self {
        Self { solid: Some((from, to)), ..self }
    }

    fn across_span(&self) -> ValueSpan {
        let points = self.found.iter().chain(&self.exact).flatten();
        span(points.map(|(x, _)| *x)).unwrap_or((0.0, 1.0))
    }

    /// The view's ranges to the right and upwards. It holds every exact value, and the method's own where they do not leave that too far.
    pub fn window(&self) -> (ValueSpan, ValueSpan) {
        let heights = |lines: &[Polyline]| span(lines.iter().flatten().map(|(_, y)| *y));
        let band = self.right.into_iter().chain(self.solid).flat_map(|(from, to)| [from, to]);
        let right = span(band.chain(self.exact.iter().flatten().map(|(_, y)| *y)));
        let (least, most) = match (right, heights(&self.found)) {
            (None, None) => (0.0, 1.0),
            (Some((least, most)), Some((lowest, highest))) if most > least => {
                let free = (most - least) * if self.right.is_some() { BEYOND_BAND } else { BEYOND };
                (least.min(lowest.max(least - free)), most.max(highest.min(most + free)))
            }
            (Some((least, most)), Some((lowest, highest))) => (least.min(lowest), most.max(highest)),
            (Some(seen), None) | (None, Some(seen)) => seen,
        };
        let free = if most > least { (most - least) * MARGIN } else { least.abs().max(1.0) * MARGIN };
        let (from, to) = self.across_span();
        ((from, if to > from { to } else { from + 1.0 }), (least - free, most + free))
    }

    /// The lines as parts of the axes to the right and upwards, cut at the edges; a value that is not a number stands at the upper edge.
    pub fn parts(&self, lines: &[Polyline]) -> Vec<Polyline> {
        let ((from, to), (least, most)) = self.window();
        let part = |&(x, y): &(f64, f64)| {
            let up = if y.is_nan() { 1.0 } else { ((y - least) / (most - least)).clamp(0.0, 1.0) };
            (((x - from) / (to - from)).clamp(0.0, 1.0), up)
        };
        lines.iter().map(|line| line.iter().map(part).collect()).collect()
    }
}

fn span(values: impl Iterator<Item = f64>) -> Option<ValueSpan> {
    let finite = values.filter(|value| value.is_finite());
    finite.fold(None, |span, value| {
        let (least, most) = span.unwrap_or((value, value));
        Some((least.min(value), most.max(value)))
    })
}

/// Thinned out; the last point stays.
fn thinned(line: Polyline) -> Polyline {
    let every = line.len().div_ceil(MOST).max(1);
    let last = line.len().saturating_sub(1);
    line.into_iter().enumerate().filter(|(i, _)| i % every == 0 || *i == last).map(|(_, point)| point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_right_is_always_seen_and_what_leaves_it_is_cut() {
        let wild = [(0.0, 1.0), (1.0, -1e300), (2.0, f64::NAN), (3.0, f64::INFINITY)];
        let picture = FailurePicture::of("t", "v").found(wild).exact([(0.0, 0.0), (3.0, 1.0)]);
        let ((from, to), (least, most)) = picture.window();
        assert_eq!((from, to), (0.0, 3.0));
        assert!(least < -1.0 && least > -1.5 && most > 1.0 && most < 1.5, "{least} {most}");
        let parts = &picture.parts(&picture.found)[0];
        assert_eq!((parts[1].1, parts[2].1, parts[3].1), (0.0, 1.0, 1.0));
        let band = FailurePicture::of("t", "v").found([(0.0, 1.005), (9.0, 5.0)]).within(1.0, 0.01);
        let (_, (least, most)) = band.window();
        assert!(least < 0.99 && most > 1.5 && most < 2.0, "{least} {most}");
    }

    #[test]
    fn there_is_a_window_whatever_there_is_to_see() {
        for picture in [
            FailurePicture::default(),
            FailurePicture::of("t", "v").found([]),
            FailurePicture::of("t", "v").found([(1.0, 2.0)]),
            FailurePicture::of("t", "v").found([(f64::NAN, f64::NAN)]),
            FailurePicture::of("t", "v").exact([(0.0, 0.0), (1.0, 0.0)]).found([(0.0, 0.0), (1.0, 0.0)]),
        ] {
            let ((from, to), (least, most)) = picture.window();
            assert!(to > from && most > least, "{picture:?}");
        }
    }

    #[test]
    fn a_long_line_is_thinned_and_keeps_its_end() {
        let line = thinned((0..10_001).map(|i| (f64::from(i), 0.0)).collect());
        assert!(line.len() <= MOST + 1 && line.last() == Some(&(10_000.0, 0.0)));
    }
}
