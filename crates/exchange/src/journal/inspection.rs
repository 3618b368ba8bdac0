//! Whether a chain is whole: entry by entry, and what has become of those that do not follow.

use fitcheck_core::message::{Say, printed};

use super::chain::{ChainId, Hash, Head, entry_hash};
use super::entry::Kept;

/// So many numbers the entries behind a break may be off and are still recognised.
const FARTHEST: i64 = 32;
/// So many breaks are named; more are counted.
const MOST: usize = 100;

/// Where a chain breaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "journal-break")]
pub enum Break {
    /// The entry is not the one that was written, or its hash is not.
    Changed {
        #[say(with = printed)]
        number: u64,
    },
    /// Entries are missing before this one.
    Removed {
        /// The number of the first missing entry.
        #[say(with = printed)]
        number: u64,
        /// How many are missing.
        count: u64,
    },
    /// The entry was not written by this journal: those behind it follow the one before it.
    Inserted {
        #[say(with = printed)]
        number: u64,
    },
    /// Two entries have changed places.
    Reordered {
        /// The number of the first.
        #[say(with = printed)]
        number: u64,
        #[say(with = printed)]
        other: u64,
    },
    /// The entry's own bytes and place are whole, and a head that was kept elsewhere tells of another one: the journal was written anew
    /// from there or before.
    Rewritten {
        #[say(with = printed)]
        number: u64,
    },
    /// The chain ends before an entry of which a head elsewhere tells: its newest entries were cut off, or an older copy was put back.
    CutOff {
        #[say(with = printed)]
        last: u64,
        /// The number that is known elsewhere.
        #[say(with = printed)]
        known: u64,
    },
}

impl Break {
    /// The number of the first entry that is not what was written.
    pub const fn number(&self) -> u64 {
        match self {
            Self::Changed { number }
            | Self::Removed { number, .. }
            | Self::Inserted { number }
            | Self::Reordered { number, .. }
            | Self::Rewritten { number } => *number,
            Self::CutOff { last, .. } => last.saturating_add(1),
        }
    }
}

/// Looks at the entries of a chain, in the order of their numbers.
///
/// The first entry that does not follow is a break. What happened is told by the entry behind it: where that one follows it under another
/// number, entries were removed or inserted before it; where it follows the one before it, it was inserted.
#[derive(Debug)]
pub struct Inspection {
    chain: ChainId,
    known: Vec<Head>,
    /// The last entry that is taken as it is, with the number that it was written with.
    head: Head,
    /// The number that an entry was written with, minus the number that it has.
    shift: i64,
    /// An entry that does not follow, until the next one tells why.
    waiting: Option<Kept>,
    seen: u64,
    last: Head,
    breaks: Vec<Break>,
    count: u64,
}

/// What was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Inspected {
    /// How many entries were looked at.
    pub entries: u64,
    /// The last one, with the number that it has.
    pub head: Head,
    /// Where the chain breaks: the first hundred, first numbers first.
    pub breaks: Vec<Break>,
    /// How many breaks there are.
    pub count: u64,
}

impl Inspection {
    /// Before the first entry; `known` are heads of this chain that were kept elsewhere.
    pub fn new(chain: ChainId, known: &[Head]) -> Self {
        Self {
            chain,
            known: known.iter().copied().filter(|head| 0 < head.number).collect(),
            head: Head::default(),
            shift: 0,
            waiting: None,
            seen: 0,
            last: Head::default(),
            breaks: Vec::new(),
            count: 0,
        }
    }

    /// Looks at the next entry.
    pub fn see(&mut self, number: u64, body: &[u8], hash: Hash) {
        self.seen = self.seen.saturating_add(1);
        if let Some(failed) = self.waiting.take()
            && self.explain(&failed, Some((number, body, hash)))
        {
            self.last = Head { number, hash };
            return;
        }
        let next = self.shifted(self.last.number.saturating_add(1), 0);
        let written = self.shifted(number, 0);
        if next < written && self.last.number.saturating_add(1) < number {
            let first = self.last.number.saturating_add(1);
            self.tell(Break::Removed { number: first, count: number.saturating_sub(first) });
            // Nobody knows what it was hashed over.
            self.head = Head { number: written, hash };
        } else if self.follows(self.head, body, hash) {
            self.head = Head { number: self.head.number.saturating_add(1), hash };
        } else {
            self.waiting = Some(Kept { head: Head { number, hash }, body: body.into() });
        }
        self.last = Head { number, hash };
        if self.waiting.is_none() {
            self.compare(number, hash);
        }
    }

    /// What was found, after the last entry.
    pub fn finish(mut self) -> Inspected {
        if let Some(failed) = self.waiting.take() {
            let _is_taken = self.explain(&failed, None);
        }
        let last = self.last.number;
        if let Some(known) = self.known.iter().map(|head| head.number).max().filter(|known| last < *known) {
            self.tell(Break::CutOff { last, known });
        }
        self.breaks.sort_by_key(Break::number);
        Inspected { entries: self.seen, head: self.last, breaks: self.breaks, count: self.count }
    }

    /// What has become of an entry that does not follow. Answers whether the next one is thereby looked at, too.
    fn explain(&mut self, failed: &Kept, next: Option<(u64, &[u8], Hash)>) -> bool {
        let Head { number, hash } = failed.head;
        if let Some((_number, body, next_hash)) = next {
            let as_it_is = self.hashed(self.head, &failed.body);
            if let Some(as_it_is) = as_it_is.filter(|as_it_is| self.follows(*as_it_is, body, next_hash)) {
                // The entry is whole, and its hash is not.
                self.tell(Break::Changed { number });
                self.head = as_it_is;
                return false;
            }
            let nearest = (1..=FARTHEST).flat_map(|far| [far, -far]);
            for shift in std::iter::once(0).chain(nearest) {
                let here = Head { number: self.shifted(number, shift), hash };
                if !self.follows(here, body, next_hash) {
                    continue;
                }
                let count = shift.unsigned_abs();
                match shift {
                    0 => self.tell(Break::Changed { number }),
                    1.. => self.tell(Break::Removed { number, count }),
                    _ => {
                        for back in 1..=count {
                            self.tell(Break::Inserted { number: number.saturating_sub(back) });
                        }
                    }
                }
                self.shift = self.shift.saturating_add(shift);
                self.head = here;
                return false;
            }
            if self.follows(self.head, body, next_hash) {
                let after_next = Head { number: self.head.number.saturating_add(1), hash: next_hash };
                if self.follows(after_next, &failed.body, hash) {
                    self.tell(Break::Reordered { number, other: number.saturating_add(1) });
                    self.head = Head { number: after_next.number.saturating_add(1), hash };
                    return true;
                }
                self.tell(Break::Inserted { number });
                self.shift = self.shift.saturating_sub(1);
                return false;
            }
        }
        self.tell(Break::Changed { number });
        self.head = Head { number: self.shifted(number, 0), hash };
        false
    }

    /// The head that an entry with this body makes; `None` where no entry can have it.
    fn hashed(&self, before: Head, body: &[u8]) -> Option<Head> {
        let hash = entry_hash(self.chain, before, body)?;
        Some(Head { number: before.number.saturating_add(1), hash })
    }

    fn follows(&self, before: Head, body: &[u8], hash: Hash) -> bool {
        entry_hash(self.chain, before, body) == Some(hash)
    }

    /// The number that an entry was written with.
    fn shifted(&self, number: u64, more: i64) -> u64 {
        number.saturating_add_signed(self.shift.saturating_add(more))
    }

    /// Compares an entry that follows with what is known of it elsewhere.
    fn compare(&mut self, number: u64, hash: Hash) {
        if self.known.iter().any(|known| known.number == number && known.hash != hash) {
            self.tell(Break::Rewritten { number });
        }
    }

    fn tell(&mut self, found: Break) {
        self.count = self.count.saturating_add(1);
        if self.breaks.len() < MOST {
            self.breaks.push(found);
        }
    }
}
