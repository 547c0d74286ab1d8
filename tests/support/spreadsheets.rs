//! A table as spreadsheets of many countries save it.

/// A table in one of the forms, and the name of the form.
pub struct Saved {
    pub form: String,
    pub bytes: Vec<u8>,
}

const DELIMITERS: [(&str, char, char); 5] = [
    ("commas", ',', '.'),
    ("semicolons", ';', '.'),
    ("German semicolons", ';', ','),
    ("tabs", '\t', '.'),
    ("German tabs", '\t', ','),
];
const ENCODINGS: [&str; 4] = ["UTF-8", "marked UTF-8", "UTF-16 LE", "UTF-16 BE"];
const LINE_ENDS: [(&str, &str); 3] = [("LF", "\n"), ("CRLF", "\r\n"), ("CR", "\r")];
const STYLES: [&str; 4] = ["plain", "quoted", "spaced", "filled"];

/// The rows of a plain table, whose lines have commas alone between cells; a cell with a comma stands in quotes.
fn rows(plain: &str) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(plain.as_bytes());
    reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
}

/// In every form; with `filled` rows, empty cells make all rows as long as the longest. `is_number` tells numbers, whose decimal mark changes.
pub fn saved(plain: &str, is_number: fn(&str) -> bool) -> Vec<Saved> {
    let rows = rows(plain);
    let most = rows.iter().map(Vec::len).max().unwrap_or(0);
    let mut all = Vec::new();
    for (delimiter, sign, mark) in DELIMITERS {
        for style in STYLES {
            let cell = |text: &String| {
                let text = if is_number(text) { text.replace('.', &mark.to_string()) } else { text.clone() };
                let quoted = style == "quoted" || text.contains([sign, '"', '\n']);
                let text = if quoted { format!("\"{}\"", text.replace('"', "\"\"")) } else { text };
                if style == "spaced" { format!(" {text} ") } else { text }
            };
            let lines = rows.iter().map(|row| {
                let mut cells: Vec<String> = row.iter().map(cell).collect();
                if style == "filled" {
                    cells.resize(most, String::new());
                }
                cells.join(&sign.to_string())
            });
            let lines: Vec<String> = lines.collect();
            for (end, line_end) in LINE_ENDS {
                for said in [false, true] {
                    let said_line = if said { format!("sep={sign}{line_end}") } else { String::new() };
                    let text = said_line + &lines.iter().map(|line| format!("{line}{line_end}")).collect::<String>();
                    all.extend(ENCODINGS.map(|encoding| {
                        let form = format!("{delimiter}, {style}, {end}, {encoding}{}", if said { ", said" } else { "" });
                        Saved { form, bytes: encoded(encoding, &text) }
                    }));
                }
            }
        }
    }
    all
}

fn encoded(encoding: &str, text: &str) -> Vec<u8> {
    let wide = || std::iter::once(0xfeff).chain(text.encode_utf16());
    match encoding {
        "UTF-8" => text.as_bytes().to_vec(),
        "marked UTF-8" => [b"\xef\xbb\xbf", text.as_bytes()].concat(),
        "UTF-16 LE" => wide().flat_map(u16::to_le_bytes).collect(),
        _ => wide().flat_map(u16::to_be_bytes).collect(),
    }
}
