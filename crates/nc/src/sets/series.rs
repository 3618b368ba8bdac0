//! The main program of a series: it measures the next part and asks nothing.
//!
//! The table of the series has a row for each part. The next part is that of the first row whose counter is 0. When all of its features
//! are measured, its row is written with the counter last, so that a run that stops before leaves the row to the next one. Mean,
//! range and worst status are computed from the rows: what is corrected in the table counts with the next part. Then a block is added
//! to the protocol, and a part that is scrap stops the run.
//!
//! | parameter | what |
//! |---|---|
//! | Q90, Q92, Q94 | row of the part, rows of the table, number of the part |
//! | Q91, Q96 | worst status: 0 good, 1 rework, 2 scrap; that of this part |
//! | Q93, Q95 | what is read, and its row |
//! | QS10, QS15 | the word of the worst status so far, and of this part |
//! | QS11, QS12, QS13 | the words for scrap, rework, good |
//! | Q1600, Q1640, Q1680 and on | measured value, minimum and maximum of each size |
//! | Q1720, Q1760, Q1800, Q1840 and on | mean (before it the sum), smallest, largest value and range of each size so far |
//! | QS1600, QS1640 and on | what was checked, and its status |

use std::fmt::Write as _;

use super::Planned;
use super::blocks::{Blocks, bare, blocks, written};
use super::called::Called;
use super::error::SetError;
use super::names::Names;
use super::programs::{built_in, heading, main_block};
use crate::program::{Body, TextOperand};

/// The most sizes of a part: so many parameters each kind of figure has.
const MOST_SIZES: usize = 40;

/// The first parameters of each kind of figure.
pub(super) const MEASURED: usize = 1_600;
pub(super) const MINIMUM: usize = 1_640;
pub(super) const MAXIMUM: usize = 1_680;
pub(super) const MEAN: usize = 1_720;
const SMALLEST: usize = 1_760;
const LARGEST: usize = 1_800;
pub(super) const RANGE: usize = 1_840;
/// Of texts: what was checked, and its status.
pub(super) const CHECKED: usize = 1_600;
pub(super) const STATUS: usize = 1_640;

/// The first label of the sizes; each has two.
const LABEL: usize = 100;

/// Names that the table of a series has for columns of its own.
pub(super) const COLUMNS: [&str; 3] = ["NR", "PART", "STATUS"];

/// A size of a part in a series.
pub(super) struct SeriesSize {
    /// The name of its column.
    pub(super) column: String,
    /// The result of its cycle.
    result: u16,
    /// The parameters of the called program that have its limits; none of a point, whose band is a text.
    pub(super) limits: Option<[&'static str; 2]>,
    /// The text of the called program that says what was checked.
    checked: &'static str,
}

/// The sizes of a feature, in the order of its results.
pub(super) fn sizes(planned: Planned<'_>) -> Vec<SeriesSize> {
    let name = &planned.feature.name;
    let one = |result| SeriesSize { column: name.clone(), result, limits: Some(["Q33", "Q23"]), checked: "QS2" };
    let side =
        |result, side, limits| SeriesSize { column: format!("{name}_{side}"), limits: Some(limits), ..one(result) };
    match Called::of(&planned.feature.kind) {
        // The cycle that takes the tolerance as a text has its own parameter.
        Some(Called::Diameter) => vec![one(if planned.by_text { 966 } else { 153 })],
        Some(Called::Width) => vec![one(156)],
        Some(Called::Face) => vec![one(160)],
        Some(Called::Rectangle) => vec![side(154, "X", ["Q83", "Q73"]), side(155, "Y", ["Q33", "Q23"])],
        Some(Called::Point) => vec![SeriesSize { limits: None, checked: "QS1", ..one(164) }],
        None => Vec::new(),
    }
}

/// Refuses what the table of a series has no column for.
pub(super) fn check(planned: &[Planned<'_>]) -> Result<(), SetError> {
    let names = planned.iter().map(|planned| &planned.feature.name);
    let is_column = |name: &str| {
        // Names of columns begin with a letter (TNC7 manual 81762x-19).
        name.starts_with(|first: char| first.is_ascii_alphabetic())
            && !COLUMNS.iter().any(|own| own.eq_ignore_ascii_case(name))
    };
    if let Some(name) = names.into_iter().find(|name| !is_column(name)) {
        return Err(SetError::SeriesName { name: name.clone() });
    }
    let sizes = planned.iter().map(|planned| sizes(*planned).len()).sum();
    if MOST_SIZES < sizes { Err(SetError::SeriesSizes { sizes, most: MOST_SIZES }) } else { Ok(()) }
}

/// The main program of a series with room for so many parts.
pub(super) fn main(names: &Names<'_>, planned: &[Planned<'_>], parts: u16) -> Result<Vec<u8>, SetError> {
    check(planned)?;
    let words = &names.target.language.words().series;
    let part_of = |text: &String| bare(Body::Heading { depth: 2, text: text.clone() });
    let [mut made, each, tail] = built_in(names);
    made.push(part_of(&words.next_part));
    made.extend(next_part(names, parts));
    let mut all = Vec::new();
    for planned in planned {
        made.push(heading(*planned));
        for block in &each {
            match &block.0 {
                // The window of a feature stays as it is; its file becomes a block of the protocol.
                Body::CallProgram(_) => {
                    made.extend(main_block(block, names, *planned).into_iter().take(1));
                    made.extend(read(&kept(*planned, all.len())));
                }
                Body::Stop(_) => {}
                _ => made.extend(main_block(block, names, *planned)),
            }
        }
        all.extend(sizes(*planned));
    }
    made.push(part_of(&words.row));
    made.extend(read(&row(names, &all)));
    made.push(part_of(&words.so_far));
    made.extend(read(&so_far(&all)));
    made.push(part_of(&words.protocol));
    made.extend(protocol(names));
    made.extend(tail);
    made.extend(read(WORST));
    Ok(written(&names.main, &made))
}

fn read(text: &str) -> Blocks {
    blocks(text.as_bytes())
}

fn open(names: &Names<'_>) -> String {
    format!("FN 26: TABOPEN {}\n", names.path(names.series_table))
}

/// Finds the first row without a part. The number in a row must be that of its part: 1011 is "input value incorrect". 1004, "range
/// exceeded", says that no row is left; both come again until the table is in order.
fn next_part(names: &Names<'_>, parts: u16) -> Blocks {
    let words = &names.target.language.words().status;
    let mut text = format!(
        "DECLARE STRING QS11 = \"{}\"\nDECLARE STRING QS12 = \"{}\"\nDECLARE STRING QS13 = \"{}\"\n",
        words.scrap, words.rework, words.good
    );
    text.push_str(&open(names));
    let _infallible = write!(
        text,
        "Q92 = {parts}
Q90 = 0
LBL 80
FN 11: IF +Q92 GT +Q90 GOTO LBL 81
FN 14: ERROR= 1004
FN 9: IF +0 EQU +0 GOTO LBL 80
LBL 81
FN 28: TABREAD Q93 = +Q90/\"PART\"
FN 9: IF +Q93 EQU +0 GOTO LBL 83
Q90 = Q90 + 1
FN 9: IF +Q93 EQU +Q90 GOTO LBL 80
LBL 82
FN 14: ERROR= 1011
FN 9: IF +0 EQU +0 GOTO LBL 82
LBL 83
Q91 = 0
"
    );
    read(&text)
}

/// A value in whole nanometres: what the table has is what was judged.
fn rounded(value: &str) -> String {
    format!("INT ( ( {value} ) * 1000000 + 0.5 * SGN ( {value} ) ) / 1000000")
}

/// Keeps what was measured of a feature, whose first size has this number, and its status.
fn kept(planned: Planned<'_>, first: usize) -> String {
    let mut text = String::new();
    for (at, size) in (first..).zip(sizes(planned)) {
        let value = rounded(&format!("Q{}", size.result));
        let _infallible = writeln!(text, "Q{} = {value}", MEASURED + at);
        if let Some([minimum, maximum]) = size.limits {
            let _infallible = writeln!(text, "Q{} = {minimum}\nQ{} = {maximum}", MINIMUM + at, MAXIMUM + at);
        }
        let _infallible = writeln!(text, "QS{} = {}\nQS{} = QS3", CHECKED + at, size.checked, STATUS + at);
    }
    text + "CALL LBL 70\n"
}

/// Writes the row of the part, its number last.
fn row(names: &Names<'_>, all: &[SeriesSize]) -> String {
    let mut text = format!("Q96 = Q91\nCALL LBL 75\nQS15 = QS10\nQ94 = Q90 + 1\n{}", open(names));
    for (at, size) in (MEASURED..).zip(all) {
        let _infallible = writeln!(text, "FN 27: TABWRITE Q90/\"{}\" = Q{at}", size.column);
    }
    text + "FN 27: TABWRITE Q90/\"STATUS\" = QS15\nFN 27: TABWRITE Q90/\"PART\" = Q94\n"
}

/// Mean, range and worst status of all rows so far.
fn so_far(all: &[SeriesSize]) -> String {
    let mut text = "Q91 = 0\nQ95 = 0\n".to_owned();
    for at in 0..all.len() {
        let measured = MEASURED + at;
        let (mean, smallest, largest) = (MEAN + at, SMALLEST + at, LARGEST + at);
        let _infallible = writeln!(text, "Q{mean} = 0\nQ{smallest} = Q{measured}\nQ{largest} = Q{measured}");
    }
    text.push_str("LBL 84\n");
    for (at, size) in all.iter().enumerate() {
        let (measured, mean, smallest, largest) = (MEASURED + at, MEAN + at, SMALLEST + at, LARGEST + at);
        let label = LABEL + 2 * at;
        let next = label + 1;
        let _infallible = writeln!(
            text,
            "FN 28: TABREAD Q93 = +Q95/\"{}\"
Q{mean} = Q{mean} + Q93 - Q{measured}
FN 11: IF +Q93 GT +Q{smallest} GOTO LBL {label}
Q{smallest} = Q93
LBL {label}
FN 12: IF +Q93 LT +Q{largest} GOTO LBL {next}
Q{largest} = Q93
LBL {next}",
            size.column
        );
    }
    text.push_str(
        "FN 28: TABREAD QS3 = +Q95/\"STATUS\"
CALL LBL 70
Q95 = Q95 + 1
FN 12: IF +Q95 LT +Q94 GOTO LBL 84
CALL LBL 75
",
    );
    for at in 0..all.len() {
        let [measured, mean, smallest, largest, range] =
            [MEASURED, MEAN, SMALLEST, LARGEST, RANGE].map(|kind| kind + at);
        // The sum counts from this part, which keeps it small; from the smallest value on nothing is below zero, and half is rounded up.
        let sum = format!("INT ( ( Q{mean} + Q94 * ( Q{measured} - Q{smallest} ) ) * 1000000 + 0.5 )");
        let _infallible = writeln!(
            text,
            "Q{mean} = Q{smallest} + INT ( {sum} / Q94 + 0.5 ) / 1000000\nQ{range} = {}",
            rounded(&format!("Q{largest} - Q{smallest}"))
        );
    }
    text
}

/// The block of the protocol; a part that is scrap shows it and stops.
fn protocol(names: &Names<'_>) -> Blocks {
    let print = |output: String| {
        bare(Body::Print { mask: names.operand(&names.series_mask), output: TextOperand::Text(output) })
    };
    let mut made = vec![print(names.path(names.protocol))];
    made.extend(read("FN 12: IF +Q96 LT +2 GOTO LBL 86\n"));
    made.push(print("SCREEN:".to_owned()));
    made.extend(read("STOP\nLBL 86\n"));
    made
}

/// Subprograms: 70 makes Q91 the worse one of itself and the status in QS3, 75 puts the word of Q91 into QS10. A word that is none of the
/// three stops the run: it is neither good nor bad.
const WORST: &str = "LBL 70
Q93 = STRCOMP ( SRC_QS3 SEA_QS13 )
FN 9: IF +Q93 EQU +0 GOTO LBL 74
Q93 = STRCOMP ( SRC_QS3 SEA_QS11 )
FN 9: IF +Q93 EQU +0 GOTO LBL 72
Q93 = STRCOMP ( SRC_QS3 SEA_QS12 )
FN 9: IF +Q93 EQU +0 GOTO LBL 73
LBL 71
FN 14: ERROR= 1011
FN 9: IF +0 EQU +0 GOTO LBL 71
LBL 72
Q91 = 2
LBL 73
FN 11: IF +Q91 GT +0 GOTO LBL 74
Q91 = 1
LBL 74
LBL 0
LBL 75
QS10 = QS13
FN 9: IF +Q91 EQU +0 GOTO LBL 76
QS10 = QS12
FN 9: IF +Q91 EQU +1 GOTO LBL 76
QS10 = QS11
LBL 76
LBL 0
";
