//! The player's settings: keys, volumes, the picture, and help in flight; and the file that keeps it.
//!
//! [`Settings`] holds the values, [`Item`] is one of them as a list shows and changes it, [`mod@file`] is `settings.csv`. Screens, view and
//! game read them.

pub mod file;
mod item;
mod keys;
mod values;

pub use item::Item;
#[cfg(feature = "window")]
pub(crate) use keys::plain_keys;
pub use keys::{Action, Bindings, Key, Keys};
pub use values::{Assists, Palette, Settings};
