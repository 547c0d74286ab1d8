//! The force manager of a body, and a file for each law that moves it:
//!
//! | weight | drive | wind | fields of gravity | drag of the air | buoyancy and drag of liquids | springs |
//! |---|---|---|---|---|---|---|
//! | `weight` | `drive` | `wind` | `field` | `air` | `liquid`, `displaced` | `link` |
//!
//! `law` sums them for a body that touches nothing; `media` holds the zones, and `zones` says who is in one.

pub(crate) mod air;
pub(crate) mod displaced;
mod drive;
mod field;
pub(crate) mod kind;
pub(crate) mod law;
pub(crate) mod link;
pub(crate) mod liquid;
pub(crate) mod manager;
pub(crate) mod media;
pub(crate) mod weight;
mod wind;
pub(crate) mod zones;
