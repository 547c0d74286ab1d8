//! The tools beside the picture: each stays until Esc or another one, and has a key.

use super::picture::{colour, draw_link, edge};
use super::{Editor, EditorPass, layout::INSIDE};
use crate::draw::layout::{Area, DETAILS, Vec2};
use crate::{draw::Canvas, draw::Style, level::document::Kind, level::document::LinkForm, view::theme, view::widgets};
use crate::{settings::Key, ui::Ui, ui::WidgetKind, words::tr};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EditorTool {
    Select,
    Add(Kind),
    Link(LinkForm),
    /// A click starts a test flight.
    Fly,
}

const COUNT: usize = 1 + Kind::ADDED.len() + LinkForm::ALL.len();
/// In the order of [`EditorTool::all`].
const KEYS: [Key; COUNT] = {
    use Key::{A, B, C, D, E, H, I, K, L, M, N, O, P, Q, R, S, T, U, W, X, Y};
    [Q, B, M, D, S, P, K, Y, O, N, R, X, H, L, A, U, E, T, C, W, I]
};

impl EditorTool {
    /// In the order in which they are offered: links stand behind the bodies that they join.
    pub fn all() -> impl Iterator<Item = Self> {
        let bodies = 1 + Kind::ADDED.iter().position(|kind| *kind == Kind::Object).unwrap_or_default();
        let (first, rest) = Kind::ADDED.split_at(bodies);
        let links = LinkForm::ALL.map(Self::Link);
        let first = first.iter().copied().map(Self::Add);
        [Self::Select].into_iter().chain(first).chain(links).chain(rest.iter().copied().map(Self::Add))
    }

    const fn label(self) -> &'static str {
        match self {
            Self::Select => "Select",
            Self::Add(kind) => kind.name(),
            Self::Link(form) => form.name(),
            Self::Fly => "Fly here",
        }
    }

    pub fn key(self) -> Key {
        Self::all().zip(KEYS).find(|(tool, _)| *tool == self).map_or(Key::F6, |(_, key)| key)
    }

    /// `Rope · key R. …`
    fn in_words(self) -> String {
        let help = match self {
            Self::Select => tr("Selects, moves and sizes: Shift adds, a drag from free ground frames, Alt and a drag doubles."),
            Self::Add(_) => tr("A drag draws one, a click puts one down. Esc puts the tool away."),
            Self::Fly => tr("Click where the ship is to start."),
            Self::Link(_) => tr("Pull it from a body to another one, or to a place."),
        };
        tr!("{tool} · key {key}. {help}", tool = tr(self.label()), key = self.key().label(), help)
    }

    fn draw_mark(self, canvas: &Canvas, mark: Area) {
        let own = match self {
            Self::Select | Self::Fly => theme::text(),
            Self::Add(kind) => colour(kind),
            Self::Link(_) => colour(Kind::Link),
        };
        let (from, to) = (Vec2::new(mark.min.x, mark.max().y), Vec2::new(mark.max().x, mark.min.y));
        match self {
            Self::Select | Self::Fly => edge(canvas, mark, 0.75, own),
            Self::Add(_) => canvas.rectangle(mark, own),
            Self::Link(form) => draw_link(canvas, [from, to], form, own),
        }
    }
}

impl Editor {
    pub(super) fn show_tools(&mut self, ui: &mut Ui<'_>, pass: &mut EditorPass) {
        let canvas = ui.canvas();
        canvas.rectangle(self.panes.left, theme::panel());
        for (tool, area) in EditorTool::all().zip(self.panes.tools(COUNT)) {
            let touch = ui.touch(tool.label(), area, WidgetKind::Tool);
            if touch.pressed && pass.open {
                self.take_tool(tool);
            }
            if touch.hover {
                pass.tip = Some(tool.in_words());
            }
            let ground = if touch.hover { theme::panel_hover() } else { theme::ground() };
            widgets::panel_in(canvas, area, ground, if tool == self.tool { theme::accent() } else { theme::panel_edge() });
            let mark = Area::around(Vec2::new(area.min.x + 16.0, area.centre().y), Vec2::new(14.0, 10.0));
            tool.draw_mark(canvas, mark);
            let at = Vec2::new(mark.max().x + INSIDE, area.centre().y);
            canvas.text(tr(tool.label()), at, Style::new(DETAILS, theme::text()).middle());
        }
    }

    pub(super) fn take_tool(&mut self, tool: EditorTool) {
        self.tool = tool;
        self.panel.typing = None;
    }
}
