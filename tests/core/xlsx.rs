//! Workbooks: rows of a sheet as those of a CSV; errors with sheet and cell; ZIP files that are not meant well.

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use fitcheck::exchange::{FORMATS, Imported, WhyUnjudged, import, sheet_rows, sizes};
use fitcheck::tolerance::{Feature, Sources};
use jiff::civil::{DateTime, date};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

const OPENPYXL: &[u8] = include_bytes!("../data/xlsx/openpyxl.xlsx");
const XLSXWRITER: &[u8] = include_bytes!("../data/xlsx/xlsxwriter.xlsx");

const NOW: DateTime = date(2030, 1, 1).at(0, 0, 0, 0);

fn read(bytes: &[u8]) -> Imported {
    import("a.xlsx", bytes, &Sources::default(), NOW)
}

fn errors(imported: &Imported) -> Vec<String> {
    imported.errors.iter().map(ToString::to_string).collect()
}

fn warnings(imported: &Imported) -> Vec<String> {
    imported.warnings.iter().map(ToString::to_string).collect()
}

/// Line, name, callout, measured value and status of each record.
fn records(imported: &Imported) -> Vec<String> {
    let lines = imported.lines.iter().zip(&imported.records);
    lines
        .map(|(line, record)| {
            let callout = record.callout.unwrap();
            let status = record.verdict.size.status.word();
            format!("{line} {} {callout} {} {status} {}", record.id, record.measurement.diameter, record.time)
        })
        .collect()
}

/// A ZIP file of these members.
fn zipped(members: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in members {
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        zip.start_file(*name, options).unwrap();
        zip.write_all(content).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

const RELS: &str = r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>"#;
const BOOK: &str = r#"<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets><sheet name="S" sheetId="1" r:id="rId1"/></sheets></workbook>"#;
const BOOK_RELS: &str = r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/></Relationships>"#;

/// A workbook of one sheet, with further members.
fn book(sheet: &str, more: &[(&str, &[u8])]) -> Vec<u8> {
    let mut members: Vec<(&str, &[u8])> = vec![
        ("_rels/.rels", RELS.as_bytes()),
        ("xl/workbook.xml", BOOK.as_bytes()),
        ("xl/_rels/workbook.xml.rels", BOOK_RELS.as_bytes()),
        ("xl/worksheets/sheet1.xml", sheet.as_bytes()),
    ];
    members.extend(more);
    zipped(&members)
}

/// A workbook with a sheet of these rows.
pub(crate) fn workbook(rows: &[&[&str]]) -> Vec<u8> {
    book(&sheet(rows), &[])
}

/// A sheet of these rows: a number as such, anything else as a text.
fn sheet(rows: &[&[&str]]) -> String {
    let mut xml = String::from("<worksheet><sheetData>");
    for row in rows {
        xml.push_str("<row>");
        for cell in *row {
            match cell.parse::<f64>() {
                Ok(_) => write!(xml, "<c><v>{cell}</v></c>"),
                Err(_) => write!(xml, "<c t=\"inlineStr\"><is><t>{cell}</t></is></c>"),
            }
            .unwrap();
        }
        xml.push_str("</row>");
    }
    xml + "</sheetData></worksheet>"
}

const HEADER: &[&str] = &["id", "callout", "measured"];

#[track_caller]
fn refused(bytes: &[u8], error: &str) {
    let imported = read(bytes);
    assert_eq!(errors(&imported), [error]);
    assert_eq!(imported.records, []);
}

#[test]
fn the_first_sheet_with_measurements_is_read() {
    let imported = read(OPENPYXL);
    assert_eq!(
        records(&imported),
        [
            "2 B1 25 H7 25.0123 GOOD 2025-01-15T10:21:33",
            "3 B2 25 H7 25.03 SCRAP 2025-01-16T00:00:00",
            "4 B3 25 H7 24.998 REWORK 2030-01-01T00:00:00",
            "8 B6 30 g6 29.985 GOOD 2025-01-15T10:27:00",
        ]
    );
    assert_eq!(
        errors(&imported),
        [
            "line 5, column 3: Measurements!C5: the value of the formula =C2+0.001 is not stored: open the workbook in a spreadsheet program and save it",
            "line 6, column 3: Measurements!C6: the cell shows #N/A",
        ]
    );
    // The callout of merged cells is that of the first one.
    let [unjudged] = imported.unjudged.as_slice() else { panic!() };
    assert_eq!((unjudged.line, unjudged.id.as_str(), &unjudged.why), (9, "B7", &WhyUnjudged::NoCallout));
    let told = [
        "line 1: sheet Measurements is read; other sheets are not: Notes, Chart",
        "line 4: no date and time here: the time of import is used",
    ];
    assert_eq!(warnings(&imported), told);
    // Neither of them looks as if something measured were in it.
    assert!(!imported.warnings[0].what.kind.stands_against());
}

#[test]
fn formulas_count_by_their_stored_value_and_numbers_as_typed() {
    let imported = read(XLSXWRITER);
    assert_eq!(
        records(&imported),
        [
            "2 T1 25 H7 25.0123 GOOD 2025-01-15T10:21:01",
            "4 T3 25 H7 25.0123 GOOD 2025-01-15T10:21:03",
            "5 T4 25 H7 24.9 REWORK 2025-01-15T10:21:04",
        ]
    );
    assert_eq!(
        errors(&imported),
        ["line 3, column 4: Messung!D3: measured: 25.0123666666667 is finer than a nanometre"]
    );
    assert_eq!(warnings(&imported), ["line 1: columns skipped: 7 (Bemerkung)"]);
}

#[test]
fn a_workbook_is_told_by_content() {
    for bytes in [OPENPYXL, XLSXWRITER] {
        for name in ["a.xlsx", "a.txt", "a.csv", "a.qif"] {
            let found = FORMATS.iter().find(|format| format.recognises(bytes, name)).map(|format| format.name);
            assert_eq!(found, Some("xlsx"));
        }
    }
    refused(
        include_bytes!("../data/xlsx/old.xls"),
        "line 1: a workbook in XLS format, which is not supported: save it as XLSX",
    );
    refused(
        include_bytes!("../data/xlsx/other.ods"),
        "line 1: a workbook in ODS format, which is not supported: save it as XLSX",
    );
    refused(
        &zipped(&[("xl/workbook.bin", b"")]),
        "line 1: a workbook in XLSB format, which is not supported: save it as XLSX",
    );
    refused(&zipped(&[("a.txt", b"")]), "line 1: a ZIP file, but not a workbook: unpack it and give the files in it");
}

#[test]
fn sizes_and_rows_alone_come_from_a_workbook() {
    let bytes = book(&sheet(&[&["id", "measured"], &["H1", "25.012"], &["H2", "no"]]), &[]);
    let read = sizes("a.xlsx", &bytes, Feature::Hole);
    assert_eq!((read.measured.len(), read.measured[0].measured.to_string().as_str()), (1, "25.012"));
    assert_eq!(read.errors[0].to_string(), "line 3, column 2: S!B3: measured: no is not a number");
    let rows = sheet_rows(OPENPYXL).unwrap();
    assert_eq!(rows[0], (1, vec!["Bores of part PN-4711".to_owned()]));
    let rows = sheet_rows(XLSXWRITER).unwrap();
    assert_eq!(rows[0].1[..4], ["Teil", "Nennmaß", "Toleranz", "Istmaß (mm)"]);
    assert_eq!(rows[1].1, ["T1", "25", "H7", "25.0123", "2025-01-15", "10:21:01", "abc"]);
    assert_eq!(
        sheet_rows(b"id;measured\n").unwrap_err().to_string(),
        "the end of the workbook is missing: it may be cut off"
    );
}

#[test]
fn a_sheet_that_is_not_in_order_is_refused() {
    let good = "<row r=\"1\"><c t=\"inlineStr\"><is><t>25 H7</t></is></c><c><v>25.012</v></c></row>";
    let with = |row: &str| book(&format!("<worksheet><sheetData>{good}{row}</sheetData></worksheet>"), &[]);
    let told = |row: &str| errors(&read(&with(row))).join("|");
    assert_eq!(
        told("<row r=\"5\"><c><v>1</v></c></row><row r=\"3\"><c><v>1</v></c></row>"),
        "line 5: S!5: expected 2 cells, found 1|line 1: S: this workbook cannot be read: row 3 comes after row 5"
    );
    assert_eq!(
        told("<row r=\"2\"><c r=\"B2\"><v>1</v></c><c r=\"A2\"><v>1</v></c></row>"),
        "line 1: S: this workbook cannot be read: cell A2 is not in order"
    );
    assert_eq!(
        told("<row r=\"2\"><c r=\"XFD2\"><v>1</v></c></row>"),
        "line 1: S: cell XFD2 is beyond the first 1000 columns"
    );
    assert!(
        told("<row r=\"99999999999\"><c r=\"ZZZZZZZZZ99999999999\"><v>1</v></c></row>").starts_with("line 1: S: "),
        "{}",
        told("<row r=\"99999999999\"><c r=\"ZZZZZZZZZ99999999999\"><v>1</v></c></row>")
    );
    assert!(
        told("<row r=\"2\"><c t=\"s\"><v>7</v></c></row>").starts_with("line 1: S: this workbook cannot be read: ")
    );
}

#[test]
fn what_unpacks_to_too_much_is_refused_before_it_does() {
    let rows = sheet(&[HEADER, &["B1", "25 H7", "25.012"]]);
    assert_eq!(read(&book(&rows, &[])).records.len(), 1);
    let dense = "is compressed too densely for a workbook: it is not read";
    let bomb = "<row/>".repeat(4 << 20).into_bytes();
    let packed = book(&rows, &[("xl/sharedStrings.xml", &bomb)]);
    assert!(packed.len() < 200_000);
    refused(&packed, &format!("line 1: xl/sharedStrings.xml unpacks to more than 64 MiB, or {dense}"));
    refused(
        &book(&rows, &[("xl/worksheets/sheet2.xml", &bomb)]),
        &format!("line 1: xl/worksheets/sheet2.xml unpacks to more than 512 MiB, or {dense}"),
    );
    refused(
        &book(&rows, &[("xl/media/a.png", &bomb)]),
        &format!("line 1: xl/media/a.png unpacks to more than 64 MiB, or {dense}"),
    );
    refused(
        &book(&rows, &[("xl/styles.xml", &bomb[..5 << 20])]),
        &format!("line 1: xl/styles.xml unpacks to more than 4 MiB, or {dense}"),
    );
    let counted = "<sst uniqueCount=\"18446744073709551615\"><si><t>a</t></si></sst>";
    refused(
        &book(&rows, &[("xl/sharedStrings.xml", counted.as_bytes())]),
        "line 1: the workbook has more than 3000000 different texts",
    );
    let many = format!("<sst>{}</sst>", "<si/>".repeat(7_000_000));
    let told = errors(&read(&book(&rows, &[("xl/sharedStrings.xml", many.as_bytes())])));
    assert_eq!(told.len(), 1, "{told:?}");
    let deep = "<a>".repeat(100_000);
    refused(
        &book(&rows, &[("xl/worksheets/sheet2.xml", deep.as_bytes())]),
        "line 1: line 1, column 601: nesting limit of 200 elements reached",
    );
    let doctype = format!("<!DOCTYPE worksheet [<!ENTITY a \"b\">]>{rows}");
    refused(
        &book(&doctype, &[]),
        "line 1: line 1, column 1: a DOCTYPE is not supported: remove it, or export the file without it",
    );
    let names: Vec<String> = (0..10_100).map(|number| format!("a{number}")).collect();
    let members: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), b"".as_slice())).collect();
    refused(&book(&rows, &members), "line 1: the workbook's list of members is damaged or has more than 10000 entries");
}

#[test]
fn a_workbook_that_is_cut_off_or_damaged_anywhere_says_so() {
    let whole = read(XLSXWRITER);
    for end in (4..XLSXWRITER.len()).step_by(7) {
        let imported = read(&XLSXWRITER[..end]);
        assert_eq!(imported.records, [], "{end}");
        assert!(!imported.errors.is_empty(), "{end}");
    }
    for at in (0..XLSXWRITER.len()).step_by(3) {
        let mut bytes = XLSXWRITER.to_vec();
        bytes[at] ^= 0x55;
        let imported = read(&bytes);
        // Dates and flags of members are nobody's business.
        assert!(!imported.errors.is_empty() || imported.records == whole.records, "{at}");
    }
}

#[test]
fn what_is_no_measurement_is_said() {
    refused(&book(&sheet(&[]), &[]), "line 1: no row holds a measurement");
    refused(&book(&sheet(&[HEADER]), &[]), "line 1: no row holds a measurement");
    refused(
        &book(&sheet(&[&["a", "b"], &["c", "d"]]), &[]),
        "line 1: S: no column of measured values: name it in the first line, such as id;callout;measured",
    );
}

/// A workbook whose measured value is written so, with these shared texts.
fn measured_as(cell: &str) -> Vec<u8> {
    let rows = sheet(&[HEADER, &["A", "25 H7"]]);
    let rows = rows.replace("</c></row></sheetData>", &format!("</c>{cell}</row></sheetData>"));
    let texts = "<sst uniqueCount=\"2\"><si><t>25.01</t></si><si><t>25.05</t></si></sst>";
    book(&rows, &[("xl/sharedStrings.xml", texts.as_bytes())])
}

#[test]
fn a_value_in_pieces_is_refused_and_never_read_by_half() {
    let odd = "line 1: xl/worksheets/sheet1.xml!C2: the value of the cell is not stored as one plain text, so only a part of it could be \
               read: open the workbook in a spreadsheet program and save it";
    for value in [
        "<v>25.0<!-- -->5</v>",
        "<v>25&#46;05</v>",
        "<v>25.0<![CDATA[5]]></v>",
        "<v><![CDATA[25.05]]></v>",
        "<v>25.0<?x y?>5</v>",
        "<v>25.0<x/>5</v>",
        "<v>25.0</v><v>25.05</v>",
    ] {
        refused(&measured_as(&format!("<c r=\"C2\">{value}</c>")), odd);
    }
    for number in [" 1 ", "+1", "1.0", "x1", "-1", "1<!-- -->", "99999999999999999999"] {
        refused(&measured_as(&format!("<c r=\"C2\" t=\"s\"><v>{number}</v></c>")), odd);
    }
    refused(&measured_as("<c r=\"C2\" t=\"str\"><v>25.0<![CDATA[5]]></v></c>"), odd);
    let good = measured_as("<c r=\"C2\" t=\"s\"><v>0</v></c>");
    assert_eq!(records(&read(&good)), ["2 A 25 H7 25.01 GOOD 2030-01-01T00:00:00"]);
    let scrap = measured_as("<c r=\"C2\"><f>A&amp;B</f><v>25.05</v></c>");
    assert_eq!(records(&read(&scrap)), ["2 A 25 H7 25.05 SCRAP 2030-01-01T00:00:00"]);
}

#[test]
fn a_sheet_under_another_name_is_looked_at_or_refused() {
    let rows = sheet(&[HEADER, &["A", "25 H7"]])
        .replace("</c></row></sheetData>", "</c><c><v>25.0<!-- -->5</v></c></row></sheetData>");
    for (member, is_sheet) in [("worksheets/data.xml", true), ("data.xml", false)] {
        let rels = BOOK_RELS.replace("worksheets/sheet1.xml", member);
        let name = format!("xl/{member}");
        let bytes = zipped(&[
            ("_rels/.rels", RELS.as_bytes()),
            ("xl/workbook.xml", BOOK.as_bytes()),
            ("xl/_rels/workbook.xml.rels", rels.as_bytes()),
            (&name, rows.as_bytes()),
        ]);
        let [error] = errors(&read(&bytes)).try_into().unwrap();
        assert_eq!(error.contains("not stored as one plain text"), is_sheet, "{error}");
        assert_eq!(read(&bytes).records, []);
    }
}

#[test]
fn two_members_of_one_name_are_refused() {
    let rows = sheet(&[HEADER, &["A", "25 H7", "25.05"]]);
    let mut bytes = book(&rows, &[("xl/worksheets/sheet2.xml", sheet(&[HEADER, &["A", "25 H7", "25.01"]]).as_bytes())]);
    // The second name becomes the first one: in its own header and in the list.
    while let Some(at) = bytes.windows(10).position(|at| at == b"sheet2.xml") {
        bytes[at + 5] = b'1';
    }
    refused(
        &bytes,
        "line 1: two members of the workbook have the same name, so it has been changed: open it in a spreadsheet program and save it",
    );
}

#[test]
fn shared_texts_are_counted_and_not_their_tags() {
    // Rich texts have several elements each.
    let texts = format!("<sst>{}</sst>", "<si><r><rPr><b/></rPr><t>a</t></r><r><t>b</t></r></si>".repeat(500_000));
    let rows = sheet(&[HEADER, &["A", "25 H7", "25.01"]]);
    let bytes = book(&rows, &[("xl/sharedStrings.xml", texts.as_bytes())]);
    assert_eq!(records(&read(&bytes)), ["2 A 25 H7 25.01 GOOD 2030-01-01T00:00:00"]);
}

/// A workbook of two sheets, S and T, with further attributes.
fn two_sheets([first, second]: [&str; 2], [s, t]: [&str; 2]) -> Vec<u8> {
    let sheets = format!(
        "<sheet name=\"S\" sheetId=\"1\" r:id=\"rId1\"{first}/><sheet name=\"T\" sheetId=\"2\" r:id=\"rId2\"{second}/>"
    );
    let rel = BOOK_RELS.replace("sheet1.xml\"/>", "sheet1.xml\"/><Relationship Id=\"rId2\" Type=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet\" Target=\"worksheets/sheet2.xml\"/>");
    zipped(&[
        ("_rels/.rels", RELS.as_bytes()),
        ("xl/workbook.xml", BOOK.replace("<sheet name=\"S\" sheetId=\"1\" r:id=\"rId1\"/>", &sheets).as_bytes()),
        ("xl/_rels/workbook.xml.rels", rel.as_bytes()),
        ("xl/worksheets/sheet1.xml", s.as_bytes()),
        ("xl/worksheets/sheet2.xml", t.as_bytes()),
    ])
}

#[test]
fn a_cover_sheet_says_how_warm_the_part_was() {
    let rows = sheet(&[HEADER, &["A", "25 H7", "25.01"]]);
    for (temperature, is_told) in [("35", true), ("20.5", false)] {
        let cover = sheet(&[
            &["Report"],
            &["Customer", "ACME"],
            &["Part temperature [°C]", temperature],
            &["Inspector", "Meier"],
        ]);
        let imported = read(&two_sheets(["", ""], [&cover, &rows]));
        assert_eq!(records(&imported), ["2 A 25 H7 25.01 GOOD 2030-01-01T00:00:00"]);
        let against: Vec<String> =
            imported.warnings.iter().filter(|told| told.what.kind.stands_against()).map(ToString::to_string).collect();
        assert_eq!(against.len(), usize::from(is_told), "{against:?}");
        assert!(against.iter().all(|told| told.contains("Part temperature [°C] 35")), "{against:?}");
    }
}

#[test]
fn a_sheet_that_is_seen_comes_before_a_hidden_one_and_a_hidden_one_is_told() {
    let sheet_of = |value: &str| sheet(&[HEADER, &["A", "25 H7", value]]);
    let state = |first: &str, second: &str| two_sheets([first, second], [&sheet_of("25.01"), &sheet_of("25.05")]);
    let imported = read(&state(" state=\"hidden\"", ""));
    assert_eq!(records(&imported), ["2 A 25 H7 25.05 SCRAP 2030-01-01T00:00:00"]);
    assert_eq!(warnings(&imported), ["line 1: sheet T is read; other sheets are not: S"]);
    assert!(imported.warnings[0].what.kind.stands_against(), "S has a measured value, too");
    let imported = read(&state(" state=\"hidden\"", " state=\"veryHidden\""));
    assert_eq!(records(&imported), ["2 A 25 H7 25.01 GOOD 2030-01-01T00:00:00"]);
    assert_eq!(warnings(&imported)[1], "line 1: sheet S is read, although it is hidden in the workbook");
}

/// Cell formats of these codes, after the plain one.
fn styles(codes: &[&str]) -> String {
    let mut formats = String::new();
    let mut styles = String::from("<xf numFmtId=\"0\"/>");
    for (id, code) in (164..).zip(codes) {
        write!(formats, "<numFmt numFmtId=\"{id}\" formatCode=\"{}\"/>", code.replace('"', "&quot;")).unwrap();
        write!(styles, "<xf numFmtId=\"{id}\" applyNumberFormat=\"1\"/>").unwrap();
    }
    format!("<styleSheet><numFmts>{formats}</numFmts><cellXfs>{styles}</cellXfs></styleSheet>")
}

#[test]
fn a_unit_that_the_number_format_shows_counts() {
    let row = |name: &str, style: usize, value: &str| {
        format!(
            "<row><c t=\"inlineStr\"><is><t>{name}</t></is></c><c t=\"inlineStr\"><is><t>25 H7</t></is></c><c s=\"{style}\"><v>{value}</v></c></row>"
        )
    };
    let rows = [
        row("A", 0, "25.01"),
        row("B", 1, "25.01"),
        row("C", 2, "25010"),
        row("D", 3, "0.9847"),
        row("E", 4, "25.01"),
        row("F", 5, "25.01"),
    ];
    let sheet = sheet(&[HEADER]).replace("</sheetData>", &format!("{}</sheetData>", rows.concat()));
    let styles = styles(&["0.000\" mm\"", "0.0\" \u{b5}m\"", "0.0000\\\"", "0.00%", "0.000\" cm\""]);
    let imported = read(&book(&sheet, &[("xl/styles.xml", styles.as_bytes())]));
    assert_eq!(
        records(&imported),
        [
            "2 A 25 H7 25.01 GOOD 2030-01-01T00:00:00",
            "3 B 25 H7 25.01 GOOD 2030-01-01T00:00:00",
            "4 C 25 H7 25.01 GOOD 2030-01-01T00:00:00",
            // 0.9847 in = 25.01138 mm
            "5 D 25 H7 25.01138 GOOD 2030-01-01T00:00:00",
        ]
    );
    assert_eq!(
        errors(&imported),
        [
            "line 6, column 3: S!C6: measured: 25.01 % is not a number",
            "line 7, column 3: S!C7: measured: 25.01 cm is not a number",
        ]
    );
}

/// Somebody has crossed it out.
#[test]
fn a_number_that_is_struck_through_is_no_value() {
    let row = |name: &str, style: usize, value: &str| {
        format!("<row><c t=\"str\"><v>{name}</v></c><c t=\"str\"><v>25 H7</v></c><c s=\"{style}\">{value}</c></row>")
    };
    let rows = [row("A", 0, "<v>25.01</v>"), row("B", 1, "<v>25.01</v>")].concat();
    let typed =
        "<row><c t=\"str\"><v>C</v></c><c t=\"str\"><v>25 H7</v></c><c s=\"1\" t=\"str\"><v>25,01</v></c></row>";
    let sheet = sheet(&[HEADER]).replace("</sheetData>", &format!("{rows}{typed}</sheetData>"));
    let styles = "<styleSheet><fonts><font/><font><strike/></font></fonts>\
        <cellXfs><xf fontId=\"0\"/><xf fontId=\"1\" applyFont=\"1\"/></cellXfs></styleSheet>";
    let imported = read(&book(&sheet, &[("xl/styles.xml", styles.as_bytes())]));
    assert_eq!(records(&imported), ["2 A 25 H7 25.01 GOOD 2030-01-01T00:00:00"]);
    assert_eq!(
        errors(&imported),
        [
            "line 3, column 3: S!C3: measured: 25,01 (struck through) is not a number",
            "line 4, column 3: S!C4: measured: 25,01 (struck through) is not a number",
        ]
    );
}

#[test]
fn cells_without_a_style_of_their_own_show_the_unit_of_the_plain_one() {
    let row = |name: &str, style: &str, value: &str| {
        format!("<row><c t=\"str\"><v>{name}</v></c><c t=\"str\"><v>25 H7</v></c><c{style}><v>{value}</v></c></row>")
    };
    let rows = [row("A", "", "25010"), row("B", " s=\"1\"", "25.01"), row("C", " s=\"2\"", "25012")].concat();
    let sheet = sheet(&[HEADER]).replace("</sheetData>", &format!("{rows}</sheetData>"));
    let unit = "formatCode=\"0.0&quot; \u{b5}m&quot;\"";
    let styles = format!(
        "<styleSheet><numFmts><numFmt numFmtId=\"164\" {unit}/></numFmts><cellXfs><xf numFmtId=\"164\"/><xf numFmtId=\"2\"/><xf numFmtId=\"164\"/></cellXfs></styleSheet>"
    );
    let imported = read(&book(&sheet, &[("xl/styles.xml", styles.as_bytes())]));
    let measured: Vec<String> = imported.records.iter().map(|record| record.measurement.diameter.to_string()).collect();
    assert_eq!(measured, ["25.01", "25.01", "25.012"], "{:?}", errors(&imported));
}

#[test]
fn hidden_rows_and_columns_are_read_and_told() {
    let sheet = sheet(&[HEADER, &["A", "25 H7", "25.01"], &["B", "25 H7", "25.05"], &["C", "25 H7", "25.02"]]);
    let cols =
        "<cols><col min=\"3\" max=\"3\" hidden=\"1\"/><col min=\"9\" max=\"16384\" hidden=\"1\"/></cols><sheetData>";
    let sheet = sheet.replace("<sheetData>", cols).replacen(
        "<row><c t=\"inlineStr\"><is><t>B",
        "<row hidden=\"1\"><c t=\"inlineStr\"><is><t>B",
        1,
    );
    let imported = read(&book(&sheet, &[]));
    assert_eq!(imported.records.len(), 3);
    assert_eq!(
        warnings(&imported),
        [
            "line 1: row 3 is hidden or filtered out in the workbook, but is read like the others",
            "line 1: hidden columns are read like the others: C",
        ]
    );
    // A sheet is found by its name, whatever signs that has.
    let named = BOOK.replace("name=\"S\"", "name=\"A &amp; B \"");
    let named = zipped(&[
        ("_rels/.rels", RELS.as_bytes()),
        ("xl/workbook.xml", named.as_bytes()),
        ("xl/_rels/workbook.xml.rels", BOOK_RELS.as_bytes()),
        ("xl/worksheets/sheet1.xml", sheet.as_bytes()),
    ]);
    assert_eq!(warnings(&read(&named)).len(), 2);
}
