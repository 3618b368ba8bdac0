//! What is read: samples, encodings, BEGIN lines, ends.

use super::*;

fn read_sample(name: &str) -> (DeviationTable, Vec<String>) {
    let (table, warnings) = read_table(&sample(name), name, name, false).unwrap();
    (table.unwrap(), warnings.iter().map(ToString::to_string).collect())
}

/// Values of `tests/data/samples/README.md`.
#[test]
fn the_sample_tables_are_read_to_the_values_of_their_list() {
    let (plain, warnings) = read_sample("generation1_plain.tab");
    assert_eq!(warnings, [""; 0]);
    assert_eq!((plain.name(), plain.columns().len(), plain.ends().len()), ("generation1_plain.tab", 4, 5));
    check_cell(&plain, "10 JS7", "7.5", "-7.5");
    check_cell(&plain, "6 N7", "-4", "-16");
    check_cell(&plain, "30 U1", "12", "5");
    let own = plain.columns().iter().find(|column| column.class.as_str() == "U1").unwrap();
    let defined: Vec<bool> = own.cells.iter().map(Option::is_some).collect();
    assert_eq!(defined, [false, true, true, false, true]);

    let (structure, warnings) = read_sample("generation2_struct.tab");
    assert_eq!(warnings, [""; 0]);
    check_cell(&structure, "18 p6", "29", "18");

    let (description, warnings) = read_sample("generation3_description.tab");
    assert_eq!(warnings, [""; 0]);
    check_cell(&description, "30 K7", "6", "-15");

    let (comma, warnings) = read_sample("decimal_comma_latin1_crlf.tab");
    let [skipped] = warnings.as_slice() else { panic!("{warnings:?}") };
    assert!(skipped.starts_with("column REMARK was skipped, because it holds texts and no deviations"), "{skipped}");
    assert_eq!(comma.columns().len(), 2, "REMARK holds no deviations");
    check_cell(&comma, "10 JS7", "7.5", "-7.5");
    check_cell(&comma, "30 JS7", "10.5", "-10.5");

    let (alias, warnings) = read_sample("alias_bereik_no_end.tab");
    assert_eq!(
        warnings,
        [
            "[END] is missing: alias_bereik_no_end.tab, line 12, column 1",
            "BEREIK was read as BEREICH: alias_bereik_no_end.tab, line 2, column 9",
        ]
    );
    check_cell(&alias, "18 H7", "18", "0");
}

#[test]
fn the_parts_of_a_table_are_kept() {
    let read = |name: &str| ControlTable::read(&sample(name), name).unwrap().table;
    let plain = read("generation1_plain.tab");
    assert_eq!((plain.name.as_str(), plain.suffix.as_deref(), plain.unit), ("fit_hole_g1", Some("tab"), None));
    assert_eq!(plain.comments[0].text, " small hole table for parser tests, deviations in micrometres");
    assert_eq!(plain.columns.iter().map(|column| column.width).collect::<Vec<_>>(), [8, 8, 7, 7, 7, 7]);
    let description = read("generation3_description.tab");
    assert_eq!(description.unit, Some(TableUnit::Millimetre));
    assert_eq!(description.version.as_deref(), Some("Update:110.24"));
    assert_eq!(description.properties, [("primaryKey".to_owned(), "\"NR\"".to_owned())]);
    assert_eq!(description.columns[0].kind.as_deref(), Some("INT"));
    assert_eq!(description.columns[0].settings[0], ("initial".to_owned(), "\"+0\"".to_owned()));
    let comma = read("decimal_comma_latin1_crlf.tab");
    assert_eq!(comma.columns[1].settings[1].1, "Maßbereich bis einschließlich?");
    assert_eq!(comma.rows[1][4], "untere Größe");
    let probes = read("tchprobe.tp");
    assert_eq!((probes.suffix.as_deref(), probes.rows.len()), (Some("TP"), 2));
    assert_eq!(probes.rows[1][probes.column("F_PREPOS").unwrap()], "FMAX_MACHINE");
}

#[track_caller]
fn check_begin(line: &str, expected: &str) {
    let text = format!("{line}\nA B\n1 2\n[END]\n");
    let said = match ControlTable::read(text.as_bytes(), "x.tab") {
        Ok(TableFile { table, .. }) => format!(
            "{} {} {} {} {}",
            table.name,
            table.suffix.as_deref().unwrap_or("-"),
            table.unit.map_or("-".to_owned(), |unit| format!("{unit:?}")),
            table.version.as_deref().unwrap_or("-"),
            table.mark.as_deref().unwrap_or("-"),
        ),
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected, "for {line:?}");
}

/// The forms of `docs/SOURCES.md`.
#[test]
fn every_seen_form_of_the_begin_line_is_read() {
    check_begin("BEGIN 8150-1-en.tab", "8150-1-en tab - - -");
    check_begin("BEGIN CCMT.CUT MM", "CCMT CUT Millimetre - -");
    check_begin("BEGIN TOOL.T INCH", "TOOL T Inch - -");
    check_begin(
        "BEGIN TOOL.T MM Version: 'Update:120.17 Date:2004-08-01'",
        "TOOL T Millimetre Update:120.17 Date:2004-08-01 -",
    );
    check_begin("BEGIN TOOL.T MM VERSION: 'Update:1.2' U", "TOOL T Millimetre Update:1.2 U");
    check_begin("BEGIN TOOL.T MM U", "TOOL T Millimetre - U");
    check_begin("BEGIN Test.AFC.TAB MM", "Test.AFC TAB Millimetre - -");
    check_begin("BEGIN SIMTOOLT_M MM", "SIMTOOLT_M - Millimetre - -");
    check_begin("BEGIN FRAES_GB.CDT ", "FRAES_GB CDT - - -");
    check_begin("BEGIN pal2sp .p ", "pal2sp p - - -");
    check_begin("BEGIN", "the name of the table is missing after BEGIN: x.tab, line 1, column 6");
    check_begin("BEGIN x.tab Version: 'a", "a quotation mark is not closed: x.tab, line 1, column 24");
    check_begin("BEGIN x.tab Version: a", "expected ', found a: x.tab, line 1, column 1");
    check_begin(
        "BEGINNING x.tab",
        "a table begins with BEGIN and its name, not with BEGINNING x.tab: x.tab, line 1, column 1",
    );
}

#[test]
fn a_table_is_the_same_whatever_its_encoding_and_line_ends() {
    let read = |bytes: &[u8]| ControlTable::read(bytes, "own.tab").unwrap();
    let german = SOUND.replace("BEGIN own.tab\n", "BEGIN own.tab\n; Größe\n");
    let sound = read(german.as_bytes());
    for end in ["\r\n", "\r", "\0"] {
        assert_eq!(read(german.replace('\n', end).as_bytes()), sound, "{end:?}");
    }
    let mut marked = b"\xef\xbb\xbf".to_vec();
    marked.extend(german.as_bytes());
    assert_eq!(read(&marked), sound);
    let latin: Vec<u8> = german.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    assert_eq!(read(&latin), sound);
    let (comma, _) = read_table(SOUND.replace("+12 ", "+12,50").as_bytes(), "own.tab", "own.tab", false).unwrap();
    check_cell(&comma.unwrap(), "6 H7", "12.5", "0");
}

#[test]
fn comments_blank_lines_and_a_bare_end_are_no_rows() {
    check(&SOUND.replace("2   6", ";2   5       +99    x\n\n   \n2   6"), &[]);
    check(&SOUND.replace("[END]", "END"), &[]);
    check(&SOUND.replace("[END]\n", "[END]\n\n  \n"), &[]);
}

#[test]
fn a_missing_end_is_a_warning() {
    check(&SOUND.replace("[END]\n", ""), &["[END] is missing: own.tab, line 6, column 1"]);
    // A blank after the last cell: the cell is also whole.
    let padded = SOUND.replace("+8\n", "+8     \n").replace("+3\n", "+3     \n").replace("-\n", "-      \n");
    check(padded.trim_end_matches("\n[END]\n"), &["[END] is missing: own.tab, line 6, column 1"]);
    let unpadded = SOUND.trim_end_matches("\n[END]\n");
    check(
        unpadded,
        &["! the file ends within this row and without [END]: it may be cut off: own.tab, line 6, column 1"],
    );
}
