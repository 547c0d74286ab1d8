//! The marks above the picture: the selection, its handles, the drag. The level in small.

use super::picture::{colour, draw_link, edge};
use super::{Editor, EditorPass, hand::PointerDrag, handles::Handle};
use crate::draw::layout::{Area, DETAILS, Vec2};
use crate::level::document::{Kind, LinkForm, Place, number};
use crate::{draw::Canvas, draw::Style, physics::DVec2, ui::Ui, view::theme};

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
                Handle::Way(_) | Handle::Reach | Handle::End(_) => canvas.disc(at, 6.0, theme::accent()),
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
            Some(PointerDrag::Draw(kind, [from, _])) => {
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
            Some(PointerDrag::Handle { row, handle: Handle::End(end), .. }) => {
                if let Some(ends) = self.document.link_ends(*row) {
                    self.draw_pull(canvas, ends[1 - end], self.document.link_form(*row));
                }
            }
            Some(PointerDrag::Link(form, from)) => self.draw_pull(canvas, *from, *form),
            Some(PointerDrag::Pan(_) | PointerDrag::Move { .. } | PointerDrag::Handle { .. }) | None => {}
        }
    }

    /// A link that is pulled to the pointer, and the body that it would join there.
    fn draw_pull(&self, canvas: &Canvas, from: DVec2, form: LinkForm) {
        let to = self.view.pixels(self.pointer);
        for body in [from, to].into_iter().filter_map(|at| self.document.place(self.document.body_at(at)?)) {
            edge(canvas, self.view.rect(&body).inset(-3.0), 2.0, colour(Kind::Link));
        }
        draw_link(canvas, [self.view.point(from), self.pointer], form, colour(Kind::Link));
    }

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
