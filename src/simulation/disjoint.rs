//! Values that threads write side by side.

use std::{marker::PhantomData, ops::Range};

/// A slice that several threads write, each entry only one of them.
///
/// Which entries belong to whom follows from the mesh, not from their place, so that slices
/// cannot be handed out.
#[derive(Debug)]
pub(super) struct Disjoint<'a, T> {
    first: *mut T,
    len: usize,
    values: PhantomData<&'a mut [T]>,
}

// SAFETY: it is a reference to the slice, and callers of `entry` promise that no two threads
// hold the same entry
unsafe impl<T: Send> Sync for Disjoint<'_, T> {}

impl<'a, T> Disjoint<'a, T> {
    pub fn new(values: &'a mut [T]) -> Self {
        Self { first: values.as_mut_ptr(), len: values.len(), values: PhantomData }
    }

    /// Number of entries.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Entries to write that follow each other.
    ///
    /// # Safety
    /// Nobody else uses these entries while the result lives.
    ///
    /// # Panics
    /// If there are not so many entries.
    #[expect(clippy::mut_from_ref)]
    pub unsafe fn part(&self, range: Range<usize>) -> &mut [T] {
        assert!(range.start <= range.end && range.end <= self.len, "{range:?} of {}", self.len);
        // SAFETY: the range is within the slice; the caller's promise; the slice is borrowed for `'a`
        unsafe { std::slice::from_raw_parts_mut(self.first.add(range.start), range.len()) }
    }

    /// An entry to write.
    ///
    /// # Safety
    /// `index` is below [`Self::len`], and nobody else uses this entry while the result lives.
    #[inline(always)]
    #[expect(clippy::mut_from_ref)]
    pub unsafe fn entry(&self, index: usize) -> &mut T {
        debug_assert!(index < self.len);
        // SAFETY: the caller's promises; the slice is borrowed for `'a`
        unsafe { &mut *self.first.add(index) }
    }
}
