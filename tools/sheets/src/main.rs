//! `cargo run -p sheets` writes `docs/sheets` and the list in `docs/lessons/README.md` from `docs/lessons`; with a folder behind `--`,
//! the sheets alone, into that folder.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let listed = if folder.is_none() { sheets::write_lessons(&root) } else { Ok(()) };
    let folder = folder.unwrap_or_else(|| root.join(sheets::FOLDER));
    match listed.and_then(|()| sheets::write(&root, &folder)) {
        Ok(count) => {
            println!("{}: {count} files", folder.display());
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("sheets: {problem}");
            ExitCode::FAILURE
        }
    }
}
