//! The lines of the files that an edit changes, and the lines that it leaves.

use super::{all_bytes, folders};
use proptest::prelude::*;
use resultant::level::document::{Document, Kind, LevelFolder, NewRow, Place, RowId, SetCell, Table};
use resultant::physics::DVec2;
use std::path::Path;

fn of(table: Table, text: &str) -> Document {
    Document::new(|asked| (asked == table).then(|| text.as_bytes().to_vec()))
}

fn text(document: &Document, table: Table) -> String {
    String::from_utf8(document.bytes(table).unwrap().to_vec()).unwrap()
}

fn row(table: Table, row: usize) -> RowId {
    RowId { table, row }
}

fn set(row: RowId, column: &'static str, text: &str) -> SetCell {
    SetCell { row, column, text: text.to_owned() }
}

/// How many lines differ, where both have as many.
fn lines_that_differ(a: &[u8], b: &[u8]) -> usize {
    let lines = |bytes: &[u8]| bytes.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect::<Vec<_>>();
    let (a, b) = (lines(a), lines(b));
    assert_eq!(a.len(), b.len());
    a.iter().zip(&b).filter(|(a, b)| a != b).count()
}

#[test]
fn one_cell_is_one_line_in_every_file_of_every_level() {
    let mut cells = 0;
    for folder in folders() {
        let Ok(opened) = LevelFolder::open(&folder, Path::new(env!("CARGO_MANIFEST_DIR"))) else { continue };
        for table in Table::ALL {
            let Some(before) = opened.document.bytes(*table).map(<[u8]>::to_vec) else { continue };
            assert_eq!(before, std::fs::read(folder.join(table.file())).unwrap(), "opened, and nothing else");
            for row in opened.document.rows(*table) {
                let Some(kind) = opened.document.kind(row) else { continue };
                for column in kind.schema().columns.iter().map(|column| column.name).filter(|column| *column != "kind") {
                    let mut document = opened.document.clone();
                    let Some(old) = document.cell(row, column).map(str::to_owned) else { continue };
                    let Ok(()) = document.set(&[set(row, column, "123.456")], None) else { continue };
                    let after = document.bytes(*table).unwrap();
                    // Words over several lines become one.
                    let differ = if old.contains('\n') { 1 } else { lines_that_differ(&before, after) };
                    assert_eq!(differ, 1, "{}: {}, {row:?} {column}", folder.display(), table.file());
                    assert_eq!(document.cell(row, column), Some("123.456"));
                    document.set(&[set(row, column, &old)], None).unwrap();
                    assert!(document.undo() && document.undo());
                    assert_eq!(document.bytes(*table).unwrap(), before);
                    cells += 1;
                }
            }
        }
    }
    assert!(cells > 2000, "{cells}");
}

#[test]
fn what_a_cell_is_not_about_stays() {
    let file = "\u{feff}# \"blocks\"\r\n\r\nheight, width ,y,x\r\n 040 , 1e2,\t\"5\" ,+7 \r\n#1,2\r\n1,2,3,4";
    let mut document = of(Table::World, file);
    document.set(&[set(row(Table::World, 0), "y", "6"), set(row(Table::World, 1), "x", "9")], None).unwrap();
    assert_eq!(text(&document, Table::World), file.replace("\"5\"", "\"6\"").replace("3,4", "3,9"));
    let (version, history) = (document.version(), document.history());
    document.set(&[set(row(Table::World, 0), "height", "040")], None).unwrap();
    assert_eq!((document.version(), document.history()), (version, history));
}

#[test]
fn a_cell_that_is_not_there_yet_is_added() {
    let mut document = of(Table::World, "1,2,3,4\n5,6,7,8\n");
    document.set(&[set(row(Table::World, 1), "belt", "2"), set(row(Table::World, 1), "name", "a")], None).unwrap();
    assert_eq!(text(&document, Table::World), "1,2,3,4\n5,6,7,8,,,2,,a\n");
    let mut document = of(Table::World, "x,y,width,height # not a comment\n1,2,3,4\n5,6,7,8\n");
    assert!(document.set(&[set(row(Table::World, 0), "belt", "2")], None).is_ok());
    let mut document = of(Table::World, "height,x,y,width\r\n1,2,3,4 \r\n5,6,7,8\r\n");
    document.set(&[set(row(Table::World, 0), "material", "Ice")], None).unwrap();
    assert_eq!(text(&document, Table::World), "height,x,y,width,material\r\n1,2,3,4,Ice \r\n5,6,7,8\r\n");
}

#[test]
fn texts_are_put_in_quotes_where_they_have_to_be() {
    let mut document = of(Table::Texts, "1,2,3,words\n");
    for words in ["a, b", "he said \"no\"", " spaces ", "# no comment", "plain"] {
        document.set(&[set(row(Table::Texts, 0), "text", words)], None).unwrap();
        assert_eq!(document.cell(row(Table::Texts, 0), "text"), Some(words.trim()));
    }
    assert_eq!(text(&document, Table::Texts), "1,2,3,\"plain\"\n", "quotes that are there stay");
}

#[test]
fn rows_are_added_below_and_taken_out_with_their_lines() {
    let mut document = of(Table::World, "# floor\r\nwidth,height,x,y\r\n\r\n1,2,3,4");
    let new = NewRow {
        kind: Kind::Solid,
        cells: vec![("x", "5".into()), ("y", "6".into()), ("width", "7".into()), ("height", "8".into())],
    };
    assert_eq!(document.add(&[new]).unwrap(), [row(Table::World, 1)]);
    assert_eq!(text(&document, Table::World), "# floor\r\nwidth,height,x,y\r\n\r\n1,2,3,4\r\n7,8,5,6\r\n");
    document.remove(&[row(Table::World, 0)]).unwrap();
    assert_eq!(text(&document, Table::World), "# floor\r\nwidth,height,x,y\r\n\r\n7,8,5,6\r\n");
    assert!(document.undo() && document.undo() && !document.undo());
    assert_eq!(text(&document, Table::World), "# floor\r\nwidth,height,x,y\r\n\r\n1,2,3,4");
    document.put(Kind::Pod, Place { min: DVec2::new(1.0, 2.0), size: DVec2::new(30.0, 40.0) }).unwrap();
    assert_eq!(text(&document, Table::Pods), "x,y,width,height,fuel\n1,2,30,40,100\n");
    assert!(document.undo());
    assert_eq!(document.bytes(Table::Pods), None);
}

#[test]
fn what_cannot_be_read_is_left_alone() {
    for bytes in [
        &b"x,y,width,height\n1,2,3,caf\xe9\n"[..],
        b"1\x00,\x002\x00",
        b"\xff\xfe1\x00,",
        b"PK\x03\x04...",
        b"sep=|\n1|2|3|4\n",
        b"left,top,wide,high\n1,2,3,4\n",
    ] {
        let mut document = Document::new(|asked| (asked == Table::World).then(|| bytes.to_vec()));
        assert_eq!(document.rows(Table::World).count(), 0, "{bytes:?}");
        assert!(document.put(Kind::Solid, Place { min: DVec2::ZERO, size: DVec2::ONE }).is_err());
        assert_eq!((document.bytes(Table::World), document.history()), (Some(bytes), (0, 0)));
    }
    let mut document = of(Table::World, "1,2,3,4\n5,6,7,\"8\n9,1,2,3\n");
    assert!(document.set(&[set(row(Table::World, 1), "x", "1")], None).unwrap_err().contains("world.csv:2 cannot be read"));
    assert!(document.put(Kind::Solid, Place { min: DVec2::ZERO, size: DVec2::ONE }).is_err(), "it would end within quotes");
    document.set(&[set(row(Table::World, 0), "x", "0")], None).unwrap();
    assert!(text(&document, Table::World).starts_with("0,2,3,4\n5,6,7,\"8\n"));
}

#[test]
fn a_gesture_is_one_operation_however_long_it_takes() {
    let mut document = of(Table::World, "1,2,3,4\n5,6,7,8\n");
    for x in 0..500 {
        document.set(&[set(row(Table::World, x % 2), "x", &(x * 1001).to_string())], Some(7)).unwrap();
    }
    document.set(&[set(row(Table::World, 0), "x", "1")], Some(8)).unwrap();
    assert_eq!(document.history(), (2, 0));
    assert!(document.undo() && document.undo());
    assert_eq!(text(&document, Table::World), "1,2,3,4\n5,6,7,8\n");
    assert!(document.redo());
    assert_eq!(text(&document, Table::World), "498498,2,3,4\n499499,6,7,8\n");
    let before = document.history();
    document.set(&[set(row(Table::World, 0), "y", "9")], Some(9)).unwrap();
    document.set(&[set(row(Table::World, 0), "y", "2")], Some(9)).unwrap();
    assert_eq!(document.history().0, before.0);
}

#[test]
fn a_mover_takes_its_way_along_and_a_switch_is_wired_by_name() {
    let mut document = Document::new(|table| match table {
        Table::Movers => Some(b"10,20,30,40,50 60; 70 80.5,2\n".to_vec()),
        Table::Switches => Some(b"1,2,3,4,gate\n".to_vec()),
        Table::Doors => Some(b"1,2,3,4,door\n".to_vec()),
        _ => None,
    });
    let (lift, switch, door) = (row(Table::Movers, 0), row(Table::Switches, 0), row(Table::Doors, 0));
    document.set(&document.shifted(lift, DVec2::new(5.0, -5.0)), None).unwrap();
    assert_eq!(text(&document, Table::Movers), "15,15,30,40,55 55; 75 75.5,2\n");
    document.set(&document.rewired(switch, lift), None).unwrap();
    assert_eq!((document.cell(lift, "name"), document.cell(switch, "works")), (Some("lift"), Some("lift")));
    document.set(&document.rewired(switch, door), None).unwrap();
    assert_eq!(document.cell(switch, "works"), Some("lift door"));
    assert_eq!(document.wires().len(), 2);
    document.set(&document.rewired(switch, lift), None).unwrap();
    assert_eq!(document.cell(switch, "works"), Some("door"));
    // A wire to a thing of two names takes the one that no switch works; with a second name the first keeps its wires.
    document.set(&[set(door, "name", "door&")], Some(1)).unwrap();
    document.set(&[set(door, "name", "door&both")], Some(1)).unwrap();
    assert_eq!((document.cell(switch, "works"), document.wires().len()), (Some("door"), 1));
    let second = document.put(Kind::Switch, Place { min: DVec2::ZERO, size: DVec2::ONE }).unwrap().unwrap();
    document.set(&document.rewired(second, door), None).unwrap();
    assert_eq!((document.cell(second, "works"), document.wires().len()), (Some("lift both"), 3));
    document.set(&[set(door, "name", "hatch&two")], None).unwrap();
    assert_eq!((document.cell(switch, "works"), document.cell(second, "works")), (Some("hatch"), Some("lift two")));
    assert!(document.rewired(switch, switch).is_empty());
}

#[test]
fn keys_pads_and_objects_of_one_file_stay_in_order() {
    let mut document = of(Table::Objectives, "PLAYER,1,2,3,4");
    let place = Place { min: DVec2::ZERO, size: DVec2::new(40.0, 20.0) };
    let key = document.put(Kind::Key, place).unwrap().unwrap();
    let copies = document.duplicate(&[row(Table::Objectives, 0), key], DVec2::new(10.0, 10.0), None).unwrap();
    assert_eq!(copies.iter().map(|row| document.kind(*row)).collect::<Vec<_>>(), [Some(Kind::Pad), Some(Kind::Key)]);
    let lines = "PLAYER,1,2,3,4\nOBJECT,20,10,box:40x20,50,240,170,40,0.2,1.05\nPLAYER,11,12,3,4\nOBJECT,30,20,box:40x20,50,240,170,40,0.2,1.05\n";
    assert_eq!(text(&document, Table::Objectives), lines);
}

/// A file as an author could write it, and worse ones.
fn anything() -> impl Strategy<Value = Vec<u8>> {
    let piece = prop_oneof![
        4 => "[0-9]{1,3}(\\.[0-9])?",
        2 => Just(",".to_owned()),
        6 => Just(",".to_owned()),
        3 => prop_oneof![Just("\n".to_owned()), Just("\r\n".to_owned()), Just("\r".to_owned())],
        1 => prop_oneof![Just("\"".to_owned()), Just("\"a, b\"".to_owned()), Just("# note".to_owned()), Just(" ".to_owned())],
        1 => prop_oneof![Just("x,y,width,height\n".to_owned()), Just("width,x,what,y\n".to_owned()), Just("PLAYER,".to_owned())],
        1 => "\\PC{0,4}",
    ];
    prop::collection::vec(piece, 0..60).prop_map(|pieces| pieces.concat().into_bytes())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// Nothing done changes nothing, everything done can be undone and done again, a cell that was set holds its text, and no other cell of the
    /// level has changed.
    #[test]
    fn operations_change_what_they_are_about(
        file in anything(), of_world in any::<bool>(), steps in prop::collection::vec((0_u8..5, 0_usize..6, 0_usize..9, "[0-9a-z,\" #]{0,5}"), 1..25),
    ) {
        let table = if of_world { Table::World } else { Table::Objectives };
        let mut document = Document::new(|asked| (asked == table).then(|| file.clone()));
        prop_assert_eq!(document.bytes(table), Some(&file[..]));
        let mut states = vec![all_bytes(&document)];
        for (what, row, column, text) in steps {
            let row = RowId { table, row };
            let before = document.version();
            match what {
                0 | 1 => {
                    let Some(kind) = document.kind(row) else { continue };
                    let names: Vec<&str> = kind.schema().columns.iter().map(|column| column.name).collect();
                    let column = kind.schema().columns[column % names.len()].name;
                    if column == "kind" || column == "x" && text.trim().is_empty() { continue; }
                    let cells = |document: &Document| {
                        let cells = document.rows(table).flat_map(|row| names.iter().map(move |name| (row, *name)));
                        let other = cells.filter(|(r, name)| (*r, *name) != (row, column));
                        other.map(|(row, name)| document.cell(row, name).unwrap_or_default().to_owned()).collect::<Vec<_>>()
                    };
                    let others = cells(&document);
                    // Another cell would turn the first row into a header.
                    if document.set(&[SetCell { row, column, text: text.clone() }], None).is_ok() && document.rows(table).count() * names.len() == others.len() + 1 {
                        prop_assert_eq!(document.cell(row, column).unwrap_or_default(), text.trim());
                        prop_assert_eq!(cells(&document), others);
                    }
                }
                2 => drop(document.remove(&[row])),
                3 => drop(document.put(if of_world { Kind::Solid } else { Kind::Key }, Place { min: DVec2::ZERO, size: DVec2::ONE })),
                _ => drop(document.duplicate(&[row], DVec2::ONE, None)),
            }
            if document.version() != before {
                states.push(all_bytes(&document));
            }
        }
        for state in states[..states.len() - 1].iter().rev() {
            prop_assert!(document.undo());
            prop_assert_eq!(&all_bytes(&document), state);
        }
        prop_assert!(!document.undo());
        for state in &states[1..] {
            prop_assert!(document.redo());
            prop_assert_eq!(&all_bytes(&document), state);
        }
    }
}

fn document(files: &[(&str, &[u8])]) -> Document {
    Document::new(|table| files.iter().find(|(file, _)| *file == table.file()).map(|(_, bytes)| bytes.to_vec()))
}

#[test]
fn a_file_that_cannot_be_read_blocks_itself_alone() {
    let place = Place { min: DVec2::new(10.0, 10.0), size: DVec2::new(50.0, 20.0) };
    for bad in [&b"# Treibstoff f\xfcr das Schiff\n1,2,30,40,100\n"[..], b"1,2,30,40,\"100\n"] {
        let mut document = document(&[("pods.csv", bad)]);
        for kind in Kind::ADDED.into_iter().filter(|kind| *kind != Kind::Pod) {
            assert_eq!(document.put(kind, place).map(|row| row.is_some()), Ok(true), "{kind:?}");
        }
        let refused = document.put(Kind::Pod, place).unwrap_err();
        assert!(refused.contains("pods.csv"), "{refused}");
        assert_eq!(document.bytes(Table::Pods).unwrap(), bad);
    }
}

#[test]
fn a_name_takes_its_wires_along() {
    let files: [(&str, &[u8]); 4] = [
        ("doors.csv", b"1,2,3,4,gate\n9,2,3,4,gate\n"),
        ("movers.csv", b"x,y,width,height,way_points,speed,name\n1,2,3,4,5 6,1,lift\n"),
        ("hazards.csv", b"x,y,width,height,stream_width,stream_height,force_x,force_y,name\n1,2,3,4,0,9,0,5,fan\n"),
        ("switches.csv", b"# a comment\n1,2,3,4,gate !fan\n5,2,3,4,  lift\n"),
    ];
    let mut document = document(&files);
    let works = |document: &Document| {
        document.rows(Table::Switches).map(|row| document.cell(row, "works").unwrap().to_owned()).collect::<Vec<_>>()
    };
    let name = |document: &mut Document, table, row, text: &str, gesture| {
        let cell = SetCell { row: RowId { table, row }, column: "name", text: text.to_owned() };
        document.set(&[cell], Some(gesture)).unwrap();
    };
    // Typed letter by letter, past the name of another thing: one operation.
    for text in ["l", "li", "lif", "lift", "lifts", "lift s", ""] {
        name(&mut document, Table::Hazards, 0, text, 1);
    }
    assert_eq!(works(&document), ["gate !fan", "lift"], "a thing without a name of one word has no wire yet");
    name(&mut document, Table::Hazards, 0, "blow", 1);
    assert_eq!(works(&document), ["gate !blow", "lift"]);
    assert_eq!(document.history(), (1, 0));
    assert!(document.undo() && document.bytes(Table::Switches).unwrap() == files[3].1);
    assert!(document.redo());
    name(&mut document, Table::Doors, 1, "hatch", 2);
    name(&mut document, Table::Movers, 0, "raft", 3);
    assert_eq!(works(&document), ["gate hatch !blow", "raft"]);
    assert_eq!(document.wires().len(), 4);
    assert!((0..3).all(|_| document.undo()));
    for (file, bytes) in files {
        assert_eq!(document.bytes(Table::of_file(file).unwrap()).unwrap(), bytes, "{file}");
    }
}

#[test]
fn a_name_takes_the_ends_of_its_links_along() {
    let files: [(&str, &[u8]); 2] = [
        ("objects.csv", b"x,y,image,mass,name\n1,2,box:40x40,50,crate\n9,2,box:40x40,50,float\n"),
        ("links.csv", b"kind,a,b,stiffness\nrope,ship,crate,500\nspring,crate,float,500\nrope,float,600 300,500\n"),
    ];
    let mut document = document(&files);
    let ends = |document: &Document| {
        let ends = |row| ["a", "b"].map(|column| document.cell(row, column).unwrap().to_owned()).join("-");
        document.rows(Table::Links).map(ends).collect::<Vec<_>>()
    };
    for text in ["floa", "", "floa t", "raft"] {
        let cell = SetCell { row: RowId { table: Table::Objects, row: 1 }, column: "name", text: text.to_owned() };
        document.set(&[cell], Some(1)).unwrap();
        let name = if ["", "floa t"].contains(&text) { "float" } else { text };
        assert_eq!(ends(&document), ["ship-crate".to_owned(), format!("crate-{name}"), format!("{name}-600 300")]);
    }
    assert_eq!(document.history(), (1, 0));
    assert!(document.undo() && document.bytes(Table::Links).unwrap() == files[1].1);
}
