//! Warnings of doors that no body can open, pads behind red, plates that are too heavy. A doubtful route counts as possible: a body gets
//! anywhere in its own free space, and one-way and fragile blocks and movers are no obstacles.

use super::draft::Draft;
use super::problem::Problem;
use super::reach::{CentredBox, FreeSpace};
use super::types::{ObjectiveKind, Presser, SHIP_HALF, ShipStart, Switch};
use super::winnable::fitting;
use super::wiring::{SwitchesByName, Wire, Worked};
use crate::physics::Aabb;
use crate::words::tr;

pub(super) fn warn(draft: &Draft, player: &ShipStart, space: &FreeSpace) -> Vec<Problem> {
    if draft.switches.is_empty() && draft.doors.is_empty() && draft.obstacles.is_empty() {
        return Vec::new();
    }
    let ship = (player.position, SHIP_HALF);
    let red = || draft.obstacles.iter().map(|red| red.item);
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
    warnings.extend(plates(draft, player, space));
    warnings
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
            let off_red = free.with(self.draft.obstacles.iter().map(|red| red.item));
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

/// Plates that take more than the sum of all weights, the ship's thrust and the winds near by, downwards. The force of a mover, a belt or
/// a link has no such bound.
fn plates(draft: &Draft, player: &ShipStart, space: &FreeSpace) -> Vec<Problem> {
    let plates = draft.switches.iter().filter_map(|switch| Some((switch, switch.item.weight?)));
    if draft.is_driven() {
        return Vec::new();
    }
    // Bodies that touch each other reach no further than all of them in a row.
    let sizes = draft.objects.iter().map(|object| object.item.size.max_element());
    let reach = 2.0 * SHIP_HALF.x + sizes.sum::<f64>();
    let near = |plate: &Aabb| Aabb::new(plate.min - reach, plate.max + reach);
    let bodies: Vec<(CentredBox, f64, bool)> = std::iter::once(((player.position, SHIP_HALF), player.mass, false))
        .chain(draft.objects.iter().map(|object| {
            let object = &object.item;
            ((object.position, object.size * 0.5), object.mass, object.weightless)
        }))
        .collect();
    let fields: f64 = draft.fields.iter().map(|field| field.item.strength.y.max(0.0)).sum();
    let pull = draft.settings.gravity.max(0.0) + fields;
    let mut warnings = Vec::new();
    for (plate, weight) in plates {
        let near = near(&plate.item.bounds);
        let there = bodies.iter().filter(|(body, ..)| space.gets_to(*body, &near));
        let (mut most, mut count) = (player.thrust, 0.0);
        for (_, mass, weightless) in there {
            most += if *weightless { 0.0 } else { mass * pull };
            count += 1.0;
        }
        let winds = draft.streams.iter().filter(|stream| stream.item.zone.touches(&near, 0.0));
        most += count * winds.map(|stream| stream.item.force.y.max(0.0)).sum::<f64>();
        if most <= weight {
            let found = tr!(
                "{weight} N, with {most} N of weight, thrust and wind in all to press it",
                weight,
                most = format_args!("{most:.0}")
            );
            warnings.push(plate.problem("weight", found, tr("less than that")));
        }
    }
    warnings
}
