//! The lab in the window, on five pages: the charts, where methods are stable, what each survives, two methods side by side, and experiments. What `resultant chart`
//! measures is handed in; nothing is measured here.

mod charts;
mod experiments;
mod side_by_side;
mod stability;
mod survival;

pub use charts::ChartsPage;
pub use experiments::{Experiment, ExperimentsPage};
pub use side_by_side::{Half, SideBySide};
pub use stability::StabilityPage;
pub use survival::{SurvivalLine, SurvivalPage};

use self::experiments::ExperimentWish;
use super::{Buttons, Input, Key, Keys, Motion, Request, Screen, Toolbar};
use crate::draw::layout::{Area, Frame, GAP};
use crate::lab::charts::Charts;
use crate::ui::Ui;

/// A run of `resultant chart`, and what is to be said about it.
#[derive(Clone, Debug, Default)]
pub struct Shown {
    /// What it measured; nothing where none could be read.
    pub charts: Charts,
    /// Whether it came with the game.
    pub kept: bool,
    /// Why it is not the one that the player made.
    pub problem: Option<String>,
}

/// The pages, in the order of their tabs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Page {
    /// Accuracy against speed.
    #[default]
    Charts,
    /// Where each method is stable.
    Stability,
    /// What each method survives.
    Survival,
    /// Two methods at the same time.
    SideBySide,
    /// Levels for lessons.
    Experiments,
}

/// The pages and the words on their tabs.
pub const PAGES: [(Page, &str); 5] = [
    (Page::Charts, "Charts"),
    (Page::Stability, "Stability"),
    (Page::Survival, "Stress tests"),
    (Page::SideBySide, "Side by side"),
    (Page::Experiments, "Experiments"),
];
/// Width and height of a tab.
const TAB: (f32, f32) = (200.0, 40.0);
/// From the canvas' top to the tabs.
const TABS_AT: f32 = 16.0;
/// From the canvas' top to what a page shows.
const TOP: f32 = 72.0;
/// From that to the canvas' foot: the toolbar.
const FOOT: f32 = 88.0;
/// Between a page and the canvas' sides.
const MARGIN: f32 = 24.0;

/// The lab.
#[derive(Debug)]
pub struct Lab {
    page: Page,
    tabs: Buttons,
    charts: ChartsPage,
    stability: StabilityPage,
    survival: SurvivalPage,
    side_by_side: SideBySide,
    experiments: ExperimentsPage,
}

impl Lab {
    /// The lab with its first page open, or with an experiment that was left.
    pub fn new(shown: Shown, experiments: Result<Vec<Experiment>, String>, left: Option<&str>) -> Self {
        let survival = SurvivalPage::new(&shown.charts.stress);
        Self {
            page: if left.is_some() { Page::Experiments } else { Page::default() },
            experiments: ExperimentsPage::new(experiments, left),
            tabs: Buttons::default(),
            charts: ChartsPage::new(shown),
            stability: StabilityPage::default(),
            survival,
            side_by_side: SideBySide::default(),
        }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.tabs.place(tabs(&input.frame));
        let pointer_only = Input { pressed: Keys::default(), ..input.clone() };
        if let Some(tab) = self.tabs.update(&pointer_only) {
            self.page = PAGES[tab].0;
        } else if input.pressed(Key::Tab) {
            let tab = PAGES.iter().position(|(page, _)| *page == self.page).unwrap_or(0);
            self.page = PAGES[(tab + 1) % PAGES.len()].0;
        }
        let away = match self.page {
            Page::Charts => self.charts.update(input),
            Page::Stability => self.stability.update(input),
            Page::Survival => self.survival.update(input),
            Page::SideBySide => self.side_by_side.update(input),
            Page::Experiments => match self.experiments.update(input)? {
                ExperimentWish::Leave => true,
                ExperimentWish::Fly(folder) => return Some(Request::Experiment(folder)),
            },
        };
        away.then_some(Request::Menu)
    }

    /// What is open.
    pub fn page(&self) -> Page {
        self.page
    }

    /// The tabs, in the order of [`PAGES`].
    pub fn tabs(&self) -> &Buttons {
        &self.tabs
    }

    /// The page with the charts.
    pub fn charts(&self) -> &ChartsPage {
        &self.charts
    }

    /// The page with the regions of stability.
    pub fn stability(&self) -> &StabilityPage {
        &self.stability
    }

    /// The page with the stress tests.
    pub fn survival(&self) -> &SurvivalPage {
        &self.survival
    }

    /// The page with two methods.
    pub fn side_by_side(&self) -> &SideBySide {
        &self.side_by_side
    }

    /// The page with the experiments.
    pub fn experiments(&self) -> &ExperimentsPage {
        &self.experiments
    }

    /// The buttons at the foot of the page; the first one is Back.
    pub fn toolbar(&self) -> &Toolbar {
        match self.page {
            Page::Charts => self.charts.toolbar(),
            Page::Stability => self.stability.toolbar(),
            Page::Survival => self.survival.toolbar(),
            Page::SideBySide => self.side_by_side.toolbar(),
            Page::Experiments => self.experiments.toolbar(),
        }
    }
}

fn tabs(frame: &Frame) -> Vec<Area> {
    let (width, height) = TAB;
    let pitch = width + GAP;
    let left = (frame.size.x - (PAGES.len() as f32 * pitch - GAP)) / 2.0;
    (0..PAGES.len()).map(|i| Area::new(left + i as f32 * pitch, TABS_AT, width, height)).collect()
}

/// What a page may fill: all between tabs and toolbar.
fn body(frame: &Frame) -> Area {
    Area::new(MARGIN, TOP, frame.size.x - 2.0 * MARGIN, frame.size.y - TOP - FOOT)
}

impl Screen for Lab {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let request = self.update(ui.input());
        self.draw(ui.canvas());
        request
    }

    fn motion(&self, _: &Input) -> Motion {
        let moves = self.page == Page::SideBySide && !self.side_by_side.is_paused();
        if moves { Motion::Full } else { Motion::Still }
    }
}

mod drawing {
    use super::{Lab, PAGES, Page};
    use crate::draw::layout::{Area, TEXT, Vec2};
    use crate::draw::{Canvas, Style};
    use crate::view::{theme, widgets};

    impl Lab {
        /// Draws the page that is open.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            for (i, (area, (page, label))) in self.tabs.areas().iter().zip(PAGES).enumerate() {
                let open = page == self.page;
                widgets::button_box(canvas, *area, self.tabs.hover() == Some(i), false);
                let colour = if open { theme::accent() } else { theme::quiet() };
                canvas.text(label, area.centre(), Style::new(TEXT, colour).centred().middle());
                if open {
                    let line = Area::new(area.min.x + 16.0, area.max().y - 6.0, area.size.x - 32.0, 2.0);
                    canvas.rounded(line, 1.0, theme::accent());
                }
            }
            if let Some(last) = self.tabs.areas().last() {
                let at = Vec2::new(last.max().x + 16.0, last.centre().y);
                canvas.text("Tab", at, Style::new(TEXT, theme::accent()).mono().middle());
            }
            match self.page {
                Page::Charts => self.charts.draw(canvas),
                Page::Stability => self.stability.draw(canvas),
                Page::Survival => self.survival.draw(canvas),
                Page::SideBySide => self.side_by_side.draw(canvas),
                Page::Experiments => self.experiments.draw(canvas),
            }
        }
    }
}
