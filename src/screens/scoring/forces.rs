//! The forces on the ship at one moment of its flight, tip to tail: their sum is the arrow of the game's title.

use super::{EDGE, Scoring};
use crate::view::scale::{self, ArrowKind};
use crate::{draw::Canvas, draw::Style, game::Game, game::SHIP, number::fixed, words::tr};
use crate::{draw::layout::DETAILS, draw::layout::Vec2, physics::DVec2, physics::ForceKind, view::camera::Viewport, view::theme};

/// The most room for the arrows, canvas units.
const ROOM: Vec2 = Vec2::new(120.0, 92.0);
/// From line to line of their names, and from name to name, canvas units.
const PITCH: f32 = 24.0;
const APART: f32 = 20.0;
/// The ring round the ship at that moment, canvas units.
const RING: f32 = 16.0;
/// Forces below this part of the resultant are left out, and no moment is shown whose resultant is below that part of its largest force.
const LEAST: f64 = 0.02;
const LEAST_SUM: f64 = 0.3;
/// The first arrow begins so long after the page has opened, s; and how long each takes.
const BEGIN: f64 = 0.5;
const STEP: f64 = 0.18;

#[derive(Debug)]
pub(super) struct ShipForces {
    /// On the clock, s.
    time: f64,
    /// The ship's centre, m.
    place: DVec2,
    /// N, y down.
    forces: Vec<(ForceKind, DVec2)>,
}

impl ShipForces {
    fn of(game: &Game) -> Self {
        let forces = game.world().forces(SHIP);
        let least = LEAST * forces.resultant().length();
        let felt = ForceKind::ALL.map(|kind| (kind, forces.total(kind))).into_iter().filter(|(_, force)| force.length() > least);
        Self { time: game.time(), place: game.world().body(SHIP).position, forces: felt.collect() }
    }

    fn sum(&self) -> DVec2 {
        self.forces.iter().map(|(_, force)| *force).sum()
    }

    /// How much there is to see: the newtons aside of the sum, for each force that takes part.
    fn worth(&self) -> f64 {
        let sum = self.sum();
        let largest = self.forces.iter().map(|(_, force)| force.length()).fold(0.0, f64::max);
        let aside: f64 = self.forces.iter().map(|(_, force)| force.perp_dot(sum.normalize_or_zero()).abs()).sum();
        if sum.length() > LEAST_SUM * largest { aside * self.forces.len() as f64 } else { 0.0 }
    }

    /// Puts the game's present moment in the place of the best one so far, where it shows more.
    pub fn note(best: &mut Option<Self>, game: &Game) {
        let now = Self::of(game);
        if now.worth() > best.as_ref().map_or(0.0, Self::worth) {
            *best = Some(now);
        }
    }

    /// By when all of it is there, s.
    pub fn whole(&self) -> f64 {
        BEGIN + STEP * (self.forces.len() + 2) as f64
    }
}

impl Scoring {
    /// The arrows one after the other in the corner `foot`, and their names in lines that end in the height of `foot`; a line leads to where it was.
    pub(super) fn draw_forces(&self, foot: Vec2, view: &Viewport, canvas: &Canvas) {
        let Some(moment) = self.moment.as_ref().filter(|_| self.paths.iter().all(|(_, track)| track.is_whole())) else { return };
        let sum = moment.sum();
        let mut corners = vec![DVec2::ZERO];
        corners.extend(moment.forces.iter().scan(DVec2::ZERO, |at, (_, force)| {
            *at += *force;
            Some(*at)
        }));
        let low = corners.iter().fold(DVec2::ZERO, |low, corner| low.min(*corner));
        let high = corners.iter().fold(DVec2::ZERO, |high, corner| high.max(*corner));
        let scale = (ROOM.as_dvec2() / (high - low)).min_element();
        let point = |corner: DVec2| foot - ((high - corner) * scale).as_vec2();
        let grown = |place: usize| ((self.shown - BEGIN - STEP * place as f64) / STEP).clamp(0.0, 1.0);
        let (place, ring) = (view.point(moment.place), theme::text().faded(0.6 * grown(0) as f32));
        let way = (point(DVec2::ZERO) - place).normalize_or_zero();
        canvas.ring(place, RING, 2.0, ring);
        canvas.dashed(&[place + way * RING, point(DVec2::ZERO) - way * RING], &[3.0, 5.0], 1.5, ring);
        let rows = moment.forces.iter().map(|(kind, force)| (ArrowKind::Force(*kind), *force, tr(kind.name())));
        let mut names = vec![(tr!("Forces at {time} s", time = fixed(moment.time, 2)), theme::quiet())];
        for (i, (shown, force, name)) in rows.chain([(ArrowKind::Resultant, sum, tr("Resultant"))]).enumerate() {
            let tail = if shown == ArrowKind::Resultant { DVec2::ZERO } else { corners[i] };
            if grown(i) > 0.0 {
                scale::draw_one(canvas, (point(tail), point(tail + force * grown(i))), shown, 1.0);
            }
            names.push((format!("{name} {} N", fixed(force.length(), 0)), scale::colour(shown).faded(grown(i) as f32)));
        }
        let style = Style::new(DETAILS, theme::quiet()).middle();
        let (mut at, right) = (Vec2::new(EDGE, 0.0), foot.x - ROOM.x - EDGE);
        let mut places = Vec::new();
        for (words, colour) in names {
            let width = canvas.width(&words, style);
            if at.x + width > right {
                at = Vec2::new(EDGE, at.y + PITCH);
            }
            places.push((words, at, colour));
            at.x += width + APART;
        }
        for (words, place, colour) in places {
            canvas.text(&words, Vec2::new(place.x, foot.y + place.y - at.y), Style { colour, ..style });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_moment_with_most_forces_aside_of_their_sum_is_shown() {
        let moment = |forces: &[(ForceKind, DVec2)]| ShipForces { time: 1.0, place: DVec2::ZERO, forces: forces.to_vec() };
        let weight = (ForceKind::Weight, DVec2::new(0.0, 1000.0));
        let up = moment(&[weight, (ForceKind::Drive, DVec2::new(0.0, -2000.0))]);
        let at_rest = moment(&[weight, (ForceKind::Reaction, -weight.1)]);
        let across = moment(&[weight, (ForceKind::Drive, DVec2::new(1000.0, -1500.0))]);
        assert_eq!((up.worth(), at_rest.worth()), (0.0, 0.0));
        assert!(across.worth() > 0.0 && across.sum() == DVec2::new(1000.0, -500.0));
    }
}
