//! Files that are written while the system fails, at every single system call of the program, or while it is killed there.

use super::traced::{Fault, run};
use super::{data, read};
use crate::support::program::Data;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Stdio;

/// Files by their paths in the data folder, but for staged ones.
type Files = BTreeMap<String, Vec<u8>>;

/// Calls that change the disk, or wait for it: a kill before any other call comes to the same as before one of these.
const CHANGES: [i64; 23] = [
    libc::SYS_open,
    libc::SYS_openat,
    libc::SYS_write,
    libc::SYS_pwrite64,
    libc::SYS_writev,
    libc::SYS_copy_file_range,
    libc::SYS_sendfile,
    libc::SYS_ftruncate,
    libc::SYS_fsync,
    libc::SYS_fdatasync,
    libc::SYS_syncfs,
    libc::SYS_fchmod,
    libc::SYS_fchown,
    libc::SYS_mkdir,
    libc::SYS_mkdirat,
    libc::SYS_rename,
    libc::SYS_renameat,
    libc::SYS_renameat2,
    libc::SYS_linkat,
    libc::SYS_unlink,
    libc::SYS_unlinkat,
    libc::SYS_rmdir,
    libc::SYS_exit_group,
];

fn files(folder: &Path) -> Files {
    fn add(folder: &Path, below: &str, found: &mut Files) {
        for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
            let name = entry.file_name().into_string().unwrap();
            let path = format!("{below}{name}");
            match entry.file_type().unwrap().is_dir() {
                _ if name.starts_with(".resultant-") => {}
                true => add(&entry.path(), &format!("{path}/"), found),
                false => drop(found.insert(path, fs::read(entry.path()).unwrap())),
            }
        }
    }
    let mut found = Files::new();
    add(folder, "", &mut found);
    found
}

fn restore(data: &Data, old: &Files) {
    fs::remove_dir_all(data.path(".")).ok();
    for (name, bytes) in old {
        fs::create_dir_all(data.path(name).parent().unwrap()).unwrap();
        fs::write(data.path(name), bytes).unwrap();
    }
}

/// Runs the command with a fault at each of its calls. `units` are the files, or beginnings of paths, of which each is as it was or as it is to be.
fn every_call(data: &Data, args: &[&str], units: &[&str]) {
    let old = files(&data.path("."));
    let command = || {
        let mut command = data.command(args);
        command.current_dir(data.path(".")).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command
    };
    let (calls, status) = run(&mut command(), None);
    assert!(status.success(), "{args:?}: {status}");
    let new = files(&data.path("."));
    let part = |files: &Files, unit: &str| -> Files {
        files.iter().filter(|(name, _)| name.starts_with(unit)).map(|(name, bytes)| (name.clone(), bytes.clone())).collect()
    };
    assert!(units.iter().all(|unit| part(&old, unit) != part(&new, unit)), "{args:?} writes all of them");
    let (mut failed, mut killed) = (0, 0);
    for (at, call) in calls.iter().enumerate() {
        let changes = CHANGES.contains(call);
        let faults = [Some(Fault::Error(libc::EIO)), changes.then_some(Fault::Error(libc::ENOSPC)), changes.then_some(Fault::Kill)];
        for fault in faults.into_iter().flatten() {
            restore(data, &old);
            let (_, status) = run(&mut command(), Some((at, fault)));
            let now = files(&data.path("."));
            let place = format!("{args:?}: {fault:?} at call {at}, number {call}: {status}");
            for unit in units {
                let found = part(&now, unit);
                assert!(found == part(&old, unit) || found == part(&new, unit), "{place}: {unit} is neither old nor new");
                assert!(!status.success() || found == part(&new, unit), "{place}: {unit} is old");
            }
            let others = |files: &Files| -> Files {
                let is_other = |name: &String| !units.iter().any(|unit| name.starts_with(unit));
                files.iter().filter(|(name, _)| is_other(name)).map(|(name, bytes)| (name.clone(), bytes.clone())).collect()
            };
            assert_eq!(others(&now), others(&old), "{place}");
            match fault {
                Fault::Error(_) => failed += usize::from(!status.success()),
                Fault::Kill => killed += usize::from(status.code().is_none()),
            }
        }
        // Whatever was left staged goes with the next run.
        if CHANGES.contains(call) && units.iter().all(|unit| part(&files(&data.path(".")), unit) == part(&old, unit)) {
            assert_eq!(run(&mut command(), None).1.code(), Some(0));
            let staged = |folder: &str| {
                let names = fs::read_dir(data.path(folder)).into_iter().flatten().map(|entry| entry.unwrap().file_name());
                names.filter(|name| name.to_string_lossy().starts_with(".resultant-")).count()
            };
            assert_eq!(staged(".") + staged("levels"), 0, "{args:?}: call {at}");
        }
    }
    assert!(failed > 10 && killed > 10, "{args:?}: {failed} failed and {killed} were killed of {} calls", calls.len());
}

#[test]
fn what_a_run_writes_is_whole_or_untouched() {
    let data = data();
    data.write("old.csv", &"old,old\n".repeat(3000));
    data.write("record.csv", "old");
    let run = ["run", "flight", "--seconds", "0.5", "--telemetry", "old.csv", "--forces", "new.csv", "--record", "record.csv"];
    every_call(&data, &run, &["old.csv", "new.csv", "record.csv"]);
    assert!(read(&data, "levels/flight/objects.csv").starts_with("900,100,"));
}

#[test]
fn a_level_is_packed_unpacked_and_made_whole_or_not_at_all() {
    let data = data();
    every_call(&data, &["new", "made"], &["levels/made"]);
    assert_eq!(data.resultant(&["pack", "goal", "--out", data.path("packed.zip").to_str().unwrap()]).status, 0);
    every_call(&data, &["pack", "goal", "--out", "again.zip"], &["again.zip"]);
    every_call(&data, &["unpack", "packed.zip", "--as", "other"], &["levels/other"]);
}

/// Many small files wait for the disk as often as one does.
#[test]
fn a_folder_waits_for_the_disk_once_and_not_once_a_file() {
    let data = data();
    (0..40).for_each(|i| drop(data.write(&format!("levels/goal/note-{i}.txt"), "small")));
    assert_eq!(data.resultant(&["pack", "goal", "--out", data.path("packed.zip").to_str().unwrap()]).status, 0);
    let mut command = data.command(&["unpack", "packed.zip", "--as", "other"]);
    command.current_dir(data.path(".")).stdout(Stdio::null());
    let (calls, status) = run(&mut command, None);
    let waits = [libc::SYS_fsync, libc::SYS_fdatasync, libc::SYS_syncfs];
    let waited = calls.iter().filter(|call| waits.contains(call)).count();
    assert!(status.success() && (1..=3).contains(&waited), "{waited} times");
    assert_eq!(read(&data, "levels/other/note-39.txt"), "small");
}
