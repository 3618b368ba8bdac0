//! The date and time of a row.

use jiff::civil::{DateTime, Time};

/// Whether a date and time says how far it is from UTC, or in which time zone it is.
pub(super) fn has_offset(given: &str) -> bool {
    let time = given.split_once(['T', 't', ' ']).map_or("", |(_, time)| time);
    given.contains('[') || time.contains(['+', '-', '\u{2212}'])
}

/// `2024-03-14 08:05:09` as in ISO 8601 (the time is optional), or day first: `14.3.2024 8:05`.
pub(in crate::exchange) fn date_time(given: &str) -> Option<DateTime> {
    if let Ok(time) = given.parse() {
        return Some(time);
    }
    let (day, time) = given.split_once([' ', 'T']).unwrap_or((given, "0:00"));
    let mut parts = day.split(['-', '.']);
    let day = parts.next()?;
    let month = parts.next()?;
    let year = parts.next()?;
    let year = year.parse().ok().filter(|year| 1000 <= *year)?;
    let date = jiff::civil::Date::new(year, month.parse().ok()?, day.parse().ok()?).ok()?;
    let mut parts = time.trim().split(':');
    let hour = parts.next()?.parse().ok()?;
    let minute = parts.next()?.parse().ok()?;
    let second = parts.next().map_or(Some(0), |second| second.parse().ok())?;
    Some(date.to_datetime(Time::new(hour, minute, second, 0).ok()?))
}
