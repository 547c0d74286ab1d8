//! The game's side of the sound. What is due in a frame is gathered and passed on at its end, each cue once and as loud as its
//! loudest: many collisions a frame are one click.

use super::output::Output;
use super::{Ambience, Cue, Sound, SoundDesk, Volumes, desk};

/// Where sounds go.
#[derive(Debug)]
pub struct Speaker {
    desk: SoundDesk,
    /// By the cues' numbers.
    due: [Option<Sound>; Cue::COUNT],
    ambience: Ambience,
    /// `None` where sounds go nowhere.
    _output: Option<Output>,
}

impl Speaker {
    /// To the system's own device, as soon and as long as there is one. Never waits, never fails.
    pub fn new() -> Self {
        let (desk, feed) = desk();
        Self { desk, due: [None; Cue::COUNT], ambience: Ambience::default(), _output: Some(Output::start(feed)) }
    }

    /// To a desk whose feed someone else reads.
    pub fn at(desk: SoundDesk) -> Self {
        Self { desk, due: [None; Cue::COUNT], ambience: Ambience::default(), _output: None }
    }

    /// How loud each part is from now on.
    pub fn set_volumes(&mut self, volumes: Volumes) {
        self.desk.set_volumes(volumes);
    }

    /// Which tune is played, or none. The one before it fades.
    pub fn set_tune(&mut self, tune: Option<u32>) {
        self.desk.set_tune(tune);
    }

    /// A sound is due in this frame.
    pub fn play(&mut self, sound: Sound) {
        let due = &mut self.due[sound.cue.number()];
        if due.is_none_or(|due| due.loudness < sound.loudness) {
            *due = Some(sound);
        }
    }

    /// What is heard all the time, in this frame. A frame that does not say so has none of it.
    pub fn surround(&mut self, ambience: Ambience) {
        self.ambience = ambience;
    }

    /// Passes on what became due.
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
