//! The program as a user runs it, in a data folder of its own.

use std::path::PathBuf;
use std::process::{Command, Output};

pub struct Data {
    folder: tempfile::TempDir,
}

impl Data {
    /// An empty one; in memory, where the system has a place for that and to wait for the disk takes no time.
    pub fn new() -> Self {
        let folder = tempfile::tempdir_in("/dev/shm").or_else(|_| tempfile::tempdir()).unwrap();
        std::fs::create_dir(folder.path().join("levels")).unwrap();
        Self { folder }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The same for the command line.
    pub fn arg(&self, name: &str) -> String {
        self.path(name).to_str().unwrap().to_owned()
    }

    pub fn write(&self, name: &str, text: &str) -> String {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
        self.arg(name)
    }

    /// Writes a level of 3000 × 3000 px from its files.
    pub fn level(&self, name: &str, constants: &str, files: &[(&str, &str)]) {
        self.write(&format!("levels/{name}/constants.csv"), &format!("name,value\nwidth,3000\nheight,3000\n{constants}"));
        for (file, text) in files {
            self.write(&format!("levels/{name}/{file}"), text);
        }
    }

    pub fn resultant(&self, args: &[&str]) -> Ran {
        Ran::new(&mut self.command(args))
    }

    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = resultant();
        command.arg("--data").arg(self.folder.path()).args(args);
        command
    }
}

/// The program, without a display.
pub fn resultant() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_resultant"));
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    command
}

#[derive(Debug)]
pub struct Ran {
    pub status: i32,
    pub out: String,
    pub err: String,
}

impl Ran {
    pub fn new(command: &mut Command) -> Self {
        let Output { status, stdout, stderr } = command.output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Self { status: status.code().unwrap_or(-1), out: text(stdout), err: text(stderr) }
    }

    pub fn value(&self, key: &str) -> &str {
        let line = self.out.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix('='));
        line.unwrap_or_else(|| panic!("no {key} in {self:?}"))
    }
}
