//! Scenes seen otherwise.

use resultant::physics::{Aabb, DVec2, WorldDef};

/// In a mirror: x becomes −x.
pub fn mirrored(def: &WorldDef) -> WorldDef {
    let mut def = def.clone();
    let turn = |v: &mut DVec2| v.x = -v.x;
    let over = |area: &mut Aabb| (area.min.x, area.max.x) = (-area.max.x, -area.min.x);
    for body in &mut def.bodies {
        turn(&mut body.position);
        turn(&mut body.velocity);
    }
    for surface in &mut def.surfaces {
        over(&mut surface.bounds);
        surface.belt = -surface.belt;
        for leg in &mut surface.path.legs {
            turn(&mut leg.velocity);
            turn(&mut leg.acceleration);
        }
    }
    def.fluids.iter_mut().for_each(|fluid| over(&mut fluid.zone));
    for stream in &mut def.streams {
        over(&mut stream.zone);
        turn(&mut stream.force);
    }
    def
}

/// So far away, m.
pub fn shifted(def: &WorldDef, by: DVec2) -> WorldDef {
    let mut def = def.clone();
    let shift = |area: &mut Aabb| (area.min, area.max) = (area.min + by, area.max + by);
    def.bodies.iter_mut().for_each(|body| body.position += by);
    def.surfaces.iter_mut().for_each(|surface| shift(&mut surface.bounds));
    def.fluids.iter_mut().for_each(|fluid| shift(&mut fluid.zone));
    def.streams.iter_mut().for_each(|stream| shift(&mut stream.zone));
    def
}

/// With the last row first.
pub fn reversed(def: &WorldDef) -> WorldDef {
    let mut def = def.clone();
    def.bodies.reverse();
    def.surfaces.reverse();
    def
}
