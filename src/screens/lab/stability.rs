//! The methods' regions of stability in the complex plane of z = h·λ, and why explicit Euler gains energy: a picture and three sentences.

use super::BACK;
use super::charts::{self, LegendPick, METHOD, panel};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, PADDING, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::methods::motion::{MotionLaw, MotionStep, PointState, explicit_euler, semi_implicit_euler};
use crate::lab::stability::{Region, TITLE as REGIONS_TITLE, regions};
use crate::{draw::chart::Marker, draw::chart::marker, lab::drawing::plane, lab::drawing::plane::Plane, physics::DVec2, ui::Ui};
use crate::{screens::screen::Request, settings::Key, view::theme, view::widgets, words::tr};

const NO_SINGLE_Z: &str =
    "It has no single z: places and velocities take different steps, so the plane shows the growth of the damped oscillator at z.";

/// Of a method without a single z, that; else as beside its curve.
fn about(region: &Region) -> Option<[String; 2]> {
    let [first, second] = charts::about(region.name)?;
    Some([first, if region.single { second } else { tr(NO_SINGLE_Z).to_owned() }])
}

#[derive(Debug, Default)]
pub struct StabilityPage {
    regions: Vec<Region>,
    legend: LegendPick,
}

impl StabilityPage {
    /// Computed when they are first asked for.
    pub(super) fn regions(&mut self) -> &[Region] {
        if self.regions.is_empty() {
            self.regions = regions();
        }
        &self.regions
    }

    pub(super) fn show(&mut self, ui: &mut Ui<'_>, body: Area) -> Option<Request> {
        self.regions();
        let tool = ui.tools(&[BACK, METHOD]);
        if tool == Some("Method") {
            self.legend.go(1, self.regions.len());
        } else if ui.key(Key::Up) {
            self.legend.go(-1, self.regions.len());
        }
        let plane = Plane::of(panel(body, &ui.frame()), &ui.frame());
        let (middle, widest) = (plane.panel.centre().x, plane.panel.size.x);
        let at = |y: f32| Vec2::new(middle, y);
        widgets::fitted(ui.canvas(), tr(REGIONS_TITLE), at(plane.panel.min.y - 20.0), widest, &[BUTTON_TEXT, TEXT], theme::text());
        let lines = self.regions.iter().enumerate().map(|(line, region)| (region.name, plane.legend(line + 1)));
        let picked = self.legend.show(ui, lines);
        plane::draw(ui.canvas(), &plane, &self.regions, picked);
        let words =
            picked.and_then(|picked| about(&self.regions[picked])).unwrap_or(plane::WORDS.map(|words| tr(words).to_owned()));
        charts::words_below(ui.canvas(), plane.panel, words.each_ref().map(|words| (words.as_str(), TEXT, theme::text())));
        (tool == Some("Back")).then_some(Request::Pop)
    }
}

const TITLE: &str = "Why Euler gains energy";
const SENTENCES: [&str; 3] = [
    "A body on a spring goes round a circle, if its place x counts to the right and v/ω upwards: its energy goes with the square of the radius.",
    "Explicit Euler goes straight on along the tangent and leaves the circle: each step multiplies the energy by 1 + (ω·h)², however small it is.",
    "Semi-implicit Euler moves by the new velocity, and its corners lie on an ellipse for ever; the engine turns by the angle ω·h and stays on the circle.",
];
/// ω·h.
const TURN: f64 = 0.4;
const STEPS: usize = 12;
const LEGEND: [(&str, Option<Marker>); 3] =
    [("explicit Euler", Some(Marker::Square)), ("semi-implicit Euler", Some(Marker::Up)), ("exact, and the shipped engine", None)];
/// The picture's part of the width, the same where words are large, and the radius of the circle in its half height.
const PICTURE: f32 = 0.5;
const SMALL_PICTURE: f32 = 0.42;
const RADIUS: f32 = 0.17;

pub(super) fn show(ui: &mut Ui<'_>, body: Area) -> Option<Request> {
    let tool = ui.tools(&[BACK]);
    let canvas = ui.canvas();
    let title = Vec2::new(body.centre().x, body.min.y + 20.0);
    canvas.text(tr(TITLE), title, Style::new(BUTTON_TEXT, theme::text()).centred().middle());
    let panel = Area::new(body.min.x, body.min.y + 40.0, body.size.x, body.size.y - 40.0);
    widgets::panel(canvas, panel);
    // Large words have more of the width.
    let picture = if canvas.frame().text > 1.0 { SMALL_PICTURE } else { PICTURE };
    draw_picture(canvas, Area { size: Vec2::new(picture * panel.size.x, panel.size.y), ..panel });
    let line = canvas.line_height(TEXT);
    let style = Style::new(TEXT, theme::text());
    let width = panel.size.x * (1.0 - picture) - 2.0 * PADDING;
    let sentences = SENTENCES.map(|sentence| widgets::lines(canvas, tr(sentence), width, style));
    let rows = sentences.iter().map(Vec::len).sum::<usize>() + LEGEND.len();
    let room = panel.size.y - 3.0 * PADDING - rows as f32 * line;
    let apart = line.min(room / SENTENCES.len() as f32);
    let mut at = panel.min + Vec2::new(picture * panel.size.x, 2.0 * PADDING);
    for lines in &sentences {
        for words in lines {
            canvas.text(words, at, style);
            at.y += line;
        }
        at.y += apart;
    }
    for ((name, mark), colour) in LEGEND.into_iter().zip([theme::bad(), theme::player_objective(), theme::good()]) {
        let middle = Vec2::new(at.x, at.y + 0.5 * line);
        canvas.line(middle, middle + Vec2::new(36.0, 0.0), 2.0, colour);
        mark.into_iter().for_each(|mark| marker(canvas, middle + Vec2::new(18.0, 0.0), mark, colour));
        canvas.text(tr(name), middle + Vec2::new(48.0, 0.0), style.middle());
        at.y += line;
    }
    (tool == Some("Back")).then_some(Request::Pop)
}

/// The places of a swing with ω = 1 after each step of [`TURN`], from (1, 0) on.
fn steps(step: MotionStep) -> Vec<DVec2> {
    let law = MotionLaw { spring: 1.0, ..MotionLaw::default() };
    let start = PointState { x: DVec2::X, v: DVec2::ZERO };
    let next = |point: &PointState| Some(step(&law, *point, TURN));
    std::iter::successors(Some(start), next).take(STEPS + 1).map(|point| DVec2::new(point.x.x, point.v.x)).collect()
}

fn draw_picture(canvas: &Canvas, area: Area) {
    let radius = RADIUS * area.size.y;
    let middle = area.centre() - Vec2::new(0.0, 0.03 * area.size.y);
    let at = |point: DVec2| middle + Vec2::new(point.x as f32, -point.y as f32) * radius;
    let reach = 2.6 * radius;
    let quiet = Style::new(DETAILS, theme::quiet()).middle();
    canvas.hairline(middle - Vec2::new(reach, 0.0), middle + Vec2::new(reach, 0.0), theme::solid_top());
    canvas.hairline(middle - Vec2::new(0.0, reach), middle + Vec2::new(0.0, reach), theme::solid_top());
    canvas.text("x", middle + Vec2::new(reach + 8.0, 0.0), quiet);
    canvas.text("v/ω", middle + Vec2::new(8.0, 6.0 - reach), quiet);
    canvas.ring(middle, radius + 1.0, 2.0, theme::good());
    let lines: [(MotionStep, Colour, Marker); 2] =
        [(semi_implicit_euler, theme::player_objective(), Marker::Up), (explicit_euler, theme::bad(), Marker::Square)];
    for (step, colour, mark) in lines {
        let corners: Vec<Vec2> = steps(step).into_iter().map(at).collect();
        corners.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], 2.0, colour));
        corners.iter().for_each(|corner| marker(canvas, *corner, mark, colour));
    }
    let words = tr!("ω·h = {turn}", turn = TURN);
    canvas.text(&words, Vec2::new(area.centre().x, area.max().y - PADDING), quiet.centred());
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The picture and its sentences say the same.
    #[test]
    fn explicit_euler_gains_what_the_sentence_says_and_the_symplectic_one_stays_on_an_ellipse() {
        let gain = (1.0 + TURN * TURN).powi(STEPS as i32);
        let end = *steps(explicit_euler).last().unwrap();
        assert!((end.length_squared() / gain - 1.0).abs() < 1e-12);
        // Semi-implicit Euler keeps x² − ω·h·x·v/ω + (v/ω)².
        for point in steps(semi_implicit_euler) {
            let kept = point.length_squared() - TURN * point.x * point.y;
            assert!((kept - 1.0).abs() < 1e-12, "{kept}");
        }
        assert!(gain.sqrt() * f64::from(RADIUS) < 0.45, "all of it is in the picture");
    }
}
