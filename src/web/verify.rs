//! A page that flies every recorded flight that is built in, and compares where they lead: `index.html#verify`.

use super::{PageWord, say};
use crate::files::SHIPPED;
use crate::game::Replay;
use crate::level;
use macroquad::window::next_frame;
use std::path::Path;
use std::sync::Arc;

/// One flight a frame, each with a line, and a last line that counts them.
pub async fn verify() {
    let (mut holds, mut all) = (0, 0);
    for (path, bytes) in SHIPPED.iter().filter(|(path, _)| path.ends_with(".replay.csv")) {
        all += 1;
        let line = match fly(path, bytes) {
            Ok(line) => {
                holds += 1;
                line
            }
            Err(problem) => problem,
        };
        say(PageWord::Verified, &format!("{path}: {line}"));
        next_frame().await;
    }
    say(PageWord::Verified, &format!("{holds} of {all} flights hold"));
}

fn fly(path: &str, bytes: &[u8]) -> Result<String, String> {
    let text = std::str::from_utf8(bytes).map_err(|error| error.to_string())?;
    let replay = Replay::parse(path, text).map_err(|problems| problems.to_string())?;
    let folder = Path::new("levels").join(&replay.level);
    let level = level::load(&folder, Path::new("")).map_err(|problems| level::listed(&problems).join("; "))?.level;
    let flown = replay.verify(Arc::new(level), |_| {}).map_err(|error| error.to_string())?;
    flown.map_err(|mismatch| mismatch.to_string())?;
    Ok(format!("ok, score {}, hash {:016x}", replay.score, replay.hash))
}
