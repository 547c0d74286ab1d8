//! How difficult a level is: the share of flights that succeed when the careful plan is flown as a person would, who sees late, judges
//! places wrongly and presses keys early or late.

use crate::flight::{Aim, LONGEST};
use crate::pilot::Pilot;
use crate::plan::Plan;
use crate::plan_of;
use crate::sight::Sight;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use resultant::game::{Controls, Game, Outcome};
use resultant::level::Level;
use std::collections::VecDeque;
use std::sync::Arc;

/// Flights, each with a seed of its own, from 1 on.
const FLIGHTS: u64 = 50;
/// From what happens to the pilot's seeing it, s: a person's time to react.
const DELAY: f64 = 0.2;
/// By how much places are misjudged, pixels: a fifth of the ship.
const SPREAD: f64 = 10.0;
/// The most by which a key is pressed or let go of late, ticks: 33 ms.
const LATEST: u32 = 4;

/// Flies a level and prints how often that went well.
pub fn measure(level: &Arc<Level>) -> Result<(), String> {
    let plan = plan_of(&level.name, Aim::Careful)?;
    let longest = (2.0 * plan.settings.par).min(LONGEST);
    let ends: Vec<(Outcome, u32)> = (1..=FLIGHTS).map(|seed| fly(level, &plan, seed, longest)).collect();
    let count = |wanted: Outcome| ends.iter().filter(|(outcome, _)| *outcome == wanted).count();
    let done = count(Outcome::Completed);
    let clean = ends.iter().filter(|(outcome, hits)| *outcome == Outcome::Completed && *hits == 0).count();
    println!(
        "{}: {} % succeed ({done} of {FLIGHTS}, {clean} without a damaging hit; {} lost, {} came to no end)",
        level.name,
        100 * done as u64 / FLIGHTS,
        count(Outcome::Failed),
        count(Outcome::Running),
    );
    Ok(())
}

/// The share of the flights with these seeds that complete the level without a damaging hit within `longest` seconds.
pub fn share(level: &Arc<Level>, plan: &Plan, seeds: std::ops::Range<u64>, longest: f64) -> f64 {
    let all = seeds.clone().count();
    seeds.filter(|seed| fly(level, plan, *seed, longest) == (Outcome::Completed, 0)).count() as f64 / all as f64
}

/// One unsteady flight: how it ended, and with how many damaging hits.
fn fly(level: &Arc<Level>, plan: &Plan, seed: u64, longest: f64) -> (Outcome, u32) {
    let mut random = Pcg32::seed_from_u64(seed);
    let plan = plan.misjudged(SPREAD, &mut random);
    let Ok(mut game) = Game::new(Arc::clone(level)) else { return (Outcome::Failed, 0) };
    let mut seen = VecDeque::from([game.clone()]);
    let mut pilot = Pilot::new(&plan, &Sight::clear(&game));
    let mut hands = Hands::default();
    let late = (DELAY * game.tick_rate()) as usize;
    while game.outcome() == Outcome::Running && game.time() < longest {
        let wanted = pilot.keys(&Sight::late(&seen[0], &game));
        game.step(hands.press(wanted, &mut random));
        seen.push_back(game.clone());
        if seen.len() > late {
            seen.pop_front();
        }
    }
    (game.outcome(), game.collisions())
}

/// Keys as they are held, each a little behind what is wanted.
#[derive(Default)]
struct Hands {
    held: [bool; 4],
    /// Ticks until each follows.
    left: [u32; 4],
}

impl Hands {
    fn press(&mut self, wanted: Controls, random: &mut Pcg32) -> Controls {
        let wanted = [wanted.thrust, wanted.reverse, wanted.left, wanted.right];
        for ((held, left), wanted) in self.held.iter_mut().zip(&mut self.left).zip(wanted) {
            if *left > 0 {
                *left -= 1;
                if *left == 0 {
                    *held = wanted;
                }
            } else if *held != wanted {
                *left = random.random_range(0..=LATEST);
                if *left == 0 {
                    *held = wanted;
                }
            }
        }
        let [thrust, reverse, left, right] = self.held;
        Controls { thrust, reverse, left, right }
    }
}
