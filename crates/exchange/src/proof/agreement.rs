//! The checks of a report as data beside the entries that they were made from.
//!
//! A report names the numbers of its checks, and its data has the checks in the order of the page; some of them may be in no journal. So the
//! checks are first looked for in the order of the numbers; where that does not come out, each is looked for anywhere, and what is left over
//! on both sides is told.

use std::fmt;

use fitcheck_core::message::{Say, printed, shortened};
use fitcheck_core::text::long;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, SeqAccess, Visitor};
use serde_json::{Number, Value};

use crate::journal::Record;
use crate::report::RenderError;
use crate::report::json::object;

/// What is compared, besides the name: the time of the check, its limits, the measured value and the verdict.
const FIELDS: [&str; 5] = ["time", "min_mm", "max_mm", "measured_mm", "status"];

/// A check of the journal that a report shows.
#[derive(Debug, Clone, Copy)]
pub struct JournalCheck<'a> {
    /// The number of its entry.
    pub number: u64,
    pub record: &'a Record,
    /// What its entry calls it, besides the record's own name: part, serial number and feature; the part alone. Each may be empty.
    pub names: [&'a str; 2],
}

/// Where the data of a report and the journal say different things.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "report-difference")]
pub enum Difference {
    /// A field of a check.
    Field {
        #[say(with = printed)]
        number: u64,
        /// The field, as it is called in the file.
        field: &'static str,
        /// What the file says.
        said: String,
        /// What the journal says.
        kept: String,
    },
    /// No check of the file says what an entry says.
    Missing {
        #[say(with = printed)]
        number: u64,
    },
    /// The file has more checks than are in the journal or were never recorded.
    More { count: u64 },
    /// The file has fewer.
    Fewer { count: u64 },
}

/// Why the data of a report cannot be compared.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "report-data", error)]
pub enum Disagreement {
    /// It is not what Fitcheck writes.
    Json {
        /// What the reader says.
        reason: String,
    },
    /// A check of the journal cannot be put into figures.
    #[say(transparent)]
    Render(RenderError),
}

/// What is read of a check of the file: plain values, since whatever else claims to be a check may be as large as the file.
#[derive(Debug, Deserialize)]
struct FileCheck {
    #[serde(default)]
    id: Option<String>,
    #[serde(default)]
    time: Option<String>,
    #[serde(default)]
    min_mm: Option<Number>,
    #[serde(default)]
    max_mm: Option<Number>,
    #[serde(default)]
    measured_mm: Option<Number>,
    #[serde(default)]
    status: Option<String>,
}

/// A check in texts: numbers as JSON prints them, nothing where there is none.
#[derive(Debug, PartialEq, Eq)]
struct Told {
    name: String,
    fields: [String; 5],
}

impl From<FileCheck> for Told {
    fn from(check: FileCheck) -> Self {
        let FileCheck { id, time, min_mm, max_mm, measured_mm, status } = check;
        // What the writer leaves out or writes as null are one thing here: nothing.
        let text = |text: Option<String>| text.unwrap_or_default();
        let number = |number: Option<Number>| number.map_or_else(String::new, |number| number.to_string());
        Self { name: text(id), fields: [text(time), number(min_mm), number(max_mm), number(measured_mm), text(status)] }
    }
}

/// A check of the journal as the file would have it.
struct Expected {
    number: u64,
    /// The entry's name, or else the record's: a report of records calls them by the former.
    told: Told,
    /// What else it may be called.
    others: [String; 2],
}

impl Expected {
    fn of(check: JournalCheck<'_>) -> Result<Self, RenderError> {
        let object = object(check.record)?;
        let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        let fields = FIELDS.map(|name| object.get(name).map_or_else(String::new, text));
        let [whole, part] = check.names;
        let own = check.record.id.clone();
        let name = if whole.is_empty() { own.clone() } else { whole.to_owned() };
        Ok(Self { number: check.number, told: Told { name, fields }, others: [own, part.to_owned()] })
    }

    fn is(&self, check: &Told) -> bool {
        self.is_called(check) && self.told.fields == check.fields
    }

    fn is_called(&self, check: &Told) -> bool {
        check.name == self.told.name || self.others.contains(&check.name)
    }

    /// What is other in a check that stands in its place.
    fn differences(&self, check: &Told) -> Vec<Difference> {
        let number = self.number;
        let shown = |text: &str| if text.is_empty() { "–".to_owned() } else { shortened(text, 80) };
        let field =
            |field, said: &str, kept: &str| Difference::Field { number, field, said: shown(said), kept: shown(kept) };
        let name = (!self.is_called(check)).then(|| field("id", &check.name, &self.told.name));
        let fields = FIELDS.into_iter().zip(check.fields.iter().zip(&self.told.fields));
        let others = fields.filter(|(_, (said, kept))| said != kept);
        name.into_iter().chain(others.map(|(name, (said, kept))| field(name, said, kept))).collect()
    }
}

/// Compares the data of a report with the checks of the journal that it shows, in the order of their numbers; `unrecorded` of its checks are
/// in no journal. Empty where they agree.
///
/// # Errors
/// [`Disagreement`] where the data is not what Fitcheck writes.
pub fn compare(json: &[u8], checks: &[JournalCheck<'_>], unrecorded: u64) -> Result<Vec<Difference>, Disagreement> {
    let expected: Result<Vec<Expected>, _> = checks.iter().map(|check| Expected::of(*check)).collect();
    let expected = expected.map_err(Disagreement::Render)?;
    let all = long(expected.len()).saturating_add(unrecorded);
    let read = read(json, usize::try_from(all).unwrap_or(usize::MAX))
        .map_err(|error| Disagreement::Json { reason: shortened(&error.to_string(), 200) })?;
    if 0 < read.more {
        return Ok(vec![Difference::More { count: read.more }]);
    }
    let fewer = all.saturating_sub(long(read.checks.len()));
    let mut rest = read.checks.iter();
    let is_in_order = expected.iter().all(|one| rest.any(|check| one.is(check)));
    let mut differences = if is_in_order { Vec::new() } else { left_over(&expected, read.checks) };
    // Which check is missing is told where the journal knows it.
    if differences.is_empty() && 0 < fewer {
        differences.push(Difference::Fewer { count: fewer });
    }
    Ok(differences)
}

/// What is left where each check of the journal is looked for anywhere in the file.
fn left_over(expected: &[Expected], checks: Vec<Told>) -> Vec<Difference> {
    let mut checks: Vec<Option<Told>> = checks.into_iter().map(Some).collect();
    let mut missing = Vec::new();
    // Both are mostly in one order: the search goes on behind the last find, and begins anew only where that finds nothing.
    let mut from = 0_usize;
    for one in expected {
        let is_it = |check: &Option<Told>| check.as_ref().is_some_and(|check| one.is(check));
        let behind = checks.iter().skip(from).position(is_it).map(|at| from.saturating_add(at));
        let found = behind.or_else(|| checks.iter().take(from).position(is_it));
        match found.and_then(|at| Some((at, checks.get_mut(at)?))) {
            Some((at, check)) => {
                *check = None;
                from = at.saturating_add(1);
            }
            None => missing.push(one),
        }
    }
    let rest: Vec<Told> = checks.into_iter().flatten().collect();
    if missing.len() == rest.len() {
        // What is left on both sides stands in each other's place.
        return missing.iter().zip(&rest).flat_map(|(one, check)| one.differences(check)).collect();
    }
    missing.iter().map(|one| Difference::Missing { number: one.number }).collect()
}

/// The checks of a file.
#[derive(Default)]
struct FileChecks {
    checks: Vec<Told>,
    /// How many there are besides: they are counted and not kept.
    more: u64,
}

/// Reads at most so many checks: what claims to be a report may have millions of them.
fn read(json: &[u8], most: usize) -> serde_json::Result<FileChecks> {
    let mut reader = serde_json::Deserializer::from_slice(json);
    let found = File { most }.deserialize(&mut reader)?;
    reader.end()?;
    Ok(found)
}

struct File {
    most: usize,
}

impl<'de> DeserializeSeed<'de> for File {
    type Value = FileChecks;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<FileChecks, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for File {
    type Value = FileChecks;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a report with checks")
    }

    fn visit_map<A: serde::de::MapAccess<'de>>(self, mut map: A) -> Result<FileChecks, A::Error> {
        let mut found = None;
        while let Some(key) = map.next_key::<String>()? {
            if key != "checks" {
                let _skipped: IgnoredAny = map.next_value()?;
            } else if found.replace(map.next_value_seed(List { most: self.most })?).is_some() {
                return Err(serde::de::Error::duplicate_field("checks"));
            }
        }
        found.ok_or_else(|| serde::de::Error::missing_field("checks"))
    }
}

struct List {
    most: usize,
}

impl<'de> DeserializeSeed<'de> for List {
    type Value = FileChecks;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<FileChecks, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for List {
    type Value = FileChecks;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of checks")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<FileChecks, A::Error> {
        let mut found = FileChecks::default();
        while found.checks.len() < self.most {
            match list.next_element::<FileCheck>()? {
                Some(check) => found.checks.push(check.into()),
                None => return Ok(found),
            }
        }
        while list.next_element::<IgnoredAny>()?.is_some() {
            found.more = found.more.saturating_add(1);
        }
        Ok(found)
    }
}
