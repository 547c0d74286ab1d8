//! What lies above the picture: what is selected, its handles, what is being drawn; and the level in small.

use super::*;

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
            Some(Drag::Frame(from, _)) => {
                let to = self.pointed();
                let area = self.view.rect(&Place::between(*from, to));
                canvas.rectangle(area, theme::accent().faded(0.1));
                edge(canvas, area, 0.75, theme::accent());
            }
            Some(Drag::Draw(kind, from)) => {
                let to = self.pointed().round();
                let area = self.view.rect(&Place::between(*from, to));
                canvas.rectangle(area, colour(*kind).faded(0.5));
                edge(canvas, area, 1.0, colour(*kind));
                let size = (to - *from).abs();
                let words = format!("{} × {} px", number(size.x.round()), number(size.y.round()));
                canvas.text(&words, area.max() + Vec2::new(8.0, -8.0), Style::new(DETAILS, theme::text()).mono());
            }
            Some(Drag::Handle { row, handle: Handle::Wire, .. }) => {
                if let Some(place) = self.document.place(*row) {
                    canvas.line(self.view.point(place.centre()), self.pointer, 2.0, colour(Kind::Switch));
                }
            }
            Some(Drag::Pan(_) | Drag::Move { .. } | Drag::Handle { .. }) | None => {}
        }
    }

    /// The level in small, with the part in view.
    pub(super) fn draw_map(&self, canvas: &Canvas) {
        if !self.map_is_shown() {
            return;
        }
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
