//! A law through the selected curve, over the stretch whose area is shown.
//!
//! The curves as files.

use super::Plot;
use super::panel::Format;
use crate::files::INPUTS;
use crate::game::Game;
use crate::instruments::chart::{self, Exported};
use crate::instruments::curve::Curve;
use crate::instruments::fit::{Fit, FitLaw};
use crate::instruments::quantity::Quantity;
use crate::physics::BodyId;
use crate::session::library::NewFile;
use crate::view::lanes;
use crate::words::tr;

/// A fit with all that it depends on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fitted {
    of: (FitLaw, usize, Option<BodyId>, [Quantity; 2], (usize, usize)),
    /// `None` where the stretch has too few points.
    fit: Option<Fit>,
}

impl Plot {
    pub(super) fn refit(&mut self) {
        let selected = self.shown().find(|(number, ..)| *number == self.selected);
        let Some((law, (number, line, track))) = self.law.zip(selected) else {
            self.fitted = None;
            return;
        };
        let of = (law, number, line.read, [self.across, line.up], self.stretch(track));
        if self.fitted.as_ref().is_none_or(|fitted| fitted.of != of) {
            let fit = Fit::of(law, &points(&line.now, of.4));
            self.fitted = Some(Fitted { of, fit });
        }
    }

    /// The fit through the selected curve, if one is asked for and there is one.
    pub fn fit(&self) -> Option<&Fit> {
        self.fitted.as_ref()?.fit.as_ref()
    }

    /// The formula of the fit with its figures and its residual.
    pub(super) fn fit_words(&self) -> Option<String> {
        let (fit, line) = (self.fit()?, self.lines.get(self.selected)?);
        Some(fit.words(line.up, self.across))
    }

    /// From none through every law to none.
    pub(super) fn next_law(&mut self) {
        let next = self.law.map_or(0, |law| law as usize + 1);
        (self.law, self.message) = (FitLaw::ALL.get(next).copied(), None);
    }
}

fn points(curve: &Curve, (from, to): (usize, usize)) -> Vec<(f64, f64)> {
    (from..=to).map_while(|place| curve.point(place)).collect()
}

impl Plot {
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
