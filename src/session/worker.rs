//! The worker beside the screens: it reads and judges levels, one errand after the other, so that no frame waits for a disk or a large
//! level. A test steps it by hand.

use super::{folder_watch::Stamp, library::Refusal, library::load, recordings};
use crate::level::document::{LevelFolder, Opened};
use crate::level::{self, Awards, Level};
use crate::words::{self, Language};
use crate::{draw::Image, game::Reel, import, pack::Installed, view::painting};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::{collections::VecDeque, path::PathBuf, thread};

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Errand {
    /// The level in a folder; images are looked up there, then under the second folder, the project's.
    Level(PathBuf, PathBuf),
    Card(PathBuf, PathBuf),
    Editor(PathBuf, PathBuf),
    Install {
        archive: PathBuf,
        levels: PathBuf,
        root: PathBuf,
    },
    List(PathBuf),
    /// The first of these levels that loads; and of the level in the last folder, if any, its flight for gold.
    First(Vec<PathBuf>, PathBuf, Option<PathBuf>),
}

#[derive(Clone, Debug)]
pub struct Card {
    pub folder: PathBuf,
    /// What that looked like before it was read: what is written meanwhile is seen at the next look.
    pub stamp: Stamp,
    /// Title, medals and picture, or why it does not load.
    pub level: Result<(String, Awards, Option<Image>), Refusal>,
    /// The medals and the mark that its own flights prove, by their names; `None` where it comes with the game.
    pub proven: Option<Vec<&'static str>>,
}

#[derive(Debug)]
pub enum Brought {
    /// Of [`Errand::Level`], with its folder.
    Level(PathBuf, Result<Arc<Level>, Refusal>),
    Card(Box<Card>),
    Editor(Result<Box<Opened>, String>),
    Installed(Result<(Installed, Vec<String>), Refusal>),
    List(Vec<String>),
    /// Of [`Errand::First`]: name and title, and the flight.
    First(Option<(String, String)>, Option<Box<Reel>>),
}

impl Errand {
    fn run(self) -> Brought {
        match self {
            Self::Level(folder, root) => {
                let level = load(&folder, &root);
                Brought::Level(folder, level)
            }
            Self::Card(folder, root) => {
                let stamp = Stamp::of(&folder, &[]);
                let level = load(&folder, &root);
                let own = level.as_ref().ok().filter(|_| !level::is_shipped(&folder));
                let proven = own.map(|level| recordings::rivals(&folder, level).into_iter().map(|rival| rival.name).collect());
                let level = level.map(|level| (level.title.clone(), level.awards, painting(&level)));
                Brought::Card(Box::new(Card { folder, stamp, level, proven }))
            }
            Self::Editor(folder, root) => Brought::Editor(LevelFolder::open_to_edit(&folder, &root).map(Box::new)),
            Self::Install { archive, levels, root } => Brought::Installed(import::take_in(&archive, &levels, &root)),
            Self::List(levels) => Brought::List(level::list(&levels)),
            Self::First(folders, root, shown) => {
                let first = folders.iter().find_map(|folder| {
                    let level = load(folder, &root).ok()?;
                    Some((level.name.clone(), level.title.clone()))
                });
                let gold = shown.and_then(|folder| recordings::gold(&folder, load(&folder, &root).ok()?));
                Brought::First(first, gold.map(Box::new))
            }
        }
    }
}

pub type Ticket = u64;

#[derive(Debug)]
pub struct Worker {
    last: Ticket,
    at: At,
}

#[derive(Debug)]
enum At {
    /// On the screen's thread: the given number of errands, or without a number each as it is asked for.
    Here(VecDeque<(Ticket, Errand)>, Option<usize>),
    Beside(Arc<Desk>, Receiver<(Ticket, Brought)>),
}

#[derive(Debug, Default)]
struct Desk {
    waiting: Mutex<Waiting>,
    news: Condvar,
}

#[derive(Debug, Default)]
struct Waiting {
    errands: VecDeque<(Ticket, Errand)>,
    /// Of the screen that asked last.
    language: Language,
    closed: bool,
}

impl Desk {
    /// No errand panics while it holds the lock: what is behind it is whole.
    fn lock(&self) -> MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next errand; `None` once there is nobody who asks.
    fn next(&self) -> Option<(Ticket, Errand)> {
        let mut waiting = self.lock();
        loop {
            if waiting.closed {
                return None;
            }
            if let Some(next) = waiting.errands.pop_front() {
                words::speak(waiting.language);
                return Some(next);
            }
            waiting = self.news.wait(waiting).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl Worker {
    /// One that does everything at once, on the screen's thread.
    pub const fn here() -> Self {
        Self { last: 0, at: At::Here(VecDeque::new(), None) }
    }

    /// One that does nothing but what [`Worker::step`] lets it do.
    pub const fn by_hand() -> Self {
        Self { last: 0, at: At::Here(VecDeque::new(), Some(0)) }
    }

    /// One on a thread of its own; on the screen's where there is none, as in a browser.
    pub fn beside() -> Self {
        let desk = Arc::new(Desk::default());
        let (send, receive) = channel();
        let own = desk.clone();
        let begun = thread::Builder::new().name("worker".to_owned()).spawn(move || work(&own, &send));
        match begun {
            Ok(_) => Self { last: 0, at: At::Beside(desk, receive) },
            Err(_) => Self::here(),
        }
    }

    /// Asks for something; what a player waits for goes first.
    pub fn ask(&mut self, errand: Errand) -> Ticket {
        self.last += 1;
        let urgent = matches!(errand, Errand::Level(..) | Errand::Editor(..) | Errand::Install { .. });
        let next = (self.last, errand);
        let put =
            |errands: &mut VecDeque<(Ticket, Errand)>| if urgent { errands.push_front(next) } else { errands.push_back(next) };
        match &mut self.at {
            At::Here(errands, _) => put(errands),
            At::Beside(desk, _) => {
                let mut waiting = desk.lock();
                waiting.language = words::spoken();
                put(&mut waiting.errands);
                desk.news.notify_one();
            }
        }
        self.last
    }

    pub fn forget(&mut self, ticket: Ticket) {
        let keep = |errands: &mut VecDeque<(Ticket, Errand)>| errands.retain(|(other, _)| *other != ticket);
        match &mut self.at {
            At::Here(errands, _) => keep(errands),
            At::Beside(desk, _) => keep(&mut desk.lock().errands),
        }
    }

    pub fn bring(&mut self) -> Option<(Ticket, Brought)> {
        match &mut self.at {
            At::Here(errands, left) => {
                if let Some(left) = left {
                    *left = left.checked_sub(1)?;
                }
                let (ticket, errand) = errands.pop_front()?;
                Some((ticket, errand.run()))
            }
            At::Beside(_, brought) => brought.try_recv().ok(),
        }
    }

    /// Lets a worker that goes by hand do its next errand; whether there is one.
    pub fn step(&mut self) -> bool {
        let At::Here(errands, Some(left)) = &mut self.at else { return false };
        let more = *left < errands.len();
        *left += usize::from(more);
        more
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        if let At::Beside(desk, _) = &self.at {
            desk.lock().closed = true;
            desk.news.notify_one();
        }
    }
}

fn work(desk: &Desk, to: &Sender<(Ticket, Brought)>) {
    while let Some((ticket, errand)) = desk.next() {
        if to.send((ticket, errand.run())).is_err() {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    fn list(name: &str) -> Errand {
        Errand::List(PathBuf::from(name))
    }

    #[test]
    fn what_a_player_waits_for_goes_first_and_what_is_forgotten_is_not_done() {
        let mut worker = Worker::by_hand();
        let (first, second) = (worker.ask(list("a")), worker.ask(list("b")));
        let level = worker.ask(Errand::Level(PathBuf::from("nowhere"), PathBuf::from("nowhere")));
        assert!(worker.bring().is_none(), "nothing is done by itself");
        assert!(worker.step());
        assert!(matches!(worker.bring(), Some((ticket, Brought::Level(_, Err(_)))) if ticket == level));
        worker.forget(first);
        assert!(worker.step() && !worker.step(), "one is left");
        assert!(matches!(worker.bring(), Some((ticket, Brought::List(_))) if ticket == second));
        assert!(worker.bring().is_none());
    }

    #[test]
    fn a_thread_of_its_own_brings_the_same_and_ends_with_the_worker() {
        let mut worker = Worker::beside();
        let tickets = [worker.ask(list("a")), worker.ask(list("b"))];
        let At::Beside(desk, brought) = &worker.at else { panic!("the system gives no thread") };
        let first = [brought.recv(), brought.recv()].map(|brought| brought.map(|(ticket, _)| ticket));
        assert_eq!(first, tickets.map(Ok));
        let desk = desk.clone();
        drop(worker);
        // Woken or not, it finds that nobody asks.
        assert!(desk.next().is_none());
        assert_eq!(desk.news.wait_timeout(desk.lock(), Duration::ZERO).map(|(waiting, _)| waiting.closed).ok(), Some(true));
    }
}
