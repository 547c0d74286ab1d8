/// FNV-1a, 64 bits (Fowler, Noll, Vo): the same on every machine and in every version of this program; not for secrets.
pub struct Fnv1a(u64);

impl Fnv1a {
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Takes in the eight bytes, the least significant one first.
    pub fn write(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    pub const fn finish(&self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_an_independent_computation() {
        assert_eq!(Fnv1a::new().finish(), 0xcbf2_9ce4_8422_2325);
        let mut hash = Fnv1a::new();
        hash.write(u64::from_le_bytes(*b"resultan"));
        assert_eq!(hash.finish(), 0xa849_dace_30d6_5343);
    }
}
