//! The screens: a state machine that is tested without a window.
