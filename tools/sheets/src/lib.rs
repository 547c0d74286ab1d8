//! Sheets for lessons as HTML to be printed: of each experiment a page for the class, and one with its answers. The texts are those of
//! `docs/lessons`, the order is that of their `experiments.csv`; the keys, which all sheets share, stand here. English pages lie in the
//! folder itself, those of each other language in one of its own.

mod by_hand;
mod text;
mod words;

use std::collections::HashMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;
pub use text::{Lesson, Plan, figures};
use text::{escaped, inline};
use words::{LANGUAGES, SheetWords};

/// The levels of the experiments and their list, from the project's root.
const EXPERIMENTS: &str = "levels/experiments";

/// The folder of the sheets in the project, and in what players get.
pub const FOLDER: &str = "docs/sheets";
/// The list of all sheets.
const INDEX: &str = "index.html";
/// The page that lists all lessons, behind a mark.
pub const LESSONS: &str = "docs/lessons/README.md";
const LISTED: &str = "<!-- list -->\n";

/// Keys of an experiment, and what they do.
pub const KEYS: [(&[&str], &str); 14] = [
    (&["Enter"], "opens the experiment"),
    (&["Tab"], "details: forces and numbers"),
    (&["K"], "the forces on one body, as in a textbook"),
    (&["L"], "your sheet: prediction, readings, answer"),
    (&["N"], "the next object; or click one"),
    (&["Shift"], "and a click: compares a second object"),
    (&["B"], "starts it, stops time, lets it go on"),
    (&[".", ","], "a tick on, a tick back"),
    (&["[", "]"], "slower, faster"),
    (&["+", "−"], "zoom; or the wheel"),
    (&["F"], "everything that moves in view"),
    (&["I"], "instruments: plot, ruler, energy, what if"),
    (&["R"], "back to its start"),
    (&["Esc"], "pause, and back to the experiments"),
];

const STYLE: &str = "
@page { size: A4; margin: 11mm 14mm; }
body { font: 10pt/1.32 'Liberation Sans', Arial, Helvetica, sans-serif; color: #111; background: #fff;
  max-width: 180mm; margin: 8mm auto; }
h1 { font-size: 19pt; margin: 0 0 1mm; } h2 { font-size: 11.5pt; margin: 2.6mm 0 .8mm; border-bottom: 1px solid #888; }
p, ol, ul { margin: 1mm 0; } ol, ul { padding-left: 6mm; } li { margin-bottom: .8mm; }
.question { font-size: 12.5pt; } .where, .small { color: #444; font-size: 9pt; }
.fields { display: flex; gap: 8mm; margin: 0 0 2mm; color: #444; } .fields span { flex: 1; border-bottom: 1px solid #888; }
.line { border-bottom: 1px dotted #888; height: 6.4mm; } .predict { border-bottom: 1px dotted #888; display: inline-block; width: 60mm; text-align: right; }
.keys { columns: 3; font-size: 8.5pt; margin: 1mm 0; padding: 1.5mm 2mm; background: #f1f3f6; } .keys div { break-inside: avoid; }
kbd { font: bold .92em 'Liberation Mono', Consolas, monospace; border: 1px solid #777; border-radius: 2px; padding: 0 1mm; background: #fff; }
code { font: .94em 'Liberation Mono', Consolas, monospace; }
table { border-collapse: collapse; width: 100%; margin: 1mm 0; }
th, td { border: 1px solid #999; padding: .5mm 1.6mm; text-align: left; vertical-align: top; } th { background: #f1f3f6; }
td.number { white-space: nowrap; } .empty { width: 22%; } .change { width: 40%; } tr { break-inside: avoid; }
.tight { font-size: 8.8pt; line-height: 1.25; } .plan th { width: 32mm; } .list td:nth-child(4) { width: 36%; }
@media print { body { margin: 0; max-width: none; } a { color: inherit; text-decoration: none; } }
";

/// Every sheet in every language: its file's name and its text; with links into the game where its page lies two folders above. Fails
/// on a lesson that is missing or has another shape, and on a language that lacks a text of a lesson or has one too many.
pub fn pages(root: &Path, linked: bool) -> Result<Vec<(String, String)>, String> {
    let mut pages = Vec::new();
    for (code, _) in LANGUAGES {
        pages_in(&SheetWords::read(root, code)?, root, linked, &mut pages)?;
    }
    Ok(pages)
}

/// The list of all lessons by topic, in Markdown, behind what it has in front of its mark.
pub fn lessons(root: &Path) -> Result<String, String> {
    let text = read(&root.join(LESSONS))?;
    let (before, _) = text.split_once(LISTED).ok_or_else(|| format!("{LESSONS}: expected {LISTED:?}"))?;
    let mut topics: Vec<(String, String)> = Vec::new();
    for Listed { folder, readings, .. } in &listed(root)? {
        let (file, text) = lesson_text(root, folder)?;
        let Lesson { title, plan, .. } = Lesson::read(&text, readings).map_err(|problem| format!("{file}: {problem}"))?;
        let Plan { topic, age, minutes, needed, curricula: [england, ..] } = plan;
        let row = format!("| [{title}]({folder}.md) | {age} | {minutes} | {needed} | {england} | `#play=experiments/{folder}` |\n");
        topic_of(&mut topics, topic).push_str(&row);
    }
    let head = "| lesson | age | minutes | needed | curriculum | link |\n|---|---|---|---|---|---|\n";
    let tables = topics.iter().map(|(topic, rows)| format!("\n## {topic}\n\n{head}{rows}"));
    Ok(format!("{before}{LISTED}{}", tables.collect::<String>()))
}

/// Writes that list.
pub fn write_lessons(root: &Path) -> Result<(), String> {
    let text = lessons(root)?;
    fs::write(root.join(LESSONS), text).map_err(|error| format!("{LESSONS}: {error}"))
}

/// What is collected below a topic; topics stay in the order of their first lessons.
fn topic_of<'a>(topics: &'a mut Vec<(String, String)>, topic: &str) -> &'a mut String {
    let at = topics.iter().position(|(name, _)| name == topic).unwrap_or_else(|| {
        topics.push((topic.to_owned(), String::new()));
        topics.len() - 1
    });
    &mut topics[at].1
}

fn lesson_text(root: &Path, folder: &str) -> Result<(String, String), String> {
    let file = format!("docs/lessons/{folder}.md");
    let text = read(&root.join(&file))?;
    Ok((file, text))
}

/// An experiment as the list has it: what its screen asks, its page asks in the same words.
pub struct Listed {
    pub folder: String,
    pub question: String,
    /// Predictions to choose from, parted by `|`.
    pub choices: String,
    /// The right prediction: a choice, or a number with its unit.
    pub right: String,
    /// Quantities and their exact answers, see [`figures`].
    pub readings: String,
}

/// The experiments in the order of their sheets. Fails on a list that is missing or has another shape.
pub fn listed(root: &Path) -> Result<Vec<Listed>, String> {
    const LIST: &str = "experiments.csv";
    let list = read(&root.join(EXPERIMENTS).join(LIST))?;
    let reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(list.as_bytes());
    let rows = reader.into_deserialize::<HashMap<String, String>>();
    let listed = |mut row: HashMap<String, String>| {
        let [folder, question, choices, right, readings] =
            ["folder", "question", "choices", "right", "readings"].map(|column| row.remove(column));
        Some(Listed { folder: folder?, question: question?, choices: choices?, right: right?, readings: readings? })
    };
    rows.map(|row| row.map_err(|error| format!("{LIST}: {error}")))
        .map(|row| {
            listed(row?).ok_or_else(|| format!("{LIST}: expected the columns folder, question, choices, right and readings"))
        })
        .collect()
}

fn pages_in(words: &SheetWords, root: &Path, linked: bool, pages: &mut Vec<(String, String)>) -> Result<(), String> {
    let folder = words.folder();
    let mut topics = Vec::new();
    for asked @ Listed { folder: name, readings, .. } in &listed(root)? {
        let (file, text) = lesson_text(root, name)?;
        let lesson = Lesson::read(&text, readings).map_err(|problem| format!("{file}: {problem}"))?;
        let link = Some(opens(words, name)).filter(|_| linked).unwrap_or_default();
        let (title, answered) = (escaped(words.say(lesson.title)), words.say("answers"));
        let Plan { topic, age, minutes, needed, .. } = lesson.plan;
        let row = format!(
            "<tr><td><a href=\"{name}.html\">{title}</a> · <a href=\"{name}-answers.html\">{answered}</a></td><td class=\"number\">{age}</td>\
             <td class=\"number\">{minutes}</td><td>{}</td>{}</tr>\n",
            escaped(words.say(needed)),
            if linked { format!("<td>{link}</td>") } else { String::new() },
        );
        topic_of(&mut topics, words.say(topic)).push_str(&row);
        pages.push((
            format!("{folder}{name}.html"),
            sheet(words, root, asked, &lesson, &link).map_err(|problem| format!("{file}: {problem}"))?,
        ));
        pages.push((format!("{folder}{name}-answers.html"), answers(words, &lesson, &link)?));
        words.complete(&file)?;
    }
    let (title, about) = (words.say("Experiments"), words.say("A page to print each, and one with its answers for the teacher."));
    let head = ["experiment", "age", "minutes", "known before"].map(|cell| format!("<th>{}</th>", words.say(cell))).concat();
    let tables = topics.iter().map(|(topic, rows)| {
        format!(
            "<h2>{}</h2>\n<table class=\"list\">\n<tr>{head}{}</tr>\n{rows}</table>\n",
            escaped(topic),
            if linked { "<th></th>" } else { "" }
        )
    });
    let body = format!("{}<h1>{title}</h1>\n<p>{about}</p>\n{}", other_languages(words), tables.collect::<String>());
    pages.push((format!("{folder}{INDEX}"), document(words, title, &body)));
    words.complete(INDEX)?;
    words.used()
}

/// A link that opens an experiment in the game's page.
fn opens(words: &SheetWords, name: &str) -> String {
    let up = if words.folder().is_empty() { "" } else { "../" };
    format!("<a href=\"{up}../../index.html#play=experiments/{name}\">{}</a>", escaped(words.say("open it here")))
}

/// A line with the index of each language.
fn other_languages(words: &SheetWords) -> String {
    let up = if words.folder().is_empty() { "" } else { "../" };
    let link = |(code, name): (&str, &str)| match code {
        _ if code == words.code => name.to_owned(),
        "en" => format!("<a href=\"{up}{INDEX}\" lang=\"en\">{name}</a>"),
        _ => format!("<a href=\"{up}{code}/{INDEX}\" lang=\"{code}\">{name}</a>"),
    };
    format!("<p class=\"small\">{}</p>\n", LANGUAGES.map(link).join(" · "))
}

/// Whether the keys of the sheets have that one.
pub fn is_key(name: &str) -> bool {
    KEYS.iter().any(|(keys, _)| keys.contains(&name))
}

/// Writes every sheet into a folder; returns their number.
pub fn write(root: &Path, folder: &Path) -> Result<usize, String> {
    // The folder of the game's page has the sheets in `docs/sheets`.
    let page = folder.parent().and_then(Path::parent).map(|above| above.join("index.html"));
    let pages = pages(root, page.is_some_and(|page| page.is_file()))?;
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    for (name, text) in &pages {
        let file = folder.join(name);
        file.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&file, text)).map_err(failed)?;
    }
    Ok(pages.len())
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn document(words: &SheetWords, title: &str, body: &str) -> String {
    let (title, code) = (escaped(title), words.code);
    // French has a space before such a sign, where no line may end.
    let body = match code {
        "fr" => [" :", " ;", " ?", " !", " »", "« "]
            .iter()
            .fold(body.to_owned(), |b, sign| b.replace(sign, &sign.replace(' ', "\u{a0}"))),
        _ => body.to_owned(),
    };
    let body = words.decimals(&body);
    format!(
        "<!DOCTYPE html>\n<html lang=\"{code}\">\n<head>\n<meta charset=\"utf-8\">\n<title>{title}</title>\n<style>{STYLE}</style>\n\
         </head>\n<body>\n{body}</body>\n</html>\n"
    )
}

/// The page of the class: the question, what to do and with which keys, and room for what is found.
fn sheet(words: &SheetWords, root: &Path, asked: &Listed, lesson: &Lesson, link: &str) -> Result<String, String> {
    let name = &asked.folder;
    let say = |text| escaped(words.say(text));
    let title = say(lesson.title);
    let mut body = format!("<h1>{title}</h1>\n");
    let fields = ["Name", "Class", "Date"].map(|field| format!("<span>{}</span>", say(field))).concat();
    let _ = writeln!(body, "<p class=\"fields\">{fields}</p>");
    let _ = writeln!(body, "<p class=\"question\">{}</p>", inline(words, words.say(lesson.question)));
    let menu = ["Menu", "Lab", "Experiments"].map(say).join(" → ");
    let link = if link.is_empty() { String::new() } else { format!(" · {link}") };
    let or = say("or");
    let _ = writeln!(body, "<p class=\"where\">{menu} → {title}, {or} <code>resultant play experiments/{name}</code>{link}</p>");
    let _ = write!(body, "{}<h2>{}</h2>\n<ol>\n", prediction(words, asked), say("Do"));
    for step in &lesson.steps {
        let _ = writeln!(body, "<li>{}</li>", inline(words, words.say(step)));
    }
    body += "</ol>\n<div class=\"keys\">\n";
    for (keys, does) in KEYS {
        let keys: String = keys.iter().map(|key| format!("{} ", text::key(words, &escaped(key)))).collect();
        let _ = writeln!(body, "<div>{keys}{}</div>", say(does));
    }
    let _ = write!(body, "</div>\n<h2>{}</h2>\n{}", say("Found"), found(words, lesson));
    let _ = write!(body, "<p>{}</p>\n{LINE}<h2>{}</h2>\n", say("Why?"), say("Vary"));
    let _ = writeln!(body, "<p class=\"small\">{}</p>", inline(words, words.say(VARY)));
    let by_hand = |change: &str| by_hand::by_hand(words, root, name, change).map(|change| inline(words, &change));
    body += &changes(words, lesson, "found", by_hand, |_| String::new())?;
    Ok(document(words, words.say(lesson.title), &body))
}

/// The question of the screen, with choices to tick or room for a number with its unit, and for the reason.
fn prediction(words: &SheetWords, asked: &Listed) -> String {
    let say = |text| escaped(words.say(text));
    let unit = asked.right.split_once(' ').map_or("", |(_, unit)| unit);
    let room = match asked.choices.split('|').collect::<Vec<_>>()[..] {
        [_] | [] => format!("<span class=\"predict\">{}</span>", escaped(unit)),
        ref choices => choices.iter().map(|choice| format!("☐ {} &emsp; ", escaped(&words.quantity(choice)))).collect(),
    };
    let question = inline(words, words.say(&asked.question));
    format!("<h2>{}</h2>\n<p>{question}</p>\n<p>{room}</p>\n<p>{}</p>\n{LINE}", say("Your prediction"), say("Why?"))
}

/// A line to write on.
const LINE: &str = "<div class=\"line\"></div>\n";

const VARY: &str = "In flight: `I`, then *What if …* makes each of these changes: for the object that is followed (`N`), or at *Level and things* \
    for the rest. Heights are those above the lower edge of the level. The run before stays as a ghost.";

/// The table of what is found, with units: two quantities a line, since a sheet is one page.
fn found(words: &SheetWords, lesson: &Lesson) -> String {
    let head = format!("<th>{}</th><th class=\"empty\">{}</th>", escaped(words.say("quantity")), escaped(words.say("found")));
    let mut table = format!("<table class=\"tight\">\n<tr>{head}{head}</tr>\n");
    let wanted = |[what, exact]: &[&str; 2]| {
        let unit = exact.split_once(' ').map_or_else(String::new, |(_, unit)| format!(" ({unit})"));
        inline(words, &words.quantity(what)) + &escaped(&unit)
    };
    let cell = |row: Option<&[&str; 2]>| format!("<td>{}</td><td></td>", row.map_or_else(String::new, wanted));
    for pair in lesson.figures.chunks(2) {
        let _ = writeln!(table, "<tr>{}{}</tr>", cell(pair.first()), cell(pair.get(1)));
    }
    table + "</table>\n"
}

/// The table of changes; `written` writes its first column, `answer` its last one.
fn changes(
    words: &SheetWords,
    lesson: &Lesson,
    head: &str,
    written: impl Fn(&str) -> Result<String, String>,
    answer: impl Fn(&str) -> String,
) -> Result<String, String> {
    let [change, what, head] = ["change", "what then", head].map(|text| escaped(words.say(text)));
    let mut table = format!(
        "<table class=\"tight\">\n<tr><th class=\"change\">{change}</th><th>{what}</th><th class=\"empty\">{head}</th></tr>\n"
    );
    for (i, [change, what, exact]) in lesson.changes.iter().enumerate() {
        let rows = 1 + lesson.changes[i + 1..].iter().take_while(|[change, ..]| change.is_empty()).count();
        let change = match *change {
            "" => String::new(),
            change => format!("<td rowspan=\"{rows}\">{}</td>", written(change)?),
        };
        let what = inline(words, &words.quantity(what));
        let _ = writeln!(table, "<tr>{change}<td>{what}</td><td class=\"number\">{}</td></tr>", answer(exact));
    }
    Ok(table + "</table>\n")
}

/// The plan of a lesson, a line a fact.
fn plan(words: &SheetWords, plan: &Plan, link: &str) -> String {
    let own = LANGUAGES.iter().position(|(code, _)| *code == words.code).unwrap_or_default();
    let facts = [
        ("age", plan.age),
        ("minutes", plan.minutes),
        ("known before", words.say(plan.needed)),
        ("needed", words.say("a computer for two, a sheet each")),
        ("curriculum", plan.curricula[own]),
    ];
    let rows = facts.map(|(name, fact)| format!("<tr><th>{}</th><td>{}</td></tr>\n", escaped(words.say(name)), escaped(fact)));
    format!("<table class=\"tight plan\">\n{}</table>\n<p class=\"small\">{link}</p>\n", rows.concat())
}

/// The teacher's page.
fn answers(words: &SheetWords, lesson: &Lesson, link: &str) -> Result<String, String> {
    let say = |text| escaped(words.say(text));
    let title = words.say("{title}: answers").replace("{title}", words.say(lesson.title));
    let mut body = format!("<h1>{}</h1>\n", escaped(&title));
    let question = inline(words, words.say(lesson.question));
    let _ = writeln!(body, "<p class=\"question\">{question}</p>");
    let _ = writeln!(body, "{}<h2>{}</h2>", plan(words, &lesson.plan, link), say("Exact answer"));
    let paragraphs = |paragraphs: &[&str]| -> String {
        paragraphs.iter().map(|paragraph| format!("<p>{}</p>\n", inline(words, words.say(paragraph)))).collect()
    };
    body += &paragraphs(&lesson.answer);
    let (quantity, exact) = (say("quantity"), say("exact answer"));
    let _ = writeln!(body, "<table>\n<tr><th>{quantity}</th><th class=\"empty\">{exact}</th></tr>");
    for [what, exact] in &lesson.figures {
        let what = inline(words, &words.quantity(what));
        let _ = writeln!(body, "<tr><td>{what}</td><td class=\"number\">{}</td></tr>", inline(words, exact));
    }
    let _ = writeln!(body, "</table>\n<h2>{}</h2>", say("Vary"));
    let written = |change: &str| Ok(inline(words, &words.change(change)));
    body += &changes(words, lesson, "exact answer", written, |exact| inline(words, exact))?;
    let expected: String =
        lesson.misconceptions.iter().map(|text| format!("<li>{}</li>\n", inline(words, words.say(text)))).collect();
    let _ = writeln!(body, "<h2>{}</h2>\n<ul>\n{expected}</ul>", say("Misconceptions that pupils may have"));
    let _ = writeln!(body, "<h2>{}</h2>", say("For the teacher"));
    body += &paragraphs(&lesson.teacher);
    Ok(document(words, &title, &body))
}
