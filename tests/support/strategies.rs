//! The strategies of property tests.

use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;
use resultant::physics::{Aabb, DVec2, Material, SurfaceDef};
use std::ops::Range;

/// A seed that fails is written beside the test; the scene that it draws becomes a case in `fixtures/found`.
pub fn cases(cases: u32) -> ProptestConfig {
    let failure_persistence = Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions")) as _);
    ProptestConfig { cases, failure_persistence, ..ProptestConfig::default() }
}

/// Any of the game's materials.
pub fn materials() -> impl Strategy<Value = Material> + Clone {
    (0..Material::FIRM.len()).prop_map(|i| Material::FIRM[i])
}

/// Up to five blocks of any material: the ranges of their left and top edges, widths and heights, m.
pub fn blocks(x: Range<f64>, y: Range<f64>, width: Range<f64>, height: Range<f64>) -> impl Strategy<Value = Vec<SurfaceDef>> {
    prop::collection::vec((x, y, width, height, materials()), 0..6).prop_map(|list| {
        let block = |(x, y, w, h, material)| SurfaceDef::fixed(Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h)), material);
        list.into_iter().map(block).collect()
    })
}
