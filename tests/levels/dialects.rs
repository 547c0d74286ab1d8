//! One level, whatever spreadsheet saved its files.

use crate::fixtures;
use crate::spreadsheets::saved;
use crate::support::Memory;
use resultant::level::document::{Document, NewRow, RowId, SetCell};
use resultant::level::schema::{Kind, Table};
use resultant::level::{self, FILES, Level, Problem};

fn plain() -> [(&'static str, String); 18] {
    let folder = fixtures().join("levels/good_every_table");
    let tables = FILES.into_iter().filter(|name| name.ends_with(".csv"));
    let read = tables.map(|name| (name, std::fs::read_to_string(folder.join(name)).unwrap()));
    read.collect::<Vec<_>>().try_into().unwrap()
}

fn with(file: &str, text: &[u8]) -> Vec<(&'static str, Vec<u8>)> {
    plain().map(|(name, plain)| (name, if name == file { text.to_vec() } else { plain.into() })).into()
}

fn read(files: &[(&'static str, Vec<u8>)]) -> Result<Level, Vec<Problem>> {
    level::read("l", &Memory(files.to_vec())).map(|loaded| loaded.level)
}

/// Whether a cell is a number, or several, which a spreadsheet does not touch.
fn is_number(text: &str) -> bool {
    !text.is_empty() && text.split([' ', ';']).filter(|part| !part.is_empty()).all(|part| part.parse::<f64>().is_ok())
}

fn without_header(name: &str, text: &str) -> String {
    // The columns of links.csv stand in another order than without a header.
    if name == "links.csv" { text.to_owned() } else { text.split_once('\n').unwrap().1.to_owned() }
}

#[test]
fn every_file_of_every_spreadsheet_is_the_same_level() {
    let level = read(&with("", b"")).unwrap();
    assert_eq!((level.gravity, level.pods[0].fuel, level.movers[0].stops.len(), level.hints.len()), (9.5, 100.5, 4, 2));
    for headers in [true, false] {
        let files = plain().map(|(name, text)| {
            let text = if headers { text } else { without_header(name, &text) };
            saved(&text, is_number).into_iter().map(move |saved| (name, saved)).collect::<Vec<_>>()
        });
        for form in 0..files[0].len() {
            let found = read(&files.each_ref().map(|file| (file[form].0, file[form].1.bytes.clone())));
            assert_eq!(found.as_ref(), Ok(&level), "{}, headers: {headers}", files[0][form].1.form);
        }
    }
}

#[test]
fn numbers_and_truths_of_other_languages_are_read() {
    let mut files = plain();
    let plain = level::read("l", &Memory(files.to_vec())).unwrap();
    assert!(plain.dialects.is_empty());
    for (name, text) in [
        ("player.csv", "x;y;mass;fuel;thrust;air;vx\n150,5;600,0;100;500;2\u{202f}500;WAHR;\u{2212}0,25\n"),
        ("world.csv", "x,y,width,height,material\n0,680,1\u{a0}280,40,Ice\u{a0}\n\u{a0}840,440.5,100,20.0,\n"),
        (
            "hazards.csv",
            "x\ty\twidth\theight\tstream_width\tstream_height\tforce_x\tforce_y\tshaded\tname\n20\t100\t20\t20\t200\t0\t1,55E+01\t0\tVRAI\tfan\n",
        ),
        (
            "objectives.csv",
            "PLAYER;1000;420;100;10;1,5;1,0\nPHYS;300;670;100;10;0;2.0\nOBJECT;400;600;ball:40x40;75;181,0;49;201;0,5;0,1\n",
        ),
    ] {
        files.iter_mut().find(|(file, _)| *file == name).unwrap().1 = text.to_owned();
    }
    let read = level::read("l", &Memory(files.to_vec())).unwrap();
    assert_eq!(read.level, plain.level);
    let expected = [("player.csv", "semicolons"), ("objectives.csv", "semicolons"), ("hazards.csv", "tabs")];
    assert_eq!(read.dialects, expected.map(|(file, dialect)| (file, dialect.to_owned())));
}

#[test]
fn a_hint_with_a_comma_needs_no_quotes_where_nothing_else_parts_cells() {
    for text in ["text\r\nErst links, dann rechts\r\nNur Mut\r\n", "Erst links, dann rechts\n# a, b, c\nNur Mut\n"] {
        assert_eq!(read(&with("hints.csv", text.as_bytes())).unwrap().hints, ["Erst links, dann rechts", "Nur Mut"]);
    }
}

#[test]
fn refusals_in_other_dialects_name_line_column_unit_and_limits() {
    let told = |file: &str, text: &[u8]| {
        read(&with(file, text)).unwrap_err().iter().map(|problem| format!("{problem}\n")).collect::<String>()
    };
    let names = "kind,x,y,width,height,[hold],[order],[r],[g],[b]";
    let order = format!(
        "kind\": found a header with its columns in another order, expected {names}: the columns of these rows never change places"
    );
    for (file, text, found) in [
        (
            "pods.csv",
            "x;y;width;height;fuel\r\n\r\n# \r\n1,5;2;3;4;-1,5\r\n",
            "4: column \"fuel\": found \"-1,5\", expected a number of 0 or more fuel units",
        ),
        (
            "pods.csv",
            "x;y;width;height;fuel\n1,5;2;3;vier;4\n",
            "2: column \"height\": found \"vier\", expected a number such as 12.5",
        ),
        ("pods.csv", "x;y;width;height;fuel\n1,5;2;3;4;nan\n", "2: column \"fuel\": found \"nan\", expected a finite number"),
        (
            "pods.csv",
            "fuel\ty\tx\twidth\theight\n\"1\n\"\t2\t3\t4\t\n",
            "3: column \"height\": found nothing, expected a number such as 12.5",
        ),
        (
            "pods.csv",
            "x;y;width;height;fuel\n1;2;3;4;5\n1,2,3,4,5\n",
            "3: column \"x\": found cells separated by commas, expected cells separated by semicolons, as in the rest of the file",
        ),
        (
            "objectives.csv",
            "PLAYER;1000;420;100;10;1,5\nGOAL;1;2;3;4\n",
            "2: column \"kind\": found \"GOAL\", expected one of PLAYER, PHYS, OBJECT",
        ),
        ("objectives.csv", "kind;x;y;width;height;order;hold\nPLAYER;1000;420;100;10;1;3\n", &format!("1: column \"{order}")),
    ] {
        assert_eq!(told(file, text.as_bytes()), format!("{file}:{found}\n"));
    }
    let excel = "Excel: Save As, CSV UTF-8";
    for (text, found) in [
        (&b"x|y|width|height|fuel\n1|2|3|4|5\n"[..], "cells separated by |"),
        (b"sep=|\n1|2|3|4|5\n", "another separator in the line sep="),
        (b"700,620,30,40,100,\xfc\n", "letters that are not UTF-8"),
        (b"1\x00,\x002\x00\n\x00", "a file saved as UTF-16 without a byte-order mark"),
        (b"\xff\xfe1\x00,\x00\n", "letters that are not UTF-8"),
        (b"PK\x03\x04", "a spreadsheet's own file"),
        (b"\xd0\xcf\x11\xe0", "a spreadsheet's own file"),
    ] {
        let told = told("pods.csv", text);
        let names = [found, excel, "LibreOffice"].iter().all(|words| told.contains(words));
        assert!(told.starts_with("pods.csv:1: ") && names, "{told}");
    }
}

#[test]
fn numbers_without_their_names_and_a_ship_among_objects_are_explained() {
    let told = |file: &str, text: &str| {
        read(&with(file, text.as_bytes())).unwrap_err().iter().map(|problem| format!("{problem}\n")).collect::<String>()
    };
    let bare = told("constants.csv", "9.81\n1.2\n");
    assert!(bare.contains("constants.csv:1: column \"value\": found 1 cell in the row, expected 2: name,value; a name says what the number is, such as gravity,9.81 or air_density,9.81"), "{bare}");
    let ship = told("objects.csv", "50,50,100   \n100,100,box:40x40,150,0.5,TRUE,0.35\n");
    assert!(ship.starts_with("objects.csv:1: "), "{ship}");
    assert!(ship.contains("; the ship stands in player.csv: x,y,mass,fuel,thrust,"), "{ship}");
}

fn edited(bytes: Vec<u8>) -> Document {
    let mut document = Document::new(|table| (table == Table::World).then(|| bytes.clone()));
    let row = RowId { table: Table::World, row: 0 };
    let cell = |column, text: &str| SetCell { row, column, text: text.into() };
    document.set(&[cell("y", "2.25"), cell("belt", "0.5")], None).unwrap();
    let new = [("x", "7.5"), ("y", "8"), ("width", "9"), ("height", "10")].map(|(column, text)| (column, text.to_owned()));
    document.add(&[NewRow { kind: Kind::Solid, cells: new.to_vec() }]).unwrap();
    document.remove(&[RowId { table: Table::World, row: 1 }]).unwrap();
    document
}

#[test]
fn the_editor_writes_in_the_dialect_of_the_file() {
    let after = |text: &str| String::from_utf8(edited(text.into()).bytes(Table::World).unwrap().to_vec()).unwrap();
    let edited = "sep=;\r\nx;y;width;height;belt\r\n1,5;2,25;3;4;0,5 \r\n7,5;8;9;10\r\n";
    assert_eq!(after("sep=;\r\nx;y;width;height\r\n1,5;2;3;4 \r\n5;6;7;8\r\n"), edited);
    assert_eq!(after("1.5;2;3;4\n5;6;7;8\n"), "1.5;2.25;3;4;;;0.5\n7.5;8;9;10\n", "decimal points stay");
    assert_eq!(after("1;2;3;4\n5;6;7;8\n"), "1;2,25;3;4;;;0,5\n7,5;8;9;10\n");
    assert_eq!(after("1\t2\t3\t4\n5\t6\t7\t8\n"), "1\t2.25\t3\t4\t\t\t0.5\n7.5\t8\t9\t10\n");
}

#[test]
fn what_the_editor_writes_is_one_file_in_every_form() {
    let plain = "x,y,width,height,belt\n1.5,2,3,4,\n5,6,7,8,\n";
    for saved in saved(plain, is_number) {
        let document = edited(saved.bytes);
        let cell = |row, column| document.cell(RowId { table: Table::World, row }, column).unwrap_or_default().to_owned();
        let found = [(0, "x"), (0, "y"), (0, "belt"), (1, "x"), (1, "height")].map(|(row, column)| cell(row, column));
        assert_eq!(found, ["1.5", "2.25", "0.5", "7.5", "10"], "{}", saved.form);
        let again = Document::new(|table| document.bytes(table).map(<[u8]>::to_vec));
        assert_eq!(again.rows(Table::World).count(), 2, "{}", saved.form);
        assert_eq!(again.cell(RowId { table: Table::World, row: 1 }, "x"), Some("7.5"), "{}", saved.form);
    }
}

#[test]
fn settings_of_a_german_file_are_written_as_it_writes_them() {
    let bytes = "name;value\r\ntitle;Version 1.5\r\ngravity;9,81\r\n".as_bytes().to_vec();
    let mut document = Document::new(|table| (table == Table::Constants).then(|| bytes.clone()));
    let rows: Vec<RowId> = document.rows(Table::Constants).collect();
    assert_eq!(document.cell(rows[1], "value"), Some("9.81"));
    let set = |row, text: &str| SetCell { row, column: "value", text: text.into() };
    document.set(&[set(rows[0], "Version 1.6"), set(rows[1], "1.62")], None).unwrap();
    assert_eq!(document.bytes(Table::Constants).unwrap(), "name;value\r\ntitle;Version 1.6\r\ngravity;1,62\r\n".as_bytes());
}
