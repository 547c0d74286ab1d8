//! A scores folder of a test's own, and processes that write into it.

use crate::support::shipped::names;
use resultant::files::SaveError;
use resultant::scores::{Name, Scores, ScoresError};
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// Tries again as long as another process is saving there, also where other programs keep every core busy.
pub fn until_its_turn(mut save: impl FnMut() -> Result<(), ScoresError>) {
    loop {
        match save() {
            Err(ScoresError::Save(SaveError::Busy(_))) => {}
            saved => return saved.unwrap(),
        }
    }
}

/// A project folder, removed with the test. Its scores folder need not be there.
pub struct Fixture {
    pub root: tempfile::TempDir,
}

impl Fixture {
    pub fn new() -> Self {
        Self { root: tempfile::tempdir().unwrap() }
    }

    pub fn with(file: &str, text: &str) -> Self {
        let fixture = Self::new();
        fixture.write(file, text);
        fixture
    }

    pub fn write(&self, name: &str, text: &str) {
        fs::create_dir_all(self.file(name).parent().unwrap()).unwrap();
        fs::write(self.file(name), text).unwrap();
    }

    pub fn folder(&self) -> PathBuf {
        self.root.path().join("scores")
    }

    pub fn file(&self, name: &str) -> PathBuf {
        self.folder().join(name)
    }

    pub fn text(&self, name: &str) -> String {
        fs::read_to_string(self.file(name)).unwrap()
    }

    pub fn scores(&self) -> Scores {
        Scores::new(self.folder())
    }

    pub fn names(&self) -> Vec<String> {
        names(&self.folder())
    }
}

pub fn name(text: &str) -> Name {
    Name::new(text).unwrap()
}

pub fn make_read_only(path: &Path) {
    let mut permissions = fs::metadata(path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(path, permissions).unwrap();
}

/// The scores folder that a worker writes to, the user it writes for, and how many rows it writes.
const FOLDER: &str = "RESULTANT_TEST_FOLDER";
const USER: &str = "RESULTANT_TEST_USER";
const ROWS: &str = "RESULTANT_TEST_ROWS";
/// A worker prints this before each row that is safely written.
const WRITTEN: &str = "written ";

/// This test program, to be started again with nothing but the test `worker`, which works there by [`in_a_worker`].
pub struct Worker {
    command: Command,
}

impl Worker {
    /// Started through a shell by a script that ends in `"$@"`.
    #[cfg(unix)]
    pub fn through(script: &str, worker: &str, folder: &Path) -> Self {
        let mut shell = Command::new("sh");
        shell.args(["-c", script, "sh"]).arg(std::env::current_exe().unwrap());
        Self::of(shell, worker, folder, "a", 1)
    }

    fn of(mut command: Command, worker: &str, folder: &Path, user: &str, rows: u32) -> Self {
        command.args(["--exact", worker, "--nocapture", "--test-threads=1"]);
        command.env(FOLDER, folder).env(USER, user).env(ROWS, rows.to_string());
        Self { command }
    }

    #[cfg(unix)]
    pub fn output(mut self) -> std::process::Output {
        self.command.output().unwrap()
    }

    pub fn start(worker: &str, folder: &Path, user: &str, rows: u32) -> Child {
        let program = Command::new(std::env::current_exe().unwrap());
        Self::of(program, worker, folder, user, rows).command.stdout(Stdio::piped()).spawn().unwrap()
    }
}

/// In a worker: writes row after row, confirms each, and ends the process.
pub fn in_a_worker(mut write: impl FnMut(&Scores, &str, u32)) {
    let told = |key| std::env::var(key).ok();
    let (Some(folder), Some(user), Some(rows)) = (told(FOLDER), told(USER), told(ROWS)) else { return };
    let scores = Scores::new(folder);
    for row in 1..=rows.parse().unwrap() {
        write(&scores, &user, row);
        let mut out = std::io::stdout().lock();
        writeln!(out, "\n{WRITTEN}{row}").unwrap();
        out.flush().unwrap();
    }
    std::process::exit(0);
}

pub fn confirmed(worker: &mut Child) -> impl Iterator<Item = u32> + use<> {
    let lines = BufReader::new(worker.stdout.take().unwrap()).lines().map_while(Result::ok);
    lines.filter_map(|line| line.strip_prefix(WRITTEN)?.parse().ok())
}

/// Kills a worker at some moment after its first row; the last row that it confirmed.
pub fn kill_within(mut worker: Child, round: u64) -> u32 {
    let mut rows = confirmed(&mut worker);
    let first = rows.next().unwrap();
    // Steps that share no factor with the length of a write reach every part of one.
    std::thread::sleep(Duration::from_micros(round * 1_733 % 20_011));
    worker.kill().unwrap();
    worker.wait().unwrap();
    rows.last().unwrap_or(first)
}
