//! Libraries of the system that are looked up when the program runs.
//!
//! Unsafe code: loading runs a library's own initialisers, and only who asks for a function knows its type.
#![allow(unsafe_code)]

use libloading::Library;
use std::ffi::CStr;

/// It stays loaded until the program ends, so that its functions never vanish.
pub fn library(name: &str) -> Option<&'static Library> {
    // SAFETY: the libraries of sound, keyboard and display, which any program may load.
    let library = unsafe { Library::new(name) }.ok()?;
    Some(Box::leak(Box::new(library)))
}

/// # Safety
/// `F` must be the type of a function pointer that fits what the library has under that name.
pub unsafe fn function<F: Copy>(library: &'static Library, name: &CStr) -> Option<F> {
    // SAFETY: as the caller promises; the pointer is copied out, and the library stays.
    unsafe { library.get::<F>(name) }.ok().map(|symbol| *symbol)
}
