//! Between the game and the sound's thread: atomics only, so that neither ever waits. The [`SoundDesk`] writes, the mixer reads the [`Feed`]. The
//! [`Speaker`] passes each cue of a frame on once, as loud as its loudest: many collisions a frame are one click.

use super::{Ambience, Cue, Sound, Volumes, music::Arrangement, output::Output};
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, AtomicU64, AtomicUsize, Ordering};

/// The most sounds due at once: more than a frame ever brings, [`Cue::COUNT`].
const WAITING: usize = 64;
/// Loudness and place pass as integer multiples of 1 / this.
const STEPS: f32 = 32_767.0;

/// The desk and its feed. There is no third end: sounds go from one writer to one reader.
pub fn desk() -> (SoundDesk, Feed) {
    let shared = Arc::new(Shared::default());
    let desk = SoundDesk(shared.clone());
    desk.set_volumes(Volumes::default());
    (desk, Feed(shared))
}

pub struct SoundDesk(Arc<Shared>);

#[derive(Clone)]
pub struct Feed(Arc<Shared>);

struct Shared {
    volumes: [AtomicU32; 3],
    ambience: [AtomicU32; 4],
    /// The tune's number + 1; 0: none.
    tune: AtomicU32,
    /// The world of its ensemble, and its layers.
    world: AtomicUsize,
    layers: [AtomicU32; 2],
    /// Frames written so far: a game without new frames is held up.
    frames: AtomicU32,
    /// A ring of sounds. `written` and `read` count them; only the writer moves the one, only the reader the other.
    sounds: [AtomicU64; WAITING],
    written: AtomicUsize,
    read: AtomicUsize,
}

impl Default for Shared {
    fn default() -> Self {
        Self {
            volumes: Default::default(),
            ambience: Default::default(),
            tune: AtomicU32::new(0),
            world: AtomicUsize::new(0),
            layers: Default::default(),
            frames: AtomicU32::new(0),
            sounds: [const { AtomicU64::new(0) }; WAITING],
            written: AtomicUsize::new(0),
            read: AtomicUsize::new(0),
        }
    }
}

impl SoundDesk {
    pub fn set_volumes(&self, volumes: Volumes) {
        let Volumes { master, effects, music } = volumes;
        store(&self.0.volumes, [master, effects, music]);
    }

    /// Of the frame that ends now.
    pub fn set_ambience(&self, ambience: Ambience) {
        let Ambience { engine, wind, liquid, motion } = ambience;
        store(&self.0.ambience, [engine, wind, liquid, motion]);
        self.0.frames.fetch_add(1, Ordering::Relaxed);
    }

    /// The tune before it fades; `None` stops the music.
    pub fn set_tune(&self, tune: Option<u32>) {
        self.0.tune.store(tune.map_or(0, |tune| tune.saturating_add(1)), Ordering::Relaxed);
    }

    pub fn set_arrangement(&self, how: Arrangement) {
        self.0.world.store(how.world, Ordering::Relaxed);
        store(&self.0.layers, [how.pace, how.goals]);
    }

    /// A full ring drops the sound.
    pub fn play(&self, sound: Sound) {
        let shared = &self.0;
        let (written, read) = (shared.written.load(Ordering::Relaxed), shared.read.load(Ordering::Acquire));
        if written.wrapping_sub(read) < WAITING {
            shared.sounds[written % WAITING].store(pack(sound), Ordering::Relaxed);
            // The reader may read sounds below `written`.
            shared.written.store(written.wrapping_add(1), Ordering::Release);
        }
    }
}

impl Feed {
    pub fn volumes(&self) -> Volumes {
        let [master, effects, music] = load(&self.0.volumes);
        Volumes { master, effects, music }
    }

    pub fn ambience(&self) -> Ambience {
        let [engine, wind, liquid, motion] = load(&self.0.ambience);
        Ambience { engine, wind, liquid, motion }
    }

    pub fn tune(&self) -> Option<u32> {
        self.0.tune.load(Ordering::Relaxed).checked_sub(1)
    }

    pub fn arrangement(&self) -> Arrangement {
        let [pace, goals] = load(&self.0.layers);
        Arrangement { world: self.0.world.load(Ordering::Relaxed), pace, goals }
    }

    pub fn frames(&self) -> u32 {
        self.0.frames.load(Ordering::Relaxed)
    }

    pub fn next(&self) -> Option<Sound> {
        let shared = &self.0;
        let (written, read) = (shared.written.load(Ordering::Acquire), shared.read.load(Ordering::Relaxed));
        if read == written {
            return None;
        }
        let sound = unpack(shared.sounds[read % WAITING].load(Ordering::Relaxed));
        // The writer may overwrite sounds below `read`.
        shared.read.store(read.wrapping_add(1), Ordering::Release);
        Some(sound)
    }

    /// Drops the due sounds: they are of another time.
    pub fn forget(&self) {
        while self.next().is_some() {}
    }
}

fn store<const N: usize>(to: &[AtomicU32; N], values: [f32; N]) {
    for (to, value) in to.iter().zip(values) {
        to.store(within(value, 0.0).to_bits(), Ordering::Relaxed);
    }
}

fn load<const N: usize>(from: &[AtomicU32; N]) -> [f32; N] {
    from.each_ref().map(|value| f32::from_bits(value.load(Ordering::Relaxed)))
}

/// Clamps to `least` … 1; NaN becomes 0.
fn within(value: f32, least: f32) -> f32 {
    if value.is_nan() { 0.0 } else { value.clamp(least, 1.0) }
}

fn pack(sound: Sound) -> u64 {
    let loudness = (within(sound.loudness, 0.0) * STEPS) as u64;
    (sound.cue.number() as u64) << 32 | loudness << 16 | (within(sound.place, -1.0) * STEPS + STEPS) as u64
}

fn unpack(packed: u64) -> Sound {
    let part = |shift: u32| (packed >> shift & 0xffff) as u16;
    let cue = Cue::ALL[usize::from(part(32)) % Cue::COUNT];
    Sound { cue, loudness: f32::from(part(16)) / STEPS, place: f32::from(part(0)) / STEPS - 1.0 }
}

pub struct Speaker {
    pub desk: SoundDesk,
    /// Indexed by the cues' numbers.
    due: [Option<Sound>; Cue::COUNT],
    ambience: Ambience,
    /// `None` where no device plays.
    _output: Option<Output>,
}

impl Speaker {
    /// Plays on the system's device whenever there is one. Never waits, never fails.
    pub fn start() -> Self {
        let (desk, feed) = desk();
        Self { _output: Some(Output::start(feed)), ..Self::at(desk) }
    }

    /// Plays to a desk with another reader.
    pub fn at(desk: SoundDesk) -> Self {
        Self { desk, due: [None; Cue::COUNT], ambience: Ambience::default(), _output: None }
    }

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sounds_arrive_in_order_and_too_many_are_lost() {
        let (desk, feed) = desk();
        let sound = |i: usize| Sound { cue: Cue::ALL[i % Cue::COUNT], loudness: 0.5, place: -0.25 };
        for round in 0..3 {
            for i in 0..WAITING + 10 {
                desk.play(sound(i));
            }
            for i in 0..WAITING {
                let heard = feed.next().expect("it was played");
                assert_eq!(heard.cue, sound(i).cue, "round {round}");
                assert!((heard.loudness - 0.5).abs() < 1e-4 && (heard.place + 0.25).abs() < 1e-4);
            }
            assert_eq!(feed.next(), None);
        }
        desk.play(sound(0));
        feed.forget();
        assert_eq!(feed.next(), None);
    }

    #[test]
    fn two_threads_lose_and_double_nothing_that_finds_room() {
        let (desk, feed) = desk();
        let writer = std::thread::spawn(move || {
            for i in 0..20_000 {
                while desk.0.written.load(Ordering::Relaxed) - desk.0.read.load(Ordering::Relaxed) == WAITING {
                    std::thread::yield_now();
                }
                desk.play(Sound { cue: Cue::ALL[i % Cue::COUNT], loudness: 1.0, place: 0.0 });
            }
        });
        for i in 0..20_000 {
            let sound = loop {
                match feed.next() {
                    Some(sound) => break sound,
                    None => std::thread::yield_now(),
                }
            };
            assert_eq!(sound.cue, Cue::ALL[i % Cue::COUNT]);
        }
        assert!(writer.join().is_ok());
        assert_eq!(feed.next(), None);
    }

    #[test]
    fn what_is_out_of_range_or_no_number_is_put_right() {
        let (desk, feed) = desk();
        assert_eq!(feed.volumes(), Volumes::default());
        desk.set_volumes(Volumes { master: f32::NAN, effects: 7.0, music: -1.0 });
        assert_eq!(feed.volumes(), Volumes { master: 0.0, effects: 1.0, music: 0.0 });
        desk.play(Sound { cue: Cue::Met, loudness: f32::INFINITY, place: f32::NAN });
        assert_eq!(feed.next(), Some(Sound { cue: Cue::Met, loudness: 1.0, place: 0.0 }));
        for tune in [None, Some(0), Some(7)] {
            desk.set_tune(tune);
            assert_eq!(feed.tune(), tune);
        }
    }
}
