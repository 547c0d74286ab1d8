//! A problem of a level: its place, the found and the expected, with the known word that an author probably meant.

use crate::{files::found_instead, words::tr};
use std::{collections::BTreeMap, fmt};

const QUOTED_CHARACTERS: usize = 40;

/// It prints on one line, whatever the author's cells hold: `file:line: column "name": found …, expected …`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The file's name in the level folder.
    pub file: String,
    /// The line as an editor counts it, from 1; 1 where a whole table is meant, 0 in a file that is no table.
    pub line: usize,
    /// The column's name; for a cell beyond the last column its number, counted from 1; empty in a file that is no table.
    pub column: String,
    pub found: String,
    pub expected: String,
}

impl Problem {
    pub(super) fn new(file: &str, line: usize, column: &str, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self { file: file.into(), line, column: column.into(), found: found.into(), expected: expected.into() }
    }

    /// The problem with a file that has no lines and columns.
    pub(super) fn of_file(file: &str, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::new(file, 0, "", found, expected)
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, found, expected } = self;
        let place = if *line == 0 { file.clone() } else { place(file, *line, column) };
        f.write_str(&found_instead(&place, found, expected))
    }
}

/// As [`crate::files::place`], with a long name of a column cut.
fn place(file: &str, line: usize, column: &str) -> String {
    tr!("{file}:{line}: column {column}", file, line, column = quoted(column))
}
/// The most problems that are written out of all that differ only in the row.
const ALIKE: usize = 3;

/// The problems as they are printed, a line each; of problems that differ only in the row the first few, and a line that counts the rest.
pub fn listed(problems: &[Problem]) -> Vec<String> {
    let alike = |problem: &Problem| (problem.file.clone(), problem.column.clone(), problem.found.clone(), problem.expected.clone());
    // The count of a kind, and the line of the last.
    let mut kinds: BTreeMap<_, (usize, usize)> = BTreeMap::new();
    let number = |problem: &Problem| {
        let (count, last) = kinds.entry(alike(problem)).or_default();
        (*count, *last) = (*count + 1, problem.line);
        *count - 1
    };
    let numbers: Vec<usize> = problems.iter().map(number).collect();
    let line = |(problem, number): (&Problem, usize)| {
        let (count, last) = kinds[&alike(problem)];
        match Some(number).filter(|_| count > ALIKE + 1) {
            Some(ALIKE) => {
                let more = count - ALIKE;
                let Problem { file, line, column, found, .. } = problem;
                let place = place(file, *line, column);
                Some(tr!("{place}: found {found} in {more} more rows, the last in line {last}", place, found, more, last))
            }
            Some(further) if further > ALIKE => None,
            _ => Some(problem.to_string()),
        }
    };
    problems.iter().zip(numbers).filter_map(line).collect()
}

pub(super) const MOST_PROBLEMS: usize = 1000;

/// Stands in place of all further problems.
pub(super) fn too_many(file: &str, line: usize) -> Problem {
    Problem::new(file, line, "all", tr("more problems from here on"), at_most(MOST_PROBLEMS))
}

pub(super) fn at_most(most: usize) -> String {
    tr!("at most {most} in a level", most)
}

/// An author's text in quotes, on one line, cut when it is long.
pub(super) fn quoted(text: &str) -> String {
    match text.char_indices().nth(QUOTED_CHARACTERS) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}

/// Letters of a misspelt word for each slip, which inserts, leaves out, changes or exchanges letters: a word with more slips is another word.
const LETTERS_A_SLIP: usize = 3;

/// The known word nearest to `word`, whatever the case, if it is near enough to be meant.
pub(super) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.trim().to_lowercase();
    let slips = |known: &str| strsim::osa_distance(&word, &known.to_lowercase());
    let best = known.into_iter().map(|known| (slips(known), known)).min_by_key(|(slips, _)| *slips);
    let longest = word.chars().count();
    best.filter(|(slips, known)| slips * LETTERS_A_SLIP <= longest.max(known.chars().count())).map(|(_, known)| known)
}

/// `; is "world.csv" meant?`, or empty.
pub(super) fn meant<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, known).map_or(String::new(), |known| tr!("; is {known} meant?", known = format_args!("{known:?}")))
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
    fn problems_that_are_alike_are_summed_up() {
        let alike = |line| Problem::new("world.csv", line, "material", quoted("Cheese"), "one of Asphalt, Steel");
        let other = Problem::new("world.csv", 5, "x", quoted("a"), "a number");
        let mut problems: Vec<Problem> = (2..=1001).map(alike).collect();
        problems.insert(3, other.clone());
        let lines = listed(&problems);
        assert_eq!(lines.len(), 5, "{lines:?}");
        assert_eq!(lines[..4], [alike(2).to_string(), alike(3).to_string(), alike(4).to_string(), other.to_string()]);
        assert_eq!(lines[4], "world.csv:5: column \"material\": found \"Cheese\" in 997 more rows, the last in line 1001");
        assert_eq!(listed(&problems[..5]).len(), 5, "four of a kind take no less room summed up");
    }

    #[test]
    fn long_cells_are_cut_between_characters() {
        assert_eq!(quoted(&"é".repeat(41)), format!("\"{}\"…", "é".repeat(40)));
        assert_eq!(quoted(&"é".repeat(40)), format!("\"{}\"", "é".repeat(40)));
    }

    #[test]
    fn only_what_is_near_is_meant() {
        let known = ["gravity", "width", "height"];
        assert_eq!(nearest("Gravitiy", known), Some("gravity"));
        assert_eq!(nearest(" WIDHT", known), Some("width"));
        assert_eq!(nearest("colour", known), None);
        assert_eq!(meant("gravty", known), "; is \"gravity\" meant?");
        assert_eq!(meant("x", known), "");
    }
}
