//! What outlasts a screen: who plays, the levels and the worker that reads them, recorded flights, and the files that are written. No
//! screen is known here.

pub mod attempt;
pub mod experiment;
pub mod folder_watch;
pub mod journal;
pub mod library;
pub mod new_file;
pub mod recordings;
pub mod worker;
