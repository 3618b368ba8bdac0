//! A journal that is not there: any number of records, made as they are asked for, a reader that takes its time, and a disk that is
//! full until it is not.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering::SeqCst};
use std::sync::{Arc, Mutex, OnceLock};
use std::time::Duration;

use fitcheck::gui::journal::{Journals, Keeps, ReadError, Reads};
use fitcheck::journal::Record;
use fitcheck::journal::ask::Question;
use fitcheck::journal::chain::{ChainId, Hash, Head};
use fitcheck::journal::entry::{About, Check, Checked, Content, Entry, Moment};
use fitcheck::length::Length;
use fitcheck::message::Message;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::session::records::Verified;
use fitcheck::session::{OpenJournal, RecordRow};
use fitcheck::tolerance::{Callout, Limits, Sources};

use crate::harness::moment;

/// The journal.
#[derive(Debug, Clone, Default)]
pub struct Fake {
    /// How many entries it has.
    pub count: u64,
    /// How long a call of its reader takes.
    pub slow: Duration,
    /// Held while the disk takes nothing.
    pub disk: Arc<Mutex<()>>,
    /// Whether nothing can be written.
    pub is_full: Arc<AtomicBool>,
    /// What was written.
    pub written: Arc<Mutex<Vec<Entry>>>,
    /// How many rows were read.
    pub read: Arc<AtomicUsize>,
    /// How often a call was stopped.
    pub stopped: Arc<AtomicU64>,
}

impl Fake {
    pub fn of(count: u64, slow: Duration) -> Self {
        Self { count, slow, ..Self::default() }
    }

    fn newest(&self) -> u64 {
        self.count + u64::try_from(self.written.lock().unwrap().len()).unwrap()
    }

    fn head(&self) -> Head {
        Head { number: self.newest(), hash: Hash(std::array::from_fn(|at| u8::try_from(37 * (at + 5) % 251).unwrap())) }
    }

    /// Waits as a slow disk does; somebody may stop that.
    fn wait(&self) -> Result<(), ReadError> {
        let before = self.stopped.load(SeqCst);
        let mut waited = Duration::ZERO;
        while waited < self.slow {
            std::thread::sleep(Duration::from_millis(5));
            waited += Duration::from_millis(5);
            if self.stopped.load(SeqCst) != before {
                return Err(ReadError::Interrupted);
            }
        }
        Ok(())
    }
}

/// Record `number`: part `P` and its number, of which every tenth is scrap.
fn entry(number: u64) -> Entry {
    static LIMITS: OnceLock<(Callout, Limits)> = OnceLock::new();
    let (callout, limits) = LIMITS
        .get_or_init(|| {
            let callout: Callout = "25 H7".parse().unwrap();
            (callout, Sources::default().limits(&callout, None).unwrap())
        })
        .clone();
    let um = if number.is_multiple_of(10) { 40 } else { i64::try_from(number % 10).unwrap() };
    let measured = Length::from_nanometres(25_000_000 + um * 1_000).unwrap();
    let time = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
    let part = format!("P{number}");
    let measurement = Measurement::of_diameter(measured, Origin::Typed);
    let record = Record::judged(time, part.clone(), Some(callout), limits, measurement, None);
    let about = About {
        station: "Mill 3".to_owned(),
        time: moment(),
        who: "Anna".to_owned(),
        part,
        serial: String::new(),
        feature: String::new(),
        remark: String::new(),
    };
    let check = Check { what: Checked::Size(Arc::new(record)), files: Vec::new(), corrects: None };
    Entry { about, content: Content::Check(Box::new(check)) }
}

impl Journals for Fake {
    fn open(&self, _: &Path, _: &str, _: &Moment) -> Result<(Box<dyn Keeps>, Box<OpenJournal>), Message> {
        let opened = OpenJournal { chain: ChainId([1; 16]), head: self.head(), remarks: Vec::new() };
        Ok((Box::new(self.clone()), Box::new(opened)))
    }

    fn reader(&self, _: &Path) -> Result<Box<dyn Reads>, Message> {
        Ok(Box::new(self.clone()))
    }

    fn bodies(&self, _: &Path, see: &mut dyn FnMut(&[u8])) -> Result<(), Message> {
        let written = self.written.lock().unwrap();
        written.iter().for_each(|entry| see(&fitcheck::journal::body::write(entry).unwrap()));
        Ok(())
    }

    fn verify(&self, _: &Path, progress: &mut dyn FnMut(u64, u64) -> ControlFlow<()>) -> Result<Verified, Message> {
        for done in 0..self.count {
            if progress(done, self.count).is_break() {
                return Err(Message::new("store-interrupted"));
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        Ok(Verified { entries: self.count, head: self.head(), problems: Vec::new() })
    }
}

impl Keeps for Fake {
    fn append(&mut self, entries: &[Entry]) -> Result<Vec<Head>, Message> {
        drop(self.disk.lock().unwrap());
        if self.is_full.load(SeqCst) {
            return Err(Message::new("records-page-no-thread"));
        }
        let heads = entries.iter().map(|entry| {
            self.written.lock().unwrap().push(entry.clone());
            self.head()
        });
        Ok(heads.collect())
    }
}

impl Reads for Fake {
    fn newest(&self) -> Result<Head, ReadError> {
        self.wait()?;
        Ok(self.head())
    }

    fn numbers(&self, question: &Question, before: Option<u64>, most: usize) -> Result<Vec<u64>, ReadError> {
        self.wait()?;
        let from = before.unwrap_or(self.newest() + 1);
        // Words ask for numbers that end with them; verdicts for the tenth ones.
        let is_asked = |number: &u64| {
            question.words.iter().all(|word| number.to_string().ends_with(word.as_str()))
                && (question.verdicts.is_empty() || number.is_multiple_of(10))
        };
        Ok((2..from).rev().filter(is_asked).take(most).collect())
    }

    fn rows(&self, numbers: &[u64]) -> Result<Vec<RecordRow>, ReadError> {
        self.wait()?;
        self.read.fetch_add(numbers.len(), SeqCst);
        let newest = self.newest();
        let written = self.written.lock().unwrap();
        let corrects = |entry: &Entry| entry.corrects().map(|correction| correction.target.number);
        let corrected_by = |number: u64| {
            let by = written.iter().position(|entry| corrects(entry) == Some(number))?;
            Some(self.count + 1 + u64::try_from(by).unwrap())
        };
        let row = |number: &u64| {
            let own = number.checked_sub(self.count + 1).and_then(|at| written.get(usize::try_from(at).ok()?));
            RecordRow {
                head: Head {
                    number: *number,
                    hash: Hash(std::array::from_fn(|at| u8::try_from(37 * (at + 5) % 251).unwrap())),
                },
                entry: Ok(own.cloned().unwrap_or_else(|| entry(*number))),
                corrected_by: corrected_by(*number),
                went_back: false,
            }
        };
        Ok(numbers.iter().filter(|number| **number <= newest).map(row).collect())
    }

    fn reports_of(&self, number: u64) -> Result<Vec<RecordRow>, ReadError> {
        let written = self.written.lock().unwrap().clone();
        let shows = |entry: &Entry| entry.report().is_some_and(|report| report.shown.checks.contains(number));
        let places = (self.count + 1..).zip(&written).filter(|(_, entry)| shows(entry)).map(|(number, _)| number);
        self.rows(&places.collect::<Vec<_>>())
    }

    fn interrupt(&self) -> Arc<dyn Fn() + Send + Sync> {
        let stopped = Arc::clone(&self.stopped);
        Arc::new(move || _ = stopped.fetch_add(1, SeqCst))
    }
}
