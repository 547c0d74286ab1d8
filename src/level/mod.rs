//! Level folders: CSV text becomes a valid [`Level`], or the list of all its [`Problem`]s. `table` finds the columns of cells, the rows of `schema`
//! become things of `draft`, and `read` makes the level. `names`, `links`, `placement` and `winnable` refuse levels; `certain` warns, with
//! `gates` among its checks, and `reach` fills the free space for both. Only `folder`, `scaffold` and `document` know the disk.

mod certain;
pub mod document;
mod draft;
mod folder;
mod gates;
mod image;
mod links;
mod names;
mod numbers;
mod parameter;
mod placement;
mod problem;
mod reach;
mod read;
mod route;
pub mod scaffold;
pub mod schema;
mod table;
mod types;
mod varied;
mod winnable;
mod wiring;
mod world_def;

pub(crate) use folder::by_number_then_name;
#[cfg(test)]
pub(crate) use folder::fixture;
pub use folder::{NameFault, is_device, is_hidden, is_shipped, judge_name, landscape, list, load, load_unfinished, title};
pub use image::{BACKGROUND, Files, read_picture};
pub use parameter::Parameter;
pub use problem::{Problem, listed};
pub use read::{Loaded, read, read_unfinished};
pub use route::{MoverPace, Route, RouteShape};
pub use schema::FILES;
pub use types::{
    AirStream, Awards, BURN_RATE, Decoration, Fluid, GravityZone, Landscape, Level, LevelLink, Look, Mark, Mover, Object,
    Objective, ObjectiveKind, Pod, Presser, SHIP_HALF, SHIP_HEIGHT, SHIP_PIXELS, ShipStart, Solid, Star, StarTouch, Switch,
    SwitchStay, TICK_RATE, Text, Work,
};
pub use varied::varied;
pub use wiring::{SurfaceOf, Wire, Worked};
pub use world_def::{SHIP_BODY, nose, ship_body, sweep_touches};
