//! Drawing only: reads the game and changes nothing in it. The screens hand over what they hold; what they decide is in
//! [`crate::screens`]. Only [`layout`], which is plain arithmetic, is there without a window.

pub mod layout;

#[cfg(feature = "window")]
pub mod canvas;
#[cfg(feature = "window")]
pub mod fonts;
#[cfg(feature = "window")]
pub mod shapes;
#[cfg(feature = "window")]
pub mod theme;
#[cfg(feature = "window")]
pub mod widgets;
