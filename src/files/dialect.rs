//! How a file separates its cells and writes its numbers, as spreadsheets of many countries do, and its encoding.

use crate::words::tr;
use std::borrow::Cow;

/// The encodings that a file tells by its first bytes; without a mark it is UTF-8.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    #[default]
    Utf8,
    /// With a byte-order mark, as Excel's "CSV UTF-8".
    MarkedUtf8,
    /// With a byte-order mark, as Excel's "Unicode Text".
    Utf16Le,
    Utf16Be,
}

const MARKS: [(Encoding, &[u8]); 3] =
    [(Encoding::MarkedUtf8, b"\xEF\xBB\xBF"), (Encoding::Utf16Le, b"\xFF\xFE"), (Encoding::Utf16Be, b"\xFE\xFF")];

impl Encoding {
    /// The text behind the mark, its encoding, and whether some bytes were no text: they are U+FFFD.
    pub fn decode(bytes: &[u8]) -> (String, Self, bool) {
        let marked = MARKS.into_iter().find_map(|(encoding, mark)| Some((encoding, bytes.strip_prefix(mark)?)));
        let (encoding, rest) = marked.unwrap_or((Self::Utf8, bytes));
        let wide = |unit: fn([u8; 2]) -> u16| {
            let (pairs, odd) = rest.as_chunks();
            let units: Vec<u16> = pairs.iter().map(|pair| unit(*pair)).collect();
            let broken = !odd.is_empty() || char::decode_utf16(units.iter().copied()).any(|c| c.is_err());
            let end = if odd.is_empty() { "" } else { "\u{fffd}" };
            (String::from_utf16_lossy(&units) + end, encoding, broken)
        };
        match encoding {
            Self::Utf16Le => wide(u16::from_le_bytes),
            Self::Utf16Be => wide(u16::from_be_bytes),
            Self::Utf8 | Self::MarkedUtf8 => match String::from_utf8_lossy(rest) {
                Cow::Borrowed(text) => (text.to_owned(), encoding, false),
                Cow::Owned(text) => (text, encoding, true),
            },
        }
    }

    /// The text of a whole file. Errors: the line of the first bytes that are no text.
    pub fn text(bytes: &[u8]) -> Result<String, usize> {
        let (text, _, broken) = Self::decode(bytes);
        let before = &text[..text.find(char::REPLACEMENT_CHARACTER).unwrap_or(text.len())];
        if broken { Err(1 + before.bytes().filter(|byte| *byte == b'\n').count()) } else { Ok(text) }
    }

    pub fn encode(self, text: &str) -> Vec<u8> {
        let mark = MARKS.into_iter().find(|(encoding, _)| *encoding == self).map_or(&[][..], |(_, mark)| mark);
        let wide = |bytes: fn(u16) -> [u8; 2]| mark.iter().copied().chain(text.encode_utf16().flat_map(bytes)).collect();
        match self {
            Self::Utf16Le => wide(u16::to_le_bytes),
            Self::Utf16Be => wide(u16::to_be_bytes),
            Self::Utf8 | Self::MarkedUtf8 => [mark, text.as_bytes()].concat(),
        }
    }
}

/// Where cells are not separated by commas, numbers may have a decimal comma.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dialect {
    pub delimiter: u8,
    pub encoding: Encoding,
}

impl Dialect {
    /// Commas and UTF-8.
    pub const PLAIN: Self = Self { delimiter: b',', encoding: Encoding::Utf8 };
    /// The first one wins where several suit a file equally well.
    pub const DELIMITERS: [u8; 3] = [b',', b';', b'\t'];

    pub fn sign(self) -> char {
        char::from(self.delimiter)
    }

    pub fn takes_decimal_commas(self) -> bool {
        self.delimiter != b','
    }

    /// A cell's number as Rust writes it: with a decimal point, a plain minus, and no space between thousands. What is no number stays.
    pub fn number(self, text: &str) -> Cow<'_, str> {
        if self.is_plain(text) {
            return text.into();
        }
        let plain: String = self.with_points(without_thousands(text).as_deref().unwrap_or(text)).collect();
        if plain.parse::<f64>().is_ok() { plain.into() } else { text.into() }
    }

    /// As [`Dialect::number`], of a cell with several numbers, between which any space or a semicolon may stand.
    pub fn numbers(self, text: &str) -> Cow<'_, str> {
        if self.is_plain(text) {
            return text.into();
        }
        let plain: String = self.with_points(text).collect();
        let mut parts = plain.split(|c: char| c.is_whitespace() || c == ';').filter(|part| !part.is_empty());
        if parts.all(|part| part.parse::<f64>().is_ok()) { plain.into() } else { text.into() }
    }

    fn is_plain(self, text: &str) -> bool {
        text.is_ascii() && !(self.takes_decimal_commas() && text.contains(','))
    }

    fn with_points(self, text: &str) -> impl Iterator<Item = char> {
        text.chars().map(move |c| match c {
            ',' if self.takes_decimal_commas() => '.',
            c if MINUS.contains(&c) => '-',
            c => c,
        })
    }

    /// A text as a cell: in quotes where `quoted` says so, or where they are needed.
    pub fn encoded(self, text: &str, quoted: bool) -> String {
        let quoted = quoted || text.contains([self.sign(), '"', '\n', '\r']);
        if quoted { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
    }

    /// For the author of a file; `None` for commas and UTF-8, with or without a mark.
    pub fn words(self) -> Option<String> {
        let wide = matches!(self.encoding, Encoding::Utf16Le | Encoding::Utf16Be).then_some("UTF-16");
        let words: Vec<&str> = separators(self.delimiter).into_iter().filter(|_| self.takes_decimal_commas()).chain(wide).collect();
        (!words.is_empty()).then(|| words.join(", "))
    }
}

/// `semicolons`, in words.
pub fn separators(delimiter: u8) -> Option<&'static str> {
    match delimiter {
        b',' => Some(tr("commas")),
        b';' => Some(tr("semicolons")),
        b'\t' => Some(tr("tabs")),
        _ => None,
    }
}

/// The typographic minus, and the dash that stands in for it.
const MINUS: [char; 2] = ['\u{2212}', '\u{2013}'];
/// What French spreadsheets write between thousands.
const NARROW_SPACES: [char; 3] = ['\u{a0}', '\u{2009}', '\u{202f}'];

/// A number without the spaces between its thousands; `None` where there are none, or at other places.
fn without_thousands(text: &str) -> Option<String> {
    let whole = &text[..text.find(['.', ',']).unwrap_or(text.len())];
    let mut groups = whole.split(NARROW_SPACES);
    let first = groups.next()?.trim_start_matches(|c| c == '+' || c == '-' || MINUS.contains(&c));
    let digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    let grouped = (1..=3).contains(&first.len()) && digits(first) && groups.all(|group| group.len() == 3 && digits(group));
    (grouped && whole.contains(NARROW_SPACES)).then(|| text.replace(NARROW_SPACES, ""))
}

/// TRUE or FALSE in any case, also as the spreadsheets of other languages write it.
pub fn truth(text: &str) -> Option<bool> {
    const YES: [&str; 6] = ["TRUE", "WAHR", "VRAI", "VERDADERO", "VERO", "WAAR"];
    const NO: [&str; 5] = ["FALSE", "FALSCH", "FAUX", "FALSO", "ONWAAR"];
    let is = |words: &[&str]| words.iter().any(|word| word.eq_ignore_ascii_case(text));
    if is(&YES) { Some(true) } else { is(&NO).then_some(false) }
}

/// A whole number's text without a fraction of zeros: a spreadsheet writes 1.0 for 1.
pub fn whole(text: &str) -> &str {
    text.split_once('.').filter(|(_, fraction)| fraction.bytes().all(|byte| byte == b'0')).map_or(text, |(whole, _)| whole)
}

/// What a file says by a first line `sep=;`: the sign and the length of that line, without its end.
pub(super) fn said(text: &str) -> Option<(char, usize)> {
    let line = &text[..text.find(['\n', '\r']).unwrap_or(text.len())];
    let rest = line.trim_start().trim_start_matches('"');
    let rest = rest.get(4..).filter(|_| rest[..4].eq_ignore_ascii_case("sep="))?;
    let sign = rest.chars().next()?;
    // A spreadsheet fills the line with empty cells.
    let is_empty = |c: char| c == sign || c == '"' || c.is_whitespace() || Dialect::DELIMITERS.map(char::from).contains(&c);
    rest.chars().all(is_empty).then_some((sign, line.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SEMICOLONS: Dialect = Dialect { delimiter: b';', encoding: Encoding::Utf8 };

    #[test]
    fn numbers_of_spreadsheets_are_plain_numbers() {
        for (text, plain) in [
            ("1,5", "1.5"),
            ("\u{2212}1,5e3", "-1.5e3"),
            ("1\u{202f}234\u{a0}567,8", "1234567.8"),
            ("1.5", "1.5"),
            ("12\u{a0}34", "12\u{a0}34"),
            ("1.234,5", "1.234,5"),
            (",", ","),
        ] {
            assert_eq!(SEMICOLONS.number(text), plain, "{text}");
        }
        assert_eq!((Dialect::PLAIN.number("1,5"), Dialect::PLAIN.number("–2")), ("1,5".into(), "-2".into()));
        assert_eq!([whole("1.0"), whole("1."), whole("1.50"), whole("1"), whole("1.0x")], ["1", "1", "1.50", "1", "1.0x"]);
        assert_eq!([truth("wahr"), truth("FAUX"), truth("yes")], [Some(true), Some(false), None]);
    }

    #[test]
    fn a_file_says_its_separator_in_its_first_line() {
        for (text, expected) in [
            ("sep=;\n1;2", Some((';', 5))),
            ("\"SEP=\t\"\r\n1", Some(('\t', 7))),
            ("sep=,;;;\n", Some((',', 8))),
            ("sep=|", Some(('|', 5))),
            ("sep=", None),
            ("separate", None),
            ("sep=;x", None),
            ("sé=", None),
        ] {
            assert_eq!(said(text), expected, "{text:?}");
        }
    }

    proptest::proptest! {
        #[test]
        fn every_encoding_comes_back(text in "[^\u{feff}\u{fffd}]{0,9}") {
            for encoding in [Encoding::Utf8, Encoding::MarkedUtf8, Encoding::Utf16Le, Encoding::Utf16Be] {
                proptest::prop_assert_eq!(Encoding::decode(&encoding.encode(&text)), (text.clone(), encoding, false));
            }
        }
    }
}
