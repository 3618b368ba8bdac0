//! A question as its text, which reads back as the same.

use jiff::Timestamp;

use super::reading::{SWITCHES, begin_of, verdict_of};
use super::{AskedKinds, LocalNow, Question};

impl Question {
    /// Its text. Where it begins and ends with days of the place where it is asked, these are named; other instants are in UTC.
    pub fn text(&self, here: &LocalNow) -> String {
        let mut words = Vec::new();
        let named = [
            ("part", &self.part),
            ("serial", &self.serial),
            ("feature", &self.feature),
            ("callout", &self.callout),
            ("class", &self.class),
        ];
        let mut name = |(key, text): (&str, &Option<String>)| {
            words.extend(text.as_ref().map(|text| asking(key, text)));
        };
        named.into_iter().for_each(&mut name);
        let verdicts: Vec<String> = self.verdicts.iter().map(|status| status.key().to_owned()).collect();
        name(("verdict", &(!verdicts.is_empty()).then(|| verdicts.join(","))));
        name(("who", &self.who));
        name(("station", &self.station));
        name(("from", &self.from_ms.map(|ms| instant(ms, here, false))));
        name(("to", &self.before_ms.map(|ms| instant(ms, here, true))));
        words.extend(self.simulated.map(|simulated| if simulated { "simulated" } else { "measured" }.to_owned()));
        if self.standing {
            words.push("standing".to_owned());
        }
        words.extend(match self.kinds {
            AskedKinds::All => None,
            AskedKinds::Checks => Some("checks".to_owned()),
            AskedKinds::Reports => Some("reports".to_owned()),
            AskedKinds::Alarms => Some("alarms".to_owned()),
        });
        words.extend(self.words.iter().map(|text| word(text)));
        words.join(" ")
    }
}

/// A day where an instant begins one, or ends one; otherwise a time in UTC.
fn instant(ms: i64, here: &LocalNow, is_end: bool) -> String {
    let Ok(time) = Timestamp::from_millisecond(ms) else { return ms.to_string() };
    let day = time.to_zoned(here.zone.clone()).date();
    let day = if is_end { day.yesterday() } else { Ok(day) };
    let begins = |day: &jiff::civil::Date| {
        let first = if is_end { day.tomorrow().ok() } else { Some(*day) };
        first.and_then(|first| begin_of(first, here)) == Some(ms)
    };
    match day {
        // Other years have more digits.
        Ok(day) if begins(&day) && (0..=9999).contains(&day.year()) => day.to_string(),
        _ => time.to_string(),
    }
}

/// A word that asks for a value by its key.
pub fn asking(key: &str, text: &str) -> String {
    format!("{key}:{}", value(text))
}

/// A value, in quotation marks where it needs them.
fn value(text: &str) -> String {
    let is_plain = !text.is_empty() && !text.contains(|sign: char| sign.is_whitespace() || sign == '"');
    if is_plain { text.to_owned() } else { quoted(text) }
}

/// A word, in quotation marks where it would be something else without them.
fn word(text: &str) -> String {
    let is_switch = SWITCHES.contains(&text.to_lowercase().as_str());
    if is_switch || verdict_of(text, &[]).is_some() || text.contains(':') { quoted(text) } else { value(text) }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}
