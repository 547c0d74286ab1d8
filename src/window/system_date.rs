//! The system's date for this program goes on evenly, whatever the system's clock is set to meanwhile. At the end of each frame macroquad's scene
//! makes up for all time since the last one at 60 steps a second of the date, and no setting turns that off: a clock that is set ahead by a year
//! costs 6 s, one before 1970 ends the program. So the date is that of the first call and the time since: off by as much as the clock was set since.
//!
//! Unsafe code: the function below has the name and the type of POSIX, and takes its place for all code that is linked into the program;
//! what does not ask for the date goes to the system's own.
#![allow(unsafe_code)]

use libc::{CLOCK_BOOTTIME, CLOCK_REALTIME, c_int, c_void, clockid_t, timespec};
use std::ptr;
use std::sync::atomic::{AtomicI64, AtomicPtr, Ordering};

type ClockGettime = unsafe extern "C" fn(clockid_t, *mut timespec) -> c_int;

/// Nanoseconds a second.
const NANO: i64 = 1_000_000_000;
/// What no offset is.
const UNKNOWN: i64 = i64::MIN;

static SYSTEM: AtomicPtr<c_void> = AtomicPtr::new(ptr::null_mut());
/// From the time since the system began to the date, nanoseconds.
static OFFSET: AtomicI64 = AtomicI64::new(UNKNOWN);

/// # Safety
/// As POSIX says: `time` has room.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn clock_gettime(clock: clockid_t, time: *mut timespec) -> c_int {
    // SAFETY: the system's function takes what the caller has given.
    unsafe {
        let Some(system) = system() else { return -1 };
        if clock != CLOCK_REALTIME {
            return system(clock, time);
        }
        let mut since_boot = timespec { tv_sec: 0, tv_nsec: 0 };
        if system(CLOCK_BOOTTIME, &raw mut since_boot) != 0 {
            return system(clock, time);
        }
        if OFFSET.load(Ordering::Relaxed) == UNKNOWN {
            let answer = system(clock, time);
            if answer != 0 {
                return answer;
            }
            let offset = nanoseconds(*time).saturating_sub(nanoseconds(since_boot));
            let _ = OFFSET.compare_exchange(UNKNOWN, offset, Ordering::Relaxed, Ordering::Relaxed);
        }
        let date = nanoseconds(since_boot).saturating_add(OFFSET.load(Ordering::Relaxed));
        *time = timespec { tv_sec: date.div_euclid(NANO), tv_nsec: date.rem_euclid(NANO) };
        0
    }
}

/// Has the function above linked in: a linker leaves out what nobody names.
pub fn keep() {
    std::hint::black_box::<ClockGettime>(clock_gettime);
}

/// The function that this one stands before.
fn system() -> Option<ClockGettime> {
    let mut found = SYSTEM.load(Ordering::Relaxed);
    if found.is_null() {
        // SAFETY: the name ends with 0.
        found = unsafe { libc::dlsym(libc::RTLD_NEXT, c"clock_gettime".as_ptr()) };
        SYSTEM.store(found, Ordering::Relaxed);
    }
    // SAFETY: the system's function of that name has that type.
    (!found.is_null()).then(|| unsafe { std::mem::transmute::<*mut c_void, ClockGettime>(found) })
}

/// A date beyond the year 2262 is the last that fits.
const fn nanoseconds(time: timespec) -> i64 {
    time.tv_sec.saturating_mul(NANO).saturating_add(time.tv_nsec)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_asks_this_function_which_knows_the_systems_date() {
        assert!(libc::clock_gettime as ClockGettime as usize == clock_gettime as ClockGettime as usize);
        let mut dates = [timespec { tv_sec: 0, tv_nsec: 0 }; 3];
        // SAFETY: there is room.
        let status = unsafe {
            let [before, date, after] = &mut dates;
            let system = system().unwrap();
            [system(CLOCK_REALTIME, before), clock_gettime(CLOCK_REALTIME, date), system(CLOCK_REALTIME, after)]
        };
        let [before, date, after] = dates.map(nanoseconds);
        assert!(status == [0; 3] && before - NANO < date && date < after + NANO, "{before} {date} {after}");
        // SAFETY: there is room.
        let status = unsafe { clock_gettime(CLOCK_REALTIME, &raw mut dates[0]) };
        assert!(status == 0 && nanoseconds(dates[0]) >= date, "it never goes back");
    }

    #[test]
    fn dates_before_1970_are_dates() {
        assert_eq!(nanoseconds(timespec { tv_sec: -2, tv_nsec: 500_000_000 }), -1_500_000_000);
        assert_eq!(nanoseconds(timespec { tv_sec: i64::MAX, tv_nsec: 0 }), i64::MAX);
    }
}
