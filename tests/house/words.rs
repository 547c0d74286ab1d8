//! Comments, messages and pages are in plain words.

use super::sources::{files, root};
use std::fs;
use std::path::PathBuf;

/// Phrases that hide their subject.
const BANNED: [&str; 6] = ["is told", "are told", "anew", "so many", "whoever", "of whom"];
const FOLDERS: [&str; 9] = ["src", "tests", "tools", "benches", "platform", "docs", "levels", "scores", ".github"];
const PAGES: [&str; 4] = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", ".ci/run"];
const ENDINGS: [&str; 6] = ["rs", "md", "sh", "toml", "yml", "csv"];

fn has(line: &str, phrase: &str) -> bool {
    let in_word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    line.match_indices(phrase).any(|(at, _)| {
        let (before, after) = (&line[..at], &line[at + phrase.len()..]);
        !in_word(before.chars().next_back()) && !in_word(after.chars().next())
    })
}

#[test]
fn no_banned_word_is_written() {
    let mut found = Vec::new();
    let pages = PAGES.map(|page| root().join(page));
    let all = FOLDERS.iter().flat_map(|folder| files(&root().join(folder), &ENDINGS)).chain(pages);
    for path in all.filter(|path: &PathBuf| !path.ends_with("house/words.rs")) {
        let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).to_lowercase();
        for (number, line) in (1..).zip(text.lines()) {
            let words = BANNED.iter().filter(|phrase| has(line, phrase));
            found.extend(words.map(|phrase| format!("{}:{number}: {phrase}", path.strip_prefix(root()).unwrap().display())));
        }
    }
    assert!(found.is_empty(), "{} lines:\n{}", found.len(), found.join("\n"));
}
