//! A verdict for every row: the answers of `import` and of the library, whatever the blocks and however many workers.

use std::fmt::Write as _;
use std::io::{BufRead as _, Read, Write as _};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

use fitcheck::batch::{Failed, Input, Manner, Packing, Rendering, Summary, Watch, run};
use fitcheck::control::deviations::read_table;
use fitcheck::exchange::batch::{Csv, Cutter, JsonLines, Layout, RowNoteKind, StreamJudging, Tsv};
use fitcheck::exchange::{Item, import_each};
use fitcheck::length::{Length, Unit};
use fitcheck::tolerance::{Callout, Feature, Sources, iso286};
use fitcheck::verdict::judge_size;
use proptest::prelude::*;

/// Gives a few bytes at a time, and then fails if it should.
struct Pieces<'a> {
    rest: &'a [u8],
    piece: usize,
    fails: bool,
}

impl Read for Pieces<'_> {
    fn read(&mut self, to: &mut [u8]) -> std::io::Result<usize> {
        if self.rest.is_empty() && self.fails {
            return Err(std::io::Error::other("the line went dead"));
        }
        let count = self.piece.min(to.len()).min(self.rest.len());
        to[..count].copy_from_slice(&self.rest[..count]);
        self.rest = &self.rest[count..];
        Ok(count)
    }
}

/// How a text is cut: bytes of a block, bytes that come at a time, whether a block waits until it is full, and workers.
#[derive(Debug, Clone, Copy)]
struct Cut {
    step: usize,
    piece: usize,
    is_patient: bool,
    workers: usize,
}

const WHOLE: Cut = Cut { step: 1 << 20, piece: 1 << 20, is_patient: true, workers: 1 };

fn judged<R: Rendering>(text: &[u8], cut: Cut, sources: &Sources, out: &mut Vec<u8>) -> Result<Summary, Failed> {
    let layout = Layout::of(text, true, "test.csv").unwrap();
    let court = StreamJudging::new(&layout, sources);
    let cutter = Cutter::new(layout.separator(), cut.step, cut.is_patient);
    let mut input = Pieces { rest: &text[layout.skip..], piece: cut.piece, fails: false };
    let manner = Manner { workers: cut.workers, packing: Packing::Plain, prefix: "" };
    let summary = run::<R>(Input { stream: &mut input, cutter }, &court, manner, out, &Watch::default(), &mut |_| {});
    summary.map(|mut summary| {
        summary.tally.lines += layout.line;
        summary
    })
}

/// The text with its answers.
fn answers(text: &str) -> String {
    let mut out = Csv::header(&Layout::of(text.as_bytes(), true, "test.csv").unwrap(), "");
    judged::<Csv>(text.as_bytes(), WHOLE, &Sources::default(), &mut out).unwrap();
    String::from_utf8(out).unwrap()
}

#[test]
fn every_row_keeps_its_place_and_gets_its_answer() {
    let text = "id,nominal,class,measured\n1,25,H7,25.01\n2,25,H7,24.998\n3,25,h6,25.0005\n4,25,h6,24.9\n5,25,H7,\n";
    let expected = "id,nominal,class,measured,min_mm,max_mm,deviation_um,status,remove_um,error\n\
        1,25,H7,25.01,25.000,25.021,10,GOOD,,\n\
        2,25,H7,24.998,25.000,25.021,-2,REWORK,2,\n\
        3,25,h6,25.0005,24.987,25.000,0.5,REWORK,0.5,\n\
        4,25,h6,24.9,24.987,25.000,-100,SCRAP,,\n\
        5,25,H7,,,,,,,measured: a length is missing\n";
    assert_eq!(answers(text), expected);
}

#[test]
fn columns_separators_decimal_signs_and_units_are_those_that_import_knows() {
    let text = "Teil;Passung;Istma\u{df} (\u{b5}m);Bemerkung\r\n\"a;b\";25 H7;25012,5;=1+1\r\n";
    let expected = "Teil;Passung;Istma\u{df} (\u{b5}m);Bemerkung;min_mm;max_mm;deviation_um;status;remove_um;error\r\n\
        \"a;b\";25 H7;25012,5;=1+1;25.000;25.021;12.5;GOOD;;\r\n";
    assert_eq!(answers(text), expected);
    let text = "part|callout|actual [inch]\n1|25.4 H7|1.0005\n2|25.4 \u{b1}0.1|1.01\n";
    let expected = "part|callout|actual [inch]|min_mm|max_mm|deviation_um|status|remove_um|error\n\
        1|25.4 H7|1.0005|25.400|25.421|12.7|GOOD||\n\
        2|25.4 \u{b1}0.1|1.01||||||25.4 \u{b1}0.1: the callout does not say hole or shaft: add letters, such as H7 or h6\n";
    let said = answers(text);
    // What a callout without letters says is told where callouts are tested.
    let kept = said.lines().zip(expected.lines()).take(2).all(|(said, expected)| said == expected);
    assert!(kept && said.lines().count() == 3, "{said}");
}

#[test]
fn what_is_no_row_stays_where_it_is() {
    let text = "\u{feff}sep=;\r\nid;callout;measured\r\n# morning\r\n\r\n1;25 H7;25.01\r\n;;\r\n2;25 H7";
    let expected = "\u{feff}sep=;\r\nid;callout;measured;min_mm;max_mm;deviation_um;status;remove_um;error\r\n\
        # morning\r\n\r\n1;25 H7;25.01;25.000;25.021;10;GOOD;;\r\n;;;;;;;;\r\n\
        2;25 H7;;;;;;;expected 3 cells, found 2\r\n";
    assert_eq!(answers(text), expected);
}

#[test]
fn cells_beyond_the_columns_move_no_answer() {
    let text = "id,callout,measured\n1,25 H7,25.01,\n2,25 H7,25.01,x,y\n";
    let said = answers(text);
    let rows: Vec<&str> = said.lines().skip(1).collect();
    assert_eq!(rows[0], "1,25 H7,25.01,25.000,25.021,10,GOOD,,");
    assert!(
        rows[1].starts_with("2,25 H7,25.01,,,,,,\"expected 3 cells, found 5") && rows[1].ends_with(": x,y\""),
        "{said}"
    );
}

#[test]
fn a_quoted_cell_may_run_over_lines_and_a_stray_mark_costs_its_own_line() {
    let text = "id,callout,measured\n\"a\nb\",25 H7,25.01\n\"c,25 H7,25.01\nd,25 H7,24.9\n\"e\",25 H7,25.01\n";
    let expected = "id,callout,measured,min_mm,max_mm,deviation_um,status,remove_um,error\n\
        \"a\nb\",25 H7,25.01,25.000,25.021,10,GOOD,,\n\
        \"\"\"c,25 H7,25.01\",,,,,,,,a quotation mark is not closed on this line\n\
        d,25 H7,24.9,25.000,25.021,-100,REWORK,100,\n\
        \"e\",25 H7,25.01,25.000,25.021,10,GOOD,,\n";
    assert_eq!(answers(text), expected);
    let mut out = Vec::new();
    let summary = judged::<Csv>(text.as_bytes(), WHOLE, &Sources::default(), &mut out).unwrap();
    let notes = |kind| summary.tally.notes(kind).first.iter().map(|note| note.line + 2).collect::<Vec<_>>();
    assert_eq!(notes(RowNoteKind::Refused), [4]);
    assert_eq!(notes(RowNoteKind::SeveralLines), [2]);
    assert_eq!(summary.tally.lines, 7);
}

#[test]
fn a_line_of_megabytes_is_told_and_costs_itself_only() {
    for (long, reason) in [
        (format!("x,25 H7,25.01{}", " ".repeat(3 << 20)), "longer than"),
        (format!("\"{}\",25 H7,25.01", "x".repeat(3 << 20)), "longer than"),
        (format!("\"x,25 H7,25.01\n{}", "y,25 H7,25.01\n".repeat(200_000)), "not closed"),
    ] {
        let text = format!("id,callout,measured\n1,25 H7,25.01\n{long}\n2,25 H7,24.9\n");
        for step in [1 << 10, 256 << 10, 16 << 20] {
            let mut out = Vec::new();
            let cut = Cut { step, piece: step, ..WHOLE };
            let summary = judged::<Csv>(text.as_bytes(), cut, &Sources::default(), &mut out).unwrap();
            let refused = summary.tally.notes(RowNoteKind::Refused);
            assert_eq!(refused.count, 1);
            assert!(
                refused.first[0].line == 1 && refused.first[0].what.to_string().contains(reason),
                "{:?}",
                refused.first
            );
            assert_eq!(usize::try_from(summary.tally.rows).unwrap(), long.lines().count() + 2, "no row is swallowed");
            let out = String::from_utf8(out).unwrap();
            assert!(out.ends_with("2,25 H7,24.9,25.000,25.021,-100,REWORK,100,\n"));
        }
    }
}

#[test]
fn a_stream_that_breaks_off_gives_its_whole_rows_and_then_the_reason() {
    let text = b"id,callout,measured\n1,25 H7,25.01\n2,25 H7,25.0";
    let layout = Layout::of(text, true, "test.csv").unwrap();
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    for step in [1, 7, 1000] {
        let mut input = Pieces { rest: &text[layout.skip..], piece: step, fails: true };
        let mut out = Vec::new();
        let cutter = Cutter::new(b',', step, true);
        let manner = Manner { workers: 2, packing: Packing::Plain, prefix: "" };
        let failed =
            run::<Csv>(Input { stream: &mut input, cutter }, &court, manner, &mut out, &Watch::default(), &mut |_| {});
        assert!(matches!(failed, Err(Failed::Reading(error)) if error.to_string() == "the line went dead"));
        assert_eq!(out, b"1,25 H7,25.01,25.000,25.021,10,GOOD,,\n");
    }
}

#[test]
fn a_row_is_answered_before_the_next_one_comes() {
    let mut program = Command::new(env!("CARGO_BIN_EXE_fitcheck"))
        .args(["batch", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let (mut input, output) = (program.stdin.take().unwrap(), program.stdout.take().unwrap());
    let (answered, answers) = std::sync::mpsc::channel();
    let read = move || {
        for line in std::io::BufReader::new(output).lines() {
            answered.send(line.unwrap()).unwrap();
        }
    };
    let reader = std::thread::Builder::new().name("reader".to_owned()).spawn(read).unwrap();
    let next = || answers.recv_timeout(std::time::Duration::from_mins(1)).unwrap();
    input.write_all(b"callout,measured\n25 H7,25.01\n").unwrap();
    assert_eq!(next(), "callout,measured,min_mm,max_mm,deviation_um,status,remove_um,error");
    assert_eq!(next(), "25 H7,25.01,25.000,25.021,10,GOOD,,");
    for _ in 0..3 {
        // The first half of a row has no answer yet.
        input.write_all(b"25 H7,").unwrap();
        input.write_all(b"24.9\n").unwrap();
        assert_eq!(next(), "25 H7,24.9,25.000,25.021,-100,REWORK,100,");
    }
    drop(input);
    assert_eq!(program.wait().unwrap().code(), Some(10));
    reader.join().unwrap();
}

#[test]
fn rows_that_are_not_utf_8_are_read_as_windows_1252() {
    let text = b"id,callout,measured\n\xd8 1,25 H7,25.01\n\xc3\x98 2,25 H7,25.01\n";
    let mut out = Vec::new();
    let summary = judged::<Csv>(text, WHOLE, &Sources::default(), &mut out).unwrap();
    assert_eq!(summary.tally.not_utf8, 1);
    let said = String::from_utf8(out).unwrap();
    assert!(
        said.starts_with("\u{d8} 1,25 H7,25.01,25.000") && said.contains("\n\u{d8} 2,25 H7,25.01,25.000"),
        "{said}"
    );
}

#[test]
fn json_lines_have_the_columns_as_texts_and_the_answers_as_numbers() {
    let text = b"id,callout,measured\n\"a \"\"b\"\"\",25 H7,24.998\n# note\n2,25 H7\n";
    let mut out = Vec::new();
    judged::<JsonLines>(text, WHOLE, &Sources::default(), &mut out).unwrap();
    let lines: Vec<serde_json::Value> =
        String::from_utf8(out).unwrap().lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(
        lines,
        [
            serde_json::json!({"id": "a \"b\"", "callout": "25 H7", "measured": "24.998", "min_mm": 25, "max_mm": 25.021,
                "deviation_um": -2, "status": "REWORK", "remove_um": 2, "error": null}),
            serde_json::json!({"id": "2", "callout": "25 H7", "measured": null, "min_mm": null, "max_mm": null,
                "deviation_um": null, "status": null, "remove_um": null, "error": "expected 3 cells, found 2"}),
        ]
    );
}

/// The text with its answers as TSV.
fn tab_separated(text: &str, cut: Cut) -> String {
    let mut out = Tsv::header(&Layout::of(text.as_bytes(), true, "test.csv").unwrap(), "");
    judged::<Tsv>(text.as_bytes(), cut, &Sources::default(), &mut out).unwrap();
    String::from_utf8(out).unwrap()
}

#[test]
fn tsv_names_its_columns_and_has_cells_without_quotation_marks_tabs_and_line_breaks() {
    let text = "\u{feff}# morning\r\nid;callout;measured;\"by\nwhom\"\r\n1;25 H7;25,012;=A1\r\n\"a\tb\r\nc\nd\";25 H7;24,998;\"x; \"\"y\"\"\"\r\n\
        # noon\r\n\r\n3;25 H7\r\n4;25 H7;25,01;\tann;bob\r\n;;;\r\n\"5\t;25 H7;25,01;ann\r\n6;25 h6;24,9;5\" pipe";
    let expected = [
        "id\tcallout\tmeasured\tby whom\tmin_mm\tmax_mm\tdeviation_um\tstatus\tremove_um\terror",
        "1\t25 H7\t25,012\t=A1\t25.000\t25.021\t12\tGOOD\t\t",
        "a b c d\t25 H7\t24,998\tx; \"y\"\t25.000\t25.021\t-2\tREWORK\t2\t",
        "3\t25 H7\t\t\t\t\t\t\t\texpected 4 cells, found 2",
        "4\t25 H7\t25,01\t ann\t\t\t\t\t\texpected 4 cells, found 5: is the separator also used as decimal sign or within a text?: bob",
        "\t\t\t\t\t\t\t\t\t",
        "\"5 ;25 H7;25,01;ann\t\t\t\t\t\t\t\t\ta quotation mark is not closed on this line",
        "6\t25 h6\t24,9\t5\" pipe\t24.987\t25.000\t-100\tSCRAP\t\t",
    ];
    assert_eq!(tab_separated(text, WHOLE).split_terminator('\n').collect::<Vec<_>>(), expected);
}

#[test]
fn tsv_names_columns_by_their_numbers_where_the_input_has_no_names() {
    let said = tab_separated("25 H7|25.01\n25 H7|24.9\n", WHOLE);
    let expected = "column_1\tcolumn_2\tmin_mm\tmax_mm\tdeviation_um\tstatus\tremove_um\terror\n\
        25 H7\t25.01\t25.000\t25.021\t10\tGOOD\t\t\n25 H7\t24.9\t25.000\t25.021\t-100\tREWORK\t100\t\n";
    assert_eq!(said, expected);
}

/// Every class of the standard in every step of it: just above its beginning, within and on its end; measured on both
/// limits, a nanometre beside them and between them; and the sizes beyond the last step.
#[test]
fn every_class_step_and_border_has_the_answer_of_the_library() {
    let sources = Sources::default();
    let ends: Vec<i64> = iso286::step_ends().map(Length::nanometres).collect();
    let mut text = "nominal,class,measured\n".to_owned();
    let mut expected = String::new();
    let mut rows = 0;
    let mut over = 0;
    let length = |nm: i64| Length::from_nanometres(nm).unwrap();
    let mm = |length: Length| length.exact(Unit::Millimetre, 3);
    for to in ends.iter().copied().chain([4_000_000_000]) {
        for nominal in [over + 1, over + (to - over) / 2, to - 1, to] {
            for feature in [Feature::Hole, Feature::Shaft] {
                for class in iso286::classes(feature, iso286::Options::default()) {
                    let callout = Callout::new(length(nominal), class).unwrap();
                    let limits = sources.limits(&callout, None);
                    let measured = limits.as_ref().map_or(vec![nominal], |limits| {
                        let (low, high) = (limits.minimum().nanometres(), limits.maximum().nanometres());
                        vec![low - 1, low, low.midpoint(high), high, high + 1]
                    });
                    for measured in measured {
                        let (nominal, measured) = (length(nominal), length(measured));
                        let given = format!("{nominal},{class},{measured}");
                        text.push_str(&given);
                        text.push('\n');
                        rows += 1;
                        let answer = match &limits {
                            Ok(limits) if Length::ZERO < measured => {
                                let verdict = judge_size(limits, measured);
                                let remove = verdict.removal.map(|removal| removal.to_limit.exact(Unit::Micrometre, 0));
                                format!(
                                    "{},{},{},{},{},",
                                    mm(limits.minimum()),
                                    mm(limits.maximum()),
                                    verdict.deviation.exact(Unit::Micrometre, 0),
                                    verdict.status.word(),
                                    remove.unwrap_or_default()
                                )
                            }
                            Ok(_) => format!(",,,,,measured: a diameter of {measured} is not above 0"),
                            Err(error) => format!(",,,,,{}", quoted(&error.to_string())),
                        };
                        writeln!(expected, "{given},{answer}").unwrap();
                    }
                }
            }
        }
        over = to;
    }
    let mut out = Vec::new();
    judged::<Csv>(text.as_bytes(), Cut { step: 256 << 10, workers: 2, ..WHOLE }, &sources, &mut out).unwrap();
    let out = String::from_utf8(out).unwrap();
    for (said, expected) in out.lines().zip(expected.lines()) {
        assert_eq!(said, expected);
    }
    assert_eq!(out.lines().count(), rows);
    assert!(600_000 < rows, "only {rows} rows");
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

/// Within every step of some sources, no class has another answer.
#[test]
fn no_class_changes_within_a_step() {
    let sources = Sources::default();
    let mut over = 0;
    for to in sources.step_ends() {
        for nominal in [over + 1, over + (to.nanometres() - over) / 3] {
            let nominal = Length::from_nanometres(nominal).unwrap();
            for class in
                [Feature::Hole, Feature::Shaft].into_iter().flat_map(|f| iso286::classes(f, iso286::Options::default()))
            {
                let deviations =
                    |nominal| sources.limits(&Callout::new(nominal, class).unwrap(), None).ok().map(|l| l.deviations);
                assert_eq!(deviations(nominal), deviations(to), "{class} at {nominal} and {to}");
            }
        }
        over = to.nanometres();
    }
}

/// Rows that people and machines write, right and wrong.
fn row(separator: char) -> impl Strategy<Value = String> {
    let number = prop_oneof![
        "[0-9]{1,3}",
        "[0-9]{1,3}\\.[0-9]{1,7}",
        "[0-9]{1,2},[0-9]{1,3}",
        "-[0-9]\\.[0-9]",
        " ?25\\.0[0-9]{1,3} ?",
        Just("25.012".to_owned()),
        Just("25,012".to_owned()),
        Just("24.9995 mm".to_owned()),
        Just("25012 um".to_owned()),
        Just(String::new()),
        "[a-z]{1,3}",
        Just("635".to_owned()),
        Just("\"25.01\"".to_owned()),
        Just("0".to_owned()),
    ];
    let class = prop_oneof![
        Just("H7"),
        Just("h6"),
        Just("25 H7"),
        Just("25H7"),
        Just("25.0  H7"),
        Just("js9"),
        Just("zz9"),
        Just("H07"),
        Just("h 6"),
        Just("25 H7/g6"),
        Just("25 \u{b1}0.1"),
        Just("25 m"),
        Just(""),
        Just("\"H7\""),
        Just("\"25 H7\""),
        Just("A1"),
        Just("26 H7"),
        Just("H7 "),
        Just("5 H7"),
        Just("\u{d8}25 H7"),
        Just("4000 H7"),
        Just("ZC18"),
        Just("25,5 H7"),
        Just("M6"),
        own_class(),
    ];
    let id = prop_oneof![
        "[A-Z][0-9]{1,4}",
        "[0-9]{1,2}",
        Just("#1".to_owned()),
        Just(" # x".to_owned()),
        Just("\"#x\"".to_owned()),
        Just(String::new()),
        Just("\"a \"\"b\"\"\"".to_owned()),
        Just("5\" pipe".to_owned()),
        Just("\u{d8}12".to_owned()),
        Just("\"x\"y".to_owned()),
        Just("\" \"".to_owned()),
    ];
    let nominal = prop_oneof![
        Just("25".to_owned()),
        Just("25.0".to_owned()),
        Just(String::new()),
        Just("25,5".to_owned()),
        number.clone()
    ];
    let simulated = prop_oneof![9 => Just(""), 1 => Just("false"), 1 => Just("true"), 1 => Just("perhaps")];
    let extra = prop_oneof![9 => Just(""), 1 => Just(";"), 1 => Just(";x")];
    (id, nominal, class, number, simulated, extra).prop_map(move |(id, nominal, class, number, simulated, extra)| {
        let s = separator;
        let extra = extra.replace(';', &separator.to_string());
        format!("{id}{s}{nominal}{s}{class}{s}{number}{s}{simulated}{extra}")
    })
}

/// Names of own columns, and names that are none.
fn own_class() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        "PF",
        "pf",
        "PX",
        "Pf",
        "mm",
        "M",
        "H",
        "U1Z1",
        "25 PF",
        "25PF",
        "25 pf",
        "25 PX",
        "25 U1Z1",
        "25mmpf",
        "25 mm PF",
        "25 in",
        "25 h",
        "31 PF",
        "25 PF/pf",
        "\"25 PF\"",
        "PF ",
    ])
}

/// Limits in a shop with two own tables.
static OWN_SOURCES: LazyLock<Sources> = LazyLock::new(|| {
    let own = [
        "NR BEREICH PF    U1Z1\n0  30      +40   +2.5\n1          +10   -2.5\n",
        "NR BEREICH pf\n0  30      -10\n1          -40\n",
    ];
    let read = |rows: &str| {
        let table = format!("BEGIN own.tab\n{rows}[END]\n");
        read_table(table.as_bytes(), "own.tab", "own.tab", false).unwrap().0
    };
    Sources::default().with_own(own.into_iter().filter_map(read))
});

/// What `import` says of every row: its line, status and limits, or its reason.
fn imported(text: &[u8]) -> Vec<(usize, String)> {
    let mut all = Vec::new();
    let now = jiff::civil::date(2026, 1, 1).at(0, 0, 0, 0);
    import_each("test.csv", text, &OWN_SOURCES, now, &mut |item| match item {
        Item::Record { line, record, .. } => {
            let (limits, size) = (&record.limits, record.verdict.size);
            let remove = size.removal.map_or(String::new(), |removal| removal.to_limit.exact(Unit::Micrometre, 0));
            let um = size.deviation.exact(Unit::Micrometre, 0);
            let (low, high) =
                (limits.minimum().exact(Unit::Millimetre, 3), limits.maximum().exact(Unit::Millimetre, 3));
            all.push((line, format!("{low}|{high}|{um}|{}|{remove}|", size.status.word())));
        }
        Item::Unjudged(unjudged) => all.push((unjudged.line, format!("|||||{}", unjudged.why))),
        Item::Error(error) => all.push((error.place.line.unwrap(), format!("|||||{}", error.what.kind))),
        Item::Warning(_) | Item::Contacts(_) => {}
    });
    all
}

/// A class without a size has no verdict, also where it is the first one of a block.
#[test]
fn a_class_without_a_verdict_counts_in_no_block() {
    let text = format!("id,callout,measured\n1,25 H7,25.01\n{}", "7,5a,7.\n2,25 H7,25.01\n".repeat(20));
    let judged = |cut: Cut| judged::<Csv>(text.as_bytes(), cut, &Sources::default(), &mut Vec::new()).unwrap();
    let whole = judged(WHOLE);
    for (step, workers) in (1..60).flat_map(|step| (1..4).map(move |workers| (step, workers))) {
        let cut = judged(Cut { step, piece: 10, is_patient: false, workers });
        assert_eq!(cut, whole, "{step}, {workers}");
    }
    assert_eq!(whole.by_class.len(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    /// Every answer is that of `import`, which reads each row by itself.
    #[test]
    fn answers_are_those_of_import(
        separator in prop_oneof![Just(';'), Just(','), Just('\t')],
        has_header in any::<bool>(),
        rows in prop::collection::vec(row(';'), 1..30),
    ) {
        let s = separator.to_string();
        let mut text = String::new();
        if has_header {
            text.push_str(&["id", "nominal", "class", "measured", "simulated"].join(&s));
            text.push('\n');
        }
        for row in &rows {
            text.push_str(&row.replace(';', &s));
            text.push('\n');
        }
        let Ok(layout) = Layout::of(text.as_bytes(), true, "test.csv") else { return Ok(()) };
        let count = layout.names.len();
        let mut out = Vec::new();
        let s = char::from(layout.separator());
        judged::<Csv>(text.as_bytes(), WHOLE, &OWN_SOURCES, &mut out).unwrap();
        let said = String::from_utf8(out).unwrap();
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false).flexible(true).delimiter(layout.separator()).from_reader(said.as_bytes());
        let mut answers = Vec::new();
        for record in reader.records() {
            let record = record.unwrap();
            let added: Vec<&str> = record.iter().skip(count).collect();
            if added.len() == 6 && added.iter().any(|cell| !cell.is_empty()) {
                let byte = usize::try_from(record.position().unwrap().byte()).unwrap();
                let before = said.get(..byte).unwrap().trim_end_matches('\n').lines().count();
                let line = layout.line + before;
                answers.push((line, added.join("|")));
            }
        }
        let mut expected = imported(text.as_bytes());
        // That a file has no row is said once for all of it.
        expected.retain(|(_, answer)| !answer.ends_with("no row holds a measurement"));
        let above: Vec<_> = layout.warnings.iter().map(|(line, warning)| (*line, format!("|||||{warning}"))).collect();
        expected.retain(|one| !above.contains(one));
        // The cells beyond the columns are told with the reason.
        for (answer, expected) in answers.iter_mut().zip(&mut expected) {
            if expected.1.starts_with("|||||") && answer.1.starts_with(&format!("{}: ", expected.1)) {
                answer.1.truncate(expected.1.len());
            }
        }
        prop_assert_eq!(answers, expected, "{:?} with {:?}", text, s);
    }

    /// However a text is cut, the answers are the same, to the byte and to the line of every remark.
    #[test]
    fn answers_do_not_depend_on_the_blocks(
        rows in prop::collection::vec("[a#\",; 5H7.\r\n]{0,12}", 0..60),
        mark in any::<bool>(),
        step in 1..100_usize,
        piece in 1..100_usize,
        is_patient in any::<bool>(),
        workers in 1..4_usize,
    ) {
        let header = if mark { "\u{feff}id,callout,measured\r\n" } else { "id,callout,measured\n" };
        let text = format!("{header}1,25 H7,25.01\n{}", rows.join("\n\"x\",25 H7,25.01"));
        let text = text.as_bytes();
        // A row that seems to say inch refuses the whole file.
        if Layout::of(text, true, "test.csv").is_err() {
            return Ok(());
        }
        let (mut once, mut cut_out) = (Vec::new(), Vec::new());
        let whole = judged::<Csv>(text, WHOLE, &Sources::default(), &mut once).unwrap();
        let cut = Cut { step, piece, is_patient, workers };
        let cut = judged::<Csv>(text, cut, &Sources::default(), &mut cut_out).unwrap();
        prop_assert_eq!(String::from_utf8(once).unwrap(), String::from_utf8(cut_out).unwrap());
        prop_assert_eq!(whole, cut);
    }

    /// However a text is cut and whoever works, TSV has the same rows in their order, each with a cell for every column.
    #[test]
    fn tsv_has_as_many_cells_in_every_row_however_many_workers_there_are(
        rows in prop::collection::vec(row(';'), 1..30),
        wild in prop::collection::vec("[a#\",;\t 5H7.\r\n]{0,12}", 1..30),
        step in 1..100_usize,
        workers in 1..5_usize,
    ) {
        let mut text = "id;nominal;class;measured;simulated\n".to_owned();
        for (row, wild) in rows.iter().zip(wild.iter().cycle()) {
            writeln!(text, "{row}\n{wild}").unwrap();
        }
        // A row that seems to say inch refuses the whole file.
        if Layout::of(text.as_bytes(), true, "test.csv").is_err() {
            return Ok(());
        }
        let once = tab_separated(&text, WHOLE);
        prop_assert_eq!(&once, &tab_separated(&text, Cut { step, workers, ..WHOLE }));
        for line in once.split_terminator('\n') {
            prop_assert_eq!(line.split('\t').count(), 5 + 6, "{:?} of {:?}", line, text);
        }
        // Its rows are the objects of JSON lines.
        let mut lines = Vec::new();
        judged::<JsonLines>(text.as_bytes(), WHOLE, &Sources::default(), &mut lines).unwrap();
        let objects = String::from_utf8(lines).unwrap();
        prop_assert_eq!(once.lines().count(), objects.lines().count() + 1);
        for (line, object) in once.lines().skip(1).zip(objects.lines()) {
            let object: serde_json::Value = serde_json::from_str(object).unwrap();
            let id = object["id"].as_str().unwrap().replace("\r\n", " ").replace(['\t', '\r', '\n'], " ");
            prop_assert_eq!(line.split('\t').next(), Some(id.as_str()));
            prop_assert_eq!(line.split('\t').nth(8), Some(object["status"].as_str().unwrap_or_default()));
        }
    }
}
