//! Arrows at the window's edge that point to goals and key objects outside the view, each with its sign and the distance.

use super::super::camera::Viewport;
use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, MONO_ADVANCE, Vec2};
use crate::game::{Game, Outcome, SHIP, object_body};
use crate::level::ObjectiveKind;
use crate::number::fixed;
use crate::physics::{Aabb, DVec2};

/// A goal or a key with less than this in the window is outside, canvas units; a smaller one with less than half of itself.
const LEAST_SEEN: f32 = 16.0;
/// Length of an arrow's head, and side of the sign, canvas units.
pub const HEAD: f32 = 16.0;
pub const SIGN: f32 = 18.0;
/// From the window's edge to an arrow, canvas units.
const MARGIN: f32 = GRID;
/// The search's step along the edge, canvas units, and its number of rows, from the edge inwards.
const STEP: f32 = GRID;
const ROWS: usize = 4;
/// The most arrows: more tell nothing.
const MOST: usize = 12;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointerTarget {
    /// Index of the objective.
    Objective(usize),
    /// Index of the key object in the level's objects.
    Key(usize),
}

/// An arrow with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Pointer {
    pub target: PointerTarget,
    /// The distance, in words.
    pub words: String,
    /// All of it, with room for its head in any direction.
    pub area: Area,
    /// The unit vector to its target.
    pub along: Vec2,
}

impl Pointer {
    /// The box with the sign and the words.
    pub fn panel(&self) -> Area {
        self.area.inset(HEAD)
    }
}

/// The unmet goals and the keys that an unmet one waits for, each with its place, m; `centres` are the drawn centres of bodies, m.
pub fn targets(game: &Game, centres: &[DVec2]) -> Vec<(PointerTarget, Aabb)> {
    let level = game.level();
    if game.outcome() != Outcome::Running {
        return Vec::new();
    }
    let goals = level.objectives.iter().enumerate().filter(|(index, _)| !game.met()[*index]);
    let goals = goals.map(|(index, objective)| (PointerTarget::Objective(index), objective.bounds));
    let physics = || (0..level.objectives.len()).filter(|&goal| level.objectives[goal].kind == ObjectiveKind::Physics);
    let keys = level.objects.iter().enumerate().filter_map(|(index, object)| {
        let key = object.key?;
        let (body, fits) = (object_body(index), |goal: &usize| level.objectives[*goal].fits(key));
        let touches = |goal: usize| game.world().body(body).bounds().touches(&level.objectives[goal].bounds, 0.0);
        let wanted = physics().filter(fits).any(|goal| !game.met()[goal]);
        let at_work =
            physics().filter(fits).any(|goal| game.met()[goal] && level.objectives[goal].order.is_none() && touches(goal));
        (wanted && !at_work).then(|| (PointerTarget::Key(index), Aabb::around(centres[body.index()], object.size * 0.5)))
    });
    goals.chain(keys).collect()
}

/// Whether enough of a box is in the window to be seen.
pub fn in_view(area: &Area, frame: &Frame) -> bool {
    let seen = area.max().min(frame.size) - area.min.max(Vec2::ZERO);
    seen.cmpge((area.size / 2.0).min(Vec2::splat(LEAST_SEEN))).all()
}

/// The arrows, the nearest target's first: inside the window, over nothing in `taken`, over no other, and, where there is room,
/// over nothing in `clear`.
pub fn place(game: &Game, centres: &[DVec2], taken: &[Area], clear: &[Area], view: &Viewport, frame: &Frame) -> Vec<Pointer> {
    let ship = centres[SHIP.index()];
    let outside = |(_, bounds): &(PointerTarget, Aabb)| !in_view(&view.exact(bounds), frame);
    let far = |bounds: &Aabb| bounds.centre().distance(ship);
    let mut targets: Vec<(PointerTarget, Aabb)> = targets(game, centres).into_iter().filter(outside).collect();
    targets.sort_by(|a, b| far(&a.1).total_cmp(&far(&b.1)));
    let mut taken = taken.to_vec();
    let mut pointers = Vec::new();
    for (target, bounds) in targets.into_iter().take(MOST) {
        let words = format!("{} m", fixed(far(&bounds), 0));
        let text = frame.text_height(DETAILS);
        let panel = Vec2::new(SIGN + words.chars().count() as f32 * MONO_ADVANCE * text + 3.0 * GRID, text * LINE + GRID);
        let aim = view.point(bounds.centre());
        let size = panel + 2.0 * HEAD;
        let free = |area: &Area| area.covers_none(&taken);
        let place = best(view.point(ship), aim, size, frame, &|area| free(area) && area.covers_none(clear));
        if let Some(area) = place.or_else(|| best(view.point(ship), aim, size, frame, &free)) {
            taken.push(area);
            pointers.push(Pointer { target, words, area, along: (aim - area.centre()).normalize_or(Vec2::Y) });
        }
    }
    pointers
}

/// The free place along the window's edge that is nearest to where the straight line from the ship to the aim leaves the window.
fn best(ship: Vec2, aim: Vec2, size: Vec2, frame: &Frame, is_free: &dyn Fn(&Area) -> bool) -> Option<Area> {
    let mut found: Option<(f32, Area)> = None;
    let inner = frame.area().inset(MARGIN);
    let room = Area { min: inner.min + size / 2.0, size: inner.size - size };
    if room.size.min_element() < 0.0 {
        return None;
    }
    let from = ship.clamp(room.min, room.max());
    let length = from.distance(aim);
    let along = (aim - from) / length.max(f32::MIN_POSITIVE);
    let ideal = room.stretch(from, along, length).map_or(from, |(_, leaves)| from + along * leaves);
    let mut consider = |centre: Vec2| {
        let (area, off) = (Area::around(centre, size), centre.distance(ideal));
        if found.is_none_or(|(least, _)| off < least) && is_free(&area) {
            found = Some((off, area));
        }
    };
    consider(ideal);
    for row in 0..ROWS {
        let ring = Area { min: room.min + row as f32 * size.y, size: room.size - 2.0 * row as f32 * size.y };
        if ring.size.min_element() < 0.0 {
            break;
        }
        for (corner, side) in [(ring.min, Vec2::X), (ring.min, Vec2::Y), (ring.max(), Vec2::NEG_X), (ring.max(), Vec2::NEG_Y)] {
            let length = (ring.size * side.abs()).element_sum();
            // The places move with the ideal one, so that an arrow glides.
            let phase = (ideal - corner).dot(side).rem_euclid(STEP);
            (0..=(length / STEP) as usize).for_each(|i| consider(corner + side * (i as f32 * STEP + phase).min(length)));
        }
    }
    found.map(|(_, area)| area)
}
