//! Barriers of exhaust, dust and sparks: the solid surfaces near the view, sorted into columns so that a particle looks at few of
//! them.

use crate::physics::{Aabb, DVec2, Sides, World};

/// Columns over the width of the view.
const COLUMNS: usize = 64;
/// Gap that a stopped particle keeps to its surface, m.
const CLEAR: f64 = 1e-3;

/// The end of a path at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarrierStop {
    /// A little before the surface, m.
    pub at: DVec2,
    /// The axis (0: x, 1: y) along which the path meets it.
    pub axis: usize,
}

/// The surfaces of one moment.
#[derive(Clone, Debug, Default)]
pub struct Barriers {
    left: f64,
    /// Columns a metre.
    scale: f64,
    columns: Vec<Vec<(Aabb, Sides)>>,
}

impl Barriers {
    /// The present surfaces of a world that touch a box.
    pub fn new(world: &World, within: &Aabb) -> Self {
        let width = within.size().x;
        let scale = if width > 0.0 { COLUMNS as f64 / width } else { 0.0 };
        let mut barriers = Self { left: within.min.x, scale, columns: vec![Vec::new(); COLUMNS] };
        for surface in world.surfaces().iter().filter(|surface| surface.present && surface.bounds.touches(within, 0.0)) {
            let (from, to) = (barriers.column(surface.bounds.min.x), barriers.column(surface.bounds.max.x));
            barriers.columns[from..=to].iter_mut().for_each(|column| column.push((surface.bounds, surface.sides())));
        }
        barriers
    }

    /// The first stop on the straight path between two points, m. A path that begins inside a surface leads out of it.
    pub fn stop(&self, from: DVec2, to: DVec2) -> Option<BarrierStop> {
        if self.columns.is_empty() {
            return None;
        }
        let (first, last) = (self.column(from.x.min(to.x)), self.column(from.x.max(to.x)));
        let boxes = self.columns[first..=last].iter().flatten();
        let met = boxes.filter_map(|(bounds, sides)| meets(bounds, *sides, from, to));
        let (part, axis) = met.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let way = to - from;
        let mut at = from + way * part;
        at[axis] -= CLEAR * way[axis].signum();
        Some(BarrierStop { at, axis })
    }

    /// The distance from a point to the first stop along a unit vector, at most `reach`, m.
    pub fn room(&self, from: DVec2, along: DVec2, reach: f64) -> f64 {
        self.stop(from, from + along * reach).map_or(reach, |stop| stop.at.distance(from))
    }

    fn column(&self, x: f64) -> usize {
        // The cast takes places left of the view to 0.
        (((x - self.left) * self.scale) as usize).min(COLUMNS - 1)
    }
}

/// The free part (0 … 1) of a path before it enters a box through a solid face, and the axis of that face.
fn meets(bounds: &Aabb, sides: Sides, from: DVec2, to: DVec2) -> Option<(f64, usize)> {
    let way = to - from;
    let (mut enters, mut leaves, mut axis) = (f64::NEG_INFINITY, 1.0_f64, 0);
    for i in 0..2 {
        if way[i] == 0.0 {
            if from[i] <= bounds.min[i] || from[i] >= bounds.max[i] {
                return None;
            }
            continue;
        }
        let (a, b) = ((bounds.min[i] - from[i]) / way[i], (bounds.max[i] - from[i]) / way[i]);
        if a.min(b) > enters {
            (enters, axis) = (a.min(b), i);
        }
        leaves = leaves.min(a.max(b));
    }
    (enters >= 0.0 && enters < leaves && sides.face(axis, way[axis] < 0.0)).then_some((enters, axis))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Material, SurfaceDef, WorldDef};

    /// A deck 4 m wide and 0.2 m thick, its top at y = 2.
    fn deck(sides: Sides) -> Barriers {
        let bounds = Aabb::new(DVec2::new(3.0, 2.0), DVec2::new(7.0, 2.2));
        let surface = SurfaceDef { sides, ..SurfaceDef::fixed(bounds, Material::STEEL) };
        let world = World::new(WorldDef { surfaces: vec![surface], ..WorldDef::default() }).expect("a valid world");
        Barriers::new(&world, &Aabb::new(DVec2::ZERO, DVec2::splat(10.0)))
    }

    #[test]
    fn a_path_ends_at_the_deck_however_long_it_is() {
        let deck = deck(Sides::ALL);
        for (from, to) in [((5.0, 1.0), (5.0, 3.0)), ((5.0, 1.0), (5.0, 1e6)), ((1.0, 0.5), (6.0, 4.0)), ((5.0, 2.0), (5.5, 2.1))] {
            let stop = deck.stop(DVec2::from(from), DVec2::from(to)).expect("it meets the deck");
            assert!(stop.axis == 1 && (stop.at.y - 2.0).abs() < 2.0 * CLEAR && stop.at.y < 2.0, "{stop:?}");
        }
        for (from, to) in
            [((5.0, 1.0), (5.0, 1.9)), ((1.0, 1.0), (1.0, 9.0)), ((5.0, 2.1), (5.0, 9.0)), ((5.0, 1.999), (9.0, 1.999))]
        {
            assert_eq!(deck.stop(DVec2::from(from), DVec2::from(to)), None);
        }
        let room = deck.room(DVec2::new(5.0, 1.15), DVec2::Y, 2.0);
        assert!((room - 0.85).abs() < 2.0 * CLEAR, "{room}");
        assert_eq!(deck.room(DVec2::new(5.0, 1.15), DVec2::NEG_Y, 2.0), 2.0);
    }

    #[test]
    fn a_one_way_deck_stops_what_comes_from_its_side_alone() {
        let deck = deck(Sides::TOP);
        assert!(deck.stop(DVec2::new(5.0, 1.0), DVec2::new(5.0, 3.0)).is_some());
        assert!(deck.stop(DVec2::new(5.0, 3.0), DVec2::new(5.0, 1.0)).is_none());
    }
}
