//! An allocator that remembers the largest piece that anybody asked for.
//!
//! A test file that asks for it makes it its own:
//! `#[global_allocator] static ALLOCATOR: Watched = Watched;`

use std::{
    alloc::{GlobalAlloc, Layout, System},
    sync::atomic::{AtomicUsize, Ordering},
};

/// Most bytes that one allocation may take for a file of a few kilobytes.
pub const LARGEST_ALLOCATION: usize = 64 << 20;

/// The system's allocator, watched.
pub struct Watched;

static LARGEST: AtomicUsize = AtomicUsize::new(0);

/// The largest piece so far, bytes.
pub fn largest() -> usize {
    LARGEST.load(Ordering::Relaxed)
}

// SAFETY: all calls are handed to the system's allocator as they are.
unsafe impl GlobalAlloc for Watched {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        LARGEST.fetch_max(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller keeps the allocator's contract.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps the allocator's contract.
        unsafe { System.dealloc(pointer, layout) }
    }
}
