//! Files of any size: CSV and measuring logs are read in pieces, to the same rows as at once.

use std::fs::File;
use std::io::{Cursor, Read, Seek, SeekFrom, Write as _};
use std::path::Path;

use assert_cmd::Command;
use fitcheck::exchange::{ImportInputs, Item, import, import_from};
use fitcheck::tolerance::Sources;

const NOW: jiff::civil::DateTime = jiff::civil::date(2025, 1, 1).at(0, 0, 0, 0);

/// More rows than fit into the first piece.
const ROWS: usize = 60_000;

/// The nanometres of a row.
fn measured(row: usize) -> i64 {
    25_000_000 + i64::try_from(row).unwrap() % 30_000
}

fn text(line_end: &str) -> String {
    let rows = (0..ROWS).map(|row| {
        let nm = measured(row);
        format!("Bohrung {row} Ø;25 H7;{}.{:06}{line_end}", nm / 1_000_000, nm % 1_000_000)
    });
    format!("name;callout;measured{line_end}") + &rows.collect::<String>()
}

/// Line, name and measured value of each record, and what was said of others.
fn read(name: &str, bytes: &[u8]) -> (Vec<(usize, String, i64)>, Vec<String>) {
    let (mut records, mut others) = (Vec::new(), Vec::new());
    let sources = Sources::default();
    import_from(name, &mut Cursor::new(bytes), ImportInputs::new(&sources, NOW), &mut |item| match item {
        Item::Record { line, record, .. } => {
            records.push((line, record.id.clone(), record.measurement.diameter.nanometres()));
        }
        Item::Error(error) => others.push(error.to_string()),
        other => others.push(format!("{other:?}")),
    });
    (records, others)
}

#[track_caller]
fn check(bytes: &[u8]) {
    let (records, others) = read("m.csv", bytes);
    assert_eq!(others, [""; 0]);
    assert_eq!(records.len(), ROWS);
    for (row, (line, id, nm)) in records.iter().enumerate() {
        assert_eq!((*line, id.as_str(), *nm), (row + 2, format!("Bohrung {row} Ø").as_str(), measured(row)));
    }
}

#[test]
fn a_csv_of_many_pieces_is_read_row_by_row_whatever_its_line_ends() {
    for line_end in ["\n", "\r\n", "\r"] {
        check(text(line_end).as_bytes());
    }
}

#[test]
fn a_csv_of_many_pieces_is_read_in_every_encoding() {
    let text = text("\r\n");
    check(&[b"\xef\xbb\xbf", text.as_bytes()].concat());
    check(&encoding_rs::WINDOWS_1252.encode(&text).0);
    let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    check(&[b"\xff\xfe".as_slice(), &utf16].concat());
    let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    check(&[b"\xfe\xff".as_slice(), &utf16].concat());
}

#[test]
fn many_logs_are_read_one_by_one() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs");
    for (path, unfinished) in [("en/TCHPR421.TXT", false), ("variants/TCHPR421_value_on_next_line.TXT", true)] {
        let one = std::fs::read(folder.join(path)).unwrap();
        let lines = memchr::memchr_iter(b'\n', &one).count();
        let (first, _) = read("logs.txt", &one);
        let count = (3 << 20) / one.len();
        let all = one.repeat(count);
        let (records, others) = read("logs.txt", if unfinished { all.trim_ascii_end() } else { &all });
        assert_eq!((records.len(), others), (count, Vec::new()));
        for (log, (line, _, nm)) in records.into_iter().enumerate() {
            assert_eq!((line, nm), (first[0].0 + log * lines, first[0].2));
        }
    }
}

#[test]
fn what_is_kept_in_memory_is_bounded_and_says_so() {
    let sources = Sources::default();
    let text = text("\n");
    let (mut rows, mut said) = (0, Vec::new());
    let given = ImportInputs { most_rows: 10, ..ImportInputs::new(&sources, NOW) };
    import_from("m.csv", &mut Cursor::new(text.as_bytes()), given, &mut |item| match item {
        Item::Error(error) => said.push(error.to_string()),
        _ => rows += 1,
    });
    assert_eq!((rows, said), (10, vec!["line 12: only the first 10 rows were read: split the file".to_owned()]));
    let imported = import("m.csv", text.as_bytes(), &sources, NOW);
    assert_eq!((imported.records.len(), imported.errors.len()), (ROWS, 0));
}

#[test]
fn comments_of_any_length_may_come_before_the_rows() {
    let text =
        format!("{}name;callout;measured\n{}b1;25 H7;25.012\n", "# station 3\n".repeat(20_000), "\n".repeat(200_000));
    let (records, others) = read("m.csv", text.as_bytes());
    assert_eq!((records, others), (vec![(220_002, "b1".to_owned(), 25_012_000)], Vec::new()));
}

#[test]
fn a_row_of_many_megabytes_costs_itself_alone() {
    let text = format!("callout;measured\n25 H7;25.012\n{}\n25 H7;25.013\n", "x".repeat(5 << 20));
    let (records, others) = read("m.csv", text.as_bytes());
    let lines: Vec<usize> = records.iter().map(|(line, ..)| *line).collect();
    assert_eq!((lines, others), (vec![2, 4], vec!["line 3: the row is longer than 1024 KiB".to_owned()]));
}

/// A file whose disk fails after some bytes.
struct Failing {
    text: Cursor<Vec<u8>>,
    after: u64,
}

impl Read for Failing {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        if self.after <= self.text.position() {
            return Err(std::io::Error::other("the disk is gone"));
        }
        self.text.read(buffer)
    }
}

impl Seek for Failing {
    fn seek(&mut self, to: SeekFrom) -> std::io::Result<u64> {
        self.text.seek(to)
    }
}

#[test]
fn what_was_read_before_the_disk_failed_counts() {
    let (sources, mut records, mut said) = (Sources::default(), 0, Vec::new());
    let mut body = Failing { text: Cursor::new(text("\n").into_bytes()), after: 1_500_000 };
    import_from("m.csv", &mut body, ImportInputs::new(&sources, NOW), &mut |item| match item {
        Item::Error(error) => said.push(error.to_string()),
        _ => records += 1,
    });
    assert!(20_000 < records && records < ROWS, "{records}");
    assert_eq!(said.len(), 1, "{said:?}");
    assert!(said[0].contains("the disk is gone"), "{said:?}");
}

fn run(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output = Command::cargo_bin("fitcheck").unwrap().current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn a_csv_larger_than_what_is_read_whole_is_imported_and_reported() {
    let folder = tempfile::tempdir().unwrap();
    let mut file = File::create(folder.path().join("large.csv")).unwrap();
    file.write_all(b"callout;measured\n25 H7;25.012\n").unwrap();
    // A line that takes no space on the disk.
    file.set_len(200_000_000).unwrap();
    file.seek(SeekFrom::End(0)).unwrap();
    file.write_all(b"\n25 H7;25.022\n").unwrap();
    let (code, out, err) = run(folder.path(), &["import", "large.csv", "--format", "csv"]);
    assert_eq!((code, out.lines().count(), err.as_str()), (1, 4, ""), "{out}");
    assert!(out.contains("large.csv,2,") && out.contains("large.csv,4,"), "{out}");
    let (code, out, err) = run(folder.path(), &["report", "large.csv", "-o", "-", "--format", "csv"]);
    assert_eq!((code, out.lines().count()), (1, 3), "{err}");
}
