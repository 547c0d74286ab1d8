//! What the tests of random worlds ask of them, and what they are made of.

mod overlap;

pub use overlap::worst_overlap;
use proptest::prelude::*;
use resultant::physics::{Material, World};

/// Any of the game's materials.
pub fn materials() -> impl Strategy<Value = Material> + Clone {
    (0..Material::ALL.len()).prop_map(|i| Material::ALL[i])
}

/// All bits of a world's state.
pub fn bits(world: &World) -> Vec<u64> {
    let mut bits = Vec::new();
    world.hash_state(&mut |word| bits.push(word));
    bits
}
