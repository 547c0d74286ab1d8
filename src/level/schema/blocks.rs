//! Rows of solid blocks, world.csv, movers.csv and doors.csv; of switches.csv; and of links.csv.

use super::facts::{Column, Count, FileSchema, Holds, RowSchema};
use super::typed::{FromRow, MATERIAL, Row as _, RowCells, RowReader, Word, by_word, number, one_of, rows};
use super::values::{LinkRowEnd, WayPoints, Works};
use crate::level::numbers::{self, MIN_SIZE};
use crate::level::route::{MoverPace, Route, RouteShape, path};
use crate::level::types::{LevelLink, Mover, Object, Presser, Solid, Switch, SwitchStay};
use crate::physics::{BodyId, DVec2, LinkDef, LinkEnd, LinkLaw, Magnet, Material, Sides, Spring};
use crate::{level::problem::quoted, words::tr};

pub static WORLD: FileSchema = FileSchema {
    name: "world.csv",
    help: "Blocks that are solid and never move.",
    sample: "0,680,1280,40,Asphalt\n840,440,440,30,Wood\n560,560,120,15,Steel,top\n",
};
pub static SOLID: RowSchema =
    RowSchema::new(&WORLD, "Block", SolidRow::COLUMNS, (160.0, 40.0))
        .counted(&[Count::always("solid", "solids", |level| level.world.len())]);

pub static MOVERS: FileSchema = FileSchema {
    name: "movers.csv",
    help: "Blocks that move through way points. They carry, push and crush.",
    sample: "240,560,90,20,240 380; 400 380,3,,0.5,0.5,back,Steel,,0,\n",
};
pub static MOVER: RowSchema = RowSchema::new(&MOVERS, "Mover", MoverRow::COLUMNS, (120.0, 20.0))
    .fresh(&[("speed", "2"), ("wait", "1"), ("ease", "0.5")])
    .counted(&[Count::if_any("mover", "movers", |level| level.movers.len())]);

pub static DOORS: FileSchema =
    FileSchema { name: "doors.csv", help: "Blocks that a switch opens.", sample: "1000,300,20,140,gate,Steel\n" };
pub static DOOR: RowSchema =
    RowSchema::new(&DOORS, "Door", DoorRow::COLUMNS, (20.0, 120.0))
        .counted(&[Count::if_any("door", "doors", |level| level.doors.len())]);

pub static SWITCHES: FileSchema = FileSchema {
    name: "switches.csv",
    help: "Plates and areas that work doors, movers, streams, belts and links by their names.",
    sample: "60,360,60,60,gate,,ship,latched\n760,640,60,40,!fan,,object,held\n",
};
pub static SWITCH: RowSchema = RowSchema::new(&SWITCHES, "Switch", SwitchRow::COLUMNS, (60.0, 60.0))
    .fresh(&[("by", "ship"), ("stays", "held")])
    .counted(&[Count::if_any("switch", "switches", |level| level.switches.len())]);

const ONE_WAY: Column = one_of::<Sides>("the one side from which it is solid; with none it is solid all around").or("");
const BELT: Column = number(numbers::BELT, "speed of its skin, clockwise: the upper side runs to the right").or("0");
const SWITCH_NAME: Column = Column::new(Holds::Name, "the name by which switches work it");

rows! {
    SolidRow {
        rectangle,
        material: Material = MATERIAL,
        one_way: Sides = ONE_WAY,
        belt: f64 = BELT,
        breaks: Option<f64> = number(numbers::IMPULSE, "a blow larger than this breaks it").maybe(),
        name: Option<String> = SWITCH_NAME.maybe(),
    }

    MoverRow {
        rectangle,
        way_points: WayPoints = Column::new(Holds::Points, "where its top left corner goes from its start"),
        speed: Option<f64> = number(numbers::SPEED, "its speed; or give a period").maybe(),
        period: Option<f64> = number(numbers::PERIOD, "time of the whole route; or give a speed").maybe(),
        wait: f64 = number(numbers::PAUSE, "how long it waits at each way point").or("0"),
        ease: f64 = number(numbers::PAUSE, "how long it takes to get to its speed, and to stop").or("0"),
        route: Route = one_of::<Route>("back as it came, round to its start, or once").or("back"),
        material: Material = MATERIAL,
        one_way: Sides = ONE_WAY,
        belt: f64 = BELT,
        name: Option<String> = SWITCH_NAME.maybe(),
    }

    DoorRow {
        rectangle,
        name: String = SWITCH_NAME,
        material: Material = MATERIAL,
    }

    SwitchRow {
        rectangle,
        works: Works = Column::new(Holds::Works, "the things that it works; behind a ! those that are on while it is off"),
        weight: Option<f64> = number(numbers::LOAD, "the force beyond which it is pressed, a plate; without it the switch is an area to touch").maybe(),
        by: Presser = one_of::<Presser>("the body that works an area by touching it").or("any"),
        stays: SwitchStay = one_of::<SwitchStay>("held while pressed, latched for ever, or toggled by each press").or("held"),
    }
}

by_word!(Route, Presser, SwitchStay);

impl Word for Route {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("back", Self::Back), ("round", Self::Round), ("once", Self::Once)]
    }
}

impl Word for Presser {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("any", Self::Any), ("ship", Self::Ship), ("key", Self::Key), ("object", Self::Object)]
    }
}

impl Word for SwitchStay {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("held", Self::Held), ("latched", Self::Latched), ("toggled", Self::Toggled)]
    }
}

pub fn solid(record: &RowCells, reader: &mut RowReader) -> Option<Solid> {
    let SolidRow { x, y, width, height, material, one_way, belt, breaks, name } = record.read(reader)?;
    Some(Solid { bounds: reader.scale.bounds([x, y, width, height]), material, sides: one_way, belt, breaks, name })
}

pub fn door(record: &RowCells, reader: &mut RowReader) -> Option<Solid> {
    let DoorRow { x, y, width, height, name, material } = record.read(reader)?;
    Some(Solid { name: Some(name), ..Solid::new(reader.scale.bounds([x, y, width, height]), material) })
}

pub fn mover(record: &RowCells, reader: &mut RowReader) -> Option<Mover> {
    let row: MoverRow = record.read(reader)?;
    let pace = pace(&row, record, reader)?;
    let bounds = reader.scale.bounds([row.x, row.y, row.width, row.height]);
    let solid = Solid { sides: row.one_way, belt: row.belt, name: row.name, ..Solid::new(bounds, row.material) };
    let corners = row.way_points.0.into_iter().map(|corner| corner / reader.scale.metre);
    let stops: Vec<DVec2> = std::iter::once(bounds.min).chain(corners).map(|corner| corner + bounds.size() * 0.5).collect();
    if stops.windows(2).any(|pair| pair[0].distance(pair[1]) < MIN_SIZE) {
        let points = quoted(record.text("way_points")?);
        let found = tr!("{points}, with a way point where the block is already", points);
        let expected = tr("each way point apart from the one before (the first, from x and y)");
        reader.problems.push(record.problem("way_points", found, expected));
        return None;
    }
    let manner = RouteShape { route: row.route, pace, wait: row.wait, ease: row.ease };
    let path = path(&stops, manner).map_err(|least| {
        let found = quoted(record.text("period").unwrap_or_default());
        let expected = tr!("at least {least} s, which its waits and easings take", least = format_args!("{least:.3}"));
        reader.problems.push(record.problem("period", found, expected));
    });
    Some(Mover { solid, stops, manner, path: path.ok()? })
}

fn pace(row: &MoverRow, record: &RowCells, reader: &mut RowReader) -> Option<MoverPace> {
    let found = match (row.speed, row.period) {
        (Some(speed), None) => return Some(MoverPace::Speed(speed)),
        (None, Some(period)) => return Some(MoverPace::Period(period)),
        (Some(_), Some(_)) => tr("a speed and a period"),
        (None, None) => tr("neither a speed nor a period"),
    };
    reader.problems.push(record.problem("speed", found, tr("one of the two: speed in m/s, or period in s")));
    None
}

pub fn switch(record: &RowCells, reader: &mut RowReader) -> Option<Switch> {
    let SwitchRow { x, y, width, height, works, weight, by, stays } = record.read(reader)?;
    if weight.is_some() && by != Presser::Any {
        let by = quoted(record.text("by")?);
        let found = tr!("{by} beside a weight", by);
        reader.problems.push(record.problem("by", found, tr("nothing or any: a plate is pressed by whatever weighs on it")));
        return None;
    }
    Some(Switch { bounds: reader.scale.bounds([x, y, width, height]), works: works.0, weight, by, latch: stays })
}

pub static LINKS: FileSchema = FileSchema {
    name: "links.csv",
    help: "Springs, ropes and magnets between two bodies, or a body and a place, at most 256 a level. With the distance ℓ of the centres, which \
           grows by ℓ′, and the length ℓ₀ a spring pulls with k·(ℓ − ℓ₀) + c·ℓ′; a rope does so where that pulls and ℓ > ℓ₀; a magnet pulls with \
           s/ℓ². A switch that is off lets the ends go; it stops a link that has a rate.",
    sample: "",
};
pub static LINK: RowSchema = RowSchema::new(&LINKS, "Link", LinkRow::COLUMNS, (51.0, 51.0))
    .fresh(&[("kind", "rope"), ("stiffness", "5000"), ("damping", "100")])
    .counted(&[Count::if_any("link", "links", |level| level.links.len())]);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::level) enum LinkKind {
    Spring,
    Rope,
    Magnet,
}

by_word!(LinkKind, LinkBegin);

impl Word for LinkKind {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("spring", Self::Spring), ("rope", Self::Rope), ("magnet", Self::Magnet)]
    }
}

/// Whether a link begins at once, or when its ends touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::level) enum LinkBegin {
    Start,
    Touch,
}

impl Word for LinkBegin {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("", Self::Start), ("touch", Self::Touch)]
    }
}

rows! {
    LinkRow {
        kind: LinkKind = one_of::<LinkKind>("its law").or("rope"),
        a: LinkRowEnd = Column::new(Holds::End, "its first end"),
        b: LinkRowEnd = Column::new(Holds::End, "its other end; one of the two is a body"),
        length: Option<f64> = Column::new(Holds::Length, "the length without a force; as the ends stand, where none is given").maybe(),
        stiffness: Option<f64> = number(numbers::STIFFNESS, "force k of a spring or rope for each metre that it is too long").maybe(),
        damping: Option<f64> = number(numbers::DAMPING, "force c of a spring or rope for each m/s at which its ends part").maybe(),
        strength: Option<f64> = number(numbers::STRENGTH, "force s of a magnet at 1 m; below 0 it pushes").maybe(),
        hook: LinkBegin = one_of::<LinkBegin>("begins when its ends first touch").or(""),
        breaks: Option<f64> = number(numbers::LOAD, "a force larger than this breaks it").maybe(),
        rate: f64 = number(numbers::BELT, "a winch: the growth of its length while its switch is on").or("0"),
        name: Option<String> = Column::new(Holds::Name, "the name by which switches work it").maybe(),
    }
}

pub fn link(record: &RowCells, reader: &mut RowReader) -> Option<UnboundLink> {
    let row: LinkRow = record.read(reader)?;
    let (kind, before) = (row.kind, reader.problems.len());
    let mut refuse = |column: &'static str, found: String, expected: &str| {
        reader.problems.push(record.problem(column, found, expected));
    };
    let given = |column: &str| record.text(column).filter(|text| !text.is_empty()).map(quoted);
    let (own, others): (_, &[&str]) = match kind {
        LinkKind::Magnet => ("strength", &["length", "stiffness", "damping", "rate"]),
        LinkKind::Spring | LinkKind::Rope => ("stiffness", &["strength"]),
    };
    let magnet = kind == LinkKind::Magnet;
    for (column, found) in others.iter().filter_map(|column| Some((*column, given(column)?))) {
        refuse(column, found, tr(if magnet { "nothing: a magnet has none" } else { "nothing: only a magnet has one" }));
    }
    if given(own).is_none() {
        refuse(own, tr("nothing").to_owned(), tr(if magnet { "a strength in N·m²" } else { "a stiffness in N/m" }));
    }
    let LinkRow { breaks, rate, .. } = row;
    let (length, damping) = (row.length.unwrap_or(0.0) / reader.scale.metre, row.damping.unwrap_or(0.0));
    let spring = |stiffness: f64| Spring { length, stiffness, damping };
    let law = match kind {
        LinkKind::Spring => LinkLaw::Spring(spring(row.stiffness?)),
        LinkKind::Rope => LinkLaw::Rope(spring(row.stiffness?)),
        LinkKind::Magnet => LinkLaw::Magnet(Magnet { strength: row.strength?, nearest: 0.0 }),
    };
    let (hook, as_found, name) = (row.hook == LinkBegin::Touch, row.length.is_none(), row.name);
    let ends = [row.a, row.b].map(|end| end.in_metres(reader.scale));
    (reader.problems.len() == before).then_some(UnboundLink { ends, law, as_found, hook, breaks, rate, name })
}

/// The most links of a level: a stiff one takes some 10 µs a tick.
pub(in crate::level) const MOST_LINKS: usize = 256;

/// A link whose ends are names.
#[derive(Clone, Debug)]
pub(in crate::level) struct UnboundLink {
    pub ends: [LinkRowEnd; 2],
    pub law: LinkLaw,
    pub as_found: bool,
    pub hook: bool,
    pub breaks: Option<f64>,
    pub rate: f64,
    pub name: Option<String>,
}

impl UnboundLink {
    /// `None` where an end has no body, or where neither is one.
    pub fn bind(&self, objects: &[FromRow<Object>]) -> Option<LevelLink> {
        let end = |end: &LinkRowEnd| match end {
            LinkRowEnd::Ship => Some(LinkEnd::Body(BodyId(0))),
            LinkRowEnd::Place(place) => Some(LinkEnd::Place(*place)),
            LinkRowEnd::Object(name) => {
                let found = objects.iter().position(|object| object.item.name.as_ref() == Some(name));
                Some(LinkEnd::Body(BodyId(found? as u32 + 1)))
            }
        };
        let (body, to) = match (end(&self.ends[0])?, end(&self.ends[1])?) {
            (LinkEnd::Body(body), to) | (to, LinkEnd::Body(body)) => (body, to),
            (LinkEnd::Place(_), LinkEnd::Place(_)) => return None,
        };
        let Self { law, as_found, hook, breaks, rate, .. } = *self;
        Some(LevelLink { def: LinkDef { body, to, law, as_found, hook, breaks, rate }, name: self.name.clone() })
    }
}

pub(in crate::level) fn bound(links: &[FromRow<UnboundLink>], objects: &[FromRow<Object>]) -> Vec<LevelLink> {
    let bound = links.iter().filter_map(|link| link.item.bind(objects));
    bound.filter(|link| link.def.to != LinkEnd::Body(link.def.body)).take(MOST_LINKS).collect()
}
