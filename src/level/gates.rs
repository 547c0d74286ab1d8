//! Warnings of switches and objectives behind red, one-way blocks, winds and doors. A doubtful route counts as possible: a body gets anywhere in
//! its own free space, and fragile blocks and movers are no obstacles.

use super::reach::{FreeSpace, grown};
use super::types::{SHIP_HALF, SwitchStay};
use super::winnable::{Checked, TouchGoal};
use super::wiring::{SwitchesByName, Wire, Worked};
use super::{numbers::MIN_SIZE, problem::Problem, schema::typed::FromRow};
use crate::physics::{Aabb, DVec2, Sides};
use crate::words::tr;

/// Of obstacles, as in [`Gates::spaces`].
const KINDS: usize = 4;

pub(super) fn warn(level: &Checked) -> Vec<Problem> {
    let mut gates = Gates::new(level);
    let draft = level.draft;
    if draft.switches.is_empty() && draft.doors.is_empty() && draft.obstacles.is_empty() && gates.valves.is_empty() {
        return Vec::new();
    }
    gates.play();
    let in_turn: [_; KINDS + 1] = std::array::from_fn(|kinds| gates.spaces(kinds));
    // Three for each kind of obstacles and for rock before them: what is found of a switch and of an objective, and what is expected.
    let words = |barred: usize, which: usize| {
        tr([
            "a switch that nothing which works it gets to",
            "an objective that the ship cannot get to",
            "free space from the start of what works it",
            "a switch that the ship gets to through red alone",
            "an objective that the ship gets to through red alone",
            "a route for the ship that keeps off the rows of obstacles.csv",
            "a switch behind a one-way block or a wind that lets nothing through",
            "an objective behind a one-way block or a wind that lets nothing through",
            "a route to it along which nothing stops what comes from the start",
            "a switch behind a door that nothing opens",
            "an objective behind a door that nothing opens",
            "a switch in reach for each door on the route, or a route around",
            "a switch behind a door that closes before the ship gets there",
            "an objective behind a door that closes before the ship gets there",
            "a switch that stays on or lies beside its door, or something else that holds it",
        ][3 * barred + which])
    };
    let switches = draft.switches.iter().zip(&gates.pressed).filter(|(_, pressed)| !**pressed);
    let switches = switches.map(|(switch, _)| (switch.map(TouchGoal::of_switch), 0));
    let goals = switches.chain(draft.objectives.iter().map(|pad| (pad.map(TouchGoal::of_pad), 1)));
    let warning = |(goal, which): (FromRow<TouchGoal>, usize)| {
        let barred = in_turn.iter().position(|spaces| goal.item.gets(level, spaces.each_ref()) == [false; 2])?;
        Some(goal.problem("x", words(barred, which), words(barred, 2)))
    };
    goals.filter_map(warning).collect()
}

/// A line that lets bodies through to one side alone.
struct Valve {
    line: Aabb,
    /// Right behind it, where only what may pass it can be.
    behind: Aabb,
    of_ship: bool,
}

impl Valve {
    /// Nothing gets through `area` further than `deep` metres towards `side`, 1 or −1, along an axis.
    fn new(area: &Aabb, axis: usize, side: f64, deep: f64, of_ship: bool) -> Self {
        let from = if side > 0.0 { area.min[axis] + deep } else { area.max[axis] - deep };
        let strip = |near: f64| {
            let ends = [near, near + 1.0].map(|at| from + side * at * MIN_SIZE);
            let mut strip = *area;
            (strip.min[axis], strip.max[axis]) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            strip
        };
        Self { line: strip(0.0), behind: strip(2.0), of_ship }
    }
}

/// Of one-way blocks, and of streams and fields that outdo the ship, as deep in them as it can get.
fn valves(level: &Checked) -> Vec<Valve> {
    let mut valves = Vec::new();
    let blocks = level.draft.world.iter().map(|block| &block.item);
    for block in blocks.filter(|block| block.breaks.is_none() && block.sides != Sides::ALL) {
        let Sides { left, right, top, bottom } = block.sides;
        let ends = [(left, 0, 1.0), (right, 0, -1.0), (top, 1, 1.0), (bottom, 1, -1.0)].into_iter().filter(|(solid, ..)| *solid);
        valves.extend(ends.map(|(_, axis, side)| Valve::new(&block.bounds, axis, side, 0.0, false)));
    }
    for (area, force, _) in level.zones().filter(|(.., switched)| !switched) {
        for (axis, along) in [DVec2::X, DVec2::Y].into_iter().enumerate().filter(|(axis, _)| force[*axis] != 0.0) {
            let against = -force[axis].signum();
            let Some(energy) = level.run(along * against) else { continue };
            let deep = energy / force[axis].abs();
            if deep + 3.0 * MIN_SIZE < area.size()[axis] {
                valves.push(Valve::new(&area, axis, against, deep, true));
            }
        }
    }
    valves
}

/// How much narrower than its box the ship is for red at any angle, m: the square in the largest circle inside its body.
const NARROWER: f64 = SHIP_HALF.x - 0.45;

/// A level's gates, and what is known of them, from less to more.
struct Gates<'a> {
    level: &'a Checked<'a>,
    /// Of each door.
    wires: Vec<Option<Wire>>,
    valves: Vec<Valve>,
    /// The switches that are pressed at some time.
    pressed: Vec<bool>,
    /// Those that something presses which can stay there, or with effect for ever.
    lasting: Vec<bool>,
    /// The doors that are open at some time.
    open: Vec<bool>,
    /// Those that are open while the ship goes through.
    passed: Vec<bool>,
    /// Of each valve, whether nothing has got behind it.
    shut: Vec<bool>,
}

impl<'a> Gates<'a> {
    fn new(level: &'a Checked<'a>) -> Self {
        let draft = level.draft;
        let switches = SwitchesByName::new(draft.switches.iter().map(|switch| &switch.item));
        let doors = draft.doors.iter().enumerate();
        let valves = valves(level);
        Self {
            level,
            wires: doors.map(|(index, door)| switches.wire(door.item.name.as_deref()?, Worked::Door(index))).collect(),
            pressed: vec![false; draft.switches.len()],
            lasting: draft.switches.iter().map(|switch| switch.item.latch != SwitchStay::Held).collect(),
            open: Vec::new(),
            passed: Vec::new(),
            shut: vec![true; valves.len()],
            valves,
        }
    }

    /// Where the ship gets and where objects get, kept off by the first kinds of obstacles: red, valves, doors that nothing opens, and doors
    /// that are closed when the ship comes.
    fn spaces(&self, kinds: usize) -> [FreeSpace; 2] {
        let Checked { draft, space, .. } = self.level;
        [true, false].map(|ship| {
            let red = draft.obstacles.iter().filter(|_| ship && kinds > 0);
            let valves = self.valves.iter().zip(&self.shut).filter(|(valve, shut)| kinds > 1 && **shut && (ship || !valve.of_ship));
            let open = if ship && kinds == KINDS { &self.passed } else { &self.open };
            let doors = draft.doors.iter().zip(open).filter(|(_, open)| kinds > 2 && !**open);
            let red = red.map(|red| grown(&red.item, DVec2::splat(-NARROWER)));
            space.with(red.chain(valves.map(|(valve, _)| valve.line)).chain(doors.map(|(door, _)| door.item.bounds)))
        })
    }

    /// From the switches in reach at the start, door after door.
    fn play(&mut self) {
        let Checked { draft, space, .. } = *self.level;
        let objects = draft.objects.iter().map(|object| (object.item.position, object.item.size * 0.5));
        // An object in its way keeps a door open.
        let jammed: Vec<bool> =
            draft.doors.iter().map(|door| objects.clone().any(|body| space.gets_to(body, &door.item.bounds))).collect();
        loop {
            let before = [self.pressed.clone(), self.lasting.clone(), self.shut.clone()];
            self.open = (0..jammed.len()).map(|door| self.opens(door, true)).collect();
            self.passed = (0..jammed.len()).map(|door| self.opens(door, jammed[door])).collect();
            let [ships, others] = self.spaces(KINDS);
            for (index, switch) in draft.switches.iter().enumerate() {
                let [by_ship, by_others] = TouchGoal::of_switch(&switch.item).gets(self.level, [&ships, &others]);
                self.pressed[index] |= by_ship || by_others;
                self.lasting[index] |= by_others;
            }
            for (valve, shut) in self.valves.iter().zip(&mut self.shut) {
                let past = |body| !valve.of_ship && others.gets_to(body, &valve.behind);
                *shut &= !ships.gets_to(self.level.ship_box(), &valve.behind) && !objects.clone().any(past);
            }
            if before == [&self.pressed, &self.lasting, &self.shut].map(Vec::clone) {
                return;
            }
        }
    }

    /// Whether a switch of each of its names turns a door on: one behind a `!` until it is pressed, one that the ship alone holds down, with the
    /// ship beside the door, or `anywhere`.
    fn opens(&self, door: usize, anywhere: bool) -> bool {
        let draft = self.level.draft;
        // Where the ship's centre is beside a box, with its own width to spare, for what it does in a tick.
        let beside = |bounds: &Aabb| grown(bounds, 2.0 * SHIP_HALF);
        let near =
            |switch: usize| beside(&draft.doors[door].item.bounds).touches(&beside(&draft.switches[switch].item.bounds), 0.0);
        let on = |&(switch, inverted): &(usize, bool)| {
            inverted || self.pressed[switch] && (anywhere || self.lasting[switch] || near(switch))
        };
        self.wires[door].as_ref().is_some_and(|wire| wire.by.iter().all(|by| by.iter().any(on)))
    }
}
