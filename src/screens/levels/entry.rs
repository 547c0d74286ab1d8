//! A level in the list: what is known of it without opening it.

use crate::game::Medals;
use crate::level::{Awards, Landscape};
use crate::session::folder_watch::Stamp;
use crate::session::library::Refusal;
use crate::view::miniature::Miniature;
use crate::words::tr;

/// A level in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelEntry {
    /// Its folder's name.
    pub name: String,
    /// Its world, where it comes with the game.
    pub world: Option<Landscape>,
    /// Its title and what it looks like, or why it does not load; `None` until it has been in view.
    pub level: Option<Result<(String, Miniature), Refusal>>,
    /// What its folder looked like then.
    pub stamp: Stamp,
    /// Its title, as far as it has been looked for.
    pub title: Option<String>,
    /// The player's best time without help, s; `None` where there is none.
    pub best: Option<f64>,
    /// What its medals ask for.
    pub awards: Awards,
    /// The medals that it has brought the player.
    pub medals: Medals,
}

impl LevelEntry {
    /// A level of which nothing but its name and world is known.
    pub fn new(name: String, world: Option<Landscape>) -> Self {
        Self {
            name,
            world,
            level: None,
            stamp: Stamp::default(),
            title: None,
            best: None,
            awards: Awards::default(),
            medals: Medals::default(),
        }
    }

    /// Whether its name or title has these letters in it, which are small.
    pub(super) fn has(&self, letters: &str) -> bool {
        let has = |text: &str| text.to_lowercase().contains(letters);
        has(&self.name) || self.title.as_deref().is_some_and(|title| has(title) || has(tr(title)))
    }
}
