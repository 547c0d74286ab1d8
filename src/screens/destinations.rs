//! Where a request leads: what is read before, and the screen that opens.

use super::boards;
use super::boards::flights::Flights;
use super::classics::Classics;
use super::classics::jumper::Jumper;
use super::classics::pi::Pi;
use super::classics::tile_run::TileRun;
use super::editor::Editor;
use super::flight::Flight;
use super::lab::Lab;
use super::levels::LevelSelect;
use super::menu::Menu;
use super::menu::credits::Credits;
use super::menu::link::{LinkTarget, PageLink, bad};
use super::players::PlayerList;
use super::scoring::Scoring;
use super::screen::{Classic, Destination, Purpose, Screen};
#[cfg(all(feature = "window", browser))]
use super::settings;
use super::settings::SettingsPanel;
use crate::classics::jumper::LEADERBOARD;
use crate::game::body_title;
use crate::physics::BodyId;
use crate::session::Session;
use crate::session::library::{Attempt, is_of_level, named};
use crate::session::recordings::FlightSource;
use crate::session::worker::Errand;
use crate::ui::Spectator;
use crate::words::tr;
use crate::{files, level};
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
            Err(unread) => unread_board(unread, session),
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

/// Flies the level of a folder, or of a file in it, wherever that is.
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

fn unread_board((subject, error): (String, String), session: &mut Session) -> Box<dyn Screen> {
    let heading = tr!("The scores of {subject} cannot be read", subject);
    Box::new(LevelSelect::with_panel(Purpose::Leaderboard, heading, vec![error], session))
}

/// The target of a link.
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
        assert_eq!(flight.observer().focus().followed(), Some(BodyId(1)));
        follow(&mut stack, "play=1");
        assert_eq!(stack.screen().get::<Flight>().unwrap().game().level().name, "1");
        follow(&mut stack, "lab=stress-tests");
        assert_eq!(stack.screen().get::<Lab>().unwrap().page(), Page::Survival);
        for link in ["play=nowhere", "play=experiments/nowhere", "nonsense"] {
            follow(&mut stack, link);
            assert!(stack.screen().is::<LevelSelect>(), "{link}");
        }
    }
}
