//! The schema as text: the rows of a new level with their comments, and the tables of docs/levels.md.

use super::facts::{Column, RowSchema};
use super::{kinds::Table, settings::SETTINGS};
use crate::words;

/// The longest line of a comment, characters.
const LINE: usize = 100;

/// A file of a new level: help as comments, in English, a header and some rows; `None` where a new level has no such file.
pub fn sample(table: Table) -> Option<String> {
    words::in_english(|| written(table))
}

fn written(table: Table) -> Option<String> {
    let file = table.schema();
    if file.sample.is_empty() {
        return None;
    }
    let mut text = comment(file.help);
    for (rows, columns) in groups(table) {
        rows.iter().filter(|row| !row.tag.is_empty()).for_each(|row| text += &comment(&tagged_columns(row)));
        // A place needs no help but its name.
        let is_place = |column: &Column| matches!(column.name, "kind" | "x" | "y" | "width" | "height") && column.required;
        columns.iter().filter(|column| !is_place(column)).for_each(|column| text += &comment(&column.in_words()));
    }
    if let [only] = table.rows() {
        let names: Vec<&str> = only.columns.iter().map(|column| column.name).collect();
        text += &(names.join(",") + "\n");
    }
    Some(text + file.sample)
}

/// Kinds of rows that share their columns, and these columns. For constants.csv the settings.
fn groups(table: Table) -> Vec<(Vec<&'static RowSchema>, &'static [Column])> {
    if table == Table::Constants {
        return vec![(table.rows().to_vec(), SETTINGS)];
    }
    let groups = table.rows().chunk_by(|a, b| std::ptr::eq(a.columns, b.columns));
    groups.map(|rows| (rows.to_vec(), rows[0].columns)).collect()
}

/// `PLAYER,x,y,width,height,[hold]`.
fn tagged_columns(row: &RowSchema) -> String {
    let text = row.columns_text();
    match text.split_once(',') {
        Some((_, rest)) if !row.tag.is_empty() => format!("{},{rest}", row.tag),
        _ => text,
    }
}

fn comment(words: &str) -> String {
    let mut lines = vec!["#".to_owned()];
    for word in words.split_whitespace() {
        let last = lines.len() - 1;
        if lines[last].chars().count() + word.chars().count() >= LINE {
            lines.push("#  ".to_owned());
        }
        let last = lines.len() - 1;
        lines[last] += &format!(" {word}");
    }
    lines.join("\n") + "\n"
}

/// The tables of docs/levels.md: a section a file, a line a column.
pub fn documentation() -> String {
    Table::ALL.iter().map(|table| section(*table)).collect::<Vec<_>>().join("\n")
}

fn section(table: Table) -> String {
    let mut text = format!("### `{}`\n\n{}\n", table.file(), table.schema().help);
    for (rows, columns) in groups(table) {
        let rows: Vec<String> = rows.into_iter().map(|row| format!("`{}`", tagged_columns(row))).collect();
        let first = if table == Table::Constants { "setting" } else { "column" };
        text += &format!("\n{}\n\n| {first} | what it is | what it holds | where left out |\n|---|---|---|---|\n", rows.join(", "));
        for column in columns.iter().filter(|column| column.name != "kind") {
            let usual = match (column.usual, column.required) {
                (_, true) => "required".to_owned(),
                ("", false) => String::new(),
                (usual, false) => format!("`{usual}`"),
            };
            text += &format!("| `{}` | {} | {} | {usual} |\n", column.name, column.help, column.limits());
        }
    }
    text
}
