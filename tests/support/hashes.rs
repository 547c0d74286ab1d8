//! The hashes of played scenes and levels at their ends, in one place. They change whenever the engine, the rules or their state change on
//! purpose: then take over the lines that the failing tests print.

use super::measure::bits;
use resultant::physics::World;

const GOLDEN: [(&str, u64); 6] = [
    ("yard", 0xd5e3_a6c0_6de7_4c21),
    ("crowd", 0xa5e0_cf1a_b6ca_5cb9),
    ("liquid", 0x1103_dc83_511a_574f),
    ("stream", 0x782a_1628_a6dc_b825),
    ("moving surfaces", 0x61b8420e8dfe65f9),
    ("moving surfaces, dense", 0x5e68023e3f5d1e3c),
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
