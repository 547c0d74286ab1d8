//! One run of a level: controls, fuel, objectives, hazards, events, score; and the [`Clock`], the [`Latch`], recorded [`Inputs`]
//! and [`Replay`]s, which make ticks of frames and files. It reads no key, wall clock, file or pixel: text, inputs and frame times
//! are arguments, and view and sound read its state.
//!
//! ```text
//! clock.add(frame_time);
//! while clock.tick() { game.step(latch.take()) }
//! view.draw(&game, clock.alpha())
//! ```

mod again;
mod attempt;
mod clock;
mod code;
mod event;
mod fingerprint;
mod history;
mod impacts;
mod inputs;
mod mechanisms;
mod names;
mod notes;
mod replay;
mod score;
mod ship;
mod track;
mod tricks;

pub use again::Again;
pub use again::DryRun;
pub use attempt::Game;
pub use clock::Controls;
pub use clock::Latch;
pub use clock::{Clock, TICK_RATE, TICK_RATES, TICKS_A_FRAME};
pub use event::Death;
pub use event::{GameError, GameEvent, Outcome};
pub use fingerprint::{LevelHash, level_hash};
pub use history::{History, Reel, Tape, Unflown};
pub use impacts::APART;
pub use impacts::TOUCH;
pub use impacts::{DAMAGING_SPEED, DUST_SPEED, Felt, READABLE};
pub use inputs::{BadFile, HEADER, Inputs, MOST_TICKS, Playback};
pub use mechanisms::Mechanisms;
pub use names::{body_title, obstacle_name, plain_name, source_name};
pub use notes::MOST_SECONDS;
pub use replay::{Mismatch, PROGRAM, Recorder, Replay};
pub use score::{Goal, Medal, Medals, Prize, goals, words};
pub use score::{RunResult, ScoreParts};
pub use ship::{BURN_RATE, ROTATION_RATE, SHIP, Ship, nose, object_body};
pub use track::{GhostPose, GhostTrack};
