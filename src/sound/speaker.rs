//! The game's side of the sound. It gathers the sounds of a frame and passes them on at its end, each cue once and as loud as its
//! loudest: many collisions a frame are one click.

use super::output::Output;
use super::{Ambience, Arrangement, Cue, Sound, SoundDesk, Volumes, desk};

#[derive(Debug)]
pub struct Speaker {
    desk: SoundDesk,
    /// Indexed by the cues' numbers.
    due: [Option<Sound>; Cue::COUNT],
    ambience: Ambience,
    /// `None` where no device plays.
    _output: Option<Output>,
}

impl Speaker {
    /// Plays on the system's device whenever there is one. Never waits, never fails.
    pub fn new() -> Self {
        let (desk, feed) = desk();
        Self { desk, due: [None; Cue::COUNT], ambience: Ambience::default(), _output: Some(Output::start(feed)) }
    }

    /// Plays to a desk with another reader.
    pub fn at(desk: SoundDesk) -> Self {
        Self { desk, due: [None; Cue::COUNT], ambience: Ambience::default(), _output: None }
    }

    pub fn set_volumes(&mut self, volumes: Volumes) {
        self.desk.set_volumes(volumes);
    }

    /// The tune before it fades.
    pub fn set_tune(&mut self, tune: Option<u32>) {
        self.desk.set_tune(tune);
    }

    pub fn arrange(&mut self, how: Arrangement) {
        self.desk.set_arrangement(how);
    }

    /// In this frame.
    pub fn play(&mut self, sound: Sound) {
        let due = &mut self.due[sound.cue.number()];
        if due.is_none_or(|due| due.loudness < sound.loudness) {
            *due = Some(sound);
        }
    }

    /// The ambience of this frame. A frame without this call has none.
    pub fn surround(&mut self, ambience: Ambience) {
        self.ambience = ambience;
    }

    /// Writes the frame's sounds to the desk.
    pub fn end_frame(&mut self) {
        self.desk.set_ambience(std::mem::take(&mut self.ambience));
        for sound in self.due.iter_mut().filter_map(Option::take) {
            self.desk.play(sound);
        }
    }
}

impl Default for Speaker {
    fn default() -> Self {
        Self::new()
    }
}
