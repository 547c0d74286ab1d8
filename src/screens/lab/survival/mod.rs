//! The table of the stress tests with a small picture of each failure, and a large one of the selected line.

mod drawing;

use super::body;
use crate::draw::layout::{Area, Frame};
use crate::lab::stress::picture::FailurePicture;
use crate::lab::stress::{self, Survival};
use crate::screens::scroll::{Bar, Scroll, bar_beside};
use crate::screens::{Input, Key, Toolbar};
use std::collections::HashMap;

const ROW: f32 = 40.0;
const TABLE: f32 = 768.0;
/// Widest of table and picture together.
const WIDEST: f32 = 1440.0;
const PADDING: f32 = 8.0;
const WORDS: f32 = 40.0;

#[derive(Clone, Debug, PartialEq)]
pub enum SurvivalLine {
    /// With the number that grows, and its unit.
    Test(String, String),
    Method(Survival),
}

#[derive(Debug)]
pub struct SurvivalPage {
    lines: Vec<SurvivalLine>,
    /// One a line, computed when the line comes into view.
    pictures: HashMap<usize, Option<FailurePicture>>,
    pointed: Option<usize>,
    scroll: Scroll,
    toolbar: Toolbar,
}

impl SurvivalPage {
    pub(super) fn new(stress: &[Survival]) -> Self {
        let tests = stress.chunk_by(|a, b| a.test == b.test);
        let lines = tests.flat_map(|rows| {
            let head = SurvivalLine::Test(rows[0].test.clone(), rows[0].parameter.clone());
            std::iter::once(head).chain(rows.iter().cloned().map(SurvivalLine::Method))
        });
        Self {
            lines: lines.collect(),
            pictures: HashMap::new(),
            pointed: None,
            scroll: Scroll::default(),
            toolbar: Toolbar::default(),
        }
    }

    /// True where the player leaves the lab.
    pub(super) fn update(&mut self, input: &Input) -> bool {
        let panel = panel(&input.frame);
        let page = page(panel);
        let rows = panel.min.y + PADDING;
        self.scroll.place(self.lines.len(), page, bar_beside(panel, rows, rows + page as f32 * ROW));
        self.scroll.update(input);
        let in_line = |place: &usize| line_of(panel, *place).contains(input.pointer);
        let pointed = (0..self.range().len()).find(in_line).map(|place| self.range().start + place);
        self.pointed = pointed.filter(|line| matches!(self.lines[*line], SurvivalLine::Method(_)));
        self.draw_one_more();
        self.toolbar.update(input, &[Key::Escape]).is_some()
    }

    /// Computes one picture in view, the selected one first: each takes up to a few milliseconds.
    fn draw_one_more(&mut self) {
        let missing = |line: &usize| !self.pictures.contains_key(line);
        let wanted = self.chosen().into_iter().chain(self.range()).filter(missing);
        let method = |line: usize| if let SurvivalLine::Method(row) = &self.lines[line] { Some((line, row)) } else { None };
        if let Some((line, row)) = wanted.filter_map(method).next() {
            let picture = stress::picture(row);
            self.pictures.insert(line, picture);
        }
    }

    pub fn lines(&self) -> &[SurvivalLine] {
        &self.lines
    }

    pub fn range(&self) -> std::ops::Range<usize> {
        self.scroll.range()
    }

    /// The selected line: the one under the pointer, or else the first method in view.
    pub fn chosen(&self) -> Option<usize> {
        self.pointed.or_else(|| self.range().find(|line| matches!(self.lines[*line], SurvivalLine::Method(_))))
    }

    /// `None` until it is computed.
    pub fn picture(&self, line: usize) -> Option<&FailurePicture> {
        self.pictures.get(&line)?.as_ref()
    }

    /// `None` where all lines are in view.
    pub fn bar(&self) -> Option<Bar> {
        self.scroll.bar()
    }

    pub fn toolbar(&self) -> &Toolbar {
        &self.toolbar
    }
}

fn panel(frame: &Frame) -> Area {
    let body = body(frame);
    let width = body.size.x.min(WIDEST);
    let room = Area::new(body.centre().x - width / 2.0, body.min.y + WORDS, TABLE, body.size.y - WORDS);
    Area::new(room.min.x, room.min.y, TABLE, page(room) as f32 * ROW + 2.0 * PADDING)
}

fn line_of(panel: Area, place: usize) -> Area {
    Area::new(panel.min.x, panel.min.y + PADDING + place as f32 * ROW, panel.size.x - 24.0, ROW)
}

fn page(panel: Area) -> usize {
    ((panel.size.y - 2.0 * PADDING) / ROW).floor() as usize
}
