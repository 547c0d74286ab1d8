//! The levels with the experiments, assets and charts that are built in.

/// The bytes by their paths from the project's folder, with forward slashes.
pub static SHIPPED: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/shipped.rs"));
