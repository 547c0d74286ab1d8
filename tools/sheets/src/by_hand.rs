//! A change of a level as one makes it in the game, at *What if …*: by the names, units and heights there.

use super::{EXPERIMENTS, SheetWords, read};
use std::path::Path;

/// Pixels a metre.
const METRE: f64 = 30.0;

/// A column, its label in the game, and its unit.
const LABELS: [(&str, &str, &str); 20] = [
    ("gravity", "Gravity", "N/kg"),
    ("air_density", "Air density", "kg/m³"),
    ("mass", "Mass", "kg"),
    ("drag", "Drag coefficient", ""),
    ("restitution", "Restitution", ""),
    ("vx", "Start velocity →", "m/s"),
    ("vy", "Start velocity ↑", "m/s"),
    ("x", "Start place →", "m"),
    ("y", "Start place ↑", "m"),
    ("image", "Width", "m"),
    ("stiffness", "Link {number}: stiffness", "N/m"),
    ("damping", "Link {number}: damping", "N·s/m"),
    ("breaks", "Link {number}: breaks", "N"),
    ("material", "Block {number}", ""),
    ("density", "Liquid {number}: density", "kg/m³"),
    ("speed", "Mover {number}: speed", "m/s"),
    ("ease", "Mover {number}: easing", "s"),
    ("way_points", "Mover {number}: to ↑", "m"),
    ("force_x", "Fan {number}", "N"),
    ("movers.csv y", "Mover {number}: from ↑", "m"),
];

/// The rows of a table, cells by comma, without its head; and the place of a column in them.
fn column(table: &str, name: &str) -> (Vec<Vec<String>>, Option<usize>) {
    let mut rows = table.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(',').map(str::to_owned).collect());
    let head: Vec<String> = rows.next().unwrap_or_default();
    (rows.collect(), head.iter().position(|cell| cell == name))
}

/// A sheet's change; fails on one that nothing there can make.
pub fn by_hand(words: &SheetWords, root: &Path, folder: &str, change: &str) -> Result<String, String> {
    let changes: Result<Vec<String>, String> = change
        .split("; ")
        .map(|part| one(words, root, folder, part).transpose().unwrap_or_else(|| Err(format!("{part:?} is no change by hand"))))
        .collect();
    Ok(changes?.join("; "))
}

fn one(words: &SheetWords, root: &Path, folder: &str, part: &str) -> Result<Option<String>, String> {
    let table = |file: &str| read(&root.join(EXPERIMENTS).join(folder).join(file));
    let (objects, images) = column(&table("objects.csv")?, "image");
    let (settings, values) = column(&table("constants.csv")?, "value");
    let cell = |row: usize, at: Option<usize>, rows: &[Vec<String>]| Some(rows.get(row)?.get(at?)?.clone());
    let said = || {
        let (setting, place) = part.rsplit_once(" in ")?;
        let (column, value) = setting.strip_prefix('`')?.split_once("` ")?;
        let (value, note) = value.split_once(" (").map_or((value, None), |(value, note)| (value, Some(note.trim_end_matches(')'))));
        let (row, file) = place.split_once(" of ").unwrap_or(("", place));
        let file = file.trim_matches('`');
        let own = format!("{file} {column}");
        let (_, label, unit) =
            LABELS.iter().find(|(name, ..)| *name == own).or(LABELS.iter().find(|(name, ..)| *name == column))?;
        let height: f64 = cell(settings.iter().position(|row| row[0] == "height")?, values, &settings)?.parse().ok()?;
        let up = |pixels: &str| Some((height - pixels.parse::<f64>().ok()?) / METRE);
        let number = match column {
            "x" => value.parse::<f64>().ok()? / METRE,
            "y" => up(value)?,
            "way_points" => up(value.rsplit_once(' ')?.1)?,
            "image" => value.split_once(':')?.1.split_once('x')?.0.parse::<f64>().ok()? / METRE,
            "vy" => -value.parse::<f64>().ok()?,
            "material" => 0.0,
            _ => value.parse().ok()?,
        };
        let thousandths = (number * 1000.0).round() / 1000.0;
        let value = if column == "material" { words.say(value).to_owned() } else { format!("{thousandths} {unit}") };
        let of = match (file, row.strip_prefix("row ")) {
            ("objects.csv", Some(row)) => {
                let ball = cell(row.parse::<usize>().ok()? - 1, images, &objects)?.starts_with("ball");
                words.say(if ball { "Ball {number}" } else { "Box {number}" }).replace("{number}", row) + ", "
            }
            ("objects.csv", None) => format!("{}, ", words.say("each object")),
            (_, None) if !row.is_empty() => format!("{}, ", words.say("each of them")),
            _ => String::new(),
        };
        let label = words.say(label).replace("{number}", row.strip_prefix("row ").unwrap_or("1"));
        let note = note.map_or_else(String::new, |note| format!(" ({})", words.quantity(note)));
        Some(format!("{of}*{label}* {}{note}", value.trim_end().replace('-', "−")))
    };
    Ok(said())
}
