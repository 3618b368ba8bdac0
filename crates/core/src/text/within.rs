//! Pieces of texts and lists between places that were found in them, and counts in the width of files.

use std::slice::SliceIndex;

/// What lies between two places.
pub trait Within<Range> {
    /// What lies between places that were found here. A place beyond the end is a fault of the program: tests stop at it, and otherwise
    /// nothing is there.
    #[must_use]
    fn within(&self, range: Range) -> &Self;
}

impl<Range: SliceIndex<Self, Output = Self>> Within<Range> for str {
    #[inline]
    fn within(&self, range: Range) -> &Self {
        let found = self.get(range);
        debug_assert!(found.is_some(), "a place that is none of this text");
        found.unwrap_or("")
    }
}

impl<T, Range: SliceIndex<[T], Output = [T]>> Within<Range> for [T] {
    #[inline]
    fn within(&self, range: Range) -> &Self {
        let found = self.get(range);
        debug_assert!(found.is_some(), "a place that is none of this list");
        found.unwrap_or(&[])
    }
}

/// A count or a length in 64 bits: no machine counts further.
#[inline]
pub fn long(count: usize) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_between_two_places_is_found_in_texts_and_lists() {
        assert_eq!("25 H7".within(3..), "H7");
        assert_eq!("25 H7".within(..2), "25");
        assert_eq!([1, 2, 3].within(1..2), [2]);
        assert!(b"25".within(2..).is_empty());
    }

    #[test]
    #[cfg(debug_assertions)]
    #[should_panic = "a place that is none of this text"]
    fn a_place_beyond_the_end_is_a_fault() {
        let _nothing = "25".within(3..);
    }
}
