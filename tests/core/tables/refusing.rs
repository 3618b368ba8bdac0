//! What is refused or warned about, each with its own text and place.

use super::*;

#[test]
fn empty_files_and_other_files_are_refused() {
    check("", &["! the file is empty: own.tab, line 1, column 1"]);
    check(" \r\n\0\n", &["! the file is empty: own.tab, line 1, column 1"]);
    check_bytes(b"\xef\xbb\xbf", &["! the file is empty: own.tab, line 1, column 1"]);
    check_bytes(
        b"\x7fELF\x02\x01\x01",
        &["! character U+007F is not text: the file is not a table or is damaged: own.tab, line 1, column 1"],
    );
    check_bytes(
        b"\x89PNG\r\n\x1a\n",
        &["! a table begins with BEGIN and its name, not with \u{2030}PNG: own.tab, line 1, column 1"],
    );
    check(
        "id;callout;measured\n",
        &["! a table begins with BEGIN and its name, not with id;callout;measured: own.tab, line 1, column 1"],
    );
    check(
        &SOUND.replace("+12", "+\u{1}2"),
        &["! character U+0001 is not text: the file is not a table or is damaged: own.tab, line 5, column 14"],
    );
    check("BEGIN x.tab\n", &["! the line with the names of the columns is missing: own.tab, line 2, column 1"]);
    check("BEGIN x.tab\n[END]\n", &["! the line with the names of the columns is missing: own.tab, line 2, column 1"]);
}

#[test]
fn a_truncated_table_is_refused() {
    // Cut within +12, which would read as +1.
    check(
        &SOUND[..SOUND.find("+12").unwrap() + 2],
        &["! the row ends before column U1: fill it with spaces, or write - for no value: own.tab, line 5, column 15"],
    );
    // Cut within the last column: +25 would read as +2.
    let long = SOUND.replace("-\n3  ", "+25\n3  ");
    check(
        &long[..long.find("+25").unwrap() + 2],
        &["! the file ends within this row and without [END]: it may be cut off: own.tab, line 5, column 1"],
    );
    // Cut between two rows of a pair.
    check(
        &SOUND[..SOUND.find("3           +0     -").unwrap()],
        &[
            "! the number of rows is odd (3): each size range takes two, first the upper deviation, then the lower deviation: own.tab, line 5, column 1",
        ],
    );
    check(
        "BEGIN x.tab\n#STRUCTBEGIN\n  NAME = H7\n",
        &["! the block #STRUCTBEGIN of line 2 is not closed: own.tab, line 3, column 1"],
    );
    check(
        "BEGIN x.tab\nTableDescription (\n columns:= [\n",
        &["! the block TableDescription of line 2 is not closed: own.tab, line 3, column 1"],
    );
}

#[test]
fn broken_rows_and_columns_are_refused() {
    check(&SOUND.replace("U1", "H7"), &["! column H7 occurs twice: own.tab, line 2, column 20"]);
    check(
        &SOUND.replace("2   6       +12    -", "2   6       +12"),
        &["! the row ends before column U1: fill it with spaces, or write - for no value: own.tab, line 5, column 16"],
    );
    check(&SOUND.replace("+12", "+1x"), &["! column H7: +1x is not a number: own.tab, line 5, column 13"]);
    check(&SOUND.replace("+12 ", "12mm"), &["! column H7: 12mm is not a number: own.tab, line 5, column 13"]);
    check(
        &SOUND.replace("+12    ", "1.234,5"),
        &["! column H7 and its neighbour run into each other: separate them with a space: own.tab, line 5, column 13"],
    );
    check(
        &SOUND.replace("+12    ", "1.23,5 "),
        &[
            "! column H7: 1.23,5 is ambiguous: write one decimal sign and no thousands separator: own.tab, line 5, column 13",
        ],
    );
    check(
        &SOUND.replace("+12    ", "0.0005 "),
        &["! column H7: 0.0005 is finer than a nanometre: own.tab, line 5, column 13"],
    );
    check(&SOUND.replace("   6   ", "   six "), &["! column BEREICH: six is not a number: own.tab, line 5, column 5"]);
    check(
        &SOUND.replace("2   6", "2\t6"),
        &["! tab character: separate columns with spaces only: own.tab, line 5, column 2"],
    );
    check(&SOUND.replace("[END]", "[END]\n4   10"), &["! text after [END]: 4   10: own.tab, line 8, column 1"]);
    // One place too far to the left: the sign would be lost and -5 read as 5.
    check(
        &SOUND.replace("+0     +3", "+0    -5 "),
        &["! column H7 and its neighbour run into each other: separate them with a space: own.tab, line 4, column 13"],
    );
}

#[test]
fn broken_ranges_and_pairs_are_refused() {
    check(
        &SOUND.replace("2   6", "2   3"),
        &["! size range up to 3 mm does not end above the one before it, 3 mm: own.tab, line 5, column 5"],
    );
    check(
        &SOUND.replace("0   3", "0   0"),
        &["! size range up to 0 mm does not end above the one before it, 0 mm: own.tab, line 3, column 5"],
    );
    check(&SOUND.replace("2   6", "2    "), &["! the end of the size range is missing: own.tab, line 5, column 5"]);
    check(
        &SOUND.replace("3           +0     -", "3   5       +0     -"),
        &[
            "! the size range up to 6 mm has 5 in its second row: repeat it or leave it blank: own.tab, line 6, column 5",
        ],
    );
    check(&SOUND.replace("3           +0     -", "3   6       +0     -"), &[]);
    check(
        &SOUND.replace("+3\n", "  \n"),
        &["! column U1 has only one of the two deviations for the size range up to 3 mm: own.tab, line 4, column 20"],
    );
    check(
        &SOUND.replace("+12    -", "+12    -1"),
        &["! column U1 has only one of the two deviations for the size range up to 6 mm: own.tab, line 6, column 20"],
    );
    check(
        &SOUND.replace("+3\n", "+9\n"),
        &["! column U1: upper deviation 0.008 mm is below lower deviation 0.009 mm: own.tab, line 4, column 20"],
    );
    check("BEGIN x.tab\nNR BEREICH H7\n[END]\n", &["! the table has no size range: own.tab, line 2, column 4"]);
    check(
        &SOUND.replace("own.tab", "own.tab INCH"),
        &[
            "! the table is in inch: write size ranges in millimetres and deviations in micrometres: own.tab, line 2, column 5",
        ],
    );
    check(
        &SOUND.replace("U1", "BEREIK"),
        &["! the table has both BEREICH and BEREIK: only one can hold the size ranges: own.tab, line 2, column 20"],
    );
    check(
        &SOUND.replace("H7", "H_").replace("U1", "U_"),
        &["! no column is a tolerance class such as H7: own.tab, line 2, column 5"],
    );
}

#[test]
fn other_columns_are_left_alone() {
    // Names that no class has; TNC7 and others allow more than letters and digits in them.
    let skipped =
        "was skipped, because its name cannot be that of a tolerance class: a table written from this one lacks it";
    for name in ["P_F", "MM", "M", "PRODUCTION"] {
        check(&SOUND.replace("U1", name), &[&format!("column {name} {skipped}: own.tab, line 2, column 20")]);
    }
    check(&SOUND.replace("U1", "P_F").replace("+8\n", "-\n").replace("+3\n", "-\n"), &[]);
    let texts = "was skipped, because it holds texts and no deviations: a table written from this one lacks it";
    for name in ["U1", "NOTE"] {
        let text = SOUND.replace("U1", name).replace("+8\n", "ab\n").replace("+3\n", "cd\n");
        check(&text, &[&format!("column {name} {texts}: own.tab, line 2, column 20")]);
    }
    for name in ["Js7", "Pf"] {
        let mixed = "was skipped, because a tolerance class does not mix upper and lower case: a table written from this one lacks it";
        check(&SOUND.replace("U1", name), &[&format!("column {name} {mixed}: own.tab, line 2, column 20")]);
    }
    check(&SOUND.replace("BEREICH", "RANGE  "), &["skipped, not a table of deviations (no column BEREICH): own.tab"]);
    let both = SOUND.replace("U1", "h7");
    let (table, _) = read_table(both.as_bytes(), "own.tab", "own.tab", false).unwrap();
    let tables = fitcheck::tolerance::Sources::of_tables(vec![table.unwrap()]);
    assert_eq!((tables.classes(Feature::Hole).len(), tables.classes(Feature::Shaft).len()), (1, 1));
}

/// An own column as NC-Solution 8255 allows them, by the rules of every class.
#[test]
fn own_columns_are_read_like_classes() {
    for name in ["PF", "pf", "P", "U1Z1", "PRODUKT1"] {
        let own = SOUND.replace("U1", name);
        check(&own, &[]);
        check_cell(
            &read_table(own.as_bytes(), "own.tab", "x", false).unwrap().0.unwrap(),
            &format!("2 {name}"),
            "8",
            "3",
        );
    }
    // Some numbers and some texts: an error with its place, as in every column of deviations.
    check(
        &SOUND.replace("U1", "PF").replace("+3\n", "ab\n"),
        &["! column PF: ab is not a number: own.tab, line 4, column 20"],
    );
    check(
        &SOUND.replace("U1", "PF").replace("+3\n", "+9\n"),
        &["! column PF: upper deviation 0.008 mm is below lower deviation 0.009 mm: own.tab, line 4, column 20"],
    );
    // What a block calls a text is a remark, whatever stands in it; a column with a grade is a class all the same.
    let described = |name: &str| {
        let block = format!(
            "#STRUCTBEGIN\nNAME = BEREICH\nTYPE = N\nNAME = H7\nTYPE = N\nNAME = {name}\nTYPE = C\n#STRUCTEND\nNR  BER"
        );
        SOUND.replace("U1", name).replace("NR  BER", &block)
    };
    let texts = "was skipped, because it holds texts and no deviations: a table written from this one lacks it";
    check(&described("DOC"), &[&format!("column DOC {texts}: own.tab, line 10, column 20")]);
    check(&described("U1"), &[]);
    // A column without a value is kept.
    let empty = SOUND.replace("U1", "PF").replace("+8\n", "-\n").replace("+3\n", "-\n");
    let table = read_table(empty.as_bytes(), "own.tab", "own.tab", false).unwrap().0.unwrap();
    assert_eq!(table.columns().len(), 2);
}

#[test]
fn blocks_are_checked_against_the_line_of_names() {
    let structure = |block: &str| SOUND.replace("NR  BER", &format!("#STRUCTBEGIN\n{block}#STRUCTEND\nNR  BER"));
    let names = "NAME = BEREICH\nWIDTH = 3\nNAME = H7\nWIDTH = 6\nNAME = U1\nWIDTH = 6\n";
    check(&structure(names), &[]);
    check(
        &structure(&names.replace("H7\nWIDTH = 6", "H7\nWIDTH = 5")),
        &[
            "column H7 is 7 characters wide here but 6 in the description; the line of column names applies: own.tab, line 10, column 13",
        ],
    );
    check(
        &structure("NAME = BEREICH\nNAME = H7\nNAME = H8\n"),
        &[
            "column U1 is not described: own.tab, line 7, column 20",
            "column H8 is described but not in the table: own.tab, line 7, column 1",
        ],
    );
    check(
        &structure("NAME = H7\n  WIDTH = six\n"),
        &["! WIDTH must be a whole number up to 10000, not six: own.tab, line 4, column 3"],
    );
    check(&structure("NAME = H7\nNAME = H7\n"), &["! column H7 occurs twice: own.tab, line 4, column 1"]);
    check(&structure("NAME\n"), &["! expected =, found NAME: own.tab, line 3, column 1"]);
    check(&structure("TYPE = N\n"), &["! expected NAME =, found TYPE = N: own.tab, line 3, column 1"]);
    check(
        &SOUND.replace("NR  BER", "#STRUCTBEGIN\n#STRUCTEND\nTableDescription (\n)\nNR  BER"),
        &["! the columns are described a second time: own.tab, line 4, column 1"],
    );
    let description = |block: &str| SOUND.replace("NR  BER", &format!("TableDescription ({block}\n)\nNR  BER"));
    let h7 = "CfgColumnDescription (key:=\"H7\", width:=7, unit:=FLOAT)";
    check(
        &description(&format!(" columns:=[ {h7}, CfgTableProperties ( a:=[ 1 ] ) ]")),
        &[
            "CfgTableProperties is unknown and was skipped: own.tab, line 2, column 108",
            "column BEREICH is not described: own.tab, line 4, column 5",
            "column U1 is not described: own.tab, line 4, column 20",
        ],
    );
    check(&description(" columns:= 7"), &["! expected [, found 7: own.tab, line 2, column 30"]);
    check(&description(" a:=\"7"), &["! a quotation mark is not closed: own.tab, line 2, column 23"]);
    check(&description(" a=7"), &["! expected :=, found =7: own.tab, line 2, column 21"]);
    check(&description(&" [".repeat(1000)), &["! expected ), found [: own.tab, line 2, column 20"]);
}

#[test]
fn large_files_are_refused_before_they_fill_the_memory() {
    let rows = "BEGIN x.tab\nA B\n".to_owned() + &"1 2\n".repeat(600_000);
    check(&rows, &["! the table has more than 1000000 cells: own.tab, line 500002, column 1"]);
    let comments = "BEGIN x.tab\nA B\n".to_owned() + &";\n".repeat(1_100_000);
    check(&comments, &["! the table has more than 1000000 cells: own.tab, line 1000001, column 1"]);
    let columns = (0..1001).map(|number| format!("C{number}")).collect::<Vec<_>>().join(" ");
    check(&format!("BEGIN x.tab\n{columns}\n"), &["! the table has more than 1000 columns: own.tab, line 2, column 1"]);
    check(
        &format!("BEGIN x.tab\n{}\n", "A".repeat(65_537)),
        &["! the line is longer than 65536 bytes: own.tab, line 2, column 1"],
    );
}

#[test]
fn a_folder_is_read_by_name_and_every_message_names_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let said = || match read_tables(folder.path()) {
        Ok(own) => {
            let sizes = |table: &DeviationTable| (table.columns().len(), table.ends().len());
            let tables = own.tables.iter().map(|table| format!("{} {:?}", table.name(), sizes(table)));
            tables.chain(own.warnings.iter().map(ToString::to_string)).collect::<Vec<_>>()
        }
        Err(error) => vec![error.to_string()],
    };
    let shown = |name: &str| at(name).display().to_string();
    let none =
        format!("no table of deviations (*.tab with a column BEREICH) in this folder: {}", folder.path().display());
    assert_eq!(said(), [none.as_str()]);
    std::fs::write(at("tool.tab"), "BEGIN TOOL.TAB MM\nT NAME\n1 DRILL\n[END]\n").unwrap();
    assert_eq!(said(), [none.as_str()]);
    std::fs::write(at("b.TAB"), SOUND).unwrap();
    std::fs::write(at("a.tab"), SOUND.replace("[END]\n", "")).unwrap();
    std::fs::write(at("notes.txt"), "not a table").unwrap();
    std::fs::create_dir(at("folder.tab")).unwrap();
    assert_eq!(
        said(),
        [
            "a.tab (2, 2)".to_owned(),
            "b.TAB (2, 2)".to_owned(),
            format!("[END] is missing: {}, line 6, column 1", shown("a.tab")),
            format!("skipped, not a table of deviations (no column BEREICH): {}", shown("tool.tab")),
        ]
    );
    std::fs::write(at("c.tab"), SOUND.replace("+12", "x12")).unwrap();
    assert_eq!(said(), [format!("column H7: x12 is not a number: {}, line 5, column 13", shown("c.tab"))]);
    let missing = read_tables(&at("none")).unwrap_err().to_string();
    assert_eq!(missing, format!("no such file or folder: {}", shown("none")));
}
