//! One run of a level: controls, fuel, objectives, hazards, events, score; and the [`Clock`], the [`Latch`], recorded [`Inputs`]
//! and [`Replay`]s, which make ticks of frames and files. It reads no key, wall clock, file or pixel: text, inputs and frame times
//! are arguments, and view and sound read its state.
//!
//! ```text
//! clock.add(frame_time);
//! while clock.tick() { game.step(latch.take()) }
//! view.draw(&game, clock.alpha())
//! ```

mod attempt;
mod clock;
mod code;
mod event;
mod fingerprint;
mod history;
mod impacts;
mod inputs;
mod mechanisms;
mod replay;
mod score;
mod ship;
mod track;

pub use attempt::Game;
pub use clock::{Clock, Controls, Latch, TICK_RATE, TICK_RATES, TICKS_A_FRAME};
pub use event::{Death, GameError, GameEvent, Outcome, body_title, obstacle_name, plain_name, source_name};
pub use fingerprint::{LevelHash, level_hash};
pub use history::{Again, DryRun, History, Reel, Tape, Unflown};
pub use impacts::{APART, DAMAGING_SPEED, DUST_SPEED, Felt, READABLE, TOUCH};
pub use inputs::{BadFile, HEADER, Inputs, MOST_TICKS, Playback};
pub use mechanisms::Mechanisms;
pub use replay::{MOST_SECONDS, Mismatch, PROGRAM, Recorder, Replay};
pub use score::{Goal, Medal, Medals, Prize, RunResult, ScoreParts, goals, words};
pub use ship::{BURN_RATE, ROTATION_RATE, SHIP, Ship, nose, object_body};
pub use track::{GhostPose, GhostTrack};
