//! Drawing only: reads the game and changes nothing in it. The screens decide, in [`crate::screens`]. A [`crate::draw::Canvas`]
//! records the shapes.

pub mod arrows;
pub mod art;
pub mod barriers;
pub mod boxes;
pub mod camera;
pub mod decoration;
pub mod details;
pub mod emitters;
pub mod facts;
pub mod feedback;
pub mod focus;
pub mod free_body;
pub mod game_view;
pub mod hitboxes;
pub mod hud;
pub mod lanes;
pub mod links;
pub mod mechanisms;
pub mod medals;
pub mod miniature;
pub mod names;
pub mod paper;
pub mod particles;
pub mod partner;
pub mod pictures;
pub mod quantity;
pub mod scale;
pub mod sky;
mod stirred;
pub mod terrain;
pub mod theme;
pub mod things;
pub mod touchdown;
pub mod widgets;
pub mod world;
pub mod wreck;
pub mod zones;

pub use game_view::{GameView, GhostShip, Overlays};
