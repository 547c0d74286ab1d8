//! The first page: four pictures, each of which leads on to its page.

use super::{BACK, experiments::ExperimentsPage};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, Frame, GAP, PADDING, TEXT, Vec2};
use crate::{draw::Style, lab::drawing::overview, lab::savings::LEVEL, lab::savings::Saving, view::theme, view::widgets};
use crate::{lab::charts::Charts, lab::curve::Measured, lab::stability::Region, ui::Ui, ui::WidgetKind, words::tr};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Onwards {
    /// To the charts, at the diagram of that name.
    Chart(&'static str),
    Stability,
    /// To the picture of the savings alone, and back.
    Savings,
    /// Out of the Lab.
    Back,
}

const ERRORS: &str = "projectile";
const PILES: &str = "piles";
/// Height of a picture's title, and of a line of its sentence, which may take two.
const TITLE: f32 = 40.0;
const LINE: f32 = 18.0;
/// The most of a picture's height that its sentence takes.
const SENTENCE: f32 = 0.15;

/// Title, sentence, and what it leads to.
const PICTURES: [(&str, &str, Onwards); 4] = [
    (
        "Error against computing time",
        "A throw with drag and wind: a curve a method, a mark a step. Lower left is better.",
        Onwards::Chart(ERRORS),
    ),
    (
        "Where methods break",
        "Inside its edge a method fades as the truth does (implicit Euler: outside); else it grows without end.",
        Onwards::Stability,
    ),
    ("What modelling less saves", "What a scene does not contain is not computed, and not a bit changes.", Onwards::Savings),
    (
        "Beside Box2D and Rapier",
        "Piles of 100 to 5000 boxes: how deep they overlap, and how long a step takes.",
        Onwards::Chart(PILES),
    ),
];

#[derive(Debug, Default)]
pub(super) struct OverviewPage {
    /// The savings fill the page.
    savings: bool,
}

impl OverviewPage {
    pub fn show(
        &mut self,
        ui: &mut Ui<'_>,
        body: Area,
        (charts, regions): (&Charts, &[Region]),
        experiments: &ExperimentsPage,
    ) -> Option<Onwards> {
        if ui.tools(&[BACK]).is_some() {
            return if std::mem::take(&mut self.savings) { None } else { Some(Onwards::Back) };
        }
        let diagram = |name: &str| charts.diagrams.iter().find(|measured| measured.name == name);
        let title_of = |row: &Saving| match diagram(&row.scene) {
            _ if row.of == LEVEL => tr!("Level {level}", level = row.scene),
            Some(measured) => tr(&measured.title).to_owned(),
            None => tr(experiments.title_of(&row.scene).unwrap_or(&row.scene)).to_owned(),
        };
        if self.savings {
            let (title, sentence, _) = PICTURES[2];
            ui.panel(body);
            head(ui, body, title, sentence);
            overview::savings(ui.canvas(), inside(body, &ui.frame()), &charts.savings, title_of);
            return None;
        }
        let has = |onwards: Onwards| match onwards {
            Onwards::Chart(name) => diagram(name).is_some_and(|measured: &Measured| !measured.curves.is_empty()),
            Onwards::Stability | Onwards::Back => true,
            Onwards::Savings => !charts.savings.is_empty(),
        };
        let shown: Vec<_> = PICTURES.into_iter().filter(|(_, _, onwards)| has(*onwards)).collect();
        let mut chosen = None;
        for ((title, sentence, onwards), area) in shown.iter().zip(cards(body, shown.len())) {
            let touch = ui.touch(title, area, WidgetKind::Button);
            widgets::panel_in(
                ui.canvas(),
                area,
                if touch.hover { theme::panel_hover() } else { theme::panel() },
                theme::panel_edge(),
            );
            head(ui, area, title, sentence);
            match *onwards {
                Onwards::Chart(name) => {
                    diagram(name).into_iter().for_each(|found| overview::diagram(ui.canvas(), inside(area, &ui.frame()), found))
                }
                Onwards::Stability => overview::plane(ui.canvas(), inside(area, &ui.frame()), regions),
                Onwards::Savings => overview::savings(ui.canvas(), inside(area, &ui.frame()), &charts.savings, title_of),
                Onwards::Back => {}
            }
            if touch.focus {
                widgets::focus_ring(ui.canvas(), area);
            }
            chosen = chosen.or(touch.pressed.then_some(*onwards));
        }
        self.savings = chosen == Some(Onwards::Savings);
        chosen
    }
}

/// Two a row; the last of an odd number is as wide as two.
fn cards(body: Area, count: usize) -> impl Iterator<Item = Area> {
    let rows = count.div_ceil(2).max(1) as f32;
    let size = Vec2::new((body.size.x - GAP) / 2.0, (body.size.y - GAP * (rows - 1.0)) / rows);
    (0..count).map(move |i| {
        let place = Vec2::new((i % 2) as f32, (i / 2) as f32) * (size + GAP);
        let wide = i % 2 == 0 && i + 1 == count;
        Area { min: body.min + place, size: if wide { Vec2::new(body.size.x, size.y) } else { size } }
    })
}

fn head(ui: &Ui<'_>, area: Area, title: &str, sentence: &str) {
    let widest = area.size.x - 2.0 * PADDING;
    let at = |y: f32| Vec2::new(area.centre().x, area.min.y + y);
    widgets::fitted(ui.canvas(), tr(title), at(TITLE / 2.0 + 2.0), widest, &[BUTTON_TEXT, TEXT], theme::text());
    if !has_sentence(area, &ui.frame()) {
        return;
    }
    let style = Style::new(DETAILS, theme::quiet()).centred().middle();
    for (row, line) in widgets::lines(ui.canvas(), tr(sentence), widest, style).iter().enumerate() {
        ui.canvas().text(line, at(TITLE + (row as f32 + 0.5) * line_of(&ui.frame()) - 4.0), style);
    }
}

fn line_of(frame: &Frame) -> f32 {
    LINE.max(1.05 * frame.text_height(DETAILS))
}

/// Large words leave a small picture its room.
fn has_sentence(area: Area, frame: &Frame) -> bool {
    2.0 * line_of(frame) <= SENTENCE * area.size.y
}

fn inside(area: Area, frame: &Frame) -> Area {
    let down = TITLE + if has_sentence(area, frame) { 2.0 * line_of(frame) } else { 0.0 };
    Area::new(area.min.x + PADDING, area.min.y + down, area.size.x - 2.0 * PADDING, area.size.y - down - 8.0)
}
