//! What a box says, letter by letter: this is what is drawn, and what tests read.

use super::PADDING;
use crate::draw::layout::{DETAILS, Frame, LINE, MONO_ADVANCE, Vec2};
use crate::physics::{BodyId, DVec2};
use crate::view::facts::{ArrowKind, BodyFacts, FactRow, Value};
use crate::view::quantity::{number_width, quantity};

/// Numbers are given room for this many characters at least, so that boxes seldom change their width: "−0.123".
const NUMBER_WIDTH: usize = 6;
/// Characters of the longest unit that is usual.
const UNIT_WIDTH: usize = 4;

/// A line of a box.
#[derive(Clone, Debug, PartialEq)]
pub struct BoxLine {
    /// What it is, and by whom.
    pub label: String,
    /// How much, with its unit.
    pub value: String,
    /// What it tells of, if that has a colour.
    pub shown: Option<ArrowKind>,
    /// Whether it says that there is nothing.
    pub nothing: bool,
    /// Which of the body's facts it is.
    pub row: usize,
}

/// All that a box says.
#[derive(Clone, Debug, PartialEq)]
pub struct BoxText {
    /// Of whom.
    pub body: BodyId,
    /// Its heading.
    pub title: String,
    /// Its lines.
    pub lines: Vec<BoxLine>,
}

impl BoxText {
    /// The text of a box; `short`, for when there is no room: heading and resultant.
    pub fn new(facts: &BodyFacts, short: bool) -> Self {
        let width = number_width(&facts.rows, NUMBER_WIDTH);
        let line = |(row, told): (usize, &FactRow)| BoxLine {
            label: told.label(),
            value: quantity(told, &facts.rows, width),
            shown: told.shown,
            nothing: told.value == Value::Vector(DVec2::ZERO),
            row,
        };
        let told = |row: &(usize, &FactRow)| !short || row.1.shown == Some(ArrowKind::Resultant);
        let lines = facts.rows.iter().enumerate().filter(told).map(line).collect();
        Self { body: facts.body, title: facts.title.clone(), lines }
    }

    /// Where the numbers begin, characters from the names.
    pub fn column(&self) -> usize {
        self.lines.iter().map(|line| line.label.chars().count() + 1).max().unwrap_or(0)
    }

    /// The size of its box: its longest line, or the longest that is usual, and the number of its lines.
    pub fn size(&self, frame: &Frame) -> Vec2 {
        let text = frame.text_height(DETAILS);
        // Brackets, comma and spaces stand between and around the numbers and their unit.
        let usual = 2 * NUMBER_WIDTH + 5 + UNIT_WIDTH;
        let values = self.lines.iter().map(|line| line.value.trim_end().chars().count()).fold(usual, usize::max);
        let characters = (self.column() + values).max(self.title.chars().count());
        let lines = self.lines.len() + 1;
        Vec2::new(characters as f32 * MONO_ADVANCE * text, lines as f32 * text * LINE) + 2.0 * PADDING
    }
}
