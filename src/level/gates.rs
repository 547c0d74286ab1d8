//! Warnings of doors that no body can open and of pads behind red. A doubtful route counts as possible: a body gets anywhere in its own
//! free space, and one-way and fragile blocks and movers are no obstacles.

use super::draft::Draft;
use super::problem::Problem;
use super::reach::{CentredBox, FreeSpace};
use super::types::{ObjectiveKind, Presser, SHIP_HALF, ShipStart, Switch};
use super::winnable::fitting;
use super::wiring::{SwitchesByName, Wire, Worked};
use crate::physics::Aabb;
use crate::words::tr;

pub(super) fn warn_of_gates(draft: &Draft, player: &ShipStart, space: &FreeSpace) -> Vec<Problem> {
    if draft.switches.is_empty() && draft.doors.is_empty() && draft.obstacles.is_empty() {
        return Vec::new();
    }
    let ship = (player.position, SHIP_HALF);
    let red = || red(draft);
    let off_red = space.with(red());
    let gates = Gates::new(draft);
    let (pressed, open) = gates.play(ship, space);
    let closed = || gates.closed(&open);
    let (behind, behind_and_red) = (space.with(closed()), space.with(closed().chain(red())));
    let mut warnings = Vec::new();
    for (index, switch) in draft.switches.iter().enumerate().filter(|(index, _)| !pressed[*index]) {
        let (found, expected) = if !presses(draft, &switch.item, ship, (space, space)) {
            (tr("a switch that nothing which works it gets to").to_owned(), tr("free space from the start of what works it"))
        } else if !presses(draft, &switch.item, ship, (&off_red, space)) {
            (
                tr("a switch that the ship gets to through red alone").to_owned(),
                tr("a route for the ship that keeps off the rows of obstacles.csv"),
            )
        } else {
            let own = (0..open.len()).find(|&door| !open[door] && gates.opens(index, door));
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
        let gets_there = |space: &FreeSpace| fitting(draft, objective, ship).any(|body| space.gets_to(body, &objective.bounds));
        let pad = objective.kind == ObjectiveKind::Player;
        if pad && !gets_there(&off_red) {
            let expected = tr("a route for the ship that keeps off the rows of obstacles.csv");
            warnings.push(placed.problem("x", tr("an objective that the ship gets to through red alone"), expected));
        } else if !gets_there(if pad { &behind_and_red } else { &behind }) {
            let expected = tr("a switch in reach for each door on the route, or a route around");
            warnings.push(placed.problem("x", tr("an objective behind a door that nothing opens"), expected));
        }
    }
    warnings
}

/// How much narrower than its box the ship is for red at any angle, m: the square in the largest circle inside its body.
const NARROWER: f64 = SHIP_HALF.x - 0.45;

/// Where the ship touches red at every angle, for the ship's box.
fn red(draft: &Draft) -> impl Iterator<Item = Aabb> {
    draft.obstacles.iter().map(|red| Aabb { min: red.item.min + NARROWER, max: red.item.max - NARROWER })
}

struct Gates<'a> {
    draft: &'a Draft,
    /// Of each door.
    wires: Vec<Option<Wire>>,
}

impl<'a> Gates<'a> {
    fn new(draft: &'a Draft) -> Self {
        let switches = SwitchesByName::new(draft.switches.iter().map(|switch| &switch.item));
        let doors = draft.doors.iter().enumerate();
        let wires = doors.map(|(index, door)| switches.wire(door.item.name.as_deref()?, Worked::Door(index))).collect();
        Self { draft, wires }
    }

    /// Whether a door needs that switch, or another one of the same name, to be pressed.
    fn opens(&self, switch: usize, door: usize) -> bool {
        self.wires[door].as_ref().is_some_and(|wire| wire.by.iter().flatten().any(|by| *by == (switch, false)))
    }

    /// The doors that are open at some time; one behind a `!` is open until its switch is pressed.
    fn open(&self, pressed: &[bool]) -> Vec<bool> {
        let ever = |by: &Vec<(usize, bool)>| by.iter().any(|(switch, inverted)| *inverted || pressed[*switch]);
        self.wires.iter().map(|wire| wire.as_ref().is_some_and(|wire| wire.by.iter().all(ever))).collect()
    }

    fn closed(&self, open: &[bool]) -> impl Iterator<Item = Aabb> + use<'_> {
        let closed: Vec<usize> = (0..open.len()).filter(|door| !open[*door]).collect();
        closed.into_iter().map(|door| self.draft.doors[door].item.bounds)
    }

    /// Which switches can be pressed, and which doors are open at some time: from the switches in reach at the start, door after door.
    fn play(&self, ship: CentredBox, space: &FreeSpace) -> (Vec<bool>, Vec<bool>) {
        let mut pressed = vec![false; self.draft.switches.len()];
        loop {
            let open = self.open(&pressed);
            let free = space.with(self.closed(&open));
            let off_red = free.with(red(self.draft));
            let mut news = false;
            for (index, switch) in self.draft.switches.iter().enumerate() {
                if !pressed[index] && presses(self.draft, &switch.item, ship, (&off_red, &free)) {
                    (pressed[index], news) = (true, true);
                }
            }
            if !news {
                return (pressed, open);
            }
        }
    }
}

/// Whether a body that works a switch gets to it, the ship in one space and the objects in another.
fn presses(draft: &Draft, switch: &Switch, ship: CentredBox, (ships, objects): (&FreeSpace, &FreeSpace)) -> bool {
    let by_ship = matches!(switch.by, Presser::Any | Presser::Ship);
    let counts = |key: bool| match switch.by {
        Presser::Any | Presser::Object => true,
        Presser::Key => key,
        Presser::Ship => false,
    };
    let mut others = draft.objects.iter().filter(|object| counts(object.item.key.is_some()));
    by_ship && ships.gets_to(ship, &switch.bounds)
        || others.any(|object| objects.gets_to((object.item.position, object.item.size * 0.5), &switch.bounds))
}
