//! Links into the game, as a page's address has them behind `#`: `play=experiments/friction&follow=Box+1&details=1`, `play=2`,
//! `lab=stress-tests`.

use crate::files;
use crate::level::judge_name;
use crate::screens::screen::{PAGES, Page};
use crate::words::tr;

/// A link with more characters is none of this game's.
const LONGEST: usize = 500;
const EXPERIMENTS: &str = "experiments/";

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LinkTarget {
    Level(String),
    Experiment(String),
    Lab(Page),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PageLink {
    pub target: LinkTarget,
    /// The title of the body that the details are about, as the game writes it.
    pub follow: Option<String>,
    pub details: Option<bool>,
}

impl PageLink {
    /// # Errors
    /// The fault of the link, in words.
    pub fn parse(text: &str) -> Result<Self, String> {
        if text.chars().count() > LONGEST {
            return Err(tr!("found more than {most} characters, expected a link of this game", most = LONGEST));
        }
        let (mut target, mut follow, mut details) = (None, None, None);
        for part in text.split('&').filter(|part| !part.is_empty()) {
            let (name, value) = part.split_once('=').unwrap_or((part, ""));
            let value = decoded(value).ok_or_else(|| bad(name, value, tr("letters as addresses have them")))?;
            match name {
                "play" => target = Some(played(&value)?),
                "lab" => target = Some(LinkTarget::Lab(page(&value)?)),
                "follow" => follow = Some(value).filter(|value| !value.is_empty()),
                "details" => match value.as_str() {
                    "0" | "1" => details = Some(value == "1"),
                    _ => return Err(bad("details", &value, tr("0 or 1"))),
                },
                _ => {
                    return Err(tr!("found {found}, expected play, lab, follow or details", found = format_args!("{name:?}")));
                }
            }
        }
        let target = target.ok_or(tr("found neither play nor lab, expected one of them, such as play=1"))?;
        Ok(Self { target, follow, details })
    }
}

pub fn bad(part: &str, value: &str, expected: &str) -> String {
    files::found_instead(part, format_args!("{value:?}"), expected)
}

/// A level's name stays below the folder of levels.
fn played(value: &str) -> Result<LinkTarget, String> {
    let (name, experiment) = value.strip_prefix(EXPERIMENTS).map_or((value, false), |name| (name, true));
    let number = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_digit());
    if !number && judge_name(name).is_err() {
        return Err(bad("play", value, tr("a level's name or experiments/NAME")));
    }
    Ok(if experiment { LinkTarget::Experiment(name.to_owned()) } else { LinkTarget::Level(name.to_owned()) })
}

/// A tab's words in small letters, with hyphens.
fn page(value: &str) -> Result<Page, String> {
    let named = |words: &str| words.to_lowercase().replace(' ', "-");
    let found = PAGES.iter().find(|(_, words)| named(words) == value).map(|(page, _)| *page);
    let known: Vec<String> = PAGES.iter().map(|(_, words)| named(words)).collect();
    found.ok_or_else(|| bad("lab", value, &known.join(", ")))
}

/// With `+` for a space and `%` before two hexadecimal digits; `None` where that is no text.
fn decoded(text: &str) -> Option<String> {
    let (mut bytes, mut rest) = (Vec::new(), text.bytes());
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'+' => b' ',
            b'%' => {
                let digits = [rest.next()?, rest.next()?];
                u8::from_str_radix(str::from_utf8(&digits).ok()?, 16).ok()?
            }
            other => other,
        });
    }
    String::from_utf8(bytes).ok().filter(|text| !text.chars().any(char::is_control))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_is_read_as_an_address_has_it() {
        let link = PageLink::parse("play=experiments/friction&follow=Box+1&details=1").unwrap();
        let friction = LinkTarget::Experiment("friction".to_owned());
        assert_eq!(link, PageLink { target: friction, follow: Some("Box 1".to_owned()), details: Some(true) });
        assert_eq!(PageLink::parse("play=2").unwrap().target, LinkTarget::Level("2".to_owned()));
        assert_eq!(PageLink::parse("play=H%C3%B6hle&").unwrap().target, LinkTarget::Level("Höhle".to_owned()));
        assert_eq!(PageLink::parse("lab=side-by-side").unwrap().target, LinkTarget::Lab(Page::SideBySide));
    }

    #[test]
    fn a_foreign_or_damaged_link_is_refused_in_words() {
        for (link, problem) in [
            ("", "found neither play nor lab"),
            ("details=1", "found neither play nor lab"),
            ("play=", "play: found \"\""),
            ("play=../../etc", "play: found \"../../etc\""),
            ("play=experiments/../levels/1", "play: found"),
            ("play=a%2Fb", "play: found \"a/b\""),
            ("play=%zz", "play: found \"%zz\", expected letters"),
            ("play=%f", "expected letters"),
            ("play=%ff", "expected letters"),
            ("play=1&details=yes", "details: found \"yes\", expected 0 or 1"),
            ("lab=kitchen", "lab: found \"kitchen\", expected overview, "),
            ("utm_source=x&play=1", "found \"utm_source\", expected play"),
            (&"x".repeat(501), "found more than 500 characters"),
        ] {
            let refused = PageLink::parse(link).unwrap_err();
            assert!(refused.contains(problem), "{link}: {refused}");
        }
    }
}
