//! The places of words in the level: of goals and plates, and the author's. None lies on another, on a goal, a plate, a fan, the ship's start
//! or the head-up display; what has no free place is left out.

use super::camera::Viewport;
use crate::draw::layout::{Area, DETAILS, Frame, LINE, MONO_ADVANCE, Vec2, nearest_size, words_width};
use crate::level::{Level, Objective, ObjectiveKind, SHIP_HALF};
use crate::{number::fixed, physics::Aabb, words::tr};

/// From a thing to the words beside it, canvas units.
const GAP: f32 = 4.0;
/// Width of a goal's sign: with the ring of a hold time, and without; and from it to the words.
const SIGN: [f32; 2] = [28.0, 16.0];
pub const BESIDE_SIGN: f32 = 6.0;

/// What the words are of, by its index in the level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LabelOf {
    Text(usize),
    Objective(usize),
    /// A switch that a weight presses.
    Plate(usize),
}

#[derive(Clone, Debug, PartialEq)]
pub struct LevelLabel {
    pub of: LabelOf,
    pub words: String,
    pub area: Area,
}

/// The labels in a view, beside those areas of the display.
pub fn place(level: &Level, view: &Viewport, frame: &Frame, display: impl Iterator<Item = Area>) -> Vec<LevelLabel> {
    let goals: Vec<Area> = level.objectives.iter().map(|objective| view.rect(&objective.bounds)).collect();
    let mut taken: Vec<Area> = things(level, view).skip(goals.len()).chain(display).collect();
    let mut labels: Vec<LevelLabel> = Vec::new();
    let mut put = |of: LabelOf, words: String, places: &[Area], own: Option<usize>| {
        let others = || goals.iter().enumerate().filter(move |(goal, _)| Some(*goal) != own).map(|(_, area)| area);
        let free = |area: &&Area| taken.iter().chain(others()).all(|other| area.gap(other) >= 0.0);
        if let Some(area) = places.iter().find(free).copied() {
            taken.push(area);
            labels.push(LevelLabel { of, words, area });
        }
    };
    for (index, text) in level.texts.iter().enumerate() {
        let (words, height) = (tr(&text.text).to_owned(), frame.text_height(nearest_size(view.length(text.size))));
        let area = Area { min: view.point(text.position), size: Vec2::new(words_width(&words, height), height * LINE) };
        put(LabelOf::Text(index), words, &[area], None);
    }
    let height = frame.text_height(DETAILS);
    let visible = view.visible();
    for (index, objective) in level.objectives.iter().enumerate().filter(|(_, it)| it.bounds.touches(&visible, 2.0)) {
        let words = name(objective);
        let size = Vec2::new(sign(objective) + BESIDE_SIGN + words_width(&words, height), sign(objective).max(height));
        let area = goals[index];
        let inside = (area.size.cmpge(size + 2.0 * GAP).all()).then(|| Area::around(area.centre(), size));
        let places: Vec<Area> = inside.into_iter().chain(beside(&area, size, frame)).collect();
        put(LabelOf::Objective(index), words, &places, Some(index));
    }
    for (index, switch) in level.switches.iter().enumerate().filter(|(_, it)| it.bounds.touches(&visible, 1.0)) {
        let Some(weight) = switch.weight else { continue };
        let words = format!("> {} N", fixed(weight, 0));
        let size = Vec2::new(words.chars().count() as f32 * MONO_ADVANCE * height + 8.0, height * 1.3);
        let [above, below, ..] = beside(&view.rect(&switch.bounds), size, frame);
        put(LabelOf::Plate(index), words, &[below, above], None);
    }
    labels
}

/// The areas of goals first, then of plates, fans and the ship's start.
pub fn things(level: &Level, view: &Viewport) -> impl Iterator<Item = Area> {
    let goals = level.objectives.iter().map(|objective| objective.bounds);
    let plates = level.switches.iter().map(|switch| switch.bounds);
    let fans = level.streams.iter().map(|stream| stream.source);
    let start = level.ship_plays().then(|| Aabb::around(level.player.position, SHIP_HALF));
    goals.chain(plates).chain(fans).chain(start).map(|bounds| view.rect(&bounds))
}

/// Its turn, and whose goal it is.
fn name(objective: &Objective) -> String {
    let name = match objective.kind {
        ObjectiveKind::Player => tr("Ship"),
        ObjectiveKind::Physics => tr("Key"),
    };
    objective.order.map_or(name.to_owned(), |turn| format!("{turn}. {name}"))
}

pub const fn sign(objective: &Objective) -> f32 {
    SIGN[(objective.hold <= 0.0) as usize]
}

fn beside(area: &Area, size: Vec2, frame: &Frame) -> [Area; 4] {
    let out = (area.size + size) / 2.0 + GAP;
    let (low, high) = (size / 2.0 + GAP, frame.size - size / 2.0 - GAP);
    [-Vec2::Y, Vec2::Y, Vec2::X, -Vec2::X].map(|way| {
        let middle = area.centre() + way * out;
        // Along the edge of what it is of it stays in the window.
        let kept = middle.clamp(low, high.max(low));
        Area::around(if way.x == 0.0 { Vec2::new(kept.x, middle.y) } else { Vec2::new(middle.x, kept.y) }, size)
    })
}
