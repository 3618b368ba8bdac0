//! This computer: its name, its user, and the time with its zone. What a station is called where nobody has named it.

use std::path::Path;

use fitcheck_exchange::journal::entry::Moment;
use fitcheck_files as files;

/// The time now, as an entry keeps it.
pub fn moment() -> Moment {
    let now = files::now();
    let zone = files::zone_name(&now);
    Moment { utc_ms: now.timestamp().as_millisecond(), offset_min: now.offset().seconds() / 60, zone }
}

/// The user of the computer, where the system tells it; else empty.
pub fn user() -> String {
    let of_variable = ["USER", "USERNAME", "LOGNAME"].into_iter().find_map(|name| std::env::var(name).ok());
    of_variable.map_or_else(String::new, |name| plain(&name))
}

/// A name as an entry takes it.
fn plain(name: &str) -> String {
    name.trim().chars().filter(|c| !c.is_control()).take(200).collect()
}

/// The name of the computer, where the system tells it.
pub fn computer() -> String {
    let of_variable = ["COMPUTERNAME", "HOSTNAME"].into_iter().find_map(|name| std::env::var(name).ok());
    let of_file = || {
        let mut paths = ["/proc/sys/kernel/hostname", "/etc/hostname"].into_iter();
        let read = |path| Some(String::from_utf8_lossy(&files::read_file(Path::new(path)).ok()?).into_owned());
        paths.find_map(read)
    };
    let name = of_variable.or_else(of_file).map(|name| plain(&name));
    name.filter(|name| !name.is_empty()).unwrap_or_else(|| "fitcheck".to_owned())
}
