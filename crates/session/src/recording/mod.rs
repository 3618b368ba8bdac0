//! Every check that is made is recorded: what is sent to the journal, what is on disk, and what is not.
//!
//! A check counts as recorded once the journal has answered with its number, never before. What could not be written stays here until
//! it is written, and the user is told.
//!
//! | file | what |
//! |---|---|
//! | here | where records are kept, which checks are recorded, what failed |
//! | `alarms` | alarms of control charts, and their answers |
//! | `making` | from a check to an entry |
//! | `people` | who is measuring |
//! | `reports` | which file was written, and of which checks |
//! | `server` | the server of the shop |
//! | `undoing` | undo withdraws what it takes back |

mod alarms;
mod making;
mod people;
mod reports;
mod server;
mod undoing;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use fitcheck_core::message::Message;
use fitcheck_exchange::journal::chain::{ChainId, Hash, Head};
use fitcheck_exchange::journal::entry::{Entry, UsedFile};
use fitcheck_exchange::journal::query::RecordId;
use jiff::civil::DateTime;
use jiff::tz::TimeZone;
pub use making::Named;
pub(super) use making::{Sent, ToKeep, correcting, used};
pub use people::MOST_NAMES;
use server::Server;

use self::people::People;
use self::undoing::{Undone, Withdrawing};
use super::effect::Effect;
use super::saved::SavedRecords;

/// How many of the newest checks of a journal come back into the history at the start.
pub const RESTORED: u64 = 1_000;

/// Whether records are kept.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub enum Keeping {
    /// Nobody named a place for them: there is no data folder, or the window is not one of a user.
    #[default]
    Nowhere,
    /// The user turned it off in the state file.
    Off,
    /// The journal is being opened.
    Opening,
    Open,
    /// It cannot be opened.
    Failed(Message),
}

/// What has become of a check on its way to the journal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Recorded<'a> {
    /// It is being written.
    Waiting,
    /// It is on disk with this number.
    Kept(u64),
    /// It could not be written.
    Failed(&'a Message),
}

/// A check that was sent: the number of its batch, and its place there.
pub(super) type Slip = (u64, u64);

/// What is known of a check of the history.
#[derive(Debug)]
struct Known {
    slip: Slip,
    named: Named,
    /// The files that it was made with.
    files: Vec<UsedFile>,
}

/// Entries that were sent together, and what came of it.
#[derive(Debug)]
struct Batch {
    /// Until they are on disk.
    entries: Vec<Entry>,
    fate: RecordingState,
}

#[derive(Debug)]
enum RecordingState {
    Waiting,
    Kept(Vec<Head>),
    Failed(Message),
    /// It can never be written, whatever the disk does.
    Refused(Message),
}

#[derive(Debug, Clone, PartialEq)]
pub struct OpenJournal {
    /// The name of its chain.
    pub chain: ChainId,
    /// Its newest entry.
    pub head: Head,
    /// What is worth knowing, such as a damaged file that was set aside.
    pub remarks: Vec<Message>,
}

/// What is recorded, and what is on its way.
#[derive(Debug, Default)]
pub struct Recording {
    settings: SavedRecords,
    /// Whether records are kept.
    pub keeping: Keeping,
    /// Whether it was said where records are kept.
    has_begun: bool,
    /// The file that they are kept in.
    pub file: Option<PathBuf>,
    /// The station's name.
    pub station: String,
    /// The journal, once it was opened.
    pub journal: Option<OpenJournal>,
    people: People,
    /// What the user names beside the next check.
    pub(super) named: Named,
    /// How many batches were sent.
    sent: u64,
    batches: BTreeMap<u64, Batch>,
    checks: BTreeMap<RecordId, Known>,
    /// Checks of the history that were read from the journal, with their numbers.
    numbers: BTreeMap<RecordId, u64>,
    /// Part and serial number of what was read from the journal when it was opened.
    parts: BTreeSet<(String, String)>,
    /// Where days begin; UTC until that is known.
    pub zone: Option<TimeZone>,
    /// The time of the last command: a question may ask for today.
    pub now: DateTime,
    /// The newest number that this window has seen.
    pub newest: u64,
    /// The file that was read last, with SHA-256 of its bytes.
    measured: Option<(String, Hash)>,
    server: Server,
    /// Steps that undo took back, until all of their records are written.
    undone: Vec<Undone>,
    /// Batches of withdrawals that undo asked for.
    withdrawing: BTreeMap<u64, Withdrawing>,
    /// Batches that tell of reports, each with the name of the file.
    reports: BTreeMap<u64, String>,
    errands: Vec<Effect>,
}

impl Recording {
    /// As the state file says; nothing is opened yet.
    pub(super) fn new(settings: SavedRecords) -> Self {
        let people = People::new(&settings);
        Self { settings, people, ..Self::default() }
    }

    /// What survives a restart.
    pub(super) fn saved(&self) -> SavedRecords {
        let (who, names) = self.people.saved();
        SavedRecords { who, names, ..self.settings.clone() }
    }

    /// The window has begun: records are kept in the file that the state file names, or else in the usual one.
    pub(super) fn begin(&mut self, usual: Option<PathBuf>, station: String) {
        self.station = station;
        self.has_begun = true;
        self.file = self.settings.file.clone().or(usual);
        match &self.file {
            _ if self.settings.off => self.keeping = Keeping::Off,
            None => self.keeping = Keeping::Nowhere,
            Some(_) => self.open(),
        }
    }

    fn open(&mut self) {
        let Some(file) = self.file.clone() else { return };
        self.keeping = Keeping::Opening;
        self.errands.push(Effect::OpenJournal { file, station: self.station.clone(), newest: RESTORED });
    }

    /// The journal was opened, or not. What failed before is sent again.
    pub(super) fn opened(&mut self, result: Result<OpenJournal, Message>) {
        match result {
            Ok(journal) => {
                self.newest = self.newest.max(journal.head.number);
                if self.journal.is_none() {
                    self.begin_sending();
                }
                self.journal = Some(journal);
                self.keeping = Keeping::Open;
            }
            Err(problem) => self.keeping = Keeping::Failed(problem),
        }
    }

    /// Sends entries; `None` where no records are kept.
    fn send(&mut self, entries: Vec<Entry>) -> Option<u64> {
        if !self.is_on() || entries.is_empty() {
            return None;
        }
        self.sent += 1;
        let run = self.sent;
        self.errands.push(Effect::Keep { run, entries: entries.clone() });
        self.batches.insert(run, Batch { entries, fate: RecordingState::Waiting });
        Some(run)
    }

    /// What cannot be an entry of a journal is told at once, and not tried again; returns its number.
    fn refuse(&mut self, problem: Message) -> u64 {
        self.sent += 1;
        self.batches.insert(self.sent, Batch { entries: Vec::new(), fate: RecordingState::Refused(problem) });
        self.sent
    }

    /// The journal has answered about a batch. Returns whether that is news of a failure.
    pub(super) fn kept(&mut self, run: u64, result: Result<Vec<Head>, Message>) -> bool {
        let Some(batch) = self.batches.get_mut(&run) else { return false };
        match result {
            Ok(heads) => {
                if let (Some(journal), Some(head)) = (&mut self.journal, heads.last()) {
                    journal.head = *head;
                }
                self.newest = heads.last().map_or(self.newest, |head| self.newest.max(head.number));
                batch.fate = RecordingState::Kept(heads);
                batch.entries = Vec::new();
                self.wake_sender();
                false
            }
            Err(problem) => {
                batch.fate = RecordingState::Failed(problem);
                true
            }
        }
    }

    /// Tries again what could not be written, in the order in which it was made.
    pub(super) fn try_again(&mut self) {
        if matches!(self.keeping, Keeping::Failed(_)) {
            self.open();
        }
        for (run, batch) in &mut self.batches {
            if matches!(batch.fate, RecordingState::Failed(_)) {
                batch.fate = RecordingState::Waiting;
                self.errands.push(Effect::Keep { run: *run, entries: batch.entries.clone() });
            }
        }
    }

    /// A file was read, and its bytes have this SHA-256.
    pub(super) fn saw(&mut self, name: String, sha256: Hash) {
        self.measured = Some((name, sha256));
    }

    /// SHA-256 of the file of a name that was just read.
    pub(super) fn of_file(&mut self, name: &str) -> Option<Hash> {
        self.measured.take().filter(|(of, _)| of == name).map(|(_, sha256)| sha256)
    }

    /// What has to be done outside.
    pub(super) fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }

    /// Checks of the history that were read from the journal.
    pub(super) fn know(&mut self, numbers: impl IntoIterator<Item = (RecordId, u64)>) {
        self.numbers.extend(numbers);
    }

    /// Whether records are kept, or should be.
    pub const fn is_on(&self) -> bool {
        matches!(self.keeping, Keeping::Opening | Keeping::Open | Keeping::Failed(_))
    }

    /// Whether it was said where records are kept, or that they are not.
    pub(super) const fn has_begun(&self) -> bool {
        self.has_begun
    }

    /// Who is measuring; empty where nobody said.
    pub fn who(&self) -> &str {
        &self.people.who
    }

    /// The names that were used last, the latest first.
    pub fn names(&self) -> &[String] {
        &self.people.names
    }

    pub(super) fn use_name(&mut self, name: &str) {
        self.people.choose(name);
    }

    /// What the user names beside the next check.
    pub const fn named(&self) -> &Named {
        &self.named
    }

    /// What has become of something that was sent.
    pub fn of_slip(&self, (run, at): (u64, u64)) -> Option<Recorded<'_>> {
        Some(match &self.batches.get(&run)?.fate {
            RecordingState::Waiting => Recorded::Waiting,
            RecordingState::Kept(heads) => {
                Recorded::Kept(heads.first().map_or(0, |head| head.number).saturating_add(at))
            }
            RecordingState::Failed(problem) | RecordingState::Refused(problem) => Recorded::Failed(problem),
        })
    }

    /// The entry on disk of something that was sent.
    pub(super) fn head_of_slip(&self, (run, at): Slip) -> Option<Head> {
        match &self.batches.get(&run)?.fate {
            RecordingState::Kept(heads) => heads.get(usize::try_from(at).ok()?).copied(),
            _ => None,
        }
    }

    /// The entry on disk of a check that was sent.
    pub(super) fn head_of(&self, id: RecordId) -> Option<Head> {
        self.head_of_slip(self.checks.get(&id)?.slip)
    }

    /// A correction put a check into the history: the entry of this batch.
    pub(super) fn know_correction(&mut self, id: RecordId, run: u64, named: Named) {
        self.checks.insert(id, Known { slip: (run, 0), named, files: Vec::new() });
    }

    /// What has become of a check of the history; `None` where it was not sent.
    pub fn of_check(&self, id: RecordId) -> Option<Recorded<'_>> {
        match (self.numbers.get(&id), self.checks.get(&id)) {
            (Some(number), _) => Some(Recorded::Kept(*number)),
            (None, known) => self.of_slip(known?.slip),
        }
    }

    /// The check of the history that is recorded with a number.
    pub(super) fn check_of(&self, number: u64) -> Option<RecordId> {
        let ids = self.numbers.keys().chain(self.checks.keys()).copied();
        ids.into_iter().find(|id| self.of_check(*id) == Some(Recorded::Kept(number)))
    }

    /// What was named beside a check of the history.
    pub(super) fn named_of(&self, id: RecordId) -> Option<&Named> {
        self.checks.get(&id).map(|known| &known.named)
    }

    /// Entries that were read from the journal when it was opened.
    pub(super) fn know_parts<'a>(&mut self, entries: impl Iterator<Item = &'a Entry>) {
        let of_entry = |entry: &Entry| (entry.about.part.clone(), entry.about.serial.clone());
        self.parts.extend(entries.map(of_entry).filter(|(_, serial)| !serial.is_empty()));
    }

    /// Whether a check of a part with this serial number was sent since the window was opened, or is one of the newest of the journal.
    pub(super) fn has_serial(&self, part: &str, serial: &str) -> bool {
        let is_known = self.parts.contains(&(part.to_owned(), serial.to_owned()));
        is_known || self.checks.values().any(|known| known.named.serial == serial && known.named.part == part)
    }

    /// Whether the journal could not be opened.
    pub const fn has_failed_to_open(&self) -> bool {
        matches!(self.keeping, Keeping::Failed(_))
    }

    /// How many checks could not be written.
    pub fn failed(&self) -> usize {
        let failed = self.batches.values().filter(|batch| matches!(batch.fate, RecordingState::Failed(_)));
        failed.map(|batch| batch.entries.len()).sum()
    }

    /// How many checks are not on disk yet, failed or being written.
    pub fn unwritten(&self) -> usize {
        self.batches.values().map(|batch| batch.entries.len()).sum()
    }

    /// The checks of the history among these that are recorded or on their way.
    pub(super) fn has_any(&self, ids: &BTreeSet<RecordId>) -> bool {
        ids.iter().any(|id| self.numbers.contains_key(id) || self.checks.contains_key(id))
    }
}
