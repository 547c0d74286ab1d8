//! The charts that come with the game, as its authors measured them: the files of `docs/charts`. The game shows them where
//! `resultant chart` has not been run.

use super::charts::Charts;

macro_rules! kept {
    ($($name:literal),* $(,)?) => {
        [$((concat!($name, ".csv"), include_str!(concat!("../../docs/charts/", $name, ".csv")))),*]
    };
}

/// Names and texts.
const FILES: [(&str, &str); 20] = kept![
    "setting",
    "scenes",
    "stress",
    "fall",
    "parabola",
    "fall-with-drag",
    "projectile",
    "gust",
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
];

/// Reads them.
///
/// # Errors
/// As [`Charts::read`]: a file that was damaged before the game was built.
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
        let mut expected: Vec<&str> = scenes::all().iter().map(|scene| scene.name).collect();
        expected.push("piles");
        assert_eq!(kept, expected);
        assert_eq!(FILES.len(), kept.len() + 3, "no file too many");
        assert!(!charts.stress.is_empty());
    }
}
