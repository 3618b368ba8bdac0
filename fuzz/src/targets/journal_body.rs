//! Any bytes as an entry of a journal: what is read is written, and reads back as the same with the same verdict.

use fitcheck::journal::body::{read, write};
use fitcheck::journal::entry::Check;

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let entry = match read(bytes) {
        Ok(entry) => entry,
        Err(error) => return told(bytes, &error),
    };
    let written = write(&entry).expect("what was read can be written");
    let again = read(&written).expect("what was written can be read");
    assert_eq!(again, entry);
    assert_eq!(write(&again).as_ref(), Ok(&written));
    if let Some(check) = entry.check() {
        assert_eq!(check.remark().is_some(), again.check().and_then(Check::remark).is_some());
    }
}
