//! What changed since an earlier report of the same part: features whose result or limits are others, features that are new, and features that
//! are gone. The earlier report is its JSON, which a PDF has attached, too.
//!
//! Features are the same that have the same name, or the same callout where they have none. One that stands several times in a report is told
//! and not compared.

use std::collections::BTreeMap;
use std::io;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::verdict::Status;
use serde_json::Value;

use super::Report;
use super::part::PartSheet;

/// An earlier report, as far as a later one is compared with it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EarlierReport {
    /// When it was made, as it says it.
    pub created: String,
    features: Features,
}

impl EarlierReport {
    /// Reads a report as JSON.
    ///
    /// # Errors
    /// The bytes are none.
    pub fn read(json: &[u8]) -> Result<Self, Message> {
        let refused = || message!("report-since-no-report");
        let file: Value = serde_json::from_slice(json).map_err(|_not_json| refused())?;
        let created = file.get("created").and_then(Value::as_str).ok_or_else(refused)?.replace('T', " ");
        let features = Features::read(&file).ok_or_else(refused)?;
        Ok(Self { created, features })
    }
}

/// What changed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Changes {
    /// When the earlier report was made, as it says it.
    pub since: String,
    /// A sentence each, in the order of the report.
    pub lines: Vec<Message>,
}

/// What a report says of a feature.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Said {
    limits: Option<[Length; 2]>,
    /// Its verdict, and whether nobody measured; `None` where there is no value.
    status: Option<(Status, bool)>,
    /// How often it stands in the report.
    times: usize,
}

/// The features of a report by their names, in its order.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Features {
    order: Vec<String>,
    all: BTreeMap<String, Said>,
}

impl Features {
    fn see(&mut self, name: &str, limits: Option<[Length; 2]>, status: Option<(Status, bool)>) {
        if let Some(said) = self.all.get_mut(name) {
            said.times += 1;
            return;
        }
        self.order.push(name.to_owned());
        self.all.insert(name.to_owned(), Said { limits, status, times: 1 });
    }

    fn of(report: &Report) -> io::Result<Self> {
        let mut features = Self::default();
        report.checks.each(&mut |record| {
            let name = name(&record.id, || record.callout.map(|callout| callout.to_string()));
            let limits = [record.limits.minimum(), record.limits.maximum()];
            features.see(
                &name,
                Some(limits),
                Some((record.verdict.status(), record.measurement.origin.is_simulated())),
            );
            Ok(())
        })?;
        for missing in report.parts.iter().flat_map(PartSheet::missing) {
            features.see(&missing, None, None);
        }
        Ok(features)
    }

    /// Those of a report as JSON; `None` where it is none.
    fn read(file: &Value) -> Option<Self> {
        let mut features = Self::default();
        for check in file.get("checks")?.as_array()? {
            let text = |key: &str| check.get(key).and_then(Value::as_str);
            let length = |key: &str| check.get(key)?.to_string().trim_matches('"').parse::<Length>().ok();
            let name = name(text("id")?, || text("callout").map(str::to_owned));
            let status = Status::ALL.into_iter().find(|status| Some(status.word()) == text("status"))?;
            let is_simulated = check.get("simulated").and_then(Value::as_bool).unwrap_or(false);
            features.see(&name, Some([length("min_mm")?, length("max_mm")?]), Some((status, is_simulated)));
        }
        let parts = file.get("parts").and_then(Value::as_array).into_iter().flatten();
        for missing in parts.filter_map(|part| part.get("missing")?.as_array()).flatten() {
            features.see(missing.as_str()?, None, None);
        }
        Some(features)
    }
}

fn name(id: &str, callout: impl FnOnce() -> Option<String>) -> String {
    if id.is_empty() { callout().unwrap_or_default() } else { id.to_owned() }
}

impl Changes {
    /// What changed since an earlier report.
    ///
    /// # Errors
    /// The checks of the report cannot be read.
    pub(super) fn since(earlier: &EarlierReport, report: &Report) -> io::Result<Self> {
        let EarlierReport { created, features: before } = earlier;
        let now = Features::of(report)?;
        let mut lines = Vec::new();
        for name in &now.order {
            match (before.all.get(name), now.all.get(name)) {
                (None, _) => lines.push(message!("report-changed-added").text("name", name)),
                (Some(before), Some(now)) => lines.extend(changed(name, before, now)),
                (Some(_), None) => {}
            }
        }
        let gone = before.order.iter().filter(|name| !now.all.contains_key(*name));
        lines.extend(gone.map(|name| message!("report-changed-removed").text("name", name)));
        if lines.is_empty() {
            lines.push(message!("report-changed-none"));
        }
        Ok(Self { since: created.clone(), lines })
    }

    /// The sentence above them.
    pub fn heading(&self) -> Message {
        message!("report-changed-since").text("since", &self.since)
    }
}

/// What is another one of a feature.
fn changed(name: &str, before: &Said, now: &Said) -> Vec<Message> {
    if 1 < before.times.max(now.times) {
        return vec![message!("report-changed-several").text("name", name)];
    }
    let mut lines = Vec::new();
    if before.status != now.status {
        let said = message!("report-changed-result").text("name", name);
        lines.push(said.message("before", word(before.status)).message("now", word(now.status)));
    }
    if let (Some([low, high]), Some([lower, higher])) = (before.limits, now.limits)
        && before.limits != now.limits
    {
        let said = message!("report-changed-limits").text("name", name).text("low", low).text("high", high);
        lines.push(said.text("lower", lower).text("higher", higher));
    }
    lines
}

/// A result in words: what nobody measured is no plain verdict.
fn word(status: Option<(Status, bool)>) -> Message {
    match status {
        None => message!("report-missing"),
        Some((status, false)) => status.message(),
        Some((status, true)) => message!("status-simulated").message("status", status.message()),
    }
}
