//! explore
mod support;
use resultant::physics::*;
use support::scenes::{Scene, exact_scenes};
use support::TICK;

fn twins(scene: &Scene) -> [World; 2] {
    let plan = Plan::of(&scene.def);
    [false, true].map(|dense| {
        let mut world = World::with_plan(scene.def.clone(), Plan { dense, ..plan.clone() }).unwrap();
        if scene.drive != DVec2::ZERO { world.set_drive(BodyId(0), scene.drive); }
        world
    })
}

#[test]
fn exact() {
    for scene in exact_scenes() {
        let [mut a, mut b] = twins(&scene);
        let (mut dx, mut dv, mut df, mut da) = ((0.0f64,0), (0.0f64,0), (0.0f64,0), (0.0f64,0));
        let mut dense = 0;
        for tick in 0..(scene.seconds / TICK).round() as u32 {
            a.step(TICK);
            b.step(TICK);
            dense += b.methods().in_one_step;
            for i in 0..a.bodies().len() {
                let id = BodyId(i as u32);
                let (p, q) = (a.body(id), b.body(id));
                let f = |d: f64, w: &mut (f64, u32)| if d > w.0 { *w = (d, tick) };
                f((p.position - q.position).length(), &mut dx);
                f((p.velocity - q.velocity).length(), &mut dv);
                f((p.acceleration - q.acceleration).length(), &mut da);
                let (ff, fg) = (a.forces(id), b.forces(id));
                for kind in [ForceKind::Reaction, ForceKind::Friction, ForceKind::Push] {
                    f((ff.total(kind) - fg.total(kind)).length(), &mut df);
                }
            }
        }
        println!("{:34} x {:9.2e} at {:4} v {:9.2e} at {:4} a {:9.2e} at {:4} F {:9.2e} at {:4}  dense {dense} {:?}", scene.name, dx.0, dx.1, dv.0, dv.1, da.0, da.1, df.0, df.1, b.guards().all().filter(|g|g.1>0).collect::<Vec<_>>());
    }
}
