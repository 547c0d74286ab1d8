//! The page that the game runs in, in a browser: its storage, clock, gamepads and what its script, `script.js` beside this file, asks for; and
//! `index.html#verify`, a page that flies every recorded flight that is built in and compares where they lead.
//!
//! Unsafe code: the functions of the script take and give the bytes of the program's memory; each call below hands over a pointer and the
//! length of what it points to, and the script keeps neither beyond the call.
#![allow(unsafe_code)]

use crate::files::{self, SHIPPED};
use crate::{game::Replay, level, pack, words::tr};
use macroquad::window::next_frame;
use std::cell::{Cell, RefCell};
use std::path::{Path, PathBuf};
use std::{ops::Sub, sync::Arc, time::Duration};

mod keeper;
mod keys;
mod sound;

pub use keeper::{delete, export, import, is_export, storage};
pub use keys::drain as drain_keys;
pub use sound::Output;

/// Where dropped files lie while the page is open: never in the browser's storage.
const DROPPED: &str = "dropped";
/// Buttons and axes of the page's standard gamepad.
pub const PAD_LEVELS: usize = 17 + 2;

thread_local! {
    static FILES: RefCell<Vec<PathBuf>> = const { RefCell::new(Vec::new()) };
    static HIDDEN: Cell<bool> = const { Cell::new(false) };
    static AT_RISK: Cell<bool> = const { Cell::new(false) };
    static FULLSCREEN: Cell<Option<bool>> = const { Cell::new(None) };
}

#[link(wasm_import_module = "env")]
unsafe extern "C" {
    /// ms.
    fn resultant_now() -> f64;
    /// The length of the value, which [`resultant_take`] copies; below 0: see [`keeper`].
    fn resultant_get(key: *const u8, length: usize) -> i32;
    fn resultant_keys() -> i32;
    fn resultant_take(to: *mut u8);
    fn resultant_set(key: *const u8, length: usize, value: *const u8, value_length: usize) -> i32;
    fn resultant_remove(key: *const u8, length: usize);
    fn resultant_pads(levels: *mut f32);
    fn resultant_link() -> i32;
    fn resultant_link_again();
    fn resultant_language() -> i32;
    /// s.
    fn resultant_frame_ends(rest: f64);
    fn resultant_say(kind: i32, words: *const u8, length: usize);
    fn resultant_download(name: *const u8, length: usize, bytes: *const u8, bytes_length: usize);
    fn resultant_choose_file();
}

#[derive(Clone, Copy, Debug)]
#[repr(i32)]
pub enum PageWord {
    /// The game has stopped, with the reason.
    Stopped = 0,
    /// A line of a verification.
    Verified = 1,
    /// A line above the picture, until it is clicked.
    Notice = 2,
    /// Everything was imported: the page begins again.
    Begin = 3,
}

pub fn say(word: PageWord, words: &str) {
    // SAFETY: pointer and length are of one string.
    unsafe { resultant_say(word as i32, words.as_ptr(), words.len()) }
}

/// The answer of that length that the script holds ready.
fn taken(length: i32) -> Vec<u8> {
    let mut bytes = vec![0; usize::try_from(length).unwrap_or(0)];
    // SAFETY: the script writes as many bytes as it has just named.
    unsafe { resultant_take(bytes.as_mut_ptr()) }
    bytes
}

/// The part of the page's address behind `#`, since it was last asked for; empty without news.
pub fn link() -> String {
    // SAFETY: it takes nothing.
    let length = unsafe { resultant_link() };
    String::from_utf8(taken(length)).unwrap_or_default()
}

/// The next [`link`] is the last one once more.
pub fn link_again() {
    // SAFETY: it takes nothing.
    unsafe { resultant_link_again() }
}

/// The browser's, such as `de-AT`.
pub fn language() -> String {
    // SAFETY: it takes nothing.
    let length = unsafe { resultant_language() };
    String::from_utf8(taken(length)).unwrap_or_default()
}

/// How far each button and axis of the standard gamepad is pressed, over all gamepads.
pub fn pads() -> [f32; PAD_LEVELS] {
    let mut levels = [0.0; PAD_LEVELS];
    // SAFETY: the script writes that number of levels.
    unsafe { resultant_pads(levels.as_mut_ptr()) }
    levels
}

/// Lets the player keep a file.
pub fn download(name: &str, bytes: &[u8]) {
    // SAFETY: pointers and lengths are of one string and one slice.
    unsafe { resultant_download(name.as_ptr(), name.len(), bytes.as_ptr(), bytes.len()) }
}

/// Lets the player choose a file, which comes as if it were dropped.
pub fn choose_file() {
    // SAFETY: it takes nothing.
    unsafe { resultant_choose_file() }
}

/// The files that were dropped or chosen since the last call.
pub fn dropped() -> Vec<PathBuf> {
    FILES.take()
}

/// Whether the page was hidden since the last call.
pub fn was_hidden() -> bool {
    HIDDEN.take()
}

/// Whether the page fills the screen, where that has changed since the last call.
pub fn fullscreen() -> Option<bool> {
    FULLSCREEN.take()
}

/// Whether the browser asks before it leaves the page.
pub fn set_at_risk(at_risk: bool) {
    AT_RISK.set(at_risk);
}

/// The least time until the next frame, s.
pub fn end_frame(rest: f64) {
    // SAFETY: it takes a number.
    unsafe { resultant_frame_ends(rest) }
}

/// The script's version, so that a page with an old script says so.
#[unsafe(no_mangle)]
pub extern "C" fn resultant_crate_version() -> u32 {
    4
}

#[unsafe(no_mangle)]
extern "C" fn resultant_hidden() {
    HIDDEN.set(true);
}

/// 1 where something is lost with the page.
#[unsafe(no_mangle)]
extern "C" fn resultant_at_risk() -> i32 {
    i32::from(AT_RISK.get())
}

/// The browser has taken the graphics away, with all textures and shaders: the page has to be loaded again.
#[unsafe(no_mangle)]
extern "C" fn resultant_graphics_lost() {
    HIDDEN.set(true);
    say(
        PageWord::Stopped,
        tr("The browser has taken the graphics away. Click here, or load the page again, to play on; what was saved is kept."),
    );
}

#[unsafe(no_mangle)]
extern "C" fn resultant_fullscreen(fills: i32) {
    FULLSCREEN.set(Some(fills != 0));
}

/// Room for bytes that the script hands over.
#[unsafe(no_mangle)]
extern "C" fn resultant_room(length: usize) -> *mut u8 {
    Box::leak(vec![0; length].into_boxed_slice()).as_mut_ptr()
}

/// # Safety
/// [`resultant_room`] made it with that length, and it is handed over once.
unsafe fn handed_over(at: *mut u8, length: usize) -> Vec<u8> {
    // SAFETY: as said above.
    unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, length)) }.into_vec()
}

/// Whether a file of that name and size, bytes, is too large to be handed over. The page then says so.
#[unsafe(no_mangle)]
extern "C" fn resultant_refuses(name: *mut u8, length: usize, size: f64) -> bool {
    // SAFETY: the script hands over what it has just filled.
    let name = unsafe { handed_over(name, length) };
    let refuses = size > pack::LARGEST as f64;
    if refuses {
        let problem = files::too_large(Some(size as u64), pack::LARGEST);
        say(PageWord::Notice, &format!("{}: {problem}", String::from_utf8_lossy(&name)));
    }
    refuses
}

#[unsafe(no_mangle)]
extern "C" fn resultant_dropped(name: *mut u8, name_length: usize, bytes: *mut u8, length: usize) {
    // SAFETY: the script hands over what it has just filled.
    let (name, bytes) = unsafe { (handed_over(name, name_length), handed_over(bytes, length)) };
    let name = String::from_utf8_lossy(&name).replace(['/', '\\'], "_");
    let path = format!("{DROPPED}/{name}");
    keeper::hold(path.clone(), bytes);
    FILES.with_borrow_mut(|files| files.push(path.into()));
}

/// As [`std::time::Instant`], which a page does not have.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Instant(Duration);

impl Instant {
    pub fn now() -> Self {
        // SAFETY: it takes nothing.
        let milliseconds = unsafe { resultant_now() };
        Self(Duration::try_from_secs_f64(milliseconds / 1000.0).unwrap_or_default())
    }

    pub fn elapsed(&self) -> Duration {
        Self::now().0.saturating_sub(self.0)
    }
}

impl Sub for Instant {
    type Output = Duration;

    fn sub(self, earlier: Self) -> Duration {
        self.0.saturating_sub(earlier.0)
    }
}

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
