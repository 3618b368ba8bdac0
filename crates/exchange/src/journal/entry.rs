//! An entry of a journal: everything needed to say years later what was decided and why.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::Say;
use fitcheck_core::probing::Contact;
use fitcheck_core::verdict::Status;
use jiff::Timestamp;
use jiff::civil::DateTime;
use jiff::tz::Offset;

use super::chain::{ChainId, Hash, Head};
use super::ranges::EntryRanges;
use super::{Alarm, Record};

/// A point in time with what the station's clock showed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moment {
    /// Milliseconds since 1970-01-01 in UTC.
    pub utc_ms: i64,
    /// How far local time was ahead of UTC, minutes.
    pub offset_min: i32,
    /// The name of the time zone, such as `Europe/Amsterdam`, or its rule or offset; empty where it is not known.
    pub zone: String,
}

impl Moment {
    /// What the station's clock showed.
    pub fn local(&self) -> Option<DateTime> {
        let offset = Offset::from_seconds(self.offset_min.saturating_mul(60)).ok()?;
        Some(offset.to_datetime(Timestamp::from_millisecond(self.utc_ms).ok()?))
    }

    /// The same with how far it was from UTC, for machines: `2026-11-23T13:00:00.123+01:00`.
    pub fn text(&self) -> String {
        let sign = if self.offset_min < 0 { '-' } else { '+' };
        let offset = self.offset_min.unsigned_abs();
        let Some(local) = self.local() else { return self.utc_ms.to_string() };
        format!("{}{sign}{:02}:{:02}", local.strftime("%Y-%m-%dT%H:%M:%S%.3f"), offset / 60, offset % 60)
    }
}

/// Who measured what, where and when: what a station tells of every entry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct About {
    /// The station that wrote the entry.
    pub station: String,
    /// When it was written.
    pub time: Moment,
    /// Who measured; empty where nobody said.
    pub who: String,
    /// The part; empty where nobody said.
    pub part: String,
    /// The part's serial number; empty where nobody said.
    pub serial: String,
    /// The feature of the part; empty where the part has one only.
    pub feature: String,
    /// Anything else, up to [`About::LONGEST_REMARK`] bytes.
    pub remark: String,
}

impl About {
    /// The longest remark, bytes of UTF-8.
    pub const LONGEST_REMARK: usize = 65_536;
    /// The longest of the other texts, bytes of UTF-8.
    pub const LONGEST_NAME: usize = 1_024;

    /// Part, serial number and feature as one name; empty where nobody said any of them.
    pub fn name(&self) -> String {
        let texts = [&self.part, &self.serial, &self.feature].into_iter().map(String::as_str);
        texts.filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ")
    }
}

/// A file that a check was made with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UsedFile {
    pub role: FileRole,
    /// Its name without its folder.
    pub name: Arc<str>,
    /// SHA-256 of its bytes.
    pub sha256: Hash,
}

fitcheck_core::named! {
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum FileRole {
        ALL;
        /// Its word in an entry's body.
        fn word;
        /// Measured values or contacts.
        Measurements = "measurements",
        /// An NC program.
        Program = "program",
        /// The simulated workpiece.
        Workpiece = "workpiece",
        /// An uncertainty budget.
        Budget = "budget",
    }
}

/// An entry of a journal.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Who, where and when.
    pub about: About,
    /// What it tells.
    pub content: Content,
}

/// What an entry tells.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// The first entry of a chain.
    Begin(Begin),
    /// A check, or a check in place of another one.
    Check(Box<Check>),
    /// A check is taken back, and nothing stands in its place.
    Withdrawal(Correction),
    /// A file of checks was written.
    Report(Reported),
    /// A rule of a control chart fires, or somebody answers that.
    Alarm(Box<Alarm>),
}

/// The beginning of a chain.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Begin {
    /// The chain's name.
    pub chain: ChainId,
    /// The program that began it, with its version.
    pub program: String,
    /// The chain that it goes on from, where that one was damaged and set aside, and its last entry that is known.
    pub after: Option<(ChainId, Head)>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// What was decided, and why.
    pub what: Checked,
    /// The files that it was made with.
    pub files: Vec<UsedFile>,
    /// The entry that it stands in place of.
    pub corrects: Option<Correction>,
}

/// What was decided.
#[derive(Debug, Clone, PartialEq)]
pub enum Checked {
    /// A size against its limits.
    Size(Arc<Record>),
    /// What a measuring cycle says.
    Cycle(Box<CycleCheck>),
}

/// What a measuring cycle says, as a control does: by its own tolerances, without a decision rule.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleCheck {
    /// The cycle's number.
    pub cycle: u16,
    /// Its parameters as they are written: `Q262` and `25`.
    pub parameters: Vec<(String, String)>,
    /// Where its contacts come from.
    pub origin: CycleOrigin,
    /// Its contacts in probing order, millimetres.
    pub contacts: Vec<Contact>,
    /// Its results by their names for machines: lengths.
    pub figures: BTreeMap<String, Length>,
    /// What it compared with limits, in its order.
    pub compared: Vec<Compared>,
    /// The limits of the size that it measures, where it has one and they were given: minimum and maximum.
    pub limits: Option<[Length; 2]>,
    /// The size that it measures, where it has one.
    pub measured: Option<Length>,
    /// What the control's markers say; `None` where nothing was judged.
    pub status: Option<Status>,
    /// The program's block, where a program called it: the name of the file, and the line.
    pub block: Option<(String, u64)>,
    /// The datum that it counted from, where a cycle of the program had set it.
    pub datum: Option<DatumKept>,
}

/// A datum, and what has set it.
#[derive(Debug, Clone, PartialEq)]
pub struct DatumKept {
    /// Where its zero is in the coordinates of the workpiece: X, Y, Z.
    pub zero: [Length; 3],
    /// The block that has set the zero; `None` where one has only turned the axes.
    pub set_by: Option<BlockKept>,
    /// How its axes are turned in the plane, degrees, and the block that has done so.
    pub rotation: Option<(f64, BlockKept)>,
    /// The spatial angles A, B and C of its plane, degrees, and the block that has tilted it.
    pub tilt: Option<([f64; 3], BlockKept)>,
}

/// A block of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BlockKept {
    /// Its line in its program, from 1.
    pub line: u64,
    /// Its first line.
    pub text: String,
}

/// Where the contacts of a cycle come from.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "journal-origin")]
pub enum CycleOrigin {
    /// A simulated workpiece without faults.
    Perfect,
    /// A simulated workpiece.
    Workpiece {
        /// The file's name without its folder.
        file: Arc<str>,
        /// The seed of the scatter.
        seed: u64,
    },
    /// Contacts that were recorded.
    Contacts {
        /// The file's name without its folder.
        file: Arc<str>,
    },
}

impl CycleOrigin {
    /// Whether nobody measured.
    pub const fn is_simulated(&self) -> bool {
        !matches!(self, Self::Contacts { .. })
    }
}

/// A value that a cycle compared with its limits.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Compared {
    /// Its name for machines: `diameter`, `centre_1`.
    pub what: String,
    pub measured: Length,
    /// The smallest permitted value.
    pub minimum: Length,
    /// The largest permitted value.
    pub maximum: Length,
    /// What this value alone says.
    pub status: Status,
}

/// Which entry is corrected, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Correction {
    /// The entry.
    pub target: Head,
    /// The reason that somebody gave; never empty.
    pub reason: String,
    /// Who gave it; empty where nobody said. The entry itself says who measured.
    pub by: String,
}

/// A file of checks that was written: by its bytes it is recognised, whatever it is called later.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reported {
    /// Its name without its folder.
    pub name: String,
    /// The name of the rendering: `html`, `json`.
    pub format: String,
    /// SHA-256 of its bytes.
    pub sha256: Hash,
    /// How many bytes it has.
    pub bytes: u64,
    /// The title of the report; empty where nobody gave one.
    pub title: String,
    /// What it shows.
    pub shown: Shown,
}

/// What a report shows, and how far the journal was when it was made.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Shown {
    /// The entries of its checks. Those that correct them later are not in it.
    pub checks: EntryRanges,
    /// How many of its checks are in no journal.
    pub unrecorded: u64,
    /// The last entry that was known when it was made; `None` where there was none.
    pub head: Option<Head>,
}

/// An entry as it is kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Kept {
    /// Its number and hash.
    pub head: Head,
    /// The bytes that were hashed: UTF-8.
    pub body: Arc<[u8]>,
}

impl Entry {
    /// The check that it tells of.
    pub fn check(&self) -> Option<&Check> {
        match &self.content {
            Content::Check(check) => Some(check),
            Content::Begin(_) | Content::Withdrawal(_) | Content::Report(_) | Content::Alarm(_) => None,
        }
    }

    /// The alarm that it tells of, or the answer to one.
    pub fn alarm(&self) -> Option<&Alarm> {
        match &self.content {
            Content::Alarm(alarm) => Some(alarm),
            Content::Begin(_) | Content::Check(_) | Content::Withdrawal(_) | Content::Report(_) => None,
        }
    }

    /// The report that it tells of.
    pub const fn report(&self) -> Option<&Reported> {
        match &self.content {
            Content::Report(report) => Some(report),
            Content::Begin(_) | Content::Check(_) | Content::Withdrawal(_) | Content::Alarm(_) => None,
        }
    }

    pub fn corrects(&self) -> Option<&Correction> {
        match &self.content {
            Content::Check(check) => check.corrects.as_ref(),
            Content::Withdrawal(correction) => Some(correction),
            Content::Begin(_) | Content::Report(_) | Content::Alarm(_) => None,
        }
    }
}

impl Check {
    /// The verdict; `None` where a cycle judged nothing.
    pub fn status(&self) -> Option<Status> {
        match &self.what {
            Checked::Size(record) => Some(record.verdict.status()),
            Checked::Cycle(cycle) => cycle.status,
        }
    }

    /// Whether it is of a size, and not of what a cycle says by itself.
    pub const fn is_size(&self) -> bool {
        matches!(self.what, Checked::Size(_))
    }

    /// Whether nobody measured: never evidence.
    pub fn is_simulated(&self) -> bool {
        match &self.what {
            Checked::Size(record) => record.measurement.origin.is_simulated(),
            Checked::Cycle(cycle) => cycle.origin.is_simulated(),
        }
    }

    /// What is to be said of it: that it would be decided in another way today. What was decided then stands.
    pub fn remark(&self) -> Option<CheckRemark> {
        let Checked::Size(record) = &self.what else { return None };
        let kept = record.verdict.status();
        let now = record.judged_again().status();
        (kept != now).then_some(CheckRemark::JudgedOtherwise { kept, now })
    }
}

/// What is to be said of a check that was read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "journal-check")]
pub enum CheckRemark {
    /// This version decides it in another way.
    JudgedOtherwise {
        /// What was decided, and stands.
        kept: Status,
        /// What this version says.
        now: Status,
    },
}
