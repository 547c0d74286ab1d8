//! Where a request leads: what is read before, and the screen that opens. Links into the game, as a page's address has them behind `#`:
//! `play=experiments/friction&follow=Box+1&details=1`, `play=2`, `lab=stress-tests`.

use super::screen::{Classic, Destination, PAGES, Page, Purpose, Screen};
#[cfg(all(feature = "window", browser))]
use super::settings;
use super::{boards, editor::Editor, flight::Flight, scoring::Scoring};
use super::{boards::flights::Flights, classics::jumper::Jumper, classics::tile_run::TileRun, lab::Lab, settings::SettingsPanel};
use super::{classics::Classics, classics::pi::Pi, levels::LevelSelect, menu::Menu, menu::credits::Credits, players::PlayerList};
use crate::level::{self, judge_name};
use crate::session::library::{Attempt, is_of_level, named};
use crate::session::{Session, recordings::FlightSource, worker::Errand};
use crate::{classics::jumper::LEADERBOARD, files, game::body_title, physics::BodyId, ui::Spectator, words::tr};
use std::path::Path;

/// What is to be read before a place opens, with its name in words.
pub(super) fn reading(place: &Destination, session: &mut Session) -> Option<(Errand, String)> {
    let name = match place {
        Destination::Play(name) => {
            session.library.close();
            name.clone()
        }
        // Of a level that comes with the game a copy is made first.
        Destination::Edit { name, original } if *original || !level::is_shipped(&session.library.folder(name)) => {
            let root = session.library.root().to_path_buf();
            return Some((Errand::Editor(session.library.folder(name), root), named(name)));
        }
        // What was just flown is there.
        Destination::Watch(_, candidate) if candidate.source == FlightSource::Flown => return None,
        Destination::Flights(visit) | Destination::Race(visit, _) | Destination::Watch(visit, _) => visit.level.clone(),
        Destination::Board(visit) if visit.level != LEADERBOARD => visit.level.clone(),
        Destination::Experiment(name) => session.library.open(&session.library.experiment(name))?,
        Destination::Dropped(path) if is_of_level(path) => session.library.open(path)?,
        Destination::Dropped(path) => {
            let levels = session.library.levels().to_path_buf();
            let errand = Errand::Install { archive: path.clone(), levels, root: session.library.root().to_path_buf() };
            return Some((errand, path.file_name().unwrap_or_default().to_string_lossy().into_owned()));
        }
        _ => return None,
    };
    Some((session.level_errand(&name), named(&name)))
}

/// The screen of a place, or one that says why it cannot be had; an error is said by the screen that asked.
pub(super) fn open(place: Destination, session: &mut Session, spectator: &mut dyn Spectator) -> Result<Box<dyn Screen>, String> {
    Ok(match place {
        Destination::Menu => Box::new(Menu::open(session)),
        Destination::Levels(purpose) => Box::new(LevelSelect::open(purpose, session)),
        Destination::Play(name) => {
            session.library.close();
            match session.library.load(&name) {
                Ok(level) => fly(Attempt::by_hand(level), session, spectator),
                Err(refusal) => Box::new(LevelSelect::refused(&name, refusal, session)),
            }
        }
        Destination::Fly(attempt) => fly(attempt, session, spectator),
        Destination::TryOut { level, problems, in_memory, on } => {
            let flight = Flight::test((level, in_memory), (problems, on), session, spectator);
            Box::new(flight.map_err(|error| error.to_string())?)
        }
        Destination::Edit { name, original } if !original && level::is_shipped(&session.library.folder(&name)) => {
            Box::new(LevelSelect::asking_for_copy(&name, session))
        }
        Destination::Edit { name, .. } => match Editor::take_up(&name, session) {
            Ok(editor) => Box::new(editor),
            Err(problem) => {
                let heading = tr!("Level {name} cannot be edited", name);
                Box::new(LevelSelect::with_panel(Purpose::Edit, heading, vec![problem], session))
            }
        },
        Destination::Score(finished) => Box::new(Scoring::open(*finished, session)),
        Destination::Board(visit) => match boards::open(visit, session) {
            Ok(board) => Box::new(board),
            Err((subject, error)) => {
                let heading = tr!("The scores of {subject} cannot be read", subject);
                Box::new(LevelSelect::with_panel(Purpose::Leaderboard, heading, vec![error], session))
            }
        },
        Destination::Flights(visit) => match session.library.load(&visit.level) {
            Ok(level) => Box::new(Flights::open(visit, &level, session)),
            Err(refusal) => Box::new(LevelSelect::refused(&visit.level, refusal, session)),
        },
        Destination::Watch(visit, candidate) => {
            let (title, reel) = session.reel(&visit, &candidate)?;
            Box::new(Flight::watch(title, reel, spectator))
        }
        Destination::Race(visit, candidates) => fly(session.race(&visit, &candidates)?, session, spectator),
        Destination::Players => Box::new(PlayerList::open(session)),
        Destination::Credits => Box::new(Credits::default()),
        Destination::Settings => Box::new(SettingsPanel::new(session.settings, session.settings_problems.clone())),
        Destination::Classics(left) => Box::new(Classics::new(left, None)),
        Destination::Classic(Classic::TileRun) => match session.library.tile_run() {
            Ok((map, commands)) => Box::new(TileRun::new(map, commands)),
            Err(problem) => Box::new(Classics::new(Some(Classic::TileRun), Some(problem))),
        },
        Destination::Classic(Classic::Jumper) => Box::new(Jumper::default()),
        Destination::Classic(Classic::Pi) => Box::new(Pi::default()),
        Destination::Climbed(scene) => Box::new(Jumper::ended(*scene, session)),
        Destination::Lab(left) => Box::new(Lab::new(session.library.charts(), session.library.experiments(), left.as_deref())),
        Destination::Experiment(name) => fly_folder(&session.library.experiment(&name), session, spectator),
        Destination::Dropped(path) if is_of_level(&path) => fly_folder(&path, session, spectator),
        Destination::Dropped(path) => Box::new(LevelSelect::installed(&path, session)),
        Destination::Link(text) => match PageLink::parse(&text).and_then(|link| follow(link, session, spectator)) {
            Ok(screen) => screen,
            Err(problem) => {
                let heading = tr("This link cannot be followed").to_owned();
                Box::new(LevelSelect::with_panel(Purpose::Play, heading, vec![problem], session))
            }
        },
        #[cfg(all(feature = "window", browser))]
        Destination::PageData => Box::new(settings::page_data::PageData::default()),
    })
}

/// An attempt at a level, or the list of levels with why it cannot be flown.
fn fly(attempt: Attempt, session: &mut Session, spectator: &mut dyn Spectator) -> Box<dyn Screen> {
    let name = attempt.level.name.clone();
    match Flight::open(attempt, session, spectator) {
        Ok(flight) => Box::new(flight),
        Err(error) => Box::new(LevelSelect::refused(&name, vec![error.to_string()], session)),
    }
}

fn fly_folder(path: &Path, session: &mut Session, spectator: &mut dyn Spectator) -> Box<dyn Screen> {
    let (heading, problems) = match session.library.open(path) {
        Some(name) => match session.library.load(&name) {
            Ok(level) => return fly(Attempt::by_hand(level), session, spectator),
            Err(refusal) => (tr!("Level {name} does not load", name), refusal),
        },
        None => (tr("There is no such level").to_owned(), vec![path.display().to_string()]),
    };
    Box::new(LevelSelect::with_panel(Purpose::Play, heading, problems, session))
}

fn follow(link: PageLink, session: &mut Session, spectator: &mut dyn Spectator) -> Result<Box<dyn Screen>, String> {
    let (name, folder) = match link.target {
        LinkTarget::Lab(page) => {
            let mut lab = Lab::new(session.library.charts(), session.library.experiments(), None);
            lab.turn_to(page);
            return Ok(Box::new(lab));
        }
        LinkTarget::Level(name) => {
            session.library.close();
            let folder = session.library.folder(&name);
            (name, folder)
        }
        LinkTarget::Experiment(name) => {
            let folder = session.library.experiment(&name);
            (name, folder)
        }
    };
    if !files::is_folder(&folder) {
        return Err(bad("play", &name, tr("a level that is there")));
    }
    let mut screen = fly_folder(&folder, session, spectator);
    if let Some(flight) = screen.get_mut::<Flight>() {
        let level = flight.game().level();
        let mut bodies = (0..flight.game().world().bodies().len() as u32).map(BodyId);
        let of_title = |title: &String| {
            let found = bodies.find(|body| body_title(level, *body).eq_ignore_ascii_case(title));
            found.ok_or_else(|| bad("follow", title, tr("the title of a body of this level")))
        };
        let body = link.follow.as_ref().map(of_title).transpose()?;
        flight.show_as(body, link.details);
    }
    Ok(screen)
}

/// A link with more characters is none of this game's.
const LONGEST: usize = 500;
/// Before an experiment's name: links name folders below that of the levels, as the command line does.
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
    use crate::draw::layout::Frame;
    use crate::screens::screen::{Page, Request};
    use crate::screens::stack::Stack;
    use crate::session::Places;

    fn follow(stack: &mut Stack, link: &str) {
        stack.grant(Request::Reset(Destination::Link(link.to_owned())), &mut ());
    }

    #[test]
    fn a_link_opens_its_target_or_says_why_not() {
        let (root, scores) = (Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf(), tempfile::tempdir().unwrap());
        let (own, settings) = (scores.path().to_path_buf(), scores.path().join("settings.csv"));
        let mut stack = Stack::new(Places { levels: root.join("levels"), root, scores: own, settings });
        follow(&mut stack, "play=experiments/friction&follow=box+1&details=0");
        let flight = stack.screen().get::<Flight>().unwrap();
        assert_eq!(flight.game().level().name, "friction");
        assert!(!stack.screen().scene(&Frame::default()).unwrap().overlays.details);
        assert_eq!(flight.observer().focus().followed, Some(BodyId(1)));
        follow(&mut stack, "play=1");
        assert_eq!(stack.screen().get::<Flight>().unwrap().game().level().name, "1");
        follow(&mut stack, "lab=stress-tests");
        assert_eq!(stack.screen().get::<Lab>().unwrap().page, Page::Survival);
        for link in ["play=nowhere", "play=experiments/nowhere", "nonsense"] {
            follow(&mut stack, link);
            assert!(stack.screen().is::<LevelSelect>(), "{link}");
        }
    }

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
