//! No test reads a clock: its result must not depend on the load of the machine. Work is counted instead: units of the engine's work,
//! allocations, samples, lines.

use super::sources::{files, root};
use std::fs;
use std::path::Path;

/// Names of clocks and of their answers.
const CLOCKS: [&str; 6] = ["Instant", "SystemTime", "ThreadTime", "ProcessTime", "get_time(", "UNIX_EPOCH"];
/// This list, and the one measure that is no count: how many passes over a text reading it costs, both in the thread's own time.
const MAY: [&str; 2] = ["tests/house/no_clocks.rs", "tests/files/limits.rs"];

/// The unit tests of a source, and all of a test's.
fn tests_of(path: &Path, text: &str) -> String {
    if path.starts_with("tests") {
        return text.to_owned();
    }
    // Unit tests stand at the end of their file.
    text.split_once("\n#[cfg(test)]\nmod ")
        .or_else(|| text.split_once("\n#[cfg(all(test,"))
        .map_or("", |(_, tests)| tests)
        .to_owned()
}

#[test]
fn no_test_reads_a_clock() {
    let mut with_tests = 0;
    for path in ["tests", "src"].iter().flat_map(|folder| files(&root().join(folder), &["rs"])) {
        let name = path.strip_prefix(root()).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        let tests = tests_of(name, &text);
        with_tests += u32::from(!tests.is_empty());
        let clock = CLOCKS.iter().find(|clock| tests.contains(**clock));
        assert!(clock.is_none() || MAY.iter().any(|may| name == Path::new(may)), "{}: {clock:?}", name.display());
    }
    assert!(with_tests > 200, "{with_tests}");
}
