//! The program: everything it does is in the library.

#[cfg(not(all(target_arch = "wasm32", target_os = "unknown")))]
fn main() -> std::process::ExitCode {
    resultant::cli::main()
}

/// A page has no command line.
#[cfg(all(target_arch = "wasm32", target_os = "unknown"))]
fn main() {
    resultant::window::open_page();
}
