//! The marks above the picture: the selection, its handles, the drag.

use super::Editor;
use super::hand::{Handle, PointerDrag};
use super::paint::{colour, edge};
use crate::draw::layout::{Area, DETAILS, Vec2};
use crate::draw::{Canvas, Style};
use crate::level::document::{Kind, Place, number};
use crate::view::theme;

impl Editor {
    pub(super) fn draw_selection(&self, canvas: &Canvas) {
        let visible = self.view.visible();
        for place in self.selection.iter().filter_map(|row| self.document.place(*row)).filter(|place| place.meets(&visible)) {
            edge(canvas, self.view.rect(&place).inset(-2.0), 1.5, theme::accent());
        }
        for (handle, point) in self.handles() {
            let at = self.view.point(point);
            match handle {
                Handle::Size(_) => {
                    canvas.rectangle(Area::around(at, Vec2::splat(8.0)), theme::accent());
                    canvas.rectangle(Area::around(at, Vec2::splat(5.0)), theme::ground());
                }
                Handle::Way(_) | Handle::Reach => canvas.disc(at, 6.0, theme::accent()),
                Handle::MoreWay => {
                    canvas.ring(at, 8.0, 1.5, theme::accent());
                    canvas.rectangle(Area::around(at, Vec2::new(9.0, 1.5)), theme::accent());
                    canvas.rectangle(Area::around(at, Vec2::new(1.5, 9.0)), theme::accent());
                }
                Handle::Wire => {
                    canvas.disc(at, 6.0, colour(Kind::Switch));
                    canvas.ring(at, 8.0, 1.5, theme::text());
                }
            }
        }
        match &self.drag {
            Some(PointerDrag::Frame(from, _)) => {
                let to = self.view.pixels(self.pointer);
                let area = self.view.rect(&Place::between(*from, to));
                canvas.rectangle(area, theme::accent().faded(0.1));
                edge(canvas, area, 0.75, theme::accent());
            }
            Some(PointerDrag::Draw(kind, from)) => {
                let to = self.view.pixels(self.pointer).round();
                let area = self.view.rect(&Place::between(*from, to));
                canvas.rectangle(area, colour(*kind).faded(0.5));
                edge(canvas, area, 1.0, colour(*kind));
                let size = (to - *from).abs();
                let words = format!("{} × {} px", number(size.x.round()), number(size.y.round()));
                canvas.text(&words, area.max() + Vec2::new(8.0, -8.0), Style::new(DETAILS, theme::text()).mono());
            }
            Some(PointerDrag::Handle { row, handle: Handle::Wire, .. }) => {
                if let Some(place) = self.document.place(*row) {
                    canvas.line(self.view.point(place.centre()), self.pointer, 2.0, colour(Kind::Switch));
                }
            }
            Some(PointerDrag::Pan(_) | PointerDrag::Move { .. } | PointerDrag::Handle { .. }) | None => {}
        }
    }
}
