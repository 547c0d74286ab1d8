//! Box2D v3 through boxdd, with 4 substeps. Rotation is off by the lock *and* by a rotational inertia of 0: the lock alone gives soft,
//! lossy contacts.

use crate::engine::{Engine, Lift, NO_LIMIT, STIFFER, Spec, V, settings};
use boxdd::shapes::SurfaceMaterial;
use boxdd::{BodyId, BodyType, Foundation, MassData, MotionLocks, Position, ShapeDef, Vec2, World, WorldBuilder, shapes};

/// Box2D's own advice.
const SUBSTEPS: u32 = 4;
/// Box2D's default stiffness of contacts, Hz; it takes no more than an eighth of the substeps a second.
const HERTZ: f64 = 30.0;

/// Its world, the ids of its bodies, and the forces on them, which hold for one step only.
pub struct Box2d {
    world: World,
    ids: Vec<BodyId>,
    forces: Vec<(usize, f32)>,
    lift: Option<(BodyId, Lift)>,
    /// The scene, where there is water in it.
    water: Option<Spec>,
    substeps: u32,
    time: f64,
}

impl Box2d {
    fn build(spec: &Spec) -> boxdd::Result<Self> {
        let foundation = Foundation::get().map_or_else(Foundation::initialize_default, Ok)?;
        let mut builder = WorldBuilder::from(foundation.world_def()).gravity(Vec2::new(0.0, spec.gravity as f32));
        let mut substeps = SUBSTEPS;
        if spec.stiff {
            substeps *= STIFFER;
            let hertz = HERTZ * f64::from(STIFFER);
            builder = builder.contact_hertz(hertz as f32).maximum_linear_speed(NO_LIMIT as f32);
        }
        let mut world = foundation.create_world(builder.build()?)?;
        world.enable_sleeping(spec.sleep)?;
        let solid = |restitution: f64| -> boxdd::Result<ShapeDef> {
            let material = SurfaceMaterial::default().with_friction(spec.friction as f32)?.with_restitution(restitution as f32)?;
            ShapeDef::builder().density(1.0).material(material).build()
        };
        let place = |(x, y): V| Position::new(x as f32, y as f32);
        for &(centre, half) in &spec.statics {
            let def = world.body_builder().body_type(BodyType::Static).position(place(centre)).build()?;
            let id = world.create_body(def)?;
            world.body(id)?.create_polygon(&solid(0.0)?, &shapes::box_polygon(half.0 as f32, half.1 as f32)?)?;
        }
        let mut ids = Vec::new();
        for body in &spec.bodies {
            let def = world
                .body_builder()
                .body_type(BodyType::Dynamic)
                .position(place(body.position))
                .linear_velocity(Vec2::new(body.velocity.0 as f32, body.velocity.1 as f32))
                .motion_locks(MotionLocks::new(false, false, true))
                .linear_damping((spec.gravity / spec.terminal) as f32)
                .bullet(spec.swept)
                .build()?;
            let id = world.create_body(def)?;
            let mut rigid = world.body(id)?;
            rigid.create_polygon(&solid(body.restitution)?, &shapes::box_polygon(body.half.0 as f32, body.half.1 as f32)?)?;
            rigid.set_mass_data(MassData::new(body.mass as f32, Vec2::new(0.0, 0.0), 0.0)?)?;
            ids.push(id);
        }
        let forces = spec.bodies.iter().enumerate().filter(|(_, body)| body.force != 0.0);
        let forces = forces.map(|(i, body)| (i, body.force as f32)).collect();
        let mut platform = None;
        if let Some(lift) = &spec.lift {
            let (centre, half) = lift.place;
            let def = world.body_builder().body_type(BodyType::Kinematic).position(place(centre)).build()?;
            let id = world.create_body(def)?;
            world.body(id)?.create_polygon(&solid(0.0)?, &shapes::box_polygon(half.0 as f32, half.1 as f32)?)?;
            platform = Some((id, lift.clone()));
        }
        Ok(Self { world, ids, forces, lift: platform, water: spec.liquid.is_some().then(|| spec.clone()), substeps, time: 0.0 })
    }

    /// Lets the water act, for one step.
    fn float(&mut self) -> boxdd::Result<()> {
        let Some(spec) = &self.water else { return Ok(()) };
        let Some(liquid) = &spec.liquid else { return Ok(()) };
        for (id, body) in self.ids.iter().zip(&spec.bodies) {
            let mut rigid = self.world.body(*id)?;
            let (at, v) = (rigid.position()?, rigid.linear_velocity()?);
            let (at, v) = ((f64::from(at.x), f64::from(at.y)), (f64::from(v.x), f64::from(v.y)));
            let (x, y) = liquid.force_on(body, at, v, spec.gravity);
            rigid.apply_force_to_center(Vec2::new(x as f32, y as f32), true)?;
        }
        Ok(())
    }

    fn try_step(&mut self, dt: f64) -> boxdd::Result<()> {
        let now = self.time;
        self.time += dt;
        if let Some((id, lift)) = &self.lift {
            let speed = (lift.at(self.time).1 - lift.at(now).1) / dt;
            self.world.body(*id)?.set_linear_velocity(Vec2::new(0.0, speed as f32))?;
        }
        self.float()?;
        for &(body, force) in &self.forces {
            self.world.body(self.ids[body])?.apply_force_to_center(Vec2::new(force, 0.0), true)?;
        }
        self.world.step(dt as f32, self.substeps as i32).map(|_| ())
    }
}

impl Engine for Box2d {
    const NAME: &'static str = "Box2D";
    const QUADRATIC: bool = false;

    fn version() -> String {
        let version = boxdd::version().map(|version| format!("{}.{}.{}", version.major, version.minor, version.revision));
        version.unwrap_or_else(|_| "?".to_owned())
    }

    fn settings(stiff: bool) -> String {
        settings(SUBSTEPS, "substeps", HERTZ, stiff)
    }

    fn new(spec: &Spec) -> Option<Self> {
        Self::build(spec).map_err(|error| eprintln!("Box2D refuses the scene: {error}")).ok()
    }

    fn step(&mut self, dt: f64) {
        self.try_step(dt).expect("Box2D steps a scene that it has accepted");
    }

    fn position(&mut self, body: usize) -> V {
        let read = self.world.body(self.ids[body]).and_then(|body| body.position());
        read.map_or((f64::NAN, f64::NAN), |at| (f64::from(at.x), f64::from(at.y)))
    }

    fn velocity(&mut self, body: usize) -> V {
        let read = self.world.body(self.ids[body]).and_then(|body| body.linear_velocity());
        read.map_or((f64::NAN, f64::NAN), |v| (f64::from(v.x), f64::from(v.y)))
    }
}
