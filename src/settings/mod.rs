//! The player's settings: keys, volumes, picture and assists. [`Settings`] holds the values, [`Item`] is one of them in the list,
//! [`mod@file`] is `settings.csv`.

pub mod file;
mod item;
mod keys;
mod values;

pub use item::Item;
#[cfg(feature = "window")]
pub(crate) use keys::plain_keys;
pub use keys::{Action, Bindings, Key, Keys};
pub use values::{Assists, Palette, Settings};
