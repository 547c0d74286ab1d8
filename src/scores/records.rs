//! The records of a CSV file, each with the line it begins on as an editor counts it.
//!
//! The `csv` crate reads the cells. Where a record begins and ends is found here: the crate's own line numbers are off after CRLF and blank
//! lines, and one quotation mark that is never closed would swallow all rows behind it.

use csv::StringRecord;

/// What some editors put in front of UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// Why a record has no cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fault {
    /// The file ends inside quotes that begin in it. Only its first line is given up, not all that follow.
    Unclosed,
    /// Its bytes are no UTF-8.
    NotText,
}

impl Fault {
    /// What was found and what is expected, as a damage says it.
    pub const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Unclosed => ("a quotation mark that is never closed", "expected a second one at the end of its cell"),
            Self::NotText => ("bytes that are no text", "expected UTF-8"),
        }
    }
}

/// All records that hold something, with their lines. Lines end with LF, CRLF or CR; a byte-order mark is passed over.
pub(super) fn read(bytes: &[u8]) -> Vec<(usize, Result<StringRecord, Fault>)> {
    let mut rest = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    let (mut line, mut unclosed) = (1, false);
    let mut found: Vec<(usize, Option<Fault>)> = Vec::new();
    // What is sound, a record after the other, each ended by LF.
    let mut sound = Vec::with_capacity(rest.len());
    while !rest.is_empty() {
        let end = match record_end(rest, unclosed) {
            Some(end) => {
                let record = rest[..end].strip_suffix(b"\n").unwrap_or(&rest[..end]);
                let record = record.strip_suffix(b"\r").unwrap_or(record);
                if str::from_utf8(record).is_err() {
                    found.push((line, Some(Fault::NotText)));
                } else if !record.trim_ascii().is_empty() {
                    found.push((line, None));
                    sound.extend_from_slice(record);
                    sound.push(b'\n');
                }
                end
            }
            None => {
                found.push((line, Some(Fault::Unclosed)));
                unclosed = true;
                line_end(rest)
            }
        };
        line += line_count(&rest[..end]);
        rest = &rest[end..];
    }
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(sound.as_slice());
    let mut cells = reader.records();
    let mut record = || cells.next().and_then(Result::ok).ok_or(Fault::NotText);
    found.into_iter().map(|(line, fault)| (line, fault.map_or_else(&mut record, Err))).collect()
}

/// Where the first record of `bytes` ends, its line end included; `None` when a quotation mark in it is never closed.
///
/// `unclosed` says that an earlier record was of that kind. That one is within quotes at each line end up to the file's end, and
/// whatever is within quotes at one of them goes on like it: no record need be followed beyond its line, and reading takes time in
/// proportion to the file's length.
fn record_end(bytes: &[u8], unclosed: bool) -> Option<usize> {
    let (mut quoted, mut may_open) = (false, true);
    let mut index = 0;
    while index < bytes.len() {
        match bytes[index] {
            b'"' if quoted => (quoted, may_open) = (false, true), // one right behind it opens again: a doubled mark is one mark
            b'"' if may_open => quoted = true,
            b'\r' | b'\n' if quoted && unclosed => return None,
            b'\r' | b'\n' if !quoted => return Some(index + line_end(&bytes[index..])),
            byte => may_open = byte == b',',
        }
        index += 1;
    }
    (!quoted).then_some(bytes.len())
}

/// The length of the first line of `bytes` with its end: LF, CRLF or a CR alone.
fn line_end(bytes: &[u8]) -> usize {
    match bytes.iter().position(|&byte| byte == b'\r' || byte == b'\n') {
        Some(index) if bytes[index..].starts_with(b"\r\n") => index + 2,
        Some(index) => index + 1,
        None => bytes.len(),
    }
}

/// How many lines `bytes` holds.
fn line_count(mut bytes: &[u8]) -> usize {
    let mut count = 0;
    while !bytes.is_empty() {
        bytes = &bytes[line_end(bytes)..];
        count += 1;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    proptest::proptest! {
        /// The crate sees as many records as were cut here, and each has the cells that it has alone.
        #[test]
        fn records_are_those_of_the_csv_crate(text in "([a\", \r\n]|\"\"){0,16}") {
            let records = read(text.as_bytes());
            for (_, record) in &records {
                proptest::prop_assert!(*record != Err(Fault::NotText), "{text:?}");
            }
            if records.iter().all(|(_, record)| record.is_ok()) {
                let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
                let theirs = reader.records().map(Result::unwrap).filter(|record| record.len() > 1);
                let ours = records.into_iter().filter_map(|(_, record)| record.ok()).filter(|record| record.len() > 1);
                proptest::prop_assert!(ours.eq(theirs), "{text:?}");
            }
        }
    }
}
