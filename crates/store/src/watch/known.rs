//! What was taken already, by content: SHA-256 of whole files, and of the lines that a growing file had.

use std::collections::HashMap;
use std::io;

use fitcheck_core::message::Message;
use fitcheck_exchange::exchange::Body;
use fitcheck_exchange::journal::chain::Hash;

use super::lines::{Mark, Side, each_mark};
use fitcheck_core::text::Within as _;

/// The hashes of what was taken, and the names that the files had then.
#[derive(Debug, Clone, Default)]
pub struct TakenFiles {
    hashes: HashMap<Hash, Vec<String>>,
    /// By name.
    files: HashMap<String, Past>,
}

/// What was taken from files of one name.
#[derive(Debug, Clone, Default)]
pub(super) struct Past {
    /// What was taken last.
    last: Option<Hash>,
    /// Its lines, where it was taken since this program began, or was seen to be unchanged.
    pub(super) lines: Option<TakenLines>,
    /// What is to be said of values that were taken too early.
    pub(super) late: Vec<Message>,
}

/// The lines that a file had when something was taken from it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct TakenLines {
    /// Of everything up to the end of each line, enough of the hash to tell the beginnings of one file from another.
    pub(super) marks: Vec<u64>,
    /// Whether the last one had no line end: it may have become longer.
    pub(super) is_open: bool,
}

/// How a file stands to what was taken before from files of its name.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) enum FileStanding {
    /// Nothing was taken, or the format has no lines.
    #[default]
    New,
    /// All of it was taken: the name that it had then, this one where it was that among others; empty where nobody said it.
    Known(String),
    /// It has the lines that were taken, and may have more.
    Grown,
    /// It is shorter: it has only the first lines of what was taken.
    Cut,
    /// It is shorter, and ends within a line that is not as it was.
    CutWithinLine,
    /// It took the place of a file that had other lines.
    Replaced,
    /// Before this program began its lines were taken, and later another file of its name.
    Older,
    /// Before this program began another file of its name was taken, with other lines.
    Another,
}

/// How far a file goes, and how much of it is known.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Extent {
    pub(super) whole: Mark,
    /// Its whole lines.
    pub(super) lines: Mark,
    /// The end of the lines that are taken now, where it has more new ones than are taken at once.
    pub(super) part: Option<Mark>,
    /// Its beginning that was taken before from a file of its name.
    pub(super) known: Mark,
    pub(super) standing: FileStanding,
    /// The other name under which its beginning was taken, and how many lines that are.
    pub(super) begins_as: Option<(String, usize)>,
    /// How many lines at its beginning are those that were taken last from a file of its name.
    pub(super) same_lines: usize,
    marks: Vec<u64>,
}

impl Extent {
    /// The lines up to a place.
    pub(super) fn taken_lines(&self, mark: &Mark) -> TakenLines {
        let marks = self.marks.get(..mark.lines).unwrap_or(&self.marks).to_vec();
        TakenLines { marks, is_open: self.is_within_line(mark) }
    }

    /// Whether a place is the end of the file within a line.
    pub(super) fn is_within_line(&self, mark: &Mark) -> bool {
        self.lines.end < self.whole.end && mark.end == self.whole.end
    }

    /// One more line; `taken` are those that were taken before.
    fn push(&mut self, hash: &Hash, taken: &TakenLines) {
        let short = hash.0.first_chunk().map_or(0, |first| u64::from_be_bytes(*first));
        let at = self.marks.len();
        self.same_lines += usize::from(self.same_lines == at && taken.marks.get(at) == Some(&short));
        self.marks.push(short);
    }
}

impl TakenFiles {
    /// Remembers what was taken.
    pub fn add(&mut self, hash: Hash, name: &str) {
        self.past(name).last = Some(hash);
        let names = self.hashes.entry(hash).or_default();
        if names.iter().all(|known| known != name) {
            names.push(name.to_owned());
        }
    }

    /// What was taken from files of this name.
    pub(super) fn past(&mut self, name: &str) -> &mut Past {
        self.files.entry(name.to_owned()).or_default()
    }

    /// A file got another name: what was taken from it was taken from a file of that name, too.
    pub(super) fn rename(&mut self, before: &str, now: &str) {
        let Some(past) = self.files.get_mut(before) else { return };
        let Some(lines) = past.lines.take() else { return };
        let last = past.last;
        let past = self.past(now);
        past.lines = Some(lines);
        past.last = last.or(past.last);
        for names in self.hashes.values_mut().filter(|names| names.iter().any(|name| name == before)) {
            if names.iter().all(|name| name != now) {
                names.push(now.to_owned());
            }
        }
    }

    /// The name under which something was taken, this one where it was that among others; empty where nobody said it.
    fn name_of(&self, hash: &Hash, name: &str) -> Option<&str> {
        let names = self.hashes.get(hash)?;
        names.iter().find(|known| *known == name).or(names.last()).map(String::as_str)
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
            let before = body.within(..=at);
            let name = memchr::memmem::rfind(before, NAME).and_then(|from| before.get(from + NAME.len()..));
            // Without a name it is the same content.
            let name = name.and_then(|name| serde_json::from_slice::<String>(name).ok()).unwrap_or_default();
            if let Some(hash) = hash {
                self.add(hash, &name);
            }
        }
    }

    /// How many contents were taken.
    pub fn count(&self) -> usize {
        self.hashes.len()
    }

    /// How much of a file is known; at most `most` lines behind that are a part of it. Lines count where they are said to end with
    /// something, and only those that were taken from a file of its name: the first lines of another part's file may be the same, and
    /// are other measurements.
    pub(super) fn extent(
        &mut self,
        name: &str,
        body: &mut dyn Body,
        line_ends: &[u8],
        most: usize,
    ) -> io::Result<Extent> {
        let mut extent = Extent::default();
        let nothing = TakenLines::default();
        let past = self.files.get(name).filter(|_| !line_ends.is_empty());
        let taken = past.and_then(|past| past.lines.as_ref()).unwrap_or(&nothing);
        extent.whole = each_mark(body, line_ends, &mut |side, mark| {
            match self.name_of(&mark.hash, name) {
                // A last line may have been taken without its end.
                Some(known) if known == name => (extent.known, extent.part) = (mark, None),
                Some(other) => extent.begins_as = Some((other.to_owned(), mark.lines)),
                None => {}
            }
            match side {
                Side::Before => extent.push(&mark.hash, taken),
                Side::After => extent.lines = mark,
            }
            if side == Side::After && mark.lines == extent.known.lines + most {
                extent.part = Some(mark);
            }
        })?;
        if extent.lines.end < extent.whole.end {
            let last = extent.whole.hash;
            extent.push(&last, taken);
            extent.whole.lines += 1;
        }
        extent.part = extent.part.filter(|part| part.end < extent.lines.end);
        let Extent { whole, lines, known, same_lines, .. } = &extent;
        let is_cut = lines.lines <= *same_lines && lines.lines < taken.marks.len();
        // A last line without an end may have become longer: the file is still the same then.
        let is_replaced = *same_lines + usize::from(taken.is_open) < taken.marks.len();
        extent.standing = match (self.name_of(&whole.hash, name), past) {
            (Some(known), _) => FileStanding::Known(known.to_owned()),
            _ if is_cut && whole.lines <= *same_lines => FileStanding::Cut,
            _ if is_cut => FileStanding::CutWithinLine,
            _ if is_replaced => FileStanding::Replaced,
            (_, Some(Past { last: Some(_), lines: None, .. })) if known.lines == 0 => FileStanding::Another,
            (_, Some(Past { last: Some(last), lines: None, .. })) if *last != known.hash => FileStanding::Older,
            (_, Some(Past { last: Some(_), .. })) => FileStanding::Grown,
            _ => FileStanding::New,
        };
        let seen = match &extent.standing {
            FileStanding::Known(known) if known == name => Some(extent.whole),
            FileStanding::Grown => Some(extent.known),
            // Its first lines may be the same as before, but they are other measurements.
            FileStanding::Cut | FileStanding::CutWithinLine | FileStanding::Replaced => {
                extent.known = Mark::default();
                extent.part = None;
                None
            }
            _ => None,
        };
        if let Some(seen) = seen {
            self.past(name).lines.get_or_insert_with(|| extent.taken_lines(&seen));
        }
        Ok(extent)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::super::lines::until;
    use super::*;

    fn extent(known: &TakenFiles, name: &str, text: &str) -> Extent {
        known.clone().extent(name, &mut Cursor::new(text), b"\n\r", 2).unwrap()
    }

    #[test]
    fn a_file_that_has_grown_is_known_up_to_the_lines_that_were_taken() {
        let mut known = TakenFiles::default();
        known.add(Hash::of_file(b"a\nb\n"), "a.csv");
        assert_eq!(extent(&known, "a.csv", "a\nb\n").standing, FileStanding::Known("a.csv".to_owned()));
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
        let mut known = TakenFiles::default();
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
        let mut known = TakenFiles::default();
        let all = extent(&known, "a.csv", "a\nb\nc\n");
        known.add(all.whole.hash, "a.csv");
        known.past("a.csv").lines = Some(all.taken_lines(&all.whole));
        for cut in ["a\nb\n", "a\nb"] {
            assert_eq!(extent(&known, "a.csv", cut).standing, FileStanding::Cut, "{cut:?}");
        }
        assert_eq!(extent(&known, "a.csv", "a\nb\nC").standing, FileStanding::CutWithinLine);
        let other = extent(&known, "a.csv", "a\nB\n");
        assert_eq!((other.standing, other.same_lines), (FileStanding::Replaced, 1));
        assert_eq!(extent(&known, "b.csv", "a\nb\n").standing, FileStanding::New);
    }

    #[test]
    fn a_part_ends_with_a_line() {
        let mut known = TakenFiles::default();
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
        let mut known = TakenFiles::default();
        let hash = Hash::of_file(b"a");
        let name = "a\"b\\c\u{fc}.csv";
        let text = serde_json::to_string(name).unwrap();
        known.see(format!("{{\"files\":[{{\"role\":\"x\",\"name\":{text},\"sha256\":\"{hash}\"}}]}}").as_bytes());
        assert_eq!(known.name_of(&hash, name), Some(name));
        known.add(hash, "b.csv");
        assert_eq!(known.name_of(&hash, name), Some(name), "both are known");
        assert_eq!(known.name_of(&hash, "b.csv"), Some("b.csv"));
    }
}
