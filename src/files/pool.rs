//! Readers of the `csv` crate, kept for the next file: a new one takes some 15 µs for its tables of states.

use csv::{Position, Reader, ReaderBuilder, StringRecord};
use std::cell::RefCell;
use std::io::{Cursor, SeekFrom};

type MemoryReader = Reader<Cursor<Vec<u8>>>;

thread_local! {
    /// By their delimiters.
    static KEPT: RefCell<Vec<(u8, MemoryReader)>> = const { RefCell::new(Vec::new()) };
}

pub(super) struct Pooled {
    delimiter: u8,
    /// `None` only once it is dropped.
    reader: Option<MemoryReader>,
}

impl Pooled {
    pub fn new(delimiter: u8, text: &[u8]) -> Self {
        let kept = KEPT.with_borrow_mut(|kept| {
            let index = kept.iter().position(|(of, _)| *of == delimiter)?;
            Some(kept.swap_remove(index).1)
        });
        let fresh = || ReaderBuilder::new().has_headers(false).flexible(true).delimiter(delimiter).from_reader(Cursor::default());
        let mut reader = kept.unwrap_or_else(fresh);
        *reader.get_mut() = Cursor::new(text.to_vec());
        let mut pooled = Self { delimiter, reader: Some(reader) };
        pooled.seek(0);
        pooled
    }

    pub fn byte(&self) -> usize {
        // The text is in memory: its length is a usize.
        self.reader.as_ref().map_or(0, |reader| reader.position().byte() as usize)
    }

    pub fn seek(&mut self, byte: usize) {
        let mut position = Position::new();
        position.set_byte(byte as u64);
        // Memory takes every place.
        drop(self.reader.as_mut().map(|reader| reader.seek_raw(SeekFrom::Start(byte as u64), position)));
    }

    /// The next record; `false` at the end.
    pub fn read(&mut self, record: &mut StringRecord) -> bool {
        self.reader.as_mut().is_some_and(|reader| reader.read_record(record).unwrap_or(false))
    }
}

impl Drop for Pooled {
    fn drop(&mut self) {
        let Some(mut reader) = self.reader.take() else { return };
        *reader.get_mut() = Cursor::default();
        // While a thread ends there is no pool any more.
        let _ = KEPT.try_with(|kept| kept.borrow_mut().push((self.delimiter, reader)));
    }
}
