//! Records of flights that a spreadsheet has saved.

use resultant::game::Replay;
use std::path::Path;

#[test]
fn a_record_is_the_same_whatever_spreadsheet_saved_it() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("levels/1/flights/gold.replay.csv");
    let text = std::fs::read_to_string(path).unwrap();
    let record = Replay::parse("gold", &text).unwrap();
    for sign in [',', ';', '\t'] {
        let row = |line: &str| match line.strip_prefix('#') {
            Some(note) => format!("#{note}{}\r\n", sign.to_string().repeat(4)),
            None => line.replace(',', &sign.to_string()) + "\r\n",
        };
        let saved: String = text.lines().map(row).collect();
        assert_eq!(Replay::parse("gold", &saved).as_ref(), Ok(&record), "{sign:?}");
    }
}
