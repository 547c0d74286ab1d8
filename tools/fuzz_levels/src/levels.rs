//! Random levels, as the texts that an author would have written: most of them playable, some with numbers at the accepted limits, some
//! beyond.

use super::Random;
use resultant::level::Files;
use resultant::physics::{Aabb, DVec2};
use std::fmt::Write;
use std::io;

/// A level's files in memory.
pub struct Memory<T = String>(pub Vec<(&'static str, T)>);

impl<T: AsRef<[u8]>> Files for Memory<T> {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        let file = self.0.iter().find(|(file, _)| *file == name);
        file.map(|(_, bytes)| bytes.as_ref().to_vec()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn project_file(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// The files of a random level.
pub fn level_texts(seed: u64) -> Memory {
    let mut random = Random(seed);
    let wildness = how_wild(&mut random);
    let author = Author { random, wildness, taken: Vec::new(), metre: 30.0, corner: DVec2::ZERO, size: DVec2::ZERO };
    author.write(seed >= MOVES_FROM)
}

/// How many of all numbers of that level are extreme, from 0 to 1.
pub fn wildness(seed: u64) -> f64 {
    how_wild(&mut Random(seed))
}

fn how_wild(random: &mut Random) -> f64 {
    random.pick(&[0.0, 0.0, 0.02, 0.1, 0.3])
}

/// Levels from this seed on have surfaces that move, belts and blocks that are solid from one side only; earlier seeds keep their levels.
const MOVES_FROM: u64 = 2_000_000;

const MATERIALS: [&str; 7] = ["", "Asphalt", "Steel", "Ice", "Rubber", "Wood", "Glass"];

struct Author {
    random: Random,
    /// How many of all numbers are extreme.
    wildness: f64,
    /// Where something is already, m.
    taken: Vec<Aabb>,
    metre: f64,
    /// Where things are put, m.
    corner: DVec2,
    size: DVec2,
}

impl Author {
    fn write(mut self, moves: bool) -> Memory {
        self.metre = self.number(&[30.0, 30.0, 30.0, 50.0], -3.0, 6.0);
        let (width, height) = (self.random.between(8.0, 40.0), self.random.between(6.0, 30.0));
        self.size = DVec2::new(width, height);
        let level = match self.random.below(12) {
            0 => self.size + DVec2::new(self.random.decades(0.0, 5.9), self.random.decades(0.0, 5.9)),
            _ => self.size,
        };
        // Things are put together, in the near corner of the level or in the far one.
        self.corner = if self.random.chance(0.5) { level - self.size } else { DVec2::ZERO };
        let mut files = vec![
            ("constants.csv", self.constants(level)),
            ("player.csv", self.player()),
            ("world.csv", self.solids()),
            ("hazards.csv", self.streams()),
            ("objects.csv", self.objects()),
            ("fluids.csv", self.fluids()),
            // No attempt ends before its time.
            ("objectives.csv", format!("PLAYER,0,0,{},{},1e6\n", level.x * self.metre, level.y * self.metre)),
        ];
        if moves {
            files.push(("movers.csv", self.movers()));
        }
        Memory(files)
    }

    fn movers(&mut self) -> String {
        let mut text = String::from("x,y,width,height,way_points,speed,wait,ease,route,material,one_way,belt\n");
        for _ in 0..1 + self.count(&[0, 0, 1, 2, 5]) {
            let (usual_x, usual_y) = (self.random.between(0.3, 4.0), self.random.pick(&[0.1, 0.5, 2.0]));
            let half = DVec2::new(self.number(&[usual_x], -3.0, 2.0), self.number(&[usual_y], -3.0, 2.0)) * 0.5;
            let bounds = Aabb::around(self.anywhere(half), half);
            if self.taken.iter().any(|taken| taken.overlaps(&bounds, 0.0)) {
                continue;
            }
            self.taken.push(bounds);
            let ways: Vec<String> = (0..1 + self.random.below(3))
                .map(|_| {
                    let at = (self.anywhere(half) - half) * self.metre;
                    format!("{} {}", at.x, at.y)
                })
                .collect();
            let speed = self.number(&[1.0, 3.0, 10.0], -6.0, 6.0);
            let (wait, ease) = (self.number(&[0.0, 0.0, 0.5], -3.0, 2.0), self.number(&[0.0, 0.0, 0.2], -3.0, 2.0));
            let route = self.random.pick(&["", "round", "once"]);
            let (material, side) = (self.random.pick(&MATERIALS), self.random.pick(&["", "", "top", "left"]));
            let belt = self.signed(&[0.0, 0.0, 2.0], -3.0, 6.0);
            self.row(&bounds, &mut text);
            writeln!(text, ",{},{speed},{wait},{ease},{route},{material},{side},{belt}", ways.join(";")).unwrap();
        }
        text
    }

    /// One of the usual numbers, or an extreme one between two powers of ten; now and then one that is refused.
    fn number(&mut self, usual: &[f64], low: f64, high: f64) -> f64 {
        if !self.random.chance(self.wildness) {
            return self.random.pick(usual);
        }
        match self.random.below(40) {
            0 => self.random.decades(high, high + 6.0),
            1 => self.random.decades(low - 6.0, low),
            2..7 => libm::pow(10.0, self.random.pick(&[low, high])),
            _ => self.random.decades(low, high),
        }
    }

    /// A number of either sign.
    fn signed(&mut self, usual: &[f64], low: f64, high: f64) -> f64 {
        self.number(usual, low, high) * self.random.pick(&[-1.0, 1.0])
    }

    fn constants(&mut self, level: DVec2) -> String {
        let mut text =
            format!("name,value\nwidth,{}\nheight,{}\nmetre,{}\n", level.x * self.metre, level.y * self.metre, self.metre);
        let gravity = self.signed(&[15.0, 15.0, 9.81, 0.0], -3.0, 3.0);
        let gravity = if self.random.chance(0.9) { gravity.abs() } else { gravity };
        let air = self.number(&[1.2041, 1.2041, 0.0], -3.0, 2.0);
        let rest_speed = self.number(&[0.0, 0.0, 1.0], -6.0, 4.0);
        writeln!(text, "gravity,{gravity}\nair_density,{air}\nrest_speed,{rest_speed}").unwrap();
        text
    }

    fn player(&mut self) -> String {
        let at = self.free(DVec2::splat(0.85)) * self.metre;
        let mass = self.number(&[100.0, 75.0, 21.0, 400.0], -3.0, 5.0);
        let thrust = self.number(&[3000.0, 2000.0, 0.0, 12000.0], 0.0, 6.0);
        let (air, angle) = (self.random.pick(&["TRUE", "FALSE"]), self.signed(&[0.0, 30.0, 90.0], -3.0, 6.0));
        let (vx, vy) = (self.velocity(), self.velocity());
        let material = self.random.pick(&MATERIALS);
        format!(
            "x,y,mass,fuel,thrust,air,vx,vy,angle,material\n{},{},{mass},500,{thrust},{air},{vx},{vy},{angle},{material}\n",
            at.x, at.y
        )
    }

    fn velocity(&mut self) -> f64 {
        let usual = self.random.between(0.0, 20.0);
        self.signed(&[0.0, 0.0, usual], -6.0, 4.0)
    }

    fn objects(&mut self) -> String {
        let count = match self.random.below(20) {
            0 => 65 + self.random.below(60),
            1..4 => 20 + self.random.below(44),
            _ => self.random.below(14),
        };
        let mut text = String::from("x,y,image,mass,drag,circular,restitution,vx,vy,material\n");
        let (alike, size) = (self.random.chance(0.3), self.random.between(0.15, 0.6));
        let stacked = self.random.chance(0.3);
        for _ in 0..count {
            let (usual_x, usual_y) = (self.random.between(0.1, 0.7), self.random.between(0.1, 0.7));
            let half = match alike {
                true => DVec2::splat(size),
                false => DVec2::new(self.number(&[usual_x], -3.3, 2.0), self.number(&[usual_y], -3.3, 2.0)),
            };
            let at = if stacked { self.on_top(half) } else { self.free(half) } * self.metre;
            let usual = self.random.decades(-0.5, 3.0);
            let mass = self.number(&[usual], -3.0, 5.0);
            let drag = self.number(&[1.05, 0.5, 0.0], -3.0, 3.0);
            let bounce = self.random.unit();
            let restitution = self.random.pick(&[0.0, 0.0, 0.0, bounce, bounce, 1.0]);
            let (round, (vx, vy)) = (self.random.pick(&["TRUE", "FALSE"]), (self.velocity(), self.velocity()));
            let (vx, vy) = if stacked { (0.0, 0.0) } else { (vx, vy) };
            let (w, h) = (2.0 * half.x * self.metre, 2.0 * half.y * self.metre);
            let material = self.random.pick(&MATERIALS);
            writeln!(text, "{},{},box:{w}x{h},{mass},{drag},{round},{restitution},{vx},{vy},{material}", at.x, at.y).unwrap();
        }
        text
    }

    fn solids(&mut self) -> String {
        let mut text = String::from("x,y,width,height,material\n");
        if self.random.chance(0.3) {
            // A floor of flush tiles.
            let tile = self.random.pick(&[0.5, 1.0, 4.0]);
            let material = self.random.pick(&MATERIALS);
            let top = self.corner.y + self.size.y - self.random.pick(&[tile, 2.0]);
            for i in 0..(self.size.x / tile).floor() as usize {
                let left = self.corner.x + tile * i as f64;
                self.solid(Aabb::new(DVec2::new(left, top), DVec2::new(left + tile, top + tile)), material, &mut text);
            }
        }
        for _ in 0..self.random.below(6) {
            let (usual_x, usual_y) = (self.random.between(0.3, 6.0), self.random.pick(&[0.1, 0.5, 2.0]));
            let half = DVec2::new(self.number(&[usual_x], -3.0, 2.0), self.number(&[usual_y], -3.0, 2.0)) * 0.5;
            let half = if self.random.chance(0.5) { half } else { DVec2::new(half.y, half.x) };
            let at = self.anywhere(half);
            let material = self.random.pick(&MATERIALS);
            self.solid(Aabb::around(at, half), material, &mut text);
        }
        text
    }

    fn solid(&mut self, bounds: Aabb, material: &str, text: &mut String) {
        if self.taken.iter().all(|taken| !taken.overlaps(&bounds, 0.0)) {
            self.row(&bounds, text);
            writeln!(text, ",{material}").unwrap();
            self.taken.push(bounds);
        }
    }

    fn streams(&mut self) -> String {
        let mut text = String::from("x,y,width,height,stream_width,stream_height,force_x,force_y\n");
        for _ in 0..self.count(&[0, 0, 1, 3, 8]) {
            let half = DVec2::new(self.random.between(0.2, 1.0), self.random.between(0.2, 1.0));
            let bounds = Aabb::around(self.anywhere(half), half);
            if self.taken.iter().any(|taken| taken.overlaps(&bounds, 0.0)) {
                continue;
            }
            self.taken.push(bounds);
            let reach = self.signed(&[2.0, 5.0, 12.0], -3.0, 5.0) * self.metre;
            let (across, down) = if self.random.chance(0.5) { (reach, 0.0) } else { (0.0, reach) };
            let (fx, fy) = (self.signed(&[0.0, 300.0, 1200.0], 0.0, 6.0), self.signed(&[0.0, 1200.0, 3000.0], 0.0, 6.0));
            self.row(&bounds, &mut text);
            writeln!(text, ",{across},{down},{fx},{fy}").unwrap();
        }
        text
    }

    fn fluids(&mut self) -> String {
        let mut text = String::from("x,y,width,height,density,viscosity\n");
        let mut fluids: Vec<Aabb> = Vec::new();
        for _ in 0..self.count(&[0, 0, 1, 2, 5]) {
            let half = DVec2::new(self.random.between(1.0, 20.0), self.random.between(0.5, 8.0));
            let bounds = Aabb::around(self.anywhere(half), half);
            let (density, viscosity) =
                (self.number(&[1000.0, 800.0, 1.5], -3.0, 4.3), self.number(&[0.001, 1.0, 50.0, 1000.0], -6.0, 3.0));
            if fluids.len() == 16 || fluids.iter().any(|fluid| fluid.overlaps(&bounds, 0.0)) {
                continue;
            }
            fluids.push(bounds);
            self.row(&bounds, &mut text);
            writeln!(text, ",{density},{viscosity}").unwrap();
        }
        text
    }

    /// Mostly a few, seldom many.
    fn count(&mut self, usual: &[usize]) -> usize {
        if self.random.chance(0.02) { 40 } else { self.random.pick(usual) }
    }

    fn row(&self, bounds: &Aabb, text: &mut String) {
        let (min, size) = (bounds.min * self.metre, bounds.size() * self.metre);
        write!(text, "{},{},{},{}", min.x, min.y, size.x, size.y).unwrap();
    }

    fn anywhere(&mut self, half: DVec2) -> DVec2 {
        let (least, most) = (self.corner + half, (self.corner + self.size - half).max(self.corner + half));
        DVec2::new(self.random.between(least.x, most.x), self.random.between(least.y, most.y))
    }

    /// A place where nothing is yet, if one is found.
    fn free(&mut self, half: DVec2) -> DVec2 {
        let mut at = self.anywhere(half);
        for _ in 0..60 {
            if self.is_free(&Aabb::around(at, half)) {
                break;
            }
            at = self.anywhere(half);
        }
        self.taken.push(Aabb::around(at, half));
        at
    }

    /// A place on the ground or on a thing there, as far down as it goes.
    fn on_top(&mut self, half: DVec2) -> DVec2 {
        let x = self.anywhere(half).x;
        let over = |of: &&Aabb| of.min.x < x + half.x && of.max.x > x - half.x;
        let ground = self.corner.y + self.size.y;
        let top = self.taken.iter().filter(over).map(|of| of.min.y).fold(ground, f64::min);
        let at = DVec2::new(x, top - half.y);
        self.taken.push(Aabb::around(at, half));
        at
    }

    fn is_free(&self, bounds: &Aabb) -> bool {
        self.taken.iter().all(|taken| !taken.touches(bounds, 1e-6))
    }
}
