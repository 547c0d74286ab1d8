//! The text of a box, letter by letter: the drawing shows it, and the tests read it.

use super::PADDING;
use crate::draw::layout::{DETAILS, Frame, LINE, MONO_ADVANCE, Vec2};
use crate::physics::{BodyId, DVec2};
use crate::view::facts::{ArrowKind, BodyFacts, FactRow, Value};
use crate::view::quantity::quantities;

/// The least width of a number in characters, so that boxes seldom change their width: "−0.123".
const NUMBER_WIDTH: usize = 6;
/// Characters of the longest unit that is usual.
const UNIT_WIDTH: usize = 4;

#[derive(Clone, Debug, PartialEq)]
pub struct BoxLine {
    /// The quantity, and the body that exerts it.
    pub label: String,
    /// Number and unit.
    pub value: String,
    /// The force or impact, where the line has a colour.
    pub shown: Option<ArrowKind>,
    /// Whether the value is zero as written.
    pub nothing: bool,
    /// Index among the body's facts.
    pub row: usize,
}

#[derive(Clone, Debug, PartialEq)]
pub struct BoxText {
    /// The body of the box.
    pub body: BodyId,
    pub title: String,
    pub lines: Vec<BoxLine>,
}

impl BoxText {
    /// `short`, without room: heading and resultant.
    pub fn new(facts: &BodyFacts, short: bool) -> Self {
        let values = quantities(&facts.rows, NUMBER_WIDTH);
        let line = |(row, told): (usize, &FactRow)| BoxLine {
            label: told.label(),
            value: values[row].clone(),
            shown: told.shown,
            nothing: told.value == Value::Vector(DVec2::ZERO),
            row,
        };
        let told = |row: &(usize, &FactRow)| !short || row.1.shown == Some(ArrowKind::Resultant);
        let lines = facts.rows.iter().enumerate().filter(told).map(line).collect();
        Self { body: facts.body, title: facts.title.clone(), lines }
    }

    /// The column at which the numbers begin, characters from the names.
    pub fn column(&self) -> usize {
        self.lines.iter().map(|line| line.label.chars().count() + 1).max().unwrap_or(0)
    }

    /// Its longest line, or the longest usual one, by the number of its lines.
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
