//! From a text to a question.

use std::ops::Range;
use std::str::FromStr as _;

use fitcheck_core::length::Length;
use fitcheck_core::message::shortened;
use fitcheck_core::tolerance::{Callout, CalloutError, ToleranceClass};
use fitcheck_core::verdict::Status;
use jiff::civil::{Date, DateTime};
use jiff::{Timestamp, ToSpan as _};

use super::{AskError, AskErrorKind, AskedKinds, LocalNow, Question};

/// The longest text of a question, bytes.
pub(super) const LONGEST: usize = 65_536;

/// What has a value after a colon.
pub const KEYS: [&str; 10] =
    ["part", "serial", "feature", "callout", "class", "verdict", "who", "station", "from", "to"];

/// What stands alone.
pub const SWITCHES: [&str; 8] = ["today", "week", "simulated", "measured", "standing", "checks", "reports", "alarms"];

struct Word {
    /// Before the colon, in small letters; `None` where there is none.
    key: Option<String>,
    /// What follows, without its quotation marks.
    value: String,
    /// Whether it had quotation marks.
    is_quoted: bool,
    /// Its characters, from 0.
    span: Range<usize>,
    /// The characters of its value.
    value_span: Range<usize>,
}

impl Question {
    /// Reads a question; days are those of the place where it is asked.
    ///
    /// # Errors
    /// [`AskError`] with the place of what is wrong, and what is allowed.
    pub fn read(text: &str, here: &LocalNow) -> Result<Self, AskError> {
        Self::read_named(text, here, &[])
    }

    /// Reads a question of somebody who calls verdicts by these names, too.
    ///
    /// # Errors
    /// As for [`Self::read`].
    pub fn read_named(text: &str, here: &LocalNow, named: &[(String, Status)]) -> Result<Self, AskError> {
        if LONGEST < text.len() {
            let kind = AskErrorKind::TooLong { bytes: text.len(), most: LONGEST };
            return Err(AskError { kind, span: 0..text.chars().count() });
        }
        let mut question = Self::default();
        // Verdicts that stand alone: any of them is asked for, of checks that stand.
        let mut alone = Vec::new();
        let words = words(text)?;
        let mut at = 0;
        while let Some(word) = words.get(at) {
            let rest = words.get(at..).unwrap_or(&[]);
            if let Some((status, count)) = verdict_at(rest, named) {
                alone.push(status);
                at += count;
                continue;
            }
            at += 1;
            let span = word.span.clone();
            match &word.key {
                Some(key) => question.take(key, word, here)?,
                None => question.take_word(word, here)?,
            }
            if question.from_ms.zip(question.before_ms).is_some_and(|(from, before)| before <= from) {
                return Err(AskError { kind: AskErrorKind::Order, span });
            }
        }
        question.standing |= !alone.is_empty();
        for status in alone {
            if !question.verdicts.contains(&status) {
                question.verdicts.push(status);
            }
        }
        Ok(question)
    }

    /// A word with a colon.
    fn take(&mut self, key: &str, word: &Word, here: &LocalNow) -> Result<(), AskError> {
        let wrong = |kind| AskError { kind, span: word.value_span.clone() };
        let twice = || AskError { kind: AskErrorKind::Twice { key: key.to_owned() }, span: word.span.clone() };
        let set = |place: &mut Option<String>, text: String| match place.replace(text) {
            Some(_) => Err(twice()),
            None => Ok(()),
        };
        let value = word.value.as_str();
        match key {
            "part" => set(&mut self.part, value.to_owned()),
            "serial" => set(&mut self.serial, value.to_owned()),
            "feature" => set(&mut self.feature, value.to_owned()),
            "who" => set(&mut self.who, value.to_owned()),
            "station" => set(&mut self.station, value.to_owned()),
            "callout" => {
                let callout = asked_callout(value).map_err(|error| wrong(AskErrorKind::Callout { error }))?;
                set(&mut self.callout, callout)
            }
            "class" => {
                let class = ToleranceClass::from_str(value).map_err(|error| wrong(AskErrorKind::Class { error }))?;
                set(&mut self.class, class.to_string())
            }
            "verdict" if self.verdicts.is_empty() => {
                self.verdicts = verdicts(value).map_err(wrong)?;
                Ok(())
            }
            "verdict" => Err(twice()),
            "from" => {
                let begin = moment(value, here, false).ok_or_else(|| wrong(not_a_date(value)))?;
                if self.from_ms.replace(begin).is_some() { Err(twice()) } else { Ok(()) }
            }
            "to" => {
                let end = moment(value, here, true).ok_or_else(|| wrong(not_a_date(value)))?;
                if self.before_ms.replace(end).is_some() { Err(twice()) } else { Ok(()) }
            }
            _ => {
                let key = shortened(key, 40);
                let known = KEYS.map(|key| format!("{key}:")).join(", ");
                Err(AskError { kind: AskErrorKind::UnknownKey { key, known }, span: word.span.clone() })
            }
        }
    }

    /// A word without a colon.
    fn take_word(&mut self, word: &Word, here: &LocalNow) -> Result<(), AskError> {
        let wrong = |kind| AskError { kind, span: word.span.clone() };
        let small = word.value.to_lowercase();
        let switch = SWITCHES.into_iter().find(|switch| !word.is_quoted && *switch == small);
        let Some(switch) = switch else {
            if word.value.trim().is_empty() {
                return Err(wrong(AskErrorKind::EmptyWord));
            }
            self.words.push(word.value.clone());
            return Ok(());
        };
        let twice = || wrong(AskErrorKind::Twice { key: switch.to_owned() });
        match switch {
            "today" => self.days(here, here.today(), 1).ok_or_else(twice),
            "week" => {
                let today = here.today();
                let since = here.today().weekday().to_monday_zero_offset();
                let monday = today.checked_sub(i64::from(since).days()).unwrap_or(today);
                self.days(here, monday, 7).ok_or_else(twice)
            }
            "standing" if self.standing => Err(twice()),
            "standing" => {
                self.standing = true;
                Ok(())
            }
            "checks" | "reports" | "alarms" => {
                let asked = match switch {
                    "checks" => AskedKinds::Checks,
                    "reports" => AskedKinds::Reports,
                    _ => AskedKinds::Alarms,
                };
                match std::mem::replace(&mut self.kinds, asked) {
                    AskedKinds::All => Ok(()),
                    before if before == asked => Err(twice()),
                    _ => Err(wrong(AskErrorKind::BothKinds)),
                }
            }
            _ => match self.simulated.replace(switch == "simulated") {
                None => Ok(()),
                Some(before) if before == (switch == "simulated") => Err(twice()),
                Some(_) => Err(wrong(AskErrorKind::BothOrigins)),
            },
        }
    }

    /// Asks for so many days from one on; `None` where days are asked for already.
    fn days(&mut self, here: &LocalNow, first: Date, count: i64) -> Option<()> {
        if self.from_ms.is_some() || self.before_ms.is_some() {
            return None;
        }
        self.from_ms = begin_of(first, here);
        self.before_ms = first.checked_add(count.days()).ok().and_then(|day| begin_of(day, here));
        Some(())
    }
}

/// A callout as records are found by it: limits from a log have none, and are found by their nominal size.
fn asked_callout(text: &str) -> Result<String, CalloutError> {
    match text.strip_prefix('Ø').map(str::parse::<Length>) {
        Some(Ok(nominal)) => Ok(format!("Ø {nominal}")),
        _ => text.parse().map(|callout: Callout| callout.to_string()),
    }
}

fn not_a_date(value: &str) -> AskErrorKind {
    AskErrorKind::Date { given: shortened(value, 40) }
}

/// The instant at which a day begins where somebody asks.
pub(super) fn begin_of(day: Date, here: &LocalNow) -> Option<i64> {
    day.to_zoned(here.zone.clone()).ok().map(|begin| begin.timestamp().as_millisecond())
}

/// A day, a local time or an instant. The end of a day is the beginning of the next one.
fn moment(text: &str, here: &LocalNow, is_end: bool) -> Option<i64> {
    let is_day = text.len() == "2026-11-23".len() && text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'-');
    if is_day {
        let day: Date = text.parse().ok()?;
        return begin_of(if is_end { day.tomorrow().ok()? } else { day }, here);
    }
    if !text.contains('T') {
        return None;
    }
    if text.ends_with('Z') {
        let instant: Timestamp = text.parse().ok()?;
        return Some(instant.as_millisecond());
    }
    let local = text.bytes().all(|byte| byte.is_ascii_digit() || b"-:.T".contains(&byte));
    let time: DateTime = local.then(|| text.parse().ok()).flatten()?;
    time.to_zoned(here.zone.clone()).ok().map(|time| time.timestamp().as_millisecond())
}

/// The verdict of a word that stands alone, as it is called in English or by one of these names.
pub fn verdict_of(word: &str, named: &[(String, Status)]) -> Option<Status> {
    let word = word.trim().to_lowercase();
    let english = Status::ALL.into_iter().find(|status| status.key() == word || status.word().to_lowercase() == word);
    english.or_else(|| named.iter().find(|(name, _)| name.to_lowercase() == word).map(|(_, status)| *status))
}

/// The verdict that words begin with, and of how many of them its name is.
fn verdict_at(words: &[Word], named: &[(String, Status)]) -> Option<(Status, usize)> {
    let longest = named.iter().map(|(name, _)| name.split_whitespace().count()).max().unwrap_or(1).max(1);
    let plain = words.iter().take(longest).take_while(|word| word.key.is_none() && !word.is_quoted);
    let plain: Vec<&str> = plain.map(|word| word.value.as_str()).collect();
    (1..=plain.len()).rev().find_map(|count| Some((verdict_of(&plain.get(..count)?.join(" "), named)?, count)))
}

/// Verdicts with commas between them, each once.
fn verdicts(text: &str) -> Result<Vec<Status>, AskErrorKind> {
    let mut found = Vec::new();
    for given in text.split(',') {
        let word = given.trim().to_ascii_lowercase();
        let status =
            Status::ALL.into_iter().find(|status| status.key() == word || status.word().to_ascii_lowercase() == word);
        let status = status.or_else(|| (word == "remeasure").then_some(Status::ReMeasure));
        let Some(status) = status else {
            let known = Status::ALL.map(Status::key).join(", ");
            return Err(AskErrorKind::Verdict { given: shortened(given, 40), known });
        };
        if !found.contains(&status) {
            found.push(status);
        }
    }
    Ok(found)
}

/// The characters of a text, one after another.
struct Signs {
    signs: Vec<char>,
    at: usize,
}

impl Signs {
    fn peek(&self) -> Option<char> {
        self.signs.get(self.at).copied()
    }

    /// Up to the first character for which something holds.
    fn until(&mut self, ends: impl Fn(char) -> bool) -> String {
        let text: String = self.signs.iter().skip(self.at).copied().take_while(|sign| !ends(*sign)).collect();
        self.at += text.chars().count();
        text
    }

    /// A text in quotation marks, from its first one on.
    fn quoted(&mut self) -> Result<String, AskError> {
        let start = self.at;
        let mut text = String::new();
        loop {
            self.at += 1;
            text.push_str(&self.until(|sign| sign == '"'));
            self.at += 1;
            match self.peek() {
                _ if self.signs.len() < self.at => {
                    return Err(AskError { kind: AskErrorKind::NotClosed, span: start..self.signs.len() });
                }
                Some('"') => text.push('"'),
                None => return Ok(text),
                Some(blank) if blank.is_whitespace() => return Ok(text),
                Some(other) => {
                    let kind = AskErrorKind::AfterQuote { found: shortened(&other.to_string(), 1) };
                    return Err(AskError { kind, span: self.at..self.at + 1 });
                }
            }
        }
    }
}

/// Whether letters before a colon are a name of something to ask for. `12:30` is a word.
fn is_key(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|sign| sign.is_alphabetic() || sign == '-' || sign == '_')
}

fn words(text: &str) -> Result<Vec<Word>, AskError> {
    let mut signs = Signs { signs: text.chars().collect(), at: 0 };
    let mut words = Vec::new();
    loop {
        let _blanks = signs.until(|sign| !sign.is_whitespace());
        let start = signs.at;
        let Some(first) = signs.peek() else { return Ok(words) };
        if first == '"' {
            let value = signs.quoted()?;
            let span = start..signs.at;
            words.push(Word { key: None, value, is_quoted: true, span: span.clone(), value_span: span });
            continue;
        }
        let head = signs.until(|sign| sign.is_whitespace() || sign == ':');
        if signs.peek() != Some(':') || !is_key(&head) {
            let value = head + &signs.until(char::is_whitespace);
            let span = start..signs.at;
            words.push(Word { key: None, value, is_quoted: false, span: span.clone(), value_span: span });
            continue;
        }
        signs.at += 1;
        let begin = signs.at;
        let is_quoted = signs.peek() == Some('"');
        let value = if is_quoted { signs.quoted()? } else { signs.until(char::is_whitespace) };
        let span = start..signs.at;
        let value_span = begin..signs.at;
        let key = head.to_lowercase();
        if value.is_empty() && !is_quoted && KEYS.contains(&key.as_str()) {
            return Err(AskError { kind: AskErrorKind::NoValue { key }, span });
        }
        words.push(Word { key: Some(key), value, is_quoted, span, value_span });
    }
}
