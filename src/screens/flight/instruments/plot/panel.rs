//! The buttons of the panel: their effects, their places, and the lists to choose from. A law through the selected curve, and the curves as files.

use super::choices::{self, PlotObject, choices};
use super::{Plot, PlotLine, along, hand::MOST_LINES, hand::PlotPlaces};
use crate::draw::layout::{Area, DETAILS, Vec2};
use crate::instruments::chart::{self, Exported};
use crate::{draw::Style, files::INPUTS, game::Game, instruments::quantity::Quantity, physics::BodyId, session::library::NewFile};
use crate::{instruments::fit::Fit, instruments::fit::FitLaw, ui::Ui, ui::WidgetKind, view::lanes, view::theme, words::tr};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Action {
    Add,
    /// Opens the choice of the quantity to the right.
    Across,
    /// Keep an object, or follow again.
    Keep(usize),
    Law,
    Export(Format),
    Whole,
    Larger,
    Whose(usize),
    What(usize),
    Remove(usize),
    Select(usize),
    Choose(Quantity),
}

impl Action {
    fn tip(self) -> Option<&'static str> {
        match self {
            Self::Keep(_) => Some("Plots this object, whichever is followed; once more: the followed one"),
            Self::Whose(_) => Some("Plots the other object"),
            Self::Remove(_) => Some("Removes this curve"),
            Self::Across => Some("The quantity of the axis to the right"),
            Self::What(_) => Some("The quantity of this curve"),
            Self::Law => Some("A line, a parabola or a sine through the selected curve: over the marked stretch (Shift and drag)"),
            Self::Export(_) => Some("Writes the curves as a file"),
            Self::Add | Self::Whole | Self::Larger | Self::Select(_) | Self::Choose(_) => None,
        }
    }
}

/// A button: its label, its words, and its action.
type PlotButton = (String, String, Action);

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
    /// The head, and each curve's line; returns the pressed action.
    pub(super) fn show_buttons(&self, ui: &mut Ui<'_>, places: &PlotPlaces) -> Option<Action> {
        let head = self.head();
        let top = places.panel.min.y;
        let mut pressed = row(ui, &head, places.head(&words(&head)), top);
        for (i, (line, area)) in self.lines.iter().zip(&places.lines).enumerate() {
            let name = format!("Curve {}", i + 1);
            if ui.touch(&name, *area, WidgetKind::Tool).pressed {
                pressed = Some(Action::Select(i));
            }
            let button = |words: &str, action| (format!("{name}: {words}"), words.to_owned(), action);
            let buttons = [
                button(&line.up.symbol(), Action::What(i)),
                button(tr(["1st", "2nd"][line.whose]), Action::Whose(i)),
                button("×", Action::Remove(i)),
            ];
            pressed = row(ui, &buttons, places.line(i, &words(&buttons)), top).or(pressed);
        }
        pressed
    }

    fn head(&self) -> Vec<PlotButton> {
        let mut head = Vec::new();
        let mut add = |words: String, action| head.push((words.clone(), words, action));
        if self.lines.len() < MOST_LINES {
            add(tr("+ Curve").to_owned(), Action::Add);
        }
        add(tr!("Across: {quantity}", quantity = self.across.symbol()), Action::Across);
        for (whose, rank) in [tr("1st"), tr("2nd")].into_iter().enumerate() {
            let kept = if self.objects[whose].kept.is_some() { tr(", kept") } else { "" };
            add(format!("{rank}: {}{kept}", self.name(whose)), Action::Keep(whose));
        }
        let law = self.law.map_or_else(|| tr("Fit: none").to_owned(), |law| tr!("Fit: {law}", law = tr(law.name())));
        add(law, Action::Law);
        add(tr(if self.large { "Smaller" } else { "Larger" }).to_owned(), Action::Larger);
        if self.window.is_some() {
            add(tr("Whole flight").to_owned(), Action::Whole);
        }
        add("CSV".to_owned(), Action::Export(Format::Csv));
        add("SVG".to_owned(), Action::Export(Format::Svg));
        head
    }

    /// The open list of quantities, above all else of the plot; returns the chosen one.
    pub(super) fn show_picker(&self, ui: &mut Ui<'_>, pick: Pick, places: &PlotPlaces) -> Option<Action> {
        let blocks = self.choices(pick);
        let (list, cells) = places.picker(&blocks.each_ref().map(Vec::len), choices::NAME, choices::MOST_OF_A_ROW);
        ui.canvas().end_layer();
        ui.touch("Quantities", list, WidgetKind::Tool);
        ui.panel(list);
        let mut chosen = None;
        for ((name, quantities), cells) in blocks.iter().flatten().zip(cells.iter().flatten()) {
            let at = Vec2::new(cells[0].min.x, cells[0].centre().y);
            ui.text(tr(name), at, Style::new(DETAILS, theme::quiet()).middle());
            let button = |quantity: &Quantity| (quantity.symbol(), choices::label(*quantity), Action::Choose(*quantity));
            let buttons: Vec<PlotButton> = quantities.iter().map(button).collect();
            chosen = row(ui, &buttons, cells[1..].to_vec(), list.min.y).or(chosen);
        }
        chosen
    }

    fn choices(&self, pick: Pick) -> [Vec<choices::ChoiceRow>; 2] {
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
                object.kept = if object.kept.is_some() { None } else { object.track().map(|track| track.body) };
            }
            Action::Law => {
                let next = self.law.map_or(0, |law| law as usize + 1);
                (self.law, self.message) = (FitLaw::ALL.get(next).copied(), None);
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
        }
        self.refresh(false);
    }

    pub(super) fn refit(&mut self) {
        let selected = self.shown().find(|(number, ..)| *number == self.selected);
        let Some((law, (number, line, track))) = self.law.zip(selected) else {
            self.fitted = None;
            return;
        };
        let of = (law, number, line.read, [self.across, line.up], self.stretch(track));
        if self.fitted.as_ref().is_none_or(|fitted| fitted.of != of) {
            let fit = Fit::of(law, &(of.4.0..=of.4.1).map_while(|place| line.now.point(place)).collect::<Vec<_>>());
            self.fitted = Some(Fitted { of, fit });
        }
    }

    /// The fit through the selected curve, if one is asked for and there is one.
    pub fn fit(&self) -> Option<&Fit> {
        self.fitted.as_ref()?.fit.as_ref()
    }

    pub(super) fn make_file(&mut self, format: Format, game: &Game) {
        let curves: Vec<Exported> = self
            .shown()
            .map(|(number, line, track)| Exported {
                body: self.name(line.whose),
                curve: &line.now,
                track,
                number,
                fit: self.fit().filter(|_| number == self.selected),
            })
            .collect();
        if curves.is_empty() {
            self.message = Some((tr("There is no curve to be exported.").to_owned(), true));
            return;
        }
        let (text, ending) = match format {
            Format::Csv => (chart::csv(&curves), ".csv"),
            Format::Svg => (lanes::curves(&game.level().title, &chart::sheet(self.window(), &curves)), ".svg"),
        };
        let stem = chart::stem(&self.level, &curves);
        self.export = Some(NewFile { stem, ending, bytes: text.into_bytes(), what: tr("the curves"), same_up_to: INPUTS });
    }
}

/// Returns the pressed action; tooltips stand above `top`, off the curves.
fn row(ui: &mut Ui<'_>, buttons: &[PlotButton], areas: Vec<Area>, top: f32) -> Option<Action> {
    let mut pressed = None;
    for ((label, words, action), area) in buttons.iter().zip(areas) {
        if ui.small_button((label, words), area, Style::new(DETAILS, theme::text()).centred()) {
            pressed = Some(*action);
        }
        if let Some(tip) = action.tip() {
            ui.tip_above(area, tip, Some(top));
        }
    }
    pressed
}

fn words(buttons: &[PlotButton]) -> Vec<String> {
    buttons.iter().map(|(_, words, _)| words.clone()).collect()
}

/// A fit with all that it depends on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fitted {
    of: (FitLaw, usize, Option<BodyId>, [Quantity; 2], (usize, usize)),
    /// `None` where the stretch has too few points.
    fit: Option<Fit>,
}
