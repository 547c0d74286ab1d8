//! Lists the levels, experiments and assets of the repository as Rust, so that the program has them built in (`src/built_in.rs`),
//! and names the browser's target `browser`.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::Path;

const SHIPPED: [&str; 3] = ["assets", "experiments", "levels"];

fn main() {
    println!("cargo::rustc-check-cfg=cfg(browser)");
    let target = |part: &str| env::var(format!("CARGO_CFG_TARGET_{part}")).unwrap_or_default();
    // WebAssembly under WASI has files, a clock and a standard output.
    if target("ARCH") == "wasm32" && target("OS") == "unknown" {
        println!("cargo::rustc-cfg=browser");
    }
    let root = env::var("CARGO_MANIFEST_DIR").expect("cargo names the folder");
    let mut files = Vec::new();
    for folder in SHIPPED {
        list(Path::new(&root), folder, &mut files);
    }
    let mut list = String::from("&[\n");
    for file in files {
        writeln!(list, "    ({file:?}, include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {:?}))),", format!("/{file}"))
            .expect("a string takes text");
    }
    list.push(']');
    let out = env::var("OUT_DIR").expect("cargo names the folder");
    fs::write(Path::new(&out).join("shipped.rs"), list).expect("the folder can be written");
}

/// The files below a folder in order of their names, except hidden ones.
fn list(root: &Path, folder: &str, files: &mut Vec<String>) {
    println!("cargo::rerun-if-changed={folder}");
    let entries = fs::read_dir(root.join(folder)).expect("the folder comes with the program");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("it can be read").file_name().into_string().expect("text")).collect();
    names.sort_unstable();
    for name in names.into_iter().filter(|name| !name.starts_with('.')) {
        let path = format!("{folder}/{name}");
        if root.join(&path).is_dir() { list(root, &path, files) } else { files.push(path) }
    }
}
