//! What was taken already, by content: SHA-256 of whole files, and of the lines that a growing file had.

use std::collections::HashMap;
use std::io;

use fitcheck_core::message::Message;
use fitcheck_exchange::exchange::Body;
use fitcheck_exchange::journal::chain::{FileHash, Hash};

use super::lines::{End, Lines, each_piece};

/// The hashes of what was taken, and the names that the files had then.
#[derive(Debug, Clone, Default)]
pub struct Known {
    hashes: HashMap<Hash, Vec<String>>,
    /// By name, what was taken last.
    names: HashMap<String, Hash>,
    /// By name, the lines that were taken last while this is running.
    lines: HashMap<String, Taken>,
    /// By name, what is to be said of values that were taken too early.
    late: HashMap<String, Vec<Message>>,
}

/// The lines that a file had when something was taken from it: a mark of everything up to the end of each.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Taken {
    marks: Vec<u64>,
    /// Whether the last one had no end: more may have come to it.
    is_open: bool,
}

/// A place in a file, how many lines come before it, and the hash of all of that.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Mark {
    pub(super) end: u64,
    pub(super) lines: usize,
    pub(super) hash: Hash,
}

/// How far a file goes, and how much of it is known.
#[expect(clippy::struct_excessive_bools, reason = "each answers another question about the file")]
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Extent {
    pub(super) whole: Mark,
    /// Its whole lines.
    pub(super) lines: Mark,
    /// As many whole lines behind the known ones as are taken at once, where it has more.
    pub(super) part: Option<Mark>,
    /// Its beginning that was taken before from a file of its name.
    pub(super) known: Mark,
    /// Whether something else was taken from a file of its name since, as far as that is known from before this is running.
    pub(super) is_older: bool,
    /// The other name under which its beginning was taken, and how many lines that are.
    pub(super) begins_as: Option<(String, usize)>,
    /// How many lines at its beginning are those that were taken last from a file of its name.
    pub(super) same_lines: usize,
    /// Whether all its whole lines are, and there were more; and whether its last line without an end is, too.
    pub(super) is_cut: bool,
    pub(super) is_cut_whole: bool,
    /// Whether it took the place of a file of its name that had other lines.
    pub(super) is_replaced: bool,
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

impl Extent {
    /// A mark of everything up to the end of each line, for so many of them.
    pub(super) fn marks(&self, lines: usize) -> Vec<u64> {
        self.marks.get(..lines).unwrap_or(&self.marks).to_vec()
    }

    /// Whether a place is the end of the file within a line.
    pub(super) fn is_within_line(&self, mark: &Mark) -> bool {
        self.lines.end < self.whole.end && mark.end == self.whole.end
    }
}

impl Known {
    /// Remembers what was taken.
    pub fn add(&mut self, hash: Hash, name: &str) {
        self.names.insert(name.to_owned(), hash);
        let names = self.hashes.entry(hash).or_default();
        if names.iter().all(|known| known != name) {
            names.push(name.to_owned());
        }
    }

    /// Remembers the lines of a file, from which something was taken.
    pub(super) fn add_lines(&mut self, name: &str, marks: Vec<u64>, is_open: bool) {
        self.lines.insert(name.to_owned(), Taken { marks, is_open });
    }

    /// A file got another name: what was taken from it was taken from a file of that name, too.
    pub(super) fn rename(&mut self, before: &str, now: &str) {
        let Some(taken) = self.lines.remove(before) else { return };
        self.lines.insert(now.to_owned(), taken);
        if let Some(hash) = self.names.get(before) {
            self.names.insert(now.to_owned(), *hash);
        }
        for names in self.hashes.values_mut().filter(|names| names.iter().any(|name| name == before)) {
            if names.iter().all(|name| name != now) {
                names.push(now.to_owned());
            }
        }
    }

    /// What is to be said of values of a file that were taken too early.
    pub(super) fn late(&self, name: &str) -> &[Message] {
        self.late.get(name).map(Vec::as_slice).unwrap_or_default()
    }

    /// Remembers that, or that there is nothing more to be said.
    pub(super) fn set_late(&mut self, name: &str, late: Vec<Message>) {
        if late.is_empty() {
            self.late.remove(name);
        } else {
            self.late.insert(name.to_owned(), late);
        }
    }

    /// Whether it is known which lines were taken last from a file of this name.
    pub(super) fn has_lines(&self, name: &str) -> bool {
        self.lines.contains_key(name)
    }

    /// The name under which something was taken, this one where it was that among others; empty where nobody said it.
    pub(super) fn name_of(&self, hash: &Hash, name: &str) -> Option<&str> {
        let names = self.hashes.get(hash)?;
        names.iter().find(|known| *known == name).or(names.last()).map(String::as_str)
    }

    /// Whether something was taken from a file of this name, and nothing since this is running.
    pub(super) fn is_from_before(&self, name: &str) -> bool {
        self.names.contains_key(name) && !self.has_lines(name)
    }

    /// Remembers the files that an entry of a journal was made from, by its body: every SHA-256 in it that is named so. A budget or a
    /// program is no file of measurements, so it does no harm among them.
    pub fn see(&mut self, body: &[u8]) {
        const KEY: &[u8] = b"\",\"sha256\":\"";
        const NAME: &[u8] = b"\"name\":";
        for at in memchr::memmem::find_iter(body, KEY) {
            let hex = body.get(at + KEY.len()..).and_then(|rest| rest.get(..64));
            let hash = hex.and_then(|hex| std::str::from_utf8(hex).ok()).and_then(|hex| hex.parse().ok());
            // The quotation mark at the end of the name is the first sign of the key.
            let before = body.get(..=at).unwrap_or_default();
            let name = memchr::memmem::rfind(before, NAME).and_then(|from| before.get(from + NAME.len()..));
            let name = name.and_then(|name| serde_json::from_slice::<String>(name).ok()).unwrap_or_default();
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
                    search.line(begin + wide(before), hash.clone().hash());
                }
                hash.see(piece.get(from..after).unwrap_or_default());
                from = after;
                search.line_end(begin + wide(after), hash.clone().hash());
            }
            hash.see(piece.get(from..).unwrap_or_default());
            search.extent.whole.end += wide(piece.len());
        })?;
        Ok(search.end(hash.hash()))
    }
}

impl Search<'_> {
    /// A line is complete, but for its end.
    fn line(&mut self, end: u64, hash: Hash) {
        self.lines += 1;
        self.see(Mark { end, lines: self.lines, hash });
        self.push(short(&hash));
    }

    fn push(&mut self, short: u64) {
        let before = self.known.lines.get(self.name).and_then(|taken| taken.marks.get(self.extent.marks.len()));
        if self.extent.same_lines == self.extent.marks.len() && before == Some(&short) {
            self.extent.same_lines += 1;
        }
        self.extent.marks.push(short);
    }

    /// Its end, too. A last line may have been taken without it.
    fn line_end(&mut self, end: u64, hash: Hash) {
        let mark = Mark { end, lines: self.lines, hash };
        self.see(mark);
        self.extent.lines = mark;
        if self.lines == self.extent.known.lines + self.most {
            self.extent.part = Some(mark);
        }
    }

    fn see(&mut self, mark: Mark) {
        match self.known.name_of(&mark.hash, self.name) {
            Some(name) if name == self.name => {
                self.extent.known = mark;
                self.extent.part = None;
            }
            Some(other) => self.extent.begins_as = Some((other.to_owned(), mark.lines)),
            None => {}
        }
    }

    fn end(mut self, hash: Hash) -> Extent {
        let taken = self.known.lines.get(self.name);
        let before = taken.map_or(0, |taken| taken.marks.len());
        self.extent.is_cut = self.extent.same_lines == self.extent.marks.len() && self.extent.marks.len() < before;
        let has_tail = self.extent.lines.end < self.extent.whole.end;
        if has_tail {
            self.push(short(&hash));
        }
        let Self { known, name, lines, mut extent, .. } = self;
        extent.whole = Mark { lines: lines + usize::from(has_tail), hash, ..extent.whole };
        extent.is_cut_whole = extent.is_cut && extent.same_lines == extent.marks.len();
        // More may have come to a last line without an end: it is another one then, and the file still the same.
        let sure = before - usize::from(taken.is_some_and(|taken| taken.is_open));
        extent.is_replaced = extent.same_lines < sure && !extent.is_cut;
        extent.is_known = known.hashes.contains_key(&hash);
        let last = known.names.get(name);
        extent.is_older = !known.has_lines(name) && 0 < extent.known.lines && last != Some(&extent.known.hash);
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
                found = Some(Mark { end: begin + wide(after), lines: line, hash: hash.clone().hash() });
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
        assert_eq!((grown.known.lines, grown.known.end), (2, 4));
        assert_eq!(grown.lines, Mark { end: 6, lines: 3, hash: Hash::of_file(b"a\nb\nc\n") });
        assert_eq!(grown.whole, Mark { end: 7, lines: 4, hash: Hash::of_file(b"a\nb\nc\nd") });
        assert_eq!(extent(&known, "a.csv", "a\nB\nc\n").known.lines, 0);
        assert_eq!(known.extent("a.csv", &mut Cursor::new("a\nb\nc\n"), b"", 2).unwrap().known.lines, 0);
        let other = extent(&known, "b.csv", "a\nb\nc\n");
        assert_eq!((other.known.lines, other.begins_as), (0, Some(("a.csv".to_owned(), 2))), "it begins so");
    }

    #[test]
    fn a_last_line_that_was_taken_without_its_end_is_known_with_any_end() {
        let mut known = Known::default();
        known.add(Hash::of_file(b"a\nb"), "a.csv");
        for grown in ["a\nb\nc\n", "a\nb\r\nc\n", "a\nb\rc\n"] {
            assert_eq!(extent(&known, "a.csv", grown).known.lines, 2, "{grown:?}");
        }
        assert_eq!(extent(&known, "a.csv", "a\nb1\n").known.lines, 0);
        known.add(Hash::of_file(b"a\r"), "r.csv");
        assert_eq!(extent(&known, "r.csv", "a\r\nb\n").known.lines, 1, "the LF came later");
    }

    #[test]
    fn a_file_that_is_written_anew_from_its_beginning_is_seen_to_be_cut() {
        let mut known = Known::default();
        let all = extent(&known, "a.csv", "a\nb\nc\n");
        known.add(all.whole.hash, "a.csv");
        known.add_lines("a.csv", all.marks(3), false);
        assert!(extent(&known, "a.csv", "a\nb\n").is_cut && extent(&known, "a.csv", "a\nb").is_cut);
        let other = extent(&known, "a.csv", "a\nB\n");
        assert_eq!((other.is_cut, other.same_lines), (false, 1));
        assert!(!extent(&known, "b.csv", "a\nb\n").is_cut);
    }

    #[test]
    fn a_part_ends_with_a_line() {
        let mut known = Known::default();
        assert_eq!(extent(&known, "a.csv", "a\nb\n").part, None);
        let part = Some(Mark { end: 4, lines: 2, hash: Hash::of_file(b"a\nb\n") });
        assert_eq!(extent(&known, "a.csv", "a\nb\nc\n").part, part);
        known.add(Hash::of_file(b"a\n"), "a.csv");
        assert_eq!(extent(&known, "a.csv", "a\nb\nc\nd\n").part.unwrap().end, 6);
        assert_eq!(until(&mut Cursor::new("a\nb\nc\n"), b"\n", 2).unwrap(), part);
        assert_eq!(until(&mut Cursor::new("a\nb"), b"\n", 2).unwrap(), None);
    }

    #[test]
    fn names_are_read_from_a_journal_as_they_were() {
        let mut known = Known::default();
        let (hash, name) = (Hash::of_file(b"a"), "a\"b\\c\u{fc}.csv");
        let text = serde_json::to_string(name).unwrap();
        known.see(format!("{{\"files\":[{{\"role\":\"x\",\"name\":{text},\"sha256\":\"{hash}\"}}]}}").as_bytes());
        assert_eq!(known.name_of(&hash, name), Some(name));
        known.add(hash, "b.csv");
        assert_eq!(known.name_of(&hash, name), Some(name), "both are known");
        assert_eq!(known.name_of(&hash, "b.csv"), Some("b.csv"));
    }
}
