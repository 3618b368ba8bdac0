//! The time zone of this computer: in which zone it is now, and what to say where nobody knows.
//!
//! The system's own database of zones comes first, since it is kept up to date; the one that is compiled in answers where the system has
//! none, or lacks the zone. What is not understood is told, and never taken for UTC in silence.

use std::ffi::OsString;
use std::path::Path;

use fitcheck_core::message::{Say, shortened};
use jiff::tz::{TimeZone, TimeZoneDatabase};
use jiff::{Timestamp, Zoned};

/// Why the time zone of this computer is not known.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "zone", error)]
pub enum ZoneError {
    /// `TZ` is set, and names no zone.
    NotUnderstood {
        /// What it says.
        given: String,
    },
    /// Neither `TZ` nor the system tells a zone.
    Unknown,
}

/// The zone of this computer.
///
/// # Errors
/// [`ZoneError`] where it is not known.
pub fn zone() -> Result<TimeZone, ZoneError> {
    if let Ok(zone) = TimeZone::try_system() {
        return Ok(zone);
    }
    let compiled_in = |text: &str| TimeZoneDatabase::bundled().get(name(text)).ok();
    match variable() {
        Some(given) => {
            let given = given.to_string_lossy().into_owned();
            compiled_in(&given).ok_or_else(|| ZoneError::NotUnderstood { given: shortened(&given, 80) })
        }
        // A link that leads nowhere still has the name.
        None => std::fs::read_link(Path::new("/etc/localtime"))
            .ok()
            .and_then(|link| compiled_in(link.to_str()?))
            .ok_or(ZoneError::Unknown),
    }
}

/// The same, and UTC under the name `Etc/Unknown` where it is not known: whoever asks this has told the [`ZoneError`].
pub fn zone_or_unknown() -> TimeZone {
    zone().unwrap_or_else(|_told| TimeZone::unknown())
}

/// The time now in that zone.
pub fn now() -> Zoned {
    Timestamp::now().to_zoned(zone_or_unknown())
}

/// What a time's zone is called: its name, else the rule that `TZ` gives, else how far it is from UTC.
pub fn zone_name(time: &Zoned) -> String {
    if let Some(name) = time.time_zone().iana_name() {
        return name.to_owned();
    }
    let is_rule = |text: &String| TimeZone::posix(text).is_ok();
    let rule = variable().and_then(|given| given.into_string().ok()).filter(is_rule);
    rule.unwrap_or_else(|| time.strftime("%:z").to_string())
}

fn variable() -> Option<OsString> {
    std::env::var_os("TZ").filter(|given| !given.is_empty())
}

/// The name of a zone in what `TZ` or a link says: `Europe/Amsterdam`, `:Europe/Amsterdam`, `/usr/share/zoneinfo/Europe/Amsterdam`.
fn name(given: &str) -> &str {
    given.rsplit_once("zoneinfo/").map_or_else(|| given.strip_prefix(':').unwrap_or(given), |(_, name)| name)
}
