//! The head-up display: time, met objectives, speed, fuel, arrows to targets outside of the view; and the ship's velocity.

mod aside;

pub use aside::{Aside, HudLayout, HudPart, HudShown, Pointer, PointerTarget, in_view, targets};

use super::art::{self, Tile};
use super::widgets::{fitted, panel_in};
use super::zones::{diamond, ring};
use super::{camera::Viewport, emitters::objective_colour, labels, theme};
use crate::draw::layout::{Area, DETAILS, Frame, GRID, TEXT, Vec2, text_room};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{DAMAGING_SPEED, Game, Medals, SHIP};
use crate::level::{Level, ObjectiveKind};
use crate::number::{clock, fixed};
use crate::physics::{Aabb, BodyId, DVec2};
use crate::settings::{Action, Settings};
use crate::words::tr;

/// The fuel bar's colour when full; it runs to [`FUEL_EMPTY`].
const FUEL_FULL: Colour = Colour::hex(0xFFB01C);
const FUEL_EMPTY: Colour = Colour::hex(0xF2302F);
/// Opacity of a part at home, and of its words where it has stepped aside.
const HIDES: f32 = 0.9;
const WORDS_ASIDE: f32 = 0.3;
/// End of the speed gauge, m/s.
const GAUGE_END: f64 = 2.0 * DAMAGING_SPEED;
/// Length of the arrow of velocity, m of the level a m/s, and where it begins and ends, m from the ship's centre.
const VELOCITY_SCALE: f64 = 0.22;
const VELOCITY_START: f64 = 1.25;
const VELOCITY_END: f64 = 6.0;
/// Length of its head, canvas units.
const VELOCITY_HEAD: f32 = 9.0;
/// A slower ship has no arrow, m/s.
const VELOCITY_LEAST: f64 = 0.5;
/// Below this time left for a medal its number glows, s.
const HURRY: f64 = 3.0;
/// Radius of the fuel's ring around the ship, m, and the share of fuel below which the ring is bold.
const FUEL_RING: f64 = 1.3;
const FUEL_LOW: f32 = 0.25;
/// Duration of the hint with the keys at the start of the first level, s.
const HINT_TIME: f64 = 12.0;

#[derive(Clone, Copy, Debug)]
pub struct HudScene<'a> {
    pub game: &'a Game,
    /// Drawn centres of the bodies, m.
    pub centres: &'a [DVec2],
    pub view: &'a Viewport,
    pub frame: &'a Frame,
    /// The panels on the screen besides the display.
    pub panels: &'a [Area],
    pub shown: HudShown,
    pub settings: &'a Settings,
}

#[derive(Default)]
pub struct Hud {
    pub aside: Aside,
    pub pointers: Vec<Pointer>,
    /// Advice without fuel, and its place.
    stranded: Option<(String, Area)>,
}

impl Hud {
    pub fn update(&mut self, scene: &HudScene, frame_time: f64) {
        let HudScene { game, view, frame, .. } = *scene;
        let (ship, others) = kept_free(scene);
        self.aside.update(scene.shown, (ship, view.length(game.world().body(SHIP).velocity.length())), &others, frame, frame_time);
        self.stranded = (scene.shown.fuel && game.is_stranded()).then(|| stranded(scene, ship, &others));
        self.pointers.clear();
        if scene.shown.status {
            let mut taken: Vec<Area> = self.aside.homes().chain(scene.panels.iter().copied()).collect();
            taken.extend(self.stranded.iter().map(|(_, area)| *area));
            taken.push(ship);
            let labels = labels::place(game.level(), view, frame, self.aside.homes()).into_iter().map(|label| label.area);
            taken.extend(labels.chain(labels::things(game.level(), view)));
            let objects = (1..scene.centres.len()).map(|index| view.exact(&body(scene, index)));
            let clear: Vec<Area> = others.into_iter().chain(objects).filter(|area| area.gap(&frame.area()) < 0.0).collect();
            self.pointers = aside::place(game, scene.centres, &taken, &clear, view, frame);
        }
    }

    pub fn stranded(&self) -> Option<Area> {
        self.stranded.as_ref().map(|(_, area)| *area)
    }

    /// All but the strip of a race; `hint_shown` says whether the first level's hint with the keys is there.
    pub fn draw(&self, game: &Game, settings: &Settings, hint_shown: bool, canvas: &Canvas) {
        for pointer in &self.pointers {
            draw_pointer(pointer, game, canvas);
        }
        if let Some(area) = self.aside.home(HudPart::Status) {
            draw_status(game, settings, area, self.aside.of(HudPart::Status), canvas);
        }
        if let Some(strip) = self.aside.home(HudPart::Race) {
            let (ground, _) = left(self.aside.of(HudPart::Race));
            panel_in(canvas, strip, theme::panel().faded(0.7 * ground), theme::panel_edge().faded(ground));
        }
        if let Some(column) = self.aside.medal() {
            draw_medal(game, column, &self.aside, canvas);
        }
        if let Some((words, area)) = &self.stranded {
            panel_in(canvas, *area, theme::panel().faded(HIDES), theme::panel_edge());
            canvas.text(words, area.centre(), Style::new(TEXT, theme::text()).centred().middle());
        }
        if let Some(bar) = self.aside.fuel_bar(canvas.frame()) {
            let level = &game.level().player;
            let share = if level.fuel > 0.0 { (game.ship().fuel / level.fuel).clamp(0.0, 1.0) } else { 0.0 };
            let fuel = tr!("Fuel {fuel} units", fuel = fixed(game.ship().fuel, 0));
            let words = hint(game, settings).filter(|_| hint_shown).map_or(fuel.clone(), |hint| format!("{fuel}    {hint}"));
            draw_fuel(share as f32, &words, bar, self.aside.of(HudPart::Fuel), canvas);
        }
    }
}

/// Places that the display may not hide: the ship; and hazards, goals and keys.
fn kept_free(scene: &HudScene) -> (Area, Vec<Area>) {
    let objects = scene.game.level().objects.iter().enumerate();
    let keys = objects.filter(|(_, object)| object.key.is_some()).map(|(index, _)| body(scene, index + 1));
    let others = landmarks(scene.game.level()).chain(keys);
    (scene.view.exact(&body(scene, SHIP.index())), others.map(|bounds| scene.view.exact(&bounds)).collect())
}

/// The boxes of goals, death boxes and the sources of streams, m.
pub fn landmarks(level: &Level) -> impl Iterator<Item = Aabb> {
    let goals = level.objectives.iter().map(|objective| objective.bounds);
    goals.chain(level.obstacles.iter().copied()).chain(level.streams.iter().map(|stream| stream.source))
}

/// The box of a body where it is drawn, m.
fn body(scene: &HudScene, index: usize) -> Aabb {
    Aabb::around(scene.centres[index], scene.game.world().body(BodyId(index as u32)).half)
}

/// The advice without fuel: above the fuel bar, or below the status where that would hide one of the others.
fn stranded(scene: &HudScene, ship: Area, others: &[Area]) -> (String, Area) {
    let words = tr!("Out of fuel – {key} flies again", key = scene.settings.keys.label(Action::Restart));
    let layout = HudLayout::new(scene.frame);
    let size = text_room(&words, scene.frame.text_height(TEXT)) + Vec2::new(2.0, 1.0) * GRID;
    let at = |y: f32| Area::around(Vec2::new(scene.frame.size.x / 2.0, y), size);
    let places = [at(layout.fuel.min.y - GRID - size.y / 2.0), at(layout.status.max().y + GRID + size.y / 2.0)];
    let free = |area: &&Area| area.gap(&ship) >= GRID && area.covers_none(others);
    let area = places.iter().find(free).or_else(|| places.iter().find(|area| area.gap(&ship) >= GRID)).unwrap_or(&places[0]);
    (words, *area)
}

/// An arrow at the window's edge: head, sign and distance. A goal's sign is a box with the ship or a diamond in it; a key's is the key itself.
fn draw_pointer(pointer: &Pointer, game: &Game, canvas: &Canvas) {
    let level = game.level();
    let panel = pointer.panel();
    let sign = Area::around(Vec2::new(panel.min.x + GRID + aside::SIGN / 2.0, panel.centre().y), Vec2::splat(aside::SIGN));
    let middle = sign.centre();
    let colour = match pointer.target {
        PointerTarget::Objective(index) => objective_colour(game, index),
        PointerTarget::Key(index) => key_colour(level.objects[index].key),
    };
    // The head stands on the box's edge, where the line from the middle to the target leaves it: slim, or its tip would be a corner.
    let reach = panel.stretch(panel.centre(), pointer.along, panel.size.length()).map_or(0.0, |(_, leaves)| leaves);
    let (tip, across) = (panel.centre() + pointer.along * (reach + aside::HEAD), pointer.along.perp() * (0.4 * aside::HEAD));
    let root = tip - pointer.along * (1.5 * aside::HEAD);
    canvas.convex(&[tip, root + across, root - across], colour);
    panel_in(canvas, panel, theme::panel().faded(HIDES), colour);
    match pointer.target {
        PointerTarget::Objective(index) => {
            canvas.rectangle(sign, colour.faded(0.30));
            canvas.rectangle_edge(sign, 1.5, colour);
            match level.objectives[index].kind {
                ObjectiveKind::Player => art::draw(canvas, Tile::Ship, Area::around(middle, sign.size * 0.8), 0.0, Colour::WHITE),
                ObjectiveKind::Physics => diamond(canvas, middle, 5.0, key_colour(level.objectives[index].colour)),
            }
        }
        PointerTarget::Key(index) => {
            if level.objects[index].circular {
                canvas.disc(middle, sign.size.x / 2.0, colour);
            } else {
                canvas.rectangle(sign, colour);
            }
            diamond(canvas, middle, 5.0, Colour::WHITE);
        }
    }
    let words = Style::new(DETAILS, theme::text()).mono().middle().right();
    canvas.text(&pointer.words, Vec2::new(panel.max().x - GRID, middle.y), words);
}

/// The colour of a key, or of a goal for any key.
fn key_colour(key: Option<[u8; 3]>) -> Colour {
    key.map_or(theme::physics_objective(), Colour::of)
}

/// The keys, at the start of the first level: in the fuel bar, where the words hide nothing.
fn hint(game: &Game, settings: &Settings) -> Option<String> {
    (game.level().name == "1" && game.elapsed() < HINT_TIME).then(|| {
        let label = |action| settings.keys.label(action);
        let [restart, rewind, pause, details] = [Action::Restart, Action::Rewind, Action::Pause, Action::Details].map(label);
        tr!("{restart} restarts · {rewind} rewinds · {pause} pauses · {details} shows the forces", restart, rewind, pause, details)
    })
}

/// The opacity of a part's ground and edge, and of its words, at `aside` (0 … 1).
pub const fn left(aside: f32) -> (f32, f32) {
    (1.0 - aside, 1.0 - (1.0 - WORDS_ASIDE) * aside)
}

fn draw_status(game: &Game, settings: &Settings, area: Area, aside: f32, canvas: &Canvas) {
    let (ground, words) = left(aside);
    panel_in(canvas, area, theme::panel().faded(HIDES * ground), theme::panel_edge().faded(ground));
    let middle = area.min.y + area.size.y * 0.29;
    let number = Style::new(TEXT, theme::text().faded(words)).mono().middle();
    let left = area.min.x + 2.0 * GRID;
    if settings.timer {
        canvas.text(&clock(if game.is_idle() { 0.0 } else { game.time() }), Vec2::new(left, middle), number);
    }
    draw_speed(game, area, words, canvas);
    let (met, all) = (game.met().iter().filter(|met| **met).count(), game.met().len());
    let colour = if met == all { theme::good() } else { theme::text() };
    let right = area.max().x - 2.0 * GRID;
    let count = format!("{met}/{all}");
    let style = Style::new(TEXT, colour.faded(words)).mono().middle().right();
    canvas.text(&count, Vec2::new(right, middle), style);
    let name = Vec2::new(right - canvas.width(&count, style) - GRID, middle);
    canvas.text(tr("Objectives"), name, Style::new(TEXT, theme::quiet().faded(words)).middle().right());
}

/// A column of the strip: a name and a number below it.
pub fn draw_column(column: Area, (name, number): (&str, &str), colour: Colour, aside: &Aside, canvas: &Canvas) {
    let (_, strong) = left(aside.of(HudPart::Race));
    let at = |part: f32| Vec2::new(column.centre().x, column.min.y + column.size.y * part);
    fitted(canvas, name, at(0.3), column.size.x - GRID, &[TEXT, DETAILS], theme::quiet().faded(strong));
    canvas.text(number, at(0.72), Style::new(TEXT, colour.faded(strong)).mono().centred().middle());
}

fn draw_medal(game: &Game, column: Area, aside: &Aside, canvas: &Canvas) {
    let time = if game.is_idle() { 0.0 } else { game.time() };
    let (medal, left) = Medals::within_reach(&game.level().awards, time);
    let words = left.map_or_else(|| "–".to_owned(), |left| format!("{} s", fixed(left, 2)));
    let colour = if left.is_some_and(|left| left < HURRY) { theme::accent() } else { theme::text() };
    draw_column(column, (tr(medal.name()), &words), colour, aside, canvas);
}

/// A number and a bar with a mark where speed damages; `strong` (0 … 1) is the opacity.
fn draw_speed(game: &Game, area: Area, strong: f32, canvas: &Canvas) {
    let speed = game.world().body(SHIP).velocity.length();
    let colour = speed_colour(speed).faded(strong);
    let y = area.min.y + area.size.y * 0.72;
    let left = area.min.x + 2.0 * GRID;
    let words = format!("{:>5} m/s", fixed(speed, 1));
    let style = Style::new(TEXT, colour).mono().middle();
    canvas.text(&words, Vec2::new(left, y), style);
    let start = left + canvas.width(&words, style) + 1.5 * GRID;
    let (length, height) = (area.max().x - 2.0 * GRID - start, GRID);
    let share = (speed / GAUGE_END).min(1.0) as f32;
    canvas.rectangle(Area::new(start, y - height / 2.0, length, height), theme::ground().faded(strong));
    canvas.rectangle(Area::new(start, y - height / 2.0, length * share, height), colour);
    let mark = start + length * (DAMAGING_SPEED / GAUGE_END) as f32;
    canvas.rectangle(Area::new(mark - 1.0, y - height, 2.0, 2.0 * height), theme::bad().faded(strong));
}

fn speed_colour(speed: f64) -> Colour {
    if speed >= DAMAGING_SPEED { theme::bad() } else { theme::text() }
}

/// The ends of the velocity's arrow (m/s), beside the ship whose drawn centre is `centre` (m); none for a slow ship.
fn velocity_arrow(velocity: DVec2, centre: DVec2, view: &Viewport) -> Option<(Vec2, Vec2)> {
    let speed = velocity.length();
    let along = velocity / speed;
    let length = (speed * VELOCITY_SCALE).min(VELOCITY_END);
    let ends = || (view.point(centre + along * VELOCITY_START), view.point(centre + along * (VELOCITY_START + length)));
    (speed >= VELOCITY_LEAST).then(ends)
}

pub fn velocity_tip(velocity: DVec2, centre: DVec2, view: &Viewport) -> Option<Area> {
    let (from, to) = velocity_arrow(velocity, centre, view)?;
    Some(Area::around(to - (to - from).normalize_or_zero() * VELOCITY_HEAD * 0.5, Vec2::splat(VELOCITY_HEAD * 1.2)))
}

pub fn draw_velocity(velocity: DVec2, centre: DVec2, view: &Viewport, canvas: &Canvas) {
    let Some((from, to)) = velocity_arrow(velocity, centre, view) else { return };
    let colour = speed_colour(velocity.length()).faded(0.85);
    let (way, head) = ((to - from).normalize_or_zero(), VELOCITY_HEAD);
    canvas.line(from, to - way * head * 0.6, 3.0, colour);
    canvas.convex(&[to, to - way * head + way.perp() * head * 0.5, to - way * head - way.perp() * head * 0.5], colour);
}

/// The fuel as a ring around the ship, which is drawn at `centre` (m): faint while there is plenty.
pub fn draw_fuel_ring(game: &Game, centre: DVec2, view: &Viewport, canvas: &Canvas) {
    let (share, place) = (game.fuel().clamp(0.0, 1.0) as f32, (view.point(centre), view.length(FUEL_RING)));
    let strength = if share < FUEL_LOW { 0.95 } else { 0.5 };
    ring(canvas, place, 1.0, theme::panel_edge().faded(0.35));
    ring(canvas, place, share, fuel_colour(share).faded(strength));
}

/// The bar at `area`; at `aside` (0 … 1) it becomes a line without words.
fn draw_fuel(share: f32, words: &str, area: Area, aside: f32, canvas: &Canvas) {
    let (at, size) = (area.min, area.size);
    canvas.rectangle(area, theme::panel().faded(HIDES));
    canvas.rectangle(Area::new(at.x, at.y, size.x * share, size.y), fuel_colour(share));
    // Dark words on the bright bar; light ones where the bar has ended.
    let style = Style::new(DETAILS, theme::ground()).mono().middle();
    let width = canvas.width(words, style);
    let covered = size.x * share > width + 2.0 * GRID;
    let colour = if covered { theme::ground() } else { theme::text() };
    let x = if covered { at.x + GRID } else { at.x + size.x * share + GRID };
    let named = x - GRID..x + width + GRID;
    // Quarters make the length readable: all across the bar, or they would look like commas, and none through the words.
    for quarter in 1..4_u8 {
        let x = at.x + size.x * f32::from(quarter) / 4.0;
        if !named.contains(&x) {
            canvas.rectangle(Area::new(x - 1.0, at.y, 2.0, size.y), theme::ground().faded(0.6));
        }
    }
    canvas.rectangle_edge(area, 2.0 * (1.0 - aside), theme::panel_edge().faded(1.0 - aside));
    let style = Style { colour: colour.faded((1.0 - 2.0 * aside).max(0.0)), ..style };
    // What large words leave no room for is left out, key by key.
    let fits = |words: &str| canvas.width(words, style) <= canvas.size().x - x - GRID;
    let mut heads = std::iter::successors(Some(words), |words| Some(words.rsplit_once(" · ")?.0));
    canvas.text(heads.find(|words| fits(words)).unwrap_or_default(), Vec2::new(x, area.centre().y), style);
}

fn fuel_colour(share: f32) -> Colour {
    FUEL_EMPTY.mixed(FUEL_FULL, share.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::Frame;

    #[test]
    fn the_fuel_bar_is_small_and_at_the_bottom_left() {
        for pixels in [Vec2::new(900.0, 500.0), Vec2::new(1280.0, 720.0), Vec2::new(1920.0, 1080.0), Vec2::new(700.0, 1000.0)] {
            let frame = Frame::of_window(pixels);
            let bar = HudLayout::new(&frame).fuel;
            assert!((bar.size - frame.size * Vec2::new(0.16, 0.025)).abs().max_element() < 1e-3);
            assert!(bar.min.x < 0.02 * frame.size.x);
            assert!(bar.max().y < frame.size.y && bar.min.y > frame.size.y * 0.9);
        }
    }

    #[test]
    fn the_fuel_bar_reddens_as_it_empties() {
        let (full, half, empty) = (fuel_colour(1.0), fuel_colour(0.5), fuel_colour(0.0));
        assert_eq!((full, empty), (FUEL_FULL, FUEL_EMPTY));
        assert!(full.g > half.g && half.g > empty.g);
    }
}
