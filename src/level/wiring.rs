//! The things that switches work, found by name; and the kinds of a world's surfaces.

use super::types::{Level, Switch};
use std::collections::BTreeMap;

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Worked {
    /// It moves while it is on.
    Mover(usize),
    /// It is open while it is on.
    Door(usize),
    /// Of that block of the world: it runs while it is on.
    Belt(usize),
    /// It blows while it is on.
    Stream(usize),
    /// It acts while it is on; one with a rate winds.
    Link(usize),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wire {
    pub worked: Worked,
    /// For each name of the thing its switches, each with whether it turns the thing on while it is off, not on. One of each name is enough.
    pub by: Vec<Vec<(usize, bool)>>,
}

/// The names of a thing: `a&b` is on while a switch of `a` and one of `b` are.
pub fn names_in(name: &str) -> impl Iterator<Item = &str> {
    name.split('&')
}

/// By name its switches, as in [`Wire::by`].
pub(super) struct SwitchesByName<'a>(BTreeMap<&'a str, Vec<(usize, bool)>>);

impl<'a> SwitchesByName<'a> {
    pub fn new(switches: impl Iterator<Item = &'a Switch>) -> Self {
        let mut known: BTreeMap<&str, Vec<(usize, bool)>> = BTreeMap::new();
        for (switch, of) in switches.enumerate() {
            of.works.iter().for_each(|work| known.entry(&work.name).or_default().push((switch, work.inverted)));
        }
        Self(known)
    }

    /// `None` where no switch works the thing; a name that no switch works does not count.
    pub fn wire(&self, name: &str, worked: Worked) -> Option<Wire> {
        let by: Vec<_> = names_in(name).filter_map(|name| self.0.get(name).cloned()).collect();
        (!by.is_empty()).then_some(Wire { worked, by })
    }
}

impl Wire {
    /// `switches`: whether each is on.
    pub fn is_on(&self, switches: &[bool]) -> bool {
        self.by.iter().all(|by| by.iter().any(|&(switch, inverted)| switches[switch] != inverted))
    }
}

/// The thing that a surface of a level's world belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceOf {
    /// The block of that index in `Level::world`.
    World(usize),
    Source(usize),
    Mover(usize),
    Door(usize),
    Plate(usize),
    /// An edge of the level: left, right, top, bottom.
    Edge(usize),
}

impl Level {
    pub fn wires(&self) -> Vec<Wire> {
        let belt = |index: usize| (self.world[index].belt != 0.0).then_some(Worked::Belt(index));
        let named = (0..self.movers.len()).map(|i| (&self.movers[i].solid.name, Some(Worked::Mover(i))));
        let named = named.chain((0..self.doors.len()).map(|i| (&self.doors[i].name, Some(Worked::Door(i)))));
        let named = named.chain((0..self.world.len()).map(|i| (&self.world[i].name, belt(i))));
        let named = named.chain((0..self.streams.len()).map(|i| (&self.streams[i].name, Some(Worked::Stream(i)))));
        let named = named.chain((0..self.links.len()).map(|i| (&self.links[i].name, Some(Worked::Link(i)))));
        let switches = SwitchesByName::new(self.switches.iter());
        named.filter_map(|(name, worked)| switches.wire(name.as_deref()?, worked?)).collect()
    }

    /// `index` counts the surfaces of the level's world.
    pub fn surface(&self, index: usize) -> SurfaceOf {
        let mut left = index;
        let mut within = |count: usize| {
            let inside = left < count;
            left -= if inside { 0 } else { count };
            inside
        };
        if within(self.world.len()) {
            return SurfaceOf::World(index);
        }
        for (count, kind) in [
            (self.streams.len(), SurfaceOf::Source as fn(usize) -> SurfaceOf),
            (self.movers.len(), SurfaceOf::Mover),
            (self.doors.len(), SurfaceOf::Door),
        ] {
            if within(count) {
                return kind(left);
            }
        }
        match self.plates().nth(left) {
            Some(switch) => SurfaceOf::Plate(switch),
            None => SurfaceOf::Edge((left - self.plates().count()).min(3)),
        }
    }

    pub fn surface_index(&self, of: SurfaceOf) -> usize {
        let before = [self.world.len(), self.streams.len(), self.movers.len(), self.doors.len(), self.plates().count()];
        let after = |kinds: usize| before[..kinds].iter().sum::<usize>();
        match of {
            SurfaceOf::World(index) => index,
            SurfaceOf::Source(index) => after(1) + index,
            SurfaceOf::Mover(index) => after(2) + index,
            SurfaceOf::Door(index) => after(3) + index,
            SurfaceOf::Plate(index) => after(4) + self.plates().take_while(|switch| *switch < index).count(),
            SurfaceOf::Edge(index) => after(5) + index,
        }
    }

    pub(super) fn plates(&self) -> impl Iterator<Item = usize> {
        (0..self.switches.len()).filter(|&switch| self.switches[switch].weight.is_some())
    }
}
