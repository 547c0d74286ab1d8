//! Values of cells that are more than a number or a word, as serde reads them: names, what a switch works, way points, ends of links.

use crate::level::numbers::{self, PixelScale};
use crate::{level::types::Work, physics::DVec2, words::tr};
use serde::Deserialize;

const MOST_WORKS: usize = 50;
const MOST_STOPS: usize = 50;

/// `600 300; 600 100`: top left corners, pixels.
#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "String")]
pub(in crate::level) struct WayPoints(pub Vec<DVec2>);

impl TryFrom<String> for WayPoints {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let expected = || tr("way points such as 600 300; 600 100: x and y in pixels, a semicolon between them").to_owned();
        let points: Vec<&str> = text.split(';').map(str::trim).filter(|point| !point.is_empty()).collect();
        if points.is_empty() {
            return Err(expected());
        }
        if points.len() > MOST_STOPS {
            return Err(tr!("at most {most} way points", most = MOST_STOPS));
        }
        points.iter().map(|point| place(point)?.ok_or_else(expected)).collect::<Result<_, _>>().map(Self)
    }
}

/// `600 300`, pixels; `None` where those are not two words.
fn place(text: &str) -> Result<Option<DVec2>, String> {
    match text.split_whitespace().collect::<Vec<_>>()[..] {
        [x, y] => Ok(Some(DVec2::new(numbers::number(x)?, numbers::number(y)?))),
        _ => Ok(None),
    }
}

/// `3 8`: a number of objectives, met within that time, s.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(try_from = "String")]
pub(in crate::level) struct Together {
    pub count: u32,
    /// s.
    pub within: f64,
}

impl TryFrom<String> for Together {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let expected = || tr("a number of objectives from 2 on, and seconds, such as 3 8").to_owned();
        let DVec2 { x: count, y: within } = place(&text)?.ok_or_else(expected)?;
        let good = (2.0..=1e6).contains(&count) && count.fract() == 0.0 && numbers::MEDAL_TIME.judge(within).is_ok();
        // Whole and at most a million, so the conversion is exact.
        if good { Ok(Self { count: count as u32, within }) } else { Err(expected()) }
    }
}

pub(super) fn is_name(text: &str) -> bool {
    text.chars().count() <= 40
        && text.chars().next().is_some_and(char::is_alphabetic)
        && text.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_'))
}

/// `lift !fan`.
#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "String")]
pub(in crate::level) struct Works(pub Vec<Work>);

impl TryFrom<String> for Works {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let work = |word: &str| Work { name: word.trim_start_matches('!').to_owned(), inverted: word.starts_with('!') };
        let works: Vec<Work> = text.split_whitespace().map(work).collect();
        let good = (1..=MOST_WORKS).contains(&works.len()) && works.iter().all(|work| is_name(&work.name));
        if good { Ok(Self(works)) } else { Err(tr("names with spaces between them, such as: gate !fan").into()) }
    }
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(try_from = "String")]
pub(in crate::level) enum LinkRowEnd {
    Ship,
    Object(String),
    /// Pixels in a row, m in a level.
    Place(DVec2),
}

impl LinkRowEnd {
    pub fn in_metres(self, scale: PixelScale) -> Self {
        if let Self::Place(place) = self { Self::Place(place / scale.metre) } else { self }
    }

    /// The name of its object.
    pub fn object(&self) -> Option<&str> {
        match self {
            Self::Object(name) => Some(name),
            Self::Ship | Self::Place(_) => None,
        }
    }
}

impl TryFrom<String> for LinkRowEnd {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        match (place(&text)?, text.as_str()) {
            (Some(place), _) => Ok(Self::Place(place)),
            (None, name) if name.eq_ignore_ascii_case("ship") => Ok(Self::Ship),
            (None, name) if is_name(name) => Ok(Self::Object(text)),
            _ => Err(tr("ship, the name of an object, or a place such as 600 300: x and y in pixels").to_owned()),
        }
    }
}
