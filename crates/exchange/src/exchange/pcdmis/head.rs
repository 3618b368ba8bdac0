//! The head of a report: part, serial number, operator, date and time.

use jiff::civil::{Date, DateTime, Time};

use crate::exchange::given::shorten;
use crate::exchange::measurements::date_time;

/// What the head says of all values below it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) part: String,
    pub(super) serial: String,
    pub(super) who: String,
    date: String,
    time: String,
    /// The entry that it begins with.
    first: Option<&'static str>,
    /// All that it says, as it says it.
    said: Vec<String>,
}

/// What the entries are called. `PARTNO` stands beside the name of the part.
const KEYS: [&str; 11] = [
    "DATE",
    "TIME",
    "PART NAME",
    "PARTNO",
    "PART NUMBER",
    "REV NUMBER",
    "SER NUMBER",
    "SERIAL NUMBER",
    "STATS COUNT",
    "OPERATOR",
    "INSPECTOR",
];

impl Head {
    /// Reads a line; `false` where it is none of a head.
    pub(super) fn line(&mut self, text: &str) -> bool {
        let entries = entries(text);
        let Some((first, _)) = entries.first() else { return false };
        // Each page begins with the whole head, and a report of another part with another one.
        if self.first == Some(*first) {
            *self = Self::default();
        }
        self.first = self.first.or(Some(*first));
        for (key, value) in entries {
            let field = match key {
                "DATE" => Some(&mut self.date),
                "TIME" => Some(&mut self.time),
                "PART NAME" => Some(&mut self.part),
                "SER NUMBER" | "SERIAL NUMBER" => Some(&mut self.serial),
                "OPERATOR" | "INSPECTOR" => Some(&mut self.who),
                _ => None,
            };
            if let Some(field) = field {
                value.clone_into(field);
            }
            if !value.is_empty() {
                self.said.push(format!("{key} {value}"));
            }
        }
        true
    }

    /// All that it says; empty where there is none.
    pub(super) fn said(&self) -> String {
        self.said.iter().map(|said| shorten(said)).collect::<Vec<_>>().join(", ")
    }

    /// When it was measured, where that can be read in one way alone.
    ///
    /// # Errors
    /// A date or a time that cannot.
    pub(super) fn date_time(&self) -> Result<Option<DateTime>, String> {
        if self.date.is_empty() {
            return Ok(None);
        }
        let given = || shorten(format!("{} {}", self.date, self.time).trim());
        let time = if self.time.is_empty() { Some(Time::midnight()) } else { time(&self.time) };
        let read = date(&self.date).zip(time).map(|(date, time)| date.to_datetime(time));
        read.map(Some).ok_or_else(given)
    }
}

/// The entries of a line, which begins with one: `PART NAME  : HOUSING     PARTNO: 4711-B`.
fn entries(text: &str) -> Vec<(&'static str, &str)> {
    let mut found: Vec<(usize, usize, &'static str)> = Vec::new();
    for key in KEYS {
        for (at, _) in text.match_indices(key) {
            let behind = fitcheck_core::text::behind(text, at + key.len());
            let is_word = !fitcheck_core::text::before(text, at).ends_with(char::is_alphanumeric);
            let value = behind.trim_start().strip_prefix([':', '=']);
            if let Some(value) = value.filter(|_| is_word) {
                found.push((at, text.len() - value.len(), key));
            }
        }
    }
    found.sort_unstable();
    let begins = found.first().is_some_and(|(at, ..)| fitcheck_core::text::before(text, *at).trim().is_empty());
    if !begins {
        return Vec::new();
    }
    let ends = found.iter().skip(1).map(|(at, ..)| *at).chain([text.len()]);
    let entry = |((_, from, key), end): (&(usize, usize, &'static str), usize)| {
        (*key, fitcheck_core::text::part(text, *from, end.max(*from)).trim())
    };
    found.iter().zip(ends).map(entry).collect()
}

/// English months, as reports have them.
const MONTHS: [&str; 12] = ["jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec"];

/// `17-Sep-25`, `September 17, 2025`, or figures that can be read in one way alone.
fn date(text: &str) -> Option<Date> {
    let parts: Vec<&str> = text.split(['-', '/', '.', ',', ' ']).filter(|part| !part.is_empty()).collect();
    let [first, second, third] = parts.as_slice() else { return None };
    let number = |text: &str| text.parse::<i16>().ok().filter(|_| text.bytes().all(|byte| byte.is_ascii_digit()));
    let month = |text: &str| {
        let begin: String = text.chars().take(3).collect::<String>().to_lowercase();
        let at = MONTHS.iter().position(|month| *month == begin).filter(|_| text.chars().all(char::is_alphabetic))?;
        i16::try_from(at + 1).ok()
    };
    let year = |text: &str| match (number(text)?, text.len()) {
        (year, 2) => Some(2000 + year),
        (year, 4) => Some(year),
        _ => None,
    };
    let (year, month, day) = match (month(first), month(second)) {
        (Some(month), None) => (year(third)?, month, number(second)?),
        (None, Some(month)) => (year(third)?, month, number(first)?),
        (None, None) if first.len() == 4 => (year(first)?, number(second)?, number(third)?),
        // Day or month first: only where one of them can be no month.
        (None, None) => match (number(first)?, number(second)?) {
            (day @ 13.., month) | (month, day @ 13..) => (year(third)?, month, day),
            (day, month) if day == month || text.contains('.') => (year(third)?, month, day),
            _ => return None,
        },
        (Some(_), Some(_)) => return None,
    };
    Date::new(year, month.try_into().ok()?, day.try_into().ok()?).ok()
}

/// `10:09:47`, or with `AM` or `PM` behind it.
fn time(text: &str) -> Option<Time> {
    let small = text.trim().to_lowercase();
    let half = ["am", "pm"].into_iter().find(|half| small.ends_with(half));
    let clock = small.trim_end_matches(['a', 'p', 'm', ' ', '.']);
    let read = date_time(&format!("2000-01-01 {clock}"))?.time();
    let hour = match (half, read.hour()) {
        (Some(_), 0 | 13..) => return None,
        (Some("am"), 12) => 0,
        (Some("pm"), hour) if hour < 12 => hour + 12,
        (_, hour) => hour,
    };
    Time::new(hour, read.minute(), read.second(), 0).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_date_that_can_be_read_in_two_ways_is_none() {
        for (given, expected) in [
            ("17-Sep-25", Some("2025-09-17")),
            ("September 17, 2025", Some("2025-09-17")),
            ("9/17/2025", Some("2025-09-17")),
            ("17/9/2025", Some("2025-09-17")),
            ("05.09.2025", Some("2025-09-05")),
            ("2025-09-05", Some("2025-09-05")),
            ("9/9/2025", Some("2025-09-09")),
            ("5/9/2025", None),
            ("31-Feb-25", None),
            ("yesterday", None),
        ] {
            assert_eq!(date(given).map(|date| date.to_string()).as_deref(), expected, "{given}");
        }
    }

    #[test]
    fn a_time_may_have_twelve_hours_twice() {
        for (given, expected) in [
            ("10:09:47 AM", Some("10:09:47")),
            ("10:09:47 PM", Some("22:09:47")),
            ("12:00 am", Some("00:00:00")),
            ("12:30 pm", Some("12:30:00")),
            ("22:09", Some("22:09:00")),
            ("22:09 PM", None),
            ("x", None),
        ] {
            assert_eq!(time(given).map(|time| time.to_string()).as_deref(), expected, "{given}");
        }
    }
}
