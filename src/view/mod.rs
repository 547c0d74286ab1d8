//! Drawing only: reads the game and changes nothing in it. The screens hand over what they hold; what they decide is in
//! [`crate::screens`]. Only [`layout`], [`plot`], [`quantity`] and the geometry of [`terrain`], which are plain
//! arithmetic, are there without a window.

pub mod layout;
pub mod plot;
pub mod terrain;

#[cfg(feature = "window")]
pub mod arrows;
#[cfg(feature = "window")]
pub mod art;
pub mod barriers;
#[cfg(feature = "window")]
pub mod boxes;
#[cfg(feature = "window")]
pub mod camera;
#[cfg(feature = "window")]
pub mod canvas;
#[cfg(feature = "window")]
pub mod decoration;
#[cfg(feature = "window")]
pub mod details;
#[cfg(feature = "window")]
pub mod diagram;
#[cfg(feature = "window")]
pub mod emitters;
#[cfg(feature = "window")]
pub mod facts;
#[cfg(feature = "window")]
pub mod feedback;
pub mod focus;
#[cfg(feature = "window")]
pub mod fonts;
#[cfg(feature = "window")]
pub mod free_body;
#[cfg(feature = "window")]
pub mod game_view;
#[cfg(feature = "window")]
pub mod hitboxes;
#[cfg(feature = "window")]
pub mod hud;
#[cfg(feature = "window")]
pub mod mechanisms;
#[cfg(feature = "window")]
pub mod medals;
#[cfg(feature = "window")]
pub mod names;
#[cfg(feature = "window")]
pub mod particles;
#[cfg(feature = "window")]
pub mod partner;
#[cfg(feature = "window")]
pub mod picture;
#[cfg(feature = "window")]
pub mod pictures;
pub mod plane;
pub mod quantity;
#[cfg(feature = "window")]
pub mod scale;
#[cfg(feature = "window")]
pub mod shapes;
#[cfg(feature = "window")]
pub mod sound;
#[cfg(feature = "window")]
pub mod theme;
#[cfg(feature = "window")]
pub mod things;
#[cfg(feature = "window")]
pub mod timeline;
#[cfg(feature = "window")]
pub mod touchdown;
#[cfg(feature = "window")]
pub mod widgets;
#[cfg(feature = "window")]
pub mod world;
#[cfg(feature = "window")]
pub mod wreck;
#[cfg(feature = "window")]
pub mod zones;

#[cfg(feature = "window")]
pub use art::{Art, icon};
#[cfg(feature = "window")]
pub use game_view::{GameView, Ghost, Overlays};
