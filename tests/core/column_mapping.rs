//! Which column of a CSV is which: as it is detected, and as the user says it.

use std::io::Cursor;
use std::path::Path;

use assert_cmd::Command;
use fitcheck::exchange::{
    Choice, FirstRows, ImportInputs, Item, Kept, Labels, MOST_KEPT, Mapping, Remembered, Role, import_from,
};
use fitcheck::tolerance::Sources;

const NOW: jiff::civil::DateTime = jiff::civil::date(2025, 1, 1).at(0, 0, 0, 0);

/// What is said of each item, and the labels of records.
fn read(mapping: Option<&str>, text: &str) -> (Vec<String>, Vec<Labels>) {
    let mapping = mapping.map(|text| text.parse::<Mapping>().unwrap());
    let sources = Sources::default();
    let (mut said, mut all) = (Vec::new(), Vec::new());
    let given = ImportInputs { mapping: mapping.as_ref(), ..ImportInputs::new(&sources, NOW) };
    import_from("m.csv", &mut Cursor::new(text.as_bytes()), given, &mut |item| {
        said.push(match item {
            Item::Record { line, record, labels } => {
                all.push(labels);
                let callout = record.callout.map(|callout| callout.to_string()).unwrap_or_default();
                format!("{line}: {} {callout} {}", record.id, record.measurement.diameter)
            }
            Item::Unjudged(unjudged) => format!("{}: {} {}", unjudged.line, unjudged.id, unjudged.why),
            Item::Error(error) => error.to_string(),
            Item::Warning(warning) => format!("warning: {warning}"),
            Item::Contacts(_) => "contacts".to_owned(),
        });
    });
    (said, all)
}

#[track_caller]
fn check(mapping: &str, text: &str, expected: &[&str]) {
    assert_eq!(read(Some(mapping), text).0, expected, "{mapping}\n{text}");
}

#[test]
fn columns_are_said_by_number_or_name() {
    let text = "q;r;s;t\nbore;25 H7;25.012;26.5\n";
    check(
        "measured=3,callout=2",
        text,
        &[
            "warning: line 1: columns skipped: 4 (t)",
            "warning: line 1: skipped, not a measurement: q r s t",
            "2: bore 25 H7 25.012",
        ],
    );
    check("measured=s,callout=R,name=t", text, &["warning: line 1: columns skipped: 1 (q)", "2: 26.5 25 H7 25.012"]);
    check(
        "measured=s, callout=r, name=-",
        text,
        &["warning: line 1: columns skipped: 1 (q), 4 (t)", "2:  25 H7 25.012"],
    );
    // What is detected counts for the rest.
    check(
        "measured=4",
        "id;callout;first;second\nb1;25 H7;24.9;25.01\n",
        &["warning: line 1: columns skipped: 3 (first)", "2: b1 25 H7 25.01"],
    );
    check("callout=1,measured=2", "25 H7;25.01\n20 g6;19.99\n", &["1:  25 H7 25.01", "2:  20 g6 19.99"]);
}

#[test]
fn nominal_size_and_class_unit_and_signs_are_said() {
    check(
        "nominal=1,class=2,measured=3,unit=inch,decimal=comma",
        "x1;x2;x3\n1;H7;1,0003\n1;H7;1.0003\n",
        &[
            "warning: line 1: skipped, not a measurement: x1 x2 x3",
            "2:  25.4 H7 25.40762",
            "line 3, column 3: measured: 1.0003 has a different decimal sign than the other values: \",\"",
        ],
    );
    check(
        "separator=comma,callout=1,measured=2",
        "\"25 H7; reamed\",25.01\n",
        &[
            "line 1, column 1: callout: H7; is not a tolerance class: write letters and a grade, such as H7 or js13 (character 4)",
        ],
    );
}

#[test]
fn rows_begin_where_it_is_said() {
    check(
        "first-row=4,callout=fit,measured=result",
        "report;;\nfit;result;note\n25 H7;25.010;an example\n25 H7;25.020;\n",
        &[
            "warning: line 2: columns skipped: 3 (note)",
            "warning: line 1: skipped, not a measurement: report",
            "warning: line 3: skipped, not a measurement: 25 H7 25.010 an example",
            "4:  25 H7 25.02",
        ],
    );
}

#[test]
fn a_mapping_that_contradicts_the_file_is_refused_with_both() {
    let text = "id;callout;measured\nb1;25 H7;25.012\n";
    check(
        "measured=7",
        text,
        &["line 1: the measured value should be in column 7, but the file has 1 (id), 2 (callout), 3 (measured)"],
    );
    check(
        "measured=Istmaß",
        text,
        &["line 1: the measured value should be in column Istmaß, but the file has 1 (id), 2 (callout), 3 (measured)"],
    );
    check(
        "measured=0",
        text,
        &["line 1: the measured value should be in column 0, but the file has 1 (id), 2 (callout), 3 (measured)"],
    );
    check(
        "measured=3,nominal=3",
        text,
        &["line 1: column 3 (measured) cannot be both the measured value and the nominal size"],
    );
    check(
        "measured=v",
        "v;v\n1;2\n",
        &[
            "line 1: columns 1 (v), 2 (v) may each be the measured value: choose one with import --columns, such as measured=3, or name the columns in the first line so that only one fits, such as id;callout;measured",
        ],
    );
    let refused = |text: &str| text.parse::<Mapping>().unwrap_err().to_string();
    assert_eq!(refused("measured"), "measured assigns no column: write a word, = and a column, such as measured=3");
    assert!(refused("colour=3").starts_with("colour is not a known column content: allowed are name callout"));
    assert_eq!(refused("decimal=dot"), "decimal: dot is unknown: allowed are point comma");
    assert_eq!(refused("first-row=0"), "first-row: 0 is unknown: allowed are 1, 2, 3, …");
}

#[test]
fn part_serial_number_operator_and_place_come_with_a_value() {
    let labels = |header: &str| {
        let text = format!("{header}\nflange;0815;7;J. Jansen;bore A;10;20,5;-3;25 H7;25.012\n");
        let (said, labels) = read(None, &text);
        assert_eq!(said, ["2: bore A 25 H7 25.012"], "{header}");
        labels
    };
    for header in [
        "part;serial;number;operator;feature;x;y;z;callout;measured",
        "Teil;Seriennummer;Merkmal Nr;Prüfer;Merkmal;X;Y;Z;Passung;Istmaß",
        "onderdeel;serienummer;kenmerknummer;gemeten door;kenmerk;X [mm];Y [mm];Z [mm];passing;gemeten",
        "pezzo;matricola;numero;operatore;caratteristica;posizione x;posizione y;posizione z;tolleranza;misurato",
    ] {
        let [found] = labels(header).try_into().unwrap();
        let Labels { number, part, serial, who, place, .. } = found;
        assert_eq!([number, part, serial, who], ["7", "flange", "0815", "J. Jansen"], "{header}");
        assert_eq!(place.map(|place| place.unwrap().to_string()), ["10", "20.5", "-3"], "{header}");
    }
    // Alone, any of these names the value as ever.
    assert_eq!(read(None, "serial;callout;measured\n0815;25 H7;25.01\n").0, ["2: 0815 25 H7 25.01"]);
    assert_eq!(read(None, "part;serial;callout;measured\np;0815;25 H7;25.01\n").0, ["2: p 25 H7 25.01"]);
    let (said, _) = read(Some("x=1,callout=2,measured=3"), "a;b;c\nleft;25 H7;25.01\n");
    assert_eq!(
        said,
        [
            "warning: line 1: skipped, not a measurement: a b c",
            "warning: line 2, column 1: left is not a length: the location is skipped",
            "2:  25 H7 25.01"
        ]
    );
}

#[test]
fn what_is_detected_reads_the_same_when_it_is_said() {
    for text in [
        "id;callout;measured\nb1;25 H7;25,012\nb2;20 g6;19,99\n",
        "b1,25 H7,25.012\nb2,20 g6,19.99\n",
        "# remark\ntitle\nDatum;Uhrzeit;Nennmaß [inch];Toleranzklasse;Istmaß [inch];Maschine\n14.3.2024;8:05;1;H7;1,0003;3\n",
        "part\tserial\tfeature\tx\ty\tcallout\tmeasured_um\np\ts\tf\t1\t2\t25 H7\t25012\n",
    ] {
        let detected = Mapping::default().detect(text.as_bytes()).unwrap();
        let toml = detected.mapping.to_toml().unwrap();
        let again = Mapping::from_toml(&toml).unwrap();
        assert_eq!(again, detected.mapping, "{toml}");
        let sources = Sources::default();
        let items = |mapping: Option<&Mapping>| {
            let mut items = Vec::new();
            let given = ImportInputs { mapping, ..ImportInputs::new(&sources, NOW) };
            import_from("m.csv", &mut Cursor::new(text.as_bytes()), given, &mut |item| items.push(item));
            items
        };
        assert_eq!(items(Some(&again)), items(None), "{toml}");
    }
    let error = Mapping::from_toml("colour = 3").unwrap_err().to_string();
    assert!(error.starts_with("not a mapping of columns: unknown field `colour`"), "{error}");
    assert!(Mapping::from_toml("columns = { colour = 3 }").is_err());
}

#[test]
fn the_command_line_shows_and_takes_columns() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let mut file = std::fs::File::create(folder.path().join(name)).unwrap();
        std::io::Write::write_all(&mut file, text.as_bytes()).unwrap();
    };
    write("m.csv", "q;r;s;t\nbore;25 H7;25,012;26,5\n");
    let run = |arguments: &[&str]| answer(folder.path(), arguments);
    let (code, out, err) = run(&["--show-columns", "--columns", "measured=3", "m.csv"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert_eq!(
        out,
        "m.csv\n   1  q  name      bore\n   2  r  callout   25 H7\n   3  s  measured  25,012\n   4  t  -         26,5\n\n\
         separator = \"semicolon\"\ndecimal = \"comma\"\nunit = \"mm\"\nfirst-row = 2\n\n[columns]\ncallout = \"r\"\n\
         measured = \"s\"\nname = \"q\"\n\n"
    );
    write("columns.toml", out.split_once("\n\n").unwrap().1);
    let (code, out, _) = run(&["--columns", "columns.toml", "m.csv", "--format", "csv"]);
    assert!(code == 0 && out.contains("m.csv,2,bore,25 H7,25,25.000,25.021,25.012,12,GOOD"), "{out}");
    let (code, _, err) = run(&["--columns", "colour=3", "m.csv"]);
    assert!(code == 1 && err.contains("colour is not a known column content"), "{err}");
    let (code, out, err) = run(&["--show-columns", "m.csv", "missing.csv", "--format", "json"]);
    // What is known is shown, and why the file cannot be read yet.
    assert!(code == 1 && out.contains("m.csv") && err.contains("m.csv: columns 3, 4"), "{out}{err}");
}

fn answer(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output =
        Command::cargo_bin("fitcheck").unwrap().current_dir(folder).arg("import").args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn nothing_is_said_twice() {
    let refused = |text: &str| text.parse::<Mapping>().unwrap_err().to_string();
    assert_eq!(refused("measured=a,measured=b"), "measured is given twice: give it once");
    assert_eq!(refused("measured=a,Measured=a"), "Measured is given twice: give it once");
    assert_eq!(refused("name=1,id=2"), "id is given twice: give it once");
    assert_eq!(refused("unit=mm,unit=inch"), "unit is given twice: give it once");
    assert_eq!(refused("first-row=2,first-row=3"), "first-row is given twice: give it once");
    let of_toml = |text: &str| Mapping::from_toml(text).unwrap_err().to_string();
    assert_eq!(of_toml("[columns]\nclass = 1\ncallout = 2"), "class is given twice: give it once");
    check(
        "name=1,measured=1",
        "id;callout;measured\nb1;25 H7;25.012\n",
        &["line 1: column 1 (id) cannot be both the measured value and the name"],
    );
}

#[test]
fn places_have_a_unit_of_their_own() {
    let text = "a;x;y;fit;m\nb;1;2;1 H7;1.0003\n";
    let place = |mapping: &str| {
        let (said, labels) = read(Some(mapping), text);
        let [labels] = labels.try_into().unwrap_or_else(|_| panic!("{said:?}"));
        let [x, y, z] = labels.place.map(|place| place.map(|place| place.to_string()));
        assert_eq!(z, None);
        [x.unwrap(), y.unwrap()]
    };
    assert_eq!(place("name=a,measured=m,unit=inch"), ["1", "2"], "the unit of sizes says nothing of places");
    // 1 in is 25.4 mm.
    assert_eq!(place("name=a,measured=m,place-unit=inch"), ["25.4", "50.8"]);
    let refused = "place-unit=cm".parse::<Mapping>().unwrap_err().to_string();
    assert_eq!(refused, "place-unit: cm is unknown: allowed are mm um inch");
    // What is detected says both, and leaves to the names what differs.
    let toml = |text: &str| Mapping::default().detect(text.as_bytes()).unwrap().mapping.to_toml().unwrap();
    let said = toml("name;x [mm];y [mm];callout;measured [inch]\nb;1;2;25 H7;1.0003\n");
    assert!(said.contains("\nunit = \"inch\"\nplace-unit = \"mm\"\n"), "{said}");
    let said = toml("name;nominal [mm];class;measured [inch]\nb;25;H7;1.0003\n");
    assert!(!said.contains("unit"), "{said}");
}

#[test]
fn date_and_time_have_a_column_each_or_one_of_them_is_left_out() {
    let text = "Datum;Uhrzeit;Passung;Istmaß\n14.3.2024;8:05;25 H7;25,012\n";
    let time = |toml: &str| {
        let (mapping, sources) = (Mapping::from_toml(toml).unwrap(), Sources::default());
        let given = ImportInputs { mapping: Some(&mapping), ..ImportInputs::new(&sources, NOW) };
        let mut times = Vec::new();
        import_from("m.csv", &mut Cursor::new(text.as_bytes()), given, &mut |item| {
            if let Item::Record { record, .. } = item {
                times.push(record.time.to_string());
            }
        });
        times
    };
    assert_eq!(time("[columns]\ntime = \"Datum\""), ["2024-03-14T08:05:00"], "one of them names both");
    assert_eq!(time("[columns]\ntime = [\"Datum\", \"Uhrzeit\"]"), ["2024-03-14T08:05:00"]);
    assert_eq!(time("[columns]\ntime = [\"Datum\"]"), ["2024-03-14T00:00:00"]);
    for wrong in ["time = []", "time = [1, 2, 3]", "time = [[1]]", "time = [\"-\"]", "measured = [3, 4]"] {
        assert!(Mapping::from_toml(&format!("[columns]\n{wrong}")).is_err(), "{wrong}");
    }
}

/// German, with names that nobody knows, commas and inches.
const ODD: &str = "Stelle;Kontur;Ergebnis in Zoll\nBORE;12;0,98465\nPIN;7;0,78675\n";

fn chosen(first: &FirstRows) -> Choice {
    let mut choice = first.guess(&Mapping::default());
    assert!(choice.roles.iter().all(Option::is_none), "{choice:?}");
    choice.give(0, Some(Role::Id));
    choice.give(2, Some(Role::Measured));
    choice
}

#[test]
fn what_is_chosen_for_a_file_is_found_again_for_files_of_its_shape_alone() {
    let first = FirstRows::of("a.csv", ODD.as_bytes()).unwrap();
    assert!(first.detect(&Mapping::default()).is_err());
    let mut remembered = Remembered::default();
    let shape = remembered.keep(Kept::of(&first, &chosen(&first), NOW).unwrap());
    let read = |text: &str| {
        let first = FirstRows::of("b.csv", text.as_bytes()).unwrap();
        let (found, kept, mapping) = remembered.find(&first)?;
        assert_eq!((found, kept.day()), (shape.as_str(), "2025-01-01"));
        let sources = Sources::default();
        let mut sizes = Vec::new();
        let given = ImportInputs { mapping: Some(&mapping), ..ImportInputs::new(&sources, NOW) };
        import_from("b.csv", &mut Cursor::new(text.as_bytes()), given, &mut |item| {
            if let Item::Unjudged(unjudged) = item {
                sizes.push(format!("{} {}", unjudged.id, unjudged.measured.unwrap()));
            }
        });
        Some(sizes)
    };
    // 0.98465 in is 25.01011 mm, 0.78675 in is 19.98345 mm.
    let sizes = || Some(vec!["BORE 25.01011".to_owned(), "PIN 19.98345".to_owned()]);
    assert_eq!(read(ODD), sizes());
    assert_eq!(read(&format!("Protokoll;7\n# ein Satz\n{ODD}")), sizes(), "lines above the header");
    assert_eq!(read(&ODD.replace("Kontur", "Form")), None, "another name");
    assert_eq!(read(&ODD.replace(';', "\t")), None, "another separator");
    assert_eq!(read(&ODD.replace("Stelle;Kontur", "Kontur;Stelle")), None, "another order");
    assert_eq!(read(&ODD.replace("Zoll\n", "Zoll;SN\n")), None, "one more");
}

#[test]
fn the_first_row_is_remembered_by_its_distance_from_the_header() {
    let with_units = ODD.replacen("BORE", "-;-;1\nBORE", 1);
    let first = FirstRows::of("a.csv", with_units.as_bytes()).unwrap();
    let mut choice = chosen(&first);
    choice.first_row = Some(3);
    let mut remembered = Remembered::default();
    remembered.keep(Kept::of(&first, &choice, NOW).unwrap());
    let later = format!("Protokoll;7\nMaschine;3\n{with_units}");
    let first = FirstRows::of("b.csv", later.as_bytes()).unwrap();
    let (.., mapping) = remembered.find(&first).unwrap();
    let detected = first.detect(&mapping).unwrap();
    assert_eq!((detected.header, detected.rows[0].0), (Some(3), 5));
}

#[test]
fn a_file_without_a_header_is_known_by_the_number_of_its_columns() {
    let first = FirstRows::of("a.csv", b"BORE;7;25,012\nPIN;8;19,985\n").unwrap();
    let mut choice = first.guess(&Mapping::default());
    choice.give(0, Some(Role::Id));
    choice.give(2, Some(Role::Measured));
    let mut remembered = Remembered::default();
    remembered.keep(Kept::of(&first, &choice, NOW).unwrap());
    let is_known = |text: &str| remembered.find(&FirstRows::of("b.csv", text.as_bytes()).unwrap()).is_some();
    assert!(is_known("D9;1;9,004\nD10;2;10,004\n"));
    assert!(!is_known("D9;1;9,004;x\nD10;2;10,004;y\n"), "four columns");
    assert!(!is_known("name;gauge;measured\nD9;1;9,004\n"), "a header");
}

#[test]
fn fifty_shapes_are_kept_and_the_oldest_makes_room() {
    let mut remembered = Remembered::default();
    let mut shapes = Vec::new();
    for number in 0..51_i8 {
        let text = ODD.replace("Kontur", &format!("Kontur {number}"));
        let first = FirstRows::of("a.csv", text.as_bytes()).unwrap();
        let time = NOW.saturating_add(jiff::Span::new().minutes(number));
        shapes.push(remembered.keep(Kept::of(&first, &chosen(&first), time).unwrap()));
    }
    assert_eq!(remembered.len(), MOST_KEPT);
    assert!(!remembered.has(&shapes[0]) && remembered.has(&shapes[1]) && remembered.has(&shapes[50]));
    let written = toml::to_string(&remembered).unwrap();
    assert_eq!(toml::from_str::<Remembered>(&written).unwrap(), remembered);
}

#[test]
fn a_choice_is_given_to_one_column_and_time_to_two() {
    let mut choice = Choice { roles: vec![Some(Role::Measured), None, None, None], ..Choice::default() };
    choice.give(2, Some(Role::Measured));
    assert_eq!(choice.roles, [None, None, Some(Role::Measured), None]);
    for at in [0, 1, 3] {
        choice.give(at, Some(Role::Time));
    }
    assert_eq!(choice.roles.iter().filter(|role| **role == Some(Role::Time)).count(), 2, "{choice:?}");
    choice.give(2, None);
    assert_eq!(choice.roles[2], None);
}

#[test]
fn the_sheet_of_a_workbook_is_said() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/xlsx/openpyxl.xlsx");
    let bytes = std::fs::read(path).unwrap();
    let first = FirstRows::of("m.xlsx", &bytes).unwrap();
    let detected = first.detect(&Mapping::default()).unwrap();
    assert!(detected.mapping.to_toml().unwrap().contains("sheet = "), "{}", detected.mapping.to_toml().unwrap());
    let read = |mapping: &Mapping| {
        let (sources, mut said) = (Sources::default(), Vec::new());
        let given = ImportInputs { mapping: Some(mapping), ..ImportInputs::new(&sources, NOW) };
        import_from("m.xlsx", &mut Cursor::new(&bytes), given, &mut |item| match item {
            Item::Error(error) => said.push(error.to_string()),
            Item::Record { line, .. } => said.push(line.to_string()),
            _ => {}
        });
        said
    };
    let choice = first.guess(&Mapping::default());
    let chosen = choice.mapping(&first.names(&choice));
    assert_eq!(read(&chosen), read(&Mapping::default()), "{}", chosen.to_toml().unwrap());
    let said = read(&"sheet=Nowhere".parse().unwrap());
    assert_eq!(said.len(), 1);
    assert!(said[0].starts_with("line 1: the workbook has no sheet Nowhere; it has "), "{said:?}");
}
