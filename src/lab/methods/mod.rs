//! The methods that games use, each written down as plainly as its textbook has it, as small pure functions: a state and a step in,
//! the next state out. They are here to be measured beside the engine, which uses none of this code; scenes, references and
//! limits are not here.

pub mod bounce;
pub mod chain;
pub mod impact;
pub mod implicit;
pub mod motion;
pub mod rules;
pub mod slide;
