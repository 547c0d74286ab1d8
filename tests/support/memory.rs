//! An allocator that counts, for one thread at a time: tests run beside each other.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The system's allocator, with counts for each thread.
pub struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
    /// Bytes. Memory that one thread takes and another gives back counts as taken in the one and as given back in the other.
    static HELD: Cell<isize> = const { Cell::new(0) };
    static MOST: Cell<isize> = const { Cell::new(0) };
}

/// How often this thread has allocated something so far.
pub fn allocations() -> usize {
    ALLOCATIONS.get()
}

/// The most bytes that this thread holds at once during the call, beyond its bytes before.
pub fn most_held<T>(during: impl FnOnce() -> T) -> (isize, T) {
    let before = HELD.get();
    MOST.set(before);
    let done = during();
    (MOST.get() - before, done)
}

#[allow(unsafe_code)]
// SAFETY: every call is handed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        HELD.set(HELD.get() + layout.size() as isize);
        MOST.set(MOST.get().max(HELD.get()));
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        HELD.set(HELD.get() - layout.size() as isize);
        unsafe { System.dealloc(at, layout) }
    }
}
