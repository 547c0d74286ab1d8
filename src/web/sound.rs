//! Output in a page: an audio worklet of the script asks for a block when it needs one. A browser lets sound begin with the player's first press.

use crate::sound::{Feed, Mixer};
use std::cell::RefCell;

/// The most frames a block.
const MOST_FRAMES: usize = 4096;

struct PageSound {
    feed: Feed,
    /// `None` before the first press.
    mixer: Option<Mixer>,
    samples: Vec<f32>,
}

thread_local! {
    static SOUND: RefCell<Option<PageSound>> = const { RefCell::new(None) };
}

#[derive(Debug)]
pub struct Output;

impl Output {
    pub fn start(feed: Feed) -> Self {
        SOUND.set(Some(PageSound { feed, mixer: None, samples: Vec::new() }));
        Self
    }
}

/// The player has pressed something: from now on blocks are asked for, with that number of frames a second.
#[unsafe(no_mangle)]
extern "C" fn resultant_sound_begins(rate: u32) {
    SOUND.with_borrow_mut(|sound| {
        if let Some(sound) = sound {
            sound.feed.forget();
            sound.mixer = Some(Mixer::new(rate, sound.feed.clone()));
        }
    });
}

/// The next frames, left and right by turns; they stay until the next call. Null where there is no sound.
#[unsafe(no_mangle)]
extern "C" fn resultant_sound_block(frames: usize) -> *const f32 {
    SOUND.with_borrow_mut(|sound| {
        let Some(PageSound { mixer: Some(mixer), samples, .. }) = sound else { return std::ptr::null() };
        samples.resize(2 * frames.min(MOST_FRAMES), 0.0);
        mixer.render(samples);
        samples.as_ptr()
    })
}
