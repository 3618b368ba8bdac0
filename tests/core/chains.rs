//! A chain of entries: its hashes by a second implementation, and what is found of it when somebody was at it.

use fitcheck::journal::chain::{ChainId, Hash, Head, entry_hash};
use fitcheck::journal::inspection::{Break, Inspected, Inspection};
use proptest::prelude::*;

type Entry = (u64, Vec<u8>, Hash);

fn name() -> ChainId {
    ChainId(std::array::from_fn(|place| u8::try_from(place).unwrap()))
}

/// A chain of entries as they were written.
fn chain(bodies: &[&[u8]]) -> Vec<Entry> {
    let mut head = Head::default();
    let next = |body: &&[u8]| {
        let hash = entry_hash(name(), head, body).unwrap();
        head = Head { number: head.number + 1, hash };
        (head.number, body.to_vec(), hash)
    };
    bodies.iter().map(next).collect()
}

fn of_length(count: u64) -> Vec<Entry> {
    let bodies: Vec<Vec<u8>> = (1..=count).map(|number| format!("entry {number}").into_bytes()).collect();
    chain(&bodies.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

fn inspect_beside(entries: &[Entry], known: &[Head]) -> Inspected {
    let mut inspection = Inspection::new(name(), known);
    for (number, body, hash) in entries {
        inspection.see(*number, body, *hash);
    }
    inspection.finish()
}

fn inspect(entries: &[Entry]) -> Vec<Break> {
    inspect_beside(entries, &[]).breaks
}

/// The same entries with numbers from 1 without gaps.
fn numbered(entries: Vec<Entry>) -> Vec<Entry> {
    (1..).zip(entries).map(|(number, (_old, body, hash))| (number, body, hash)).collect()
}

/// Computed with Python: `sha256(b"fitcheck entry 1\0" + previous + pack(">I", 16) + chain + pack(">Q", number) + pack(">I", len(body)) + body)`
/// with the chain 00 01 … 0f.
#[test]
fn hashes_are_those_of_a_second_implementation() {
    let hashes: Vec<String> =
        chain(&[b"{\"v\":1}", "Ø 25 H7".as_bytes(), b""]).iter().map(|(_, _, hash)| hash.to_string()).collect();
    assert_eq!(
        hashes,
        [
            "341614bbf7f715ca42f7ae3abf28a819705ed5c94b169ccb36ed6629818f4d9b",
            "c2777fb0b7b6918db47bd4300c56376eb8fdf22cacb235610551854ea329c320",
            "b5a545e3097e2e80c4324c04234a87e7d03dff12c549c7f5476ce99a5cb5c56d"
        ]
    );
}

#[test]
fn a_hash_reads_back_and_nothing_else_does() {
    let hash = Hash::of_file(b"abc");
    // FIPS 180-2, appendix B.1.
    assert_eq!(hash.to_string(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    assert_eq!(hash.to_string().parse(), Ok(hash));
    assert_eq!(hash.short(), "ba7816bf");
    for wrong in ["", "ba", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015a", "é".repeat(32).as_str()]
    {
        let error = wrong.parse::<Hash>().unwrap_err();
        assert_eq!(error.digits, 64, "{wrong}");
    }
}

#[test]
fn a_whole_chain_has_no_break() {
    for count in [0, 1, 2, 3, 50] {
        let entries = of_length(count);
        let head = entries.last().map_or_else(Head::default, |(number, _, hash)| Head { number: *number, hash: *hash });
        let found = inspect_beside(&entries, &[head]);
        assert_eq!(found, Inspected { entries: count, head, breaks: Vec::new(), count: 0 });
    }
}

#[test]
fn what_was_cut_off_is_found_beside_a_head_that_was_kept() {
    let entries = of_length(5);
    let head = Head { number: 5, hash: entries[4].2 };
    assert_eq!(inspect_beside(&entries[..3], &[head]).breaks, [Break::CutOff { last: 3, known: 5 }]);
    assert_eq!(inspect_beside(&entries[..3], &[]).breaks, []);
}

#[test]
fn a_chain_that_was_written_anew_is_found_beside_a_head_that_was_kept() {
    let written = of_length(5);
    let mut bodies: Vec<&[u8]> = written.iter().map(|(_, body, _)| body.as_slice()).collect();
    bodies[2] = b"another one";
    let anew = chain(&bodies);
    assert_eq!(inspect(&anew), []);
    let known = [Head { number: 2, hash: written[1].2 }, Head { number: 4, hash: written[3].2 }];
    assert_eq!(inspect_beside(&anew, &known).breaks, [Break::Rewritten { number: 4 }]);
}

#[test]
fn several_breaks_are_named_in_their_order() {
    let mut entries = of_length(30);
    entries[4].1 = b"changed".to_vec();
    entries.remove(9);
    entries[20].2 = Hash::default();
    let breaks = inspect(&entries);
    let removed = Break::Removed { number: 10, count: 1 };
    assert_eq!(breaks, [Break::Changed { number: 5 }, removed, Break::Changed { number: 22 }]);
}

proptest! {
    /// Somebody changes one byte of a body.
    #[test]
    fn a_changed_byte_is_named(count in 1_u64..40, place in any::<prop::sample::Index>(), byte in any::<prop::sample::Index>()) {
        let mut entries = of_length(count);
        let at = place.index(entries.len());
        let byte = byte.index(entries[at].1.len());
        entries[at].1[byte] ^= 1;
        let number = entries[at].0;
        prop_assert_eq!(inspect(&entries), [Break::Changed { number }]);
    }

    /// Somebody removes entries and leaves the gap, or closes it.
    #[test]
    fn removed_entries_are_named(count in 3_u64..60, place in any::<prop::sample::Index>(), gone in 1_usize..30, closed in any::<bool>()) {
        let mut entries = of_length(count);
        let at = place.index(entries.len() - 2);
        let gone = gone.min(entries.len() - at - 2);
        prop_assume!(0 < gone);
        entries.drain(at..at + gone);
        let expected = Break::Removed { number: u64::try_from(at).unwrap() + 1, count: u64::try_from(gone).unwrap() };
        let entries = if closed { numbered(entries) } else { entries };
        prop_assert_eq!(inspect(&entries), [expected]);
    }

    /// Somebody inserts an entry and moves the others on, with a hash that follows or with any.
    #[test]
    fn an_inserted_entry_is_named(count in 3_u64..40, place in any::<prop::sample::Index>(), follows in any::<bool>()) {
        let mut entries = of_length(count);
        let at = place.index(entries.len() - 1);
        let before = at.checked_sub(1).map_or_else(Head::default, |before| Head { number: entries[before].0, hash: entries[before].2 });
        let hash = if follows { entry_hash(name(), before, b"inserted").unwrap() } else { Hash([7; 32]) };
        entries.insert(at, (0, b"inserted".to_vec(), hash));
        let number = u64::try_from(at).unwrap() + 1;
        prop_assert_eq!(inspect(&numbered(entries)), [Break::Inserted { number }]);
    }

    /// Somebody lets two neighbours change places.
    #[test]
    fn entries_that_changed_places_are_named(count in 2_u64..40, place in any::<prop::sample::Index>()) {
        let mut entries = of_length(count);
        let at = place.index(entries.len() - 1);
        entries.swap(at, at + 1);
        let number = u64::try_from(at).unwrap() + 1;
        prop_assert_eq!(inspect(&numbered(entries)), [Break::Reordered { number, other: number + 1 }]);
    }

    /// Whatever is done, the first entry that is not what was written is not passed over.
    #[test]
    fn no_change_is_passed_over(
        count in 1_u64..30,
        changes in prop::collection::vec((0_u8..5, any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..4),
    ) {
        let written = of_length(count);
        let head = written.last().map(|(number, _, hash)| Head { number: *number, hash: *hash }).unwrap();
        let mut entries = written.clone();
        for (kind, place, other) in changes {
            if entries.is_empty() {
                break;
            }
            let (at, to) = (place.index(entries.len()), other.index(entries.len()));
            match kind {
                0 => entries[at].1.push(b'x'),
                1 => drop(entries.remove(at)),
                2 => entries.insert(at, entries[to].clone()),
                3 => entries.swap(at, to),
                _ => entries[at].2.0[0] ^= 1,
            }
        }
        let entries = numbered(entries);
        let found = inspect_beside(&entries, &[head]);
        prop_assert_eq!(found.breaks.is_empty(), entries == written, "{:?}", found);
        if let Some(first) = found.breaks.first() {
            let differs = entries.iter().zip(&written).position(|(one, other)| one != other).unwrap_or(entries.len().min(written.len()));
            prop_assert!(first.number() <= u64::try_from(differs).unwrap() + 2, "{:?}", found);
        }
    }
}
