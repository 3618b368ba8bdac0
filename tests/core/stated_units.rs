//! What a file states about units is read or refused, by every reader alike: 1.0009 in is no millimetre. Limits by hand: 1 in H7 is 25.400
//! to 25.421, and 1.0009 in is 25.42286; 1 H7 is 1.000 to 1.010; 25 H7 is 25.000 to 25.021.

use std::io::{Cursor, Write as _};

use assert_cmd::Command;
use fitcheck::batch::{Input, Manner, Packing, Watch, run};
use fitcheck::exchange::batch::{Csv, Cutter, JsonLines, Layout, StreamJudging};
use fitcheck::exchange::{ImportInputs, Item, Mapping, contacts, import, import_from, sizes};
use fitcheck::tolerance::{Feature, Sources};

const NOW: jiff::civil::DateTime = jiff::civil::date(2026, 1, 1).at(0, 0, 0, 0);

/// The words of verdicts, or that nothing was judged.
fn imported(name: &str, bytes: &[u8]) -> (Vec<String>, Vec<String>) {
    let imported = import(name, bytes, &Sources::default(), NOW);
    let errors: Vec<String> = imported.errors.iter().map(ToString::to_string).collect();
    (imported.records.iter().map(|record| record.verdict.size.status.word().to_owned()).collect(), errors)
}

/// The same by `batch`, as CSV and as JSON.
fn judged(text: &str) -> (Vec<String>, Vec<String>) {
    let layout = match Layout::of(text.as_bytes(), true, "a.csv") {
        Ok(layout) => layout,
        Err(error) => return (Vec::new(), vec![error.to_string()]),
    };
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    let manner = Manner { workers: 1, packing: Packing::Plain, prefix: "" };
    let input = |stream| Input { stream, cutter: Cutter::new(layout.separator(), 1 << 20, true) };
    let (mut csv, mut json) = (Csv::header(&layout, ""), Vec::new());
    let mut rest = &text.as_bytes()[layout.skip..];
    run::<Csv>(input(&mut rest), &court, manner, &mut csv, &Watch::default(), &mut |_| {}).unwrap();
    let mut rest = &text.as_bytes()[layout.skip..];
    run::<JsonLines>(input(&mut rest), &court, manner, &mut json, &Watch::default(), &mut |_| {}).unwrap();
    let words = ["GOOD", "REWORK", "SCRAP", "RE-MEASURE"];
    let csv = String::from_utf8(csv).unwrap();
    let separator = char::from(layout.separator());
    let status = |line: &str| line.split(separator).map(str::to_owned).find(|cell| words.contains(&cell.as_str()));
    let statuses: Vec<String> = csv.lines().filter_map(status).collect();
    let json: Vec<serde_json::Value> =
        String::from_utf8(json).unwrap().lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let of_json: Vec<String> = json.iter().filter_map(|row| row["status"].as_str().map(str::to_owned)).collect();
    assert_eq!(statuses, of_json, "{text}");
    let errors = json.iter().filter_map(|row| row["error"].as_str().map(str::to_owned)).collect();
    (statuses, errors)
}

/// A workbook with a sheet of these rows: numbers as such, with a style, and texts.
fn book(rows: &[Vec<&str>], format: Option<&str>) -> Vec<u8> {
    let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let mut sheet = String::from("<worksheet><sheetData>");
    for row in rows {
        sheet.push_str("<row>");
        for cell in row {
            let cell = match cell.parse::<f64>() {
                Ok(_) => format!("<c s=\"1\"><v>{cell}</v></c>"),
                Err(_) => format!("<c t=\"inlineStr\"><is><t>{}</t></is></c>", escaped(cell)),
            };
            sheet.push_str(&cell);
        }
        sheet.push_str("</row>");
    }
    sheet += "</sheetData></worksheet>";
    let format = escaped(format.unwrap_or("General"));
    let styles = format!(
        "<styleSheet xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\"><numFmts count=\"1\"><numFmt numFmtId=\"170\" formatCode=\"{format}\"/></numFmts><cellXfs count=\"2\"><xf numFmtId=\"0\"/><xf numFmtId=\"170\"/></cellXfs></styleSheet>"
    );
    let members = [
        (
            "_rels/.rels",
            r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>"#,
        ),
        (
            "xl/workbook.xml",
            r#"<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets><sheet name="S" sheetId="1" r:id="rId1"/></sheets></workbook>"#,
        ),
        (
            "xl/_rels/workbook.xml.rels",
            r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/><Relationship Id="rId2" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/styles" Target="styles.xml"/></Relationships>"#,
        ),
        ("xl/worksheets/sheet1.xml", sheet.as_str()),
        ("xl/styles.xml", styles.as_str()),
    ];
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in members {
        zip.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        zip.write_all(content.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// What every reader makes of a text with semicolons: these verdicts and no error, or an error that begins so and nothing judged.
#[track_caller]
fn check(text: &str, expected: Result<&str, &str>) {
    let tabs = text.replace(';', "\t");
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(';').collect()).collect();
    let mut wrong = Vec::new();
    for (reader, (statuses, errors)) in [
        ("import", imported("a.csv", text.as_bytes())),
        ("import of TSV", imported("a.tsv", tabs.as_bytes())),
        ("batch", judged(text)),
        ("batch of TSV", judged(&tabs)),
        ("workbook", imported("a.xlsx", &book(&rows, None))),
    ] {
        let is_right = match expected {
            Ok(expected) => statuses.join(" ") == expected && errors.is_empty(),
            Err(expected) => statuses.is_empty() && errors.first().is_some_and(|error| error.contains(expected)),
        };
        if !is_right {
            wrong.push(format!("{reader}: {statuses:?} {errors:?}"));
        }
    }
    assert!(wrong.is_empty(), "{text}\nexpected {expected:?}\n{}", wrong.join("\n"));
    // Whoever takes measured sizes alone reads the same unit or refuses.
    let alone = sizes("a.csv", text.as_bytes(), Feature::Hole);
    if let Some(size) = alone.measured.first().filter(|_| text.contains("1.0009")) {
        let right = if expected.is_ok_and(|words| words.starts_with("GOOD")) { "1.0009" } else { "25.42286" };
        assert_eq!(size.measured.to_string(), right, "{text}");
    }
}

const ROWS: &str = "id;nominal;class;measured\nA;1;H7;1.0009\n";

#[test]
fn what_stands_above_the_header_or_behind_it_in_inches_is_never_good_as_millimetres() {
    for line in [
        "# unit: inch",
        "#unit=inch",
        "# Units: inches",
        "Unit:;inch",
        "Unit;in",
        "units=INCH",
        "UNITS;INCH",
        "Unit of measure;inch",
        "Measurement unit: Inch",
        "UoM;IN",
        "Einheit;Zoll",
        "Einheit: Zoll",
        "Maßeinheit;inch",
        "Eenheid;duim",
        "Meeteenheid: inch",
        "Unità;pollici",
        "Unità di misura: pollici",
        "All values in inch",
        "All dimensions are in inches",
        "# all values in inches",
        "Alle Werte in Zoll",
        "Maße in Zoll",
        "Alle maten in duim",
        "Alle waarden in inch.",
        "Tutte le misure in pollici",
        "Values: inch",
        "inch",
        "[inch]",
        "(inches)",
        "Measured values [inch]",
        "Report of 2026-07-10;;Units;inch",
        "values in in",
    ] {
        let title = format!("{line}\n{ROWS}");
        check(&title, Ok("SCRAP"));
        // Behind the rows it contradicts what they were read by; `# unit: inch` of the case is above.
        check(&format!("{ROWS}{line}\n"), Err("the rows above it are read in mm"));
    }
}

#[test]
fn a_unit_that_is_not_read_or_not_clear_is_refused() {
    for line in
        ["# unit: cm", "All values in cm", "Unit;m", "Einheit;mil", "Units: thou", "Unit: furlong", "Unit: 0.001 mm"]
    {
        check(&format!("{line}\n{ROWS}"), Err("which is not supported"));
    }
    for line in ["Inch report", "values are not in inch", "Zoll"] {
        let refused =
            if line == "Zoll" { Ok("SCRAP") } else { Err("nothing says whether the values are in this unit") };
        check(&format!("{line}\n{ROWS}"), refused);
    }
    check(&format!("# unit: inch\nMaße in mm\n{ROWS}"), Err("correct one of them"));
    check("# unit: inch\nid;nominal;class;measured [mm]\nA;1;H7;1.0009\n", Err("correct one of them"));
    check("id;nominal [inch];class;measured\nA;1;H7;1.0009\n", Err("does not say its unit"));
    check("id;nominal;class;measured [inch]\nA;1;H7;1.0009\n", Err("does not say its unit"));
    check("id;callout;measured;deviation [inch]\nA;1 H7;1.0009;0.0009\n", Err("does not say its unit"));
}

#[test]
fn a_word_that_is_also_a_name_is_no_unit_of_its_row_and_none_of_a_title() {
    // 25 N7 is 24.972 to 24.993: in inches it would be GOOD.
    for (header, rows) in [
        ("id;nominal;class;measured;Supplier\n", "A;25;N7;24.997;Zoll\nB;25;N7;24.996;Zoll\n"),
        ("id;nominal;class;measured;Country\n", "A;25;N7;24.997;IN\nB;25;N7;24.996;IN\n"),
        ("", "A;25;N7;24.997;IN\nB;25;N7;24.996;IN\n"),
    ] {
        check(&format!("{header}{rows}"), Err("nothing says whether the values are in this unit"));
    }
    check("id;nominal;class;measured;Remark\nA;25;H7;25.010;Zoll\nB;25;H7;25.030;\n", Ok("GOOD SCRAP"));
    check("id;callout;measured;Shift\nA;25 H7;25.010;M\nB;25 H7;25.030;A\n", Ok("GOOD SCRAP"));
    check("Unit;callout;measured\n001;25 H7;25.010\n002;25 H7;25.030\n", Ok("GOOD SCRAP"));
    for line in ["# Allgemeintoleranz: m", "# Shift: M", "# Country: IN"] {
        check(&format!("{line}\nid;callout;measured\nA;25 H7;25.010\n"), Ok("GOOD"));
    }
}

#[test]
fn a_title_with_two_units_or_none_of_them_is_refused() {
    for line in [
        "# Werte nicht in mm sondern in Zoll",
        "# values are not in mm but in inch",
        "# Wellen in mm - Bohrungen in Zoll",
        "All dimensions in mm except diameters which are in inch",
        "# all sizes in mm or inch",
        "# Werte in 1/1000 mm",
    ] {
        check(&format!("{line}\n{ROWS}"), Err("nothing says whether the values are in this unit"));
    }
}

#[test]
fn a_row_without_its_value_is_no_row_of_units() {
    let (statuses, errors) = imported("a.csv", b"name;callout;measured;dir\nB;25 H7;;mm\nA;25 H7;25.01;\n");
    assert!(statuses.is_empty() && errors.len() == 2, "{statuses:?} {errors:?}");
    let rows = "name;callout;measured;unit\nA;25 H7;25.01;mm\nB;H7;0.5;inch\nC;;;mm\n";
    let (statuses, errors) = imported("a.csv", rows.as_bytes());
    assert!(statuses == ["GOOD"] && errors.len() == 2, "{statuses:?} {errors:?}");
}

#[test]
fn what_is_in_millimetres_or_says_nothing_of_lengths_is_read_as_before() {
    for line in [
        "Maße in mm",
        "# unit: mm",
        "Unit;metric",
        "Temperature;20.1 C;Probe;3 mm",
        "Temperature;20.1 C",
        "Temperature unit;°C",
        "Unit;°C",
        "Tip [mm];3",
        "Zoll;12345",
        "Part Name;Plate 4711;Drawing;D-200",
        "in the machine",
    ] {
        check(&format!("{line}\n{ROWS}"), Ok("GOOD"));
        check(&format!("{line}\nid;nominal;class;measured [mm]\nA;1;H7;1.0009\n"), Ok("GOOD"));
    }
    check("id;nominal;class;measured;temperature;unit\nA;1;H7;1.0009;20.1;°C\n", Ok("GOOD"));
    check("id;nominal;class;measured;temperature [°C]\nA;1;H7;1.0009;20.1\n", Ok("GOOD"));
    check("# all in µm\nid;nominal;class;measured\nA;25000;H7;25012\nB;25000;H7;25030\n", Ok("GOOD SCRAP"));
}

#[test]
fn a_column_of_units_states_that_of_its_row() {
    for name in [
        "unit",
        "Units",
        "UoM",
        "Unit of measure",
        "unit of measurement",
        "Einheit",
        "Maßeinheit",
        "eenheid",
        "meeteenheid",
        "unità",
        "unità di misura",
        "measured unit",
        "EH",
        "-",
    ] {
        for unit in ["inch", "in", "IN", "Inches", "Zoll", "duim", "pollici"] {
            // Below a name that says nothing, a word that may be another name is asked about.
            let is_clear = name != "-" || !["in", "IN", "Zoll"].contains(&unit);
            let expected = if is_clear { Ok("SCRAP") } else { Err("nothing says whether the values are in this unit") };
            check(&format!("id;nominal;class;measured;{name}\nA;1;H7;1.0009;{unit}\n"), expected);
        }
        check(&format!("id;nominal;class;measured;{name}\nA;1;H7;1.0009;mm\nB;1;H7;1.0009;inch\n"), Ok("GOOD SCRAP"));
        check(&format!("id;nominal;class;measured;{name}\nA;1;H7;1.0009;cm\n"), Err("unknown unit cm"));
    }
    check("id;callout;measured;unit\nA;25 H7;25012;µm\nB;25 H7;25.030;mm\n", Ok("GOOD SCRAP"));
    check("id;nominal;class;measured;unit\nA;1;H7;1.0009;\n", Err("the unit of this row is missing"));
    check("id;nominal;class;measured;unit\nA;1;H7;1.0009;furlong\n", Err("unknown unit furlong"));
    check("id;nominal;class;measured;unit\nA;1;H7;1.0009;°C\nB;1;H7;;mm\n", Err("unknown unit °C"));
    check("id;nominal;class;measured [mm];unit\nA;1;H7;1.0009;inch\n", Err("correct one of them"));
    check("# unit: mm\nid;nominal;class;measured;unit\nA;1;H7;1.0009;inch\n", Err("correct one of them"));
    check("id;nominal;unit;class;measured;unit\nA;1;mm;H7;1.0009;inch\n", Err("correct one of them"));
    check("id;nominal;class;measured;unit\nA;1;H7;1.0009 mm;inch\n", Err("correct one of them"));
    // A callout with a size is in mm by its nature.
    check("id;callout;measured;unit\nA;1 H7;1.0009;inch\n", Err("the row is in inch"));
    check("# unit: inch\nid;callout;measured\nA;25.4 H7;1.0009\n", Err("the row is in inch"));
    // Without a header.
    check("A;1;H7;1.0009;inch\nB;1;H7;1.0009;inch\n", Ok("SCRAP SCRAP"));
}

#[test]
fn a_row_of_units_below_the_header_gives_the_unit_of_each_column() {
    let text = |units: &str| format!("Feature;Callout;Measured\n{units}\nA1;25 H7;25012\nA2;25 H7;25030\n");
    for units in [";;µm", ";;[µm]", ";;(um)", "-;-;µm", "text;;µm", ";mm;µm"] {
        check(&text(units), Ok("GOOD SCRAP"));
    }
    check(&text(";;cm"), Err("unknown unit cm"));
    check(&text(";;inch").replace("25012", "0.9847").replace("25030", "0.9855"), Ok("GOOD SCRAP"));
    check("id;nominal;class;measured\n;inch;;inch\nA;1;H7;1.0009\n", Ok("SCRAP"));
    check("id;nominal;class;measured\n;inch;;\nA;1;H7;1.0009\n", Err("does not say its unit"));
    check("id;nominal;class;measured [mm]\n;mm;;inch\nA;1;H7;1.0009\n", Err("correct one of them"));
    check("p;q;r;s\n;;;inch\nA;x;25.4 H7;1.0009\n", Ok("SCRAP"));
}

#[test]
fn a_unit_behind_a_value_counts_or_is_refused() {
    check("id;callout;measured\nA;25 H7;25.012 mm\nB;25 H7;25030 µm\n", Ok("GOOD SCRAP"));
    for unit in ["in", "inch"] {
        check(&format!("id;callout;measured\nA;25 H7;0.9847 {unit}\n"), Ok("GOOD"));
        check(&format!("id;callout;measured\nA;25 H7;0,98523 {unit}\n"), Ok("SCRAP"));
    }
    for unit in ["cm", "thou"] {
        check(&format!("id;callout;measured\nA;25 H7;0.9847 {unit}\n"), Err("is not a number"));
    }
}

#[test]
fn number_formats_of_a_workbook_state_a_unit() {
    let rows = |measured| vec![vec!["id", "callout", "measured"], vec!["A", "25 H7", measured]];
    for format in [
        "General\" in\"",
        "0.000\" in\"",
        "0.0000\\ \"in\"",
        "[$in]\u{a0}0.0000",
        "#,##0.0000\\\"",
        "#,##0.0000 [$in]",
        "0.0000 in",
        "0.0000\" inch\"",
        "0.0000\" Zoll\"",
    ] {
        // 0.9847 in is 25.01138 mm, 0.9855 in 25.0317.
        let (statuses, errors) = imported("a.xlsx", &book(&rows("0.9847"), Some(format)));
        let is_read = statuses == ["GOOD"] && errors.is_empty();
        assert!(is_read || statuses.is_empty() && !errors.is_empty(), "{format} {statuses:?} {errors:?}");
        let (statuses, _) = imported("a.xlsx", &book(&rows("25.012"), Some(format)));
        assert!(!statuses.contains(&"GOOD".to_owned()), "{format}");
    }
    let (statuses, errors) = imported("a.xlsx", &book(&rows("25012"), Some("General\" µm\"")));
    assert_eq!((statuses, errors), (vec!["GOOD".to_owned()], Vec::new()));
}

#[test]
fn a_statement_far_behind_the_first_rows_holds_for_all_of_them() {
    let many = format!("id;nominal;class;measured\n{}# all values in inch\n", "A;1;H7;1.0009\n".repeat(20_000));
    let (statuses, errors) = imported("a.csv", many.as_bytes());
    assert_eq!(statuses.len(), 0);
    assert!(errors[0].contains("line 20002 states inch"), "{errors:?}");
    // A stream was judged before its end is known: the line says so, and the exit code.
    let (_, errors) = judged(&many);
    let [error] = errors.as_slice() else { panic!("{errors:?}") };
    assert!(error.starts_with("this line states inch"), "{error}");
    let rows: Vec<Vec<&str>> =
        many.lines().take(400).chain(["All values in inch"]).map(|line| line.split(';').collect()).collect();
    let (statuses, errors) = imported("a.xlsx", &book(&rows, None));
    assert!(statuses.is_empty() && errors[0].contains("states inch"), "{errors:?}");
}

#[test]
fn a_unit_that_the_user_says_must_be_that_of_the_file() {
    let read = |mapping: &str, text: &str| {
        let (mapping, sources) = (mapping.parse::<Mapping>().unwrap(), Sources::default());
        let given = ImportInputs { mapping: Some(&mapping), ..ImportInputs::new(&sources, NOW) };
        let mut said = String::new();
        import_from("a.csv", &mut Cursor::new(text.as_bytes()), given, &mut |item| match item {
            Item::Record { record, .. } => said += record.verdict.size.status.word(),
            Item::Error(error) => said += &error.to_string(),
            _ => {}
        });
        said
    };
    let inch = format!("# unit: inch\n{ROWS}");
    assert_eq!(read("unit=inch", &inch), "SCRAP");
    assert!(
        read("unit=mm", &inch).contains("the unit chosen is mm, but the file says inch"),
        "{}",
        read("unit=mm", &inch)
    );
    assert_eq!(read("unit=inch", ROWS), "SCRAP");
    assert_eq!(read("unit=mm", &format!("Inch report\n{ROWS}")), "GOOD", "it is not clear, and the user knows");
    assert!(read("unit=mm", &format!("Unit;cm\n{ROWS}")).contains("but the file says cm"));
    let column = "id;nominal;class;measured;unit\nA;1;H7;1.0009;inch\n";
    assert!(read("unit=mm", column).contains("correct one of them"), "{}", read("unit=mm", column));
    assert_eq!(read("unit=inch", &column.replace(";inch", ";")), "SCRAP");
    assert!(read("unit=mm", "id;nominal;class;measured [inch]\nA;1;H7;1.0009\n").contains("the file says inch"));
    assert!(read("unit=mm,nominal=2,class=3,measured=4", &inch).contains("the file says inch"));
    assert_eq!(read("nominal=2,class=3,measured=4", &inch), "SCRAP");
}

#[test]
fn what_says_the_unit_is_shown_with_the_columns() {
    let from = |text: &str| Mapping::default().detect(text.as_bytes()).unwrap().unit_from;
    assert_eq!(from(&format!("# unit: inch\n{ROWS}")).as_deref(), Some("# unit: inch"));
    assert_eq!(from("id;nominal;class;measured;unit\nA;1;H7;1;inch\n").as_deref(), Some("5 (unit)"));
    assert_eq!(from("id;callout;measured [mm]\nA;1 H7;1\n").as_deref(), Some("3 (measured [mm])"));
    assert_eq!(from("id;callout;measured\n;;µm\nA;1 H7;1000\n").as_deref(), Some("µm"));
    assert_eq!(from(ROWS), None);
}

#[test]
fn a_print_of_a_control_in_inches_is_refused() {
    let read = |mask: &str, print: &str| {
        let masks = [("m.a".to_owned(), fitcheck::control::mask::Mask::read(mask.as_bytes()).unwrap().0)];
        let sources = Sources::default();
        let given = ImportInputs { masks: &masks, ..ImportInputs::new(&sources, NOW) };
        let mut said = Vec::new();
        import_from("p.txt", &mut Cursor::new(print.as_bytes()), given, &mut |item| match item {
            Item::Record { record, .. } => said.push(record.verdict.size.status.word().to_owned()),
            Item::Error(error) => said.push(error.to_string()),
            _ => {}
        });
        said
    };
    let mask = |unit: &str| format!("\"NOMINAL: %9.4F {unit}\",Q262;\n\"ACTUAL: %9.4F {unit}\",Q153;\n");
    let print = |unit: &str| format!("NOMINAL:   25.0000 {unit}\nACTUAL:   25.0120 {unit}\n");
    for unit in ["INCH", "in", "inch", "\u{2033}"] {
        let said = read(&mask(unit), &print(unit));
        assert!(said[0].contains("but the output of a control is read in mm"), "{unit} {said:?}");
    }
    let said = read(&mask("mm"), &print("mm"));
    assert!(!said.iter().any(|said| said.contains("the output of a control")), "{said:?}");
    let said = read(&mask("mm"), &format!("UNIT: INCH\n{}", print("mm")));
    assert!(said[0].contains("line 1 states INCH"), "{said:?}");
}

#[test]
fn contacts_in_another_unit_are_refused() {
    let circle = "12.5;0\n0;12.5\n-12.5;0\n";
    let read = |text: String| {
        contacts::read(text.as_bytes()).map(|read| read.contacts.len()).map_err(|error| error.to_string())
    };
    assert_eq!(read(format!("# unit: mm\nx;y\nmm;mm\n{circle}")), Ok(3));
    for text in [
        format!("# unit: inch\nx;y\n{circle}"),
        format!("x;y\ninch;inch\n{circle}"),
        format!("x;y\n{circle}# all values in inch\n"),
        "x;y;unit\n12.5;0;inch\n0;12.5;inch\n-12.5;0;inch\n".to_owned(),
    ] {
        assert!(
            read(text.clone()).is_err_and(|error| error.contains("contacts are in mm, but this line states inch")),
            "{text}"
        );
    }
}

#[test]
fn the_command_line_says_where_an_inch_comes_from_and_ends_as_its_worst_row() {
    let folder = tempfile::tempdir().unwrap();
    let run = |command: &[&str], name: &str, text: &str| {
        std::fs::File::create(folder.path().join(name)).unwrap().write_all(text.as_bytes()).unwrap();
        let mut binary = Command::cargo_bin("fitcheck").unwrap();
        let output = binary.current_dir(folder.path()).args(command).arg(name).output().unwrap();
        (
            output.status.code(),
            String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr),
        )
    };
    let column = "id;nominal;class;measured;unit\nA;1;H7;1.0009;inch\n";
    let comment = format!("# unit: inch\n{ROWS}");
    for command in ["import", "batch"] {
        let (code, said) = run(&[command], "a.csv", column);
        assert_eq!(code, Some(11), "{command} {said}");
        let (code, said) = run(&[command], "b.csv", &comment);
        assert_eq!(code, Some(11), "{command} {said}");
        assert!(said.contains("lengths are read in inch, as the file states: # unit: inch"), "{said}");
        let (code, said) = run(&[command], "c.csv", &format!("{ROWS}# all values in inch\n"));
        assert_eq!(code, Some(1), "{command} {said}");
    }
    let (_, said) = run(&["import", "--show-columns"], "b.csv", &comment);
    assert!(said.contains("# unit: # unit: inch"), "{said}");
}
