//! How curves are called and what they look like.

use crate::draw::chart::{CurveLook, CurveOrigin, DASHES, Marker};
use crate::lab::curve::{GROWTH, Measured, MethodCurve, slope};
use crate::lab::scenes::{bouncing, collisions, stacks};
use crate::{draw::Colour, view::theme, words::tr};
use crate::{lab::kept::OURS, lab::methods::METHODS, lab::methods::motion, lab::stability::PART, lab::stability::SHIPPED};

/// Other engines, each with a marker of its own.
const PEERS: [(&str, Marker); 3] = [("Rapier f32", Marker::Up), ("Rapier f64", Marker::Down), ("Box2D", Marker::Square)];
/// In a peer's name: how often it solves its contacts and how stiff they are, and that bodies at rest are left alone.
const FINE: &str = "stiffness 240 Hz";
const SLEEP: &str = "with sleep";
/// The opacity of a curve while another is picked out.
const QUIETED: f32 = 0.2;

/// A curve's name in the player's language: the engine's is the same in all charts, those of peers are put together.
pub fn name_of(name: &str, origin: CurveOrigin) -> String {
    let part = |part: &str| {
        if let Some(count) = part.strip_suffix(" iterations") {
            tr!("{count} iterations", count)
        } else if let Some(count) = part.strip_suffix(" substeps") {
            tr!("{count} substeps", count)
        } else if let Some(frequency) = part.strip_prefix("stiffness ") {
            tr!("stiffness {frequency}", frequency)
        } else {
            tr(part).to_owned()
        }
    };
    match origin {
        CurveOrigin::Peer => name.split(", ").map(part).collect::<Vec<_>>().join(", "),
        CurveOrigin::Shipped if name == OURS => tr(SHIPPED).to_owned(),
        _ => tr(name).to_owned(),
    }
}

/// A method has the same look in all charts; what is unknown here, that of its place.
pub(super) fn look_of(name: &str, origin: CurveOrigin, index: usize) -> CurveLook {
    if origin == CurveOrigin::Peer {
        let look = CurveLook::of(index, origin);
        let marker = PEERS.iter().find(|(engine, _)| name.starts_with(engine)).map_or(look.marker, |(_, marker)| *marker);
        let dash = if name.ends_with(SLEEP) { DASHES[3] } else { DASHES[if name.contains(FINE) { 0 } else { 2 }] };
        return CurveLook { dash, marker, ..look };
    }
    let name = if name == PART { motion::ADAPTIVE } else { name };
    let motions = METHODS.iter().map(|(name, _)| *name).chain(["exact flow"]);
    let contacts = bouncing::SLIDE_METHODS.iter().map(|(name, _)| *name).chain(bouncing::METHODS.iter().map(|(name, _)| *name));
    let solvers = collisions::METHODS.iter().map(|(name, _)| *name).chain(stacks::SOLVERS.iter().map(|(name, _)| *name));
    let known = motions.chain(contacts).chain(solvers).position(|known| known == name);
    CurveLook::of(known.unwrap_or(index), origin)
}

/// A curve's name, with its order where one is seen (a peer's name is long enough), or its growth with the number of bodies.
pub(super) fn with_order(measured: &Measured, curve: &MethodCurve) -> String {
    if let Some(slope) = slope(&curve.points).filter(|_| measured.name == GROWTH) {
        let method = name_of(&curve.name, curve.origin);
        return tr!("{method}, slope {slope}", method, slope = format_args!("{slope:.2}"));
    }
    let (name, order) = (name_of(&curve.name, curve.origin), if curve.origin == CurveOrigin::Peer { None } else { curve.order() });
    match order {
        Some(order) => tr!("{method}, order {order}", method = name, order = format_args!("{order:.1}")),
        None => name,
    }
}

/// A name without the version of what it names: the last word before the first comma.
pub(super) fn without_version(name: &str) -> String {
    let parts = name.split_once(", ").and_then(|(head, rest)| Some((head.rsplit_once(' ')?, rest)));
    match parts {
        Some(((engine, version), rest)) if version.starts_with(|letter: char| letter.is_ascii_digit()) => {
            format!("{engine}, {rest}")
        }
        _ => name.to_owned(),
    }
}

/// The colour, or its faded version on a panel.
pub(super) fn shade(colour: Colour, whole: bool) -> Colour {
    let part = if whole { 1.0 } else { QUIETED };
    let mix = |a: f32, b: f32| a * part + b * (1.0 - part);
    Colour::new(mix(colour.r, theme::panel().r), mix(colour.g, theme::panel().g), mix(colour.b, theme::panel().b), 1.0)
}
