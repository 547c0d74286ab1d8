use super::{Half, SideBySide, panels};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::{draw::chart::Decades, draw::chart::LEAST_ERROR, number::power, number::short, physics::Aabb, physics::DVec2};
use crate::{lab::TOLERANCE, lab::methods::rules, view::theme, view::widgets, words::tr};

/// Height of the line at a half's foot: its error.
const FOOT: f32 = 40.0;
/// Between two words below the halves, and the most that the sample and the gap before them take.
const BETWEEN: f32 = 24.0;
const SAMPLE: f32 = 42.0;
/// Larger errors have this many decimals, so that they do not jitter.
const PLAIN: f64 = 1e-3;

fn colour_of(half: usize) -> Colour {
    if half == 0 { theme::player_objective() } else { theme::accent() }
}

/// A half's errors: the second half's line is dashed.
fn draw_line(canvas: &Canvas, line: &[Vec2], half: usize) {
    if half == 0 {
        line.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], 2.0, colour_of(half)));
    } else {
        canvas.dashed(line, &[8.0, 5.0], 2.0, colour_of(half));
    }
}

impl SideBySide {
    pub(super) fn draw(&self, canvas: &Canvas, body: Area) {
        let halves = panels(body, canvas.frame());
        let title = Vec2::new(body.centre().x, body.min.y + 20.0);
        canvas.text(tr(self.exhibit().title), title, Style::new(BUTTON_TEXT, theme::text()).centred().middle());
        let small = self.halves().iter().any(|half| {
            let (rule, uses) = rules::of(half.method).unwrap_or_default();
            let wide = |words: &str| canvas.width(tr(words), Style::new(TEXT, theme::text())) > halves[0].size.x;
            wide(rule) || wide(uses)
        });
        let size = if small { DETAILS } else { TEXT };
        for (i, (half, panel)) in self.halves().iter().zip(halves).enumerate() {
            self.draw_half(canvas, half, panel, (i, size));
        }
        let (left, right) = (halves[0], halves[1]);
        let below = |top: f32, height: f32| Area::new(left.min.x, left.max().y + top, right.max().x - left.min.x, height);
        self.draw_errors(canvas, below(super::APART, super::ERRORS));
        self.draw_words(canvas, below(super::APART + super::ERRORS, super::TIME));
    }

    /// The meaning of the outline and of the lines above at the left, the time at the right.
    fn draw_words(&self, canvas: &Canvas, row: Area) {
        let quiet = Style::new(TEXT, theme::quiet()).middle();
        let speed = self.exhibit().speed;
        let pace = if speed < 1.0 { tr!("   {speed} times slower", speed = short(1.0 / speed)) } else { String::new() };
        let end = if self.is_over() { tr("   the end") } else { "" };
        let words = tr!("time {time} s{pace}{end}", time = format_args!("{:6.3}", self.time()), pace, end);
        canvas.text(&words, Vec2::new(row.max().x, row.centre().y), quiet.mono().right());
        let end = row.max().x - canvas.width(&words, quiet.mono()) - BETWEEN;
        let y = row.centre().y;
        let ghost = |left: f32| {
            canvas.rounded_edge(Area::around(Vec2::new(left + 8.0, y), Vec2::splat(16.0)), 0.0, 2.0, theme::good());
            16.0
        };
        let line = |left: f32| {
            canvas.line(Vec2::new(left, y), Vec2::new(left + 32.0, y), 2.0, theme::good());
            32.0
        };
        let bare = |_: f32| 0.0;
        let samples: [(&dyn Fn(f32) -> f32, &str); 3] =
            [(&ghost, tr("the exact answer")), (&line, tr("a tenth of a pixel, 1/300 m")), (&bare, tr("above: the errors so far"))];
        let mut left = row.min.x;
        // What has no room beside the time is left out, the last one first.
        for (sample, words) in samples {
            let width = canvas.width(words, quiet);
            if left + SAMPLE + width > end {
                break;
            }
            let from = left + sample(left) + 10.0;
            canvas.text(words, Vec2::new(from, y), quiet);
            left = from + width + BETWEEN;
        }
    }

    fn draw_errors(&self, canvas: &Canvas, panel: Area) {
        widgets::panel(canvas, panel);
        let decades = Decades { from: -15, to: 2 };
        let quiet = Style::new(DETAILS, theme::quiet()).middle();
        // Large words leave room for every second one.
        let each = if canvas.frame().text_height(DETAILS) > 0.25 * (panel.size.y - 20.0) { 2 } else { 1 };
        let named = [-15, -10, -5, 0].into_iter().step_by(each).map(|exponent| (exponent, format!("{} m", power(exponent))));
        let named: Vec<_> = named.collect();
        let left = named.iter().map(|(_, words)| canvas.width(words, quiet)).fold(0.0, f32::max) + 16.0;
        let edge = (0.6 * canvas.frame().text_height(DETAILS)).max(10.0);
        let area = Area::new(panel.min.x + left, panel.min.y + edge, panel.size.x - left - 12.0, panel.size.y - 2.0 * edge);
        let level = |error: f64| area.max().y - area.size.y * decades.part(error) as f32;
        for (exponent, words) in named {
            let y = level(10f64.powi(exponent));
            canvas.hairline(Vec2::new(area.min.x, y), Vec2::new(area.max().x, y), theme::panel_edge());
            canvas.text(&words, Vec2::new(area.min.x - 8.0, y), quiet.right());
        }
        let seen = level(TOLERANCE);
        canvas.hairline(Vec2::new(area.min.x, seen), Vec2::new(area.max().x, seen), theme::good());
        for (i, half) in self.halves().iter().enumerate() {
            let place = |(part, error): (usize, &f64)| {
                let right = area.size.x * (part + 1) as f32 / Half::parts() as f32;
                let error = if error.is_finite() { error.max(LEAST_ERROR) } else { f64::MAX };
                Vec2::new(area.min.x + right, level(error))
            };
            let line: Vec<Vec2> = half.errors.iter().enumerate().map(place).collect();
            draw_line(canvas, &line, i);
        }
    }

    fn draw_half(&self, canvas: &Canvas, half: &Half<'_>, panel: Area, (which, size): (usize, f32)) {
        let colour = colour_of(which);
        widgets::panel(canvas, panel);
        let name = Vec2::new(panel.centre().x, panel.min.y - super::head(canvas.frame()) + super::CHOICE.y / 2.0);
        widgets::fitted(canvas, tr(half.method), name, panel.size.x - 2.0 * super::CHOICE.x - 32.0, &[BUTTON_TEXT, TEXT], colour);
        let (rule, uses) = rules::of(half.method).unwrap_or_default();
        let line = if canvas.frame().text > 1.0 { 1.05 * canvas.frame().text_height(DETAILS) } else { 20.0 };
        let mut up = (0.6 * canvas.frame().text_height(DETAILS)).max(12.0);
        for (words, colour) in [(uses, theme::quiet()), (rule, theme::text())] {
            let style = Style::new(size, colour).centred().middle();
            for words in widgets::lines(canvas, tr(words), panel.size.x, style).iter().rev() {
                canvas.text(words, Vec2::new(panel.centre().x, panel.min.y - up), style);
                up += line;
            }
        }
        let stage = Area { min: panel.min, size: panel.size - Vec2::new(0.0, FOOT) };
        let place = Placing::new(&self.exhibit().view, stage.inset(8.0));
        for solid in &self.exhibit().solid {
            place.fill(canvas, solid, theme::solid());
        }
        for body in self.exact() {
            place.edge(canvas, body, theme::good());
        }
        let now: Vec<DVec2> = half.boxes.iter().map(Aabb::centre).collect();
        let moments: Vec<&Vec<DVec2>> = half.trail.iter().chain([&now]).collect();
        for pair in moments.windows(2) {
            for (from, to) in pair[0].iter().zip(pair[1]) {
                place.stroke(canvas, (*from, *to), colour.faded(0.5));
            }
        }
        for body in half.boxes.iter().filter(|_| self.exhibit().bound.is_some()) {
            place.stroke(canvas, (self.exhibit().bound.unwrap_or_default(), body.centre()), theme::quiet());
        }
        for body in half.boxes {
            place.fill(canvas, body, colour.faded(0.35));
            place.edge(canvas, body, colour);
        }
        canvas.hairline(
            Vec2::new(panel.min.x + 16.0, stage.max().y),
            Vec2::new(panel.max().x - 16.0, stage.max().y),
            theme::panel_edge(),
        );
        let y = stage.max().y + FOOT / 2.0;
        let reach = (5.2 * canvas.frame().text_height(TEXT)).max(96.0);
        canvas.text(tr("error"), Vec2::new(panel.centre().x - reach, y), Style::new(TEXT, theme::quiet()).middle());
        let sample = Vec2::new(panel.centre().x - reach - 12.0, y);
        draw_line(canvas, &[sample - Vec2::new(48.0, 0.0), sample], which);
        let (seen, number) = (half.error <= TOLERANCE, Vec2::new(panel.centre().x + reach, y));
        let style = Style::new(TEXT, if seen { theme::good() } else { theme::bad() }).middle();
        canvas.text(&metres(half.error), number, style.mono().right());
        let mark = number + Vec2::new(20.0, 0.0);
        if seen { widgets::tick(canvas, mark, 7.0, theme::good()) } else { canvas.text("×", mark, style.centred()) }
    }
}

fn metres(error: f64) -> String {
    match error {
        0.0 => "0 m".to_owned(),
        _ if !error.is_finite() => "∞ m".to_owned(),
        _ if error >= PLAIN => format!("{error:.3} m"),
        _ => format!("{} m", short(error)),
    }
}

/// From metres to a panel, without stretching.
struct Placing {
    view: Aabb,
    panel: Area,
    scale: f32,
}

impl Placing {
    fn new(view: &Aabb, panel: Area) -> Self {
        let size = view.size();
        let scale = (panel.size.x / size.x as f32).min(panel.size.y / size.y as f32);
        Self { view: *view, panel, scale }
    }

    fn at(&self, point: DVec2) -> Vec2 {
        let from_middle = point - self.view.centre();
        self.panel.centre() + Vec2::new(from_middle.x as f32, from_middle.y as f32) * self.scale
    }

    fn seen(&self, body: &Aabb) -> Option<Area> {
        let inside = |point: Vec2| point.clamp(self.panel.min, self.panel.max());
        let (min, max) = (inside(self.at(body.min)), inside(self.at(body.max)));
        (max.x > min.x && max.y > min.y).then_some(Area { min, size: max - min })
    }

    /// `None` where an end is outside the panel.
    fn stroke(&self, canvas: &Canvas, (from, to): (DVec2, DVec2), colour: Colour) {
        let (from, to) = (self.at(from), self.at(to));
        let inside = |point: Vec2| point.cmpge(self.panel.min).all() && point.cmple(self.panel.max()).all();
        if from != to && inside(from) && inside(to) {
            canvas.line(from, to, 2.0, colour);
        }
    }

    fn fill(&self, canvas: &Canvas, body: &Aabb, colour: Colour) {
        if let Some(area) = self.seen(body) {
            canvas.rounded(area, 0.0, colour);
        }
    }

    fn edge(&self, canvas: &Canvas, body: &Aabb, colour: Colour) {
        if let Some(area) = self.seen(body) {
            canvas.rounded_edge(area, 0.0, 2.0, colour);
        }
    }
}
