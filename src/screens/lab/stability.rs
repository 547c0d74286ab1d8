//! The methods' regions of stability in the complex plane of z = h·λ. The player picks out one of them.

use super::BACK;
use super::charts::{LegendPick, METHOD, panel};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, TEXT, Vec2};
use crate::lab::drawing::plane::{self, Plane};
use crate::lab::methods::rules;
use crate::lab::stability::{Region, TITLE, regions};
use crate::screens::screen::Request;
use crate::settings::Key;
use crate::ui::Ui;
use crate::view::{theme, widgets};
use crate::words::tr;

#[derive(Debug, Default)]
pub struct StabilityPage {
    /// Computed when the page first opens.
    regions: Vec<Region>,
    legend: LegendPick,
}

impl StabilityPage {
    pub(super) fn show(&mut self, ui: &mut Ui<'_>, body: Area) -> Option<Request> {
        if self.regions.is_empty() {
            self.regions = regions();
        }
        let tool = ui.tools(&[BACK, METHOD]);
        if tool == Some("Method") {
            self.legend.go(1, self.regions.len());
        } else if ui.key(Key::Up) {
            self.legend.go(-1, self.regions.len());
        }
        let plane = Plane::of(panel(body));
        let (middle, widest) = (plane.panel.centre().x, plane.panel.size.x);
        let at = |y: f32| Vec2::new(middle, y);
        widgets::fitted(ui.canvas(), tr(TITLE), at(plane.panel.min.y - 20.0), widest, &[BUTTON_TEXT, TEXT], theme::text());
        let lines = self.regions.iter().enumerate().map(|(line, region)| (region.name, plane.legend(line + 1)));
        let picked = self.legend.show(ui, lines);
        plane::draw(ui.canvas(), &plane, &self.regions, picked);
        let rule = picked.and_then(|picked| rules::of(self.regions[picked].name));
        let words = rule.map_or(plane::WORDS, |(rule, uses)| [rule, uses]);
        for (words, down) in words.iter().zip([18.0, 42.0]) {
            widgets::fitted(ui.canvas(), tr(words), at(plane.panel.max().y + down), widest, &[TEXT, DETAILS], theme::text());
        }
        (tool == Some("Back")).then_some(Request::Pop)
    }
}
