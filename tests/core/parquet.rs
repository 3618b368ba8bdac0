//! Parquet in and out of `batch`: the answers of CSV, whatever the types, row groups and pages; files of other tools; damaged
//! ones.

use std::sync::Arc;

use ::parquet::basic::{Compression, GzipLevel, LogicalType, Repetition, Type as Physical, ZstdLevel};
use ::parquet::data_type::{
    ByteArray, ByteArrayType, DoubleType, FixedLenByteArray, FixedLenByteArrayType, FloatType, Int32Type, Int64Type,
};
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::reader::{FileReader as _, SerializedFileReader};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::record::Field as Cell;
use ::parquet::schema::types::{Type, TypePtr};
use bytes::Bytes;
use fitcheck::batch::parquet::{Columns, from_text, into_text, through};
use fitcheck::batch::{Input, Manner, Packing, Summary, Watch};
use fitcheck::exchange::batch::{
    Csv, Cutter, JsonLines, Layout, RowNoteKind, StreamJudging, Tsv, layout_of, output_fields,
};
use fitcheck::exchange::parquet::{Field, Reader, Writer};
use fitcheck::tolerance::Sources;
use proptest::prelude::*;

const MANNER: Manner<'static> = Manner { workers: 2, packing: Packing::Plain, prefix: "" };

/// A column for a file that the `parquet` crate writes by itself.
#[derive(Debug, Clone)]
enum Column {
    Text(Vec<Option<String>>),
    Int32(Vec<Option<i32>>),
    Int64(Vec<Option<i64>>),
    Float(Vec<Option<f32>>),
    Double(Vec<Option<f64>>),
    Bytes(Vec<Option<Vec<u8>>>),
    Fixed(usize, Vec<Option<Vec<u8>>>),
}

/// How a file is laid out.
#[derive(Debug, Clone, Copy)]
struct Shape {
    group: usize,
    page: usize,
    has_dictionary: bool,
    packing: Compression,
}

const SHAPE: Shape = Shape { group: 1000, page: 1000, has_dictionary: true, packing: Compression::SNAPPY };

fn optional(name: &str, physical: Physical, logical: Option<LogicalType>, length: i32) -> TypePtr {
    let builder =
        Type::primitive_type_builder(name, physical).with_repetition(Repetition::OPTIONAL).with_length(length);
    let builder = match &logical {
        Some(LogicalType::Decimal(decimal)) => builder.with_precision(decimal.precision).with_scale(decimal.scale),
        _ => builder,
    };
    Arc::new(builder.with_logical_type(logical).build().unwrap())
}

/// A file with these columns, written by the `parquet` crate's own writer.
fn file(columns: &[(&str, Option<LogicalType>, Column)], shape: Shape) -> Bytes {
    let text = Some(LogicalType::String);
    let fields = columns.iter().map(|(name, logical, column)| match column {
        Column::Text(_) => optional(name, Physical::BYTE_ARRAY, text.clone(), 0),
        Column::Int32(_) => optional(name, Physical::INT32, logical.clone(), 0),
        Column::Int64(_) => optional(name, Physical::INT64, logical.clone(), 0),
        Column::Float(_) => optional(name, Physical::FLOAT, logical.clone(), 0),
        Column::Double(_) => optional(name, Physical::DOUBLE, logical.clone(), 0),
        Column::Bytes(_) => optional(name, Physical::BYTE_ARRAY, logical.clone(), 0),
        Column::Fixed(length, _) => {
            optional(name, Physical::FIXED_LEN_BYTE_ARRAY, logical.clone(), i32::try_from(*length).unwrap())
        }
    });
    let schema = Type::group_type_builder("root").with_fields(fields.collect()).build().unwrap();
    let properties = WriterProperties::builder()
        .set_dictionary_enabled(shape.has_dictionary)
        .set_data_page_row_count_limit(shape.page)
        .set_write_batch_size(shape.page.clamp(1, 64))
        .set_compression(shape.packing);
    let mut out = Vec::new();
    let mut writer = SerializedFileWriter::new(&mut out, Arc::new(schema), Arc::new(properties.build())).unwrap();
    let rows = columns.first().map_or(0, |(_, _, column)| column.len());
    for from in (0..rows).step_by(shape.group.max(1)) {
        let to = rows.min(from + shape.group.max(1));
        let mut group = writer.next_row_group().unwrap();
        for (_, _, column) in columns {
            let mut next = group.next_column().unwrap().unwrap();
            macro_rules! write {
                ($values:expr, $kind:ty, $make:expr) => {{
                    let some = &$values[from..to];
                    let levels: Vec<i16> = some.iter().map(|value| i16::from(value.is_some())).collect();
                    let values: Vec<_> = some.iter().flatten().cloned().map($make).collect();
                    next.typed::<$kind>().write_batch(&values, Some(&levels), None).unwrap();
                }};
            }
            match column {
                Column::Text(values) => {
                    write!(values, ByteArrayType, |text: String| ByteArray::from(text.into_bytes()));
                }
                Column::Int32(values) => write!(values, Int32Type, |value| value),
                Column::Int64(values) => write!(values, Int64Type, |value| value),
                Column::Float(values) => write!(values, FloatType, |value| value),
                Column::Double(values) => write!(values, DoubleType, |value| value),
                Column::Bytes(values) => write!(values, ByteArrayType, ByteArray::from),
                Column::Fixed(_, values) => write!(values, FixedLenByteArrayType, FixedLenByteArray::from),
            }
            next.close().unwrap();
        }
        group.close().unwrap();
    }
    writer.close().unwrap();
    out.into()
}

/// A file of these columns: a column of numbers alone as such where `are_typed`, any other as texts.
pub(crate) fn of_table(names: &[&str], rows: &[Vec<&str>], are_typed: bool) -> Bytes {
    let column = |at: usize| {
        let cells = || rows.iter().map(move |row| Some(row[at]).filter(|cell| !cell.is_empty()));
        let numbers: Option<Vec<Option<f64>>> = cells()
            .map(|cell| cell.map(|cell| cell.parse().ok()))
            .map(|cell| match cell {
                Some(None) => None,
                Some(number) => Some(number),
                None => Some(None),
            })
            .collect();
        match numbers.filter(|_| are_typed) {
            Some(numbers) => Column::Double(numbers),
            None => Column::Text(cells().map(|cell| cell.map(str::to_owned)).collect()),
        }
    };
    let columns: Vec<_> = names.iter().enumerate().map(|(at, name)| (*name, None, column(at))).collect();
    file(&columns, SHAPE)
}

impl Column {
    fn len(&self) -> usize {
        match self {
            Self::Text(values) => values.len(),
            Self::Int32(values) => values.len(),
            Self::Int64(values) => values.len(),
            Self::Float(values) => values.len(),
            Self::Double(values) => values.len(),
            Self::Bytes(values) | Self::Fixed(_, values) => values.len(),
        }
    }
}

/// The rows of a file as CSV with their answers.
fn as_csv(file: &Bytes) -> Result<(Vec<Vec<String>>, Summary), String> {
    let reader = || Reader::new(file.clone()).map_err(|error| error.to_string());
    let layout = layout_of(reader()?).map_err(|error| error.to_string())?;
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    let mut out = Csv::header(&layout, "");
    let summary = into_text::<Csv, _>(reader()?, &court, MANNER, &mut out, &Watch::default(), &mut |_| {});
    let summary = summary.map_err(|error| format!("{error:?}"))?;
    Ok((records(&out, b','), summary))
}

/// The rows of a file as a Parquet file with their answers.
fn as_parquet(file: &Bytes) -> Result<Bytes, String> {
    let reader = || Reader::new(file.clone()).map_err(|error| error.to_string());
    let layout = layout_of(reader()?).map_err(|error| error.to_string())?;
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    let columns = output_fields(&layout, Some(reader()?.fields()), "").unwrap();
    let mut out = Vec::new();
    let mut writer = Writer::new(&mut out, &columns).unwrap();
    let done = through(
        reader()?,
        &court,
        Columns { columns: &columns, workers: 2 },
        &mut writer,
        &Watch::default(),
        &mut |_| {},
    );
    done.map_err(|error| format!("{error:?}"))?;
    writer.finish().unwrap();
    Ok(out.into())
}

/// The rows of CSV as a Parquet file with their answers, cut in blocks of about so many bytes.
fn csv_as_parquet(text: &[u8], step: usize) -> Bytes {
    let layout = Layout::of(text, true, "a.csv").unwrap();
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    let columns = output_fields(&layout, None, "").unwrap();
    let mut out = Vec::new();
    let mut writer = Writer::new(&mut out, &columns).unwrap();
    let mut stream = &text[layout.skip..];
    let input = Input { stream: &mut stream, cutter: Cutter::new(layout.separator(), step, true) };
    from_text(input, &court, Columns { columns: &columns, workers: 2 }, &mut writer, &Watch::default(), &mut |_| {})
        .unwrap();
    writer.finish().unwrap();
    out.into()
}

fn csv_answers(text: &[u8]) -> (Vec<Vec<String>>, Summary) {
    let layout = Layout::of(text, true, "a.csv").unwrap();
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    let mut out = Csv::header(&layout, "");
    let mut stream = &text[layout.skip..];
    let input = Input { stream: &mut stream, cutter: Cutter::new(layout.separator(), 1 << 20, true) };
    let summary = fitcheck::batch::run::<Csv>(input, &court, MANNER, &mut out, &Watch::default(), &mut |_| {}).unwrap();
    (records(&out, layout.separator()), summary)
}

fn records(text: &[u8], separator: u8) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).delimiter(separator).from_reader(text);
    reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
}

/// What the `parquet` crate's own reader finds in a file: the names, then each row; figures without zeros at their end.
fn cells(file: &Bytes) -> Vec<Vec<String>> {
    let reader = SerializedFileReader::new(file.clone()).unwrap();
    let schema = reader.metadata().file_metadata().schema().clone();
    let mut all = vec![schema.get_fields().iter().map(|field| field.name().to_owned()).collect()];
    for row in reader.get_row_iter(None).unwrap() {
        let row = row.unwrap();
        let text = |cell: &Cell| match cell {
            Cell::Null => String::new(),
            Cell::Str(text) => text.clone(),
            Cell::Decimal(_) => short(&cell.to_string()),
            other => other.to_string(),
        };
        all.push(row.get_column_iter().map(|(_, cell)| text(cell)).collect());
    }
    all
}

/// A decimal without zeros at its end.
fn short(text: &str) -> String {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text.to_owned() }
}

/// Rows of CSV answers, with the figures written shortly.
fn shortened(rows: Vec<Vec<String>>, from: usize) -> Vec<Vec<String>> {
    let is_figure =
        |text: &String| !text.is_empty() && text.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'.' | b'-'));
    let cell = |(at, text): (usize, String)| if from <= at && is_figure(&text) { short(&text) } else { text };
    rows.into_iter().map(|row| row.into_iter().enumerate().map(cell).collect()).collect()
}

#[test]
fn what_duckdb_writes_is_read_in_every_type_and_passed_on_as_it_is() {
    let bytes = Bytes::from_static(include_bytes!("../data/parquet/duckdb.parquet"));
    let (rows, summary) = as_csv(&bytes).unwrap();
    let names = "id,nominal,class,measured,large,tiny,huge,whole,flag,day,moment,moment_utc,noon,binary,short,uuid,bytes,\
        min_mm,max_mm,deviation_um,status,remove_um,error";
    let mut expected = names.to_owned();
    expected.push_str(
        "\nA1,25.0,H7,25.010000,25.010000,7,18446744073709551615,-3,true,2026-01-31,2026-01-31T12:00:00.5,\
        2026-01-31T12:00:00Z,12:30:00,0.1,0.1,00112233-4455-6677-8899-aabbccddeeff,a,25.000,25.021,10,GOOD,,\n",
    );
    let large = format!("1{}", "0".repeat(300));
    let rest = format!(
        "\"A,2\",25.0,H7,24.998000,-24.9980000001,0,0,9,false,1969-12-31,1969-12-31T23:59:59.999999,1969-01-31T12:00:00Z,\
        00:00:00,{large},-2.5,ffffffff-ffff-ffff-ffff-ffffffffffff,b,25.000,25.021,-2,REWORK,2,\n\
        ,25.0,h6,25.000500,,,,,,,,,,,,,,24.987,25.000,0.5,REWORK,0.5,\n\
        A4,,h6,24.900000,0.000000,1,1,1,true,2026-01-31,,,,NaN,inf,,,,,,,,nominal size: a length is missing\n\
        A5,25.0,h6,,0.500000,1,1,1,true,2026-01-31,,,,-0,3,,,,,,,,measured: a length is missing\n\
        ,,,,,,,,,,,,,,,,,,,,,,\n"
    );
    expected.push_str(&rest);
    assert_eq!(rows, records(expected.as_bytes(), b','));
    assert_eq!(summary.tally.rows, 5, "a row without any value is none, and keeps its place");
    let out = as_parquet(&bytes).unwrap();
    let declared = |bytes: &Bytes| {
        let reader = SerializedFileReader::new(bytes.clone()).unwrap();
        reader.metadata().file_metadata().schema().get_fields().to_vec()
    };
    assert_eq!(declared(&out)[..17], declared(&bytes)[..]);
    let (mut before, after) = (cells(&bytes), cells(&out));
    for (before, after) in before.iter_mut().zip(&after) {
        before.extend_from_slice(&after[17..]);
    }
    assert_eq!(before, after, "the columns of the input");
    let answers = |rows: Vec<Vec<String>>| rows.into_iter().map(|row| row[17..].to_vec()).collect::<Vec<_>>();
    assert_eq!(answers(shortened(rows, 17)), answers(after));
}

#[test]
fn what_polars_writes_is_read_over_row_groups() {
    let bytes = Bytes::from_static(include_bytes!("../data/parquet/polars.parquet"));
    let expected = "part,callout,measured,inspector,when,width,min_mm,max_mm,deviation_um,status,remove_um,error\n\
        A1,25 H7,25.01,Jo,2026-01-31T12:00:00,1.5000,25.000,25.021,10,GOOD,,\n\
        A2,25 H7,24.998,Jo,2026-01-31T12:00:00,,25.000,25.021,-2,REWORK,2,\n\
        A3,25 h6,25.0005,Al,2026-01-31T12:00:00,-2.2500,24.987,25.000,0.5,REWORK,0.5,\n\
        ,25 H7,,Al,2026-01-31T12:00:00,0.0000,,,,,,measured: a length is missing\n";
    assert_eq!(as_csv(&bytes).unwrap().0, records(expected.as_bytes(), b','));
    let reader = Reader::new(bytes.clone()).unwrap();
    let floats: Vec<&str> = reader.fields().iter().filter(|field| field.is_float()).map(Field::name).collect();
    assert_eq!(floats, ["measured"]);
    assert_eq!(cells(&as_parquet(&bytes).unwrap()).len(), 5);
}

fn texts(values: &[&str]) -> Column {
    Column::Text(values.iter().map(|text| (!text.is_empty()).then(|| (*text).to_owned())).collect())
}

/// The big-endian bytes of a number, no more than needed, or exactly so many.
fn big_endian(number: i128, length: Option<usize>) -> Vec<u8> {
    let all = number.to_be_bytes();
    let sign = if number < 0 { 0xff } else { 0 };
    match length {
        Some(length) if all.len() < length => [vec![sign; length - all.len()], all.to_vec()].concat(),
        Some(length) => all[all.len() - length..].to_vec(),
        None => {
            let skip = (0..all.len() - 1).take_while(|&at| all[at] == sign && (all[at + 1] ^ sign) < 0x80).count();
            all[skip..].to_vec()
        }
    }
}

#[test]
fn a_decimal_of_any_physical_type_is_exact() {
    let numbers: [i128; 6] = [25_010_001, 25_021_000, 25_021_001, 24_999_999, 0, -5_000_000];
    let all = |scale: u32| numbers.map(|number| number * 10_i128.pow(scale - 6));
    let decimal = |scale, precision| Some(LogicalType::decimal(scale, precision));
    let some = |values: [i128; 6], length| values.iter().map(|value| Some(big_endian(*value, length))).collect();
    let expected = ["25.010001", "25.021000", "25.021001", "24.999999", "0.000000", "-5.000000"];
    let statuses = ["GOOD", "GOOD", "SCRAP", "REWORK", "", ""];
    for (column, logical) in [
        (Column::Int32(numbers.map(|value| i32::try_from(value).ok()).to_vec()), decimal(6, 9)),
        (Column::Int64(numbers.map(|value| i64::try_from(value).ok()).to_vec()), decimal(6, 18)),
        (Column::Bytes(some(numbers, None)), decimal(6, 30)),
        (Column::Bytes(some(all(18), None)), decimal(18, 38)),
        (Column::Fixed(4, some(numbers, Some(4))), decimal(6, 9)),
        (Column::Fixed(16, some(all(18), Some(16))), decimal(18, 38)),
        (Column::Fixed(20, some(all(20), Some(20))), decimal(20, 47)),
        (Column::Fixed(32, some(numbers, Some(32))), decimal(6, 76)),
    ] {
        let name = format!("{column:?} {logical:?}");
        let bytes = file(&[("callout", None, texts(&["25 H7"; 6])), ("measured", logical, column)], SHAPE);
        let (rows, _) = as_csv(&bytes).unwrap();
        let measured: Vec<&str> = rows[1..].iter().map(|row| row[1].as_str()).collect();
        assert_eq!(measured, expected, "{name}");
        let found: Vec<&str> = rows[1..].iter().map(|row| row[5].as_str()).collect();
        assert_eq!(found, statuses, "{name}");
    }
}

#[test]
fn a_float_is_judged_as_its_shortest_decimal() {
    let doubles = vec![Some(25.021), Some(25.021_000_000_1), Some(0.1 + 0.2), Some(f64::NAN), None, Some(25.0)];
    let bytes = file(&[("callout", None, texts(&["25 H7"; 6])), ("measured", None, Column::Double(doubles))], SHAPE);
    let (rows, _) = as_csv(&bytes).unwrap();
    let said: Vec<(&str, &str)> = rows[1..].iter().map(|row| (row[1].as_str(), row[5].as_str())).collect();
    let expected =
        [("25.021", "GOOD"), ("25.0210000001", ""), ("0.30000000000000004", ""), ("NaN", ""), ("", ""), ("25", "GOOD")];
    assert_eq!(said, expected);
    assert!(rows[1..].iter().all(|row| row[5].is_empty() != row[7].is_empty()), "{rows:?}");
    let floats = Column::Float(vec![Some(25.021), Some(25.022), Some(1e-9)]);
    let bytes = file(&[("callout", None, texts(&["25 H7"; 3])), ("measured", None, floats)], SHAPE);
    let (rows, _) = as_csv(&bytes).unwrap();
    assert_eq!(rows[1..].iter().map(|row| row[1].as_str()).collect::<Vec<_>>(), ["25.021", "25.022", "0.000000001"]);
}

#[test]
fn what_means_something_in_csv_is_a_cell_like_any_other() {
    let bytes = file(
        &[
            ("id", None, texts(&["#1", "a,b", "c\"d", "e\nf", ";"])),
            ("callout", None, texts(&["25 H7", "25 H7", "25 H7", "25 H7", ""])),
            ("measured", None, Column::Int64(vec![Some(25), Some(25), Some(25), Some(25), None])),
            ("count", None, Column::Int64(vec![Some(12); 5])),
        ],
        SHAPE,
    );
    let (rows, summary) = as_csv(&bytes).unwrap();
    let found: Vec<(&str, &str)> = rows[1..].iter().map(|row| (row[0].as_str(), row[7].as_str())).collect();
    assert_eq!(found, [("#1", "GOOD"), ("a,b", "GOOD"), ("c\"d", "GOOD"), ("e\nf", "GOOD"), (";", "")]);
    assert_eq!(summary.tally.notes(RowNoteKind::SeveralLines).count, 0);
    assert_eq!(summary.tally.lines, 5, "a row counts as one line");
    assert_eq!(summary.tally.notes(RowNoteKind::Refused).first[0].line, 4);
    let again = cells(&as_parquet(&bytes).unwrap());
    let statuses: Vec<&str> = again[1..].iter().map(|row| row[7].as_str()).collect();
    assert_eq!(statuses, ["GOOD", "GOOD", "GOOD", "GOOD", ""]);
}

#[test]
fn json_lines_come_from_parquet_too() {
    let bytes = Bytes::from_static(include_bytes!("../data/parquet/polars.parquet"));
    let layout = layout_of(Reader::new(bytes.clone()).unwrap()).unwrap();
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    let mut out = Vec::new();
    let reader = Reader::new(bytes).unwrap();
    into_text::<JsonLines, _>(reader, &court, MANNER, &mut out, &Watch::default(), &mut |_| {}).unwrap();
    let first: serde_json::Value =
        serde_json::from_str(std::str::from_utf8(&out).unwrap().lines().next().unwrap()).unwrap();
    assert_eq!(first["measured"], "25.01");
    assert_eq!(first["deviation_um"], 10);
}

#[test]
fn tsv_comes_from_parquet_too() {
    let bytes = file(
        &[
            ("a\tb", None, texts(&["x\ty\r\nz", ""])),
            ("callout", None, texts(&["25 H7", ""])),
            ("measured", None, texts(&["25.01", ""])),
        ],
        SHAPE,
    );
    let layout = layout_of(Reader::new(bytes.clone()).unwrap()).unwrap();
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    let mut out = Tsv::header(&layout, "");
    let reader = Reader::new(bytes).unwrap();
    into_text::<Tsv, _>(reader, &court, MANNER, &mut out, &Watch::default(), &mut |_| {}).unwrap();
    let expected = "a b\tcallout\tmeasured\tmin_mm\tmax_mm\tdeviation_um\tstatus\tremove_um\terror\n\
        x y z\t25 H7\t25.01\t25.000\t25.021\t10\tGOOD\t\t\n\t\t\t\t\t\t\t\t\n";
    assert_eq!(String::from_utf8(out).unwrap(), expected);
}

#[test]
fn nothing_without_rows_columns_or_plain_cells_is_judged() {
    let none = file(&[("callout", None, texts(&[])), ("measured", None, texts(&[]))], SHAPE);
    assert_eq!(as_csv(&none).unwrap().1.tally.rows, 0);
    assert_eq!(cells(&as_parquet(&none).unwrap()).len(), 1);
    let unknown = file(&[("a", None, texts(&["x"])), ("b", None, texts(&["y"]))], SHAPE);
    let said = as_csv(&unknown).unwrap_err();
    assert_eq!(said, "no column of measured values: name it in the first line, such as id;callout;measured");
    let empty = file(&[], SHAPE);
    assert!(as_csv(&empty).is_err());
    let inner = optional("x", Physical::INT32, None, 0);
    let nested = Type::group_type_builder("measured").with_repetition(Repetition::REQUIRED).with_fields(vec![inner]);
    let schema = Type::group_type_builder("root").with_fields(vec![Arc::new(nested.build().unwrap())]).build().unwrap();
    let mut out = Vec::new();
    SerializedFileWriter::new(&mut out, Arc::new(schema), Arc::default()).unwrap().close().unwrap();
    let said = as_csv(&out.into()).unwrap_err();
    assert_eq!(said, "column measured.x contains columns or lists: only columns of single values can be judged");
}

/// Rows that people and machines write, right and wrong; the cells as they are, without any quotation.
fn row() -> impl Strategy<Value = [String; 5]> {
    let own = |texts: &[&str]| prop::sample::select(texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>());
    let id = prop_oneof!["[A-Z][0-9]{1,4}", own(&["", "a,b", "5\" pipe", "\"q\"", "x\ny", " ", "\u{d8}12", "=1+1"])];
    let nominal =
        prop_oneof![3 => Just("25".to_owned()), 1 => own(&["25.0", "", "25,5", "26", "x", "0", "25.0000001"])];
    let class = prop_oneof![
        3 => own(&["H7", "h6", "js9", "25 H7", "25H7"]),
        1 => own(&["", "zz9", "H07", "h 6", "25 H7/g6", "25 \u{b1}0.1", "26 H7", "4000 H7", "ZC18", "M6", "H7 ", "A1"]),
    ];
    let measured = prop_oneof![
        3 => "(24|25)\\.[0-9]{1,7}",
        1 => own(&["25", "", "25,012", "25.012 mm", "25012 um", "-1", "0", "x", "635", " 25.01 ", "1e3"]),
    ];
    let simulated = prop_oneof![9 => Just(String::new()), 1 => own(&["true", "false", "perhaps"])];
    (id, nominal, class, measured, simulated)
        .prop_map(|(id, nominal, class, measured, simulated)| [id, nominal, class, measured, simulated])
}

const NAMES: [&str; 5] = ["id", "nominal", "class", "measured", "simulated"];

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, ..ProptestConfig::default() })]

    /// The same rows have the same answers: from CSV, from Parquet of any shape, into CSV and into Parquet.
    #[test]
    fn answers_are_those_of_csv(
        rows in prop::collection::vec(row(), 1..60),
        group in 1..70_usize,
        page in 1..30_usize,
        step in 1..3000_usize,
        has_dictionary in any::<bool>(),
        packing in prop::sample::select(vec![
            Compression::UNCOMPRESSED, Compression::SNAPPY, Compression::GZIP(GzipLevel::default()), Compression::ZSTD(ZstdLevel::default()),
        ]),
    ) {
        let mut writer = csv::WriterBuilder::new().delimiter(b';').from_writer(Vec::new());
        writer.write_record(NAMES).unwrap();
        for row in &rows {
            writer.write_record(row).unwrap();
        }
        let text = writer.into_inner().unwrap();
        let (expected, summary) = csv_answers(&text);
        let column = |at: usize| Column::Text(rows.iter().map(|row| Some(row[at].clone()).filter(|text| !text.is_empty())).collect());
        let columns: Vec<_> = NAMES.into_iter().enumerate().map(|(at, name)| (name, None, column(at))).collect();
        let bytes = file(&columns, Shape { group, page, has_dictionary, packing });
        let (said, other) = as_csv(&bytes).unwrap();
        prop_assert_eq!(&said, &expected);
        prop_assert_eq!(summary.counts(), other.counts());
        prop_assert_eq!(summary.tally.rows, other.tally.rows);
        prop_assert_eq!(summary.tally.notes(RowNoteKind::Refused).count, other.tally.notes(RowNoteKind::Refused).count);
        prop_assert_eq!(cells(&as_parquet(&bytes).unwrap()), shortened(expected.clone(), 5));
        prop_assert_eq!(cells(&csv_as_parquet(&text, step)), shortened(expected, 5));
    }

    /// The text of a double is the shortest that gives it back, whichever way it was found.
    #[test]
    fn doubles_keep_their_shortest_text(numbers in prop::collection::vec(prop_oneof![
        any::<f64>(), (-1_000_000_000_i64..1_000_000_000).prop_map(|nm| f64::from(i32::try_from(nm).unwrap()) / 1e6),
        (0..4_000_000_u32, -3..4_i32).prop_map(|(um, off)| f64::from(um) / 1e3 + f64::from(off) * f64::EPSILON),
    ], 1..50)) {
        let count = numbers.len();
        let column = Column::Double(numbers.iter().copied().map(Some).collect());
        let bytes = file(&[("callout", None, texts(&vec!["25 H7"; count])), ("measured", None, column)], SHAPE);
        let (rows, _) = as_csv(&bytes).unwrap();
        for (row, number) in rows[1..].iter().zip(numbers) {
            prop_assert_eq!(&row[1], &number.to_string());
        }
    }
}

#[test]
fn rows_in_many_row_groups_and_pages_keep_their_order() {
    let count = 300_000;
    let ids = Column::Int64((0..count).map(Some).collect());
    let classes = Column::Text(
        (0..count).map(|at| Some(["H7", "h6", "g6"][usize::try_from(at % 3).unwrap()].to_owned())).collect(),
    );
    let measured = Column::Int64((0..count).map(|at| (at % 7 != 0).then_some(24_990_000 + at % 40_000)).collect());
    let decimal = Some(LogicalType::decimal(6, 18));
    let nominal = Column::Int32(vec![Some(25); usize::try_from(count).unwrap()]);
    let columns =
        [("id", None, ids), ("nominal", None, nominal), ("class", None, classes), ("measured", decimal, measured)];
    for (group, page) in [(1 << 20, 1000), (70_001, 20_000), (999, 100)] {
        let bytes = file(&columns, Shape { group, page, ..SHAPE });
        let (rows, summary) = as_csv(&bytes).unwrap();
        assert_eq!(summary.tally.rows, 300_000);
        assert!(rows[1..].iter().zip(0..).all(|(row, id): (_, i64)| row[0] == id.to_string()));
        let out = as_parquet(&bytes).unwrap();
        let reader = SerializedFileReader::new(out.clone()).unwrap();
        assert_eq!(reader.metadata().num_row_groups(), 3, "of 131 072 rows");
        let answers = cells(&out);
        assert_eq!(answers.len(), rows.len());
        for (said, expected) in answers.into_iter().zip(shortened(rows, 4)).step_by(97) {
            assert_eq!(said[0], expected[0]);
            assert_eq!(said[4..], expected[4..]);
        }
    }
}

/// No byte that is changed, and no end that is missing, does more than to give a reason or other answers.
#[test]
fn a_damaged_file_is_refused_or_read_and_nothing_else() {
    for bytes in [
        include_bytes!("../data/parquet/duckdb.parquet").as_slice(),
        include_bytes!("../data/parquet/polars.parquet").as_slice(),
        include_bytes!("../data/parquet/duckdb_v2.parquet").as_slice(),
    ] {
        for end in 0..bytes.len() {
            assert!(as_csv(&Bytes::copy_from_slice(&bytes[..end])).is_err(), "cut at {end}");
        }
        let mut refused = 0;
        for (at, change) in (0..bytes.len()).zip([0x01, 0x80].into_iter().cycle()) {
            let mut changed = bytes.to_vec();
            changed[at] ^= change;
            refused += usize::from(as_csv(&changed.into()).is_err());
        }
        assert!(bytes.len() / 8 < refused, "only {refused} of {} changes were noticed", bytes.len());
    }
    let garbage = [b"PAR1".as_slice(), &[7; 1000], b"PAR1"].concat();
    assert!(as_csv(&garbage.into()).is_err());
}
