//! Places of the head-up display's parts, which step aside for the ship, hazards, goals and keys; the fuel bar sinks to a thin line at the edge.
//! Arrows at the window's edge point to goals and key objects outside the view, each with its sign and the distance.

use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, MONO_ADVANCE, TEXT, Vec2};
use crate::game::{Game, Outcome, SHIP, object_body};
use crate::physics::{Aabb, DVec2};
use crate::{level::ObjectiveKind, number::fixed, view::camera::Viewport};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HudPart {
    /// Time, objectives and speed, at the top left.
    Status,
    /// The fuel bar, at the bottom left.
    Fuel,
    /// The strip with the medal and the ghosts of a race, beside the status.
    Race,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HudShown {
    pub status: bool,
    pub fuel: bool,
    pub rivals: usize,
    /// The medal that is still within reach.
    pub medal: bool,
}

/// A part steps aside for an object nearer than this, canvas units.
const NEAR: f32 = GRID;
/// Duration of a part's step aside, s.
const TIME: f32 = 0.16;
/// Height of the line that remains of the fuel bar, canvas units.
const STRIP: f32 = 4.0;

#[derive(Clone, Debug, Default)]
pub struct Aside {
    homes: [Option<Area>; 3],
    columns: usize,
    shows_medal: bool,
    /// 0 at home … 1 aside.
    parts: [f32; 3],
}

impl Aside {
    /// Advances by `frame_time` s, with the drawn places of the ship (its speed in canvas units a second) and of all else that may not be hidden.
    pub fn update(&mut self, shown: HudShown, (ship, speed): (Area, f32), others: &[Area], frame: &Frame, frame_time: f64) {
        let layout = HudLayout::new(frame);
        self.shows_medal = shown.medal;
        self.columns = shown.rivals + usize::from(shown.medal);
        let race = (self.columns > 0).then(|| layout.race(frame, self.columns));
        self.homes = [shown.status.then_some(layout.status), shown.fuel.then_some(layout.fuel), race];
        let step = frame_time as f32 / TIME;
        for (home, aside) in self.homes.iter().zip(&mut self.parts) {
            let Some(home) = home else { continue };
            let gap = others.iter().map(|other| home.gap(other) - NEAR).fold(home.gap(&ship) - NEAR - speed * TIME, f32::min);
            *aside = if gap < 0.0 { *aside + step } else { *aside - step }.clamp(0.0, 1.0);
            // A view that jumps or a very fast ship waits for no fading.
            if home.gap(&ship) < 0.0 || others.iter().any(|other| home.gap(other) < 0.0) {
                *aside = 1.0;
            }
        }
    }

    /// The undisturbed place of a part; `None` where it is not shown.
    pub const fn home(&self, part: HudPart) -> Option<Area> {
        self.homes[part as usize]
    }

    pub fn medal(&self) -> Option<Area> {
        self.column(0, self.columns).filter(|_| self.shows_medal)
    }

    /// The place of the column `index` among the last `of` of the strip.
    pub fn column(&self, index: usize, of: usize) -> Option<Area> {
        let strip = self.home(HudPart::Race).filter(|_| of <= self.columns)?;
        let width = strip.size.x / self.columns as f32;
        Some(Area::new(strip.min.x + (self.columns - of + index) as f32 * width, strip.min.y, width, strip.size.y))
    }

    pub fn homes(&self) -> impl Iterator<Item = Area> {
        self.homes.iter().copied().flatten()
    }

    /// 0 at home, 1 aside.
    pub const fn of(&self, part: HudPart) -> f32 {
        self.parts[part as usize]
    }

    /// The fuel bar on its path from its home to the line at the window's edge.
    pub fn fuel_bar(&self, frame: &Frame) -> Option<Area> {
        let home = self.home(HudPart::Fuel)?;
        let aside = self.of(HudPart::Fuel);
        let line = Area::new(home.min.x, frame.size.y - STRIP, home.size.x, STRIP);
        Some(Area { min: home.min.lerp(line.min, aside), size: home.size.lerp(line.size, aside) })
    }
}

/// Width and height of the fuel bar as shares of the window's: the ring around the ship says the same.
const BAR: Vec2 = Vec2::new(0.16, 0.025);
/// Height of the panel at the top left.
const STATUS_HEIGHT: f32 = 72.0;
/// Width of a column of the strip, in heights of text.
const RACE_COLUMN: f32 = 6.6;

/// Nothing else should cover these places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HudLayout {
    pub status: Area,
    pub fuel: Area,
}

impl HudLayout {
    pub fn new(frame: &Frame) -> Self {
        let (bar, text) = (frame.size * BAR, frame.text_height(TEXT));
        Self {
            status: Area::new(2.0 * GRID, 2.0 * GRID, 15.2 * text, STATUS_HEIGHT.max(text * 3.2)),
            fuel: Area::new(2.0 * GRID, frame.size.y - bar.y - 2.0 * GRID, bar.x, bar.y),
        }
    }

    /// The parts in a game in which the ship plays a part.
    pub fn shown(frame: &Frame, game: &Game) -> Vec<Area> {
        if game.level().ship_plays() { Self::new(frame).areas().to_vec() } else { Vec::new() }
    }

    pub fn race(&self, frame: &Frame, columns: usize) -> Area {
        let left = self.status.max().x + GRID;
        let width = (RACE_COLUMN * frame.text_height(TEXT) * columns as f32).min(frame.size.x - left - 2.0 * GRID);
        Area::new(left, self.status.min.y, width, frame.text_height(TEXT) * 2.8)
    }

    pub fn areas(&self) -> [Area; 2] {
        [self.status, self.fuel]
    }
}

/// A goal or a key with less than this in the window is outside, canvas units; a smaller one with less than half of itself.
const LEAST_SEEN: f32 = 16.0;
/// Length of an arrow's head, and side of the sign, canvas units.
pub const HEAD: f32 = 16.0;
pub const SIGN: f32 = 18.0;
/// From the window's edge to an arrow, canvas units.
const MARGIN: f32 = GRID;
/// The search's step along the edge, canvas units.
const STEP: f32 = GRID;
/// The most arrows: more tell nothing.
const MOST: usize = 3;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointerTarget {
    Objective(usize),
    /// Index of the key object in the level's objects.
    Key(usize),
}

#[derive(Clone, Debug, PartialEq)]
pub struct Pointer {
    pub target: PointerTarget,
    pub words: String,
    /// All of it, with room for its head in any direction.
    pub area: Area,
    /// The unit vector to its target.
    pub along: Vec2,
}

impl Pointer {
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
        let at_work = physics().filter(fits).any(|i| game.met()[i] && level.objectives[i].order.is_none() && touches(i));
        (wanted && !at_work).then(|| (PointerTarget::Key(index), Aabb::around(centres[body.index()], object.size * 0.5)))
    });
    goals.chain(keys).collect()
}

pub fn in_view(area: &Area, frame: &Frame) -> bool {
    (area.max().min(frame.size) - area.min.max(Vec2::ZERO)).cmpge((area.size / 2.0).min(Vec2::splat(LEAST_SEEN))).all()
}

/// The arrows, the nearest target's first: in the window, over no other, over nothing in `taken` and, where there is room, in `clear`.
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
    for (corner, side) in [(room.min, Vec2::X), (room.min, Vec2::Y), (room.max(), Vec2::NEG_X), (room.max(), Vec2::NEG_Y)] {
        let length = (room.size * side.abs()).element_sum();
        // The places move with the ideal one, so that an arrow glides.
        let phase = (ideal - corner).dot(side).rem_euclid(STEP);
        (0..=(length / STEP) as usize).for_each(|i| consider(corner + side * (i as f32 * STEP + phase).min(length)));
    }
    found.map(|(_, area)| area)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::Vec2;

    const SHOWN: HudShown = HudShown { status: true, fuel: true, rivals: 2, medal: false };

    #[test]
    fn a_part_fades_for_the_ship_that_comes_near_and_comes_back() {
        let (mut aside, frame) = (Aside::default(), Frame::default());
        let far = Area::around(frame.size / 2.0, Vec2::splat(51.0));
        aside.update(SHOWN, (far, 0.0), &[], &frame, 1.0);
        assert_eq!(aside.parts, [0.0; 3]);
        let bar = aside.home(HudPart::Fuel).expect("it is shown");
        let above = Area::around(bar.centre() - Vec2::new(0.0, 70.0), Vec2::splat(51.0));
        aside.update(SHOWN, (above, 0.0), &[], &frame, 0.05);
        assert_eq!(aside.of(HudPart::Fuel), 0.0, "a ship at rest above it is in nobody's way");
        aside.update(SHOWN, (above, 300.0), &[], &frame, 0.05);
        assert!(aside.of(HudPart::Fuel) > 0.0 && aside.of(HudPart::Fuel) < 1.0 && aside.of(HudPart::Status) == 0.0);
        for _ in 0..4 {
            aside.update(SHOWN, (above, 300.0), &[], &frame, 0.05);
        }
        assert_eq!(aside.of(HudPart::Fuel), 1.0);
        assert!(aside.fuel_bar(&frame).expect("it is shown").min.y > bar.max().y, "it is a line below where it was");
        for _ in 0..4 {
            aside.update(SHOWN, (far, 0.0), &[], &frame, 0.05);
        }
        assert_eq!((aside.of(HudPart::Fuel), aside.fuel_bar(&frame)), (0.0, Some(bar)));
    }

    #[test]
    fn a_part_never_hides_a_goal_that_a_jump_brings_under_it() {
        let (mut aside, frame) = (Aside::default(), Frame::default());
        let far = Area::around(frame.size / 2.0, Vec2::splat(51.0));
        let goal = Area::new(100.0, 20.0, 200.0, 30.0);
        aside.update(SHOWN, (far, 0.0), &[goal], &frame, 0.0);
        assert_eq!(aside.parts, [1.0, 0.0, 1.0]);
    }

    #[test]
    fn a_part_that_plays_none_is_not_there() {
        let (mut aside, frame) = (Aside::default(), Frame::default());
        let far = Area::around(frame.size / 2.0, Vec2::splat(51.0));
        aside.update(HudShown { fuel: false, rivals: 0, ..SHOWN }, (far, 0.0), &[], &frame, 0.0);
        assert_eq!(aside.homes().count(), 1);
        assert_eq!(aside.fuel_bar(&frame), None);
    }
}
