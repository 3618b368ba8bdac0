//! Any bytes as the file of a report: its data is found, refused with a sentence or not there, and compared; what is data by itself is the
//! same data where a PDF has it attached.

use fitcheck::proof::{attached_json, compare, json_of};

use super::shared::told;

/// So many checks that the journal does not have.
const UNRECORDED: u64 = 3;

pub fn run(bytes: &[u8]) {
    let data = match json_of(bytes) {
        None => return,
        Some(Err(error)) => return told(bytes, &error),
        Some(Ok(data)) => data,
    };
    match compare(&data, &[], UNRECORDED) {
        Ok(differences) => differences.iter().for_each(|difference| told(bytes, difference)),
        Err(error) => told(bytes, &error),
    }
    // A text in it may be the word that ends an attachment, or that begins one.
    let is_plain = [&b"stream"[..], b"/EmbeddedFile", b"obj", b"%PDF-"];
    let has = |word: &&[u8]| data.windows(word.len()).any(|part| part == *word);
    if !is_plain.iter().any(has) {
        let head: &[u8] = b"%PDF-1.7\n1 0 obj\n<</Type/EmbeddedFile>>\nstream\n";
        let file = [head, &data, b"\nendstream\nendobj\n"].concat();
        let found = attached_json(&file).expect("the attachment is found").expect("it is not packed");
        assert_eq!(found.strip_suffix(b"\n"), Some(&data[..]));
    }
}
