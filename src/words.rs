//! The languages of the screens. The English text of the source is the key of its German and French ones in `assets/words/`; a text
//! that a catalogue lacks stays English, as do the command line and all files.
//!
//! Templates have named places: `tr!("{count} levels in {name}", count = 3, name)`. Each language orders them as it likes.

use crate::built_in::SHIPPED;
use std::sync::{LazyLock, Mutex, OnceLock, PoisonError};
use std::{borrow::Cow, cell::Cell, collections::HashMap, fmt::Display};

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    #[default]
    English,
    German,
    French,
    /// For tests: English in letters of full width, so that a text that passes by the catalogues shows.
    Wide,
}

thread_local! {
    static SPOKEN: Cell<Language> = const { Cell::new(Language::English) };
}

static OF_SYSTEM: OnceLock<Language> = OnceLock::new();
static CATALOGUES: LazyLock<[HashMap<String, String>; 2]> =
    LazyLock::new(|| [Language::German, Language::French].map(|language| rows(language).into_iter().collect()));
/// Each text that was widened, for good: only tests ask for them.
static WIDENED: Mutex<Option<HashMap<String, &'static str>>> = Mutex::new(None);

impl Language {
    /// In the order of the settings.
    pub const ALL: [Self; 3] = [Self::English, Self::German, Self::French];

    /// As in the settings' file and in the name of the catalogue.
    pub const fn code(self) -> &'static str {
        match self {
            Self::English | Self::Wide => "en",
            Self::German => "de",
            Self::French => "fr",
        }
    }

    /// In the language itself.
    pub const fn name(self) -> &'static str {
        match self {
            Self::English | Self::Wide => "English",
            Self::German => "Deutsch",
            Self::French => "Français",
        }
    }

    /// The language of a system that names it so: `de_AT.UTF-8`, `fr-CA`; English for all others.
    pub fn named(system: &str) -> Self {
        let code = system.get(..2).unwrap_or_default();
        Self::ALL.into_iter().find(|language| language.code().eq_ignore_ascii_case(code)).unwrap_or_default()
    }

    /// That of [`note_system`], else English.
    pub fn of_system() -> Self {
        OF_SYSTEM.get().copied().unwrap_or_default()
    }
}

/// The language of a setting that names none, for all of this process. A second call changes nothing.
pub fn note_system(language: Language) {
    let _ = OF_SYSTEM.set(language);
}

/// The language of this thread from now on.
pub fn speak(language: Language) {
    SPOKEN.set(language);
}

/// The language of this thread.
pub fn spoken() -> Language {
    SPOKEN.get()
}

/// The English texts and those of a language, in the order of its file.
pub fn rows(language: Language) -> Vec<(String, String)> {
    let path = format!("assets/words/{}.csv", language.code());
    let file = SHIPPED.iter().find(|(name, _)| *name == path).map_or(&b""[..], |(_, bytes)| bytes);
    let records = csv::Reader::from_reader(file).into_records().filter_map(Result::ok);
    records.filter_map(|record| Some((record.get(0)?.to_owned(), record.get(1)?.to_owned()))).collect()
}

/// With English on this thread meanwhile, as for files.
pub fn in_english<T>(make: impl FnOnce() -> T) -> T {
    let before = SPOKEN.replace(Language::English);
    let made = make();
    SPOKEN.set(before);
    made
}

/// The text in the language of this thread.
pub fn tr(text: &str) -> &str {
    let look_up = |catalogue: usize| CATALOGUES[catalogue].get(text).map(String::as_str);
    let found = match spoken() {
        Language::English => None,
        Language::German => look_up(0),
        Language::French => look_up(1),
        Language::Wide => look_up(0).map(|_| widened(text)),
    };
    found.unwrap_or(text)
}

/// The text with the decimal marks of the language of this thread: a comma in German and French, where a semicolon parts a pair in
/// brackets. What has three parts, as a version, is no number.
pub fn decimals(text: &str) -> Cow<'_, str> {
    if !text.contains(['.', '(']) || !matches!(spoken(), Language::German | Language::French) {
        return Cow::Borrowed(text);
    }
    let digits = |c: char| c.is_ascii_digit();
    let is_mark = |at: usize| {
        let (before, behind) = (&text[..at], &text[at + 1..]);
        let (whole, parts) = (before.trim_end_matches(digits), behind.trim_start_matches(digits));
        let goes_on = |rest: &str| rest.strip_prefix('.').is_some_and(|rest| rest.starts_with(digits));
        let began = whole.strip_suffix('.').is_some_and(|rest| rest.ends_with(digits));
        whole.len() < before.len() && parts.len() < behind.len() && !began && !goes_on(parts)
    };
    let in_pair = |at: usize| {
        let ends = text[..at].rfind('(').zip(text[at..].find(')'));
        ends.is_some_and(|(from, to)| !text[from..at + to].contains(char::is_alphabetic))
    };
    let said = |(at, c)| match c {
        '.' if is_mark(at) => ',',
        ',' if in_pair(at) => ';',
        _ => c,
    };
    Cow::Owned(text.char_indices().map(said).collect())
}

/// A template with its places filled.
pub fn filled(template: &str, places: &[(&str, &dyn Display)]) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, (place, after))) =
        rest.split_once('{').and_then(|(before, behind)| Some((before, behind.split_once('}')?)))
    {
        text.push_str(before);
        match places.iter().find(|(name, _)| *name == place) {
            Some((_, value)) => text.push_str(&value.to_string()),
            None => text.extend(["{", place, "}"]),
        }
        rest = after;
    }
    text + rest
}

/// A template in the language of this thread, with its places filled. `name` alone stands for `name = name`; numbers with a format are
/// `format_args!`.
macro_rules! template {
    (@value $place:ident) => { $place };
    (@value $place:ident $value:expr) => { $value };
    ($text:expr, $($place:ident $(= $value:expr)?),+ $(,)?) => {
        $crate::words::filled(
            $crate::words::tr($text),
            &[$((stringify!($place), &$crate::words::tr!(@value $place $($value)?) as &dyn std::fmt::Display)),+],
        )
    };
}
pub(crate) use template as tr;

/// Letters of full width outside of the places of a template.
fn widened(text: &str) -> &'static str {
    let mut known = WIDENED.lock().unwrap_or_else(PoisonError::into_inner);
    known.get_or_insert_default().entry(text.to_owned()).or_insert_with(|| {
        let mut inside = false;
        let wide = |letter: char| {
            inside = letter == '{' || inside && letter != '}';
            let code = u32::from(letter) + if letter.is_ascii_alphabetic() && !inside { 0xFEE0 } else { 0 };
            char::from_u32(code).unwrap_or(letter)
        };
        text.chars().map(wide).collect::<String>().leak()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_looked_up_in_the_language_of_the_thread() {
        let texts = || [tr("Play"), tr("no such text")];
        assert_eq!(texts(), ["Play", "no such text"]);
        speak(Language::German);
        assert_eq!(texts(), ["Spielen", "no such text"]);
        speak(Language::French);
        assert_eq!(texts(), ["Jouer", "no such text"]);
        std::thread::spawn(move || assert_eq!(tr("Play"), "Play")).join().unwrap();
        speak(Language::Wide);
        assert_eq!(texts(), ["Ｐｌａｙ", "no such text"]);
        speak(Language::English);
    }

    #[test]
    fn numbers_have_the_decimal_mark_of_the_language() {
        let english = "e = 0.5, (−1.25,  0) kN, 2.0 m. 00:05.50 1.0.0 (a, b.csv) 1. .5 5.";
        let commas = "e = 0,5, (−1,25;  0) kN, 2,0 m. 00:05,50 1.0.0 (a, b.csv) 1. .5 5.";
        for (language, said) in [(Language::German, commas), (Language::French, commas), (Language::English, english)] {
            speak(language);
            assert_eq!(decimals(english), said);
        }
    }

    #[test]
    fn places_are_filled_by_their_names() {
        let name = "Ann {count}";
        assert_eq!(tr!("{count} of {name}, {lost} {", count = format_args!("{:.1}", 2.0), name), "2.0 of Ann {count}, {lost} {");
    }

    #[test]
    fn the_systems_language_is_known_by_its_first_letters() {
        let all = ["de_AT.UTF-8", "FR", "fr-CA", "C", "", "é", "nl"].map(|name| Language::named(name).code());
        assert_eq!(all, ["de", "fr", "fr", "en", "en", "en", "en"]);
    }
}
