//! Tile run: a point runs and jumps through a map of tiles, one [`Command`] a frame.
//!
//! The tile at column c and row r covers x ∈ [c, c+1), y ∈ [r, r+1); y grows downwards; lengths are in tiles, speeds in tiles a frame.
//! [`Runner::frame`] uses nothing but `+ − × floor` and comparisons on `f64`, in a fixed order, so that a run has the same bits on every machine.

use std::fmt;

/// Added to vy in every frame.
const GRAVITY: f64 = 0.06;
/// The part of vx that a frame leaves.
const FRICTION: f64 = 0.80;
/// |vx| is at most this. Below 1, so that no frame jumps over a tile.
const MAX_RUN: f64 = 0.5;
/// vy is at least this: the fastest rise.
const MAX_RISE: f64 = -0.6;
/// vy is at most this: the fastest fall, tiles a frame. Below 1, so that no frame jumps over a tile.
pub const MAX_FALL: f64 = 0.8;
/// The gap between a stopped runner and a solid tile. Were it 0, a stop on the right or below would lie in the solid tile.
const GAP: f64 = 1e-6;

/// `LINE: MESSAGE`, to be put behind `FILE:`, with lines counted from 1, as an editor does.
pub type InputError = String;

fn error(line: usize, message: impl fmt::Display) -> InputError {
    format!("{line}: {message}")
}

/// Numbered lines without their ends: LF or CRLF, and a byte-order mark before the first.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.strip_prefix('\u{feff}').unwrap_or(text).lines().enumerate().map(|(index, line)| (index + 1, line))
}

/// The solid tiles and the start. Outside the map, and behind the end of a short row, everything is solid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map {
    solid: Vec<Vec<bool>>,
    pub start: (usize, usize),
}

impl Map {
    /// Reads a map: a row a line; `#` solid, `.` empty, one `s` or `S` the start. Rows may differ in length.
    /// Errors: the first of: another character, a second start, no start, no tiles at all.
    pub fn parse(text: &str) -> Result<Self, InputError> {
        let mut solid = Vec::new();
        let mut start = None;
        for (line, row) in lines(text) {
            let mut tiles = Vec::with_capacity(row.len());
            for (column, tile) in row.chars().enumerate() {
                match (tile, start) {
                    ('#' | '.', _) => {}
                    ('s' | 'S', None) => start = Some((column, line - 1)),
                    ('s' | 'S', Some((_, first))) => {
                        return Err(error(
                            line,
                            format!("a second start; the first is on line {}, expected exactly one", first + 1),
                        ));
                    }
                    _ => return Err(error(line, format!("column {}: found {tile:?}, expected '#', '.', 's' or 'S'", column + 1))),
                }
                tiles.push(tile == '#');
            }
            solid.push(tiles);
        }
        if solid.iter().all(Vec::is_empty) {
            return Err(error(1, "the map is empty, expected rows of '#', '.' and one 's' or 'S'"));
        }
        let start = start.ok_or_else(|| error(solid.len(), "the map ends without a start, expected one 's' or 'S'"))?;
        Ok(Self { solid, start })
    }

    /// Which tiles of each row are solid; a row may be shorter than others.
    pub fn rows(&self) -> &[Vec<bool>] {
        &self.solid
    }

    /// Whether the tile that holds the point (x, y) is solid.
    pub fn is_solid(&self, x: f64, y: f64) -> bool {
        let (column, row) = (x.floor(), y.floor());
        if column < 0.0 || row < 0.0 {
            return true;
        }
        // From here the casts are exact: the runner stays within one tile of the map.
        self.solid.get(row as usize).and_then(|tiles| tiles.get(column as usize)).copied().unwrap_or(true)
    }
}

/// A command for one frame; the values are finite, in tiles a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    /// Subtract from vx.
    Left(f64),
    /// Add to vx.
    Right(f64),
    /// Subtract from vy, when on the ground, down to -0.6 and no further.
    Jump(f64),
    Wait,
}

impl Command {
    /// Reads a list of commands: `NAME VALUE` a line, NAME one of LEFT, RIGHT, JUMP, WAIT. Blank lines are skipped.
    /// Errors: the first line with an unknown name, without a value, with a value that is no finite number, or with more behind it.
    pub fn parse_all(text: &str) -> Result<Vec<Self>, InputError> {
        let written = lines(text).filter(|(_, line)| !line.trim().is_empty());
        written.map(|(number, line)| Self::parse(line).map_err(|message| error(number, message))).collect()
    }

    fn parse(line: &str) -> Result<Self, String> {
        let mut words = line.split_whitespace();
        let name = words.next().unwrap_or_default();
        let command: fn(f64) -> Self = match name {
            "LEFT" => Self::Left,
            "RIGHT" => Self::Right,
            "JUMP" => Self::Jump,
            "WAIT" => |_| Self::Wait,
            _ => return Err(format!("unknown command {name:?}, expected LEFT, RIGHT, JUMP or WAIT")),
        };
        let word = words.next().ok_or_else(|| format!("{name} without a value, expected a number behind it"))?;
        let value = word.parse().ok().filter(|value: &f64| value.is_finite());
        let value = value.ok_or_else(|| format!("{name}: found {word:?}, expected a finite number"))?;
        match words.next() {
            None => Ok(command(value)),
            Some(more) => Err(format!("{name} {word}: found {more:?} behind the value, expected the end of the line")),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Runner {
    /// Tiles from the left.
    pub x: f64,
    /// Tiles from the top.
    pub y: f64,
    /// Tiles a frame.
    pub vx: f64,
    /// Tiles a frame, downwards.
    pub vy: f64,
    /// Whether the last frame ended on a solid tile.
    pub on_ground: bool,
}

impl Runner {
    /// At rest in the top left corner of the map's start tile, not yet on the ground.
    pub fn new(map: &Map) -> Self {
        let (column, row) = map.start;
        Self { x: column as f64, y: row as f64, vx: 0.0, vy: 0.0, on_ground: false }
    }

    /// Column and row of the tile that holds the runner.
    pub fn tile(&self) -> (i64, i64) {
        (self.x.floor() as i64, self.y.floor() as i64)
    }

    pub fn frame(&mut self, map: &Map, command: Command) {
        self.obey(command);
        self.vy += GRAVITY;
        self.vx *= FRICTION;
        self.vx = self.vx.clamp(-MAX_RUN, MAX_RUN);
        self.vy = self.vy.clamp(MAX_RISE, MAX_FALL);
        self.move_across(map);
        self.move_down(map);
    }

    fn obey(&mut self, command: Command) {
        match command {
            Command::Left(value) => self.vx -= value,
            Command::Right(value) => self.vx += value,
            // The limit on rising applies here and not only below: gravity then takes its part of the limited speed.
            Command::Jump(value) if self.on_ground => self.vy = (self.vy - value).max(MAX_RISE),
            Command::Jump(_) | Command::Wait => {}
        }
    }

    fn move_across(&mut self, map: &Map) {
        let x = self.x + self.vx;
        if map.is_solid(x, self.y) {
            self.x = in_front_of(x, self.vx);
            self.vx = 0.0;
        } else {
            self.x = x;
        }
    }

    fn move_down(&mut self, map: &Map) {
        self.on_ground = false;
        let y = self.y + self.vy;
        if map.is_solid(self.x, y) {
            self.y = in_front_of(y, self.vy);
            self.on_ground = self.vy > 0.0;
            self.vy = 0.0;
        } else {
            self.y = y;
        }
    }
}

/// Where a move with velocity `v` to coordinate `to`, inside a solid tile, ends. `v` is not 0: the runner is never in a solid tile
/// before a move, and no move is longer than a tile.
fn in_front_of(to: f64, v: f64) -> f64 {
    if v > 0.0 { to.floor() - GAP } else { to.floor() + 1.0 + GAP }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bad_map_is_refused_with_its_line() {
        for (text, expected) in [
            ("", "1: the map is empty, expected rows of '#', '.' and one 's' or 'S'"),
            ("\n\n", "1: the map is empty, expected rows of '#', '.' and one 's' or 'S'"),
            ("#.#\n###\n", "2: the map ends without a start, expected one 's' or 'S'"),
            ("#s.\n#S#", "2: a second start; the first is on line 1, expected exactly one"),
            ("ss", "1: a second start; the first is on line 1, expected exactly one"),
            ("#s#\r\n#. \r\n", "2: column 3: found ' ', expected '#', '.', 's' or 'S'"),
            ("#s#\n\n#é", "3: column 2: found 'é', expected '#', '.', 's' or 'S'"),
        ] {
            assert_eq!(Map::parse(text).unwrap_err(), expected, "{text:?}");
        }
    }

    #[test]
    fn every_bad_command_is_refused_with_its_line() {
        for (text, expected) in [
            ("WAIT 0\nFLY 1", "2: unknown command \"FLY\", expected LEFT, RIGHT, JUMP or WAIT"),
            ("left 1", "1: unknown command \"left\", expected LEFT, RIGHT, JUMP or WAIT"),
            ("\n\r\nLEFT", "3: LEFT without a value, expected a number behind it"),
            ("WAIT", "1: WAIT without a value, expected a number behind it"),
            ("WAIT a", "1: WAIT: found \"a\", expected a finite number"),
            ("JUMP 0,5", "1: JUMP: found \"0,5\", expected a finite number"),
            ("JUMP nan", "1: JUMP: found \"nan\", expected a finite number"),
            ("RIGHT -inf", "1: RIGHT: found \"-inf\", expected a finite number"),
            ("RIGHT 1e999", "1: RIGHT: found \"1e999\", expected a finite number"),
            ("RIGHT 1 2", "1: RIGHT 1: found \"2\" behind the value, expected the end of the line"),
        ] {
            assert_eq!(Command::parse_all(text).unwrap_err(), expected, "{text:?}");
        }
    }

    #[test]
    fn line_ends_byte_order_marks_and_blank_lines_change_nothing() {
        assert_eq!(Map::parse("\u{feff}#s\r\n.\r\n"), Map::parse("#s\n."));
        let commands = Ok(vec![Command::Left(0.5), Command::Wait, Command::Jump(-1e-3)]);
        assert_eq!(Command::parse_all("\u{feff}LEFT .5\r\n\r\n WAIT\t7 \r\nJUMP -1e-3\r\n\r\n"), commands);
        assert_eq!(Command::parse_all("\n"), Ok(vec![]));
    }

    #[test]
    fn outside_the_map_and_behind_a_short_row_all_is_solid() {
        let map = Map::parse("..s\n\n.#").unwrap();
        assert_eq!(map.start, (2, 0));
        for (x, y) in [(0.0, 0.0), (2.999, 0.999), (0.5, 2.5)] {
            assert!(!map.is_solid(x, y), "({x}, {y})");
        }
        for (x, y) in [(-1e-9, 0.0), (0.0, -1e-9), (3.0, 0.0), (0.0, 1.0), (1.0, 2.0), (2.0, 2.0), (0.0, 3.0), (1e300, 0.0)] {
            assert!(map.is_solid(x, y), "({x}, {y})");
        }
    }
}
