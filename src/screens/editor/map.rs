//! The level in small.

use super::paint::{colour, edge};
use super::{Editor, EditorPass};
use crate::draw::Canvas;
use crate::draw::layout::{Area, Vec2};
use crate::level::document::{Kind, Place};
use crate::physics::DVec2;
use crate::ui::Ui;
use crate::view::theme;

impl Editor {
    /// Canvas units a pixel of the picture, and the place of its corner.
    fn map(&self) -> (f32, Vec2) {
        let (area, size) = (self.panes.map, self.document.size().as_vec2());
        let scale = (area.size / size).min_element();
        (scale, area.centre() - size * scale / 2.0)
    }

    /// The level in small, with the part in view: held down there, the button brings another part into view.
    pub(super) fn show_map(&mut self, ui: &Ui<'_>, pass: &mut EditorPass) {
        let (visible, input) = (self.view.visible(), ui.input());
        if visible.contains(DVec2::ZERO) && visible.contains(self.document.size()) {
            return;
        }
        if pass.open && self.drag.is_none() && self.panes.map.contains(input.pointer) && input.holding {
            let (scale, corner) = self.map();
            self.view.centre(((input.pointer - corner) / scale).as_dvec2());
            pass.close(None);
        }
        if pass.draws {
            self.draw_map(ui.canvas());
        }
    }

    fn draw_map(&self, canvas: &Canvas) {
        let (scale, corner) = self.map();
        let size = self.document.size().as_vec2() * scale;
        let paper = Area { min: corner, size };
        canvas.rectangle(paper.inset(-3.0), theme::panel_edge());
        canvas.rectangle(paper, theme::ground());
        let point = |pixels: DVec2| (corner + pixels.as_vec2() * scale).clamp(paper.min, paper.max());
        let between = |place: &Place| {
            let (min, max) = (point(place.min), point(place.max()));
            Area { min, size: (max - min).max(Vec2::ONE) }
        };
        for (row, place) in self.document.things() {
            let Some(kind) = self.document.kind(row).filter(|kind| *kind != Kind::Text) else { continue };
            let area = between(&place);
            let least = if matches!(kind, Kind::Ship | Kind::Pad | Kind::KeyPad | Kind::Key) { 3.0 } else { 1.0 };
            canvas.rectangle(
                Area::around(area.centre(), area.size.max(Vec2::splat(least))),
                if kind == Kind::Solid { theme::solid() } else { colour(kind) },
            );
        }
        edge(canvas, between(&self.view.visible()), 0.75, theme::accent());
    }
}
