//! Level folders: CSV text becomes a valid [`Level`], or the list of all its [`Problem`]s. Behind the loader nothing knows pixels
//! but drawing; drawing, rules and physics do not live here.
//!
//! How a level is read: `cells` cuts a file's bytes into cells that know their line; `table` finds out which cell belongs to which
//! column; `quantity` says which numbers are accepted, `varied` which of them can be varied while a level is flown; `rows`, `blocks` and `extras` turn each file's records into typed rows; `read`
//! puts the rows together, `names`, `strength`, `placement`, `reach` and `winnable` look at the whole; `gates`, `pushed` and `power` warn of
//! what nobody gets to, pushes or flies; `ship_body` is the shape of the ship that red kills. All of that is pure: [`read()`] asks [`Files`]
//! for bytes. Only `folder`
//! knows the disk: [`load`] and [`list`].

mod awards;
mod blocks;
mod box_tree;
mod cells;
mod constants;
pub mod document;
mod extras;
mod folder;
mod gates;
mod image;
mod name;
mod names;
mod nearest;
mod placement;
mod power;
mod problem;
mod pushed;
mod quantity;
mod reach;
mod read;
mod route;
mod rows;
pub mod scaffold;
mod shade;
mod ship_body;
mod strength;
mod table;
mod types;
mod varied;
mod winnable;
mod wiring;
mod words;
mod world_def;

pub use awards::{Awards, Mark};
pub use folder::{is_shipped, list, load, load_unfinished, title};
pub use image::read_picture;
pub use name::{NameFault, is_device, judge_name};
pub use names::FILES;
pub use problem::{Problem, told};
pub use read::{BACKGROUND, Files, Loaded, read, read_unfinished};
pub use ship_body::{SHIP_BODY, nose, ship_body, sweep_touches};
pub use types::{
    BURN_RATE, Decoration, Field, Fluid, Latch, Level, Look, Mover, Object, Objective, ObjectiveKind, Player, Pod, Presser, Route,
    SHIP_DRAG, SHIP_HALF, SHIP_HEIGHT, SHIP_PIXELS, Solid, Stream, Switch, TICK_RATE, Text, Work,
};
pub use varied::{Parameter, varied};
pub use wiring::{SurfaceOf, Wire, Worked};
