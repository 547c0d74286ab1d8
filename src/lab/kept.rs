//! The charts that come with the game, as its authors measured them: the files of `docs/charts`. The game shows them where
//! `resultant chart` has not been run.

use super::charts::Charts;

macro_rules! kept {
    ($($name:literal),* $(,)?) => {
        [$((concat!($name, ".csv"), include_str!(concat!("../../docs/charts/", $name, ".csv")))),*]
    };
}

const FILES: [(&str, &str); 37] = kept![
    "setting",
    "scenes",
    "stress",
    "fall",
    "parabola",
    "fall-with-drag",
    "rise-with-drag",
    "drag-alone",
    "liquid",
    "projectile",
    "gust",
    "oscillator",
    "oscillator-energy",
    "spring",
    "pendulum",
    "slide",
    "bounce-perfect",
    "bounce-apexes",
    "head-on",
    "cradle",
    "column",
    "heavy-on-light",
    "pushed-row",
    "thin-wall",
    "thin-body",
    "pi",
    "piles",
    "piles-of-masses",
    "piles-that-bounce",
    "settled",
    "flights",
    "flights-with-drag",
    "bounce-fourth",
    "column-100",
    "wall-10-km-s",
    "oscillator-energy-over-time",
    "bounce-perfect-over-time",
];

/// # Errors
/// As [`Charts::read`]: a file was damaged before the build.
pub fn charts() -> Result<Charts, String> {
    Charts::read(|name| {
        let file = FILES.iter().find(|(file, _)| *file == name);
        file.map(|(_, text)| (*text).to_owned()).ok_or_else(|| format!("{name}: not among the charts that come with the game"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::scenes;

    #[test]
    fn every_scene_has_its_chart() {
        let charts = charts().unwrap();
        let kept: Vec<&str> = charts.diagrams.iter().map(|measured| measured.name.as_str()).collect();
        let scenes: Vec<&str> = scenes::all().iter().map(|scene| scene.name).collect();
        // Behind the scenes of the lab stand the scenes of engines only.
        assert_eq!(kept[..scenes.len()], scenes);
        let followed = charts.diagrams.iter().filter(|measured| measured.over_time.is_some());
        let kept: Vec<String> =
            kept.iter().map(|name| (*name).to_owned()).chain(followed.map(|m| format!("{}-over-time", m.name))).collect();
        let listed: Vec<&str> = FILES[3..].iter().map(|(name, _)| name.trim_end_matches(".csv")).collect();
        assert_eq!(listed, kept, "docs/charts/scenes.csv names other files than are listed here");
        assert!(!charts.stress.is_empty());
    }
}
