//! libudev, found when the program runs. The crate of this name links it when the program is built, which needs a package with its
//! headers; this one asks the system's loader for `libudev.so.1` at the first call. Where there is none every function says that it has
//! nothing, and `gilrs`, whose only way to it this is, goes without gamepads.
//!
//! The functions are those that `gilrs-core` calls, as libudev's manual declares them (`man 3 libudev`).

#![allow(non_camel_case_types)] // They bear libudev's names.
#![allow(clippy::missing_safety_doc)] // What each asks for is in libudev's manual.

use libc::{RTLD_LAZY, RTLD_LOCAL, c_char, c_int, c_void, dlopen, dlsym};
use std::ffi::CStr;
use std::ptr::null_mut;
use std::sync::OnceLock;

/// What libudev hands out pointers to.
macro_rules! handles {
    ($($name:ident)*) => {
        $(
            #[repr(C)]
            #[derive(Debug)]
            pub struct $name {
                nothing: [u8; 0],
            }
        )*
    };
}
handles!(udev udev_list_entry udev_device udev_monitor udev_enumerate);

/// The library; it stays loaded, so that what it handed out stays valid.
struct Library(*mut c_void);

// SAFETY: the handle is only passed to dlsym, which may be called from any thread.
unsafe impl Send for Library {}
// SAFETY: as above.
unsafe impl Sync for Library {}

fn symbol(name: &CStr) -> *mut c_void {
    static LIBRARY: OnceLock<Library> = OnceLock::new();
    // SAFETY: the name is a C string; libudev's initialisers have no conditions.
    let library = LIBRARY.get_or_init(|| Library(unsafe { dlopen(c"libudev.so.1".as_ptr(), RTLD_LAZY | RTLD_LOCAL) }));
    if library.0.is_null() {
        return null_mut();
    }
    // SAFETY: the handle comes from dlopen and is never closed; the name is a C string.
    unsafe { dlsym(library.0, name.as_ptr()) }
}

/// A function of libudev, and what it answers where there is no libudev.
macro_rules! functions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $result:ty, else $otherwise:expr;)*) => {
        $(
            #[doc = concat!("`", stringify!($name), "` of libudev.")]
            pub unsafe fn $name($($argument: $type),*) -> $result {
                static FOUND: OnceLock<Option<unsafe extern "C" fn($($type),*) -> $result>> = OnceLock::new();
                let found = FOUND.get_or_init(|| {
                    let symbol = symbol(unsafe { CStr::from_bytes_with_nul_unchecked(concat!(stringify!($name), "\0").as_bytes()) });
                    // SAFETY: a symbol of this name in libudev.so.1 is a function of this type.
                    (!symbol.is_null()).then(|| unsafe { std::mem::transmute::<*mut c_void, unsafe extern "C" fn($($type),*) -> $result>(symbol) })
                });
                match found {
                    // SAFETY: the caller keeps what libudev's manual asks for.
                    Some(function) => unsafe { function($($argument),*) },
                    None => $otherwise,
                }
            }
        )*
    };
}

functions! {
    udev_new() -> *mut udev, else null_mut();
    udev_ref(of: *mut udev) -> *mut udev, else null_mut();
    udev_unref(of: *mut udev) -> *mut udev, else null_mut();

    udev_list_entry_get_next(entry: *mut udev_list_entry) -> *mut udev_list_entry, else null_mut();
    udev_list_entry_get_name(entry: *mut udev_list_entry) -> *const c_char, else null_mut();
    udev_list_entry_get_value(entry: *mut udev_list_entry) -> *const c_char, else null_mut();

    udev_device_ref(device: *mut udev_device) -> *mut udev_device, else null_mut();
    udev_device_unref(device: *mut udev_device) -> *mut udev_device, else null_mut();
    udev_device_new_from_syspath(of: *mut udev, path: *const c_char) -> *mut udev_device, else null_mut();
    udev_device_get_syspath(device: *mut udev_device) -> *const c_char, else null_mut();
    udev_device_get_devnode(device: *mut udev_device) -> *const c_char, else null_mut();
    udev_device_get_action(device: *mut udev_device) -> *const c_char, else null_mut();
    udev_device_get_properties_list_entry(device: *mut udev_device) -> *mut udev_list_entry, else null_mut();
    udev_device_get_property_value(device: *mut udev_device, key: *const c_char) -> *const c_char, else null_mut();

    udev_monitor_new_from_netlink(of: *mut udev, name: *const c_char) -> *mut udev_monitor, else null_mut();
    udev_monitor_filter_add_match_subsystem_devtype(monitor: *mut udev_monitor, subsystem: *const c_char, devtype: *const c_char) -> c_int, else -1;
    udev_monitor_enable_receiving(monitor: *mut udev_monitor) -> c_int, else -1;
    udev_monitor_get_fd(monitor: *mut udev_monitor) -> c_int, else -1;
    udev_monitor_receive_device(monitor: *mut udev_monitor) -> *mut udev_device, else null_mut();
    udev_monitor_unref(monitor: *mut udev_monitor) -> *mut udev_monitor, else null_mut();

    udev_enumerate_new(of: *mut udev) -> *mut udev_enumerate, else null_mut();
    udev_enumerate_add_match_property(enumerate: *mut udev_enumerate, property: *const c_char, value: *const c_char) -> c_int, else -1;
    udev_enumerate_add_match_subsystem(enumerate: *mut udev_enumerate, subsystem: *const c_char) -> c_int, else -1;
    udev_enumerate_scan_devices(enumerate: *mut udev_enumerate) -> c_int, else -1;
    udev_enumerate_get_list_entry(enumerate: *mut udev_enumerate) -> *mut udev_list_entry, else null_mut();
    udev_enumerate_unref(enumerate: *mut udev_enumerate) -> *mut udev_enumerate, else null_mut();
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With libudev or without: nothing of it crashes, and what it hands out can be given back.
    #[test]
    fn the_devices_are_listed_where_there_is_a_libudev() {
        // SAFETY: the calls follow libudev's manual; nothing is used after it was given back.
        unsafe {
            let udev = udev_new();
            assert_eq!(udev.is_null(), symbol(c"udev_new").is_null());
            if udev.is_null() {
                return;
            }
            let enumerate = udev_enumerate_new(udev);
            assert_eq!(udev_enumerate_add_match_subsystem(enumerate, c"mem".as_ptr()), 0);
            udev_enumerate_scan_devices(enumerate);
            let mut entry = udev_enumerate_get_list_entry(enumerate);
            while !entry.is_null() {
                assert!(!udev_list_entry_get_name(entry).is_null());
                entry = udev_list_entry_get_next(entry);
            }
            udev_enumerate_unref(enumerate);
            udev_unref(udev);
        }
    }
}
