//! The buttons of the panel: their effects, their places, and the lists to choose from.

use super::choices::{self, choices};
use super::object::PlotObject;
use super::places::{MOST_LINES, PlotPlaces};
use super::{Plot, PlotLine, along};
use crate::draw::layout::Area;
use crate::instruments::quantity::Quantity;
use crate::instruments::track::BodyTrack;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Action {
    Add,
    /// Opens the choice of the quantity to the right.
    Across,
    /// Keep an object, or follow again.
    Keep(usize),
    Export(Format),
    Whole,
    Larger,
    /// The other object for a curve.
    Whose(usize),
    /// Opens the choice of a curve's quantity.
    What(usize),
    Remove(usize),
    /// Shows this curve's area.
    Select(usize),
    Choose(Quantity),
    None,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Csv,
    Svg,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pick {
    Across,
    Line(usize),
}

impl Plot {
    pub(super) fn lay_out(&mut self, places: &PlotPlaces) {
        self.actions.clear();
        let mut areas = Vec::new();
        if let Some((list, cells)) = self.pick.map(|pick| self.list(pick, places)) {
            areas.extend(cells);
            self.actions.extend(list);
        }
        let mut head = Vec::new();
        if self.lines.len() < MOST_LINES {
            head.push((Action::Add, "+ Curve".to_owned()));
        }
        head.push((Action::Across, format!("Across: {}", self.across.symbol())));
        for (whose, rank) in ["1st", "2nd"].into_iter().enumerate() {
            let kept = if self.objects[whose].kept.is_some() { ", kept" } else { "" };
            head.push((Action::Keep(whose), format!("{rank}: {}{kept}", self.name(whose))));
        }
        head.push((Action::Larger, if self.large { "Smaller" } else { "Larger" }.to_owned()));
        if self.window.is_some() {
            head.push((Action::Whole, "Whole flight".to_owned()));
        }
        head.extend([(Action::Export(Format::Csv), "CSV".to_owned()), (Action::Export(Format::Svg), "SVG".to_owned())]);
        areas.extend(places.head(&words(&head)));
        self.actions.extend(head);
        for (i, line) in self.lines.iter().enumerate() {
            let whose = ["1st", "2nd"][line.whose].to_owned();
            let row = vec![(Action::What(i), line.up.symbol()), (Action::Whose(i), whose), (Action::Remove(i), "×".to_owned())];
            areas.extend(places.line(i, &words(&row)));
            areas.push(places.lines[i]);
            self.actions.extend(row);
            self.actions.push((Action::Select(i), String::new()));
        }
        self.buttons.place(areas);
    }

    /// The open list: its cells with their effects and places.
    fn list(&self, pick: Pick, places: &PlotPlaces) -> (Vec<(Action, String)>, Vec<Area>) {
        let blocks = self.choices(pick);
        let (_, cells) = places.picker(&blocks.each_ref().map(Vec::len), choices::NAME, choices::MOST_OF_A_ROW);
        let mut list = Vec::new();
        let mut areas = Vec::new();
        for ((name, quantities), cells) in blocks.iter().flatten().zip(cells.iter().flatten()) {
            list.push((Action::None, (*name).to_owned()));
            list.extend(quantities.iter().map(|quantity| (Action::Choose(*quantity), choices::label(*quantity))));
            areas.extend(&cells[..=quantities.len()]);
        }
        (list, areas)
    }

    fn choices(&self, pick: Pick) -> [Vec<choices::Row>; 2] {
        let tracks = || self.objects.iter().filter_map(PlotObject::track);
        choices(pick == Pick::Across, |kind| tracks().any(|track| track.felt(kind)))
    }

    pub(super) fn picker(&self, places: &PlotPlaces) -> Option<Area> {
        let blocks = self.choices(self.pick?);
        Some(places.picker(&blocks.each_ref().map(Vec::len), choices::NAME, choices::MOST_OF_A_ROW).0)
    }

    pub(super) fn act(&mut self, action: Action) {
        let pick = self.pick.take();
        // The player's choice stays.
        self.settled |= matches!(action, Action::Add | Action::Choose(_) | Action::Remove(_));
        match action {
            Action::Add => {
                let new = |up: &Quantity| self.lines.iter().all(|line| line.up != *up);
                let up = along(self.axis).into_iter().find(new).unwrap_or(Quantity::Kinetic);
                self.lines.push(PlotLine::new(0, self.across, up));
                self.pick = Some(Pick::Line(self.lines.len() - 1));
            }
            Action::Across => self.pick = Some(Pick::Across).filter(|now| pick != Some(*now)),
            Action::What(line) => self.pick = Some(Pick::Line(line)).filter(|now| pick != Some(*now)),
            Action::Keep(whose) => {
                let object = &mut self.objects[whose];
                object.kept = if object.kept.is_some() { None } else { object.track().map(BodyTrack::body) };
            }
            Action::Export(format) => (self.waiting, self.message) = (Some(format), None),
            Action::Whole => self.window = None,
            Action::Larger => self.large = !self.large,
            Action::Whose(line) => self.lines[line].whose = 1 - self.lines[line].whose,
            Action::Remove(line) => {
                self.lines.remove(line);
                self.selected = 0;
            }
            Action::Select(line) => self.selected = line,
            Action::Choose(quantity) => match pick {
                Some(Pick::Across) => self.across = quantity,
                Some(Pick::Line(line)) => self.lines[line].up = quantity,
                None => {}
            },
            Action::None => self.pick = pick,
        }
        self.refresh(false);
    }
}

fn words(buttons: &[(Action, String)]) -> Vec<String> {
    buttons.iter().map(|(_, words)| words.clone()).collect()
}
