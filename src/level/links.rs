//! Links: the names of their ends become bodies.

use super::draft::Draft;
use super::nearest::meant;
use super::placed::FromRow;
use super::problem::{MOST_PROBLEMS, Problem, quoted};
use super::strength::judge;
use super::types::{LevelLink, Object, SHIP_HALF, ShipStart};
use crate::physics::domain::{MOST_DAMPING, MOST_STIFFNESS};
use crate::physics::{BodyId, DVec2, LinkDef, LinkEnd, LinkLaw};

/// The most links of a level: a stiff one takes some 10 µs a tick.
const MOST_LINKS: usize = 256;

/// An end of a row of links.csv.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum LinkRowEnd {
    Ship,
    /// By name.
    Object(String),
    /// m.
    Place(DVec2),
}

/// A link whose ends are names.
#[derive(Clone, Debug)]
pub(super) struct UnboundLink {
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
    fn bind(&self, objects: &[FromRow<Object>]) -> Option<LevelLink> {
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

/// The links whose ends are bodies.
pub(super) fn bound(links: &[FromRow<UnboundLink>], objects: &[FromRow<Object>]) -> Vec<LevelLink> {
    let bound = links.iter().filter_map(|link| link.item.bind(objects));
    bound.filter(|link| link.def.to != LinkEnd::Body(link.def.body)).take(MOST_LINKS).collect()
}

/// Ends that are no body, names that two bodies share, links without a body, and links too stiff or too strong for one.
pub(super) fn check(draft: &Draft) -> Vec<Problem> {
    let mut problems = Vec::new();
    let beyond = draft.links.iter().skip(MOST_LINKS).take(MOST_PROBLEMS);
    let found = format!("{} links", draft.links.len());
    problems.extend(beyond.map(|link| link.problem("a", found.clone(), format!("at most {MOST_LINKS} in a level"))));
    let names: Vec<&str> = draft.objects.iter().filter_map(|object| object.item.name.as_deref()).collect();
    let mut loads = vec![(0.0, 0.0); draft.objects.len() + 1];
    for link in draft.links.iter().take(MOST_LINKS) {
        let before = problems.len();
        for (column, end) in ["a", "b"].into_iter().zip(&link.item.ends) {
            let LinkRowEnd::Object(name) = end else { continue };
            match names.iter().filter(|known| *known == name).count() {
                0 => {
                    let meant = meant(name, names.iter().copied().chain(["ship"]));
                    problems.push(link.problem(
                        column,
                        quoted(name),
                        format!("ship, the name of an object, or a place x y{meant}"),
                    ));
                }
                1 => {}
                many => problems.push(link.problem(column, quoted(name), format!("the name of one object; {many} have that one"))),
            }
        }
        let bound = link.item.bind(&draft.objects);
        match &bound {
            None if problems.len() == before => problems.push(link.problem("b", "a second place", "a body at one end at least")),
            Some(LevelLink { def, .. }) if def.to == LinkEnd::Body(def.body) => {
                problems.push(link.problem("b", "the same body as at the other end", "another body, or a place"));
            }
            Some(LevelLink { def, .. }) => problems.extend(load(draft, link, def, &mut loads)),
            None => {}
        }
    }
    problems.truncate(MOST_PROBLEMS);
    problems
}

/// The first number of a link that is too large for a body; `loads` sums stiffness and damping by body.
fn load(draft: &Draft, link: &FromRow<UnboundLink>, def: &LinkDef, loads: &mut [(f64, f64)]) -> Option<Problem> {
    let ship = |ship: &FromRow<ShipStart>| (ship.item.mass, SHIP_HALF);
    let body = |body: BodyId| match body.index().checked_sub(1) {
        None => draft.player.as_ref().map(ship),
        Some(object) => draft.objects.get(object).map(|object| (object.item.mass, object.item.size * 0.5)),
    };
    let ends: Vec<BodyId> = [def.to, LinkEnd::Body(def.body)]
        .iter()
        .filter_map(|end| match end {
            LinkEnd::Body(body) => Some(*body),
            LinkEnd::Place(_) => None,
        })
        .collect();
    let nearest: f64 = ends.iter().filter_map(|end| body(*end)).map(|(_, half)| half.element_sum() * 0.5).sum();
    for end in ends {
        let (Some((mass, _)), (stiffness, damping)) = (body(end), &mut loads[end.index()]) else { continue };
        match def.law {
            LinkLaw::Spring(spring) | LinkLaw::Rope(spring) => {
                *stiffness += spring.stiffness;
                *damping += spring.damping;
                for (column, sum, most, unit) in
                    [("stiffness", *stiffness, MOST_STIFFNESS * mass, "N/m"), ("damping", *damping, MOST_DAMPING * mass, "N·s/m")]
                {
                    if sum > most {
                        let found = format!("{sum} {unit} on {mass} kg, all links up to this one");
                        return Some(link.problem(column, found, format!("at most {most} {unit}")));
                    }
                }
            }
            LinkLaw::Magnet(magnet) => {
                let force = magnet.strength / (nearest * nearest);
                if let Some(expected) = judge(force, mass) {
                    return Some(link.problem("strength", format!("{force} N on {mass} kg at {nearest} m, the nearest"), expected));
                }
            }
        }
    }
    None
}
