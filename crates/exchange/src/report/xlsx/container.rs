//! The container of a workbook: a ZIP file, which says on which system it was made. It says the same everywhere.

/// The bytes that begin each entry of the list of files.
const ENTRY: &[u8] = b"PK\x01\x02";
/// The bytes that begin the end of that list.
const END: &[u8] = b"PK\x05\x06";
/// How long the end is where it has no comment.
const END_LENGTH: usize = 22;
/// Where an entry has the system, and which one is said to have made it: Unix.
const SYSTEM: (usize, u8) = (5, 3);
/// Where an entry has the lengths of name, extra fields and comment, and how long it is without them.
const LENGTHS: ([usize; 3], usize) = ([28, 30, 32], 46);

/// The same file, made on Unix: the names and bytes of the files within stay. What is no such file stays as it is.
pub(super) fn made_on_unix(mut zip: Vec<u8>) -> Vec<u8> {
    let end = zip.len().saturating_sub(END_LENGTH);
    let is_end = zip.get(end..).is_some_and(|end| end.starts_with(END));
    let mut at = number::<4>(&zip, end + 16).filter(|_| is_end);
    while let Some(entry) = at.filter(|&at| zip.get(at..).is_some_and(|entry| entry.starts_with(ENTRY))) {
        if let Some(system) = zip.get_mut(entry + SYSTEM.0) {
            *system = SYSTEM.1;
        }
        let (places, least) = LENGTHS;
        let more = places.into_iter().map(|place| number::<2>(&zip, entry + place)).sum::<Option<usize>>();
        at = more.map(|more| entry + least + more);
    }
    zip
}

/// A whole number of so many bytes, the lowest first.
fn number<const BYTES: usize>(zip: &[u8], at: usize) -> Option<usize> {
    let bytes = zip.get(at..at + BYTES)?;
    Some(bytes.iter().rev().fold(0, |sum, byte| sum << 8 | usize::from(*byte)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_entry_of_a_workbook_says_the_same_system_and_nothing_else_changes() {
        let mut workbook = rust_xlsxwriter::Workbook::new();
        workbook.add_worksheet();
        let here = workbook.save_to_buffer().unwrap();
        let starts: Vec<usize> = (0..here.len()).filter(|&at| here[at..].starts_with(ENTRY)).collect();
        assert!(5 < starts.len());
        let mut elsewhere = here.clone();
        for start in &starts {
            elsewhere[start + SYSTEM.0] = 0;
        }
        let made = made_on_unix(elsewhere);
        assert!(starts.iter().all(|start| made[start + SYSTEM.0] == 3));
        assert_eq!(made, made_on_unix(here));
        assert_eq!(made_on_unix(b"PK".to_vec()), b"PK");
    }
}
