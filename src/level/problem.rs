//! What is wrong with a level: where, what was found, what is expected.

use std::fmt;

/// How many characters of an author's cell a message quotes.
const QUOTED_CHARACTERS: usize = 40;

/// One thing that is wrong, or only odd, in a level's files. It prints on one line, whatever the author's cells hold:
/// `file:line: column "name": found …, expected …`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The file's name in the level folder.
    pub file: String,
    /// The line as an editor counts it, from 1; 1 where a whole table is meant, 0 in what is no table.
    pub line: usize,
    /// The column's name; for a cell beyond the last column its number, counted from 1; empty in what is no table.
    pub column: String,
    /// What was found.
    pub found: String,
    /// What is expected there.
    pub expected: String,
}

impl Problem {
    /// The problem in that cell.
    pub(super) fn new(
        file: &str,
        line: usize,
        column: impl Into<String>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self { file: file.into(), line, column: column.into(), found: found.into(), expected: expected.into() }
    }
}

impl Problem {
    /// The problem with a file that has no lines and columns.
    pub(super) fn of_file(file: &str, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::new(file, 0, "", found, expected)
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, found, expected } = self;
        if *line == 0 {
            return write!(f, "{file}: found {found}, expected {expected}");
        }
        write!(f, "{file}:{line}: column {}: found {found}, expected {expected}", quoted(column))
    }
}

/// An author's text in quotes, on one line, cut when it is long.
pub(super) fn quoted(text: &str) -> String {
    match text.char_indices().nth(QUOTED_CHARACTERS) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_problem_stays_on_one_line() {
        let problem = Problem::new("texts.csv", 3, "a\nb", quoted("1\r\n2"), "a number");
        assert_eq!(problem.to_string(), r#"texts.csv:3: column "a\nb": found "1\r\n2", expected a number"#);
    }

    #[test]
    fn long_cells_are_cut_between_characters() {
        assert_eq!(quoted(&"é".repeat(41)), format!("\"{}\"…", "é".repeat(40)));
        assert_eq!(quoted(&"é".repeat(40)), format!("\"{}\"", "é".repeat(40)));
    }
}
