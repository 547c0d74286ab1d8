//! The catalogues of the languages are complete: each text that the source or a shipped file shows stands in all of them, with the same
//! places, and no row is of no use.

use super::sources::{files, root};
use proc_macro2::{Group, TokenStream, TokenTree};
use resultant::files::EXPERIMENTS;
use resultant::game::Outcome;
use resultant::level::schema::{Kind, SETTINGS};
use resultant::physics::{ForceKind, Guards, Methods};
use resultant::settings::{Action, Item, Key};
use resultant::words::{Language, rows};
use std::collections::BTreeSet;
use std::fs;
use syn::Lit;

/// What stands before the brackets of a call whose words are looked up.
const CALLS: [&str; 9] =
    ["tr", "tr !", "ui . page", "ui . button", "ui . buttons", "ui . row", "ui . column", "ui . choice", "SaveError : : file"];

fn literals(tokens: TokenStream) -> Vec<String> {
    let is_doc = |group: &Group| group.stream().into_iter().next().is_some_and(|first| first.to_string() == "doc");
    let of = |token| match token {
        TokenTree::Group(group) if !is_doc(&group) => literals(group.stream()),
        TokenTree::Literal(literal) => match Lit::new(literal) {
            Lit::Str(text) => vec![text.value()],
            _ => vec![],
        },
        _ => vec![],
    };
    tokens.into_iter().flat_map(of).collect()
}

/// The literals that stand inside the brackets of one of the calls.
fn looked_up(tokens: TokenStream) -> BTreeSet<String> {
    let (mut found, mut before) = (BTreeSet::new(), String::new());
    for token in tokens {
        if let TokenTree::Group(group) = &token {
            let is_call = |call: &&str| before.ends_with(&format!(" {call}")) && !before.ends_with(&format!(" fn {call}"));
            found.extend(if CALLS.iter().any(is_call) { literals(group.stream()) } else { vec![] });
            found.extend(looked_up(group.stream()));
            before.clear();
        } else {
            before = format!("{before} {token}");
        }
    }
    found
}

/// Whether a text has words, not signs, places and numbers alone.
fn has_words(text: &str) -> bool {
    let mut inside = false;
    let outside = |letter: &char| {
        inside = *letter == '{' || inside && *letter != '}';
        !inside
    };
    let letters: String = text.chars().filter(outside).map(|letter| if letter.is_alphabetic() { letter } else { ' ' }).collect();
    letters.split(' ').any(|word| word.chars().count() > 1)
}

fn sources() -> Vec<TokenStream> {
    let paths = files(&root().join("src"), &["rs"]).into_iter().filter(|path| !path.ends_with("tests.rs"));
    let texts = paths.map(|path| fs::read_to_string(path).unwrap());
    texts.map(|text| text.split("#[cfg(test)]\nmod tests {").next().unwrap().parse().expect("it is Rust")).collect()
}

/// The texts of shipped files that a screen shows: titles, hints and words of levels and experiments.
fn shown_by_files() -> BTreeSet<String> {
    let mut texts = BTreeSet::new();
    for path in files(&root().join("levels"), &["csv"]) {
        let bytes = fs::read(&path).unwrap();
        let records = || {
            csv::ReaderBuilder::new().has_headers(false).flexible(true).comment(Some(b'#')).from_reader(&bytes[..]).into_records()
        };
        let cells = records().filter_map(Result::ok).enumerate();
        match path.file_name().and_then(|name| name.to_str()) {
            Some("constants.csv") => texts.extend(cells.filter(|(_, row)| &row[0] == "title").map(|(_, row)| row[1].to_owned())),
            Some("hints.csv") => texts.extend(cells.skip(1).map(|(_, row)| row[0].to_owned())),
            Some("texts.csv") => texts.extend(cells.skip(1).map(|(_, row)| row[3].to_owned())),
            Some("experiments.csv") => texts.extend(cells.skip(1).flat_map(|(_, row)| {
                let choices: Vec<String> = row[4].split('|').map(str::to_owned).collect();
                let wanted = row[6].split('|').filter_map(|part| part.rsplit_once(": "));
                let wanted = wanted.flat_map(|(what, _)| what.splitn(2, ", ").map(str::to_owned)).collect();
                [[row[1].to_owned(), row[2].to_owned(), row[3].to_owned()].to_vec(), choices, wanted].concat()
            })),
            _ => {}
        }
    }
    texts.retain(|text| has_words(text) && !is_quantity(text));
    texts
}

/// A number or letter with its unit, as in "60 kg/m³" and "e = 0.5".
fn is_quantity(text: &str) -> bool {
    const UNITS: [&str; 5] = ["kg", "m", "N", "s", "e"];
    let words = text.split(|letter: char| !letter.is_alphabetic()).filter(|word| !word.is_empty());
    words.clone().all(|word| UNITS.contains(&word))
}

/// The engine's names of its methods and guards, as F3 shows them.
fn shown_by_engine() -> impl Iterator<Item = String> {
    let (methods, guards) = (Methods::default(), Guards::default());
    let names = methods.all().map(|(name, _)| name).chain(guards.all().map(|(name, _)| name));
    names.map(|name| name.replace('_', " ")).collect::<Vec<_>>().into_iter()
}

fn catalogues() -> [(Language, Vec<(String, String)>); 2] {
    [Language::German, Language::French].map(|language| (language, rows(language)))
}

#[test]
fn every_text_stands_in_every_catalogue() {
    let mut wanted: BTreeSet<String> = sources().into_iter().flat_map(looked_up).filter(|text| has_words(text)).collect();
    wanted.extend(shown_by_files());
    wanted.extend(shown_by_engine());
    wanted.extend([Outcome::Running, Outcome::Completed, Outcome::Failed].map(|outcome| outcome.name().to_owned()));
    wanted.extend(Action::ALL.map(|action| action.label().to_owned()));
    wanted.extend(Item::ALL.map(|item| item.label().to_owned()));
    wanted.extend(Kind::ALL.iter().map(|kind| kind.name().to_owned()));
    let columns = Kind::ALL.iter().flat_map(|kind| kind.schema().columns).chain(SETTINGS);
    wanted.extend(columns.map(|column| column.help.to_owned()));
    wanted.extend(ForceKind::ALL.iter().flat_map(|kind| [kind.shown().to_owned(), kind.does().to_owned()]));
    let named = |label: &String| label.len() > 3 && !label.starts_with("Num") && !label.starts_with("Pad");
    wanted.extend(Key::ALL.iter().map(|key| key.label()).filter(named));
    for (language, rows) in catalogues() {
        let known: BTreeSet<String> = rows.iter().map(|(english, _)| english.clone()).collect();
        let missing: Vec<&String> = wanted.difference(&known).collect();
        assert!(missing.is_empty(), "{language:?} lacks {} texts:\n{missing:#?}", missing.len());
    }
}

#[test]
fn every_row_is_of_use_and_keeps_its_places() {
    let mut known: BTreeSet<String> = sources().into_iter().flat_map(literals).collect();
    known.extend(shown_by_files());
    known.extend(shown_by_engine());
    known.extend(Key::ALL.iter().map(|key| key.label()));
    for folder in [EXPERIMENTS, "docs/charts"] {
        for path in files(&root().join(folder), &["csv"]) {
            let bytes = fs::read(&path).unwrap();
            let records = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(&bytes[..]).into_records();
            known.extend(records.filter_map(Result::ok).flat_map(|row| row.iter().map(str::to_owned).collect::<Vec<_>>()));
        }
    }
    let places = |text: &str| {
        let mut places: Vec<String> = text.split('{').skip(1).filter_map(|part| Some(part.split_once('}')?.0.to_owned())).collect();
        places.sort();
        places
    };
    for (language, rows) in catalogues() {
        let mut before = BTreeSet::new();
        for (english, text) in rows {
            assert!(known.contains(&english), "{language:?}: nothing shows {english:?}");
            assert!(!text.is_empty() && before.insert(english.clone()), "{language:?}: {english:?} is empty or there twice");
            assert_eq!(places(&english), places(&text), "{language:?}: {english:?} and {text:?} have other places");
            let ends = |text: &str| (text.starts_with(' '), text.ends_with(' '));
            assert_eq!(ends(&english), ends(&text), "{language:?}: {english:?} and {text:?} begin or end with other spaces");
        }
    }
}
