//! The rooms of a daily flight. A room is a piece of a hall between a floor and a roof, with the way points by which the autopilot flies
//! through it. Lengths are pixels of the level, 30 a metre.

use rand::RngExt;
use rand_pcg::Pcg32;
use std::fmt::Write;

/// Floor and roof of the hall.
pub const ROOF: i32 = 120;
pub const FLOOR: i32 = 840;
/// Where the ship passes where nothing is in its path.
pub const MIDDLE: i32 = 480;

/// The rows of a level's files, and of the plan.
#[derive(Debug, Default)]
pub struct HallRows {
    pub world: String,
    pub obstacles: String,
    pub hazards: String,
    pub fluids: String,
    pub gravity: String,
    pub switches: String,
    pub doors: String,
    pub plan: String,
    /// From the level's left edge to the next room.
    pub x: i32,
}

/// Builds a room at the rows' `x` and moves that to its end.
pub type Room = fn(&mut HallRows, &mut Pcg32);

pub const ROOMS: [Room; 6] = [pillars, red_gate, fan, pool, light_room, plate_room];

impl HallRows {
    fn block(&mut self, x: i32, y: i32, width: i32, height: i32) {
        row(&mut self.world, format_args!("{},{y},{width},{height}", self.x + x));
    }

    /// A slab from the roof and one from the floor, with a gap round `centre`.
    fn gate(&mut self, x: i32, (centre, gap): (i32, i32)) {
        let (top, bottom) = (centre - gap / 2, centre + gap / 2);
        self.block(x, ROOF, 60, top - ROOF);
        self.block(x, bottom, 60, FLOOR - bottom);
    }

    fn fly(&mut self, x: i32, y: i32, speed: i32) {
        row(&mut self.plan, format_args!("fly,{},{y},{speed},40", self.x + x));
    }
}

fn row(rows: &mut String, cells: std::fmt::Arguments<'_>) {
    // To write into a string never fails.
    let _ = writeln!(rows, "{cells}");
}

fn height(random: &mut Pcg32) -> i32 {
    10 * random.random_range(28..68)
}

fn pillars(rows: &mut HallRows, random: &mut Pcg32) {
    for x in [200, 520] {
        let centre = height(random);
        rows.gate(x, (centre, 200));
        rows.fly(x - 90, centre, 4);
        rows.fly(x + 150, centre, 4);
    }
    rows.x += 760;
}

/// A gate with red on both sides of its gap.
fn red_gate(rows: &mut HallRows, random: &mut Pcg32) {
    let centre = height(random);
    rows.gate(240, (centre, 300));
    for y in [centre - 150, centre + 120] {
        row(&mut rows.obstacles, format_args!("{},{y},60,30", rows.x + 240));
    }
    rows.fly(130, centre, 4);
    rows.fly(410, centre, 4);
    rows.x += 520;
}

/// A fan that blows up or, from the roof, down.
fn fan(rows: &mut HallRows, random: &mut Pcg32) {
    let force = 50 * random.random_range(8..17);
    let (y, stream, force) =
        if random.random_bool(0.5) { (FLOOR - 30, 60 + ROOF - FLOOR, -force) } else { (ROOF, FLOOR - ROOF - 60, force) };
    row(&mut rows.hazards, format_args!("{},{y},180,30,0,{stream},0,{force}", rows.x + 180));
    rows.fly(80, MIDDLE, 4);
    rows.fly(480, MIDDLE, 4);
    rows.x += 540;
}

/// A basin under a wall that hangs into it.
fn pool(rows: &mut HallRows, random: &mut Pcg32) {
    let density = 5 * random.random_range(4..13);
    for (x, y, width, height) in [(60, 620, 30, 220), (590, 620, 30, 220), (310, ROOF, 60, 540)] {
        rows.block(x, y, width, height);
    }
    row(&mut rows.fluids, format_args!("{},640,500,200,{density},0.001", rows.x + 90));
    for (x, y) in [(150, 520), (200, 750), (480, 750), (530, 520), (660, MIDDLE)] {
        rows.fly(x, y, 3);
    }
    rows.x += 720;
}

/// A zone in which everything weighs less, or more.
fn light_room(rows: &mut HallRows, random: &mut Pcg32) {
    let field = [-13, -7, -5, 3, 4][random.random_range(0..5)];
    row(&mut rows.gravity, format_args!("{},{ROOF},440,{},0,{field}", rows.x + 100, FLOOR - ROOF));
    let centre = height(random);
    rows.gate(300, (centre, 210));
    rows.fly(60, MIDDLE, 4);
    rows.fly(210, centre, 3);
    rows.fly(450, centre, 3);
    rows.fly(620, MIDDLE, 4);
    rows.x += 680;
}

/// A plate that opens the door behind it for good.
fn plate_room(rows: &mut HallRows, random: &mut Pcg32) {
    let centre = height(random);
    rows.gate(480, (centre, 200));
    row(&mut rows.doors, format_args!("{},{},30,200,hatch", rows.x + 495, centre - 100));
    row(&mut rows.switches, format_args!("{},{},150,15,hatch,500,,latched", rows.x + 180, FLOOR - 15));
    rows.fly(255, 700, 2);
    row(&mut rows.plan, format_args!("land,{},799.5,1,45", rows.x + 255));
    rows.fly(370, centre, 2);
    rows.fly(640, centre, 3);
    rows.x += 700;
}
