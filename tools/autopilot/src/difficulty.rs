//! How difficult a level is: the share of flights that succeed when the careful plan is flown as a person would, who sees late, judges
//! places wrongly and presses keys early or late.

use crate::flight::Aim;
use crate::judgement::Judgement;
use crate::make::{Options, write};
use crate::pilot::Autopilot;
use crate::plan::FlightPlan;
use crate::sight::Sight;
use crate::{plan_file, plan_of};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use resultant::game::{Controls, Game, Outcome};
use resultant::level::Level;
use std::collections::VecDeque;
use std::sync::Arc;

/// Flights, each with a seed of its own, from 1 on.
const FLIGHTS: u64 = 50;
/// The seeds by which plans are tuned: others.
const TUNED: std::ops::Range<u64> = 1001..1025;
/// The plan that is flown, where there is one; else the careful one.
const PERSON: &str = "person";
/// The longest flight by the level's optimal time: later than that the score does not fall any more.
const AT_LEISURE: f64 = 2.0;
/// From what happens to the pilot's seeing it, s: a person's time to react.
const DELAY: f64 = 0.2;
/// By how much places are misjudged, pixels: a third of the ship, most by less.
const SPREAD: f64 = 18.0;
/// By how much speeds are misjudged, a share of themselves.
const MISJUDGED: f64 = 0.05;
/// The most by which a key is pressed or let go of late, ticks: 50 ms.
const LATEST: u32 = 6;

/// Flies a level and prints how often that went well, and in which steps of the plan it did not.
pub fn measure(level: &Arc<Level>, options: &Options) -> Result<(), String> {
    let mut plan = plan_of(&level.name, PERSON).or_else(|_| plan_of(&level.name, Aim::Careful.name()))?;
    let longest = AT_LEISURE * level.optimal_time;
    if let Some(trials) = options.trials {
        let keep =
            |plan: &FlightPlan| if options.keep { write(&plan_file(&level.name, PERSON), &plan.to_string()) } else { Ok(()) };
        plan = steadier(level, plan, (trials, options.seed), keep)?;
    }
    if options.trace {
        fly(level, &plan, options.seed, longest, crate::make::trace_line);
    }
    let ends: Vec<End> = (1..=FLIGHTS).map(|seed| fly(level, &plan, seed, longest, |_, _, _| ())).collect();
    let count = |wanted: Outcome| ends.iter().filter(|end| end.outcome == wanted).count();
    let done = count(Outcome::Completed);
    let clean = ends.iter().filter(|end| end.outcome == Outcome::Completed && end.hits == 0).count();
    let time = ends.iter().filter(|end| end.outcome == Outcome::Completed).map(|end| end.time).sum::<f64>() / done.max(1) as f64;
    let mut steps = std::collections::BTreeMap::<(usize, &str), Vec<u64>>::new();
    for (seed, end) in (1..).zip(&ends).filter(|(_, end)| end.outcome != Outcome::Completed) {
        steps.entry((end.step + 1, end.outcome.name())).or_default().push(seed);
    }
    let steps: Vec<String> = steps.iter().map(|((step, outcome), seeds)| format!("{step} {outcome} {seeds:?}")).collect();
    println!(
        "{}: {} % succeed ({done} of {FLIGHTS}, {clean} without a damaging hit, in {time:.0} s of {longest} s; {} lost, {} came to no end): {}",
        level.name,
        100 * done as u64 / FLIGHTS,
        count(Outcome::Failed),
        count(Outcome::Running),
        steps.join(", "),
    );
    Ok(())
}

/// A plan that forgives more, of `trials` variations from a seed: more of other unsteady flights succeed by it, and sooner.
fn steadier(
    level: &Arc<Level>,
    plan: FlightPlan,
    (trials, seed): (u32, u64),
    keep: impl Fn(&FlightPlan) -> Result<(), String>,
) -> Result<FlightPlan, String> {
    let mut random = Pcg32::seed_from_u64(seed);
    let longest = AT_LEISURE * level.optimal_time;
    let worth = |plan: &FlightPlan| -> f64 {
        let ends = TUNED.map(|seed| fly(level, plan, seed, longest, |_, _, _| ()));
        let worth = |end: End| match end.outcome {
            Outcome::Completed => 1.0 - 0.1 * end.time / longest,
            _ => 0.3 * end.step as f64 / plan.steps.len() as f64,
        };
        ends.map(worth).sum()
    };
    let mut best = (worth(&plan), plan);
    for trial in 0..trials {
        let plan = best.1.varied(&mut random);
        let worth = worth(&plan);
        if worth > best.0 {
            eprintln!("trial {trial}: {worth:.2} of {}", TUNED.end - TUNED.start);
            keep(&plan)?;
            best = (worth, plan);
        }
    }
    Ok(best.1)
}

/// How a flight ended.
struct End {
    outcome: Outcome,
    hits: u32,
    time: f64,
    /// Of the plan.
    step: usize,
}

/// One unsteady flight.
fn fly(level: &Arc<Level>, plan: &FlightPlan, seed: u64, longest: f64, mut each: impl FnMut(&Game, usize, Controls)) -> End {
    let mut random = Pcg32::seed_from_u64(seed);
    let mut game = crate::flight::new_game(level);
    let mut eyes = Eyes { seen: game.clone(), pressed: VecDeque::new(), wanted: VecDeque::new() };
    let mut pilot = Autopilot::new(plan, &Sight::of(&game)).with(Judgement::new(SPREAD / level.metre, MISJUDGED, random.clone()));
    let mut hands = Hands::default();
    while game.outcome() == Outcome::Running && game.elapsed() < longest && !game.is_stranded() {
        if pilot.is_due() {
            pilot.look(&Sight::of(&eyes.imagine()));
        }
        let wanted = pilot.press();
        let pressed = hands.press(wanted, &mut random);
        game.step(pressed);
        eyes.follow(pressed, wanted);
        each(&game, pilot.step(), pressed);
    }
    End { outcome: game.outcome(), hits: game.collisions(), time: game.time(), step: pilot.step() }
}

/// A person's eyes, which see the game late, and what is imagined of it since.
struct Eyes {
    /// The game as it was [`DELAY`] ago.
    seen: Game,
    /// The keys since then, as they were pressed and as they were meant.
    pressed: VecDeque<Controls>,
    wanted: VecDeque<Controls>,
}

impl Eyes {
    fn follow(&mut self, pressed: Controls, wanted: Controls) {
        self.pressed.push_back(pressed);
        self.wanted.push_back(wanted);
        if self.pressed.len() as f64 > DELAY * self.seen.tick_rate() {
            self.wanted.pop_front();
            self.pressed.pop_front().into_iter().for_each(|keys| self.seen.step(keys));
        }
    }

    /// The present, as one takes it to be who saw what was, and believes to have pressed what was meant.
    fn imagine(&self) -> Game {
        let mut game = self.seen.clone();
        self.wanted.iter().for_each(|keys| game.step(*keys));
        game
    }
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
