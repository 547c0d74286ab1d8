//! The methods' regions of stability in the complex plane of z = h·λ. The player picks out one of them.

use super::BACK;
use super::charts::{self, LegendPick, METHOD, panel};
use crate::draw::layout::{Area, BUTTON_TEXT, TEXT, Vec2};
use crate::lab::drawing::plane::{self, Plane};
use crate::lab::stability::{Region, TITLE, regions};
use crate::screens::screen::Request;
use crate::settings::Key;
use crate::ui::Ui;
use crate::view::{theme, widgets};
use crate::words::tr;

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
        let at = Vec2::new(plane.panel.centre().x, plane.panel.min.y - 20.0);
        widgets::fitted(ui.canvas(), tr(TITLE), at, plane.panel.size.x, &[BUTTON_TEXT, TEXT], theme::text());
        let lines = self.regions.iter().enumerate().map(|(line, region)| (region.name, plane.legend(line + 1)));
        let picked = self.legend.show(ui, lines);
        plane::draw(ui.canvas(), &plane, &self.regions, picked);
        let words =
            picked.and_then(|picked| about(&self.regions[picked])).unwrap_or(plane::WORDS.map(|words| tr(words).to_owned()));
        charts::words_below(ui.canvas(), plane.panel, words.each_ref().map(|words| (words.as_str(), TEXT, theme::text())));
        (tool == Some("Back")).then_some(Request::Pop)
    }
}
