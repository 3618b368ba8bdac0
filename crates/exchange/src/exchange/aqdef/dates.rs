//! Dates of values. What stands between day, month and year says their order: `15.01.2025`, `01/15/2025`, `2025-01-15`.

use jiff::civil::{Date, DateTime, Time};

/// A date with its time, such as `15.01.2025/10:21:33`; `None` where it is in no known order.
pub(super) fn date_time(text: &str) -> Option<DateTime> {
    let text = text.trim();
    let colon = text.find(':')?;
    // The hour has one figure or two.
    let before = text.get(..colon)?;
    let hour = before.rfind(|sign: char| !sign.is_ascii_digit())?;
    let (date, rest) = text.split_at_checked(hour)?;
    let time = rest.strip_prefix(['/', ' ', '.', 'T'])?;
    Some(date_of(date.trim())?.to_datetime(time_of(time)?))
}

/// A date and time without the offset from UTC at its end, `+02:00` or `Z`; `None` where there is none.
pub(super) fn without_offset(text: &str) -> Option<&str> {
    let text = text.trim();
    if let Some(text) = text.strip_suffix('Z') {
        return Some(text);
    }
    let (time, offset) = text.split_at_checked(text.len().checked_sub(6)?)?;
    (offset.starts_with(['+', '-']) && time.contains(':')).then_some(time)
}

fn date_of(text: &str) -> Option<Date> {
    let parts = |sign| -> Option<[&str; 3]> { text.split(sign).collect::<Vec<_>>().try_into().ok() };
    let (year, month, day) = if let Some([day, month, year]) = parts('.') {
        (year, month, day)
    } else if let Some([month, day, year]) = parts('/') {
        (year, month, day)
    } else {
        let [year, month, day] = parts('-')?;
        (year, month, day)
    };
    let year = match (year.len(), figures(year, 4)?) {
        // Two figures are those of this century.
        (2, year) => 2000 + year,
        (4, year) => year,
        _ => return None,
    };
    Date::new(year, figures(month, 2)?.try_into().ok()?, figures(day, 2)?.try_into().ok()?).ok()
}

/// Hours and minutes, with or without seconds.
fn time_of(text: &str) -> Option<Time> {
    let mut parts = text.split(':');
    let mut next = || figures(parts.next()?, 2)?.try_into().ok();
    let hour = next()?;
    let minute = next()?;
    let second = if text.matches(':').count() == 2 { next()? } else { 0 };
    if parts.next().is_some() {
        return None;
    }
    Time::new(hour, minute, second, 0).ok()
}

fn figures(text: &str, most: usize) -> Option<i16> {
    let is_number = !text.is_empty() && text.len() <= most && text.bytes().all(|byte| byte.is_ascii_digit());
    if is_number { text.parse().ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sign_between_says_the_order() {
        let expected = DateTime::constant(2018, 5, 9, 10, 5, 59, 0);
        for text in [
            "09.05.2018/10:05:59",
            "9.5.18/10:5:59",
            "9.5.2018 10:05:59",
            "09.05.18.10:05:59",
            "05/09/2018/10:05:59",
            "5/9/18 10:05:59",
            "5/9/18.10:05:59",
            "2018-05-09/10:05:59",
            "18-5-9 10:05:59",
            "2018-05-09T10:05:59",
        ] {
            assert_eq!(date_time(text), Some(expected), "{text}");
        }
        for text in ["2018-05-09T10:05:59+02:00", "2018-05-09T10:05:59Z", "2018-05-09T10:05:59-11:30"] {
            assert_eq!((date_time(text), without_offset(text).and_then(date_time)), (None, Some(expected)), "{text}");
        }
        assert_eq!(without_offset("ä:01-02-2018"), None);
        assert_eq!(date_time("9.5.18/10:05"), Some(DateTime::constant(2018, 5, 9, 10, 5, 0, 0)));
    }

    #[test]
    fn another_order_is_not_guessed() {
        for text in [
            "20/05/2018/18:05:10",
            "20-05-2018/18:05:10",
            "05.20.2018/18:05:10",
            "2018.05.20/18:05:10",
            "2018/05/20/18:05:10",
            "09.05.2018",
            "09.05.218/10:05:59",
            "09.05.2018/25:05:59",
            "31.02.2018/10:05:59",
            "09.05.2018/10:05:59:1",
            "",
            ":",
        ] {
            assert_eq!(date_time(text), None, "{text}");
        }
    }
}
