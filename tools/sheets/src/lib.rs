//! Sheets for lessons as HTML to be printed: of each experiment a page for the class, and one with its answers. The texts are those of
//! `docs/lessons`, the order is that of `experiments/experiments.csv`; the keys, which all sheets share, stand here.

mod text;

use std::fmt::Write;
use std::fs;
use std::path::Path;
pub use text::Lesson;
use text::{escaped, inline};

/// The folder of the sheets in the project.
pub const FOLDER: &str = "docs/sheets";
/// The list of all sheets.
const INDEX: &str = "index.html";

/// Keys of an experiment, and what they do.
pub const KEYS: [(&[&str], &str); 13] = [
    (&["Enter"], "flies the experiment"),
    (&["Tab"], "details: forces and numbers"),
    (&["N"], "the next object; or click one"),
    (&["Shift"], "and a click: compares a second object"),
    (&["B"], "stops time, lets it go on"),
    (&[".", ","], "a tick on, a tick back"),
    (&["[", "]"], "slower, faster"),
    (&["+", "−"], "zoom; or the wheel"),
    (&["F"], "everything that moves in view"),
    (&["I"], "instruments: plot, ruler, clock, energy, what if"),
    (&["R"], "starts once more"),
    (&["Esc"], "pause, and back to the experiments"),
    (&["Space"], "in the list of experiments: the answer"),
];

const STYLE: &str = "
@page { size: A4; margin: 11mm 14mm; }
body { font: 10pt/1.32 'Liberation Sans', Arial, Helvetica, sans-serif; color: #111; background: #fff;
  max-width: 180mm; margin: 8mm auto; }
h1 { font-size: 19pt; margin: 0 0 1mm; } h2 { font-size: 11.5pt; margin: 2.6mm 0 .8mm; border-bottom: 1px solid #888; }
p, ol { margin: 1mm 0; } ol { padding-left: 6mm; } li { margin-bottom: .8mm; }
.question { font-size: 12.5pt; } .where, .small { color: #444; font-size: 9pt; }
.fields { display: flex; gap: 8mm; margin: 0 0 2mm; color: #444; } .fields span { flex: 1; border-bottom: 1px solid #888; }
.line { border-bottom: 1px dotted #888; height: 6.4mm; }
.keys { columns: 3; font-size: 8.5pt; margin: 1mm 0; padding: 1.5mm 2mm; background: #f1f3f6; } .keys div { break-inside: avoid; }
kbd { font: bold .92em 'Liberation Mono', Consolas, monospace; border: 1px solid #777; border-radius: 2px; padding: 0 1mm; background: #fff; }
code { font: .94em 'Liberation Mono', Consolas, monospace; }
table { border-collapse: collapse; width: 100%; margin: 1mm 0; }
th, td { border: 1px solid #999; padding: .5mm 1.6mm; text-align: left; vertical-align: top; } th { background: #f1f3f6; }
td.number { white-space: nowrap; } .empty { width: 22%; } .change { width: 40%; } tr { break-inside: avoid; }
.tight { font-size: 8.8pt; line-height: 1.25; }
@media print { body { margin: 0; max-width: none; } a { color: inherit; text-decoration: none; } }
";

/// Every sheet: its file's name and its text. Fails on a lesson that is missing or has another shape.
pub fn pages(root: &Path) -> Result<Vec<(String, String)>, String> {
    let list = read(&root.join("experiments/experiments.csv"))?;
    let mut names = list.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    names.next().filter(|head| head.starts_with("folder,")).ok_or("experiments.csv: expected the column folder first")?;
    let mut pages = Vec::new();
    let mut links = String::new();
    for name in names.filter_map(|line| line.split(',').next()) {
        let text = read(&root.join(format!("docs/lessons/{name}.md")))?;
        let lesson = Lesson::read(&text).map_err(|problem| format!("docs/lessons/{name}.md: {problem}"))?;
        let title = escaped(lesson.title);
        let _ = writeln!(links, "<li><a href=\"{name}.html\">{title}</a> · <a href=\"{name}-answers.html\">answers</a></li>");
        pages.push((format!("{name}.html"), sheet(name, &lesson)));
        pages.push((format!("{name}-answers.html"), answers(&lesson)));
    }
    let body = format!(
        "<h1>Experiments</h1>\n<p>A page to print each, and one with its answers for the teacher.</p>\n<ol>\n{links}</ol>\n"
    );
    pages.push((INDEX.to_owned(), document("Experiments", &body)));
    Ok(pages)
}

/// Whether the keys of the sheets have that one.
pub fn is_key(name: &str) -> bool {
    KEYS.iter().any(|(keys, _)| keys.contains(&name))
}

/// Writes every sheet into the project's folder; returns their number.
pub fn write(root: &Path) -> Result<usize, String> {
    let (pages, folder) = (pages(root)?, root.join(FOLDER));
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    fs::create_dir_all(&folder).map_err(failed)?;
    for (name, text) in &pages {
        fs::write(folder.join(name), text).map_err(failed)?;
    }
    Ok(pages.len())
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn document(title: &str, body: &str) -> String {
    let title = escaped(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{title}</title>\n<style>{STYLE}</style>\n\
         </head>\n<body>\n{body}</body>\n</html>\n"
    )
}

/// The page of the class: the question, what to do and with which keys, and room for what is found.
fn sheet(name: &str, lesson: &Lesson) -> String {
    let mut body = format!("<h1>{}</h1>\n", escaped(lesson.title));
    body += "<p class=\"fields\"><span>Name</span><span>Class</span><span>Date</span></p>\n";
    let _ = writeln!(body, "<p class=\"question\">{}</p>", inline(lesson.question));
    let _ = writeln!(
        body,
        "<p class=\"where\">Menu → Lab → Experiments → {}, or <code>resultant play experiments/{name}</code></p>",
        escaped(lesson.title)
    );
    body += "<h2>Your guess, and why</h2>\n<div class=\"line\"></div>\n<div class=\"line\"></div>\n<h2>Do</h2>\n<ol>\n";
    for step in &lesson.steps {
        let _ = writeln!(body, "<li>{}</li>", inline(step));
    }
    body += "</ol>\n<div class=\"keys\">\n";
    for (keys, does) in KEYS {
        let keys: String = keys.iter().map(|key| format!("<kbd>{}</kbd> ", escaped(key))).collect();
        let _ = writeln!(body, "<div>{keys}{}</div>", escaped(does));
    }
    body += "</div>\n<h2>Found</h2>\n";
    // Two quantities a line: a sheet is one page.
    body += "<table class=\"tight\">\n<tr><th>quantity</th><th class=\"empty\">found</th><th>quantity</th><th class=\"empty\">found</th></tr>\n";
    let cell = |row: Option<&[&str; 2]>| format!("<td>{}</td><td></td>", row.map_or_else(String::new, |[what, _]| inline(what)));
    for pair in lesson.figures.chunks(2) {
        let _ = writeln!(body, "<tr>{}{}</tr>", cell(pair.first()), cell(pair.get(1)));
    }
    body += "</table>\n<p>Why?</p>\n<div class=\"line\"></div>\n<h2>Vary</h2>\n";
    let _ = writeln!(body, "<p class=\"small\">{VARY}</p>");
    body += &changes(lesson, "found", |_| String::new());
    document(lesson.title, &body)
}

const VARY: &str = "In flight: <kbd>I</kbd>, then <em>What if …</em> varies the level's gravity, air, friction and wind, and the mass, start \
    velocity, restitution and drag of the object that is followed (<kbd>N</kbd>). The table names changes of a copy of the level, in the editor \
    or in its files.";

/// The table of changes; `answer` writes its last column.
fn changes(lesson: &Lesson, head: &str, answer: impl Fn(&str) -> String) -> String {
    let mut table = format!(
        "<table class=\"tight\">\n<tr><th class=\"change\">change</th><th>what then</th><th class=\"empty\">{head}</th></tr>\n"
    );
    for (i, [change, what, exact]) in lesson.changes.iter().enumerate() {
        let rows = 1 + lesson.changes[i + 1..].iter().take_while(|[change, ..]| change.is_empty()).count();
        let change = if change.is_empty() { String::new() } else { format!("<td rowspan=\"{rows}\">{}</td>", inline(change)) };
        let _ = writeln!(table, "<tr>{change}<td>{}</td><td class=\"number\">{}</td></tr>", inline(what), answer(exact));
    }
    table + "</table>\n"
}

/// The teacher's page.
fn answers(lesson: &Lesson) -> String {
    let mut body = format!("<h1>{}: answers</h1>\n", escaped(lesson.title));
    let _ = writeln!(body, "<p class=\"question\">{}</p>\n<h2>Exact answer</h2>", inline(lesson.question));
    for paragraph in &lesson.answer {
        let _ = writeln!(body, "<p>{}</p>", inline(paragraph));
    }
    body += "<table>\n<tr><th>quantity</th><th class=\"empty\">exact answer</th></tr>\n";
    for [what, exact] in &lesson.figures {
        let _ = writeln!(body, "<tr><td>{}</td><td class=\"number\">{}</td></tr>", inline(what), inline(exact));
    }
    body += "</table>\n<h2>Vary</h2>\n";
    body += &changes(lesson, "exact answer", inline);
    body += "<h2>For the teacher</h2>\n";
    for paragraph in &lesson.teacher {
        let _ = writeln!(body, "<p>{}</p>", inline(paragraph));
    }
    document(&format!("{}: answers", lesson.title), &body)
}
