//! Curves differ by colour, dash and marker, on paper and on the screen; and how they are drawn.

use crate::draw::layout::{Area, Vec2};
use crate::draw::{Canvas, Colour};

/// Whose curve it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveOrigin {
    Lab,
    Shipped,
    /// As `benches/peers` measured it.
    Peer,
}

/// Words, and other engines.
pub const TEXT: u32 = 0xE6EBF2;
/// The shipped engine: the game's accent.
pub const SHIPPED: u32 = 0xFF9F1C;
/// All common kinds of colour vision tell these apart (M. Okabe, K. Ito, "Color Universal Design", 2008); lightened for a dark
/// ground.
const COLOURS: [u32; 8] = [0x56B4E9, 0xB79CED, 0xF0E442, 0xD55E00, 0x1FB88F, 0xCC79A7, 0xDCE6F5, 0xA3A847];
/// Pixels drawn and left out.
const DASHES: [Option<(u32, u32)>; 4] = [None, Some((8, 4)), Some((3, 3)), Some((14, 5))];
/// Pixels drawn and left out of the line of the tolerance.
pub const TOLERANCE_DASH: (u32, u32) = (2, 4);
/// Pixels. Radius of the ring around the shipped point.
pub const RING: f32 = 11.0;
/// Pixels. Half the side of the square around the cheapest one.
pub const FRAME: f32 = 10.0;

/// From a legend line's left end to its words.
pub const WORDS: f32 = 52.0;
/// Length of the sample of a curve in the legend.
pub const SAMPLE: f32 = 40.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CurveLook {
    /// As 0xRRGGBB.
    pub colour: u32,
    /// Pixels drawn and left out; none: a full line.
    pub dash: Option<(u32, u32)>,
    pub marker: Marker,
    /// Pixels.
    pub width: u32,
}

impl CurveLook {
    /// Other engines are white, ours has the accent's colour.
    pub fn of(index: usize, origin: CurveOrigin) -> Self {
        let marker = Marker::ALL[index % Marker::ALL.len()];
        // One shape further each time the colours begin again, so that no two of many curves share both.
        let dash = DASHES[(index + index / COLOURS.len()) % DASHES.len()];
        match origin {
            CurveOrigin::Shipped => Self { colour: SHIPPED, dash: None, marker: Marker::Star, width: 3 },
            CurveOrigin::Lab => Self { colour: COLOURS[index % COLOURS.len()], dash, marker, width: 2 },
            CurveOrigin::Peer => Self { colour: TEXT, dash: DASHES[2], marker, width: 1 },
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    Square,
    /// Points up.
    Up,
    Diamond,
    /// Points down.
    Down,
    Bar,
    Hexagon,
    Pole,
    Star,
    /// Marks a run that blew up.
    Cross,
}

/// A convex outline around a point, pixels, y down.
pub type Outline = Vec<(f32, f32)>;

impl Marker {
    /// The markers that curves take in turn.
    const ALL: [Self; 7] = [Self::Square, Self::Up, Self::Diamond, Self::Down, Self::Hexagon, Self::Bar, Self::Pole];

    /// Convex pieces that overlap.
    pub fn pieces(self) -> Vec<Outline> {
        match self {
            Self::Square => vec![vec![(-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)]],
            Self::Up => vec![vec![(0.0, -6.0), (6.0, 4.0), (-6.0, 4.0)]],
            Self::Down => vec![vec![(0.0, 6.0), (6.0, -4.0), (-6.0, -4.0)]],
            Self::Diamond => vec![vec![(0.0, -6.0), (6.0, 0.0), (0.0, 6.0), (-6.0, 0.0)]],
            Self::Bar => vec![vec![(-6.0, -2.0), (6.0, -2.0), (6.0, 2.0), (-6.0, 2.0)]],
            Self::Pole => vec![vec![(-2.0, -6.0), (2.0, -6.0), (2.0, 6.0), (-2.0, 6.0)]],
            Self::Hexagon => vec![vec![(-3.0, -5.0), (3.0, -5.0), (6.0, 0.0), (3.0, 5.0), (-3.0, 5.0), (-6.0, 0.0)]],
            Self::Star => star(8.5),
            Self::Cross => vec![
                vec![(-6.0, -4.0), (-4.0, -6.0), (6.0, 4.0), (4.0, 6.0)],
                vec![(6.0, -4.0), (4.0, -6.0), (-6.0, 4.0), (-4.0, 6.0)],
            ],
        }
    }
}

/// The pentagram: from each tip, the triangle to the two corners of the inner pentagon that lie across.
fn star(radius: f32) -> Vec<Outline> {
    // The inner pentagon's radius over the outer one's: 1/φ².
    const INNER: f32 = 0.381_966;
    let at = |fifth: f32, r: f32| {
        let (sine, cosine) = ((fifth / 5.0 - 0.25) * std::f32::consts::TAU).sin_cos();
        (r * cosine, r * sine)
    };
    let inner = |fifth: f32| at(fifth, radius * INNER);
    (0..5).map(|i| i as f32).map(|tip| vec![at(tip, radius), inner(tip + 1.5), inner(tip - 1.5)]).collect()
}

pub fn stroke(canvas: &Canvas, line: &[Vec2], look: &CurveLook, colour: Colour) {
    let width = look.width as f32;
    match look.dash {
        None => line.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], width, colour)),
        Some(dash) => dashed(canvas, line, dash, width, colour),
    }
}

pub fn dashed(canvas: &Canvas, line: &[Vec2], (on, off): (u32, u32), width: f32, colour: Colour) {
    canvas.dashed(line, &[on as f32, off as f32], width, colour);
}

pub fn marker(canvas: &Canvas, at: Vec2, shape: Marker, colour: Colour) {
    for piece in shape.pieces() {
        let corners: Vec<Vec2> = piece.into_iter().map(|corner| at + Vec2::from(corner)).collect();
        canvas.convex(&corners, colour);
    }
}

/// A curve's sample at the left end of its legend line.
pub fn sample(canvas: &Canvas, line: Area, look: &CurveLook, colour: Colour) {
    let [from, middle, to] = [0.0, SAMPLE / 2.0, SAMPLE].map(|right| Vec2::new(line.min.x + right, line.centre().y));
    stroke(canvas, &[from, to], look, colour);
    marker(canvas, middle, look.marker, colour);
}
