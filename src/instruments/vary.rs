//! "What if": numbers of a level that vary while it is flown, and their sliders.

use crate::level::{Level, Parameter, Problem, varied};
use std::collections::BTreeMap;

/// Digits that a slider sets, which is as many as it shows.
const DIGITS: usize = 3;
/// A number nearer to 0 than this part of a slider is 0.
const NOTHING: f64 = 1e-3;

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Variation {
    changes: BTreeMap<Parameter, f64>,
}

impl Variation {
    /// Varies a number; one that is as in the level is not varied.
    pub fn set(&mut self, parameter: Parameter, value: f64, level: &Level) {
        if parameter.of(level) == Some(value) {
            self.changes.remove(&parameter);
        } else {
            self.changes.insert(parameter, value);
        }
    }

    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// `None` where it is as in the level.
    pub fn get(&self, parameter: Parameter) -> Option<f64> {
        self.changes.get(&parameter).copied()
    }

    /// In the order of the list.
    pub fn changes(&self) -> impl Iterator<Item = (Parameter, f64)> + '_ {
        self.changes.iter().map(|(parameter, value)| (*parameter, *value))
    }

    pub fn parameters(&self) -> Vec<Parameter> {
        self.changes.keys().copied().collect()
    }

    /// # Errors
    /// Every number that the loader would not accept.
    pub fn apply(&self, level: &Level) -> Result<Level, Vec<Problem>> {
        varied(level, &self.changes().collect::<Vec<_>>())
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SliderTrack {
    /// Equal distances, equal differences.
    Even(f64, f64),
    /// Equal distances, equal ratios; both ends above 0.
    Ratios(f64, f64),
    /// Ever finer towards 0, which is on it: a number grows with the square of the distance from there.
    Fine(f64, f64),
    /// Whole numbers from 0 to this.
    Choices(f64),
}

impl SliderTrack {
    /// The slider of a number that is `usual` in the level: a sensible range within the loader's limits.
    pub fn of(parameter: Parameter, usual: f64) -> Self {
        let (least, most) = parameter.limits();
        let reach = |sensible: f64| sensible.max(2.0 * usual.abs()).min(most);
        match parameter {
            Parameter::Mass(_) => Self::Ratios((usual / 100.0).max(least), (usual * 100.0).min(most)),
            Parameter::VelocityX(_) | Parameter::VelocityY(_) => Self::Fine(-reach(30.0), reach(30.0)),
            Parameter::Air => Self::Fine(0.0, reach(20.0)),
            Parameter::Gravity => Self::Even(if usual < 0.0 { -reach(30.0) } else { 0.0 }, reach(30.0)),
            Parameter::Thrust => Self::Even(0.0, reach(5000.0)),
            Parameter::Wind => Self::Even(0.0, reach(5.0)),
            Parameter::Drag(_) | Parameter::Friction => Self::Even(0.0, reach(3.0)),
            Parameter::Restitution(_) => Self::Even(0.0, 1.0),
            Parameter::PlaceX(_) | Parameter::PlaceY(_) | Parameter::From(_) | Parameter::To(_) | Parameter::Ease(_) => {
                Self::Even(0.0, reach(10.0))
            }
            Parameter::Width(_) => Self::Ratios((usual / 10.0).max(least), (usual * 10.0).min(most)),
            Parameter::Stiffness(_) | Parameter::Damping(_) | Parameter::Density(_) | Parameter::Speed(_) => {
                Self::Fine(least, reach(20.0))
            }
            Parameter::Breaks(_) => Self::Ratios(0.1, most),
            Parameter::Stream(_) => Self::Fine(-reach(100.0), reach(100.0)),
            Parameter::Material(_) => Self::Choices(most),
        }
    }

    const fn ends(self) -> (f64, f64) {
        match self {
            Self::Even(low, high) | Self::Ratios(low, high) | Self::Fine(low, high) => (low, high),
            Self::Choices(high) => (0.0, high),
        }
    }

    /// The number at that part of the slider (0 … 1), with three digits.
    pub fn value(self, part: f64) -> f64 {
        let part = part.clamp(0.0, 1.0);
        let (low, high) = self.ends();
        let value = match self {
            Self::Even(..) => low + (high - low) * part,
            Self::Ratios(..) => low * (high / low).powf(part),
            Self::Fine(..) => {
                let way = bent(low) + (bent(high) - bent(low)) * part;
                way * way.abs()
            }
            Self::Choices(_) => return (high * part).round(),
        };
        if !matches!(self, Self::Ratios(..)) && value.abs() <= NOTHING * (high - low) {
            return 0.0;
        }
        // Both ends are accepted.
        rounded(value).clamp(low, high)
    }

    /// The part of the slider (0 … 1) for that number; at an end where the number is beyond it.
    pub fn part(self, value: f64) -> f64 {
        let (low, high) = self.ends();
        let value = value.clamp(low, high);
        match self {
            Self::Even(..) | Self::Choices(_) => (value - low) / (high - low),
            Self::Ratios(..) => (value / low).ln() / (high / low).ln(),
            Self::Fine(..) => (bent(value) - bent(low)) / (bent(high) - bent(low)),
        }
    }

    /// The number that is fine `steps` further: units of the last but one digit on the screen, within the loader's limits.
    pub fn stepped(self, value: f64, steps: f64, (least, most): (f64, f64)) -> f64 {
        let finest = match self {
            Self::Even(low, high) | Self::Fine(low, high) => power(high - low) * NOTHING,
            Self::Ratios(..) => 0.0,
            Self::Choices(high) => return (value + steps.signum()).clamp(0.0, high),
        };
        rounded(value + steps * (power(value) * 0.1).max(finest)).clamp(least, most)
    }
}

fn bent(value: f64) -> f64 {
    value.abs().sqrt().copysign(value)
}

/// Not above a number's size; 0 for 0.
fn power(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { 10f64.powi(value.abs().log10().floor() as i32) }
}

fn rounded(value: f64) -> f64 {
    // Through its text, since a float cannot hold most powers of ten below one.
    format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const TRACKS: [SliderTrack; 5] = [
        SliderTrack::Even(0.0, 30.0),
        SliderTrack::Even(-30.0, 30.0),
        SliderTrack::Ratios(0.01, 1e6),
        SliderTrack::Fine(-50.0, 50.0),
        SliderTrack::Fine(0.0, 20.0),
    ];

    #[test]
    fn a_slider_sets_three_digits_and_finds_zero_and_its_ends() {
        assert_eq!(SliderTrack::Even(0.0, 30.0).value(0.327), 9.81);
        assert_eq!(SliderTrack::Even(0.0, 30.0).value(1e-4), 0.0);
        assert_eq!(SliderTrack::Fine(-50.0, 50.0).value(0.5), 0.0);
        assert_eq!(SliderTrack::Ratios(1.0, 1e4).value(0.5), 100.0);
        for (track, ends) in TRACKS.iter().zip([(0.0, 30.0), (-30.0, 30.0), (0.01, 1e6), (-50.0, 50.0), (0.0, 20.0)]) {
            assert_eq!((track.value(0.0), track.value(1.0)), ends);
        }
    }

    #[test]
    fn steps_are_units_of_the_digit_before_the_last() {
        let gravity = SliderTrack::of(Parameter::Gravity, 9.81);
        let limits = Parameter::Gravity.limits();
        assert_eq!([1.0, -1.0, 5.0].map(|steps| gravity.stepped(9.81, steps, limits)), [9.91, 9.71, 10.3]);
        assert_eq!(gravity.stepped(0.0, 1.0, limits), 0.01);
        let mass = SliderTrack::of(Parameter::Mass(0), 100.0);
        assert_eq!([1.0, -1.0].map(|steps| mass.stepped(2.0, steps, Parameter::Mass(0).limits())), [2.1, 1.9]);
        assert_eq!(mass.stepped(1e-3, -100.0, Parameter::Mass(0).limits()), 1e-3, "never what is not accepted");
    }

    proptest! {
        #[test]
        fn a_slider_stands_where_its_number_is(track in proptest::sample::select(TRACKS.to_vec()), part in 0.0_f64..=1.0) {
            let value = track.value(part);
            let again = track.value(track.part(value));
            prop_assert!((again - value).abs() <= 0.01 * value.abs(), "{track:?}: {value} came back as {again}");
            prop_assert!((track.part(value) - part).abs() <= 0.05, "{track:?}: {part} became {}", track.part(value));
        }

        #[test]
        fn whatever_a_level_holds_its_sliders_are_within_what_is_accepted(usual in -1.0_f64..=1.0, part in 0.0_f64..=1.0) {
            for parameter in [Parameter::Mass(1), Parameter::Drag(0), Parameter::Restitution(2), Parameter::VelocityX(0),
                Parameter::VelocityY(1), Parameter::Thrust, Parameter::Gravity, Parameter::Air, Parameter::Friction, Parameter::Wind] {
                let (least, most) = parameter.limits();
                let usual = (usual * most).max(least);
                let value = SliderTrack::of(parameter, usual).value(part);
                prop_assert!(value.is_finite() && (least..=most).contains(&value), "{parameter:?} {usual}: {value}");
            }
        }
    }
}
