//! A work–precision diagram a scene. The player picks out a method, by keys or by its line in the legend, or reads a point.

use super::BACK;
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, Frame, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::curve::{ANOTHER_BUILD, GROWTH, Measured, OverTime};
use crate::lab::drawing::diagram::{self, Picked, with_unit};
use crate::{lab::drawing::looks::name_of, lab::drawing::places::DiagramPlaces, number::short, view::theme, view::widgets};
use crate::{lab::drawing::timeline, screens::screen::Request, session::library::Shown, settings::Key, ui::Ui, ui::WidgetKind};
use crate::{lab::methods::rules, words::tr};
use std::borrow::Cow;

#[derive(Debug)]
pub struct ChartsPage {
    pub(super) shown: Shown,
    scene: usize,
    legend: LegendPick,
    /// The wish for error and energy over time, for the scenes that have them.
    over_time: bool,
}

impl ChartsPage {
    pub(super) fn new(shown: Shown) -> Self {
        Self { shown, scene: 0, legend: LegendPick::default(), over_time: false }
    }

    pub(super) fn show(&mut self, ui: &mut Ui<'_>, body: Area) -> Option<Request> {
        let request = self.show_tools(ui);
        let panel = panel(body, &ui.frame());
        let Some(measured) = self.measured().map(Cow::into_owned) else {
            ui.panel(panel);
            ui.text(tr("There are no charts to show."), panel.centre(), Style::new(TEXT, theme::quiet()).centred().middle());
            return request;
        };
        let plot = DiagramPlaces::of(panel, &measured, &ui.frame());
        let lines = measured.curves.iter().enumerate().map(|(line, curve)| (curve.name.as_str(), plot.legend(line)));
        let curve = self.legend.show(ui, lines);
        self.draw_words(ui, panel, &measured, curve);
        match self.over_time() {
            Some(over_time) => timeline::draw(ui.canvas(), &plot, (&measured, over_time), curve),
            None => {
                let point = plot.point_near(&measured, ui.input().pointer);
                diagram::draw(ui.canvas(), &plot, &measured, Picked { curve, point });
            }
        }
        request
    }

    fn show_tools(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let scenes = self.shown.charts.diagrams.len();
        let curves = self.measured().map_or(0, |measured| measured.curves.len());
        let followed = self.scene().is_some_and(|measured| measured.over_time.is_some());
        let other = if self.over_time().is_some() { "At the end" } else { "Over time" };
        let tools = [BACK, ("Previous", Key::Left, "←"), ("Next", Key::Right, "→"), METHOD, (other, Key::Space, "Space")];
        match ui.tools(&tools[..if followed { 5 } else { 4 }]) {
            Some("Back") => return Some(Request::Pop),
            Some("Previous") => self.turn_to(self.scene + scenes.saturating_sub(1)),
            Some("Next") => self.turn_to(self.scene + 1),
            Some("Method") => self.legend.go(1, curves),
            Some(_) => {
                self.over_time = !self.over_time;
                self.legend.clear();
            }
            None => {}
        }
        if ui.key(Key::Up) {
            self.legend.go(-1, curves);
        }
        for (key, scene) in [(Key::Home, 0), (Key::End, scenes.saturating_sub(1))] {
            if ui.key(key) {
                self.turn_to(scene);
            }
        }
        None
    }

    pub(super) fn open(&mut self, name: &str) {
        let found = self.shown.charts.diagrams.iter().position(|measured| measured.name == name);
        self.turn_to(found.unwrap_or(self.scene));
    }

    fn turn_to(&mut self, scene: usize) {
        self.scene = scene.checked_rem(self.shown.charts.diagrams.len()).unwrap_or(0);
        self.legend.clear();
    }

    fn scene(&self) -> Option<&Measured> {
        self.shown.charts.diagrams.get(self.scene)
    }

    /// With the curves that are shown.
    fn measured(&self) -> Option<Cow<'_, Measured>> {
        let scene = self.scene()?;
        Some(self.over_time().map_or(Cow::Borrowed(scene), |over_time| Cow::Owned(timeline::followed(scene, over_time))))
    }

    fn over_time(&self) -> Option<&OverTime> {
        self.scene()?.over_time.as_ref().filter(|_| self.over_time)
    }

    /// The title above the chart; below it the verdict and the source, or the rule of the picked method and what it uses.
    fn draw_words(&self, ui: &Ui<'_>, panel: Area, measured: &Measured, curve: Option<usize>) {
        let (canvas, widest) = (ui.canvas(), panel.size.x);
        let title = Vec2::new(panel.centre().x, panel.min.y - 20.0);
        widgets::fitted(canvas, tr(&measured.title), title, widest - 240.0, &[BUTTON_TEXT, TEXT], theme::text());
        let count = tr!("{number} of {count}", number = self.scene + 1, count = self.shown.charts.diagrams.len());
        ui.text(&count, Vec2::new(panel.max().x, title.y), Style::new(TEXT, theme::quiet()).mono().middle().right());
        if let Some(lines) = curve.and_then(|curve| about(&measured.curves[curve].name)) {
            return words_below(canvas, panel, lines.each_ref().map(|words| (words.as_str(), TEXT, theme::text())));
        }
        let (second, size, colour) = match &self.shown.problem {
            Some(problem) => (problem.clone(), TEXT, theme::bad()),
            None if measured.note.is_empty() => (self.source(), DETAILS, theme::quiet()),
            None => (tr(&measured.note).to_owned(), DETAILS, theme::quiet()),
        };
        let verdict = self.verdict().unwrap_or_default();
        words_below(canvas, panel, [(&verdict, TEXT, theme::text()), (&second, size, colour)]);
    }

    fn verdict(&self) -> Option<String> {
        let measured = self.scene()?;
        if self.over_time().is_some() {
            return Some(
                tr("Each point is the worst since the one before. A method that ends near the truth may have been far from it.")
                    .into(),
            );
        }
        let shipped = measured.shipped_point().filter(|_| measured.name != GROWTH)?;
        let mut words = tr!(
            "As shipped: error {error}, {time} ns.",
            error = with_unit(shipped.error, tr(&measured.error)),
            time = short(shipped.work)
        );
        if let Some((curve, point)) = measured.cheapest() {
            let costs = shipped.work / point.work;
            let cheapest = tr!(
                "{method} at {step}, {time} ns",
                method = name_of(&curve.name, curve.origin),
                step = curve.setting(point),
                time = short(point.work)
            );
            words += &tr!(
                "  Cheapest within the tolerance: {cheapest}; the shipped point costs {factor} times that.",
                cheapest,
                factor = short(costs)
            );
        }
        Some(words)
    }

    fn source(&self) -> String {
        let setting = &self.shown.charts.setting;
        let stale = self.scene().is_some_and(Measured::is_stale);
        let build = if stale { format!("; {}", tr(ANOTHER_BUILD)) } else { String::new() };
        let runs = if setting.quick { tr("few runs a point") } else { tr("medians") };
        let whose = if self.shown.kept {
            tr("Came with the game: run “resultant chart” to measure here.")
        } else {
            tr("From the last run of “resultant chart” here.")
        };
        tr!(
            "Measured on {machine}, {profile} build, {runs}{build}. {whose}",
            machine = setting.machine,
            profile = setting.profile,
            runs,
            build,
            whose
        )
    }
}

/// Two lines on a method: its rule and what it uses, or, where more is known, both in one and where it holds and fails.
pub(super) fn about(method: &str) -> Option<[String; 2]> {
    let (rule, uses) = rules::of(method)?;
    let (rule, uses) = (tr(rule), tr(uses));
    Some(match rules::limits(method) {
        Some((limits, source)) => [format!("{rule}   {uses}"), format!("{} ({source})", tr(limits))],
        None => [rule.to_owned(), uses.to_owned()],
    })
}

/// Height of a page's title, and of its words below the chart.
pub(super) const TITLE: f32 = 40.0;
const WORDS: f32 = 56.0;
/// The same in heights of small text, where that is large.
const LARGE_WORDS: f32 = 4.3;

pub(super) const METHOD: (&str, Key, &str) = ("Method", Key::Down, "↓");

#[derive(Debug, Default)]
pub(super) struct LegendPick {
    picked: Option<usize>,
}

impl LegendPick {
    pub fn clear(&mut self) {
        self.picked = None;
    }

    /// Goes `by` curves on, of `count`: from the last one to none, and on to the first one.
    pub fn go(&mut self, by: isize, count: usize) {
        let place = self.picked.map_or(0, |picked| picked as isize + 1);
        self.picked = usize::try_from((place + by).rem_euclid(count as isize + 1) - 1).ok();
    }

    /// A click on a line picks it out for good, or not any more. Returns the curve under the pointer, or else the picked one.
    pub fn show<'l>(&mut self, ui: &mut Ui<'_>, lines: impl Iterator<Item = (&'l str, Area)>) -> Option<usize> {
        let mut pointed = None;
        for (line, (name, area)) in lines.enumerate() {
            let touch = ui.touch(name, area, WidgetKind::Tool);
            if touch.pressed {
                self.picked = if self.picked == Some(line) { None } else { Some(line) };
            }
            pointed = pointed.or(touch.hover.then_some(line));
        }
        pointed.or(self.picked)
    }
}

pub(super) fn panel(body: Area, frame: &Frame) -> Area {
    Area::new(body.min.x, body.min.y + TITLE, body.size.x, body.size.y - TITLE - words_room(frame))
}

/// A line each, or as many small ones as there is room for; where these are too many, a source in brackets at their end is left out.
pub(super) fn words_below(canvas: &Canvas, panel: Area, texts: [(&str, f32, Colour); 2]) {
    let (widest, from) = (panel.size.x, Vec2::new(panel.centre().x, panel.max().y));
    let style = |size, colour| Style::new(size, colour).centred().middle();
    let fit = |size: f32| texts.iter().all(|(words, most, colour)| canvas.width(words, style(size.min(*most), *colour)) <= widest);
    if canvas.frame().text <= 1.0 && fit(DETAILS) {
        // Words of one kind have one size.
        let most = if texts[0].1 == texts[1].1 && !fit(texts[0].1) { DETAILS } else { f32::INFINITY };
        for ((words, size, colour), down) in texts.into_iter().zip([18.0, 42.0]) {
            widgets::fitted(canvas, words, from + Vec2::new(0.0, down), widest, &[size.min(most), DETAILS], colour);
        }
        return;
    }
    let pitch = 1.05 * canvas.frame().text_height(DETAILS);
    let most = (words_room(canvas.frame()) / pitch) as usize;
    let lines_of = |texts: [&str; 2]| -> Vec<(String, usize)> {
        let of = |(which, words): (usize, &str)| {
            widgets::lines(canvas, words, widest, style(DETAILS, theme::text())).into_iter().map(move |line| (line, which))
        };
        texts.into_iter().enumerate().flat_map(of).collect()
    };
    let [first, second] = texts.map(|(words, ..)| words);
    let mut lines = lines_of([first, second]);
    if lines.len() > most {
        lines = lines_of([first, second.rsplit_once(" (").map_or(second, |(brief, _)| brief)]);
    }
    if lines.len() > most {
        lines.truncate(most);
        lines.last_mut().into_iter().for_each(|(line, _)| line.push('…'));
    }
    for (row, (line, which)) in lines.into_iter().enumerate() {
        canvas.text(&line, from + Vec2::new(0.0, (row as f32 + 0.7) * pitch), style(DETAILS, texts[which].2));
    }
}

/// Height of the words below a chart: two lines of them, or four where they are large.
fn words_room(frame: &Frame) -> f32 {
    WORDS.max(LARGE_WORDS * frame.text_height(DETAILS))
}
