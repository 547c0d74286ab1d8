//! The surfaces that each body may meet.
//!
//! Each body owns a *fat box* (Box2D's fat AABBs); the list of surfaces whose boxes overlap it holds while the body stays inside.

use crate::physics::data::{Aabb, Body};
use crate::physics::store::{grid::CellGrid, motions::MARGIN, motions::Motions};
use glam::DVec2;

/// Steps ahead for which a fat box is made. More: more surfaces to test; fewer: more new boxes.
const HORIZON: f64 = 8.0;
/// Cells are this many times wider than the mean body.
const CELL: f64 = 2.0;
/// Surfaces for which a body has room from the start.
const ROOM: usize = 16;

#[derive(Clone, Debug)]
pub(crate) struct BroadPhase {
    surfaces: CellGrid,
    /// The fat box of each body, and the surfaces that meet it, by their numbers.
    boxes: Vec<Aabb>,
    near: Vec<Vec<u32>>,
    /// Of a fat box, m. Larger: more surfaces to test; smaller: more new boxes.
    skin: f64,
}

/// Cells a metre that suit these bodies.
pub(crate) fn cells_per_metre(bodies: &[Body]) -> f64 {
    1.0 / (CELL * 2.0 * mean_half(bodies)).max(1e-6)
}

fn mean_half(bodies: &[Body]) -> f64 {
    bodies.iter().map(|body| body.half.min_element()).sum::<f64>() / bodies.len().max(1) as f64
}

impl BroadPhase {
    pub fn new(bodies: &[Body], motions: &Motions) -> Self {
        let mut surfaces = CellGrid::new(motions.surfaces.len(), cells_per_metre(bodies));
        for (s, of) in motions.surfaces.iter().enumerate() {
            surfaces.enter(s, Aabb::around(of.from, of.half + MARGIN));
        }
        let near = bodies.iter().map(|_| Vec::with_capacity(ROOM)).collect();
        Self { surfaces, boxes: vec![Aabb::NOWHERE; bodies.len()], near, skin: mean_half(bodies) }
    }

    /// Surfaces near a body where they were first, in the order of their numbers.
    pub fn near(&self, i: usize) -> &[u32] {
        &self.near[i]
    }

    /// Whether the surfaces near a body are all that a box may meet.
    pub fn covers(&self, i: usize, bounds: &Aabb) -> bool {
        self.boxes[i].contains(bounds, 0.0)
    }

    /// Gives those of the bodies new boxes that sweep more than theirs.
    pub fn update(&mut self, bodies: &[Body], motions: &Motions, of: &[u32], dt: f64) {
        if motions.surfaces.is_empty() {
            return;
        }
        for i in of.iter().map(|i| *i as usize) {
            let swept = motions.swept[i];
            if !self.covers(i, &swept) {
                let (velocity, ahead) = (bodies[i].velocity, HORIZON * dt);
                let gained = DVec2::new(0.0, 0.5 * ahead * (motions.bodies[i].free.1.y - velocity.y) / dt);
                let way = ahead * (velocity + gained);
                let (min, max) = (swept.min - self.skin + way.min(DVec2::ZERO), swept.max + self.skin + way.max(DVec2::ZERO));
                self.boxes[i] = Aabb::new(min, max);
                self.near[i].clear();
                self.surfaces.find(&self.boxes[i], &mut self.near[i]);
                self.near[i].sort_unstable();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::data::material::Material;
    use crate::physics::data::surface::{Surface, SurfaceDef};
    use crate::physics::forces::media::Media;
    use crate::random::Random;

    fn random_boxes(n: usize, random: &mut Random) -> Vec<(DVec2, DVec2)> {
        let place = |k: usize| {
            let size = if k.is_multiple_of(50) { 6.0 } else { 0.4 };
            let mut pair = |scale: f64, least: f64| DVec2::new(scale * (least + random.unit()), scale * (least + random.unit()));
            (pair(20.0, 0.0), pair(size, 0.2))
        };
        (0..n).map(place).collect()
    }

    /// Surfaces near a body are those that testing all gives, giants and fast bodies included, however often boxes change.
    #[test]
    fn finds_the_surfaces_that_brute_force_finds() {
        let (n, surfaces) = (100, 200);
        let mut random = Random(1);
        let body = |(position, half)| Body { position, half, ..Body::default() };
        let mut bodies: Vec<Body> = random_boxes(n, &mut random).into_iter().map(body).collect();
        let fixed = |(centre, half)| Surface::new(SurfaceDef::fixed(Aabb::around(centre, half), Material::WOOD));
        let fixed: Vec<Surface> = random_boxes(surfaces, &mut random).into_iter().map(fixed).collect();
        let media = Media::new(0.0, 0.0, (&[], &[]), Vec::new());
        let mut motions = Motions::new(&bodies, &fixed, &media);
        let mut broad_phase = BroadPhase::new(&bodies, &motions);
        let all: Vec<u32> = (0..n as u32).collect();
        for _ in 0..20 {
            for (i, body) in bodies.iter_mut().enumerate() {
                body.velocity.x = if i % 40 == 7 { 3000.0 } else { 4.0 * random.unit() - 2.0 };
                body.position.x += 0.1 * body.velocity.x.min(2.0);
            }
            motions.fly(&bodies, &all, 0.01);
            broad_phase.update(&bodies, &motions, &all, 0.01);
            for i in 0..n {
                let mine = broad_phase.boxes[i];
                assert!(mine.contains(&motions.swept[i], 0.0));
                let of = |s: &u32| Aabb::around(motions.surfaces[*s as usize].from, motions.surfaces[*s as usize].half + MARGIN);
                let meet: Vec<u32> = (0..surfaces as u32).filter(|s| mine.meets(&of(s))).collect();
                assert_eq!(broad_phase.near(i), meet);
            }
        }
    }
}
