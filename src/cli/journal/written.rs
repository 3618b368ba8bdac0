//! Whether a file is a report that the journal knows, and what has become of its checks since.

use std::collections::BTreeMap;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::row::ReportAnswer;
use super::{IntoCliError as _, Io};
use crate::cli::CliError;
use crate::files;
use crate::journal::Record;
use crate::journal::chain::{ChainId, FileHash, Hash};
use crate::journal::entry::{About, Check, Checked, Content, Entry, Reported};
use crate::proof::{self, JournalCheck, compare, json_of};
use crate::store::local::{ListedEntry, Reader};

/// So many entries are read at once.
const PAGE: usize = 500;

/// What is found of a file.
pub(super) struct Written {
    path: PathBuf,
    sha256: Hash,
    /// The reports that have its bytes, the oldest first.
    known: Vec<Found>,
    /// The newest report of a file of this name, where none has its bytes.
    named: Option<Found>,
}

/// A report of the journal.
struct Found {
    number: u64,
    about: About,
    report: Reported,
    /// What has become of its checks.
    checks: Since,
    /// What its data says; `None` where the file has none.
    data: Option<Data>,
}

/// What has become of the checks of a report.
#[derive(Default)]
struct Since {
    /// Those that another entry corrects, with that entry.
    corrected: BTreeMap<u64, u64>,
    /// Those that another entry takes back.
    withdrawn: BTreeMap<u64, u64>,
    /// Numbers of entries that are no checks of a size, or are not there.
    others: Vec<u64>,
}

/// Whether the data of a file says what the journal says.
enum Data {
    Agrees,
    /// What is other, in sentences.
    Differs(Vec<String>),
}

/// The bytes of a file as far as they are looked at.
struct Bytes {
    sha256: Hash,
    /// What it has as data, or why that cannot be read.
    json: Option<Result<Vec<u8>, String>>,
}

/// A check with what its entry calls it.
struct Known {
    number: u64,
    record: Arc<Record>,
    names: [String; 2],
}

impl Written {
    /// Looks for a file in the journal.
    ///
    /// # Errors
    /// [`CliError`] where the file or the journal cannot be read.
    pub(super) fn of(path: &Path, reader: &Reader) -> Result<Self, CliError> {
        let bytes = Bytes::of(path)?;
        let found = |numbers: &[u64]| -> Result<Vec<Found>, CliError> {
            let rows = reader.rows(numbers).said()?;
            rows.iter().filter_map(|row| Found::of(row, &bytes, reader).transpose()).collect()
        };
        let known = found(&reader.reports_with(bytes.sha256).said()?)?;
        let named = if known.is_empty() {
            let name = files::name_of(path).to_string_lossy();
            let newest = reader.reports_named(&name).said()?.pop();
            found(newest.as_slice())?.pop()
        } else {
            None
        };
        Ok(Self { path: path.to_owned(), sha256: bytes.sha256, known, named })
    }

    /// Whether it is a file that was written, and its data says what the journal says.
    pub(super) fn is_whole(&self) -> bool {
        !self.known.is_empty() && self.known.iter().all(Found::is_whole)
    }

    /// `is_whole`: whether the journal is as it was written; otherwise what it says of the file proves nothing.
    pub(super) fn print(&self, chain: ChainId, is_whole: bool, io: &mut Io<'_>) {
        let path = self.path.display();
        for found in &self.known {
            let Found { number, about, report, .. } = found;
            let who = if about.who.is_empty() { String::new() } else { format!(" by {}", about.who) };
            let time = about.time.text();
            let station = &about.station;
            let shown = shown(report);
            writeln!(
                io.people(),
                "{path} was written on {time}{who} at {station}, as entry {number} of chain {chain}: {shown}"
            );
            found.print(is_whole, io);
            if !is_whole {
                writeln!(
                    io.people(),
                    "  the journal itself is not as it was written: what it says of the file proves nothing"
                );
            }
        }
        if self.known.is_empty() {
            writeln!(io.people(), "{path} is not a file that this journal knows: it was changed, or written elsewhere");
            writeln!(io.people(), "  its SHA-256 is {}", self.sha256);
        }
        if let Some(Found { number, report, data, .. }) = &self.named {
            let sha256 = report.sha256;
            writeln!(io.people(), "  entry {number} is a report of this name, with the SHA-256 {sha256}");
            match data {
                Some(Data::Agrees) => {
                    writeln!(
                        io.people(),
                        "  the data of the file agrees with entry {number}: what is other is elsewhere"
                    );
                }
                Some(Data::Differs(differences)) => differences.iter().for_each(|one| writeln!(io.people(), "  {one}")),
                None => {}
            }
        }
    }
}

/// `3 checks (2 to 4)`, with what was never recorded.
pub(super) fn shown(report: &Reported) -> String {
    let checks = &report.shown.checks;
    let count = |number: u64| if number == 1 { "1 check".to_owned() } else { format!("{number} checks") };
    let numbers = if checks.is_empty() { String::new() } else { format!(" ({checks})") };
    let unrecorded = match report.shown.unrecorded {
        0 => String::new(),
        number => format!(", and {} that the journal does not have", count(number)),
    };
    format!("{}{numbers}{unrecorded}", count(checks.count()))
}

impl Found {
    /// The report of a row; `None` where it cannot be read, which the chain itself tells.
    fn of(row: &ListedEntry, bytes: &Bytes, reader: &Reader) -> Result<Option<Self>, CliError> {
        let Ok(Entry { about, content: Content::Report(report) }) = &row.entry else { return Ok(None) };
        let last = reader.head().said()?.number;
        let mut since = Since::default();
        let mut known = Vec::new();
        // What a body claims may go on for ever: the journal has an end.
        let numbers: Vec<u64> = report.shown.checks.numbers().take_while(|number| *number <= last).collect();
        for page in numbers.chunks(PAGE) {
            let rows = reader.rows(page).said()?;
            for row in &rows {
                since.see(row, reader)?;
                known.extend(Known::of(row));
            }
        }
        let data = bytes.json.as_ref().map(|json| match json {
            Ok(json) => Data::of(json, &known, report.shown.unrecorded),
            Err(why) => Data::Differs(vec![why.clone()]),
        });
        let (about, report) = (about.clone(), report.clone());
        Ok(Some(Self { number: row.kept.head.number, about, report, checks: since, data }))
    }

    fn is_whole(&self) -> bool {
        self.checks.others.is_empty() && !matches!(self.data, Some(Data::Differs(_)))
    }

    fn print(&self, is_whole: bool, io: &mut Io<'_>) {
        let Since { corrected, withdrawn, others } = &self.checks;
        for number in others {
            writeln!(io.people(), "  entry {number} is not a check of a size");
        }
        for (number, by) in corrected {
            writeln!(io.people(), "  entry {number} was corrected by entry {by} since");
        }
        for (number, by) in withdrawn {
            writeln!(io.people(), "  entry {number} was withdrawn by entry {by} since");
        }
        let is_any = !self.report.shown.checks.is_empty();
        if is_whole && is_any && others.is_empty() && corrected.is_empty() && withdrawn.is_empty() {
            writeln!(io.people(), "  every one of them stands as it was written");
        }
        match &self.data {
            Some(Data::Agrees) => writeln!(io.people(), "  the data of the file says what the journal says"),
            Some(Data::Differs(differences)) => differences.iter().for_each(|one| writeln!(io.people(), "  {one}")),
            None => {}
        }
    }
}

impl Since {
    fn see(&mut self, row: &ListedEntry, reader: &Reader) -> Result<(), CliError> {
        let number = row.kept.head.number;
        let is_size = row.entry.as_ref().is_ok_and(|entry| entry.check().is_some_and(Check::is_size));
        if !is_size {
            self.others.push(number);
            return Ok(());
        }
        let Some(by) = row.corrected_by else { return Ok(()) };
        let by_what = reader.rows(&[by]).said()?;
        let takes_back = |row: &ListedEntry| matches!(&row.entry, Ok(Entry { content: Content::Withdrawal(_), .. }));
        let list = if by_what.iter().any(takes_back) { &mut self.withdrawn } else { &mut self.corrected };
        list.insert(number, by);
        Ok(())
    }
}

impl Known {
    fn of(row: &ListedEntry) -> Option<Self> {
        let entry = row.entry.as_ref().ok()?;
        let Checked::Size(record) = &entry.check()?.what else { return None };
        let names = [entry.about.name(), entry.about.part.clone()];
        Some(Self { number: row.kept.head.number, record: Arc::clone(record), names })
    }
}

impl Known {
    fn check(&self) -> JournalCheck<'_> {
        let Self { number, record, names: [whole, part] } = self;
        JournalCheck { number: *number, record, names: [whole, part] }
    }
}

impl Data {
    fn of(json: &[u8], known: &[Known], unrecorded: u64) -> Self {
        let checks: Vec<JournalCheck<'_>> = known.iter().map(Known::check).collect();
        match compare(json, &checks, unrecorded) {
            Ok(differences) if differences.is_empty() => Self::Agrees,
            Ok(differences) => Self::Differs(differences.iter().map(ToString::to_string).collect()),
            Err(error) => Self::Differs(vec![error.to_string()]),
        }
    }

    fn differences(&self) -> &[String] {
        match self {
            Self::Agrees => &[],
            Self::Differs(differences) => differences,
        }
    }
}

impl Bytes {
    /// Reads a file of any size once; what is larger than any data that is read is only hashed.
    fn of(path: &Path) -> Result<Self, CliError> {
        let (file, _size) = files::open(path)?;
        let failed = |error: std::io::Error| CliError::from(files::system(path, &error));
        let mut hash = FileHash::default();
        let mut whole = Vec::new();
        let mut is_too_large = false;
        let mut file = std::io::BufReader::new(file);
        let mut piece = vec![0; 1 << 16];
        loop {
            let count = file.read(&mut piece).map_err(failed)?;
            let Some(read) = piece.get(..count).filter(|read| !read.is_empty()) else { break };
            hash.see(read);
            is_too_large |= proof::LARGEST < u64::try_from(whole.len().saturating_add(count)).unwrap_or(u64::MAX);
            if is_too_large {
                whole = Vec::new();
            } else {
                whole.extend_from_slice(read);
            }
        }
        let json = if is_too_large { None } else { json_of(&whole) };
        let json = json.map(|json| json.map_err(|error| error.to_string()));
        Ok(Self { sha256: hash.hash(), json })
    }
}

object! {
    /// What is found of a file.
    pub(super) struct WrittenAnswer of(written: &Written) {
        file: String = written.path.display().to_string(),
        sha256: String = written.sha256.to_string(),
        known: bool = !written.known.is_empty(),
        whole: bool = written.is_whole(),
        reports: Vec<FoundAnswer> = written.known.iter().map(FoundAnswer::of).collect(),
        same_name: Option<FoundAnswer> = written.named.as_ref().map(FoundAnswer::of),
    }

    struct FoundAnswer of(found: &Found) {
        number: u64 = found.number,
        time: String = found.about.time.text(),
        who: String = found.about.who.clone(),
        station: String = found.about.station.clone(),
        report: ReportAnswer = ReportAnswer::of(&found.report),
        corrected: Vec<SinceAnswer> = found.checks.corrected.iter().map(|(number, by)| SinceAnswer::of(*number, *by)).collect(),
        withdrawn: Vec<SinceAnswer> = found.checks.withdrawn.iter().map(|(number, by)| SinceAnswer::of(*number, *by)).collect(),
        no_checks: Vec<u64> = found.checks.others.clone(),
        data_agrees: Option<bool> = Some(matches!(found.data.as_ref()?, Data::Agrees)),
        differences: Vec<String> = found.data.iter().flat_map(Data::differences).cloned().collect(),
    }

    struct SinceAnswer of(number: u64, by: u64) {
        number: u64 = number,
        by: u64 = by,
    }
}
