//! What flies in the menu: the ship, which hovers by its own engine, and balls. The game's own engine under weak gravity, without air, on steel. The
//! pilot of the menu's ship: it keeps the ship over the buttons with the engine alone, and leads it back there from wherever a ball has knocked it.

use crate::draw::layout::{Area, Frame, Vec2};
use crate::game::{Clock, ROTATION_RATE, SHIP, TICK_RATE, nose};
use crate::physics::{Aabb, Body, BodyDef, BodyId, DVec2, Material, SurfaceDef, World, WorldDef};
use crate::view::theme;
use crate::{draw::Canvas, level::SHIP_HALF, ui::input::Input};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;

/// Canvas units a metre.
pub const METRE: f32 = 30.0;
/// Half a ball's width, m.
const RADIUS: f64 = 0.45;
/// kg.
const MASS: f64 = 10.0;
/// Coefficient of restitution: lively, yet coming to rest.
const BOUNCE: f64 = 0.8;
/// The fastest a ball starts along each axis, m/s.
const FASTEST: f64 = 8.0;
/// The most balls; the oldest makes room. More would cover the menu.
const MOST: usize = 24;
/// How far around the pointer a free place is looked for, in ball widths.
const SEARCH: i32 = 6;

/// The ship, the balls and what they bounce off.
#[derive(Debug)]
pub struct Balls {
    /// `None` until the first frame has told what there is.
    world: Option<World>,
    obstacles: Vec<Area>,
    frame: Frame,
    clock: Clock,
    /// How long there have been balls, s. When a ball was dropped says how it flies: no two sittings are alike.
    time: f64,
    seed: u64,
    hover: Hover,
}

impl Balls {
    pub fn new(seed: u64) -> Self {
        Self {
            world: None,
            obstacles: Vec::new(),
            frame: Frame::default(),
            clock: Clock::new(TICK_RATE),
            time: 0.0,
            seed,
            hover: Hover::default(),
        }
    }

    /// One frame; a right click drops a ball.
    pub fn update(&mut self, input: &Input, obstacles: &[Area]) {
        self.time += input.frame_time;
        if self.world.is_none() || self.frame.size != input.frame.size || self.obstacles != obstacles {
            self.frame = input.frame;
            self.obstacles = obstacles.to_vec();
            self.rebuild(0);
        }
        if input.right_click {
            if self.areas().count() >= MOST {
                self.rebuild(1);
            }
            let mut random = Pcg32::seed_from_u64(self.time.to_bits() ^ self.seed);
            let velocity = DVec2::new(random.random_range(-FASTEST..FASTEST), random.random_range(-FASTEST..FASTEST));
            self.add(metres(input.pointer), velocity);
        }
        self.clock.add(input.frame_time);
        while self.clock.tick() {
            if let Some(world) = &mut self.world {
                let drive = self.hover.drive(world.body(SHIP));
                world.set_drive(SHIP, drive);
                world.step(1.0 / TICK_RATE);
            }
        }
    }

    /// The ship's centre (m, with the metres of the canvas), its angle (degrees) and how its engine burns (1 or 0), between the last two ticks.
    pub fn ship(&self) -> Option<(DVec2, f64, f64)> {
        let (world, alpha) = (self.world.as_ref()?, self.clock.alpha());
        let centre = world.previous_position(SHIP).lerp(world.body(SHIP).position, alpha);
        let (now, before) = self.hover.angle;
        Some((centre, before + (now - before) * alpha, (self.hover.burning * 2.0).min(1.0)))
    }

    /// The balls' boxes on the canvas, between the last two ticks.
    pub fn areas(&self) -> impl Iterator<Item = Area> + '_ {
        let alpha = self.clock.alpha();
        self.world.iter().flat_map(move |world| {
            world.bodies().iter().enumerate().skip(1).map(move |(i, body)| {
                let before = world.previous_position(BodyId(i as u32));
                let centre = before.lerp(body.position, alpha) * f64::from(METRE);
                Area::around(centre.as_vec2(), Vec2::splat(2.0 * RADIUS as f32 * METRE))
            })
        })
    }

    pub fn draw(&self, canvas: &Canvas) {
        for (i, area) in self.areas().enumerate() {
            let (centre, radius) = (area.centre(), area.size.x / 2.0);
            let colour = [theme::player_objective(), theme::physics_objective(), theme::good(), theme::accent()][i % 4];
            canvas.disc(centre, radius, colour);
            canvas.disc(centre - Vec2::splat(radius * 0.3), radius * 0.22, theme::text().faded(0.7));
        }
    }

    /// A world of the window as it is now, with all balls but the `without` oldest ones.
    fn rebuild(&mut self, without: usize) {
        let balls = self.world.iter().flat_map(|world| world.bodies().iter().skip(1 + without));
        let kept: Vec<_> = balls.map(|ball| (ball.position, ball.velocity)).collect();
        let ship = self.world.as_ref().map(|world| (world.body(SHIP).position, world.body(SHIP).velocity));
        let solid = |area: &Area| SurfaceDef::fixed(in_metres(area), Material::STEEL);
        let def = WorldDef {
            gravity: GRAVITY,
            air_density: 0.0,
            bounds: Some(in_metres(&self.frame.area())),
            surfaces: self.obstacles.iter().map(solid).collect(),
            bodies: vec![self.hover.settle(&self.obstacles.iter().map(in_metres).collect::<Vec<_>>(), ship)],
            ..WorldDef::default()
        };
        // The numbers are the program's own and in range; should the engine refuse them, the menu has no balls.
        self.world = World::new(def).ok();
        for (position, velocity) in kept {
            self.add(position, velocity);
        }
    }

    fn add(&mut self, at: DVec2, velocity: DVec2) {
        let Some(position) = self.free_place(at) else { return };
        let def = BodyDef {
            position,
            velocity,
            half: DVec2::splat(RADIUS),
            mass: MASS,
            drag: 0.0,
            round: true,
            restitution: BOUNCE,
            material: Material::STEEL,
            feels_air: false,
            ..BodyDef::default()
        };
        if let Some(world) = &mut self.world {
            // As above: a refusal costs a ball.
            let _ = world.add_body(def);
        }
    }

    /// The free place nearest to a point, as far as one is near.
    fn free_place(&self, at: DVec2) -> Option<DVec2> {
        let world = self.world.as_ref()?;
        let room = in_metres(&self.frame.area());
        let half = DVec2::splat(RADIUS);
        let free = |place: &DVec2| {
            let ball = Aabb::around(*place, half);
            room.contains(&ball, 0.0)
                && !self.obstacles.iter().any(|area| ball.overlaps(&in_metres(area), 0.0))
                && !world.bodies().iter().any(|body| ball.overlaps(&Aabb::around(body.position, body.half), 0.0))
        };
        let at = at.clamp(room.min + half, room.max - half);
        let around = (-SEARCH..=SEARCH).flat_map(|y| (-SEARCH..=SEARCH).map(move |x| DVec2::new(f64::from(x), f64::from(y))));
        let places = around.map(|step| at + step * RADIUS).filter(free);
        places.min_by(|a, b| a.distance_squared(at).total_cmp(&b.distance_squared(at)))
    }
}

fn metres(point: Vec2) -> DVec2 {
    (point / METRE).as_dvec2()
}

fn in_metres(area: &Area) -> Aabb {
    Aabb::new(metres(area.min), metres(area.max()))
}

/// N/kg, downwards.
pub const GRAVITY: f64 = 2.0;
/// kg.
const SHIP_MASS: f64 = 100.0;
/// N: three times the ship's weight in the menu.
const THRUST: f64 = 600.0;
/// What the pilot wants for each metre off its place (m/s²/m) and against each m/s: near critical damping.
const PULL: f64 = 1.2;
const DAMPING: f64 = 2.2;
/// The most that the pilot asks for, m/s²: sideways, downwards and upwards. More, and it would overshoot.
const MOST_ASKED: (f64, f64, f64) = (1.6, 1.2, 2.5);
/// How far it leans over at most, degrees.
const LEAN: f64 = 30.0;
/// How far over the buttons it hovers at most, m: in a high window the title is far above them.
const HEIGHT: f64 = 2.2;
/// How far it wanders to each side, m, and how long there and back takes, s.
const WANDER: (f64, f64) = (4.0, 14.0);
/// From the middle of the ship to the edge of what it flies around, m.
const CLEARANCE: f64 = 1.5;
/// Share of a tick in what is shown of the engine. Its bursts are shorter than a frame.
const SHOWN: f64 = 0.1;

#[derive(Debug, Default)]
pub struct Hover {
    /// What the ship flies around: the column of buttons, the title.
    blocks: Vec<Aabb>,
    /// The middle of where it hovers, m.
    home: DVec2,
    ticks: u64,
    /// Degrees clockwise, now and a tick ago.
    angle: (f64, f64),
    /// Parts of a burst that are due.
    due: f64,
    /// How much the engine burns, 0 … 1.
    burning: f64,
}

impl Hover {
    /// The ship in a menu with these blocks, the last one of which is the title: where it is, or at home where the menu is another one.
    pub fn settle(&mut self, blocks: &[Aabb], ship: Option<(DVec2, DVec2)>) -> BodyDef {
        let around = |blocks: &[Aabb]| blocks.iter().copied().reduce(|a, b| a.union(&b));
        let mut known = Vec::new();
        if let Some((title, buttons)) = blocks.split_last() {
            let narrow = buttons.iter().filter(|button| (button.centre().x - title.centre().x).abs() < 1.0).copied();
            known.extend(around(&narrow.collect::<Vec<_>>()));
            known.push(*title);
            let below = known[0].min.y;
            self.home = DVec2::new(title.centre().x, ((title.max.y + below) / 2.0).max(below - HEIGHT));
        }
        let same = self.blocks == known;
        self.blocks = known;
        let (position, velocity) = ship.filter(|_| same).unwrap_or((self.home, DVec2::ZERO));
        BodyDef {
            position,
            velocity,
            half: SHIP_HALF,
            mass: SHIP_MASS,
            drag: 0.0,
            restitution: 0.5,
            material: Material::STEEL,
            feels_air: false,
            ..BodyDef::default()
        }
    }

    /// The engine's drive in the next tick, N.
    pub fn drive(&mut self, ship: &Body) -> DVec2 {
        self.ticks += 1;
        let wish = (self.goal(ship.position) - ship.position) * PULL - ship.velocity * DAMPING;
        let (aside, down, up) = MOST_ASKED;
        // What the engine has to give: the wish, and what carries the ship's weight.
        let push = DVec2::new(wish.x.clamp(-aside, aside), wish.y.clamp(-up, down) - GRAVITY) * SHIP_MASS;
        let lean = push.x.atan2(-push.y).to_degrees().clamp(-LEAN, LEAN);
        let step = ROTATION_RATE / TICK_RATE;
        let turn = if (lean - self.angle.0).abs() > step { step.copysign(lean - self.angle.0) } else { 0.0 };
        self.angle = (self.angle.0 + turn, self.angle.0);
        let nose = nose(self.angle.0);
        self.due += (push.dot(nose) / THRUST).clamp(0.0, 1.0);
        let burst = self.due >= 1.0;
        self.due -= f64::from(u8::from(burst));
        self.burning += (f64::from(u8::from(burst)) - self.burning) * SHOWN;
        if burst { nose * THRUST } else { DVec2::ZERO }
    }

    /// Where to fly from there: home, or first around what lies between.
    fn goal(&self, from: DVec2) -> DVec2 {
        let (reach, period) = WANDER;
        let phase = self.ticks as f64 / TICK_RATE / period * std::f64::consts::TAU;
        let home = self.home + DVec2::new(reach * phase.sin(), 0.25 * (2.0 * phase).sin());
        let between = |block: &&Aabb| {
            let level = if from.y > self.home.y { block.min.y > self.home.y } else { block.max.y < self.home.y };
            level && (from.y - self.home.y).abs() > CLEARANCE
        };
        let Some(block) = self.blocks.iter().find(between) else { return home };
        let (left, right) = (block.min.x - CLEARANCE, block.max.x + CLEARANCE);
        let lane = if from.x < block.centre().x { left - 1.0 } else { right + 1.0 };
        let beside = from.x < left || from.x > right;
        DVec2::new(lane, if beside { home.y } else { from.y })
    }
}
