//! Which column of a CSV is which: as it is detected, and as the user says it.

use std::io::Cursor;
use std::path::Path;

use assert_cmd::Command;
use fitcheck::exchange::{Given, Item, Labels, Mapping, import_from};
use fitcheck::tolerance::Sources;

const NOW: jiff::civil::DateTime = jiff::civil::date(2025, 1, 1).at(0, 0, 0, 0);

/// What is said of each item, and the labels of records.
fn read(mapping: Option<&str>, text: &str) -> (Vec<String>, Vec<Labels>) {
    let mapping = mapping.map(|text| text.parse::<Mapping>().unwrap());
    let sources = Sources::default();
    let (mut said, mut all) = (Vec::new(), Vec::new());
    let given = Given { mapping: mapping.as_ref(), ..Given::new(&sources, NOW) };
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
        &["line 1: the measured value should be in column 7, and the file has 1 (id), 2 (callout), 3 (measured)"],
    );
    check(
        "measured=Istmaß",
        text,
        &["line 1: the measured value should be in column Istmaß, and the file has 1 (id), 2 (callout), 3 (measured)"],
    );
    check(
        "measured=0",
        text,
        &["line 1: the measured value should be in column 0, and the file has 1 (id), 2 (callout), 3 (measured)"],
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
            "line 1: columns 1 (v), 2 (v) may each be the measured value: name them in the first line, such as id;callout;measured",
        ],
    );
    let refused = |text: &str| text.parse::<Mapping>().unwrap_err().to_string();
    assert_eq!(
        refused("measured"),
        "measured says nothing about a column: write a word, = and a column, such as measured=3"
    );
    assert!(refused("colour=3").starts_with("colour is not something that a column holds: allowed are name callout"));
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
            "warning: line 2, column 1: left is not a length: the place is left out",
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
        let toml = detected.mapping.to_toml();
        let again = Mapping::from_toml(&toml).unwrap();
        assert_eq!(again, detected.mapping, "{toml}");
        let sources = Sources::default();
        let items = |mapping: Option<&Mapping>| {
            let mut items = Vec::new();
            let given = Given { mapping, ..Given::new(&sources, NOW) };
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
    assert!(code == 1 && err.contains("colour is not something that a column holds"), "{err}");
    let (code, out, err) = run(&["--show-columns", "m.csv", "missing.csv", "--format", "json"]);
    assert_eq!((code, out.trim()), (1, "[]"), "{err}");
}

fn answer(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output =
        Command::cargo_bin("fitcheck").unwrap().current_dir(folder).arg("import").args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}
