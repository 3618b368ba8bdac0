//! Numbers of entries as ranges: the checks of a report mostly follow each other.

use std::fmt;

/// Numbers of entries: ranges from the first to the last one, ascending, and no number twice.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct EntryRanges(Vec<[u64; 2]>);

impl EntryRanges {
    /// These numbers, in whatever order they come, each once.
    pub fn of(numbers: impl IntoIterator<Item = u64>) -> Self {
        let mut numbers: Vec<u64> = numbers.into_iter().collect();
        numbers.sort_unstable();
        numbers.dedup();
        let mut ranges: Vec<[u64; 2]> = Vec::new();
        for number in numbers {
            match ranges.last_mut() {
                Some([_, last]) if last.checked_add(1) == Some(number) => *last = number,
                _ => ranges.push([number, number]),
            }
        }
        Self(ranges)
    }

    /// These ranges; `None` where one ends before it begins, or does not begin after the one before it ends. Entries count from 1.
    pub fn read(ranges: Vec<[u64; 2]>) -> Option<Self> {
        let mut before = 0;
        for [first, last] in &ranges {
            if *first <= before || last < first {
                return None;
            }
            before = *last;
        }
        Some(Self(ranges))
    }

    /// The ranges: first and last number of each.
    pub fn ranges(&self) -> &[[u64; 2]] {
        &self.0
    }

    /// Whether there is no number.
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many numbers there are.
    pub fn count(&self) -> u64 {
        let counts = self.0.iter().map(|[first, last]| last.saturating_sub(*first).saturating_add(1));
        counts.fold(0, u64::saturating_add)
    }

    /// The largest number.
    pub fn last(&self) -> Option<u64> {
        self.0.last().map(|[_, last]| *last)
    }

    pub fn contains(&self, number: u64) -> bool {
        let after = self.0.partition_point(|[first, _]| *first <= number);
        let range = after.checked_sub(1).and_then(|at| self.0.get(at));
        range.is_some_and(|[_, last]| number <= *last)
    }

    /// Every number, ascending. Whoever reads them from a journal stops at its last entry: what a body claims may have no end.
    pub fn numbers(&self) -> impl Iterator<Item = u64> {
        self.0.iter().flat_map(|[first, last]| *first..=*last)
    }
}

/// `2, 4 to 8`
impl fmt::Display for EntryRanges {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, [first, last]) in self.0.iter().enumerate() {
            let comma = if at == 0 { "" } else { ", " };
            write!(f, "{comma}{first}")?;
            if first < last {
                write!(f, " to {last}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_a_row_are_one_range_and_each_is_in_it_once() {
        let ranges = EntryRanges::of([9, 2, 3, 3, 4, 7]);
        assert_eq!(ranges.ranges(), [[2, 4], [7, 7], [9, 9]]);
        assert_eq!(ranges.to_string(), "2 to 4, 7, 9");
        assert_eq!(ranges.count(), 5);
        assert_eq!(ranges.numbers().collect::<Vec<_>>(), [2, 3, 4, 7, 9]);
        assert_eq!((1..=10).filter(|number| ranges.contains(*number)).count(), 5);
        assert_eq!(EntryRanges::of([]), EntryRanges::default());
    }

    #[test]
    fn ranges_that_overlap_or_go_back_are_none() {
        assert!(EntryRanges::read(vec![[2, 4], [5, 5], [7, 9]]).is_some());
        for wrong in [vec![[0, 1]], vec![[2, 1]], vec![[2, 4], [4, 5]], vec![[5, 6], [2, 3]]] {
            assert_eq!(EntryRanges::read(wrong), None);
        }
        let all = EntryRanges::read(vec![[1, u64::MAX]]).unwrap();
        assert_eq!((all.count(), all.contains(u64::MAX)), (u64::MAX, true));
    }
}
