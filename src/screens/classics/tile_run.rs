//! The tile run in the window: played with the keys, or a list of commands that is watched, paused and stepped.

use crate::classics::tile_run::{Command, MAX_FALL, Map, Runner};
use crate::draw::layout::{Area, TEXT, Vec2};
use crate::screens::screen::{Classic, Destination, Noise, Request, Screen};
use crate::{draw::Canvas, draw::Style, settings::Key, settings::Keys};
use crate::{game::Clock, number::fixed, words::tr};
use crate::{ui::Ui, ui::input::Input, ui::input::KeyLatch, ui::pace::Motion, view::theme, view::widgets};
use std::collections::VecDeque;

/// Frames of the tile run a second: at twice as many it is too fast for fingers.
pub const FRAME_RATE: f64 = 30.0;
/// What an arrow key adds to vx in a frame, tiles a frame.
const PUSH: f64 = 0.1;
/// What Space jumps with, tiles a frame.
const JUMP: f64 = 0.6;
const TRAIL: usize = 90;

/// From the canvas' edges to the map, and from its top to it.
const MARGIN: Vec2 = Vec2::new(32.0, 136.0);
/// Kept free below the map.
const FOOT: f32 = 104.0;
/// The runner's radius, tiles. It stands on its point, which is what the map's tiles stop.
const RUNNER: f64 = 0.3;

#[derive(Debug)]
pub struct TileRun {
    map: Map,
    commands: Vec<Command>,
    pub watching: bool,
    pub paused: bool,
    pub runner: Runner,
    /// The last places, from the oldest to that before the last frame.
    trail: VecDeque<(f64, f64)>,
    pub frame: usize,
    last_command: Option<Command>,
    clock: Clock,
    latch: KeyLatch,
    noises: Vec<Noise>,
}

impl TileRun {
    /// The runner at the start of the map, obeying the keys.
    pub fn new(map: Map, commands: Vec<Command>) -> Self {
        Self {
            runner: Runner::new(&map),
            map,
            commands,
            watching: false,
            paused: false,
            trail: VecDeque::new(),
            frame: 0,
            last_command: None,
            clock: Clock::new(FRAME_RATE),
            latch: KeyLatch::default(),
            noises: Vec::new(),
        }
    }

    fn go_on(&mut self, input: &Input) {
        self.latch.frame(input);
        if self.paused {
            return;
        }
        self.clock.add(input.frame_time);
        while self.clock.tick() {
            self.run_frame();
        }
    }

    fn restart(&mut self, watching: bool) {
        self.runner = Runner::new(&self.map);
        self.trail.clear();
        self.frame = 0;
        self.last_command = None;
        (self.watching, self.paused) = (watching, false);
        (self.clock, self.latch) = (Clock::new(FRAME_RATE), KeyLatch::default());
    }

    /// A frame of the run; none is left after the last command.
    fn run_frame(&mut self) {
        let keys = self.latch.take();
        let command = if self.watching { self.commands.get(self.frame).copied() } else { Some(self.command(keys)) };
        let Some(command) = command else { return };
        self.trail.push_back((self.runner.x, self.runner.y));
        if self.trail.len() > TRAIL {
            self.trail.pop_front();
        }
        let before = self.runner;
        self.runner.frame(&self.map, command);
        if before.on_ground && matches!(command, Command::Jump(_)) {
            self.noises.push(Noise::Jump);
        } else if self.runner.on_ground && !before.on_ground {
            self.noises.push(Noise::Landing((before.vy / MAX_FALL).clamp(0.0, 1.0)));
        }
        self.last_command = Some(command);
        self.frame += 1;
    }

    /// One command a frame: on the ground Space goes before the arrow keys.
    fn command(&self, keys: Keys) -> Command {
        match (keys.has(Key::Left), keys.has(Key::Right)) {
            _ if keys.has(Key::Space) && self.runner.on_ground => Command::Jump(JUMP),
            (true, false) => Command::Left(PUSH),
            (false, true) => Command::Right(PUSH),
            (_, _) => Command::Wait,
        }
    }

    fn draw(&self, canvas: &Canvas) {
        let rows = self.map.rows();
        let tiles = Vec2::new(rows.iter().map(Vec::len).max().unwrap_or(1) as f32, rows.len() as f32);
        let room = canvas.size() - 2.0 * MARGIN + Vec2::new(0.0, MARGIN.y - FOOT);
        let pixel = canvas.frame().pixel;
        let side = ((room / tiles).min_element() / pixel).floor().max(1.0) * pixel;
        let corner = Vec2::new((canvas.size().x - side * tiles.x) / 2.0, MARGIN.y + (room.y - side * tiles.y) / 2.0);
        let at = |x: f64, y: f64| corner + Vec2::new(x as f32, y as f32) * side;

        widgets::graph_paper(canvas);
        widgets::heading(canvas, tr("Tile Run"), 40.0);
        self.draw_map(canvas, corner, side);
        for (age, &(x, y)) in self.trail.iter().rev().enumerate() {
            let fading = 1.0 - age as f32 / TRAIL as f32;
            canvas.disc(at(x, y - RUNNER), side * 0.12, theme::accent().faded(0.6 * fading));
        }
        let (x, y) = self.drawn_place();
        canvas.disc(at(x, y - RUNNER), side * RUNNER as f32, theme::accent());
        canvas.ring(at(x, y - RUNNER), side * RUNNER as f32, 0.1 * side, theme::text());
        self.draw_words(canvas);
    }

    /// Between the last two frames of the run; where it stands still, at the last.
    fn drawn_place(&self) -> (f64, f64) {
        let (x, y) = (self.runner.x, self.runner.y);
        let alpha = if self.paused || self.ended() { 1.0 } else { self.clock.alpha() };
        let &(from_x, from_y) = self.trail.back().unwrap_or(&(x, y));
        (from_x + alpha * (x - from_x), from_y + alpha * (y - from_y))
    }

    fn ended(&self) -> bool {
        self.watching && self.frame == self.commands.len()
    }

    fn draw_map(&self, canvas: &Canvas, corner: Vec2, side: f32) {
        let rows = self.map.rows();
        let is_solid = |row: usize, column: usize| rows[row].get(column).copied().unwrap_or(true);
        let widest = rows.iter().map(Vec::len).max().unwrap_or(0);
        let tile = |column: usize, row: usize, width: usize, height: f32| {
            Area::new(corner.x + column as f32 * side, corner.y + row as f32 * side, width as f32 * side, height * side)
        };
        canvas.rounded(tile(0, 0, widest, rows.len() as f32).inset(-4.0), 4.0, theme::solid());
        for (row, _) in rows.iter().enumerate() {
            for (from, to, solid) in runs(widest, |column| is_solid(row, column)) {
                if !solid {
                    canvas.rounded(tile(from, row, to - from, 1.0), 0.0, theme::ground());
                }
            }
        }
        for column in 1..widest {
            let line = tile(column, 0, 0, rows.len() as f32);
            canvas.hairline(line.min, line.max(), theme::grid_heavy().faded(0.7));
        }
        for row in 1..rows.len() {
            let line = tile(0, row, widest, 0.0);
            canvas.hairline(line.min, line.max(), theme::grid_heavy().faded(0.7));
            for (from, to, top) in runs(widest, |column| is_solid(row, column) && !is_solid(row - 1, column)) {
                if top {
                    canvas.rounded(tile(from, row, to - from, 0.14), 0.0, theme::solid_top());
                }
            }
        }
        let (column, row) = self.map.start;
        canvas.rounded_edge(tile(column, row, 1, 1.0).inset(1.0), 3.0, 2.0, theme::player_objective());
    }

    fn draw_words(&self, canvas: &Canvas) {
        let style = Style::new(TEXT, theme::quiet()).middle();
        let middle = canvas.size().x / 2.0;
        let hint = match (self.watching, self.ended(), self.paused) {
            (false, ..) => tr("Left and Right run, Space jumps").to_owned(),
            (true, true, _) => {
                let (column, row) = self.runner.tile();
                tr!("All {count} commands done: tile ({column}, {row})", count = self.commands.len(), column, row)
            }
            (true, false, true) => {
                tr!("Paused before command {number} of {count}", number = self.frame + 1, count = self.commands.len())
            }
            (true, false, false) => {
                tr!("Watching command {number} of {count}", number = self.frame + 1, count = self.commands.len())
            }
        };
        canvas.text(&hint, Vec2::new(middle, 80.0), style.centred());

        let signed = |number: f64| format!("{:>8}", fixed(number, 3));
        let runner = &self.runner;
        let figures = tr!(
            "frame {frame}   x {x}   y {y}   vx {vx}   vy {vy}   {place}  {command}",
            frame = format_args!("{:>5}", self.frame),
            x = signed(runner.x),
            y = signed(runner.y),
            vx = signed(runner.vx),
            vy = signed(runner.vy),
            place = format_args!("{:<7}", if runner.on_ground { tr("ground") } else { tr("air") }),
            command = format_args!("{:<11}", self.last_command.map_or_else(String::new, words))
        );
        canvas.text(&figures, Vec2::new(middle, 112.0), style.mono().centred());
    }
}

impl Screen for TileRun {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        // The passes that show take no time.
        if ui.input().frame_time > 0.0 {
            self.noises.clear();
        }
        self.draw(ui.canvas());
        let (other, pause) = (if self.watching { "Play" } else { "Watch" }, if self.paused { "Go on" } else { "Pause" });
        let tools = [
            ("Back", Key::Escape, "Esc"),
            ("Restart", Key::R, "R"),
            (other, Key::Tab, "Tab"),
            (pause, Key::Space, "Space"),
            ("Step", Key::Right, "→"),
        ];
        match ui.tools(if self.watching { &tools } else { &tools[..3] }) {
            Some("Back") => return Some(Request::Pop),
            Some("Restart") => self.restart(self.watching),
            Some("Step") => {
                self.paused = true;
                self.run_frame();
            }
            Some("Pause" | "Go on") => self.paused = !self.paused,
            Some(_) => self.restart(!self.watching),
            None => {}
        }
        self.go_on(ui.input());
        None
    }

    fn parent(&self) -> Destination {
        Destination::Classics(Some(Classic::TileRun))
    }

    fn motion(&self, _: &Input) -> Motion {
        if self.paused { Motion::Still } else { Motion::Full }
    }

    fn tune(&self) -> Option<&str> {
        Some("tile run")
    }

    fn noises(&self) -> Vec<Noise> {
        self.noises.clone()
    }
}

fn words(command: Command) -> String {
    match command {
        Command::Left(value) => format!("LEFT {value}"),
        Command::Right(value) => format!("RIGHT {value}"),
        Command::Jump(value) => format!("JUMP {value}"),
        Command::Wait => "WAIT".to_owned(),
    }
}

/// Stretches of 0 … `end` over which `what` is the same: from, to, and what.
fn runs(end: usize, what: impl Fn(usize) -> bool) -> Vec<(usize, usize, bool)> {
    let mut runs: Vec<(usize, usize, bool)> = Vec::new();
    for i in 0..end {
        match runs.last_mut() {
            Some((_, to, same)) if *same == what(i) => *to = i + 1,
            _ => runs.push((i, i + 1, what(i))),
        }
    }
    runs
}
