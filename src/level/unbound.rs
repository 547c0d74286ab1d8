//! Links as their rows have them: the names of their ends become bodies.

use super::schema::typed::FromRow;
use super::schema::values::LinkRowEnd;
use super::types::{LevelLink, Object};
use crate::physics::{BodyId, LinkDef, LinkEnd, LinkLaw};

/// The most links of a level: a stiff one takes some 10 µs a tick.
pub(super) const MOST_LINKS: usize = 256;

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

/// The links whose ends are bodies.
pub(super) fn bound(links: &[FromRow<UnboundLink>], objects: &[FromRow<Object>]) -> Vec<LevelLink> {
    let bound = links.iter().filter_map(|link| link.item.bind(objects));
    bound.filter(|link| link.def.to != LinkEnd::Body(link.def.body)).take(MOST_LINKS).collect()
}
