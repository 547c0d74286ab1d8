//! The known word that an author probably meant.

use crate::words::tr;

/// Letters of a misspelt word for each slip: a word with more slips is another word.
const LETTERS_A_SLIP: usize = 3;

/// The known word nearest to `word`, whatever the case, if it is near enough to be meant.
pub(super) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.trim().to_lowercase();
    let slips = |known: &str| distance(&word, &known.to_lowercase());
    let best = known.into_iter().map(|known| (slips(known), known)).min_by_key(|(slips, _)| *slips);
    let longest = word.chars().count();
    best.filter(|(slips, known)| slips * LETTERS_A_SLIP <= longest.max(known.chars().count())).map(|(_, known)| known)
}

/// `; is "world.csv" meant?`, or empty.
pub(super) fn meant<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, known).map_or(String::new(), |known| tr!("; is {known} meant?", known = format_args!("{known:?}")))
}

/// The fewest letters to insert, leave out, change or exchange with their neighbours to make one word of another.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = match (i, j) {
                (0, n) | (n, 0) => n,
                _ => {
                    let changed = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                    let exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
                    let exchanged = if exchanged { rows[i - 2][j - 2] + 1 } else { usize::MAX };
                    changed.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1).min(exchanged)
                }
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_counted() {
        for (a, b, slips) in [("", "", 0), ("", "abc", 3), ("doors", "door", 1), ("wrold", "world", 1), ("kitten", "sitting", 3)] {
            assert_eq!((distance(a, b), distance(b, a)), (slips, slips), "{a} {b}");
        }
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
