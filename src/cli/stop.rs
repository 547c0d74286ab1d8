//! How a subcommand ends, and the texts that it leaves on a terminal.

use std::fmt::Display;
use std::io::{self, Write};
use std::time::{Duration, Instant};

/// An exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    Done = 0,
    /// A check or verification found a fault, also when nobody reads the report.
    Wrong = 1,
    /// Refused input, or results that could not be written: each file is the old one or the new one, whole.
    Refused = 2,
}

#[derive(Debug)]
pub enum CommandError {
    /// With the reason, a line a problem; ends with [`Status::Refused`].
    Refused(String),
    /// Ends with [`Status::Refused`], too.
    Output(io::Error),
}

impl CommandError {
    pub fn refused(reason: impl Display) -> Self {
        Self::Refused(reason.to_string())
    }
}

impl From<io::Error> for CommandError {
    /// For `?` behind `write!` to the output. Any other fault of reading or writing wants a message with its path.
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

/// Ticks between two looks at the clock, whose cost must not count.
pub(super) const TICKS_A_LOOK: u64 = 4096;
/// The time before the first line on a long flight, and between two lines.
const SILENCE: Duration = Duration::from_secs(2);

/// The time since the last line on a long flight.
pub(super) struct Silence(Instant);

impl Silence {
    pub fn new() -> Self {
        Self(Instant::now())
    }

    /// Whether a line is due; the next silence begins with it.
    pub fn is_over(&mut self) -> bool {
        let over = self.0.elapsed() >= SILENCE;
        if over {
            *self = Self::new();
        }
        over
    }
}

/// A stream until its reader goes away, as `head` does. Later writes go nowhere and change no result.
pub(super) struct Readers<W> {
    stream: W,
    gone: bool,
}

impl<W: Write> Readers<W> {
    pub const fn of(stream: W) -> Self {
        Self { stream, gone: false }
    }

    /// `done`, or `otherwise` once the reader has gone.
    fn unless_gone<T>(&mut self, done: impl FnOnce(&mut W) -> io::Result<T>, otherwise: T) -> io::Result<T> {
        if self.gone {
            return Ok(otherwise);
        }
        done(&mut self.stream).or_else(|error| {
            self.gone = error.kind() == io::ErrorKind::BrokenPipe;
            if self.gone { Ok(otherwise) } else { Err(error) }
        })
    }
}

impl<W: Write> Write for Readers<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.unless_gone(|stream| stream.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.unless_gone(Write::flush, ())
    }
}

/// A name or path with control characters written out, which would move a terminal's cursor or change its colours.
pub(super) fn shown(name: impl Display) -> String {
    let visible = |c: char| if c == '"' || c == '\'' || c == '\\' { vec![c] } else { c.escape_debug().collect() };
    name.to_string().chars().flat_map(visible).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shown_leaves_the_terminal_as_it_is() {
        assert_eq!(shown("höhle-2 \"a\\b\" '→'"), "höhle-2 \"a\\b\" '→'");
        assert_eq!(shown("a\u{1b}[31m\r\n\u{9b}2J\u{202e}\u{7f}"), "a\\u{1b}[31m\\r\\n\\u{9b}2J\\u{202e}\\u{7f}");
    }

    #[test]
    fn a_reader_that_has_gone_away_changes_nothing_and_a_full_disk_does() {
        struct Failing(io::ErrorKind);
        impl Write for Failing {
            fn write(&mut self, _: &[u8]) -> io::Result<usize> {
                Err(self.0.into())
            }
            fn flush(&mut self) -> io::Result<()> {
                Err(self.0.into())
            }
        }
        let mut gone = Readers::of(Failing(io::ErrorKind::BrokenPipe));
        assert!(gone.flush().is_ok() && gone.write_all(b"told to no one").is_ok());
        assert!(Readers::of(Failing(io::ErrorKind::StorageFull)).write_all(b"results").is_err());
    }
}
