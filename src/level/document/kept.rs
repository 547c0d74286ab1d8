//! The file of unsaved edits: the name and the length of each table, then its bytes.

use super::model::Document;
use crate::files;
use crate::level::schema::Table;

/// The file's first line.
const MARK: &str = "resultant autosave 1\n";
/// Its last line: a file without it was cut short.
const END: &str = "end\n";
/// The largest such file that is read, bytes: all tables at their limits, and room for their names.
pub(super) const MOST: u64 = (files::LEVEL_TABLE + 100) * Table::ALL.len() as u64;

/// Unsaved bytes of all files, by [`Table`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kept(pub(super) Vec<Option<Vec<u8>>>);

impl Document {
    /// One operation, which can be undone.
    pub fn restore(&mut self, kept: Kept) {
        self.replace_all(kept.0);
    }
}

pub(super) fn encoded(document: &Document) -> Vec<u8> {
    let mut all = MARK.as_bytes().to_vec();
    for table in Table::ALL {
        if let Some(bytes) = document.bytes(*table) {
            all.extend_from_slice(format!("{} {}\n", table.file(), bytes.len()).as_bytes());
            all.extend_from_slice(bytes);
        }
    }
    all.extend_from_slice(END.as_bytes());
    all
}

/// `None` where the bytes are no such file, or not whole.
pub(super) fn parse(bytes: &[u8]) -> Option<Kept> {
    let mut rest = bytes.strip_prefix(MARK.as_bytes())?;
    let mut kept = vec![None; Table::ALL.len()];
    while rest != END.as_bytes() {
        let end = rest.iter().position(|byte| *byte == b'\n')?;
        let (file, length) = std::str::from_utf8(&rest[..end]).ok()?.split_once(' ')?;
        let bytes = rest.get(end + 1..)?.get(..length.parse().ok()?)?;
        kept[Table::of_file(file)?.index()] = Some(bytes.to_vec());
        rest = &rest[end + 1 + bytes.len()..];
    }
    Some(Kept(kept))
}
