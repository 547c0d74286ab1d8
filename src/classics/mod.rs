//! Three small classics, each with just the model that its scene needs.
