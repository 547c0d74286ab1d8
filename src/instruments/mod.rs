//! What a lesson measures with, without a window: it reads a flight tick by tick and changes nothing in it.

pub mod walk;
