//! Where the cards of a page stand, and the buttons below them. The pages of the list: a shelf a world, two of them a page; levels without a world
//! alone fill a page of one grid.

use super::{LevelSelect, MOST_LETTERS, card::LevelEntry};
use crate::draw::layout::{Area, BUTTON_TEXT, Frame, GAP, ROW_BUTTON, TEXT, Vec2};
use crate::view::{sky::WorldPalette, theme, widgets};
use crate::{draw::Canvas, draw::Style, game::Medal, game::Prize, ui::Ui, ui::input::Stroke};
use crate::{level::Landscape, settings::Key, words::tr};
use std::ops::Range;

/// From the canvas' sides to the cards, and from its top: the heading.
pub(super) const SIDE: f32 = 40.0;
pub(super) const HEAD: f32 = 88.0;
const BETWEEN: f32 = 24.0;
/// From the canvas' bottom to the buttons below the cards, and from those to the cards.
pub(super) const FOOT: f32 = 24.0;
const ABOVE_FOOT: f32 = 24.0;
const SHAPE: f32 = 1.3;
/// No card is larger: a single level does not want the whole window.
const LARGEST: Vec2 = Vec2::new(900.0, 600.0);
pub(super) const FOOT_BUTTON: Vec2 = Vec2::new(160.0, ROW_BUTTON.y);

pub(super) fn from_left(nth: f32, frame: &Frame) -> Area {
    Area { min: Vec2::new(SIDE + nth * (FOOT_BUTTON.x + GAP), foot(frame)), size: FOOT_BUTTON }
}

pub(super) fn from_right(nth: f32, frame: &Frame) -> Area {
    let left = frame.size.x - SIDE - FOOT_BUTTON.x - nth * (FOOT_BUTTON.x + GAP);
    Area { min: Vec2::new(left, foot(frame)), size: FOOT_BUTTON }
}

fn foot(frame: &Frame) -> f32 {
    frame.size.y - FOOT - ROW_BUTTON.y
}

pub(super) fn room(frame: &Frame) -> Area {
    Area {
        min: Vec2::new(SIDE, HEAD),
        size: Vec2::new(frame.size.x - 2.0 * SIDE, frame.size.y - HEAD - FOOT - ROW_BUTTON.y - ABOVE_FOOT),
    }
}

/// The places of a page's cards: as many across as make the cards largest, all the window between the heading and the foot.
pub(super) fn cards(count: usize, frame: &Frame) -> Vec<Area> {
    let room = room(frame);
    let size = |across: usize| {
        let grid = Vec2::new(across as f32, count.div_ceil(across) as f32);
        (room.size - (grid - 1.0) * BETWEEN) / grid
    };
    // Of a card's size only as much counts as has a good shape.
    let worth = |across: &usize| size(*across).x.min(size(*across).y * SHAPE);
    // Of equal ones the last: the fewest across leave the fewest gaps.
    let across = (1..=count).rev().max_by(|a, b| worth(a).total_cmp(&worth(b))).unwrap_or(1);
    let size = size(across).min(LARGEST);
    let down = count.div_ceil(across);
    let place = |index: usize| {
        let (column, row) = (index % across, index / across);
        // The last row stands in the middle when it is not full, and so do cards that are as large as any.
        let in_row = across.min(count - row * across);
        let all = Vec2::new(in_row as f32, down as f32) * (size + BETWEEN) - BETWEEN;
        let first = room.centre() - all / 2.0;
        Area { min: first + Vec2::new(column as f32, row as f32) * (size + BETWEEN), size }
    };
    (0..count).map(place).collect()
}

pub(super) const PAGE: usize = 15;
/// Levels a shelf, and shelves a page: a world of six.
const ACROSS: usize = 3;
const SHELVES: usize = 2;
/// Between two cards of a shelf, and the height of a shelf's heading.
const BETWEEN_ON_SHELF: f32 = 16.0;
const HEADING_ROOM: f32 = 42.0;
/// Of that below the words: the frame of a selected card reaches into it.
const ABOVE_CARDS: f32 = 10.0;

/// The pages of levels in those worlds, each of ranges of levels that stand on a shelf together.
pub(super) fn pages(worlds: &[Option<Landscape>]) -> Vec<Vec<Range<usize>>> {
    let ranges = |step: usize, all: Range<usize>| {
        let end = all.end;
        all.step_by(step).map(move |first| first..(first + step).min(end))
    };
    if worlds.iter().all(Option::is_none) {
        return ranges(PAGE, 0..worlds.len()).map(|page| vec![page]).collect();
    }
    let mut first = 0;
    let runs = worlds.chunk_by(|a, b| a == b).map(|run| {
        first += run.len();
        first - run.len()..first
    });
    let shelves: Vec<Range<usize>> = runs.flat_map(|run| ranges(ACROSS, run)).collect();
    shelves.chunks(SHELVES).map(<[_]>::to_vec).collect()
}

/// The places of a page's cards, shelf by shelf, and of the headings above those shelves whose `heads` say so; without any the cards fill a grid.
pub(super) fn places(page: &[Range<usize>], heads: &[bool], frame: &Frame) -> (Vec<Area>, Vec<Area>) {
    if heads.is_empty() {
        return (cards(page.iter().map(Range::len).sum(), frame), Vec::new());
    }
    let room = room(frame);
    let headings = heads.iter().filter(|has| **has).count() as f32 * HEADING_ROOM;
    let height = (room.size.y - headings - (SHELVES as f32 - 1.0) * BETWEEN_ON_SHELF) / SHELVES as f32;
    let size = Vec2::new((room.size.x + BETWEEN_ON_SHELF) / ACROSS as f32 - BETWEEN_ON_SHELF, height);
    let (mut places, mut areas, mut top) = (Vec::new(), Vec::new(), HEAD);
    for (shelf, has) in page.iter().zip(heads) {
        if *has {
            areas.push(Area { min: Vec2::new(SIDE, top), size: Vec2::new(room.size.x, HEADING_ROOM - ABOVE_CARDS) });
            top += HEADING_ROOM;
        }
        let place = |i: usize| Area { min: Vec2::new(SIDE + i as f32 * (size.x + BETWEEN_ON_SHELF), top), size };
        places.extend((0..shelf.len()).map(place));
        top += height + BETWEEN_ON_SHELF;
    }
    (places, areas)
}

pub(super) fn draw_heading(canvas: &Canvas, area: Area, levels: &[&LevelEntry]) {
    let Some(world) = levels.first().map(|level| level.world) else { return };
    let (title, colour) =
        world.map_or((tr("Your levels"), theme::quiet()), |world| (tr(world.title()), WorldPalette::of(world).ink));
    let middle = area.centre().y;
    canvas.text(title, Vec2::new(area.min.x, middle), Style::new(BUTTON_TEXT, colour).middle());
    let mut right = area.max().x;
    for medal in [Medal::Bronze, Medal::Silver, Medal::Gold] {
        let earned = levels.iter().filter(|level| level.medals.medal == Some(medal)).count();
        let style = Style::new(TEXT, theme::text()).mono().middle().right();
        canvas.text(&format!("{earned}"), Vec2::new(right, middle), style);
        right -= canvas.width(&format!("{earned}"), style) + 18.0;
        widgets::draw(canvas, Prize::Medal(medal), true, Vec2::new(right, middle), 9.0);
        right -= 30.0;
    }
}

impl LevelSelect {
    /// Letters are what is to be found; whether there were any.
    pub(super) fn type_in(&mut self, ui: &mut Ui<'_>) -> bool {
        let before = self.find.clone();
        for stroke in if ui.is_live() { ui.input().strokes(&[]) } else { Vec::new() } {
            if let Stroke::Letter(letter) = stroke
                && !letter.is_control()
                && self.find.chars().count() < MOST_LETTERS
            {
                self.find.push(letter);
            }
        }
        self.find = self.find.trim_start().to_owned();
        let letters = self.find.chars().count().saturating_sub(ui.strokes(&[Key::Backspace]).len());
        self.find = self.find.chars().take(letters).collect();
        let changed = self.find != before;
        if changed {
            self.search_again(ui);
        }
        changed
    }

    pub(super) fn search_again(&mut self, ui: &mut Ui<'_>) {
        self.page = 0;
        self.start = None;
        ui.focus(None);
        self.search();
    }

    pub(super) fn search(&mut self) {
        let letters = self.find.trim().to_lowercase();
        self.found = (0..self.entries.len()).filter(|index| self.entries[*index].has(&letters)).collect();
        let worlds: Vec<Option<Landscape>> = self.found.iter().map(|index| self.entries[*index].world).collect();
        self.pages = pages(&worlds);
        self.page = self.page.min(self.pages.len().saturating_sub(1));
    }
}

#[cfg(test)]
mod tests {
    use super::super::shelves::PAGE;
    use super::*;

    #[test]
    fn cards_fill_the_page_whatever_their_number() {
        for (width, height) in [(1280.0, 720.0), (900.0, 500.0), (1920.0, 1080.0), (600.0, 1000.0), (3000.0, 500.0)] {
            let frame = Frame::of_window(Vec2::new(width, height));
            for count in 1..=PAGE {
                let cards = cards(count, &frame);
                let (first, last) = (cards[0], cards[count - 1]);
                let foot = frame.size.y - FOOT - ROW_BUTTON.y;
                assert!(cards.iter().all(|card| card.min.x >= SIDE - 0.1 && card.max().x <= frame.size.x - SIDE + 0.1));
                assert!(first.min.y >= HEAD - 0.1 && last.max().y <= foot - ABOVE_FOOT + 0.1);
                for (i, card) in cards.iter().enumerate() {
                    assert!(card.size.min_element() > 100.0, "{count} cards in {width} × {height}: {card:?}");
                    assert!(cards[i + 1..].iter().all(|other| card.max().x < other.min.x || card.max().y < other.min.y));
                }
                let filled = cards.iter().map(|card| card.size.element_product()).sum::<f32>();
                let room = (frame.size.x - 2.0 * SIDE) * (foot - ABOVE_FOOT - HEAD);
                assert!(
                    filled > 0.5 * room || first.size == LARGEST || count < 3,
                    "{count} cards in {width} × {height}: {}",
                    filled / room
                );
            }
        }
    }

    #[test]
    fn a_shelf_holds_one_world_and_a_page_two_shelves() {
        let (launch, quarry) = (Some(Landscape::Launch), Some(Landscape::Quarry));
        let lengths = |worlds: &[Option<Landscape>]| {
            pages(worlds).iter().map(|page| page.iter().map(Range::len).collect()).collect::<Vec<Vec<usize>>>()
        };
        assert_eq!(lengths(&[None; 16]), [[15], [1]]);
        assert_eq!(pages(&[[launch; 6], [quarry; 6]].concat()), [[0..3, 3..6], [6..9, 9..12]]);
        assert_eq!(lengths(&[launch, quarry, quarry, None]), [vec![1, 2], vec![1]]);
        assert_eq!(lengths(&[launch; 4]), [[3, 1]]);
        assert!(pages(&[]).is_empty());
    }

    #[test]
    fn cards_and_headings_stand_apart_inside_the_window() {
        for (width, height) in [(1280.0, 720.0), (900.0, 500.0), (1920.0, 1080.0), (600.0, 1000.0)] {
            let frame = Frame::of_window(Vec2::new(width, height));
            let all = [[true, false], [true, true]].map(|heads| places(&[0..3, 3..6], &heads, &frame));
            let all: [Vec<Area>; 2] = all.map(|(cards, headings)| cards.into_iter().chain(headings).collect());
            for all in &all {
                for (i, card) in all.iter().enumerate() {
                    assert!(card.min.x >= SIDE - 0.1 && card.max().x <= frame.size.x - SIDE + 0.1, "{card:?}");
                    assert!(card.max().y <= room(&frame).max().y + 0.1, "{card:?}");
                    assert!(card.size.y >= HEADING_ROOM - ABOVE_CARDS, "{card:?}");
                    let apart = |other: &Area| {
                        let (a, b) = (card.max().min(other.max()), card.min.max(other.min));
                        a.x <= b.x + 0.1 || a.y <= b.y + 0.1
                    };
                    assert!(all[i + 1..].iter().all(apart), "{card:?}");
                }
            }
        }
    }
}
