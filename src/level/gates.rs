//! Warnings of doors that no body can open and of pads behind red, one-way blocks and winds. A doubtful route counts as possible: a body gets
//! anywhere in its own free space, and fragile blocks and movers are no obstacles.

use super::reach::{FreeSpace, grown, shared};
use super::types::{SHIP_HALF, SwitchStay};
use super::winnable::{Checked, TouchGoal};
use super::wiring::{SwitchesByName, Wire, Worked};
use super::{draft::Draft, numbers::MIN_SIZE, problem::Problem};
use crate::physics::{Aabb, DVec2, Sides};
use crate::words::tr;

/// The most one-way blocks and winds that are looked at.
const MOST_VALVES: usize = 32;
/// The most ways to hold the switches of a door that are tried.
const MOST_WAYS: usize = 1000;

pub(super) fn warn(level: &Checked) -> Vec<Problem> {
    let &Checked { draft, space, .. } = level;
    let valves = valves(level);
    if draft.switches.is_empty() && draft.doors.is_empty() && draft.obstacles.is_empty() && valves.is_empty() {
        return Vec::new();
    }
    let mut gates = Gates::new(level, valves);
    gates.play();
    let all = vec![true; draft.doors.len()];
    let off_red = gates.spaces([&all, &all], &[]);
    let past_doors = gates.spaces([&all, &all], &gates.shut);
    let held = gates.spaces([&gates.open, &gates.open], &gates.shut);
    let last = gates.spaces([&gates.passed, &gates.open], &gates.shut);
    let gets = |goal: &TouchGoal, spaces: [&FreeSpace; 2]| goal.gets(level, spaces) != [false; 2];
    // What keeps all from a goal, and what it takes instead.
    let barred = |goal: &TouchGoal| {
        let in_turn = [[space; 2], [&off_red[0], space], past_doors.each_ref()];
        let first = in_turn.into_iter().position(|spaces| !gets(goal, spaces));
        first.unwrap_or(if gets(goal, held.each_ref()) { 3 } else { 4 })
    };
    let expected = [
        tr("free space from the start of what works it"),
        tr("a route for the ship that keeps off the rows of obstacles.csv"),
        tr("a route to it along which nothing stops what comes from the start"),
        tr("a switch that stays on or lies beside its door, or something else that holds it"),
    ];
    let pressed = draft.switches.iter().enumerate().filter(|(index, _)| !gates.pressed[*index]);
    let switches = pressed.map(|(index, switch)| {
        let cause = barred(&TouchGoal::from(&switch.item));
        let found = [
            tr("a switch that nothing which works it gets to"),
            tr("a switch that the ship gets to through red alone"),
            tr("a switch behind a one-way block or a wind that lets nothing through"),
            tr("a switch behind a door that closes before the ship gets there"),
        ];
        if let (Some(found), Some(expected)) = (found.get(cause), expected.get(cause)) {
            return switch.problem("x", *found, *expected);
        }
        let own = (0..gates.open.len()).find(|&door| !gates.open[door] && gates.opens(index, door));
        let whose = own.map_or_else(
            || tr("a door that nothing opens").to_owned(),
            |door| tr!("its own door, line {line} of doors.csv", line = draft.doors[door].line),
        );
        let route = tr("a route to it that needs no closed door, or another switch for the door");
        switch.problem("x", tr!("a switch behind {whose}", whose), route)
    });
    let unmet = draft.objectives.iter().filter(|pad| !gets(&TouchGoal::from(&pad.item), last.each_ref()));
    let pads = unmet.map(|pad| {
        let cause = barred(&TouchGoal::from(&pad.item));
        let found = [
            tr("an objective that the ship cannot get to"),
            tr("an objective that the ship gets to through red alone"),
            tr("an objective behind a one-way block or a wind that lets nothing through"),
            tr("an objective behind a door that closes before the ship gets there"),
            tr("an objective behind a door that nothing opens"),
        ];
        let route = tr("a switch in reach for each door on the route, or a route around");
        pad.problem("x", found[cause], *expected.get(cause).unwrap_or(&route))
    });
    switches.chain(pads).collect()
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
    valves.truncate(MOST_VALVES);
    valves
}

/// How much narrower than its box the ship is for red at any angle, m: the square in the largest circle inside its body.
const NARROWER: f64 = SHIP_HALF.x - 0.45;

/// A level's gates, and what is known of them, from less to more.
struct Gates<'a> {
    level: &'a Checked<'a>,
    draft: &'a Draft,
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
    fn new(level: &'a Checked<'a>, valves: Vec<Valve>) -> Self {
        let draft = level.draft;
        let switches = SwitchesByName::new(draft.switches.iter().map(|switch| &switch.item));
        let doors = draft.doors.iter().enumerate();
        Self {
            level,
            draft,
            wires: doors.map(|(index, door)| switches.wire(door.item.name.as_deref()?, Worked::Door(index))).collect(),
            pressed: vec![false; draft.switches.len()],
            lasting: draft.switches.iter().map(|switch| switch.item.latch != SwitchStay::Held).collect(),
            open: Vec::new(),
            passed: Vec::new(),
            shut: vec![true; valves.len()],
            valves,
        }
    }

    /// Whether a door needs that switch, or another one of the same name, to be pressed.
    fn opens(&self, switch: usize, door: usize) -> bool {
        self.wires[door].as_ref().is_some_and(|wire| wire.by.iter().flatten().any(|by| *by == (switch, false)))
    }

    /// Where the ship gets, off red, and where objects get, each with its open doors.
    fn spaces(&self, open: [&[bool]; 2], shut: &[bool]) -> [FreeSpace; 2] {
        let closed = |ship: bool| {
            let doors = self.draft.doors.iter().zip(open[usize::from(!ship)]).filter(|(_, open)| !**open);
            let valves = self.valves.iter().zip(shut).filter(move |(valve, shut)| **shut && (ship || !valve.of_ship));
            doors.map(|(door, _)| door.item.bounds).chain(valves.map(|(valve, _)| valve.line))
        };
        let red = self.draft.obstacles.iter().map(|red| grown(&red.item, DVec2::splat(-NARROWER)));
        [self.level.space.with(closed(true).chain(red)), self.level.space.with(closed(false))]
    }

    /// From the switches in reach at the start, door after door.
    fn play(&mut self) {
        let draft = self.draft;
        let objects = draft.objects.iter().map(|object| (object.item.position, object.item.size * 0.5));
        // An object in its way keeps a door open.
        let room = |door: &Aabb| Some(beside(door)).filter(|_| !objects.clone().any(|body| self.level.space.gets_to(body, door)));
        let rooms: Vec<Option<Aabb>> = draft.doors.iter().map(|door| room(&door.item.bounds)).collect();
        let mut news = true;
        while news {
            let open = |(wire, room): (&Option<Wire>, &Option<Aabb>)| {
                wire.as_ref().is_some_and(|wire| self.together(&wire.by, *room, &mut MOST_WAYS.clone()))
            };
            let passed = self.wires.iter().zip(&rooms).map(open).collect();
            self.open = self.wires.iter().map(|wire| open((wire, &None))).collect();
            self.passed = passed;
            let [ships, others] = self.spaces([&self.passed, &self.open], &self.shut);
            news = false;
            for (index, switch) in draft.switches.iter().enumerate() {
                if self.lasting[index] && self.pressed[index] {
                    continue;
                }
                let [by_ship, by_others] = TouchGoal::from(&switch.item).gets(self.level, [&ships, &others]);
                news |= (by_ship || by_others) && !self.pressed[index] || by_others && !self.lasting[index];
                self.pressed[index] |= by_ship || by_others;
                self.lasting[index] |= by_others;
            }
            for (valve, shut) in self.valves.iter().zip(&mut self.shut).filter(|(_, shut)| **shut) {
                let past = |body| !valve.of_ship && others.gets_to(body, &valve.behind);
                *shut = !ships.gets_to(self.level.ship_box(), &valve.behind) && !objects.clone().any(past);
                news |= !*shut;
            }
        }
    }

    /// Whether switches of all names can be on at once, with the ship in a `room`, where it alone holds some of them. One behind a `!` is on
    /// until it is pressed.
    fn together(&self, names: &[Vec<(usize, bool)>], room: Option<Aabb>, ways: &mut usize) -> bool {
        let (Some((first, rest)), Some(left)) = (names.split_first(), ways.checked_sub(1)) else { return true };
        *ways = left;
        first.iter().any(|&(switch, inverted)| {
            if inverted || self.pressed[switch] && self.lasting[switch] {
                return self.together(rest, room, ways);
            }
            let near = beside(&self.draft.switches[switch].item.bounds);
            let both = room.map_or(near, |room| shared(&room, &near));
            self.pressed[switch] && both.min.cmple(both.max).all() && self.together(rest, Some(both), ways)
        })
    }
}

/// Where the ship's centre is beside a box, with its own width to spare, for what it does in a tick.
fn beside(bounds: &Aabb) -> Aabb {
    grown(bounds, 2.0 * SHIP_HALF)
}
