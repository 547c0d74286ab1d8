//! The player's settings: keys, volumes, picture and assists. [`Settings`] holds the values, [`Item`] is one of them in the list,
//! [`mod@file`] is `settings.csv`, [`layout`] is what the player's keyboard types.

mod bindings;
pub mod file;
mod item;
mod keys;
pub mod layout;

pub use bindings::{Action, Bindings, FLYING};
pub use item::{Assists, Item, Palette, Settings};
#[cfg(feature = "window")]
pub(crate) use keys::plain_keys;
pub use keys::{Key, Keys};
