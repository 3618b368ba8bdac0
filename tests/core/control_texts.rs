//! From the bytes of a control's text files to lines: encodings and line ends.

use fitcheck::text::{decode, lines};

#[test]
fn decodes_utf8_and_windows_1252() {
    assert_eq!(decode(b"\xef\xbb\xbfMa\xc3\x9f"), "Maß");
    assert_eq!(decode(b"Gr\xf6\xdfe \xd8 \x80"), "Größe Ø €");
}

#[test]
fn splits_at_every_kind_of_line_end() {
    let all: Vec<_> = lines("a\nb\r\nc\rd\0e\n\nf").collect();
    assert_eq!(all, [(1, "a"), (2, "b"), (3, "c"), (4, "d"), (5, "e"), (6, ""), (7, "f")]);
    assert_eq!(lines("").count(), 0);
    assert_eq!(lines("a\n").count(), 1);
}
