//! The rule of each method by hand in one line, and a sentence on what it uses, for learners.

/// The name of a method, its rule, and what it uses. A name that ends in … stands for all that begin so.
const RULES: [(&str, &str, &str); 34] = [
    (
        "explicit Euler",
        "x′ = x + h·v, v′ = v + h·a(x, v)",
        "It uses what holds at the start of the step for all of it, and gains energy.",
    ),
    (
        "semi-implicit Euler",
        "v′ = v + h·a(x, v), x′ = x + h·v′",
        "It moves by the new velocity: the energy swings about the right one.",
    ),
    (
        "velocity Verlet",
        "x′ = x + h·v + ½h²·a, v′ = v + ½h·(a + a′)",
        "It uses the mean of the accelerations at both ends; the energy swings, and less.",
    ),
    ("midpoint", "x′ = x + h·v½, v′ = v + h·a½", "It goes half a step by Euler and uses what holds there for all of the step."),
    ("Heun", "y′ = y + ½h·(f(y) + f(y + h·f(y)))", "It uses the mean of the rates at the start and where Euler would end."),
    ("RK4", "y′ = y + h/6·(k₁ + 2k₂ + 2k₃ + k₄)", "It uses four rates: at the start, twice in the middle, and at the end."),
    (
        "Yoshida 4",
        "Verlet by w₁h, w₀h and w₁h: w₁ = 1/(2 − 2^⅓), w₀ = 1 − 2w₁",
        "It takes three steps of second order, the middle one backwards: errors cancel.",
    ),
    (
        "implicit Euler",
        "v′ = v + h·a(x′, v′), x′ = x + h·v′",
        "It uses what holds at the end of the step, and has to solve for it.",
    ),
    ("implicit midpoint", "y′ = y + h·f(½y + ½y′)", "It uses what holds halfway to its own end, and has to solve for that."),
    ("trapezoid", "y′ = y + ½h·(f(y) + f(y′))", "It uses the mean of the rates at both ends, and has to solve for the later."),
    (
        "adaptive 3(2)…",
        "y′ = y + h·(2k₁ + 3k₂ + 4k₃)/9",
        "It compares two results, and cuts the step where they are too far apart.",
    ),
    (
        "linearised drag",
        "v′ = (v + h·(a + m·w))/(1 + m·h), m = k·|u|",
        "It takes drag as linear, and by the velocity at the end of the step.",
    ),
    (
        "exact drag (Lie)",
        "u′ = (u + h·a)/(1 + k·|u + h·a|·h)",
        "It uses forces alone for a step, then the exact law of drag alone.",
    ),
    (
        "Strang",
        "½h of forces, h of exact drag, ½h of forces",
        "It uses half of the forces before the exact drag and half after it.",
    ),
    ("exact flow", "the formula of the motion at t + h", "It uses the solution on paper: the step does not matter."),
    (
        "shipped engine",
        "the exact motion up to the next event, then on",
        "It uses formulas where there are some, and cuts a tick at each event.",
    ),
    (
        "snap to the floor",
        "v′ = v − h·g; below the floor: y = 0, v = −e·v",
        "It sees the floor after the step, and has gained height by then.",
    ),
    (
        "reflect",
        "v′ = v − h·g; below the floor: y = −e·y, v = −e·v",
        "It mirrors the step that went too deep, as if the speed had stayed.",
    ),
    (
        "Verlet and snap",
        "y′ = y + h·v − ½h²·g; below the floor: y = 0",
        "It flies the exact parabola, but sees the floor only after the step.",
    ),
    (
        "restitution every tick",
        "v′ = v − h·g; at the floor: v = −e·v",
        "It bounces in each tick of contact, also where the ball should rest.",
    ),
    (
        "swept, rest of tick lost",
        "to the impact at τ, bounce, and stop there",
        "It finds the time of impact, and leaves out what remains of the tick.",
    ),
    (
        "exact time of impact",
        "to the impact at τ, bounce, then h − τ",
        "It solves for the time of impact, and goes on with the rest of the tick.",
    ),
    ("exact times of impact…", "the first impact, bounce, the next, …", "It takes all impacts of a tick in their order."),
    (
        "overlap at tick ends",
        "x′ = x + h·v; those that overlap bounce",
        "It looks only after the step: what is fast passes through.",
    ),
    (
        "all contacts at once",
        "one solution for all that touch",
        "It solves touching pairs together, and so spreads an impact over all.",
    ),
    ("friction by sign", "v′ = v − h·μg·sign(v)", "It brakes by a full step also where less would do, and chatters."),
    (
        "friction clamped",
        "v′ = v − min(|v|, h·μg)·sign(v)",
        "It takes at most the whole velocity, and stops up to half a step short.",
    ),
    ("exact stop", "x′ = x + v²/(2μg) where v stops within h", "It uses the parabola up to the moment of the stop."),
    (
        "impulses, …",
        "for each contact in turn: j = max(0, j − v/w)",
        "It corrects contact by contact: a tall or heavy pile needs many sweeps.",
    ),
    (
        "soft contacts, …",
        "j = s·(j − (v + r·d)/w) where d < 0, move, then once with r = 0",
        "A damped spring takes overlaps back, and a second sweep the speed that it gave.",
    ),
    (
        "XPBD, …",
        "x′ = x + h·v, moved out of each other, v′ = (x′ − x)/h",
        "It moves bodies out of each other, and takes the way for the velocity.",
    ),
    (
        "speculative contacts",
        "v ≤ gap/h in each pair, move by h, then bounce",
        "It slows down what would pass through, so that it just touches after the step.",
    ),
    ("direct", "the loads of all contacts in one solution", "It solves all contacts of a row together."),
    (
        "time steps, N = …",
        "overlap at tick ends, with steps of 10 to the −N",
        "It steps through time and misses impacts that lie between.",
    ),
];

const PRAXIS: &str = "E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.3";

/// Where methods hold and where they fail, and a source. Names as above.
const LIMITS: [(&str, &str, &str); 8] = [
    (
        "Yoshida 4",
        "Holds: orbits and swings for ever, up to ω·h = 1.57. Fails: in fast drag, which drives while time runs backwards.",
        "H. Yoshida, Physics Letters A 150 (1990)",
    ),
    ("implicit Euler", "Holds: the stiffest spring and damper, at any step. Fails: swings fade that should last.", PRAXIS),
    (
        "implicit midpoint",
        "Holds: swings keep their height at any step. Fails: what is stiff changes its sign each step and hardly fades.",
        PRAXIS,
    ),
    ("trapezoid", "Holds: never grows, at any step. Fails: what is stiff changes its sign each step and hardly fades.", PRAXIS),
    (
        "impulses, …",
        "Holds: low piles of equal bodies, once warm. Fails: tall columns and heavy on light; from cold they sink in each step.",
        "E. Catto, Iterative Dynamics with Temporal Coherence (2005)",
    ),
    (
        "soft contacts, …",
        "Holds: columns and towers stand, with few sweeps. Fails: they stand sunk in, and what is heavy crushes what is light.",
        "E. Catto, Solver2D (2024)",
    ),
    (
        "XPBD, …",
        "Holds: columns and unequal masses, in small parts of a step. Fails: friction creeps, and no bounce comes by itself.",
        "M. Macklin et al., XPBD (2016), Small Steps (2019)",
    ),
    (
        "speculative contacts",
        "Holds: nothing passes through, at any speed. Fails: a bounce is late, and a row that is hit flies off together.",
        "E. Catto, Continuous Collision (2013)",
    ),
];

/// The rule of a method and the sentence; `None` for engines of others.
pub fn of(method: &str) -> Option<(&'static str, &'static str)> {
    find(&RULES, method)
}

/// Where it holds and fails, and the source.
pub fn limits(method: &str) -> Option<(&'static str, &'static str)> {
    find(&LIMITS, method)
}

fn find(table: &[(&str, &'static str, &'static str)], method: &str) -> Option<(&'static str, &'static str)> {
    let is = |name: &str| name.strip_suffix('…').map_or(name == method, |begins| method.starts_with(begins));
    table.iter().find(|(name, ..)| is(name)).map(|(_, first, second)| (*first, *second))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::{scenes, side_by_side, stability};

    #[test]
    fn each_method_has_its_rule_and_each_rule_its_method() {
        let mut names: Vec<String> = stability::regions().iter().map(|region| region.name.to_owned()).collect();
        names.extend(scenes::all().iter().flat_map(|scene| scene.methods.iter().map(|method| method.name.clone())));
        names
            .extend(side_by_side::exhibits().iter().flat_map(|exhibit| exhibit.methods.iter().map(|(name, _)| (*name).to_owned())));
        for name in &names {
            assert!(of(name).is_some(), "{name}");
        }
        for (name, ..) in RULES.iter().chain(&LIMITS) {
            let begins = name.trim_end_matches('…');
            assert!(names.iter().any(|known| known.starts_with(begins)), "{name}");
        }
    }
}
