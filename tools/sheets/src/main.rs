//! `cargo run -p sheets` writes docs/sheets from docs/lessons.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    match sheets::write(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")) {
        Ok(count) => {
            println!("docs/sheets: {count} files");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("sheets: {problem}");
            ExitCode::FAILURE
        }
    }
}
