//! Drawing only: reads the game and changes nothing in it. The screens decide, in [`crate::screens`]. A [`crate::draw::Canvas`] records the shapes.

pub mod art;
pub mod boxes;
pub mod camera;
pub mod details;
pub mod emitters;
pub mod facts;
pub mod feedback;
pub mod focus;
pub mod free_body;
pub mod game_view;
pub mod hitboxes;
pub mod hud;
pub mod labels;
pub mod lanes;
pub mod mechanisms;
pub mod particles;
pub mod scale;
pub mod sky;
pub mod terrain;
pub mod textbook;
pub mod theme;
pub mod things;
pub mod widgets;
pub mod world;
pub mod zones;

pub use game_view::{GameView, GhostShip, Overlays, painting};
