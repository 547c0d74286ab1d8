//! The numbers of a level that can be varied, each with the loader's limits and its cells.

use super::numbers::{self as q, NumberRange};
use super::route::{MoverPace, path};
use super::schema::Table;
use super::types::{Level, Look, Mover, Object, Solid};
use crate::physics::{Aabb, BodyId, DVec2, LinkEnd, LinkLaw, Material, Spring};
use crate::words::{filled, tr};

/// Of bodies 0 is the ship, i + 1 is object i; links, blocks, streams, liquids and movers count from 0, as in their files. Mass in kg, restitution
/// 0 … 1, forces in N, gravity in N/kg downwards, air density in kg/m³.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Parameter {
    Mass(usize),
    Drag(usize),
    Restitution(usize),
    /// At the start, m/s to the right and upwards.
    VelocityX(usize),
    VelocityY(usize),
    /// Of the centre at the start, m from the left edge and above the lower edge.
    PlaceX(usize),
    PlaceY(usize),
    /// Of a plain shape, m; its height goes with it.
    Width(usize),
    Stiffness(usize),
    Damping(usize),
    /// Nothing breaks it at the largest number.
    Breaks(usize),
    Thrust,
    Gravity,
    Air,
    /// Factor of all coefficients of friction.
    Friction,
    /// A place in [`Material::ALL`], of a block.
    Material(usize),
    Density(usize),
    Speed(usize),
    Ease(usize),
    /// Of a mover's upper edge at the start and at its last way point, m above the lower edge of the level.
    From(usize),
    To(usize),
    /// Along an air stream.
    Stream(usize),
    /// Factor of the forces of all air streams, 1 in the unvaried level.
    Wind,
}

/// To a billionth of a pixel: what is read back from a file is that number to the bit.
fn pixels(metres: f64, level: &Level) -> f64 {
    (metres * level.metre * 1e9).round() / 1e9
}

impl Parameter {
    /// The parameters of a body of the level, and of the level. An experiment has more of them: it is made of few things.
    pub fn all(level: &Level, body: usize) -> Vec<Self> {
        let mut all = Vec::new();
        if Self::Mass(body).of(level).is_some() {
            all.push(Self::Mass(body));
            all.extend((body == 0).then_some(Self::Thrust));
            all.extend([Self::VelocityX, Self::VelocityY, Self::Restitution, Self::Drag].map(|of| of(body)));
        }
        if level.experiment {
            let id = BodyId(body as u32);
            let holds = |link: &usize| level.links[*link].def.body == id || level.links[*link].def.to == LinkEnd::Body(id);
            let links = (0..level.links.len()).filter(holds);
            all.extend([Self::PlaceX(body), Self::PlaceY(body), Self::Width(body)]);
            all.extend(links.flat_map(|link| [Self::Stiffness(link), Self::Damping(link), Self::Breaks(link)]));
        }
        all.extend([Self::Gravity, Self::Air, Self::Friction]);
        all.extend((!level.streams.is_empty()).then_some(Self::Wind));
        if level.experiment {
            all.extend((0..level.streams.len()).map(Self::Stream));
            all.extend((0..level.world.len()).map(Self::Material));
            all.extend((0..level.fluids.len()).map(Self::Density));
            all.extend((0..level.movers.len()).flat_map(|i| [Self::Speed(i), Self::Ease(i), Self::From(i), Self::To(i)]));
        }
        all.retain(|parameter| parameter.of(level).is_some());
        all
    }

    /// The boxes at the start, m, of what is where by numbers that can vary, each with those of its place to the right and upwards:
    /// objects, movers, and movers at their last way point.
    pub fn places(level: &Level) -> Vec<(Aabb, [Option<Self>; 2])> {
        let of = |(object, i): (&Object, _)| {
            (Aabb::around(object.position, object.size * 0.5), [Some(Self::PlaceX(i)), Some(Self::PlaceY(i))])
        };
        let objects = level.objects.iter().zip(1..).map(of);
        let movers = level.movers.iter().enumerate().flat_map(|(i, mover)| {
            let bounds = mover.solid.bounds;
            let last = mover.stops.get(1..).and_then(|stops| stops.last());
            let end = last.map(|last| (Aabb::around(*last, bounds.size() * 0.5), [None, Some(Self::To(i))]));
            [Some((bounds, [None, Some(Self::From(i))])), end].into_iter().flatten()
        });
        objects.chain(movers).collect()
    }

    /// Its label, its accepted numbers, its file and its column.
    pub(super) const fn facts(self) -> (&'static str, NumberRange, Table, &'static str) {
        let (objects, links, movers, constants) = (Table::Objects, Table::Links, Table::Movers, Table::Constants);
        match self {
            Self::Mass(_) => ("Mass", q::MASS, objects, "mass"),
            Self::Drag(_) => ("Drag coefficient", q::DRAG, objects, "drag"),
            Self::Restitution(_) => ("Restitution", q::RESTITUTION, objects, "restitution"),
            Self::VelocityX(_) => ("Start velocity →", q::VELOCITY, objects, "vx"),
            Self::VelocityY(_) => ("Start velocity ↑", q::VELOCITY, objects, "vy"),
            Self::PlaceX(_) => ("Start place →", q::PLACE, objects, "x"),
            Self::PlaceY(_) => ("Start place ↑", q::PLACE, objects, "y"),
            Self::Width(_) => ("Width", q::SIZE, objects, "image"),
            Self::Stiffness(_) => ("Link {number}: stiffness", q::STIFFNESS, links, "stiffness"),
            Self::Damping(_) => ("Link {number}: damping", q::DAMPING, links, "damping"),
            Self::Breaks(_) => ("Link {number}: breaks", q::LOAD, links, "breaks"),
            Self::Thrust => ("Thrust", q::THRUST, Table::Player, "thrust"),
            Self::Gravity => ("Gravity", q::GRAVITY, constants, "gravity"),
            Self::Air => ("Air density", q::AIR_DENSITY, constants, "air_density"),
            Self::Friction => ("All friction ×", q::FRICTION, constants, "friction"),
            Self::Material(_) => ("Block {number}", q::MATERIAL, Table::World, "material"),
            Self::Density(_) => ("Liquid {number}: density", q::DENSITY, Table::Fluids, "density"),
            Self::Speed(_) => ("Mover {number}: speed", q::SPEED, movers, "speed"),
            Self::Ease(_) => ("Mover {number}: easing", q::PAUSE, movers, "ease"),
            Self::From(_) => ("Mover {number}: from ↑", q::PLACE, movers, "y"),
            Self::To(_) => ("Mover {number}: to ↑", q::PLACE, movers, "way_points"),
            Self::Stream(_) => ("Fan {number}", q::FORCE, Table::Hazards, "force_x"),
            Self::Wind => ("All wind ×", q::WIND, Table::Hazards, "force_x"),
        }
    }

    /// In the words of the source, and an own one for each thing.
    pub fn name(self) -> String {
        self.numbered(self.facts().0)
    }

    pub fn shown(self) -> String {
        self.numbered(tr(self.facts().0))
    }

    fn numbered(self, name: &str) -> String {
        filled(name, &[("number", &self.thing().map_or(0, |thing| thing + 1))])
    }

    /// Empty where it has none.
    pub const fn unit(self) -> &'static str {
        self.facts().1.unit
    }

    pub const fn body(self) -> Option<usize> {
        match self {
            Self::Mass(i) | Self::Drag(i) | Self::Restitution(i) | Self::VelocityX(i) | Self::VelocityY(i) => Some(i),
            Self::PlaceX(i) | Self::PlaceY(i) | Self::Width(i) => Some(i),
            Self::Thrust => Some(0),
            _ => None,
        }
    }

    /// Its place among the links, blocks, streams, liquids or movers.
    pub(super) const fn thing(self) -> Option<usize> {
        match self {
            Self::Stiffness(i) | Self::Damping(i) | Self::Breaks(i) | Self::Material(i) | Self::Density(i) => Some(i),
            Self::Speed(i) | Self::Ease(i) | Self::From(i) | Self::To(i) | Self::Stream(i) => Some(i),
            _ => None,
        }
    }

    /// Whether it is one of a body, or of what is tied to it, and not of the level.
    pub const fn is_of_a_body(self) -> bool {
        self.body().is_some() || matches!(self, Self::Stiffness(_) | Self::Damping(_) | Self::Breaks(_))
    }

    /// Whether only a flight from its start shows its effect.
    pub const fn is_of_the_start(self) -> bool {
        matches!(self, Self::VelocityX(_) | Self::VelocityY(_)) || self.moves()
    }

    /// Whether it changes what is where at the start.
    pub(super) const fn moves(self) -> bool {
        matches!(self, Self::PlaceX(_) | Self::PlaceY(_) | Self::Width(_))
            || matches!(self, Self::Speed(_) | Self::Ease(_) | Self::From(_) | Self::To(_))
    }

    /// The least and the most that it may be.
    pub const fn limits(self) -> (f64, f64) {
        let (_, range, ..) = self.facts();
        (range.low, range.high)
    }

    /// The number that a text holds, as in a level's file, also with a decimal comma; a material by its name.
    /// Errors: the number that is expected instead, in words.
    pub fn parse(self, text: &str) -> Result<f64, String> {
        if let Self::Material(_) = self {
            let named = |of: &Material| [of.name, tr(of.name)].iter().any(|name| name.eq_ignore_ascii_case(text.trim()));
            let names = Material::ALL.map(|material| tr(material.name)).join(", ");
            let place = Material::ALL.iter().position(named).map(|place| place as f64);
            return place.or_else(|| self.facts().1.parse(text).ok()).ok_or_else(|| tr!("one of {list}", list = names));
        }
        // The game itself writes a true minus.
        self.facts().1.parse(&text.trim().replace('−', "-").replace(',', "."))
    }

    /// The name of the chosen one, where it is a choice.
    pub fn choice(self, value: f64) -> Option<&'static str> {
        matches!(self, Self::Material(_)).then(|| Material::ALL.get(value as usize).map_or("", |material| material.name))
    }

    /// Its value; `None` where the level has no such thing, as an experiment has no ship.
    pub fn of(self, level: &Level) -> Option<f64> {
        let (player, object) = (&level.player, |i: usize| level.objects.get(i.checked_sub(1)?));
        let of_ship = |value: f64| level.ship_plays().then_some(value);
        let of = |i: usize, ship: f64, value: fn(&Object) -> f64| if i == 0 { of_ship(ship) } else { object(i).map(value) };
        let spring = |i: usize| match level.links.get(i)?.def.law {
            LinkLaw::Spring(spring) | LinkLaw::Rope(spring) => Some(spring),
            LinkLaw::Magnet(_) => None,
        };
        let top = |mover: &Mover, stop: DVec2| level.size.y - (stop.y - mover.solid.bounds.size().y * 0.5);
        match self {
            Self::Mass(i) => of(i, player.mass, |object| object.mass),
            Self::Drag(i) => of(i, player.drag, |object| object.drag),
            Self::Restitution(i) => of(i, player.restitution, |object| object.restitution),
            Self::VelocityX(i) => of(i, player.velocity.x, |object| object.velocity.x),
            // Adding zero turns a negative zero into zero.
            Self::VelocityY(i) => of(i, player.velocity.y, |object| object.velocity.y).map(|down| 0.0 - down),
            Self::PlaceX(i) => object(i).map(|object| object.position.x),
            Self::PlaceY(i) => object(i).map(|object| level.size.y - object.position.y),
            Self::Width(i) => object(i).filter(|object| !matches!(object.look, Look::Image(_))).map(|object| object.size.x),
            Self::Stiffness(i) => spring(i).map(|spring| spring.stiffness),
            Self::Damping(i) => spring(i).map(|spring| spring.damping),
            Self::Breaks(i) => spring(i).map(|_| level.links[i].def.breaks.unwrap_or(q::LOAD.high)),
            Self::Thrust => of_ship(player.thrust),
            Self::Gravity => Some(level.gravity),
            Self::Air => Some(level.air_density),
            Self::Friction => Some(level.friction),
            Self::Material(i) => {
                let name = level.world.get(i)?.material.name;
                Material::ALL.iter().position(|material| material.name == name).map(|place| place as f64)
            }
            Self::Density(i) => level.fluids.get(i).map(|fluid| fluid.density),
            Self::Speed(i) => match level.movers.get(i)?.manner.pace {
                MoverPace::Speed(speed) => Some(speed),
                MoverPace::Period(_) => None,
            },
            Self::Ease(i) => level.movers.get(i).map(|mover| mover.manner.ease),
            Self::From(i) => level.movers.get(i).and_then(|mover| Some(top(mover, *mover.stops.first()?))),
            Self::To(i) => level.movers.get(i).and_then(|mover| Some(top(mover, *mover.stops.get(1..)?.last()?))),
            // One that blows aslant has no such number.
            Self::Stream(i) => {
                let force = level.streams.get(i)?.force;
                (force.x * force.y == 0.0).then_some(force.x + force.y)
            }
            Self::Wind => Some(1.0),
        }
    }

    pub(super) fn put(self, level: &mut Level, value: f64) -> Result<(), String> {
        let (metre, high) = (level.metre, level.size.y);
        let (in_metres, pixels_down) = (pixels(value, level) / metre, pixels(high - value, level));
        let down = pixels_down / metre;
        let (player, objects) = (&mut level.player, &mut level.objects);
        macro_rules! field {
            ($i:ident, $($field:ident).+, $value:expr) => {
                match $i {
                    0 => player.$($field).+ = $value,
                    _ => objects[$i - 1].$($field).+ = $value,
                }
            };
        }
        match self {
            Self::Mass(i) => field!(i, mass, value),
            Self::Drag(i) => field!(i, drag, value),
            Self::Restitution(i) => field!(i, restitution, value),
            Self::VelocityX(i) => field!(i, velocity.x, value),
            Self::VelocityY(i) => field!(i, velocity.y, 0.0 - value),
            Self::PlaceX(i) => field!(i, position.x, in_metres),
            Self::PlaceY(i) => field!(i, position.y, down),
            Self::Width(i) => {
                let size = objects[i - 1].size;
                let height = (in_metres * size.y / size.x * metre * 1e9).round() / 1e9 / metre;
                objects[i - 1].size = DVec2::new(in_metres, height);
            }
            Self::Stiffness(i) => spring(&mut level.links[i].def.law, |spring| spring.stiffness = value),
            Self::Damping(i) => spring(&mut level.links[i].def.law, |spring| spring.damping = value),
            Self::Breaks(i) => level.links[i].def.breaks = (value < q::LOAD.high).then_some(value),
            Self::Thrust => player.thrust = value,
            Self::Gravity => level.gravity = value,
            Self::Air => level.air_density = value,
            Self::Friction => level.friction = value,
            Self::Material(i) => level.world[i].material = Material::ALL[value as usize],
            Self::Density(i) => level.fluids[i].density = value,
            Self::Speed(i) => level.movers[i].manner.pace = MoverPace::Speed(value),
            Self::Ease(i) => level.movers[i].manner.ease = value,
            Self::From(i) => {
                let height = pixels(level.movers[i].solid.bounds.size().y, level);
                let loaded = |corner: DVec2| DVec2::new(pixels(corner.x, level), pixels(corner.y, level)) / metre;
                let corners: Vec<DVec2> = level.movers[i].corners().map(loaded).collect();
                let Mover { solid: Solid { bounds, .. }, stops, .. } = &mut level.movers[i];
                (bounds.min.y, bounds.max.y) = (down, (pixels_down + height) / metre);
                let half = bounds.size() * 0.5;
                *stops = std::iter::once(bounds.min).chain(corners).map(|corner| corner + half).collect();
            }
            Self::To(i) => {
                let Mover { solid, stops, .. } = &mut level.movers[i];
                let last = stops.len() - 1;
                stops[last].y = down + solid.bounds.size().y * 0.5;
            }
            Self::Stream(i) => {
                let force = &mut level.streams[i].force;
                *if force.y == 0.0 { &mut force.x } else { &mut force.y } = value;
            }
            Self::Wind => level.streams.iter_mut().for_each(|stream| stream.force *= value),
        }
        if let Self::Speed(i) | Self::Ease(i) | Self::From(i) | Self::To(i) = self {
            let Mover { stops, manner, path: way, .. } = &mut level.movers[i];
            *way = path(stops, *manner).map_err(|least| tr!("at least {least} s, which its waits and easings take", least))?;
        }
        Ok(())
    }

    pub(super) fn place(self, level: &Level) -> (Table, &'static str) {
        let is_key = |body: usize| level.objects.get(body - 1).is_some_and(|object| object.key.is_some());
        let (_, _, table, column) = self.facts();
        match self.body() {
            Some(0) => (Table::Player, column),
            Some(body) if is_key(body) => (Table::Objectives, column),
            _ => (table, column),
        }
    }

    /// The text of its cell in the files of a level.
    pub(super) fn text(self, level: &Level) -> Option<String> {
        let text = |metres: f64| pixels(metres, level).to_string();
        Some(match self {
            // The files count y downwards, from the upper edge.
            Self::VelocityY(_) => (0.0 - self.of(level)?).to_string(),
            Self::PlaceX(i) => text(level.objects.get(i - 1)?.position.x),
            Self::PlaceY(i) => text(level.objects.get(i - 1)?.position.y),
            Self::Width(i) => {
                let Object { size, look, .. } = level.objects.get(i - 1)?;
                let shape = if *look == Look::Ball { "ball" } else { "box" };
                format!("{shape}:{}x{}", text(size.x), text(size.y))
            }
            Self::Breaks(i) => level.links.get(i)?.def.breaks.map_or_else(String::new, |breaks| breaks.to_string()),
            Self::Material(i) => level.world.get(i)?.material.name.to_owned(),
            Self::From(i) => text(level.movers.get(i)?.solid.bounds.min.y),
            Self::To(i) => {
                let corners = level.movers.get(i)?.corners().map(|corner| format!("{} {}", text(corner.x), text(corner.y)));
                corners.collect::<Vec<_>>().join("; ")
            }
            _ => self.of(level)?.to_string(),
        })
    }
}

impl Mover {
    /// Its upper left corner at each way point, m.
    fn corners(&self) -> impl Iterator<Item = DVec2> + '_ {
        self.stops.iter().skip(1).map(|stop| *stop - self.solid.bounds.size() * 0.5)
    }
}

fn spring(law: &mut LinkLaw, change: impl FnOnce(&mut Spring)) {
    if let LinkLaw::Spring(spring) | LinkLaw::Rope(spring) = law {
        change(spring);
    }
}
