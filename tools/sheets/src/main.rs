//! `cargo run -p sheets` writes `docs/sheets` from `docs/lessons`; with a folder behind `--`, the sheets go there.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = std::env::args_os().nth(1).map_or_else(|| root.join(sheets::FOLDER), PathBuf::from);
    match sheets::write(&root, &folder) {
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
