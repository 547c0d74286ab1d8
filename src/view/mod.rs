//! Drawing only: reads the game and changes nothing in it.
