//! The hashes of played scenes and levels at their ends, in one place. They change whenever the engine, the rules or their state change on
//! purpose: then take over the lines that the failing tests print.

use super::measure::bits;
use resultant::physics::World;

const GOLDEN: [(&str, u64); 6] = [
    ("yard", 0x503b57d4c009cbcc),
    ("crowd", 0x90ce71a58cb93046),
    ("liquid", 0x3d34db8db9d41906),
    ("stream", 0x9b528f4b7eb4e525),
    ("moving surfaces", 0x4f1be127b521d020),
    ("moving surfaces, dense", 0xffd04c24bbee0d07),
];

#[track_caller]
pub fn assert_golden(name: &str, hash: u64) {
    let golden = GOLDEN.iter().find(|(known, _)| *known == name).map(|(_, golden)| *golden);
    assert!(golden == Some(hash), "tests/support/hashes.rs: the line is now\n    (\"{name}\", {hash:#018x}),");
}

/// The hash of all bits of a world's state (FNV-1a, by bytes).
pub fn hash_of(world: &World) -> u64 {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    bits(world).into_iter().flat_map(u64::to_le_bytes).fold(0xcbf2_9ce4_8422_2325, step)
}
