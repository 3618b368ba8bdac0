//! Serial numbers that are counted up.

/// The next serial number: the last figures in it are one more, and as many as before. One without figures gets a 1.
pub(super) fn next(serial: &str) -> String {
    let serial = serial.trim();
    let Some(end) = serial.rfind(|c: char| c.is_ascii_digit()).map(|at| at + 1) else { return format!("{serial}1") };
    let figures = serial.get(..end).unwrap_or_default();
    let start = figures.rfind(|c: char| !c.is_ascii_digit()).map_or(0, |at| {
        // The sign before the figures may be longer than a byte.
        at + figures.get(at..).and_then(|rest| rest.chars().next()).map_or(1, char::len_utf8)
    });
    let mut counted: Vec<u8> = figures.get(start..).unwrap_or_default().bytes().collect();
    let mut carries = true;
    for figure in counted.iter_mut().rev() {
        if !carries {
            break;
        }
        carries = *figure == b'9';
        *figure = if carries { b'0' } else { *figure + 1 };
    }
    let more = if carries { "1" } else { "" };
    let counted = String::from_utf8_lossy(&counted);
    let before = figures.get(..start).unwrap_or_default();
    format!("{before}{more}{counted}{}", serial.get(end..).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::next;

    #[test]
    fn the_last_figures_count_and_keep_their_width() {
        for (serial, counted) in [
            ("A-0099", "A-0100"),
            ("1", "2"),
            ("", "1"),
            ("999", "1000"),
            ("17-B", "18-B"),
            ("A", "A1"),
            ("2026-α009", "2026-α010"),
            ("00000000000000000000000000099", "00000000000000000000000000100"),
        ] {
            assert_eq!(next(serial), counted, "{serial}");
        }
    }
}
