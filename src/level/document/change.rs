//! The changes of an operation: in each file the bytes between the first and the last that differ.

use crate::level::schema::Table;

/// The change of one operation in a file: of each pair the first is before it, the second after it.
#[derive(Clone, Debug)]
pub(super) struct ByteChange {
    pub table: Table,
    exists: [bool; 2],
    at: usize,
    bytes: [Vec<u8>; 2],
}

#[derive(Clone, Debug)]
pub(super) struct EditChange {
    pub files: Vec<ByteChange>,
    /// Operations of one gesture, such as a drag, are undone together.
    pub gesture: Option<u64>,
}

impl ByteChange {
    /// `None` where no byte differs.
    pub fn between(table: Table, old: Option<&[u8]>, new: Option<&[u8]>) -> Option<Self> {
        let exists = [old.is_some(), new.is_some()];
        if old == new {
            return None;
        }
        let (old, new) = (old.unwrap_or_default(), new.unwrap_or_default());
        let at = old.iter().zip(new).take_while(|(a, b)| a == b).count();
        let (old, new) = (&old[at..], &new[at..]);
        let alike = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count();
        let bytes = [old, new].map(|bytes| bytes[..bytes.len() - alike].to_vec());
        Some(Self { table, exists, at, bytes })
    }

    pub fn undone(&self, after: Option<&[u8]>) -> Option<Vec<u8>> {
        self.turned(after, 0)
    }

    pub fn redone(&self, before: Option<&[u8]>) -> Option<Vec<u8>> {
        self.turned(before, 1)
    }

    fn turned(&self, now: Option<&[u8]>, to: usize) -> Option<Vec<u8>> {
        let mut bytes = now.unwrap_or_default().to_vec();
        bytes.splice(self.at..self.at + self.bytes[1 - to].len(), self.bytes[to].iter().copied());
        self.exists[to].then_some(bytes)
    }
}
