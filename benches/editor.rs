//! The editor with a level of 2000 blocks and 300 objects: a frame of a drag with its picture, the loader's check, and keeping the edits beside
//! the files. A frame has 16.7 ms.

use criterion::{Criterion, criterion_group, criterion_main};
use resultant::draw::Canvas;
use resultant::draw::layout::{Frame, Vec2};
use resultant::level::document::{LevelFolder, RowId, Table};
use resultant::physics::DVec2;
use resultant::screens::{Editor, Input, Screen};
use resultant::ui::{Memory, PassInput};
use std::fmt::Write as _;
use std::fs;
use std::hint::black_box;

/// A level of `count` blocks and as many objects, in rows that leave room between them.
fn level(blocks: usize, objects: usize) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let (mut world, mut things) = ("x,y,width,height,material\n".to_owned(), String::new());
    for i in 0..blocks {
        let _ = writeln!(world, "{},{},60,20,Wood", 100 * (i % 50), 200 + 120 * (i / 50));
    }
    for i in 0..objects {
        let _ = writeln!(things, "{},{},box:30x30,20,1.05,FALSE,0.2", 100 * (i % 50) + 30, 185 + 120 * (i / 50));
    }
    let files = [
        ("constants.csv", "width,5200\nheight,5200\n"),
        ("player.csv", "60,60,100,500,3000\n"),
        ("objectives.csv", "PLAYER,4000,60,80,10\n"),
        ("world.csv", &world),
        ("objects.csv", &things),
    ];
    for (file, text) in files {
        fs::write(folder.path().join(file), text).expect("it is written");
    }
    folder
}

/// A frame of the editor: the pass that acts and the one that shows.
fn frame(editor: &mut Editor, (memory, canvas): (&mut Memory, &mut Canvas), (pointer, click, holding): (Vec2, bool, bool)) {
    let input = Input { frame_time: 1.0 / 60.0, pointer, click, holding, ..Input::default() };
    canvas.begin(input.frame, 1.0, false);
    memory.act(PassInput { input: &input, canvas, spectator: &mut (), time: 1.0 }, |ui| editor.show(ui));
    canvas.begin(input.frame, 1.0, false);
    memory.show(PassInput { input: &input.without_edges(), canvas, spectator: &mut (), time: 1.0 }, |ui| editor.show(ui));
}

fn editor(criterion: &mut Criterion) {
    let folder = level(2000, 300);
    let mut group = criterion.benchmark_group("editor");
    group.sample_size(30);
    let opened = LevelFolder::open(folder.path(), folder.path()).expect("it opens");
    group.bench_function("check", |bench| bench.iter(|| black_box(opened.folder.check(&opened.document).expect("it loads"))));
    let mut edited = opened.document.clone();
    let block = RowId { table: Table::World, row: 1000 };
    edited.set(&edited.shifted(block, DVec2::X), None).expect("it moves");
    group.bench_function("keep", |bench| bench.iter(|| opened.folder.keep(&edited).expect("it is kept")));
    opened.folder.forget();

    let mut editor = Editor::open(folder.path(), folder.path()).expect("it opens");
    let (mut memory, mut canvas) = (Memory::default(), Canvas::new(Frame::default()));
    let mut give = |editor: &mut Editor, pointer, click, holding| {
        frame(editor, (&mut memory, &mut canvas), (pointer, click, holding));
        black_box(canvas.shapes().len());
    };
    give(&mut editor, Vec2::ZERO, false, false);
    let at = editor.document().place(block).expect("it is there").centre();
    let mut x = 0.0;
    let held = editor.point(at);
    give(&mut editor, held, true, true);
    group.bench_function("drag", |bench| {
        bench.iter(|| {
            x = (x + 13.0) % 600.0;
            let pointer = editor.point(at + DVec2::new(x, 0.5 * x));
            give(&mut editor, pointer, false, true);
        });
    });
    group.bench_function("rest", |bench| bench.iter(|| give(&mut editor, Vec2::ZERO, false, false)));
    group.finish();
}

criterion_group!(benches, editor);
criterion_main!(benches);
