//! The strip above the picture: things are aligned, spread, and, until the editor is left, grouped and locked; layers are hidden.

use super::{Editor, EditorPass, layout::INSIDE};
use crate::level::document::{Kind, Place, RowId, SetCell, Table};
use crate::ui::{Ui, WidgetKind, input::Input};
use crate::{draw::Canvas, physics::DVec2, settings::Key, words::tr};
use crate::{draw::layout::Area, draw::layout::Vec2, view::theme, view::widgets};

/// A button of the strip, canvas units.
const BUTTON: Vec2 = Vec2::new(26.0, 24.0);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PictureLayer {
    Wires,
    Words,
    Zones,
    Flight,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Act {
    /// Along an axis, to the lower edge (0), the middle (1) or the upper edge (2) of all.
    Align(usize, u8),
    /// Along an axis, with equal gaps.
    Spread(usize),
    Group,
    Ungroup,
    Lock,
    Unlock,
    Hide(PictureLayer),
}

/// Each with its words, its key, and its picture: five rows of five dots.
const ACTS: [(Act, &str, &str, &str); 16] = [
    (Act::Align(0, 0), "Align left", "", "#....####.#....##...#...."),
    (Act::Align(0, 1), "Align middles", "", "..#..#####..#...###...#.."),
    (Act::Align(0, 2), "Align right", "", "....#.####....#...##....#"),
    (Act::Align(1, 0), "Align top", "", "#####.#.#..#.#..#........"),
    (Act::Align(1, 1), "Align centres", "", ".#....#.#.#####.#.#..#..."),
    (Act::Align(1, 2), "Align bottom", "", "........#..#.#..#.#.#####"),
    (Act::Spread(0), "Spread across", "", "#.#.##.#.##.#.##.#.##.#.#"),
    (Act::Spread(1), "Spread down", "", "#####.....#####.....#####"),
    (Act::Group, "Group", "Ctrl G", "#########.####.###.######"),
    (Act::Ungroup, "Ungroup", "Ctrl Shift G", "##...##.........##...##.."),
    (Act::Lock, "Lock", "Ctrl L", ".###..#.#.#####.###.#####"),
    (Act::Unlock, "Unlock all", "Ctrl Shift L", "###..#.#....#####.###.###"),
    (Act::Hide(PictureLayer::Wires), "Hide wires", "F8", "...##...##..#..##...##..."),
    (Act::Hide(PictureLayer::Words), "Hide words", "F9", "#####..#....#....#....#.."),
    (Act::Hide(PictureLayer::Zones), "Hide zones", "F10", "#####.....#.#.#.....#####"),
    (Act::Hide(PictureLayer::Flight), "Hide the flight", "F12", "..#...#.#..#..#.#...##..."),
];

/// Things that belong together, things that stay where they are, and what is hidden.
#[derive(Clone, Debug, Default)]
pub(super) struct Arranged {
    groups: Vec<Vec<RowId>>,
    locked: Vec<RowId>,
    hidden: Vec<PictureLayer>,
}

impl Arranged {
    pub fn shows(&self, layer: PictureLayer) -> bool {
        !self.hidden.contains(&layer)
    }

    pub fn shows_kind(&self, kind: Kind) -> bool {
        match kind {
            Kind::Link => self.shows(PictureLayer::Wires),
            Kind::Text => self.shows(PictureLayer::Words),
            Kind::Fluid | Kind::Gravity => self.shows(PictureLayer::Zones),
            _ => true,
        }
    }

    fn whole(&self, rows: &[RowId]) -> Vec<RowId> {
        let mut all = rows.to_vec();
        for group in self.groups.iter().filter(|group| group.iter().any(|row| rows.contains(row))) {
            all.extend(group.iter().filter(|row| !rows.contains(row)));
        }
        all
    }
}

impl Editor {
    /// What the pointer can take hold of: neither locked nor hidden.
    pub(super) fn at_hand(&self) -> impl Iterator<Item = (RowId, Place)> + '_ {
        let shown = |row: &RowId| self.document.kind(*row).is_some_and(|kind| self.arranged.shows_kind(kind));
        self.document.things().filter(move |(row, _)| shown(row) && !self.arranged.locked.contains(row))
    }

    pub(super) fn select(&mut self, rows: &[RowId]) {
        self.selection = self.arranged.whole(rows);
    }

    /// Does something after which rows may have other numbers.
    pub(super) fn renumber(&mut self, act: impl FnOnce(&mut Self)) {
        let known = |rows: &[RowId]| rows.iter().map(|row| (row.table, self.document.place(*row))).collect::<Vec<_>>();
        let (groups, locked) =
            (self.arranged.groups.iter().map(|group| known(group)).collect::<Vec<_>>(), known(&self.arranged.locked));
        act(self);
        let now = |rows: &Vec<(Table, Option<Place>)>| {
            let found =
                |known: &(Table, Option<Place>)| self.document.things().find(|(row, place)| (row.table, Some(*place)) == *known);
            rows.iter().filter_map(|known| Some(found(known)?.0)).collect::<Vec<RowId>>()
        };
        (self.arranged.groups, self.arranged.locked) = (groups.iter().map(now).collect(), now(&locked));
    }

    pub(super) fn show_strip(&mut self, ui: &mut Ui<'_>, pass: &mut EditorPass) {
        let (canvas, from) = (ui.canvas(), self.panes.middle.min + INSIDE);
        let mut pressed = None;
        for (index, (act, label, key, picture)) in ACTS.into_iter().enumerate() {
            let gap = if matches!(act, Act::Hide(_)) { 2.0 * INSIDE } else { 0.0 };
            let area = Area { min: from + Vec2::new(index as f32 * (BUTTON.x + 2.0) + gap, 0.0), size: BUTTON };
            let touch = ui.touch(label, area, WidgetKind::Tool);
            let ground = if touch.hover { theme::panel_hover() } else { theme::panel() };
            let on = matches!(act, Act::Hide(layer) if self.arranged.shows(layer));
            widgets::panel_in(canvas, area, ground, if on { theme::accent() } else { theme::panel_edge() });
            self.draw_act(canvas, (act, picture), Area::around(area.centre(), Vec2::splat(15.0)));
            if touch.hover {
                let what = if matches!(act, Act::Group | Act::Lock) {
                    tr!("{what}, while the editor is open", what = tr(label))
                } else {
                    tr(label).to_owned()
                };
                pass.tip = Some(if key.is_empty() { what } else { tr!("{what} · key {key}", what, key = tr(key)) });
            }
            pressed = pressed.or(touch.pressed.then_some(act));
            if pass.open && area.contains(pass.pointer) && ui.input().click {
                pass.close(None);
            }
        }
        if let Some(act) = pressed.filter(|_| ui.is_live()) {
            self.arrange(act);
        }
    }

    /// The keys of the strip; whether one was pressed.
    pub(super) fn arrange_by_key(&mut self, input: &Input) -> bool {
        let held = |keys: &str, word: &str, key| keys.contains(word) == input.held(key);
        let is_pressed = |(_, _, keys, _): &&(Act, &str, &str, &str)| {
            let key = keys.rsplit(' ').next().and_then(Key::named);
            key.is_some_and(|key| input.pressed(key)) && held(keys, "Ctrl", Key::Control) && held(keys, "Shift", Key::Shift)
        };
        let act = ACTS.iter().find(is_pressed).map(|(act, ..)| *act);
        act.inspect(|act| self.arrange(*act)).is_some()
    }

    fn arrange(&mut self, act: Act) {
        self.gesture += 1;
        let rows = self.selection.clone();
        match act {
            Act::Align(axis, side) => self.align(axis, side),
            Act::Spread(axis) => self.spread(axis),
            Act::Group if rows.len() > 1 => {
                self.arranged.groups.retain(|group| !group.iter().any(|row| rows.contains(row)));
                self.say(tr("They belong together now."));
                self.arranged.groups.push(rows);
            }
            Act::Ungroup => self.arranged.groups.retain(|group| !group.iter().any(|row| rows.contains(row))),
            Act::Lock if !rows.is_empty() => {
                self.say(tr("Locked: Ctrl Shift L frees all."));
                self.arranged.locked.extend(rows);
                self.selection.clear();
            }
            Act::Unlock => self.arranged.locked.clear(),
            Act::Group | Act::Lock => self.say(tr("Select things first: Shift adds one, a frame takes several.")),
            Act::Hide(layer) => {
                let before = self.arranged.hidden.len();
                self.arranged.hidden.retain(|hidden| *hidden != layer);
                if self.arranged.hidden.len() == before {
                    self.arranged.hidden.push(layer);
                }
                let arranged = &self.arranged;
                self.selection.retain(|row| self.document.kind(*row).is_some_and(|kind| arranged.shows_kind(kind)));
            }
        }
    }

    /// The places of what is selected and has one of its own, in order along an axis.
    fn selected_places(&self, axis: usize) -> Vec<(RowId, Place)> {
        let own = self.selection.iter().filter(|row| self.document.kind(**row) != Some(Kind::Link));
        let mut places: Vec<(RowId, Place)> = own.filter_map(|row| Some((*row, self.document.place(*row)?))).collect();
        places.sort_by(|(_, a), (_, b)| a.centre()[axis].total_cmp(&b.centre()[axis]));
        places
    }

    /// Brings the lower edges of things along an axis to these places.
    fn bring(&mut self, axis: usize, places: &[(RowId, Place)], to: impl Iterator<Item = f64>) {
        let mut along = DVec2::ZERO;
        along[axis] = 1.0;
        let moved =
            places.iter().zip(to).map(|((row, place), to)| self.document.shifted(*row, along * (to - place.min[axis]).round()));
        let cells: Vec<SetCell> = moved.flatten().collect();
        self.set(&cells);
    }

    fn align(&mut self, axis: usize, side: u8) {
        let (places, share) = (self.selected_places(axis), f64::from(side) * 0.5);
        let low = places.iter().map(|(_, place)| place.min[axis]).fold(f64::INFINITY, f64::min);
        let high = places.iter().map(|(_, place)| place.max()[axis]).fold(f64::NEG_INFINITY, f64::max);
        self.bring(axis, &places, places.iter().map(|(_, place)| low + (high - low - place.size[axis]) * share));
    }

    fn spread(&mut self, axis: usize) {
        let places = self.selected_places(axis);
        let (Some((_, first)), Some((_, last))) = (places.first(), places.last()) else { return };
        let filled: f64 = places.iter().map(|(_, place)| place.size[axis]).sum();
        let gap = (last.max()[axis] - first.min[axis] - filled) / (places.len() as f64 - 1.0).max(1.0);
        let edges = places.iter().scan(first.min[axis], |at, (_, place)| {
            *at += place.size[axis] + gap;
            Some(*at - place.size[axis] - gap)
        });
        self.bring(axis, &places, edges);
    }

    fn draw_act(&self, canvas: &Canvas, (act, picture): (Act, &str), area: Area) {
        let can = match act {
            Act::Align(..) | Act::Spread(_) | Act::Group => self.selection.len() > 1,
            Act::Ungroup => !self.arranged.groups.is_empty(),
            Act::Lock => !self.selection.is_empty(),
            Act::Unlock => !self.arranged.locked.is_empty(),
            Act::Hide(layer) => self.arranged.shows(layer),
        };
        let (ink, dot) = (if can { theme::text() } else { theme::solid_top() }, area.size / 5.0);
        for (index, _) in picture.bytes().enumerate().filter(|(_, mark)| *mark == b'#') {
            let place = Vec2::new((index % 5) as f32, (index / 5) as f32);
            canvas.rectangle(Area { min: area.min + place * dot, size: dot }, ink);
        }
    }
}
