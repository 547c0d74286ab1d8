//! The force manager of a body, and a file for each law that moves it:
//!
//! | weight | drive and added pushes | wind | fields of gravity | drag of the air | buoyancy and drag of liquids | springs, ropes, magnets |
//! |---|---|---|---|---|---|---|
//! | `media` | `manager` | `zones` | `zones` | `air` | `liquid`, `displaced` | `link` |
//!
//! `law` sums them for a body that touches nothing.

pub(crate) mod air;
pub(crate) mod displaced;
pub(crate) mod kind;
pub(crate) mod law;
pub(crate) mod link;
pub(crate) mod liquid;
pub(crate) mod manager;
pub(crate) mod media;
pub(crate) mod zones;

pub(crate) use air::Drag;
pub(crate) use kind::{ForceKind, Source};
pub(crate) use law::Law;
pub(crate) use link::{Link, Links};
pub(crate) use liquid::{Bath, Regime};
pub(crate) use manager::{Force, ForceManager};
pub(crate) use media::Media;
pub(crate) use zones::ZoneList;
