//! The editor with a level of 2000 blocks and 300 objects: a frame of a drag, the loader's look at what is edited, and keeping it beside the
//! files. A frame has 16.7 ms.

use criterion::{Criterion, criterion_group, criterion_main};
use resultant::level::document::{LevelFolder, RowId, Table};
use resultant::physics::DVec2;
use resultant::screens::{Editor, Input};
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
    let frame = |pointer, click, holding| Input { frame_time: 1.0 / 60.0, pointer, click, holding, ..Input::default() };
    editor.update(&frame(Default::default(), false, false));
    let at = editor.document().place(block).expect("it is there").centre();
    let mut x = 0.0;
    editor.update(&frame(editor.point(at), true, true));
    group.bench_function("drag", |bench| {
        bench.iter(|| {
            x = (x + 13.0) % 600.0;
            black_box(editor.update(&frame(editor.point(at + DVec2::new(x, 0.5 * x)), false, true)))
        });
    });
    group.bench_function("rest", |bench| bench.iter(|| black_box(editor.update(&frame(Default::default(), false, false)))));
    group.finish();
}

criterion_group!(benches, editor);
criterion_main!(benches);
