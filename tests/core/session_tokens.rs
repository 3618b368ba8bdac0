//! The parts of a line of an NC program, as the program page tells them apart.

#![cfg(test)]

use fitcheck::nc::program::Notation;
use fitcheck::session::program::{Token, tokens, tokens_of};

#[track_caller]
fn check(line: &str, begins: bool, expected: &[(&str, Token)]) {
    let parts = tokens(line, begins);
    let found: Vec<_> = parts.iter().map(|(range, token)| (line.get(range.clone()).unwrap(), *token)).collect();
    assert_eq!(found, expected, "{line}");
    assert_eq!(parts.iter().map(|(range, _)| range.len()).sum::<usize>(), line.len());
}

#[test]
fn a_line_of_a_lathe_program_is_told_apart() {
    use Token::{Comment, Keyword, Number, Parameter, Plain, Text};
    for (line, expected) in [
        (
            "N5 #l1=40 [nominal; \"size\"]",
            vec![("N5", Number), (" ", Plain), ("#l1", Parameter), ("=40 ", Plain), ("[nominal; \"size\"]", Comment)],
        ),
        ("BEARBEITUNG", vec![("BEARBEITUNG", Keyword)]),
        (
            "N24 PRINT(\"re]work\",#l4)",
            vec![
                ("N24", Number),
                (" ", Plain),
                ("PRINT", Keyword),
                ("(", Plain),
                ("\"re]work\"", Text),
                (",", Plain),
                ("#l4", Parameter),
                (")", Plain),
            ],
        ),
        ("  G785 R0 [open", vec![("  ", Plain), ("G785", Keyword), (" R0 ", Plain), ("[open", Comment)]),
        ("NAME", vec![("NAME", Plain)]),
        ("#EINHEIT METRISCH", vec![("#EINHEIT METRISCH", Plain)]),
        ("", vec![]),
    ] {
        let parts = tokens_of(Notation::DinPlus, line, true);
        let found: Vec<_> = parts.iter().map(|(range, token)| (line.get(range.clone()).unwrap(), *token)).collect();
        assert_eq!(found, expected, "{line}");
    }
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
