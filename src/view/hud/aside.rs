//! The parts of the head-up display step aside for the ship, hazards, goals and keys: a part that would hide one of them fades, and
//! the fuel bar sinks to a thin line at the window's edge.

use crate::draw::layout::{Area, Frame, GRID};
use crate::view::hud::HudLayout;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HudPart {
    /// Time, objectives and speed, at the top left.
    Status,
    /// The fuel bar, at the bottom centre.
    Fuel,
    /// The strip with the medal and the ghosts of a race, beside the status.
    Race,
}

impl HudPart {
    pub const ALL: [Self; 3] = [Self::Status, Self::Fuel, Self::Race];
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HudShown {
    /// Time, objectives and speed.
    pub status: bool,
    /// The fuel bar.
    pub fuel: bool,
    /// The number of ghosts in the race.
    pub rivals: usize,
    /// The medal that is still within reach.
    pub medal: bool,
}

/// A part steps aside for an object nearer than this, canvas units.
const NEAR: f32 = GRID;
/// Duration of a part's step aside, s.
const TIME: f32 = 0.16;
/// Height of the line that remains of the fuel bar, canvas units.
const LINE: f32 = 4.0;

#[derive(Clone, Debug, Default)]
pub struct Aside {
    homes: [Option<Area>; 3],
    /// Columns of the strip.
    columns: usize,
    shows_medal: bool,
    /// 0 at home … 1 aside.
    parts: [f32; 3],
}

impl Aside {
    /// Advances by `frame_time` seconds, with the drawn places of the ship (its speed in canvas units a second) and of everything
    /// else that may not be hidden.
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

    /// The place of the medal in the strip.
    pub fn medal(&self) -> Option<Area> {
        self.column(0, self.columns).filter(|_| self.shows_medal)
    }

    /// The place of the column `index` among the last `of` of the strip.
    pub fn column(&self, index: usize, of: usize) -> Option<Area> {
        let strip = self.home(HudPart::Race).filter(|_| of <= self.columns)?;
        let width = strip.size.x / self.columns as f32;
        Some(Area::new(strip.min.x + (self.columns - of + index) as f32 * width, strip.min.y, width, strip.size.y))
    }

    /// The undisturbed place of every part that is shown.
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
        let line = Area::new(home.min.x, frame.size.y - LINE, home.size.x, LINE);
        Some(Area { min: home.min.lerp(line.min, aside), size: home.size.lerp(line.size, aside) })
    }
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
        assert_eq!(HudPart::ALL.map(|part| aside.of(part)), [0.0; 3]);
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
        assert_eq!(HudPart::ALL.map(|part| aside.of(part)), [1.0, 0.0, 1.0]);
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
