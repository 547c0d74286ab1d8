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
mod controls;
mod death;
mod dry_run;
mod event;
mod fingerprint;
mod hash;
mod history;
mod impacts;
mod inputs;
mod latch;
mod mechanisms;
mod medals;
mod names;
mod notes;
mod objectives;
mod proof;
mod pushes;
mod replay;
mod score;
mod ship;
mod touch;
mod track;

pub use again::Again;
pub use attempt::Game;
pub use clock::{Clock, TICK_RATE, TICK_RATES, TICKS_A_FRAME};
pub use controls::Controls;
pub use death::Death;
pub use dry_run::DryRun;
pub use event::{GameError, GameEvent, Outcome};
pub use fingerprint::{LevelHash, level_hash};
pub use history::{History, Reel, Tape, Unflown};
pub use impacts::{DAMAGING_SPEED, DUST_SPEED, Felt, READABLE};
pub use inputs::{BadFile, HEADER, Inputs, MOST_TICKS, Playback};
pub use latch::Latch;
pub use mechanisms::Mechanisms;
pub use medals::{Goal, Medal, Medals, Prize, goals, words};
pub use names::{body_title, obstacle_name, plain_name, source_name};
pub use notes::MOST_SECONDS;
pub use pushes::APART;
pub use replay::{Mismatch, PROGRAM, Recorder, Replay};
pub use score::{RunResult, ScoreParts};
pub use ship::{BURN_RATE, ROTATION_RATE, SHIP, Ship, nose, object_body};
pub use touch::TOUCH;
pub use track::{GhostPose, GhostTrack};
