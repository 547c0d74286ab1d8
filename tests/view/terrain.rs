//! The drawn world's geometry: the outline round solid rectangles, the hatching and the dimension lines within it, the light on its edges.

use crate::support::shipped::{fixture, levels, load};
use proptest::prelude::*;
use resultant::level::Landscape;
use resultant::physics::{Aabb, DVec2};
use resultant::view::terrain::light::cast;
use resultant::view::terrain::silhouette::{Corner, Silhouette};
use resultant::view::terrain::{Dimension, ROCK, Tint, dimensions, hatching, kind, mass, parts};

/// A box by its top left corner and its size, m.
fn area(x: f64, y: f64, width: f64, height: f64) -> Aabb {
    Aabb::new(DVec2::new(x, y), DVec2::new(x + width, y + height))
}

/// Boxes on a grid of half metres, many of them adjoining, over each other, or touching at a corner.
fn boxes() -> impl Strategy<Value = Vec<(Aabb, usize)>> {
    let solid = (0..24_i32, 0..24_i32, 1..8_i32, 1..8_i32, 0..3_usize);
    let to_box = |(x, y, w, h, kind): (i32, i32, i32, i32, usize)| {
        let (min, size) = (DVec2::new(f64::from(x), f64::from(y)), DVec2::new(f64::from(w), f64::from(h)));
        (Aabb::new(min * 0.5, (min + size) * 0.5), kind)
    };
    prop::collection::vec(solid.prop_map(to_box), 0..14)
}

/// The kind at a point that lies on no side: that of the last box over it.
fn kind_at(boxes: &[(Aabb, usize)], at: DVec2) -> Option<usize> {
    boxes.iter().rev().find(|(bounds, _)| bounds.contains(&Aabb::around(at, DVec2::ZERO), 0.0)).map(|(_, kind)| *kind)
}

/// The area that the boxes cover together and the length of its outline, counted cell by cell.
fn counted(boxes: &[(Aabb, usize)]) -> (f64, f64) {
    let solid = |i: i32, j: i32| kind_at(boxes, DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5) * 0.5).is_some();
    let (mut area, mut outline) = (0.0, 0.0);
    for i in -1..40 {
        for j in -1..40 {
            area += if solid(i, j) { 0.25 } else { 0.0 };
            outline += 0.5 * f64::from(u8::from(solid(i, j) != solid(i + 1, j)) + u8::from(solid(i, j) != solid(i, j + 1)));
        }
    }
    (area, outline)
}

/// Twice the area on the right hand of a loop (y down): positive round solid ground, negative round a hole.
fn shoelace(corners: &[DVec2]) -> f64 {
    (0..corners.len()).map(|i| corners[i].perp_dot(corners[(i + 1) % corners.len()])).sum()
}

proptest! {
    #![proptest_config(crate::support::strategies::cases(256))]

    #[test]
    fn the_outline_holds_the_area_of_the_union_and_is_as_long_as_its_border(boxes in boxes()) {
        let mass = Silhouette::new(&boxes);
        let (area, outline) = counted(&boxes);
        let pieces: f64 = mass.pieces().map(|(bounds, _)| bounds.size().x * bounds.size().y).sum();
        let inside: f64 = mass.loops.iter().map(|corners| shoelace(corners)).sum::<f64>() / 2.0;
        let edges: f64 = mass.edges.iter().map(|edge| edge.length()).sum();
        prop_assert!((pieces - area).abs() < 1e-9, "pieces of {pieces} m², the boxes cover {area}");
        prop_assert!((inside - area).abs() < 1e-9, "loops round {inside} m², the boxes cover {area}");
        prop_assert!((edges - outline).abs() < 1e-9, "edges of {edges} m, the border is {outline}");
    }

    #[test]
    fn the_pieces_are_apart_and_each_of_the_kind_that_is_on_top(boxes in boxes()) {
        let pieces: Vec<_> = Silhouette::new(&boxes).pieces().collect();
        for (i, (bounds, kind)) in pieces.iter().enumerate() {
            prop_assert!(pieces[..i].iter().all(|(other, _)| !other.overlaps(bounds, 0.0)));
            prop_assert_eq!(kind_at(&boxes, bounds.min + 0.25), Some(*kind));
            prop_assert_eq!(kind_at(&boxes, bounds.max - 0.25), Some(*kind));
        }
    }

    #[test]
    fn every_loop_turns_at_each_corner_and_every_edge_knows_its_two_sides(boxes in boxes()) {
        let mass = Silhouette::new(&boxes);
        for corners in mass.loops {
            prop_assert!(corners.len() >= 4 && corners.len() % 2 == 0);
            let side = |i: usize| corners[(i + 1) % corners.len()] - corners[i % corners.len()];
            prop_assert!((0..corners.len()).all(|i| side(i).dot(side(i + 1)) == 0.0 && side(i) != DVec2::ZERO));
        }
        for edge in mass.edges {
            let middle = (edge.from + edge.to) * 0.5;
            // The middle of an edge of a whole number of half metres may lie between two cells.
            let at = middle + edge.along() * 0.125;
            prop_assert_eq!(kind_at(&boxes, at + edge.inward * 0.1), Some(edge.kind));
            prop_assert_eq!(kind_at(&boxes, at - edge.inward * 0.1), None);
            let behind = Aabb::new(edge.from.min(edge.to), edge.from.max(edge.to));
            let deep = edge.inward * (edge.depth - 0.01);
            let shown = Aabb::new(behind.min.min(behind.min + deep) + 1e-3, behind.max.max(behind.max + deep) - 1e-3);
            let solid = |at: DVec2| kind_at(&boxes, at).is_some();
            let corners = [shown.min, shown.max, DVec2::new(shown.min.x, shown.max.y), DVec2::new(shown.max.x, shown.min.y)];
            prop_assert!(corners.into_iter().all(solid), "behind {edge:?}");
        }
    }

    #[test]
    fn no_stroke_leaves_what_it_hatches_and_none_meets_one_from_the_other_side(boxes in boxes()) {
        let mass = Silhouette::new(&boxes);
        for (from, to) in hatching(&mass, ROCK) {
            let at = |share: f64| from.lerp(to, share);
            for share in [0.013, 0.307, 0.551, 0.803, 0.997] {
                prop_assert_eq!(kind_at(&boxes, at(share)), Some(ROCK), "{} to {}", from, to);
                // (No share leads to a corner of the grid, which belongs to all that touch it.) A stroke covers the ground as far ahead as it is long.
                prop_assert_eq!(kind_at(&boxes, from + (to - from) * (share * 1.99)), Some(ROCK), "{} to {}", from, to);
            }
        }
    }

    #[test]
    fn a_dimension_tells_the_length_of_an_edge_and_lies_in_rock(boxes in boxes()) {
        let mass = Silhouette::new(&boxes);
        let lines = dimensions(&mass, ROCK, &[]);
        for (i, line) in lines.iter().enumerate() {
            let ends = [line.from + line.to_edge, line.to + line.to_edge];
            let measured = mass.edges.iter().any(|edge| {
                let near = |corner: DVec2| ends.iter().any(|end| end.distance(corner) < 1e-9);
                near(edge.from) && near(edge.to)
            });
            prop_assert!(measured, "{:?} measures no edge", line);
            prop_assert!(mass.holds(&line.bounds(), ROCK));
            prop_assert!(lines[..i].iter().all(|other| !other.bounds().touches(&line.bounds(), 0.0)));
        }
    }

    #[test]
    fn light_is_never_outside_of_its_range_and_falls_on_no_face_that_looks_away(boxes in boxes(), x in 0.0..14.0, y in 0.0..14.0) {
        let mass = Silhouette::new(&boxes);
        let (at, reach) = (DVec2::new(x, y), 5.0);
        let opaque: Vec<Aabb> = boxes.iter().map(|(bounds, _)| *bounds).collect();
        for lit in cast(&mass.edges, &Aabb::around(at, DVec2::ZERO), reach, &opaque) {
            prop_assert!(lit.strength.iter().all(|s| (0.0..=1.0).contains(s)));
            prop_assert!((at - lit.from).dot(lit.inward) < 0.05, "{lit:?} looks away from {at}");
            let nearest = (at - lit.from).length().min((at - lit.to).length());
            prop_assert!(nearest < reach + 0.5);
        }
    }
}

/// The sails of the windmill of level 15 turn before its cap, so that a picture behind them lies on the rock as well.
#[test]
fn a_picture_behind_lies_once_on_all_of_the_rock_that_it_covers() {
    let level = fixture("15");
    let (mass, picture) = (mass(&level), level.decoration[0].bounds);
    assert!(!level.decoration[0].in_front);
    let (mut on_rock, step) = (0, picture.size() / 61.0);
    for i in 0..60 * 60 {
        // Off the sides of all blocks.
        let at = picture.min + step * (DVec2::new(f64::from(i % 60), f64::from(i / 60)) + 0.37);
        let holds = |bounds: &Aabb| bounds.contains(&Aabb::around(at, DVec2::ZERO), 0.0);
        let rock = level.world.iter().any(|solid| solid.is_rock() && holds(&solid.bounds));
        assert_eq!(parts(&mass, &picture).filter(holds).count(), usize::from(rock), "at {at}");
        on_rock += usize::from(rock);
    }
    assert!((100..3500).contains(&on_rock), "the sails hang in the air and on rock: {on_rock}");
    assert!(parts(&mass, &picture).all(|part| picture.contains(&part, 1e-9)));
}

#[test]
fn a_ring_of_blocks_is_one_mass_with_a_hole() {
    let ring = [area(0.0, 0.0, 3.0, 1.0), area(0.0, 1.0, 1.0, 1.0), area(2.0, 1.0, 1.0, 1.0), area(0.0, 2.0, 3.0, 1.0)];
    let mass = Silhouette::new(&ring.map(|bounds| (bounds, ROCK)));
    let areas: Vec<f64> = mass.loops.iter().map(|corners| shoelace(corners) / 2.0).collect();
    assert_eq!(areas, [9.0, -1.0]);
    assert_eq!(mass.edges.len(), 8);
    assert!(mass.edges.iter().filter(|edge| edge.corners == [Corner::Inner; 2]).count() == 4, "the hole has inner corners");
}

#[test]
fn blocks_that_touch_at_a_corner_keep_their_own_outlines() {
    let mass = Silhouette::new(&[(area(0.0, 0.0, 1.0, 1.0), ROCK), (area(1.0, 1.0, 1.0, 1.0), ROCK)]);
    assert_eq!(mass.loops.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
}

#[test]
fn a_pad_let_into_a_floor_cuts_the_edge_without_a_corner() {
    let steel = kind("Steel");
    let floor = [area(0.0, 4.0, 3.0, 4.0), area(3.0, 5.0, 2.0, 3.0), area(5.0, 4.0, 3.0, 4.0)];
    let boxes: Vec<_> = floor.into_iter().map(|bounds| (bounds, ROCK)).chain([(area(3.0, 4.0, 2.0, 1.0), steel)]).collect();
    let mass = Silhouette::new(&boxes);
    let top: Vec<_> = mass.edges.iter().filter(|edge| edge.inward == DVec2::Y).collect();
    let found: Vec<_> = top.iter().map(|edge| (edge.from.x, edge.to.x, edge.kind, edge.corners)).collect();
    assert_eq!(
        found,
        [
            (0.0, 3.0, ROCK, [Corner::Outer, Corner::Straight]),
            (3.0, 5.0, steel, [Corner::Straight; 2]),
            (5.0, 8.0, ROCK, [Corner::Straight, Corner::Outer]),
        ]
    );
    let measured: Vec<f64> = dimensions(&mass, ROCK, &[]).iter().map(Dimension::length).collect();
    assert!(!measured.is_empty() && !measured.contains(&3.0), "{measured:?}");
}

#[test]
fn sides_a_rounding_apart_are_one_line() {
    // A tenth of a metre is no whole number of bits.
    let boxes: Vec<_> = (0..30).map(|i| (area(0.1 * f64::from(i), 0.0, 0.1, 1.0), ROCK)).collect();
    let mass = Silhouette::new(&boxes);
    assert_eq!((mass.loops.len(), mass.edges.len(), mass.pieces().count()), (1, 4, 1));
}

#[test]
fn a_wall_shades_what_is_behind_it_and_glass_would_not() {
    let (floor, wall) = (area(0.0, 10.0, 10.0, 1.0), area(4.0, 7.0, 1.0, 3.0));
    let mass = Silhouette::new(&[(floor, ROCK), (wall, ROCK)]);
    let lamp = area(2.0, 9.0, 1.0, 1.0);
    let lit = |opaque: &[Aabb]| {
        let lit = cast(&mass.edges, &lamp, 6.0, opaque);
        lit.into_iter().filter(|lit| lit.inward == DVec2::Y && lit.from.x > 5.0).count()
    };
    assert_eq!(lit(&[floor, wall]), 0);
    assert!(lit(&[floor]) > 0);
    let under = cast(&mass.edges, &lamp, 6.0, &[floor, wall]);
    assert!(under.iter().any(|lit| lit.inward == DVec2::Y && lit.strength == [1.0, 1.0]));
}

#[test]
fn the_shipped_levels_are_of_few_pieces_whatever_they_are_built_of() {
    for level in levels().iter().map(|name| load(name)) {
        let mass = mass(&level);
        assert!(mass.edges.iter().all(|edge| edge.bounds().touches(&level.bounds(), 0.0)), "level {}", level.name);
        assert!(mass.edges.len() < 150 && !dimensions(&mass, ROCK, &[]).is_empty(), "level {}", level.name);
        let (strokes, size) = (hatching(&mass, ROCK), level.size);
        // A stroke a metre and a half of edge or so: sparse.
        let length: f64 = mass.edges.iter().filter(|edge| edge.kind == ROCK).map(|edge| edge.length()).sum();
        assert!((0.5..2.0).contains(&(strokes.len() as f64 / length)), "level {}: {} on {length} m", level.name, strokes.len());
        let near = Aabb::new(DVec2::splat(-2.0), size + 2.0);
        assert!(strokes.iter().all(|(_, to)| near.contains(&Aabb::around(*to, DVec2::ZERO), 0.0)));
    }
}

#[test]
fn a_level_as_large_as_can_be_is_drafted_in_bounds() {
    let boxes: Vec<_> = (0..200).map(|i| (area(0.0, 5000.0 * f64::from(i), 1e6, 1000.0), ROCK)).collect();
    let strokes = hatching(&Silhouette::new(&boxes), ROCK).len();
    assert!(strokes < 50_000, "{strokes}");
}

#[test]
fn where_worlds_lie_in_storeys_rock_goes_from_the_moons_to_the_seas_without_a_step() {
    let of = |world| Tint::of(Some(world), "");
    let tint = Tint { storeys: Some(50.0), ..of(Landscape::Orbit) };
    let storeys = [Landscape::Orbit, Landscape::Launch, Landscape::Wind, Landscape::Quarry, Landscape::Water];
    for (world, y) in storeys.into_iter().zip([5.0, 15.0, 25.0, 35.0, 45.0]) {
        let (here, there) = (tint.at(y), of(world));
        let apart = [here.lit.r - there.lit.r, here.lit.b - there.lit.b, here.deep.g - there.deep.g];
        assert!(apart.iter().all(|apart| apart.abs() < 1e-6), "{world:?}: {here:?}");
    }
    assert_eq!((tint.at(-9.0).lit, tint.at(99.0).lit), (tint.at(5.0).lit, tint.at(45.0).lit));
    let step = |y: f64| (tint.at(y).lit.r - tint.at(y + 0.1).lit.r).abs();
    assert!((0..500).all(|i| step(f64::from(i) * 0.1) < 0.01));
    assert_eq!(of(Landscape::Wind).at(45.0), of(Landscape::Wind));
    let bounds = area(1.0, 2.0, 3.0, 7.0);
    assert_eq!(tint.strips(&bounds).reduce(|all, strip| all.union(&strip)), Some(bounds));
    assert_eq!(of(Landscape::Wind).strips(&bounds).count(), 1);
}
