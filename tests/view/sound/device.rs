//! The way to a device, on Linux: a configuration of the test's own makes ALSA's default device a file, or one that is
//! not there. The configuration is read from the environment, so the game plays in a process of its own: this test, started again.

use super::hearing::Heard;
use resultant::sound::{Ambience, Cue, Sound, Speaker};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Duration;

/// Set where the test is started again: to the file that the samples go to.
const AGAIN: &str = "RESULTANT_SOUND_AGAIN";
/// Half a second: samples of four bytes, left and right.
const HALF_A_SECOND: u64 = 24_000 * 2 * 4;
/// Frames that are played at the most: with a device a second's would do, where nobody else uses the machine.
const MOST_FRAMES: u32 = 3000;

/// Plays frames with the engine and crashes, a second of them, and on until half a second has arrived in the file.
fn play(file: &Path) {
    let arrived = || std::fs::metadata(file).map_or(0, |samples| samples.len());
    let mut speaker = Speaker::start();
    for frame in 0..MOST_FRAMES {
        if frame % 20 == 0 {
            speaker.play(Sound::new(Cue::Crash, 1.0));
        }
        speaker.surround(Ambience { engine: 1.0, ..Ambience::default() });
        speaker.end_frame();
        std::thread::sleep(Duration::from_millis(16));
        if frame >= 60 && (arrived() > HALF_A_SECOND || !has_alsa() || !file.exists()) {
            break;
        }
    }
    drop(speaker);
    println!("played");
}

fn again(test: &str, configuration: &Path, samples: &Path) -> Output {
    Command::new(std::env::current_exe().unwrap())
        .args([test, "--exact", "--nocapture"])
        .env(AGAIN, samples)
        .env("ALSA_CONFIG_PATH", configuration)
        // A sound server that may run here is left alone.
        .env("PULSE_SERVER", "unix:/nonexistent/pulse")
        .output()
        .unwrap()
}

/// Where the samples go, in the process that plays.
fn is_again() -> Option<PathBuf> {
    std::env::var_os(AGAIN).map(PathBuf::from)
}

/// Whether this machine has ALSA's library, in one of the places where systems keep it.
fn has_alsa() -> bool {
    let folders = ["/usr/lib", "/usr/lib64", "/lib", "/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu"];
    folders.iter().any(|folder| Path::new(folder).join("libasound.so.2").exists())
}

#[test]
fn samples_reach_a_device_and_are_not_silent() {
    if let Some(samples) = is_again() {
        return play(&samples);
    }
    let folder = tempfile::tempdir().unwrap();
    let (configuration, samples) = (folder.path().join("asound.conf"), folder.path().join("samples"));
    let text = format!(
        "pcm.!default {{ type file slave.pcm {{ type null }} file \"{}\" format raw }}\nctl.!default {{ type hw card 0 }}\n",
        samples.display()
    );
    std::fs::write(&configuration, text).unwrap();
    let played = again("sound::device::samples_reach_a_device_and_are_not_silent", &configuration, &samples);
    assert!(played.status.success(), "{played:?}");
    if !has_alsa() && !samples.exists() {
        eprintln!("no libasound.so.2 here: nothing was played");
        return;
    }
    let bytes = std::fs::read(&samples).unwrap();
    let floats = bytes.as_chunks().0.iter().map(|bytes| f32::from_ne_bytes(*bytes)).collect::<Vec<_>>();
    let heard = Heard(floats.as_chunks().0.to_vec());
    assert!(bytes.len() as u64 > HALF_A_SECOND, "{}", bytes.len());
    assert!(heard.rms() > 0.02 && heard.peak() < 1.0, "{} {}", heard.rms(), heard.peak());
    let last = heard.0[heard.0.len() - 1];
    assert!(last[0].abs() < 0.002 && last[1].abs() < 0.002, "it ends with a crack: {last:?}");
}

#[test]
fn a_device_that_is_missing_is_silence() {
    if let Some(none) = is_again() {
        return play(&none);
    }
    let folder = tempfile::tempdir().unwrap();
    let configuration = folder.path().join("asound.conf");
    std::fs::write(&configuration, "pcm.!default { type hw card 31 }\n").unwrap();
    let played = again("sound::device::a_device_that_is_missing_is_silence", &configuration, &folder.path().join("samples"));
    assert!(played.status.success(), "{played:?}");
    let said = [played.stdout, played.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    assert!(said[0].contains("played") && said[1].is_empty(), "{said:?}");
}
