//! The jumper in the window: how many climb, the climb, and what it came to.

use crate::classics::jumper::engine::{Cuboid, CuboidHit, StaticKind, WIDTH};
use crate::classics::jumper::{JumpKeys, JumperScene, LEADERBOARD, PLAYER_SIZE, VISIBLE};
use crate::draw::layout::{Area, BUTTON_TEXT, GAP, HEADING, PADDING, TEXT, Vec2, WIDE_BUTTON};
use crate::draw::{Canvas, Colour, Style};
use crate::screens::screen::{Classic, Destination, Noise, Request, Screen};
use crate::session::{Gain, Session, recordings::Visit};
use crate::ui::{Spectator, Ui, input::Input, input::KeyLatch, pace::Motion};
use crate::{game::Clock, game::TICK_RATE, settings::Key, settings::Keys, view::theme, view::widgets, words::tr};

/// What its leaderboard is of, in words.
pub const SUBJECT: &str = "the Jumper";

/// A landing at this speed is as loud as they get, m/s.
const HARD: f64 = 12.0;

const ONE: &str = "One Player";
const TWO: &str = "Two Players";
const RESUME: &str = "Resume";
const AGAIN: &str = "Climb Again";
const SAVE: &str = "Save Score";
const BOARD: &str = "Leaderboard";
const BACK: &str = "Back";

/// Above the panel's first button: its heading and the height.
const HEAD: f32 = 96.0;

/// Below the view's lower edge, canvas units: the ground, or what is left behind.
const FOOT: f32 = 24.0;
/// Heights that the ruler names, m.
const RULER_STEP: i64 = 5;

#[derive(Debug)]
pub struct Jumper {
    /// The climb; before the first one a tower to look at.
    pub scene: JumperScene,
    panel: Option<ClimbPanel>,
    clock: Clock,
    latch: KeyLatch,
    /// How long the screen has been there, s: a tower's seed, so that each sitting has its own towers.
    shown_for: f64,
    noises: Vec<Noise>,
}

#[derive(Debug)]
struct ClimbPanel {
    heading: &'static str,
    labels: Vec<&'static str>,
}

impl Default for Jumper {
    fn default() -> Self {
        Self::with_panel(JumperScene::new(0, true), tr("Jumper"), vec![ONE, TWO, BOARD, BACK])
    }
}

impl Jumper {
    /// A climb that has ended, saved for who plays, and what may be done with it.
    pub fn ended(scene: JumperScene, session: &mut Session) -> Self {
        let (board, subject, points) = (LEADERBOARD.to_owned(), tr(SUBJECT).to_owned(), scene.score());
        if points > 0 {
            // What cannot be saved waits.
            let _ = session.save(Gain { board, subject, points, flown: None });
        }
        let save = session.nameless().any(|(board, _)| board == LEADERBOARD).then_some(SAVE);
        let labels = [AGAIN].into_iter().chain(save).chain([BOARD, BACK]).collect();
        Self::with_panel(scene, tr("The view has left you behind"), labels)
    }

    fn with_panel(scene: JumperScene, heading: &'static str, labels: Vec<&'static str>) -> Self {
        Self { panel: Some(ClimbPanel { heading, labels }), ..Self::climbing(scene) }
    }

    fn climbing(scene: JumperScene) -> Self {
        Self { scene, panel: None, clock: Clock::new(TICK_RATE), latch: KeyLatch::default(), shown_for: 0.0, noises: Vec::new() }
    }

    /// A frame of the climb: a request where it has ended.
    fn go_on(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        if ui.key(Key::Escape) {
            self.panel = Some(ClimbPanel { heading: tr("Paused"), labels: vec![RESUME, AGAIN, BACK] });
            return None;
        }
        if ui.key(Key::R) {
            self.climb(self.is_of_two());
            return None;
        }
        self.latch.frame(ui.input());
        self.clock.add(ui.input().frame_time);
        while self.clock.tick() {
            self.tick();
        }
        self.scene.is_over().then(|| Request::Reset(Destination::Climbed(Box::new(self.scene.clone()))))
    }

    fn tick(&mut self) {
        let before: Vec<_> = self.scene.players().map(|(_, body)| (body.on_ground, body.velocity.z)).collect();
        self.scene.tick(held(self.latch.take(), self.is_of_two()));
        for ((player, body), (stood, rising)) in self.scene.players().zip(before) {
            if player.jumped {
                self.noises.push(Noise::Jump);
            } else if body.on_ground && !stood {
                self.noises.push(Noise::Landing((-rising / HARD).clamp(0.0, 1.0)));
            }
        }
        if self.scene.hits.iter().any(|hit| matches!(hit, CuboidHit::Pair(..))) {
            self.noises.push(Noise::Bump);
        }
    }

    fn is_of_two(&self) -> bool {
        self.scene.players().count() == 2
    }

    fn climb(&mut self, two: bool) {
        let seed = self.shown_for.to_bits();
        *self = Self { shown_for: self.shown_for, ..Self::climbing(JumperScene::new(seed, two)) };
    }

    fn show_panel(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let ClimbPanel { heading, labels } = self.panel.as_ref()?;
        ui.layer(0.6);
        let size = ui.frame().size;
        let column = labels.len() as f32 * (WIDE_BUTTON.y + GAP) - GAP;
        let first = ((size.y - column + HEAD) / 2.0).round();
        let (top, width) = (first - HEAD - PADDING, WIDE_BUTTON.x + 12.0 * PADDING);
        let area = Area::new((size.x - width) / 2.0, top, width, first + column + 2.0 * PADDING - top);
        ui.panel(area);
        let middle = |y: f32| Vec2::new(area.centre().x, top + y);
        let sizes = [HEADING, BUTTON_TEXT];
        widgets::fitted(ui.canvas(), heading, middle(PADDING + 24.0), width - 32.0, &sizes, theme::text());
        if self.scene.ticks > 0 {
            let score = tr!("{height} m high", height = self.scene.score());
            ui.fitted(&score, middle(PADDING + 64.0), &[TEXT], theme::quiet());
        }
        let pressed = ui.column(first, labels);
        let left = || if labels.contains(&RESUME) { RESUME } else { BACK };
        match if ui.key(Key::Escape) { left() } else { pressed? } {
            ONE => self.climb(false),
            TWO => self.climb(true),
            AGAIN => self.climb(self.is_of_two()),
            RESUME => {
                self.panel = None;
                self.latch = KeyLatch::default();
            }
            SAVE => return Some(Request::Push(Destination::Players)),
            BOARD => return Some(Request::Reset(Destination::Board(Visit::of(LEADERBOARD)))),
            _ => return Some(Request::Pop),
        }
        None
    }

    fn draw(&self, canvas: &Canvas) {
        let view = View::new(canvas, self.scene.view_bottom(self.clock.alpha()));
        widgets::graph_paper(canvas);
        self.draw_tower(canvas, &view);
        self.draw_players(canvas, &view);
        self.draw_words(canvas, &view);
    }

    fn draw_tower(&self, canvas: &Canvas, view: &View) {
        let tower = view.area(0.0, view.bottom, WIDTH, VISIBLE);
        canvas.rounded(tower, 0.0, theme::ground());
        for metre in 1..WIDTH as i32 {
            let x = view.point(f64::from(metre), 0.0).x;
            canvas.hairline(Vec2::new(x, tower.min.y), Vec2::new(x, tower.max().y), theme::grid_fine());
        }
        let (from, to) = (view.bottom.ceil() as i64, (view.bottom + VISIBLE).floor() as i64);
        for metre in from.max(0)..=to {
            let y = view.point(0.0, metre as f64).y;
            let named = metre % RULER_STEP == 0;
            let colour = if named { theme::grid_heavy() } else { theme::grid_fine() };
            canvas.hairline(Vec2::new(tower.min.x, y), Vec2::new(tower.max().x, y), colour);
            if named && y > TEXT {
                let at = Vec2::new(tower.max().x + PADDING, y);
                canvas.text(&format!("{metre} m"), at, Style::new(TEXT, theme::quiet()).mono().middle());
            }
        }
        for it in &self.scene.tower.statics {
            let Cuboid { location, dimensions } = it.cuboid;
            let (z, height) = match it.kind {
                StaticKind::Platform => (location.z, dimensions.z),
                StaticKind::Wall => (view.bottom - 1.0, VISIBLE + 2.0),
            };
            let area = view.area(location.x, z, dimensions.x, height);
            canvas.rounded(area, 2.0, theme::solid());
            if it.kind == StaticKind::Platform {
                canvas.rounded(Area { size: Vec2::new(area.size.x, 1.5), ..area }, 0.0, theme::solid_top());
            }
        }
        let foot = Area { min: Vec2::new(tower.min.x, tower.max().y), size: Vec2::new(tower.size.x, FOOT) };
        if self.scene.view_bottom(1.0) > 0.0 {
            // What is left behind is out: the edge is as red as everything that ends an attempt.
            canvas.rounded(foot, 0.0, theme::panel());
            for (height, alpha) in [(0.45, 0.12), (0.25, 0.2), (0.08, 0.9)] {
                canvas.rounded(view.area(0.0, view.bottom, WIDTH, height), 0.0, theme::bad().faded(alpha));
            }
        } else {
            canvas.rounded(foot, 0.0, theme::solid());
            canvas.rounded(Area { size: Vec2::new(foot.size.x, 2.0), ..foot }, 0.0, theme::solid_top());
        }
    }

    fn draw_players(&self, canvas: &Canvas, view: &View) {
        let alpha = self.clock.alpha();
        let two = self.is_of_two();
        for (number, (player, body)) in self.scene.players().enumerate().filter(|(_, (player, _))| !player.is_out()) {
            let place = body.previous + alpha * (body.cuboid.location - body.previous);
            let area = view.area(place.x, place.z, PLAYER_SIZE, PLAYER_SIZE);
            canvas.rounded(area, 3.0, colour_of(number));
            let eye = Vec2::new(area.centre().x + area.size.x * 0.22 * player.direction as f32, area.min.y + area.size.y * 0.35);
            canvas.disc(eye, area.size.x * 0.14, theme::ground());
            if two {
                let above = Vec2::new(area.centre().x, area.min.y - 12.0);
                canvas.text(&(number + 1).to_string(), above, Style::new(TEXT, colour_of(number)).mono().centred().middle());
            }
        }
    }

    fn draw_words(&self, canvas: &Canvas, view: &View) {
        let right = view.point(0.0, 0.0).x - 48.0;
        let quiet = Style::new(TEXT, theme::quiet()).right().middle();
        canvas.text(tr("Height"), Vec2::new(right, 48.0), quiet);
        canvas.text(
            &format!("{} m", self.scene.score()),
            Vec2::new(right, 84.0),
            Style::new(HEADING, theme::text()).mono().right().middle(),
        );
        let [left, right_key, jump] = [Key::A, Key::D, Key::W].map(Key::label_by_place);
        let keys = if self.is_of_two() {
            [
                (tr!("1: {left} {right} walk, {jump} jumps", left, right = right_key, jump), 0),
                (tr("2: ← → walk, ↑ jumps").to_owned(), 1),
            ]
        } else {
            [(tr!("{left} {right} or ← → walk", left, right = right_key), 0), (tr!("{jump}, ↑ or Space jumps", jump), 0)]
        };
        let (mut at, pitch) = (Vec2::new(right, 152.0), canvas.line_height(TEXT).max(28.0));
        let mut paragraph = |words: &str, style: Style| {
            for line in widgets::lines(canvas, words, right - PADDING, style) {
                canvas.text(&line, at, style);
                at.y += pitch;
            }
        };
        keys.iter().for_each(|(words, player)| paragraph(words, Style { colour: colour_of(*player), ..quiet }.mono()));
        paragraph("", quiet);
        paragraph(tr("Jump once more in the air;"), quiet);
        paragraph(tr("let go early for a low jump."), quiet);
        paragraph("", quiet);
        paragraph(tr("Esc pauses, R restarts."), quiet);
        paragraph("", quiet);
        for (number, (player, _)) in self.scene.players().enumerate() {
            if player.is_out() && self.is_of_two() {
                paragraph(&tr!("Player {number} is out", number = number + 1), Style { colour: theme::bad(), ..quiet });
            }
        }
    }
}

/// Who holds what: alone, either half of the keyboard will do.
fn held(keys: Keys, two: bool) -> [JumpKeys; 2] {
    let letters = JumpKeys { left: keys.has_place(Key::A), right: keys.has_place(Key::D), jump: keys.has_place(Key::W) };
    let arrows = JumpKeys { left: keys.has(Key::Left), right: keys.has(Key::Right), jump: keys.has(Key::Up) };
    if two {
        return [letters, arrows];
    }
    let either = JumpKeys {
        left: letters.left || arrows.left,
        right: letters.right || arrows.right,
        jump: letters.jump || arrows.jump || keys.has(Key::Space),
    };
    [either, JumpKeys::default()]
}

impl Screen for Jumper {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.shown_for += ui.input().frame_time;
        // The passes that show take no time.
        if ui.input().frame_time > 0.0 {
            self.noises.clear();
        }
        self.draw(ui.canvas());
        if self.panel.is_some() { self.show_panel(ui) } else { self.go_on(ui) }
    }

    fn come_back(&mut self, _: &dyn Screen, session: &mut Session, _: &mut dyn Spectator) {
        *self = Self::ended(self.scene.clone(), session);
    }

    fn parent(&self) -> Destination {
        Destination::Classics(Some(Classic::Jumper))
    }

    fn motion(&self, _: &Input) -> Motion {
        Motion::Full
    }

    fn tune(&self) -> Option<&str> {
        Some("jumper")
    }

    fn noises(&self) -> Vec<Noise> {
        self.noises.clone()
    }
}

/// The colour of each player; the number above them tells them apart without it.
fn colour_of(player: usize) -> Colour {
    if player == 0 { theme::accent() } else { theme::text() }
}
/// The part of the tower that is in view: the canvas' height but for its foot, in the middle of its width.
struct View {
    bottom: f64,
    left: f32,
    height: f32,
    /// Canvas units a metre.
    scale: f32,
}

impl View {
    fn new(canvas: &Canvas, bottom: f64) -> Self {
        let height = canvas.size().y - FOOT;
        let scale = height / VISIBLE as f32;
        Self { bottom, left: (canvas.size().x - scale * WIDTH as f32) / 2.0, height, scale }
    }

    fn point(&self, x: f64, z: f64) -> Vec2 {
        Vec2::new(self.left + x as f32 * self.scale, self.height - (z - self.bottom) as f32 * self.scale)
    }

    /// The box whose lower left corner is at (x, z).
    fn area(&self, x: f64, z: f64, width: f64, height: f64) -> Area {
        let size = Vec2::new(width as f32, height as f32) * self.scale;
        Area { min: self.point(x, z) - Vec2::new(0.0, size.y), size }
    }
}
