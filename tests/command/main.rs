//! The program as it is called from a shell.

mod command_line;
mod import;
mod printed;
mod readout;
mod run;
mod stats;
#[path = "../support/mod.rs"]
mod support;
