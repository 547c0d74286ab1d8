//! Output on Linux, block after block, paced by the clock, for a file or null device takes samples as fast as they are computed. The libraries are
//! found at run time: PulseAudio's simple interface (which PipeWire offers as well), else ALSA's; without them, or a device, there is silence.
//! Its unsafe code rests on: the types below are those of `pulse/simple.h` (PulseAudio's API 12) and `alsa/asoundlib.h` (libasound 2), compatible
//! since 2007 and 2004, as the names `.so.0` and `.so.2` promise; and a device is used by the one thread that opened it.
#![allow(unsafe_code)]

use super::Why;
use crate::sound::{Feed, Mixer};
use crate::system_library::{function, library};
use std::ffi::{c_char, c_int, c_long, c_uint, c_ulong, c_void};
use std::ptr::{self, NonNull};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Samples a block and channel: 10 ms.
const BLOCK: usize = RATE as usize / 100;

/// Plays until the game has ended or the device is gone.
pub fn play(feed: &Feed, ends: &AtomicBool) -> Why {
    if ends.load(Ordering::Acquire) {
        return Why::Over;
    }
    let Some(libraries) = Libraries::load() else { return Why::Over };
    let Some(mut device) = Device::open(libraries) else { return Why::NoDevice };
    let mut mixer = Mixer::new(RATE, feed.clone());
    let mut samples = [0.0; BLOCK * CHANNELS];
    let (begun, mut lost) = (Instant::now(), false);
    let write = || {
        if ends.load(Ordering::Acquire) {
            return false;
        }
        mixer.render(&mut samples);
        lost = !device.write(&samples);
        !lost
    };
    keep_pace(BLOCK as f64 / f64::from(RATE), write, || begun.elapsed().as_secs_f64(), std::thread::sleep);
    if lost {
        return Why::Lost;
    }
    // The last block fades out and is heard before the device closes.
    mixer.render(&mut samples);
    let length = samples.len() as f32;
    for (i, sample) in samples.iter_mut().enumerate() {
        *sample *= 1.0 - i as f32 / length;
    }
    if device.write(&samples) {
        std::thread::sleep(Duration::from_millis(LATENCY.into()));
    }
    Why::Over
}

/// The lead over the clock (s) from which the device does not pace itself, and the lead to which a pause reduces it.
const AHEAD: f64 = 0.2;
const BACK: f64 = 0.1;
/// The share of the lead that is forgotten a block: clocks differ a little, and a device's own is the right one.
const FORGETS: f64 = 0.002;

/// Writes blocks of a length (s) until `write` refuses one, at the pace of the clock (s) that `now` reads and `pause` lets pass.
pub fn keep_pace(block: f64, mut write: impl FnMut() -> bool, now: impl Fn() -> f64, pause: impl Fn(Duration)) {
    let (mut lead, mut begun) = (0.0, now());
    while write() {
        let wait = after(&mut lead, block, now() - begun);
        if !wait.is_zero() {
            pause(wait);
        }
        begun = now();
    }
}

/// The pause after a block of that length that took so long to compute and to write (both s); `lead` is that of the samples over the clock.
fn after(lead: &mut f64, block: f64, taken: f64) -> Duration {
    *lead = ((*lead + block - taken.max(0.0)) * (1.0 - FORGETS)).max(0.0);
    if *lead < AHEAD {
        return Duration::ZERO;
    }
    Duration::from_secs_f64(std::mem::replace(lead, BACK) - BACK)
}

/// Samples a second; the libraries convert them to the device's rate.
pub const RATE: u32 = 48_000;
/// Left and right.
pub const CHANNELS: usize = 2;
/// Buffered time, ms: with less a busy machine tears the sound, with more it is heard late.
pub const LATENCY: u32 = 60;
const SAMPLE: usize = size_of::<f32>();
/// A device that fails this often within one block counts as gone.
const STUMBLES: usize = 8;

pub struct Libraries {
    pulse: Option<Pulse>,
    alsa: Option<Alsa>,
}

impl Libraries {
    /// Loads a library, once; `None` where there is none.
    pub fn load() -> Option<&'static Self> {
        static LOADED: OnceLock<Libraries> = OnceLock::new();
        let loaded = LOADED.get_or_init(|| Self { pulse: Pulse::load("libpulse-simple.so.0"), alsa: Alsa::load("libasound.so.2") });
        (loaded.pulse.is_some() || loaded.alsa.is_some()).then_some(loaded)
    }
}

pub enum Device {
    /// PulseAudio or PipeWire, which mix programs.
    Pulse(&'static Pulse, NonNull<c_void>),
    Alsa(&'static Alsa, NonNull<c_void>),
}

impl Device {
    /// The system's default device.
    pub fn open(libraries: &'static Libraries) -> Option<Self> {
        let pulse = || libraries.pulse.as_ref().and_then(|pulse| Some(Self::Pulse(pulse, pulse.open()?)));
        pulse().or_else(|| libraries.alsa.as_ref().and_then(|alsa| Some(Self::Alsa(alsa, alsa.open()?))))
    }

    /// Writes samples, left and right by turns, and waits until the device has taken them; `false` when it is gone.
    pub fn write(&mut self, samples: &[f32]) -> bool {
        match self {
            Self::Pulse(pulse, connection) => pulse.write(*connection, samples),
            Self::Alsa(alsa, pcm) => alsa.write(*pcm, samples),
        }
    }
}

impl Drop for Device {
    fn drop(&mut self) {
        match self {
            // SAFETY: it was opened by this library, is open, and is not used after this.
            Self::Pulse(pulse, connection) => unsafe { (pulse.free)(connection.as_ptr()) },
            // SAFETY: likewise.
            Self::Alsa(alsa, pcm) => unsafe {
                (alsa.close)(pcm.as_ptr());
            },
        }
    }
}

/// `pa_sample_spec`
#[repr(C)]
struct SampleSpec {
    format: c_int,
    rate: u32,
    channels: u8,
}

/// `pa_buffer_attr`, in bytes; all ones: the server's choice.
#[repr(C)]
struct BufferAttr {
    maxlength: u32,
    tlength: u32,
    prebuf: u32,
    minreq: u32,
    fragsize: u32,
}

/// `PA_STREAM_PLAYBACK`
const PLAYBACK: c_int = 1;
/// `PA_SAMPLE_FLOAT32NE`
const PULSE_FLOAT: c_int = if cfg!(target_endian = "little") { 5 } else { 6 };

type PulseNew = unsafe extern "C" fn(
    *const c_char,
    *const c_char,
    c_int,
    *const c_char,
    *const c_char,
    *const SampleSpec,
    *const c_void,
    *const BufferAttr,
    *mut c_int,
) -> *mut c_void;

pub struct Pulse {
    new: PulseNew,
    write: unsafe extern "C" fn(*mut c_void, *const c_void, usize, *mut c_int) -> c_int,
    free: unsafe extern "C" fn(*mut c_void),
}

impl Pulse {
    fn load(name: &str) -> Option<Self> {
        let library = library(name)?;
        // SAFETY: the types are those of pulse/simple.h.
        unsafe {
            Some(Self {
                new: function(library, c"pa_simple_new")?,
                write: function(library, c"pa_simple_write")?,
                free: function(library, c"pa_simple_free")?,
            })
        }
    }

    fn open(&self) -> Option<NonNull<c_void>> {
        let spec = SampleSpec { format: PULSE_FLOAT, rate: RATE, channels: CHANNELS as u8 };
        let wanted = RATE * LATENCY / 1000 * (CHANNELS * SAMPLE) as u32;
        let buffer = BufferAttr { maxlength: u32::MAX, tlength: wanted, prebuf: u32::MAX, minreq: u32::MAX, fragsize: u32::MAX };
        let (name, stream) = (c"Resultant", c"Game");
        // SAFETY: the strings end with 0 and the structures live for the call; null stands for the default server, device, order of
        // the channels, and for no error number, as the interface allows.
        let connection = unsafe {
            let null = ptr::null();
            (self.new)(null, name.as_ptr(), PLAYBACK, null, stream.as_ptr(), &spec, ptr::null(), &buffer, ptr::null_mut())
        };
        NonNull::new(connection)
    }

    fn write(&self, connection: NonNull<c_void>, samples: &[f32]) -> bool {
        // SAFETY: the connection is open, and `samples` holds that number of bytes for the call.
        unsafe { (self.write)(connection.as_ptr(), samples.as_ptr().cast(), size_of_val(samples), ptr::null_mut()) >= 0 }
    }
}

/// `SND_PCM_STREAM_PLAYBACK`, `SND_PCM_NONBLOCK`, `SND_PCM_ACCESS_RW_INTERLEAVED`
const ALSA_PLAYBACK: c_int = 0;
const ALSA_NONBLOCK: c_int = 1;
const ALSA_INTERLEAVED: c_int = 3;
/// `SND_PCM_FORMAT_FLOAT`
const ALSA_FLOAT: c_int = if cfg!(target_endian = "little") { 14 } else { 15 };

/// `snd_local_error_handler_t`: file, line, function, number, text, and a `va_list`, an argument in every ABI of Linux, which may stay unread.
type ErrorHandler = unsafe extern "C" fn(*const c_char, c_int, *const c_char, c_int, *const c_char, *const c_void);

pub struct Alsa {
    open: unsafe extern "C" fn(*mut *mut c_void, *const c_char, c_int, c_int) -> c_int,
    nonblock: unsafe extern "C" fn(*mut c_void, c_int) -> c_int,
    set_params: unsafe extern "C" fn(*mut c_void, c_int, c_int, c_uint, c_uint, c_int, c_uint) -> c_int,
    writei: unsafe extern "C" fn(*mut c_void, *const c_void, c_ulong) -> c_long,
    recover: unsafe extern "C" fn(*mut c_void, c_int, c_int) -> c_int,
    close: unsafe extern "C" fn(*mut c_void) -> c_int,
    set_error_handler: Option<unsafe extern "C" fn(Option<ErrorHandler>) -> Option<ErrorHandler>>,
}

/// Without it ALSA prints a line for every device that it does not find.
unsafe extern "C" fn say_nothing(_: *const c_char, _: c_int, _: *const c_char, _: c_int, _: *const c_char, _: *const c_void) {}

impl Alsa {
    fn load(name: &str) -> Option<Self> {
        let library = library(name)?;
        // SAFETY: the types are those of alsa/pcm.h and alsa/error.h.
        unsafe {
            Some(Self {
                open: function(library, c"snd_pcm_open")?,
                nonblock: function(library, c"snd_pcm_nonblock")?,
                set_params: function(library, c"snd_pcm_set_params")?,
                writei: function(library, c"snd_pcm_writei")?,
                recover: function(library, c"snd_pcm_recover")?,
                close: function(library, c"snd_pcm_close")?,
                set_error_handler: function(library, c"snd_lib_error_set_local"),
            })
        }
    }

    fn open(&self) -> Option<NonNull<c_void>> {
        if let Some(set) = self.set_error_handler {
            // SAFETY: the handler lives for ever and reads nothing; it holds for this thread only.
            unsafe { set(Some(say_nothing)) };
        }
        let mut pcm = ptr::null_mut();
        // SAFETY: `pcm` takes the handle; the name ends with 0. Opened so that it does not wait for a device that another program has.
        if unsafe { (self.open)(&mut pcm, c"default".as_ptr(), ALSA_PLAYBACK, ALSA_NONBLOCK) } < 0 {
            return None;
        }
        let pcm = NonNull::new(pcm)?;
        // SAFETY: the handle was opened just now. From here on writing waits for room.
        let ready = unsafe {
            (self.nonblock)(pcm.as_ptr(), 0) >= 0
                && (self.set_params)(pcm.as_ptr(), ALSA_FLOAT, ALSA_INTERLEAVED, CHANNELS as c_uint, RATE, 1, 1000 * LATENCY) >= 0
        };
        if !ready {
            // SAFETY: it is open, and is not used after this.
            unsafe { (self.close)(pcm.as_ptr()) };
            return None;
        }
        Some(pcm)
    }

    fn write(&self, pcm: NonNull<c_void>, samples: &[f32]) -> bool {
        let (mut left, mut stumbles) = (samples, 0);
        while left.len() >= CHANNELS {
            if stumbles == STUMBLES {
                return false;
            }
            // SAFETY: the handle is open, and `samples` holds that number of frames of `CHANNELS` samples for the call.
            let written = unsafe { (self.writei)(pcm.as_ptr(), left.as_ptr().cast(), (left.len() / CHANNELS) as c_ulong) };
            match usize::try_from(written) {
                // A device that takes nothing and returns no error would hold this loop for ever.
                Ok(0) => return false,
                Ok(frames) => left = left.get(frames * CHANNELS..).unwrap_or_default(),
                // An underrun (the machine was busy, or asleep) recovers; any other error means that the device is gone. SAFETY: the handle is open.
                Err(_) if unsafe { (self.recover)(pcm.as_ptr(), written as c_int, 1) } < 0 => return false,
                Err(_) => stumbles += 1,
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCK: f64 = 0.01;

    #[test]
    fn what_takes_everything_gets_it_at_the_clocks_pace() {
        let mut lead = 0.0;
        let waited: Duration = (0..1000).map(|_| after(&mut lead, BLOCK, 0.0001)).sum();
        assert!((9.0..10.0).contains(&waited.as_secs_f64()), "{waited:?}");
    }

    /// A device that takes a block in a millisecond gets ten seconds of samples in ten seconds, by a clock that only the device and
    /// the pauses move; a twentieth more at most, since the lead fades.
    #[test]
    fn samples_are_computed_at_the_pace_of_the_clock() {
        let (clock, blocks) = (std::cell::Cell::new(0.0), std::cell::Cell::new(0));
        let write = || {
            blocks.set(blocks.get() + 1);
            clock.set(clock.get() + 0.001);
            clock.get() < 10.0
        };
        keep_pace(BLOCK, write, || clock.get(), |wait| clock.set(clock.get() + wait.as_secs_f64()));
        let seconds = f64::from(blocks.get()) * BLOCK;
        assert!((9.9..10.5 + AHEAD).contains(&seconds), "{seconds}");
    }

    #[test]
    fn a_device_whose_clock_is_fast_is_never_held_up() {
        let mut lead = 0.0;
        // Half a per cent fast for three hours; no device is worse than a fiftieth of that.
        let waited: Duration = (0..1_000_000).map(|_| after(&mut lead, BLOCK, BLOCK * 0.995)).sum();
        assert_eq!(waited, Duration::ZERO);
    }

    #[test]
    fn a_library_that_is_missing_is_no_error() {
        assert!(Pulse::load("libno-such-sound.so.0").is_none());
        assert!(Alsa::load("libno-such-sound.so.2").is_none());
    }

    #[test]
    fn a_library_that_is_another_is_no_error() {
        assert!(Pulse::load("libc.so.6").is_none());
        assert!(Alsa::load("libc.so.6").is_none());
    }
}
