//! The parts of a line of an NC program, as the program page tells them apart.

#![cfg(test)]

use fitcheck::session::program::{Token, tokens};

#[track_caller]
fn check(line: &str, begins: bool, expected: &[(&str, Token)]) {
    let parts = tokens(line, begins);
    let found: Vec<_> = parts.iter().map(|(range, token)| (line.get(range.clone()).unwrap(), *token)).collect();
    assert_eq!(found, expected, "{line}");
    assert_eq!(parts.iter().map(|(range, _)| range.len()).sum::<usize>(), line.len());
}

#[test]
fn a_line_is_told_apart() {
    use Token::{Comment, Heading, Keyword, Number, Parameter, Plain, Text};
    check(
        "7 Q1 = 25 ;NOMINAL",
        true,
        &[("7", Number), (" ", Plain), ("Q1", Parameter), (" = 25 ", Plain), (";NOMINAL", Comment)],
    );
    check(
        "3 DECLARE STRING QS1 = \"H;7\"",
        true,
        &[
            ("3", Number),
            (" ", Plain),
            ("DECLARE", Keyword),
            (" ", Plain),
            ("STRING", Keyword),
            (" ", Plain),
            ("QS1", Parameter),
            (" = ", Plain),
            ("\"H;7\"", Text),
        ],
    );
    check(
        "/12 L X+Q11 FQ5",
        true,
        &[
            ("/12", Number),
            (" ", Plain),
            ("L", Keyword),
            (" X+", Plain),
            ("Q11", Parameter),
            (" ", Plain),
            ("F", Keyword),
            ("Q5", Parameter),
        ],
    );
    check("4 * - Kopf ; \"x", true, &[("4", Number), (" * - Kopf ; \"x", Heading)]);
    check(
        "  Q263=+20 ;1. PUNTO ~",
        false,
        &[("  ", Plain), ("Q263", Parameter), ("=+20 ", Plain), (";1. PUNTO ~", Comment)],
    );
    check("3D ROT", true, &[("3D ROT", Plain)]);
    check("", true, &[]);
    check("5", true, &[("5", Number)]);
    check("9 \"é", true, &[("9", Number), (" \"é", Plain)]);
}
