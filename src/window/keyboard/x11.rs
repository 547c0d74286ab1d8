//! X11's keyboard. miniquad tells of a key what it types alone and nothing of its place, and of a dead key nothing at all: this reads the
//! presses as they come from the server, on the display that miniquad opened.
//!
//! Unsafe code: the functions and types below are those of `X11/Xlib.h`, `X11/Xlibint.h` and `X11/XKBlib.h` (libX11 6), `GL/glx.h` and
//! `xkbcommon/xkbcommon.h`, compatible since before 2010; miniquad itself loads the same libraries, and they stay. All of it runs on the
//! thread of the window, which is the only one that uses the display.
#![allow(unsafe_code)]

use crate::settings::{Key, Keys, layout};
use crate::system_library::{function, library};
use crate::ui::keyboard::{KeyDown, Keyboard, MARKS, alone};
use std::collections::VecDeque;
use std::ffi::{c_char, c_int, c_long, c_uchar, c_uint, c_ulong, c_void};
use std::sync::{Mutex, OnceLock, PoisonError};

const KEY_PRESS: c_int = 2;
const KEY_RELEASE: c_int = 3;
const FOCUS_IN: c_int = 9;
const FOCUS_OUT: c_int = 10;
/// Which keys are down: right after each `FOCUS_IN` where it is asked for.
const KEYMAP_NOTIFY: c_int = 11;
const MAPPING_NOTIFY: c_int = 34;
const READ: [c_int; 6] = [KEY_PRESS, KEY_RELEASE, FOCUS_IN, FOCUS_OUT, KEYMAP_NOTIFY, MAPPING_NOTIFY];
const KEYMAP_STATE_MASK: c_long = 1 << 14;
/// From the codes of PC keyboards to those of X11.
const CODES: u8 = 8;

/// `XEvent`
#[derive(Clone, Copy)]
#[repr(C)]
union Event {
    kind: c_int,
    key: KeyEvent,
    keymap: KeymapEvent,
    room: [c_long; 24],
}

/// `XKeyEvent`
#[derive(Clone, Copy)]
#[repr(C)]
struct KeyEvent {
    kind: c_int,
    serial: c_ulong,
    send_event: c_int,
    display: *mut c_void,
    window: c_ulong,
    root: c_ulong,
    subwindow: c_ulong,
    time: c_ulong,
    places: [c_int; 4],
    state: c_uint,
    keycode: c_uint,
    same_screen: c_int,
}

/// `XKeymapEvent`
#[derive(Clone, Copy)]
#[repr(C)]
struct KeymapEvent {
    kind: c_int,
    serial: c_ulong,
    send_event: c_int,
    display: *mut c_void,
    window: c_ulong,
    down: [u8; 32],
}

/// `XWindowAttributes`
#[repr(C)]
struct WindowAttributes {
    measures: [c_int; 6],
    visual: *mut c_void,
    root: c_ulong,
    kinds: [c_int; 4],
    backing: [c_ulong; 2],
    save_under: c_int,
    colormap: c_ulong,
    map: [c_int; 2],
    all_events: c_long,
    events: c_long,
    not_propagated: c_long,
    override_redirect: c_int,
    screen: *mut c_void,
}

type WireToEvent = unsafe extern "C" fn(*mut c_void, *mut Event, *mut c_void) -> c_int;

struct Functions {
    lookup: unsafe extern "C" fn(*mut KeyEvent, *mut c_char, c_int, *mut c_ulong, *mut c_void) -> c_int,
    keysym: unsafe extern "C" fn(*mut c_void, c_uchar, c_int, c_int) -> c_ulong,
    refresh: unsafe extern "C" fn(*mut Event) -> c_int,
    attributes: unsafe extern "C" fn(*mut c_void, c_ulong, *mut WindowAttributes) -> c_int,
    select: unsafe extern "C" fn(*mut c_void, c_ulong, c_long) -> c_int,
    character: unsafe extern "C" fn(u32) -> u32,
    pending: unsafe extern "C" fn(*mut c_void) -> c_int,
}

/// What the server has sent and nobody has taken.
static EVENTS: Mutex<VecDeque<Sent>> = Mutex::new(VecDeque::new());
static MAKERS: [OnceLock<WireToEvent>; MAPPING_NOTIFY as usize + 1] = [const { OnceLock::new() }; MAPPING_NOTIFY as usize + 1];

struct Sent(Event);
// SAFETY: its pointer is read on the thread of the window alone.
unsafe impl Send for Sent {}

/// Makes an event of what the server has sent, as before, and keeps a copy.
unsafe extern "C" fn make(display: *mut c_void, event: *mut Event, wire: *mut c_void) -> c_int {
    // SAFETY: Xlib hands over an event on the wire, whose first byte is its kind, and room for what is made of it.
    unsafe {
        let kind = *wire.cast::<u8>() & 0x7f;
        let Some(maker) = MAKERS.get(usize::from(kind)).and_then(OnceLock::get) else { return 0 };
        let made = maker(display, event, wire);
        if made != 0 {
            EVENTS.lock().unwrap_or_else(PoisonError::into_inner).push_back(Sent(*event));
        }
        made
    }
}

/// The keyboard of the display that is drawn to.
pub struct System {
    display: *mut c_void,
    functions: Functions,
    /// Whether codes are those of PC keyboards.
    pc: bool,
    /// The layout in use, of those that the player has chosen.
    group: c_int,
    /// Whether the window tells which keys are down as it gets the focus.
    selected: bool,
    focused: bool,
}

impl System {
    /// `None` where the window is not drawn by GLX, or a library lacks a function.
    pub fn new() -> Option<Self> {
        let [x11, gl, xkb] = ["libX11.so.6", "libGL.so.1", "libxkbcommon.so.0"].map(library);
        let (x11, gl, xkb) = (x11?, gl?, xkb?);
        // SAFETY: the types are those of the headers named above.
        let (display, functions, set_maker) = unsafe {
            let current: unsafe extern "C" fn() -> *mut c_void = function(gl, c"glXGetCurrentDisplay")?;
            let set: unsafe extern "C" fn(*mut c_void, c_int, Option<WireToEvent>) -> Option<WireToEvent> =
                function(x11, c"XESetWireToEvent")?;
            let functions = Functions {
                lookup: function(x11, c"XLookupString")?,
                keysym: function(x11, c"XkbKeycodeToKeysym")?,
                refresh: function(x11, c"XRefreshKeyboardMapping")?,
                attributes: function(x11, c"XGetWindowAttributes")?,
                select: function(x11, c"XSelectInput")?,
                character: function(xkb, c"xkb_keysym_to_utf32")?,
                pending: function(x11, c"XPending")?,
            };
            (current(), functions, set)
        };
        if display.is_null() {
            return None;
        }
        for kind in READ {
            // SAFETY: the display is open, and `make` hands all events on to what made them before.
            if let Some(before) = unsafe { set_maker(display, kind, Some(make)) } {
                let _ = MAKERS[kind as usize].set(before);
            }
        }
        let mut system = Self { display, functions, pc: true, group: 0, selected: false, focused: false };
        system.learn();
        Some(system)
    }

    /// Whether the server has sent something that nobody has read.
    pub fn has_news(&self) -> bool {
        // SAFETY: the display is open, and only reads what is there.
        unsafe { (self.functions.pending)(self.display) != 0 }
    }

    pub fn drain(&mut self, keyboard: &mut Keyboard) {
        loop {
            let sent = EVENTS.lock().unwrap_or_else(PoisonError::into_inner).pop_front();
            let Some(Sent(event)) = sent else { break };
            self.take(event, keyboard);
        }
    }

    fn take(&mut self, mut event: Event, keyboard: &mut Keyboard) {
        // SAFETY: each kind of event is read as what it is.
        unsafe {
            match event.kind {
                KEY_PRESS => {
                    self.select(event.key.window);
                    self.press(event.key, keyboard);
                }
                KEY_RELEASE => keyboard.up(event.key.keycode),
                FOCUS_IN => {
                    self.select(event.key.window);
                    self.focused = true;
                    keyboard.leave();
                }
                FOCUS_OUT => keyboard.leave(),
                KEYMAP_NOTIFY if std::mem::take(&mut self.focused) => {
                    let down = event.keymap.down;
                    keyboard.come_back((0..256_u32).filter(|code| down[*code as usize / 8] >> (code % 8) & 1 != 0));
                }
                MAPPING_NOTIFY => {
                    (self.functions.refresh)(&raw mut event);
                    self.learn();
                }
                _ => {}
            }
        }
    }

    /// Asks to be told which keys are down as the window gets the focus.
    fn select(&mut self, window: c_ulong) {
        if std::mem::replace(&mut self.selected, true) {
            return;
        }
        // SAFETY: the window is of this display, and zeros are attributes.
        unsafe {
            let mut attributes: WindowAttributes = std::mem::zeroed();
            if (self.functions.attributes)(self.display, window, &raw mut attributes) != 0 {
                (self.functions.select)(self.display, window, attributes.events | KEYMAP_STATE_MASK);
            }
        }
    }

    fn press(&mut self, mut event: KeyEvent, keyboard: &mut Keyboard) {
        let (code, group) = (event.keycode as u8, (event.state >> 13 & 3) as c_int);
        if self.group != group {
            self.group = group;
            self.learn();
        }
        let mut keysym = 0;
        // SAFETY: the event is whole, and no text is asked for.
        unsafe { (self.functions.lookup)(&raw mut event, std::ptr::null_mut(), 0, &raw mut keysym, std::ptr::null_mut()) };
        let plain = self.character(self.keysym(code, group));
        let printing = code.checked_sub(CODES).and_then(|code| layout::printing().find(|(known, _)| *known == code));
        let place = match named(self.keysym(code, 0)) {
            None if self.pc => printing.map(|(_, key)| key),
            None => plain.and_then(Key::typing),
            named => named,
        };
        let modifiers = [(1, Key::Shift), (4, Key::Control), (64, Key::Control), (8, Key::Alt), (128, Key::Alt)];
        let held = modifiers.into_iter().filter(|(bit, _)| event.state & bit != 0).map(|(_, key)| key).collect::<Keys>();
        keyboard.down(KeyDown {
            id: event.keycode,
            place,
            typed: self.character(keysym),
            plain,
            silent: false,
            repeat: false,
            held,
        });
    }

    fn keysym(&self, code: u8, group: c_int) -> c_ulong {
        // SAFETY: the display is open; a code without a key has the keysym 0.
        unsafe { (self.functions.keysym)(self.display, code, group, 0) }
    }

    /// What a keysym types; a combining mark for a dead key.
    fn character(&self, keysym: c_ulong) -> Option<char> {
        if let Some((_, (mark, ..))) = DEAD.iter().zip(MARKS).find(|(dead, _)| **dead == keysym) {
            return Some(mark);
        }
        // SAFETY: it takes any number.
        let character = unsafe { (self.functions.character)(u32::try_from(keysym).ok()?) };
        char::from_u32(character).filter(|character| !character.is_control())
    }

    fn learn(&mut self) {
        self.pc = self.keysym(65, 0) == 0x20 && self.keysym(111, 0) == 0xff52;
        for (code, place) in layout::printing().filter(|_| self.pc) {
            if let Some(sign) = self.character(self.keysym(code + CODES, self.group)) {
                layout::note(place, alone(sign));
            }
        }
    }
}

/// Dead keys, in the order of the marks that they put on letters.
const DEAD: [c_ulong; MARKS.len()] = [
    0xfe50, 0xfe51, 0xfe52, 0xfe53, 0xfe54, 0xfe55, 0xfe56, 0xfe57, 0xfe61, 0xfe58, 0xfe59, 0xfe5a, 0xfe60, 0xfe5b, 0xfe5c, 0xfe62,
];

/// The key of a keysym that types no character, or is on the number pad.
fn named(keysym: c_ulong) -> Option<Key> {
    let numbered = |start: &str, number: c_ulong| Key::named(&format!("{start}{number}"));
    Some(match keysym {
        0x20 => Key::Space,
        0xff08 => Key::Backspace,
        0xff09 => Key::Tab,
        0xff0d | 0xff8d => Key::Enter,
        0xff1b => Key::Escape,
        0xff50..=0xff57 => {
            use Key::{Down, End, Home, Left, PageDown, PageUp, Right, Up};
            [Home, Left, Up, Right, Down, PageUp, PageDown, End][keysym as usize - 0xff50]
        }
        0xff63 => Key::Insert,
        0xffff => Key::Delete,
        0xffaa => Key::KpMultiply,
        0xffab => Key::KpAdd,
        0xffad => Key::KpSubtract,
        0xffaf => Key::KpDivide,
        0xff9f | 0xffac | 0xffae => Key::KpDecimal,
        0xff95..=0xff9e => return numbered("Kp", [7, 4, 8, 6, 2, 9, 3, 1, 5, 0][keysym as usize - 0xff95]),
        0xffb0..=0xffb9 => return numbered("Kp", keysym - 0xffb0),
        0xffbe..=0xffc9 => return numbered("F", keysym - 0xffbd),
        0xffe1 | 0xffe2 => Key::Shift,
        0xffe3 | 0xffe4 => Key::Control,
        // With what chooses the third level: AltGr.
        0xffe9 | 0xffea | 0xfe03 | 0xff7e => Key::Alt,
        _ => return None,
    })
}
