//! The Lab: seven pages that show the results of a run of `resultant chart`, and measure nothing themselves.

mod charts;
mod experiments;
mod overview;
mod side_by_side;
mod stability;
mod survival;

use crate::screens::screen::{PAGES, Page, Request, Screen};
use crate::{session::library::Experiment, session::library::Shown, ui::Ui, ui::WidgetKind, view::theme, view::widgets};
pub(super) use experiments::Paragraphs;
pub use side_by_side::{Half, SideBySide};

use crate::draw::layout::{Area, DETAILS, Frame, GAP, TEXT, Vec2};
use crate::{draw::Style, lab::charts::Charts, settings::Key, ui::input::Input, ui::pace::Motion, words::tr};
use charts::ChartsPage;
use experiments::ExperimentsPage;
use overview::{Onwards, OverviewPage};
use stability::StabilityPage;
use survival::SurvivalPage;

/// The first tool of each page.
const BACK: (&str, Key, &str) = ("Back", Key::Escape, "Esc");
const TAB: Vec2 = Vec2::new(148.0, 40.0);
const TABS_AT: f32 = 16.0;
/// The room of the key behind the tabs.
const HINT: f32 = 64.0;
/// From a page to the canvas' top, foot and sides.
const TOP: f32 = 72.0;
const FOOT: f32 = 88.0;
const MARGIN: f32 = 24.0;

#[derive(Debug)]
pub struct Lab {
    pub page: Page,
    overview: OverviewPage,
    charts: ChartsPage,
    stability: StabilityPage,
    survival: SurvivalPage,
    pub side_by_side: SideBySide,
    experiments: ExperimentsPage,
}

impl Lab {
    /// Opens at its overview, or at the experiment that was `left`.
    pub fn new(shown: Shown, experiments: Result<Vec<Experiment>, String>, left: Option<&str>) -> Self {
        let survival = SurvivalPage::new(&shown.charts.stress);
        Self {
            page: if left.is_some() { Page::Experiments } else { Page::default() },
            overview: OverviewPage::default(),
            experiments: ExperimentsPage::new(experiments, left),
            charts: ChartsPage::new(shown),
            stability: StabilityPage::default(),
            survival,
            side_by_side: SideBySide::default(),
        }
    }

    pub(super) const fn turn_to(&mut self, page: Page) {
        self.page = page;
    }

    pub fn charts(&self) -> &Charts {
        &self.charts.shown.charts
    }

    fn lead(&mut self, onwards: Option<Onwards>) -> Option<Request> {
        match onwards? {
            Onwards::Back => return Some(Request::Pop),
            Onwards::Chart(name) => {
                self.charts.open(name);
                self.page = Page::Charts;
            }
            Onwards::Stability => self.page = Page::Stability,
            Onwards::Savings => {}
        }
        None
    }

    fn show_tabs(&mut self, ui: &mut Ui<'_>) {
        let words = PAGES.map(|(_, label)| ui.canvas().width(tr(label), Style::new(TEXT, theme::text())) + 1.5 * GAP);
        let gaps = (PAGES.len() - 1) as f32 * GAP;
        let room = ui.frame().size.x - 2.0 * MARGIN - HINT;
        let sum = words.iter().sum::<f32>() + gaps;
        // Large words have tabs of their own widths.
        let widths = if sum > room || words.iter().all(|width| *width <= TAB.x) { [TAB.x; PAGES.len()] } else { words };
        let whole = widths.iter().sum::<f32>() + gaps;
        let mut end = ((ui.frame().size.x - whole) / 2.0).min(MARGIN + room - whole) - GAP;
        for ((page, label), width) in PAGES.into_iter().zip(widths) {
            let area = Area::new(end + GAP, TABS_AT, width, TAB.y);
            let touch = ui.touch(label, area, WidgetKind::Tool);
            if touch.pressed {
                self.page = page;
            }
            let open = page == self.page;
            widgets::button_box(ui.canvas(), area, touch.hover, false);
            let colour = if open { theme::accent() } else { theme::quiet() };
            widgets::fitted(ui.canvas(), tr(label), area.centre(), area.size.x - GAP, &[TEXT, DETAILS], colour);
            if open {
                let line = Area::new(area.min.x + 16.0, area.max().y - 6.0, area.size.x - 32.0, 2.0);
                ui.canvas().rounded(line, 1.0, theme::accent());
            }
            end = area.max().x;
        }
        ui.text(tr("Tab"), Vec2::new(end + 16.0, TABS_AT + TAB.y / 2.0), Style::new(TEXT, theme::accent()).mono().middle());
        if ui.key(Key::Tab) {
            let open = PAGES.iter().position(|(page, _)| *page == self.page).unwrap_or(0);
            self.page = PAGES[(open + 1) % PAGES.len()].0;
        }
    }
}

/// The room of a page, between tabs and tools.
fn body(frame: &Frame) -> Area {
    Area::new(MARGIN, TOP, frame.size.x - 2.0 * MARGIN, frame.size.y - TOP - FOOT)
}

impl Screen for Lab {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        widgets::graph_paper(ui.canvas());
        self.show_tabs(ui);
        let area = body(&ui.frame());
        match self.page {
            Page::Overview => {
                let onwards =
                    self.overview.show(ui, area, (&self.charts.shown.charts, self.stability.regions()), &self.experiments);
                self.lead(onwards)
            }
            Page::Charts => self.charts.show(ui, area),
            Page::Stability => self.stability.show(ui, area),
            Page::Survival => self.survival.show(ui, area),
            Page::SideBySide => self.side_by_side.show(ui, area),
            Page::Euler => stability::show(ui, area),
            Page::Experiments => self.experiments.show(ui, area),
        }
    }

    fn motion(&self, _: &Input) -> Motion {
        let moves = self.page == Page::SideBySide && !self.side_by_side.is_paused();
        if moves { Motion::Full } else { Motion::Still }
    }
}
