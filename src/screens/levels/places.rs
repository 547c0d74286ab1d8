//! Where the cards of a page stand, and the buttons below them.

use crate::draw::layout::{Area, Frame, GAP, ROW_BUTTON, Vec2};

/// From the canvas' sides to the cards, and from its top: the heading.
pub(super) const SIDE: f32 = 40.0;
pub(super) const HEAD: f32 = 88.0;
/// Between two cards.
const BETWEEN: f32 = 24.0;
/// From the canvas' bottom to the buttons below the cards, and from those to the cards.
pub(super) const FOOT: f32 = 24.0;
const ABOVE_FOOT: f32 = 24.0;
/// How much wider than high a card looks best.
const SHAPE: f32 = 1.3;
/// No card is larger: a single level does not want the whole window.
const LARGEST: Vec2 = Vec2::new(900.0, 600.0);
/// A button at the foot.
pub(super) const FOOT_BUTTON: Vec2 = Vec2::new(160.0, ROW_BUTTON.y);

/// The place of a button at the foot, counted from the left.
pub(super) fn from_left(nth: f32, frame: &Frame) -> Area {
    Area { min: Vec2::new(SIDE + nth * (FOOT_BUTTON.x + GAP), foot(frame)), size: FOOT_BUTTON }
}

/// The place of a button at the foot, counted from the right.
pub(super) fn from_right(nth: f32, frame: &Frame) -> Area {
    let left = frame.size.x - SIDE - FOOT_BUTTON.x - nth * (FOOT_BUTTON.x + GAP);
    Area { min: Vec2::new(left, foot(frame)), size: FOOT_BUTTON }
}

fn foot(frame: &Frame) -> f32 {
    frame.size.y - FOOT - ROW_BUTTON.y
}

/// All the window between the heading and the foot.
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
}
