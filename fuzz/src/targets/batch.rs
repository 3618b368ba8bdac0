//! Any bytes as a stream of rows, cut in blocks of any size: the answers are the same, to the byte and to the line of each
//! remark; every row has its answer in its place, as CSV, TSV and JSON.

use std::io::{Cursor, Read};

use fitcheck::batch::{self, Input, Manner, Packing, Rendering, Stream, Summary, Watch};
use fitcheck::exchange::batch::{ADDED, Csv, Cutter, JsonLines, Layout, RowNoteKind, StreamJudging, Tsv};

use super::shared::OWN_SOURCES;

pub fn run(bytes: &[u8]) {
    // The first byte says how the rest is cut.
    let [cut, rest @ ..] = bytes else { return };
    let Ok(mut stream) = Stream::of(Box::new(Cursor::new(rest.to_vec()))) else { return };
    let Ok(Ok(layout)) = stream.layout(true, "a.csv") else { return };
    assert!(layout.skip <= stream.head.len());
    let text = &stream.head[layout.skip..];
    let (whole, csv) = judged::<Csv>(&layout, text, 1 << 20, true);
    let (again, same) = judged::<Csv>(&layout, text, usize::from(*cut % 64) + 1, cut & 64 == 0);
    assert_eq!(whole, again);
    assert_eq!(String::from_utf8_lossy(&csv), String::from_utf8_lossy(&same));
    let judged_rows: u64 = whole.counts().iter().sum();
    assert_eq!(whole.tally.rows, judged_rows + whole.tally.notes(RowNoteKind::Refused).count);
    let said = [Csv::header(&layout, ""), csv].concat();
    let answers = with_answers(&said, &layout);
    assert_eq!(answers, whole.tally.rows, "{}", String::from_utf8_lossy(&said));
    let (_, rows) = judged::<Tsv>(&layout, text, 1 << 20, true);
    let names = Tsv::header(&layout, "");
    for line in [names, rows].concat().split(|byte| *byte == b'\n').filter(|line| !line.is_empty()) {
        let cells = line.split(|byte| *byte == b'\t').count();
        assert_eq!(cells, layout.names.len() + ADDED.len(), "{}", String::from_utf8_lossy(line));
    }
    let (_, lines) = judged::<JsonLines>(&layout, text, 1 << 20, true);
    for line in lines.split(|byte| *byte == b'\n').filter(|line| !line.is_empty()) {
        let _object: serde_json::Value = serde_json::from_slice(line).expect("a line is JSON");
    }
}

fn judged<R: Rendering>(layout: &Layout, text: &[u8], step: usize, is_patient: bool) -> (Summary, Vec<u8>) {
    let court = StreamJudging::new(layout, &OWN_SOURCES);
    let cutter = Cutter::new(layout.separator(), step, is_patient);
    let manner = Manner { workers: 1, packing: Packing::Plain, prefix: "" };
    let mut out = Vec::new();
    let mut input = text.take(u64::MAX);
    let summary =
        batch::run::<R>(Input { stream: &mut input, cutter }, &court, manner, &mut out, &Watch::default(), &mut |_| {});
    (summary.expect("nothing fails in memory"), out)
}

/// How many rows have a status or a reason behind their columns, as another reader of CSV sees them.
fn with_answers(said: &[u8], layout: &Layout) -> u64 {
    let above = Csv::header(layout, "").len();
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(layout.separator())
        .from_reader(&said[above..]);
    let is_answer = |row: &csv::ByteRecord| {
        let count = layout.names.len();
        row.len() == count + ADDED.len() && row.iter().skip(count).any(|cell| !cell.is_empty())
    };
    let rows = reader.byte_records().filter(|row| row.as_ref().is_ok_and(is_answer)).count();
    rows.try_into().unwrap_or(u64::MAX)
}
