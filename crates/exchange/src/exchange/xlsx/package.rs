//! A workbook as a ZIP file, before anything is made of it: what it really unpacks to, counted and bounded.
//!
//! A few kilobytes can unpack to gigabytes, and what a ZIP file says of its sizes need not be true. So each member is unpacked
//! once and thrown away again, and those with texts and cells are looked at as XML: how deep, how long.

use std::collections::BTreeSet;
use std::io::{Read, SeekFrom};

use zip::ZipArchive;
use zip::result::ZipError;

use super::hidden::Hidden;
use super::{Body, broken};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::xml::{Start, Xml, fault};
use fitcheck_core::text::Within as _;

/// The most members of a workbook.
const MOST_MEMBERS: usize = 10_000;

/// The largest list of them, bytes.
const LONGEST_LIST: u64 = 4 << 20;

/// The largest sheet when it is unpacked.
const SHEET: u64 = 512 << 20;

/// The largest list of texts that cells share.
const TEXTS: u64 = 64 << 20;

/// The largest member that is neither, such as a picture.
const OTHER: u64 = 64 << 20;

/// The largest member that says how the others hang together.
const FRAME: u64 = 4 << 20;

/// All together.
const ALL: u64 = 1 << 30;

/// From this size on a member may not be packed any denser than by [`DENSEST`].
const SMALL: u64 = 16 << 20;

/// How many times smaller a sheet may be packed: rows that repeat are at 30.
const DENSEST: u64 = 200;

/// The longest cell with everything in it, bytes: a spreadsheet program stops at 32 767 characters.
const LONGEST_CELL: u64 = 1 << 20;

/// The most shared texts, each with the memory of a text.
const MOST_TEXTS: usize = 3_000_000;

/// The end of the list of members, where the tail of a file is searched for it.
const TAIL: u64 = 66 << 10;

/// What was seen of a workbook.
#[derive(Debug, Default)]
pub(super) struct WorkbookSheets {
    /// The sheets: name, and the id of where they are.
    sheets: Vec<(String, String)>,
    /// Ids and the members that they stand for.
    targets: Vec<(String, String)>,
    /// By member: what sheets hide.
    hidden: Vec<(String, Hidden)>,
}

impl WorkbookSheets {
    /// What a sheet hides.
    pub(super) fn hidden(&self, sheet: &str) -> Option<&Hidden> {
        let (_, id) = self.sheets.iter().find(|(name, _)| name == sheet.trim())?;
        let (_, target) = self.targets.iter().find(|(own, _)| own == id)?;
        let target = plain(target);
        let is_it = |member: &str| member == target || member.strip_suffix(&target).is_some_and(|at| at.ends_with('/'));
        self.hidden.iter().find(|(member, _)| is_it(member)).map(|(_, hidden)| hidden)
    }

    /// Takes note of an element of a member that says how the others hang together.
    fn see(&mut self, start: &Start) {
        match start.name.as_str() {
            "sheet" => self.sheets.push((start.attribute("name").to_owned(), start.attribute("id").to_owned())),
            "Relationship" if start.attribute("Type").ends_with("/worksheet") => {
                self.targets.push((start.attribute("Id").to_owned(), start.attribute("Target").to_owned()));
            }
            _ => {}
        }
    }
}

/// The name of a member as names are compared.
fn plain(name: &str) -> String {
    name.to_lowercase().replace('\\', "/").trim_start_matches(['/', '.']).to_owned()
}

/// Looks at all members of a workbook.
///
/// # Errors
/// Why it is not a workbook, or not one that is read.
pub(super) fn check(body: &mut dyn Body) -> Result<WorkbookSheets, ImportErrorKind> {
    check_list(body)?;
    body.rewind().map_err(|error| ImportErrorKind::read(&error))?;
    let mut archive = ZipArchive::new(std::io::BufReader::new(body)).map_err(|error| unreadable(&error))?;
    let names: Vec<String> = archive.file_names().flatten().map(|name| name.to_lowercase()).collect();
    let has = |end: &str| names.iter().any(|name| name.ends_with(end));
    match () {
        () if has("workbook.bin") => return Err(ImportErrorKind::OldWorkbook { format: "XLSB" }),
        () if !has("workbook.xml") => return Err(ImportErrorKind::NotAWorkbook),
        () => {}
    }
    // Whoever reads it takes one of two: nobody would know which.
    let mut known = BTreeSet::new();
    let twice = names.iter().find(|name| !known.insert(name.replace('\\', "/")));
    if twice.is_some() || archive.has_duplicate_names() {
        return Err(ImportErrorKind::ZipTwice);
    }
    let mut seen = WorkbookSheets::default();
    let mut all = 0;
    for index in 0..archive.len() {
        let member = archive.by_index(index).map_err(|error| unreadable(&error))?;
        let packed = member.compressed_size();
        let name = member.name().map_err(|error| unreadable(&error))?.into_owned();
        let kind = MemberKind::of(&name);
        let too_large = || ImportErrorKind::ZipBomb { member: shorten(&name), most: kind.most() >> 20 };
        if kind.most() < member.size() {
            return Err(too_large());
        }
        let most = kind.most().min(ALL.saturating_sub(all));
        let mut counted = CountedMember { inner: member, packed, read: 0, most, is_over: false };
        let looked = kind.look(&name, &mut counted, &mut seen);
        let read = counted.read;
        let is_over = counted.is_over;
        if is_over {
            return Err(too_large());
        }
        looked?;
        all += read;
    }
    Ok(seen)
}

/// The list of members says at its end how many there are: more take memory before anything else is known.
fn check_list(body: &mut dyn Body) -> Result<(), ImportErrorKind> {
    let mut tail = Vec::new();
    let mut read = || {
        let length = body.seek(SeekFrom::End(0))?;
        body.seek(SeekFrom::Start(length.saturating_sub(TAIL)))?;
        body.take(TAIL).read_to_end(&mut tail)
    };
    read().map_err(|error| ImportErrorKind::read(&error))?;
    let number = |at: usize, bytes: usize| {
        // A mark so near to the end is not that of a list, and says nothing.
        let bytes = tail.get(at..at + bytes);
        bytes.map_or(0, |bytes| bytes.iter().rev().fold(0_u64, |number, &byte| number << 8 | u64::from(byte)))
    };
    let mut has_large = false;
    for at in memchr::memmem::find_iter(&tail, b"PK\x06\x06") {
        has_large = true;
        if LONGEST_LIST < number(at + 40, 8) || MOST_MEMBERS < usize::try_from(number(at + 32, 8)).unwrap_or(usize::MAX)
        {
            return Err(ImportErrorKind::ZipMembers { most: MOST_MEMBERS });
        }
    }
    let mut ends = memchr::memmem::find_iter(&tail, b"PK\x05\x06").peekable();
    if ends.peek().is_none() {
        return Err(ImportErrorKind::ZipCutOff);
    }
    for at in ends {
        let members = number(at + 10, 2);
        let list = number(at + 12, 4);
        let is_elsewhere = members == 0xffff || list == 0xffff_ffff;
        let is_long = LONGEST_LIST < list || MOST_MEMBERS < usize::try_from(members).unwrap_or(usize::MAX);
        if if is_elsewhere { !has_large } else { is_long } {
            return Err(ImportErrorKind::ZipMembers { most: MOST_MEMBERS });
        }
    }
    if memchr::memmem::find(&tail, b"PK\x06\x07").is_some() && !has_large {
        return Err(ImportErrorKind::ZipMembers { most: MOST_MEMBERS });
    }
    Ok(())
}

/// What a member is, by its name: the names of these are fixed, or checked where they are not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum MemberKind {
    Sheet,
    Texts,
    Frame,
    /// Where the members begin: it names the workbook.
    Root,
    Other,
}

impl MemberKind {
    fn of(name: &str) -> Self {
        let name = name.to_lowercase().replace('\\', "/");
        let own = name.rsplit_once('/').map_or(name.as_str(), |(_, own)| own);
        let (own, ending) = own.rsplit_once('.').unwrap_or((own, ""));
        match (own, ending) {
            ("", "rels") => Self::Root,
            ("sharedstrings", "xml") => Self::Texts,
            (_, "xml") if own.starts_with("sheet") || name.contains("worksheets/") => Self::Sheet,
            (_, "rels") => Self::Frame,
            _ if ["[", "styles", "workbook", "theme"].iter().any(|start| own.starts_with(start)) => Self::Frame,
            _ => Self::Other,
        }
    }

    const fn most(self) -> u64 {
        match self {
            Self::Sheet => SHEET,
            Self::Texts => TEXTS,
            Self::Frame | Self::Root => FRAME,
            Self::Other => OTHER,
        }
    }

    fn look(self, name: &str, member: &mut dyn Read, seen: &mut WorkbookSheets) -> Result<(), ImportErrorKind> {
        match self {
            Self::Sheet => sheet(name, member).map(|hidden| seen.hidden.push((plain(name), hidden))),
            Self::Frame => survey(member, seen),
            Self::Texts => texts(member, seen),
            Self::Root => root(member, seen),
            Self::Other => std::io::copy(member, &mut std::io::sink()).map(|_count| ()).map_err(|error| broken(&error)),
        }
    }
}

/// How long what is kept of a member at once may be.
#[derive(Debug, Default)]
struct Measure {
    /// Where the last thing that is kept began.
    before: u64,
}

impl Measure {
    fn see(&mut self, start: &Start, depth: usize, position: u64) -> Result<(), ImportErrorKind> {
        if depth <= 3 || matches!(start.name.as_str(), "c" | "si") {
            let length = position.saturating_sub(self.before);
            self.before = position;
            if LONGEST_CELL < length {
                return Err(fault(start.at, ImportErrorKind::XmlLong { most: 1 << 10 }).into());
            }
        }
        Ok(())
    }
}

/// Looks at a member as XML: how deep it is, and how long what is kept of it at once. A sheet that is not called one is refused:
/// nobody would have looked at its cells.
fn survey(member: &mut dyn Read, seen: &mut WorkbookSheets) -> Result<(), ImportErrorKind> {
    let mut measure = Measure::default();
    // The encoding of these is UTF-8.
    let mut xml = Xml::new(member, b"", &["Type", "Target", "Id", "id", "name"])?;
    while let Some((start, depth, position)) = xml.begin()? {
        measure.see(&start, depth, position)?;
        seen.see(&start);
        let is_sheet = start.name == "Relationship" && start.attribute("Type").ends_with("/worksheet");
        if is_sheet && MemberKind::of(start.attribute("Target")) != MemberKind::Sheet {
            return Err(ImportErrorKind::NotAWorkbook);
        }
    }
    Ok(())
}

/// Looks at a sheet in the same way, and at each cell: whoever reads the cells takes the first piece of a value for all of it, and the
/// number of a text that is none for 0. Gives what it hides.
fn sheet(member: &str, body: &mut dyn Read) -> Result<Hidden, ImportErrorKind> {
    let mut measure = Measure::default();
    let mut hidden = Hidden::default();
    let mut xml = Xml::new(body, b"", &["r", "t", "hidden", "min", "max"])?;
    let mut cell = Start::default();
    let mut has_value = false;
    while let Some((start, depth, position)) = xml.begin()? {
        measure.see(&start, depth, position)?;
        hidden.see(&start);
        match start.name.as_str() {
            "c" => (cell, has_value) = (start, false),
            "v" => {
                let kind = cell.attribute("t");
                let is_text = kind == "str";
                let text = xml.plain_text(is_text)?.filter(|_| !std::mem::replace(&mut has_value, true));
                let is_sound = text.is_some_and(|text| kind != "s" || is_number_of_text(&text));
                if !is_sound {
                    let cell = format!("{}!{}", shorten(member), cell.attribute("r"));
                    return Err(ImportErrorKind::Cell { cell, reason: Box::new(ImportErrorKind::CellSplit) });
                }
            }
            _ => {}
        }
    }
    Ok(hidden)
}

/// Whether it is the number of a shared text, or nothing.
fn is_number_of_text(text: &str) -> bool {
    text.len() < 10 && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// The texts that cells share: how many there may be is reserved beforehand by who reads them.
fn texts(member: &mut dyn Read, seen: &mut WorkbookSheets) -> Result<(), ImportErrorKind> {
    let mut all = Vec::new();
    member.read_to_end(&mut all).map_err(|error| broken(&error))?;
    let too_many = ImportErrorKind::ZipTexts { most: MOST_TEXTS };
    if MOST_TEXTS < count_texts(&all) {
        return Err(too_many);
    }
    for at in memchr::memmem::find_iter(&all, b"uniqueCount") {
        let behind = all.within(at + "uniqueCount".len()..);
        let digits = behind.iter().skip_while(|byte| !byte.is_ascii_digit()).take_while(|byte| byte.is_ascii_digit());
        let said =
            digits.fold(0_usize, |said, &digit| said.saturating_mul(10).saturating_add(usize::from(digit - b'0')));
        if MOST_TEXTS < said {
            return Err(too_many);
        }
    }
    survey(&mut all.as_slice(), seen)
}

/// How many texts begin: whatever prefix their elements have.
fn count_texts(all: &[u8]) -> usize {
    let begins = |at: &usize| {
        let tag = all.within(at + 1..);
        let end = tag.iter().take(64).position(|byte| matches!(byte, b'>' | b'/' | b' ' | b'\t' | b'\n' | b'\r'));
        let name = end.map(|end| tag.within(..end));
        name.is_some_and(|name| name == b"si" || name.ends_with(b":si"))
    };
    memchr::memchr_iter(b'<', all).filter(begins).count()
}

/// A workbook with another name could be as large as a sheet.
fn root(member: &mut dyn Read, seen: &mut WorkbookSheets) -> Result<(), ImportErrorKind> {
    let mut all = Vec::new();
    member.read_to_end(&mut all).map_err(|error| broken(&error))?;
    let text = String::from_utf8_lossy(&all).to_lowercase();
    let is_odd = text.contains("sheet") && text.replace("spreadsheet", "").replace("worksheets/", "").contains("sheet");
    if is_odd { Err(ImportErrorKind::NotAWorkbook) } else { survey(&mut all.as_slice(), seen) }
}

/// What a member unpacks to.
struct CountedMember<R> {
    inner: R,
    packed: u64,
    read: u64,
    most: u64,
    is_over: bool,
}

impl<R: Read> Read for CountedMember<R> {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        let read = self.inner.read(into)?;
        self.read += u64::try_from(read).unwrap_or(u64::MAX);
        let is_dense = SMALL < self.read && self.packed.saturating_mul(DENSEST) < self.read;
        if self.most < self.read || is_dense {
            self.is_over = true;
            return Err(std::io::Error::other("too large"));
        }
        Ok(read)
    }
}

fn unreadable(error: &ZipError) -> ImportErrorKind {
    broken(error)
}
