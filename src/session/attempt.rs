//! An attempt at a level, and its record.

use crate::game::{History, Inputs, Replay};
use crate::level::Level;
use std::sync::Arc;

/// A level, and the inputs that replace the keys, if any.
#[derive(Clone, Debug)]
pub struct Attempt {
    pub level: Arc<Level>,
    /// Recorded inputs, played from the first tick on.
    pub inputs: Option<Arc<Inputs>>,
    /// Recorded flights that fly along as ghosts.
    pub rivals: Vec<Rival>,
}

impl Attempt {
    /// A flight by hand, alone.
    pub const fn by_hand(level: Arc<Level>) -> Self {
        Self { level, inputs: None, rivals: Vec::new() }
    }
}

/// A flight by hand that is over.
#[derive(Clone, Debug)]
pub struct Flown {
    pub level: Arc<Level>,
    pub replay: Replay,
    /// Any tick of it.
    pub history: History,
}

/// A recorded flight that flies along.
#[derive(Clone, Debug)]
pub struct Rival {
    /// Whose it is, in a word or two.
    pub name: String,
    /// What was pressed.
    pub inputs: Arc<Inputs>,
}
