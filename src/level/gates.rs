//! Warnings of doors that no body can open and of pads behind red, one-way blocks and winds. A doubtful route counts as possible: a body gets
//! anywhere in its own free space, and fragile blocks and movers are no obstacles.

use super::certain::{Bounds, Zone};
use super::draft::Draft;
use super::numbers::MIN_SIZE;
use super::problem::Problem;
use super::reach::{CentredBox, FreeSpace};
use super::types::{ObjectiveKind, Presser, SHIP_HALF, ShipStart, Switch, SwitchStay};
use super::winnable::fitting;
use super::wiring::{SwitchesByName, Wire, Worked};
use crate::physics::{Aabb, DVec2, Sides};
use crate::words::tr;

/// The most one-way blocks and winds that are looked at.
const MOST_VALVES: usize = 32;
/// The most ways to hold the switches of a door that are tried.
const MOST_WAYS: usize = 1000;

pub(super) fn warn_of_gates(draft: &Draft, player: &ShipStart, space: &FreeSpace, size: DVec2) -> Vec<Problem> {
    let valves = valves(draft, &Bounds { draft, ship: player, size });
    if draft.switches.is_empty() && draft.doors.is_empty() && draft.obstacles.is_empty() && valves.is_empty() {
        return Vec::new();
    }
    let ship = (player.position, SHIP_HALF);
    let gates = Gates::new(draft, space, valves);
    let end = gates.play(ship);
    let off_red = gates.spaces(&GateState::all_open(draft));
    let past_doors = gates.spaces(&GateState { shut: end.shut.clone(), ..GateState::all_open(draft) });
    let held = gates.spaces(&GateState { passed: end.open.clone(), ..end.clone() });
    let last = gates.spaces(&end);
    let red_alone = tr("a route for the ship that keeps off the rows of obstacles.csv");
    let around = tr("a route to it along which nothing stops what comes from the start");
    let stays = tr("a switch that stays on or lies beside its door, or something else that holds it");
    let mut warnings = Vec::new();
    for (index, switch) in draft.switches.iter().enumerate().filter(|(index, _)| !end.pressed[*index]) {
        let pressed = |(ships, objects)| presses(draft, &switch.item, ship, (ships, objects)) != [false; 2];
        let (found, expected) = if !pressed((space, space)) {
            (tr("a switch that nothing which works it gets to").to_owned(), tr("free space from the start of what works it"))
        } else if !pressed((&off_red.0, space)) {
            (tr("a switch that the ship gets to through red alone").to_owned(), red_alone)
        } else if !pressed((&past_doors.0, &past_doors.1)) {
            (tr("a switch behind a one-way block or a wind that lets nothing through").to_owned(), around)
        } else if pressed((&held.0, &held.1)) {
            (tr("a switch behind a door that closes before the ship gets there").to_owned(), stays)
        } else {
            let own = (0..end.open.len()).find(|&door| !end.open[door] && gates.opens(index, door));
            let whose = own.map_or_else(
                || tr("a door that nothing opens").to_owned(),
                |door| tr!("its own door, line {line} of doors.csv", line = draft.doors[door].line),
            );
            (tr!("a switch behind {whose}", whose), tr("a route to it that needs no closed door, or another switch for the door"))
        };
        warnings.push(switch.problem("x", found, expected));
    }
    for placed in &draft.objectives {
        let objective = &placed.item;
        let pad = objective.kind == ObjectiveKind::Player;
        let gets_there = |(ships, objects): &(FreeSpace, FreeSpace)| {
            let space = if pad { ships } else { objects };
            fitting(draft, objective, ship).any(|body| space.gets_to(body, &objective.bounds))
        };
        if gets_there(&last) {
            continue;
        }
        let (found, expected) = if pad && !gets_there(&off_red) {
            (tr("an objective that the ship gets to through red alone"), red_alone)
        } else if !gets_there(&past_doors) {
            (tr("an objective behind a one-way block or a wind that lets nothing through"), around)
        } else if gets_there(&held) {
            (tr("an objective behind a door that closes before the ship gets there"), stays)
        } else {
            let expected = tr("a switch in reach for each door on the route, or a route around");
            (tr("an objective behind a door that nothing opens"), expected)
        };
        warnings.push(placed.problem("x", found, expected));
    }
    warnings
}

/// A line that lets bodies through to one side alone.
struct Valve {
    line: Aabb,
    /// Right behind it, where only what may pass it can be.
    behind: Aabb,
    of_ship: bool,
}

impl Valve {
    /// Across `area`, at `place` along an axis; nothing gets through it towards `side`, 1 or −1.
    fn new(area: &Aabb, (axis, side): (usize, f64), place: f64, of_ship: bool) -> Self {
        let strip = |from: f64, to: f64| {
            let mut strip = *area;
            let ends = [from, to].map(|at| place + side * at * MIN_SIZE);
            (strip.min[axis], strip.max[axis]) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            strip
        };
        Self { line: strip(0.0, 1.0), behind: strip(2.0, 3.0), of_ship }
    }
}

/// Of one-way blocks, and of streams and fields that outdo the ship, as deep in them as it can get.
fn valves(draft: &Draft, bounds: &Bounds) -> Vec<Valve> {
    let mut valves = Vec::new();
    for block in draft.world.iter().map(|block| &block.item).filter(|block| block.breaks.is_none() && block.sides != Sides::ALL) {
        let Sides { left, right, top, bottom } = block.sides;
        let ends = [(left, 0, 1.0), (right, 0, -1.0), (top, 1, 1.0), (bottom, 1, -1.0)];
        for (_, axis, side) in ends.into_iter().filter(|(solid, ..)| *solid) {
            let place = if side > 0.0 { block.bounds.min[axis] } else { block.bounds.max[axis] };
            valves.push(Valve::new(&block.bounds, (axis, side), place, false));
        }
    }
    let streams = draft.streams.iter().enumerate().filter(|(_, stream)| stream.item.name.is_none());
    let streams = streams.map(|(index, stream)| (Zone::Stream(index), stream.item.zone, stream.item.force));
    let fields = draft.fields.iter().enumerate();
    let fields = fields.map(|(index, field)| (Zone::Field(index), field.item.zone, field.item.strength * bounds.ship.mass));
    for (zone, area, force) in streams.chain(fields) {
        for (axis, side) in [(0, DVec2::X), (1, DVec2::Y)].into_iter().filter(|(axis, _)| force[*axis] != 0.0) {
            let against = -force[axis].signum();
            let Some(energy) = bounds.run(side * against, Some(zone)) else { continue };
            let deep = energy / force[axis].abs();
            if deep + 3.0 * MIN_SIZE < area.size()[axis] {
                let place = if against > 0.0 { area.min[axis] + deep } else { area.max[axis] - deep };
                valves.push(Valve::new(&area, (axis, against), place, true));
            }
        }
    }
    valves.truncate(MOST_VALVES);
    valves
}

/// How much narrower than its box the ship is for red at any angle, m: the square in the largest circle inside its body.
const NARROWER: f64 = SHIP_HALF.x - 0.45;

/// Where the ship touches red at every angle, for the ship's box.
fn red(draft: &Draft) -> impl Iterator<Item = Aabb> {
    draft.obstacles.iter().map(|red| Aabb { min: red.item.min + NARROWER, max: red.item.max - NARROWER })
}

/// What is known of the level's gates, from less to more.
#[derive(Clone)]
struct GateState {
    pressed: Vec<bool>,
    /// The doors that are open at some time.
    open: Vec<bool>,
    /// Those that are open while the ship goes through.
    passed: Vec<bool>,
    /// Of each valve, whether nothing has got behind it.
    shut: Vec<bool>,
}

impl GateState {
    fn all_open(draft: &Draft) -> Self {
        let doors = vec![true; draft.doors.len()];
        Self { pressed: vec![true; draft.switches.len()], open: doors.clone(), passed: doors, shut: Vec::new() }
    }
}

struct Gates<'a> {
    draft: &'a Draft,
    space: &'a FreeSpace,
    /// Of each door.
    wires: Vec<Option<Wire>>,
    valves: Vec<Valve>,
}

impl<'a> Gates<'a> {
    fn new(draft: &'a Draft, space: &'a FreeSpace, valves: Vec<Valve>) -> Self {
        let switches = SwitchesByName::new(draft.switches.iter().map(|switch| &switch.item));
        let doors = draft.doors.iter().enumerate();
        let wires = doors.map(|(index, door)| switches.wire(door.item.name.as_deref()?, Worked::Door(index))).collect();
        Self { draft, space, wires, valves }
    }

    /// Whether a door needs that switch, or another one of the same name, to be pressed.
    fn opens(&self, switch: usize, door: usize) -> bool {
        self.wires[door].as_ref().is_some_and(|wire| wire.by.iter().flatten().any(|by| *by == (switch, false)))
    }

    /// Where the ship gets, off red, and where objects get.
    fn spaces(&self, state: &GateState) -> (FreeSpace, FreeSpace) {
        let closed = |open: &[bool], ship: bool| -> Vec<Aabb> {
            let doors = self.draft.doors.iter().zip(open).filter(|(_, open)| !**open).map(|(door, _)| door.item.bounds);
            let valves = self.valves.iter().zip(&state.shut).filter(|(valve, shut)| **shut && (ship || !valve.of_ship));
            doors.chain(valves.map(|(valve, _)| valve.line)).collect()
        };
        let ships = closed(&state.passed, true).into_iter().chain(red(self.draft));
        (self.space.with(ships), self.space.with(closed(&state.open, false)))
    }

    /// From the switches in reach at the start, door after door.
    fn play(&self, ship: CentredBox) -> GateState {
        let Draft { switches, objects, .. } = self.draft;
        let mut state = GateState {
            pressed: vec![false; switches.len()],
            open: Vec::new(),
            passed: Vec::new(),
            shut: vec![true; self.valves.len()],
        };
        // An object in its way keeps a door open.
        let propped = |door: &Aabb| objects.iter().any(|body| self.space.gets_to((body.item.position, body.item.size * 0.5), door));
        // By something that can stay there, or with effect for ever.
        let mut lasting: Vec<bool> = switches.iter().map(|switch| switch.item.latch != SwitchStay::Held).collect();
        loop {
            let open = |room: Option<Aabb>, wire: &Option<Wire>| {
                wire.as_ref().is_some_and(|wire| self.together(&wire.by, room, (&state.pressed, &lasting), &mut MOST_WAYS.clone()))
            };
            let doors = || self.draft.doors.iter().zip(&self.wires);
            let room = |door: &Aabb| Some(beside(door)).filter(|_| !propped(door));
            let passed = doors().map(|(door, wire)| open(room(&door.item.bounds), wire)).collect();
            (state.open, state.passed) = (doors().map(|(_, wire)| open(None, wire)).collect(), passed);
            let (ships, others) = self.spaces(&state);
            let mut news = false;
            for (index, switch) in switches.iter().enumerate() {
                if lasting[index] && state.pressed[index] {
                    continue;
                }
                let [by_ship, by_others] = presses(self.draft, &switch.item, ship, (&ships, &others));
                news |= (by_ship || by_others) && !state.pressed[index] || by_others && !lasting[index];
                state.pressed[index] |= by_ship || by_others;
                lasting[index] |= by_others;
            }
            for (valve, shut) in self.valves.iter().zip(&mut state.shut).filter(|(_, shut)| **shut) {
                let behind = |space: &FreeSpace, body| space.gets_to(body, &valve.behind);
                let mut bodies = objects.iter().map(|object| (object.item.position, object.item.size * 0.5));
                if behind(&ships, ship) || !valve.of_ship && bodies.any(|body| behind(&others, body)) {
                    (*shut, news) = (false, true);
                }
            }
            if !news {
                return state;
            }
        }
    }

    /// Whether switches of all names can be on at once, with the ship in a `room`, where it alone holds some of them. One behind a `!` is on
    /// until it is pressed.
    fn together(&self, names: &[Vec<(usize, bool)>], room: Option<Aabb>, state: (&[bool], &[bool]), ways: &mut usize) -> bool {
        let (Some((first, rest)), Some(left)) = (names.split_first(), ways.checked_sub(1)) else { return true };
        *ways = left;
        let (pressed, lasting) = state;
        first.iter().any(|&(switch, inverted)| {
            if inverted || pressed[switch] && lasting[switch] {
                return self.together(rest, room, state, ways);
            }
            let near = beside(&self.draft.switches[switch].item.bounds);
            let both = room.map_or(near, |room| Aabb { min: room.min.max(near.min), max: room.max.min(near.max) });
            pressed[switch] && both.min.cmple(both.max).all() && self.together(rest, Some(both), state, ways)
        })
    }
}

/// Where the ship's centre is beside a box, with its own width to spare, for what it does in a tick.
fn beside(bounds: &Aabb) -> Aabb {
    Aabb::new(bounds.min - 2.0 * SHIP_HALF, bounds.max + 2.0 * SHIP_HALF)
}

/// Whether the ship gets to a switch that it works, in one space; and whether an object does, in another.
fn presses(draft: &Draft, switch: &Switch, ship: CentredBox, (ships, objects): (&FreeSpace, &FreeSpace)) -> [bool; 2] {
    let by_ship = matches!(switch.by, Presser::Any | Presser::Ship);
    let counts = |key: bool| match switch.by {
        Presser::Any | Presser::Object => true,
        Presser::Key => key,
        Presser::Ship => false,
    };
    let mut others = draft.objects.iter().filter(|object| counts(object.item.key.is_some()));
    let by_others = others.any(|object| objects.gets_to((object.item.position, object.item.size * 0.5), &switch.bounds));
    [by_ship && ships.gets_to(ship, &switch.bounds), by_others]
}
