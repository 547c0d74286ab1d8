//! A lesson's text, in the part of Markdown that lessons use.

use super::{SheetWords, is_key};

/// The texts of a lesson.
pub struct Lesson<'a> {
    pub title: &'a str,
    pub question: &'a str,
    pub plan: Plan<'a>,
    /// Its section "Do".
    pub steps: Vec<&'a str>,
    /// Paragraphs of its section "Exact answer".
    pub answer: Vec<&'a str>,
    /// A quantity and its exact answer, with its unit.
    pub figures: Vec<[&'a str; 2]>,
    /// A change, a quantity, and its exact answer; an empty change is that of the row before.
    pub changes: Vec<[&'a str; 3]>,
    /// What pupils may expect that is not so.
    pub misconceptions: Vec<&'a str>,
    /// Paragraphs of its section "For the teacher".
    pub teacher: Vec<&'a str>,
}

/// What a teacher asks before a lesson.
pub struct Plan<'a> {
    pub topic: &'a str,
    /// Years, as in `13–15`.
    pub age: &'a str,
    pub minutes: &'a str,
    /// What pupils know before.
    pub needed: &'a str,
    /// A place in the curricula of England, Germany and France, each in its language.
    pub curricula: [&'a str; 3],
}

impl<'a> Plan<'a> {
    fn read(section: &'a str) -> Result<Self, String> {
        let rows = table::<2>(section)?;
        let cell = |name: &str| {
            let found = rows.iter().find(|[key, _]| *key == name).map(|[_, value]| *value);
            found.ok_or_else(|| format!("expected a row {name} in \"## Plan\""))
        };
        Ok(Self {
            topic: cell("topic")?,
            age: cell("age")?,
            minutes: cell("minutes")?,
            needed: cell("needed")?,
            curricula: [cell("England")?, cell("Deutschland")?, cell("France")?],
        })
    }
}

impl<'a> Lesson<'a> {
    /// `readings` is the experiment's cell of that name. The error names the missing part.
    pub fn read(text: &'a str, readings: &'a str) -> Result<Self, String> {
        let mut sections = text.split("\n## ");
        let head = sections.next().unwrap_or_default();
        let sections: Vec<(&str, &str)> = sections.filter_map(|section| section.split_once('\n')).collect();
        let section = |name: &str| {
            let found = sections.iter().find(|(title, _)| *title == name).map(|(_, text)| *text);
            found.ok_or_else(|| format!("expected a section \"## {name}\""))
        };
        let title = head.lines().find_map(|line| line.strip_prefix("# ")).ok_or("expected a title \"# …\"")?;
        let question = head.lines().find_map(|line| line.strip_prefix("**Question.** ")).ok_or("expected \"**Question.** …\"")?;
        let steps: Vec<&str> = section("Do")?.lines().filter_map(|line| Some(line.split_once(". ")?.1)).collect();
        if steps.is_empty() {
            return Err("expected numbered steps in \"## Do\"".to_owned());
        }
        Ok(Self {
            title,
            question,
            plan: Plan::read(section("Plan")?)?,
            steps,
            answer: paragraphs(section("Exact answer")?),
            figures: figures(readings)?,
            changes: table(section("Vary")?)?,
            misconceptions: section("Misconceptions")?.lines().filter_map(|line| line.strip_prefix("- ")).collect(),
            teacher: paragraphs(section("For the teacher")?),
        })
    }
}

/// Quantities with their exact answers, parted by `|`, as in `e = 0.5, height: 2.50 m`.
pub fn figures(readings: &str) -> Result<Vec<[&str; 2]>, String> {
    let parts = readings.split('|').filter(|part| !part.is_empty());
    let figure = |part: &'_ str| format!("expected QUANTITY: VALUE in {part:?}");
    parts.map(|part| part.rsplit_once(": ").map(<[&str; 2]>::from).ok_or_else(|| figure(part))).collect()
}

fn paragraphs(section: &str) -> Vec<&str> {
    section.lines().filter(|line| !line.is_empty() && !line.starts_with('|')).collect()
}

/// The rows of a section's table below its head.
fn table<const N: usize>(section: &str) -> Result<Vec<[&str; N]>, String> {
    let rows = section.lines().filter_map(|line| line.strip_prefix('|')?.strip_suffix('|')).skip(2);
    let cells = |row: &str| format!("expected {N} cells in |{row}|");
    let rows: Result<Vec<[&str; N]>, String> =
        rows.map(|row| row.split('|').map(str::trim).collect::<Vec<_>>().try_into().map_err(|_| cells(row))).collect();
    rows.and_then(|rows| if rows.is_empty() { Err("expected a table with rows".to_owned()) } else { Ok(rows) })
}

pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// `code` and *stress* as HTML; a code that is the name of a key looks like one.
pub fn inline(words: &SheetWords, text: &str) -> String {
    let part = |(i, part): (usize, &str)| match i % 2 {
        0 => stressed(part),
        _ if is_key(part) => key(words, part),
        _ => format!("<code>{part}</code>"),
    };
    escaped(text).split('`').enumerate().map(part).collect()
}

/// A key as it is named in the language; a sign is the same in all.
pub fn key(words: &SheetWords, name: &str) -> String {
    format!("<kbd>{}</kbd>", if name.chars().count() == 1 { name } else { words.say(name) })
}

fn stressed(text: &str) -> String {
    let part = |(i, part): (usize, &str)| if i % 2 == 1 { format!("<em>{part}</em>") } else { part.to_owned() };
    text.split('*').enumerate().map(part).collect()
}
