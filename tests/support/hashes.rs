//! The hashes of what is played to its end, in one place. They change whenever the engine, the rules or the state that they keep change on
//! purpose: then take over the lines that the failing tests print.

use super::measure::bits;
use resultant::physics::World;

/// What was played, and the hash of the state at its end.
const GOLDEN: [(&str, u64); 6] = [
    ("yard", 0xf9dd_8fc9_b416_dce1),
    ("crowd", 0x61ed_bc4e_2267_cddb),
    ("liquid", 0x5625_63a0_2c46_cef5),
    ("stream", 0x26f8_ab50_745b_2be5),
    ("moving surfaces", 0x55ab_78e6_6e8e_c36c),
    ("moving surfaces, dense", 0x6c3c_64f7_021f_81b3),
];

/// Holds a hash against the one that is known.
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
