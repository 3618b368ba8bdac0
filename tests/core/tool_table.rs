//! The tool table: what is read and refused, and that only changed cells are written.

use fitcheck::control::tool_table::{Tool, ToolNumber, ToolTable};
use fitcheck::probing::cycle::{CycleResult, Inputs};
use fitcheck::probing::cycles::cycle_named;
use fitcheck::probing::{Contact, Recorded};
use proptest::prelude::*;

/// Row 0 ends before the last column; tool 6 is locked; tool 9 is the probe.
fn sample() -> Vec<u8> {
    std::fs::read(format!("{}/tests/data/samples/tools/tool_small.t", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// The result of a coordinate in the first axis, `off` mm beyond the middle of its limits, with a tool in Q330.
fn coordinate(tool: &str, off: f64) -> CycleResult {
    let cycle = cycle_named("427").unwrap();
    let settings = format!("Q263=20 Q264=10 Q261=-5 Q272=1 Q267=1 Q260=30 Q288=20.1 Q289=19.9 {tool}");
    let set = |inputs, setting: &str| {
        let (name, text) = setting.split_once('=').unwrap();
        cycle.set(inputs, name, text).unwrap()
    };
    let inputs = settings.split_whitespace().fold(Inputs::new(), set);
    cycle.measure(&inputs, &mut Recorded::new(vec![Contact { x: 20.0 + off, y: 10.0, z: -5.0 }])).unwrap()
}

/// Adds to DR of a tool.
fn corrected(table: &mut ToolTable, tool: &str, off: f64) {
    let monitored = table.monitor(cycle_named("427").unwrap(), &coordinate(tool, off)).unwrap().unwrap();
    assert!(monitored.change.is_some());
}

fn tool<'a>(table: &'a ToolTable, number: &str) -> &'a Tool {
    &table.tools()[table.row_of(number.parse().unwrap()).unwrap()]
}

#[track_caller]
fn check(rows: &str, expected: &str) {
    let head = "BEGIN TOOL.T MM\nT     NAME   L     R     DL    DR      TL RT  LBREAK RBREAK TYP\n";
    let said = match ToolTable::read(format!("{head}{rows}[END]\n").as_bytes(), "tool.t") {
        Ok(table) => {
            let length = |length: Option<_>| length.map_or("-".to_owned(), |length| format!("{length}"));
            let row = |tool: &Tool| {
                format!(
                    "{} {:?} L{} R{} DL{} DR{} {} RT{} {} {} TYP{}",
                    tool.number,
                    tool.name,
                    tool.length,
                    tool.radius,
                    tool.delta_length,
                    tool.delta_radius,
                    if tool.is_locked { "locked" } else { "free" },
                    tool.replacement.map_or("-".to_owned(), |number| number.to_string()),
                    length(tool.length_breakage),
                    length(tool.radius_breakage),
                    tool.kind.map_or("-".to_owned(), |kind| kind.to_string()),
                )
            };
            table.tools().iter().map(row).collect::<Vec<_>>().join("; ")
        }
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected);
}

#[test]
fn the_sample_is_read() {
    let table = ToolTable::read(&sample(), "tool_small.t").unwrap();
    assert!(table.warnings().is_empty());
    let numbers: Vec<_> = table.tools().iter().map(|tool| tool.number.to_string()).collect();
    assert_eq!(numbers, ["0", "3", "4", "5", "6", "9"]);
    let broken = tool(&table, "4").radius_breakage.unwrap();
    assert_eq!((broken.to_string(), tool(&table, "4").replacement), ("0.02".to_owned(), "6".parse().ok()));
    assert_eq!(tool(&table, "5").delta_radius.to_string(), "-0.005");
    let locked: Vec<_> = table.tools().iter().filter(|tool| tool.is_locked).map(|tool| tool.name.as_str()).collect();
    assert_eq!(locked, ["MILL_D16_OLD"]);
    let probes: Vec<_> = table.tools().iter().filter(|tool| !tool.is_no_probe()).map(|tool| tool.number).collect();
    assert_eq!(probes, ["9".parse::<ToolNumber>().unwrap()]);
    assert_eq!(table.rows_named("mill_d10"), [1], "names are kept in capitals");
    assert_eq!(table.rows_named("").len(), 0);
}

#[test]
fn rows_are_tools_and_what_cannot_be_is_refused_with_its_place() {
    check(
        "5.1   MILL   +90   6,5   +0    -0.005  L  4   0.2    0.02   21\n0\n",
        "5.1 \"MILL\" L90 R6.5 DL0 DR-0.005 locked RT4 0.2 0.02 TYP21; 0 \"\" L0 R0 DL0 DR0 free RT- - - TYP-",
    );
    check("5            -     -     -     -       -  -   -      0\n", "5 \"\" L0 R0 DL0 DR0 free RT- - - TYP-");
    check("5                                      1\n", "5 \"\" L0 R0 DL0 DR0 locked RT- - - TYP-");
    check("", "the table has no tool: tool.t, line 2, column 1");
    let number = "expected a tool number from 0 to 32767, with an index such as 5.1 or without";
    for given in ["5.12", "32768", "-1", "A", "5.", ""] {
        let said = format!("T = {given}: {number}: tool.t, line 3, column 1");
        check(&format!("{given:<6}MILL   +90   +6    +0    +0      0\n"), &said);
    }
    check("5\n5\n", "tool 5 occurs twice: tool.t, line 4, column 1");
    check("5     MILL   ?     +6\n", "L: ? is not a number: tool.t, line 3, column 14");
    check(
        "5     MILL   +90   999999\n",
        "R = 999999 mm: expected -99999.9999 to 99999.9999 mm: tool.t, line 3, column 20",
    );
    check(
        "5     MILL   +90   +6    +0    +1000\n",
        "DR = 1000 mm: expected -999.9999 to 999.9999 mm: tool.t, line 3, column 32",
    );
    check(
        "5     MILL   +90   +6    +0    +0      0  0   -0.2\n",
        "LBREAK = -0.2 mm: expected 0 to 99999.9999 mm: tool.t, line 3, column 47",
    );
    check(
        "5     MILL   +90   +6    +0    +0      X\n",
        "TL = X: expected L or 1 for a locked tool; 0, - or nothing for a free one: tool.t, line 3, column 40",
    );
    check("5     MILL   +90   +6    +0    +0      0  X\n", &format!("RT = X: {number}: tool.t, line 3, column 43"));
    check(
        "5     MILL   +90   +6    +0    +0      0  0   0      0      END\n",
        "TYP = END: expected a whole number: tool.t, line 3, column 61",
    );
    check(
        "5     MILL_10+90\n",
        "NAME: the cell runs into its neighbour, so its value is uncertain: tool.t, line 3, column 7",
    );
    let long = format!("BEGIN A.T MM\nT  NAME{}L  R  DL DR TL\n1  {}\n[END]\n", " ".repeat(40), "N".repeat(33));
    let error = ToolTable::read(long.as_bytes(), "a.t").unwrap_err().to_string();
    assert!(error.contains("a name has at most 32 characters: a.t, line 3, column 4"), "{error}");
    let error = ToolTable::read(b"BEGIN A.T MM\nT  L  R  DL TL\n1\n[END]\n", "a.t").unwrap_err();
    assert_eq!(error.to_string(), "the table has no column DR: a.t, line 2, column 1");
}

/// A row may end early in a whole table; where the table has no end, it may have been cut off there.
#[test]
fn a_short_row_needs_the_end_of_the_table() {
    let whole = "BEGIN A.T MM\nT  L  R  DL DR TL\n1  5\n";
    assert!(ToolTable::read(format!("{whole}[END]\n").as_bytes(), "a.t").is_ok());
    let error = ToolTable::read(whole.as_bytes(), "a.t").unwrap_err().to_string();
    assert_eq!(
        error,
        "the row ends before column R: fill it with spaces, or write - for no value: a.t, line 3, column 5"
    );
}

#[test]
fn an_unchanged_table_is_written_byte_for_byte() {
    let table = ToolTable::read(&sample(), "tool_small.t").unwrap();
    assert_eq!(table.write().unwrap(), sample());
}

/// A change of a cell; a change back leaves the file as it was.
#[test]
fn only_the_changed_cell_is_other_bytes() {
    let mut table = ToolTable::read(&sample(), "tool_small.t").unwrap();
    corrected(&mut table, "Q330=3", 0.007);
    let written = String::from_utf8(table.write().unwrap()).unwrap();
    assert_eq!(written.len(), sample().len());
    let differ: Vec<_> =
        written.lines().zip(std::str::from_utf8(&sample()).unwrap().lines()).map(|(a, b)| a == b).collect();
    assert_eq!(differ, [true, true, true, true, false, true, true, true, true, true], "{written}");
    let row = written.lines().nth(4).unwrap();
    assert!(
        row.starts_with("3       MILL_D10        +88.12      +5        +0      +0        +0.007    +0      0  0  "),
        "{row}"
    );
    corrected(&mut table, "Q330=3", -0.007);
    assert_eq!(table.write().unwrap(), sample());
}

/// A row that ends before the cell gets blanks up to it; what does not fit into the column is refused.
#[test]
fn a_new_value_has_its_place_or_is_refused() {
    let read = |text: &str| ToolTable::read(text.as_bytes(), "a.t").unwrap();
    let mut table = read("BEGIN A.T MM\nT  L  R  DL TL DR\n1  5\n[END]\n");
    corrected(&mut table, "Q330=1", 0.5);
    assert_eq!(table.write().unwrap(), b"BEGIN A.T MM\nT  L  R  DL TL DR\n1  5           +0.5\n[END]\n");
    // The cell before it ends at the border.
    let mut table = read("BEGIN A.T MM\nT  L  R  TL DL DR     X\n1  5         21\n[END]\n");
    corrected(&mut table, "Q330=1", 0.5);
    assert_eq!(table.write().unwrap(), b"BEGIN A.T MM\nT  L  R  TL DL DR     X\n1  5         21 +0.5\n[END]\n");
    // Flush right, and longer than the room before the text.
    let mut table = read("BEGIN A.T MM\nT  L  R  DL     DR TL\n1  5     +0     +0 0\n[END]\n");
    corrected(&mut table, "Q330=1", -0.25);
    let said = table.write().unwrap_err().to_string();
    assert_eq!(said, "row 0, column DR: -0.25 does not fit into 3 characters");
    let mut table = read("BEGIN A.T MM\nT  L  R  DL DR     TL\n1  5           +0  0\n[END]\n");
    corrected(&mut table, "Q330=1", -0.25);
    assert_eq!(table.write().unwrap(), b"BEGIN A.T MM\nT  L  R  DL DR     TL\n1  5        -0.25  0\n[END]\n");
}

/// 0.007 mm are 0.000275… in: the table keeps the nearest 0.00001 in, and the run goes on with that value.
#[test]
fn a_table_in_inches_keeps_its_unit() {
    let text = b"BEGIN TOOL.T INCH\nT  L    R     DL    DR        TL\n1  +5   +0.25 +0    +0.0010   0\n[END]\n";
    let mut table = ToolTable::read(text, "tool.t").unwrap();
    assert_eq!(tool(&table, "1").delta_radius.to_string(), "0.0254");
    corrected(&mut table, "Q330=1", 0.007);
    // 0.0254 + 0.007 mm = 0.0012756 in.
    assert_eq!(tool(&table, "1").delta_radius.to_string(), "0.032512");
    let expected = "BEGIN TOOL.T INCH\nT  L    R     DL    DR        TL\n1  +5   +0.25 +0    +0.00128  0\n[END]\n";
    assert_eq!(String::from_utf8(table.write().unwrap()).unwrap(), expected);
    let again = ToolTable::read(&table.write().unwrap(), "tool.t").unwrap();
    assert_eq!(again.tools(), table.tools());
}

proptest! {
    /// Any line ends, encodings and widths: unchanged the same bytes, and after a correction all bytes but those of the
    /// cell, with the new value in it.
    #[test]
    fn what_is_not_changed_keeps_its_bytes(
        end in prop::sample::select(vec!["\n", "\r\n", "\r", "\0"]),
        encoding in 0..3_u8,
        widths in prop::collection::vec(6..14_usize, 6),
        deltas in prop::collection::vec(-99..99_i32, 1..6),
        which in any::<prop::sample::Index>(),
        off in (-90..90_i32).prop_filter("nothing to change", |off| *off != 0),
        lead in 0..2_usize,
    ) {
        let pad = |cells: [&str; 6]| {
            cells.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect::<Vec<_>>().concat()
        };
        let names = pad(["T", "NAME", "L", "R", "DL", "TL"]) + "DR       DOC";
        let mut lines = vec!["BEGIN TOOL.T MM".to_owned(), "; \u{fc}ber".to_owned(), names];
        for (number, delta) in (1..).zip(&deltas) {
            let delta = format!("{}{:+.3}", " ".repeat(lead), f64::from(*delta) / 1000.0);
            let row = pad([&format!("{number}"), "M\u{fc}", "+1", "", "+0", "0"]);
            lines.push(format!("{row}{delta:<9}\u{fc}ber  "));
        }
        lines.push("[END]".to_owned());
        let text = lines.join(end) + end;
        let bytes = match encoding {
            0 => text.into_bytes(),
            1 => [b"\xef\xbb\xbf", text.as_bytes()].concat(),
            // Windows-1252 has these characters where Unicode has them.
            _ => text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect(),
        };
        let mut table = ToolTable::read(&bytes, "tool.t").unwrap();
        prop_assert_eq!(&table.write().unwrap(), &bytes);
        let row = which.index(deltas.len());
        let before = table.tools()[row].delta_radius.nanometres();
        corrected(&mut table, &format!("Q330={}", row + 1), f64::from(off) / 1000.0);
        let written = table.write().unwrap();
        let again = ToolTable::read(&written, "tool.t").unwrap();
        prop_assert_eq!(again.tools(), table.tools());
        prop_assert_eq!(again.tools()[row].delta_radius.nanometres() - before, i64::from(off) * 1_000);
        prop_assert_eq!(written.len(), bytes.len());
        let differ: Vec<usize> = (0..bytes.len()).filter(|at| bytes[*at] != written[*at]).collect();
        prop_assert!(differ.iter().all(|at| at - differ[0] < 9), "{:?}", differ);
    }
}
