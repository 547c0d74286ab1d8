//! What holds of the sources themselves.

mod no_clocks;
