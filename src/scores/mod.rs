//! User names and leaderboards, and their files.
