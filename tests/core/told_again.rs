//! What Fitcheck writes comes back as what it was: simulated values as simulated, corrected ones as corrected.

use std::path::Path;

use assert_cmd::Command;
use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::Value;

/// A probe that finds 25.012 mm, and a program that prints what it found.
const PROGRAM: &str = "BEGIN PGM p MM\nTCH PROBE 421 MEASURE HOLE Q273=40 Q274=30 Q262=25 Q325=0 Q247=90 Q261=-8 Q320=5 Q260=50 Q301=0 \
    Q275=25.021 Q276=25 Q279=0.1 Q280=0.1 Q281=1 Q309=0 Q330=0\nFN 16: F-PRINT m.a / TNC:\\print.txt\nEND PGM p MM\n";
const MASK: &str = "\"DIAMETER %9.4F LIMITS %9.4F %9.4F\", Q153, Q276, Q275;\nM_APPEND;\n";
const TABLE_MASK: &str = "\"25 H7;%8.4F\", Q153;\nM_APPEND;\n";
const HOLE: &str = "[bore]\ncentre = [40, 30]\ndiameter = 25.012\n";

struct Shop(tempfile::TempDir);

impl Shop {
    fn new() -> Self {
        let shop = Self(tempfile::tempdir().unwrap());
        shop.put("hole.toml", HOLE);
        shop.put("m.a", MASK);
        shop.put("p.h", &PROGRAM.replace("    ", ""));
        shop
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn put(&self, name: &str, text: &str) {
        fitcheck::files::write(&self.path().join(name), text.as_bytes()).unwrap();
    }

    fn command(&self, args: &[&str]) -> Command {
        let mut command = cargo_bin_cmd!("fitcheck");
        command.current_dir(self.path()).args(args).env("FITCHECK_JOURNAL", self.path().join("own.sqlite"));
        command
    }

    /// Exit code, standard output, standard error.
    fn call(&self, args: &[&str]) -> (Option<i32>, String, String) {
        let output = self.command(args).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (output.status.code(), text(output.stdout), text(output.stderr))
    }

    /// What a call prints goes to a file.
    fn print(&self, name: &str, args: &[&str]) {
        let (_, out, said) = self.call(args);
        assert!(!out.is_empty(), "{args:?}: {said}");
        self.put(name, &out);
    }

    /// What an import of a file records, as the list of the journal has it.
    fn recorded(&self, args: &[&str]) -> Vec<Value> {
        let journal = self.path().join("test.sqlite");
        let _none = std::fs::remove_file(&journal);
        let journal = journal.to_str().unwrap();
        let (_, _, said) = self.call(&[&["import", "--record", "--journal", journal][..], args].concat());
        let (_, list, _) = self.call(&["journal", "list", "--journal", journal, "--format", "json"]);
        // Where nothing was judged there is no journal.
        if said.contains("nothing was judged, so nothing was recorded") {
            return Vec::new();
        }
        let list: Vec<Value> = serde_json::from_str(&list).unwrap_or_else(|error| panic!("{args:?}: {error}: {said}"));
        list.into_iter().filter(|row| !row["measured_mm"].is_null()).collect()
    }

    /// A file of simulated values records simulated values, or none.
    #[track_caller]
    fn stays_simulated(&self, args: &[&str]) {
        let (_, answer, said) = self.call(&[&["import", "--format", "csv"][..], args].concat());
        let rows: Vec<&str> = answer.lines().skip(1).collect();
        assert!(!rows.is_empty() && !answer.contains("false"), "{args:?}: {answer}{said}");
        for row in self.recorded(args) {
            assert_eq!(row["simulated"], true, "{args:?}: {row}");
        }
    }
}

#[test]
fn a_log_of_a_simulated_cycle_comes_back_simulated() {
    let shop = Shop::new();
    let (code, _, said) =
        shop.call(&["run", "p.h", "--assume-tool", "--workpiece", "hole.toml", "--output-folder", "out"]);
    assert_eq!(code, Some(0), "{said}");
    let log = std::fs::read_to_string(shop.path().join("out/TCHPR421.TXT")).unwrap();
    assert!(log.contains("\r\n# Simulated by Fitcheck - not measured\r\n"), "{log}");
    assert_eq!(shop.recorded(&["out/TCHPR421.TXT"]).len(), 1);
    shop.stays_simulated(&["out/TCHPR421.TXT"]);
    // Of contacts that somebody recorded nothing more is said than on a control.
    let contacts: String =
        [(52.506, 30.0), (40.0, 42.506), (27.494, 30.0), (40.0, 17.494)].map(|(x, y)| format!("{x},{y},-8\n")).concat();
    shop.put("contacts.csv", &contacts);
    let (_, _, said) =
        shop.call(&["run", "p.h", "--assume-tool", "--contacts", "contacts.csv", "--output-folder", "real"]);
    let real = std::fs::read_to_string(shop.path().join("real/TCHPR421.TXT")).unwrap_or_else(|_| panic!("{said}"));
    assert!(!real.contains("Fitcheck"), "{real}");
    assert_eq!(shop.recorded(&["real/TCHPR421.TXT"])[0]["simulated"], false);
    let print = std::fs::read_to_string(shop.path().join("real/print.txt")).unwrap();
    assert!(!print.contains("Fitcheck"), "{print}");
}

#[test]
fn a_print_of_a_simulated_run_comes_back_simulated_through_its_mask_and_as_a_table() {
    let shop = Shop::new();
    let run = ["run", "p.h", "--assume-tool", "--workpiece", "hole.toml", "--output-folder", "out"];
    let _twice = (shop.call(&run), shop.call(&run));
    let print = std::fs::read_to_string(shop.path().join("out/print.txt")).unwrap();
    assert!(print.starts_with("# Simulated by Fitcheck - not measured\r\nDIAMETER "), "{print}");
    shop.stays_simulated(&["--mask", "m.a", "out/print.txt"]);
    // A mask may print what is a table.
    shop.put("m.a", TABLE_MASK);
    let run = ["run", "p.h", "--assume-tool", "--workpiece", "hole.toml", "--output-folder", "table"];
    let (code, _, said) = shop.call(&run);
    assert_eq!(code, Some(0), "{said}");
    let _again = shop.call(&run);
    assert_eq!(shop.recorded(&["table/print.txt"]).len(), 2);
    shop.stays_simulated(&["table/print.txt"]);
    let table = std::fs::read_to_string(shop.path().join("table/print.txt")).unwrap();
    shop.put("once.csv", &table.lines().take(2).collect::<Vec<_>>().join("\n"));
    let (_, out, said) = shop.call(&["batch", "once.csv"]);
    assert!(said.contains("1 row says that nobody measured"), "{out}{said}");
    assert!(out.starts_with("# Simulated by Fitcheck"), "{out}");
    for format in ["tsv", "jsonl"] {
        assert_eq!(shop.call(&["batch", "once.csv", "--format", format]).0, Some(1), "{format}");
    }
    // Between rows of a stream nobody knows which rows come after it.
    shop.put("later.csv", "25 H7;25.01\n# Simulated by Fitcheck - not measured\n25 H7;25.02\n");
    assert_eq!(shop.call(&["batch", "later.csv"]).0, Some(1));
    let later: Vec<Value> = shop.recorded(&["later.csv"]).iter().rev().map(|row| row["simulated"].clone()).collect();
    assert_eq!(later, [Value::from(false), Value::from(true)]);
}

#[test]
fn a_page_of_simulated_points_comes_back_simulated() {
    let shop = Shop::new();
    let set = ["Q263=10", "Q264=20", "Q294=-5", "Q581=0", "Q582=0", "Q583=1", "QS400=0.1-0.02"];
    let (code, _, said) = shop.call(&[&["cycle", "444", "--log-folder", "logs", "--set"][..], &set].concat());
    assert_eq!(code, Some(0), "{said}");
    let page = std::fs::read_to_string(shop.path().join("logs/TCHPR444.html")).unwrap();
    assert!(page.contains("<strong>SIMULATED, NOT MEASURED</strong>"), "{page}");
    shop.stays_simulated(&["logs/TCHPR444.html"]);
}

#[test]
fn whatever_is_written_of_a_simulated_value_comes_back_simulated() {
    let shop = Shop::new();
    shop.print("check.csv", &["check", "25 H7", "--simulate", "--format", "csv"]);
    shop.stays_simulated(&["check.csv"]);
    let (_, _, said) = shop.call(&["check", "25 H7", "--simulate", "--record", "--part", "P1", "--feature-name", "A"]);
    assert!(said.contains("recorded"), "{said}");
    shop.print("list.csv", &["journal", "list", "--format", "csv"]);
    shop.print("export.csv", &["journal", "export"]);
    shop.print("import.csv", &["import", "check.csv", "--format", "csv"]);
    shop.print("report.csv", &["report", "check.csv", "-o", "-", "--format", "csv"]);
    shop.print("batch.csv", &["batch", "check.csv", "--prefix", "b_"]);
    for file in ["list.csv", "export.csv", "import.csv", "report.csv", "batch.csv"] {
        assert_eq!(shop.recorded(&[file]).len(), 1, "{file}");
        shop.stays_simulated(&[file]);
        // Whoever leaves one of the two columns has the other one.
        let text = std::fs::read_to_string(shop.path().join(file)).unwrap();
        if text.contains(",origin") {
            shop.put("origin.csv", &text.replace("simulated\n", "s\n"));
            shop.stays_simulated(&["origin.csv"]);
        }
        // No part is good by it.
        shop.put("p.csv", "name;callout\nA;25 H7\n");
        let (code, out, said) = shop.call(&["import", file, "--plan", "p.csv"]);
        // The journal knows the feature's name; the others have none that the plan could find.
        let expected = if matches!(file, "list.csv" | "export.csv") { 14 } else { 1 };
        assert_eq!((code, out.is_empty()), (Some(expected), false), "{file}: {said}");
    }
    let (_, _, said) = shop.call(&["batch", "check.csv", "--prefix", "b_"]);
    assert!(said.contains("1 row says that nobody measured"), "{said}");
}

#[test]
fn an_origin_in_four_languages_is_read_and_an_unknown_one_is_refused() {
    let shop = Shop::new();
    for (name, simulated, measured) in [
        ("origin", "simulated", "measured"),
        ("Herkunft", "simuliert", "gemessen"),
        ("oorsprong", "gesimuleerd", "gemeten"),
        ("herkomst", "gesimuleerde waarde", "getypt"),
        ("origine", "simulato", "misurato"),
    ] {
        shop.put(
            "a.csv",
            &format!("callout;measured;{name}\n25 H7;25.01;{simulated}\n25 H7;25.02;{measured}\n25 H7;25.005;\n"),
        );
        let said: Vec<Value> = shop.recorded(&["a.csv"]).iter().rev().map(|row| row["simulated"].clone()).collect();
        assert_eq!(said, [true, false, false].map(Value::from), "{name}");
        shop.put("b.csv", &format!("callout;measured;{name}\n25 H7;25.01;Werk 2\n"));
        let (code, _, said) = shop.call(&["import", "b.csv"]);
        assert_eq!(code, Some(1), "{said}");
        assert!(said.contains("b.csv:2:3: origin: Werk 2 says neither measured nor simulated"), "{said}");
        // The column is about something else.
        assert_eq!(shop.call(&["import", "b.csv", "--columns", "simulated=-"]).0, Some(0));
        assert_eq!(shop.call(&["batch", "b.csv"]).0, Some(1));
    }
    for (cell, code) in [("ja", "true"), ("x", "true"), ("nein", "false"), ("0", "false")] {
        shop.put("c.csv", &format!("callout;measured;simuliert\n25 H7;25.01;{cell}\n"));
        assert_eq!(shop.recorded(&["c.csv"])[0]["simulated"].to_string(), code, "{cell}");
    }
    shop.put("c.csv", "x;y;simulated\n12.5;0;yes\n0;12.5;yes\n-12.5;0;yes\n");
    let (code, _, said) = shop.call(&["check", "25 H7", "--contacts", "c.csv"]);
    assert!(code == Some(1) && said.contains("these contacts are simulated"), "{said}");
}

/// 6 K and 11.5 · 10⁻⁶/K: 25.025 mm are 25.023273 mm at 20 °C.
const WARM: [&str; 4] = ["--temperature", "26", "--material", "11.5"];

#[test]
fn no_file_of_fitcheck_is_corrected_a_second_time() {
    let shop = Shop::new();
    shop.put("raw.csv", "id,callout,measured\nA,25 H7,25.0250\n");
    let (code, ..) = shop.call(&[&["import", "raw.csv"][..], &WARM].concat());
    assert_eq!(code, Some(11), "25.025 mm at 26 °C is 25.023273 mm");
    shop.call(&[&["import", "raw.csv", "--record", "--part", "P"][..], &WARM].concat());
    shop.print("journal.csv", &["journal", "export"]);
    shop.print("import.csv", &[&["import", "raw.csv", "--format", "csv"][..], &WARM].concat());
    shop.print("again.csv", &["import", "import.csv", "--format", "csv"]);
    shop.print("report.csv", &["report", "import.csv", "-o", "-", "--format", "csv"]);
    for file in ["journal.csv", "import.csv", "again.csv", "report.csv"] {
        let text = std::fs::read_to_string(shop.path().join(file)).unwrap();
        let row = text.lines().last().unwrap();
        assert!(row.contains("25.023273") && row.contains("25.025,"), "{file}: {text}");
        for command in ["import", "report"] {
            let output: &[&str] = if command == "report" { &["-o", "-", "--format", "csv"] } else { &[] };
            let (code, out, said) = shop.call(&[&[command, file][..], output, &WARM].concat());
            assert_eq!(code, Some(1), "{command} {file}: {out}{said}");
        }
        // Read without a temperature it is what it was.
        assert_eq!(shop.call(&["import", file]).0, Some(11), "{file}");
        shop.put("p.csv", "name;callout\nA;25 H7\n");
        let (code, out, said) = shop.call(&[&["import", file, "--plan", "p.csv"][..], &WARM].concat());
        assert_eq!(code, Some(1), "{file}: {out}{said}");
        assert!(said.contains("the file says that its values are at 20 °C already"), "{file}: {said}");
        assert_eq!(shop.call(&["import", file, "--plan", "p.csv"]).0, Some(11), "{file}");
        // Without the columns that tell how.
        let at = text.lines().next().unwrap().split(',').position(|name| name == "temperature_c").unwrap();
        assert!(0 < at);
        shop.put("cut.csv", &text.replace("temperature_c", "t").replace("expansion_um_per_m_k", "e"));
        assert_eq!(shop.call(&[&["import", "cut.csv"][..], &WARM].concat()).0, Some(1), "{file}");
    }
    // Other formats say it in their own way.
    for (name, language) in [("r.dfq", "en"), ("r.qif", "en"), ("r.md", "en"), ("r.xlsx", "en"), ("nl.xlsx", "nl")] {
        let report = ["report", "raw.csv", "--language", language, "-o", name];
        assert_eq!(shop.call(&[&report[..], &WARM].concat()).0, Some(11), "{name}");
        let (code, out, said) = shop.call(&[&["import", name][..], &WARM].concat());
        assert_eq!(code, Some(1), "{name}: {out}{said}");
        assert!(said.contains("at 20 °C already"), "{name}: {out}{said}");
        let (code, out, said) = shop.call(&["import", name]);
        // The line below the head of a table of Markdown is no row.
        let is_read = matches!(code, Some(11 | 14)) || name == "r.md";
        assert!(is_read && out.contains("25.023273"), "{name}: {code:?} {out}{said}");
    }
    // Where its columns are not known in a language, nothing of it is judged.
    for language in ["de", "it", "fr", "es", "pl", "cs"] {
        shop.call(&[&["report", "raw.csv", "--language", language, "-o", "other.xlsx"][..], &WARM].concat());
        let (_, out, said) = shop.call(&[&["import", "other.xlsx"][..], &WARM].concat());
        assert!(!out.contains("25.021546"), "{language}: {out}{said}");
    }
    // A value that was not corrected is.
    shop.call(&["import", "raw.csv", "--record", "--part", "Q", "--journal", "other.sqlite"]);
    shop.print("plain.csv", &["journal", "export", "--journal", "other.sqlite"]);
    let (code, out, said) = shop.call(&[&["import", "plain.csv"][..], &WARM].concat());
    assert_eq!(code, Some(11), "{out}{said}");
    assert!(out.contains("25.023273"), "{out}{said}");
}

#[test]
fn a_column_that_says_corrected_is_not_corrected_again() {
    let shop = Shop::new();
    for (header, cell, is_corrected) in [
        ("callout;measured;temperature corrected", ";yes", true),
        ("callout;measured;temperaturkorrigiert", ";ja", true),
        ("callout;measured;gecorrigeerd", ";nee", false),
        ("callout;measured;corrected", ";", false),
        ("callout;measured;correction_um", ";-1.7", true),
        ("callout;Istmaß auf 20 °C", "", true),
        ("callout;measured (corrected)", "", true),
    ] {
        shop.put("a.csv", &format!("{header}\n25 H7;25.0118{cell}\n"));
        let (code, out, said) = shop.call(&[&["import", "a.csv"][..], &WARM].concat());
        let expected = if is_corrected { Some(1) } else { Some(0) };
        assert_eq!(code, expected, "{header}: {out}{said}");
        assert_eq!(said.contains("at 20 °C already"), is_corrected, "{header}: {said}");
        assert_eq!(shop.call(&["import", "a.csv"]).0, Some(0), "{header}");
    }
}

#[test]
fn no_report_of_a_simulated_value_comes_back_as_a_measured_one() {
    let shop = Shop::new();
    shop.put("simulated.csv", "id;callout;measured;simulated\nA;25 H7;25.01;true\nB;25 H7;25.012;true\n");
    for language in ["en", "nl", "de", "it", "fr", "es", "pl", "cs"] {
        for ending in ["xlsx", "dfq", "qif", "md"] {
            let name = format!("{language}.{ending}");
            shop.call(&["report", "simulated.csv", "--language", language, "-o", &name]);
            assert!(shop.path().join(&name).exists(), "{name}");
            for row in shop.recorded(&[&name]) {
                assert_eq!(row["simulated"], true, "{name}: {row}");
            }
        }
    }
}
