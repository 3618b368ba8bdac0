//! What was taken already, by content: SHA-256 of whole files, and of the lines that a growing file had.

use std::collections::{HashMap, HashSet};
use std::io;

use super::lines::{End, Lines, each_piece};
use crate::exchange::Body;
use crate::journal::chain::{FileHash, Hash};

/// The hashes of what was taken, and the name that each file had then.
#[derive(Debug, Clone, Default)]
pub struct Known {
    hashes: HashMap<Hash, String>,
    names: HashSet<String>,
    /// By name, the content that was taken last while this is running: a mark of everything up to the end of each line.
    marks: HashMap<String, Vec<u64>>,
}

/// A place in a file, and the hash of everything before it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Mark {
    pub(super) end: u64,
    pub(super) hash: Hash,
}

/// How far a file goes, and how much of it is known.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Extent {
    /// All of it.
    pub(super) whole: Mark,
    /// Its whole lines.
    pub(super) lines: Mark,
    /// As many whole lines behind the known ones as are taken at once, where it has more.
    pub(super) part: Option<Mark>,
    /// How many lines and bytes at its beginning were taken before from a file of its name.
    pub(super) known_lines: usize,
    pub(super) known_end: u64,
    /// The other name under which its beginning was taken, and how many lines that are.
    pub(super) begins_as: Option<(String, usize)>,
    /// How many lines at its beginning are those that were taken last from a file of its name.
    pub(super) same_lines: usize,
    /// Whether all its lines are, and there were more.
    pub(super) is_cut: bool,
    /// Whether all of it was taken before, under any name.
    pub(super) is_known: bool,
    marks: Vec<u64>,
}

/// What is known of a file that is gone through.
struct Search<'a> {
    known: &'a Known,
    name: &'a str,
    most: usize,
    lines: usize,
    extent: Extent,
}

impl Known {
    /// Remembers what was taken.
    pub fn add(&mut self, hash: Hash, name: &str) {
        self.names.insert(name.to_owned());
        self.hashes.insert(hash, name.to_owned());
    }

    /// Remembers the lines of a file, from which something was taken.
    pub(super) fn add_lines(&mut self, name: &str, extent: &Extent) {
        self.marks.insert(name.to_owned(), extent.marks.clone());
    }

    /// The name under which something was taken; empty where nobody said it.
    pub(super) fn name_of(&self, hash: &Hash) -> Option<&str> {
        self.hashes.get(hash).map(String::as_str)
    }

    /// Whether something was taken from a file of this name, and nothing since this is running.
    pub(super) fn is_from_before(&self, name: &str) -> bool {
        self.names.contains(name) && !self.marks.contains_key(name)
    }

    /// Remembers the files that an entry of a journal was made from, by its body: every SHA-256 in it that is named so. A budget or a
    /// program is no file of measurements, so it does no harm among them.
    pub fn see(&mut self, body: &[u8]) {
        const KEY: &[u8] = b"\",\"sha256\":\"";
        const NAME: &[u8] = b"\"name\":\"";
        for at in memchr::memmem::find_iter(body, KEY) {
            let hex = body.get(at + KEY.len()..).and_then(|rest| rest.get(..64));
            let hash = hex.and_then(|hex| std::str::from_utf8(hex).ok()).and_then(|hex| hex.parse().ok());
            let before = body.get(..at).unwrap_or_default();
            let name = memchr::memmem::rfind(before, NAME).and_then(|from| before.get(from + NAME.len()..));
            let name = name.map_or_else(String::new, |name| String::from_utf8_lossy(name).into_owned());
            if let Some(hash) = hash {
                self.add(hash, &name);
            }
        }
    }

    /// How many hashes there are.
    pub fn len(&self) -> usize {
        self.hashes.len()
    }

    /// Whether nothing was taken yet.
    pub fn is_empty(&self) -> bool {
        self.hashes.is_empty()
    }

    /// How much of a file is known; at most `most` lines behind that are a part of it. Lines count where they are said to end with
    /// something, and only those that were taken from a file of its name: the first lines of another part's file may be the same, and
    /// are other measurements.
    pub(super) fn extent(
        &self,
        name: &str,
        body: &mut dyn Body,
        line_ends: &'static [u8],
        most: usize,
    ) -> io::Result<Extent> {
        let (mut hash, mut lines) = (FileHash::default(), None);
        let mut search = Search { known: self, name, most, lines: 0, extent: Extent::default() };
        each_piece(body, &mut |piece| {
            let lines = lines.get_or_insert_with(|| Lines::new(piece, line_ends));
            let (begin, mut from) = (search.extent.whole.end, 0);
            for End { before, after, is_rest } in lines.ends(piece) {
                if !is_rest {
                    hash.see(piece.get(from..before).unwrap_or_default());
                    from = before;
                    search.line(Mark { end: begin + wide(before), hash: hash.clone().hash() });
                }
                hash.see(piece.get(from..after).unwrap_or_default());
                from = after;
                search.line_end(Mark { end: begin + wide(after), hash: hash.clone().hash() });
            }
            hash.see(piece.get(from..).unwrap_or_default());
            search.extent.whole.end += wide(piece.len());
        })?;
        Ok(search.end(hash.hash()))
    }
}

impl Search<'_> {
    /// A line is complete, but for its end.
    fn line(&mut self, mark: Mark) {
        self.lines += 1;
        self.see(mark);
        let short = short(&mark.hash);
        let before = self.known.marks.get(self.name).and_then(|marks| marks.get(self.extent.marks.len()));
        if self.extent.same_lines == self.extent.marks.len() && before == Some(&short) {
            self.extent.same_lines += 1;
        }
        self.extent.marks.push(short);
    }

    /// Its end, too. A last line may have been taken without it.
    fn line_end(&mut self, mark: Mark) {
        self.see(mark);
        self.extent.lines = mark;
        if self.lines == self.extent.known_lines + self.most {
            self.extent.part = Some(mark);
        }
    }

    fn see(&mut self, mark: Mark) {
        match self.known.name_of(&mark.hash) {
            Some(name) if name == self.name => {
                (self.extent.known_lines, self.extent.known_end) = (self.lines, mark.end);
                self.extent.part = None;
            }
            Some(other) => self.extent.begins_as = Some((other.to_owned(), self.lines)),
            None => {}
        }
    }

    fn end(self, hash: Hash) -> Extent {
        let Self { known, name, mut extent, .. } = self;
        extent.whole.hash = hash;
        extent.is_known = known.hashes.contains_key(&hash);
        let before = known.marks.get(name).map_or(0, Vec::len);
        extent.is_cut = extent.same_lines == extent.marks.len() && extent.marks.len() < before;
        extent.part = extent.part.filter(|part| part.end < extent.lines.end);
        extent
    }
}

/// Everything up to and with the line of this number, from 1; `None` where there is no such line.
///
/// # Errors
/// What the system says.
pub(super) fn until(body: &mut dyn Body, line_ends: &'static [u8], line: usize) -> io::Result<Option<Mark>> {
    let (mut hash, mut lines) = (FileHash::default(), None);
    let (mut begin, mut count, mut found) = (0, 0, None);
    each_piece(body, &mut |piece| {
        let lines = lines.get_or_insert_with(|| Lines::new(piece, line_ends));
        let mut from = 0;
        for End { after, is_rest, .. } in lines.ends(piece) {
            count += usize::from(!is_rest);
            if line < count {
                break;
            }
            hash.see(piece.get(from..after).unwrap_or_default());
            from = after;
            if count == line {
                found = Some(Mark { end: begin + wide(after), hash: hash.clone().hash() });
            }
        }
        if count < line {
            hash.see(piece.get(from..).unwrap_or_default());
        }
        begin += wide(piece.len());
    })?;
    Ok(found)
}

/// Enough of a hash to tell the beginnings of one file from another.
fn short(hash: &Hash) -> u64 {
    hash.0.first_chunk().map_or(0, |first| u64::from_be_bytes(*first))
}

/// A length as a place in a file.
fn wide(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    fn extent(known: &Known, name: &str, text: &str) -> Extent {
        known.extent(name, &mut Cursor::new(text), b"\n\r", 2).unwrap()
    }

    #[test]
    fn a_file_that_has_grown_is_known_up_to_the_lines_that_were_taken() {
        let mut known = Known::default();
        known.add(Hash::of_file(b"a\nb\n"), "a.csv");
        assert!(extent(&known, "a.csv", "a\nb\n").is_known);
        let grown = extent(&known, "a.csv", "a\nb\nc\nd");
        assert_eq!((grown.known_lines, grown.known_end), (2, 4));
        assert_eq!(grown.lines, Mark { end: 6, hash: Hash::of_file(b"a\nb\nc\n") });
        assert_eq!(grown.whole, Mark { end: 7, hash: Hash::of_file(b"a\nb\nc\nd") });
        assert_eq!(extent(&known, "a.csv", "a\nB\nc\n").known_lines, 0);
        assert_eq!(known.extent("a.csv", &mut Cursor::new("a\nb\nc\n"), b"", 2).unwrap().known_lines, 0);
        let other = extent(&known, "b.csv", "a\nb\nc\n");
        assert_eq!((other.known_lines, other.begins_as), (0, Some(("a.csv".to_owned(), 2))), "it begins so");
    }

    #[test]
    fn a_last_line_that_was_taken_without_its_end_is_known_with_any_end() {
        let mut known = Known::default();
        known.add(Hash::of_file(b"a\nb"), "a.csv");
        for grown in ["a\nb\nc\n", "a\nb\r\nc\n", "a\nb\rc\n"] {
            assert_eq!(extent(&known, "a.csv", grown).known_lines, 2, "{grown:?}");
        }
        assert_eq!(extent(&known, "a.csv", "a\nb1\n").known_lines, 0);
        known.add(Hash::of_file(b"a\r"), "r.csv");
        assert_eq!(extent(&known, "r.csv", "a\r\nb\n").known_lines, 1, "the LF came later");
    }

    #[test]
    fn a_file_that_is_written_anew_from_its_beginning_is_seen_to_be_cut() {
        let mut known = Known::default();
        let all = extent(&known, "a.csv", "a\nb\nc\n");
        known.add(all.whole.hash, "a.csv");
        known.add_lines("a.csv", &all);
        assert!(extent(&known, "a.csv", "a\nb\n").is_cut && extent(&known, "a.csv", "a\nb").is_cut);
        let other = extent(&known, "a.csv", "a\nB\n");
        assert_eq!((other.is_cut, other.same_lines), (false, 1));
        assert!(!extent(&known, "b.csv", "a\nb\n").is_cut);
    }

    #[test]
    fn a_part_ends_with_a_line() {
        let mut known = Known::default();
        assert_eq!(extent(&known, "a.csv", "a\nb\n").part, None);
        let part = Some(Mark { end: 4, hash: Hash::of_file(b"a\nb\n") });
        assert_eq!(extent(&known, "a.csv", "a\nb\nc\n").part, part);
        known.add(Hash::of_file(b"a\n"), "a.csv");
        assert_eq!(extent(&known, "a.csv", "a\nb\nc\nd\n").part.unwrap().end, 6);
        assert_eq!(until(&mut Cursor::new("a\nb\nc\n"), b"\n", 2).unwrap(), part);
        assert_eq!(until(&mut Cursor::new("a\nb"), b"\n", 2).unwrap(), None);
    }
}
