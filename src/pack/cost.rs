//! The memory of a packed level, before it is unpacked: by the sizes in the archive, to which reading holds it, and by its
//! pictures' heads.

use crate::files;
use crate::level::FILES;

/// Bytes of memory a byte of a table, for reading, checks and building: `/usr/bin/time` shows 29 for tables of solids and objects
/// at their limits.
const TABLE: u64 = 32;
/// Bytes of memory a byte of a flight, with some room. Only one flight is in memory at a time.
const FLIGHT: u64 = 6;
/// Bytes a pixel: unpacked, as a texture and as a graphics driver's copy, 4 bytes each; or at 16 bits a channel while it is
/// unpacked.
const PIXEL: u64 = 12;
const DEEP_PIXEL: u64 = 8;
/// A PNG's first bytes; then length and name of its head, width and height.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
const SIDES: usize = 16;

#[derive(Debug, Default)]
pub(super) struct Cost {
    /// The archive and its unpacked files.
    files: u64,
    tables: u64,
    largest_flight: u64,
    pixels: u64,
    most_pixels: u64,
}

impl Cost {
    /// Bytes of a file that tell its cost.
    pub const HEAD: u64 = 24;

    /// Bytes.
    pub fn of_archive(packed: u64) -> Self {
        Self { files: packed, ..Self::default() }
    }

    /// `head` is the beginning of the file.
    pub fn add(&mut self, path: &str, size: u64, head: &[u8]) {
        self.files = self.files.saturating_add(size);
        if path.to_lowercase().ends_with(super::package::FLIGHT) {
            self.largest_flight = self.largest_flight.max(size);
        } else if path.rsplit('/').next().is_some_and(|name| FILES.contains(&name)) {
            // The size of a larger one refuses it.
            self.tables += size.min(files::LEVEL_TABLE);
        }
        if let Some(pixels) = pixels(head) {
            self.pixels = self.pixels.saturating_add(pixels);
            self.most_pixels = self.most_pixels.max(pixels);
        }
    }

    pub fn bytes(&self) -> u64 {
        let Self { files, tables, largest_flight, pixels, most_pixels } = *self;
        let pictures = pixels.saturating_mul(PIXEL).saturating_add(most_pixels.saturating_mul(DEEP_PIXEL));
        files.saturating_add(tables * TABLE).saturating_add(largest_flight.saturating_mul(FLIGHT)).saturating_add(pictures)
    }
}

/// The pixels of a PNG with that head.
fn pixels(head: &[u8]) -> Option<u64> {
    let side = |at: usize| Some(u64::from(u32::from_be_bytes(*head.get(at..)?.first_chunk()?)));
    if head.starts_with(SIGNATURE) { Some(side(SIDES)?.saturating_mul(side(SIDES + 4)?)) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(width: u32, height: u32) -> Vec<u8> {
        [SIGNATURE, b"\0\0\0\x0dIHDR", &width.to_be_bytes(), &height.to_be_bytes()].concat()
    }

    #[test]
    fn each_kind_of_file_costs_what_it_becomes() {
        let one = |path: &str, size: u64, head: &[u8]| {
            let mut cost = Cost::default();
            cost.add(path, size, head);
            cost.bytes()
        };
        assert_eq!(one("t/notes.txt", 100, b""), 100);
        assert_eq!(one("t/world.csv", 100, b""), 100 + 100 * TABLE);
        assert_eq!(one("t/flights/a.replay.csv", 100, b""), 100 + 100 * FLIGHT);
        assert_eq!(one("t/a.png", 100, &head(1000, 500)), 100 + 500_000 * (PIXEL + DEEP_PIXEL));
        assert_eq!(one("t/a.png", 100, &head(u32::MAX, u32::MAX)), u64::MAX);
        assert_eq!((one("t/a.png", 9, b"no picture"), one("t/a.png", 9, SIGNATURE)), (9, 9));
    }

    #[test]
    fn of_several_flights_and_pictures_one_at_a_time_is_read() {
        let mut cost = Cost::of_archive(1000);
        for path in ["t/flights/a.replay.csv", "t/flights/b.replay.csv"] {
            cost.add(path, 10, b"");
        }
        cost.add("t/a.png", 1, &head(10, 10));
        cost.add("t/b.png", 1, &head(20, 10));
        assert_eq!(cost.bytes(), 1000 + 20 + 10 * FLIGHT + 2 + 300 * PIXEL + 200 * DEEP_PIXEL);
    }
}
