//! Lists the levels with the experiments, assets and charts of the repository as Rust, so that the program has them built in (`src/built_in.rs`),
//! names the browser's target `browser`, and the engine's sources by a hash of their lines.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::Path;

const SHIPPED: [&str; 3] = ["assets", "docs/charts", "levels"];
/// Charts that no screen reads: pictures, and what other files were made of.
const LEFT_OUT: [&str; 6] = [".svg", ".md", "/peers.csv", "/shipped.csv", "/stability.csv", "/stability-limits.csv"];

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
    files.retain(|file| !file.starts_with("docs/") || !LEFT_OUT.iter().any(|end| file.ends_with(end)));
    let (mut sources, mut hash) = (Vec::new(), 0xcbf2_9ce4_8422_2325_u64); // FNV-1a
    list(Path::new(&root), "src/physics", &mut sources);
    for file in sources.iter().filter(|file| file.ends_with(".rs") && !file.ends_with("tests.rs")) {
        let text = fs::read_to_string(Path::new(&root).join(file)).expect("sources are text");
        let code = text.lines().map(str::trim).filter(|line| !line.starts_with("//"));
        hash = code.flat_map(str::bytes).fold(hash, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
    }
    println!("cargo::rustc-env=PHYSICS_SOURCES={hash:016x}");
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
